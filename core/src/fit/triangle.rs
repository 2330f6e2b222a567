//! Information about unknowns in square-root form: an upper triangular matrix R and a vector z, to which one row at a
//! time is added by rotations.
//!
//! R δ = z is the least-squares problem of all rows that were added. Its condition is the root of that of the normal
//! equations, and no row has to be kept.

/// Largest number of unknowns: a launch, four directions of the top's ratios, and the biases of four sensors.
pub const MOST_UNKNOWNS: usize = 22;
/// Entries of a triangle with its right-hand side.
const ENTRIES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 3) / 2;

/// A number for each unknown.
pub(crate) type Unknowns = [f64; MOST_UNKNOWNS];

/// Symmetric matrix over the unknowns.
pub type Symmetric = [[f64; MOST_UNKNOWNS]; MOST_UNKNOWNS];

/// Triangle R with its right-hand side z, stored by rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    count: usize,
    entries: [f64; ENTRIES],
}

impl Triangle {
    /// Triangle without information about so many unknowns.
    pub(crate) fn new(count: usize) -> Self {
        Self { count: count.min(MOST_UNKNOWNS), entries: [0.0; ENTRIES] }
    }

    /// Adds a row: the equation `row` · δ = `value`, of unit variance.
    pub(crate) fn add(&mut self, row: &Unknowns, value: f64) {
        let mut incoming = *row;
        let mut value = value;
        let mut rest = &mut self.entries[..];
        for index in 0..self.count {
            let Some((line, tail)) = rest.split_at_mut_checked(self.count - index + 1) else { return };
            rest = tail;
            let (Some(&pivot), Some(&x)) = (line.first(), incoming.get(index)) else { return };
            if x == 0.0 {
                continue;
            }
            let length = libm::sqrt(pivot * pivot + x * x);
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
    fn rows(&self) -> [&[f64]; MOST_UNKNOWNS] {
        let mut rows: [&[f64]; MOST_UNKNOWNS] = [&[]; MOST_UNKNOWNS];
        let mut rest = &self.entries[..];
        for (index, row) in rows.iter_mut().enumerate().take(self.count) {
            if let Some((line, tail)) = rest.split_at_checked(self.count - index + 1) {
                (*row, rest) = (line, tail);
            }
        }
        rows
    }

    /// Solution of R x = y, where y is given; entries without information are 0.
    fn back_substituted(&self, y: &Unknowns) -> Unknowns {
        let mut x = [0.0; MOST_UNKNOWNS];
        let rows = self.rows();
        for index in (0..self.count).rev() {
            let Some((pivot, others)) = rows.get(index).and_then(|row| row.split_first()) else { continue };
            let known: f64 =
                others.iter().zip(x.iter().take(self.count).skip(index + 1)).map(|(r, x)| r * x).sum();
            let Some(slot) = x.get_mut(index) else { continue };
            if *pivot != 0.0 {
                *slot = (y.get(index).copied().unwrap_or(0.0) - known) / pivot;
            }
        }
        x
    }

    /// Right-hand side z.
    fn side(&self) -> Unknowns {
        let mut side = [0.0; MOST_UNKNOWNS];
        for (slot, row) in side.iter_mut().zip(self.rows()) {
            *slot = row.last().copied().unwrap_or(0.0);
        }
        side
    }

    /// Least-squares solution δ.
    pub(crate) fn solution(&self) -> Unknowns {
        self.back_substituted(&self.side())
    }

    /// This information and more: each unknown is 0 with this standard deviation, a positive number.
    pub(crate) fn damped(&self, deviations: &Unknowns) -> Self {
        let mut damped = *self;
        for (index, deviation) in deviations.iter().enumerate().take(self.count) {
            let mut row = [0.0; MOST_UNKNOWNS];
            if let Some(slot) = row.get_mut(index) {
                *slot = 1.0 / deviation;
            }
            damped.add(&row, 0.0);
        }
        damped
    }

    /// Sums of the squares of the columns of R: the diagonal of RᵀR.
    pub(crate) fn column_squares(&self) -> Unknowns {
        let mut squares = [0.0; MOST_UNKNOWNS];
        for (index, row) in self.rows().iter().enumerate().take(self.count) {
            for (slot, entry) in squares.iter_mut().take(self.count).skip(index).zip(row.iter()) {
                *slot += entry * entry;
            }
        }
        squares
    }

    /// Norm |R δ|: the size of a change in standard deviations.
    pub(crate) fn size(&self, change: &Unknowns) -> f64 {
        let square: f64 = self
            .rows()
            .iter()
            .enumerate()
            .take(self.count)
            .map(|(index, row)| {
                // the last entry of a row is its right-hand side, which has no unknown
                let inner: f64 =
                    row.iter().zip(change.iter().take(self.count).skip(index)).map(|(r, x)| r * x).sum();
                inner * inner
            })
            .sum();
        libm::sqrt(square)
    }

    /// Covariance (RᵀR)⁻¹. An unknown without any information gets the variance 0.
    pub(crate) fn covariance(&self) -> Symmetric {
        let mut covariance = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
        // the columns of R⁻¹
        let mut inverse = covariance;
        for (index, column) in inverse.iter_mut().enumerate().take(self.count) {
            let mut unit = [0.0; MOST_UNKNOWNS];
            if let Some(slot) = unit.get_mut(index) {
                *slot = 1.0;
            }
            *column = self.back_substituted(&unit);
        }
        for column in inverse.iter().take(self.count) {
            for (line, a) in covariance.iter_mut().zip(column) {
                for (slot, b) in line.iter_mut().zip(column) {
                    *slot += a * b;
                }
            }
        }
        covariance
    }

    /// Matrix RᵀR with unknown i in units of `units[i]`.
    pub(crate) fn normal(&self, units: &Unknowns) -> Symmetric {
        let mut normal = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
        for (index, row) in self.rows().iter().enumerate().take(self.count) {
            let mut line = [0.0; MOST_UNKNOWNS];
            for ((slot, entry), unit) in
                line.iter_mut().zip(units).skip(index).zip(row.iter()).map(|((s, u), e)| ((s, e), u))
            {
                *slot = entry * unit;
            }
            for slot in line.iter_mut().skip(self.count) {
                *slot = 0.0;
            }
            for (target, a) in normal.iter_mut().zip(&line) {
                for (slot, b) in target.iter_mut().zip(&line) {
                    *slot += a * b;
                }
            }
        }
        normal
    }
}

/// Eigenvalues of a symmetric matrix, and its eigenvectors as rows, by Jacobi's rotations.
pub(crate) fn eigen(matrix: &Symmetric, count: usize) -> (Unknowns, Symmetric) {
    let mut a = *matrix;
    let mut vectors = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (index, row) in vectors.iter_mut().enumerate() {
        if let Some(slot) = row.get_mut(index) {
            *slot = 1.0;
        }
    }
    let entry =
        |a: &Symmetric, i: usize, j: usize| a.get(i).and_then(|row| row.get(j)).copied().unwrap_or(0.0);
    for _ in 0..12 {
        let mut turned = false;
        for i in 0..count {
            for j in i + 1..count {
                let (aii, aij, ajj) = (entry(&a, i, i), entry(&a, i, j), entry(&a, j, j));
                if aij * aij <= 1e-30 * (aii * ajj).max(f64::MIN_POSITIVE) {
                    continue;
                }
                turned = true;
                let ratio = (ajj - aii) / (2.0 * aij);
                let root = libm::sqrt(1.0 + ratio * ratio);
                let tangent = if ratio < 0.0 { 1.0 / (ratio - root) } else { 1.0 / (ratio + root) };
                let cosine = 1.0 / libm::sqrt(1.0 + tangent * tangent);
                let sine = tangent * cosine;
                for row in &mut a {
                    rotate(row, i, j, cosine, sine);
                }
                rotate_rows(&mut a, i, j, cosine, sine);
                rotate_rows(&mut vectors, i, j, cosine, sine);
            }
        }
        if !turned {
            break;
        }
    }
    let mut values = [0.0; MOST_UNKNOWNS];
    for (index, value) in values.iter_mut().enumerate().take(count) {
        *value = entry(&a, index, index);
    }
    (values, vectors)
}

fn rotate(row: &mut Unknowns, i: usize, j: usize, cosine: f64, sine: f64) {
    let (Some(&x), Some(&y)) = (row.get(i), row.get(j)) else { return };
    if let Some(slot) = row.get_mut(i) {
        *slot = cosine * x - sine * y;
    }
    if let Some(slot) = row.get_mut(j) {
        *slot = sine * x + cosine * y;
    }
}

fn rotate_rows(a: &mut Symmetric, i: usize, j: usize, cosine: f64, sine: f64) {
    let (Some(&x), Some(&y)) = (a.get(i), a.get(j)) else { return };
    let mut lines = [x, y];
    let [first, second] = &mut lines;
    for (p, q) in first.iter_mut().zip(second.iter_mut()) {
        (*p, *q) = (cosine * *p - sine * *q, sine * *p + cosine * *q);
    }
    let [first, second] = lines;
    if let Some(slot) = a.get_mut(i) {
        *slot = first;
    }
    if let Some(slot) = a.get_mut(j) {
        *slot = second;
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

    fn triangle() -> Triangle {
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

    #[test]
    fn the_covariance_is_the_inverse_of_the_normal_matrix() {
        let (covariance, normal) = (triangle().covariance(), triangle().normal(&[1.0; MOST_UNKNOWNS]));
        for i in 0..3 {
            for j in 0..3 {
                let direct: f64 = ROWS.iter().map(|(row, _)| row[i] * row[j]).sum();
                assert!((normal[i][j] - direct).abs() < 1e-13);
                let product: f64 = (0..3).map(|k| covariance[i][k] * normal[k][j]).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-13, "{product}");
            }
        }
    }

    #[test]
    fn eigenvectors_are_those_of_the_matrix() {
        let normal = triangle().normal(&[1.0; MOST_UNKNOWNS]);
        let (values, vectors) = eigen(&normal, 3);
        for (value, vector) in values.iter().zip(&vectors).take(3) {
            for i in 0..3 {
                let image: f64 = (0..3).map(|k| normal[i][k] * vector[k]).sum();
                assert!((image - value * vector[i]).abs() < 1e-12, "{image}");
            }
        }
    }
}
