//! Rows of the least-squares problem before they are added to a triangle, reduced by Householder reflections.
//!
//! A row has one bias at most. Therefore the triangle of the measurements is an arrowhead matrix: the biases come
//! first, and the row of each has no entry for another one. Rows are collected and reflected in blocks, which needs
//! one square root for each unknown instead of one for each row.

use crate::fit::launch::LAUNCH;
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle};
use crate::fit::{MOST_RATIOS, MOST_SENSORS};
use crate::scalar::Real;

/// Largest number of unknowns that are not biases, plus one for the right-hand side.
const WIDTH: usize = LAUNCH + MOST_RATIOS + 1;
/// Largest number of biases.
const BIASES: usize = 3 * MOST_SENSORS;
/// Number of rows that are collected.
const BLOCK: usize = 16;

/// Derivatives with respect to the launch and the ratios, followed by the right-hand side.
type Entries<F> = [F; WIDTH];

/// Rows that were added and are not yet in a [`Triangle`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows<F> {
    /// Number of the unknowns that are not biases.
    common: usize,
    block: [(Option<u8>, Row<F>); BLOCK],
    filled: usize,
    by_bias: [Row<F>; BIASES],
    others: [Entries<F>; WIDTH - 1],
}

/// Derivative with respect to one bias, and the other entries.
#[derive(Clone, Copy, Debug)]
struct Row<F> {
    by_bias: F,
    entries: Entries<F>,
}

impl<F: Real> Row<F> {
    const ZERO: Self = Self { by_bias: F::ZERO, entries: [F::ZERO; WIDTH] };
}

impl<F: Real> Rows<F> {
    /// Empty set of rows, for `common` unknowns that are not biases.
    pub(super) fn new(common: usize) -> Self {
        Self {
            common: common.min(WIDTH - 1),
            block: [(None, Row::ZERO); BLOCK],
            filled: 0,
            by_bias: [Row::ZERO; BIASES],
            others: [[F::ZERO; WIDTH]; WIDTH - 1],
        }
    }

    /// Removes all rows.
    pub(super) fn clear(&mut self) {
        self.filled = 0;
        self.by_bias = [Row::ZERO; BIASES];
        self.others = [[F::ZERO; WIDTH]; WIDTH - 1];
    }

    /// Place for the derivatives of the next row.
    ///
    /// * `bias`: bias of the row, counted from 0
    /// * `by_bias`: derivative with respect to the bias
    /// * `value`: right-hand side
    pub(super) fn next(&mut self, bias: Option<usize>, by_bias: F, value: F) -> Option<&mut [F]> {
        if self.filled == BLOCK {
            self.reflect();
        }
        let (slot, row) = self.block.get_mut(self.filled)?;
        self.filled += 1;
        (*slot, row.by_bias) = (bias.map(|index| index as u8), by_bias);
        let (entries, rest) = row.entries.split_at_mut_checked(self.common)?;
        *rest.first_mut()? = value;
        Some(entries)
    }

    /// Reduces the collected rows to the arrowhead form.
    #[inline(never)] // once for many rows
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
        let others = self.others.iter().map(|entries| (None, F::ZERO, entries));
        let biases = self.by_bias.iter().enumerate();
        let biases = biases.map(|(index, Row { by_bias, entries })| (Some(index), *by_bias, entries));
        for (bias, by_bias, entries) in biases.chain(others) {
            let mut unknowns = [F::ZERO; MOST_UNKNOWNS];
            for (slot, entry) in unknowns.iter_mut().zip(entries).take(self.common) {
                *slot = *entry;
            }
            if let Some(slot) = bias.and_then(|index| unknowns.get_mut(self.common + index)) {
                *slot = by_bias;
            }
            let value = entries.get(self.common).copied().unwrap_or(F::ZERO);
            triangle.add(&unknowns, value);
        }
    }
}

/// Reflects the rows of each bias, which have W entries with the right-hand side. The rows of all biases are summed in one
/// pass, and changed in a second one.
fn reflect_biases<F: Real, const W: usize>(
    pivots: &mut [Row<F>; BIASES],
    block: &mut [(Option<u8>, Row<F>)],
) {
    let mut sums = [(F::ZERO, [F::ZERO; W]); BIASES];
    for (bias, Row { by_bias, entries }) in block.iter() {
        if let Some((square, sums)) = bias.and_then(|index| sums.get_mut(usize::from(index))) {
            *square = *square + by_bias.squared();
            add(sums, entries, *by_bias);
        }
    }
    for (pivot, (square, sums)) in pivots.iter_mut().zip(&mut sums) {
        // the sums are 0 where there is no row
        let Some((next, lead, scale)) = reflection(pivot.by_bias, *square) else { continue };
        add(sums, &pivot.entries, lead);
        *sums = sums.map(|x| -(scale * x));
        pivot.by_bias = next;
        add(&mut pivot.entries, sums, lead);
    }
    for (bias, Row { by_bias, entries }) in block.iter_mut() {
        if let Some((_, sums)) = bias.and_then(|index| sums.get(usize::from(index))) {
            add(entries, sums, *by_bias);
        }
    }
}

