//! Quantities of a sample, each one number or several.

use super::angles;
use crate::input::scenario::Units;
use crate::motion::propagate::Sample;
use toytop::Support;

/// Quantity of a sample: a group of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
#[value(rename_all = "snake_case")]
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
}

/// Columns without `--columns`.
pub const DEFAULT_COLUMNS: &str = "t,u,udot,alpha,beta,gamma,delta,omega,tip,phi";

impl Column {
    /// Name, as a key of JSON.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::T => "t",
            Self::U => "u",
            Self::Udot => "udot",
            Self::Alpha => "alpha",
            Self::Beta => "beta",
            Self::Gamma => "gamma",
            Self::Delta => "delta",
            Self::Omega => "omega",
            Self::Tip => "tip",
            Self::Phi => "phi",
            Self::Quaternion => "quaternion",
            Self::Axis => "axis",
            Self::OmegaBody => "omega_body",
            Self::Angles => "angles",
            Self::EulerZxz => "euler_zxz",
        }
    }

    /// Names of its numbers, as columns of CSV.
    #[must_use]
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::T => &["t"],
            Self::U => &["u"],
            Self::Udot => &["udot"],
            Self::Alpha => &["alpha_re", "alpha_im"],
            Self::Beta => &["beta_re", "beta_im"],
            Self::Gamma => &["gamma_re", "gamma_im"],
            Self::Delta => &["delta_re", "delta_im"],
            Self::Omega => &["omega_x", "omega_y", "omega_z"],
            Self::Tip => &["tip_x", "tip_y"],
            Self::Phi => &["phi"],
            Self::Quaternion => &["w", "x", "y", "z"],
            Self::Axis => &["axis_x", "axis_y", "axis_z"],
            Self::OmegaBody => &["wx", "wy", "wz"],
            Self::Angles => &["tilt", "azimuth", "roll"],
            Self::EulerZxz => &["euler_phi", "euler_theta", "euler_psi"],
        }
    }

    /// Unit of its numbers; empty where there is none.
    #[must_use]
    pub fn unit(self, units: Units, support: Support) -> &'static str {
        match (self, support) {
            (Self::T, _) => units.name("s"),
            (Self::Udot, _) => units.name("1/s"),
            (Self::Omega | Self::OmegaBody, _) => units.name("rad/s"),
            (Self::Phi | Self::Angles | Self::EulerZxz, _) => "rad",
            (Self::Tip, Support::Sliding) => units.name("m"),
            _ => "",
        }
    }

    /// Appends its numbers; NaN stands for what does not exist.
    pub fn push(self, sample: &Sample, numbers: &mut Vec<f64>) {
        let phi = sample.orientation();
        let mut pair = |z: toytop::Complex<f64>| numbers.extend([z.re, z.im]);
        match self {
            Self::T => numbers.push(sample.t),
            Self::U => numbers.push(sample.u),
            Self::Udot => numbers.push(sample.udot),
            Self::Alpha => pair(phi.alpha),
            Self::Beta => pair(phi.beta),
            Self::Gamma => pair(phi.gamma()),
            Self::Delta => pair(phi.delta()),
            Self::Omega => numbers.extend(sample.omega),
            Self::Tip => pair(sample.tip),
            Self::Phi => numbers.push(sample.phi.unwrap_or(f64::NAN)),
            Self::Quaternion => numbers.extend(phi.quaternion()),
            Self::Axis => {
                let [x, y, _] = phi.axis();
                numbers.extend([x, y, sample.u]);
            }
            Self::OmegaBody => numbers.extend(phi.inverse().adjoint(sample.omega)),
            Self::Angles => numbers.extend(angles::tilt_azimuth_roll(&phi)),
            Self::EulerZxz => numbers.extend(angles::zxz(&phi)),
        }
    }
}
