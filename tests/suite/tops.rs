//! Tops that the paper does not contain: with a rotor inside, without torque, without axial moment of inertia. They are compared with two
//! integrations to 30 digits (`tests/reference/tops.json`).

use fixed::types::{I2F14, I2F30};
use serde_json::Value;
use toytop::exact::ClosedForm;
use toytop::scalar::Real;
use toytop::{
    BranchPoints, Complex, EphemerisScalar, Motion, Orientation, State, Stepper, Tick, Top, TopParameters,
};
use toytop_tests::{boxed, greater, tolerance, vectors, widened};

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
    for case in cases() {
        let ephemeris = boxed::<R, SEGMENTS>(&case.motion, Tick::hertz(1000).unwrap());
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

/// A free body turns about its angular momentum once in a nutation period, and a pendulum has the period of its motion.
#[test]
fn closed_forms_have_the_period_of_the_motion() {
    let mut count = [0; 2];
    for case in cases() {
        let (Ok(form), Some(advance)) = (ClosedForm::of(&case.motion), case.motion.period_advance()) else {
            continue;
        };
        let near = |x: f64, y: f64| assert!((x - y).abs() <= 4e-16 * y.abs(), "{x} {y}");
        match form {
            ClosedForm::FreeBody(form) => {
                count[0] += 1;
                near(form.precession() * advance.period, std::f64::consts::TAU);
                let length: f64 = form.direction().iter().map(|component| component * component).sum();
                near(length, 1.0);
                let Some([start, next]) =
                    form.nutation_phase(0.0).zip(form.nutation_phase(advance.period)).map(<[_; 2]>::from)
                else {
                    continue;
                };
                near((next - start).to_f64(), 1.0);
            }
            ClosedForm::Pendulum(form) => {
                count[1] += 1;
                near(form.period(), advance.period);
            }
            _ => {}
        }
    }
    assert!(count.iter().all(|count| *count > 0), "{count:?}");
}

/// A rotor changes only n = C spin + K: a top without a rotor and with C' = n/spin has the same motion of the axis.
#[test]
fn a_rotor_is_worth_its_momentum() {
    let parameters = TopParameters {
        transverse_inertia: 1.25,
        axial_inertia: 0.75,
        com_height: 0.5,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    };
    let plain = Top::sliding(&TopParameters { axial_inertia: 1.5, ..parameters }).unwrap();
    let with = Top::sliding(&TopParameters { rotor_momentum: 1.5, ..parameters }).unwrap();
    let state =
        State::release(&toytop::Release { tilt: 0.5, spin: 2.0, precession: 0.25, ..Default::default() })
            .unwrap();
    let [plain, with] = [plain, with].map(|top| Motion::launch(&top, &state).unwrap());
    // ω·r of the state, and the momentum that the rotor replaces, are 2 except for rounding
    let near = |x: f64, y: f64| assert!((x - y).abs() < 4e-15 * (1.0 + y.abs()), "{x} {y}");
    let (e, other_e) = (plain.branch_points(), with.branch_points());
    near(e.e1, other_e.e1);
    near(e.e2, other_e.e2);
    near(e.e3, other_e.e3);
    near(plain.min_normal_force().unwrap(), with.min_normal_force().unwrap());
    let (one, other) = (plain.first_integrals(), with.first_integrals());
    near(one.l, other.l);
    near(one.n, other.n);
    near(one.spin, other.spin);
    // h does not contain the energy of the rotor
    near(one.h, other.h + 0.5 * 0.75 * 4.0);
    let phi = |motion: &Motion| motion.period_advance().unwrap().phi_per_period();
    near(phi(&plain), phi(&with));
}

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

/// A free body is the limit of weak gravity: with half the gravity the difference is half as large.
#[test]
fn a_free_body_is_the_limit_of_weak_gravity() {
    let body = TopParameters {
        transverse_inertia: 1.25,
        axial_inertia: 0.5,
        mass_moment: 1.0,
        ..TopParameters::default()
    };
    let release =
        toytop::Release { tilt: 0.5, spin: 3.0, precession: 0.5, nutation: 0.75, ..Default::default() };
    let state = State::release(&release).unwrap();
    let at_two = |top: Top| Stepper::<f64>::new(&Motion::launch(&top, &state).unwrap()).after(2.0);
    let free = at_two(Top::free(&body).unwrap());
    let distances = [1e-6, 5e-7, 2.5e-7]
        .map(|gravity| at_two(Top::fixed(&TopParameters { gravity, ..body }).unwrap()).distance(&free));
    assert!(distances[0] > 1e-7, "{distances:?}");
    for pair in distances.windows(2) {
        assert!((pair[0] / pair[1] - 2.0).abs() < 1e-4, "{distances:?}");
    }
    assert_eq!(at_two(Top::fixed(&TopParameters { gravity: 0.0, ..body }).unwrap()), free);
}

/// Stepper at a later time, reached in small steps.
trait After {
    fn after(self, t: f64) -> Orientation<f64>;
}

impl After for Stepper<f64> {
    fn after(mut self, t: f64) -> Orientation<f64> {
        (0..4096).for_each(|_| self.step(t / 4096.0));
        self.orientation()
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
