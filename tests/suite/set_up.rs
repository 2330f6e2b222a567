//! Set-up in slices gives the same table as one call, for any interruptions.

use fixed::types::I2F30;
use std::task::Poll;
use toytop::{
    Ephemeris, EphemerisScalar, EphemerisView, Launch, Motion, ParameterError, Release, SetUp, State,
    TableTooSmall, Tick, Top, TopParameters,
};
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
    equal_the_blocking_ones::<I2F30>();
}

#[test]
fn a_refusal_takes_no_more_than_two_tables() {
    let motion = vectors::named("exact_near_separatrix_straddle").motion().unwrap();
    let (mut small, mut large) = (Ephemeris::<f32, 16>::EMPTY, Ephemeris::<f32, 32>::EMPTY);
    let (refused, ready) = (polled(&motion, &mut small), polled(&motion, &mut large));
    let truncation = 2.0 * f64::from(f32::EPSILON);
    assert_eq!(refused.0, Err(TableTooSmall { truncation, segments: 16 }));
    assert_eq!(ready.0, Ok(()));
    assert!((3..2 * ready.1).contains(&refused.1), "{} and {} slices", refused.1, ready.1);
}

/// Tables of 64 segments for 600 tops of all kinds, slender ones among them. A refusal from the estimate must be right, and nine of ten
/// refusals come before a third of the segments is computed.
#[test]
fn a_table_that_cannot_fit_is_refused_early() {
    const SEGMENTS: usize = 64;
    let (mut refused, mut at_once, mut early) = (0, 0, 0);
    for number in 1..=600 {
        // a sequence of low discrepancy
        let [first, second, third] =
            [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|step| (step * f64::from(number)).fract());
        let a = 0.05 * 0.03 * 0.03 * 10_f64.powf(5.0 * third - 2.0);
        let top = Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: 0.67 * a,
            com_height: 0.03,
            mass: 0.05,
            ..TopParameters::default()
        });
        let release = Release {
            tilt: std::f64::consts::PI * first,
            spin: 1000.0 * second * second,
            ..Release::default()
        };
        let motion = Motion::launch(&top.unwrap(), &State::release(&release).unwrap()).unwrap();
        let mut table = Ephemeris::<I2F30, SEGMENTS>::EMPTY;
        let (result, slices) = polled(&motion, &mut table);
        if let Err(TableTooSmall { truncation, .. }) = result {
            let needed = EphemerisView::<I2F30>::segments_needed(&motion, truncation);
            assert!(needed.is_none_or(|needed| needed > SEGMENTS as u32), "{release:?}: {needed:?}");
            refused += 1;
            at_once += usize::from(slices <= 8);
            early += usize::from(slices < 7 * SEGMENTS / 3);
        }
    }
    assert!(refused > 100 && 2 * at_once > refused, "{at_once} at once and {early} early of {refused}");
    assert!(10 * early > 9 * refused, "{at_once} at once and {early} early of {refused}");
}

/// Polls a launch until the end; the result and the number of slices.
fn launched(top: &Top, release: &Release) -> (Result<Motion, ParameterError>, usize) {
    let mut launch = Launch::new(top, &State::release(release).unwrap());
    for slices in 1.. {
        if let Poll::Ready(result) = launch.poll() {
            assert_eq!(launch.poll(), Poll::Ready(result), "and so it stays");
            return (result, slices);
        }
    }
    unreachable!("a launch ends")
}

