//! Which of the devices a user means.
//!
//! | request | meaning |
//! |---|---|
//! | `opencl` | the first GPU, else the first accelerator, else the first CPU, else the first of what remains |
//! | `opencl:2` | the device of that index in the list |
//! | `opencl:rtx` | the one device whose platform and name, in either case, contain the text |

use crate::discover::Discovery;
use crate::error::DeviceError;
use crate::info::{DeviceInfo, DeviceKind};

/// The kinds, from the most to the least wanted.
const PREFERENCE: [DeviceKind; 4] = [
    DeviceKind::Gpu,
    DeviceKind::Accelerator,
    DeviceKind::Cpu,
    DeviceKind::Other,
];

/// Whether a request is one of this module's: `opencl` alone or with a choice after a colon.
pub fn is_opencl(request: &str) -> bool {
    request == "opencl" || request.starts_with("opencl:")
}

/// The device that a request names.
///
/// # Errors
///
/// Nothing fits, or a name fits several devices; the message lists what there is.
pub fn select<'a>(request: &str, found: &'a Discovery) -> Result<&'a DeviceInfo, DeviceError> {
    let choice = match request.split_once(':') {
        None if request == "opencl" => None,
        Some(("opencl", choice)) => Some(choice.trim()),
        _ => return Err(DeviceError::new(format!("\"{request}\" is not an OpenCL device")).with_help(FORMS)),
    };
    if found.devices.is_empty() {
        return Err(none_at_all(found));
    }
    match choice {
        None => preferred(found).ok_or_else(|| none_at_all(found)),
        Some("") => Err(DeviceError::new("a device is missing after \"opencl:\"").with_help(FORMS)),
        Some(index) if index.bytes().all(|digit| digit.is_ascii_digit()) => index
            .parse()
            .ok()
            .and_then(|index: usize| found.devices.get(index))
            .ok_or_else(|| DeviceError::new(format!("there is no OpenCL device {index}")).with_help(list(found))),
        Some(name) => by_name(name, found),
    }
}

/// The first GPU, which is what makes an automatic choice worth going to OpenCL for.
pub fn gpu(found: &Discovery) -> Option<&DeviceInfo> {
    found.devices.iter().find(|device| device.kind == DeviceKind::Gpu)
}

const FORMS: &str = "write opencl, opencl:INDEX or opencl:NAME";

fn preferred(found: &Discovery) -> Option<&DeviceInfo> {
    PREFERENCE
        .iter()
        .find_map(|kind| found.devices.iter().find(|device| device.kind == *kind))
}

fn by_name<'a>(name: &str, found: &'a Discovery) -> Result<&'a DeviceInfo, DeviceError> {
    let wanted = name.to_lowercase();
    let fits: Vec<&DeviceInfo> = found
        .devices
        .iter()
        .filter(|device| device.full_name().to_lowercase().contains(&wanted))
        .collect();
    // A whole name wins over the longer names that begin with it.
    let exact: Vec<&DeviceInfo> = fits
        .iter()
        .copied()
        .filter(|device| device.name.to_lowercase() == wanted)
        .collect();
    match (exact.as_slice(), fits.as_slice()) {
        ([one], _) | (_, [one]) => Ok(one),
        (_, []) => Err(DeviceError::new(format!("no OpenCL device is called \"{name}\"")).with_help(list(found))),
        _ => Err(DeviceError::new(format!("\"{name}\" fits {} OpenCL devices", fits.len())).with_help(list(found))),
    }
}

fn none_at_all(found: &Discovery) -> DeviceError {
    let mut reasons = found.notes.join("; ");
    if reasons.is_empty() {
        reasons.push_str("the drivers offer none");
    }
    DeviceError::new(format!("there is no OpenCL device: {reasons}"))
        .with_help("install a driver (for the processor itself: PoCL), or use --device cpu")
}

