//! Partial derivatives are compared with central differences of launches in 640 bits, and with their growth where it has no bound.

use std::thread;
use toytop::su2::{Vector, cross};
use toytop::{Complex, Motion, Orientation, State, Stepper, Support, TopParameters};
use toytop_fit::{Partials, Sensitivity};
use toytop_host::input::scenario::{Launch, MotionInput};
use toytop_host::reference::float640::{Float640, Orientation640, from_f64, product, to_f64};
use toytop_host::reference::quadrature::Quadrature;
use toytop_tests::{apart, check, greater, length, tolerance, top_of, worst};

/// Relative change of an input: so small that its square is negligible after a million periods, and exact in `f64` for
/// inputs with few digits.
const CHANGE: f64 = 1.0 / (1_u64 << 46) as f64;
/// Half the time between the two orientations that give a rate, as a share of the period. With 2⁻³² the errors are a hundred
/// times as large, because they are then errors of the truth, divided by this time.
const INSTANT: f64 = 1.0 / (1_u64 << 24) as f64;

/// Numbers A, C, s, p, g and K of a top, and a state. s = 0 means a held tip, and p = 0 a free body.
#[derive(Clone, Copy)]
struct Given {
    top: [f64; 6],
    phi: [[f64; 2]; 2],
    omega: Vector<f64>,
}

const LEANING: [[f64; 2]; 2] = [[0.96875, 0.125], [-0.1875, 0.0625]];
const UPRIGHT: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 0.0]];
/// Numbers with few binary digits, so that their changes are exact.
const TOY: [f64; 6] = [3.0 / 131_072.0, 2.0 / 131_072.0, 0.03125, 3.0 / 2048.0, 9.8125, 0.0];

impl Given {
    fn new(top: [f64; 6], phi: [[f64; 2]; 2], omega: Vector<f64>) -> Self {
        // of unit norm to 12 digits, and with few binary digits, so that changes are exact
        let norm = phi.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
        let few = (1_u64 << 40) as f64;
        Self { top, phi: phi.map(|pair| pair.map(|x| (x / norm * few).round() / few)), omega }
    }

    fn numbers(&self) -> MotionInput {
        let [a, c, s, p, g, k] = self.top;
        let top = TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass_moment: p,
            gravity: g,
            rotor_momentum: k,
            ..TopParameters::default()
        };
        let support = match (s > 0.0, p > 0.0) {
            (true, _) => Support::Sliding,
            (false, true) => Support::Fixed,
            (false, false) => Support::Free,
        };
        let [alpha, beta] = self.phi.map(|[re, im]| Complex::new(re, im));
        let launch = Launch::State { orientation: Orientation { alpha, beta }, omega: self.omega };
        MotionInput { support, top, launch }
    }

    fn partials(&self, t: f64) -> Partials {
        Sensitivity::new(&self.numbers().motion().unwrap()).at(t).unwrap()
    }

    /// Inputs with one number changed, of those of Φ, of ω and of the top.
    fn changed(&self, input: usize, sign: f64) -> Self {
        let mut given = *self;
        let mut slots = given.phi.iter_mut().flatten().chain(&mut given.omega).chain(&mut given.top);
        let slot = slots.nth(input).unwrap();
        *slot += sign * CHANGE * if *slot == 0.0 { 0.25 } else { slot.abs() };
        // K/A is no column
        given.top[5] *= given.top[0] / self.top[0];
        given
    }

    /// Ratios A/C, A/(ps) (A/p for a held tip), s and g.
    fn ratios(&self) -> [Float640; 4] {
        let [a, c, s, p, g, _] = self.top.map(from_f64);
        // a ratio that is infinite has no effect
        let over = |x: Float640| if x == from_f64(0.0) { x } else { &a / x };
        [over(c), over(if self.top[2] == 0.0 { p } else { p * &s }), s, g]
    }

    fn unit(&self) -> Orientation640 {
        let [alpha, beta] = self.phi.map(|pair| pair.map(from_f64));
        let norm = [&alpha, &beta].into_iter().flatten().fold(from_f64(0.0), |sum, x| sum + x * x).sqrt();
        Orientation640 { alpha: alpha.map(|x| x / &norm), beta: beta.map(|x| x / &norm) }
    }
}

