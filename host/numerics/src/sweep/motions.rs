//! Motions of a sweep, of either kind.

use super::{Launches, Place, Space};
use std::fmt;
use toytop::Motion;

/// Motions of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub enum Motions {
    /// Motions of the paper's constants, without units.
    BranchPoints(Space),
    /// Motions of a scenario, some of whose numbers vary.
    Scenario(Launches),
}

impl Motions {
    /// Number of motions.
    #[must_use]
    pub fn count(&self) -> u64 {
        match self {
            Self::BranchPoints(space) => space.count(),
            Self::Scenario(launches) => launches.count(),
        }
    }

    /// Seed of a random sample.
    #[must_use]
    pub fn seed(&self) -> Option<u64> {
        let sample = match self {
            Self::BranchPoints(space) => space.sample,
            Self::Scenario(launches) => launches.sample,
        };
        sample.map(|(_, seed)| seed)
    }

    /// Names of the columns with the numbers that vary.
    #[must_use]
    pub fn keys(&self) -> String {
        match self {
            Self::BranchPoints(_) => "e1,e2,e3,a_over_ps,c_over_a,sign_l_plus_n,sign_l_minus_n".to_owned(),
            Self::Scenario(launches) => launches.keys().collect::<Vec<_>>().join(","),
        }
    }

    /// Fields of these columns, and the motion; `None` where no motion has these numbers.
    #[must_use]
    pub fn at(&self, number: u64) -> (String, Option<Motion>) {
        match self {
            Self::BranchPoints(space) => {
                let place = space.place(number);
                let Place { e: [e1, e2, e3], a, c_over_a, signs } = place;
                let [plus, minus] = [signs.l_plus_n, signs.l_minus_n].map(|sign| sign.factor());
                (format!("{e1:?},{e2:?},{e3:?},{a:?},{c_over_a:?},{plus},{minus}"), place.motion().ok())
            }
            Self::Scenario(launches) => {
                let numbers = launches.numbers(number);
                let fields: Vec<_> = numbers.iter().map(|(_, number)| format!("{number:?}")).collect();
                (fields.join(","), launches.motion(number))
            }
        }
    }
}

impl Motions {
    /// Reason why no motion has the numbers with this index; `None` where one has them.
    #[must_use]
    pub fn refusal(&self, number: u64) -> Option<String> {
        match self {
            Self::BranchPoints(space) => space.place(number).motion().err().map(|error| error.to_string()),
            Self::Scenario(launches) => launches.refusal(number),
        }
    }
}

/// Options of `toytop sweep` that select the motions.
impl fmt::Display for Motions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BranchPoints(space) => space.fmt(f),
            Self::Scenario(launches) => launches.fmt(f),
        }
    }
}
