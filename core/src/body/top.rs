//! Symmetric top, with valid parameters.

use crate::scalar::{Extended, Float};

/// Support of the tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Support {
    /// Sliding on a frictionless horizontal plane: Springborn's toy top.
    Sliding,
    /// Held at a fixed point: the Lagrange top, the limit s → 0 of the formulas at fixed p.
    Fixed,
    /// None: a body that is thrown, floats or is in orbit.
    Free,
}

/// Symmetric top, in SI or any other consistent units. With g = 1 they are the paper's.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Top {
    pub(super) support: Support,
    pub(super) a: f64,
    pub(super) c: f64,
    pub(super) s: f64,
    pub(super) p: Extended,
    pub(super) g: f64,
    pub(super) k: f64,
}

impl Top {
    /// Support of the tip.
    pub fn support(&self) -> Support {
        self.support
    }

    /// Transverse moment of inertia A, kg m²: about the tip for a fixed tip, otherwise about the centre of mass.
    pub fn transverse_inertia(&self) -> f64 {
        self.a
    }

    /// Axial moment of inertia C, kg m².
    pub fn axial_inertia(&self) -> f64 {
        self.c
    }

    /// Distance s of the centre of mass from a sliding tip, m; 0 for another support.
    pub fn com_height(&self) -> f64 {
        self.s
    }

    /// Length in the tip curve c = 2 s αβ, m: s, or 1 for another support.
    pub fn tip_scale(&self) -> f64 {
        match self.support {
            Support::Sliding => self.s,
            Support::Fixed | Support::Free => 1.0,
        }
    }

    /// Whether no torque acts.
    pub fn is_torque_free(&self) -> bool {
        self.g == 0.0
    }

    /// Mass moment p = M s, kg m; 0 for a free body.
    pub fn mass_moment(&self) -> f64 {
        self.p.to_f64()
    }

    /// Gravity g, m/s²; 0 for a free body.
    pub fn gravity(&self) -> f64 {
        self.g
    }

    /// Angular momentum K of the rotor inside, kg m²/s; 0 without one. n = C ⟨ω, r⟩ + K.
    pub fn rotor_momentum(&self) -> f64 {
        self.k
    }
}
