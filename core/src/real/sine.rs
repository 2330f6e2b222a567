//! Sine and cosine of an integer phase: reduction is exact, and costs a shift.
//!
//! In `f64` by quarter turns and two polynomials. In `f32` from a table of 128 points of the circle and two terms of the
//! series from the nearest: half the operations, for 1 KiB of flash. Where a phase is near a zero of either function, the
//! nearest point is that zero exactly, so the result has relative precision there, down to the phase's own resolution.

/// sin 2πx = x S(x²) and cos 2πx = C(x²) for |x| <= 1/8: the Chebyshev interpolants on [0, 1/64] (mpmath:
/// `chebyfit(lambda y: sin(2*pi*sqrt(y))/sqrt(y), [0, 1/64], 8)`, and the like), lowest power first; their own error is
/// below 2e-21.
const SINE: [f64; 8] = [
    core::f64::consts::TAU,
    -41.34170224039976,
    81.60524927607493,
    -76.70585975299812,
    42.05869392898878,
    -15.094640403891546,
    3.8197881201632113,
    -0.7116358090781666,
];
const COSINE: [f64; 9] = [
    1.0,
    -19.739208802178716,
    64.9393940226683,
    -85.45681720669354,
    60.244641371818105,
    -26.426256772545436,
    7.9035351947629575,
    -1.7143161879285278,
    0.27945867147528963,
];

/// (sin 2πx, cos 2πx) for a phase of x turns, given by the 64 bits of its fraction. Error: below 2e-16.
pub(super) const fn sine_cosine_f64(phase: u64) -> (f64, f64) {
    const SCALE: f64 = 1.0 / (1_u64 << 32) as f64;
    // the nearest quarter turn, and the signed rest in [-1/8, 1/8); a word at a time, each conversion exact
    let quadrant = phase.wrapping_add(1 << 61) >> 62;
    let rest = phase.wrapping_sub(quadrant << 62) as i64;
    quarter_turns(quadrant as u32, ((rest >> 32) as i32 as f64 + rest as u32 as f64 * SCALE) * SCALE)
}

/// (sin, cos) of a number of quarter turns and x turns more, |x| <= 1/8. Relative to the result near its zeros.
pub(super) const fn quarter_turns(quadrant: u32, x: f64) -> (f64, f64) {
    let y = x * x;
    let (sine, cosine) = (x * horner(&SINE, y), horner(&COSINE, y));
    match quadrant & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

const fn horner(mut coefficients: &[f64], y: f64) -> f64 {
    let mut sum = 0.0;
    while let [rest @ .., last] = coefficients {
        sum = sum * y + *last;
        coefficients = rest;
    }
    sum
}

/// Bits of a phase that choose a point of the table.
const POINT_BITS: u32 = 7;

/// (sin, cos) of 128 points around the circle.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static POINTS: [(f32, f32); 1 << POINT_BITS] = {
    let mut points = [(0.0, 1.0); 1 << POINT_BITS];
    let mut i = 0;
    while i < points.len() {
        let (sine, cosine) = sine_cosine_f64((i as u64) << (64 - POINT_BITS));
        points[i] = (sine as f32, cosine as f32);
        i += 1;
    }
    points
};

/// (sin 2πx, cos 2πx) for each of N phases of x turns, from the upper 32 bits of their fraction. Error: below 1.2e-7.
///
/// Together, because each is a chain of dependent operations, and a pipeline can fill one chain from another.
#[inline(always)]
pub(super) fn sine_cosine_f32<const N: usize>(phases: [u64; N]) -> [(f32, f32); N] {
    /// rad per unit of the 32-bit phase
    const SCALE: f32 = core::f32::consts::TAU / (1_u64 << 32) as f32;
    phases.map(|phase| {
        let phase = (phase >> 32) as u32;
        let point = phase.wrapping_add(1 << (31 - POINT_BITS)) >> (32 - POINT_BITS);
        let d = phase.wrapping_sub(point << (32 - POINT_BITS)) as i32 as f32 * SCALE;
        let (sine, cosine) = POINTS.get(point as usize).copied().unwrap_or((0.0, 1.0));
        // sin d and cos d, |d| <= π/128: the next terms are 7e-11 and 1.5e-8
        let y = d * d;
        let small_cosine = 1.0 - y * 0.5;
        let small_sine = d - d * y * (1.0 / 6.0);
        (sine * small_cosine + cosine * small_sine, cosine * small_cosine - sine * small_sine)
    })
}

#[cfg(test)]
mod tests {
    use crate::real::Scalar;
    use crate::turns::Turns;

    /// Largest error against libm's f64 sine over a grid that is no multiple of the segments.
    fn worst<R: Scalar + Into<f64>>() -> f64 {
        let points = 100_003;
        (0..points).fold(0.0, |worst: f64, i| {
            let turns = f64::from(i) * (3.0 / f64::from(points)) - 1.5;
            let (sine, cosine) = R::sine_cosine(Turns::new(turns));
            let angle = 2.0 * core::f64::consts::PI * (turns - turns.round());
            worst.max((sine.into() - libm::sin(angle)).abs()).max((cosine.into() - libm::cos(angle)).abs())
        })
    }

    #[test]
    fn errors_are_what_the_documentation_says() {
        let single = worst::<f32>();
        assert!((5e-8..1.2e-7).contains(&single), "f32: {single:e}");
        // The reference rounds its own argument: up to 4.4e-16 at π.
        let double = worst::<f64>();
        assert!((2e-16..6e-16).contains(&double), "f64: {double:e}");
    }

    #[test]
    fn zeros_are_exact_and_their_neighbourhood_relatively_exact() {
        assert_eq!(f64::sine_cosine(Turns::QUARTER), (1.0, 0.0));
        assert_eq!(f32::sine_cosine(Turns::HALF), (0.0, -1.0));
        let tiny = 1e-15;
        let (_, cosine) = f64::sine_cosine(Turns::QUARTER - Turns::new(tiny));
        assert!((cosine / (2.0 * core::f64::consts::PI * tiny) - 1.0).abs() < 1e-4);
        let (sine, _) = f32::sine_cosine(Turns::new(1e-6));
        assert!((sine / 6.283_185_3e-6 - 1.0).abs() < 3e-4);
    }
}
