//! Tables as literal data are compared with the tables that they came from, and changed data are refused.

use fixed::types::{I2F14, I2F30};
use toytop::{Baked, BakedError, SizedTable, Tick};
use toytop_tests::random::Random;
use toytop_tests::{kilohertz, vectors};

/// Sets the checksum to that of the data.
macro_rules! set_checksum {
    ($baked:expr) => {
        if let Err(BakedError::Checksum { computed, .. }) = $baked.table() {
            $baked.crc32 = computed;
        }
    };
}

/// Number of tables that fit, 0 or 1. A table that fits is the same after conversion there and back.
macro_rules! converted {
    ($scalar:ty, $segments:literal, $vector:expr, $tick:expr) => {{
        let table = SizedTable::<$scalar, $segments>::new(&$vector.motion().unwrap(), $tick).ok();
        table.map_or(0, |table| {
            let baked = table.to_baked();
            let back = baked.table().unwrap();
            // the checksum depends on the sign of a zero, which `==` ignores
            assert!(back == table && back.to_baked().crc32 == baked.crc32, "{}", $vector.name);
            for n in [0, 77, -1 << 40, i64::MAX] {
                assert_eq!(back.at_tick(n).attitude_state(), table.at_tick(n).attitude_state());
            }
            1
        })
    }};
}

#[test]
fn conversion_there_and_back_keeps_every_bit() {
    let mut counts = [0; 4];
    for vector in vectors::tabulated() {
        let eight = Tick::hertz(8000).unwrap();
        counts[0] += converted!(f32, 256, vector, kilohertz());
        counts[1] += converted!(f64, 256, vector, Tick::ratio(44_100, 2).unwrap());
        counts[2] += converted!(I2F30, 256, vector, eight);
        counts[3] += converted!(I2F14, 128, vector, eight);
    }
    assert!(counts.iter().all(|count| *count > 40), "{counts:?}");
}

/// Change of one number.
type Change = fn(&mut Baked<f32, 25>);

fn refused(baked: &Baked<f32, 25>, change: Change) -> Option<BakedError> {
    let mut changed = baked.clone();
    change(&mut changed);
    changed.table().err()
}

#[test]
fn a_bit_flipped_anywhere_is_refused() {
    let motion = vectors::motion("exact_generic_pp");
    let baked = SizedTable::<f32, 25>::new(&motion, kilohertz()).unwrap().to_baked();
    let changes: [Change; 15] = [
        |baked| baked.clock.epoch += 1,
        |baked| baked.clock.mean_tip_at_tick_0[3] ^= 1,
        |baked| baked.clock.tip_passages ^= 1,
        |baked| baked.clock.has_turning_points = !baked.clock.has_turning_points,
        |baked| baked.crc32 ^= 1 << 31,
        |baked| baked.clock.first_phases[1] ^= 1 << 63,
        |baked| baked.clock.increments[2][0] ^= 1,
        |baked| baked.clock.increments[0][3] ^= 1,
        |baked| baked.clock.ticks_per_time[1] = -baked.clock.ticks_per_time[1],
        |baked| baked.error_bound.constant = f64::from_bits(baked.error_bound.constant.to_bits() ^ 1),
        |baked| baked.rate_error_bound.per_tick *= 1.5,
        |baked| baked.clock.twice_tip_scale = -baked.clock.twice_tip_scale,
        |baked| baked.clock.x_rate = f32::from_bits(baked.clock.x_rate.to_bits() ^ 1),
        |baked| baked.cells[15] ^= 1,
        |baked| baked.segments.swap(3, 4),
    ];
    for (index, change) in changes.into_iter().enumerate() {
        assert!(matches!(refused(&baked, change), Some(BakedError::Checksum { .. })), "{index}");
    }
    assert_eq!(refused(&baked, |baked| baked.format += 1), Some(BakedError::Format { found: 12 }));
    // every bit of every coefficient
    for segment in 0..25 {
        for bit in 0..5 * 4 * 32 {
            let mut changed = baked.clone();
            changed.segments[segment][bit / 128][bit / 32 % 4] ^= 1 << (bit % 32);
            assert!(matches!(changed.table(), Err(BakedError::Checksum { .. })), "{segment} {bit}");
        }
    }
}

/// Random numbers under a correct checksum either are refused or give finite numbers, without overflow.
macro_rules! wild {
    ($name:ident, $scalar:ty, $segments:literal, $coefficient:ty) => {
        #[test]
        fn $name() {
            let motion = vectors::motion("exact_generic_pp");
            let table = SizedTable::<$scalar, $segments>::new(&motion, kilohertz()).unwrap();
            let baked = table.to_baked();
            let mut random = Random(0x9e37_79b9_7f4a_7c15);
            let mut draw = || random.bits();
            let (mut refused, mut read) = (0, 0);
            for k in 0..4000 {
                let mut wild = baked.clone();
                // from all bits of a coefficient to only a few
                let shift = k % 56;
                let row = &mut wild.segments[draw() as usize % $segments];
                let power = draw() as usize % row.len();
                for number in row[power..].iter_mut().flatten() {
                    *number = <$coefficient>::wild(draw(), shift);
                }
                if k % 3 == 0 {
                    wild.clock.first_phases = [0; 3].map(|_: u64| draw());
                    wild.cells = [0; 16].map(|_: u16| draw() as u16);
                }
                set_checksum!(wild);
                let Ok(table) = wild.table() else {
                    refused += 1;
                    continue;
                };
                read += 1;
                for n in (0..300).map(|n| n * 7).chain([i64::MIN, i64::MAX, draw() as i64]) {
                    let sample = table.at_tick(n);
                    let phi = sample.orientation();
                    let tip = sample.tip_over_s();
                    let (attitude, wide) = (sample.attitude_state(), sample.tip());
                    let [x, y, z] = attitude.omega();
                    let numbers =
                        [wide.re, wide.im, attitude.orientation.u(), attitude.udot(), x, y, z].map(f64::from);
                    let of_scalar = [phi.alpha.re, phi.beta.im, tip.re, tip.im].map(f64::from);
                    assert!(numbers.iter().chain(&of_scalar).all(|x| x.is_finite()), "{n}");
                    let _ = (table.turning_points(n).next(), table.cursor(n).next(&table).orientation());
                }
            }
            assert!(refused > 200 && read > 300, "{refused} refused, {read} read");
        }
    };
}

