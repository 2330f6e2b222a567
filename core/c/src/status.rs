//! Status codes, and the text with the refused parameter and its allowed values.

use core::ffi::{CStr, c_char};
use toytop::{ParameterError, SetUpError};

/// Status of a call: `TOYTOP_OK`, or the reason of a refusal. A refused call changes nothing, except that a refused set-up leaves no table.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::upper_case_acronyms, reason = "constants of C")]
pub enum toytop_status {
    /// The call was successful.
    TOYTOP_OK = 0,
    /// A pointer is null that must not be null.
    TOYTOP_NULL_POINTER = 1,
    /// A parameter is NaN or infinite; the text of the error names it.
    TOYTOP_NOT_FINITE = 2,
    /// A parameter is finite but not allowed; the text of the error names it and the allowed range.
    TOYTOP_OUT_OF_RANGE = 3,
    /// The memory of a table is too small for the motion; the error says how many segments are not enough.
    TOYTOP_TABLE_TOO_SMALL = 4,
    /// The memory of a table or a workspace is not aligned, or the memory of a table has no room for 8 segments.
    TOYTOP_BAD_MEMORY = 5,
    /// A table, motion, cursor, sample or search for events was not made by this library, its set-up failed, or it belongs to another or an earlier table.
    TOYTOP_NOT_SET_UP = 6,
    /// The motion has no such event, angle or derivative.
    TOYTOP_NONE = 7,
    /// The motion is aperiodic, and such a motion has no table.
    TOYTOP_NO_TABLE = 8,
}

use toytop_status::{
    TOYTOP_NO_TABLE, TOYTOP_NOT_FINITE, TOYTOP_OK, TOYTOP_OUT_OF_RANGE, TOYTOP_TABLE_TOO_SMALL,
};

/// Bytes of the text of an error, the closing zero included.
pub const TOYTOP_TEXT_SIZE: usize = 192;

/// Reason why a call was refused.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_error {
    /// Status that the call returned.
    pub status: toytop_status,
    /// With `TOYTOP_TABLE_TOO_SMALL`: number of segments of the table, which is not enough.
    pub segments: u32,
    /// One line without its end, such as "tilt: must be between 0 and pi"; it closes with a zero.
    pub text: [c_char; TOYTOP_TEXT_SIZE],
}

/// Texts of the status codes, by their numbers.
const TEXTS: [&CStr; 9] = [
    c"ok",
    c"pointer: must not be null",
    c"a parameter must be a finite number",
    c"a parameter is out of its allowed range",
    c"table: must have more segments for this motion",
    c"table or workspace: must be aligned to 8 bytes, and a table must hold at least 8 segments",
    c"table, motion, cursor, sample or events: must be made first, after the last set-up of the table",
    c"the motion has no such event, angle or derivative",
    c"an aperiodic motion has no table",
];

fn line(status: u32) -> &'static CStr {
    TEXTS.get(status as usize).copied().unwrap_or(c"not a status of toytop")
}

/// Text of a status code, in one line; never null.
#[unsafe(no_mangle)]
pub extern "C" fn toytop_status_text(status: u32) -> *const c_char {
    line(status).as_ptr()
}

/// Reason for a refusal, before it is written to the memory of the caller.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Refusal {
    status: toytop_status,
    segments: u32,
    /// Name and allowed values of a parameter.
    parameter: Option<[&'static str; 2]>,
}

impl From<toytop_status> for Refusal {
    fn from(status: toytop_status) -> Self {
        Self { status, segments: 0, parameter: None }
    }
}

impl From<ParameterError> for Refusal {
    fn from(error: ParameterError) -> Self {
        let status = if error.is_not_finite() { TOYTOP_NOT_FINITE } else { TOYTOP_OUT_OF_RANGE };
        Self { status, segments: 0, parameter: Some([error.parameter(), error.allowed()]) }
    }
}

impl From<SetUpError> for Refusal {
    fn from(error: SetUpError) -> Self {
        match error {
            SetUpError::TableTooSmall { segments, .. } => {
                Self { segments, ..Self::from(TOYTOP_TABLE_TOO_SMALL) }
            }
            SetUpError::Parameter(error) => error.into(),
            _ => TOYTOP_NO_TABLE.into(),
        }
    }
}

impl From<Result<(), Refusal>> for toytop_status {
    fn from(result: Result<(), Refusal>) -> Self {
        result.err().map_or(TOYTOP_OK, |refusal| refusal.status)
    }
}

/// Status of a call. The reason for a refusal goes to `error`, unless that is null.
///
/// # Safety
/// `error` is null or valid for writing.
pub(crate) unsafe fn status_of(
    error: *mut toytop_error,
    call: impl FnOnce() -> Result<(), Refusal>,
) -> toytop_status {
    let result = call();
    if !error.is_null() {
        let refusal = result.err().unwrap_or(TOYTOP_OK.into());
        // SAFETY: the caller guarantees that the pointer, which is not null, is valid.
        unsafe { error.write_unaligned(refusal.described()) };
    }
    result.into()
}

impl Refusal {
    fn described(&self) -> toytop_error {
        let parts = match self.parameter {
            Some([parameter, allowed]) => [parameter.as_bytes(), b": must be ", allowed.as_bytes()],
            None => [line(self.status as u32).to_bytes(), b"", b""],
        };
        let mut text = [0; TOYTOP_TEXT_SIZE];
        // a longer text is cut off; the last byte stays the closing zero
        for (place, byte) in text.iter_mut().take(TOYTOP_TEXT_SIZE - 1).zip(parts.into_iter().flatten()) {
            *place = *byte as c_char;
        }
        toytop_error { status: self.status, segments: self.segments, text }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Release, State};

    fn text(refusal: impl Into<Refusal>) -> String {
        let described = refusal.into().described();
        // SAFETY: the text closes with a zero.
        unsafe { CStr::from_ptr(described.text.as_ptr()) }.to_str().map(str::to_owned).unwrap_or_default()
    }

    #[test]
    fn a_refusal_names_the_parameter_and_what_is_allowed() {
        let refused = |release| State::from_release(&release).err().map(text);
        let tilt = refused(Release { tilt: 4.0, ..Release::default() });
        assert_eq!(tilt.as_deref(), Some("tilt: must be between 0 and pi"));
        let spin = refused(Release { spin: f64::NAN, ..Release::default() });
        assert_eq!(spin.as_deref(), Some("spin: must be a finite number"));
    }

    #[test]
    fn a_long_text_is_cut_before_its_zero() {
        let allowed = "x".repeat(300).leak();
        let refused = ParameterError::new("tilt", allowed);
        assert_eq!(text(refused).len(), TOYTOP_TEXT_SIZE - 1);
    }
}
