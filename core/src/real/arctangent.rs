//! The angle of a point, in integers: by rotations through angles whose tangent is a power of two (CORDIC), so that there is no
//! division, no root and no product.

/// Rotations; each gives a bit, and more than these would be lost in the roundings.
const ROTATIONS: usize = 29;

/// The angles of tangent 1, 1/2, 1/4, ..., in units of 2^-32 turns.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static ANGLES: [u32; ROTATIONS] = {
    let mut angles = [1 << 29; ROTATIONS];
    let mut k = 1;
    while k < angles.len() {
        let turns = arctangent(1.0 / (1_u64 << k) as f64) / core::f64::consts::TAU;
        angles[k] = (turns * (1_u64 << 32) as f64 + 0.5) as u32;
        k += 1;
    }
    angles
};

/// Of |x| <= 1/2, by its power series.
const fn arctangent(x: f64) -> f64 {
    let mut sum = 0.0;
    let mut n = 27;
    while n > 0 {
        n -= 1;
        sum = 1.0 / (2 * n + 1) as f64 - x * x * sum;
    }
    x * sum
}

/// The angle of the point (x, y) in units of 2^-32 turns, for |x| and |y| <= 2^30; 0 at the origin. Error: below 5e-8 rad,
/// if the point is that exact.
///
/// No sum can overflow: the larger of the two is brought into [2^28, 2^29), and the rotations stretch by 1.65 in all, so
/// that neither exceeds √2 · 1.65 · 2^29 < 2^31.
pub(crate) fn angle(x: i32, y: i32) -> u32 {
    const HEADROOM: i32 = 3;
    let spare = (x.unsigned_abs() | y.unsigned_abs()).leading_zeros() as i32 - HEADROOM;
    let scaled = |part: i32| if spare < 0 { part >> -spare } else { part << (spare & 31) };
    let (mut x, mut y) = (scaled(x), scaled(y));
    let mut angle = 0_u32;
    if x < 0 {
        (x, y, angle) = (-x, -y, 1 << 31);
    }
    for (k, &step) in ANGLES.iter().enumerate() {
        // towards y = 0: all signs change by a complement and a carry
        let mask = y >> 31;
        let sign = |value: i32| (value ^ mask).wrapping_sub(mask);
        (x, y) = (x + sign(y >> k), y - sign(x >> k));
        angle = angle.wrapping_add(sign(step as i32) as u32);
    }
    if x == 0 { 0 } else { angle }
}

#[cfg(test)]
mod tests {
    use super::{angle, arctangent};

    /// The compiler's own run of it, for the table, is seen by no debugger and no measure of coverage.
    #[test]
    fn the_series_has_the_digits_that_the_table_needs() {
        let worst = (1..=500).map(|i| f64::from(i) * 1e-3).fold(0.0_f64, |worst, x| {
            let truth = libm::atan(x);
            worst.max(((arctangent(x) - truth) / truth).abs()).max((arctangent(-x) + truth).abs())
        });
        assert!(worst <= 3e-16, "{worst:e}");
    }

    #[test]
    fn the_error_is_what_the_documentation_says() {
        let mut worst = 0.0_f64;
        let points: u32 = if cfg!(miri) { 3001 } else { 200_003 };
        for i in 0..points {
            let turns = f64::from(i) / f64::from(points);
            let radius = f64::from(1_u32 << 30) * 0.5_f64.powf(f64::from(i % 7) * 0.3);
            let (y, x) = libm::sincos(core::f64::consts::TAU * turns);
            let (x, y) = ((radius * x) as i32, (radius * y) as i32);
            let truth = libm::atan2(f64::from(y), f64::from(x));
            let ours = f64::from(angle(x, y) as i32) * (core::f64::consts::PI / (1_u64 << 31) as f64);
            let miss = (ours - truth).abs();
            worst = worst.max(miss.min((core::f64::consts::TAU - miss).abs()));
        }
        assert!((1e-8..5e-8).contains(&worst), "{worst:e}");
    }

    #[test]
    fn axes_origin_and_extremes() {
        assert_eq!(angle(0, 0), 0);
        let near = |ours: u32, truth: u32| (ours.wrapping_sub(truth) as i32).abs() < 32;
        for size in [1, 1000, 1 << 28, (1 << 29) - 1, 1 << 30] {
            assert!(near(angle(size, 0), 0) && near(angle(-size, 0), 1 << 31), "{size}");
            assert!(near(angle(0, size), 1 << 30) && near(angle(0, -size), 3 << 30), "{size}");
            assert!(near(angle(size, size), 1 << 29) && near(angle(-size, -size), 5 << 29), "{size}");
        }
    }
}
