//! Tests of `toytop state`: chosen columns, ticks, formats for programs, and many rows.

use super::{folder, run, sample, samples, stderr, stdout};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::Path;

/// Names and rows of a CSV text.
fn table(csv: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = csv.lines();
    let words = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let number = |word: &String| if word.is_empty() { f64::NAN } else { word.parse().expect("a number") };
    let names = words(lines.next().expect("a header"));
    (names, lines.map(|line| words(line).iter().map(number).collect()).collect())
}

fn csv(arguments: &[&str]) -> (Vec<String>, Vec<Vec<f64>>) {
    let output = run(&[arguments, &["--format", "csv"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    table(stdout(&output))
}

#[test]
fn columns_follow_from_each_other() {
    let file = sample("lagrange");
    let columns = "axis,quaternion,angles,euler_zxz,omega,omega_body,t";
    let (names, rows) = csv(&["state", &file, "--times=0..2/41", "--columns", columns]);
    let expected = "axis_x,axis_y,axis_z,w,x,y,z,tilt,azimuth,roll,euler_phi,euler_theta,euler_psi,\
                    omega_x,omega_y,omega_z,wx,wy,wz,t";
    assert_eq!(names.join(","), expected);
    for row in rows {
        let [ax, ay, az, w, x, y, z, tilt, azimuth, roll, phi, theta, psi, ox, oy, oz, bx, by, bz, t] =
            row[..]
        else {
            panic!("{row:?}")
        };
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12 * (1.0 + a.abs());
        assert!(near(w * w + x * x + y * y + z * z, 1.0));
        // the third column of the rotation matrix
        assert!(near(ax, 2.0 * (x * z + w * y)) && near(ay, 2.0 * (y * z - w * x)), "{t}");
        assert!(
            near(az, tilt.cos())
                && near(ax, tilt.sin() * azimuth.cos())
                && near(ay, tilt.sin() * azimuth.sin())
        );
        assert!(
            near(theta, tilt) && near((phi - azimuth).sin(), 1.0) && near((psi - roll).sin(), -1.0),
            "{t}"
        );
        assert!([azimuth, roll, phi, psi].iter().all(|angle| angle.abs() <= PI));
        let along = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        assert!(
            near(along([ox, oy, oz], [ax, ay, az]), bz),
            "the axial component is the same in both frames"
        );
        assert!(near(along([ox, oy, oz], [ox, oy, oz]), along([bx, by, bz], [bx, by, bz])), "{t}");
    }
    let json = samples(&file, "0", &["--columns", "quaternion,u"]);
    let object = json[0].as_object().expect("an object");
    assert_eq!((object.len(), object["quaternion"].as_array().map(Vec::len)), (2, Some(4)));
    let named =
        run(&["state", &file, "--times=0", "--format", "csv", "--units", "--columns", "t,u,omega,tip,phi"]);
    let header = stdout(&named).lines().next().expect("a header").to_owned();
    assert_eq!(header, "t [s],u,omega_x [rad/s],omega_y [rad/s],omega_z [rad/s],tip_x,tip_y,phi [rad]");
}

/// Ticks give the same bits as the clock of a program on a chip.
#[test]
fn ticks_are_times_of_a_clock() {
    let file = sample("toy_top");
    let (_, ticks) = csv(&["state", &file, "--ticks=-3..4", "--tick", "44100/2"]);
    let times: Vec<_> = (-3..=4).map(|n| (f64::from(n) * 2.0 / 44100.0).to_string()).collect();
    let (_, by_time) = csv(&["state", &file, &format!("--times={}", times.join(","))]);
    assert_eq!(ticks.len(), 8);
    for (a, b) in ticks.iter().zip(&by_time) {
        assert_eq!(a[0], b[0]);
        assert!(a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-12 * (1.0 + y.abs())), "{a:?} {b:?}");
    }
    let (_, far) = csv(&["state", &file, "--ticks=1099511627776,0", "--hertz", "1000", "--columns", "t,u"]);
    assert_eq!((far[0][0], far[1][0]), (1_099_511_627.776, 0.0));
    let (_, baked) = csv(&["state", &file, "--ticks=5", "--scalar", "q15", "--columns", "alpha"]);
    assert!(baked[0].iter().all(|x| (x * 16384.0).fract() == 0.0), "16 bits: {baked:?}");
    for (arguments, part) in [
        (&["--ticks", "1..0"][..], "--ticks: 1..0: must be N1,N2,... or FIRST..LAST"),
        (&["--times", "1", "--hertz", "5"], "--hertz, --tick: need --ticks"),
        (&["--ticks", "1", "--tick", "0/1"], "--tick"),
        (&["--times", "1", "--columns", "t,speed"], "speed"),
    ] {
        let output = run(&[&["state", &file], arguments].concat());
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}");
        assert!(stderr(&output).contains(part), "{}", stderr(&output));
    }
}

#[test]
fn a_numpy_file_has_the_numbers_of_csv() {
    let (file, folder) = (sample("sleeping"), folder("state_npy"));
    let to = folder.join("rows.npy");
    let arguments = ["state", &file, "--times=0..1/3000", "--columns", "t,omega,phi"];
    let output = run(&[&arguments[..], &["--format", "npy", "-o", to.to_str().expect("UTF-8")]].concat());
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{}", stderr(&output));
    let bytes = std::fs::read(&to).expect("the file");
    let (magic, rest) = bytes.split_at(10);
    assert_eq!(&magic[..8], b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([magic[8], magic[9]]));
    assert_eq!((length + 10) % 64, 0);
    let (head, numbers) = rest.split_at(length);
    let head = String::from_utf8_lossy(head);
    assert!(
        head.starts_with("{'descr': [('t', '<f8'), ('omega_x', '<f8'), ") && head.ends_with('\n'),
        "{head}"
    );
    assert!(head.contains("'fortran_order': False, 'shape': (3000,)"), "{head}");
    let numbers: Vec<f64> =
        numbers.chunks(8).map(|eight| f64::from_le_bytes(eight.try_into().expect("eight"))).collect();
    let (_, rows) = csv(&arguments);
    assert_eq!(numbers.len(), 5 * 3000);
    assert!(
        numbers
            .iter()
            .zip(rows.concat())
            .all(|(a, b)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()))
    );
    assert!(numbers[4].is_nan(), "a vertical axis has no tip angle");
}

