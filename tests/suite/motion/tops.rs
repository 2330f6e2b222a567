//! Tops that the paper does not contain: with a rotor inside, without torque, without axial moment of inertia. They are compared with two
//! integrations to 30 digits (`tests/reference/tops.json`).

use fixed::types::{I2F14, I2F30};
use serde_json::Value;
use toytop::scalar::Real;
use toytop::{
    BranchPoints, Complex, EphemerisScalar, Motion, Orientation, State, Stepper, Top, TopParameters,
};
use toytop_closed_forms::ClosedForm;
use toytop_tests::{boxed, greater, kilohertz, tolerance, vectors, widened};

/// Motion of the file, with exact orientations and angular velocities at some times.
struct Case {
    name: String,
    motion: Motion,
    samples: Vec<(f64, Orientation<f64>, [f64; 3])>,
}

fn cases() -> Vec<Case> {
    let json = vectors::json("tops.json");
    json["motions"].as_array().unwrap().iter().map(case).collect()
}

fn case(json: &Value) -> Case {
    let number = |value: &Value| vectors::number(value).unwrap();
    let phi = |json: &Value| {
        let complex = |key: &str| Complex::new(number(&json[key][0]), number(&json[key][1]));
        Orientation { alpha: complex("alpha"), beta: complex("beta") }
    };
    let omega = |json: &Value| [0, 1, 2].map(|i| number(&json["omega"][i]));
    let name = json["name"].as_str().unwrap().to_owned();
    let motion = Motion::launch(&top(json), &State::new(phi(json), omega(json)).unwrap()).unwrap();
    let samples = json["samples"].as_array().unwrap().iter();
    let samples = samples.map(|sample| (number(&sample["t"]), phi(sample), omega(sample))).collect();
    Case { name, motion, samples }
}

fn top(json: &Value) -> Top {
    let [transverse_inertia, axial_inertia, com_height, mass_moment, gravity, rotor_momentum] =
        ["A", "C", "s", "p", "g", "K"].map(|key| vectors::number(&json[key]).unwrap());
    let parameters = TopParameters {
        transverse_inertia,
        axial_inertia,
        com_height,
        mass_moment,
        gravity,
        rotor_momentum,
        ..TopParameters::default()
    };
    match json["support"].as_str().unwrap() {
        "sliding" => Top::sliding(&parameters),
        "fixed" => Top::fixed(&parameters),
        "free" => Top::free(&parameters),
        other => panic!("{other}"),
    }
    .unwrap()
}

/// Greatest distance of two angular velocities, relative to the greatest rate of the motion.
fn apart(case: &Case, omega: [f64; 3], truth: [f64; 3]) -> f64 {
    let length = |w: [f64; 3]| w.iter().map(|x| x * x).sum::<f64>().sqrt();
    let most = case.samples.iter().map(|(_, _, omega)| length(*omega)).fold(0.0, f64::max);
    length(std::array::from_fn(|i| omega[i] - truth[i])) / most
}

/// Errors of orientation and angular velocity of tables, as shares of their bounds.
fn of_tables<R: EphemerisScalar<Wide: Into<f64>> + Into<f64>, const SEGMENTS: usize>() -> [f64; 2] {
    let mut worst = [0.0; 2];
    for case in cases().into_iter().filter(|case| case.motion.regime() != toytop::Regime::Aperiodic) {
        let ephemeris = boxed::<R, SEGMENTS>(&case.motion, kilohertz());
        for &(t, phi, omega) in &case.samples {
            let sample = ephemeris.at(t);
            let distance = widened(sample.orientation()).distance(&phi);
            let rates = sample.omega().map(Into::into);
            let rate_distance = (0..3).map(|i| (rates[i] - omega[i]).powi(2)).sum::<f64>().sqrt();
            let shares = [
                distance / ephemeris.error_bound().after(1000.0 * t),
                rate_distance / ephemeris.rate_error_bound().after(1000.0 * t),
            ];
            assert!(
                shares.iter().all(|share| *share <= 1.0),
                "{} at {t}: {shares:?} of the bounds",
                case.name
            );
            worst = std::array::from_fn(|i| greater(worst[i], shares[i]));
        }
    }
    worst
}

