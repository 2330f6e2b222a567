//! Ephemerides in fixed point of 32 and of 16 bits.

use super::ephemeris;
use super::input::Input;
use fixed::types::{I2F14, I2F30};

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    if input.byte().is_multiple_of(2) {
        ephemeris::check::<I2F30, 16>(&mut input);
    } else {
        ephemeris::check::<I2F14, 32>(&mut input);
    }
}
