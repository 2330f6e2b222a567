//! Refusals as exceptions: `ValueError`, whose message begins with the parameter.

use pyo3::PyErr;
use pyo3::exceptions::{PyOSError, PyValueError};
use std::fmt::Display;
use toytop::ParameterError;
use toytop_host::Failure;

/// Exception for a parameter that core refuses.
pub(crate) fn refused(error: ParameterError) -> PyErr {
    renamed(error, &[])
}

/// Exception for a parameter that core refuses; `names` lists the parameters with another name here.
pub(crate) fn renamed(error: ParameterError, names: &[(&str, &str)]) -> PyErr {
    let parameter = error.parameter();
    let name = names.iter().find(|(core, _)| *core == parameter).map_or(parameter, |(_, name)| name);
    value_error(name, format!("must be {}", error.allowed()))
}

/// Exception for a parameter and the reason.
pub(crate) fn value_error(parameter: &str, reason: impl Display) -> PyErr {
    PyValueError::new_err(format!("{parameter}: {reason}"))
}

/// Exception for a failure of the host library.
pub(crate) fn failed(failure: Failure) -> PyErr {
    match failure {
        Failure::Input(_) | Failure::Method(_) => PyValueError::new_err(failure.to_string()),
        Failure::Output(_) | Failure::Tool(_) => PyOSError::new_err(failure.to_string()),
    }
}
