//! Parts of a motion for the crates beside this one: unrounded constants, phases, and branch points of first integrals.

use crate::body::{ParameterError, Top};
use crate::constants::{BranchPoints, FirstIntegrals, ReducedPoint};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};

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
}

impl<'a> From<&'a Motion> for ExtendedConstants<'a> {
    fn from(motion: &'a Motion) -> Self {
        let Motion { top: Top { a, s, p, g, .. }, branch_points, integrals, half_tau, half_phase, .. } =
            motion;
        Self {
            a: *a,
            s: *s,
            p: *p,
            g: *g,
            e: branch_points,
            integrals,
            half_tau: *half_tau,
            half_phase: *half_phase,
        }
    }
}

/// Variable v = asinh(tan χ) at t = 0 of an aperiodic motion, which has χ = gd v; `None` for another motion.
pub fn aperiodic_v(motion: &Motion) -> Option<f64> {
    motion.aperiodic_v()
}

/// Unrounded period of a motion, s, and its rotations about the vertical, ψ_α(T) + ψ_β(T), and about the axis, ψ_α(T) - ψ_β(T) + τT;
/// `None` where [`Motion::period_advance`] is.
pub fn period_and_rotations(motion: &Motion) -> Option<(Extended, [Phase; 2])> {
    let period = motion.period::<Extended>(&motion.equations(), &mut || {})?;
    let rotations = period.rotations(motion.half_tau).map(|angle| angle.radians_to_turns().to_phase());
    Some((period.time, rotations))
}

/// Branch points of the motion with first integrals l, n and h through a point of the reduced curve, given by u, u' and the kinetic energy
/// of the axis in units of p g, or of 1 without torque.
///
/// # Errors
/// `omega`: e₃ above 1e14.
pub fn branch_points_through(
    top: &Top,
    [l, n, h]: [Extended; 3],
    [u, udot, scaled_axis_energy]: [Extended; 3],
) -> Result<BranchPoints, ParameterError> {
    let integrals = FirstIntegrals { l, n, h, spin: top.spin(n), l_plus_n: l + n, l_minus_n: l - n };
    let [one_minus_u, one_plus_u] = [Extended::ONE - u, Extended::ONE + u];
    let point = ReducedPoint { u, one_minus_u, one_plus_u, udot, scaled_axis_energy };
    let e = BranchPoints::from_reduced_point(top, &integrals, &point, &mut || {})?;
    Ok(e.map(Float::to_f64))
}
