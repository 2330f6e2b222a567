//! Table `[motion]`: exactly one of three kinds.

mod fastest;

use super::units::ANGLES;
use crate::Failure;
use crate::input::section::{Key, Section};
use crate::truth::motions::Start;
use toytop::{Complex, InitialPhases, Motion, Orientation, Release, Sign, Signs, State, Top};
use toytop_page::scenario::{angle, tilt};

/// Motion, and its launch.
pub fn read(section: &Section<'_>, top: &Top) -> Result<(Motion, Start), Failure> {
    match section.choice("kind", &["release", "state", "branch_points"], None)? {
        "release" => {
            let release = release(section)?;
            let state = State::release(&release).map_err(|error| section.refused(&error, &ANGLES))?;
            launch(section, top, state, || fastest::too_fast(section, top, &release))
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
