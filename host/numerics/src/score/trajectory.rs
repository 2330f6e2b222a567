//! Trajectory of a CSV file: columns by name, and statements about the run in comment lines above the header.

use crate::Failure;
use crate::input::rows::unread;
use crate::output::shown;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::Path;
use toytop::{Complex, Orientation};

/// Row of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Time, s.
    pub t: f64,
    /// Orientation, normalised. Its sign is the file's.
    pub orientation: Orientation<f64>,
    /// Distance of the file's quaternion from unit norm, or half that of RᵀR from the unit matrix.
    pub norm_error: f64,
    /// Angular velocity in the fixed frame, rad/s, if the file has it.
    pub omega: Option<[f64; 3]>,
}

/// Times and orientations of one run of an integrator.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// Name of the file.
    pub name: String,
    /// Name of the method, from a line `# method = NAME`.
    pub method: Option<String>,
    /// Step size in s, from a line `# step = H`.
    pub step: Option<f64>,
    /// Evaluations of the equations, from a line `# evaluations = N`.
    pub evaluations: Option<f64>,
    /// Rows, at least one, with monotone times.
    pub rows: Vec<Row>,
}

/// Greatest length of a line above the header, bytes.
const LONGEST_COMMENT: u64 = 1 << 16;

/// Columns of the orientation in a file, one of three sets; the first that is complete counts.
const ORIENTATIONS: [&[&str]; 3] = [
    &["w", "x", "y", "z"],
    &["alpha_re", "alpha_im", "beta_re", "beta_im"],
    &["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"],
];
/// Columns of the angular velocity: in the body frame, or in the fixed frame.
const RATES: [&[&str]; 2] = [&["wx", "wy", "wz"], &["omega_x", "omega_y", "omega_z"]];

impl Trajectory {
    /// Trajectory of a file, which is read row by row.
    ///
    /// # Errors
    /// [`Failure::Input`] with the file and the line: a column is missing, a value is not a finite number or no rotation, or a time is out
    /// of order.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        Self::parse(&name, BufReader::new(file))
    }

    fn parse(name: &str, mut text: impl BufRead) -> Result<Self, Failure> {
        let refuse = |reason: String| Failure::Input(format!("{name}: {reason}"));
        let (comments, header) = head(&mut text).map_err(|error| refuse(error.to_string()))?;
        let stated = |key: &str| stated(&comments, key);
        let positive = |key: &str| match stated(key) {
            None => Ok(None),
            Some(value) => value
                .parse()
                .ok()
                .filter(|x| *x > 0.0 && f64::is_finite(*x))
                .map(Some)
                .ok_or_else(|| refuse(format!("# {key} = {}: must be a number above 0", shown(&value)))),
        };
        let (step, evaluations) = (positive("step")?, positive("evaluations")?);
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(header.chain(text));
        let columns =
            Columns::of(reader.headers().map_err(|error| refuse(error.to_string()))?).map_err(&refuse)?;
        let mut rows: Vec<Row> = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| refuse(unread(&error)))?;
            let line = record.position().map_or(0, csv::Position::line);
            let row = columns.row(&record).map_err(|reason| refuse(format!("line {line}: {reason}")))?;
            if !goes_on(&rows, row.t) {
                return Err(refuse(format!("line {line}: t: must go on in one direction from row to row")));
            }
            rows.push(row);
        }
        if rows.is_empty() {
            return Err(refuse("must hold at least one row below the header".to_owned()));
        }
        Ok(Self { name: name.to_owned(), method: stated("method"), step, evaluations, rows })
    }

    /// Trajectory in other body axes, where `body` takes the file's body coordinates to the new ones.
    #[must_use]
    pub fn in_body_axes(mut self, body: &Orientation<f64>) -> Self {
        let inverse = body.inverse();
        for row in &mut self.rows {
            row.orientation = row.orientation.compose(&inverse);
        }
        self
    }

    /// Spacing of the rows, s, if it is constant to a millionth; `None` otherwise.
    #[must_use]
    pub fn spacing(&self) -> Option<f64> {
        let [first, .., last] = &self.rows[..] else { return None };
        let mean = (last.t - first.t) / (self.rows.len() - 1) as f64;
        let even = |pair: &[Row]| (pair[1].t - pair[0].t - mean).abs() <= 1e-6 * mean.abs();
        self.rows.windows(2).all(even).then_some(mean.abs())
    }
}

