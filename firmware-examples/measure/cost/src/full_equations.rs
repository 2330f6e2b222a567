//! Baseline: the full equations of motion for (Φ, m), and one step of the classical Runge-Kutta method.
//!
//! The code is optimised for speed. m' = p s u' (r' × k) - p g (r × k) is horizontal, so that m₃ is a constant and
//! six equations remain; constant factors are combined before the first step; Φ is normalised by one Newton step of
//! 1/√x, which needs neither root nor division.

use toytop::scalar::Float;
use toytop::su2::dot;
use toytop::{Complex, Motion, Orientation, State};

/// State: Re α, Im α, Re β, Im β, m₁, m₂.
pub(crate) type Point<R> = [R; 6];

/// Constants of a top and a step, with their common factors combined.
pub(crate) struct Constants<R> {
    /// Vertical angular momentum m₃, kg m²/s.
    pub(crate) m3: R,
    /// Reciprocal 1/A.
    per_a: R,
    /// Quotient (C - A)/C.
    axial: R,
    /// Quotient A/(p s).
    a_per_ps: R,
    /// Product p g, kg m²/s².
    pg: R,
    /// Length of a step, and parts of it.
    pub(crate) dt: R,
    half: R,
    third: R,
    sixth: R,
}

impl<R: Float> Constants<R> {
    pub(crate) fn of(motion: &Motion, tick_rate: u32) -> Self {
        let (top, dt) = (motion.top(), 1.0 / f64::from(tick_rate));
        let (a, c, ps) =
            (top.transverse_inertia(), top.axial_inertia(), top.mass_moment() * top.com_height());
        let [m3, per_a, axial, a_per_ps, pg] =
            [motion.first_integrals().l, 1.0 / a, (c - a) / c, a / ps, top.mass_moment() * top.gravity()]
                .map(R::from_f64);
        let [dt, half, third, sixth] = [dt, dt / 2.0, dt / 3.0, dt / 6.0].map(R::from_f64);
        Self { m3, per_a, axial, a_per_ps, pg, dt, half, third, sixth }
    }

    /// Rates Φ' and m'.
    #[inline(always)]
    pub(crate) fn rates(&self, [a, b, c, d, m1, m2]: Point<R>) -> Point<R> {
        let r = [-(a * c - b * d).doubled(), -(a * d + b * c).doubled(), a * a + b * b - c * c - d * d];
        let axial = (m1 * r[0] + m2 * r[1] + self.m3 * r[2]) * self.axial;
        // p s u', where u' = <m, q>/(A + p s |q|²) and q = r × k
        let rise = (m1 * r[1] - m2 * r[0]) / (self.a_per_ps + r[0] * r[0] + r[1] * r[1]);
        let w = [
            (m1 - axial * r[0] - rise * r[1]) * self.per_a,
            (m2 - axial * r[1] + rise * r[0]) * self.per_a,
            (self.m3 - axial * r[2]) * self.per_a,
        ];
        let half = w.map(R::halved);
        [
            half[1] * c - half[2] * b - half[0] * d,
            half[2] * a - half[0] * c - half[1] * d,
            half[0] * b - half[1] * a - half[2] * d,
            half[2] * c + half[0] * a + half[1] * b,
            rise * (w[2] * r[0] - w[0] * r[2]) - self.pg * r[1],
            rise * (w[2] * r[1] - w[1] * r[2]) + self.pg * r[0],
        ]
    }

    /// Performs one step.
    #[inline(always)]
    pub(crate) fn step(&self, y: &mut Point<R>) {
        let ahead = |y: &Point<R>, k: &Point<R>, dt: R| -> Point<R> {
            let mut sum = *y;
            for (y, &k) in sum.iter_mut().zip(k) {
                *y = *y + dt * k;
            }
            sum
        };
        let k1 = self.rates(*y);
        let mut sum = ahead(y, &k1, self.sixth);
        let k2 = self.rates(ahead(y, &k1, self.half));
        sum = ahead(&sum, &k2, self.third);
        let k3 = self.rates(ahead(y, &k2, self.half));
        sum = ahead(&sum, &k3, self.third);
        let k4 = self.rates(ahead(y, &k3, self.dt));
        *y = renormalised(ahead(&sum, &k4, self.sixth));
    }
}

/// State with Φ normalised. After one step the squared norm x is so close to 1 that (3 - x)/2 equals 1/√x.
#[inline(always)]
pub(crate) fn renormalised<R: Float>([a, b, c, d, m1, m2]: Point<R>) -> Point<R> {
    let norm_squared = a * a + b * b + c * c + d * d;
    let scale = (R::ONE + R::ONE.halved()) - norm_squared.halved();
    [a * scale, b * scale, c * scale, d * scale, m1, m2]
}

/// Point of a state: Φ, and m = A ω + (C - A) <ω, r> r + p s u' q.
pub(crate) fn start<R: Float>(motion: &Motion, state: &State) -> Point<R> {
    let (top, orientation, omega) = (motion.top(), state.orientation(), state.omega());
    let r = orientation.axis();
    let q = [r[1], -r[0], 0.0];
    let (axial, rise) = (
        (top.axial_inertia() - top.transverse_inertia()) * dot(omega, r),
        top.mass_moment() * top.com_height() * dot(omega, q),
    );
    let m = |i: usize| top.transverse_inertia() * omega[i] + axial * r[i] + rise * q[i];
    let Orientation { alpha, beta } = orientation;
    [alpha.re, alpha.im, beta.re, beta.im, m(0), m(1)].map(R::from_f64)
}

pub(crate) fn orientation<R: Float>([a, b, c, d, _, _]: Point<R>) -> Orientation<R> {
    Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) }
}
