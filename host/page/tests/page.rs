//! Values that JavaScript receives, compared with the core.

use toytop::scalar::Float;
use toytop::{Motion, Pose, Release, State, Stepper, Support, TableF64, Top};
use toytop_model::constants::number_constants;
use toytop_model::launch::Launch;
use toytop_model::parameters::{self, tilt_from_degrees, top_parameters};
use toytop_model::timed_motion::TimedMotion;
use toytop_page::exports::launch_names;
use toytop_page::runge_kutta::{MAX_STEPS, RungeKutta};
use toytop_page::table::{PageTable, pose_numbers};

/// The toy top of the README: A, C, s, M, p, g, K.
const TOY_TOP: [f64; 7] = [3.0e-5, 2.0e-5, 0.03, 0.05, 0.0, 9.81, 0.0];
/// Tilt, spin, precession, nutation, azimuth, roll.
const THROW: [f64; 8] = [20.0, 150.0, 4.0, -3.0, 50.0, 70.0, 0.0, 0.0];

fn top(support: Support, numbers: [f64; 7]) -> Top {
    parameters::top(support, &top_parameters(numbers)).unwrap()
}

fn launched(top: &Top, kind: &str, numbers: [f64; 8]) -> Motion {
    Launch::new(kind, numbers).unwrap().motion(top).unwrap()
}

fn thrown() -> Motion {
    launched(&top(Support::Sliding, TOY_TOP), "release", THROW)
}

fn constant(motion: &Motion, name: &str) -> f64 {
    let (_, value) = number_constants().find(|(other, _)| *other == name).unwrap();
    value(&TimedMotion::new(*motion))
}

/// A table of the largest capacity is larger than a test's stack.
fn on_a_large_stack(test: impl FnOnce() + Send + 'static) {
    std::thread::Builder::new().stack_size(64 << 20).spawn(test).unwrap().join().unwrap();
}

#[test]
fn numbers_make_the_motion_that_names_make() {
    let top = top(Support::Sliding, TOY_TOP);
    assert_eq!([top.transverse_inertia(), top.axial_inertia(), top.com_height()], [3.0e-5, 2.0e-5, 0.03]);
    assert_eq!((top.mass_moment(), top.gravity()), (0.05 * 0.03, 9.81));
    let held = self::top(Support::Fixed, [7.5e-5, 2.0e-5, 0.0, 0.0, 0.0015, 9.81, 0.25]);
    assert_eq!((held.mass_moment(), held.rotor_momentum()), (0.0015, 0.25));
    let release = Release {
        tilt: 20_f64.to_radians(),
        spin: 150.0,
        precession: 4.0,
        nutation: -3.0,
        azimuth: 50_f64.to_radians(),
        roll: 70_f64.to_radians(),
    };
    let state = State::from_release(&release).unwrap();
    assert_eq!(thrown(), Motion::launch(&top, &state).unwrap());
    let ([alpha, beta], omega) = ([state.orientation().alpha, state.orientation().beta], state.omega());
    let numbers = [alpha.re, alpha.im, beta.re, beta.im, omega[0], omega[1], omega[2], 0.0];
    assert_eq!(launched(&top, "state", numbers), thrown());
    let of_roots = launched(&top, "branch_points", [0.5, 0.75, 2.0, 1.0, -1.0, 0.0, 0.0, 0.0]);
    assert_eq!(["e1", "e2", "e3"].map(|name| constant(&of_roots, name)), [0.5, 0.75, 2.0]);
    assert!(constant(&of_roots, "l").abs() < constant(&of_roots, "n").abs());
}

/// The sliders of the throw show any motion by these.
#[test]
fn angles_and_rates_at_the_start_are_those_of_the_throw() {
    let motion = thrown();
    for (name, given) in [
        ("tilt", 20_f64.to_radians()),
        ("azimuth", 50_f64.to_radians()),
        ("spin", 150.0),
        ("precession", 4.0),
        ("nutation", -3.0),
    ] {
        let found = constant(&motion, name);
        assert!((found / given - 1.0).abs() < 1e-12, "{name}: {found} for {given}");
    }
    assert_eq!(launch_names().count(), number_constants().count() + 3);
}

