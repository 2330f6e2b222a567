//! One segment: from the polynomials of its span to its coefficients, with bounds on its error and speeds.

use crate::scalar::{Float, Ring};
use crate::table::build::interval::Interval;
use crate::table::build::path::Path;
use crate::table::build::path::polynomial::Polynomial;
use crate::table::evaluation::Coefficient;
use crate::table::evaluation::TABLE_UNIT;
use crate::table::evaluation::TableScalar;

/// Upper bounds on the errors of segments, rad, and on speeds, rad per half period. They are in `f32`, for which many chips have an FPU.
#[derive(Debug)]
pub(super) struct SegmentBounds {
    /// Orientation error by truncation, rad; infinite where a tick could overflow.
    pub(super) error: f32,
    /// Angular speed 2 √(|da/dt|² + |db/dt|²), rad per half period.
    pub(super) angular_speed: f32,
    /// Rate of a residual phase, rad per half period.
    pub(super) residual_rate: f32,
    /// Rate of the local coordinate x.
    pub(super) coordinate_rate: f32,
}

impl SegmentBounds {
    pub(super) const ZERO: Self =
        Self { error: 0.0, angular_speed: 0.0, residual_rate: 0.0, coordinate_rate: 0.0 };

    /// Includes other segments.
    pub(super) fn include(&mut self, other: &Self) {
        let raise = |greatest: &mut f32, other: f32| *greatest = greatest.larger_or_nan(other);
        raise(&mut self.error, other.error);
        raise(&mut self.angular_speed, other.angular_speed);
        raise(&mut self.residual_rate, other.residual_rate);
        raise(&mut self.coordinate_rate, other.coordinate_rate);
    }

    /// Greatest change of the orientation on half a segment, rad. The half is at most a cell.
    pub(super) fn half_segment_change(&self) -> f64 {
        f64::from(self.angular_speed) / 16.0
    }

    /// Orientation error by a delay of χ alone, in half periods.
    pub(super) fn error_of_delay(&self, delay: f64) -> f64 {
        f64::from(self.angular_speed + 2.0 * self.residual_rate) * delay
    }
}

/// Rounds the polynomial of a (index 0) or b (1), and stores it in a segment.
pub(super) fn store_polynomial<R: TableScalar>(
    segment: &mut R::Segment,
    index: usize,
    polynomial: &Polynomial,
) {
    for (column, part) in (2 * index..).zip(&polynomial.parts) {
        for (power, (row, &value)) in segment.as_mut().iter_mut().zip(&part.coefficients).enumerate() {
            if let Some(stored) = row.get_mut(column) {
                *stored = R::Coefficient::nearest(value, power);
            }
        }
    }
}

/// Computes and stores the polynomials of a and b on a segment of the last span.
pub(super) fn store_segment<R: TableScalar>(
    path: &mut Path<'_, R::SetUpFloat>,
    segment: Interval,
    stored: &mut R::Segment,
) -> SegmentBounds {
    let mut truncation_squared = 0.0;
    let mut slope_squared = 0.0;
    for index in 0..2 {
        let Some(polynomial) = path.polynomial_on(segment, index) else { continue };
        polynomial.drop_last_terms(R::TERMS, i64::MAX);
        truncation_squared += Ring::squared(polynomial.truncation());
        slope_squared += polynomial.slope_squared();
        store_polynomial::<R>(stored, index, polynomial);
    }
    let is_safe = R::Coefficient::are_safe((*stored).as_ref());
    // x grows by 2 over a segment
    let coordinate_rate = (2_u32 << segment.depth) as f32;
    SegmentBounds {
        error: if is_safe {
            2.0 * TABLE_UNIT as f32 * Float::sqrt(truncation_squared)
        } else {
            f32::INFINITY
        },
        angular_speed: 2.0 * TABLE_UNIT as f32 * Float::sqrt(slope_squared) * coordinate_rate,
        residual_rate: path.greatest_residual_rate(),
        coordinate_rate,
    }
}