/// Lines above the header that begin with #, and what a reader of CSV has to read before the rest.
fn head(text: &mut impl BufRead) -> io::Result<(Vec<String>, Cursor<Vec<u8>>)> {
    let mut comments = Vec::new();
    loop {
        let mut line = Vec::new();
        text.by_ref().take(LONGEST_COMMENT).read_until(b'\n', &mut line)?;
        let line = line.strip_prefix("\u{feff}".as_bytes()).map_or(line.clone(), <[u8]>::to_vec);
        if !line.starts_with(b"#") {
            // with a line for each comment, so that lines are counted as they stand in the file
            let before = "\n".repeat(comments.len()).into_bytes();
            return Ok((comments, Cursor::new([before, line].concat())));
        }
        comments.push(String::from_utf8_lossy(&line).into_owned());
    }
}

/// Value of `# key = value` above the header.
fn stated(comments: &[String], key: &str) -> Option<String> {
    let mut values = comments.iter().filter_map(|line| {
        let (name, value) = line.strip_prefix('#')?.split_once('=')?;
        (name.trim() == key).then(|| value.trim().to_owned())
    });
    values.next()
}

fn goes_on(rows: &[Row], t: f64) -> bool {
    match rows {
        [] => true,
        [only] => t != only.t,
        [first, second, ..] => {
            let last = rows[rows.len() - 1];
            if second.t > first.t { t > last.t } else { t < last.t }
        }
    }
}

/// Indices of the columns that are read.
struct Columns {
    t: usize,
    /// Index into [`ORIENTATIONS`], and indices of its columns.
    orientation: (usize, Vec<usize>),
    /// Index into [`RATES`], and indices of its columns.
    rates: Option<(usize, Vec<usize>)>,
}

impl Columns {
    fn of(header: &csv::StringRecord) -> Result<Self, String> {
        // a unit in brackets is no part of the name
        let without_unit = |name: &str| name.split(['[', '(']).next().unwrap_or_default().trim().to_owned();
        let names: Vec<_> = header.iter().map(without_unit).collect();
        let place = |name: &&str| names.iter().position(|found| found == name);
        let first = |sets: &[&[&str]]| {
            let places = |set: &[&str]| set.iter().map(place).collect::<Option<Vec<_>>>();
            sets.iter().enumerate().find_map(|(which, set)| Some((which, places(set)?)))
        };
        let allowed =
            "t with w,x,y,z (body to fixed), alpha_re,alpha_im,beta_re,beta_im or r11,r12,...,r33 (by rows)";
        let refusal = || format!("columns: must have {allowed}; has {}", shown(&names.join(",")));
        Ok(Self {
            t: place(&"t").ok_or_else(refusal)?,
            orientation: first(&ORIENTATIONS).ok_or_else(refusal)?,
            rates: first(&RATES),
        })
    }

    fn row(&self, record: &csv::StringRecord) -> Result<Row, String> {
        let number = |place: usize, name: &str| {
            let text = record.get(place).unwrap_or_default();
            let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
            number.ok_or_else(|| format!("{name}: {:?} must be a finite number", shown(text)))
        };
        let numbers = |places: &[usize], names: &[&str]| -> Result<Vec<f64>, String> {
            places.iter().zip(names).map(|(place, name)| number(*place, name)).collect()
        };
        let (which, places) = &self.orientation;
        let (orientation, norm_error) = orientation(*which, &numbers(places, ORIENTATIONS[*which])?)?;
        let omega = match &self.rates {
            None => None,
            Some((which, places)) => {
                let omega = numbers(places, RATES[*which])?;
                let omega = [omega[0], omega[1], omega[2]];
                Some(if *which == 0 { orientation.adjoint(omega) } else { omega })
            }
        };
        Ok(Row { t: number(self.t, "t")?, orientation, norm_error, omega })
    }
}

/// Orientation from the columns of one of [`ORIENTATIONS`], and their distance from a rotation.
fn orientation(which: usize, numbers: &[f64]) -> Result<(Orientation<f64>, f64), String> {
    let raw = match (which, numbers) {
        (0, &[w, x, y, z]) => Orientation::from_quaternion([w, x, y, z]),
        (1, &[a, b, c, d]) => Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) },
        _ => return matrix(&Matrix3::from_row_slice(numbers)),
    };
    let norm = raw.norm_squared().sqrt();
    if !(0.1..10.0).contains(&norm) {
        return Err(format!("orientation: must be of unit norm (is {norm:.1e})"));
    }
    Ok((raw.normalised(), (norm - 1.0).abs()))
}

