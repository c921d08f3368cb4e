//! `scenec preview-worker`

use std::io;

use clap::Args;
use scenec_lsp::preview::work;

use crate::exit::Exit;
use crate::jobs::remark;

/// The name of the subcommand, for the server that starts it.
pub(crate) const NAME: &str = "preview-worker";

/// Draw for an editor's server, which starts this by itself
#[derive(Args)]
pub(crate) struct PreviewWorker {}

impl PreviewWorker {
    pub(crate) fn run(&self) -> Exit {
        match work(io::stdin().lock(), io::stdout()) {
            Ok(()) => Exit::Clean,
            Err(error) => {
                remark(&format!("the orders can't be understood: {error}"));
                Exit::Unusable
            }
        }
    }
}
