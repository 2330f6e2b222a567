//! Singular values of a triangle.

use crate::fit::triangle::{MOST_UNKNOWNS, Symmetric, Triangle, Unknowns};
use crate::scalar::Real;

/// Largest number of rounds of Jacobi's rotations.
const MOST_SWEEPS: usize = 12;

impl<F: Real> Triangle<F> {
    /// Singular values of R with unknown i in units of `units[i]`, and the directions that belong to them, by Jacobi's
    /// rotations of the columns. Small ones keep their digits, which they would lose in RᵀR.
    pub(crate) fn singular(&self, units: &Unknowns<F>) -> (Unknowns<F>, Symmetric<F>) {
        let count = self.count;
        // column i of R, and of the directions
        let mut columns = [[F::ZERO; MOST_UNKNOWNS]; MOST_UNKNOWNS];
        let mut directions = columns;
        for (index, (direction, (column, unit))) in
            directions.iter_mut().zip(columns.iter_mut().zip(units)).enumerate().take(count)
        {
            if let Some(slot) = direction.get_mut(index) {
                *slot = F::ONE;
            }
            for (line, (slot, row)) in column.iter_mut().zip(self.rows()).enumerate().take(index + 1) {
                *slot = row.get(index - line).copied().unwrap_or(F::ZERO) * *unit;
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
                    rotate(&mut directions, [i, j], turn, count);
                }
            }
            if !turned {
                break;
            }
        }
        (columns.map(|column| inner(&column, &column).sqrt()), directions)
    }
}

/// Turns two rows of a matrix into each other by an angle of this sine and cosine.
fn rotate<F: Real>(rows: &mut Symmetric<F>, [i, j]: [usize; 2], [sine, cosine]: [F; 2], count: usize) {
    let Some((front, back)) = rows.split_at_mut_checked(j) else { return };
    let (Some(x), Some(y)) = (front.get_mut(i), back.first_mut()) else { return };
    for (p, q) in x.iter_mut().zip(y).take(count) {
        (*p, *q) = (cosine * *p - sine * *q, sine * *p + cosine * *q);
    }
}