/// Rotation vector from the second orientation to the first, to the third order.
fn rotation(to: &Orientation640, from: &Orientation640) -> [Float640; 3] {
    let conj = |[re, im]: &[Float640; 2]| [re.clone(), -im];
    let [_, a1] = product(&to.alpha, &conj(&from.alpha));
    let [_, a2] = product(&to.beta, &conj(&from.beta));
    let [b1, c1] = product(&to.beta, &from.alpha);
    let [b2, c2] = product(&to.alpha, &from.beta);
    [(c1 - c2) << 1, (b2 - b1) << 1, (a1 + a2) << 1]
}

/// Greatest error at some times, of θ and η relative to both.
fn error(given: &Given, periods: &[f64]) -> f64 {
    let motion = given.numbers().motion().unwrap();
    let sensitivity = Sensitivity::new(&motion);
    let period = motion.period_advance().map_or(1.0, |advance| advance.period);
    let at = |share: &f64| (share * period, sensitivity.at(share * period).unwrap());
    let partials: Vec<_> = periods.iter().map(at).collect();
    // C = 0 is the end of its range, s = 0 is a held tip, and p = 0 is a free body
    let inputs: Vec<_> = (0..12).filter(|input| *input < 7 || given.top[input - 7] != 0.0).collect();
    let of_inputs = |half: usize| {
        let inputs = inputs.iter().skip(half).step_by(2);
        worst(inputs.map(|input| error_of_change(given, *input, period, &partials)))
    };
    thread::scope(|scope| {
        let other = scope.spawn(|| of_inputs(1));
        greater(of_inputs(0), other.join().unwrap())
    })
}

/// Greatest error of a change of one input.
fn error_of_change(given: &Given, input: usize, period: f64, partials: &[(f64, Partials)]) -> f64 {
    let frequency = std::f64::consts::TAU / period;
    let [plus, minus] = [1.0, -1.0].map(|sign| given.changed(input, sign));
    let [up, down] = [&plus, &minus].map(|numbers| Quadrature::new(&numbers.numbers()));
    let turned = rotation(&plus.unit(), &minus.unit()).map(|x| to_f64(&x));
    let ratios = plus.ratios().into_iter().zip(minus.ratios()).map(|(up, down)| to_f64(&(up - down)));
    // ω turns with Φ
    let by_turn = cross(turned, given.omega);
    let omega = [0, 1, 2].map(|k| plus.omega[k] - minus.omega[k] - by_turn[k]);
    let change: Vec<f64> = turned.into_iter().chain(omega).chain(ratios).collect();
    worst(partials.iter().map(|(t, partials)| {
        let predicted = |columns: [Vector<f64>; 10]| {
            [0, 1, 2].map(|k| columns.iter().zip(&change).map(|(column, by)| column[k] * by).sum::<f64>())
        };
        let theta = predicted(partials.d_orientation());
        let eta = partials.in_fixed(predicted(partials.d_omega_body()));
        let dt = from_f64(period * INSTANT);
        let [before, after] = [-1.0, 1.0].map(|k| {
            let t = from_f64(*t) + from_f64(k) * &dt;
            rotation(&up.at(&t), &down.at(&t))
        });
        // the mean is θ at t to (2π INSTANT)², which is 1e-13
        let true_theta = [0, 1, 2].map(|k| to_f64(&((&after[k] + &before[k]) >> 1)));
        let true_eta = [0, 1, 2].map(|k| to_f64(&((&after[k] - &before[k]) / (&dt + &dt))));
        // a change without effect on the motion, such as that of A for a sleeping top, gives no scale for its error
        let size = (length(true_theta) + length(true_eta) / frequency).max(1e-9 * CHANGE);
        (apart(theta, true_theta) + apart(eta, true_eta) / frequency) / size
    }))
}

