//! Table `[motion]`: exactly one of three kinds.

use crate::Failure;
use crate::input::section::{Key, Section};
use crate::input::units::{RADIANS, RATE};
use toytop::{Motion, Release, Top};
use toytop_model::launch::{KINDS, Kind, Launch};

const RATE_RANGE: &str = "a number of rad/s, at most 1e11 in size";
const SPIN: &str = "a number of rad/s, at most 1e11 in size: the whole component of omega along the axis";
const DEGREES: &str = "a finite number of degrees";
const PAIR: &str = "an array of two finite numbers [re, im], of unit norm with the other parameter";
const SIGN: &str = "1 or -1";
const ANGLE: &str = "a number between -1e6 and 1e6 rad";

/// Angles of a release: their keys, which need a unit, and their keys in degrees.
pub const ANGLES: [(&str, &str); 3] =
    [("tilt", "tilt_deg"), ("azimuth", "azimuth_deg"), ("roll", "roll_deg")];

static RELEASE: [Key; 6] = [
    Key::required("tilt_deg", "a number in [0, 180]").within(0.0, 180.0),
    Key::required("spin", SPIN).with_units(RATE),
    Key::optional("precession", 0.0, RATE_RANGE).with_units(RATE),
    Key::optional("nutation", 0.0, RATE_RANGE).with_units(RATE),
    Key::optional("azimuth_deg", 0.0, DEGREES),
    Key::optional("roll_deg", 0.0, DEGREES),
];

static STATE: [Key; 3] = [
    Key::required("alpha", PAIR),
    Key::required("beta", PAIR),
    Key::required("omega", "an array of three finite numbers [x, y, z] in rad/s").with_units(RATE),
];

static BRANCH_POINTS: [Key; 8] = [
    Key::required("e1", "a number in [-1, e2]"),
    Key::required("e2", "a number in [e1, 1]"),
    Key::required("e3", "a number in [1, 1e14]"),
    Key::required("sign_l_plus_n", SIGN),
    Key::required("sign_l_minus_n", SIGN),
    Key::optional("nutation_phase", 0.0, ANGLE).with_units(RADIANS),
    Key::optional("arg_alpha", 0.0, ANGLE).with_units(RADIANS),
    Key::optional("arg_beta", 0.0, ANGLE).with_units(RADIANS),
];

/// Keys of a kind, in the order of the numbers of [`Launch::new`].
pub fn keys(kind: Kind) -> &'static [Key] {
    match kind {
        Kind::Release => &RELEASE,
        Kind::State => &STATE,
        Kind::BranchPoints => &BRANCH_POINTS,
    }
}

/// Name of the fastest rate of a release.
pub fn fastest_rate(release: &Release) -> &'static str {
    let rates = [("nutation", release.nutation), ("precession", release.precession), ("spin", release.spin)];
    let fastest = rates.into_iter().max_by(|(_, x), (_, y)| x.abs().total_cmp(&y.abs()));
    fastest.map_or("spin", |(name, _)| name)
}

/// Motion, and its launch.
pub fn read(section: &Section<'_>, top: &Top) -> Result<(Motion, Launch), Failure> {
    let refused = |error| section.refusal(error);
    let (name, kind) = section.choice("kind", &KINDS, None)?;
    let choice = Some(("kind", name));
    let (numbers, fastest) = match kind {
        Kind::Release => {
            let [tilt, spin, precession, nutation, azimuth, roll] = section.only_numbers(choice, &RELEASE)?;
            let rates = Release { spin, precession, nutation, ..Release::default() };
            ([tilt, spin, precession, nutation, azimuth, roll, 0.0, 0.0], fastest_rate(&rates))
        }
        Kind::State => {
            section.refuse_other_keys(choice, STATE.iter().map(|key| key.name))?;
            let [alpha, beta, omega] = &STATE;
            let ([a, b], [c, d]) = (section.array(alpha, None)?, section.array(beta, None)?);
            let [x, y, z] = section.array(omega, None)?;
            ([a, b, c, d, x, y, z, 0.0], "omega")
        }
        Kind::BranchPoints => {
            let numbers = section.only_numbers(choice, &BRANCH_POINTS)?;
            for (key, sign) in [("sign_l_plus_n", numbers[3]), ("sign_l_minus_n", numbers[4])] {
                if sign.abs() != 1.0 {
                    return Err(section.failure(key, format!("must be {SIGN}")));
                }
            }
            (numbers, "kind")
        }
    };
    let launch = Launch::new(kind, numbers).map_err(refused)?;
    let motion = launch.motion(top).map_err(|error| match error.parameter() {
        "omega" => section.failure(
            fastest,
            "must be slow enough for e3 <= 1e14 (faster, a body feels no torque: support = \"free\" is then exact)",
        ),
        _ => refused(error),
    })?;
    Ok((motion, launch))
}
