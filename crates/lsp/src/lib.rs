//! The language server: frames, documents and their order, one thin handler a feature, and the live preview.
//!
//! It must not know how statements are parsed and bound; what an editor shows comes from the features as plain data.
