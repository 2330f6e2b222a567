//! Result of a fit. Its field names are the keys of JSON; the report, CSV and Python use them too.

use super::fit::{Estimated, FitResult};
use serde::{Serialize, Serializer};
use toytop_fit::Sensitivity;

/// Numbers of a fit. Their names are the keys of JSON.
#[derive(Serialize)]
pub struct FitSummary<'a> {
    /// Whether the launch may be trusted.
    pub converged: bool,
    /// Reason why it must not be trusted.
    pub reason: Option<&'a str>,
    /// Time of the launch among the samples, s.
    pub epoch: f64,
    /// Unit quaternion w, x, y, z from body to fixed coordinates.
    pub quaternion: [f64; 4],
    /// Standard deviations of the rotation vector of the orientation in the fixed frame, rad.
    pub orientation_deviation: [f64; 3],
    /// Angular velocity in the fixed frame, rad/s.
    pub omega: [f64; 3],
    /// Standard deviations of the angular velocity, rad/s, in a frame that turns with the error of the orientation.
    pub omega_deviation: [f64; 3],
    /// Component of the angular velocity along the axis, rad/s.
    pub spin: f64,
    /// Its standard deviation, rad/s.
    pub spin_deviation: f64,
    /// Angle of the axis from the upward vertical, degrees.
    pub tilt_deg: f64,
    /// Its standard deviation, degrees.
    pub tilt_deviation_deg: f64,
    /// Free numbers of the top by their keys, in their order.
    #[serde(serialize_with = "as_map")]
    pub free: Vec<(&'a str, Estimated<f64>)>,
    /// Biases by sensor, in their order.
    #[serde(serialize_with = "as_map")]
    pub biases: Vec<(&'static str, Estimated<[f64; 3]>)>,
    /// Losses of rotation and the drift that they cause, if they were fitted.
    pub drift: Option<DriftSummary>,
    /// Covariance of the unknowns by rows.
    pub covariance: Vec<Vec<f64>>,
    /// Unknowns of the covariance.
    pub covariance_of: &'static str,
    /// Sum of squares by degrees of freedom.
    pub reduced_chi_squared: f64,
    /// Sum of the squares of the residuals in standard deviations; an outlier counts as the limit.
    pub chi_squared: f64,
    /// Number of values that were used.
    pub used: u32,
    /// Number of values at the end of their range, which were not used.
    pub saturated: u32,
    /// Number of values beyond the Huber limit.
    pub outliers: u32,
    /// Largest residual, standard deviations.
    pub largest_residual: f64,
    /// Directions of the launch that the samples do not determine.
    pub undetermined: Vec<&'static str>,
    /// Number of other launches that fit the first samples as well.
    pub alternatives: usize,
    /// Predictions up to ten seconds after the samples.
    pub prediction: Vec<Prediction>,
}

/// Mean drift of l, n and h during the samples, with the losses that cause it.
#[derive(Serialize)]
pub struct DriftSummary {
    /// Standard deviations of the rates.
    pub deviation: [f64; 3],
    /// Losses of rotation about the axis, across it and about the vertical, 1/s.
    pub losses: [f64; 3],
    /// Mean rates of l and n, N m, and of h, W.
    pub rates: [f64; 3],
}

/// Error bars of the motion at a time after the samples.
#[derive(Serialize)]
pub struct Prediction {
    /// Standard deviation of the axis, rad.
    pub axis_rad: f64,
    /// Standard deviation of the orientation, rad.
    pub orientation_rad: f64,
    /// Time, s.
    pub t: f64,
}

/// Unknowns of the covariance.
const UNKNOWNS: &str = "rotation vector delta of the orientation in the fixed frame, change of omega in the frame that delta turns, others";

impl<'a> FitSummary<'a> {
    /// Numbers of a fit by name.
    pub fn new(fit: &'a FitResult) -> Self {
        let fitted = &fit.fitted;
        let (launch, statistics, count) = (&fitted.launch, &fitted.statistics, fitted.unknown_count);
        let [d0, d1, d2, d3, d4, d5, ..] = fitted.deviations();
        let [spin, tilt] = fit.spin_and_tilt();
        let drift = fitted.drift.as_ref().map(|drift| DriftSummary {
            deviation: drift.deviations(),
            losses: drift.losses,
            rates: drift.rates,
        });
        let covariance = |i| (0..count).filter_map(|j| fitted.covariance(i, j)).collect();
        Self {
            converged: fitted.is_trusted(),
            reason: fit.reason.as_deref(),
            epoch: fitted.launch_time,
            quaternion: launch.orientation.quaternion(),
            orientation_deviation: [d0, d1, d2],
            omega: launch.omega,
            omega_deviation: [d3, d4, d5],
            spin: spin.value,
            spin_deviation: spin.deviation,
            tilt_deg: tilt.value.to_degrees(),
            tilt_deviation_deg: tilt.deviation.to_degrees(),
            free: fit.free_values(),
            biases: fit.biases(),
            drift,
            covariance: (0..count).map(covariance).collect(),
            covariance_of: UNKNOWNS,
            reduced_chi_squared: statistics.reduced_chi_squared(count),
            chi_squared: statistics.chi_squared,
            used: statistics.used,
            saturated: statistics.unused,
            outliers: statistics.outliers,
            largest_residual: statistics.largest,
            undetermined: fit.undetermined(),
            alternatives: fitted.other_launch_count,
            prediction: Prediction::all(fit),
        }
    }
}

impl Prediction {
    /// Predictions up to ten seconds after the samples; none where there is no launch.
    fn all(fit: &FitResult) -> Vec<Self> {
        const AHEAD: [f64; 5] = [0.0, 1.0, 2.0, 5.0, 10.0];
        let motion = fit.fitted.motion().ok().filter(|_| fit.used_any_sample());
        let Some(sensitivity) = motion.map(|motion| Sensitivity::new(&motion)) else { return Vec::new() };
        let at = |ahead: &f64| {
            let t = fit.end + ahead;
            let [orientation_rad, axis_rad] = fit.predicted(&sensitivity.at(t - fit.fitted.launch_time)?);
            Some(Self { axis_rad, orientation_rad, t })
        };
        AHEAD.iter().filter_map(at).collect()
    }
}

fn as_map<T: Serialize, S: Serializer>(pairs: &[(&str, T)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(key, value)| (key, value)))
}
