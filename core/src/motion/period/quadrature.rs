//! Trapezoid rule over a nutation period, in the argument of [`EllipticEquations`]. There its error decreases geometrically with the number of
//! nodes. The rate of the decrease is estimated from the last two changes.

use super::Period;
use super::elliptic_equations::EllipticEquations;
use super::landen::Landen;
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::{Float, Ring};

impl Period {
    /// Period of a motion that nutates, with an error of the rule below that of its roundings. `pause` is called at each node.
    #[inline(never)]
    pub(crate) fn integrated<F: Float>(equations: &PhaseEquations<F>, pause: &mut dyn FnMut()) -> Self {
        let elliptic = EllipticEquations::new(equations);
        pause();
        let mut landen = Landen::EMPTY;
        landen.fill(elliptic.parameters, pause);
        let mut rule = TrapezoidRule::new(&elliptic, &landen, pause);
        rule.triple_nodes();
        loop {
            let error = rule.double_nodes();
            if rule.nodes >= MAX_NODES || error <= Period::rounding_error::<F>(rule.nodes) {
                return rule.period(error);
            }
        }
    }
}

/// Last limit of the nodes on half a period, which no launch of the corner study reaches.
const MAX_NODES: u32 = 1 << 13;

/// Trapezoid sums over half a period.
struct TrapezoidRule<'a, F> {
    equations: &'a EllipticEquations<'a, F>,
    landen: &'a Landen<F>,
    /// Sums of the integrands of t, ψ_α and ψ_β without factors; the ends count half.
    sums: [F; 3],
    nodes: u32,
    /// Sine and cosine of the angle between two nodes.
    step: [F; 2],
    /// Relative changes of the time and of ψ by the last three doublings of the nodes.
    changes: [[f32; 3]; 2],
    pause: &'a mut dyn FnMut(),
}

impl<'a, F: Float> TrapezoidRule<'a, F> {
    /// Rule with both ends as its only nodes.
    #[inline(never)]
    fn new(
        equations: &'a EllipticEquations<'a, F>,
        landen: &'a Landen<F>,
        pause: &'a mut dyn FnMut(),
    ) -> Self {
        let mut rule = Self {
            equations,
            landen,
            sums: [F::ZERO; 3],
            nodes: 1,
            step: [F::ONE, F::ZERO],
            changes: [[1.0; 3]; 2],
            pause,
        };
        let ends = add(rule.integrands_at([F::ZERO, F::ONE]), rule.integrands_at([F::ONE, F::ZERO]));
        rule.sums = ends.map(F::halved);
        rule
    }

    /// Divides the quarter turn between the ends by three: 3, 6, 12, ... nodes take less time than 2, 4, 8, ... in the costliest set-ups.
    #[inline(never)]
    fn triple_nodes(&mut self) {
        self.step = [F::ONE.halved(), F::from_f64(0.75).sqrt()];
        self.sums = add(self.sums, self.sum_nodes(2, self.step));
        self.nodes = 3;
    }

    /// Halves the distance of the nodes. Returns the estimated relative error.
    #[inline(never)]
    fn double_nodes(&mut self) -> f64 {
        let [sine, cosine] = self.step;
        let half_cosine = (F::ONE + cosine).halved().sqrt();
        let half_step = [sine / half_cosine.doubled(), half_cosine];
        let odd = self.sum_nodes(self.nodes, half_step);
        let difference = add(odd, self.sums.map(|sum| -sum));
        self.sums = add(self.sums, odd);
        (self.nodes, self.step) = (2 * self.nodes, half_step);
        let relative = self.relative(difference);
        for ([first, second, third], relative) in self.changes.iter_mut().zip(relative) {
            (*first, *second, *third) = (*second, *third, relative as f32);
        }
        (self.pause)();
        let [time, psi] = self.changes.map(|changes| remaining_error(changes.map(f64::from)));
        time.max(psi)
    }

