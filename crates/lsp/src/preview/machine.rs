//! What computes the passes of one picture.
//!
//! Drivers are asked only when a pass could be theirs: coarse passes are done before a device has opened its eyes, and a
//! scene that the processor draws within a blink never wakes one.

use scenec_device::{DeviceInfo, Precision, discover, gpu, is_opencl, select};

/// What the processor does within this, in nanoseconds, is not worth another device's preparations.
const BLINK: f64 = 50e6;

/// A wish, what was found for it, and what is to be said about that.
pub(super) struct Machine<'a> {
    wish: &'a str,
    precision: Precision,
    /// Once asked for.
    device: Option<Option<&'static DeviceInfo>>,
    pub(super) remark: Option<String>,
}

impl<'a> Machine<'a> {
    pub(super) const fn new(wish: &'a str, precision: Precision) -> Self {
        Self {
            wish,
            precision,
            device: None,
            remark: None,
        }
    }

    /// The device for a pass that would take the processor so many nanoseconds, and the precision to ask of it; `None` for
    /// the processor itself.
    pub(super) fn for_pass(&mut self, whole: bool, nanoseconds: f64) -> Option<(&'static DeviceInfo, Precision)> {
        let auto = !is_opencl(self.wish);
        if self.wish == "cpu" || !whole || (auto && nanoseconds <= BLINK) {
            return None;
        }
        let device = match self.device {
            Some(device) => device,
            None => {
                let device = self.find();
                self.device = Some(device);
                device
            }
        };
        device.map(|info| (info, self.precision))
    }

    fn find(&mut self) -> Option<&'static DeviceInfo> {
        let doubles = self.precision == Precision::F64;
        if !is_opencl(self.wish) {
            return gpu(discover()).filter(|info| !doubles || info.has_f64);
        }
        match select(self.wish, discover()) {
            Ok(info) => {
                if doubles && !info.has_f64 {
                    self.precision = Precision::F32;
                    self.remark = Some(format!("{} has no f64, so f32 has to do", info.name));
                }
                Some(info)
            }
            Err(error) => {
                self.remark = Some(format!("{}, so the cpu draws", error.message()));
                None
            }
        }
    }

    /// Leaves the rest to the processor.
    pub(super) fn give_up(&mut self, info: &DeviceInfo, why: &str) {
        self.remark = Some(format!("{} failed, so the cpu draws: {why}", info.name));
        self.device = Some(None);
    }
}

#[cfg(test)]
mod tests {
    use scenec_device::Precision;

    use super::Machine;

    /// Whether drivers are asked at all.
    fn check(wish: &str, whole: bool, milliseconds: f64, expect: bool) {
        let mut machine = Machine::new(wish, Precision::F32);
        machine.for_pass(whole, milliseconds * 1e6);
        assert_eq!(machine.device.is_some(), expect, "{wish} {whole} {milliseconds}");
    }

    #[test]
    fn drivers_are_asked_only_for_what_is_worth_it() {
        check("cpu", true, 1e6, false);
        check("auto", false, 1e6, false);
        check("auto", true, 20.0, false);
        check("auto", true, 100.0, true);
        check("opencl", false, 1e6, false);
        check("opencl", true, 1.0, true);
    }

    #[test]
    fn a_device_that_is_not_there_is_told_once_and_for_all() {
        let mut machine = Machine::new("opencl:no such device", Precision::F32);
        assert!(machine.for_pass(true, 1.0).is_none() && machine.for_pass(true, 1.0).is_none());
        assert!(
            machine
                .remark
                .is_some_and(|remark| remark.ends_with("so the cpu draws"))
        );
    }
}
