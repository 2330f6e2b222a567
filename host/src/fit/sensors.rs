//! Sensors of a recording: their noise, bias, range and mounting, from a TOML file.

use crate::Failure;
use crate::output::{shown, whole_file};
use std::path::Path;
use toml::{Table, Value};
use toytop::{Orientation, Support, Top};
use toytop_fit::{
    Accelerometer, AxisCamera, Gyroscope, Magnetometer, Mark, Mounting, Noise, OrientationCamera, Sensor,
    TipCamera,
};

/// Kind of a sensor: its table in the file, and its columns in the samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// Name of the table.
    pub name: &'static str,
    /// Columns of the samples.
    pub columns: &'static [&'static str],
}

impl Kind {
    /// Names of the residuals: the columns, and for an orientation x, y, z of the rotation vector.
    pub fn residuals(&self) -> &'static [&'static str] {
        &self.columns[self.columns.len().saturating_sub(3)..]
    }
}

/// All kinds.
pub const KINDS: [Kind; 7] = [
    Kind { name: "gyroscope", columns: &["gyro_x", "gyro_y", "gyro_z"] },
    Kind { name: "accelerometer", columns: &["accel_x", "accel_y", "accel_z"] },
    Kind { name: "magnetometer", columns: &["mag_x", "mag_y", "mag_z"] },
    Kind { name: "orientation", columns: &["w", "x", "y", "z"] },
    Kind { name: "axis", columns: &["axis_x", "axis_y", "axis_z"] },
    Kind { name: "tip", columns: &["tip_x", "tip_y"] },
    Kind { name: "mark", columns: &["mark"] },
];

/// One sensor.
pub struct Instrument {
    /// Kind of the sensor.
    pub kind: Kind,
    /// Sensor of the core.
    pub sensor: Box<dyn Sensor + Send + Sync>,
    /// Standard deviations of a simulated bias and of the noise of one reading.
    pub noise: Noise,
    /// Largest magnitude of a reading.
    pub range: f64,
    /// Smallest step of a reading; 0 for none.
    pub quantum: f64,
    /// Number of samples from one reading to the next.
    pub every: u64,
}

/// Sensors, and errors of their clock.
pub struct Sensors {
    /// Sensors, at most four.
    pub instruments: Vec<Instrument>,
    /// Standard deviation of the difference between the true and the stated time of a sample, s.
    pub jitter: f64,
    /// Share of samples that are lost.
    pub dropped: f64,
}

/// Sensors of a telephone. A quantum of the first two is the range over 2^15.
const TELEPHONE: &str = "
[gyroscope]
noise = 0.002
bias = 0.0175
range = 34.906585039886586
quantum = 0.0010652644360316951
[accelerometer]
noise = 0.022
bias = 0.2
range = 157.0
quantum = 0.004791259765625
[magnetometer]
noise = 0.6
quantum = 0.15
every = 10
";

/// Share of the range from which a reading counts as at its end: data sheets round the range.
const REACHED: f64 = 0.999;

/// Properties of a top's body that predictions of some sensors need.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Scale of the tip's curve, m.
    pub tip_scale: f64,
    /// Position of the centre of mass relative to the point that the moments of inertia refer to, in the body frame, m.
    pub com: [f64; 3],
}

impl Body {
    /// Properties of a top's body. The origin is the centre of mass of a sliding top or a free body, and the tip of a held top.
    ///
    /// * `com_height`: distance of the centre of mass from the tip, m; if it is not known, the centre of mass of a held top counts as at its tip
    pub fn of(top: &Top, com_height: Option<f64>) -> Self {
        let com = match (top.support(), com_height) {
            (Support::Fixed, Some(height)) => [0.0, 0.0, height],
            _ => [0.0; 3],
        };
        Self { tip_scale: top.tip_scale(), com }
    }
}

impl Sensors {
    /// Sensors as the core takes them.
    pub fn listed(&self) -> Vec<&dyn Sensor> {
        self.instruments.iter().map(|instrument| &*instrument.sensor as &dyn Sensor).collect()
    }

    /// A consumer MEMS gyroscope (2000 degrees per second, noise 0.005 degrees per second and root hertz in 500 Hz, bias 1
    /// degree per second), accelerometer (16 g, 100 micro-g per root hertz, bias 20 milli-g) and magnetometer (0.6 microtesla, one
    /// reading in ten samples) at the centre of mass.
    pub fn telephone(body: Body) -> Self {
        Self::parse("telephone", TELEPHONE, body).expect("sensors in range")
    }

    /// Sensors of a file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file cannot be read, is no TOML, or has a key that is unknown, missing or out of range.
    pub fn read(path: &Path, body: Body) -> Result<Self, Failure> {
        let file = path.display().to_string();
        Self::parse(&file, &whole_file::read(&file, path, 1)?, body)
    }

