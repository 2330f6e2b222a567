//! Set-up in slices gives the same table as one call, for any interruptions.

use std::task::Poll;
use toytop::{Ephemeris, EphemerisScalar, Motion, SetUp, TableTooSmall, Tick};
use toytop_tests::vectors;

/// Result of a set-up in slices, and the number of slices.
fn polled<R: EphemerisScalar, const S: usize>(
    motion: &Motion,
    table: &mut Ephemeris<R, S>,
) -> (Result<(), TableTooSmall>, usize) {
    let mut set_up = SetUp::new(motion, Tick::hertz(1000).unwrap());
    for slices in 1.. {
        match set_up.poll(table) {
            Poll::Pending => assert_eq!(table.error_bound().after(0.0), f64::INFINITY),
            Poll::Ready(result) => {
                assert_eq!(set_up.poll(table), Poll::Ready(result), "and so it stays");
                assert_eq!(set_up.motion(), motion);
                return (result, slices);
            }
        }
    }
    unreachable!("a set-up ends")
}

fn equal_the_blocking_ones<R: EphemerisScalar + PartialEq + std::fmt::Debug>() {
    const SEGMENTS: usize = 128;
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let mut table = Ephemeris::<R, SEGMENTS>::EMPTY;
        let (result, slices) = polled(&motion, &mut table);
        match (result, Ephemeris::<R, SEGMENTS>::new(&motion, Tick::hertz(1000).unwrap())) {
            (Ok(()), Ok(blocking)) => assert!(table == blocking, "{}", vector.name),
            (refusal, blocking) => assert_eq!(refusal.err(), blocking.err(), "{}", vector.name),
        }
        // fifteen slices for each segment, in two attempts, each of which may halve a cell several times
        assert!(slices < 40 * SEGMENTS, "{}: {slices} slices", vector.name);
    }
}

#[test]
fn slices_give_the_table_of_one_call() {
    equal_the_blocking_ones::<f32>();
    equal_the_blocking_ones::<f64>();
    equal_the_blocking_ones::<fixed::types::I2F30>();
}

#[test]
fn a_refusal_takes_no_more_than_two_tables() {
    let motion = vectors::named("exact_near_separatrix_straddle").motion().unwrap();
    let (mut small, mut large) = (Ephemeris::<f32, 16>::EMPTY, Ephemeris::<f32, 32>::EMPTY);
    let (refused, ready) = (polled(&motion, &mut small), polled(&motion, &mut large));
    let truncation = 2.0 * f64::from(f32::EPSILON);
    assert_eq!(refused.0, Err(TableTooSmall { truncation, segments: 16 }));
    assert_eq!(ready.0, Ok(()));
    assert!((10..2 * ready.1).contains(&refused.1), "{} and {} slices", refused.1, ready.1);
}
