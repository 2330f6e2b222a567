//! Baked tables: conversion to literal data and back loses nothing, and changed data are refused.

use super::input::Input;
use toytop::{Baked, Ephemeris, Motion, Tick};

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    let double = input.byte() % 2 == 1;
    let Ok(motion) = input.motion() else { return };
    let Ok(tick) = input.tick(&motion) else { return };
    if double { in_f64(&motion, tick, &mut input) } else { in_f32(&motion, tick, &mut input) }
}

/// Test of one scalar, as a macro because the functions for constants belong to no trait.
macro_rules! there_and_back {
    ($name:ident, $scalar:ty, $changed:ident) => {
        fn $name(motion: &Motion, tick: Tick, input: &mut Input<'_>) {
            let Ok(ephemeris) = Ephemeris::<$scalar, 16>::within(motion, tick, input.truncation()) else {
                return;
            };
            let baked = ephemeris.to_baked();
            let back = baked.ephemeris().unwrap_or_else(|error| panic!("{error}"));
            assert!(back == ephemeris && back.to_baked() == baked);
            let mut changed = baked.clone();
            flip_head(&mut changed, input);
            assert!(changed.ephemeris().is_err());
            let mut changed = baked.clone();
            let [segment, power, part, bit] = [input.byte(), input.byte(), input.byte(), input.byte()];
            let segment = &mut changed.segments[usize::from(segment % 16)];
            let place = &mut segment[usize::from(power) % segment.len()];
            $changed(&mut place[usize::from(part % 4)], bit);
            assert!(changed.ephemeris().is_err());
        }
    };
}

there_and_back!(in_f32, f32, flip_i32);
there_and_back!(in_f64, f64, flip_f64);

fn flip_i32(number: &mut i32, bit: u8) {
    *number ^= 1 << (bit % 32);
}

fn flip_f64(number: &mut f64, bit: u8) {
    *number = f64::from_bits(number.to_bits() ^ (1 << (bit % 64)));
}

/// Flips one bit outside the segments.
fn flip_head<R: toytop::EphemerisScalar>(baked: &mut Baked<R, 16>, input: &mut Input<'_>) {
    let [place, bit] = [input.byte(), input.byte()];
    let entry = usize::from(place / 16) % 3;
    match place % 10 {
        0 => baked.format ^= 1 << (bit % 32),
        1 => baked.crc32 ^= 1 << (bit % 32),
        2 => baked.clock.first[entry] ^= 1 << (bit % 64),
        3 => baked.clock.step[entry][usize::from(bit) % 3] ^= 1 << (bit % 32),
        4 => flip_f64(&mut baked.clock.exact_step[entry][usize::from(bit) % 2], bit),
        5 => flip_f64(&mut baked.clock.ticks_per_time[entry % 2], bit),
        6 => baked.clock.tip.start[entry] ^= 1 << (bit % 32),
        7 => baked.clock.tip.step[entry] ^= 1 << (bit % 32),
        8 => flip_f64(&mut baked.error_bound.per_tick, bit),
        _ => match &mut baked.clock.horizon {
            Some(horizon) => horizon[entry % 2] ^= 1 << (bit % 64),
            None => baked.clock.horizon = Some([0; 2]),
        },
    }
}
