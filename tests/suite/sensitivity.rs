//! Partial derivatives against central differences of launches in 192 bits.

use toytop::su2::Vector;
use toytop::{Motion, Sensitivity};
use toytop_host::truth::exact::{Exact, PreciseOrientation};
use toytop_host::truth::precise::{Precise, precise, product, to_f64};
use toytop_host::truth::state_constants::Launched;
use toytop_host::truth::states::StateNumbers;
use toytop_tests::tolerance;

/// Relative change of an input: so small that its square is negligible after a million periods, and exact in `f64` for
/// inputs with few digits.
const CHANGE: f64 = 1.0 / (1_u64 << 46) as f64;
/// Half the time between the two orientations that give a rate, as a share of the period. With 2⁻³² the errors are a hundred
/// times as large, because they are then errors of the truth, divided by this time.
const INSTANT: f64 = 1.0 / (1_u64 << 24) as f64;

/// Motion, and whether its tip is held.
struct Case {
    name: &'static str,
    held: bool,
    numbers: StateNumbers,
}

/// Case of A, C, s, p, g and K, of Φ and of ω; s = 0 for a held tip.
fn case(name: &'static str, top: [f64; 6], phi: [[f64; 2]; 2], omega: [f64; 3]) -> Case {
    // of unit norm to 12 digits, and with few binary digits, so that changes are exact
    let norm = phi.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    let few = (1_u64 << 40) as f64;
    let phi = phi.map(|pair| pair.map(|x| (x / norm * few).round() / few));
    let [_, _, s, ..] = top;
    Case { name, held: s == 0.0, numbers: StateNumbers { top, phi, omega } }
}

/// Numbers with few binary digits, so that their changes are exact.
fn cases() -> Vec<Case> {
    let toy = [3.0 / 131_072.0, 2.0 / 131_072.0, 0.03125, 3.0 / 2048.0, 9.8125, 0.0];
    let unit = [1.25, 0.75, 0.625, 1.0, 1.0, 0.0];
    let leaning = [[0.96875, 0.125], [-0.1875, 0.0625]];
    let upright = [[1.0, 0.0], [0.0, 0.0]];
    vec![
        case("toy top", toy, leaning, [-22.5, 4.0, 149.5]),
        case("slow", unit, leaning, [0.25, -0.5, 1.75]),
        case("held", [1.25, 0.75, 0.0, 1.0, 1.0, 0.0], leaning, [0.25, -0.5, 1.75]),
        case("rotor", [1.25, 0.75, 0.625, 1.0, 1.0, 1.5], leaning, [0.25, -0.5, 0.75]),
        case("held rotor", [1.25, 0.75, 0.0, 1.0, 1.0, -2.5], leaning, [0.25, -0.5, 0.75]),
        case("hanging low", unit, [[0.25, 0.125], [-0.9375, 0.1875]], [0.5, 0.25, -1.0]),
        case("through the vertical", unit, upright, [0.5, 0.0, 4.0]),
        case("sleeping", unit, upright, [0.0, 0.0, 4.0]),
        case("slender", [0.015625, 0.0234375, 1.0, 1.0, 1.0, 0.0], leaning, [0.25, -0.5, 12.0]),
    ]
}

impl Case {
    fn motion(&self) -> Motion {
        self.numbers.motion().unwrap()
    }

    /// Inputs with one number changed, and the change as multiples of the ten columns: (input, index).
    fn changed(&self, input: usize, sign: f64) -> StateNumbers {
        let mut numbers = self.numbers;
        let slots = numbers.phi.iter_mut().flatten().chain(&mut numbers.omega).chain(&mut numbers.top);
        for (index, slot) in slots.enumerate() {
            if index == input {
                *slot += sign * CHANGE * if *slot == 0.0 { 0.25 } else { slot.abs() };
            }
        }
        // K/A is no column
        let [a, .., momentum] = &mut numbers.top;
        *momentum *= *a / self.numbers.top[0];
        numbers
    }

    /// Change of the four ratios by both inputs.
    fn ratios(&self, numbers: &StateNumbers) -> [Precise; 4] {
        let [a, c, s, p, g, _] = numbers.top.map(precise);
        let leverage = if self.held { &a / &p } else { &a / (&p * &s) };
        [a / c, leverage, s, g]
    }
}

fn unit(z: &[[f64; 2]; 2]) -> PreciseOrientation {
    let [alpha, beta] = z.map(|pair| pair.map(precise));
    let norm = [&alpha, &beta].into_iter().flatten().fold(precise(0.0), |sum, x| sum + x * x).sqrt();
    PreciseOrientation { alpha: alpha.map(|x| x / &norm), beta: beta.map(|x| x / &norm) }
}

