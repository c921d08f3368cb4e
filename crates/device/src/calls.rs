//! The calls of the bindings that are unsafe, each behind a check that makes it safe.
//!
//! All unsafe code of this crate is here. Every command takes an event and has ended when its function returns, so that no memory
//! of ours is in use by a device afterwards; a kernel, which uses none of it, may run on. Some drivers leak what is run without an
//! event.

#![allow(unsafe_code)]

use crate::error::DeviceError;
use ocl::core::{self, CommandQueue, Context, Event, Kernel, Mem, MemFlags};
use scenec_plan::packed_structs;
use std::slice;

/// What may be copied to a device and back as it lies in memory.
///
/// # Safety
///
/// The type is `repr(C)` or a number, has no padding, and every pattern of bits is a value of it.
pub unsafe trait Plain: Copy {}

macro_rules! plain_numbers {
    ($($number:ty)*) => {
        // SAFETY: a number has no padding, and all its bits are values.
        $(unsafe impl Plain for $number {})*
    };
}

plain_numbers! { u8 u16 u32 u64 i8 i16 i32 i64 f32 f64 }

// SAFETY: an array lays its elements side by side.
unsafe impl<T: Plain, const N: usize> Plain for [T; N] {}

macro_rules! plain_structs {
    ($($name:ident $(<$real:ident>)?,)*) => {
        // SAFETY: the plan declares them `repr(C)`, refuses padding when it compiles, and all their fields are numbers.
        $(unsafe impl $(<$real: Plain>)? Plain for packed_structs::$name $(<$real>)? {})*
    };
}

plain_structs! { Shape<R>, Leaf, Island, Cell, Node, WideNode, Block<R>, Material<R>, Light<R>, Touch<R>, Outcome<R>, Sampled<R>, Frame<R>, }

// SAFETY: one word without a niche.
unsafe impl Plain for scenec_plan::Child {}

/// Elements as bytes.
pub(crate) fn bytes<T: Plain>(items: &[T]) -> &[u8] {
    // SAFETY: the same memory for the same time; without padding, every byte of it is set.
    unsafe { slice::from_raw_parts(items.as_ptr().cast(), size_of_val(items)) }
}

/// Elements as bytes that may be written.
pub(crate) fn bytes_mut<T: Plain>(items: &mut [T]) -> &mut [u8] {
    // SAFETY: the same memory for the same time; whatever is written is a value of the type.
    unsafe { slice::from_raw_parts_mut(items.as_mut_ptr().cast(), size_of_val(items)) }
}

/// A new buffer that holds a copy of `bytes`, which kernels only read.
pub(crate) fn create_filled(context: &Context, bytes: &[u8]) -> Result<Mem, DeviceError> {
    let flags = MemFlags::READ_ONLY | MemFlags::COPY_HOST_PTR;
    // SAFETY: the flags go together, and the bytes are copied before the call returns.
    unsafe { core::create_buffer(context, flags, bytes.len(), Some(bytes)) }
        .map_err(|error| DeviceError::of_call("create a buffer", &error))
}

/// A new buffer of `len` zero bytes, which kernels read and write.
pub(crate) fn create_zeroed(context: &Context, queue: &CommandQueue, len: usize) -> Result<Mem, DeviceError> {
    // SAFETY: no host memory takes part.
    let buffer = unsafe { core::create_buffer::<_, u8>(context, MemFlags::READ_WRITE, len, None) }
        .map_err(|error| DeviceError::of_call("create a buffer", &error))?;
    let mut event = Event::null();
    core::enqueue_fill_buffer(queue, &buffer, 0u8, 0, len, None::<Event>, Some(&mut event), None)
        .and_then(|()| core::wait_for_event(&event))
        .map_err(|error| DeviceError::of_call("clear a buffer", &error))?;
    Ok(buffer)
}

/// Copies from `start` (in bytes) of a buffer; the driver refuses a range that reaches past its end.
pub(crate) fn read(queue: &CommandQueue, buffer: &Mem, start: usize, into: &mut [u8]) -> Result<(), DeviceError> {
    let mut event = Event::null();
    // SAFETY: a blocking read has ended when it returns, so `into` outlives it.
    unsafe { core::enqueue_read_buffer(queue, buffer, true, start, into, None::<Event>, Some(&mut event)) }
        .and_then(|()| core::wait_for_event(&event))
        .map_err(|error| DeviceError::of_call("read a buffer", &error))
}

/// Has a kernel run whose arguments are all set, and returns its event.
pub(crate) fn launch(
    queue: &CommandQueue,
    kernel: &Kernel,
    global: [usize; 2],
    local: [usize; 2],
) -> Result<Event, DeviceError> {
    let wide = |[x, y]: [usize; 2]| [x, y, 1];
    let mut event = Event::null();
    // SAFETY: the sizes are plain numbers that the driver checks. What the kernel does is as trusted as the rest
    // of this program's code, which it is a part of.
    unsafe {
        let (global, local) = (wide(global), Some(wide(local)));
        core::enqueue_kernel(queue, kernel, 2, None, &global, local, None::<Event>, Some(&mut event))
    }
    // Some drivers begin only when they are told to, or waited for.
    .and_then(|()| core::flush(queue))
    .map_err(|error| DeviceError::of_call("run a kernel", &error))?;
    Ok(event)
}

/// Waits for a kernel.
pub(crate) fn wait(event: &Event) -> Result<(), DeviceError> {
    core::wait_for_event(event).map_err(|error| DeviceError::of_call("run a kernel", &error))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<T: Plain + PartialEq + std::fmt::Debug>(items: &[T], size: usize) {
        let seen = bytes(items).to_vec();
        assert_eq!(seen.len(), size);
        let mut again = items.to_vec();
        bytes_mut(&mut again).fill(0xa5);
        bytes_mut(&mut again).copy_from_slice(&seen);
        assert_eq!(again, items);
    }

    #[test]
    fn elements_survive_as_bytes() {
        check::<f64>(&[], 0);
        check(&[1.5f32, -0.0, f32::MAX], 12);
        check(&[[1u32, 2], [3, 4]], 16);
        check(&[u64::MAX], 8);
    }
}
