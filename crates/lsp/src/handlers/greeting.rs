//! The first words: what the client can do, what the server offers, what it asks to be told of.

use serde_json::json;
use tower_lsp::lsp_types::{
    CodeActionOptions, CodeActionProviderCapability, CodeLensOptions, CompletionOptions, DiagnosticOptions,
    DiagnosticServerCapabilities, DocumentOnTypeFormattingOptions, InitializeParams, InitializeResult, OneOf,
    Registration, RenameOptions, SemanticTokensFullOptions, SemanticTokensOptions, SemanticTokensServerCapabilities,
    ServerCapabilities, ServerInfo, SignatureHelpOptions, TextDocumentSyncCapability, TextDocumentSyncKind,
    TextDocumentSyncOptions, WorkDoneProgressOptions, WorkspaceFoldersServerCapabilities, WorkspaceServerCapabilities,
};

use crate::abilities::Abilities;
use crate::handlers::{actions, settings, tokens};
use crate::publisher::Publisher;
use crate::server::Server;
use crate::settings::Settings;

/// What opens the list of completions beside letters: the sigils, and what an operator begins with.
const TYPED: &str = "!?*=+#|&<";

/// Gets to know the client, and tells what the server can do.
pub(crate) fn initialize(server: &Server, params: &InitializeParams) -> InitializeResult {
    let abilities = Abilities::of(&params.capabilities);
    server.meet(abilities, params.process_id);
    server.folders.meet(params);
    if let Some(settings) = params.initialization_options.as_ref().and_then(Settings::read) {
        server.set(settings);
    }
    if !abilities.pulls {
        tokio::spawn(Publisher::run(server.clone()));
    }
    InitializeResult {
        capabilities: capabilities(abilities),
        server_info: Some(ServerInfo {
            name: "scenec".to_owned(),
            version: Some(env!("CARGO_PKG_VERSION").to_owned()),
        }),
    }
}

/// The client is ready to be asked.
pub(crate) fn initialized(server: &Server) {
    settings::ask(server);
    let abilities = server.abilities();
    let mut wishes = Vec::new();
    if abilities.watches_files {
        let pattern = format!("**/{}", server.options.configuration);
        wishes.push(wish(
            "workspace/didChangeWatchedFiles",
            json!({"watchers": [{"globPattern": pattern}]}),
        ));
    }
    if abilities.tells_settings {
        wishes.push(wish("workspace/didChangeConfiguration", json!({"section": "scenec"})));
    }
    if wishes.is_empty() {
        return;
    }
    let (client, log) = (server.client.clone(), server.log);
    tokio::spawn(async move {
        if let Err(error) = client.register_capability(wishes).await {
            log.say(format_args!("the client will not tell of changes: {error}"));
        }
    });
}

fn wish(method: &str, options: serde_json::Value) -> Registration {
    Registration {
        id: method.to_owned(),
        method: method.to_owned(),
        register_options: Some(options),
    }
}

fn capabilities(abilities: Abilities) -> ServerCapabilities {
    let diagnostics = DiagnosticOptions {
        identifier: Some("scenec".to_owned()),
        inter_file_dependencies: false,
        workspace_diagnostics: false,
        work_done_progress_options: WorkDoneProgressOptions::default(),
    };
    ServerCapabilities {
        position_encoding: Some(abilities.encoding.kind()),
        text_document_sync: Some(TextDocumentSyncCapability::Options(TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::INCREMENTAL),
            ..TextDocumentSyncOptions::default()
        })),
        diagnostic_provider: abilities
            .pulls
            .then_some(DiagnosticServerCapabilities::Options(diagnostics)),
        hover_provider: Some(true.into()),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(characters(TYPED)),
            ..CompletionOptions::default()
        }),
        signature_help_provider: Some(SignatureHelpOptions {
            trigger_characters: Some(characters(" =")),
            ..SignatureHelpOptions::default()
        }),
        inlay_hint_provider: Some(OneOf::Left(true)),
        color_provider: Some(true.into()),
        semantic_tokens_provider: Some(semantic_tokens()),
        document_highlight_provider: Some(OneOf::Left(true)),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Right(RenameOptions {
            prepare_provider: abilities.prepares_rename.then_some(true),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        document_symbol_provider: Some(OneOf::Left(true)),
        workspace_symbol_provider: Some(OneOf::Left(true)),
        workspace: Some(WorkspaceServerCapabilities {
            workspace_folders: Some(WorkspaceFoldersServerCapabilities {
                supported: Some(true),
                change_notifications: Some(OneOf::Left(true)),
            }),
            file_operations: None,
        }),
        folding_range_provider: Some(true.into()),
        selection_range_provider: Some(true.into()),
        code_action_provider: abilities.actions.then(|| {
            CodeActionProviderCapability::Options(CodeActionOptions {
                code_action_kinds: Some(actions::kinds()),
                ..CodeActionOptions::default()
            })
        }),
        code_lens_provider: Some(CodeLensOptions { resolve_provider: None }),
        document_formatting_provider: Some(OneOf::Left(true)),
        document_range_formatting_provider: Some(OneOf::Left(true)),
        document_on_type_formatting_provider: Some(DocumentOnTypeFormattingOptions {
            first_trigger_character: "\n".to_owned(),
            more_trigger_character: None,
        }),
        ..ServerCapabilities::default()
    }
}

fn semantic_tokens() -> SemanticTokensServerCapabilities {
    let options = SemanticTokensOptions {
        legend: tokens::legend(),
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
        ..SemanticTokensOptions::default()
    };
    options.into()
}

/// One string for each character.
fn characters(all: &str) -> Vec<String> {
    all.chars().map(String::from).collect()
}