/// A toy top, slow, held, with rotors, hanging low, through the vertical, sleeping, and slender.
#[test]
fn derivatives_agree_with_differences_of_launches() {
    let [unit, held] = [0.625, 0.0].map(|s| [1.25, 0.75, s, 1.0, 1.0, 0.0]);
    let rotor = |[a, c, s, p, g, _]: [f64; 6], momentum: f64| [a, c, s, p, g, momentum];
    let times = [0.01, 0.3, -0.75, 2.4, 1000.1, 1e6 + 0.4];
    let errors = [
        Given::new(TOY, LEANING, [-22.5, 4.0, 149.5]),
        Given::new(unit, LEANING, [0.25, -0.5, 1.75]),
        Given::new(held, LEANING, [0.25, -0.5, 1.75]),
        Given::new(rotor(unit, 1.5), LEANING, [0.25, -0.5, 0.75]),
        Given::new(rotor(held, -2.5), LEANING, [0.25, -0.5, 0.75]),
        Given::new(unit, [[0.25, 0.125], [-0.9375, 0.1875]], [0.5, 0.25, -1.0]),
        Given::new(unit, UPRIGHT, [0.5, 0.0, 4.0]),
        Given::new(unit, UPRIGHT, [0.0, 0.0, 4.0]),
        Given::new([0.015625, 0.0234375, 1.0, 1.0, 1.0, 0.0], LEANING, [0.25, -0.5, 12.0]),
    ]
    .map(|given| error(&given, &times));
    check("derivatives", worst(errors), tolerance::DERIVATIVES);
}

/// Bodies from a thin rod to a disc, C = 2A, sliding, held and free; each sliding body with and without a rotor, of the others every second one.
#[test]
fn derivatives_are_right_for_every_axial_inertia() {
    let moving = [0.25, -0.5, 1.75];
    // a free body at rest has no frequency of its own
    for (s, p, omega) in [(0.625, 1.0, moving), (0.0, 1.0, moving), (0.0, 0.0, moving), (0.0, 0.0, [0.0; 3])]
    {
        let bodies = [0.0, 1e-9, 0.5, 1.25, 2.5].into_iter().flat_map(|c| [(c, 0.0), (c, 1.5)]);
        for (c, k) in bodies.step_by(if s > 0.0 { 1 } else { 3 }) {
            let given = Given::new([1.25, c, s, p, 1.0, k], LEANING, omega);
            let found = error(&given, &[0.3, 2.4, 1000.1]);
            let most = if omega == moving { 1e-10 } else { 1e-9 };
            assert!(found < most, "s = {s}, p = {p}, C = {c}, K = {k}, {omega:?}: {found:e}");
        }
    }
}

/// Derivatives of the unstable sleeping top grow without bound. Beyond the range of the numbers there are none.
#[test]
fn derivatives_of_an_unstable_top_are_right_or_none() {
    thread::scope(|scope| {
        for spin in [0.0, 0.5, 1.0] {
            scope.spawn(move || check_unstable(spin));
        }
    });
}

fn check_unstable(spin: f64) {
    let top = top_of([1.25, 0.75, 0.625, 1.0], 1.0);
    let state = State::new(Orientation::IDENTITY, [0.0, 0.0, spin]).unwrap();
    let sensitivity = Sensitivity::new(&Motion::launch(&top, &state).unwrap());
    // the tilt in a frame that turns by (C S/2A) t obeys x'' = rate² x
    let half = 0.5 * 0.6 * spin;
    let rate = (1.0 / 1.25 - half * half).sqrt();
    let mut cursor = sensitivity;
    for growth in [1.0, 30.0, 300.0, 340.0, 360.0, 380.0, 500.0, 700.0, 720.0, 900.0, 3000.0] {
        let t = growth / rate;
        for found in [sensitivity.at(t), cursor.advance_to(t)] {
            let Some(found) = found else {
                assert!(growth > 300.0, "{spin}, {growth}");
                continue;
            };
            let [x, y, _] = found.d_orientation()[3];
            let off = x.hypot(y) / ((rate * t).sinh() / rate) - 1.0;
            assert!(off.abs() < 1e-9, "{spin}, {growth}: {off:e}");
        }
    }
}

