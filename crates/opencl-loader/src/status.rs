//! What became of the search for an OpenCL library, in words for the user.

use std::fmt;

/// Where the OpenCL functions lead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LoaderStatus {
    /// Something else had already brought an OpenCL into this process, and it is used.
    Present,
    /// A library was opened.
    Opened {
        /// The name or path it was opened by.
        library: String,
    },
    /// No library could be opened; every call reports that there are no platforms.
    Missing {
        /// One line for each name tried: the name and what the system said.
        tried: Vec<String>,
    },
}

impl LoaderStatus {
    /// Whether there is a library to ask for platforms.
    pub fn is_loaded(&self) -> bool {
        !matches!(self, Self::Missing { .. })
    }
}

impl fmt::Display for LoaderStatus {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Present => out.write_str("using the OpenCL that is already loaded in this process"),
            Self::Opened { library } => write!(out, "using {library}"),
            Self::Missing { tried } => write!(out, "no OpenCL library could be opened ({})", tried.join("; ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::LoaderStatus::{self, Missing, Opened, Present};

    fn check(status: LoaderStatus, loaded: bool, words: &str) {
        assert_eq!(status.is_loaded(), loaded);
        assert_eq!(status.to_string(), words);
    }

    #[test]
    fn statuses_read_well() {
        check(Present, true, "using the OpenCL that is already loaded in this process");
        check(
            Opened {
                library: "libOpenCL.so.1".into(),
            },
            true,
            "using libOpenCL.so.1",
        );
        check(
            Missing {
                tried: vec!["a.so: not found".into(), "b.so: not found".into()],
            },
            false,
            "no OpenCL library could be opened (a.so: not found; b.so: not found)",
        );
    }
}
