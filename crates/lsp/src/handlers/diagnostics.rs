//! Findings, asked for or sent.

use std::hash::{DefaultHasher, Hash, Hasher};

use scenec_text::{Code, Diagnostic, Severity};
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    self, CodeDescription, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, DocumentDiagnosticParams,
    DocumentDiagnosticReport, DocumentDiagnosticReportResult, FullDocumentDiagnosticReport, NumberOrString,
    RelatedFullDocumentDiagnosticReport, RelatedUnchangedDocumentDiagnosticReport, UnchangedDocumentDiagnosticReport,
    Url,
};

use crate::server::Server;
use crate::view::View;

/// Who found it.
const SOURCE: &str = "scenec";
/// The most findings of one document that are sent; nobody reads more, and a broken large file would cost more to tell
/// about than to analyse.
const MOST: usize = 1000;

/// What is said of statements that are ignored, or that might as well not be there, whether or not they can be removed
/// just like that.
const IDLE: [Code; 10] = [
    Code::UnknownObject,
    Code::UnknownMaterial,
    Code::UnknownVariable,
    Code::AfterSubmission,
    Code::UnusedVariable,
    Code::UnusedObject,
    Code::UnusedMaterial,
    Code::IdleTransform,
    Code::EffectlessTransform,
    Code::MaterialReplaced,
];

/// Answers with the findings of the newest text, or that they are what they were. A client that can be told to ask again gets
/// those of a large document that are known at once, and is told so when all are known, if they are others.
///
/// # Errors
/// As [`Server::on`].
pub(crate) async fn pull(server: &Server, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
    let (url, previous) = (params.text_document.uri, params.previous_result_id);
    let again = server.abilities().refreshes_findings;
    let found = server.on(&url, move |view| {
        let known = again.then(|| findings_at_once(view)).flatten();
        let later = known.is_some().then_some(view.revision);
        (known.unwrap_or_else(|| findings(view)), later)
    });
    let ((items, problem), later) = found.await?.unwrap_or_default();
    if let Some(revision) = later {
        tokio::spawn(ask_again(server.clone(), url, revision, items.clone()));
    }
    server.tell_once(problem);
    let result_id = name(&items);
    let report = if previous.as_ref() == Some(&result_id) {
        DocumentDiagnosticReport::Unchanged(RelatedUnchangedDocumentDiagnosticReport {
            related_documents: None,
            unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id },
        })
    } else {
        DocumentDiagnosticReport::Full(RelatedFullDocumentDiagnosticReport {
            related_documents: None,
            full_document_diagnostic_report: FullDocumentDiagnosticReport {
                result_id: Some(result_id),
                items,
            },
        })
    };
    Ok(DocumentDiagnosticReportResult::Report(report))
}

/// Tells the client to ask again once everything is known of a state of a document of which it was told `known`, unless there is a
/// newer state, of which it asks by itself.
async fn ask_again(server: Server, url: Url, revision: u64, known: Vec<lsp_types::Diagnostic>) {
    let others = move |view: &View| view.revision == revision && findings(view).0 != known;
    if let Ok(Some(true)) = server.on(&url, others).await {
        server.client.workspace_diagnostic_refresh().await.unwrap_or_default();
    }
}

/// A name for findings: the same findings have the same one.
fn name(items: &[lsp_types::Diagnostic]) -> String {
    let mut hasher = DefaultHasher::new();
    serde_json::to_string(items).unwrap_or_default().hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

/// The findings of a document as its configuration weighs them, and what is wrong with that configuration.
pub(crate) fn findings(view: &View) -> (Vec<lsp_types::Diagnostic>, Option<String>) {
    weighed(view, view.document.diagnostics())
}

/// The same with what is known at once of a large document; `None` where everything is.
pub(crate) fn findings_at_once(view: &View) -> Option<(Vec<lsp_types::Diagnostic>, Option<String>)> {
    Some(weighed(view, &view.document.diagnostics_at_once()?))
}

fn weighed(view: &View, found: &[Diagnostic]) -> (Vec<lsp_types::Diagnostic>, Option<String>) {
    let file = view.file_options();
    let mut found: Vec<_> = found
        .iter()
        .filter_map(|found| Some((found, (file.level)(found.code)?)))
        .collect();
    let left_out = found.len().saturating_sub(MOST);
    if left_out > 0 {
        found.sort_by_key(|(_, severity)| *severity);
        found.truncate(MOST);
    }
    let mut findings: Vec<_> = found
        .into_iter()
        .map(|(found, severity)| finding(view, found, severity))
        .collect();
    if left_out > 0 {
        let words = format!("{left_out} more findings are not shown");
        findings.push(lsp_types::Diagnostic {
            severity: Some(DiagnosticSeverity::INFORMATION),
            source: Some(SOURCE.to_owned()),
            ..lsp_types::Diagnostic::new_simple(lsp_types::Range::default(), words)
        });
    }
    (findings, file.problem)
}

/// One finding as the client wants it.
pub(crate) fn finding(view: &View, found: &Diagnostic, severity: Severity) -> lsp_types::Diagnostic {
    let tags = tags(found);
    let mut labels = found.labels.iter();
    // Where the words at the place only repeat the sentence they would be noise.
    let first = labels.next().map(|label| label.message.as_str());
    let first = first.filter(|first| !found.message.contains(first)).unwrap_or_default();
    let help = found.help.as_ref().map(|help| format!("help: {help}"));
    let message = [found.message.as_str(), first, help.as_deref().unwrap_or_default()];
    let message: Vec<&str> = message.into_iter().filter(|words| !words.is_empty()).collect();
    let related = labels.map(|label| DiagnosticRelatedInformation {
        location: view.location(label.span),
        message: label.message.clone(),
    });
    let related: Vec<_> = related.collect();
    lsp_types::Diagnostic {
        range: view.range(found.span()),
        severity: Some(match severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
            Severity::Hint if tags.is_empty() => DiagnosticSeverity::INFORMATION,
            Severity::Hint => DiagnosticSeverity::HINT,
        }),
        code: Some(NumberOrString::String(found.code.id().to_owned())),
        code_description: view.abilities.code_links.then(|| link(view, found.code)).flatten(),
        source: Some(SOURCE.to_owned()),
        message: message.join("\n"),
        related_information: (view.abilities.related && !related.is_empty()).then_some(related),
        tags: (view.abilities.tags && !tags.is_empty()).then_some(tags),
        ..lsp_types::Diagnostic::default()
    }
}

fn link(view: &View, code: Code) -> Option<CodeDescription> {
    view.pages.link(code).map(|href| CodeDescription { href })
}

/// What is dropped, or could be, is shown faded: statements that were ignored or do nothing, and those whose repair is to
/// remove them.
fn tags(found: &Diagnostic) -> Vec<DiagnosticTag> {
    let removed = |fix: &scenec_text::Fix| fix.edits.iter().all(|edit| edit.text.is_empty());
    let idle =
        IDLE.contains(&found.code) || (found.severity() != Severity::Error && found.fix.as_ref().is_some_and(removed));
    if idle {
        vec![DiagnosticTag::UNNECESSARY]
    } else {
        Vec::new()
    }
}
