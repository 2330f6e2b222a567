//! Properties that must hold for everything that was constructed.

use super::input::Input;
use crate::widened;
use toytop::scalar::{Float, Real};
use toytop::{AttitudeState, Motion, Orientation, Stepper};

/// Asserts that all numbers are finite.
pub(super) fn finite(what: &str, numbers: impl IntoIterator<Item = f64>) {
    for (index, number) in numbers.into_iter().enumerate() {
        assert!(number.is_finite(), "{what}: entry {index} is {number}");
    }
}

/// Asserts that an orientation has norm 1 within an error.
pub(super) fn orientation<R: Into<f64>>(what: &str, phi: Orientation<R>, error: f64) {
    let norm = widened(phi).norm_squared();
    assert!((norm - 1.0).abs() <= error, "{what}: |alpha|^2 + |beta|^2 = {norm}, error {error:e}");
}

/// Asserts that orientation and rates are finite, and the norm is 1 within an error.
pub(super) fn attitude<R: Float + Into<f64>>(what: &str, attitude: &AttitudeState<R>, error: f64) {
    orientation(what, attitude.orientation, error);
    let rates =
        [attitude.rate.alpha.re, attitude.rate.alpha.im, attitude.rate.beta.re, attitude.rate.beta.im];
    finite(what, rates.map(Into::into));
    finite(what, attitude.omega().map(Into::into));
    finite(what, [attitude.orientation.u().into(), attitude.udot().into()]);
}

/// Checks the constants of a motion, and a stepper of each scalar over some steps.
pub(super) fn motion(motion: &Motion, input: &mut Input<'_>) {
    let e = motion.branch_points();
    finite("e1, e2", [e.e1, e.e2]);
    assert_eq!(e.e3.is_finite(), !motion.top().is_torque_free(), "{e:?}");
    assert!(-1.0 <= e.e1 && e.e1 <= e.e2 && e.e2 <= 1.0 && 1.0 <= e.e3, "{e:?}");
    let differences = [e.one_plus_e1, e.one_minus_e2, e.e2_minus_e1, e.e3_minus_e2, e.e3_minus_one];
    assert!(differences.iter().all(|difference| *difference >= 0.0), "{e:?}");
    let integrals = motion.first_integrals();
    finite("l, n, h", [integrals.l, integrals.n, integrals.h, integrals.l_plus_n, integrals.l_minus_n]);
    if let Some(advance) = motion.period_advance() {
        assert!(advance.period > 0.0, "{advance:?}");
        finite("advance", [advance.period, advance.alpha_turns, advance.beta_turns]);
    }
    finite("normal force", motion.min_normal_force());
    let _ = motion.tip_class();
    let steps: [f64; 4] = std::array::from_fn(|_| input.signed(-12.0, 12.0));
    stepper::<f64>(motion, &steps, 1e-13);
    stepper::<f32>(motion, &steps, 2e-6);
}

/// Checks a stepper over some steps; its norm is 1 within an error.
pub fn stepper<R: Real + Into<f64>>(motion: &Motion, steps: &[f64], error: f64) {
    let mut stepper = Stepper::<R>::new(motion);
    for &dt in [0.0].iter().chain(steps) {
        stepper.step(R::from_f64(dt));
        attitude(&format!("stepper of {motion:?}"), &stepper.attitude_state(), error);
        let (tip, velocity) = (stepper.tip(), stepper.tip_velocity());
        finite("tip", [tip.re, tip.im, velocity.re, velocity.im].map(Into::into));
        finite("rate of the tip angle", [stepper.tip_angle_rate().into()]);
        assert_eq!(stepper.tip_angle().is_none(), motion.regime().is_vertical());
    }
}
