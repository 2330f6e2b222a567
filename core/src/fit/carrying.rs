//! Covariance of a launch at a later time, and its information.

use crate::fit::launch::LAUNCH;
use crate::fit::triangle::{MOST_UNKNOWNS, Symmetric, Unknowns};
use crate::su2::Vector;

/// Covariance of the unknowns with the launch at a later time.
///
/// * `columns`: derivatives of the rotation vector and of ω at that time by the unknowns
pub(super) fn carried(covariance: &Symmetric, columns: &[[Vector<f64>; MOST_UNKNOWNS]; 2]) -> Symmetric {
    let [theta, omega] = columns;
    let mut map = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (index, row) in map.iter_mut().enumerate() {
        if index >= LAUNCH {
            if let Some(slot) = row.get_mut(index) {
                *slot = 1.0;
            }
            continue;
        }
        let columns = if index < 3 { theta } else { omega };
        for (slot, column) in row.iter_mut().zip(columns) {
            *slot = column.get(index % 3).copied().unwrap_or(0.0);
        }
    }
    let mut half = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (target, row) in half.iter_mut().zip(&map) {
        for (weight, line) in row.iter().zip(covariance) {
            for (slot, entry) in target.iter_mut().zip(line) {
                *slot += weight * entry;
            }
        }
    }
    let mut carried = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (target, row) in carried.iter_mut().zip(&half) {
        for (slot, other) in target.iter_mut().zip(&map) {
            *slot = row.iter().zip(other).map(|(a, b)| a * b).sum();
        }
    }
    carried
}

/// Rows of L⁻¹ of a covariance L Lᵀ of so many unknowns. A pivot that rounding made negative counts as known to 1e-12.
pub(super) fn inverse_factor(covariance: &Symmetric, count: usize) -> Symmetric {
    let mut rest = *covariance;
    let mut inverse = [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS];
    for (index, row) in inverse.iter_mut().enumerate() {
        if let Some(slot) = row.get_mut(index) {
            *slot = 1.0;
        }
    }
    // elimination of the columns one after another, with the same operations on the identity
    for pivot in 0..count.min(MOST_UNKNOWNS) {
        let (Some(&line), Some(&image)) = (rest.get(pivot), inverse.get(pivot)) else { continue };
        let size = line.get(pivot).copied().unwrap_or(0.0).max(1e-24);
        let eliminate = |target: &mut Unknowns, by: f64, source: &Unknowns| {
            for (slot, entry) in target.iter_mut().zip(source) {
                *slot -= by * entry;
            }
        };
        for (lower, below) in rest.iter_mut().zip(&mut inverse).skip(pivot + 1) {
            let by = lower.get(pivot).copied().unwrap_or(0.0) / size;
            eliminate(lower, by, &line);
            eliminate(below, by, &image);
        }
        if let Some(row) = inverse.get_mut(pivot) {
            let scale = 1.0 / libm::sqrt(size);
            *row = image.map(|x| x * scale);
        }
    }
    inverse
}
