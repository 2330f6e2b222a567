//! Launch from sensors: a gyroscope, and an accelerometer's tilt.
//!
//! A gyroscope that is fixed to the body measures the angular velocity in the body frame, and an attitude filter estimates a
//! quaternion from body to fixed coordinates: `State::from_quaternion_and_gyro` takes the two as they are.

use toytop::{Motion, Orientation, State, TableF32, Tick, Top, TopParameters};

/// Orientation of a body whose accelerometer, at rest, measured this specific force (any unit, body frame): the shortest
/// rotation that takes the measured direction to the upward vertical. The heading is then 0 by definition.
fn levelled(force: [f64; 3]) -> Orientation<f64> {
    let length = force.iter().map(|component| component * component).sum::<f64>().sqrt();
    let [x, y, z] = force.map(|component| component / length);
    // From (x, y, z) to (0, 0, 1): the quaternion 1 + cos, and the cross product (y, -x, 0), normalised.
    Orientation::from_quaternion([1.0 + z, y, -x, 0.0]).normalised()
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let top = Top::sliding(&TopParameters::TOY)?;

    // Before the release the top is held at rest: an accelerometer reads the reaction to gravity, which points up.
    let orientation = levelled([1.96, 0.98, 9.56]);
    // At the release: the gyroscope, rad/s in the body frame. Its third component is the spin ω·r.
    let gyro = [0.4, -0.2, 150.0];
    let state = State::from_quaternion_and_gyro(orientation.quaternion(), gyro)?;

    let motion = Motion::launch(&top, &state)?;
    let table = TableF32::new(&motion, Tick::hertz(1000)?)?;
    let sample = table.at_tick(0);
    println!("tilt {:.4} rad", orientation.u().clamp(-1.0, 1.0).acos());
    println!("omega in the body frame, back from the motion: {:?} rad/s", sample.omega_body());
    println!("quaternion after a second: {:?}", table.at_tick(1000).quaternion());

    for (measured, back) in gyro.into_iter().zip(sample.omega_body()) {
        assert!((measured - f64::from(back)).abs() < 1e-3, "{measured} {back}");
    }
    // The vertical, seen from the body, is the direction that the accelerometer measured.
    let up = orientation.inverse().adjoint([0.0, 0.0, 1.0]);
    assert!((up[0] / up[2] - 1.96 / 9.56).abs() < 1e-12 && (up[1] / up[2] - 0.98 / 9.56).abs() < 1e-12);
    Ok(())
}
