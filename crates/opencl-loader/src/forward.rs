//! The forwarders: how a call finds the real function, and what it answers where there is none.
//!
//! This is the one place of the crate with unsafe code. The symbols themselves are rows of [`table`].

#![allow(unsafe_code)]

mod library;
mod table;

use crate::LoaderStatus;
use std::ffi::{CStr, c_void};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicI32, Ordering};

/// Any pointer or handle: the calling convention makes no difference between them.
type Pointer = *mut c_void;

const SUCCESS: i32 = 0;
const OUT_OF_RESOURCES: i32 = -5;
const INVALID_OPERATION: i32 = -59;
const PLATFORM_NOT_FOUND: i32 = -1001;

/// The latest error code of a driver's own invention; zero for none.
static VENDOR_CODE: AtomicI32 = AtomicI32::new(SUCCESS);

/// What was loaded, or why nothing was. Opens the library if nothing has yet.
pub fn status() -> &'static LoaderStatus {
    // Naming the table here keeps the symbols together with this function: a linker that takes single members out
    // of an archive can't take this one and leave those.
    std::hint::black_box(&table::OWN);
    library::opened().status()
}

/// The latest error code that is in no OpenCL standard, if there was one since the last call.
///
/// Drivers invent codes. The bindings abort the calling thread on one they don't know, so a forwarder hands on
/// "out of resources" instead and keeps the original here for the error message.
pub fn take_vendor_code() -> Option<i32> {
    match VENDOR_CODE.swap(SUCCESS, Ordering::Relaxed) {
        SUCCESS => None,
        code => Some(code),
    }
}

/// Whether the bindings know an error code: the core set, the two extensions' codes, and NVIDIA's one.
fn is_known(code: i32) -> bool {
    matches!(code, 0 | -19..=-1 | -70..=-30 | -1001 | -1000 | -9999)
}

/// `code` itself if the bindings know it, and a code that they do know if not.
fn known(code: i32) -> i32 {
    if is_known(code) {
        return code;
    }
    VENDOR_CODE.store(code, Ordering::Relaxed);
    OUT_OF_RESOURCES
}

/// The code for a function that the library lacks, or that no library could provide.
fn missing() -> i32 {
    if library::opened().status().is_loaded() {
        INVALID_OPERATION
    } else {
        PLATFORM_NOT_FOUND
    }
}

/// The address of one function, looked up once.
struct Slot {
    name: &'static CStr,
    address: OnceLock<Option<usize>>,
}

impl Slot {
    const fn new(name: &'static CStr) -> Self {
        Self {
            name,
            address: OnceLock::new(),
        }
    }

    fn address(&self) -> Option<Pointer> {
        self.address
            .get_or_init(|| library::opened().find(self.name).map(|at| at as usize))
            .map(|at| at as Pointer)
    }
}

/// Writes through a pointer that the caller may have left null.
///
/// # Safety
///
/// `to` is null or points to memory that holds a `T`.
unsafe fn store<T>(to: *mut T, value: T) {
    if !to.is_null() {
        // SAFETY: not null, and so valid for a write by this function's contract.
        unsafe { to.write(value) }
    }
}

/// Counts the platforms, like the function of this name in the standard, but an absence is a zero.
///
/// The common loader answers -1001 where no driver is installed, and the bindings then sleep ten seconds in the
/// hope that one turns up.
///
/// # Safety
///
/// `platforms` is null or has room for `num_entries` handles; `num_platforms` is null or points to a count.
#[unsafe(no_mangle)]
#[allow(non_snake_case)]
unsafe extern "system" fn clGetPlatformIDs(num_entries: u32, platforms: Pointer, num_platforms: *mut u32) -> i32 {
    static SLOT: Slot = Slot::new(c"clGetPlatformIDs");
    let code = match SLOT.address() {
        Some(address) => {
            type Function = unsafe extern "system" fn(u32, Pointer, *mut u32) -> i32;
            // SAFETY: the address is the one found under this very name, whose types the standard fixes.
            let function = unsafe { std::mem::transmute::<Pointer, Function>(address) };
            // SAFETY: the caller's promises are passed on unchanged.
            known(unsafe { function(num_entries, platforms, num_platforms) })
        }
        None => PLATFORM_NOT_FOUND,
    };
    if code != PLATFORM_NOT_FOUND {
        return code;
    }
    // SAFETY: null or a valid place for a count, by the caller's promise.
    unsafe { store(num_platforms, 0) };
    SUCCESS
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(code: i32, expect: i32) {
        assert_eq!(known(code), expect, "{code}");
    }

    #[test]
    fn codes_outside_the_standard_are_kept_aside() {
        for code in [0, -1, -11, -19, -30, -59, -70, -1000, -1001, -9999] {
            check(code, code);
        }
        assert_eq!(take_vendor_code(), None);
        for code in [-20, -29, -71, -1057, -6000, i32::MIN, 1, i32::MAX] {
            check(code, OUT_OF_RESOURCES);
            assert_eq!(take_vendor_code(), Some(code));
        }
        assert_eq!(take_vendor_code(), None);
    }

    #[test]
    fn platforms_are_counted_or_absent_but_never_an_error() {
        let mut count = u32::MAX;
        // SAFETY: no list is asked for, and the count is a local variable.
        let code = unsafe { clGetPlatformIDs(0, std::ptr::null_mut(), &mut count) };
        assert_eq!(code, SUCCESS);
        assert_ne!(count, u32::MAX);
        assert!(status().is_loaded() || count == 0);
    }
}
