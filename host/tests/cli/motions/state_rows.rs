//! Rows of `toytop state`: times, ticks, chosen columns, formats for programs, and many rows.

use crate::command::{branch_points, count, csv, folder, json, read, samples, scenario, toytop};
use std::f64::consts::PI;

#[test]
fn columns_follow_from_each_other() {
    let table =
        csv("state @lagrange --times=0..2/41 --columns axis,quaternion,angles,euler_zxz,omega,omega_body,t");
    let expected = "axis_x,axis_y,axis_z,w,x,y,z,tilt,azimuth,roll,euler_phi,euler_theta,euler_psi,\
                    omega_x,omega_y,omega_z,wx,wy,wz,t";
    assert_eq!(table.names, expected);
    for row in table.rows {
        let [ax, ay, az, w, x, y, z, tilt, azimuth, roll, phi, theta, psi, ox, oy, oz, bx, by, bz, t] =
            row[..]
        else {
            panic!("{row:?}")
        };
        let square = |a: [f64; 3]| a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        for (found, expected) in [
            (w * w + x * x + y * y + z * z, 1.0),
            // the third column of the rotation matrix
            (ax, 2.0 * (x * z + w * y)),
            (ay, 2.0 * (y * z - w * x)),
            (ax, tilt.sin() * azimuth.cos()),
            (ay, tilt.sin() * azimuth.sin()),
            (az, tilt.cos()),
            (theta, tilt),
            ((phi - azimuth).sin(), 1.0),
            ((psi - roll).sin(), -1.0),
            // the axial component is the same in both frames
            (ox * ax + oy * ay + oz * az, bz),
            (square([ox, oy, oz]), square([bx, by, bz])),
        ] {
            assert!((found - expected).abs() < 1e-12 * (1.0 + found.abs()), "{t}: {found} {expected}");
        }
        assert!([azimuth, roll, phi, psi].iter().all(|angle| angle.abs() <= PI));
    }
    let json = samples("@lagrange --times=0 --columns quaternion,u");
    let object = json[0].as_object().expect("an object");
    assert_eq!((object.len(), object["quaternion"].as_array().map(Vec::len)), (3, Some(4)));
}

#[test]
fn times_spread_evenly() {
    let listed = toytop("state @toy_top --times=-1,-0.5,0,0.5,1 --format csv").ok();
    assert_eq!(toytop("state @toy_top --from -1 --to 1 --count 5 --format csv").ok(), listed);
}

/// Ticks of an aperiodic motion, which has no table, are the times of its closed form.
#[test]
fn ticks_of_an_aperiodic_motion_are_times() {
    let rising = scenario("ticks_rising", &branch_points([0.2, 1.0, 1.0], 1));
    let ticks = toytop(format!("state {rising} --format csv --ticks=-3..4 --hertz 8")).ok();
    let times = toytop(format!("state {rising} --format csv --times=-0.375..0.5/8")).ok();
    assert_eq!(ticks, times);
}

/// Ticks give the same bits as the clock of a program on a chip.
#[test]
fn ticks_are_times_of_a_clock() {
    let ticks = csv("state @toy_top --ticks=-3..4 --hertz 44100/2").rows;
    let times: Vec<_> = (-3..=4).map(|n| (f64::from(n) * 2.0 / 44100.0).to_string()).collect();
    let by_time = csv(&format!("state @toy_top --times={}", times.join(","))).rows;
    assert_eq!(ticks.len(), 8);
    for (a, b) in ticks.iter().zip(&by_time) {
        assert_eq!(a[0], b[0]);
        assert!(a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-12 * (1.0 + y.abs())), "{a:?} {b:?}");
    }
    let far = csv("state @toy_top --ticks=1099511627776,0 --hertz 1000 --columns t,u").rows;
    assert_eq!((far[0][0], far[1][0]), (1_099_511_627.776, 0.0));
    let baked = csv("state @toy_top --ticks=5 --scalar q15 --columns alpha").rows;
    assert!(baked[0].iter().all(|x| (x * 16384.0).fract() == 0.0), "16 bits: {baked:?}");
}

/// More rows than are in memory at once come in order.
#[test]
fn many_rows_come_in_order() {
    let rows = csv("state @toy_top --times=0..10/100001 --columns t,u").rows;
    assert_eq!(rows.len(), 100_001);
    assert!(rows.iter().enumerate().all(|(i, row)| (row[0] - 1e-4 * i as f64).abs() < 1e-12));
    let parsed = json("state @toy_top --times=0..10/40001 --columns t");
    assert_eq!(parsed["samples"].as_array().map(Vec::len), Some(40_001));
    folder("state_file");
    assert_eq!(toytop("state @toy_top --times=0 --format csv -o state_file/rows.csv").ok(), "");
    assert_eq!((count("state_file"), read("state_file/rows.csv").lines().count()), (1, 2));
}
