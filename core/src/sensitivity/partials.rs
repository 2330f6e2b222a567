//! Partial derivatives of what a sample says, at one time.

use crate::complex::Complex;
use crate::sensitivity::equations::{Equations, Flow, sum};
use crate::sensitivity::{COLUMNS, Tangent};
use crate::su2::{Orientation, Vector, bracket};

/// State at one time with its partial derivatives, in the order of [`Sensitivity::NAMES`](crate::Sensitivity::NAMES).
#[derive(Clone, Copy, Debug)]
pub struct Partials {
    pub(crate) flow: Flow<f64, COLUMNS>,
    /// Rates of the tangents: η and η'.
    rates: [Tangent<f64>; COLUMNS],
    /// Changes of the support's acceleration g + s u''.
    supports: [f64; COLUMNS],
    omega_rate: Vector<f64>,
    support: f64,
    tip_scale: f64,
    /// Whether the tip slides, so that s is a length of the tip's curve.
    sliding: bool,
}

impl Partials {
    pub(crate) fn new(equations: &Equations<f64>, flow: Flow<f64, COLUMNS>, tip_scale: f64) -> Self {
        let at = equations.acceleration(flow.axis, flow.omega);
        let height = equations.coefficients.height;
        let mut rates = flow.tangents;
        let mut supports = [0.0; COLUMNS];
        for (index, (rate, support)) in rates.iter_mut().zip(&mut supports).enumerate() {
            let change = equations.changes.get(index.wrapping_sub(6));
            let tangent = *rate;
            let (next, u) = equations.tangent_rate(flow.axis, flow.omega, &at, &tangent, change);
            *rate = next;
            *support = height * u + change.map_or(0.0, |by| by.gravity + at.u * by.height);
        }
        Self {
            flow,
            rates,
            supports,
            omega_rate: at.omega,
            support: at.support,
            tip_scale,
            sliding: height > 0.0,
        }
    }

    /// Symmetry axis r.
    #[must_use]
    pub fn axis(&self) -> Vector<f64> {
        self.flow.axis
    }

    /// Orientation Φ, of either sign.
    #[must_use]
    pub fn orientation_now(&self) -> Orientation<f64> {
        let Flow { axis: [x3, y3, z3], side: [x1, y1, z1], .. } = self.flow;
        let [x2, y2, z2] = bracket(self.flow.axis, self.flow.side);
        // four times a component of the quaternion times the others: the row with the largest component is used
        let rows = [
            [1.0 + x1 + y2 + z3, z2 - y3, x3 - z1, y1 - x2],
            [z2 - y3, 1.0 + x1 - y2 - z3, y1 + x2, x3 + z1],
            [x3 - z1, y1 + x2, 1.0 - x1 + y2 - z3, z2 + y3],
            [y1 - x2, x3 + z1, z2 + y3, 1.0 - x1 - y2 + z3],
        ];
        let size = |row: &[f64; 4]| row.iter().map(|x| x * x).sum::<f64>();
        let first = [1.0, 0.0, 0.0, 0.0];
        let largest =
            rows.into_iter().fold(first, |best, row| if size(&row) > size(&best) { row } else { best });
        Orientation::from_quaternion(largest).normalised()
    }

    /// Angular velocity ω in the fixed frame, rad per unit time.
    #[must_use]
    pub fn angular_velocity(&self) -> Vector<f64> {
        self.flow.omega
    }

    /// Body coordinates of a vector given in the fixed frame.
    #[must_use]
    pub fn in_body(&self, fixed: Vector<f64>) -> Vector<f64> {
        self.flow.in_body(fixed)
    }

    /// Fixed coordinates of a vector given in the body frame.
    #[must_use]
    pub fn in_fixed(&self, body: Vector<f64>) -> Vector<f64> {
        self.flow.in_fixed(body)
    }

    /// Derivatives of the orientation: rotation vectors θ in the fixed frame, with dΦ = θ Φ.
    #[must_use]
    pub fn orientation(&self) -> [Vector<f64>; COLUMNS] {
        self.flow.tangents.map(|tangent| tangent.theta)
    }

