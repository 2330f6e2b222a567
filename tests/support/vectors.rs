//! Reference vectors of `tests/reference/vectors`: one JSON file per motion, with numbers as decimal strings.

use serde_json::Value;
use std::fs::DirEntry;
use std::path::{Path, PathBuf};
use toytop::scalar::{Extended, Ring};
use toytop::{Complex, InitialAngles, Motion, Orientation, ParameterError, Regime, Sign, Signs, State, Top};

/// Reference vector: one motion with its exact values. Units: g = 1.
pub struct Vector {
    /// File name without extension.
    pub name: String,
    /// Numbers of the file, as texts with all their digits.
    pub json: Value,
}

/// Exact values at one time.
pub struct Sample {
    /// Time, exact in decimal.
    pub t: f64,
    /// Cosine of the tilt u.
    pub u: f64,
    /// Rate u'.
    pub udot: f64,
    /// Orientation Φ.
    pub phi: Orientation<f64>,
    /// Tip curve c.
    pub c: Complex<f64>,
    /// Tip angle, continued in time; `None` where it does not exist.
    pub tip_angle: Option<f64>,
}

/// Exact values of one period.
pub struct Period {
    /// Period T.
    pub period: f64,
    /// Advance of arg α, rad.
    pub alpha: f64,
    /// Advance of arg β, rad.
    pub beta: f64,
    /// Advance of the tip angle, rad.
    pub phi: f64,
}

/// All vectors, sorted by name.
pub fn all() -> Vec<Vector> {
    let files = std::fs::read_dir(reference().join("vectors")).unwrap();
    let name = |file: DirEntry| Some(file.file_name().to_str()?.strip_suffix(".json")?.to_owned());
    let mut names: Vec<String> = files.filter_map(|file| name(file.unwrap())).collect();
    names.sort();
    names.iter().map(|name| named(name)).collect()
}

/// Vectors of the motions that a table can hold: all but the aperiodic ones.
pub fn tabulated() -> impl Iterator<Item = Vector> {
    all().into_iter().filter(|vector| vector.motion().unwrap().regime() != Regime::Aperiodic)
}

/// Vector of this name.
pub fn named(name: &str) -> Vector {
    Vector { name: name.to_owned(), json: read(&format!("vectors/{name}.json")) }
}

/// Motion of the vector of this name.
///
/// # Panics
/// If there is no such vector.
pub fn motion(name: &str) -> Motion {
    named(name).motion().unwrap()
}

/// Folder `tests/reference`.
fn reference() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reference")
}

/// JSON file of `tests/reference/data`.
pub fn json(name: &str) -> Value {
    read(&format!("data/{name}"))
}

/// JSON file of `tests/reference`.
fn read(path: &str) -> Value {
    let text = std::fs::read_to_string(reference().join(path));
    serde_json::from_str(&text.unwrap_or_else(|error| panic!("{path}: {error}"))).unwrap()
}

impl Vector {
    /// Number at the top level of the file (`e1`, `l`, ...).
    pub fn number(&self, key: &str) -> f64 {
        number(&self.json[key])
    }

    /// Whether the inputs are exactly `f64` numbers, so that reading them causes no rounding.
    pub fn is_exact(&self) -> bool {
        self.json.get("exact_in_f64").is_some()
    }

    /// Whether the motion is given by branch points (otherwise by a state).
    pub fn by_branch_points(&self) -> bool {
        self.json["params"]["defined_by"].as_str().is_some_and(|text| text.starts_with("e1,e2,e3"))
    }

    /// Difference e₃ - e₂; the errors of a motion are amplified by its inverse.
    pub fn gap(&self) -> f64 {
        self.number("e3") - self.number("e2")
    }

    /// Smallest of 1, e₃ - e₂ and 1 - e₂ that is not 0: the scale for the effect of a rounding of the inputs.
    pub fn smallest_difference(&self) -> f64 {
        let differences = [self.gap(), 1.0 - self.number("e2")];
        differences.into_iter().filter(|&x| x > 0.0).fold(1.0, f64::min)
    }

    /// Top of the motion; s = 0 means a fixed tip.
    pub fn top(&self) -> Top {
        top(&self.json["params"])
    }

    /// Signs of l + n and l - n.
    pub fn signs(&self) -> Signs {
        let sign = |key| match self.json.get(key).and_then(Value::as_i64) {
            Some(-1) => Sign::Minus,
            _ => Sign::Plus,
        };
        Signs { l_plus_n: sign("s_plus"), l_minus_n: sign("s_minus") }
    }

