//! A tree written down operands first, and what is left of it within a box.

use crate::side::{Side, side};
use crate::terms::{Join, Term, Terms};
use crate::{Box3, Leaf, Shape};

/// A part of a tree in postfix order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Token {
    /// A leaf or its complement.
    Leaf { leaf: u32, negative: bool },
    /// Joins so many operands before it.
    Join { join: Join, count: u32 },
}

/// Writes a term out.
pub(crate) fn write_out(terms: &Terms, top: Term, out: &mut Vec<Token>) {
    enum Task {
        Visit(Term),
        Emit(Token),
    }
    let mut open = vec![Task::Visit(top)];
    while let Some(task) = open.pop() {
        match task {
            Task::Emit(token) => out.push(token),
            Task::Visit(Term::Leaf { leaf, negative }) => out.push(Token::Leaf { leaf, negative }),
            Task::Visit(term) => {
                // There are no constants inside a term.
                if let Some((join, operands)) = terms.node(term) {
                    let count = operands.len() as u32;
                    open.push(Task::Emit(Token::Join { join, count }));
                    open.extend(operands.iter().rev().map(|term| Task::Visit(*term)));
                }
            }
        }
    }
}

/// What is left of a tree within a box.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Rest {
    /// The same everywhere in the box.
    Constant(bool),
    /// A tree.
    Tree(Vec<Token>),
}

/// Room for pruning trees over the same leaves again and again.
pub(crate) struct Pruner<'a> {
    shapes: &'a [Shape],
    leaves: &'a [Leaf],
    /// Of each leaf, when its side was found last, and the side.
    sides: Vec<(u32, Side)>,
    round: u32,
    /// Of each operand that waits for its join: where it begins, or what it comes to.
    waiting: Vec<Operand>,
}

#[derive(Clone, Copy)]
enum Operand {
    Constant(bool),
    From(usize),
}

impl<'a> Pruner<'a> {
    pub(crate) fn new(shapes: &'a [Shape], leaves: &'a [Leaf]) -> Self {
        Self {
            shapes,
            leaves,
            sides: vec![(0, Side::Across); leaves.len()],
            round: 0,
            waiting: Vec::new(),
        }
    }

    fn side(&mut self, leaf: u32, bounds: &Box3, slack: f64) -> Side {
        let (round, known) = self.sides[leaf as usize];
        if round == self.round {
            return known;
        }
        let shape = &self.shapes[self.leaves[leaf as usize].shape as usize];
        let found = side(shape, bounds, slack);
        self.sides[leaf as usize] = (self.round, found);
        found
    }

    /// What is left of a tree within a box whose points count as up to `slack` beside where they are. All truths of the
    /// tree at points of the box are those of the rest, and its leaves are in the same order.
    pub(crate) fn prune(&mut self, tokens: &[Token], bounds: &Box3, slack: f64) -> Rest {
        self.round += 1;
        self.waiting.clear();
        let mut out = Vec::new();
        for token in tokens {
            match *token {
                Token::Leaf { leaf, negative } => match self.side(leaf, bounds, slack) {
                    Side::Across => {
                        self.waiting.push(Operand::From(out.len()));
                        out.push(*token);
                    }
                    side => self.waiting.push(Operand::Constant((side == Side::Inside) != negative)),
                },
                Token::Join { join, count } => {
                    let first = self.waiting.len() - count as usize;
                    let joined = joined(join, &self.waiting[first..], &mut out);
                    self.waiting.truncate(first);
                    self.waiting.push(joined);
                }
            }
        }
        match self.waiting.pop() {
            Some(Operand::Constant(value)) => Rest::Constant(value),
            _ => Rest::Tree(out),
        }
    }

    /// How many distinct leaves a tree has; calls `each` for each of them.
    pub(crate) fn distinct(&mut self, tokens: &[Token], mut each: impl FnMut(u32)) -> usize {
        self.round += 1;
        let mut count = 0;
        for token in tokens {
            if let Token::Leaf { leaf, .. } = *token
                && self.sides[leaf as usize].0 != self.round
            {
                self.sides[leaf as usize] = (self.round, Side::Across);
                each(leaf);
                count += 1;
            }
        }
        count
    }
}

/// The join of operands that stand at the end of `out`.
fn joined(join: Join, operands: &[Operand], out: &mut Vec<Token>) -> Operand {
    let decisive = join == Join::Union;
    let start = operands.iter().find_map(|operand| match operand {
        Operand::From(start) => Some(*start),
        Operand::Constant(_) => None,
    });
    let decided = operands
        .iter()
        .any(|operand| matches!(operand, Operand::Constant(value) if *value == decisive));
    match start {
        _ if decided => {
            out.truncate(start.unwrap_or(out.len()));
            Operand::Constant(decisive)
        }
        None => Operand::Constant(!decisive),
        Some(start) => {
            let left = operands.iter().filter(|operand| matches!(operand, Operand::From(_)));
            let count = left.count() as u32;
            if count > 1 {
                out.push(Token::Join { join, count });
            }
            Operand::From(start)
        }
    }
}
