//! Information about unknowns in square-root form: a lower triangular matrix R and a vector z, to which one row at a
//! time is added by Givens rotations.
//!
//! R δ = z is the least-squares problem of all rows. No row is kept. The last unknowns, the biases, are eliminated first:
//! a row has one of them at most, and leaves the rows of the others as they are.

use core::ops::Range;
use toytop::scalar::Real;

/// Largest number of unknowns that are not biases.
pub(crate) const MOST_COMMON: usize = 10;
/// Largest number of unknowns: a launch, four directions of the top's ratios, and the biases of four sensors.
pub const MOST_UNKNOWNS: usize = 22;
/// Entries of a triangle with its right-hand side.
const ENTRIES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 3) / 2;

/// A number for each unknown.
pub(crate) type Unknowns<F = f64> = [F; MOST_UNKNOWNS];

/// Unknowns that are 0 except one.
pub(crate) fn single<F: Real>(index: usize, value: F) -> Unknowns<F> {
    core::array::from_fn(|other| if other == index { value } else { F::ZERO })
}

/// Triangle R with its right-hand side z, stored by rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle<F> {
    count: usize,
    entries: [F; ENTRIES],
}

/// Places of a row: the entries up to the diagonal, and the right-hand side.
fn entries_of_row(row: usize) -> Range<usize> {
    let start = row * (row + 3) / 2;
    start..start + row + 2
}

impl<F: Real> Triangle<F> {
    /// Triangle without information, for `count` unknowns.
    pub(crate) fn new(count: usize) -> Self {
        Self { count: count.min(MOST_UNKNOWNS), entries: [F::ZERO; ENTRIES] }
    }

    /// Removes all information.
    pub(crate) fn clear(&mut self) {
        self.entries.fill(F::ZERO);
    }

    /// Adds a row: the equation `row` · δ = `value`, of unit variance.
    pub(crate) fn add(&mut self, mut row: Unknowns<F>, mut value: F) {
        for index in (0..self.count).rev() {
            let (Some([line @ .., pivot, side]), Some([others @ .., x])) =
                (self.entries.get_mut(entries_of_row(index)), row.get_mut(..=index))
            else {
                return;
            };
            if *x == F::ZERO {
                continue;
            }
            let length = (pivot.squared() + x.squared()).sqrt();
            let (cosine, sine) = (*pivot / length, *x / length);
            *pivot = length;
            for (a, b) in line.iter_mut().zip(others) {
                (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
            }
            (*side, value) = (cosine * *side + sine * value, cosine * value - sine * *side);
        }
    }

    /// Adds the information that one unknown is 0, with this standard deviation > 0.
    pub(crate) fn add_known(&mut self, index: usize, deviation: F) {
        self.add(single(index, F::ONE / deviation), F::ZERO);
    }

    /// Row of the matrix, and its right-hand side.
    fn row(&self, index: usize) -> (&[F], F) {
        match self.entries.get(entries_of_row(index)) {
            Some([row @ .., side]) => (row, *side),
            _ => (&[], F::ZERO),
        }
    }

    /// Solution of R x = y; entries without information are 0.
    pub(crate) fn solved(&self, mut y: Unknowns<F>) -> Unknowns<F> {
        for index in 0..self.count {
            let (row, _) = self.row(index);
            let known = inner(row.iter().take(index), &y);
            if let (Some(slot), Some(pivot)) = (y.get_mut(index), row.last()) {
                *slot = if *pivot == F::ZERO { F::ZERO } else { (*slot - known) / *pivot };
            }
        }
        y
    }

    /// Least-squares solution δ.
    pub(crate) fn solution(&self) -> Unknowns<F> {
        self.solved(core::array::from_fn(|index| self.row(index).1))
    }

    /// Column of R⁻¹; 0 where there is no information.
    pub(crate) fn inverse_column(&self, index: usize) -> Unknowns<F> {
        self.solved(single(index, F::ONE))
    }

    /// Matrix R⁻¹ in another scalar, with the right-hand side 0.
    pub(crate) fn inverse<G: Real>(&self) -> Triangle<G> {
        let mut inverse = Triangle::new(self.count);
        for index in 0..self.count {
            for (row, value) in self.inverse_column(index).iter().enumerate().take(self.count).skip(index) {
                let slot = inverse.entries.get_mut(entries_of_row(row).start + index);
                slot.into_iter().for_each(|slot| *slot = G::from_f64(value.to_f64()));
            }
        }
        inverse
    }

    /// Product R x of a change x: its components in standard deviations.
    fn product(&self, change: &Unknowns<F>) -> Unknowns<F> {
        core::array::from_fn(|index| inner(self.row(index).0.iter(), change))
    }

    /// Sets the right-hand side to that of a solution.
    pub(crate) fn point_to(&mut self, point: &Unknowns<F>) {
        for (index, value) in self.product(point).into_iter().enumerate().take(self.count) {
            let side = self.entries.get_mut(entries_of_row(index)).and_then(<[F]>::last_mut);
            side.into_iter().for_each(|side| *side = value);
        }
    }

    /// Square |R x|² of the size of a change, in standard deviations.
    pub(crate) fn square(&self, change: &Unknowns<F>) -> F {
        self.product(change).into_iter().fold(F::ZERO, |sum, x| sum + x.squared())
    }
}

/// Inner product with as many numbers as there are on the left.
fn inner<'a, F: Real + 'a>(row: impl Iterator<Item = &'a F>, with: &[F]) -> F {
    row.zip(with).fold(F::ZERO, |sum, (r, x)| sum + *r * *x)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: [([f64; 3], f64); 5] = [
        ([1.0, 2.0, -1.0], 1.5),
        ([0.5, -1.0, 0.25], -0.5),
        ([3.0, 0.0, 1.0], 2.0),
        ([-1.0, 1.0, 1.0], 0.75),
        ([0.0, 2.0, 5.0], 1.0),
    ];

    fn triangle() -> Triangle<f64> {
        let mut triangle = Triangle::new(3);
        for (row, value) in ROWS {
            let mut wide = [0.0; MOST_UNKNOWNS];
            wide[..3].copy_from_slice(&row);
            triangle.add(wide, value);
        }
        triangle
    }

    #[test]
    fn the_solution_is_that_of_the_normal_equations() {
        let solution = triangle().solution();
        for k in 0..3 {
            let gradient: f64 = ROWS
                .iter()
                .map(|(row, value)| {
                    row[k] * (row[0] * solution[0] + row[1] * solution[1] + row[2] * solution[2] - value)
                })
                .sum();
            assert!(gradient.abs() < 1e-14, "{gradient}");
        }
    }
}
