//! What several commands let choose: form, method, scalar.

use crate::motion::Scalar;
use clap::ValueEnum;
use clap::builder::PossibleValue;

/// Form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For reading
    Table,
    /// Comma-separated, one line a record
    Csv,
    /// One JSON object
    Json,
}

/// Method by which `state` reaches a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// The core's ephemeris: any time at the same cost
    Ephemeris,
    /// The core's stepper
    Stepper,
    /// The full 3-D equations, integrated numerically
    Full,
    /// The paper's elliptic and elementary solutions, for the motions that have one (exit code 3 for the others)
    ClosedForm,
}

impl Method {
    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ephemeris => "ephemeris",
            Self::Stepper => "stepper",
            Self::Full => "full",
            Self::ClosedForm => "closed-form",
        }
    }
}

/// A scalar type, or all there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarChoice {
    /// This one
    One(Scalar),
    /// Every one
    All,
}

impl ValueEnum for ScalarChoice {
    fn value_variants<'a>() -> &'a [Self] {
        const {
            let mut choices = [Self::All; Scalar::ALL.len() + 1];
            let mut i = 0;
            while i < Scalar::ALL.len() {
                choices[i] = Self::One(Scalar::ALL[i]);
                i += 1;
            }
            &{ choices }
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::One(scalar) => scalar.to_possible_value(),
            Self::All => Some(PossibleValue::new("all").help("Every one")),
        }
    }
}

impl ScalarChoice {
    /// The types chosen, each once, in the order of their declaration.
    #[must_use]
    pub fn chosen(choices: &[Self]) -> Vec<Scalar> {
        let wanted = |scalar: &Scalar| choices.contains(&Self::All) || choices.contains(&Self::One(*scalar));
        Scalar::ALL.into_iter().filter(wanted).collect()
    }
}
