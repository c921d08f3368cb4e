//! What a device tells about itself.
//!
//! A driver's answers are taken as bytes and read here: the bindings' own parsing panics on what it doesn't expect.

use crate::error::{DeviceError, line};
use ocl::core::{self, DeviceId, DeviceInfo as Ask, DeviceType};
use std::fmt;

/// The bit of a floating-point configuration that promises a fused multiply-add (OpenCL 1.2, table 4.3).
const FP_FMA: u64 = 1 << 5;
/// The bit that promises correctly rounded division and square root, where the build option asks for them.
const FP_EXACT_DIVIDE: u64 = 1 << 7;

/// What a device is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DeviceKind {
    /// A graphics processor.
    Gpu,
    /// A dedicated accelerator that is no graphics processor.
    Accelerator,
    /// The machine's own processor, or a simulator on it.
    Cpu,
    /// None of these.
    Other,
}

impl fmt::Display for DeviceKind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.pad(match self {
            Self::Gpu => "GPU",
            Self::Accelerator => "accelerator",
            Self::Cpu => "CPU",
            Self::Other => "other",
        })
    }
}

/// One device, as its driver describes it. All texts are single lines without control characters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceInfo {
    /// The position in [`crate::Discovery::devices`], which is how a user may name the device.
    pub index: usize,
    /// The name of the platform, that is, of the driver.
    pub platform: String,
    /// The name of the device.
    pub name: String,
    /// What it is.
    pub kind: DeviceKind,
    /// The OpenCL version, such as `OpenCL 3.0`, with what the driver adds to it.
    pub version: String,
    /// The driver's version.
    pub driver: String,
    /// The device's memory, in bytes; zero where the driver doesn't say.
    pub global_memory: u64,
    /// The largest single buffer, in bytes; zero where the driver doesn't say.
    pub max_allocation: u64,
    /// Whether kernels may use `double`.
    pub has_f64: bool,
    /// Whether `fma` on `float` is done in hardware rather than emulated.
    pub has_fma: bool,
    /// Whether `-cl-fp32-correctly-rounded-divide-sqrt` is honoured.
    pub exact_divide: bool,
    /// The most work-items in a work-group; at least 1.
    pub max_work_group: usize,
}

impl DeviceInfo {
    /// What tells this device and its driver from all others, on this machine and in time.
    pub(crate) fn identity(&self) -> [&[u8]; 4] {
        [&self.platform, &self.name, &self.version, &self.driver].map(|text| text.as_bytes())
    }

    /// Platform and name together, the text that a user's choice by name is matched with.
    pub fn full_name(&self) -> String {
        format!("{} {}", self.platform, self.name)
    }
}

/// Asks a device about itself.
///
/// # Errors
///
/// It has no name or compiler, or is switched off.
pub(crate) fn describe(device: DeviceId, index: usize, platform: String) -> Result<DeviceInfo, DeviceError> {
    let name = text(device, Ask::Name);
    if name.is_empty() {
        return Err(DeviceError::new("it doesn't tell its name"));
    }
    if number(device, Ask::Available) == Some(0) {
        return Err(DeviceError::new(format!("{name} is switched off")));
    }
    if number(device, Ask::CompilerAvailable) == Some(0) {
        return Err(DeviceError::new(format!("{name} has no compiler")));
    }
    let single = number(device, Ask::SingleFpConfig).unwrap_or(0);
    let double = number(device, Ask::DoubleFpConfig).unwrap_or(0);
    Ok(DeviceInfo {
        index,
        platform,
        name,
        kind: kind(number(device, Ask::Type).unwrap_or(0)),
        version: text(device, Ask::Version),
        driver: text(device, Ask::DriverVersion),
        global_memory: number(device, Ask::GlobalMemSize).unwrap_or(0),
        max_allocation: number(device, Ask::MaxMemAllocSize).unwrap_or(0),
        has_f64: double != 0 || text_has(device, Ask::Extensions, "cl_khr_fp64"),
        has_fma: single & FP_FMA != 0,
        exact_divide: single & FP_EXACT_DIVIDE != 0,
        max_work_group: number(device, Ask::MaxWorkGroupSize).map_or(1, |most| most.max(1) as usize),
    })
}

fn kind(bits: u64) -> DeviceKind {
    match DeviceType::from_bits_truncate(bits) {
        bits if bits.contains(DeviceType::GPU) => DeviceKind::Gpu,
        bits if bits.contains(DeviceType::ACCELERATOR) => DeviceKind::Accelerator,
        bits if bits.contains(DeviceType::CPU) => DeviceKind::Cpu,
        _ => DeviceKind::Other,
    }
}

/// The bytes of one answer; none where the device has no answer.
fn bytes(device: DeviceId, ask: Ask) -> Vec<u8> {
    core::get_device_info_raw(device, ask as u32).unwrap_or_default()
}

fn text(device: DeviceId, ask: Ask) -> String {
    line(&String::from_utf8_lossy(&bytes(device, ask)))
}

fn text_has(device: DeviceId, ask: Ask, word: &str) -> bool {
    String::from_utf8_lossy(&bytes(device, ask))
        .split(['\0', ' '])
        .any(|one| one == word)
}

fn number(device: DeviceId, ask: Ask) -> Option<u64> {
    integer(&bytes(device, ask))
}

/// An integer of the device's choice of width, in this machine's byte order.
fn integer(bytes: &[u8]) -> Option<u64> {
    match bytes.len() {
        4 => bytes.try_into().ok().map(u32::from_ne_bytes).map(u64::from),
        8 => bytes.try_into().ok().map(u64::from_ne_bytes),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(bits: u64, expect: DeviceKind) {
        assert_eq!(kind(bits), expect, "{bits:#x}");
    }

    #[test]
    fn kinds_come_from_the_type_bits() {
        check(1 << 1 | 1, DeviceKind::Cpu);
        check(1 << 2, DeviceKind::Gpu);
        check(1 << 3, DeviceKind::Accelerator);
        check(1 << 4, DeviceKind::Other);
        check(0, DeviceKind::Other);
    }

    #[test]
    fn integers_of_both_widths_are_read_and_others_refused() {
        assert_eq!(integer(&7u32.to_ne_bytes()), Some(7));
        assert_eq!(integer(&u64::MAX.to_ne_bytes()), Some(u64::MAX));
        assert_eq!(integer(&[]), None);
        assert_eq!(integer(&[1, 2, 3]), None);
    }
}
