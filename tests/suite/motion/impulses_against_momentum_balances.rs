//! Impulses are compared with the balances of momentum of a free body whose support answers with an impulse of its own.

use nalgebra::{Matrix3, Vector3};
use toytop::su2::Vector;
use toytop::{PointImpulse, State, Support, Top, TopParameters};
use toytop_tests::random::Random;
use toytop_tests::{TOY, apart, check, check_all, greater, keep, length, tolerance, toy};

type V = Vector3<f64>;

/// Top with the moments of inertia of [`TOY`] about the centre of mass.
fn top(support: Support) -> Top {
    let transverse_inertia = TOY.transverse_inertia + TOY.mass * TOY.com_height * TOY.com_height;
    match support {
        Support::Sliding => Top::sliding(&TOY),
        Support::Free => Top::free(&TOY),
        Support::Fixed => Top::fixed(&TopParameters { transverse_inertia, ..TOY }),
    }
    .unwrap()
}

/// Vector with components in [-scale, scale).
fn vector(random: &mut Random, scale: f64) -> Vector<f64> {
    [0; 3].map(|_| scale * (2.0 * random.fraction() - 1.0))
}

/// State of any tilt, an impulse of up to 5 mN s, and a point within 6 cm.
fn stroke(random: &mut Random) -> (State, Vector<f64>, Vector<f64>) {
    let quaternion = [0; 4].map(|_| 2.0 * random.fraction() - 1.0);
    let norm = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    let gyro = vector(random, 100.0);
    let state = State::from_quaternion_and_gyro(quaternion.map(|x| x / norm), gyro).unwrap();
    (state, vector(random, 5e-3), vector(random, 0.06))
}

/// Change of ω, and the impulse of the support, by the balances of momentum about the centre of mass: the tip keeps its velocity in the
/// directions in which the support holds it.
fn by_balances(support: Support, state: &State, impulse: V, point: V) -> [V; 2] {
    let rotation = Matrix3::from_row_slice(state.orientation().normalised().matrix().as_flattened());
    let inertia =
        Matrix3::from_diagonal(&V::new(TOY.transverse_inertia, TOY.transverse_inertia, TOY.axial_inertia));
    let inverse = (rotation * inertia * rotation.transpose()).try_inverse().unwrap();
    let tip = rotation * V::new(0.0, 0.0, -TOY.com_height);
    // points of a free body are from the centre of mass
    let arm = rotation * point + if support == Support::Free { V::zeros() } else { tip };
    let of_tip = |impulse: V, arm: V| impulse / TOY.mass + (inverse * arm.cross(&impulse)).cross(&tip);
    let moved = of_tip(impulse, arm);
    let response = Matrix3::from_columns(&[V::x(), V::y(), V::z()].map(|unit| of_tip(unit, tip)));
    let reaction = match support {
        Support::Fixed => response.try_inverse().unwrap() * -moved,
        Support::Sliding => V::new(0.0, 0.0, -moved.z / response[(2, 2)]),
        Support::Free => V::zeros(),
    };
    [inverse * (arm.cross(&impulse) + tip.cross(&reaction)), reaction]
}

#[test]
fn an_impulse_obeys_the_balances_of_momentum() {
    let mut errors = [0.0; 2];
    for support in [Support::Sliding, Support::Fixed, Support::Free] {
        let (top, mut random) = (top(support), Random(17));
        for _ in 0..200 {
            let (state, impulse, point) = stroke(&mut random);
            let after = state.with_impulse(&top, &PointImpulse { impulse, point }).unwrap();
            let reaction = state.reaction_impulse(&top, &PointImpulse { impulse, point }).unwrap();
            let [omega, answer] =
                by_balances(support, &state, impulse.into(), point.into()).map(Vector::from);
            let change = std::array::from_fn(|i| after.omega()[i] - state.omega()[i]);
            keep(
                &mut errors,
                [apart(change, omega) / length(omega), apart(reaction, answer) / length(impulse)],
            );
            assert_eq!(after.orientation(), state.orientation());
        }
    }
    check_all(["change of omega", "reaction"], errors, tolerance::IMPULSES_BALANCES);
}

/// The support compensates any impulse at the tip of a held top, and a vertical impulse at a sliding tip. A horizontal impulse
/// at a sliding tip moves the top.
#[test]
fn impulses_along_the_reaction_have_no_effect() {
    let (mut random, mut greatest) = (Random(3), 0.0);
    for _ in 0..100 {
        let (state, impulse, _) = stroke(&mut random);
        // change of ω, relative to that by the same impulse at the rim
        let effect = |top: &Top, impulse, point| {
            let change = |point| {
                apart(
                    state.with_impulse(top, &PointImpulse { impulse, point }).unwrap().omega(),
                    state.omega(),
                )
            };
            change(point) / change([0.03, 0.02, TOY.com_height])
        };
        let ([x, y, z], held) = (impulse, top(Support::Fixed));
        assert_eq!(effect(&held, impulse, [0.0; 3]), 0.0);
        assert!(effect(&toy(), [x, y, 0.0], [0.0; 3]) > 1e-2);
        // an impulse on the centre of mass along the plane moves the top and does not turn it
        assert_eq!(effect(&toy(), [x, y, 0.0], [0.0, 0.0, TOY.com_height]), 0.0);
        greatest = greater(greatest, effect(&toy(), [0.0, 0.0, z], [0.0; 3]));
        for (top, impulse) in [(held, impulse), (toy(), [0.0, 0.0, z])] {
            let reaction = state.reaction_impulse(&top, &PointImpulse { impulse, point: [0.0; 3] }).unwrap();
            let sum = apart(reaction, impulse.map(|x| -x));
            assert!(sum < 1e-15 * length(impulse) + 1e-18, "{reaction:?} {impulse:?}");
        }
    }
    check("vertical impulse at the tip", greatest, tolerance::IMPULSES_WITHOUT_EFFECT);
}

/// A state from a gyroscope's reading has this reading, for any norm of the quaternion within its limits.
#[test]
fn a_gyroscope_reads_what_the_state_has() {
    let gyro = [0.4, -0.2, 150.0];
    for norm in [1.0 - 4e-7, 1.0, 1.0 + 4e-7] {
        let state = State::from_quaternion_and_gyro([0.1, 0.7, -0.1, 0.7].map(|x| x * norm), gyro).unwrap();
        let back = state.orientation().normalised().inverse().adjoint(state.omega());
        assert!(apart(back, gyro) < 1e-12, "{norm}: {back:?}");
        assert!((length(state.omega()) - length(gyro)).abs() < 1e-12);
    }
}
