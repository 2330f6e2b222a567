//! Sensors of a recording: their noise, bias, range and mounting, from a TOML file.

use crate::input::section::{self, Key, Section};
use crate::input::text_file;
use crate::{Failure, excerpt};
use std::path::Path;
use toml::{Table, Value};
use toytop::{Orientation, Support, Top};
use toytop_fit::{
    Accelerometer, AxisCamera, Gyroscope, Magnetometer, Mark, Mounting, Noise, OrientationCamera, Sensor,
    TipCamera,
};

/// List of words.
type Words = &'static [&'static str];

/// Kind of a sensor, in the order of the columns.
#[derive(Clone, Copy, PartialEq)]
pub enum SensorKind {
    /// Angular velocity.
    Gyroscope,
    /// Specific force: acceleration minus gravity.
    Accelerometer,
    /// Magnetic field.
    Magnetometer,
    /// Orientation seen by a camera.
    Orientation,
    /// Axis seen by a camera.
    Axis,
    /// Tip seen by a camera.
    Tip,
    /// Time at which a mark on the body passes.
    Mark,
}

impl SensorKind {
    /// All kinds.
    pub const ALL: [Self; 7] = [
        Self::Gyroscope,
        Self::Accelerometer,
        Self::Magnetometer,
        Self::Orientation,
        Self::Axis,
        Self::Tip,
        Self::Mark,
    ];

    /// Name of its table in a file, columns of the samples, spellings of their unit, and keys of the table.
    fn description(self) -> (&'static str, Words, Words, Words) {
        match self {
            Self::Gyroscope => (
                "gyroscope",
                &["gyro_x", "gyro_y", "gyro_z"],
                &["rad/s"],
                &["noise", "bias", "range", "rotation", "quantum", "every"],
            ),
            Self::Accelerometer => (
                "accelerometer",
                &["accel_x", "accel_y", "accel_z"],
                &["m/s^2", "m/s²", "m/s2"],
                &["noise", "bias", "range", "rotation", "position", "quantum", "every"],
            ),
            Self::Magnetometer => (
                "magnetometer",
                &["mag_x", "mag_y", "mag_z"],
                &["uT", "µT"],
                &["noise", "bias", "field", "rotation", "quantum", "every"],
            ),
            Self::Orientation => ("orientation", &["w", "x", "y", "z"], &[], &["noise", "quantum", "every"]),
            Self::Axis => ("axis", &["axis_x", "axis_y", "axis_z"], &[], &["noise", "quantum", "every"]),
            Self::Tip => ("tip", &["tip_x", "tip_y"], &["m"], &["noise", "quantum", "every"]),
            Self::Mark => ("mark", &["mark"], &["rad"], &["noise", "position"]),
        }
    }

    /// Name of its table in a file.
    pub fn name(self) -> &'static str {
        let (name, ..) = self.description();
        name
    }

    /// Columns of the samples.
    pub fn columns(self) -> &'static [&'static str] {
        let (_, columns, ..) = self.description();
        columns
    }

    /// Spellings of the unit of its columns; none where they have no unit.
    pub fn unit(self) -> &'static [&'static str] {
        let (.., unit, _) = self.description();
        unit
    }

    /// Names of the residuals: the columns, and for an orientation x, y, z of the rotation vector.
    pub fn residuals(self) -> &'static [&'static str] {
        let columns = self.columns();
        &columns[columns.len().saturating_sub(3)..]
    }
}

/// Sensor with the errors of its readings.
pub struct SensorModel {
    /// Kind of the sensor.
    pub kind: SensorKind,
    /// Sensor as the core has it.
    pub sensor: Box<dyn Sensor + Send + Sync>,
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
    pub models: Vec<SensorModel>,
    /// Standard deviation of the difference between the true and the stated time of a sample, s.
    pub jitter: f64,
    /// Share of samples that are lost.
    pub dropped: f64,
}

/// Sensors of a telephone, which give 16 bits.
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

/// Fraction of the range above which a reading counts as saturated.
const SATURATION_FRACTION: f64 = 0.999;

/// Position of the centre of mass of a top in the body frame, m. The origin is the centre of mass of a sliding top or a free body, and the tip of
/// a held top.
///
/// * `com_height`: distance of the centre of mass from the tip, m, or 0 if it is not known
pub fn centre_of_mass(top: &Top, com_height: f64) -> [f64; 3] {
    [0.0, 0.0, if top.support() == Support::Fixed { com_height } else { 0.0 }]
}

impl Sensors {
    /// Sensors as the core takes them.
    pub fn as_sensors(&self) -> Vec<&dyn Sensor> {
        self.models.iter().map(|model| &*model.sensor as &dyn Sensor).collect()
    }

    /// A consumer MEMS gyroscope (2000 degrees per second, noise 0.005 degrees per second and root hertz in 500 Hz, bias 1
    /// degree per second), accelerometer (16 g, 100 micro-g per root hertz, bias 20 milli-g) and magnetometer (0.6 microtesla, one
    /// reading in ten samples) at the centre of mass.
    pub fn telephone(com: [f64; 3]) -> Self {
        Self::parse("telephone", TELEPHONE, com).expect("sensors in range")
    }

