//! Values that JavaScript receives, compared with the core.

use toytop::scalar::Float;
use toytop::{Motion, TableF64, Top};
use toytop_model::constants::number_constants;
use toytop_model::launch::{Kind, Launch};
use toytop_model::motion_with_period::MotionWithPeriod;
use toytop_model::parameters::top_parameters;
use toytop_page::exports::launch_names;
use toytop_page::page_motion::{PageMotion, pose_numbers};
use toytop_page::runge_kutta::{MAX_STEPS, RungeKutta};

/// The toy top of the README, thrown.
fn thrown() -> Motion {
    let top = top_parameters([3.0e-5, 2.0e-5, 0.03, 0.05, 0.0, 9.81, 0.0]);
    let launch = Launch::new(Kind::Release, [20.0, 150.0, 4.0, -3.0, 50.0, 70.0, 0.0, 0.0]);
    launch.unwrap().motion(&Top::sliding(&top).unwrap()).unwrap()
}

#[test]
fn every_constant_has_a_name_on_the_page() {
    assert_eq!(launch_names().count(), number_constants().count() + 3);
}

/// A table of the largest capacity is larger than a test's stack.
fn on_a_large_stack(test: impl FnOnce() + Send + 'static) {
    std::thread::Builder::new().stack_size(64 << 20).spawn(test).unwrap().join().unwrap();
}

#[test]
fn a_pose_is_the_cores() {
    on_a_large_stack(|| {
        let motion = thrown();
        let mut table = Box::new(PageMotion::EMPTY);
        table.set_up(&MotionWithPeriod::new(motion)).unwrap();
        let core = TableF64::new(&motion, MotionWithPeriod::new(motion).tick()).unwrap();
        for t in [0.0, 0.3125, -7.1, 1e6] {
            let [a, b, c, d, u, .., x, y] = pose_numbers(table.at(t));
            let (phi, tip) = (core.at(t).orientation(), core.at(t).tip());
            assert_eq!([a, b, c, d], [phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im]);
            assert_eq!([u, x, y], [phi.u().clamp(-1.0, 1.0), tip.re, tip.im]);
        }
    });
}

/// The method is of fourth order, forwards and backwards, and a call has bounded work.
#[test]
fn runge_kutta_drifts_as_its_step_says() {
    let motion = thrown();
    let core = TableF64::new(&motion, MotionWithPeriod::new(motion).tick()).unwrap();
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
