//! Lower triangular matrix of the unknowns, packed by rows.

use core::ops::Range;
use toytop::scalar::Real;

/// Largest number of unknowns: a launch, four directions of the top's ratios, and the biases of four sensors.
pub const MAX_UNKNOWNS: usize = 22;

/// A number for each unknown.
pub(crate) type Unknowns<F = f64> = [F; MAX_UNKNOWNS];

/// Unknowns that are 0 except one.
pub(crate) fn unit_row<F: Real>(index: usize, value: F) -> Unknowns<F> {
    core::array::from_fn(|other| if other == index { value } else { F::ZERO })
}

/// Rows up to the diagonal, one after another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Triangle<F> {
    entries: [F; MAX_UNKNOWNS * (MAX_UNKNOWNS + 1) / 2],
}

/// Places of a row.
fn places(row: usize) -> Range<usize> {
    let start = row * (row + 1) / 2;
    start..start + row + 1
}

impl<F: Real> Triangle<F> {
    pub(crate) const ZERO: Self = Self { entries: [F::ZERO; _] };

    /// Row up to the diagonal.
    pub(crate) fn row(&self, index: usize) -> &[F] {
        self.entries.get(places(index)).unwrap_or(&[])
    }

    /// Row up to the diagonal.
    pub(crate) fn row_mut(&mut self, index: usize) -> &mut [F] {
        self.entries.get_mut(places(index)).unwrap_or(&mut [])
    }

    /// Entry of a row and a column of the symmetric matrix that has these rows; `None` where there is no such unknown.
    pub(crate) fn symmetric_mut(&mut self, i: usize, j: usize) -> Option<&mut F> {
        self.row_mut(i.max(j)).get_mut(i.min(j))
    }

    /// Product R x.
    pub(crate) fn product(&self, x: &Unknowns<F>) -> Unknowns<F> {
        core::array::from_fn(|index| inner(self.row(index), x))
    }

    /// Solution of R x = y. It is 0 where the diagonal is 0.
    pub(crate) fn solved(&self, mut y: Unknowns<F>) -> Unknowns<F> {
        for index in 0..MAX_UNKNOWNS {
            let solved_and_rest = y.split_at_mut_checked(index);
            if let ([row @ .., pivot], Some((known, [slot, ..]))) = (self.row(index), solved_and_rest) {
                *slot = if *pivot == F::ZERO { F::ZERO } else { (*slot - inner(row, known)) / *pivot };
            }
        }
        y
    }

    /// Column of the inverse; 0 where the diagonal is 0.
    pub(crate) fn inverse_column(&self, index: usize) -> Unknowns<F> {
        self.solved(unit_row(index, F::ONE))
    }

    /// Inverse in another scalar.
    pub(crate) fn inverse<G: Real>(&self) -> Triangle<G> {
        let mut inverse = Triangle::ZERO;
        for index in 0..MAX_UNKNOWNS {
            for (row, value) in self.inverse_column(index).iter().enumerate().skip(index) {
                if let Some(slot) = inverse.symmetric_mut(row, index) {
                    *slot = G::from_f64(value.to_f64());
                }
            }
        }
        inverse
    }
}

/// Inner product with as many numbers as there are on the left.
fn inner<F: Real>(row: &[F], with: &[F]) -> F {
    row.iter().zip(with).fold(F::ZERO, |sum, (r, x)| sum + *r * *x)
}
