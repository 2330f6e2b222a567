//! Trajectory of a CSV file: columns by name, and statements about the run in comment lines above the header.

use crate::Failure;
use crate::input::finite;
use crate::input::rows::{self, csv_error};
use crate::output::shown;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use std::path::Path;
use toytop::{Complex, Orientation};

/// Row of a trajectory.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Time, s.
    pub t: f64,
    /// Orientation, normalised. Its sign is the file's.
    pub orientation: Orientation<f64>,
    /// Distance of the file's quaternion from unit norm, or half that of RᵀR from the unit matrix.
    pub norm_error: f64,
    /// Angular velocity in the fixed frame, rad/s, if the file has it.
    pub omega: Option<[f64; 3]>,
    /// Position of the tip, if the file has it.
    pub tip: Option<[f64; 2]>,
    /// Position of the centre of mass relative to the tip, if the file has it.
    pub com: Option<[f64; 3]>,
}

/// Times and orientations of one run of an integrator.
#[derive(Debug)]
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

/// Columns of an orientation, one of three sets; the first that is complete counts.
const QUATERNION: [&str; 4] = ["w", "x", "y", "z"];
const ALPHA_BETA: [&str; 4] = ["alpha_re", "alpha_im", "beta_re", "beta_im"];
const MATRIX: [&str; 9] = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];

impl Trajectory {
    /// Trajectory of a file.
    ///
    /// # Errors
    /// [`Failure::Input`] with the file and the line: a column is missing, a value is not a finite number or no rotation, or a time is out
    /// of order.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        Self::parse(&name, &rows::read(&name, path)?)
    }

    fn parse(name: &str, text: &str) -> Result<Self, Failure> {
        let refuse = |reason: String| Failure::Input(format!("{name}: {reason}"));
        // a byte order mark would hide the first comment
        let text = text.trim_start_matches('\u{feff}');
        let stated = |key: &str| {
            let mut comments = text.lines().map_while(|line| line.strip_prefix('#')?.split_once('='));
            comments.find(|(own, _)| own.trim() == key).map(|(_, value)| value.trim())
        };
        let positive = |key: &str| match stated(key) {
            None => Ok(None),
            Some(value) => match finite(value) {
                Some(x) if x > 0.0 => Ok(Some(x)),
                _ => Err(refuse(format!("# {key} = {}: must be a number above 0", shown(value)))),
            },
        };
        let (step, evaluations) = (positive("step")?, positive("evaluations")?);
        let mut reader = rows::reader(text);
        let columns =
            Columns::of(reader.headers().map_err(|error| refuse(error.to_string()))?).map_err(&refuse)?;
        let mut rows: Vec<Row> = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| refuse(csv_error(&error)))?;
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
        Ok(Self {
            name: name.to_owned(),
            method: stated("method").map(str::to_owned),
            step,
            evaluations,
            rows,
        })
    }

    /// Trajectory in other body axes, where `body` takes the file's body coordinates to the new ones.
    pub fn in_body_axes(mut self, body: &Orientation<f64>) -> Self {
        let inverse = body.inverse();
        for row in &mut self.rows {
            row.orientation = row.orientation.compose(&inverse);
        }
        self
    }

    /// Spacing of the rows, s, if it is constant to a millionth; `None` otherwise.
    pub fn spacing(&self) -> Option<f64> {
        let [first, .., last] = &self.rows[..] else { return None };
        let mean = (last.t - first.t) / (self.rows.len() - 1) as f64;
        let even = |pair: &[Row]| (pair[1].t - pair[0].t - mean).abs() <= 1e-6 * mean.abs();
        self.rows.windows(2).all(even).then_some(mean.abs())
    }
}

/// Whether a time continues the rows in their direction.
fn goes_on(rows: &[Row], t: f64) -> bool {
    match rows {
        [] => true,
        [only] => t != only.t,
        [first, .., last] => (t > last.t) == (last.t > first.t) && t != last.t,
    }
}

/// Names of the columns; of equal names the first counts.
struct Columns(Vec<String>);

