//! Quantities of a sample, each one number or several.

use super::euler_angles;
use super::propagate::Sample;
use crate::input::scenario::Units;
use toytop::{Complex, Support};

/// Quantity of a sample: a group of columns.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Quantity {
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

impl Quantity {
    /// Columns of a table and of CSV, if none are chosen.
    pub const DEFAULT: [Self; 10] = [
        Self::T,
        Self::U,
        Self::Udot,
        Self::Alpha,
        Self::Beta,
        Self::Quaternion,
        Self::Omega,
        Self::Tip,
        Self::Phi,
        Self::ErrorBound,
    ];
}

/// Description of a quantity: key of JSON, names of its numbers as columns of CSV, unit in SI, and its numbers in a sample.
type Description = (&'static str, &'static [&'static str], &'static str, fn(&Sample) -> Vec<f64>);

impl Quantity {
    fn description(self) -> Description {
        match self {
            Self::T => ("t", &["t"], "s", |sample| vec![sample.t]),
            Self::U => ("u", &["u"], "", |sample| vec![sample.u]),
            Self::Udot => ("udot", &["udot"], "1/s", |sample| vec![sample.udot]),
            Self::Alpha => ("alpha", &["alpha_re", "alpha_im"], "", |sample| parts(sample.alpha)),
            Self::Beta => ("beta", &["beta_re", "beta_im"], "", |sample| parts(sample.beta)),
            Self::Gamma => {
                ("gamma", &["gamma_re", "gamma_im"], "", |sample| parts(sample.orientation().gamma()))
            }
            Self::Delta => {
                ("delta", &["delta_re", "delta_im"], "", |sample| parts(sample.orientation().delta()))
            }
            Self::Omega => {
                ("omega", &["omega_x", "omega_y", "omega_z"], "rad/s", |sample| sample.omega.into())
            }
            Self::Tip => ("tip", &["tip_x", "tip_y"], "m", |sample| parts(sample.tip)),
            Self::Phi => ("phi", &["phi"], "rad", |sample| vec![sample.tip_angle.unwrap_or(f64::NAN)]),
            Self::Quaternion => {
                ("quaternion", &["w", "x", "y", "z"], "", |sample| sample.orientation().quaternion().into())
            }
            Self::Axis => ("axis", &["axis_x", "axis_y", "axis_z"], "", |sample| {
                let [x, y, _] = sample.orientation().axis();
                vec![x, y, sample.u]
            }),
            Self::OmegaBody => ("omega_body", &["wx", "wy", "wz"], "rad/s", |sample| {
                sample.orientation().inverse().adjoint(sample.omega).into()
            }),
            Self::Angles => ("angles", &["tilt", "azimuth", "roll"], "rad", |sample| {
                euler_angles::tilt_azimuth_roll(&sample.orientation()).into()
            }),
            Self::EulerZxz => ("euler_zxz", &["euler_phi", "euler_theta", "euler_psi"], "rad", |sample| {
                euler_angles::zxz(&sample.orientation()).into()
            }),
            Self::ErrorBound => ("error_bound", &["error_bound"], "rad", |sample| {
                vec![sample.error_bound.unwrap_or(f64::NAN)]
            }),
        }
    }

    /// Key of JSON, and names of its numbers as columns of CSV.
    pub fn names(self) -> (&'static str, &'static [&'static str]) {
        let (key, names, ..) = self.description();
        (key, names)
    }

    /// Unit of its numbers; empty where there is none.
    pub fn unit(self, units: Units, support: Support) -> &'static str {
        match self.description() {
            (_, _, "rad", _) => "rad",
            (_, _, "m", _) if support != Support::Sliding => "",
            (_, _, unit, _) => units.name(unit),
        }
    }

    /// Numbers of a sample; NaN stands for what does not exist.
    pub fn numbers(self, sample: &Sample) -> Vec<f64> {
        let (.., numbers) = self.description();
        numbers(sample)
    }
}

fn parts(z: Complex<f64>) -> Vec<f64> {
    vec![z.re, z.im]
}
