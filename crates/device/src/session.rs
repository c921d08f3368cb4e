//! One device at work: programs, buffers and runs, each call complete when it returns.
//!
//! This knows bytes and kernels by name, and nothing of what they compute.

use crate::buffer::{Arg, Buffer};
use crate::cache::Cache;
use crate::calls::{self, Plain};
use crate::discover::discover;
use crate::error::{DeviceError, MEMORY_HELP, guarded};
use crate::info::{DeviceInfo, DeviceKind};
use crate::program::{self, Program};
use ocl::core::{self, CommandQueue, CommandQueueProperties, Context, DeviceId, Event, Kernel};
use ocl::core::{KernelInfo, KernelInfoResult, KernelWorkGroupInfo, KernelWorkGroupInfoResult, ProfilingInfo};
use std::time::Instant;

/// The sides of a work-group. Always the same: a size left to the driver, or one that follows the picture, makes
/// PoCL compile anew for each width.
const GROUP: [usize; 2] = [16, 16];
/// The same on a processor, whose threads take groups one by one: small ones are shared out evenly.
const GROUP_OF_PROCESSOR: [usize; 2] = [4, 4];

/// An open device, with a queue that takes one command after another.
#[derive(Debug)]
pub struct Session {
    info: DeviceInfo,
    /// The sides of its work-groups.
    sides: [usize; 2],
    device: DeviceId,
    queue: CommandQueue,
    context: Context,
    cache: Cache,
}

/// A kernel that was told to run.
#[must_use]
pub(crate) struct Running<'a> {
    session: &'a Session,
    program: &'a Program,
    begin: Instant,
    event: Event,
}

impl Running<'_> {
    /// Waits for its end. Returns the time that it took on the device in nanoseconds.
    ///
    /// # Errors
    ///
    /// The driver fails.
    pub(crate) fn wait(self) -> Result<u64, DeviceError> {
        guarded(|| {
            calls::wait(&self.event)?;
            self.program.keep(&self.session.cache);
            // A driver without timings still has a clock beside it.
            let elapsed = || self.begin.elapsed().as_nanos().try_into().unwrap_or(u64::MAX);
            Ok(nanoseconds(&self.event).unwrap_or_else(elapsed))
        })
    }
}

impl Session {
    /// Opens a device of [`discover`].
    ///
    /// # Errors
    ///
    /// The device is not of this machine, or its driver refuses.
    pub fn open(info: &DeviceInfo) -> Result<Self, DeviceError> {
        guarded(|| {
            let device = discover().handle(info)?;
            let context = core::create_context(None, &[device], None, None)
                .map_err(|error| DeviceError::of_call(&format!("open {}", info.name), &error))?;
            let queue = core::create_command_queue(&context, device, Some(CommandQueueProperties::PROFILING_ENABLE))
                .map_err(|error| DeviceError::of_call(&format!("open a queue of {}", info.name), &error))?;
            let sides = match info.kind {
                DeviceKind::Cpu => GROUP_OF_PROCESSOR,
                _ => GROUP,
            };
            Ok(Self {
                info: info.clone(),
                sides,
                device,
                queue,
                context,
                cache: programs(),
            })
        })
    }

    /// The same with work-groups of so many items each way, or as many as the device can do.
    pub(crate) fn in_groups(self, side: usize) -> Self {
        Self {
            sides: [side.max(1); 2],
            ..self
        }
    }

    /// The device this session is of.
    pub fn device(&self) -> &DeviceInfo {
        &self.info
    }

    /// Compiles kernels, or takes them from the cache, where they are found by `source` and `options` together: values
    /// that change from scene to scene belong in neither.
    ///
    /// # Errors
    ///
    /// The source doesn't compile, or an option is unknown; [`DeviceError::log`] is what the compiler said.
    pub fn build(&self, source: &str, options: &str) -> Result<Program, DeviceError> {
        guarded(|| program::build(&self.context, self.device, &self.info, (source, options), &self.cache))
    }

    /// Copies elements to the device, for kernels to read. Of an empty slice, one element of zeros is copied:
    /// there are no empty buffers in OpenCL.
    ///
    /// # Errors
    ///
    /// The elements are more than the device can hold in one buffer.
    pub fn upload<T: Plain>(&self, items: &[T]) -> Result<Buffer<T>, DeviceError> {
        let bytes = calls::bytes(items);
        self.check_size(bytes.len())?;
        let memory = guarded(|| match bytes {
            [] => calls::create_filled(&self.context, &vec![0; size_of::<T>().max(1)]),
            bytes => calls::create_filled(&self.context, bytes),
        })?;
        Ok(Buffer::new(memory, items.len()))
    }

    /// Makes a buffer of `len` zeroed elements, for kernels to read and write. There is always room for one.
    ///
    /// # Errors
    ///
    /// The elements are more than the device can hold in one buffer.
    pub fn zeros<T: Plain>(&self, len: usize) -> Result<Buffer<T>, DeviceError> {
        let bytes = len.max(1).saturating_mul(size_of::<T>().max(1));
        self.check_size(bytes)?;
        let memory = guarded(|| calls::create_zeroed(&self.context, &self.queue, bytes))?;
        Ok(Buffer::new(memory, len))
    }

