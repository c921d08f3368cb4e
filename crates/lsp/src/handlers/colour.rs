//! Colours beside the numbers, and the numbers of a picked colour.

use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{Color, ColorInformation, ColorPresentation, ColorPresentationParams, DocumentColorParams};

use crate::server::Server;

/// # Errors
/// As [`Server::on`].
pub(crate) async fn colours(server: &Server, params: DocumentColorParams) -> Result<Vec<ColorInformation>> {
    let on = server.on(&params.text_document.uri, |view| {
        let swatches = scenec_ide::colours(&view.document).into_iter();
        let swatches = swatches.map(|swatch| ColorInformation {
            range: view.range(swatch.span),
            color: colour(swatch.colour),
        });
        swatches.collect()
    });
    Ok(on.await?.unwrap_or_default())
}

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn presentations(server: &Server, params: ColorPresentationParams) -> Result<Vec<ColorPresentation>> {
    let on = server.on_exactly(&params.text_document.uri, move |view| {
        let picked = [params.color.red, params.color.green, params.color.blue].map(f64::from);
        let edits = scenec_ide::colour_edits(&view.document, view.span(params.range), picked)?;
        let label = edits
            .iter()
            .map(|edit| edit.text.as_str())
            .collect::<Vec<_>>()
            .join(" ");
        let mut edits = view.edits(&edits).into_iter();
        Some(ColorPresentation {
            label,
            text_edit: edits.next(),
            additional_text_edits: Some(edits.collect()),
        })
    });
    Ok(on.await?.flatten().into_iter().collect())
}

fn colour(colour: [f64; 3]) -> Color {
    let [red, green, blue] = colour.map(|part| part as f32);
    Color {
        red,
        green,
        blue,
        alpha: 1.0,
    }
}
