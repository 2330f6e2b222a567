//! Table `[motion]`: exactly one of three kinds.

use super::units::ANGLES;
use crate::Failure;
use crate::input::section::{Key, Section};
use crate::truth::motions::Start;
use toytop::{Complex, InitialPhases, Motion, Orientation, Release, Sign, Signs, State, Top};
use toytop_model::angles::{angle, tilt};

/// Motion, and its launch.
pub fn read(section: &Section<'_>, top: &Top) -> Result<(Motion, Start), Failure> {
    match section.choice("kind", &["release", "state", "branch_points"], None)? {
        "release" => {
            let release = release(section)?;
            let state = State::release(&release).map_err(|error| section.refused(&error, &ANGLES))?;
            launch(section, top, state, || too_fast(section, top, &release))
        }
        "state" => {
            launch(section, top, state(section)?, || section.refuse("omega", &format!("must be {SLOW}")))
        }
        _ => branch_points(section, top),
    }
}

/// Keys of a kind that hold one number each.
pub fn numbers(kind: &str) -> &'static [Key] {
    match kind {
        "release" => &RELEASE,
        "branch_points" => &BRANCH_POINTS,
        _ => &[],
    }
}

/// * `too_fast`: failure for an angular velocity that is too large
fn launch(
    section: &Section<'_>,
    top: &Top,
    state: State,
    too_fast: impl FnOnce() -> Failure,
) -> Result<(Motion, Start), Failure> {
    let motion = Motion::launch(top, &state).map_err(|error| match error.parameter() {
        "omega" => too_fast(),
        _ => section.refused(&error, &[]),
    })?;
    Ok((motion, Start::from(&state)))
}

/// Limit of the angular velocity in words, after `must be`.
const SLOW: &str =
    "slow enough for e3 <= 1e14 (faster, a body feels no torque: support = \"free\" is then exact)";

const RATE: &str = "a number of rad/s, at most 1e11 in size";
const SPIN: &str = "a number of rad/s, at most 1e11 in size: the whole component of omega along the axis";
const DEGREES: &str = "a finite number of degrees";

static RELEASE: [Key; 6] = [
    Key::required("tilt_deg", "a number in [0, 180]").within(0.0, 180.0),
    Key::required("spin", SPIN),
    Key::optional("precession", 0.0, RATE),
    Key::optional("nutation", 0.0, RATE),
    Key::optional("azimuth_deg", 0.0, DEGREES),
    Key::optional("roll_deg", 0.0, DEGREES),
];

fn release(section: &Section<'_>) -> Result<Release, Failure> {
    section.only_with("kind", &RELEASE)?;
    let [tilt_deg, spin, precession, nutation, azimuth_deg, roll_deg] = section.numbers(&RELEASE)?;
    Ok(Release {
        tilt: tilt(tilt_deg),
        azimuth: angle(azimuth_deg),
        roll: angle(roll_deg),
        spin,
        precession,
        nutation,
    })
}

const PAIR: &str = "an array of two finite numbers [re, im], of unit norm with the other parameter";

const STATE: [Key; 3] = [
    Key::required("alpha", PAIR),
    Key::required("beta", PAIR),
    Key::required("omega", "an array of three finite numbers [x, y, z] in rad/s"),
];

fn state(section: &Section<'_>) -> Result<State, Failure> {
    section.only_with("kind", &STATE)?;
    let [alpha, beta, omega] = &STATE;
    let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
    let phi = Orientation {
        alpha: complex(section.array(alpha, None)?),
        beta: complex(section.array(beta, None)?),
    };
    State::new(phi, section.array(omega, None)?).map_err(|error| section.refused(&error, &[]))
}

const SIGN: &str = "1 or -1";
const ANGLE: &str = "a number between -1e6 and 1e6 rad";

static BRANCH_POINTS: [Key; 8] = [
    Key::required("e1", "a number in [-1, e2]"),
    Key::required("e2", "a number in [e1, 1]"),
    Key::required("e3", "a number in [1, 1e14]"),
    Key::required("sign_l_plus_n", SIGN),
    Key::required("sign_l_minus_n", SIGN),
    Key::optional("nutation_phase", 0.0, ANGLE),
    Key::optional("arg_alpha", 0.0, ANGLE),
    Key::optional("arg_beta", 0.0, ANGLE),
];

fn branch_points(section: &Section<'_>, top: &Top) -> Result<(Motion, Start), Failure> {
    section.only_with("kind", &BRANCH_POINTS)?;
    let [e1, e2, e3, plus, minus, theta, arg_alpha, arg_beta] = section.numbers(&BRANCH_POINTS)?;
    let [_, _, _, plus_key, minus_key, ..] = &BRANCH_POINTS;
    let sign = |number: f64, key: &Key| match number {
        1.0 => Ok(Sign::Plus),
        -1.0 => Ok(Sign::Minus),
        _ => Err(section.not_allowed(key)),
    };
    let signs = Signs { l_plus_n: sign(plus, plus_key)?, l_minus_n: sign(minus, minus_key)? };
    let (e, phases) = ([e1, e2, e3], InitialPhases { theta, arg_alpha, arg_beta });
    let motion = Motion::from_branch_points(top, e, signs, &phases)
        .map_err(|error| section.refused(&error, &[("theta", "nutation_phase")]))?;
    Ok((motion, Start::BranchPoints { e, signs, phases }))
}

/// Failure for a release that is too fast. It names the greatest of its rates and, if the top can have the other ones, the limit of this
/// one.
pub fn too_fast(section: &Section<'_>, top: &Top, release: &Release) -> Failure {
    let rates = [("spin", release.spin), ("precession", release.precession), ("nutation", release.nutation)];
    let greater = |a: (&'static str, f64), b: (&'static str, f64)| if b.1.abs() > a.1.abs() { b } else { a };
    let (key, value) = rates.into_iter().fold(rates[0], greater);
    let exists = |size: f64| {
        let rate = size.copysign(value);
        let release = match key {
            "spin" => Release { spin: rate, ..*release },
            "precession" => Release { precession: rate, ..*release },
            _ => Release { nutation: rate, ..*release },
        };
        State::release(&release).is_ok_and(|state| Motion::launch(top, &state).is_ok())
    };
    let limit = limit(value.abs(), exists).map_or_else(String::new, |limit| {
        format!("at most {limit:e} rad/s in size with the other numbers of this file, ")
    });
    section.refuse(key, &format!("must be {limit}{SLOW}"))
}

/// Greatest size below `high` with which there is a motion, rounded down to three digits; `None` if there is none even near 0.
fn limit(mut high: f64, exists: impl Fn(f64) -> bool) -> Option<f64> {
    /// Least limit that is found, in units of the rate that was refused.
    const LEAST: f64 = 1e-24;
    /// Halvings of the logarithm of the ratio, after which the limit has more than three digits.
    const HALVINGS: usize = 20;
    let mut low = LEAST * high;
    if !exists(low) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        *if exists(middle) { &mut low } else { &mut high } = middle;
    }
    let unit = 10_f64.powi(low.log10().floor() as i32 - 2);
    // the decimal nearest to the product, so that it is printed with three digits
    let limit = format!("{:.2e}", (low / unit).floor() * unit).parse().ok()?;
    exists(limit).then_some(limit)
}
