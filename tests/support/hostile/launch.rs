//! Tops, states and launches from arbitrary bits.

use super::input::Input;
use super::sound;

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    match input.motion() {
        Ok(motion) => sound::motion(&motion, &mut input),
        Err(error) => assert!(!error.parameter().is_empty() && !error.allowed().is_empty()),
    }
}