    /// Sensors of the text of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`Failure::Input`]: no TOML, or a key that is unknown, missing or out of range.
    pub fn parse(file: &str, text: &str, body: Body) -> Result<Self, Failure> {
        let root = text.parse::<Table>().map_err(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            Failure::Input(format!("{file}: line {line}: must be TOML: {}", error.message()))
        })?;
        Self::of_table(file, &root, body)
    }

    /// Sensors of the tables of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`Failure::Input`]: a key is unknown, missing or out of range.
    pub fn of_table(file: &str, root: &Table, body: Body) -> Result<Self, Failure> {
        let mut sensors = Self { instruments: Vec::new(), jitter: 0.0, dropped: 0.0 };
        for (name, value) in root {
            let Value::Table(table) = value else {
                return Err(Failure::Input(format!("{file}: {}: must be a table", shown(name))));
            };
            let keys = Keys { file, name, table };
            if name == "timing" {
                keys.only(&["jitter", "dropped"])?;
                sensors.jitter = keys.number("jitter", Some(0.0), [0.0, 1e6])?;
                sensors.dropped = keys.number("dropped", Some(0.0), [0.0, 0.99])?;
                continue;
            }
            let Some(kind) = KINDS.into_iter().find(|kind| kind.name == name) else {
                let allowed: Vec<_> = KINDS.iter().map(|kind| kind.name).collect();
                let name = shown(name);
                return Err(Failure::Input(format!(
                    "{file}: {name}: unknown sensor; allowed: timing, {}",
                    allowed.join(", ")
                )));
            };
            sensors.instruments.push(instrument(&keys, kind, body)?);
        }
        if !(1..=4).contains(&sensors.instruments.len()) {
            return Err(Failure::Input(format!("{file}: must have one to four sensors")));
        }
        // in the order of the columns, whatever that of the file
        sensors.instruments.sort_by_key(|found| KINDS.iter().position(|kind| *kind == found.kind));
        Ok(sensors)
    }
}

fn instrument(keys: &Keys<'_>, kind: Kind, body: Body) -> Result<Instrument, Failure> {
    const MOST: f64 = 1e12;
    let allowed: &[&str] = match kind.name {
        "gyroscope" => &["noise", "bias", "range", "rotation", "quantum", "every"],
        "accelerometer" => &["noise", "bias", "range", "rotation", "position", "quantum", "every"],
        "magnetometer" => &["noise", "bias", "field", "rotation", "quantum", "every"],
        "mark" => &["noise", "position"],
        _ => &["noise", "quantum", "every"],
    };
    keys.only(allowed)?;
    let deviation = keys.number("noise", None, [1e-12, MOST])?;
    let bias = keys.number("bias", Some(0.0), [0.0, MOST])?;
    let noise = Noise { deviation, bias };
    let range = keys.number("range", Some(f64::INFINITY), [1e-12, f64::INFINITY])?;
    let quantum = keys.number("quantum", Some(0.0), [0.0, MOST])?;
    let every = keys.number("every", Some(1.0), [1.0, 1e9])?;
    if every.fract() != 0.0 {
        return Err(keys.refuse("every", "must be a whole number"));
    }
    let rotation = keys.array("rotation", Some([1.0, 0.0, 0.0, 0.0]))?;
    let norm: f64 = rotation.iter().map(|x| x * x).sum();
    if (norm - 1.0).abs() > 1e-6 {
        return Err(keys.refuse("rotation", "must be a unit quaternion [w, x, y, z] from sensor to body"));
    }
    let rotation = Orientation::from_quaternion(rotation).normalised();
    let mounting = Mounting { rotation, place: keys.array("position", Some(body.com))? };
    let sensor: Box<dyn Sensor + Send + Sync> = match kind.name {
        "gyroscope" => Box::new(Gyroscope { noise, mounting, range: REACHED * range }),
        "accelerometer" => Box::new(Accelerometer { noise, mounting, range: REACHED * range }),
        "magnetometer" => {
            let field = keys.array("field", Some([20.0, 0.0, -43.0]))?;
            if field == [0.0; 3] {
                return Err(keys.refuse("field", "must not be 0"));
            }
            Box::new(Magnetometer { noise, mounting, field })
        }
        "orientation" => Box::new(OrientationCamera { deviation }),
        "axis" => Box::new(AxisCamera { deviation }),
        "tip" => Box::new(TipCamera { deviation, tip_scale: body.tip_scale }),
        _ => Box::new(Mark { deviation, place: keys.array("position", Some([1.0, 0.0, 0.0]))? }),
    };
    Ok(Instrument { kind, sensor, noise, range, quantum, every: every as u64 })
}

/// One table of the file.
struct Keys<'a> {
    file: &'a str,
    name: &'a str,
    table: &'a Table,
}

impl Keys<'_> {
    fn refuse(&self, key: &str, reason: &str) -> Failure {
        Failure::Input(format!("{}: {}.{}: {reason}", self.file, shown(self.name), shown(key)))
    }

    fn only(&self, allowed: &[&str]) -> Result<(), Failure> {
        match self.table.keys().find(|key| !allowed.contains(&key.as_str())) {
            Some(key) => Err(self.refuse(key, &format!("unknown key; allowed: {}", allowed.join(", ")))),
            None => Ok(()),
        }
    }

    fn number(&self, key: &str, default: Option<f64>, [low, high]: [f64; 2]) -> Result<f64, Failure> {
        let range = || format!("must be a number from {low:e} to {high:e}");
        match (self.table.get(key), default) {
            (None, Some(default)) => Ok(default),
            (None, None) => Err(self.refuse(key, &format!("missing; {}", range()))),
            (Some(value), _) => value
                .as_float()
                .or(value.as_integer().map(|x| x as f64))
                .filter(|x| (low..=high).contains(x))
                .ok_or_else(|| self.refuse(key, &range())),
        }
    }

    fn array<const N: usize>(&self, key: &str, default: Option<[f64; N]>) -> Result<[f64; N], Failure> {
        let number = |value: &Value| {
            value.as_float().or(value.as_integer().map(|x| x as f64)).filter(|x| x.is_finite())
        };
        match (self.table.get(key), default) {
            (None, Some(default)) => Ok(default),
            (value, _) => value
                .and_then(Value::as_array)
                .and_then(|entries| entries.iter().map(number).collect::<Option<Vec<_>>>())
                .and_then(|numbers| numbers.try_into().ok())
                .ok_or_else(|| self.refuse(key, &format!("must be an array of {N} finite numbers"))),
        }
    }
}