/// More rows than are in memory at once come in order, and a closed pipe is no failure.
#[test]
fn many_rows_come_in_order() {
    let file = sample("toy_top");
    let (_, rows) = csv(&["state", &file, "--times=0..10/100001", "--columns", "t,u"]);
    assert_eq!(rows.len(), 100_001);
    assert!(rows.iter().enumerate().all(|(i, row)| (row[0] - 1e-4 * i as f64).abs() < 1e-12));
    let output = run(&["state", &file, "--times=0..10/40001", "--format", "json", "--columns", "t"]);
    let parsed: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(parsed["samples"].as_array().map(Vec::len), Some(40_001));
    let to = folder("state_file").join("rows.csv");
    let output = run(&["state", &file, "--times=0", "--format", "csv", "-o", to.to_str().expect("UTF-8")]);
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""));
    assert!(Path::new(&to).exists());
    let refused = run(&["state", &file, "--times=0..1/5000001", "--method", "stepper"]);
    assert!(
        stderr(&refused).contains("--times: 5000001 times: must be at most 5000000"),
        "{}",
        stderr(&refused)
    );
}

#[cfg(not(feature = "parquet"))]
#[test]
fn without_parquet_it_is_refused() {
    let output = run(&["state", &sample("toy_top"), "--times=0", "--format", "parquet"]);
    assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""));
    assert!(stderr(&output).contains("--features parquet"), "{}", stderr(&output));
}

/// The numbers of a Parquet file are those of CSV, with null where a number does not exist.
#[cfg(feature = "parquet")]
#[test]
fn a_parquet_file_has_the_numbers_of_csv() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;
    let (file, folder) = (sample("sleeping"), folder("state_parquet"));
    let to = folder.join("rows.parquet");
    let arguments = ["state", &file, "--times=0..1/3000", "--units", "--columns", "t,omega,phi"];
    let output = run(&[&arguments[..], &["--format", "parquet", "-o", to.to_str().expect("UTF-8")]].concat());
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{}", stderr(&output));
    let reader = SerializedFileReader::new(std::fs::File::open(&to).expect("the file")).expect("Parquet");
    let names: Vec<_> =
        reader.metadata().file_metadata().schema_descr().columns().iter().map(|c| c.name()).collect();
    assert_eq!(names, ["t", "omega_x", "omega_y", "omega_z", "phi"]);
    let (_, rows) = csv(&arguments);
    let mut count = 0;
    for (row, expected) in reader.get_row_iter(None).expect("rows").zip(&rows) {
        let row = row.expect("a row");
        assert!((0..4).all(|i| row.get_double(i).expect("a number") == expected[i]));
        assert!(row.get_double(4).is_err(), "a vertical axis has no tip angle");
        count += 1;
    }
    assert_eq!((count, rows.len()), (3000, 3000));
}
