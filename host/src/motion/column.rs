//! Columns of samples: names, unit and numbers of a quantity.

use super::euler_angles;
use super::sample::MotionSample;
use toytop::{Complex, Support};
use toytop_model::constants::Unit::{self, Any, Si};

/// Quantity of a sample, one number or several.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum), value(rename_all = "snake_case"))]
pub enum SampleColumn {
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
    #[cfg_attr(feature = "program", value(name = "phi"))]
    TipAngle,
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

impl SampleColumn {
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
        Self::TipAngle,
        Self::ErrorBound,
    ];
}

/// Key of JSON, names of the numbers as columns of CSV, and their unit.
type Description = (&'static str, &'static [&'static str], Unit);

impl SampleColumn {
    fn description(self) -> Description {
        match self {
            Self::T => ("t", &["t"], Si("s")),
            Self::U => ("u", &["u"], Any("")),
            Self::Udot => ("udot", &["udot"], Si("1/s")),
            Self::Alpha => ("alpha", &["alpha_re", "alpha_im"], Any("")),
            Self::Beta => ("beta", &["beta_re", "beta_im"], Any("")),
            Self::Gamma => ("gamma", &["gamma_re", "gamma_im"], Any("")),
            Self::Delta => ("delta", &["delta_re", "delta_im"], Any("")),
            Self::Omega => ("omega", &["omega_x", "omega_y", "omega_z"], Si("rad/s")),
            Self::Tip => ("tip", &["tip_x", "tip_y"], Si("m")),
            Self::TipAngle => ("phi", &["phi"], Any("rad")),
            Self::Quaternion => ("quaternion", &["w", "x", "y", "z"], Any("")),
            Self::Axis => ("axis", &["axis_x", "axis_y", "axis_z"], Any("")),
            Self::OmegaBody => ("omega_body", &["wx", "wy", "wz"], Si("rad/s")),
            Self::Angles => ("angles", &["tilt", "azimuth", "roll"], Any("rad")),
            Self::EulerZxz => ("euler_zxz", &["euler_phi", "euler_theta", "euler_psi"], Any("rad")),
            Self::ErrorBound => ("error_bound", &["error_bound"], Any("rad")),
        }
    }

    /// Writes its numbers into a row of as many numbers as it has names. NaN stands for a number that does not exist.
    #[inline]
    pub fn write(self, sample: &MotionSample, row: &mut [f64]) {
        let mut put = |numbers: &[f64]| row.copy_from_slice(numbers);
        let parts = |z: Complex<f64>| [z.re, z.im];
        let MotionSample { t, orientation, u, tip, rates, tip_angle, error_bound } = sample;
        match self {
            Self::T => put(&[*t]),
            Self::U => put(&[*u]),
            Self::Udot => put(&[rates.udot]),
            Self::Alpha => put(&parts(orientation.alpha)),
            Self::Beta => put(&parts(orientation.beta)),
            Self::Gamma => put(&parts(orientation.gamma())),
            Self::Delta => put(&parts(orientation.delta())),
            Self::Omega => put(&rates.omega),
            Self::Tip => put(&parts(*tip)),
            Self::TipAngle => put(&[tip_angle.unwrap_or(f64::NAN)]),
            Self::Quaternion => put(&orientation.quaternion()),
            Self::Axis => {
                let [x, y, _] = orientation.axis();
                put(&[x, y, *u]);
            }
            Self::OmegaBody => put(&rates.omega_body),
            Self::Angles => put(&euler_angles::tilt_azimuth_roll(orientation)),
            Self::EulerZxz => put(&euler_angles::zxz(orientation)),
            Self::ErrorBound => put(&[error_bound.unwrap_or(f64::NAN)]),
        }
    }

    /// Key of JSON.
    pub fn key(self) -> &'static str {
        let (key, ..) = self.description();
        key
    }

    /// Names of its numbers as columns of CSV.
    pub fn names(self) -> &'static [&'static str] {
        let (_, names, _) = self.description();
        names
    }

    /// Unit of its numbers.
    pub fn unit(self, support: Support) -> Unit {
        match self {
            Self::Tip if support != Support::Sliding => Any(""),
            _ => {
                let (.., unit) = self.description();
                unit
            }
        }
    }

    /// Numbers of a sample.
    pub fn numbers(self, sample: &MotionSample) -> Vec<f64> {
        let mut row = vec![f64::NAN; self.names().len()];
        self.write(sample, &mut row);
        row
    }
}