    /// Sums over nodes that are a step apart.
    #[inline(always)] // a frame less on the stack
    fn sum_nodes(&mut self, nodes: u32, first: [F; 2]) -> [F; 3] {
        let [step_sine, step_cosine] = self.step;
        let [mut sine, mut cosine] = first;
        let mut sums = [F::ZERO; 3];
        for _ in 0..nodes {
            sums = add(sums, self.integrands_at([sine, cosine]));
            (sine, cosine) =
                (sine * step_cosine + cosine * step_sine, cosine * step_cosine - sine * step_sine);
        }
        sums
    }

    fn integrands_at(&mut self, angle: [F; 2]) -> [F; 3] {
        (self.pause)();
        let fractions = self.landen.fractions_at_angle(angle);
        (self.pause)();
        self.equations.at(&fractions)
    }

    /// Changes of the time and of ψ_α and ψ_β, relative to the time and to |ψ_α| + |ψ_β|.
    fn relative(&self, change: [F; 3]) -> [f64; 2] {
        let [_, alpha_factor, beta_factor] = self.equations.factors.map(|factor| factor.to_f64().abs());
        let magnitudes = |sums: [F; 3]| {
            let [time, alpha, beta] = sums.map(|sum| sum.to_f64().abs());
            [time, alpha * alpha_factor + beta * beta_factor]
        };
        let [time_change, psi_change] = magnitudes(change);
        let [time, psi] = magnitudes(self.sums);
        [time_change / time, if psi > 0.0 { psi_change / psi } else { 0.0 }]
    }

    #[inline(never)]
    fn period(&self, relative_error: f64) -> Period {
        // a node has the weight 2 K over the number of nodes, as both halves are equal
        let weight = self.landen.quarter_period().doubled() / F::from_f64(f64::from(self.nodes));
        let [time, alpha, beta] = self.sums;
        let [of_time, of_alpha, of_beta] = self.equations.factors;
        let integrals = [time * of_time, alpha * of_alpha, beta * of_beta];
        let [time, alpha, beta] = integrals.map(|sum| (sum * weight).to_extended());
        Period {
            time,
            psi: [alpha, beta],
            relative_error,
            rounding_error: Period::rounding_error::<F>(self.nodes),
            nodes: self.nodes,
        }
    }
}

fn add<F: Ring>([a, b, c]: [F; 3], [x, y, z]: [F; 3]) -> [F; 3] {
    [a + x, b + y, c + z]
}

