//! First guesses of a launch from the first measurements, without iteration.
//!
//! Two directions, or a camera, give the orientation at each instant; a single direction leaves the yaw open, and the
//! axis alone the roll. The rate about the axis is beyond the range of most gyroscopes. It then follows from two
//! orientations or from the circle that a direction draws in the body; otherwise several rates are tried.

use crate::complex::Complex;
use crate::fit::Fit;
use crate::fit::instruments::rotation_vector;
use crate::fit::launch::Launch;
use crate::fit::sensor::{Hint, Measurement};
use crate::scalar::Real;
use crate::sensitivity::total;
use crate::su2::{Orientation, Vector, bracket, dot};

/// Number of instants in the first window; the others are each four times as long.
pub(super) const FIRST_WINDOW: usize = 16;
/// Largest number of guesses.
const MOST_GUESSES: usize = 24;
/// Number of rates about the axis that are tried on each side of 0, where the measurements do not determine the rate.
const TRIED: usize = 12;

/// State of the motion at one instant.
#[derive(Clone, Copy, Debug, Default)]
struct Instant {
    time: f64,
    /// Directions in the fixed frame and in the body frame, unit vectors.
    directions: [Option<[Vector<f64>; 2]>; 2],
    rate: Option<(Vector<f64>, bool)>,
    orientation: Option<Orientation<f64>>,
    axis: Option<Vector<f64>>,
}

/// First guesses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beginning {
    /// Orientation and ω of each, in a scalar that takes less of the stack.
    guesses: [(Orientation<f32>, Vector<f32>); MOST_GUESSES],
    count: usize,
}

impl Beginning {
    /// Guesses from the first instants.
    #[inline(never)] // the instants are on the stack while it works only
    pub(super) fn of<F: Real, I>(fit: &Fit<'_, F>, measurements: &I) -> Self
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut instants = [Instant::default(); FIRST_WINDOW];
        let mut count = 0_usize;
        for measurement in measurements.clone() {
            let last = count.checked_sub(1).and_then(|index| instants.get(index)).map(|instant| instant.time);
            if last != Some(measurement.time) {
                if count == FIRST_WINDOW {
                    break;
                }
                count += 1;
            }
            if let Some(instant) = instants.get_mut(count.wrapping_sub(1)) {
                instant.time = measurement.time;
                instant.learn(fit.hint(&measurement));
            }
        }
        let mut beginning = Self { guesses: [(Orientation::IDENTITY, [0.0; 3]); MOST_GUESSES], count: 0 };
        beginning.guess(instants.get(..count).unwrap_or(&[]));
        beginning
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    pub(super) fn is_ambiguous(&self) -> bool {
        self.count > 1
    }

    pub(super) fn guesses(&self) -> impl Iterator<Item = Launch> {
        let wide = |z: Complex<f32>| Complex::new(f64::from(z.re), f64::from(z.im));
        self.guesses.iter().take(self.count).map(move |(Orientation { alpha, beta }, omega)| {
            let orientation = Orientation { alpha: wide(*alpha), beta: wide(*beta) };
            Launch::new(orientation.normalised(), omega.map(f64::from))
        })
    }

    fn add(&mut self, orientation: Orientation<f64>, omega: Vector<f64>) {
        if let Some(slot) = self.guesses.get_mut(self.count) {
            let narrow = |z: Complex<f64>| Complex::new(z.re as f32, z.im as f32);
            let Orientation { alpha, beta } = orientation;
            *slot = (Orientation { alpha: narrow(alpha), beta: narrow(beta) }, omega.map(|x| x as f32));
            self.count += 1;
        }
    }

    fn guess(&mut self, instants: &[Instant]) {
        let Some(first) = instants.iter().find(|instant| instant.is_oriented()) else { return };
        let Some(begun) = instants.first() else { return };
        let lead = begun.time - first.time;
        if let Some(orientation) = first.attitude() {
            let rate = instants.iter().find_map(|instant| instant.rate);
            let turned = mean_rate(instants);
            let omega = match (rate, turned) {
                (Some(([x, y, _], true)), Some([.., axial])) => [x, y, axial],
                (Some(([x, y, low], true)), None) => {
                    let Some(axial) = circling(instants, low) else { return };
                    [x, y, axial]
                }
                (Some((omega, false)), _) => omega,
                (None, Some(omega)) => omega,
                (None, None) => return,
            };
            // back to the first measurement of all
            let orientation = orientation.compose(&Orientation::exp(omega.map(|x| x * lead)));
            self.add(orientation, orientation.adjoint(omega));
            return;
        }
        self.guess_from_axis(instants);
    }

    /// Guesses from the axis alone: its rate from the first and a later instant, and all rates about it.
    fn guess_from_axis(&mut self, instants: &[Instant]) {
        let mut seen = instants.iter().filter_map(|instant| Some((instant.time, instant.axis?)));
        let (Some((start, axis)), Some((end, later))) = (seen.next(), seen.nth(2)) else { return };
        let per_time = 1.0 / (end - start);
        let across = bracket(axis, later).map(|x| x * per_time);
        let orientation = upright_to(axis);
        let fastest = 2.0 * per_time;
        for k in 0..TRIED {
            let magnitude = fastest * libm::exp2(1.0 - k as f64 * 0.75);
            for spin in [magnitude, -magnitude] {
                self.add(orientation, total(across, axis, spin));
            }
        }
    }
}

impl Instant {
    fn learn(&mut self, hint: Hint) {
        let unit = |x: Vector<f64>| {
            let length = libm::sqrt(dot(x, x));
            (length > 0.0).then(|| x.map(|component| component / length))
        };
        match hint {
            Hint::None => {}
            Hint::Rate { omega, axial_is_saturated } => self.rate = Some((omega, axial_is_saturated)),
            Hint::Direction { fixed, body } => {
                if let Some(free) = self.directions.iter_mut().find(|slot| slot.is_none())
                    && let (Some(fixed), Some(body)) = (unit(fixed), unit(body))
                {
                    *free = Some([fixed, body]);
                }
            }
            Hint::Orientation(orientation) => self.orientation = Some(orientation),
            Hint::Axis(axis) => self.axis = Some(axis),
        }
    }

