//! Columns of samples: names, unit and numbers of a quantity.

use super::euler_angles;
use super::sample::Sample;
use toytop::{Complex, Pose, Support};
use toytop_model::equations::BodyRates;

/// Quantity of a sample, one number or several.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
#[value(rename_all = "snake_case")]
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

/// Numbers of a column, from the part of a sample that they need.
pub enum Numbers {
    /// Numbers of orientation, u and tip.
    OfPose(fn(&Pose<f64, f64>, &mut [f64])),
    /// Numbers of the rates.
    OfRates(fn(&BodyRates, &mut [f64])),
    /// Numbers of a whole sample.
    OfSample(fn(&Sample, &mut [f64])),
}

use Numbers::{OfPose, OfRates, OfSample};

/// Key of JSON, names of the numbers as columns of CSV, unit in SI, and the numbers. NaN stands for what does not exist.
type Description = (&'static str, &'static [&'static str], &'static str, Numbers);

impl SampleColumn {
    fn description(self) -> Description {
        match self {
            Self::T => ("t", &["t"], "s", OfSample(|sample, row| row[0] = sample.t)),
            Self::U => ("u", &["u"], "", OfPose(|pose, row| row[0] = pose.u)),
            Self::Udot => ("udot", &["udot"], "1/s", OfRates(|rates, row| row[0] = rates.udot)),
            Self::Alpha => {
                ("alpha", &["alpha_re", "alpha_im"], "", OfPose(|pose, row| put(row, pose.orientation.alpha)))
            }
            Self::Beta => {
                ("beta", &["beta_re", "beta_im"], "", OfPose(|pose, row| put(row, pose.orientation.beta)))
            }
            Self::Gamma => (
                "gamma",
                &["gamma_re", "gamma_im"],
                "",
                OfPose(|pose, row| put(row, pose.orientation.gamma())),
            ),
            Self::Delta => (
                "delta",
                &["delta_re", "delta_im"],
                "",
                OfPose(|pose, row| put(row, pose.orientation.delta())),
            ),
            Self::Omega => (
                "omega",
                &["omega_x", "omega_y", "omega_z"],
                "rad/s",
                OfRates(|rates, row| row.copy_from_slice(&rates.omega)),
            ),
            Self::Tip => ("tip", &["tip_x", "tip_y"], "m", OfPose(|pose, row| put(row, pose.tip))),
            Self::Phi => (
                "phi",
                &["phi"],
                "rad",
                OfSample(|sample, row| row[0] = sample.tip_angle.unwrap_or(f64::NAN)),
            ),
            Self::Quaternion => (
                "quaternion",
                &["w", "x", "y", "z"],
                "",
                OfPose(|pose, row| row.copy_from_slice(&pose.orientation.quaternion())),
            ),
            Self::Axis => (
                "axis",
                &["axis_x", "axis_y", "axis_z"],
                "",
                OfPose(|pose, row| {
                    let [x, y, _] = pose.orientation.axis();
                    row.copy_from_slice(&[x, y, pose.u]);
                }),
            ),
            Self::OmegaBody => (
                "omega_body",
                &["wx", "wy", "wz"],
                "rad/s",
                OfRates(|rates, row| row.copy_from_slice(&rates.omega_body)),
            ),
            Self::Angles => (
                "angles",
                &["tilt", "azimuth", "roll"],
                "rad",
                OfPose(|pose, row| row.copy_from_slice(&euler_angles::tilt_azimuth_roll(&pose.orientation))),
            ),
            Self::EulerZxz => (
                "euler_zxz",
                &["euler_phi", "euler_theta", "euler_psi"],
                "rad",
                OfPose(|pose, row| row.copy_from_slice(&euler_angles::zxz(&pose.orientation))),
            ),
            Self::ErrorBound => (
                "error_bound",
                &["error_bound"],
                "rad",
                OfSample(|sample, row| row[0] = sample.error_bound.unwrap_or(f64::NAN)),
            ),
        }
    }

    /// Key of JSON, and names of its numbers as columns of CSV.
    pub fn names(self) -> (&'static str, &'static [&'static str]) {
        let (key, names, ..) = self.description();
        (key, names)
    }

    /// Unit of its numbers in SI; empty where there is none.
    pub fn si_unit(self, support: Support) -> &'static str {
        match self.description() {
            (_, _, "m", _) if support != Support::Sliding => "",
            (_, _, unit, _) => unit,
        }
    }

    /// Numbers, from the part of a sample that they need.
    pub fn numbers(self) -> Numbers {
        let (.., numbers) = self.description();
        numbers
    }

    /// Numbers of a sample.
    pub fn numbers_of(self, sample: &Sample) -> Vec<f64> {
        let mut row = vec![f64::NAN; self.names().1.len()];
        match self.numbers() {
            OfPose(write) => write(&sample.pose, &mut row),
            OfRates(write) => write(&sample.rates, &mut row),
            OfSample(write) => write(sample, &mut row),
        }
        row
    }
}

fn put(row: &mut [f64], z: Complex<f64>) {
    row.copy_from_slice(&[z.re, z.im]);
}
