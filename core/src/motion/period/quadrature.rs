//! Trapezoid rule over a nutation period, in the argument v of [`EllipticEquations`].
//!
//! The integrands are periodic and analytic near the real axis, so that the error with N intervals on half a period decreases like q^2N, with the
//! nome q of the elliptic functions. [`Landen::intervals`] finds the N of an error below one rounding. The elliptic functions at K - v follow
//! from those at v.

use super::Period;
use super::elliptic_equations::EllipticEquations;
use super::landen::{JacobiFractions, Landen};
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::sine::sine_cosine_series;
use crate::scalar::{Extended, Float};

impl Period {
    /// Period of a motion that nutates. `pause` is called several times at each node.
    #[inline(never)]
    pub(crate) fn integrated<F: Float>(equations: &PhaseEquations<F>, pause: &mut dyn FnMut()) -> Self {
        let elliptic = EllipticEquations::new(equations);
        pause();
        let mut landen = Landen::EMPTY;
        landen.fill(elliptic.parameters, pause);
        let intervals = landen.intervals();
        let sums = trapezoid_sums(&elliptic, &landen, intervals, pause);
        Self::from_sums(&elliptic, &landen, intervals, sums)
    }

    /// Period from the sums of the trapezoid rule with this number of intervals.
    #[inline(never)]
    fn from_sums<F: Float>(
        elliptic: &EllipticEquations<'_, F>,
        landen: &Landen<F>,
        intervals: u32,
        [time, alpha, beta]: [F; 3],
    ) -> Self {
        // an interval has the weight 2 K over their number, as both halves of the period are equal
        let weight = landen.quarter_period().doubled() / F::from_f64(intervals.into());
        let [of_time, of_alpha, of_beta] = elliptic.factors;
        let [time, alpha, beta] =
            [time * of_time, alpha * of_alpha, beta * of_beta].map(|sum| (sum * weight).to_extended());
        Self { time, psi: [alpha, beta], rounding_error: Self::rounding_error::<F>(intervals) }
    }
}

/// Sums of the integrands of t, ψ_α and ψ_β over half a period, without their factors.
#[inline(never)]
fn trapezoid_sums<F: Float>(
    elliptic: &EllipticEquations<'_, F>,
    landen: &Landen<F>,
    intervals: u32,
    pause: &mut dyn FnMut(),
) -> [F; 3] {
    let quarter_turn = Extended::TWO_PI.halved().halved();
    let angle = F::from_extended(quarter_turn) / F::from_f64(intervals.into());
    let (step_sine, step_cosine) = sine_cosine_series(angle, pause);
    let [mut sine, mut cosine] = [F::ZERO, F::ONE];
    let mut sums = [F::ZERO; 3];
    for node in 0..=intervals / 2 {
        pause();
        let fractions = landen.fractions_at_angle([sine, cosine]);
        pause();
        add_integrands(&mut sums, elliptic, &fractions, node == 0);
        if 2 * node < intervals {
            pause();
            add_integrands(&mut sums, elliptic, &landen.at_complement(&fractions), node == 0);
        }
        (sine, cosine) = (sine * step_cosine + cosine * step_sine, cosine * step_cosine - sine * step_sine);
    }
    sums
}

