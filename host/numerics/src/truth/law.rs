//! Integrands near a turning point, in 192 bits and in `f64`.

use crate::truth::precise::{Precise, is_zero, precise, root, to_f64};

/// Turning point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// Turning point u = e₁.
    Lower,
    /// Turning point u = e₂.
    Upper,
}

impl End {
    /// Turning point of a number of quarter turns.
    pub(super) fn of(quarter: i64) -> Self {
        if quarter % 2 == 0 { Self::Lower } else { Self::Upper }
    }
}

/// Constants of a motion; differences of the branch points are separate constants.
#[derive(Clone, Debug)]
pub(crate) struct Law {
    pub(super) s: Precise,
    pub(super) g: Precise,
    pub(super) one_plus_e1: Precise,
    pub(super) one_minus_e2: Precise,
    pub(super) e2_minus_e1: Precise,
    pub(super) e3_minus_e2: Precise,
    /// Whether torque acts. Without torque e₃ - u does not depend on u, and is 1 in the units of this module.
    pub(super) torque: bool,
    pub(super) a_over_p: Precise,
    /// Rates (l ± n)/(2A).
    pub(super) momenta: [Precise; 2],
}

impl Law {
    /// Values of 1 + u, 1 - u and e₃ - u, from the squares of sine and cosine of the difference of χ from a turning point.
    fn heights(&self, end: End, [sine, cosine]: [&Precise; 2]) -> [Precise; 3] {
        let [above, below] = match end {
            End::Lower => [sine, cosine],
            End::Upper => [cosine, sine],
        };
        let fall = &self.e2_minus_e1 * below;
        let (one_plus_u, one_minus_u) =
            (&self.one_plus_e1 + &self.e2_minus_e1 * above, &self.one_minus_e2 + &fall);
        let below_e3 = if self.torque { &self.e3_minus_e2 + &fall } else { self.e3_minus_e2.clone() };
        [one_plus_u, one_minus_u, below_e3]
    }

    /// Values of 1 + u and 1 - u.
    pub(super) fn complements(&self, end: End, beyond: &Precise) -> [Precise; 2] {
        let square = beyond.sqr();
        let [one_plus_u, one_minus_u, _] = self.heights(end, [&square, &(precise(1.0) - &square)]);
        [one_plus_u, one_minus_u]
    }

    /// Derivatives of t, arg α and arg β with respect to the sine of the difference of χ from a turning point, without the rate ±τ/2.
    pub(super) fn rates(&self, end: End, beyond: &Precise) -> [Precise; 3] {
        let sine = beyond.sqr();
        let cosine = precise(1.0) - &sine;
        let [one_plus_u, one_minus_u, below_e3] = self.heights(end, [&sine, &cosine]);
        let d = &self.a_over_p + &self.s * (&one_plus_u * &one_minus_u);
        let slowness = root(&((d << 1) / (&self.g * below_e3 * cosine)));
        let turning = |momentum: &Precise, complement: Precise| {
            if is_zero(momentum) { precise(0.0) } else { momentum / complement * &slowness }
        };
        let [alpha, beta] = &self.momenta;
        let (alpha, beta) = (turning(alpha, one_plus_u), turning(beta, one_minus_u));
        [slowness, alpha, beta]
    }

    /// Constants in `f64`.
    pub(super) fn in_f64(&self) -> LawInF64 {
        let Self { s, g, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, torque, a_over_p, momenta } =
            self;
        let [s, g, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, a_over_p] =
            [s, g, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, a_over_p].map(to_f64);
        let momenta = momenta.each_ref().map(to_f64);
        let torque = *torque;
        LawInF64 { s, g, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, torque, a_over_p, momenta }
    }
}

/// Constants of a motion in `f64`, for first guesses and for the choice of places.
#[derive(Clone, Copy, Debug)]
pub(super) struct LawInF64 {
    s: f64,
    g: f64,
    one_plus_e1: f64,
    one_minus_e2: f64,
    e2_minus_e1: f64,
    e3_minus_e2: f64,
    torque: bool,
    a_over_p: f64,
    momenta: [f64; 2],
}

impl LawInF64 {
    /// Values of 1 + u and 1 - u, and the derivative of t with respect to the sine of the difference of χ from a turning point.
    fn heights_and_slowness(&self, end: End, beyond: f64) -> [f64; 3] {
        let (sine, cosine) = (beyond * beyond, (1.0 - beyond) * (1.0 + beyond));
        let (above, below) = if end == End::Lower { (sine, cosine) } else { (cosine, sine) };
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * above;
        let one_minus_u = self.one_minus_e2 + self.e2_minus_e1 * below;
        let fall = if self.torque { self.e2_minus_e1 * below } else { 0.0 };
        let below_e3 = self.e3_minus_e2 + fall;
        let d = self.a_over_p + self.s * one_plus_u * one_minus_u;
        [one_plus_u, one_minus_u, (2.0 * d / (self.g * below_e3 * cosine)).sqrt()]
    }

    /// Derivative of t with respect to the sine of the difference of χ from a turning point.
    pub(super) fn slowness(&self, end: End, beyond: f64) -> f64 {
        self.heights_and_slowness(end, beyond)[2]
    }

    /// Square of the rate of Φ without its mean rotation: |α|'² + |β|'² plus |α|² and |β|² times the squared deviations of the rates of arg α
    /// and arg β from their mean rates.
    pub(super) fn relative_speed_squared(&self, end: End, beyond: f64, mean_rates: [f64; 2]) -> f64 {
        let [one_plus_u, one_minus_u, slowness] = self.heights_and_slowness(end, beyond);
        let rise = 2.0 * self.e2_minus_e1 * beyond / slowness;
        let turning = |momentum: f64, complement: f64, mean: f64| {
            let rate = if momentum == 0.0 { 0.0 } else { momentum / complement };
            0.5 * complement * (rate - mean).powi(2)
        };
        let [alpha, beta] = self.momenta;
        let [alpha_mean, beta_mean] = mean_rates;
        let tilting = rise * rise / (4.0 * one_plus_u * one_minus_u);
        let tilting = if tilting.is_nan() { 0.0 } else { tilting };
        tilting + turning(alpha, one_plus_u, alpha_mean) + turning(beta, one_minus_u, beta_mean)
    }

    /// Distance of the nearest singularity from the turning point, as the sine of an imaginary angle; `None` for the pole of
    /// an aperiodic motion.
    pub(super) fn depth(&self, end: End) -> Option<f64> {
        // e₄² - 1 = A/(ps)
        let spread = self.a_over_p / self.s;
        let beyond_e4 = spread / ((1.0 + spread).sqrt() + 1.0);
        let (below, above) = (self.one_plus_e1, self.one_minus_e2);
        let gaps = match end {
            End::Lower => [below, below + beyond_e4, f64::INFINITY],
            End::Upper if self.e3_minus_e2 == 0.0 => return None,
            End::Upper => [above, above + beyond_e4, self.e3_minus_e2],
        };
        let least = gaps.into_iter().filter(|gap| *gap > 0.0).fold(f64::INFINITY, f64::min);
        Some((least / self.e2_minus_e1).sqrt())
    }
}
