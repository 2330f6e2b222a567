//! Motion to more than thirty digits at any time, by quadrature.
//!
//! |α|² = (1 + u)/2 and |β|² = (1 - u)/2. The arguments of α and β are integrals. Where e₁ = -1, α passes through 0 and changes its sign;
//! where e₂ = 1, β does.

use super::float640::{
    Float640, Orientation640, cis, from_f64, from_i64, is_zero, product, square_root, to_f64,
};
use super::launch_constants::LaunchConstants;
use super::nutation::{HalfPhase, Integrals, Nutation, RATIO, add_multiple};
use crate::input::scenario::MotionInput;
use toytop_model::equations::Rates;

/// Motion by quadrature, with its integrals over a nutation.
pub struct Quadrature {
    launch: LaunchConstants,
    /// Nutation of a motion in which u is not constant, and the integrals from its beginning to the launch.
    nutation: Option<(Nutation, Integrals)>,
}

impl Quadrature {
    /// Motion of this input.
    pub fn new(input: &MotionInput) -> Self {
        let launch = LaunchConstants::new(input);
        let nutation = (!launch.is_steady()).then(|| {
            let nutation = Nutation::new(&launch.constants, RATIO);
            let passed = nutation.integrals_to(&launch.half_phase);
            (nutation, passed)
        });
        Self { launch, nutation }
    }

    /// Nutation period; `None` for a motion that does not nutate.
    pub fn period(&self) -> Option<Float640> {
        let (nutation, _) = self.nutation.as_ref()?;
        nutation.is_periodic.then(|| nutation.total[0].clone())
    }

    /// Time after the launch at which tan χ has this value: 0 at u = e₁, infinite at u = e₂. For a steady motion it is 0.
    pub fn time_of(&self, tangent: f64) -> Float640 {
        let half_phase = [from_i64(1), from_f64(tangent)];
        self.nutation
            .as_ref()
            .map_or(from_i64(0), |(nutation, passed)| &nutation.integrals_to(&half_phase)[0] - &passed[0])
    }

    /// Orientation Φ at a time after the launch, which is taken as exact.
    pub fn at(&self, t: &Float640) -> Orientation640 {
        let LaunchConstants { constants, half_spin_difference, half_phase: at_launch, directions } =
            &self.launch;
        let (half_phase, [_, alpha, beta]) = match &self.nutation {
            None => {
                let [alpha, beta] = constants.turning_rates(&constants.linear_factors(at_launch));
                (at_launch.clone(), [t.clone(), alpha * t, beta * t])
            }
            Some((nutation, passed)) => {
                let (half_phase, now) = nutation.at(&(&passed[0] + t));
                (half_phase, add_multiple(&now, passed, -1))
            }
        };
        let (signs, signs_at_launch) = (self.signs(&half_phase), self.signs(at_launch));
        let linear_factors = constants.linear_factors(&half_phase);
        let drift = half_spin_difference * t;
        let parameter = |i: usize, angle: Float640| {
            let modulus = square_root(&(linear_factors[i].clone() >> 1)) * (signs[i] * signs_at_launch[i]);
            product(&directions[i], &cis(&angle)).map(|part| part * &modulus)
        };
        Orientation640 { alpha: parameter(0, alpha + &drift), beta: parameter(1, beta - drift) }
    }

    /// Signs of α and β where they pass through 0, and of the derivative at 0; 1 for one that does not.
    fn signs(&self, [cosine, sine]: &HalfPhase) -> [i32; 2] {
        let sign = |parts: [&Float640; 2]| match parts.into_iter().find(|part| !is_zero(part)) {
            Some(part) if *part < from_i64(0) => -1,
            _ => 1,
        };
        let [[one_plus_e1, _], [_, one_minus_e2], _] = &self.launch.constants.factors_at_ends;
        [
            if is_zero(one_plus_e1) { sign([sine, cosine]) } else { 1 },
            if is_zero(one_minus_e2) { sign([cosine, &-sine]) } else { 1 },
        ]
    }