impl Columns {
    fn of(header: &csv::StringRecord) -> Result<Self, String> {
        let columns = Self(rows::names(header)?);
        let orientation = columns.have(&QUATERNION) || columns.have(&ALPHA_BETA) || columns.have(&MATRIX);
        if orientation && columns.have(&["t"]) {
            return Ok(columns);
        }
        let allowed =
            "t with w,x,y,z (body to fixed), alpha_re,alpha_im,beta_re,beta_im or r11,r12,...,r33 (by rows)";
        Err(format!("columns: must have {allowed}; has {}", shown(&columns.0.join(","))))
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.0.iter().position(|own| own == name)
    }

    fn have(&self, names: &[&str]) -> bool {
        names.iter().all(|name| self.place(name).is_some())
    }

    /// Numbers of a row in these columns; `None` where one of the columns is missing.
    fn numbers<const N: usize>(
        &self,
        record: &csv::StringRecord,
        names: [&str; N],
    ) -> Result<Option<[f64; N]>, String> {
        if !self.have(&names) {
            return Ok(None);
        }
        let mut numbers = [0.0; N];
        for (number, name) in numbers.iter_mut().zip(names) {
            let text = self.place(name).and_then(|place| record.get(place)).unwrap_or_default();
            *number =
                finite(text).ok_or_else(|| format!("{name}: {:?} must be a finite number", shown(text)))?;
        }
        Ok(Some(numbers))
    }

    fn row(&self, record: &csv::StringRecord) -> Result<Row, String> {
        let named = |reason: String| format!("orientation: {reason}");
        let (orientation, norm_error) = if let Some(quaternion) = self.numbers(record, QUATERNION)? {
            normalised(Orientation::from_quaternion(quaternion)).map_err(named)?
        } else if let Some([a, b, c, d]) = self.numbers(record, ALPHA_BETA)? {
            normalised(Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) }).map_err(named)?
        } else {
            let matrix = self.numbers(record, MATRIX)?.unwrap_or_default();
            nearest_rotation(&Matrix3::from_row_slice(&matrix))?
        };
        let body = self.numbers(record, ["wx", "wy", "wz"])?.map(|omega| orientation.adjoint(omega));
        let omega = match body {
            None => self.numbers(record, ["omega_x", "omega_y", "omega_z"])?,
            body => body,
        };
        let tip = self.numbers(record, ["tip_x", "tip_y"])?;
        let com = self.numbers(record, ["x_com", "y_com", "z_com"])?;
        let [t] = self.numbers(record, ["t"])?.unwrap_or_default();
        Ok(Row { t, orientation, norm_error, omega, tip, com })
    }
}

/// Orientation of unit norm, and the distance of a given one from it.
///
/// # Errors
/// Norm that is far from 1.
pub fn normalised(given: Orientation<f64>) -> Result<(Orientation<f64>, f64), String> {
    let norm = given.norm_squared().sqrt();
    if !(0.1..10.0).contains(&norm) {
        return Err(format!("must be of unit norm (is {norm:.1e})"));
    }
    Ok((given.normalised(), (norm - 1.0).abs()))
}

/// Orientation of the rotation nearest to a matrix from body to fixed coordinates, and half the distance of RᵀR from the unit matrix.
fn nearest_rotation(given: &Matrix3<f64>) -> Result<(Orientation<f64>, f64), String> {
    let norm_error = 0.5 * (given.transpose() * given - Matrix3::identity()).amax();
    if given.determinant() <= 0.1 || norm_error > 10.0 {
        return Err(format!("r11..r33: must be a rotation (its determinant is {:.1e})", given.determinant()));
    }
    let (_, rotation) = given.polar();
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation));
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
        let read = texts.map(|text| Trajectory::parse("a.csv", &text).unwrap());
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
            let message = Trajectory::parse("a.csv", text).unwrap_err().to_string();
            assert!(message.starts_with("a.csv: ") && message.contains(part), "{text:?}: {message}");
        }
    }
}
