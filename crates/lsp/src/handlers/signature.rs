//! Which of a statement's values the cursor is in.

use scenec_ide::Signature;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    ParameterInformation, ParameterLabel, SignatureHelp, SignatureHelpParams, SignatureInformation,
};

use crate::abilities::Encoding;
use crate::markup::documentation;
use crate::server::Server;
use crate::view::View;

/// # Errors
/// As [`Server::at`].
pub(crate) async fn signature(server: &Server, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
    let at = server.at(params.text_document_position_params, |view, offset| {
        let found = scenec_ide::signature(&view.document, offset)?;
        Some(SignatureHelp {
            active_signature: Some(0),
            active_parameter: Some(found.active),
            signatures: vec![information(view, found)],
        })
    });
    at.await
}

fn information(view: &View, found: Signature) -> SignatureInformation {
    let markdown = view.abilities.markdown_signature;
    let parameters = found.parameters.iter().map(|parameter| {
        let (start, end) = parameter.range;
        let part = |from: u32, to: u32| found.label.get(from as usize..to as usize).unwrap_or_default();
        // Labels are counted in UTF-16, whatever was agreed for the text.
        let units = |text: &str| text.chars().map(|one| Encoding::Utf16.width(one)).sum();
        ParameterInformation {
            label: if view.abilities.label_offsets {
                ParameterLabel::LabelOffsets([units(part(0, start)), units(part(0, end))])
            } else {
                ParameterLabel::Simple(part(start, end).to_owned())
            },
            documentation: documentation(&parameter.documentation, markdown),
        }
    });
    SignatureInformation {
        parameters: Some(parameters.collect()),
        documentation: documentation(&found.documentation, markdown),
        active_parameter: None,
        label: found.label,
    }
}