    /// Start of a motion given by branch points.
    pub fn start(&self) -> InitialAngles {
        let angle = |key| self.json["params"].get(key).map_or(0.0, number);
        InitialAngles { theta: angle("theta0"), arg_alpha: angle("arg_alpha0"), arg_beta: angle("arg_beta0") }
    }

    /// Branch points e₁, e₂, e₃.
    pub fn roots(&self) -> [f64; 3] {
        ["e1", "e2", "e3"].map(|key| self.number(key))
    }

    /// State at t = 0, rounded to `f64`.
    pub fn state(&self) -> State {
        let (parameters, initial) = (&self.json["params"], &self.json["initial"]);
        let (phi, omega) = if parameters.get("alpha0").is_some() {
            let [alpha, beta] = ["alpha0", "beta0"].map(|key| complex(&parameters[key]));
            (Orientation { alpha, beta }, &parameters["omega0"])
        } else {
            (orientation(initial), &initial["omega_fixed"])
        };
        State::new(phi, triple(omega)).unwrap()
    }

    /// Motion, launched from its branch points or its state.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        if self.by_branch_points() {
            Motion::from_branch_points(&self.top(), self.roots(), self.signs(), &self.start())
        } else {
            Motion::launch(&self.top(), &self.state())
        }
    }

    /// Samples over the first periods.
    pub fn samples(&self) -> Vec<Sample> {
        entries(&self.json["samples"]).iter().map(sample).collect()
    }

    /// Samples near 10³, 10⁶ and 10⁹ periods, with their number of periods.
    pub fn huge_samples(&self) -> Vec<(f64, Sample)> {
        let samples = self.json.get("huge_samples").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        samples.iter().map(|json| (number(&json["period_count"]), sample(json))).collect()
    }

    /// Exact values of a period, if there is one.
    pub fn period(&self) -> Option<Period> {
        let period = self.json.get("period")?;
        let entry = |key: &str| number(&period[key]);
        Some(Period {
            period: entry("T"),
            alpha: entry("delta_arg_alpha"),
            beta: entry("delta_arg_beta"),
            phi: entry("delta_phi"),
        })
    }
}

fn sample(json: &Value) -> Sample {
    Sample {
        t: number(&json["t"]),
        u: number(&json["u"]),
        udot: number(&json["udot"]),
        phi: orientation(json),
        c: complex(&json["c"]),
        tip_angle: json["phi"].is_string().then(|| number(&json["phi"])),
    }
}

/// Orientation from the keys `alpha` and `beta`.
pub fn orientation(json: &Value) -> Orientation<f64> {
    Orientation { alpha: complex(&json["alpha"]), beta: complex(&json["beta"]) }
}

/// Complex number from its two parts.
pub fn complex(json: &Value) -> Complex<f64> {
    Complex::new(number(&json[0]), number(&json[1]))
}

/// Vector from its three components.
pub fn triple(json: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| number(&json[i]))
}

/// Top from A, C, s and p, with g = 1; s = 0 means a fixed tip.
pub fn top(json: &Value) -> Top {
    crate::top_of(["A", "C", "s", "p"].map(|key| number(&json[key])), 1.0)
}

/// Entries of a list.
pub fn entries(json: &Value) -> &[Value] {
    json.as_array().unwrap()
}

/// Number from a decimal string, to extended precision: 37 of its digits.
pub fn exact_number(json: &Value) -> Extended {
    let text = json.as_str().unwrap();
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.trim_start_matches('-').chars().chain(fraction.chars());
    let digit = |c: char| Extended::from(f64::from(c.to_digit(10).unwrap()));
    let ten = Extended::from(10.0);
    let size = digits.map(digit).fold(Extended::ZERO, |sum, digit| sum * ten + digit);
    let shift = exponent.parse::<i32>().unwrap() - fraction.len() as i32;
    let scale = (0..shift.abs()).fold(Extended::ONE, |scale, _| scale * ten);
    let size = if shift < 0 { size / scale } else { size * scale };
    if text.starts_with('-') { -size } else { size }
}

/// Number from a JSON number or a decimal string.
pub fn number(json: &Value) -> f64 {
    match json.as_str() {
        Some("pi") => std::f64::consts::PI,
        Some("pi/2") => std::f64::consts::FRAC_PI_2,
        Some(text) => text.parse().unwrap(),
        None => json.as_f64().unwrap(),
    }
}
