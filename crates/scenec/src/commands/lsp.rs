//! `scenec lsp`

use std::path::Path;
use std::sync::Arc;

use clap::Args;
use scenec_lsp::{Ended, FileOptions, Options, serve};

use crate::config::{self, Configs};
use crate::exit::Exit;
use crate::files::scenes_soon_found;
use crate::jobs::remark;

/// Serve an editor over standard input and output
///
/// Speaks the Language Server Protocol: findings while you type, hovers, completions, colours, renaming, formatting and a
/// preview of the picture. Editors start it by themselves. A scenec.toml counts here as it does for `scenec check`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Lsp {
    /// Tell on standard error what goes on; so does the variable SCENEC_LSP_LOG, if it is set and not empty
    #[arg(long)]
    log: bool,
    /// Talk over standard input and output, as is done in any case; some clients insist on saying so
    #[arg(long)]
    stdio: bool,
}

const AFTER_HELP: &str = "\
Examples:
  Neovim 0.11 or later:
    vim.lsp.config('scenec', { cmd = { 'scenec', 'lsp' }, filetypes = { 'scene' } })
    vim.lsp.enable('scenec')
  Emacs, with eglot:
    (add-to-list 'eglot-server-programs '(scene-mode . (\"scenec\" \"lsp\")))
  Helix, in languages.toml:
    [language-server.scenec]
    command = \"scenec\"
    args = [\"lsp\"]
  What was said between the two, in a file:
    scenec lsp --log 2>lsp.log

Exit codes:
  0  the editor shut the server down in due form
  1  the editor left without a word, or is gone
  2  bad arguments, or the server could not start";

impl Lsp {
    pub(crate) fn run(&self) -> Exit {
        let wanted = std::env::var_os("SCENEC_LSP_LOG").is_some_and(|value| !value.is_empty());
        let options = Options {
            file: Box::new(file_options),
            configuration: config::NAME,
            scenes: scenes_soon_found,
            log: self.log || wanted,
            // The child is this very program; if it can't say where it lies, the shell's way may find it.
            drawer: (
                std::env::current_exe().unwrap_or_else(|_| "scenec".into()),
                vec![super::preview_worker::NAME.to_owned()],
            ),
        };
        match serve(options) {
            Ok(Ended::InForm) => Exit::Clean,
            Ok(Ended::Abandoned) => Exit::Errors,
            Err(error) => {
                remark(&format!("cannot start the server: {error}"));
                Exit::Unusable
            }
        }
    }
}

/// What the configuration of a file says. It is read anew each time: an editor is where it changes.
fn file_options(file: &Path) -> FileOptions {
    match Configs::new(&config::ConfigOptions::default()).of(file) {
        Ok(config) => FileOptions {
            align: config.format.align,
            level: Arc::new(move |code| config.levels.of(code)),
            problem: None,
        },
        Err(problem) => FileOptions {
            problem: Some(problem.to_string()),
            ..FileOptions::default()
        },
    }
}
