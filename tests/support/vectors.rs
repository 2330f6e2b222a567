//! The reference vectors of `tests/reference/vectors`: one JSON file a motion, numbers as decimal strings.

use serde_json::Value;
use std::path::{Path, PathBuf};
use toytop::{Complex, Heaviness, LaunchError, Motion, Phi, Sign, Signs, Start, State, Top};

/// One motion with its truth. Units: g = 1.
pub struct Vector {
    /// File name without ending.
    pub name: String,
    json: Value,
}

/// The truth at one time.
pub struct Sample {
    /// Time, exact in decimal.
    pub t: f64,
    /// u.
    pub u: f64,
    /// u'.
    pub udot: f64,
    /// Φ.
    pub phi: Phi<f64>,
    /// The tip curve.
    pub c: Complex<f64>,
    /// The tip angle, continued; None where it does not exist.
    pub tip_angle: Option<f64>,
}

/// The truth of one period.
pub struct Period {
    /// T.
    pub period: f64,
    /// Advance of arg α, rad.
    pub alpha: f64,
    /// Advance of arg β, rad.
    pub beta: f64,
    /// Advance of the tip angle, rad.
    pub phi: f64,
}

/// All vectors, by name.
pub fn all() -> Vec<Vector> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reference/vectors");
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "json"));
    files.sort();
    files.iter().map(|file| Vector::read(file)).collect()
}

/// The vector of this name.
pub fn named(name: &str) -> Vector {
    Vector::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("reference/vectors/{name}.json")))
}

/// A file of `tests/reference`.
pub fn json(name: &str) -> Value {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("reference").join(name))
}

fn read(file: &Path) -> Value {
    let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

impl Vector {
    fn read(file: &Path) -> Self {
        let text =
            std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let json = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        Self { name: file.file_stem().unwrap().to_string_lossy().into_owned(), json }
    }

    /// A number at the top of the file (`e1`, `l`, ...), if it is there.
    pub fn number(&self, key: &str) -> Option<f64> {
        self.json.get(key).and_then(number)
    }

    fn parameter(&self, key: &str) -> Option<f64> {
        self.json["params"].get(key).and_then(number)
    }

    /// Whether its inputs are `f64` numbers exactly, so that nothing is lost in reading them.
    pub fn is_exact(&self) -> bool {
        self.json.get("exact_in_f64").is_some()
    }

    /// Whether it is defined by branch points (otherwise by a state).
    pub fn by_branch_points(&self) -> bool {
        self.json["params"]["defined_by"].as_str().is_some_and(|text| text.starts_with("e1,e2,e3"))
    }

    /// e₃ - e₂, which tells how much the equations amplify.
    pub fn gap(&self) -> f64 {
        self.number("e3").unwrap() - self.number("e2").unwrap()
    }

    /// The smallest of 1, e₃ - e₂ and 1 - e₂ that is not 0: what a rounding of the inputs is to be compared with.
    pub fn smallest_difference(&self) -> f64 {
        let differences = [self.gap(), 1.0 - self.number("e2").unwrap()];
        differences.into_iter().filter(|&x| x > 0.0).fold(1.0, f64::min)
    }

    /// The top; s = 0 is one with a fixed tip.
    pub fn top(&self) -> Top {
        let [a, c, s, p] = ["A", "C", "s", "p"].map(|key| self.parameter(key).unwrap());
        let top = if s > 0.0 {
            Top::sliding(a, c, s, Heaviness::MassMoment(p), 1.0)
        } else {
            Top::fixed(a, c, p, 1.0)
        };
        top.unwrap()
    }

    /// The signs of l + n and l - n.
    pub fn signs(&self) -> Signs {
        let sign = |key| match self.json.get(key).and_then(Value::as_i64) {
            Some(-1) => Sign::Minus,
            _ => Sign::Plus,
        };
        Signs { l_plus_n: sign("s_plus"), l_minus_n: sign("s_minus") }
    }

    /// Where a motion defined by branch points starts.
    pub fn start(&self) -> Start {
        let angle = |key| self.parameter(key).unwrap_or(0.0);
        Start { theta: angle("theta0"), arg_alpha: angle("arg_alpha0"), arg_beta: angle("arg_beta0") }
    }

    /// e₁, e₂, e₃.
    pub fn roots(&self) -> [f64; 3] {
        ["e1", "e2", "e3"].map(|key| self.number(key).unwrap())
    }

    /// The state at t = 0, as far as `f64` can say it.
    pub fn state(&self) -> State {
        let (parameters, initial) = (&self.json["params"], &self.json["initial"]);
        if parameters.get("alpha0").is_some() {
            let complex = |key: &str| Complex::new(entry(parameters, key, 0), entry(parameters, key, 1));
            let omega = [0, 1, 2].map(|i| entry(parameters, "omega0", i));
            return State::new(Phi { alpha: complex("alpha0"), beta: complex("beta0") }, omega).unwrap();
        }
        let omega = numbers(&initial["omega_fixed"]).try_into().unwrap();
        State::new(phi(initial), omega).unwrap()
    }

    /// The motion, from what defines it.
    pub fn motion(&self) -> Result<Motion, LaunchError> {
        if self.by_branch_points() {
            Motion::from_branch_points(&self.top(), self.roots(), self.signs(), &self.start())
        } else {
            Motion::launch(&self.top(), &self.state())
        }
    }

    /// The samples over the first periods.
    pub fn samples(&self) -> Vec<Sample> {
        self.json["samples"].as_array().unwrap().iter().map(sample).collect()
    }

    /// The samples near 10³, 10⁶ and 10⁹ periods, with their number of periods.
    pub fn huge_samples(&self) -> Vec<(f64, Sample)> {
        let samples = self.json.get("huge_samples").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        samples.iter().map(|json| (number(&json["period_count"]).unwrap(), sample(json))).collect()
    }

    /// The truth of a period, if there is one.
    pub fn period(&self) -> Option<Period> {
        let period = self.json.get("period")?;
        let entry = |key: &str| number(&period[key]).unwrap();
        Some(Period {
            period: entry("T"),
            alpha: entry("delta_arg_alpha"),
            beta: entry("delta_arg_beta"),
            phi: entry("delta_phi"),
        })
    }
}

fn sample(json: &Value) -> Sample {
    let entry = |key: &str| number(&json[key]);
    let c = numbers(&json["c"]);
    Sample {
        t: entry("t").unwrap(),
        u: entry("u").unwrap(),
        udot: entry("udot").unwrap(),
        phi: phi(json),
        c: Complex::new(c[0], c[1]),
        tip_angle: entry("phi"),
    }
}

fn phi(json: &Value) -> Phi<f64> {
    let complex = |key: &str| {
        let parts = numbers(&json[key]);
        Complex::new(parts[0], parts[1])
    };
    Phi { alpha: complex("alpha"), beta: complex("beta") }
}

fn entry(json: &Value, key: &str, i: usize) -> f64 {
    number(&json[key][i]).unwrap()
}

fn numbers(json: &Value) -> Vec<f64> {
    json.as_array().unwrap().iter().map(|entry| number(entry).unwrap()).collect()
}

/// A number given as a JSON number or a decimal string.
pub fn number(json: &Value) -> Option<f64> {
    match json {
        Value::String(text) => match text.as_str() {
            "pi" => Some(std::f64::consts::PI),
            "pi/2" => Some(std::f64::consts::FRAC_PI_2),
            text => text.parse().ok(),
        },
        other => other.as_f64(),
    }
}
