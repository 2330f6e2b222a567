//! Tops with a rotor inside, without torque, or without axial moment of inertia are compared with two integrations to 30 digits
//! (`tests/reference/data/tops.json`).

use fixed::types::{I2F14, I2F30};
use serde_json::Value;
use toytop::scalar::Real;
use toytop::{BranchPoints, Motion, Orientation, State, Stepper, TableScalar, Top, TopParameters};
use toytop_closed_forms::ClosedForm;
use toytop_tests::vectors::{self, entries, number, orientation, triple};
use toytop_tests::{apart, check_all, keep, kilohertz, length, table_of, tolerance, widened};

/// Motion of the file, with exact orientations and angular velocities at some times.
struct Case {
    name: String,
    motion: Motion,
    samples: Vec<(f64, Orientation<f64>, [f64; 3])>,
    /// Greatest rate of the samples.
    rate: f64,
}

fn cases() -> Vec<Case> {
    entries(&vectors::json("tops.json")["motions"]).iter().map(case).collect()
}

fn case(json: &Value) -> Case {
    let state = State::new(orientation(json), triple(&json["omega"])).unwrap();
    let sample = |json: &Value| (number(&json["t"]), orientation(json), triple(&json["omega"]));
    let samples: Vec<_> = entries(&json["samples"]).iter().map(sample).collect();
    let rate = samples.iter().map(|(_, _, omega)| length(*omega)).fold(0.0, f64::max);
    Case {
        name: json["name"].to_string(),
        motion: Motion::launch(&top(json), &state).unwrap(),
        samples,
        rate,
    }
}

fn top(json: &Value) -> Top {
    let [transverse_inertia, axial_inertia, com_height, mass_moment, gravity, rotor_momentum] =
        ["A", "C", "s", "p", "g", "K"].map(|key| number(&json[key]));
    let parameters = TopParameters {
        transverse_inertia,
        axial_inertia,
        com_height,
        mass: 0.0,
        mass_moment,
        gravity,
        rotor_momentum,
    };
    let make = match json["support"].as_str().unwrap() {
        "sliding" => Top::sliding,
        "fixed" => Top::fixed,
        _ => Top::free,
    };
    make(&parameters).unwrap()
}

/// Errors of orientation and angular velocity of tables, as shares of their bounds.
fn of_tables<R: TableScalar<Quantity: Into<f64>> + Into<f64>>() -> [f64; 2] {
    let mut worst = [0.0; 2];
    for case in cases().into_iter().filter(|case| case.motion.regime() != toytop::Regime::Aperiodic) {
        let table = table_of::<R, 256>(&case.motion, kilohertz());
        for &(t, phi, omega) in &case.samples {
            let sample = table.at(t);
            let shares = [
                widened(sample.orientation()).distance(&phi) / table.error_bound().after(1000.0 * t),
                apart(sample.omega().map(Into::into), omega) / table.rate_error_bound().after(1000.0 * t),
            ];
            assert!(shares.iter().all(|share| *share <= 1.0), "{} at {t}: {shares:?}", case.name);
            keep(&mut worst, shares);
        }
    }
    worst
}

#[test]
fn every_table_keeps_its_bounds() {
    for [orientation, rates] in
        [of_tables::<f64>(), of_tables::<f32>(), of_tables::<I2F30>(), of_tables::<I2F14>()]
    {
        assert!(
            orientation > 0.05 && rates > 0.01,
            "{orientation} and {rates}: bounds that nothing comes near"
        );
    }
}

/// Greatest errors of a stepper with steps of 1/2048: of the orientation, and of the angular velocity relative to the greatest rate.
fn of_steppers<R: Real + Into<f64>>() -> [f64; 2] {
    let mut worst = [0.0; 2];
    for case in cases() {
        for &(t, phi, omega) in &case.samples {
            let mut stepper = Stepper::<R>::new(&case.motion);
            let steps = (t.abs() * 2048.0) as u32;
            (0..steps).for_each(|_| stepper.step(R::from_f64(t.signum() / 2048.0)));
            let rate = apart(stepper.attitude_state().omega().map(Into::into), omega) / case.rate;
            keep(&mut worst, [widened(stepper.orientation()).distance(&phi), rate]);
        }
    }
    worst
}

#[test]
fn steppers_follow_the_integrations() {
    check_all(
        ["orientation, f64", "omega, f64"],
        of_steppers::<f64>(),
        tolerance::BEYOND_THE_PAPER_STEPPER_F64,
    );
    check_all(
        ["orientation, f32", "omega, f32"],
        of_steppers::<f32>(),
        tolerance::BEYOND_THE_PAPER_STEPPER_F32,
    );
}

/// The motions with a closed form are those whose tip does not slide.
#[test]
fn closed_forms_agree_with_the_integrations() {
    let (mut worst, mut count) = ([0.0; 2], 0);
    for case in cases() {
        let Ok(form) = ClosedForm::from_motion(&case.motion) else { continue };
        count += 1;
        for &(t, phi, omega) in &case.samples {
            let attitude = form.at(t);
            let rate = apart(attitude.omega(), omega) / case.rate;
            keep(&mut worst, [attitude.orientation.distance(&phi), rate]);
        }
    }
    assert!(count >= 15);
    check_all(["orientation", "omega"], worst, tolerance::BEYOND_THE_PAPER_TABLE);
}

/// Branch points from l, n and h are those of the state.
#[test]
fn integrals_of_a_free_body_have_its_branch_points() {
    let bodies = cases().into_iter().filter(|case| case.motion.top().is_torque_free());
    let mut count = 0;
    for case in bodies {
        let (top, integrals) = (case.motion.top(), case.motion.first_integrals());
        let e = case.motion.branch_points();
        let found = BranchPoints::from_integrals(top, integrals.l, integrals.n, integrals.h).unwrap();
        for (found, e) in [(found.e1, e.e1), (found.e2, e.e2), (found.e2_minus_e1, e.e2_minus_e1)] {
            assert!((found - e).abs() < 1e-14, "{}: {found} {e}", case.name);
        }
        count += 1;
        let low = BranchPoints::from_integrals(top, integrals.l, integrals.n, 0.0);
        assert!(low.is_err_and(|error| error.parameter() == "h"), "{}", case.name);
    }
    assert!(count >= 6);
}
