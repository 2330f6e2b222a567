//! Euler-Poisson equations of the toy top for (Phi, m) in the fixed frame. They use no angles, do not divide by 1 - u^2, and do not use
//! that the motion is integrable.

use toytop::scalar::{Float, Real};
pub use toytop::su2::{cross, dot};
use toytop::{AttitudeState, Complex, Orientation, Top};

/// Vector of the fixed frame, in which k = (0, 0, 1) points up.
type Vector = [f64; 3];

/// State as a vector for the integration: re alpha, im alpha, re beta, im beta, m1, m2, m3.
pub type Vector7 = [f64; 7];

/// Orientation Phi = \[\[alpha, beta\], \[-conj beta, conj alpha\]\] and angular velocity.
#[derive(Clone, Copy)]
pub struct FullState {
    /// Parameter alpha as (re, im).
    pub alpha: [f64; 2],
    /// Parameter beta as (re, im); |alpha|^2 + |beta|^2 = 1.
    pub beta: [f64; 2],
    /// Angular velocity \[rad/s\], components in the fixed frame.
    pub omega: [f64; 3],
}

impl FullState {
    /// State of this orientation and angular velocity.
    pub fn new(orientation: &Orientation<f64>, omega: [f64; 3]) -> Self {
        let [alpha, beta] = [orientation.alpha, orientation.beta].map(|z| [z.re, z.im]);
        Self { alpha, beta, omega }
    }

    /// Orientation Φ.
    pub fn orientation(&self) -> Orientation<f64> {
        let [alpha, beta] = [self.alpha, self.beta].map(|[re, im]| Complex::new(re, im));
        Orientation { alpha, beta }
    }

    /// Unit vector r from the tip to the centre of mass, fixed frame: (-2 alpha beta, |alpha|^2 - |beta|^2).
    pub fn axis(&self) -> [f64; 3] {
        axis(self.alpha, self.beta)
    }

    /// Rate u' of the axis' height u = r . k \[1/s\]: (omega x r) . k.
    pub fn udot(&self) -> f64 {
        cross(self.omega, self.axis())[2]
    }
}

/// Rates of a body's attitude at one time.
#[derive(Clone, Copy)]
pub struct Rates {
    /// Angular velocity ω in the fixed frame, rad per unit time.
    pub omega: [f64; 3],
    /// Angular velocity Ω in the body frame, rad per unit time.
    pub omega_body: [f64; 3],
    /// Rate u' of the cosine of the tilt, per unit time.
    pub udot: f64,
}

impl Rates {
    /// Rates of an attitude state of the core.
    pub fn from_attitude<R: Real>(state: &AttitudeState<R>) -> Self {
        let [omega, omega_body] = [state.omega(), state.omega_body()].map(|vector| vector.map(R::to_f64));
        Self { omega, omega_body, udot: state.udot().to_f64() }
    }
}

/// Parameters of the motion: A, C, p s, p g and K, in any units of inertia and time.
#[derive(Clone, Copy)]
pub struct Equations {
    /// Transverse moment of inertia A.
    pub a: f64,
    /// Axial moment of inertia C.
    pub c: f64,
    /// Product p s.
    pub ps: f64,
    /// Product p g.
    pub pg: f64,
    /// Angular momentum K of a rotor.
    pub k: f64,
    /// Constant axial rate <omega, r>, which the momentum of a body with C = 0 does not determine.
    pub spin: f64,
}

impl Equations {
    /// Parameters of a top, in its units, for a motion from this state.
    pub fn new(top: &Top, start: &FullState) -> Self {
        let p = top.mass_moment();
        Self {
            a: top.transverse_inertia(),
            c: top.axial_inertia(),
            ps: p * top.com_height(),
            pg: p * top.gravity(),
            k: top.rotor_momentum(),
            spin: dot(start.omega, start.axis()),
        }
    }

    /// Same parameters in other units of inertia and of angular rates.
    pub fn in_units(&self, inertia: f64, rate: f64) -> Self {
        Self {
            a: self.a / inertia,
            c: self.c / inertia,
            ps: self.ps / inertia,
            pg: self.pg / inertia / rate / rate,
            k: self.k / inertia / rate,
            spin: self.spin / rate,
        }
    }

    /// First integrals \[l, n, h\]: the angular momenta about the vertical and about the axis \[kg m^2/s\] and the energy \[J\], with the
    /// potential energy p g u. Error: a few units in the last place of their largest term.
    pub fn first_integrals(&self, state: &FullState) -> [f64; 3] {
        let (r, m) = (state.axis(), self.momentum(state));
        // the energy of the rotor relative to the body is constant and not counted
        let twice_kinetic = dot(m, state.omega) - self.k * dot(state.omega, r);
        [m[2], dot(m, r), 0.5 * twice_kinetic + self.pg * r[2]]
    }