/// Adds the integrands at a node, or half of them at an end of the half period.
#[inline(never)] // two calls, and less stack
fn add_integrands<F: Float>(
    sums: &mut [F; 3],
    elliptic: &EllipticEquations<'_, F>,
    fractions: &JacobiFractions<F>,
    is_end: bool,
) {
    for (sum, integrand) in sums.iter_mut().zip(elliptic.at(fractions)) {
        *sum = *sum + if is_end { integrand.halved() } else { integrand };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Wide;
    use crate::{Complex, InitialAngles, Motion, Orientation, Release, Signs, State, Top, TopParameters};

    fn sliding([transverse_inertia, axial_inertia, com_height, mass_moment]: [f64; 4], gravity: f64) -> Top {
        Top::sliding(&TopParameters {
            transverse_inertia,
            axial_inertia,
            com_height,
            mass_moment,
            gravity,
            ..TopParameters::default()
        })
        .unwrap()
    }

    fn from_branch_points(top: &Top, e: [f64; 3]) -> Motion {
        Motion::from_branch_points(top, e, Signs::default(), &InitialAngles::default()).unwrap()
    }

    fn released(top: &Top, release: &Release) -> Motion {
        Motion::launch(top, &State::from_release(release).unwrap()).unwrap()
    }

    fn period<F: Float>(motion: &Motion) -> Period {
        Period::integrated(&motion.equations().map(F::from_extended), &mut || {})
    }

    /// Number of intervals, and the periods with it, with half of it and with twice it.
    fn intervals_and_periods<F: Float>(motion: &Motion) -> (u32, [Period; 3]) {
        let equations = motion.equations().map(F::from_extended);
        let elliptic = EllipticEquations::new(&equations);
        let mut landen = Landen::EMPTY;
        landen.fill(elliptic.parameters, &mut || {});
        let intervals = landen.intervals();
        let numbers = [intervals, intervals / 2, 2 * intervals];
        let period = |number| {
            Period::from_sums(
                &elliptic,
                &landen,
                number,
                trapezoid_sums(&elliptic, &landen, number, &mut || {}),
            )
        };
        (intervals, numbers.map(period))
    }

    /// Motions near the limits: one whose ψ converge later than its period, three with e₄ near e₂, the most slender top that is accepted, and one
    /// that passes close to the upper vertical.
    fn extreme_motions() -> [Motion; 6] {
        let [a, c] = [550_727.206_840_833_8, 127_428.675_666_720_59];
        let top = sliding([a, c, 3.375_520_805_021_179_3, 1.708_587_416_477_475_3], 0.224_786_633_213_301_5);
        let alpha = Complex::new(-0.950_307_621_000_546_7, -0.011_024_362_132_147_47);
        let beta = Complex::new(-0.310_824_514_250_747_36, 0.013_491_117_398_039_085);
        let omega = [0.003_448_181_221_981_053, 5.756_927_032_555_872e-5, -0.005_529_380_379_944_812];
        let state = State::new(Orientation { alpha, beta }, omega).unwrap();
        let e4_near_e2 = sliding([1.0, 0.01, 1.0, 87.0], 1.0);
        let slender = Release { tilt: 1e-3, spin: 1e-3, ..Release::default() };
        [
            Motion::launch(&top, &state).unwrap(),
            from_branch_points(&e4_near_e2, [-1.0, 1.0, 3.9]),
            from_branch_points(&e4_near_e2, [-0.9, 0.999, 3.9]),
            from_branch_points(&e4_near_e2, [-0.9, 0.999, 1.001]),
            released(&sliding([1.01e-6, 1e-6, 1.0, 1.0], 1.0), &slender),
            from_branch_points(&sliding([1.0, 0.7, 1.0, 1.0], 1.0), [-0.5, 1.0 - 1e-15, 1.0]),
        ]
    }

    /// The error is below the roundings, and with half of the intervals it would not be.
    #[test]
    fn the_intervals_are_as_many_as_the_error_needs() {
        fn check<F: Float>() {
            for (number, motion) in extreme_motions().iter().enumerate() {
                let (intervals, [period, coarse, fine]) = intervals_and_periods::<F>(motion);
                let error = |period: &Period| {
                    let changes = [0, 1].map(|index| (period.psi[index] - fine.psi[index]).to_f64().abs());
                    let size: f64 = fine.psi.iter().map(|psi| psi.to_f64().abs()).sum();
                    let time = ((period.time - fine.time) / fine.time).to_f64().abs();
                    time.max((changes[0] + changes[1]) / (size + core::f64::consts::PI))
                };
                assert!(error(&period) <= fine.rounding_error, "{number}: {:e}", error(&period));
                assert!(error(&coarse) > fine.rounding_error, "{number}: {intervals} {:e}", error(&coarse));
            }
        }
        check::<Extended>();
        check::<Wide<1>>();
    }

    /// With the nutation angle as the variable the slender top needed 65 537 nodes.
    #[test]
    fn motions_near_the_limits_take_few_intervals() {
        let found = extreme_motions().map(|motion| intervals_and_periods::<Extended>(&motion).0);
        assert_eq!(found, [56, 71, 56, 62, 163, 188]);
    }

    /// Numbers of 64 bits give the period and the angles with the error that the bound counts.
    #[test]
    fn numbers_of_64_bits_have_their_error() {
        let mut worst = 0.0_f64;
        for k in 1..if cfg!(miri) { 3 } else { 100 } {
            let fraction = |step: f64| (step * f64::from(k)).fract();
            let mass = 10_f64.powf(3.0 * fraction(0.755) - 2.5);
            let top = sliding([3.0e-5, 2.0e-5, 0.03, 0.03 * mass], 9.80665);
            let release =
                Release { tilt: 3.0 * fraction(0.57), spin: 500.0 * fraction(0.327), ..Release::default() };
            let motion = released(&top, &release);
            let (exact, rounded) = (period::<Extended>(&motion), period::<Wide<1>>(&motion));
            let sum = |period: &Period| period.psi[0] + period.psi[1];
            let size = exact.psi[0].abs() + exact.psi[1].abs();
            let errors = [(rounded.time - exact.time) / exact.time, (sum(&rounded) - sum(&exact)) / size];
            for error in errors.map(|error| error.to_f64().abs()) {
                let allowed = 64.0 * Wide::<1>::OPERATION_ERROR;
                assert!(error <= allowed, "{k}: {error:e} {allowed:e}");
                worst = worst.max(error);
            }
        }
        assert!(worst > Wide::<1>::OPERATION_ERROR || cfg!(miri), "{worst:e}");
    }
}
