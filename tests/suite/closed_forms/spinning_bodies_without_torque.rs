//! Bodies without torque that spin about their axis are compared with the rotation about this axis, and closed forms of small angular
//! momentum with tables.

use fixed::types::{I2F14, I2F30};
use toytop::{Motion, Orientation, Release, State, Stepper, TableScalar, Tick, Top, TopParameters};
use toytop_closed_forms::ClosedForm;
use toytop_tests::{check, greater, kilohertz, table_of, tolerance, widened, worst};

/// Distances of the tables of a body that spins about its axis, held without gravity or free, from the truth, beyond their
/// bounds. The angular momentum is along the axis, which therefore stays where it is.
fn of_spinning_body<R: TableScalar<Quantity: Into<f64>> + Into<f64>>(motion: &Motion, state: &State) -> f64 {
    // a wide nutation needs more than 64 segments in q31
    let table = table_of::<R, 128>(motion, kilohertz());
    let form = ClosedForm::from_motion(motion).unwrap();
    let beyond = [0.0, 0.3, 1.1].map(|t| {
        let phi = Orientation::exp(state.omega().map(|x| x * t)).compose(&state.orientation());
        let off = widened(table.at(t).orientation()).distance(&phi) - table.error_bound().after(1000.0 * t);
        greater(off, form.at(t).orientation.distance(&phi))
    });
    let start = Stepper::<f64>::new(motion).orientation().distance(&state.orientation());
    let norm = (state.orientation().norm_squared() - 1.0).abs();
    worst(beyond.into_iter().chain([start, norm]))
}

/// Without torque a small C other than 0 is refused, because the direction of C ω cannot be told; larger ones and 0 are right.
#[test]
fn a_spinning_body_without_torque_is_right_or_refused() {
    let (tilts, spins) = ([0.0, 0.3, 0.7, 1.3, 2.0, std::f64::consts::PI], [1.0, -2.1, 10.0, 0.01]);
    let refused = [1e-60, 1e-45, 1e-35, 1e-34, 1e-33, 1e-30, 1e-26, 1e-23, 0.99e-20];
    let right = [0.0, 1e-20, 1e-19, 1e-18, 1e-12, 1e-3, 0.5, 2.0];
    let mut greatest = 0.0;
    for a in [1.0, 3e-40] {
        for share in refused.into_iter().chain(right) {
            let parameters = TopParameters {
                transverse_inertia: a,
                axial_inertia: share * a,
                mass_moment: 1.0,
                gravity: 0.0,
                ..TopParameters::default()
            };
            for top in [Top::free(&parameters), Top::fixed(&parameters)] {
                let Ok(top) = top else {
                    let error = top.unwrap_err();
                    assert_eq!(error.parameter(), "axial_inertia");
                    assert!(
                        refused.contains(&share) && error.allowed().contains("1e-20"),
                        "{share}: {error}"
                    );
                    continue;
                };
                for (tilt, spin) in tilts.into_iter().flat_map(|tilt| spins.map(|spin| (tilt, spin))) {
                    let release = Release { tilt, azimuth: 0.4, roll: 0.2, spin, ..Release::default() };
                    let state = State::from_release(&release).unwrap();
                    let motion = Motion::launch(&top, &state).unwrap();
                    let errors = [
                        of_spinning_body::<f64>(&motion, &state),
                        of_spinning_body::<f32>(&motion, &state),
                        of_spinning_body::<I2F30>(&motion, &state),
                        of_spinning_body::<I2F14>(&motion, &state),
                    ];
                    greatest = greater(greatest, worst(errors));
                }
            }
        }
    }
    check("spinning body", greatest, tolerance::SPINNING_BODIES);
}

/// Closed form of a free body whose angular momentum |m| is far below A ⟨ω, r⟩, because C is small or because a rotor cancels C ⟨ω, r⟩,
/// against the table.
#[test]
fn a_small_angular_momentum_keeps_its_direction() {
    let mut greatest = 0.0;
    for (c, rotor_share) in [(1.0, 1.0), (0.3, 1.0), (1e-3, 1.0), (1e-6, 0.0), (1e-12, 0.0)] {
        for rate in [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
            let top = Top::free(&TopParameters {
                transverse_inertia: 1.0,
                axial_inertia: c,
                mass_moment: 1.0,
                gravity: 0.0,
                rotor_momentum: -rotor_share * c * (1.0 + 0.3 * rate),
                ..TopParameters::default()
            })
            .unwrap();
            let [precession, nutation] = [0.37, 0.11].map(|x| x * rate);
            let release = Release { tilt: 0.7, azimuth: 0.4, roll: 0.2, spin: 1.0, precession, nutation };
            let motion = Motion::launch(&top, &State::from_release(&release).unwrap()).unwrap();
            let form = ClosedForm::from_motion(&motion).unwrap();
            // slow ticks, because the error of the table grows with their number
            let table = table_of::<f64, 128>(&motion, Tick::hertz(1).unwrap());
            let period = motion.period_advance().unwrap().period;
            for t in (0..40_u8).map(|i| (f64::from(i) * 0.171 * period).round()) {
                let apart = form.at(t).orientation.distance(&table.at(t).orientation());
                greatest = greater(greatest, apart);
            }
        }
    }
    check("small angular momentum", greatest, tolerance::SMALL_ANGULAR_MOMENTUM);
}
