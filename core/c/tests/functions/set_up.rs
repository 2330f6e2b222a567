//! Tests of set-ups: a status for each error, and equal tables with and without a workspace and pauses.

use crate::fixture::{SETTINGS, TOP, count, f32_size, launched, text};
use core::mem::MaybeUninit;
use core::ptr::{null, null_mut};
use toytop::SizedTable;
use toytop_c::toytop_status::*;
use toytop_c::*;

/// Set-ups with every error; the table is void after each that is not about its own memory.
#[test]
fn each_refused_set_up_has_a_status() {
    let motion = &launched(&TOP);
    let mut words = [0_u64; TOYTOP_TABLE_F32_SIZE / 8];
    let table: *mut toytop_table_f32 = words.as_mut_ptr().cast();
    let size = TOYTOP_TABLE_F32_SIZE;
    let mut boxed = Box::<toytop_workspace>::new_uninit();
    let empty: toytop_motion = unsafe { MaybeUninit::zeroed().assume_init() };
    let settings = toytop_settings { workspace: boxed.as_mut_ptr(), ..SETTINGS };
    let run = |table, size, motion: *const _, settings: *const _| unsafe {
        let mut why = MaybeUninit::<toytop_error>::zeroed();
        let status = toytop_f32_set_up(table, size, motion, settings, why.as_mut_ptr());
        (status, why.assume_init())
    };
    let good = || run(table, f32_size(16), motion, &toytop_settings { truncation: 1e-2, ..settings }).0;
    let read = || unsafe { toytop_f32_at_tick(table, 0, MaybeUninit::uninit().as_mut_ptr()) };
    assert_eq!(read(), TOYTOP_NOT_SET_UP);
    let odd = table.wrapping_byte_add(4);
    for (table, size, expected) in [
        (null_mut(), size, TOYTOP_NULL_POINTER),
        (odd, size - 8, TOYTOP_BAD_MEMORY),
        (table, f32_size(8) - 1, TOYTOP_BAD_MEMORY),
    ] {
        assert_eq!(run(table, size, motion, &settings).0, expected);
    }
    let settings = &settings;
    let unaligned = settings.workspace.wrapping_byte_add(4);
    for (size, motion, settings, expected, line) in [
        (size, null(), settings as *const _, TOYTOP_NULL_POINTER, ""),
        (size, motion, null(), TOYTOP_NULL_POINTER, ""),
        (size, &empty, settings, TOYTOP_NOT_SET_UP, ""),
        (size, motion, &toytop_settings { workspace: unaligned, ..*settings }, TOYTOP_BAD_MEMORY, ""),
        (
            size,
            motion,
            &toytop_settings { tick: toytop_tick { ticks: 0, seconds: 1 }, ..*settings },
            TOYTOP_OUT_OF_RANGE,
            "tick: must be a positive number",
        ),
        (
            size,
            motion,
            &toytop_settings { truncation: f64::NAN, ..*settings },
            TOYTOP_OUT_OF_RANGE,
            "truncation: must be positive",
        ),
        (
            f32_size(16),
            motion,
            &toytop_settings { truncation: 1e-12, ..*settings },
            TOYTOP_TABLE_TOO_SMALL,
            "table: must have more segments",
        ),
    ] {
        assert_eq!(good(), TOYTOP_OK);
        assert_eq!(read(), TOYTOP_OK);
        let (status, why) = run(table, size, motion, settings);
        assert_eq!([status, why.status], [expected; 2]);
        assert!(text(&why).contains(line), "{}", text(&why));
        assert_eq!(why.segments, if status == TOYTOP_TABLE_TOO_SMALL { 16 } else { 0 });
        assert_eq!(read(), TOYTOP_NOT_SET_UP, "{line}");
    }
}

/// The number of segments that is stated to be enough is, and one fewer is not: for sizes from 9 to 15, in each scalar.
#[test]
fn the_segments_needed_are_enough() {
    assert_eq!(unsafe { toytop_f32_segments_needed(&launched(&TOP), -1.0) }, 0);
    macro_rules! sizes {
        ($needed:ident, $set_up:ident, $size:ident, $standard:literal, $segment:literal) => {{
            let mut count = 0;
            for (exponent, gravity) in (4..50).flat_map(|n| [(n, 9.81), (n, 1800.0)]) {
                let motion = &launched(&toytop_top { gravity, ..TOP });
                let settings = toytop_settings { truncation: 0.5_f64.powi(exponent), ..SETTINGS };
                let segments = unsafe { $needed(motion, settings.truncation) } as usize;
                if (9..16).contains(&segments) {
                    let bytes = $size - $segment * $standard + $segment * segments;
                    let mut words = vec![0_u64; bytes / 8];
                    for (bytes, ended) in [(bytes - $segment, TOYTOP_TABLE_TOO_SMALL), (bytes, TOYTOP_OK)] {
                        let table = words.as_mut_ptr().cast();
                        assert_eq!(unsafe { $set_up(table, bytes, motion, &settings, null_mut()) }, ended);
                    }
                    count += 1;
                }
            }
            assert!(count > 4);
        }};
    }
    sizes!(toytop_f32_segments_needed, toytop_f32_set_up, TOYTOP_TABLE_F32_SIZE, 25, 80);
    sizes!(toytop_f64_segments_needed, toytop_f64_set_up, TOYTOP_TABLE_F64_SIZE, 48, 352);
    sizes!(toytop_q31_segments_needed, toytop_q31_set_up, TOYTOP_TABLE_Q31_SIZE, 32, 64);
}

#[test]
fn a_workspace_and_pauses_do_not_change_a_table() {
    let motion = launched(&TOP);
    for truncation in [0.0, 1e-4] {
        let on_stack = toytop_settings { epoch: 7, truncation, ..SETTINGS };
        let mut calls = 0_u32;
        let mut workspace = Box::<toytop_workspace>::new_uninit();
        let with_pauses = toytop_settings {
            workspace: workspace.as_mut_ptr(),
            pause: Some(count),
            context: (&raw mut calls).cast(),
            ..on_stack
        };
        let [one, other] = [on_stack, with_pauses].map(|settings| {
            let mut words = vec![0x5555_5555_5555_5555_u64; TOYTOP_TABLE_F64_SIZE / 8];
            let table = words.as_mut_ptr().cast();
            assert_eq!(
                unsafe { toytop_f64_set_up(table, TOYTOP_TABLE_F64_SIZE, &motion, &settings, null_mut()) },
                TOYTOP_OK
            );
            words
        });
        assert!(calls > 30, "{calls} calls");
        // behind the head and the flag of the memory, without padding, whose bytes may differ
        let table = |words: &[u64]| unsafe { words[2..].as_ptr().cast::<SizedTable<f64, 48>>().read() };
        assert_eq!(table(&one), table(&other), "truncation {truncation}");
        // the last 16 bits count the set-ups
        assert_eq!(one[0] << 16, other[0] << 16);
    }
}
