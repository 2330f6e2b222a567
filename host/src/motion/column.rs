//! Columns of samples: names, unit and numbers of a quantity.

use super::euler_angles;
use super::sample::{Quantities, Sample};
use toytop::{Complex, Support};

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

/// Function that writes the numbers of a column.
type Write = fn(&dyn Quantities, &mut [f64]);

/// Key of JSON, names of the numbers as columns of CSV, unit in SI, and the numbers. NaN stands for what does not exist.
type Description = (&'static str, &'static [&'static str], &'static str, Write);

impl SampleColumn {
    fn description(self) -> Description {
        match self {
            Self::T => ("t", &["t"], "s", |at, row| row[0] = at.t()),
            Self::U => ("u", &["u"], "", |at, row| row[0] = at.pose().u),
            Self::Udot => ("udot", &["udot"], "1/s", |at, row| row[0] = at.udot()),
            Self::Alpha => {
                ("alpha", &["alpha_re", "alpha_im"], "", |at, row| put(row, at.orientation().alpha))
            }
            Self::Beta => ("beta", &["beta_re", "beta_im"], "", |at, row| put(row, at.orientation().beta)),
            Self::Gamma => {
                ("gamma", &["gamma_re", "gamma_im"], "", |at, row| put(row, at.orientation().gamma()))
            }
            Self::Delta => {
                ("delta", &["delta_re", "delta_im"], "", |at, row| put(row, at.orientation().delta()))
            }
            Self::Omega => ("omega", &["omega_x", "omega_y", "omega_z"], "rad/s", |at, row| {
                row.copy_from_slice(&at.omega())
            }),
            Self::Tip => ("tip", &["tip_x", "tip_y"], "m", |at, row| put(row, at.pose().tip)),
            Self::Phi => ("phi", &["phi"], "rad", |at, row| row[0] = at.tip_angle().unwrap_or(f64::NAN)),
            Self::Quaternion => ("quaternion", &["w", "x", "y", "z"], "", |at, row| {
                row.copy_from_slice(&at.orientation().quaternion())
            }),
            Self::Axis => ("axis", &["axis_x", "axis_y", "axis_z"], "", |at, row| {
                let pose = at.pose();
                let [x, y, _] = pose.orientation.axis();
                row.copy_from_slice(&[x, y, pose.u]);
            }),
            Self::OmegaBody => {
                ("omega_body", &["wx", "wy", "wz"], "rad/s", |at, row| row.copy_from_slice(&at.omega_body()))
            }
            Self::Angles => ("angles", &["tilt", "azimuth", "roll"], "rad", |at, row| {
                row.copy_from_slice(&euler_angles::tilt_azimuth_roll(&at.orientation()))
            }),
            Self::EulerZxz => ("euler_zxz", &["euler_phi", "euler_theta", "euler_psi"], "rad", |at, row| {
                row.copy_from_slice(&euler_angles::zxz(&at.orientation()))
            }),
            Self::ErrorBound => ("error_bound", &["error_bound"], "rad", |at, row| {
                row[0] = at.error_bound().unwrap_or(f64::NAN)
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
            (_, _, "m", _) if support != Support::Sliding => "",
            (_, _, unit, _) => unit,
        }
    }

    /// Writes its numbers at several times, one row for each.
    pub fn fill<Q: Quantities>(self, times: impl Iterator<Item = Q>, rows: &mut [f64]) {
        let (_, names, _, write) = self.description();
        times.zip(rows.chunks_exact_mut(names.len())).for_each(|(quantities, row)| write(&quantities, row));
    }

    /// Numbers of a sample.
    pub fn numbers_of(self, sample: &Sample) -> Vec<f64> {
        let mut row = vec![f64::NAN; self.names().len()];
        self.fill(std::iter::once(*sample), &mut row);
        row
    }
}

fn put(row: &mut [f64], z: Complex<f64>) {
    row.copy_from_slice(&[z.re, z.im]);
}
