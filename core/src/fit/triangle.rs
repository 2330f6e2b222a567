//! Information about unknowns in square-root form: an upper triangular matrix R and a vector z, to which one row at a
//! time is added by Givens rotations.
//!
//! R δ = z is the least-squares problem of all rows that were added. Its condition number is the square root of that
//! of the normal equations, and no row has to be kept.

use crate::scalar::Real;

/// Largest number of unknowns: a launch, four directions of the top's ratios, and the biases of four sensors.
pub const MOST_UNKNOWNS: usize = 22;
/// Entries of a triangle with its right-hand side.
const ENTRIES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 3) / 2;

/// A number for each unknown.
pub(crate) type Unknowns<F = f64> = [F; MOST_UNKNOWNS];

/// Triangle R with its right-hand side z, stored by rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle<F> {
    pub(super) count: usize,
    entries: [F; ENTRIES],
}

impl<F: Real> Triangle<F> {
    /// Triangle without information, for `count` unknowns.
    pub(crate) fn new(count: usize) -> Self {
        Self { count: count.min(MOST_UNKNOWNS), entries: [F::ZERO; ENTRIES] }
    }

    /// Adds a row: the equation `row` · δ = `value`, of unit variance.
    pub(crate) fn add(&mut self, row: &Unknowns<F>, value: F) {
        let mut incoming = *row;
        let mut value = value;
        let mut rest = &mut self.entries[..];
        for index in 0..self.count {
            let Some((line, tail)) = rest.split_at_mut_checked(self.count - index + 1) else { return };
            rest = tail;
            let (Some(&pivot), Some(&x)) = (line.first(), incoming.get(index)) else { return };
            if x == F::ZERO {
                continue;
            }
            let length = (pivot * pivot + x * x).sqrt();
            let (cosine, sine) = (pivot / length, x / length);
            for (a, b) in line.iter_mut().zip(incoming.iter_mut().take(self.count).skip(index)) {
                (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
            }
            if let Some(side) = line.last_mut() {
                (*side, value) = (cosine * *side + sine * value, cosine * value - sine * *side);
            }
        }
    }

    /// Rows with their right-hand sides, from the first: row i has the entries (i, i), (i, i + 1), ..., z_i.
    pub(super) fn each_row(&self) -> impl Iterator<Item = &[F]> {
        let mut rest = &self.entries[..];
        (0..self.count).map_while(move |index| {
            let (row, tail) = rest.split_at_checked(self.count - index + 1)?;
            rest = tail;
            Some(row)
        })
    }

    /// Row with its right-hand side.
    fn row(&self, index: usize) -> &[F] {
        // the rows before have count + 1, count, ... entries
        let start = index * (self.count + 1) - index * index.saturating_sub(1) / 2;
        self.entries.get(start..start + self.count + 1 - index).unwrap_or(&[])
    }

    /// Solution of R x = y, where y is given; entries without information are 0.
    pub(super) fn back_substituted(&self, y: &Unknowns<F>) -> Unknowns<F> {
        let mut x = [F::ZERO; MOST_UNKNOWNS];
        for index in (0..self.count).rev() {
            let Some((pivot, others)) = self.row(index).split_first() else { continue };
            let known = inner(others, x.iter().take(self.count).skip(index + 1));
            let Some(slot) = x.get_mut(index) else { continue };
            if *pivot != F::ZERO {
                *slot = (y.get(index).copied().unwrap_or(F::ZERO) - known) / *pivot;
            }
        }
        x
    }

    /// Right-hand side z.
    fn side(&self) -> Unknowns<F> {
        let mut side = [F::ZERO; MOST_UNKNOWNS];
        for (slot, row) in side.iter_mut().zip(self.each_row()) {
            *slot = row.last().copied().unwrap_or(F::ZERO);
        }
        side
    }

    /// Least-squares solution δ.
    pub(crate) fn solution(&self) -> Unknowns<F> {
        self.back_substituted(&self.side())
    }

    /// Removes all information.
    pub(crate) fn clear(&mut self) {
        self.entries.fill(F::ZERO);
    }

    /// Replaces the right-hand side by that of the solution `point`; returns the size of `point` in standard deviations.
    pub(crate) fn point_to(&mut self, point: &Unknowns<F>) -> F {
        let size = self.size(point);
        let mut rest = &mut self.entries[..];
        for index in 0..self.count {
            let Some((line, tail)) = rest.split_at_mut_checked(self.count - index + 1) else { break };
            rest = tail;
            if let Some((side, row)) = line.split_last_mut() {
                *side = inner(row, point.iter().skip(index));
            }
        }
        size
    }

    /// Adds the rows of other information after a change of their entries; the right-hand sides are not changed.
    #[inline(never)]
    pub(crate) fn add_mapped(&mut self, other: &Self, of: impl Fn(&mut Unknowns<F>)) {
        for (index, row) in other.each_row().enumerate() {
            let Some((side, entries)) = row.split_last() else { continue };
            let mut wide = [F::ZERO; MOST_UNKNOWNS];
            for (slot, entry) in wide.iter_mut().skip(index).zip(entries) {
                *slot = *entry;
            }
            of(&mut wide);
            self.add(&wide, *side);
        }
    }

    /// Adds the information that each unknown is 0, with these standard deviations > 0.
    pub(crate) fn damp(&mut self, deviations: &Unknowns<F>) {
        for (index, deviation) in deviations.iter().enumerate().take(self.count) {
            let mut row = [F::ZERO; MOST_UNKNOWNS];
            if let Some(slot) = row.get_mut(index) {
                *slot = F::ONE / *deviation;
            }
            self.add(&row, F::ZERO);
        }
    }

    /// Sums of the squares of the columns of R: the diagonal of RᵀR.
    pub(crate) fn column_squares(&self) -> Unknowns<F> {
        let mut squares = [F::ZERO; MOST_UNKNOWNS];
        for (index, row) in self.each_row().enumerate() {
            for (slot, entry) in squares.iter_mut().take(self.count).skip(index).zip(row.iter()) {
                *slot = *slot + *entry * *entry;
            }
        }
        squares
    }

    /// Norm |R δ|: the size of a change in standard deviations.
    pub(crate) fn size(&self, change: &Unknowns<F>) -> F {
        let mut square = F::ZERO;
        for (index, row) in self.each_row().enumerate() {
            // the last entry of a row is its right-hand side, which has no unknown
            square = square + inner(row, change.iter().take(self.count).skip(index)).squared();
        }
        square.sqrt()
    }
}

/// Inner product.
fn inner<'a, F: Real + 'a>(row: &[F], with: impl Iterator<Item = &'a F>) -> F {
    row.iter().zip(with).fold(F::ZERO, |sum, (r, x)| sum + *r * *x)
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
            triangle.add(&wide, value);
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

    fn normal(i: usize, j: usize) -> f64 {
        ROWS.iter().map(|(row, _)| row[i] * row[j]).sum()
    }

    #[test]
    fn a_change_of_the_rows_gives_the_triangle_of_the_changed_rows() {
        let change = |row: &mut Unknowns| {
            (row[0], row[2]) = (row[0] + 0.5 * row[2], row[2] - 2.0 * row[1]);
        };
        let mut direct = Triangle::new(3);
        for (row, value) in ROWS {
            let mut wide = [0.0; MOST_UNKNOWNS];
            wide[..3].copy_from_slice(&row);
            change(&mut wide);
            direct.add(&wide, value);
        }
        let mut mapped = Triangle::new(3);
        mapped.add_mapped(&triangle(), change);
        let (mapped, expected) = (mapped.solution(), direct.solution());
        for k in 0..3 {
            assert!((mapped[k] - expected[k]).abs() < 1e-14, "{mapped:?} {expected:?}");
        }
    }

    #[test]
    fn singular_directions_are_eigenvectors_of_the_normal_matrix() {
        // components of the unit vectors along the directions
        let mut units = [[0.0; MOST_UNKNOWNS]; 3];
        (units[0][0], units[1][1], units[2][2]) = (1.0, 1.0, 1.0);
        let values = triangle().singular(&[1.0; MOST_UNKNOWNS], &mut units);
        for (index, value) in values.iter().enumerate().take(3) {
            for i in 0..3 {
                let image: f64 = (0..3).map(|k| normal(i, k) * units[k][index]).sum();
                assert!((image - value * value * units[i][index]).abs() < 1e-12, "{image}");
            }
        }
    }
}