/// Changes of the tip, of its angle, of the specific force and of a seen direction are those of slightly different motions.
#[test]
fn derivatives_of_readings_agree_with_differences() {
    let at = |change: f64| Given::new(TOY, LEANING, [-22.5, 4.0, 149.5 + change]).partials(0.37);
    let [partials, plus, minus] = [0.0, 1e-6, -1e-6].map(at);
    // the sixth column is that of the vertical component of omega
    let slope = |of: &dyn Fn(&Partials) -> Vector<f64>| {
        let (up, down) = (of(&plus), of(&minus));
        [0, 1, 2].map(|k| (up[k] - down[k]) / 2e-6)
    };
    let (place, field) = ([0.01, -0.02, 0.015], [0.3, -0.4, 0.5]);
    let expected = slope(&|at| at.specific_force(place).0);
    let off = apart(partials.specific_force(place).1[5], expected);
    assert!(off < 1e-6 * (1.0 + length(expected)), "{off:e}, {expected:?}");
    let off = apart(partials.direction(field).1[5], slope(&|at| at.in_body(field)));
    assert!(off < 1e-6, "{off:e}");
    let [x, y, _] = slope(&|at| at.axis()).map(|rate| -TOY[2] * rate);
    let tip = partials.d_tip()[5];
    assert!((tip.re - x).abs() < 1e-8 && (tip.im - y).abs() < 1e-8, "{tip:?} {x} {y}");
    let [angle, ..] = slope(&|at| [at.axis()[1].atan2(at.axis()[0]), 0.0, 0.0]);
    assert!((partials.d_tip_angle().unwrap()[5] - angle).abs() < 1e-6);
    assert!(apart(partials.orientation().axis(), partials.axis()) < 1e-14);
}

/// Specific force and a seen direction are those of three positions and orientations of the stepper.
#[test]
fn readings_agree_with_the_stepped_motion() {
    let (place, field, t, dt) = ([0.01, -0.02, 0.015], [0.3, -0.4, 0.5], 0.37, 1e-5);
    let [a, c, _, p, g, k] = TOY;
    for top in [TOY, [a, c, 0.0, p, g, k]] {
        let given = Given::new(top, LEANING, [-22.5, 4.0, 149.5]);
        let at = |t: f64| {
            let mut stepper = Stepper::<f64>::new(&given.numbers().motion().unwrap());
            (0..4096).for_each(|_| stepper.step(t / 4096.0));
            stepper.orientation()
        };
        let [before, now, after] = [-dt, 0.0, dt].map(|by| at(t + by));
        // the centre of mass of a sliding top stays above one point of the plane
        let position = |phi: &Orientation<f64>| {
            let [x, y, z] = phi.adjoint(place);
            [x, y, z + top[2] * phi.u()]
        };
        let [x0, x1, x2] = [before, now, after].map(|phi| position(&phi));
        let [x, y, z] = [0, 1, 2].map(|k| (x2[k] - 2.0 * x1[k] + x0[k]) / (dt * dt));
        let expected = now.inverse().adjoint([x, y, z + g]);
        let partials = given.partials(t);
        let off = apart(partials.specific_force(place).0, expected) / length(expected);
        assert!(off < 1e-6, "{off:e}, {expected:?}");
        assert!(apart(partials.in_body(field), now.inverse().adjoint(field)) < 1e-11);
    }
}
