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
        let (block, others) = (self.block.get_mut(..self.filled), self.others.get_mut(..self.common));
        let (Some(block), Some(others)) = (block, others) else { return };
        if self.common < NARROW {
            reflect_biases::<F, NARROW>(&mut self.by_bias, block);
            reflect_others::<F, NARROW>(others, block);
        } else {
            reflect_biases::<F, WIDTH>(&mut self.by_bias, block);
            reflect_others::<F, WIDTH>(others, block);
        }
        self.filled = 0;
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

/// Reflects the rows of each bias, which have W entries with the right-hand side.
fn reflect_biases<F: Real, const W: usize>(pivots: &mut [Row<F>], block: &mut [Row<F>]) {
    let bit = |index: usize| 1_u32.wrapping_shl(index as u32);
    let present = block.iter().filter_map(|row| row.bias).fold(0, |found, index| found | bit(index));
    for (index, pivot) in pivots.iter_mut().enumerate().filter(|(index, _)| present & bit(*index) != 0) {
        let own = |row: &&mut Row<F>| row.bias == Some(index);
        let mut square = F::ZERO;
        let mut sums = [F::ZERO; W];
        for row in block.iter_mut().filter(own) {
            square = square + row.by_bias.squared();
            add(&mut sums, &row.entries, row.by_bias);
        }
        let Some((next, lead, scale)) = reflection(pivot.by_bias, square) else { continue };
        add(&mut sums, &pivot.entries, lead);
        let sums = sums.map(|x| -(scale * x));
        pivot.by_bias = next;
        add(&mut pivot.entries, &sums, lead);
        for row in block.iter_mut().filter(own) {
            add(&mut row.entries, &sums, row.by_bias);
        }
    }
}

/// Reflects the columns of the launch and the ratios one after another, in rows with W entries.
fn reflect_others<F: Real, const W: usize>(pivots: &mut [Entries<F>], block: &mut [Row<F>]) {
    // each number is a constant in its own copy, so that the entries before the column take no time
    reflect_column::<F, 0, W>(pivots, block);
    reflect_column::<F, 1, W>(pivots, block);
    reflect_column::<F, 2, W>(pivots, block);
    reflect_column::<F, 3, W>(pivots, block);
    reflect_column::<F, 4, W>(pivots, block);
    reflect_column::<F, 5, W>(pivots, block);
    if W > LAUNCH + 1 {
        reflect_column::<F, 6, W>(pivots, block);
        reflect_column::<F, 7, W>(pivots, block);
        reflect_column::<F, 8, W>(pivots, block);
        reflect_column::<F, 9, W>(pivots, block);
    }
}

/// Reflects one column. Its entries in the block become 0; they are not used any more, and stay as they are.
#[inline(always)]
fn reflect_column<F: Real, const COLUMN: usize, const W: usize>(
    pivots: &mut [Entries<F>],
    block: &mut [Row<F>],
) {
    let Some(pivot) = pivots.get_mut(COLUMN) else { return };
    let mut sums = [F::ZERO; WIDTH];
    for row in block.iter() {
        let by = at::<F, COLUMN>(&row.entries);
        add_from::<F, COLUMN, W>(&mut sums, &row.entries, by);
    }
    let Some((next, lead, scale)) = reflection(at::<F, COLUMN>(pivot), at::<F, COLUMN>(&sums)) else {
        return;
    };
    add_from::<F, COLUMN, W>(&mut sums, pivot, lead);
    let sums = sums.map(|x| -(scale * x));
    add_from::<F, COLUMN, W>(pivot, &sums, lead);
    if let Some(slot) = pivot.get_mut(COLUMN) {
        *slot = next;
    }
    for row in block.iter_mut() {
        let by = at::<F, COLUMN>(&row.entries);
        add_from::<F, COLUMN, W>(&mut row.entries, &sums, by);
    }
}

/// Entry of a row.
#[inline(always)]
fn at<F: Real, const COLUMN: usize>(entries: &Entries<F>) -> F {
    entries.get(COLUMN).copied().unwrap_or(F::ZERO)
}

/// Adds f times some numbers to others, as far as both go.
fn add<F: Real, const A: usize, const B: usize>(to: &mut [F; A], from: &[F; B], f: F) {
    for (slot, x) in to.iter_mut().zip(from) {
        *slot = *slot + f * *x;
    }
}

/// Adds f times the entries from a column up to W to others.
#[inline(always)] // the bounds are constants, so that no loop is left
fn add_from<F: Real, const COLUMN: usize, const W: usize>(to: &mut Entries<F>, from: &Entries<F>, f: F) {
    for index in COLUMN..W {
        if let (Some(slot), Some(x)) = (to.get_mut(index), from.get(index)) {
            *slot = *slot + f * *x;
        }
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
