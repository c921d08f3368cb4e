//! What each word is, for colouring: all of them, those of a range, or what changed.

use std::iter::zip;

use scenec_ide::{Modifiers, Token, TokenKind};
use scenec_text::Span;
use tower_lsp::jsonrpc::Result;
use tower_lsp::lsp_types::{
    Position, SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokens, SemanticTokensDelta,
    SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult, SemanticTokensLegend,
    SemanticTokensParams, SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult, Url,
};

use crate::documents::lock;
use crate::server::Server;
use crate::view::View;

/// The names of kinds and modifiers, by their numbers.
pub(crate) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend {
        token_types: TokenKind::ALL
            .map(|kind| SemanticTokenType::new(kind.standard_name()))
            .to_vec(),
        token_modifiers: Modifiers::STANDARD_NAMES.map(SemanticTokenModifier::new).to_vec(),
    }
}

/// # Errors
/// As [`Server::on`].
pub(crate) async fn full(server: &Server, params: SemanticTokensParams) -> Result<Option<SemanticTokensResult>> {
    let (found, _) = renewed(server, &params.text_document.uri).await?;
    Ok(found.map(SemanticTokensResult::Tokens))
}

/// # Errors
/// As [`Server::on`].
pub(crate) async fn delta(
    server: &Server,
    params: SemanticTokensDeltaParams,
) -> Result<Option<SemanticTokensFullDeltaResult>> {
    let (found, before) = renewed(server, &params.text_document.uri).await?;
    let Some(found) = found else {
        return Ok(None);
    };
    let before = before.filter(|(name, _)| *name == params.previous_result_id);
    Ok(Some(match before {
        Some((_, before)) => SemanticTokensFullDeltaResult::TokensDelta(SemanticTokensDelta {
            edits: difference(&before, &found.data),
            result_id: found.result_id,
        }),
        None => SemanticTokensFullDeltaResult::Tokens(found),
    }))
}

/// # Errors
/// As [`Server::on_exactly`].
pub(crate) async fn range(
    server: &Server,
    params: SemanticTokensRangeParams,
) -> Result<Option<SemanticTokensRangeResult>> {
    let on = server.on_exactly(&params.text_document.uri, move |view| {
        let found = scenec_ide::tokens(&view.document, view.span(params.range));
        SemanticTokensRangeResult::Tokens(SemanticTokens {
            result_id: None,
            data: encoded(view, &found),
        })
    });
    on.await
}

/// The tokens under the name by which they can be referred to.
type Sent = (String, Vec<SemanticToken>);

/// The tokens of the newest text, and those that the client was sent before.
async fn renewed(server: &Server, url: &Url) -> Result<(Option<SemanticTokens>, Option<Sent>)> {
    let found = server.on(url, |view| {
        let end = u32::try_from(view.document.text().len()).unwrap_or(u32::MAX);
        let found = scenec_ide::tokens(&view.document, Span::new(0, end));
        (view.revision.to_string(), encoded(view, &found))
    });
    let (Some((name, data)), Some(open)) = (found.await?, server.documents.get(url)) else {
        return Ok((None, None));
    };
    let before = lock(&open.tokens).replace((name.clone(), data.clone()));
    let found = SemanticTokens {
        result_id: Some(name),
        data,
    };
    Ok((Some(found), before))
}

/// Tokens as the protocol counts them: each from the one before it.
fn encoded(view: &View, tokens: &[Token]) -> Vec<SemanticToken> {
    let mut before = Position::default();
    let encode = |token: &Token| {
        let start = view.position(token.span.start);
        let same_line = start.line == before.line;
        let encoded = SemanticToken {
            delta_line: start.line - before.line,
            delta_start: start.character - if same_line { before.character } else { 0 },
            length: view.width(token.span),
            token_type: number(token.kind),
            token_modifiers_bitset: token.modifiers.bits(),
        };
        before = start;
        encoded
    };
    tokens.iter().map(encode).collect()
}

fn number(kind: TokenKind) -> u32 {
    let number = zip(0.., TokenKind::ALL).find(|(_, other)| *other == kind);
    number.map_or(0, |(number, _)| number)
}

/// The one edit that makes `after` of `before`, if they differ: what is alike at both ends stays.
fn difference(before: &[SemanticToken], after: &[SemanticToken]) -> Vec<SemanticTokensEdit> {
    let start = zip(before, after).take_while(|(a, b)| a == b).count();
    let rest = |tokens: &[SemanticToken]| tokens.len() - start;
    let ends = zip(before.iter().rev(), after.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let end = ends.min(rest(before)).min(rest(after));
    let gone = rest(before) - end;
    let data = after.get(start..after.len() - end).unwrap_or_default().to_vec();
    if gone == 0 && data.is_empty() {
        return Vec::new();
    }
    // A token is five numbers, and numbers are what is counted.
    let numbers = |tokens: usize| u32::try_from(5 * tokens).unwrap_or(u32::MAX);
    vec![SemanticTokensEdit {
        start: numbers(start),
        delete_count: numbers(gone),
        data: Some(data),
    }]
}

#[cfg(test)]
mod tests {
    use tower_lsp::lsp_types::SemanticToken;

    use super::difference;

    fn tokens(lengths: &[u32]) -> Vec<SemanticToken> {
        let token = |length: &u32| SemanticToken {
            delta_line: 0,
            delta_start: 0,
            length: *length,
            token_type: 0,
            token_modifiers_bitset: 0,
        };
        lengths.iter().map(token).collect()
    }

    fn check(before: &[u32], after: &[u32], expect: Option<(u32, u32, usize)>) {
        let edits = difference(&tokens(before), &tokens(after));
        let short = |edit: &tower_lsp::lsp_types::SemanticTokensEdit| {
            (edit.start, edit.delete_count, edit.data.as_ref().unwrap().len())
        };
        assert_eq!(edits.first().map(short), expect, "{before:?} {after:?}");
        let mut applied = tokens(before);
        for edit in edits {
            let start = edit.start as usize / 5;
            applied.splice(start..start + edit.delete_count as usize / 5, edit.data.unwrap());
        }
        assert_eq!(applied, tokens(after));
    }

    #[test]
    fn what_is_alike_stays() {
        check(&[], &[], None);
        check(&[1, 2, 3], &[1, 2, 3], None);
        check(&[1, 2, 3], &[1, 9, 3], Some((5, 5, 1)));
        check(&[1, 2], &[1, 2, 3], Some((10, 0, 1)));
        check(&[1, 2, 3], &[3], Some((0, 10, 0)));
        check(&[1, 1, 1], &[1, 1], Some((10, 5, 0)));
        check(&[], &[1], Some((0, 0, 1)));
    }
}
