//! Trajectory of a CSV file: columns by name, and statements about the run in comment lines above the header.

use crate::input::csv_rows::{self, CsvRows, finite};
use crate::input::text_file;
use crate::{Failure, excerpt};
use csv::StringRecord;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use std::path::Path;
use toytop::{Complex, Orientation};

/// Time and orientation, with the other quantities that the file has.
#[derive(Clone, Copy, Debug)]
pub struct TrajectoryRow {
    /// Time, s.
    pub t: f64,
    /// Orientation, normalised. Its sign is the file's.
    pub orientation: Orientation<f64>,
    /// Distance of the file's quaternion from unit norm, or half the distance of RᵀR from the unit matrix.
    pub norm_error: f64,
    /// Angular velocity in the fixed frame, rad/s, if the file has it.
    pub omega: Option<[f64; 3]>,
    /// Position of the tip, if the file has it.
    pub tip: Option<[f64; 2]>,
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
    pub rows: Vec<TrajectoryRow>,
}

/// Columns of an orientation, one of three sets; the first that is complete counts.
const QUATERNION: [&str; 4] = ["w", "x", "y", "z"];
const ALPHA_BETA: [&str; 4] = ["alpha_re", "alpha_im", "beta_re", "beta_im"];
const MATRIX: [&str; 9] = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];
/// Columns of the angular velocity: in the body, by two names, and in the fixed frame.
const OMEGA: [[&str; 3]; 3] =
    [["omega_body_x", "omega_body_y", "omega_body_z"], ["wx", "wy", "wz"], ["omega_x", "omega_y", "omega_z"]];

impl Trajectory {
    /// Trajectory of a file.
    ///
    /// # Errors
    /// [`Failure::input`] with the file and the line: a column is missing, a value is not a finite number or no rotation, or a time is out
    /// of order.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let text = text_file::read(&name, path, csv_rows::MAX_FILE_MIB)?;
        let trajectory = Self::parse(&text).map_err(|reason| Failure::input(reason).at(&name))?;
        Ok(Self { name, ..trajectory })
    }

    fn parse(text: &str) -> Result<Self, String> {
        // a byte order mark would hide the first comment
        let text = text.trim_start_matches('\u{feff}');
        let stated = |key: &str| {
            let comments = text.lines().map_while(|line| line.strip_prefix('#'));
            let mut stated = comments.filter_map(|comment| comment.split_once('='));
            stated.find(|(own, _)| own.trim() == key).map(|(_, value)| value.trim())
        };
        let positive = |key: &str| {
            let number = |text| {
                let refused = || format!("# {key} = {}: must be a number above 0", excerpt(text));
                finite(text).filter(|x| *x > 0.0).ok_or_else(refused)
            };
            stated(key).map(number).transpose()
        };
        let (step, evaluations) = (positive("step")?, positive("evaluations")?);
        let CsvRows { header, rows: records, .. } = csv_rows::parse(text, unit_of)?;
        let has = |names: &[&str]| column_indices(&header, names).is_some();
        if !has(&["t"]) || !(has(&QUATERNION) || has(&ALPHA_BETA) || has(&MATRIX)) {
            let allowed = "t with w,x,y,z (body to fixed), alpha_re,alpha_im,beta_re,beta_im or r11,r12,...,r33 (by rows)";
            return Err(format!("columns: must have {allowed}; has {}", excerpt(&header.join(","))));
        }
        let mut rows: Vec<TrajectoryRow> = Vec::new();
        for record in records {
            let (line, record) = record?;
            let row = parse_row(&header, &record).map_err(|reason| format!("line {line}: {reason}"))?;
            let is_monotone = rows.last().is_none_or(|last| {
                row.t != last.t && (rows.len() == 1 || (row.t > last.t) == (last.t > rows[0].t))
            });
            if !is_monotone {
                return Err(format!("line {line}: t: must go on in one direction from row to row"));
            }
            rows.push(row);
        }
        if rows.is_empty() {
            return Err("must hold at least one row below the header".to_owned());
        }
        let method = stated("method").map(str::to_owned);
        Ok(Self { name: String::new(), method, step, evaluations, rows })
    }

    /// Trajectory in the body axes of the core, from which this rotation leads to those of the file.
    pub fn in_axes_of_core(mut self, axes: &Orientation<f64>) -> Self {
        let inverse = axes.inverse();
        for row in &mut self.rows {
            row.orientation = row.orientation.compose(&inverse);
        }
        self
    }

    /// Spacing of the rows, s, if it is constant to a millionth.
    pub fn spacing(&self) -> Option<f64> {
        let [first, .., last] = &self.rows[..] else { return None };
        let mean = (last.t - first.t) / (self.rows.len() - 1) as f64;
        let even = |pair: &[TrajectoryRow]| (pair[1].t - pair[0].t - mean).abs() <= 1e-6 * mean.abs();
        self.rows.windows(2).all(even).then_some(mean.abs())
    }
}

/// Spellings of the unit of a column.
fn unit_of(column: &str) -> &'static [&'static str] {
    match column {
        "t" => &["s"],
        "tip_x" | "tip_y" => &["m"],
        _ if OMEGA.as_flattened().contains(&column) => &["rad/s"],
        _ => &[],
    }
}

/// Indices of columns in a header, where of equal names the first counts; `None` if one is missing.
fn column_indices(header: &[String], names: &[&str]) -> Option<Vec<usize>> {
    names.iter().map(|name| header.iter().position(|own| own == name)).collect()
}

