//! Arguments of the command that lists the events of a motion.

use super::Format;
use clap::Args;
use std::path::PathBuf;

/// `toytop events`
#[derive(Args, Debug)]
pub(crate) struct EventsArgs {
    /// Scenario file
    pub(crate) scenario: PathBuf,
    /// Events to list, separated by commas: turning, tilt=DEGREES, tip-angle=DEGREES, circle=RADIUS, lift-off. With :up or :down
    /// after its name an event counts only where u (or the tip angle) rises or falls
    #[arg(long = "kind", value_name = "KIND,...", value_delimiter = ',', default_value = "turning", allow_hyphen_values = true, value_parser = kind)]
    pub(crate) kinds: Vec<Kind>,
    /// Time of the earliest event to list, s
    #[arg(long, value_name = "T", default_value_t = 0.0, allow_hyphen_values = true, value_parser = time)]
    pub(crate) from: f64,
    /// Greatest number of events
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) count: u32,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

/// Kind of event on the command line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kind {
    /// Kind of the event.
    pub what: What,
    /// Whether only upward (`true`) or only downward (`false`) events count; `None` for both.
    pub upward: Option<bool>,
    /// Text of the command line that names it.
    pub text: String,
}

/// Kinds of event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum What {
    /// Turning point of u.
    Turning,
    /// Time at which the tilt has this value, degrees.
    Tilt(f64),
    /// Time at which the tip angle has this value, degrees, modulo whole turns.
    TipAngle(f64),
    /// Time at which the tip is at this distance from the centre, m.
    Circle(f64),
    /// Time at which the normal force is 0.
    LiftOff,
}

fn kind(text: &str) -> Result<Kind, String> {
    const ALLOWED: &str = "must be turning, tilt=DEGREES, tip-angle=DEGREES, circle=RADIUS or lift-off, with or without :up or :down";
    let (rest, upward) = match text.rsplit_once(':') {
        Some((rest, "up")) => (rest, Some(true)),
        Some((rest, "down")) => (rest, Some(false)),
        Some(_) => return Err(ALLOWED.to_owned()),
        None => (text, None),
    };
    let number = |value: &str| value.parse::<f64>().ok().filter(|x| x.is_finite());
    let what = match rest.split_once('=').map(|(name, value)| (name, number(value))) {
        None if rest == "turning" => What::Turning,
        None if rest == "lift-off" => What::LiftOff,
        Some(("tilt", Some(degrees))) if (0.0..=180.0).contains(&degrees) => What::Tilt(degrees),
        Some(("tilt", Some(_))) => return Err("tilt: must be in [0, 180] degrees".to_owned()),
        Some(("tip-angle", Some(degrees))) if degrees.abs() <= 1e6 => What::TipAngle(degrees),
        Some(("tip-angle", Some(_))) => return Err("tip-angle: must be within ±1e6 degrees".to_owned()),
        Some(("circle", Some(radius))) if radius > 0.0 => What::Circle(radius),
        Some(("circle", Some(_))) => return Err("circle: must be above 0".to_owned()),
        _ => return Err(ALLOWED.to_owned()),
    };
    Ok(Kind { what, upward, text: text.to_owned() })
}

fn time(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|t: &f64| t.is_finite()).ok_or("must be a finite number")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_read_and_refused() {
        assert_eq!(kind("turning").map(|kind| (kind.what, kind.upward)), Ok((What::Turning, None)));
        assert_eq!(
            kind("tilt=30:up").map(|kind| (kind.what, kind.upward)),
            Ok((What::Tilt(30.0), Some(true)))
        );
        assert_eq!(kind("tip-angle=-90").map(|kind| kind.what), Ok(What::TipAngle(-90.0)));
        for bad in [
            "",
            "tilt",
            "tilt=x",
            "tilt=181",
            "circle=0",
            "circle=-1",
            "tilt=nan",
            "turning:left",
            "lift-off=1",
        ] {
            assert!(kind(bad).is_err(), "{bad}");
        }
    }
}
