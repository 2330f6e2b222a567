//! Quantities of a sample, each one number or several.

use super::angles;
use super::propagate::Sample;
use crate::input::scenario::Units;
use toytop::{Complex, Support};

/// Quantity of a sample: a group of columns.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), value(rename_all = "snake_case"))]
pub enum Column {
    /// Time
    T,
    /// Cosine of the tilt
    U,
    /// Rate of u
    Udot,
    /// Cayley-Klein parameter α
    Alpha,
    /// Cayley-Klein parameter β
    Beta,
    /// Cayley-Klein parameter γ = -β̄
    Gamma,
    /// Cayley-Klein parameter δ = ᾱ
    Delta,
    /// Angular velocity in the fixed frame
    Omega,
    /// Position of the tip, 2 s α β; 2 α β for a held tip
    Tip,
    /// Tip angle, continued from t = 0
    Phi,
    /// Unit quaternion w,x,y,z from body to fixed coordinates
    Quaternion,
    /// Unit vector along the axis, from the tip to the centre of mass
    Axis,
    /// Angular velocity in the body frame
    OmegaBody,
    /// Angles tilt,azimuth,roll of a release, rad
    Angles,
    /// Euler angles of the sequence z-x-z, rad
    EulerZxz,
    /// Bound on the error of the orientation, where the method has one
    ErrorBound,
}

/// Columns without `--columns`.
pub const DEFAULT_COLUMNS: &str = "t,u,udot,alpha,beta,quaternion,omega,tip,phi,error_bound";

impl Column {
    /// Key of JSON, and names of its numbers as columns of CSV.
    pub fn names(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::T => ("t", &["t"]),
            Self::U => ("u", &["u"]),
            Self::Udot => ("udot", &["udot"]),
            Self::Alpha => ("alpha", &["alpha_re", "alpha_im"]),
            Self::Beta => ("beta", &["beta_re", "beta_im"]),
            Self::Gamma => ("gamma", &["gamma_re", "gamma_im"]),
            Self::Delta => ("delta", &["delta_re", "delta_im"]),
            Self::Omega => ("omega", &["omega_x", "omega_y", "omega_z"]),
            Self::Tip => ("tip", &["tip_x", "tip_y"]),
            Self::Phi => ("phi", &["phi"]),
            Self::Quaternion => ("quaternion", &["w", "x", "y", "z"]),
            Self::Axis => ("axis", &["axis_x", "axis_y", "axis_z"]),
            Self::OmegaBody => ("omega_body", &["wx", "wy", "wz"]),
            Self::Angles => ("angles", &["tilt", "azimuth", "roll"]),
            Self::EulerZxz => ("euler_zxz", &["euler_phi", "euler_theta", "euler_psi"]),
            Self::ErrorBound => ("error_bound", &["error_bound"]),
        }
    }

    /// Unit of its numbers; empty where there is none.
    pub fn unit(self, units: Units, support: Support) -> &'static str {
        match self {
            Self::T => units.name("s"),
            Self::Udot => units.name("1/s"),
            Self::Omega | Self::OmegaBody => units.name("rad/s"),
            Self::Phi | Self::Angles | Self::EulerZxz | Self::ErrorBound => "rad",
            Self::Tip if support == Support::Sliding => units.name("m"),
            _ => "",
        }
    }

    /// Numbers of a sample; NaN stands for what does not exist.
    pub fn numbers(self, sample: &Sample) -> Vec<f64> {
        let phi = sample.orientation();
        let pair = |z: Complex<f64>| vec![z.re, z.im];
        match self {
            Self::T => vec![sample.t],
            Self::U => vec![sample.u],
            Self::Udot => vec![sample.udot],
            Self::Alpha => pair(phi.alpha),
            Self::Beta => pair(phi.beta),
            Self::Gamma => pair(phi.gamma()),
            Self::Delta => pair(phi.delta()),
            Self::Omega => sample.omega.into(),
            Self::Tip => pair(sample.tip),
            Self::Phi => vec![sample.phi.unwrap_or(f64::NAN)],
            Self::Quaternion => phi.quaternion().into(),
            Self::Axis => {
                let [x, y, _] = phi.axis();
                vec![x, y, sample.u]
            }
            Self::OmegaBody => phi.inverse().adjoint(sample.omega).into(),
            Self::Angles => angles::tilt_azimuth_roll(&phi).into(),
            Self::EulerZxz => angles::zxz(&phi).into(),
            Self::ErrorBound => vec![sample.error_bound.unwrap_or(f64::NAN)],
        }
    }
}
