//! Arguments that several commands share: form of the output, method, scalar.

use crate::motion::Scalar;
use clap::ValueEnum;
use clap::builder::PossibleValue;

/// Form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Aligned table
    Table,
    /// Comma-separated values, one line for each record
    Csv,
    /// One JSON object
    Json,
}

/// Method by which `state` reaches a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Ephemeris of the core: any time at the same cost
    Ephemeris,
    /// Stepper of the core
    Stepper,
    /// Numerical integration of the full 3-D equations
    Full,
    /// Elliptic or elementary solution of the paper, for a motion that has one (otherwise exit code 3)
    ClosedForm,
}

impl Method {
    /// Name on the command line.
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

/// One scalar type, or all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarChoice {
    /// One scalar type
    One(Scalar),
    /// All scalar types
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
            Self::All => Some(PossibleValue::new("all").help("All scalar types")),
        }
    }
}

impl ScalarChoice {
    /// Chosen types, each once, in the order of their declaration.
    #[must_use]
    pub fn chosen(choices: &[Self]) -> Vec<Scalar> {
        let wanted = |scalar: &Scalar| choices.contains(&Self::All) || choices.contains(&Self::One(*scalar));
        Scalar::ALL.into_iter().filter(wanted).collect()
    }
}
