//! Islands, parts and cells as a tracer reads them: parts stand behind the islands, and cells name them there.

use crate::cells::CELL_PART;
use crate::packed::packed_structs::{Cell, Island};
use crate::{Packed, Plan};

impl Plan {
    pub(crate) fn packed_islands(&self) -> Vec<Island> {
        let island = |program: (u32, u32), members: (u32, u32), product: bool, cells: Option<u32>| Island {
            program: program.0,
            program_end: program.1,
            members: members.0,
            members_end: members.1,
            product: product.into(),
            cells: cells.unwrap_or(u32::MAX),
        };
        let islands = self
            .islands
            .iter()
            .map(|it| island(it.program, it.members, it.product, it.cells));
        let parts = self
            .parts
            .iter()
            .map(|it| island(it.program, it.members, it.product, None));
        islands.chain(parts).collect()
    }

    pub(crate) fn packed_cells(&self) -> Vec<Cell> {
        let islands = self.islands.len() as u32;
        let numbered = |cell: &Cell| Cell {
            first: if cell.kind == CELL_PART {
                islands + cell.first
            } else {
                cell.first
            },
            ..*cell
        };
        self.cells.iter().map(numbered).collect()
    }
}

impl<R> Packed<R> {
    /// The leaf of an island that is nothing else, as most islands are.
    #[inline(always)]
    #[must_use]
    pub fn lone(&self, island: &Island) -> Option<u32> {
        // A complement stands under an operation of its own.
        let alone = island.program_end - island.program == 1 && self.program[island.program as usize] == 0;
        alone.then(|| self.members[island.members as usize])
    }
}
