//! Islands, parts and cells as a tracer reads them: parts stand behind the islands, and cells name them there.

use crate::Plan;
use crate::cells::CELL_PART;
use crate::packed::packed_structs::{Cell, Island};

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
