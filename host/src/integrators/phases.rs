//! Phase errors of a trajectory for nutation, precession and spin.
//!
//! An exact motion is a function of three angles on a torus, which advance at constant rates: the nutation phase θ (one turn in a nutation
//! period), the mean azimuth ψ of the axis and the mean rotation φ of the body about it. The orientation at other angles is
//!
//! ```text
//! Φ(θ + Δθ, ψ + Δψ, φ + Δφ):   α(t + τ) exp(i(Δψ + Δφ)/2 - i λ_α' τ),   β(t + τ) exp(i(Δψ - Δφ)/2 - i λ_β' τ),   τ = Δθ T/2π
//! ```
//!
//! with the mean rates λ_α' and λ_β' of arg α and arg β. The phase errors Δθ, Δψ and Δφ are fitted by least squares over one period, each as
//! offset + slope. The distance that remains is no phase error: the trajectory is on another torus, with other values of l, n and h.

use super::trajectory::TrajectoryRow;
use crate::motion::errors::rotation_between;
use crate::motion::evaluator::MotionEvaluator;
use nalgebra::{Matrix3, Matrix6, SMatrix, Vector3, Vector6};
use serde::Serialize;
use std::f64::consts::PI;
use toytop::{Complex, Orientation, Regime};

/// Phase errors of a trajectory over some rows, above 0 where it is ahead of the motion.
#[derive(Default, Serialize)]
pub struct PhaseErrors {
    /// Nutation phase error Δθ, rad; `None` where the axis does not nutate.
    pub nutation_error_rad: Option<f64>,
    /// Precession phase error Δψ, rad; `None` where the axis is vertical.
    pub precession_error_rad: Option<f64>,
    /// Spin phase error Δφ, rad; where the axis is vertical, the phase error of the whole rotation.
    pub spin_error_rad: Option<f64>,
    /// Root of the mean square of the rotation that remains after the phase errors are removed, rad.
    pub residual_rad: Option<f64>,
}

/// Least number of rows of a fit.
const MIN_ROWS: usize = 8;

/// Phase errors in the middle of the last nutation period, or of the last eight rows if these take longer; none for an aperiodic motion.
///
/// The fit goes through all periods, so that it recognises errors of more than half a turn.
pub fn phase_errors(evaluator: &MotionEvaluator, rows: &[TrajectoryRow]) -> PhaseErrors {
    let motion = &evaluator.motion;
    let exist = match motion.regime() {
        Regime::Nutating => [true; 3],
        Regime::Aperiodic => return PhaseErrors::default(),
        regime if regime.is_vertical() => [false, false, true],
        _ => [false, true, true],
    };
    let period = motion.characteristic_time();
    let rates = motion.advance().map_or([0.0; 3], |advance| {
        [advance.alpha_turns, advance.beta_turns, 1.0].map(|turns| 2.0 * PI * turns / period)
    });
    let fit = PhaseFit { evaluator, period, rates, exist };
    let (mut angles, mut residual) = (Vector6::zeros(), None);
    for window in fit.windows(rows) {
        // from the middle of one window to the middle of the next
        (0..3).for_each(|i| angles[i] += angles[i + 3]);
        (angles, residual) = fit.fit_rows(window, angles);
    }
    let angle = |i: usize| Some(angles[i]).filter(|_| exist[i] && residual.is_some());
    PhaseErrors {
        nutation_error_rad: angle(0),
        precession_error_rad: angle(1),
        spin_error_rad: angle(2),
        residual_rad: residual,
    }
}

/// Fit of phase errors to rows.
struct PhaseFit<'a> {
    evaluator: &'a MotionEvaluator,
    /// Time that a fit covers, s.
    period: f64,
    /// Mean rates of arg α, arg β and the nutation phase, rad/s.
    rates: [f64; 3],
    /// Whether θ, ψ and φ exist.
    exist: [bool; 3],
}

