//! Which devices there are. Asked once per process, and never a reason to fail.
//!
//! This owns the walk over platforms and devices, and the list of what it met. It doesn't choose among them.

use crate::error::{DeviceError, guarded, line};
use crate::info::{DeviceInfo, describe};
use crate::known;
use ocl::core::{self, DeviceId, DeviceType, PlatformId, PlatformInfo};
use scenec_opencl_loader as loader;
use std::sync::OnceLock;
use std::time::Instant;

/// The most devices listed for one platform; the bindings' own limit is neither checked by them nor high.
const DEVICES_PER_PLATFORM: u32 = 1024;

/// Everything that was found.
#[derive(Debug, Default)]
pub struct Discovery {
    /// The usable devices, in the order in which the drivers list them.
    pub devices: Vec<DeviceInfo>,
    /// Why something is missing, one line each: no library, no driver, a platform without devices.
    pub notes: Vec<String>,
    /// The handle of each of `devices`, in the same order.
    handles: Vec<DeviceId>,
}

impl Discovery {
    /// Devices that only exist for a test.
    #[cfg(test)]
    pub(crate) fn of(devices: Vec<DeviceInfo>) -> Self {
        Self {
            devices,
            ..Self::default()
        }
    }

    /// The handle of a device of this discovery.
    pub(crate) fn handle(&self, device: &DeviceInfo) -> Result<DeviceId, DeviceError> {
        match self.devices.get(device.index) {
            Some(known) if known == device => self.handles.get(device.index).copied(),
            _ => None,
        }
        .ok_or_else(|| DeviceError::new(format!("\"{}\" is not a device of this machine", device.name)))
    }
}

/// The devices of this machine. The first call asks the drivers; later ones only look.
///
/// Some drivers can't bear two threads that initialise them at once, so all callers wait for the first.
pub fn discover() -> &'static Discovery {
    static FOUND: OnceLock<Discovery> = OnceLock::new();
    FOUND.get_or_init(|| {
        let begin = Instant::now();
        let found = walk();
        if !found.devices.is_empty() {
            known::remember_asking(&known::cache(), begin.elapsed().as_secs_f64() * 1e9);
        }
        found
    })
}

fn walk() -> Discovery {
    let mut found = Discovery::default();
    if !loader::status().is_loaded() {
        found.notes.push(line(&loader::status().to_string()));
        return found;
    }
    match guarded(|| core::get_platform_ids().map_err(|error| DeviceError::of_call("list the platforms", &error))) {
        Ok(platforms) if platforms.is_empty() => found.notes.push(format!(
            "the OpenCL library is there ({}), but no driver is installed for it",
            line(&loader::status().to_string())
        )),
        Ok(platforms) => platforms
            .into_iter()
            .for_each(|platform| walk_platform(platform, &mut found)),
        Err(error) => found.notes.push(error.to_string()),
    }
    found
}

fn walk_platform(platform: PlatformId, found: &mut Discovery) {
    let name = platform_name(platform);
    // Every kind is asked for by name: without one, the bindings ask an environment variable.
    let listed = guarded(|| {
        core::get_device_ids(platform, Some(DeviceType::ALL), Some(DEVICES_PER_PLATFORM))
            .map_err(|error| DeviceError::of_call("list the devices", &error))
    });
    let handles = match listed {
        Ok(handles) => handles,
        Err(error) => {
            let help = if name.starts_with("Portable") {
                error.help().unwrap_or_default()
            } else {
                ""
            };
            let help = if help.is_empty() {
                String::new()
            } else {
                format!(" ({help})")
            };
            found
                .notes
                .push(format!("{name} offers no devices: {}{help}", error.message()));
            return;
        }
    };
    if handles.is_empty() {
        found.notes.push(format!("{name} offers no devices"));
    }
    for handle in handles {
        let index = found.devices.len();
        match guarded(|| describe(handle, index, name.clone())) {
            Ok(device) => {
                found.devices.push(device);
                found.handles.push(handle);
            }
            Err(error) => found.notes.push(format!("a device of {name} can't be used: {error}")),
        }
    }
}

fn platform_name(platform: PlatformId) -> String {
    let asked = guarded(|| {
        core::get_platform_info(platform, PlatformInfo::Name)
            .map_err(|error| DeviceError::of_call("ask for a platform's name", &error))
    });
    let name = asked.map(|name| line(&name.to_string())).unwrap_or_default();
    if name.is_empty() {
        "a platform without a name".to_owned()
    } else {
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::info::DeviceKind;

    #[test]
    fn discovery_is_one_for_all_threads_and_explains_an_absence() {
        let all: Vec<_> = (0..4)
            .map(|_| std::thread::spawn(|| discover() as *const Discovery as usize))
            .collect();
        for one in all {
            assert_eq!(one.join().unwrap(), discover() as *const Discovery as usize);
        }
        assert!(!discover().devices.is_empty() || !discover().notes.is_empty());
        for (index, device) in discover().devices.iter().enumerate() {
            assert_eq!(device.index, index);
            assert!(discover().handle(device).is_ok());
        }
    }

    #[test]
    fn a_device_from_elsewhere_has_no_handle() {
        let strange = crate::select::tests::device(0, "Nowhere", "Nothing", DeviceKind::Gpu);
        assert!(discover().handle(&strange).is_err());
    }
}
