//! What the client can do, read once from its greeting.

use tower_lsp::lsp_types::{ClientCapabilities, MarkupKind, PositionEncodingKind};

/// How columns are counted.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum Encoding {
    /// In bytes.
    Utf8,
    /// In UTF-16 code units, which every client knows.
    #[default]
    Utf16,
}

impl Encoding {
    /// The name that the protocol has for it.
    pub(crate) fn kind(self) -> PositionEncodingKind {
        match self {
            Self::Utf8 => PositionEncodingKind::UTF8,
            Self::Utf16 => PositionEncodingKind::UTF16,
        }
    }

    /// How many columns a character takes.
    pub(crate) const fn width(self, character: char) -> u32 {
        match self {
            Self::Utf8 => character.len_utf8() as u32,
            Self::Utf16 => character.len_utf16() as u32,
        }
    }
}

/// What matters here of all that a client can do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Abilities {
    /// How it counts columns.
    pub(crate) encoding: Encoding,
    /// It asks for findings; otherwise they are sent.
    pub(crate) pulls: bool,
    /// It can be told to ask for findings again.
    pub(crate) refreshes_findings: bool,
    /// It can be told to ask for inlay hints again.
    pub(crate) refreshes_hints: bool,
    /// It can be told to ask for code lenses again.
    pub(crate) refreshes_lenses: bool,
    /// Findings may name related places.
    pub(crate) related: bool,
    /// The codes of findings may be links.
    pub(crate) code_links: bool,
    /// Findings may be tagged.
    pub(crate) tags: bool,
    /// It answers questions about its settings.
    pub(crate) configuration: bool,
    /// It can be asked to watch files.
    pub(crate) watches_files: bool,
    /// It can be asked to tell of changed settings.
    pub(crate) tells_settings: bool,
    /// Hovers may be Markdown.
    pub(crate) markdown_hover: bool,
    /// The documentation of completions may be Markdown.
    pub(crate) markdown_completion: bool,
    /// The documentation of signatures may be Markdown.
    pub(crate) markdown_signature: bool,
    /// Parameters may be given as places in the label.
    pub(crate) label_offsets: bool,
    /// Completions may have places to fill in.
    pub(crate) snippets: bool,
    /// The outline may be a tree.
    pub(crate) hierarchy: bool,
    /// Definitions may tell where they were asked from.
    pub(crate) links: bool,
    /// Code actions may be more than commands.
    pub(crate) actions: bool,
    /// Edits may name the version that they are for.
    pub(crate) versioned_edits: bool,
    /// Renaming may begin with a question whether it can.
    pub(crate) prepares_rename: bool,
    /// It knows the commands of the project's own extension.
    pub(crate) commands: bool,
}

impl Abilities {
    /// Reads them.
    pub(crate) fn of(client: &ClientCapabilities) -> Self {
        let mut found = Self {
            encoding: encoding(client),
            ..Self::default()
        };
        found.workspace(client);
        found.document(client);
        let experimental = client.experimental.as_ref();
        found.commands = experimental.and_then(|one| one.pointer("/scenec/commands")) == Some(&true.into());
        found
    }

    fn workspace(&mut self, client: &ClientCapabilities) {
        let Some(workspace) = &client.workspace else {
            return;
        };
        self.configuration = workspace.configuration == Some(true);
        self.refreshes_findings = workspace.diagnostic.as_ref().and_then(|one| one.refresh_support) == Some(true);
        self.refreshes_hints = workspace.inlay_hint.as_ref().and_then(|one| one.refresh_support) == Some(true);
        self.refreshes_lenses = workspace.code_lens.as_ref().and_then(|one| one.refresh_support) == Some(true);
        let watching = workspace.did_change_watched_files.as_ref();
        self.watches_files = watching.and_then(|one| one.dynamic_registration) == Some(true);
        let settings = workspace.did_change_configuration.as_ref();
        self.tells_settings = settings.and_then(|one| one.dynamic_registration) == Some(true);
        let edits = workspace.workspace_edit.as_ref();
        self.versioned_edits = edits.and_then(|one| one.document_changes) == Some(true);
    }

    fn document(&mut self, client: &ClientCapabilities) {
        let Some(document) = &client.text_document else {
            return;
        };
        let markdown = |kinds: &Option<Vec<MarkupKind>>| {
            kinds.as_ref().and_then(|kinds| kinds.first()) == Some(&MarkupKind::Markdown)
        };
        self.pulls = document.diagnostic.is_some();
        if let Some(findings) = &document.publish_diagnostics {
            self.related = findings.related_information == Some(true);
            self.code_links = findings.code_description_support == Some(true);
            self.tags = findings.tag_support.is_some();
        }
        if let Some(hover) = &document.hover {
            self.markdown_hover = markdown(&hover.content_format);
        }
        if let Some(item) = document
            .completion
            .as_ref()
            .and_then(|one| one.completion_item.as_ref())
        {
            self.snippets = item.snippet_support == Some(true);
            self.markdown_completion = markdown(&item.documentation_format);
        }
        let signature = document.signature_help.as_ref();
        if let Some(signature) = signature.and_then(|one| one.signature_information.as_ref()) {
            self.markdown_signature = markdown(&signature.documentation_format);
            let parameter = signature.parameter_information.as_ref();
            self.label_offsets = parameter.and_then(|one| one.label_offset_support) == Some(true);
        }
        let symbols = document.document_symbol.as_ref();
        self.hierarchy = symbols.and_then(|one| one.hierarchical_document_symbol_support) == Some(true);
        self.links = document.definition.as_ref().and_then(|one| one.link_support) == Some(true);
        self.prepares_rename = document.rename.as_ref().and_then(|one| one.prepare_support) == Some(true);
        let actions = document.code_action.as_ref();
        self.actions = actions.is_some_and(|one| one.code_action_literal_support.is_some());
    }
}

/// Bytes where the client offers them: nothing has to be counted then.
fn encoding(client: &ClientCapabilities) -> Encoding {
    let offered = client
        .general
        .as_ref()
        .and_then(|general| general.position_encodings.as_ref());
    match offered {
        Some(offered) if offered.contains(&PositionEncodingKind::UTF8) => Encoding::Utf8,
        _ => Encoding::Utf16,
    }
}
