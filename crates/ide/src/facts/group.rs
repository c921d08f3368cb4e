//! Numbers in groups, in two flat lists.

/// For each group its numbers, in the order in which they were given.
#[derive(Clone, Debug)]
pub(crate) struct Groups {
    /// Group `i` is `items[starts[i]..starts[i + 1]]`.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Groups {
    /// Sorts pairs of a group and a number, by counting.
    pub(crate) fn new(groups: usize, pairs: impl Iterator<Item = (usize, u32)> + Clone) -> Self {
        let mut starts = vec![0_u32; groups + 1];
        for (group, _) in pairs.clone() {
            if let Some(count) = starts.get_mut(group + 1) {
                *count += 1;
            }
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut next = starts.clone();
        let mut items = vec![0; total as usize];
        for (group, number) in pairs {
            if let Some(next) = next.get_mut(group)
                && let Some(item) = items.get_mut(*next as usize)
            {
                *item = number;
                *next += 1;
            }
        }
        Self { starts, items }
    }

    /// The numbers of a group.
    pub(crate) fn of(&self, group: usize) -> &[u32] {
        let bound = |index: usize| self.starts.get(index).map_or(0, |start| *start as usize);
        self.items.get(bound(group)..bound(group + 1)).unwrap_or_default()
    }
}
