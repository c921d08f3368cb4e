//! The system's allocator, for a program that reads large files into long lists.
//!
//! A page of memory that is touched for the first time has to be found, cleared and entered by the system, and with pages of
//! four kilobytes that is a good third of the time that it takes to interpret a large file. So the system is told of every large
//! block that it may use huge pages for it, as many systems do only when told. It may or may not; nothing else changes.
//!
//! This is a place with unsafe code, all of it in one file, for an allocator can't be without.

#![allow(unsafe_code, reason = "an allocator hands out memory by its address")]

use std::alloc::{GlobalAlloc, Layout, System};

/// What a huge page holds on the processors with pages of four kilobytes, in bytes.
const HUGE_PAGE: usize = 2 << 20;

/// From so many bytes on, a block surely spans a whole huge page, wherever it begins.
const LARGE: usize = 2 * HUGE_PAGE;

/// Freed memory of up to so many bytes is kept for the next list.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
const KEPT: i32 = 64 << 20;

/// Blocks of fewer bytes are taken from what is kept: as many as half of what the allocator of a thread asks the system for at
/// once, which is the most that it takes.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
const FROM_KEPT: i32 = 32 << 20;

/// Has the allocator keep what is freed, up to some tens of megabytes: whoever reads a file again and again would otherwise give
/// the same pages back and ask for them each time. And threads that come and go share what is kept: with a store for each there is
/// always one that has nothing yet. To be called as the first thing of a program.
pub fn keep_freed() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    {
        let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get());
        let stores = i32::try_from(cores).unwrap_or(i32::MAX);
        // SAFETY: sets three numbers of the allocator, which it guards itself.
        unsafe {
            libc::mallopt(libc::M_TRIM_THRESHOLD, KEPT);
            libc::mallopt(libc::M_MMAP_THRESHOLD, FROM_KEPT);
            libc::mallopt(libc::M_ARENA_MAX, stores);
        }
    }
}

/// The system's allocator, with huge pages for large blocks where the system has them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Memory;

// SAFETY: every block comes from the system's allocator and goes back to it, as it is; what is done in between to a large one
// neither reads nor writes it.
unsafe impl GlobalAlloc for Memory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are those that the system's allocator asks for.
        large(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        large(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above; the block is one of the system's allocator.
        large(unsafe { System.realloc(block, layout, size) }, size)
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) }
    }
}

/// The block, of so many bytes, about which the system has been told if it is large.
#[inline]
fn large(block: *mut u8, size: usize) -> *mut u8 {
    if size >= LARGE && !block.is_null() {
        ask_for_huge_pages(block, size);
    }
    block
}

#[cfg(target_os = "linux")]
#[cold]
fn ask_for_huge_pages(block: *mut u8, size: usize) {
    // Pages at the ends may hold other blocks too: what lies between is whole.
    let ahead = block.addr().next_multiple_of(HUGE_PAGE) - block.addr();
    let inside = (size - ahead) / HUGE_PAGE * HUGE_PAGE;
    // SAFETY: the range lies in the block, and this advice leaves what memory holds as it is. Where it is refused, pages
    // stay small.
    unsafe { libc::madvise(block.wrapping_add(ahead).cast(), inside, libc::MADV_HUGEPAGE) };
}

#[cfg(not(target_os = "linux"))]
const fn ask_for_huge_pages(_: *mut u8, _: usize) {}
