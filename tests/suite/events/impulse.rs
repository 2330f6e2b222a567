//! Impulses: against a short force on a free body whose support is a constraint force, and by invariants.

use nalgebra::{Matrix3, Vector3};
use toytop::su2::Vector;
use toytop::{FirstIntegrals, ParameterError, State, Support, Top, TopParameters};
use toytop_tests::{tolerance, worst};

type V = Vector3<f64>;

const MASS: f64 = 0.05;
const HEIGHT: f64 = 0.03;
/// Moments of inertia about the centre of mass.
const TRANSVERSE: f64 = 3e-5;
const AXIAL: f64 = 2e-5;

fn top(support: Support) -> Top {
    let parameters = TopParameters {
        transverse_inertia: TRANSVERSE,
        axial_inertia: AXIAL,
        com_height: HEIGHT,
        mass: MASS,
        ..TopParameters::default()
    };
    match support {
        Support::Sliding => Top::sliding(&parameters).unwrap(),
        Support::Free => Top::free(&parameters).unwrap(),
        Support::Fixed => {
            let transverse_inertia = TRANSVERSE + MASS * HEIGHT * HEIGHT;
            Top::fixed(&TopParameters { transverse_inertia, ..parameters }).unwrap()
        }
    }
}

const SUPPORTS: [Support; 3] = [Support::Sliding, Support::Fixed, Support::Free];

/// Numbers in [-1, 1) from a linear congruential generator.
struct Draw(u64);

impl Draw {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self, scale: f64) -> Vector<f64> {
        [0; 3].map(|_| scale * self.number())
    }

    /// State of any tilt, an impulse of up to 5 mN s, and a point within 6 cm.
    fn stroke(&mut self) -> (State, Vector<f64>, Vector<f64>) {
        let quaternion = [0; 4].map(|_| self.number());
        let norm = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        let gyro = self.vector(100.0);
        let state = State::from_quaternion_and_gyro(quaternion.map(|x| x / norm), gyro).unwrap();
        (state, self.vector(5e-3), self.vector(0.06))
    }
}

/// Free rigid body in space: rotation matrix, velocity of the centre of mass, angular velocity.
#[derive(Clone, Copy)]
struct Body {
    rotation: Matrix3<f64>,
    velocity: V,
    omega: V,
}

/// Force on a free body: F in the fixed frame at a point of the body, m from the centre of mass.
struct Push {
    support: Support,
    force: V,
    point: V,
}

impl Push {
    /// Rates of change, with the constraint force that keeps the acceleration of the tip at 0 in the constrained
    /// directions: Lagrange's equations of the first kind, about the centre of mass for both kinds of top.
    fn rates(&self, body: &Body) -> Body {
        let inertia = Matrix3::from_diagonal(&V::new(TRANSVERSE, TRANSVERSE, AXIAL));
        let inertia = body.rotation * inertia * body.rotation.transpose();
        let inverse = inertia.try_inverse().unwrap();
        let (omega, tip) = (body.omega, body.rotation * V::new(0.0, 0.0, -HEIGHT));
        let free = self.force / MASS - V::new(0.0, 0.0, 9.80665);
        let moment = (body.rotation * self.point).cross(&self.force) - omega.cross(&(inertia * omega));
        let drift = free + (inverse * moment).cross(&tip) + omega.cross(&omega.cross(&tip));
        let response = Matrix3::from_columns(
            &[V::x(), V::y(), V::z()].map(|unit| unit / MASS + (inverse * tip.cross(&unit)).cross(&tip)),
        );
        let reaction = match self.support {
            Support::Fixed => response.try_inverse().unwrap() * -drift,
            Support::Sliding => V::new(0.0, 0.0, -drift.z / response[(2, 2)]),
            Support::Free => V::zeros(),
        };
        Body {
            rotation: omega.cross_matrix() * body.rotation,
            velocity: free + reaction / MASS,
            omega: inverse * (moment + tip.cross(&reaction)),
        }
    }

    /// Velocities after a force of this impulse, spread evenly over a time, by the classical Runge-Kutta method: of the
    /// centre of mass, and angular.
    fn over(&self, mut body: Body, time: f64) -> [V; 2] {
        const STEPS: u32 = 64;
        let dt = time / f64::from(STEPS);
        let push = Push { force: self.force / time, ..*self };
        let ahead = |body: &Body, rate: &Body, dt: f64| Body {
            rotation: body.rotation + rate.rotation * dt,
            velocity: body.velocity + rate.velocity * dt,
            omega: body.omega + rate.omega * dt,
        };
        for _ in 0..STEPS {
            let k1 = push.rates(&body);
            let k2 = push.rates(&ahead(&body, &k1, dt / 2.0));
            let k3 = push.rates(&ahead(&body, &k2, dt / 2.0));
            let k4 = push.rates(&ahead(&body, &k3, dt));
            for (rate, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
                body = ahead(&body, &rate, dt * weight / 6.0);
            }
        }
        [body.velocity, body.omega]
    }
}

