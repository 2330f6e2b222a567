//! Rates of a table are compared with the closed forms, which share no table with it, in every scalar, and with each other.

use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::su2::Vector;
use toytop::{AttitudeState, Complex, Motion, Sample, SizedTable, TableScalar, Tick};
use toytop_closed_forms::ClosedForm;
use toytop_tests::{apart, length, vectors, worst};

/// Ticks in a unit of time of the vectors, a power of two, so that the time of a tick is exact.
const RATE: u32 = 64;

fn wide<W: Float>(vector: Vector<W>) -> Vector<f64> {
    vector.map(Float::to_f64)
}

/// Greatest of the errors of Ω, ω, u' and the tip's velocity over s, rad per unit time.
fn error<R: TableScalar>(sample: Sample<'_, R>, truth: &AttitudeState<f64>, tip_scale: f64) -> f64 {
    let (velocity, rate) = (sample.tip_velocity(), truth.rate);
    let exact = (rate.alpha * truth.orientation.beta + truth.orientation.alpha * rate.beta).scaled(2.0);
    let off = Complex::new(velocity.re.to_f64() / tip_scale, velocity.im.to_f64() / tip_scale) - exact;
    worst([
        apart(wide(sample.omega_body()), truth.omega_body()),
        apart(wide(sample.omega()), truth.omega()),
        (sample.udot().to_f64() - truth.udot()).abs(),
        off.modulus(),
    ])
}

/// Greatest error of the rates over their bound, for every vector that has a closed form and fits the table.
fn errors_over_bounds<R: TableScalar, const SEGMENTS: usize>() -> Vec<f64> {
    let tick = Tick::hertz(RATE).unwrap();
    let of_motion = |motion: Motion| {
        let form = ClosedForm::from_motion(&motion).ok()?;
        let table = SizedTable::<R, SEGMENTS>::new(&motion, tick).ok()?;
        let (bound, scale) = (table.rate_error_bound(), motion.top().tip_scale());
        let ticks = (-1000..1000).chain([1 << 30, -(1 << 30)]);
        Some(ticks.fold(0.0_f64, |worst, n| {
            let truth = form.at(n as f64 / f64::from(RATE));
            // the closed form has the rounding of f64, and that of the phases at t = 0
            let allowed = bound.after(n as f64) + 2e-15 * length(truth.omega());
            worst.max(error(table.at_tick(n), &truth, scale) / allowed)
        }))
    };
    vectors::tabulated()
        .filter(|vector| vector.is_exact())
        .filter_map(|vector| of_motion(vector.motion().ok()?))
        .collect()
}

/// No error exceeds its bound, and most errors are near it.
fn check_ratios(name: &str, mut ratios: Vec<f64>) {
    ratios.sort_by(f64::total_cmp);
    assert!(ratios.len() > 8, "{name}: {} motions", ratios.len());
    assert!(ratios.last().is_some_and(|worst| *worst <= 1.0), "{name}: {ratios:?}");
    // in f64 the roundings along the path count in one direction
    let least = if name == "f64" { 0.05 } else { 0.1 };
    assert!(ratios[ratios.len() / 2] > least, "{name}: the bound is too lax: {ratios:?}");
}

#[test]
fn rates_are_within_their_bound() {
    check_ratios("f64", errors_over_bounds::<f64, 256>());
    check_ratios("f32", errors_over_bounds::<f32, 128>());
    check_ratios("q31", errors_over_bounds::<I2F30, 512>());
    check_ratios("q15", errors_over_bounds::<I2F14, 128>());
}

/// The axial component is the constant n/C in every scalar, and the rates of two ways of evaluation agree.
fn consistent<R: TableScalar, const SEGMENTS: usize>(rounding: f64) {
    let motion = vectors::motion("generic_AneC");
    let table = SizedTable::<R, SEGMENTS>::new(&motion, Tick::hertz(RATE).unwrap()).unwrap();
    let axial = motion.first_integrals().n / motion.top().axial_inertia();
    for n in -500..500 {
        let sample = table.at_tick(n);
        let omega_body = sample.omega_body();
        let [.., x3] = wide(omega_body);
        assert!((x3 / axial - 1.0).abs() <= rounding, "{n}: {x3} {axial}");
        let state = sample.attitude_state();
        let size = length(wide(omega_body));
        for (ours, others) in [(state.omega_body(), omega_body), (state.omega(), sample.omega())] {
            let off = apart(wide(ours), wide(others)) / size;
            assert!(off < 40.0 * R::ROUNDING.max(rounding), "{n}: {off:e}");
        }
    }
}

#[test]
fn rates_of_two_evaluations_agree() {
    let single = f64::from(f32::EPSILON);
    consistent::<f64, 64>(f64::EPSILON);
    consistent::<f32, 64>(single);
    consistent::<I2F30, 512>(single);
    consistent::<I2F14, 128>(single);
}
