//! Where OpenCL or its drivers are missing, a program starts at once and finds nothing, with a reason.
//!
//! The tests run this very program again under such conditions: discovery happens once per process.

#![cfg(target_os = "linux")]
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may do both, in its helpers too"
)]

use scenec_device::discover;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

/// Far below the ten seconds that the bindings wait for a platform, and far above what a loaded machine needs.
const AT_ONCE: Duration = Duration::from_secs(2);

/// Looks for devices in a process with `variable` set to `value`: there must be none, and a note with `part`.
fn check(variable: &str, value: &Path, part: &str) {
    let start = Instant::now();
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "child", "--ignored", "--nocapture"])
        .env(variable, value)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{said}{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(said.contains("devices: 0\n"), "{said}");
    assert!(said.contains(part), "{said}");
    assert!(start.elapsed() < AT_ONCE, "{:?}", start.elapsed());
}

#[test]
#[ignore = "the other tests run it, in a process of its own"]
fn child() {
    let found = discover();
    assert_eq!(found.devices.is_empty(), !found.notes.is_empty(), "{found:?}");
    println!("\ndevices: {}\n{}", found.devices.len(), found.notes.join("\n"));
}

#[test]
fn a_machine_without_drivers_has_no_devices() {
    // Either the library is there and finds no driver, or the machine has no library to begin with.
    check("OCL_ICD_VENDORS", Path::new("/nonexistent"), "OpenCL library");
}

#[test]
fn a_machine_without_the_library_has_no_devices() {
    // Files that are no libraries stand before the real ones.
    let folder = std::env::temp_dir().join(format!("scenec-absence-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["libOpenCL.so.1", "libOpenCL.so"] {
        std::fs::write(folder.join(name), "").unwrap();
    }
    check("LD_LIBRARY_PATH", &folder, "no OpenCL library could be opened (");
    std::fs::remove_dir_all(&folder).unwrap();
}
