//! Covariance of the unknowns of a fit.

use crate::information::Information;
use crate::sensitivity::{LAUNCH_COLUMNS, Tangent};
use crate::triangle::{MAX_UNKNOWNS, Triangle, Unknowns};
use crate::vector::Vector;
use toytop::Orientation;
use toytop::scalar::Real;

/// Least variance of an unknown given those before it: an unknown whose variance is negative by rounding counts as
/// known to 1e-12.
const MIN_VARIANCE: f64 = 1e-24;

/// Covariance of the unknowns: a symmetric matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covariance {
    lower: Triangle<f64>,
}

impl Covariance {
    pub(crate) const ZERO: Self = Self { lower: Triangle::ZERO };

    /// Adds the covariance (RᵀR)⁻¹ of an information. An unknown without any information gets no variance.
    #[inline(never)] // stack
    pub(crate) fn add_inverse<F: Real>(&mut self, information: &Information<F>) {
        for index in 0..information.count {
            self.add_square(&information.triangle.inverse_column(index).map(F::to_f64));
        }
    }

    /// Covariance of two unknowns, counted from 0; 0 where there is no such unknown.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.lower.row(i.max(j)).get(i.min(j)).copied().unwrap_or(0.0)
    }

    /// Adds to the variance of one unknown.
    pub(crate) fn add_variance(&mut self, index: usize, variance: f64) {
        self.lower.symmetric_mut(index, index).into_iter().for_each(|slot| *slot += variance);
    }

    /// Replaces an unknown by one of this variance that is independent of the others.
    pub(crate) fn replace_unknown(&mut self, index: usize, variance: f64) {
        for other in 0..MAX_UNKNOWNS {
            if let Some(slot) = self.lower.symmetric_mut(index, other) {
                *slot = if other == index { variance } else { 0.0 };
            }
        }
    }

    /// Covariance of the unknowns in these units.
    pub(crate) fn in_units(mut self, units: &Unknowns) -> Self {
        for (index, x) in units.iter().enumerate() {
            self.lower.row_mut(index).iter_mut().zip(units).for_each(|(slot, y)| *slot /= x * y);
        }
        self
    }

    /// Adds v vᵀ.
    fn add_square(&mut self, v: &Unknowns) {
        for (index, a) in v.iter().enumerate() {
            self.lower.row_mut(index).iter_mut().zip(v).for_each(|(slot, b)| *slot += a * b);
        }
    }

    /// Carries the launch's covariance to a later time.
    ///
    /// * `columns`: derivatives of the change with respect to the unknowns; those that are left out are 0
    pub(crate) fn propagate(&mut self, columns: &[Tangent<f64>]) {
        // the other unknowns are kept, so that only the rows of the launch have to be multiplied
        let mut rows = [[0.0; MAX_UNKNOWNS]; LAUNCH_COLUMNS];
        for (k, column) in columns.iter().enumerate() {
            for (row, weight) in rows.iter_mut().zip(column.components()) {
                row.iter_mut().enumerate().for_each(|(unknown, slot)| *slot += weight * self.get(k, unknown));
            }
        }
        for (index, row) in rows.iter().enumerate() {
            let mut launch = [0.0; LAUNCH_COLUMNS];
            for (entry, column) in row.iter().zip(columns) {
                launch.iter_mut().zip(column.components()).for_each(|(slot, weight)| *slot += entry * weight);
            }
            let entries = launch.iter().chain(row.iter().skip(LAUNCH_COLUMNS));
            for (unknown, entry) in entries.enumerate().skip(index) {
                self.lower.symmetric_mut(index, unknown).into_iter().for_each(|slot| *slot = *entry);
            }
        }
    }

    /// Replaces the covariance of a launch along the body axes of an orientation by that along the fixed axes.
    #[inline(never)] // stack
    pub(crate) fn turn(&mut self, phi: &Orientation<f64>) {
        self.propagate(&Tangent::along_body_axes(phi));
    }

    /// Covariance of a vector with these derivatives with respect to the unknowns.
    pub(crate) fn of_vector(&self, columns: &[Vector<f64>; MAX_UNKNOWNS]) -> [Vector<f64>; 3] {
        let mut carried = *self;
        carried.propagate(&columns.map(|theta| Tangent { theta, eta: [0.0; 3] }));
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| carried.get(i, j)))
    }

    /// Information of the first `count` unknowns: the inverse of Cholesky's triangle.
    #[inline(never)] // stack
    pub(crate) fn information<F: Real>(&self, count: usize) -> Information<F> {
        Information::with_triangle(count, self.factor(count).inverse())
    }

    /// Cholesky's lower triangle L of the covariance L Lᵀ of the first `count` unknowns.
    pub(crate) fn factor(&self, count: usize) -> Triangle<f64> {
        let mut factor = Triangle::ZERO;
        for index in 0..count {
            let row = factor.solved(core::array::from_fn(|other| self.get(index, other)));
            let known: f64 = row.iter().take(index).map(|x| x * x).sum();
            if let [line @ .., pivot] = factor.row_mut(index) {
                line.iter_mut().zip(row).for_each(|(slot, x)| *slot = x);
                *pivot = libm::sqrt((self.get(index, index) - known).max(MIN_VARIANCE));
            }
        }
        factor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covariance() -> Covariance {
        let mut covariance = Covariance::ZERO;
        for k in 0..9 {
            let component = |i: u32| if i < 8 { libm::sin(f64::from(i * i + 3 * k * i + k)) } else { 0.0 };
            covariance.add_square(&core::array::from_fn(|i| component(i as u32)));
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
        carried.propagate(&columns);
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
            expected.add_square(&core::array::from_fn(|i| if i < 8 { after(i) } else { 0.0 }));
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
        let mut information = Information::<f64>::new(3);
        for row in rows {
            let mut wide = [0.0; MAX_UNKNOWNS];
            wide[..3].copy_from_slice(&row);
            information.add(wide, 1.0);
        }
        let mut covariance = Covariance::ZERO;
        covariance.add_inverse(&information);
        let normal = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
        for i in 0..3 {
            for j in 0..3 {
                let product: f64 = (0..3).map(|k| covariance.get(i, k) * normal(k, j)).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-13, "{product}");
            }
        }
    }
}
