//! Columns of samples: names, unit and numbers of a quantity.

use super::euler_angles;
use super::sample::{Part, Sample};
use toytop::{Complex, Support};

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
        Self::Phi,
        Self::ErrorBound,
    ];
}

/// Function that writes the numbers of a column of a sample. NaN stands for what does not exist.
pub type Writer = fn(&Sample, &mut [f64]);

/// Key of JSON, names of the numbers as columns of CSV, unit in SI, part of the sample that is read, and function that writes the numbers.
type Description = (&'static str, &'static [&'static str], &'static str, Part, Writer);

impl SampleColumn {
    fn description(self) -> Description {
        use Part::{All, ErrorBound, Omega, OmegaBody, Orientation, Pose, TipAngle, Udot};
        match self {
            Self::T => ("t", &["t"], "s", All, |at, row| row[0] = at.t),
            Self::U => ("u", &["u"], "", Pose, |at, row| row[0] = at.pose.u),
            Self::Udot => ("udot", &["udot"], "1/s", Udot, |at, row| row[0] = at.rates.udot),
            Self::Alpha => ("alpha", &["alpha_re", "alpha_im"], "", Orientation, |at, row| {
                put(row, at.pose.orientation.alpha)
            }),
            Self::Beta => ("beta", &["beta_re", "beta_im"], "", Orientation, |at, row| {
                put(row, at.pose.orientation.beta)
            }),
            Self::Gamma => ("gamma", &["gamma_re", "gamma_im"], "", Orientation, |at, row| {
                put(row, at.pose.orientation.gamma())
            }),
            Self::Delta => ("delta", &["delta_re", "delta_im"], "", Orientation, |at, row| {
                put(row, at.pose.orientation.delta())
            }),
            Self::Omega => ("omega", &["omega_x", "omega_y", "omega_z"], "rad/s", Omega, |at, row| {
                row.copy_from_slice(&at.rates.omega)
            }),
            Self::Tip => ("tip", &["tip_x", "tip_y"], "m", Pose, |at, row| put(row, at.pose.tip)),
            Self::Phi => {
                ("phi", &["phi"], "rad", TipAngle, |at, row| row[0] = at.tip_angle.unwrap_or(f64::NAN))
            }
            Self::Quaternion => ("quaternion", &["w", "x", "y", "z"], "", Orientation, |at, row| {
                row.copy_from_slice(&at.pose.orientation.quaternion())
            }),
            Self::Axis => ("axis", &["axis_x", "axis_y", "axis_z"], "", Pose, |at, row| {
                let [x, y, _] = at.pose.orientation.axis();
                row.copy_from_slice(&[x, y, at.pose.u]);
            }),
            Self::OmegaBody => ("omega_body", &["wx", "wy", "wz"], "rad/s", OmegaBody, |at, row| {
                row.copy_from_slice(&at.rates.omega_body)
            }),
            Self::Angles => ("angles", &["tilt", "azimuth", "roll"], "rad", Orientation, |at, row| {
                row.copy_from_slice(&euler_angles::tilt_azimuth_roll(&at.pose.orientation))
            }),
            Self::EulerZxz => {
                ("euler_zxz", &["euler_phi", "euler_theta", "euler_psi"], "rad", Orientation, |at, row| {
                    row.copy_from_slice(&euler_angles::zxz(&at.pose.orientation))
                })
            }
            Self::ErrorBound => ("error_bound", &["error_bound"], "rad", ErrorBound, |at, row| {
                row[0] = at.error_bound.unwrap_or(f64::NAN)
            }),
        }
    }

    /// Key of JSON.
    pub fn key(self) -> &'static str {
        self.description().0
    }

    /// Names of its numbers as columns of CSV.
    pub fn names(self) -> &'static [&'static str] {
        self.description().1
    }

    /// Unit of its numbers in SI; empty where there is none.
    pub fn si_unit(self, support: Support) -> &'static str {
        match self.description() {
            (_, _, "m", ..) if support != Support::Sliding => "",
            (_, _, unit, ..) => unit,
        }
    }

    /// Part of a sample that it reads.
    pub fn part(self) -> Part {
        self.description().3
    }

    /// Function that writes the numbers of a sample into a row of as many numbers as it has names.
    pub fn writer(self) -> Writer {
        self.description().4
    }

    /// Numbers of a sample.
    pub fn numbers(self, sample: &Sample) -> Vec<f64> {
        let mut row = vec![f64::NAN; self.names().len()];
        self.writer()(sample, &mut row);
        row
    }
}

fn put(row: &mut [f64], z: Complex<f64>) {
    row.copy_from_slice(&[z.re, z.im]);
}