/// Orientation of the rotation nearest to a matrix from body to fixed coordinates.
fn matrix(given: &Matrix3<f64>) -> Result<(Orientation<f64>, f64), String> {
    const HALVINGS: usize = 12;
    let norm_error = 0.5 * (given.transpose() * given - Matrix3::identity()).amax();
    let refused = || format!("r11..r33: must be a rotation (its determinant is {:.1e})", given.determinant());
    if given.determinant() <= 0.1 || norm_error > 10.0 {
        return Err(refused());
    }
    // Newton's iteration for the polar factor converges quadratically from every regular matrix
    let mut nearest = *given;
    for _ in 0..HALVINGS {
        nearest = 0.5 * (nearest + nearest.try_inverse().ok_or_else(refused)?.transpose());
    }
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(nearest));
    Ok((Orientation::from_quaternion([q.w, q.i, q.j, q.k]).normalised(), norm_error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_ways_to_write_an_orientation() {
        let phi = Orientation::from_quaternion([0.5, -0.5, 0.1, 0.7]).normalised();
        let omega = [0.3, -1.0, 2.0];
        let [w, x, y, z] = phi.quaternion();
        let (a, b) = (phi.alpha, phi.beta);
        let m = phi.matrix().concat().iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        let [wx, wy, wz] = phi.inverse().adjoint(omega);
        let [ox, oy, oz] = omega;
        let texts = [
            format!("t,w,x,y,z,wx,wy,wz\n1,{w},{x},{y},{z},{wx},{wy},{wz}\n"),
            format!(
                "# step = 0.25\nomega_x,t [s],alpha_re,alpha_im, beta_re,beta_im,omega_y,omega_z (rad/s)\n\
                 {ox},1,{},{},{},{},{oy},{oz}\n",
                a.re, a.im, b.re, b.im
            ),
            format!(
                "\u{feff}# method = Euler\n#evaluations= 7\nt,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,{m}\n"
            ),
        ];
        let read = texts.map(|text| Trajectory::parse("a.csv", text.as_bytes()).unwrap());
        for (trajectory, has_omega) in read.iter().zip([true, true, false]) {
            let [row] = trajectory.rows[..] else { panic!("one row") };
            assert!(row.t == 1.0 && row.norm_error < 1e-15);
            let off = crate::score::rotation_between(&phi, &row.orientation);
            assert!(off.iter().all(|x| x.abs() < 1e-15), "{off:?}");
            assert_eq!(row.omega.is_some(), has_omega);
            for (found, given) in row.omega.unwrap_or(omega).iter().zip(omega) {
                assert!((found - given).abs() < 1e-14, "{found} {given}");
            }
        }
        assert_eq!((read[1].step, read[1].method.as_deref()), (Some(0.25), None));
        assert_eq!((read[2].evaluations, read[2].method.as_deref()), (Some(7.0), Some("Euler")));
    }

    #[test]
    fn invalid_trajectories_are_refused_with_the_line() {
        for (text, part) in [
            ("", "columns: must have t with w,x,y,z"),
            ("t,w,x,y\n0,1,0,0\n", "has t,w,x,y"),
            ("t,w,x,y,z\n", "at least one row"),
            ("t,w,x,y,z\n0,1,0,0,NaN\n", "line 2: z: \"NaN\" must be a finite number"),
            ("t,w,x,y,z\n0,1,0,0\n", "a.csv: line 2: must have 5 fields, as the header; has 4"),
            (
                "# step = 1\nt,w,x,y,z\n0,1,0,0,0\n1,1\n",
                "a.csv: line 4: must have 5 fields, as the header; has 2",
            ),
            ("t,w,x,y,z\n0,1e-3,0,0,0\n", "line 2: orientation: must be of unit norm"),
            ("# no step\nt,w,x,y,z\n0,1,0,0,0\n0,1,0,0,0\n", "line 4: t: must go on in one direction"),
            ("t,w,x,y,z\n0,1,0,0,0\n-1,1,0,0,0\n0,1,0,0,0\n", "line 4: t: must go on"),
            ("# step = 0\nt,w,x,y,z\n0,1,0,0,0\n", "# step = 0: must be a number above 0"),
            (
                "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,1,0,0,0,-1\n",
                "line 2: r11..r33: must be a rotation",
            ),
        ] {
            let message = Trajectory::parse("a.csv", text.as_bytes()).unwrap_err().to_string();
            assert!(message.starts_with("a.csv: ") && message.contains(part), "{text:?}: {message}");
        }
    }
}