/// Changes of the velocity of the centre of mass and of ω in the limit of ever shorter forces, extrapolated from two.
fn by_short_forces(support: Support, state: &State, impulse: V, point: V) -> [V; 2] {
    let phi = state.orientation().normalised();
    let rotation = Matrix3::from_row_slice(phi.matrix().as_flattened());
    let omega = V::from(state.omega());
    let velocity = match support {
        Support::Fixed => omega.cross(&(rotation * V::new(0.0, 0.0, HEIGHT))),
        Support::Sliding => V::new(0.0, 0.0, omega.cross(&(rotation * V::new(0.0, 0.0, HEIGHT))).z),
        Support::Free => V::zeros(),
    };
    // points of a free body are from the centre of mass
    let below = if support == Support::Free { V::zeros() } else { V::new(0.0, 0.0, HEIGHT) };
    let body = Body { rotation, velocity, omega };
    let push = Push { support, force: impulse, point: point - below };
    const TIME: f64 = 1e-9;
    let ([velocity, omega], [later_velocity, later_omega]) =
        (push.over(body, TIME / 2.0), push.over(body, TIME));
    [2.0 * velocity - later_velocity - body.velocity, 2.0 * omega - later_omega - body.omega]
}

#[test]
fn it_is_the_limit_of_short_forces() {
    for support in SUPPORTS {
        let (top, mut draw) = (top(support), Draw(17));
        let errors = (0..200).flat_map(|_| {
            let (state, impulse, point) = draw.stroke();
            let after = state.with_impulse(&top, impulse, point).unwrap();
            let reaction = V::from(state.reaction_impulse(&top, impulse, point).unwrap());
            let [velocity, omega] = by_short_forces(support, &state, impulse.into(), point.into());
            let ours = V::from(after.omega()) - V::from(state.omega());
            let answered = MASS * velocity - V::from(impulse);
            [(ours - omega).norm() / omega.norm(), (reaction - answered).norm() / size(impulse)]
        });
        tolerance::IMPULSE.check(&format!("{support:?}"), worst(errors));
    }
}

fn size(x: Vector<f64>) -> f64 {
    V::from(x).norm()
}

/// Change of ω, relative to that by the same impulse at the rim.
fn effect(top: &Top, state: &State, impulse: Vector<f64>, point: Vector<f64>) -> f64 {
    let change = |point| {
        let after = state.with_impulse(top, impulse, point).unwrap();
        size(std::array::from_fn(|i| after.omega()[i] - state.omega()[i]))
    };
    change(point) / change([0.03, 0.02, HEIGHT])
}

/// The support compensates any impulse at the tip of a held top, and a vertical impulse at a sliding tip. A horizontal impulse
/// at a sliding tip moves the top.
#[test]
fn impulses_along_the_reaction_have_no_effect() {
    let mut draw = Draw(3);
    for _ in 0..100 {
        let (state, impulse, _) = draw.stroke();
        assert_eq!(effect(&top(Support::Fixed), &state, impulse, [0.0; 3]), 0.0);
        let ([x, y, z], sliding) = (impulse, top(Support::Sliding));
        assert!(effect(&sliding, &state, [0.0, 0.0, z], [0.0; 3]) < 1e-13);
        assert!(effect(&sliding, &state, [x, y, 0.0], [0.0; 3]) > 1e-2);
        // an impulse on the centre of mass along the plane moves the top and does not turn it
        assert!(effect(&sliding, &state, [x, y, 0.0], [0.0, 0.0, HEIGHT]) < 1e-13);
        for (top, impulse) in [(top(Support::Fixed), impulse), (sliding, [0.0, 0.0, z])] {
            let reaction = state.reaction_impulse(&top, impulse, [0.0; 3]).unwrap();
            let sum = std::array::from_fn(|i| reaction[i] + impulse[i]);
            assert!(size(sum) < 1e-15 * size(impulse) + 1e-18, "{reaction:?} {impulse:?}");
        }
    }
}

#[test]
fn an_impulse_and_its_opposite_cancel() {
    let mut draw = Draw(5);
    for support in SUPPORTS {
        let top = top(support);
        for _ in 0..100 {
            let (state, impulse, point) = draw.stroke();
            let there = state.with_impulse(&top, impulse, point).unwrap();
            let back = there.with_impulse(&top, impulse.map(|x| -x), point).unwrap();
            let moved = |a: &State, b: &State| size(std::array::from_fn(|i| a.omega()[i] - b.omega()[i]));
            assert!(moved(&back, &state) < 1e-15 * (size(state.omega()) + size(there.omega())));
            assert!(moved(&there, &state) > 1e-3);
            assert_eq!(there.orientation(), state.orientation());
        }
    }
}

