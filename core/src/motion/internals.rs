//! Parts of a motion for the crates beside this one: unrounded constants and phases.

use crate::body::Top;
use crate::constants::{BranchPoints, FirstIntegrals};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::Extended;
use crate::su2::AttitudeState;

/// Constants of a motion in extended precision.
pub struct ExtendedConstants<'a> {
    /// Transverse moment of inertia A.
    pub a: Extended,
    /// Height s of the centre of mass.
    pub s: Extended,
    /// Mass moment p.
    pub p: Extended,
    /// Gravity g.
    pub g: Extended,
    /// Branch points.
    pub e: &'a BranchPoints<Extended>,
    /// First integrals.
    pub integrals: &'a FirstIntegrals<Extended>,
    /// Half of τ = ⟨ω, r⟩ - n/A, rad/s.
    pub half_tau: Extended,
    /// Half phase χ at t = 0; `None` for a steady motion.
    pub half_phase: Option<Phase>,
    /// Variable v = asinh(tan χ) at t = 0 of an aperiodic motion, which has χ = gd v; `None` for another motion.
    pub aperiodic_v: Option<f64>,
    /// Rate χ' = |m|/(2A) without torque, rad/s; otherwise 0.
    pub torque_free_rate: Extended,
}

impl<'a> From<&'a Motion> for ExtendedConstants<'a> {
    fn from(motion: &'a Motion) -> Self {
        let Top { a, s, p, g, .. } = motion.top;
        Self {
            a,
            s,
            p,
            g,
            e: &motion.branch_points,
            integrals: &motion.integrals,
            half_tau: motion.half_tau,
            half_phase: motion.half_phase,
            aperiodic_v: motion.aperiodic_v(),
            torque_free_rate: motion.torque_free_rate,
        }
    }
}

/// Unrounded period of a motion, s, and its rotations about the vertical, ψ_α(T) + ψ_β(T), and about the axis, ψ_α(T) - ψ_β(T) + τT;
/// `None` where [`Motion::period_advance`] is. The advances of a [`PeriodAdvance`](crate::PeriodAdvance) lack half a turn
/// where α or β passes through 0.
pub fn period_and_rotations(motion: &Motion) -> Option<(Extended, [Phase; 2])> {
    let period = motion.period::<Extended>(&motion.equations(), &mut || {})?;
    let rotations = period.rotations(motion.half_tau).map(|angle| angle.radians_to_turns().to_phase());
    Some((period.time, rotations))
}

/// Orientation at t = 0, and its rate without the rotation τ about the axis. Without torque the angular velocity is m/A. τ, which may
/// be far larger, is left out rather than subtracted, because a rounded rate with τ has lost the digits of the rest.
pub fn attitude_without_roll(motion: &Motion) -> AttitudeState<f64> {
    let [alpha, beta] = motion.constant_rates();
    motion.attitude_with([alpha - motion.half_tau, beta + motion.half_tau])
}
