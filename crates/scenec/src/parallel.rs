//! Work on many things at once, with the results in the order of the things.

use std::num::NonZero;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// How many things a thread may be ahead of the slowest one.
const AHEAD: usize = 16;

/// Does `work` on every item, on as many threads as the machine has, and hands the results to `each` in the order of
/// the items, until it breaks off. `work` must not panic.
pub(crate) fn in_order<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(&T) -> R + Sync,
    mut each: impl FnMut(&T, R) -> ControlFlow<()>,
) {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    // A part at a time, so that results which wait for an earlier one don't fill the memory.
    for part in items.chunks(threads * AHEAD) {
        let results = all(part, threads.min(part.len()), &work);
        for (item, result) in part.iter().zip(results) {
            if each(item, result).is_break() {
                return;
            }
        }
    }
}

fn all<T: Sync, R: Send>(items: &[T], threads: usize, work: &(impl Fn(&T) -> R + Sync)) -> Vec<R> {
    if threads < 2 {
        return items.iter().map(work).collect();
    }
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(items.len()));
    let busy = || {
        while let Some((index, item)) = {
            let index = next.fetch_add(1, Ordering::Relaxed);
            items.get(index).map(|item| (index, item))
        } {
            let result = work(item);
            done.lock()
                .unwrap_or_else(|poisoned| poisoned.into_inner())
                .push((index, result));
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(busy);
        }
        busy();
    });
    let mut done = done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::time::Duration;

    use super::in_order;

    #[test]
    fn results_come_in_order_until_somebody_has_enough() {
        let items: Vec<u64> = (0..200).collect();
        let mut seen = Vec::new();
        let slow_at_first = |item: &u64| {
            std::thread::sleep(Duration::from_micros(200 - item));
            item * 2
        };
        in_order(&items, slow_at_first, |item, double| {
            assert_eq!(double, item * 2);
            seen.push(*item);
            if *item == 150 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        assert_eq!(seen, items[..=150]);
    }
}