    /// Derivatives of ω in the fixed frame.
    #[must_use]
    pub fn omega(&self) -> [Vector<f64>; COLUMNS] {
        self.flow.tangents.map(|Tangent { theta, eta }| sum(eta, bracket(theta, self.flow.omega), 1.0))
    }

    /// Derivatives of Ω in the body frame.
    #[must_use]
    pub fn omega_body(&self) -> [Vector<f64>; COLUMNS] {
        self.flow.tangents.map(|tangent| self.flow.in_body(tangent.eta))
    }

    /// Derivatives of the axis r.
    #[must_use]
    pub fn axis_change(&self) -> [Vector<f64>; COLUMNS] {
        self.flow.tangents.map(|tangent| bracket(tangent.theta, self.flow.axis))
    }

    /// Derivatives of the tip c = -s (r₁ + i r₂), m; of -(r₁ + i r₂) for a fixed tip.
    #[must_use]
    pub fn tip(&self) -> [Complex<f64>; COLUMNS] {
        let mut change = self.axis_change().map(|[x, y, _]| Complex::new(x, y).scaled(-self.tip_scale));
        let [x, y, _] = self.flow.axis;
        if let Some(by_height) = change.get_mut(8)
            && self.sliding
        {
            *by_height = *by_height - Complex::new(x, y);
        }
        change
    }

    /// Derivatives of the tip angle φ = arg c, rad; `None` where the tip is at the centre.
    #[must_use]
    pub fn tip_angle(&self) -> Option<[f64; COLUMNS]> {
        let [x, y, _] = self.flow.axis;
        let square = x * x + y * y;
        (square > 0.0).then(|| self.axis_change().map(|[dx, dy, _]| (x * dy - y * dx) / square))
    }

    /// Specific force in the body frame at a point of the body, as an accelerometer there measures it, and its
    /// derivatives, m/s².
    ///
    /// * `place`: body coordinates of the point, m, from the centre of mass of a sliding top, and from the tip of a held
    ///   one: the point to which the moments of inertia belong
    #[must_use]
    pub fn specific_force(&self, place: Vector<f64>) -> (Vector<f64>, [Vector<f64>; COLUMNS]) {
        let flow = &self.flow;
        let omega = flow.in_body(flow.omega);
        let omega_rate = flow.in_body(self.omega_rate);
        let up = flow.in_body([0.0, 0.0, 1.0]);
        let turning = sum(bracket(omega_rate, place), bracket(omega, bracket(omega, place)), 1.0);
        let force = sum(turning, up, self.support);
        let mut changes = [[0.0; 3]; COLUMNS];
        for (((change, tangent), rate), support) in
            changes.iter_mut().zip(&flow.tangents).zip(&self.rates).zip(&self.supports)
        {
            let d_omega = flow.in_body(tangent.eta);
            // Ω' = Φ⁻¹ ω', whose change is that of ω' in the turned frame
            let d_rate = flow.in_body(sum(rate.eta, bracket(tangent.eta, flow.omega), 1.0));
            let d_up = flow.in_body(bracket([0.0, 0.0, 1.0], tangent.theta));
            let turned =
                sum(bracket(d_omega, bracket(omega, place)), bracket(omega, bracket(d_omega, place)), 1.0);
            let total = sum(sum(bracket(d_rate, place), turned, 1.0), up, *support);
            *change = sum(total, d_up, self.support);
        }
        (force, changes)
    }

    /// Body coordinates of a fixed direction, as a magnetometer sees the field, and their derivatives.
    #[must_use]
    pub fn direction(&self, fixed: Vector<f64>) -> (Vector<f64>, [Vector<f64>; COLUMNS]) {
        let changes = self.flow.tangents.map(|tangent| self.flow.in_body(bracket(fixed, tangent.theta)));
        (self.flow.in_body(fixed), changes)
    }
}
