//! Partial derivatives against central differences of launches in 192 bits.

use toytop::Motion;
use toytop::su2::Vector;
use toytop_fit::Sensitivity;
use toytop_host::truth::exact::{Exact, PreciseOrientation};
use toytop_host::truth::motions::{Numbers, Start};

use toytop_host::truth::precise::{Precise, precise, product, to_f64};
use toytop_tests::check;

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
    given: Given,
}

/// Numbers of a top and a state.
#[derive(Clone, Copy)]
struct Given {
    top: [f64; 6],
    phi: [[f64; 2]; 2],
    omega: Vector<f64>,
}

impl Given {
    fn numbers(&self) -> Numbers {
        Numbers { top: self.top, start: Start::State { phi: self.phi, omega: self.omega } }
    }
}

/// Case of A, C, s, p, g and K, of Φ and of ω; s = 0 for a held tip.
fn case(name: &'static str, top: [f64; 6], phi: [[f64; 2]; 2], omega: [f64; 3]) -> Case {
    // of unit norm to 12 digits, and with few binary digits, so that changes are exact
    let norm = phi.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    let few = (1_u64 << 40) as f64;
    let phi = phi.map(|pair| pair.map(|x| (x / norm * few).round() / few));
    let [_, _, s, ..] = top;
    Case { name, held: s == 0.0, given: Given { top, phi, omega } }
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
        self.given.numbers().motion().unwrap()
    }

    /// Inputs with one number changed, and the change as multiples of the ten columns: (input, index).
    fn changed(&self, input: usize, sign: f64) -> Given {
        let mut numbers = self.given;
        let slots = numbers.phi.iter_mut().flatten().chain(&mut numbers.omega).chain(&mut numbers.top);
        for (index, slot) in slots.enumerate() {
            if index == input {
                *slot += sign * CHANGE * if *slot == 0.0 { 0.25 } else { slot.abs() };
            }
        }
        // K/A is no column
        let [a, .., momentum] = &mut numbers.top;
        *momentum *= *a / self.given.top[0];
        numbers
    }

    /// Change of the four ratios by both inputs.
    fn ratios(&self, numbers: &Given) -> [Precise; 4] {
        let [a, c, s, p, g, _] = numbers.top.map(precise);
        let leverage = if self.held { &a / &p } else { &a / (&p * &s) };
        // the infinite A/C of a thin rod has no effect
        let inertia = if numbers.top[1] == 0.0 { precise(0.0) } else { a / c };
        [inertia, leverage, s, g]
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

pub(super) fn norm(x: Vector<f64>) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub(super) fn apart(x: Vector<f64>, y: Vector<f64>) -> f64 {
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
    let sensitivity = Sensitivity::new(&motion);
    let period = motion.period_advance().unwrap().period;
    let mut worst = Worst::default();
    for input in 0..12_usize {
        // C = 0 is the end of its range, and s = 0 is a held tip
        if case.given.top[input.saturating_sub(7)] == 0.0 && (input == 8 || input == 9) {
            continue;
        }
        let [plus, minus] = [1.0, -1.0].map(|sign| case.changed(input, sign));
        let [up, down] = [&plus, &minus].map(|numbers| Exact::new(&numbers.numbers()));
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
    check("derivatives", worst_of_all, 1e-10);
}

/// Bodies from a thin rod to a disc, C = 2A, with and without a rotor.
#[test]
fn derivatives_are_right_for_every_axial_inertia() {
    let leaning = [[0.96875, 0.125], [-0.1875, 0.0625]];
    for (s, c, k) in [0.0, 0.625]
        .into_iter()
        .flat_map(|s| [0.0, 1e-9, 0.5, 1.25, 2.5].map(|c| (s, c)))
        .flat_map(|(s, c)| [(s, c, 0.0), (s, c, 1.5)])
    {
        let one = case("body", [1.25, c, s, 1.0, 1.0, k], leaning, [0.25, -0.5, 1.75]);
        let found = worst(&one, &[0.3, 1.0, 2.4, 1000.1]);
        assert!(found.error < 1e-10, "s = {s}, C = {c}, K = {k}: {found:?}");
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
        Sensitivity::new(&case.motion()).at(t).unwrap()
    });
    let partials = Sensitivity::new(&case.motion()).at(t).unwrap();
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
    let s = case.given.top[2];
    let [x, y] = [0, 1].map(|k| -s * slope(plus.axis()[k], minus.axis()[k]));
    let tip = partials.tip()[5];
    assert!((tip.re - x).abs() < 1e-8 && (tip.im - y).abs() < 1e-8, "{tip:?} {x} {y}");
    let angle = |partials: &toytop_fit::Partials| partials.axis()[1].atan2(partials.axis()[0]);
    let expected = slope(angle(&plus), angle(&minus));
    assert!((partials.tip_angle().unwrap()[5] - expected).abs() < 1e-6);
    let orientation = partials.orientation_now();
    let apart_from_axis = apart(orientation.axis(), partials.axis());
    assert!(apart_from_axis < 1e-14, "{apart_from_axis:e}");
}

/// The case with another vertical component of omega.
fn case_with(case: &Case, change: f64) -> Case {
    let mut given = case.given;
    given.omega[2] += change;
    Case { name: case.name, held: case.held, given }
}