    /// Copies elements back, from element `start` on, as many as `into` has.
    ///
    /// # Errors
    ///
    /// The buffer has fewer, or the driver fails.
    pub fn read<T: Plain>(&self, buffer: &Buffer<T>, start: usize, into: &mut [T]) -> Result<(), DeviceError> {
        if into.is_empty() {
            return Ok(());
        }
        if start.checked_add(into.len()).is_none_or(|end| end > buffer.len()) {
            let (wanted, len) = (into.len(), buffer.len());
            return Err(DeviceError::new(format!(
                "a buffer of {len} elements has no {wanted} from {start} on"
            )));
        }
        guarded(|| {
            calls::read(
                &self.queue,
                &buffer.memory,
                start * size_of::<T>(),
                calls::bytes_mut(into),
            )
        })
    }

    /// Runs a kernel over at least `size` work-items across and down, and waits for it. Returns the time it took
    /// on the device in nanoseconds.
    ///
    /// Work-groups are 16 by 16, or 4 by 4 on a processor (smaller only where the device can't), so there are up to 15
    /// work-items too many each way, which the kernel must leave idle.
    ///
    /// # Errors
    ///
    /// There is no such kernel, its arguments are others, or the driver fails.
    pub fn run(&self, program: &Program, name: &str, args: &[Arg<'_>], size: [u32; 2]) -> Result<u64, DeviceError> {
        if size.contains(&0) {
            return Ok(0);
        }
        self.start(program, name, args, size)?.wait()
    }

    /// The same without waiting. What is read before is from before, and what is read after is from after.
    ///
    /// # Errors
    ///
    /// Those of [`Self::run`], or `size` is nothing.
    pub(crate) fn start<'a>(
        &'a self,
        program: &'a Program,
        name: &str,
        args: &[Arg<'_>],
        size: [u32; 2],
    ) -> Result<Running<'a>, DeviceError> {
        guarded(|| {
            let task = format!("prepare the kernel {name}");
            let fault = |error: core::Error| DeviceError::of_call(&task, &error);
            let kernel = core::create_kernel(&program.object, name).map_err(fault)?;
            if let Ok(KernelInfoResult::NumArgs(expected)) = core::get_kernel_info(&kernel, KernelInfo::NumArgs)
                && expected as usize != args.len()
            {
                let given = args.len();
                return Err(DeviceError::new(format!(
                    "the kernel {name} takes {expected} arguments, not {given}"
                )));
            }
            for (index, arg) in (0u32..).zip(args) {
                arg.set(&kernel, index).map_err(fault)?;
            }
            let local = group(self.sides, self.group_limit(&kernel));
            let global = [
                round_up(size[0] as usize, local[0]),
                round_up(size[1] as usize, local[1]),
            ];
            Ok(Running {
                session: self,
                program,
                begin: Instant::now(),
                event: calls::launch(&self.queue, &kernel, global, local)?,
            })
        })
    }

    fn check_size(&self, bytes: usize) -> Result<(), DeviceError> {
        let most = self.info.max_allocation;
        if most == 0 || bytes as u64 <= most {
            return Ok(());
        }
        let name = &self.info.name;
        Err(DeviceError::new(format!(
            "{name} holds at most {most} bytes in one buffer, and {bytes} are needed"
        ))
        .with_help(MEMORY_HELP))
    }

    /// The most work-items that one group of this kernel may have on this device.
    fn group_limit(&self, kernel: &Kernel) -> usize {
        match core::get_kernel_work_group_info(kernel, self.device, KernelWorkGroupInfo::WorkGroupSize) {
            Ok(KernelWorkGroupInfoResult::WorkGroupSize(most)) => most.min(self.info.max_work_group),
            _ => self.info.max_work_group,
        }
    }
}

/// The compiled programs of this user.
pub(crate) fn programs() -> Cache {
    Cache::of_user("programs")
}

/// The device time between the start and the end of a command.
fn nanoseconds(event: &Event) -> Option<u64> {
    let at = |what| core::get_event_profiling_info(event, what).ok()?.time().ok();
    at(ProfilingInfo::End)?.checked_sub(at(ProfilingInfo::Start)?)
}

/// The largest part of a group with no more than `most` work-items. The rows go first: devices that put neighbouring
/// work-items into one vector take them from a row.
fn group([mut across, mut down]: [usize; 2], most: usize) -> [usize; 2] {
    while across * down > most.max(1) {
        if down > 1 { down /= 2 } else { across /= 2 }
    }
    [across, down]
}

fn round_up(size: usize, step: usize) -> usize {
    size.div_ceil(step).saturating_mul(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(most: usize, expect: [usize; 2]) {
        assert_eq!(group(GROUP, most), expect, "{most}");
    }

    #[test]
    fn groups_shrink_to_what_a_device_can_do() {
        check(4096, [16, 16]);
        check(256, [16, 16]);
        check(255, [16, 8]);
        check(16, [16, 1]);
        check(15, [8, 1]);
        check(1, [1, 1]);
        check(0, [1, 1]);
    }

    #[test]
    fn sizes_are_rounded_up_to_whole_groups() {
        for (size, expect) in [(1, 16), (16, 16), (17, 32), (65535, 65536)] {
            assert_eq!(round_up(size, 16), expect);
        }
    }
}