/// Velocity of a point of the body, relative to the horizontal motion of the centre of mass.
fn velocity(top: &Top, state: &State, point: Vector<f64>) -> V {
    let (phi, omega) = (state.orientation().normalised(), V::from(state.omega()));
    let from_tip = omega.cross(&V::from(phi.adjoint(point)));
    match top.support() {
        Support::Fixed | Support::Free => from_tip,
        Support::Sliding => {
            let tip = omega.cross(&V::from(phi.adjoint([0.0, 0.0, HEIGHT])));
            from_tip - V::new(tip.x, tip.y, 0.0)
        }
    }
}

/// The energy changes by the work of the impulse, J times the mean of the velocities of its point before and after. The energy |J|²/2M of
/// a sliding top's centre of mass along the plane is not part of the state. The momenta change by the moment of the impulse: n about the
/// axis, and l about the vertical through the centre of mass (through a held tip).
#[test]
fn energy_and_momenta_change_by_the_work_and_the_moments() {
    let mut draw = Draw(11);
    for support in SUPPORTS {
        let top = top(support);
        for _ in 0..100 {
            let (state, impulse, point) = draw.stroke();
            let after = state.with_impulse(&top, impulse, point).unwrap();
            let [before, now] = [&state, &after].map(|state| FirstIntegrals::from_state(&top, state));
            let j = V::from(impulse);
            let work = j.dot(&(velocity(&top, &state, point) + velocity(&top, &after, point))) / 2.0;
            let scale = before.h.abs() + now.h.abs();
            assert!((now.h - before.h - work).abs() < 1e-13 * scale, "{} {work}", now.h - before.h);
            assert!(work.abs() > 1e-6 * scale);

            let phi = state.orientation().normalised();
            let moment = V::from(phi.adjoint([point[0], point[1], point[2] - top.com_height()])).cross(&j);
            let about_axis = moment.dot(&V::from(phi.axis()));
            for (change, moment) in [(now.l - before.l, moment.z), (now.n - before.n, about_axis)] {
                assert!((change - moment).abs() < 1e-13 * (size(state.omega()) + size(after.omega())) * 1e-4);
            }
        }
    }
}

#[test]
fn refusals_name_the_parameter() {
    let (state, impulse, point) = Draw(1).stroke();
    let top = top(Support::Sliding);
    let name = |impulse, point| {
        let refused = state.with_impulse(&top, impulse, point).err();
        let reaction = state.reaction_impulse(&top, impulse, point).err();
        (refused.map(|error| error.parameter()), reaction.map(|error| error.parameter()))
    };
    assert_eq!(name(impulse, point), (None, None));
    assert_eq!(name([0.0, f64::NAN, 0.0], point), (Some("impulse"), Some("impulse")));
    assert_eq!(name([0.0, 0.0, 2e12], point), (Some("impulse"), Some("impulse")));
    assert_eq!(name(impulse, [f64::INFINITY, 0.0, 0.0]), (Some("point"), Some("point")));
    assert_eq!(name(impulse, [0.0, -2e12, 0.0]), (Some("point"), Some("point")));
    // more than 1e12 rad/s, from numbers in range
    assert_eq!(name([1e10, 0.0, 0.0], [0.0, 1.0, 0.0]), (Some("impulse"), None));

    let state = |quaternion, gyro| {
        State::from_quaternion_and_gyro(quaternion, gyro).map_err(|e: ParameterError| e.parameter())
    };
    assert!(state([0.6, 0.0, 0.8000006, 0.0], [0.0, 0.0, 1e12]).is_ok());
    assert_eq!(state([0.6, 0.0, 0.8000007, 0.0], [0.0; 3]), Err("quaternion"));
    assert_eq!(state([0.0; 4], [0.0; 3]), Err("quaternion"));
    assert_eq!(state([f64::NAN, 0.0, 0.8, 0.0], [0.0; 3]), Err("quaternion"));
    assert_eq!(state([1e200, 0.0, 0.0, 0.0], [0.0; 3]), Err("quaternion"));
    assert_eq!(state([1.0, 0.0, 0.0, 0.0], [0.0, f64::INFINITY, 0.0]), Err("gyro"));
    assert_eq!(state([1.0, 0.0, 0.0, 0.0], [8e11, 0.0, 8e11]), Err("gyro"));
    assert_eq!(state([1.0, 0.0, 0.0, 0.0], [1e300, 0.0, 0.0]), Err("gyro"));
}

/// A motion launched from a gyroscope's reading has this reading at t = 0, for any norm of the quaternion within its limits.
#[test]
fn a_gyroscope_reads_what_the_state_has() {
    let gyro = [0.4, -0.2, 150.0];
    for norm in [1.0 - 4e-7, 1.0, 1.0 + 4e-7] {
        let state = State::from_quaternion_and_gyro([0.1, 0.7, -0.1, 0.7].map(|x| x * norm), gyro).unwrap();
        let phi = state.orientation().normalised();
        let back = phi.inverse().adjoint(state.omega());
        assert!(size(std::array::from_fn(|i| back[i] - gyro[i])) < 1e-12, "{norm}: {back:?}");
        assert!((size(state.omega()) - size(gyro)).abs() < 1e-12);
    }
}