impl PhaseFit<'_> {
    /// Consecutive windows, counted from the last row.
    fn windows<'r>(&self, rows: &'r [TrajectoryRow]) -> Vec<&'r [TrajectoryRow]> {
        let mut windows = Vec::new();
        let mut rest = rows;
        while rest.len() >= MIN_ROWS {
            let last = rest[rest.len() - 1].t;
            let inside = rest.iter().rev().take_while(|row| (row.t - last).abs() <= self.period).count();
            let (before, window) = rest.split_at(rest.len() - inside.max(MIN_ROWS));
            windows.push(window);
            rest = before;
        }
        windows.reverse();
        windows
    }

    /// Angles in the middle of the rows with their change in a period, and the root of the mean square of the remaining rotation, by
    /// Gauss-Newton iteration. The change is fitted too; otherwise an error of a rate would appear as an error of another angle.
    fn fit_rows(&self, rows: &[TrajectoryRow], mut angles: Vector6<f64>) -> (Vector6<f64>, Option<f64>) {
        const MAX_STEPS: usize = 20;
        const SMALL_STEP: f64 = 1e-3;
        let middle = 0.5 * (rows[0].t + rows[rows.len() - 1].t);
        let fraction = |row: &TrajectoryRow| (row.t - middle) / self.period;
        let at = |angles: &Vector6<f64>, row: &TrajectoryRow| {
            let angles = angles.fixed_rows::<3>(0) + angles.fixed_rows::<3>(3) * fraction(row);
            self.linearised(row, &angles)
        };
        for _ in 0..MAX_STEPS {
            let (mut gram, mut right) = (Matrix6::zeros(), Vector6::zeros());
            for row in rows {
                let (slopes, left) = at(&angles, row);
                let both = SMatrix::<f64, 3, 6>::from_fn(|i, j| {
                    if j < 3 { slopes[(i, j)] } else { slopes[(i, j - 3)] * fraction(row) }
                });
                gram += both.transpose() * both;
                right += both.transpose() * left;
            }
            for i in (0..6).filter(|i| !self.exist[i % 3]) {
                gram[(i, i)] = 1.0;
            }
            let Some(factors) = gram.cholesky() else { return (angles, None) };
            let step = factors.solve(&right);
            angles += step;
            // after a small step, the remaining rotation is known to first order
            if step.amax() < SMALL_STEP {
                break;
            }
        }
        let squares = rows.iter().map(|row| at(&angles, row).1.norm_squared()).sum::<f64>();
        (angles, Some((squares / rows.len() as f64).sqrt()).filter(|x| x.is_finite()))
    }

    /// Rotation that each angle adds, rad per rad, as columns, and the rotation that remains, rad.
    fn linearised(&self, row: &TrajectoryRow, angles: &Vector3<f64>) -> (Matrix3<f64>, Vector3<f64>) {
        let [a_rate, b_rate, theta_rate] = self.rates;
        // t + τ is rounded; the rest of Δθ is taken into account to first order
        let t = if angles[0] == 0.0 { row.t } else { row.t + angles[0] / theta_rate };
        let shift = t - row.t;
        let exact = self.evaluator.at(t);
        let turned = |z: Complex<f64>, angle: f64| z * Complex::new(angle.cos(), angle.sin());
        let azimuth = angles[1] - (a_rate + b_rate) * shift;
        let roll = angles[2] - (a_rate - b_rate) * shift;
        let predicted = Orientation {
            alpha: turned(exact.orientation.alpha, 0.5 * (azimuth + roll)),
            beta: turned(exact.orientation.beta, 0.5 * (azimuth - roll)),
        };
        let (axis, up) = (Vector3::from(predicted.axis()), Vector3::z());
        let mut slopes = Matrix3::from_columns(&[Vector3::zeros(), Vector3::zeros(), axis]);
        let mut left = Vector3::from(rotation_between(&predicted, &row.orientation));
        if self.exist[1] {
            slopes.set_column(1, &up);
        }
        if self.exist[0] {
            // ω of the motion, turned by the azimuth, minus the contribution of the mean rotations
            let [x, y, z] = exact.rates.omega;
            let across = turned(Complex::new(x, y), azimuth);
            let omega = Vector3::new(across.re, across.im, z);
            let nutation = (omega - up * (a_rate + b_rate) - axis * (a_rate - b_rate)) / theta_rate;
            slopes.set_column(0, &nutation);
            left -= nutation * (angles[0] - shift * theta_rate);
        }
        (slopes, left)
    }
}
