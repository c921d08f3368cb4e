//! Satisfies `-lOpenCL` with an empty archive, so that linking needs no OpenCL development files.
//!
//! The OpenCL bindings ask the linker for a library of that name. Every symbol they use is defined in this crate,
//! so an archive with nothing in it is all that has to be found.

use std::io::Error;
use std::path::PathBuf;
use std::{env, fs};

/// An `ar` archive without members.
const EMPTY_ARCHIVE: &[u8] = b"!<arch>\n";

fn main() -> Result<(), Error> {
    let folder = PathBuf::from(env::var_os("OUT_DIR").ok_or_else(|| Error::other("OUT_DIR is not set"))?);
    // The first name is what Unix-like linkers and MinGW look for, the second what MSVC's does.
    for name in ["libOpenCL.a", "OpenCL.lib"] {
        fs::write(folder.join(name), EMPTY_ARCHIVE)?;
    }
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rerun-if-changed=build.rs");
    Ok(())
}
