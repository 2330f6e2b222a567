//! Bounds between which the axis stays, with the names that legends give them.

use toytop::Motion;

/// Place of the axis at a bound.
#[derive(Clone, Copy, PartialEq)]
pub enum Place {
    /// Lowest place of the axis, u = e₁.
    Lowest,
    /// Highest place of the axis, u = e₂.
    Highest,
    /// Place of an axis whose tilt is constant, u = e₁ = e₂.
    Constant,
    /// Horizontal axis between the lowest and the highest place, u = 0.
    Horizontal,
}

impl Place {
    /// Name in a legend.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lowest => "lowest",
            Self::Highest => "highest",
            Self::Constant => "constant",
            Self::Horizontal => "horizontal",
        }
    }
}

/// Bound on the height of the axis.
#[derive(Clone, Copy)]
pub struct Bound {
    /// Place of the axis.
    pub place: Place,
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
            regime if regime.is_regular_precession() => vec![bound(Place::Constant, e.e2)],
            _ => vec![bound(Place::Lowest, e.e1), bound(Place::Highest, e.e2)],
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
        write!(f, "{}: tilt {:.2}°", self.place.name(), self.tilt())
    }
}
