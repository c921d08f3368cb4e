//! Trees as postfix programs over truths, evaluated on a stack of bits in one word.

/// Where an instruction keeps its operation; the bits below are its operand.
pub const OPERATION_SHIFT: u32 = 29;

/// The bit of an operation that says that its right operand was evaluated first, so that the left one is on top.
const SWAPPED: u32 = 4;

/// The operation that pushes a complement.
pub(crate) const COMPLEMENT: u32 = 3;

/// The most truths that wait while a program runs; see [`evaluate`].
pub const PROGRAM_DEPTH: usize = 26;

/// One step of a program: push whether the point lies in a member, or combine the two topmost truths.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(transparent)]
pub struct Instruction(pub u32);

impl Instruction {
    /// below or top.
    pub const UNION: Self = Self(1 << OPERATION_SHIFT);
    /// below and top.
    pub const INTERSECTION: Self = Self(2 << OPERATION_SHIFT);
    /// The same operation where its right operand was evaluated first: top and below change places.
    #[must_use]
    pub const fn swapped(self) -> Self {
        Self(self.0 | SWAPPED << OPERATION_SHIFT)
    }

    /// Push whether the point lies in the member with this number, counted within the island.
    #[must_use]
    pub const fn member(local: u32) -> Self {
        Self(local)
    }

    /// Push whether the point does not lie in the member with this number.
    #[must_use]
    pub const fn complement(local: u32) -> Self {
        Self(local | COMPLEMENT << OPERATION_SHIFT)
    }

    /// Its operation, and the number of the member that it pushes if it pushes one.
    #[inline(always)]
    #[must_use]
    pub const fn parts(self) -> (u32, u32) {
        (self.0 >> OPERATION_SHIFT, self.0 & ((1 << OPERATION_SHIFT) - 1))
    }
}

/// Runs a program. The heavier operand comes first in it, so a tree of n leaves needs at most 1 + log2 n bits, and a
/// program has at most [`crate::MAX_PROGRAM`] leaves: 25 bits of the 32.
#[inline(always)]
pub fn evaluate(program: impl IntoIterator<Item = Instruction>, mut holds: impl FnMut(u32) -> bool) -> bool {
    let mut bits = 0_u32;
    for instruction in program {
        match instruction.parts() {
            (0, member) => bits = bits << 1 | u32::from(holds(member)),
            (COMPLEMENT, member) => bits = bits << 1 | u32::from(!holds(member)),
            (operation, _) => bits = joined(operation, bits),
        }
    }
    bits & 1 == 1
}

/// Whether all members and complements of a product hold.
#[inline(always)]
pub fn evaluate_product(literals: impl IntoIterator<Item = Instruction>, mut holds: impl FnMut(u32) -> bool) -> bool {
    literals.into_iter().all(|literal| {
        let (operation, member) = literal.parts();
        holds(member) == (operation == 0)
    })
}

/// A stack of truths after an operation on the two topmost.
#[inline(always)]
const fn joined(operation: u32, bits: u32) -> u32 {
    let (top, below) = (bits & 1, bits >> 1 & 1);
    let truth = if operation & 1 == 1 { below | top } else { below & top };
    bits >> 2 << 1 | truth
}

/// The member to which a change of the whole belongs, where members change from what they were `before` to what they are
/// after: of two operands that change, the left one's. `changes` gives both truths of a member. The number is of no
/// meaning if the whole does not change.
#[inline(always)]
pub fn owner(program: impl IntoIterator<Item = Instruction>, mut changes: impl FnMut(u32) -> (bool, bool)) -> u32 {
    let (mut before, mut after) = (0_u32, 0_u32);
    let mut owners = [0_u32; PROGRAM_DEPTH];
    let mut depth = 0;
    for instruction in program {
        match instruction.parts() {
            (push @ (0 | COMPLEMENT), member) => {
                let (was, is) = changes(member);
                before = before << 1 | u32::from(was != (push == COMPLEMENT));
                after = after << 1 | u32::from(is != (push == COMPLEMENT));
                owners[depth] = member;
                depth += 1;
            }
            (operation, _) => {
                let changed = before ^ after;
                let top_is_left = operation & SWAPPED != 0;
                let takes_top = if top_is_left {
                    changed & 1 == 1
                } else {
                    changed & 2 == 0
                };
                depth -= 1;
                if takes_top {
                    owners[depth - 1] = owners[depth];
                }
                before = joined(operation, before);
                after = joined(operation, after);
            }
        }
    }
    owners[0]
}

#[cfg(test)]
mod tests {
    use super::{Instruction, evaluate, owner};

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
        let not_b = Instruction::complement(1);
        for (x, y) in [(false, false), (false, true), (true, false), (true, true)] {
            check(&[a, b, Instruction::UNION], &[x, y], x || y);
            check(&[a, b, Instruction::INTERSECTION], &[x, y], x && y);
            check(&[a, not_b, Instruction::INTERSECTION], &[x, y], x && !y);
            check(&[not_b], &[x, y], !y);
            check(&[b, a, Instruction::UNION.swapped()], &[x, y], x || y);
            check(&[b, a, Instruction::INTERSECTION.swapped()], &[x, y], x && y);
            check(&[not_b, a, Instruction::UNION.swapped()], &[x, y], x || !y);
            check(
                &[a, b, Instruction::UNION, not_b, Instruction::INTERSECTION],
                &[x, y],
                x && !y,
            );
        }
    }

    #[test]
    fn of_operands_that_change_together_the_left_one_owns() {
        let [a, b, c] = [0, 1, 2].map(Instruction::member);
        let rises = (false, true);
        let falls = (true, false);
        let stays = (true, true);
        let absent = (false, false);
        let check = |program: &[Instruction], changes: &[(bool, bool)], expect: u32| {
            let found = owner(program.iter().copied(), |local| changes[local as usize]);
            assert_eq!(found, expect, "{program:?} {changes:?}");
        };
        check(&[a, b, Instruction::UNION], &[rises, rises], 0);
        check(&[a, b, Instruction::UNION], &[absent, rises], 1);
        check(&[b, a, Instruction::UNION.swapped()], &[rises, rises], 0);
        check(&[b, a, Instruction::UNION.swapped()], &[absent, rises], 1);
        let not_b = Instruction::complement(1);
        check(&[a, not_b, Instruction::INTERSECTION], &[rises, falls], 0);
        check(&[a, not_b, Instruction::INTERSECTION], &[stays, falls], 1);
        check(&[not_b, a, Instruction::INTERSECTION.swapped()], &[stays, falls], 1);
        // A part that changes without showing does not own what shows beside it.
        let part = [a, b, Instruction::INTERSECTION, c, Instruction::UNION];
        check(&part, &[rises, absent, rises], 2);
        check(&part, &[rises, stays, rises], 0);
    }
}
