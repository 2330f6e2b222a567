//! Unrounded parts of a motion, for the crates beside this one.

use crate::motion::Motion;
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::Extended;
use crate::{BranchPoints, FirstIntegrals, Phase, Top};

/// Unrounded A, C, s, p, g and K of a top.
pub fn top_constants(top: &Top) -> [Extended; 6] {
    [top.a, top.c, top.s, top.p, top.g, top.k]
}

/// Unrounded branch points of a motion.
pub fn branch_points(motion: &Motion) -> &BranchPoints<Extended> {
    &motion.e
}

/// Unrounded first integrals of a motion.
pub fn first_integrals(motion: &Motion) -> &FirstIntegrals<Extended> {
    &motion.integrals
}

/// Half of τ = ⟨ω, r⟩ - n/A of a motion, rad/s.
pub fn half_tau(motion: &Motion) -> Extended {
    motion.half_tau
}

/// Half phase χ of a motion at t = 0; `None` for a steady motion.
pub fn half_phase(motion: &Motion) -> Option<Phase> {
    motion.half_phase
}

/// Variable v = asinh(tan χ) at t = 0 of an aperiodic motion, which has χ = gd v; `None` for another motion.
pub fn aperiodic_v(motion: &Motion) -> Option<f64> {
    motion.aperiodic_v()
}

/// Phase equations of a motion.
pub fn phase_equations(motion: &Motion) -> PhaseEquations<Extended> {
    motion.equations()
}

/// Slow phases of α and β at t = 0.
pub fn slow_phases(motion: &Motion) -> [Phase; 2] {
    motion.slow_phases
}

/// Unrounded period of a motion, s, and its rotations about the vertical, ψ_α(T) + ψ_β(T), and about the axis, ψ_α(T) - ψ_β(T) + τT;
/// `None` where [`Motion::period_advance`] is.
pub fn period_and_rotations(motion: &Motion) -> Option<(Extended, [Phase; 2])> {
    let period = motion.period::<Extended>(&motion.equations(), &mut || {})?;
    let rotations = period.rotations(motion.half_tau).map(|angle| angle.radians_to_turns().to_phase());
    Some((period.time, rotations))
}
