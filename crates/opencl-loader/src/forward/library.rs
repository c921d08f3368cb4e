//! The search for the machine's OpenCL library.

use super::Pointer;
use crate::LoaderStatus;
use libloading::Library;
use std::error::Error;
use std::ffi::CStr;
use std::mem::ManuallyDrop;
use std::sync::OnceLock;

/// The names to try, in this order.
#[cfg(target_os = "macos")]
const NAMES: &[&str] = &["/System/Library/Frameworks/OpenCL.framework/OpenCL"];
#[cfg(windows)]
const NAMES: &[&str] = &["OpenCL.dll"];
#[cfg(not(any(target_os = "macos", windows)))]
const NAMES: &[&str] = &["libOpenCL.so.1", "libOpenCL.so"];

/// A library that stays open until the process ends, or the reasons why there is none.
pub(super) struct Opened {
    status: LoaderStatus,
    // Never closed: drivers leave threads and exit handlers behind that call into it.
    library: Option<ManuallyDrop<Library>>,
}

/// The library, opened on the first call.
pub(super) fn opened() -> &'static Opened {
    static OPENED: OnceLock<Opened> = OnceLock::new();
    OPENED.get_or_init(open)
}

impl Opened {
    /// What was opened, or why nothing was.
    pub(super) fn status(&self) -> &LoaderStatus {
        &self.status
    }

    /// The address of a function, if the library has it.
    pub(super) fn find(&self, name: &CStr) -> Option<Pointer> {
        self.library.as_ref().and_then(|library| address(library, name))
    }
}

fn open() -> Opened {
    if let Some(library) = already_present() {
        return Opened {
            status: LoaderStatus::Present,
            library: Some(library),
        };
    }
    let mut tried = Vec::new();
    for name in NAMES {
        // SAFETY: opening a library runs its initialisers; the system's own OpenCL is trusted with that, as it
        // would be had the program been linked to it.
        match unsafe { Library::new(*name) } {
            Ok(library) => {
                let status = LoaderStatus::Opened {
                    library: (*name).to_owned(),
                };
                return Opened {
                    status,
                    library: Some(ManuallyDrop::new(library)),
                };
            }
            Err(error) => tried.push(reason(name, &error)),
        }
    }
    Opened {
        status: LoaderStatus::Missing { tried },
        library: None,
    }
}

/// The name and the system's own words, which lie beneath the error's and begin with the name on some systems.
fn reason(name: &str, error: &dyn Error) -> String {
    let words = error.source().map_or_else(|| error.to_string(), ToString::to_string);
    if words.starts_with(name) {
        words
    } else {
        format!("{name}: {words}")
    }
}

/// An OpenCL that came into the process some other way, such as a preloaded simulator.
///
/// It must be looked for first: a simulator that replaces OpenCL breaks if the real library is opened beside it.
#[cfg(unix)]
fn already_present() -> Option<ManuallyDrop<Library>> {
    use libloading::os::unix;
    use std::ptr;

    // RTLD_NEXT, which has this value on Linux (both C libraries), macOS and the BSDs. It means "the objects
    // loaded after the one that asks", so the search can't come upon the symbols that this crate itself defines.
    let next = ptr::without_provenance_mut(usize::MAX);
    // SAFETY: a pseudo-handle is good for lookups, which is all that it is used for: ManuallyDrop never closes it.
    let library = ManuallyDrop::new(Library::from(unsafe { unix::Library::from_raw(next) }));
    address(&library, c"clGetPlatformIDs").map(|_| library)
}

/// An OpenCL that came into the process some other way.
#[cfg(windows)]
fn already_present() -> Option<ManuallyDrop<Library>> {
    libloading::os::windows::Library::open_already_loaded("OpenCL.dll")
        .ok()
        .map(|library| ManuallyDrop::new(Library::from(library)))
}

fn address(library: &Library, name: &CStr) -> Option<Pointer> {
    // SAFETY: the symbol is only taken for its address here; whoever calls it names the types.
    let symbol = unsafe { library.get::<Pointer>(name) }.ok()?;
    Some(*symbol).filter(|address| !address.is_null())
}

#[cfg(test)]
mod tests {
    use super::reason;
    use std::io::Error;

    fn check(name: &str, error: Error, expect: &str) {
        assert_eq!(reason(name, &error), expect);
    }

    #[test]
    fn a_reason_names_the_library_once() {
        check(
            "libOpenCL.so.1",
            Error::other("libOpenCL.so.1: cannot open"),
            "libOpenCL.so.1: cannot open",
        );
        check(
            "OpenCL.dll",
            Error::other("the module was not found"),
            "OpenCL.dll: the module was not found",
        );
    }

    #[test]
    fn the_systems_words_come_before_the_wrappers() {
        let inner = Error::other("no such file");
        check("a.so", Error::other(Error::other(inner)), "a.so: no such file");
    }
}