fn list(found: &Discovery) -> String {
    let devices: Vec<String> = found
        .devices
        .iter()
        .map(|device| format!("{}: {}", device.index, device.full_name()))
        .collect();
    format!("there is {}", devices.join(", "))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn device(index: usize, platform: &str, name: &str, kind: DeviceKind) -> DeviceInfo {
        DeviceInfo {
            index,
            platform: platform.into(),
            name: name.into(),
            kind,
            version: "OpenCL 1.2".into(),
            driver: "1".into(),
            global_memory: 1 << 30,
            max_allocation: 1 << 28,
            has_f64: true,
            has_fma: true,
            exact_divide: true,
            max_work_group: 256,
        }
    }

    fn machine() -> Discovery {
        let devices = [
            ("Portable Computing Language", "pthread-zen", DeviceKind::Cpu),
            ("Xilinx", "Alveo", DeviceKind::Accelerator),
            ("NVIDIA CUDA", "RTX 3060", DeviceKind::Gpu),
            ("NVIDIA CUDA", "RTX 3060 Ti", DeviceKind::Gpu),
        ];
        let devices = devices
            .iter()
            .enumerate()
            .map(|(index, (platform, name, kind))| device(index, platform, name, *kind));
        Discovery::of(devices.collect())
    }

    /// `expect` is an index, or a part of the error.
    fn check(found: &Discovery, request: &str, expect: Result<usize, &str>) {
        match (select(request, found), expect) {
            (Ok(device), Ok(index)) => assert_eq!(device.index, index, "{request}"),
            (Err(error), Err(part)) => assert!(error.to_string().contains(part), "{request}: {error}"),
            (got, expect) => panic!("{request}: {got:?} instead of {expect:?}"),
        }
    }

    #[test]
    fn requests_name_devices() {
        let found = machine();
        check(&found, "opencl", Ok(2));
        check(&found, "opencl:0", Ok(0));
        check(&found, "opencl:3", Ok(3));
        check(&found, "opencl:ZEN", Ok(0));
        check(&found, "opencl:xilinx alv", Ok(1));
        check(&found, "opencl:rtx 3060", Ok(2));
        check(&found, "opencl: 3060 Ti", Ok(3));
    }

    #[test]
    fn what_fits_nothing_or_too_much_is_explained() {
        let found = machine();
        let all = "0: Portable Computing Language pthread-zen, 1: Xilinx Alveo, 2: NVIDIA CUDA RTX 3060, 3: ";
        check(
            &found,
            "opencl:4",
            Err("there is no OpenCL device 4; there is 0: Portable"),
        );
        check(
            &found,
            "opencl:99999999999999999999999",
            Err("there is no OpenCL device 9999"),
        );
        check(&found, "opencl:nvidia", Err("\"nvidia\" fits 2 OpenCL devices"));
        check(&found, "opencl:radeon", Err(all));
        check(&found, "opencl:", Err("missing after"));
        check(&found, "opencl: ", Err("missing after"));
        check(&found, "openclx", Err("opencl:INDEX"));
        check(&found, "OpenCL:0", Err("is not an OpenCL device"));
    }

    #[test]
    fn an_empty_machine_says_why() {
        let mut found = Discovery::default();
        check(&found, "opencl", Err("the drivers offer none"));
        found.notes.push("no library".into());
        check(
            &found,
            "opencl:0",
            Err("there is no OpenCL device: no library; install"),
        );
        check(&found, "opencl:x", Err("no library"));
    }

    #[test]
    fn the_kinds_are_preferred_in_order() {
        let mut found = machine();
        assert_eq!(gpu(&found).map(|device| device.index), Some(2));
        found.devices.truncate(2);
        assert_eq!(gpu(&found), None);
        check(&found, "opencl", Ok(1));
        found.devices.truncate(1);
        check(&found, "opencl", Ok(0));
    }

    #[test]
    fn requests_are_told_from_other_words() {
        assert!(is_opencl("opencl") && is_opencl("opencl:0") && is_opencl("opencl:"));
        assert!(!is_opencl("cpu") && !is_opencl("openclx") && !is_opencl(""));
    }
}
