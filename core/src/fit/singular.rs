//! Singular values of a triangle.

use crate::fit::triangle::{MOST_UNKNOWNS, Triangle, Unknowns};
use crate::scalar::Real;

/// Largest number of sweeps of Jacobi's rotations.
const MOST_SWEEPS: usize = 12;

impl<F: Real> Triangle<F> {
    /// Singular values of R with unknown i in units of `units[i]`, by Jacobi's rotations of the columns. Small ones keep
    /// their digits, which they would lose in RᵀR. The components of `vectors` are replaced by those along the singular
    /// directions; the directions themselves would take as much memory as R.
    #[inline(never)] // the columns are on the stack only here
    pub(crate) fn singular(&self, units: &Unknowns<F>, vectors: &mut [Unknowns<F>; 3]) -> Unknowns<F> {
        let count = self.count;
        let mut columns = [[F::ZERO; MOST_UNKNOWNS]; MOST_UNKNOWNS];
        for (line, row) in self.each_row().enumerate() {
            // the last entry of a row is its right-hand side, which has no unknown
            let entries = row.iter().zip(columns.iter_mut().zip(units).take(count).skip(line));
            for (entry, (column, unit)) in entries {
                if let Some(slot) = column.get_mut(line) {
                    *slot = *entry * *unit;
                }
            }
        }
        let inner = |x: &Unknowns<F>, y: &Unknowns<F>| {
            x.iter().zip(y).take(count).fold(F::ZERO, |sum, (a, b)| sum + *a * *b)
        };
        let negligible = F::from_f64(4.0 * F::ROUNDING);
        for _ in 0..MOST_SWEEPS {
            let mut turned = false;
            for i in 0..count {
                for j in i + 1..count {
                    let (Some(x), Some(y)) = (columns.get(i), columns.get(j)) else { continue };
                    let (xx, xy, yy) = (inner(x, x), inner(x, y), inner(y, y));
                    if xy.abs() <= negligible * (xx * yy).sqrt() {
                        continue;
                    }
                    turned = true;
                    let ratio = (yy - xx) / xy.doubled();
                    let root = (F::ONE + ratio.squared()).sqrt();
                    let tangent =
                        if ratio < F::ZERO { F::ONE / (ratio - root) } else { F::ONE / (ratio + root) };
                    let cosine = F::ONE / (F::ONE + tangent.squared()).sqrt();
                    let turn = [tangent * cosine, cosine];
                    rotate(&mut columns, [i, j], turn, count);
                    for vector in vectors.iter_mut() {
                        rotate_components(vector, [i, j], turn);
                    }
                }
            }
            if !turned {
                break;
            }
        }
        let mut values = [F::ZERO; MOST_UNKNOWNS];
        for (value, column) in values.iter_mut().zip(&columns) {
            *value = inner(column, column).sqrt();
        }
        values
    }
}

/// Rotates two rows of a matrix by an angle of this sine and cosine.
fn rotate<F: Real>(rows: &mut [Unknowns<F>], [i, j]: [usize; 2], [sine, cosine]: [F; 2], count: usize) {
    let Some((front, back)) = rows.split_at_mut_checked(j) else { return };
    let (Some(x), Some(y)) = (front.get_mut(i), back.first_mut()) else { return };
    for (p, q) in x.iter_mut().zip(y).take(count) {
        (*p, *q) = (cosine * *p - sine * *q, sine * *p + cosine * *q);
    }
}

/// Rotates two components of a vector by an angle of this sine and cosine.
fn rotate_components<F: Real>(vector: &mut Unknowns<F>, [i, j]: [usize; 2], [sine, cosine]: [F; 2]) {
    let Some((front, back)) = vector.split_at_mut_checked(j) else { return };
    if let (Some(p), Some(q)) = (front.get_mut(i), back.first_mut()) {
        (*p, *q) = (cosine * *p - sine * *q, sine * *p + cosine * *q);
    }
}
