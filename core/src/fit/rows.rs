//! Rows of the least-squares problem on their way into a triangle, by reflections of Householder.
//!
//! A row has one bias at most. So the triangle of the measurements is an arrowhead matrix: the biases come first, and
//! the row of each has no entry for another one. Rows are collected and reflected many at a time, which needs a square
//! root for an unknown and not for each row.

use crate::fit::launch::LAUNCH;
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle};
use crate::fit::{MOST_RATIOS, MOST_SENSORS};
use crate::scalar::Real;

/// Most unknowns that are no biases, with the right-hand side.
const WIDTH: usize = LAUNCH + MOST_RATIOS + 1;
/// Rows that are collected.
const BLOCK: usize = 12;

/// Row of the derivatives by the launch and the ratios, with the right-hand side behind them.
type Entries<F> = [F; WIDTH];

/// Rows that were added and are not yet in a [`Triangle`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows<F> {
    /// Number of the unknowns that are no biases.
    common: usize,
    block: [Row<F>; BLOCK],
    filled: usize,
    by_bias: [Row<F>; 3 * MOST_SENSORS],
    others: [Entries<F>; WIDTH - 1],
}

/// Derivative by one bias, and the others.
#[derive(Clone, Copy, Debug)]
struct Row<F> {
    /// Bias, counted from 0, and the derivative by it.
    bias: Option<usize>,
    by_bias: F,
    /// Derivatives by the launch and the ratios.
    entries: Entries<F>,
}

impl<F: Real> Row<F> {
    const ZERO: Self = Self { bias: None, by_bias: F::ZERO, entries: [F::ZERO; WIDTH] };
}

impl<F: Real> Rows<F> {
    /// No rows, for so many unknowns that are no biases.
    pub(super) fn new(common: usize) -> Self {
        Self {
            common: common.min(WIDTH - 1),
            block: [Row::ZERO; BLOCK],
            filled: 0,
            by_bias: [Row::ZERO; 3 * MOST_SENSORS],
            others: [[F::ZERO; WIDTH]; WIDTH - 1],
        }
    }

    /// Takes all rows away.
    pub(super) fn clear(&mut self) {
        self.filled = 0;
        self.by_bias = [Row::ZERO; 3 * MOST_SENSORS];
        self.others = [[F::ZERO; WIDTH]; WIDTH - 1];
    }

    /// Place for the derivatives of the next row.
    ///
    /// * `bias`: bias of the row, counted from 0
    /// * `by_bias`: derivative by it
    /// * `value`: right-hand side
    pub(super) fn next(&mut self, bias: Option<usize>, by_bias: F, value: F) -> Option<&mut [F]> {
        if self.filled == BLOCK {
            self.reflect();
        }
        let row = self.block.get_mut(self.filled)?;
        self.filled += 1;
        (row.bias, row.by_bias) = (bias, by_bias);
        let (entries, rest) = row.entries.split_at_mut_checked(self.common)?;
        *rest.first_mut()? = value;
        Some(entries)
    }

    /// Brings the collected rows into the shape of an arrow.
    fn reflect(&mut self) {
        const NARROW: usize = LAUNCH + 1;
        if self.common < NARROW {
            self.reflect_width::<NARROW>()
        } else {
            self.reflect_width::<WIDTH>()
        }
        self.filled = 0;
    }

    /// Reflection of rows with this number of entries, the right-hand side included.
    fn reflect_width<const W: usize>(&mut self) {
        let Some(block) = self.block.get_mut(..self.filled) else { return };
        for (index, pivot) in self.by_bias.iter_mut().enumerate() {
            let own = |row: &&mut Row<F>| row.bias == Some(index);
            let square = block.iter_mut().filter(own).fold(F::ZERO, |sum, row| sum + row.by_bias.squared());
            let Some((next, lead, scale)) = reflection(pivot.by_bias, square) else { continue };
            let mut sums = [F::ZERO; W];
            add(&mut sums, &pivot.entries, lead);
            for row in block.iter_mut().filter(own) {
                add(&mut sums, &row.entries, row.by_bias);
            }
            let sums = sums.map(|x| -(scale * x));
            pivot.by_bias = next;
            add(&mut pivot.entries, &sums, lead);
            for row in block.iter_mut().filter(own) {
                add(&mut row.entries, &sums, row.by_bias);
            }
        }
        for (index, pivot) in self.others.iter_mut().enumerate().take(self.common) {
            let entry = |entries: &Entries<F>| entries.get(index).copied().unwrap_or(F::ZERO);
            let square = block.iter().fold(F::ZERO, |sum, row| sum + entry(&row.entries).squared());
            let Some((next, lead, scale)) = reflection(entry(pivot), square) else { continue };
            let mut sums = [F::ZERO; W];
            add(&mut sums, pivot, lead);
            for row in block.iter() {
                add(&mut sums, &row.entries, entry(&row.entries));
            }
            let sums = sums.map(|x| -(scale * x));
            add(pivot, &sums, lead);
            if let Some(slot) = pivot.get_mut(index) {
                *slot = next;
            }
            for row in block.iter_mut() {
                let by = entry(&row.entries);
                add(&mut row.entries, &sums, by);
            }
        }
    }

    /// Adds all rows to a triangle, whose unknowns are the launch, the ratios and the biases.
    pub(super) fn add_to(&mut self, triangle: &mut Triangle<F>) {
        self.reflect();
        let others =
            self.others.iter().map(|entries| Row { bias: None, by_bias: F::ZERO, entries: *entries });
        for Row { bias, by_bias, entries } in self
            .by_bias
            .iter()
            .enumerate()
            .map(|(index, row)| Row { bias: Some(index), ..*row })
            .chain(others)
        {
            let mut unknowns = [F::ZERO; MOST_UNKNOWNS];
            for (slot, entry) in unknowns.iter_mut().zip(entries).take(self.common) {
                *slot = entry;
            }
            if let Some(slot) = bias.and_then(|index| unknowns.get_mut(self.common + index)) {
                *slot = by_bias;
            }
            let value = entries.get(self.common).copied().unwrap_or(F::ZERO);
            triangle.add(&unknowns, value);
        }
    }
}

/// Adds f times some numbers to others, as far as both go.
fn add<F: Real, const A: usize, const B: usize>(to: &mut [F; A], from: &[F; B], f: F) {
    for (slot, x) in to.iter_mut().zip(from) {
        *slot = *slot + f * *x;
    }
}

/// Reflection 1 - f v vᵀ that takes a column to its first entry: that entry, v₁ and f; the rest of v is that of the
/// column. `None` where the rest of the column, of this square, is 0.
fn reflection<F: Real>(first: F, rest: F) -> Option<(F, F, F)> {
    if rest == F::ZERO {
        return None;
    }
    let length = (first.squared() + rest).sqrt();
    let next = if first > F::ZERO { -length } else { length };
    let lead = first - next;
    Some((next, lead, F::ONE / (length * (length + first.abs()))))
}
