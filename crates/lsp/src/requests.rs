//! Every message of the protocol that the server understands, handed to the feature's own file.

use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    ColorInformation, ColorPresentation, ColorPresentationParams, CompletionParams, CompletionResponse,
    DidChangeConfigurationParams, DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidCloseTextDocumentParams,
    DidOpenTextDocumentParams, DocumentColorParams, DocumentDiagnosticParams, DocumentDiagnosticReportResult, Hover,
    HoverParams, InitializeParams, InitializeResult, InitializedParams, InlayHint, InlayHintParams, SignatureHelp,
    SignatureHelpParams,
};
use tower_lsp::{LanguageServer, async_trait};

use crate::handlers::{colour, completion, diagnostics, greeting, hover, inlay, settings, signature, synchronise};
use crate::server::Server;

#[async_trait]
impl LanguageServer for Server {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        Ok(greeting::initialize(self, &params))
    }

    async fn initialized(&self, _: InitializedParams) {
        greeting::initialized(self);
    }

    async fn shutdown(&self) -> Result<()> {
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        synchronise::open(self, params);
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        synchronise::change(self, &params);
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        synchronise::close(self, params);
    }

    async fn did_change_configuration(&self, params: DidChangeConfigurationParams) {
        settings::changed(self, &params);
    }

    async fn did_change_watched_files(&self, _: DidChangeWatchedFilesParams) {
        settings::refresh(self);
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        diagnostics::pull(self, params).await
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        hover::hover(self, params).await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        completion::completion(self, params).await
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        signature::signature(self, params).await
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        inlay::hints(self, params).await
    }

    async fn document_color(&self, params: DocumentColorParams) -> Result<Vec<ColorInformation>> {
        colour::colours(self, params).await
    }

    async fn color_presentation(&self, params: ColorPresentationParams) -> Result<Vec<ColorPresentation>> {
        colour::presentations(self, params).await
    }
}
