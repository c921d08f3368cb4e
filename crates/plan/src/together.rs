//! Work on long lists, on several threads.

use rayon::prelude::*;

/// From so many entries on, starting threads costs less than they save.
const MANY: usize = 1 << 13;

/// Does both, at once if there are many entries to go through.
pub(crate) fn together<A: Send, B: Send>(
    entries: usize,
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    if entries < MANY {
        (one(), other())
    } else {
        rayon::join(one, other)
    }
}

/// What comes of each entry of a list, in their order; on several threads if that is `much` work.
pub(crate) fn each<T: Sync, U: Send>(entries: &[T], much: bool, work: impl Fn(&T) -> U + Sync + Send) -> Vec<U> {
    if much {
        entries.par_iter().map(work).collect()
    } else {
        entries.iter().map(work).collect()
    }
}

/// What is found in the entries of a list, in their order.
pub(crate) fn found<T: Sync, F: Send>(entries: &[T], find: impl Fn(&T) -> Option<F> + Sync + Send) -> Vec<F> {
    if entries.len() < MANY {
        entries.iter().filter_map(find).collect()
    } else {
        entries.par_iter().filter_map(find).collect()
    }
}
