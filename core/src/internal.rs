//! Parts for `toytop-fit`, `toytop-closed-forms`, `toytop-c` and the host only; any version may change them.

pub use crate::body::{check, check_finite};
pub use crate::motion::cayley_klein::{Ellipse, Ellipses};
pub use crate::scalar::sine::{COSINE, CUBIC, LINEAR, SECANT, SINE, SINES, VERSINE};

use crate::body::Top;
use crate::constants::{BranchPoints, FirstIntegrals};
use crate::motion::Motion;
use crate::motion::phase_equations::PhaseEquations;
use crate::phase::Phase;
use crate::scalar::Extended;

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

/// Half phase χ of a motion at t = 0; `None` where u is constant.
pub fn half_phase(motion: &Motion) -> Option<Phase> {
    motion.half_phase
}

/// Slow phases of α and β at t = 0.
pub fn slow_phases(motion: &Motion) -> [Phase; 2] {
    motion.slow_phases
}

/// Variable v = asinh(tan χ) at t = 0 of an aperiodic motion, which has χ = gd v; `None` for another motion.
pub fn aperiodic_v(motion: &Motion) -> Option<f64> {
    motion.aperiodic_v()
}

/// Phase equations of a motion.
pub fn phase_equations(motion: &Motion) -> PhaseEquations<Extended> {
    motion.equations()
}

/// Unrounded period of a motion, s, and its rotations about the vertical, ψ_α(T) + ψ_β(T), and about the axis, ψ_α(T) - ψ_β(T) + τT;
/// `None` where [`Motion::period_advance`] is.
pub fn period_and_rotations(motion: &Motion) -> Option<(Extended, [Phase; 2])> {
    let period = motion.period::<Extended>(&motion.equations(), &mut || {})?;
    let rotations = period.rotations(motion.half_tau).map(|angle| angle.in_turns().to_phase());
    Some((period.time, rotations))
}

/// Number of whole half turns of a phase, and the remainder in [0, 1/2) turn.
pub fn split_half_turns(phase: Phase) -> (i64, Phase) {
    phase.split_half_turns()
}