/// Estimated error of a trapezoid sum from its last three changes.
///
/// With each doubling of the nodes the error C q^n is squared over C: C q, C q², C q⁴. The third is the last change times the square of the ratio of
/// the last two, which is the square of the ratio before. The larger of both counts, because a change can be small by chance. The factors 30 and 3
/// are margins for a C below 1 and for roundings.
fn remaining_error([first, second, third]: [f64; 3]) -> f64 {
    // changes may be 0
    let ratio = |change: f64, before: f64| change / before.max(change).max(f64::MIN_POSITIVE);
    let (last, before) = (ratio(third, second), ratio(second, first));
    let ratio = last.max(before * before);
    third * (3.0 * third + 30.0 * ratio * ratio)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Extended, Wide};
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

    fn released(top: &Top, release: &Release) -> Motion {
        Motion::launch(top, &State::from_release(release).unwrap()).unwrap()
    }

    fn period<F: Float>(motion: &Motion) -> Period {
        Period::integrated(&motion.equations().map(F::from_extended), &mut || {})
    }

    /// ψ_α and ψ_β of this motion converge later than its period: the last changes of one say nothing about the other.
    #[test]
    fn the_estimate_holds_where_one_integral_converges_later() {
        let [a, c] = [550_727.206_840_833_8, 127_428.675_666_720_59];
        let top = sliding([a, c, 3.375_520_805_021_179_3, 1.708_587_416_477_475_3], 0.224_786_633_213_301_5);
        let alpha = Complex::new(-0.950_307_621_000_546_7, -0.011_024_362_132_147_47);
        let beta = Complex::new(-0.310_824_514_250_747_36, 0.013_491_117_398_039_085);
        let omega = [0.003_448_181_221_981_053, 5.756_927_032_555_872e-5, -0.005_529_380_379_944_812];
        let state = State::new(Orientation { alpha, beta }, omega).unwrap();
        let equations = Motion::launch(&top, &state).unwrap().equations();
        let first = Period::integrated(&equations, &mut || {});
        let elliptic = EllipticEquations::new(&equations);
        let mut landen = Landen::EMPTY;
        landen.fill(elliptic.parameters, &mut || {});
        let mut pause = || {};
        let mut rule = TrapezoidRule::new(&elliptic, &landen, &mut pause);
        rule.triple_nodes();
        while rule.nodes < 2 * first.nodes {
            rule.double_nodes();
        }
        let finer = rule.period(0.0);
        assert_eq!(finer.nodes, 2 * first.nodes);
        let error = ((first.time - finer.time) / finer.time).to_f64();
        // beside the roundings of the sums
        assert!(error.abs() <= first.relative_error + 1e-36, "{error:e} {:e}", first.relative_error);
        assert!(first.relative_error <= 1e-28, "{:e}", first.relative_error);
    }

    /// A branch point e₄ close to e₂, with e₃ far away.
    #[test]
    fn a_fourth_branch_point_near_the_motion_takes_few_nodes() {
        let top = sliding([1.0, 0.01, 1.0, 87.0], 1.0);
        for (e, nodes) in [([-1.0, 1.0, 3.9], 96), ([-0.9, 0.999, 3.9], 96), ([-0.9, 0.999, 1.001], 96)] {
            let motion =
                Motion::from_branch_points(&top, e, Signs::default(), &InitialAngles::default()).unwrap();
            assert_eq!(period::<Extended>(&motion).nodes, nodes, "{e:?}");
        }
    }

    /// The most slender top that is accepted, A/(ps) = 1e-6, through the lower vertical and close to the upper one. With the nutation angle as
    /// the variable it needed 65 537 nodes.
    #[test]
    fn a_slender_top_takes_few_nodes() {
        let release = Release { tilt: 1e-3, spin: 1e-3, ..Release::default() };
        let motion = released(&sliding([1.01e-6, 1e-6, 1.0, 1.0], 1.0), &release);
        let nodes = period::<Extended>(&motion).nodes;
        assert!((128..=256).contains(&nodes), "{nodes}");
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
                let allowed = rounded.relative_error + 64.0 * Wide::<1>::OPERATION_ERROR;
                assert!(error <= allowed, "{k}: {error:e} {allowed:e}");
                worst = worst.max(error);
            }
        }
        assert!(worst > Wide::<1>::OPERATION_ERROR || cfg!(miri), "{worst:e}");
    }

    #[test]
    fn the_remaining_error_is_finite_for_equal_sums() {
        assert_eq!(remaining_error([0.0; 3]), 0.0);
        assert!(remaining_error([0.0, 0.0, 1e-32]) < 1e-30);
        // the error squares from one doubling to the next
        let left = remaining_error([1e-4, 1e-8, 1e-16]);
        assert!(left > 1e-32 && left < 1e-30, "{left:e}");
    }

    /// Errors C q, C q², C q⁴, C q⁸: the remaining error is the last one.
    #[test]
    fn the_remaining_error_is_bounded_for_a_small_constant() {
        for constant in [1.0, 1e-3, 1e-6] {
            let [first, second, third, truth] = [1, 2, 4, 8].map(|power| constant * 0.1_f64.powi(power));
            let bound = remaining_error([first, second, third]);
            assert!((truth..100.0 * truth).contains(&bound), "{bound:e} of {truth:e}");
        }
    }

    /// Launch 9250 of the corner study with seed 1: the third change is small by chance, and the error after it is 8.2e-17.
    #[test]
    fn a_change_that_is_small_by_chance_means_no_small_error() {
        let bound = remaining_error([1.7e-3, 3.5e-5, 1.11e-10]);
        assert!((8.2e-17..1e-14).contains(&bound), "{bound:e}");
    }
}