/// Where no torque acts the angular momentum stands still, Aω + ((C - A)⟨ω, r⟩ + K) r; elsewhere it does not.
#[test]
fn a_free_body_has_its_angular_momentum() {
    let top = top(Support::Free, [3.0e-5, 2.0e-5, 0.0, 0.0, 0.0, 0.0, 1.0e-3]);
    let motion = launched(&top, "release", THROW);
    let state = Stepper::<f64>::new(&motion).attitude_state();
    let (r, omega) = (state.orientation.axis(), state.omega());
    let axial = -1.0e-5 * 150.0 + 1.0e-3;
    for (i, name) in ["m_x", "m_y", "m_z"].into_iter().enumerate() {
        let (found, expected) = (constant(&motion, name), 3.0e-5 * omega[i] + axial * r[i]);
        assert!((found - expected).abs() < 1e-17, "{name}: {found:e} for {expected:e}");
        assert!(constant(&thrown(), name).is_nan());
    }
    assert_eq!(constant(&motion, "support"), 2.0);
}

#[test]
fn what_is_no_motion_is_refused_by_its_name() {
    let top = top(Support::Sliding, TOY_TOP);
    let refused = |i: usize, x: f64| {
        let mut numbers = THROW;
        numbers[i] = x;
        Launch::new("release", numbers).and_then(|launch| launch.motion(&top)).unwrap_err().parameter()
    };
    assert_eq!(
        [refused(0, 180.1), refused(0, -1.0), refused(1, f64::NAN), refused(2, 1e12)],
        ["tilt", "tilt", "spin", "precession"]
    );
    assert_eq!(tilt_from_degrees(180.0), std::f64::consts::PI);
    assert!(tilt_from_degrees(180_f64.next_down()) < std::f64::consts::PI);
}

#[test]
fn a_pose_is_the_cores() {
    on_a_large_stack(|| {
        let motion = thrown();
        let mut table = Box::new(PageTable::EMPTY);
        table.set_up(&TimedMotion::new(motion)).unwrap();
        let core = TableF64::new(&motion, TimedMotion::new(motion).tick()).unwrap();
        for t in [0.0, 0.3125, -7.1, 1e6] {
            let [a, b, c, d, u, .., x, y] = pose_numbers(table.at(t));
            let Pose { orientation: phi, tip, .. } = core.at(t).pose();
            assert_eq!([a, b, c, d], [phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im]);
            assert_eq!([u, x, y], [phi.u().clamp(-1.0, 1.0), tip.re, tip.im]);
        }
    });
}

/// The method is of fourth order, forwards and backwards, and a call has bounded work.
#[test]
fn runge_kutta_drifts_as_its_step_says() {
    let motion = thrown();
    let core = TableF64::new(&motion, TimedMotion::new(motion).tick()).unwrap();
    for t in [0.5, -0.5] {
        let errors = [4e-4, 2e-4].map(|step| {
            let (reached, phi, _) = RungeKutta::new(&motion, step).advance_to(t);
            assert_eq!(reached, t);
            core.at(t).orientation().distance(&phi)
        });
        let order = (errors[0] / errors[1]).log2();
        assert!((3.5..4.6).contains(&order) && errors[0] > 1e-9, "{order} {errors:?}");
    }
    let mut integration = RungeKutta::new(&motion, 1e-5);
    let (first, ..) = integration.advance_to(1.0);
    assert!((first / (f64::from(MAX_STEPS) * 1e-5) - 1.0).abs() < 1e-12, "{first}");
    let (second, ..) = integration.advance_to(1.0);
    assert!(second > first && second < 1.0);
    assert_eq!(Float::abs(integration.advance_to(-1e-7).0), 1e-7);
}