/// Reflects the columns of the launch and the ratios one after another, in rows with W entries.
fn reflect_others<F: Real, const W: usize>(pivots: &mut [Entries<F>], block: &mut [(Option<u8>, Row<F>)]) {
    let mut sums = [F::ZERO; WIDTH];
    for (_, Row { entries, .. }) in block.iter() {
        add_from::<F, 0, W>(&mut sums, entries, at::<F, 0>(entries));
    }
    // the column is a constant in each copy, so that the entries before it take no time
    reflect_column::<F, 0, 1, W>(pivots, block, &mut sums);
    reflect_column::<F, 1, 2, W>(pivots, block, &mut sums);
    reflect_column::<F, 2, 3, W>(pivots, block, &mut sums);
    reflect_column::<F, 3, 4, W>(pivots, block, &mut sums);
    reflect_column::<F, 4, 5, W>(pivots, block, &mut sums);
    reflect_column::<F, 5, 6, W>(pivots, block, &mut sums);
    if W > LAUNCH + 1 {
        reflect_column::<F, 6, 7, W>(pivots, block, &mut sums);
        reflect_column::<F, 7, 8, W>(pivots, block, &mut sums);
        reflect_column::<F, 8, 9, W>(pivots, block, &mut sums);
        reflect_column::<F, 9, 10, W>(pivots, block, &mut sums);
    }
}

/// Reflects one column. Its entries in the block would become 0; they are not used any more and are left unchanged.
///
/// * `NEXT`: the next column
/// * `sums`: on entry, sums of the rows of the block times their entries in this column; on return, times those in the
///   next column, summed while the rows are changed
#[inline(always)]
fn reflect_column<F: Real, const COLUMN: usize, const NEXT: usize, const W: usize>(
    pivots: &mut [Entries<F>],
    block: &mut [(Option<u8>, Row<F>)],
    sums: &mut Entries<F>,
) {
    let Some(pivot) = pivots.get_mut(COLUMN) else { return };
    let mut change = [F::ZERO; WIDTH];
    // a column of zeros changes nothing
    if let Some((next, lead, scale)) = reflection(at::<F, COLUMN>(pivot), at::<F, COLUMN>(sums)) {
        add_from::<F, COLUMN, W>(sums, pivot, lead);
        change = sums.map(|x| -(scale * x));
        add_from::<F, COLUMN, W>(pivot, &change, lead);
        if let Some(slot) = pivot.get_mut(COLUMN) {
            *slot = next;
        }
    }
    *sums = [F::ZERO; WIDTH];
    for (_, Row { entries, .. }) in block.iter_mut() {
        let by = at::<F, COLUMN>(entries);
        add_from::<F, NEXT, W>(entries, &change, by);
        add_from::<F, NEXT, W>(sums, entries, at::<F, NEXT>(entries));
    }
}

/// Entry of a row.
#[inline(always)]
fn at<F: Real, const COLUMN: usize>(entries: &Entries<F>) -> F {
    entries.get(COLUMN).copied().unwrap_or(F::ZERO)
}

/// Adds f times the numbers `from` to the numbers `to`, up to the shorter length.
fn add<F: Real, const A: usize, const B: usize>(to: &mut [F; A], from: &[F; B], f: F) {
    for (slot, x) in to.iter_mut().zip(from) {
        *slot = *slot + f * *x;
    }
}

/// Adds f times the entries of `from`, from a column up to W, to those of `to`.
#[inline(always)] // the bounds are constants, so that no loop is left
fn add_from<F: Real, const COLUMN: usize, const W: usize>(to: &mut Entries<F>, from: &Entries<F>, f: F) {
    for index in COLUMN..W {
        if let (Some(slot), Some(x)) = (to.get_mut(index), from.get(index)) {
            *slot = *slot + f * *x;
        }
    }
}

/// Reflection 1 - f v vᵀ that reduces a column to its first entry. Returns that entry, v₁ and f; the rest of v is the
/// rest of the column, whose sum of squares is `rest`. `None` where that is 0.
fn reflection<F: Real>(first: F, rest: F) -> Option<(F, F, F)> {
    if rest == F::ZERO {
        return None;
    }
    let length = (first.squared() + rest).sqrt();
    let next = if first > F::ZERO { -length } else { length };
    let lead = first - next;
    Some((next, lead, F::ONE / (length * (length + first.abs()))))
}
