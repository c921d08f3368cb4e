//! Trees as parts: a program over members, or a product that needs none.

use hashbrown::HashMap;

use crate::Part;
use crate::postfix::Token;
use crate::program::Instruction;
use crate::terms::Join;

/// Parts laid one after another.
#[derive(Default)]
pub(crate) struct Parts {
    pub(crate) program: Vec<Instruction>,
    pub(crate) members: Vec<u32>,
}

impl Parts {
    /// A part of one leaf.
    pub(crate) fn leaf(&mut self, leaf: u32, negative: bool) -> Part {
        let start = (self.program.len() as u32, self.members.len() as u32);
        self.program.push(literal(0, negative));
        self.members.push(leaf);
        self.since(start, true)
    }

    /// A part of a whole tree. Its members rise from left to right.
    pub(crate) fn tree(&mut self, tokens: &[Token]) -> Part {
        if let [Token::Leaf { leaf, negative }] = *tokens {
            return self.leaf(leaf, negative);
        }
        let start = (self.program.len() as u32, self.members.len() as u32);
        let locals = self.members(tokens);
        let local = |leaf: u32| locals.get(&leaf).copied().unwrap_or_default();
        let intersection = |token: &Token| !matches!(token, Token::Join { join: Join::Union, .. });
        let product = tokens.iter().all(intersection);
        if product {
            let literals = tokens.iter().filter_map(|token| match *token {
                Token::Leaf { leaf, negative } => Some(literal(local(leaf), negative)),
                Token::Join { .. } => None,
            });
            self.program.extend(literals);
        } else {
            Binary::of(tokens, local).emit(&mut self.program);
        }
        self.since(start, product)
    }

    fn since(&self, (program, members): (u32, u32), product: bool) -> Part {
        Part {
            program: (program, self.program.len() as u32),
            members: (members, self.members.len() as u32),
            product,
        }
    }

    /// Adds the distinct leaves of a tree; returns their numbers within the part.
    fn members(&mut self, tokens: &[Token]) -> HashMap<u32, u32> {
        let mut locals = HashMap::new();
        for token in tokens {
            if let Token::Leaf { leaf, .. } = *token {
                let next = locals.len() as u32;
                locals.entry(leaf).or_insert_with(|| {
                    self.members.push(leaf);
                    next
                });
            }
        }
        locals
    }
}

fn literal(local: u32, negative: bool) -> Instruction {
    if negative {
        Instruction::complement(local)
    } else {
        Instruction::member(local)
    }
}

/// A tree of two operands a node: of several operands, the first ones are joined first.
struct Binary {
    nodes: Vec<BinaryNode>,
}

#[derive(Clone, Copy)]
enum BinaryNode {
    Leaf(Instruction),
    Both {
        operation: Instruction,
        left: u32,
        right: u32,
        /// How many intermediate truths its evaluation must hold at once (Sethi and Ullman 1970): at most 1 + log2 of its
        /// leaves.
        height: u32,
    },
}

impl Binary {
    fn of(tokens: &[Token], local: impl Fn(u32) -> u32) -> Self {
        let mut tree = Self {
            nodes: Vec::with_capacity(2 * tokens.len()),
        };
        let mut waiting: Vec<u32> = Vec::new();
        for token in tokens {
            let made = match *token {
                Token::Leaf { leaf, negative } => tree.add(BinaryNode::Leaf(literal(local(leaf), negative))),
                Token::Join { join, count } => {
                    let operands = waiting.split_off(waiting.len() - count as usize);
                    let operation = match join {
                        Join::Union => Instruction::UNION,
                        Join::Intersection => Instruction::INTERSECTION,
                    };
                    let joined = operands
                        .into_iter()
                        .reduce(|left, right| tree.both(operation, left, right));
                    joined.unwrap_or_default()
                }
            };
            waiting.push(made);
        }
        tree
    }

    fn add(&mut self, node: BinaryNode) -> u32 {
        self.nodes.push(node);
        self.nodes.len() as u32 - 1
    }

    fn height(&self, node: u32) -> u32 {
        match self.nodes[node as usize] {
            BinaryNode::Leaf(_) => 1,
            BinaryNode::Both { height, .. } => height,
        }
    }

    fn both(&mut self, operation: Instruction, left: u32, right: u32) -> u32 {
        let (a, b) = (self.height(left), self.height(right));
        let height = if a == b { a + 1 } else { a.max(b) };
        self.add(BinaryNode::Both {
            operation,
            left,
            right,
            height,
        })
    }

    /// Emits the program of the last node, the operand that needs more bits first.
    fn emit(&self, out: &mut Vec<Instruction>) {
        enum Task {
            Visit(u32),
            Emit(Instruction),
        }
        let mut open = vec![Task::Visit(self.nodes.len() as u32 - 1)];
        while let Some(task) = open.pop() {
            let node = match task {
                Task::Emit(instruction) => {
                    out.push(instruction);
                    continue;
                }
                Task::Visit(node) => self.nodes[node as usize],
            };
            match node {
                BinaryNode::Leaf(instruction) => out.push(instruction),
                BinaryNode::Both {
                    operation, left, right, ..
                } => {
                    let swapped = self.height(right) > self.height(left);
                    let (first, second) = if swapped { (right, left) } else { (left, right) };
                    open.push(Task::Emit(if swapped { operation.swapped() } else { operation }));
                    open.push(Task::Visit(second));
                    open.push(Task::Visit(first));
                }
            }
        }
    }
}
