//! Square root of the information about the unknowns, or of their covariance.
//!
//! An equation row · x = value for the unknowns x has the square (row · x - value)². The sum of such squares is |R x - z|² and a constant,
//! with a lower triangle R. A Givens rotation adds one row at a time, and no row is kept. The last unknowns, the biases, are eliminated first:
//! a row has one of them at most, and leaves the rows of the others as they are.
//!
//! The information RᵀR has a row for each measurement, in units of its noise. A covariance RᵀR has a row for each independent error of the
//! unknowns, and no values.

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

/// Inner product with as many numbers as there are on the left.
pub(crate) fn inner<F: Real>(row: &[F], with: &[F]) -> F {
    row.iter().zip(with).fold(F::ZERO, |sum, (r, x)| sum + *r * *x)
}

/// Square root R of a symmetric matrix RᵀR, a lower triangle, with a right side z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SquareRoot<F> {
    /// Rows of R up to the diagonal, one after another.
    entries: [F; MAX_UNKNOWNS * (MAX_UNKNOWNS + 1) / 2],
    right_side: Unknowns<F>,
}

/// Places of a row.
fn places(row: usize) -> Range<usize> {
    let start = row * (row + 1) / 2;
    start..start + row + 1
}

impl<F: Real> SquareRoot<F> {
    /// Sum without rows.
    pub(crate) const ZERO: Self = Self { entries: [F::ZERO; _], right_side: [F::ZERO; _] };

    /// Row of R up to the diagonal.
    fn row(&self, index: usize) -> &[F] {
        self.entries.get(places(index)).unwrap_or(&[])
    }

    /// Rows of R, whose squares have the same sum as the rows that were added.
    pub(crate) fn rows(&self) -> impl Iterator<Item = Unknowns<F>> {
        (0..MAX_UNKNOWNS).map(|index| {
            core::array::from_fn(|column| self.row(index).get(column).copied().unwrap_or(F::ZERO))
        })
    }

    /// Columns of R⁻¹: rows of a sum whose matrix is the inverse of RᵀR. A column is 0 for an unknown without information.
    pub(crate) fn inverse_rows(&self) -> impl Iterator<Item = Unknowns<F>> {
        (0..MAX_UNKNOWNS).map(|index| self.solved(unit_row(index, F::ONE)))
    }

    /// Adds the square of `row` · x - `value`.
    pub(crate) fn add(&mut self, mut row: Unknowns<F>, mut value: F) {
        for index in (0..MAX_UNKNOWNS).rev() {
            let Some([others @ .., x]) = row.get_mut(..=index).filter(|row| row.last() != Some(&F::ZERO))
            else {
                continue;
            };
            let (Some([line @ .., pivot]), Some(right_side)) =
                (self.entries.get_mut(places(index)), self.right_side.get_mut(index))
            else {
                return;
            };
            let length = (pivot.squared() + x.squared()).sqrt();
            let cosine = *pivot / length;
            let sine = *x / length;
            *pivot = length;
            for (a, b) in line.iter_mut().zip(others) {
                (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
            }
            (*right_side, value) = (cosine * *right_side + sine * value, cosine * value - sine * *right_side);
        }
    }

    /// Adds the square of one unknown, times the square of a factor.
    pub(crate) fn add_unknown(&mut self, index: usize, factor: F) {
        self.add(unit_row(index, factor), F::ZERO);
    }

    /// Unknowns at which the sum is least; 0 for an unknown without information.
    pub(crate) fn solution(&self) -> Unknowns<F> {
        self.solved(self.right_side)
    }

    /// Sets the right side such that the solution is a given one.
    pub(crate) fn set_solution(&mut self, point: &Unknowns<F>) {
        self.right_side = self.product(point);
    }

    /// Sum |R x|² of the squares of `row` · x.
    pub(crate) fn quadratic_form(&self, x: &Unknowns<F>) -> F {
        self.product(x).into_iter().fold(F::ZERO, |sum, x| sum + x.squared())
    }

    /// Entry of the matrix RᵀR; 0 where there is no such unknown.
    pub(crate) fn entry(&self, i: usize, j: usize) -> F {
        let product = |row: &[F]| Some(*row.get(i)? * *row.get(j)?);
        (0..MAX_UNKNOWNS).filter_map(|index| product(self.row(index))).fold(F::ZERO, |sum, x| sum + x)
    }

    /// Product R x.
    fn product(&self, x: &Unknowns<F>) -> Unknowns<F> {
        core::array::from_fn(|index| inner(self.row(index), x))
    }

    /// Solution of R x = y. It is 0 where the diagonal is 0.
    fn solved(&self, mut y: Unknowns<F>) -> Unknowns<F> {
        for index in 0..MAX_UNKNOWNS {
            let solved_and_rest = y.split_at_mut_checked(index);
            if let ([row @ .., pivot], Some((known, [slot, ..]))) = (self.row(index), solved_and_rest) {
                *slot = if *pivot == F::ZERO { F::ZERO } else { (*slot - inner(row, known)) / *pivot };
            }
        }
        y
    }
}

impl<F: Real> FromIterator<Unknowns<F>> for SquareRoot<F> {
    /// Sum of the squares of rows without values.
    fn from_iter<I: IntoIterator<Item = Unknowns<F>>>(rows: I) -> Self {
        let mut sum = Self::ZERO;
        rows.into_iter().for_each(|row| sum.add(row, F::ZERO));
        sum
    }
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

    fn root() -> SquareRoot<f64> {
        let mut root = SquareRoot::ZERO;
        for ([x, y, z], value) in ROWS {
            root.add(core::array::from_fn(|k| [x, y, z].get(k).copied().unwrap_or(0.0)), value);
        }
        root
    }

    #[test]
    fn the_solution_is_that_of_the_normal_equations() {
        let [x, y, z, ..] = root().solution();
        for k in 0..3 {
            let excess = |([a, b, c], value): ([f64; 3], f64)| a * x + b * y + c * z - value;
            let gradient: f64 = ROWS.map(|one| one.0[k] * excess(one)).iter().sum();
            assert!(gradient.abs() < 1e-14, "{gradient}");
        }
    }

    #[test]
    fn the_inverse_rows_have_the_inverse_matrix() {
        let normal = |i: usize, j: usize| ROWS.iter().map(|(row, _)| row[i] * row[j]).sum::<f64>();
        let inverse: SquareRoot<f64> = root().inverse_rows().collect();
        for i in 0..3 {
            for j in 0..3 {
                assert!((root().entry(i, j) - normal(i, j)).abs() < 1e-13);
                let product: f64 = (0..3).map(|k| inverse.entry(i, k) * normal(k, j)).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-13, "{product}");
            }
        }
    }
}