#[test]
fn a_launch_takes_a_slice_for_each_node() {
    let parameters = TopParameters {
        transverse_inertia: 3e-5,
        axial_inertia: 2e-5,
        com_height: 0.03,
        mass: 0.05,
        ..TopParameters::default()
    };
    let top = Top::sliding(&parameters).unwrap();
    let thrown = |tilt, spin| Release { tilt, spin, ..Release::default() };
    // steady motions have the period of a small nutation; a top that rests upright below its critical spin has none
    for (release, fewest, most) in [
        (thrown(0.35, 150.0), 26, 30),
        (thrown(1e-3, 30.0), 98, 108),
        (thrown(0.0, 150.0), 10, 28),
        (thrown(0.0, 1.0), 8, 9),
    ] {
        let (motion, slices) = launched(&top, &release);
        assert!((fewest..=most).contains(&slices), "{release:?}: {slices} slices");
        assert_eq!(motion, Motion::launch(&top, &State::release(&release).unwrap()));
    }
    let free = Top::free(&parameters).unwrap();
    let (motion, slices) = launched(&free, &thrown(0.35, 150.0));
    assert!(motion.unwrap().period_advance().is_some() && slices < 10, "{slices} slices without a torque");
}

/// The most slender top that is accepted, A/(ps) = 1e-6, through the lower vertical and close to the upper one. The number of nodes depends
/// on K/K' alone; with the nutation angle as the variable it was 65 537.
#[test]
fn a_slender_top_needs_few_nodes() {
    let slender = Top::sliding(&TopParameters {
        transverse_inertia: 1.01e-6,
        axial_inertia: 1e-6,
        com_height: 1.0,
        mass: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    });
    let (motion, slices) =
        launched(&slender.unwrap(), &Release { tilt: 1e-3, spin: 1e-3, ..Release::default() });
    assert!(motion.unwrap().period_advance().is_some());
    assert!((60..=160).contains(&slices), "{slices} slices");
}

#[test]
fn a_launch_that_is_refused_ends_at_its_branch_points() {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 1.0,
        axial_inertia: 1.0,
        com_height: 1.0,
        mass_moment: 1e-9,
        ..TopParameters::default()
    })
    .unwrap();
    let (refused, slices) = launched(&top, &Release { tilt: 0.3, spin: 1e6, ..Release::default() });
    assert_eq!(refused.unwrap_err().parameter(), "omega");
    assert_eq!(slices, 4);
}

/// One launch and one set-up serve many motions: nothing of the one before is left, whether it is complete, refused or interrupted.
#[test]
fn memory_is_used_again() {
    let top = *vectors::named("si_toytop_150").motion().unwrap().top();
    let tick = Tick::hertz(1000).unwrap();
    let release = |tilt, spin| Release { tilt, spin, ..Release::default() };
    let releases = [
        release(0.35, 150.0),
        release(0.35, 1e10),
        release(0.0, 300.0),
        release(1e-3, 30.0),
        release(2.0, 5.0),
    ];
    let first = State::release(&releases[0]).unwrap();
    let mut launch = Launch::<f32>::for_scalar(&top, &first);
    let mut set_up = SetUp::new(&Motion::launch_for::<f32>(&top, &first).unwrap(), tick);
    let mut kinds = [0; 2];
    for (number, release) in releases.iter().cycle().take(3 * releases.len()).enumerate() {
        let state = State::release(release).unwrap();
        launch.restart(&top, &state);
        assert_eq!(launch.motion(), None);
        // every third launch is interrupted
        for _ in 0..if number % 3 == 2 { number } else { usize::MAX } {
            if launch.proceed().is_ready() {
                break;
            }
        }
        if number % 3 == 2 {
            continue;
        }
        let fresh = Motion::launch_for::<f32>(&top, &state);
        assert_eq!(
            (launch.proceed(), launch.motion()),
            (Poll::Ready(fresh.map(drop)), fresh.as_ref().ok()),
            "{release:?}"
        );
        kinds[usize::from(fresh.is_ok())] += 1;
        let Ok(motion) = fresh else { continue };
        let (mut table, mut expected) = (Ephemeris::<f32, 64>::EMPTY, Ephemeris::<f32, 64>::EMPTY);
        set_up.restart(&motion, tick);
        let result = loop {
            if let Poll::Ready(result) = set_up.poll(&mut table) {
                break result;
            }
        };
        assert_eq!((result, polled(&motion, &mut expected).0), (Ok(()), Ok(())), "{release:?}");
        assert!(table == expected, "{release:?}");
    }
    assert!(kinds.iter().all(|kind| *kind > 1), "{kinds:?}");
}
