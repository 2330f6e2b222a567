//! Nutation period of a launch in `f64`, and the rotations during it.
//!
//! [`crate::Motion::launch`] computes the period in extended precision, because an ephemeris repeats it up to 2^62
//! times. A fit repeats it some hundred times and corrects the launch by more than a rounding of `f64`. Therefore
//! arithmetic in `f64` is enough; it takes a chip a twentieth of the time and of the stack.

use crate::constants::{BranchPoints, FirstIntegrals, MovingAxis, ReducedPoint};
use crate::law::Law;
use crate::phase::Phase;
use crate::scalar::Float;
use crate::state::State;
use crate::top::{Quantities, Top};

/// Nutation period, and the rotations about the vertical and about the axis during it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turns {
    pub(super) length: f64,
    pub(super) about_vertical: Phase,
    pub(super) about_axis: Phase,
}

/// First and largest number of intervals of half a period. More are needed only near the separatrix, where the period is
/// longer than the nodes of a path reach.
const FEWEST: u32 = 4;
const MOST: u32 = 64;
/// Change by a doubling of the nodes below which the sums have converged, relative for the period and in rad for the
/// phases. The error is then about its square.
const SMALL: f64 = 1e-8;

impl Turns {
    /// Turns of the motion of a launch. `None` where it has no period, or one that takes too many nodes.
    pub(super) fn of(top: &Top, state: &State) -> Option<Self> {
        let mut law = Law::ZERO;
        let (tau, uniform) = find_law(top, state, &mut law)?;
        let [length, alpha, beta] = match uniform {
            Some(length) => [length, 0.0, 0.0],
            None => integrated(&law)?,
        };
        length.is_finite().then(|| Self {
            length,
            about_vertical: Phase::from_radians(alpha + beta),
            about_axis: Phase::from_radians(alpha - beta) + Phase::from_radians(tau * length),
        })
    }
}

/// Finds the law of a motion. Returns its rate τ, and the period of a body without torque, which needs no law because its
/// slow phases are constant. `None` where the axis approaches the vertical asymptotically.
#[inline(never)] // the constants of the motion are on the stack only here
fn find_law(top: &Top, state: &State, law: &mut Law<f64>) -> Option<(f64, Option<f64>)> {
    let (integrals, point) = integrals_and_point(top, state);
    let quantities = Quantities::<f64>::of(top);
    let tau = quantities.tau(integrals.spin);
    if top.is_torque_free() {
        let momentum = point.momentum(quantities.a, integrals.n);
        return Some((tau, Some(2.0 * core::f64::consts::PI * quantities.a / momentum)));
    }
    let e = branch_points(top, &integrals, &point).filter(|e| e.e3_minus_e2 > 0.0)?;
    set_law(law, top, &e, &integrals);
    Some((tau, None))
}

#[inline(never)] // the frames of the constants must not add up
fn integrals_and_point(top: &Top, state: &State) -> (FirstIntegrals, ReducedPoint<f64>) {
    FirstIntegrals::with_point(top, &MovingAxis::of(state))
}

#[inline(never)] // as above
fn set_law(law: &mut Law<f64>, top: &Top, e: &BranchPoints, integrals: &FirstIntegrals) {
    *law = Law::new(top, e, integrals.l_plus_n, integrals.signs());
}

#[inline(never)] // as above
fn branch_points(top: &Top, integrals: &FirstIntegrals, point: &ReducedPoint<f64>) -> Option<BranchPoints> {
    if point.rests_upright() {
        let gap = Quantities::<f64>::of(top).kappa() * integrals.n * integrals.n - 2.0;
        return Some(BranchPoints {
            e1: 1.0,
            e2: 1.0,
            e3: 1.0 + gap,
            one_plus_e1: 2.0,
            one_minus_e2: 0.0,
            e2_minus_e1: 0.0,
            e3_minus_e2: gap,
            e3_minus_one: gap,
        });
    }
    BranchPoints::with_torque(top, integrals, point).ok()
}