    /// Rates at a time after the launch, which is taken as exact, by central differences of Φ, without a formula of the rates.
    ///
    /// * `unit`: a time in which the body rotates by less than 10^12 rad, such as a tick of its table
    pub fn rates(&self, t: &Float640, unit: f64) -> Rates {
        /// Half the time between the two orientations, in units of `unit`. The relative error of the rates is below 1e-20.
        const HALF_STEP: f64 = 1.0 / (1_u128 << 80) as f64;
        let step = from_f64(unit) * from_f64(HALF_STEP);
        let (before, after) = (self.at(&(t - &step)), self.at(&(t + &step)));
        let per_time = |x: Float640| to_f64(&(x / &step));
        Rates {
            omega: after.half_rotation_from(&before).map(per_time),
            omega_body: before.inverse().half_rotation_from(&after.inverse()).map(per_time),
            udot: per_time((after.u() - before.u()) >> 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::scenario::Launch;
    use crate::random::Random;
    use crate::reference::float640::to_i64;
    use toytop::{InitialAngles, Signs, Support, TopParameters};

    /// Random motion of a sliding top, with differences of branch points down to 1e-12.
    fn random_motion(random: &mut Random) -> MotionInput {
        let [below, swing, above, beyond] = [(); 4].map(|()| random.log_uniform(1e-12, 1.0));
        let unit = 0.5 * (below + swing + above);
        let e = [below / unit - 1.0, 1.0 - above / unit, 1.0 + beyond];
        let ratio = random.log_uniform(1e-3, 1e6);
        let top = TopParameters {
            transverse_inertia: ratio,
            axial_inertia: ratio * random.log_uniform(1e-3, 2.0),
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        };
        let phases = InitialAngles { theta: random.between(-3.0, 3.0), ..InitialAngles::default() };
        let launch = Launch::BranchPoints { e, signs: Signs::default(), phases };
        MotionInput { support: Support::Sliding, top, launch }
    }

    /// With other panels only the error of the quadrature changes; at tick 2^62 it is still below 1e-15 rad.
    #[test]
    fn other_panels_the_same_truth() {
        let mut worst = 0.0_f64;
        for stream in 0..60 {
            let exact = Quadrature::new(&random_motion(&mut Random::new(7, stream)));
            let Some((nutation, _)) = exact.nutation.filter(|(nutation, _)| nutation.is_periodic) else {
                continue;
            };
            let finer = Nutation::new(&exact.launch.constants, 0.6);
            for (i, (a, b)) in nutation.total.iter().zip(&finer.total).enumerate() {
                let size = if i == 0 { to_f64(a) } else { 1.0 + to_f64(a).abs() };
                worst = worst.max(to_f64(&(a - b)).abs() / size);
            }
        }
        assert!(worst < 1e-35 && worst > 0.0, "{worst:e}");
    }

    /// The time of the half phase at a time is this time, also at large times.
    #[test]
    fn a_half_phase_and_its_time() {
        let mut worst = 0.0_f64;
        for stream in 0..60 {
            let mut random = Random::new(8, stream);
            let exact = Quadrature::new(&random_motion(&mut random));
            let (Some(period), Some((nutation, _))) = (exact.period(), &exact.nutation) else { continue };
            for time in [random.uniform(), -random.uniform(), 1e15 * random.uniform()] {
                let time = &period * from_f64(time);
                let (half_phase, [t, alpha, _]) = nutation.at(&time);
                let back = nutation.integrals_to(&half_phase);
                let periods = to_i64(&((&time - &back[0]) / &period)).expect("a number of periods");
                let [back, alpha_back, _] = add_multiple(&back, &nutation.total, periods);
                worst = worst.max(to_f64(&((&back - &time) / &period)).abs());
                assert!(to_f64(&((t - time) / &period)).abs() < 1e-40);
                assert!(to_f64(&(alpha - alpha_back)).abs() < 1e-20);
            }
        }
        assert!(worst < 1e-20, "{worst:e}");
    }
}