wild!(wild_numbers_in_f32_are_refused_or_read, f32, 64, i32);
wild!(wild_numbers_in_q31_are_refused_or_read, I2F30, 256, i32);
wild!(wild_numbers_in_q15_are_refused_or_read, I2F14, 128, i16);
wild!(wild_numbers_in_f64_are_refused_or_read, f64, 64, f64);

/// Coefficient with random bits; larger `shift` (below 56) gives smaller numbers.
trait Wild {
    fn wild(bits: u64, shift: u32) -> Self;
}

impl Wild for i32 {
    fn wild(bits: u64, shift: u32) -> Self {
        (bits >> 32) as Self >> (shift / 8)
    }
}

impl Wild for i16 {
    fn wild(bits: u64, shift: u32) -> Self {
        (bits >> 48) as Self >> (shift / 8)
    }
}

impl Wild for f64 {
    fn wild(bits: u64, shift: u32) -> Self {
        if shift & 1 == 0 { Self::from_bits(bits) } else { (bits as Self).powi(shift as i32 % 4) }
    }
}

/// A field with a number that is not finite, or too large for a tick, is named.
#[test]
fn a_field_beyond_its_range_is_named() {
    let motion = vectors::motion("exact_generic_pp");
    let baked = SizedTable::<f32, 25>::new(&motion, kilohertz()).unwrap().to_baked();
    let changes: [(Change, &str); 9] = [
        (|baked| baked.clock.ticks_per_time[0] = f64::INFINITY, "ticks_per_time"),
        (|baked| baked.error_bound.constant = f64::NAN, "error_bound"),
        (|baked| baked.error_bound.per_tick = f64::NEG_INFINITY, "error_bound"),
        (|baked| baked.clock.twice_tip_scale = f32::MAX, "twice_tip_scale"),
        (|baked| baked.clock.spin = f32::NAN, "spin"),
        // a sum of 2^31 is the smallest that is too large: the half of 1 is rounded up
        (|baked| baked.segments[3][1..3].copy_from_slice(&[[i32::MAX, 0, 0, 0], [1, 0, 0, 0]]), "segments"),
        (|baked| baked.segments[24][4][3] = i32::MIN, "segments"),
        // the last cell refers beyond the last segment; a depth of 17
        (|baked| baked.cells[15] += 25 << 4, "cells"),
        (|baked| baked.cells[0] = 14, "cells"),
    ];
    for (change, field) in changes {
        let mut changed = baked.clone();
        change(&mut changed);
        set_checksum!(changed);
        let error = changed.table().err();
        assert_eq!(error, Some(BakedError::OutOfRange { field }), "{field}");
    }
    // the largest sum that is allowed
    let mut changed = baked.clone();
    changed.segments[3][1..].fill([0; 4]);
    changed.segments[3][1] = [i32::MAX, -i32::MAX, 0, 0];
    set_checksum!(changed);
    assert!(changed.table().is_ok());
}

#[test]
fn a_table_without_segments_is_refused() {
    let motion = vectors::motion("exact_generic_pp");
    let baked = SizedTable::<f32, 25>::new(&motion, kilohertz()).unwrap().to_baked();
    let Baked { format, clock, error_bound, rate_error_bound, cells, .. } = baked;
    let mut empty =
        Baked::<f32, 0> { format, crc32: 0, clock, error_bound, rate_error_bound, cells, segments: [] };
    set_checksum!(empty);
    assert_eq!(empty.table().err(), Some(BakedError::OutOfRange { field: "cells" }));
}

/// The page on the format states its number, and has a row for every field of the clock in the order of the structure.
#[test]
fn the_page_states_the_format_and_the_fields_of_the_clock() {
    let page = include_str!("../../../core/docs/table_format.md");
    let rows: Vec<&str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `clock."))
        .filter_map(|row| row.split('`').next())
        .collect();
    let motion = vectors::motion("exact_generic_pm");
    let clock = format!("{:?}", toytop::TableF32::new(&motion, kilohertz()).unwrap().clock());
    let fields: Vec<&str> = clock
        .split(['{', ','])
        .filter_map(|part| part.split_once(':'))
        .map(|(name, _)| name.trim())
        .collect();
    assert_eq!(rows, fields);
    let format = Baked::<f32, 25>::FORMAT;
    for stated in [format!("specifies format **{format}**"), format!("| `format` | `u32` | {format} |")] {
        assert!(page.contains(&stated), "{stated}");
    }
}