/// Rotation vector from the second orientation to the first, to the third order.
fn rotation(to: &PreciseOrientation, from: &PreciseOrientation) -> [Precise; 3] {
    let conj = |[re, im]: &[Precise; 2]| [re.clone(), -im];
    let [_, a1] = product(&to.alpha, &conj(&from.alpha));
    let [_, a2] = product(&to.beta, &conj(&from.beta));
    let [b1, c1] = product(&to.beta, &from.alpha);
    let [b2, c2] = product(&to.alpha, &from.beta);
    [(c1 - c2) << 1, (b2 - b1) << 1, (a1 + a2) << 1]
}

fn norm(x: Vector<f64>) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn apart(x: Vector<f64>, y: Vector<f64>) -> f64 {
    norm([x[0] - y[0], x[1] - y[1], x[2] - y[2]])
}

/// Greatest error of θ and η, relative to both, with the input and the time at which it occurs.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    error: f64,
    /// Index of the changed number among those of Φ, of ω and of the top.
    input: usize,
    periods: f64,
}

/// Greatest error at some times.
fn worst(case: &Case, periods: &[f64]) -> Worst {
    let motion = case.motion();
    let sensitivity = Sensitivity::of(&motion);
    let period = motion.period_advance().unwrap().period;
    let mut worst = Worst::default();
    for input in 0..12 {
        if case.held && input == 9 {
            continue;
        }
        let [plus, minus] = [1.0, -1.0].map(|sign| case.changed(input, sign));
        let [up, down] = [&plus, &minus].map(|numbers| Exact::launched(&Launched::new(numbers)));
        let turned = rotation(&unit(&plus.phi), &unit(&minus.phi)).map(|x| to_f64(&x));
        let [ratios_up, ratios_down] = [&plus, &minus].map(|numbers| case.ratios(numbers));
        let mut change = [0.0; 10];
        change[..3].copy_from_slice(&turned);
        for k in 0..3 {
            change[3 + k] = plus.omega[k] - minus.omega[k];
        }
        for (slot, (a, b)) in change[6..].iter_mut().zip(ratios_up.iter().zip(&ratios_down)) {
            *slot = to_f64(&(a - b));
        }
        for share in periods {
            let t = share * period;
            let partials = sensitivity.at(t).unwrap();
            let predicted = |columns: [Vector<f64>; 10]| {
                let mut total = [0.0; 3];
                for (column, by) in columns.iter().zip(change) {
                    for (slot, x) in total.iter_mut().zip(column) {
                        *slot += x * by;
                    }
                }
                total
            };
            let theta = predicted(partials.orientation());
            let eta = partials.in_fixed(predicted(partials.omega_body()));
            let dt = precise(period * INSTANT);
            let difference = |t: &Precise| rotation(&up.at(t), &down.at(t));
            let [before, now, after] = [-1.0, 0.0, 1.0].map(|k| difference(&(precise(t) + precise(k) * &dt)));
            let true_theta = now.map(|x| to_f64(&x));
            let true_eta = [0, 1, 2].map(|k| to_f64(&((&after[k] - &before[k]) / (&dt + &dt))));
            let frequency = 2.0 * std::f64::consts::PI / period;
            // a change without effect on the motion, such as that of A for a sleeping top, gives no scale for its error
            let size = (norm(true_theta) + norm(true_eta) / frequency).max(1e-9 * CHANGE);
            let error = apart(theta, true_theta) + apart(eta, true_eta) / frequency;
            // so that NaN counts
            let is_less = error <= worst.error * size;
            if !is_less {
                worst = Worst { error: error / size, input, periods: *share };
            }
        }
    }
    worst
}

#[test]
fn derivatives_agree_with_differences_of_launches() {
    let mut worst_of_all = 0.0;
    for case in cases() {
        let found = worst(&case, &[0.01, 0.3, -0.75, 2.4, 1000.1, 1e6 + 0.4]);
        let Worst { error, input, periods } = found;
        println!("{}: {error:.1e}, input {input}, {periods} periods", case.name);
        // the axis is fast near the vertical, where the difference quotient of the truth is less accurate (see `INSTANT`)
        if case.name == "slender" {
            assert!(error < 3e-10, "{error:e}");
            continue;
        }
        worst_of_all = if found.error <= worst_of_all { worst_of_all } else { found.error };
    }
    tolerance::SENSITIVITY.check("derivatives", worst_of_all);
}

