//! Curve of the tip, and the bounds between which the axis and the tip stay.

use crate::Failure;
use crate::pictures::span::Span;
use toytop::{Motion, Support};

/// Bound between which the axis stays.
#[derive(Clone, Copy)]
pub struct Bound {
    /// Place of the axis as legends name it: `lowest` (u = e₁), `highest` (u = e₂), `constant` where both are one, or `horizontal` (u = 0).
    pub place: &'static str,
    /// Cosine u of the tilt, from -1 to 1.
    pub u: f64,
}

impl Bound {
    /// Lowest place of the axis, then the highest; one place where the tilt is constant, none where the axis is
    /// vertical at all times.
    pub fn of(motion: &Motion) -> Vec<Self> {
        let e = motion.branch_points();
        let bound = |place, u: f64| Self { place, u: u.clamp(-1.0, 1.0) };
        match motion.regime() {
            regime if regime.is_vertical() => Vec::new(),
            regime if regime.is_regular_precession() => vec![bound("constant", e.e2)],
            _ => vec![bound("lowest", e.e1), bound("highest", e.e2)],
        }
    }

    /// Tilt, degrees, from 0 to 180.
    pub fn tilt(self) -> f64 {
        self.u.acos().to_degrees()
    }
}

/// Name and tilt, as in `lowest: tilt 45.57°`.
impl std::fmt::Display for Bound {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: tilt {:.2}°", self.place, self.tilt())
    }
}

/// Curve of the tip (of the axis, if the tip is held) and the circles between which it stays.
pub struct Curve {
    /// Points (x, y), m (without unit for a fixed tip).
    pub points: Vec<[f64; 2]>,
    /// Circles at e₁ and e₂, and at u = 0 if that is between them; none where the tip stays at the centre.
    pub circles: Vec<Circle>,
}

/// Circle of radius ρ(e) = s √(1 - e²), a bound on the distance from the centre.
pub struct Circle {
    /// Radius, in the unit of the curve.
    pub radius: f64,
    /// Bound on the height of the axis.
    pub bound: Bound,
}

impl Curve {
    /// Curve over about one turn of the tip around the centre.
    ///
    /// # Errors
    /// [`Failure::Method`]: no ephemeris is large enough.
    pub fn of(motion: &Motion) -> Result<Self, Failure> {
        Ok(Self::over(motion, &Span::new(motion, None)?))
    }

    /// Curve over a span of time.
    pub fn over(motion: &Motion, span: &Span) -> Self {
        let circles = circles(motion);
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
}

fn circles(motion: &Motion) -> Vec<Circle> {
    let (e, scale) = (motion.branch_points(), motion.top().tip_scale());
    let mut bounds = Bound::of(motion);
    // between e₁ and e₂ the axis is horizontal, which is the largest circle
    if e.e1 < 0.0 && e.e2 > 0.0 && bounds.len() == 2 {
        bounds.push(Bound { place: "horizontal", u: 0.0 });
    }
    let circle = |bound: Bound| {
        let (one_plus_u, one_minus_u) = match bound.place {
            "lowest" => (e.one_plus_e1, 2.0 - e.one_plus_e1),
            "horizontal" => (1.0, 1.0),
            _ => (2.0 - e.one_minus_e2, e.one_minus_e2),
        };
        Circle { radius: scale * (one_plus_u * one_minus_u).sqrt(), bound }
    };
    bounds.into_iter().map(circle).filter(|circle| circle.radius > 0.0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Release, State, Top, TopParameters};

    /// At t = 0 the curve of a sliding top starts opposite to the direction of its axis, and that of a held top starts
    /// at its axis.
    #[test]
    fn tip_and_axis_begin_where_they_are() {
        let release = Release { tilt: 0.4, azimuth: 0.7, spin: 150.0, ..Release::default() };
        let state = State::release(&release).unwrap();
        let [x, y, _] = state.orientation().axis();
        let slid = Top::sliding(&TopParameters {
            transverse_inertia: 3.0e-5,
            axial_inertia: 2.0e-5,
            com_height: 0.03,
            mass: 0.05,
            gravity: 9.81,
            ..TopParameters::default()
        })
        .unwrap();
        let held = Top::fixed(&TopParameters {
            transverse_inertia: 7.5e-5,
            axial_inertia: 2.0e-5,
            mass_moment: 1.5e-3,
            gravity: 9.81,
            ..TopParameters::default()
        })
        .unwrap();
        for (top, scale) in [(slid, -0.03), (held, 1.0)] {
            let curve = Curve::of(&Motion::launch(&top, &state).unwrap()).unwrap();
            let [at_x, at_y] = curve.points[0];
            assert!((at_x - scale * x).hypot(at_y - scale * y) < 1e-6 * scale.abs(), "{at_x} {at_y}");
        }
    }
}
