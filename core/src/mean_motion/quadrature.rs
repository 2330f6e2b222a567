//! Trapezoid rule over a nutation period, in the elliptic argument of [`EllipticLaw`].
//!
//! The integrands are smooth periodic functions of this argument v, so the trapezoid rule converges geometrically, at a rate that
//! is known beforehand. sn and cn come from the descending Landen transformation, with the *complementary* parameter m₁ as an
//! argument. At the lower end of the transformation the nodes are equidistant angles, so no inverse function and no
//! transcendental function is needed.

mod division;

mod sums;

use crate::elliptic::jacobi::LandenSteps;
use crate::law::Law;
use crate::law::elliptic::EllipticLaw;
use crate::scalar::{Extended, RateNumber, Ring};
use division::{MOST_NODES, division, part_of_right_angle, sum_of_angles};
use sums::Sums;

/// Integrals over one period: T, and ψ_A(T) and ψ_B(T) in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Integrals {
    pub(crate) period: Extended,
    pub(crate) psi_alpha: Extended,
    pub(crate) psi_beta: Extended,
    /// Error of the trapezoid rule, estimated from its last change: relative to the period, and relative to |ψ_A| +
    /// |ψ_B|.
    pub(crate) relative_error: f64,
    /// Relative error of one operation of the arithmetic.
    pub(crate) operation_error: f64,
    /// Number of nodes on half a period.
    pub(crate) nodes: u32,
}

impl Integrals {
    /// Integrals of a uniform rotation.
    pub(crate) fn uniform(period: Extended) -> Self {
        let operation_error = Extended::OPERATION_ERROR;
        let [psi_alpha, psi_beta] = [Extended::ZERO; 2];
        Self { period, psi_alpha, psi_beta, relative_error: 0.0, operation_error, nodes: 1 }
    }
}

/// Next piece of the work.
#[derive(Clone, Copy, Debug)]
enum Piece {
    /// Landen transformations, and then the number of nodes.
    Transformations,
    /// Node of the first division.
    FirstNode,
    /// Half of the angle between two nodes.
    HalfStep,
    /// Node between two nodes.
    OddNode,
    /// Change of the sums by the last doubling of the nodes.
    Change,
}

/// Number of Landen transformations in a piece of work.
const TRANSFORMATIONS: usize = 3;

/// Trapezoid sums over half a period, to which one node is added at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadrature<N> {
    law: EllipticLaw<N>,
    jacobi: LandenSteps<N>,
    piece: Piece,
    /// Sums over `nodes` nodes; the ends of the half period have half weight, and are the first two nodes.
    sums: Sums<N>,
    nodes: u32,
    /// Number of nodes that the rate of convergence requires.
    needed: u32,
    /// Number of ends and of other nodes of the first division that are not yet in the sums.
    first_nodes: u32,
    /// Sums over the first `odd_nodes` of the nodes between those of `sums`.
    odd: Sums<N>,
    odd_nodes: u32,
    /// Sine and cosine of the angle between two nodes, of half of it, and of the next node's angle.
    step: [N; 2],
    half_step: [N; 2],
    angle: [N; 2],
    /// Relative changes of the period and of the slow phases by the doubling before the last one.
    before: [f64; 2],
}

impl<N: RateNumber> Quadrature<N> {
    /// Quadrature before [`Quadrature::begin`].
    pub(crate) const NONE: Self = Self {
        law: EllipticLaw::ZERO,
        jacobi: LandenSteps::NONE,
        piece: Piece::Transformations,
        sums: Sums::ZERO,
        nodes: 1,
        needed: 0,
        first_nodes: 0,
        odd: Sums::ZERO,
        odd_nodes: 0,
        step: [N::ZERO; 2],
        half_step: [N::ZERO; 2],
        angle: [N::ZERO, N::ONE],
        before: [f64::INFINITY; 2],
    };

    /// Begins the quadrature for a law, without a node. A chip's stack is too small for another quadrature, so that it begins in its own
    /// memory.
    #[inline(never)]
    pub(crate) fn begin(&mut self, law: &Law<N>) {
        self.law = EllipticLaw::new(law);
        self.jacobi.begin(self.law.parameters(), N::LEAST_MODULUS);
        self.piece = Piece::Transformations;
        (self.sums, self.nodes) = (Sums::ZERO, 1);
        (self.angle, self.before) = ([N::ZERO, N::ONE], [f64::INFINITY; 2]);
    }

    pub(crate) fn law(&self) -> &Law<N> {
        self.law.law()
    }

