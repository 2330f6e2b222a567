//! Partial derivatives where they are known in closed form: free bodies, and the unstable upright top.

use super::sensitivity::{apart, norm};
use toytop::su2::Vector;
use toytop::{Motion, Orientation, State, Top, TopParameters};
use toytop_fit::Sensitivity;

/// A free body turns about its angular momentum and about its axis, each at a constant rate.
#[test]
fn derivatives_of_a_free_body_are_right_for_every_axial_inertia() {
    let bodies = [0.0, 1e-9, 0.5, 1.25, 2.5].into_iter().flat_map(|c| [(c, 0.0), (c, 1.5)]);
    // a body at rest has no frequency of its own
    let rates = [[0.25, -0.5, 1.75], [0.0; 3]];
    for ((c, k), omega) in bodies.flat_map(|body| rates.map(|omega| (body, omega))) {
        let top = Top::free(&TopParameters {
            transverse_inertia: 1.25,
            axial_inertia: c,
            rotor_momentum: k,
            ..TopParameters::default()
        });
        let top = top.unwrap();
        let phi = Orientation::exp([0.3, -0.8, 0.2]);
        let motion = Motion::launch(&top, &State::new(phi, omega).unwrap()).unwrap();
        let sensitivity = Sensitivity::new(&motion);
        for t in [0.7, 9.3, 250.0] {
            let at = |phi: Orientation<f64>, omega: Vector<f64>| {
                let axis = phi.axis();
                let spin: f64 = (0..3).map(|i| axis[i] * omega[i]).sum();
                let n = (c * spin + k) / 1.25;
                let momentum = [0, 1, 2].map(|i| omega[i] + (n - spin) * axis[i]);
                Orientation::exp(momentum.map(|x| x * t)).compose(&phi).compose(&Orientation::exp([
                    0.0,
                    0.0,
                    (spin - n) * t,
                ]))
            };
            for (column, found) in sensitivity.at(t).unwrap().orientation().into_iter().enumerate().take(6) {
                let changed = |sign: f64| {
                    let mut change = [0.0; 6];
                    change[column] = sign * 1e-6;
                    let [a, b, c, x, y, z] = change;
                    at(Orientation::exp([a, b, c]).compose(&phi), [omega[0] + x, omega[1] + y, omega[2] + z])
                };
                let [_, x, y, z] = changed(1.0).compose(&changed(-1.0).inverse()).quaternion();
                let expected = [x, y, z].map(|x| x / 1e-6);
                let off = apart(found, expected) / (1.0 + norm(expected));
                assert!(off < 1e-6, "C = {c}, K = {k}, {t}, {column}: {found:?} {expected:?}");
            }
        }
    }
}

/// Derivatives of the unstable sleeping top grow without bound. Beyond the range of the numbers there are none.
#[test]
fn derivatives_of_an_unstable_top_are_right_or_none() {
    for spin in [0.0, 0.5, 1.0] {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 1.25,
            axial_inertia: 0.75,
            com_height: 0.625,
            mass: 1.6,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        let state = State::new(Orientation::IDENTITY, [0.0, 0.0, spin]).unwrap();
        let sensitivity = Sensitivity::new(&Motion::launch(&top, &state).unwrap());
        // the tilt in a frame that turns by (C S/2A) t obeys x'' = rate² x
        let half = 0.5 * 0.6 * spin;
        let rate = (1.0 / 1.25 - half * half).sqrt();
        let mut cursor = sensitivity.cursor();
        for growth in [1.0, 30.0, 300.0, 340.0, 360.0, 380.0, 500.0, 700.0, 720.0, 900.0, 3000.0] {
            let t = growth / rate;
            for found in [sensitivity.at(t), cursor.at(t)] {
                let Some(found) = found else {
                    assert!(growth > 300.0, "{spin}, {growth}");
                    continue;
                };
                let [x, y, _] = found.orientation()[3];
                let expected = (rate * t).sinh() / rate;
                let off = x.hypot(y) / expected - 1.0;
                assert!(off.abs() < 1e-9, "{spin}, {growth}: {off:e}");
            }
        }
    }
}
