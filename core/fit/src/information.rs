//! Information about the unknowns in square-root form: a lower triangle R and a vector z, to which one row at a
//! time is added by Givens rotations.
//!
//! R δ = z is the least-squares problem of all rows. No row is kept. The last unknowns, the biases, are eliminated first:
//! a row has one of them at most, and leaves the rows of the others as they are.

use crate::triangle::{Triangle, Unknowns, unit_row};
use toytop::scalar::Real;

/// Triangle R with its right side z, for the first `count` unknowns.
#[derive(Clone, Copy)]
pub(crate) struct Information<F> {
    pub(crate) count: usize,
    pub(crate) triangle: Triangle<F>,
    right_side: Unknowns<F>,
}

impl<F: Real> Information<F> {
    /// No information.
    pub(crate) fn new(count: usize) -> Self {
        Self::with_triangle(count, Triangle::ZERO)
    }

    /// Information that all unknowns are 0, with the covariance (RᵀR)⁻¹.
    pub(crate) fn with_triangle(count: usize, triangle: Triangle<F>) -> Self {
        Self { count, triangle, right_side: [F::ZERO; _] }
    }

    /// Adds a row: the equation `row` · δ = `value`, of unit variance.
    pub(crate) fn add(&mut self, mut row: Unknowns<F>, mut value: F) {
        for index in (0..self.count).rev() {
            let ([line @ .., pivot], Some(right_side), Some([others @ .., x])) =
                (self.triangle.row_mut(index), self.right_side.get_mut(index), row.get_mut(..=index))
            else {
                return;
            };
            if *x == F::ZERO {
                continue;
            }
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

    /// Adds the information that one unknown is 0, with this standard deviation > 0.
    pub(crate) fn add_prior(&mut self, index: usize, deviation: F) {
        self.add(unit_row(index, F::ONE / deviation), F::ZERO);
    }

    /// Least-squares solution δ; 0 where there is no information.
    pub(crate) fn solution(&self) -> Unknowns<F> {
        self.triangle.solved(self.right_side)
    }

    /// Sets the right side such that the solution is a given one.
    pub(crate) fn set_solution(&mut self, point: &Unknowns<F>) {
        self.right_side = self.triangle.product(point);
    }

    /// Square |R x|² of the size of a change, in standard deviations.
    pub(crate) fn square(&self, change: &Unknowns<F>) -> F {
        self.triangle.product(change).into_iter().fold(F::ZERO, |sum, x| sum + x.squared())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangle::MAX_UNKNOWNS;

    const ROWS: [([f64; 3], f64); 5] = [
        ([1.0, 2.0, -1.0], 1.5),
        ([0.5, -1.0, 0.25], -0.5),
        ([3.0, 0.0, 1.0], 2.0),
        ([-1.0, 1.0, 1.0], 0.75),
        ([0.0, 2.0, 5.0], 1.0),
    ];

    fn information() -> Information<f64> {
        let mut information = Information::new(3);
        for (row, value) in ROWS {
            let mut wide = [0.0; MAX_UNKNOWNS];
            wide[..3].copy_from_slice(&row);
            information.add(wide, value);
        }
        information
    }

    #[test]
    fn the_solution_is_that_of_the_normal_equations() {
        let solution = information().solution();
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