    /// Sensors of a file, or without one of a telephone.
    ///
    /// * `com`: [`centre_of_mass`], where a sensor is that has no position
    ///
    /// # Errors
    /// [`Failure::input`]: the file cannot be read, or as [`Sensors::parse`].
    pub fn read(path: Option<&Path>, com: [f64; 3]) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self::telephone(com)) };
        let file = path.display().to_string();
        Self::parse(&file, &text_file::read(&file, path, 1)?, com)
    }

    /// Sensors of the text of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`Failure::input`]: no TOML, or a key is unknown, missing or out of range.
    pub fn parse(file: &str, text: &str, com: [f64; 3]) -> Result<Self, Failure> {
        Self::from_tables(&section::parse(file, text)?, com).map_err(|failure| failure.at(file))
    }

    /// Sensors of the tables of a file.
    ///
    /// # Errors
    /// [`Failure::input`]: a key is unknown, missing or out of range.
    pub fn from_tables(tables: &Table, com: [f64; 3]) -> Result<Self, Failure> {
        let mut sensors = Self { models: Vec::new(), jitter: 0.0, dropped: 0.0 };
        for (name, value) in tables {
            let Value::Table(table) = value else {
                return Err(Failure::input("must be a table").at(excerpt(name)));
            };
            let section = Section { name, table };
            match SensorKind::ALL.into_iter().find(|kind| kind.name() == name) {
                Some(kind) => sensors.models.push(read_model(&section, kind, com)?),
                None if name == "timing" => {
                    [sensors.jitter, sensors.dropped] = section.only_numbers(None, &TIMING)?;
                }
                None => {
                    let allowed = SensorKind::ALL.map(SensorKind::name).join(", ");
                    let reason = format!("unknown sensor; allowed: timing, {allowed}");
                    return Err(Failure::input(reason).at(excerpt(name)));
                }
            }
        }
        if !(1..=4).contains(&sensors.models.len()) {
            return Err(Failure::input("must have one to four sensors"));
        }
        // in the order of the columns, in any order of the file
        sensors.models.sort_by_key(|model| model.kind as u8);
        Ok(sensors)
    }

    /// Removes the sensors without columns.
    ///
    /// * `all`: whether every sensor must have its columns
    ///
    /// # Errors
    /// Requirement that the columns do not meet: at least one sensor must have all its columns, or with `all` every sensor.
    pub fn retain_with_columns(&mut self, has: impl Fn(&str) -> bool, all: bool) -> Result<(), String> {
        let present = |columns: &[&'static str]| columns.iter().all(|name| has(name));
        if all && let Some(missing) = self.models.iter().find(|one| !present(one.kind.columns())) {
            let columns = missing.kind.columns().join(", ");
            return Err(format!("must have the columns of the {}: {columns}", missing.kind.name()));
        }
        self.models.retain(|model| present(model.kind.columns()));
        if self.models.is_empty() {
            let names: Vec<_> = SensorKind::ALL.iter().map(|kind| kind.columns().join(",")).collect();
            return Err(format!("must have the columns of a sensor: {}", names.join("; ")));
        }
        Ok(())
    }
}

static TIMING: [Key; 2] = [
    Key::optional("jitter", 0.0, "a number from 0 to 1e6").within(0.0, 1e6),
    Key::optional("dropped", 0.0, "a number from 0 to 0.99").within(0.0, 0.99),
];

static NUMBERS: [Key; 5] = [
    Key::required("noise", "a number from 1e-12 to 1e12").within(1e-12, 1e12),
    Key::optional("bias", 0.0, "a number from 0 to 1e12").within(0.0, 1e12),
    Key::optional("range", f64::INFINITY, "a number from 1e-12").within(1e-12, f64::INFINITY),
    Key::optional("quantum", 0.0, "a number from 0 to 1e12").within(0.0, 1e12),
    Key::optional("every", 1.0, "a whole number from 1 to 1e9").within(1.0, 1e9),
];

static ROTATION: Key = Key::required("rotation", "a unit quaternion [w, x, y, z] from sensor to body");
static POSITION: Key = Key::required("position", "an array of 3 finite numbers");
static FIELD: Key = Key::required("field", "an array of 3 finite numbers, not all 0");

fn read_model(section: &Section<'_>, kind: SensorKind, com: [f64; 3]) -> Result<SensorModel, Failure> {
    let (.., keys) = kind.description();
    section.refuse_other_keys(None, keys.iter().copied())?;
    let [deviation, bias_deviation, range, quantum, every] = section.numbers(&NUMBERS)?;
    let noise = Noise { deviation, bias_deviation };
    if every.fract() != 0.0 {
        return Err(section.not_allowed(&NUMBERS[4]));
    }
    let rotation = section.array(&ROTATION, Some([1.0, 0.0, 0.0, 0.0]))?;
    let norm: f64 = rotation.iter().map(|x| x * x).sum();
    if (norm - 1.0).abs() > 1e-6 {
        return Err(section.not_allowed(&ROTATION));
    }
    let rotation = Orientation::from_quaternion(rotation).normalised();
    let mounting = Mounting { rotation, place: section.array(&POSITION, Some(com))? };
    let sensor: Box<dyn Sensor + Send + Sync> = match kind {
        SensorKind::Gyroscope => Box::new(Gyroscope { noise, mounting, range: SATURATION_FRACTION * range }),
        SensorKind::Accelerometer => {
            Box::new(Accelerometer { noise, mounting, range: SATURATION_FRACTION * range })
        }
        SensorKind::Magnetometer => {
            let field = section.array(&FIELD, Some([20.0, 0.0, -43.0]))?;
            if field == [0.0; 3] {
                return Err(section.not_allowed(&FIELD));
            }
            Box::new(Magnetometer { noise, mounting, field })
        }
        SensorKind::Orientation => Box::new(OrientationCamera { deviation }),
        SensorKind::Axis => Box::new(AxisCamera { deviation }),
        SensorKind::Tip => Box::new(TipCamera { deviation }),
        SensorKind::Mark => {
            Box::new(Mark { deviation, place: section.array(&POSITION, Some([1.0, 0.0, 0.0]))? })
        }
    };
    Ok(SensorModel { kind, sensor, range, quantum, every: every as u64 })
}
