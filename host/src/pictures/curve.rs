//! Curve of the tip, and the limits between which the axis and the tip stay.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::evaluator::MotionEvaluator;
use crate::pictures::{MAX_CYCLES, MotionSpan};
use toytop::{Motion, Support};
use toytop_model::motion_with_period::MotionWithPeriod;

/// Limit of the tilt.
pub struct TiltLimit {
    /// `lowest` (u = e₁), `highest` (u = e₂), `constant` (u = e₁ = e₂) or `horizontal` (u = 0).
    pub name: &'static str,
    /// Cosine u of the tilt, from -1 to 1.
    pub u: f64,
    /// Sine of the tilt.
    pub sine: f64,
}

impl TiltLimit {
    /// Lowest limit, then the highest; one limit where the tilt is constant, none where the axis is vertical at all times.
    pub fn all(motion: &Motion) -> Vec<Self> {
        let e = motion.branch_points();
        let limit = |name, u: f64, sine_squared: f64| Self {
            name,
            u: u.clamp(-1.0, 1.0),
            sine: sine_squared.max(0.0).sqrt(),
        };
        let lowest = limit("lowest", e.e1, e.one_plus_e1 * (2.0 - e.one_plus_e1));
        let highest = |name| limit(name, e.e2, (2.0 - e.one_minus_e2) * e.one_minus_e2);
        match motion.regime() {
            regime if regime.is_vertical() => Vec::new(),
            regime if regime.is_regular_precession() => vec![highest("constant")],
            _ => vec![lowest, highest("highest")],
        }
    }
}

/// Name and tilt, as in `lowest: tilt 45.57°`.
impl std::fmt::Display for TiltLimit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: tilt {:.2}°", self.name, self.u.acos().to_degrees())
    }
}

/// Curve of the tip (of the axis, if the tip is held) and the circles between which it stays.
pub struct TipCurve {
    /// Points (x, y), m (without unit for a fixed tip).
    pub points: Vec<[f64; 2]>,
    /// Radii s √(1 - u²) of the circles at e₁ and e₂, and at u = 0 if that is between them, with their limits; none where the tip stays
    /// at the centre.
    pub circles: Vec<(f64, TiltLimit)>,
}

impl TipCurve {
    /// Curve over about one turn of the tip around the centre.
    ///
    /// # Errors
    /// [`Failure::method`]: no table is large enough.
    pub fn new(motion: &MotionWithPeriod) -> Result<Self, Failure> {
        Ok(Self::over(&MotionSpan::new(MotionEvaluator::new(motion, Scalar::F64)?, None, MAX_CYCLES)?))
    }

    /// Curve over a span of time.
    pub fn over(span: &MotionSpan) -> Self {
        let motion = &span.evaluator.motion;
        let mut limits = TiltLimit::all(motion);
        // between e₁ and e₂ the axis is horizontal, which is the largest circle
        if let [low, high] = &limits[..]
            && low.u < 0.0
            && high.u > 0.0
        {
            limits.push(TiltLimit { name: "horizontal", u: 0.0, sine: 1.0 });
        }
        let circles: Vec<_> = limits
            .into_iter()
            .map(|limit| (motion.top().tip_scale() * limit.sine, limit))
            .filter(|(radius, _)| *radius > 0.0)
            .collect();
        // where the tip does not slide, the curve of the axis is drawn: -2αβ
        let sense = if motion.top().support() == Support::Sliding { 1.0 } else { -1.0 };
        let tip = |t: f64| {
            let c = span.at(t).tip;
            [sense * c.re, sense * c.im]
        };
        // rounding errors of a table are not drawn
        let points =
            if circles.is_empty() { vec![[0.0; 2]] } else { span.times_of_curve().map(tip).collect() };
        Self { points, circles }
    }

    /// Picture as SVG, without axes: the curve from its start, between its circles, with the second fixed axis upwards.
    pub fn svg(&self) -> String {
        const SIDE: f64 = 320.0;
        let radii = self.circles.iter().map(|(radius, _)| *radius);
        let largest = radii.clone().chain(self.points.iter().map(|[x, y]| x.hypot(*y))).fold(0.0, f64::max);
        let scale = if largest > 0.0 { 0.45 * SIDE / largest } else { 1.0 };
        let circles: String = radii
            .map(|radius| {
                format!(
                    r##"<circle cx="160" cy="160" r="{:.2}" fill="none" stroke="#8a8a8a"/>"##,
                    scale * radius
                )
            })
            .collect();
        let places: Vec<[f64; 2]> =
            self.points.iter().map(|[x, y]| [0.5 * SIDE + scale * x, 0.5 * SIDE - scale * y]).collect();
        let [x, y] = places[0];
        let line: Vec<_> = places.iter().map(|[x, y]| format!("{x:.2},{y:.2}")).collect();
        let line = line.join(" ");
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" width="{SIDE}" height="{SIDE}" viewBox="0 0 {SIDE} {SIDE}"><rect width="100%" height="100%" fill="#fff"/>{circles}<polyline points="{line}" fill="none" stroke="#1f4e8c" stroke-width="1.5"/><circle cx="{x:.2}" cy="{y:.2}" r="3.5" fill="#c0392b"/></svg>"##
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Release, State, Top, TopParameters};

    /// At t = 0 the curve of a sliding top starts opposite to the direction of its axis, and the curve of a held top starts
    /// at its axis.
    #[test]
    fn tip_and_axis_begin_where_they_are() {
        let release = Release { tilt: 0.4, azimuth: 0.7, spin: 150.0, ..Release::default() };
        let state = State::from_release(&release).unwrap();
        let [x, y, _] = state.orientation().axis();
        let slid = Top::sliding(&TopParameters::TOY).unwrap();
        let held = Top::fixed(&TopParameters {
            transverse_inertia: 7.5e-5,
            axial_inertia: 2.0e-5,
            mass_moment: 1.5e-3,
            gravity: 9.81,
            ..TopParameters::default()
        })
        .unwrap();
        for (top, scale) in [(slid, -0.03), (held, 1.0)] {
            let motion = MotionWithPeriod::new(Motion::launch(&top, &state).unwrap());
            let curve = TipCurve::new(&motion).unwrap();
            let [at_x, at_y] = curve.points[0];
            assert!((at_x - scale * x).hypot(at_y - scale * y) < 1e-6 * scale.abs(), "{at_x} {at_y}");
        }
    }
}
