//! Covariance of the unknowns of a fit.

use crate::sensitivity::{LAUNCH_COLUMNS, Tangent};
use crate::triangle::{MOST_UNKNOWNS, Triangle};
use crate::vector::Vector;
use toytop::scalar::Real;

/// Entries of a symmetric matrix on and below its diagonal.
const ENTRIES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 1) / 2;
/// Least variance of an unknown given those before it: an unknown whose variance is negative by rounding counts as
/// known to 1e-12.
const LEAST_VARIANCE: f64 = 1e-24;

/// Covariance of the unknowns: a symmetric matrix. One half is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covariance {
    /// Rows of the lower triangle up to the diagonal, one after another.
    entries: [f64; ENTRIES],
}

impl Covariance {
    pub(crate) const ZERO: Self = Self { entries: [0.0; ENTRIES] };

    /// Covariance of two unknowns, counted from 0; 0 where there is no such unknown.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.entries.get(index_of(i, j)).copied().unwrap_or(0.0)
    }

    pub(crate) fn set(&mut self, i: usize, j: usize, value: f64) {
        if let Some(slot) = self.entries.get_mut(index_of(i, j)) {
            *slot = value;
        }
    }

    /// Adds v vᵀ, where the first `count` numbers of v are not 0.
    fn add_square(&mut self, v: impl Iterator<Item = f64> + Clone, count: usize) {
        let mut slots = self.entries.iter_mut();
        for (index, a) in v.clone().enumerate().take(count) {
            for (slot, b) in slots.by_ref().take(index + 1).zip(v.clone()) {
                *slot += a * b;
            }
        }
    }

    /// Adds (RᵀR)⁻¹ of a triangle. An unknown without any information gets the variance 0.
    #[inline(never)] // stack
    pub(crate) fn add_inverse<F: Real>(&mut self, information: &Triangle<F>, count: usize) {
        for index in 0..count {
            let column = information.inverse_column(index);
            self.add_square(column.iter().map(|x| x.to_f64()), count);
        }
    }

    /// Replaces the covariance of the launch by that of a later change of the motion.
    ///
    /// * `columns`: derivatives of the change with respect to the unknowns; those that are left out are 0
    pub(crate) fn carry(&mut self, columns: &[Tangent<f64>]) {
        let weight = |index: usize, unknown: usize| {
            let change = columns.get(unknown).map_or([[0.0; 3]; 2], |by| [by.theta, by.eta]);
            change.as_flattened().get(index).copied().unwrap_or(0.0)
        };
        // the other unknowns are kept, so that only the rows of the launch have to be multiplied
        let mut rows = [[0.0; MOST_UNKNOWNS]; LAUNCH_COLUMNS];
        for (index, row) in rows.iter_mut().enumerate() {
            for (unknown, slot) in row.iter_mut().enumerate() {
                *slot = (0..MOST_UNKNOWNS).map(|k| weight(index, k) * self.get(k, unknown)).sum();
            }
        }
        for (index, row) in rows.iter().enumerate() {
            for (unknown, entry) in row.iter().enumerate().skip(index) {
                let product = || row.iter().enumerate().map(|(k, entry)| entry * weight(unknown, k)).sum();
                self.set(index, unknown, if unknown < LAUNCH_COLUMNS { product() } else { *entry });
            }
        }
    }

    /// Replaces the covariance of a launch along other axes by that along the fixed ones.
    pub(crate) fn turn(&mut self, axes: &[Vector<f64>; 3]) {
        self.carry(&Tangent::along_axes::<LAUNCH_COLUMNS>(axes));
    }

    /// Covariance of a vector with these derivatives with respect to the unknowns.
    pub(crate) fn of_vector(&self, columns: &[Vector<f64>; MOST_UNKNOWNS]) -> [Vector<f64>; 3] {
        let mut carried = *self;
        carried.carry(&columns.map(|theta| Tangent { theta, eta: [0.0; 3] }));
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| carried.get(i, j)))
    }

    /// Information of the first `count` unknowns: the inverse of Cholesky's triangle.
    #[inline(never)] // stack
    pub(crate) fn information<F: Real>(&self, count: usize) -> Triangle<F> {
        self.factor(count).inverse()
    }

    /// Cholesky's lower triangle L of the covariance L Lᵀ of the first `count` unknowns.
    pub(crate) fn factor(&self, count: usize) -> Triangle<f64> {
        let mut factor = Triangle::new(count);
        for index in 0..count {
            let mut row = factor.solved(core::array::from_fn(|other| self.get(index, other)));
            let known: f64 = row.iter().take(index).map(|x| x * x).sum();
            let pivot = libm::sqrt((self.get(index, index) - known).max(LEAST_VARIANCE));
            row.iter_mut().skip(index).take(1).for_each(|slot| *slot = pivot);
            factor.add(row, 0.0);
        }
        factor
    }
}