/// Period, and ψ_A and ψ_B over it, by the trapezoid rule in χ, which converges geometrically.
#[inline(never)] // the frames of the law and of its integration must not add up
fn integrated(law: &Law<f64>) -> Option<[f64; 3]> {
    const RIGHT_ANGLE: f64 = core::f64::consts::FRAC_PI_2;
    let sum_over = |intervals: u32, odd: bool| {
        let step = RIGHT_ANGLE / f64::from(intervals);
        let [mut sine, mut cosine] = if odd { [libm::sin(step), libm::cos(step)] } else { [0.0, 1.0] };
        let turned = if odd { 2.0 * step } else { step };
        let [by_sine, by_cosine] = [libm::sin(turned), libm::cos(turned)];
        let mut sums = [0.0; 3];
        let count = if odd { intervals / 2 } else { intervals + 1 };
        for index in 0..count {
            let rates = law.rates(sine, cosine);
            let at_end = !odd && (index == 0 || index == intervals);
            let weight = if at_end { 0.5 } else { 1.0 } / rates.nutation;
            for (sum, rate) in sums.iter_mut().zip([1.0, rates.alpha, rates.beta]) {
                *sum += weight * rate;
            }
            [sine, cosine] = [sine * by_cosine + cosine * by_sine, cosine * by_cosine - sine * by_sine];
        }
        sums
    };
    let mut intervals = FEWEST;
    let mut sums = sum_over(intervals, false);
    while intervals < MOST {
        intervals *= 2;
        // the odd nodes lie between those of the previous sums
        let odd = sum_over(intervals, true);
        let weight = 2.0 * RIGHT_ANGLE / f64::from(intervals);
        let ([time, alpha, beta], [odd_time, odd_alpha, odd_beta]) = (sums, odd);
        let is_small = |change: f64, unit: f64| Float::abs(change) < SMALL * unit;
        let settled = is_small(odd_time - time, time)
            && is_small((odd_alpha - alpha) * weight, 1.0)
            && is_small((odd_beta - beta) * weight, 1.0);
        sums = [time + odd_time, alpha + odd_alpha, beta + odd_beta];
        if settled {
            return Some(sums.map(|sum| sum * weight));
        }
    }
    None
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::motion::Motion;
    use crate::state::Release;
    use crate::top::TopParameters;

    /// A top by A, C, s, M, K and support (0: sliding, 1: fixed, 2: free), and its launch by tilt, spin, precession and
    /// nutation rate.
    pub(in crate::fit) type Case = ([f64; 5], u8, [f64; 4]);

    /// Top and state of a case.
    pub(in crate::fit) fn launched(&(top, support, launch): &Case) -> (Top, State) {
        let [transverse_inertia, axial_inertia, com_height, mass, rotor_momentum] = top;
        let parameters = TopParameters {
            transverse_inertia,
            axial_inertia,
            com_height,
            mass,
            gravity: 9.81,
            rotor_momentum,
            ..TopParameters::default()
        };
        let top = match support {
            0 => Top::sliding(&parameters),
            1 => Top::fixed(&parameters),
            _ => Top::free(&parameters),
        };
        let [tilt, spin, precession, nutation] = launch;
        let release = Release { tilt, spin, precession, nutation, azimuth: 0.4, roll: -0.7 };
        (top.unwrap(), State::release(&release).unwrap())
    }

    /// Throws, the last ones upright, almost upright, on a cone and without torque.
    const CASES: [Case; 12] = [
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.35, 150.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.1, -220.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.7, 45.0, 9.0, 3.0]),
        ([7.5e-5, 2e-5, 0.03, 0.05, 0.0], 1, [0.35, 150.0, 2.0, 0.5]),
        ([7.5e-5, 2e-5, 0.03, 0.05, 0.0], 1, [2.5, -12.0, 2.0, 0.5]),
        ([3e-5, 2e-5, 0.03, 0.05, 1e-3], 0, [0.5, 10.0, 1.0, 0.0]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [0.0, 150.0, 0.0, 0.0]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [1e-7, 150.0, 0.0, 0.0]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [1e-3, 150.0, 0.0, 7.0]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 0, [1.1, 170.0, 5.0, 0.0]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 2, [0.6, 30.0, 5.0, 1.0]),
        ([3e-5, 2e-5, 0.03, 0.05, 0.0], 2, [0.6, 0.0, 0.0, 0.0]),
    ];

    #[test]
    fn the_turns_are_those_of_the_motion() {
        for (index, case) in CASES.iter().enumerate() {
            let (top, state) = launched(case);
            let motion = Motion::launch(&top, &state).unwrap();
            let found = Turns::of(&top, &state);
            let Some(mean) = motion.mean_motion() else {
                assert!(found.is_none(), "{index}");
                continue;
            };
            let Turns { length, about_vertical, about_axis } = found.unwrap();
            let off = length / mean.advance.period.to_f64() - 1.0;
            assert!(Float::abs(off) < 1e-12, "{index}: {off:e}");
            for (ours, exact) in [about_vertical, about_axis].into_iter().zip(mean.turns(motion.half_tau())) {
                // the two rotations may both be off by half a turn, which changes the sign of the orientation only
                let off = (ours - exact).principal().to_radians();
                assert!(Float::abs(off) < 1e-11, "{index}: {off:e}");
            }
        }
    }
}