/// The three known changes keep their form at all times: θ = k for a rotation about the vertical, θ = r for a rotation of the body about
/// its axis, and θ = ω for a shift of time.
#[test]
fn the_known_changes_are_kept() {
    let cross = toytop::su2::bracket;
    for case in cases() {
        let motion = case.motion();
        let sensitivity = Sensitivity::of(&motion);
        let [start, soon, before] = [0.0, 1e-7, -1e-7].map(|t| sensitivity.at(t).unwrap());
        let (omega, axis) = (start.angular_velocity(), start.axis());
        let rate = [0, 1, 2].map(|k| (soon.angular_velocity()[k] - before.angular_velocity()[k]) / 2e-7);
        let up = [0.0, 0.0, 1.0];
        let period = motion.period_advance().unwrap().period;
        for t in [0.4 * period, 30.2 * period] {
            let now = sensitivity.at(t).unwrap();
            let known = [
                (up, cross(up, omega), up),
                (axis, [0.0; 3], now.axis()),
                (omega, rate, now.angular_velocity()),
            ];
            for (which, (theta, change, expected)) in known.into_iter().enumerate() {
                let mut found = [0.0; 3];
                for (column, by) in now.orientation().iter().zip(theta.into_iter().chain(change)) {
                    found = [0, 1, 2].map(|k| found[k] + column[k] * by);
                }
                // the rate of omega is a difference quotient
                let tolerance = if which == 2 { 1e-4 } else { 1e-9 };
                let off = apart(found, expected) / norm(expected);
                assert!(off < tolerance, "{}, {which}: {off:e}", case.name);
            }
        }
    }
}

/// Changes of the tip, of its angle, of the specific force and of a seen direction are those of slightly different motions.
#[test]
fn what_follows_from_the_orientation_changes_with_it() {
    let case = &cases()[0];
    let t = 0.37;
    let [plus, minus] = [1.0, -1.0].map(|sign| {
        let mut case = case_with(case, sign * 1e-6);
        case.name = "changed";
        Sensitivity::of(&case.motion()).at(t).unwrap()
    });
    let partials = Sensitivity::of(&case.motion()).at(t).unwrap();
    // the sixth column is that of the vertical component of omega
    let slope = |up: f64, down: f64| (up - down) / 2e-6;
    let place = [0.01, -0.02, 0.015];
    let (up, _) = plus.specific_force(place);
    let (down, _) = minus.specific_force(place);
    let (_, columns) = partials.specific_force(place);
    for k in 0..3 {
        let (found, expected) = (columns[5][k], slope(up[k], down[k]));
        assert!((found - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{k}: {found} {expected}");
    }
    let field = [0.3, -0.4, 0.5];
    let (_, columns) = partials.direction(field);
    for (k, found) in columns[5].iter().enumerate() {
        let expected = slope(plus.in_body(field)[k], minus.in_body(field)[k]);
        assert!((found - expected).abs() < 1e-6, "{k}: {found} {expected}");
    }
    let s = case.numbers.top[2];
    let [x, y] = [0, 1].map(|k| -s * slope(plus.axis()[k], minus.axis()[k]));
    let tip = partials.tip()[5];
    assert!((tip.re - x).abs() < 1e-8 && (tip.im - y).abs() < 1e-8, "{tip:?} {x} {y}");
    let angle = |partials: &toytop::Partials| partials.axis()[1].atan2(partials.axis()[0]);
    let expected = slope(angle(&plus), angle(&minus));
    assert!((partials.tip_angle().unwrap()[5] - expected).abs() < 1e-6);
    let orientation = partials.orientation_now();
    let apart_from_axis = apart(orientation.axis(), partials.axis());
    assert!(apart_from_axis < 1e-14, "{apart_from_axis:e}");
}

/// The case with another vertical component of omega.
fn case_with(case: &Case, change: f64) -> Case {
    let mut numbers = case.numbers;
    numbers.omega[2] += change;
    Case { name: case.name, held: case.held, numbers }
}

/// A body at rest on which no torque acts has no frequency of its own; its partial derivatives are those of a rotation.
#[test]
fn a_body_at_rest_has_partials_at_any_time() {
    let top = toytop::Top::free(&toytop::TopParameters {
        transverse_inertia: 2.0,
        axial_inertia: 1.0,
        ..toytop::TopParameters::default()
    })
    .unwrap();
    let state = toytop::State::new(toytop::Orientation::IDENTITY, [0.0; 3]).unwrap();
    let motion = Motion::launch(&top, &state).unwrap();
    for t in [0.0, 0.2, -3.0, 1e6] {
        let partials = Sensitivity::of(&motion).at(t).expect("a result");
        assert_eq!(partials.orientation_now(), state.orientation(), "{t}");
        // a change of ω rotates the body for the time t
        let by_rate = partials.orientation()[3];
        assert!((by_rate[0] / t.abs().max(1e-300) - t.signum()).abs() < 1e-9 || t == 0.0, "{t}: {by_rate:?}");
    }
}
