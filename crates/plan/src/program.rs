//! Trees as postfix programs over truths, evaluated on a stack of bits in one word.

/// Where an instruction keeps its operation; the bits below are its operand.
pub const OPERATION_SHIFT: u32 = 29;

/// One step of a program: push whether the point lies in a member, or combine the two topmost truths.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(transparent)]
pub struct Instruction(pub u32);

impl Instruction {
    /// below or top.
    pub const UNION: Self = Self(1 << OPERATION_SHIFT);
    /// below and top.
    pub const INTERSECTION: Self = Self(2 << OPERATION_SHIFT);
    /// below and not top.
    pub const SUBTRACTION: Self = Self(3 << OPERATION_SHIFT);
    /// top and not below: a subtraction whose right operand was evaluated first.
    pub const SUBTRACTION_SWAPPED: Self = Self(4 << OPERATION_SHIFT);

    /// Push whether the point lies in the member with this number, counted within the island.
    #[must_use]
    pub const fn member(local: u32) -> Self {
        Self(local)
    }

    /// The number of the member that it pushes, if it pushes one.
    #[must_use]
    pub const fn as_member(self) -> Option<u32> {
        if self.0 >> OPERATION_SHIFT == 0 {
            Some(self.0)
        } else {
            None
        }
    }
}

/// Runs a program. The heavier operand comes first in it, so a tree of n leaves needs at most 1 + log2 n bits, and a
/// program has at most [`crate::MAX_PROGRAM`] leaves: 25 bits of the 32.
#[inline(always)]
pub fn evaluate(program: impl IntoIterator<Item = Instruction>, mut holds: impl FnMut(u32) -> bool) -> bool {
    let mut bits = 0_u32;
    for instruction in program {
        match instruction.0 >> OPERATION_SHIFT {
            0 => bits = bits << 1 | u32::from(holds(instruction.0)),
            operation => {
                let (top, below) = (bits & 1, bits >> 1 & 1);
                let truth = match operation {
                    1 => below | top,
                    2 => below & top,
                    3 => below & !top,
                    _ => top & !below,
                };
                bits = bits >> 2 << 1 | truth & 1;
            }
        }
    }
    bits & 1 == 1
}

#[cfg(test)]
mod tests {
    use super::{Instruction, evaluate};

    fn check(program: &[Instruction], members: &[bool], expect: bool) {
        assert_eq!(
            evaluate(program.iter().copied(), |local| members[local as usize]),
            expect,
            "{program:?} {members:?}"
        );
    }

    #[test]
    fn every_operation_has_its_truth_table() {
        let [a, b] = [Instruction::member(0), Instruction::member(1)];
        for (x, y) in [(false, false), (false, true), (true, false), (true, true)] {
            check(&[a, b, Instruction::UNION], &[x, y], x || y);
            check(&[a, b, Instruction::INTERSECTION], &[x, y], x && y);
            check(&[a, b, Instruction::SUBTRACTION], &[x, y], x && !y);
            check(&[b, a, Instruction::SUBTRACTION_SWAPPED], &[x, y], x && !y);
            check(
                &[a, b, Instruction::UNION, a, Instruction::SUBTRACTION],
                &[x, y],
                !x && y,
            );
        }
    }
}