#[test]
fn every_table_keeps_its_bounds() {
    for [orientation, rates] in [
        of_tables::<f64, 256>(),
        of_tables::<f32, 256>(),
        of_tables::<I2F30, 256>(),
        of_tables::<I2F14, 256>(),
    ] {
        assert!(
            orientation > 0.05 && rates > 0.02,
            "{orientation} and {rates}: bounds that nothing comes near"
        );
    }
}

/// Greatest errors of a stepper with steps of 1/2048: of the orientation, and of the angular velocity.
fn of_steppers<R: Real + Into<f64>>() -> [f64; 2] {
    let mut worst = [0.0; 2];
    for case in cases() {
        for &(t, phi, omega) in &case.samples {
            let mut stepper = Stepper::<R>::new(&case.motion);
            let steps = (t.abs() * 2048.0) as u32;
            (0..steps).for_each(|_| stepper.step(R::from_f64(t.signum() / 2048.0)));
            let attitude = stepper.attitude_state();
            let errors = [
                widened(attitude.orientation).distance(&phi),
                apart(&case, attitude.omega().map(Into::into), omega),
            ];
            worst = std::array::from_fn(|i| greater(worst[i], errors[i]));
        }
    }
    worst
}

#[test]
fn steppers_follow_the_truth() {
    let found = [of_steppers::<f64>(), of_steppers::<f32>()];
    for (budgets, errors) in tolerance::TOPS_STEPPER.into_iter().zip(found) {
        for (budget, error) in budgets.into_iter().zip(errors) {
            budget.check("stepper", error);
        }
    }
}

#[test]
fn closed_forms_agree() {
    let (mut worst, mut count) = ([0.0; 2], 0);
    for case in cases() {
        let Ok(form) = ClosedForm::of(&case.motion) else { continue };
        count += 1;
        for &(t, phi, omega) in &case.samples {
            let attitude = form.at(t);
            let errors = [attitude.orientation.distance(&phi), apart(&case, attitude.omega(), omega)];
            worst = std::array::from_fn(|i| greater(worst[i], errors[i]));
        }
    }
    assert_eq!(count, CLOSED_FORMS);
    for (budget, error) in tolerance::TOPS_CLOSED_FORMS.into_iter().zip(worst) {
        budget.check("closed form", error);
    }
}

/// Number of motions of the file with a closed form, which are those whose tip does not slide.
const CLOSED_FORMS: u32 = 15;

/// A motion depends on quotients only: a change of the units of mass and length by powers of two changes no bit.
#[test]
fn a_change_of_units_changes_no_bit() {
    let unit = |power: i32| 2.0_f64.powi(power);
    let top = |mass: f64, length: f64| {
        let inertia = mass * length * length;
        Top::sliding(&TopParameters {
            transverse_inertia: 1.3 * inertia,
            axial_inertia: 0.7 * inertia,
            com_height: 0.9 * length,
            mass_moment: 1.1 * mass * length,
            gravity: 1.7 * length,
            rotor_momentum: 0.3 * inertia,
            ..TopParameters::default()
        })
        .unwrap()
    };
    let release = toytop::Release { tilt: 0.5, spin: 3.0, precession: 0.25, ..Default::default() };
    let state = State::release(&release).unwrap();
    let motion = Motion::launch(&top(1.0, 1.0), &state).unwrap();
    // units in which the numbers are those of a molecule, a planet or a star
    for (mass, length) in [(unit(-85), unit(-33)), (unit(80), unit(23)), (unit(100), unit(-40))] {
        let other = Motion::launch(&top(mass, length), &state).unwrap();
        assert_eq!(motion.branch_points(), other.branch_points());
        assert_eq!(motion.period_advance(), other.period_advance());
        assert_eq!(motion.min_normal_force(), other.min_normal_force());
        let (one, far) = (motion.first_integrals(), other.first_integrals());
        let energy = mass * length * length;
        assert_eq!(
            [one.l * energy, one.n * energy, one.h * energy, one.spin],
            [far.l, far.n, far.h, far.spin]
        );
        let poses = [&motion, &other].map(|motion| {
            let mut stepper = Stepper::<f32>::new(motion);
            (0..100).for_each(|_| stepper.step(0.01));
            stepper.orientation()
        });
        assert_eq!(poses[0], poses[1]);
    }
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
    assert_eq!(count, 6);
}