    /// Momentum m = A omega + ((C - A) <omega, r> + K) r + p s u' q, where q = r x k and u' = <omega, q>.
    pub fn momentum(&self, state: &FullState) -> Vector {
        let (r, w) = (state.axis(), state.omega);
        let q = [r[1], -r[0], 0.0];
        let (axial, rise) = ((self.c - self.a) * dot(w, r) + self.k, self.ps * dot(w, q));
        core::array::from_fn(|i| self.a * w[i] + axial * r[i] + rise * q[i])
    }

    /// State as a vector for the integration.
    pub fn vector(&self, state: &FullState) -> Vector7 {
        let ([a, b], [c, d], [m1, m2, m3]) = (state.alpha, state.beta, self.momentum(state));
        [a, b, c, d, m1, m2, m3]
    }

    /// Angular velocity of a momentum, and p s u'. The equations <m, r> = C <omega, r> + K and <m, q> = (A + p s |q|^2) u' need no matrix
    /// inverse, and their divisors are not small.
    fn angular_velocity(&self, r: Vector, m: Vector) -> (Vector, f64) {
        let q = [r[1], -r[0], 0.0];
        let spin = if self.c > 0.0 { (dot(m, r) - self.k) / self.c } else { self.spin };
        let axial = (self.c - self.a) * spin + self.k;
        let rise = self.ps * dot(m, q) / (self.a + self.ps * dot(q, q));
        (core::array::from_fn(|i| (m[i] - axial * r[i] - rise * q[i]) / self.a), rise)
    }

    /// State with its angular velocity, from (Phi, m).
    pub fn state(&self, y: &Vector7) -> FullState {
        let (alpha, beta) = ([y[0], y[1]], [y[2], y[3]]);
        let omega = self.angular_velocity(axis(alpha, beta), [y[4], y[5], y[6]]).0;
        FullState { alpha, beta, omega }
    }

    /// Derivative d/dt (Phi, m). Phi' = omega Phi. m' = omega x m + DL with DL = ((C - A) <omega, r> + K) r x omega + p s u' r
    /// x (k x omega) - p g q; the terms along r cancel and Jacobi's identity leaves m' = p s u' (r' x k)
    /// - p g q, which is horizontal: l = m3 is conserved to the last bit.
    pub fn derivative(&self, y: &Vector7) -> Vector7 {
        let r = axis([y[0], y[1]], [y[2], y[3]]);
        let (w, rise) = self.angular_velocity(r, [y[4], y[5], y[6]]);
        let turn = cross(w, r);
        [
            0.5 * (-w[2] * y[1] + w[1] * y[2] - w[0] * y[3]),
            0.5 * (w[2] * y[0] + w[0] * -y[2] - w[1] * y[3]),
            0.5 * (-w[2] * y[3] - w[1] * y[0] + w[0] * y[1]),
            0.5 * (w[2] * y[2] + w[0] * y[0] + w[1] * y[1]),
            rise * turn[1] - self.pg * r[1],
            -rise * turn[0] + self.pg * r[0],
            0.0,
        ]
    }

    /// State after one step of the classical Runge-Kutta method, with Φ normalised.
    pub fn runge_kutta(&self, y: &Vector7, step: f64) -> Vector7 {
        let ahead = |k: &Vector7, fraction: f64| -> Vector7 {
            core::array::from_fn(|i| y[i] + fraction * step * k[i])
        };
        let k1 = self.derivative(y);
        let k2 = self.derivative(&ahead(&k1, 0.5));
        let k3 = self.derivative(&ahead(&k2, 0.5));
        let k4 = self.derivative(&ahead(&k3, 1.0));
        let sum: Vector7 = core::array::from_fn(|i| k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        let [a, b, c, d, m1, m2, m3] = ahead(&sum, 1.0 / 6.0);
        let norm = Float::sqrt(a * a + b * b + c * c + d * d);
        [a / norm, b / norm, c / norm, d / norm, m1, m2, m3]
    }
}

fn axis(alpha: [f64; 2], beta: [f64; 2]) -> Vector {
    let ([a, b], [c, d]) = (alpha, beta);
    [-2.0 * (a * c - b * d), -2.0 * (a * d + b * c), a * a + b * b - c * c - d * d]
}