    fn is_oriented(&self) -> bool {
        self.attitude().is_some() || self.axis.is_some()
    }

    /// Orientation, if it is fully determined.
    fn full_attitude(&self) -> Option<Orientation<f64>> {
        if self.orientation.is_some() {
            return self.orientation;
        }
        let [Some([fixed, body]), Some([second_fixed, second_body])] = self.directions else { return None };
        let frame = |x: Vector<f64>, y: Vector<f64>| {
            let across = bracket(x, y);
            let length = libm::sqrt(dot(across, across));
            (length > 1e-3).then(|| from_frame(x, across.map(|c| c / length)))
        };
        let (in_fixed, in_body) = (frame(fixed, second_fixed)?, frame(body, second_body)?);
        Some(in_fixed.compose(&in_body.inverse()))
    }

    /// Orientation; with an arbitrary rotation about the direction where there is only one.
    fn attitude(&self) -> Option<Orientation<f64>> {
        self.full_attitude().or_else(|| {
            let [Some([fixed, body]), _] = self.directions else { return None };
            Some(upright_to(fixed).compose(&upright_to(body).inverse()))
        })
    }
}

/// Orientation whose third and first axes are these unit vectors.
fn from_frame(third: Vector<f64>, first: Vector<f64>) -> Orientation<f64> {
    let tilt = upright_to(third);
    // rotation about the third axis that brings the first one home
    let [x, y, _] = tilt.inverse().adjoint(first);
    let half = 0.5 * libm::atan2(y, x);
    tilt.compose(&Orientation::from_quaternion([libm::cos(half), 0.0, 0.0, libm::sin(half)]))
}

/// Smallest rotation that takes the vertical to this unit vector.
pub(super) fn upright_to([x, y, z]: Vector<f64>) -> Orientation<f64> {
    // below -1 + 1e-12 any horizontal axis serves
    if z < -1.0 + 1e-12 {
        return Orientation::from_quaternion([0.0, 1.0, 0.0, 0.0]);
    }
    Orientation::from_quaternion([1.0 + z, -y, x, 0.0]).normalised()
}

/// Angular velocity in the body frame from the orientations. The component along the axis is the mean over all; the
/// others are those of the first instants.
fn mean_rate(instants: &[Instant]) -> Option<Vector<f64>> {
    let mut known = instants.iter().filter_map(|instant| Some((instant.time, instant.full_attitude()?)));
    let (mut time, mut orientation) = known.next()?;
    let start = time;
    let mut along = 0.0;
    let mut across: Option<(f64, f64)> = None;
    for (next_time, next) in known {
        let [x, y, z] = rotation_vector(&orientation.inverse().compose(&next));
        let per_time = 1.0 / (next_time - time);
        along += z;
        across = across.or(Some((x * per_time, y * per_time)));
        (time, orientation) = (next_time, next);
    }
    let (x, y) = across?;
    Some([x, y, along / (time - start)])
}

/// Rate about the axis from the circle that a direction draws in the body, with the sign of `bound`.
///
/// For K = Φ⁻¹ k and z = K₁ + i K₂ the motion gives z' = -iΩ₃ z + i K₃ (Ω₁ + i Ω₂).
fn circling(instants: &[Instant], bound: f64) -> Option<f64> {
    const PLACES: u32 = 720;
    let step = |pair: &[Instant]| -> Option<[f64; 7]> {
        let [before, after] = pair else { return None };
        let ([Some([_, k]), _], [Some([_, next]), _]) = (before.directions, after.directions) else {
            return None;
        };
        let ((w, _), (w_next, _)) = (before.rate?, after.rate?);
        let ([k1, k2, k3], [n1, n2, n3], [x, y, _], [x2, y2, _]) = (k, next, w, w_next);
        let half = 0.25 * (k3 + n3) * (after.time - before.time);
        Some([after.time - before.time, k1, k2, n1, n2, -half * (y + y2), half * (x + x2)])
    };
    let mismatch = |rate: f64| {
        let mut sum = 0.0;
        for [dt, k1, k2, n1, n2, p, q] in instants.windows(2).filter_map(step) {
            let (sine, cosine) = libm::sincos(0.5 * rate * dt);
            // e^{iφ/2} z_next - e^{-iφ/2} z - forcing
            let re = (cosine * n1 - sine * n2) - (cosine * k1 + sine * k2) - p;
            let im = (cosine * n2 + sine * n1) - (cosine * k2 - sine * k1) - q;
            sum += re * re + im * im;
        }
        sum
    };
    let [dt, ..] = instants.windows(2).find_map(step)?;
    let fastest = core::f64::consts::PI / libm::fabs(dt);
    let mut best = (f64::INFINITY, 0.0);
    for place in 1..PLACES {
        let magnitude = fastest * f64::from(place) / f64::from(PLACES);
        let rate = if bound < 0.0 { -magnitude } else { magnitude };
        let value = mismatch(rate);
        if magnitude >= 0.9 * libm::fabs(bound) && value < best.0 {
            best = (value, rate);
        }
    }
    let (_, rate) = best;
    (rate != 0.0).then_some(rate)
}