    /// Does the next piece of work. Returns the integrals once the sums have converged. Relative error: some roundings
    /// of the number type.
    pub(crate) fn proceed(&mut self) -> Option<Integrals> {
        match self.piece {
            Piece::Transformations => self.transform(),
            Piece::FirstNode => self.add_first_node(),
            Piece::HalfStep => self.begin_odd_nodes(),
            Piece::OddNode => {
                self.odd = self.odd.plus(&self.at(self.angle));
                self.odd_nodes += 1;
                if self.odd_nodes < self.nodes {
                    self.angle = sum_of_angles(self.angle, self.step);
                } else {
                    self.piece = Piece::Change;
                }
            }
            Piece::Change => return self.doubled(),
        }
        None
    }

    /// Adds Landen transformations; after the last, the number of nodes is known.
    fn transform(&mut self) {
        if (0..TRANSFORMATIONS).all(|_| self.jacobi.proceed()) {
            return;
        }
        let (division, needed) = division(N::QUADRATURE_BITS / self.jacobi.landen().bits_per_node());
        (self.nodes, self.needed, self.first_nodes) = (division, needed, division + 1);
        self.half_step = part_of_right_angle(division);
        self.step = self.half_step;
        self.piece = Piece::FirstNode;
    }

    /// Adds the odd nodes to the others. Returns the integrals if the sums have converged.
    #[inline(never)] // the stack frames of a launch must not add up
    fn doubled(&mut self) -> Option<Integrals> {
        // difference of the trapezoid sums with `nodes` and with twice as many nodes
        let difference = self.odd.plus(&self.sums.negated());
        self.sums = self.sums.plus(&self.odd);
        self.nodes *= 2;
        let changes = difference.relative_to(&self.sums, self.law.slow_scales());
        let ([time, slow], [time_before, slow_before]) = (changes, self.before);
        let error = remaining_error(time, time_before).max(remaining_error(slow, slow_before));
        // beyond twice the number needed only roundings are left
        let most = MOST_NODES.min(2 * self.needed);
        if self.nodes >= self.needed && error <= N::SETTLED || self.nodes >= most {
            return Some(self.integrals(error));
        }
        self.before = changes;
        self.begin_odd_nodes();
        None
    }

    /// Adds a node of the first division. The first and the last are the ends, whose weight is half.
    fn add_first_node(&mut self) {
        let node = self.at(self.angle);
        let is_end = self.first_nodes == 1 || self.first_nodes > self.nodes;
        self.sums = self.sums.plus(&if is_end { node.halved() } else { node });
        self.first_nodes -= 1;
        self.angle = sum_of_angles(self.angle, self.step);
        if self.first_nodes == 0 {
            self.piece = Piece::HalfStep;
        }
    }

    fn begin_odd_nodes(&mut self) {
        let [sine, cosine] = self.half_step;
        let half_cosine = (N::ONE + cosine).halved().sqrt();
        self.step = self.half_step;
        self.half_step = [sine / half_cosine.doubled(), half_cosine];
        self.angle = self.half_step;
        (self.odd, self.odd_nodes, self.piece) = (Sums::ZERO, 0, Piece::OddNode);
    }

    /// Integrands at a node, of which sine and cosine are given.
    #[inline(never)]
    fn at(&self, [sine, cosine]: [N; 2]) -> Sums<N> {
        Sums(self.law.at(&self.jacobi.landen().squares_at_angle(sine, cosine)))
    }

    fn integrals(&self, relative_error: f64) -> Integrals {
        // The two halves of the period are equal: 2 K over the number of nodes is twice the weight of half a period.
        let weight = self.jacobi.landen().quarter_period().doubled() / N::from_f64(f64::from(self.nodes));
        let (Sums([time, alpha, beta]), [of_time, of_alpha, of_beta]) = (self.sums, self.law.factors());
        Integrals {
            period: (time * of_time * weight).into(),
            psi_alpha: (alpha * of_alpha * weight).into(),
            psi_beta: (beta * of_beta * weight).into(),
            relative_error,
            operation_error: N::OPERATION_ERROR,
            nodes: self.nodes,
        }
    }
}