fn index_of(i: usize, j: usize) -> usize {
    let (row, column) = if i < j { (j, i) } else { (i, j) };
    row * (row + 1) / 2 + column
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covariance() -> Covariance {
        let mut covariance = Covariance::ZERO;
        for k in 0..9 {
            let vector = (0..8).map(|i| libm::sin(f64::from(i * i + 3 * k * i + k)));
            covariance.add_square(vector, 8);
        }
        covariance
    }

    #[test]
    fn the_inverse_factor_makes_the_covariance_one() {
        let factor = covariance().factor(8);
        let inverse = [0, 1, 2, 3, 4, 5, 6, 7].map(|index| factor.inverse_column(index));
        for i in 0..8 {
            for j in 0..8 {
                let [x, y] = [i, j].map(|row| inverse.map(|column| column[row]));
                let product: f64 =
                    (0..8).flat_map(|k| (0..8).map(move |l| x[k] * covariance().get(k, l) * y[l])).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-10, "{i} {j}: {product}");
            }
        }
    }

    #[test]
    fn a_carried_covariance_is_that_of_the_carried_unknowns() {
        let column = |shift: usize, k: usize| [0.3, 1.1, 2.3].map(|x| libm::cos(x * (k + shift) as f64));
        let columns = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| Tangent { theta: column(0, k), eta: column(5, k) });
        let mut carried = covariance();
        carried.carry(&columns);
        let mut expected = Covariance::ZERO;
        for k in 0..9 {
            let before = |i: u32| libm::sin(f64::from(i * i + 3 * k * i + k));
            let after = |i: usize| {
                if i < 6 {
                    (0..8)
                        .map(|j| [columns[j].theta, columns[j].eta].as_flattened()[i] * before(j as u32))
                        .sum()
                } else {
                    before(i as u32)
                }
            };
            expected.add_square((0..8).map(after), 8);
        }
        for i in 0..8 {
            for j in 0..8 {
                assert!((carried.get(i, j) - expected.get(i, j)).abs() < 1e-12, "{i} {j}");
            }
        }
    }

    #[test]
    fn the_covariance_is_the_inverse_of_the_normal_matrix() {
        let rows = [[1.0, 2.0, -1.0], [0.5, -1.0, 0.25], [3.0, 0.0, 1.0], [-1.0, 1.0, 1.0], [0.0, 2.0, 5.0]];
        let mut triangle = Triangle::<f64>::new(3);
        for row in rows {
            let mut wide = [0.0; MOST_UNKNOWNS];
            wide[..3].copy_from_slice(&row);
            triangle.add(wide, 1.0);
        }
        let mut covariance = Covariance::ZERO;
        covariance.add_inverse(&triangle, 3);
        let normal = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
        for i in 0..3 {
            for j in 0..3 {
                let product: f64 = (0..3).map(|k| covariance.get(i, k) * normal(k, j)).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-13, "{product}");
            }
        }
    }
}
