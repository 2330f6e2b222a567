//! Covariance of the unknowns of a fit.

use crate::least_squares::triangle::{MOST_UNKNOWNS, Triangle, Unknowns};
use crate::vector::Vector;
use toytop::scalar::Real;

/// Number of unknowns of a launch.
const LAUNCH: usize = 6;
/// Entries of a symmetric matrix on and below its diagonal.
const ENTRIES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 1) / 2;
/// Least variance of an unknown given those before it: an unknown whose variance is negative by rounding counts as
/// known to 1e-12.
const LEAST_VARIANCE: f64 = 1e-24;

/// Covariance of the unknowns: a symmetric matrix, of which one half is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covariance {
    /// Rows of the lower triangle up to the diagonal, one after another.
    entries: [f64; ENTRIES],
}

/// Derivatives of a vector with respect to the unknowns.
pub(crate) type Columns = [Vector<f64>; MOST_UNKNOWNS];

impl Covariance {
    pub(crate) const ZERO: Self = Self { entries: [0.0; ENTRIES] };

    /// Covariance of two unknowns, counted from 0; 0 where there is no such unknown.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.entries.get(place(i, j)).copied().unwrap_or(0.0)
    }

    /// Sets the covariance of two unknowns.
    pub(crate) fn set(&mut self, i: usize, j: usize, value: f64) {
        if let Some(slot) = self.entries.get_mut(place(i, j)) {
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
    #[inline(never)] // one column of R⁻¹ is on the stack at a time
    pub(crate) fn add_inverse<F: Real>(&mut self, information: &Triangle<F>, count: usize) {
        for index in 0..count {
            let column = information.inverse_column(index);
            self.add_square(column.iter().map(|x| x.to_f64()), count);
        }
    }

    /// Replaces the covariance of the launch by that of two vectors, of which the derivatives are given.
    pub(crate) fn carry(&mut self, first: &Columns, second: &Columns) {
        let share = |index: usize, unknown: usize| {
            let columns = if index < 3 { first } else { second };
            columns.get(unknown).and_then(|column| column.get(index % 3)).copied().unwrap_or(0.0)
        };
        // the other unknowns are kept, so that only the rows of the launch have to be multiplied
        let mut rows = [[0.0; MOST_UNKNOWNS]; LAUNCH];
        for (index, row) in rows.iter_mut().enumerate() {
            for (unknown, slot) in row.iter_mut().enumerate() {
                *slot = (0..MOST_UNKNOWNS).map(|k| share(index, k) * self.get(k, unknown)).sum();
            }
        }
        for (index, row) in rows.iter().enumerate() {
            for (unknown, entry) in row.iter().enumerate().skip(index) {
                let product = || row.iter().enumerate().map(|(k, entry)| entry * share(unknown, k)).sum();
                self.set(index, unknown, if unknown < LAUNCH { product() } else { *entry });
            }
        }
    }

    /// Replaces the covariance of a launch along other axes by that along the fixed ones.
    pub(crate) fn turn(&mut self, axes: &[Vector<f64>; 3]) {
        let [mut turns, mut rates]: [Columns; 2] = [[[0.0; 3]; MOST_UNKNOWNS]; 2];
        turns.iter_mut().zip(axes).for_each(|(slot, axis)| *slot = *axis);
        rates.iter_mut().skip(3).zip(axes).for_each(|(slot, axis)| *slot = *axis);
        self.carry(&turns, &rates);
    }

    /// Covariance of a vector, of which the derivatives are given.
    pub(crate) fn of_vector(&self, columns: &Columns) -> [Vector<f64>; 3] {
        let mut carried = *self;
        carried.carry(columns, columns);
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| carried.get(i, j)))
    }

    /// Replaces the covariance L Lᵀ of the first `count` unknowns by the lower triangle L, by Cholesky's method.
    pub(crate) fn factorise(&mut self, count: usize) {
        for i in 0..count {
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| self.get(i, k) * self.get(j, k)).sum();
                let rest = self.get(i, j) - known;
                let root = if i == j { libm::sqrt(rest.max(LEAST_VARIANCE)) } else { rest / self.get(j, j) };
                self.set(i, j, root);
            }
        }
    }

    /// Row of L⁻¹ of a lower triangle L.
    pub(crate) fn inverse_row(&self, index: usize) -> Unknowns {
        let mut row = [0.0; MOST_UNKNOWNS];
        for unknown in (0..=index).rev() {
            let known: f64 =
                row.iter().enumerate().skip(unknown + 1).map(|(k, x)| x * self.get(k, unknown)).sum();
            let unit = if unknown == index { 1.0 } else { 0.0 };
            if let Some(slot) = row.get_mut(unknown) {
                *slot = (unit - known) / self.get(unknown, unknown);
            }
        }
        row
    }
}

/// Index of an entry.
fn place(i: usize, j: usize) -> usize {
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
    fn the_rows_of_the_inverse_factor_make_the_covariance_one() {
        let mut factor = covariance();
        factor.factorise(8);
        for i in 0..8 {
            for j in 0..8 {
                let [x, y] = [i, j].map(|index| factor.inverse_row(index));
                let product: f64 =
                    (0..8).flat_map(|k| (0..8).map(move |l| x[k] * covariance().get(k, l) * y[l])).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-10, "{i} {j}: {product}");
            }
        }
    }

    #[test]
    fn a_carried_covariance_is_that_of_the_carried_unknowns() {
        let column = |shift: usize| {
            let mut columns = [[0.0; 3]; MOST_UNKNOWNS];
            for (k, column) in columns.iter_mut().enumerate().take(8) {
                *column = [0.3, 1.1, 2.3].map(|x| libm::cos(x * (k + shift) as f64));
            }
            columns
        };
        let columns = [column(0), column(5)];
        let mut carried = covariance();
        carried.carry(&columns[0], &columns[1]);
        let mut expected = Covariance::ZERO;
        for k in 0..9 {
            let before = |i: u32| libm::sin(f64::from(i * i + 3 * k * i + k));
            let after = |i: usize| {
                if i < 6 {
                    (0..8).map(|j| columns[i / 3][j][i % 3] * before(j as u32)).sum()
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