/// Row of a trajectory, from a record of CSV.
fn parse_row(header: &[String], record: &StringRecord) -> Result<TrajectoryRow, String> {
    let given = match numbers(header, record, QUATERNION)? {
        Some(quaternion) => Some(Orientation::from_quaternion(quaternion)),
        None => numbers(header, record, ALPHA_BETA)?
            .map(|[a, b, c, d]| Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) }),
    };
    let (orientation, norm_error) = match given {
        Some(given) => normalised(given).map_err(|reason| format!("orientation: {reason}"))?,
        None => nearest_rotation(numbers(header, record, MATRIX)?.unwrap_or_default())?,
    };
    let omega_body = match numbers(header, record, OMEGA[0])? {
        Some(omega_body) => Some(omega_body),
        None => numbers(header, record, OMEGA[1])?,
    };
    let omega = match omega_body {
        Some(omega_body) => Some(orientation.adjoint(omega_body)),
        None => numbers(header, record, OMEGA[2])?,
    };
    let tip = numbers(header, record, ["tip_x", "tip_y"])?;
    let [t] = numbers(header, record, ["t"])?.unwrap_or_default();
    Ok(TrajectoryRow { t, orientation, norm_error, omega, tip })
}

/// Numbers of a record in these columns; `None` where one of the columns is missing.
fn numbers<const N: usize>(
    header: &[String],
    record: &StringRecord,
    names: [&str; N],
) -> Result<Option<[f64; N]>, String> {
    let Some(indices) = column_indices(header, &names) else { return Ok(None) };
    let mut numbers = [0.0; N];
    for ((number, name), index) in numbers.iter_mut().zip(names).zip(indices) {
        let refused = || format!("{name}: {:?} must be a finite number", excerpt(&record[index]));
        *number = finite(&record[index]).ok_or_else(refused)?;
    }
    Ok(Some(numbers))
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
fn nearest_rotation(rows: [f64; 9]) -> Result<(Orientation<f64>, f64), String> {
    let given = Matrix3::from_row_slice(&rows);
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
    fn an_orientation_and_its_rates_may_be_written_in_several_ways() {
        let phi = Orientation::from_quaternion([0.5, -0.5, 0.1, 0.7]).normalised();
        let omega = [0.3, -1.0, 2.0];
        let [w, x, y, z] = phi.quaternion();
        let (a, b) = (phi.alpha, phi.beta);
        let m = phi.matrix().concat().iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        let [wx, wy, wz] = phi.inverse().adjoint(omega);
        let [ox, oy, oz] = omega;
        let texts = [
            format!("t,w,x,y,z,wx,wy,wz\n1,{w},{x},{y},{z},{wx},{wy},{wz}\n"),
            format!("t,w,x,y,z,omega_body_x,omega_body_y,omega_body_z\n1,{w},{x},{y},{z},{wx},{wy},{wz}\n"),
            format!(
                "# made by a script\n# step = 0.25\nomega_x,t [s],alpha_re,alpha_im, beta_re,beta_im,omega_y,omega_z (rad/s)\n\
                 {ox},1,{},{},{},{},{oy},{oz}\n",
                a.re, a.im, b.re, b.im
            ),
            format!(
                "\u{feff}# method = Euler\n#evaluations= 7\nt,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,{m}\n"
            ),
        ];
        let read = texts.map(|text| Trajectory::parse(&text).unwrap());
        for (trajectory, has_omega) in read.iter().zip([true, true, true, false]) {
            let [row] = trajectory.rows[..] else { panic!("one row") };
            assert!(row.t == 1.0 && row.norm_error < 1e-15);
            let off = crate::motion::errors::rotation_between(&phi, &row.orientation);
            assert!(off.iter().all(|x| x.abs() < 1e-15), "{off:?}");
            assert_eq!(row.omega.is_some(), has_omega);
            for (found, given) in row.omega.unwrap_or(omega).iter().zip(omega) {
                assert!((found - given).abs() < 1e-14, "{found} {given}");
            }
        }
        assert_eq!((read[2].step, read[2].method.as_deref()), (Some(0.25), None));
        assert_eq!((read[3].evaluations, read[3].method.as_deref()), (Some(7.0), Some("Euler")));
    }

    #[test]
    fn invalid_trajectories_are_refused_with_the_line() {
        for (text, part) in [
            ("", "columns: must have t with w,x,y,z"),
            ("t,w,x,y\n0,1,0,0\n", "has t,w,x,y"),
            ("t,w,x,y,z\n", "at least one row"),
            ("t [s],tip_z [mm],tip_x [mm]\n", "line 1: tip_x: must be in m, not mm"),
            ("t,wy [deg/s]\n", "line 1: wy: must be in rad/s, not deg/s"),
            ("t,omega_body_x [deg/s]\n", "line 1: omega_body_x: must be in rad/s"),
            ("t,w,x,y,z\n0,1,0,0,NaN\n", "line 2: z: \"NaN\" must be a finite number"),
            ("t,w,x,y,z\n0,1,0,0\n", "line 2: must have 5 fields, as the header; has 4"),
            ("# step = 1\nt,w,x,y,z\n0,1,0,0,0\n1,1\n", "line 4: must have 5 fields, as the header; has 2"),
            ("t,w,x,y,z\n0,1e-3,0,0,0\n", "line 2: orientation: must be of unit norm"),
            ("# no step\nt,w,x,y,z\n0,1,0,0,0\n0,1,0,0,0\n", "line 4: t: must go on in one direction"),
            ("t,w,x,y,z\n0,1,0,0,0\n-1,1,0,0,0\n0,1,0,0,0\n", "line 4: t: must go on"),
            ("# step = 0\nt,w,x,y,z\n0,1,0,0,0\n", "# step = 0: must be a number above 0"),
            (
                "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,1,0,0,0,-1\n",
                "line 2: r11..r33: must be a rotation",
            ),
        ] {
            let message = Trajectory::parse(text).unwrap_err();
            assert!(message.contains(part), "{text:?}: {message}");
        }
    }
}