/// Estimated error of a trapezoid sum, from the changes of the last two doublings of its nodes. Convergence is
/// geometric. Each error is either the square of the previous one divided by a constant C, or the previous one times
/// the square of the last ratio. C may be small and the ratio may not have settled yet, so the sum of both estimates
/// is used (`toytop-lab study` checks it on random motions).
fn remaining_error(change: f64, before: f64) -> f64 {
    // both changes may be 0: a slow and small nutation may change no sum; before the first change there is none
    let ratio = change / before.max(change).max(f64::MIN_POSITIVE);
    change * (3.0 * change + 30.0 * ratio * ratio)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mean_motion::MeanMotion;
    use crate::scalar::{Extended64, Float};
    use crate::{Complex, Motion, Orientation, Release, Signs, Start, State, Top, TopParameters};

    fn settled<N: RateNumber>(quadrature: &mut Quadrature<N>) -> Integrals {
        loop {
            if let Some(integrals) = quadrature.proceed() {
                return integrals;
            }
        }
    }

    /// The slow phases of this motion converge later than its period: the last changes of one say nothing about the other.
    #[test]
    fn the_estimate_holds_where_one_integral_converges_later() {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 550_727.206_840_833_8,
            axial_inertia: 127_428.675_666_720_59,
            com_height: 3.375_520_805_021_179_3,
            mass_moment: 1.708_587_416_477_475_3,
            gravity: 0.224_786_633_213_301_5,
            ..TopParameters::default()
        })
        .unwrap();
        let alpha = Complex::new(-0.950_307_621_000_546_7, -0.011_024_362_132_147_47);
        let beta = Complex::new(-0.310_824_514_250_747_36, 0.013_491_117_398_039_085);
        let omega = [0.003_448_181_221_981_053, 5.756_927_032_555_872e-5, -0.005_529_380_379_944_812];
        let state = State::new(Orientation { alpha, beta }, omega).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let mut quadrature = Quadrature::<Extended>::NONE;
        quadrature.begin(&motion.law());
        let first = settled(&mut quadrature);
        quadrature.begin_odd_nodes();
        let finer = settled(&mut quadrature);
        assert_eq!(finer.nodes, 2 * first.nodes);
        let error = ((first.period - finer.period) / finer.period).to_f64();
        // beside the roundings of the sums
        assert!(Float::abs(error) <= first.relative_error + 1e-36, "{error:e} {:e}", first.relative_error);
        assert!(first.relative_error <= Extended::SETTLED, "{:e}", first.relative_error);
    }

    /// A branch point e₄ close to e₂, with e₃ far away: the number of nodes follows from K'/K of these points.
    #[test]
    fn a_fourth_branch_point_near_the_motion_takes_few_nodes() {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 1.0,
            axial_inertia: 0.01,
            com_height: 1.0,
            mass_moment: 87.0,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        for (e, nodes) in [([-1.0, 1.0, 3.9], 60), ([-0.9, 0.999, 3.9], 48), ([-0.9, 0.999, 1.001], 48)] {
            let motion = Motion::from_branch_points(&top, e, Signs::default(), &Start::default()).unwrap();
            assert_eq!(motion.mean_motion().map(|mean| mean.nodes), Some(nodes), "{e:?}");
        }
    }

    /// Numbers of 64 bits give the period and the angles with the error that the bound counts.
    #[test]
    fn numbers_of_64_bits_have_their_error() {
        let mut worst = 0.0_f64;
        for k in 1..if cfg!(miri) { 3 } else { 100 } {
            let fraction = |step: f64| (step * f64::from(k)).fract();
            let top = Top::sliding(&TopParameters {
                transverse_inertia: 3.0e-5,
                axial_inertia: 2.0e-5,
                com_height: 0.03,
                mass: 10_f64.powf(3.0 * fraction(0.755) - 2.5),
                ..TopParameters::default()
            })
            .unwrap();
            let release =
                Release { tilt: 3.0 * fraction(0.57), spin: 500.0 * fraction(0.327), ..Release::default() };
            let state = State::release(&release).unwrap();
            let exact = *Motion::launch(&top, &state).unwrap().mean_motion().unwrap();
            let rounded = *Motion::launch_for::<f32>(&top, &state).unwrap().mean_motion().unwrap();
            let slow = |mean: &MeanMotion| mean.psi[0] + mean.psi[1];
            let size = exact.psi[0].abs() + exact.psi[1].abs();
            let errors = [
                (rounded.advance.period - exact.advance.period) / exact.advance.period,
                (slow(&rounded) - slow(&exact)) / size,
            ];
            for error in errors {
                let allowed = rounded.relative_error + 64.0 * rounded.operation_error;
                assert!(Float::abs(error.to_f64()) <= allowed, "{k}: {:e} {allowed:e}", error.to_f64());
                worst = worst.max(Float::abs(error.to_f64()));
            }
        }
        assert!(worst > Extended64::OPERATION_ERROR || cfg!(miri), "{worst:e}");
    }

    #[test]
    fn what_is_left_is_a_number_also_where_nothing_changed() {
        assert_eq!(remaining_error(0.0, 0.0), 0.0);
        assert!(remaining_error(1e-32, 0.0) < 1e-30);
        // the changes were 1e-8 and 1e-16 of the total: the next error is the square of the last
        let left = remaining_error(1e-16, 1e-8);
        assert!(left > 1e-32 && left < 1e-30, "{left:e}");
    }

    /// Errors C q, C q², C q⁴: the last two changes are the first two of them, and the remaining error is the third.
    #[test]
    fn what_is_left_is_bounded_however_small_the_constant() {
        for constant in [1.0, 1e-3, 1e-6] {
            let [before, change, truth] = [1, 2, 4].map(|power| constant * 0.01_f64.powi(power));
            let bound = remaining_error(change, before);
            assert!((truth..100.0 * truth).contains(&bound), "{bound:e} of {truth:e}");
        }
    }
}
