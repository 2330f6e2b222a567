//! The stepper is compared with itself at many more steps, which measures its order of convergence.

use toytop::{Motion, Orientation, Stepper};
use toytop_tests::vectors;

fn after(motion: &Motion, time: f64, steps: u32) -> Orientation<f64> {
    let mut stepper = Stepper::<f64>::new(motion);
    (0..steps).for_each(|_| stepper.step(time / f64::from(steps)));
    stepper.orientation()
}

/// Slope of log(error) over log(dt) between two numbers of steps, against a run with many more steps.
fn order(name: &str, time: f64) -> f64 {
    let motion = vectors::motion(name);
    let truth = after(&motion, time, 20_000);
    let error = |steps| after(&motion, time, steps).distance(&truth);
    (error(100) / error(400)).ln() / 4.0_f64.ln()
}

#[test]
fn the_stepper_is_of_fourth_order() {
    for (name, time) in [
        ("generic_AneC", 12.0),
        ("fig3_diff_e3_3", 9.0),
        ("vertical_pass_e2_1", 10.0),
        ("aperiodic_AneC", 9.0),
    ] {
        let order = order(name, time);
        assert!((3.7..4.4).contains(&order), "{name}: measured order {order:.2}");
    }
}

/// Where u is constant a step of any length is exact.
#[test]
fn steady_motions_are_exact_in_one_step() {
    let names =
        ["regular_precession", "regular_precession_fast", "sleeping_stable", "sleeping_unstable", "hanging"];
    let error = |motion: Motion| after(&motion, 1e6, 1).distance(&after(&motion, 1e6, 1000));
    assert_eq!(names.map(|name| error(vectors::motion(name))), [0.0; 5]);
}
