//! What is under the mouse.

use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{Hover, HoverContents, HoverParams};

use crate::ball::ball;
use crate::markup::markup;
use crate::server::Server;

/// # Errors
/// As [`Server::at`].
pub(crate) async fn hover(server: &Server, params: HoverParams) -> Result<Option<Hover>> {
    let at = server.at(params.text_document_position_params, |view, offset| {
        let hover = scenec_ide::hover(&view.document, offset)?;
        let pictures = view.settings.ball && view.abilities.markdown_hover;
        let ball = hover.ball.as_ref().filter(|_| pictures).and_then(ball);
        let words = match ball {
            // Above the words: long hovers scroll, and what the material looks like is asked for first.
            Some(image) => format!("{image}\n\n{}", hover.markdown),
            None => hover.markdown,
        };
        Some(Hover {
            contents: HoverContents::Markup(markup(&words, view.abilities.markdown_hover)),
            range: Some(view.range(hover.span)),
        })
    });
    at.await
}
