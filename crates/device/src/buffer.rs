//! What a kernel is given: memory of the device, and plain numbers.

use ocl::core::{self, ArgVal, Kernel, Mem};
use std::marker::PhantomData;

/// Elements of one type in the memory of a device.
#[derive(Debug)]
pub struct Buffer<T> {
    pub(crate) memory: Mem,
    len: usize,
    element: PhantomData<T>,
}

/// One argument of a kernel: made with `into()` from a reference to a [`Buffer`], a `u32` or a `u64`.
#[derive(Clone, Copy, Debug)]
pub struct Arg<'a>(Value<'a>);

#[derive(Clone, Copy, Debug)]
enum Value<'a> {
    Memory(&'a Mem),
    Narrow(u32),
    Wide(u64),
}

impl<T> Buffer<T> {
    /// A buffer of `len` elements over memory that holds them.
    pub(crate) fn new(memory: Mem, len: usize) -> Self {
        Self {
            memory,
            len,
            element: PhantomData,
        }
    }

    /// The number of elements.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }
}

impl Arg<'_> {
    /// Makes this the argument of that index.
    pub(crate) fn set(&self, kernel: &Kernel, index: u32) -> core::Result<()> {
        let value = match &self.0 {
            Value::Memory(memory) => ArgVal::mem(memory),
            Value::Narrow(value) => ArgVal::scalar(value),
            Value::Wide(value) => ArgVal::scalar(value),
        };
        core::set_kernel_arg(kernel, index, value)
    }
}

impl<'a, T> From<&'a Buffer<T>> for Arg<'a> {
    fn from(buffer: &'a Buffer<T>) -> Self {
        Self(Value::Memory(&buffer.memory))
    }
}

impl From<u32> for Arg<'_> {
    fn from(value: u32) -> Self {
        Self(Value::Narrow(value))
    }
}

impl From<u64> for Arg<'_> {
    fn from(value: u64) -> Self {
        Self(Value::Wide(value))
    }
}
