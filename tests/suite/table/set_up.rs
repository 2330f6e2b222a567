//! Set-up in the memory of a program: other work in between, equal tables, and refusals.

use fixed::types::{I2F14, I2F30};
use toytop::{
    Ephemeris, EphemerisMemory, EphemerisScalar, EphemerisView, Motion, ParameterError, Release, SetUp,
    SetUpError, State, Top, TopParameters,
};
use toytop_tests::{kilohertz, vectors};

fn equal_the_ones_by_value<R: EphemerisScalar>() {
    const SEGMENTS: usize = 128;
    let (mut set_up, mut memory) = (SetUp::new(), EphemerisMemory::<Ephemeris<R, SEGMENTS>>::new());
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let mut calls = 0;
        let table = memory.set_up(&mut set_up, &motion, kilohertz(), 0, &mut || calls += 1);
        match (table, Ephemeris::<R, SEGMENTS>::new(&motion, kilohertz())) {
            (Ok(table), Ok(by_value)) => assert!(*table == *by_value, "{}", vector.name),
            (refusal, by_value) => assert_eq!(refusal.err(), by_value.err(), "{}", vector.name),
        }
        // some twenty calls for each segment, each of which may be computed several times
        assert!(calls < 60 * SEGMENTS, "{}: {calls} calls", vector.name);
    }
}

/// One memory serves many motions: nothing of the one before is left, whether it is complete or refused.
#[test]
fn tables_in_place_equal_those_by_value() {
    equal_the_ones_by_value::<f32>();
    equal_the_ones_by_value::<f64>();
    equal_the_ones_by_value::<I2F30>();
}

/// Other work is done in between, however many segments there are, and a refusal takes no longer than a table.
#[test]
fn a_refusal_takes_no_more_than_a_table() {
    let motion = vectors::motion("exact_near_separatrix_straddle");
    let calls = |memory: &mut EphemerisMemory<EphemerisView<f32>>| {
        let mut calls = 0;
        let refused = memory.set_up(&mut SetUp::new(), &motion, kilohertz(), 0, &mut || calls += 1).err();
        (refused, calls)
    };
    let refused = calls(&mut EphemerisMemory::<Ephemeris<f32, 16>>::new());
    let ready = calls(&mut EphemerisMemory::<Ephemeris<f32, 64>>::new());
    let truncation = f64::from(f32::EPSILON);
    assert_eq!(refused.0, Some(SetUpError::TooSmall { truncation, segments: 16 }));
    assert_eq!(ready.0, None);
    assert!((50..ready.1).contains(&refused.1), "{} and {} calls", refused.1, ready.1);
}

/// Tables of 64 segments for 600 tops of all kinds, slender ones among them: a refusal is right.
#[test]
fn a_table_that_would_fit_is_not_refused() {
    const SEGMENTS: usize = 64;
    let mut refused = 0;
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
        if let Err(error) = Ephemeris::<I2F30, SEGMENTS>::new(&motion, kilohertz()) {
            assert!(matches!(error, SetUpError::TooSmall { segments: 64, .. }), "{release:?}: {error}");
            let needed = EphemerisView::<I2F30>::segments_needed(&motion, I2F30::TRUNCATION);
            assert!(needed.is_none_or(|needed| needed > SEGMENTS as u32), "{release:?}: {needed:?}");
            refused += 1;
        }
    }
    assert!(refused > 100, "{refused} refused");
}

/// Number of tables of exactly as many segments as are needed, of all vectors and of many allowed errors.
fn tables_of_the_needed_size<R: EphemerisScalar, const SEGMENTS: usize>() -> usize {
    let mut tables = 0;
    for vector in vectors::tabulated() {
        let motion = vector.motion().unwrap();
        for truncation in (0..30).map(|power| R::TRUNCATION * 2.5_f64.powi(power)) {
            if EphemerisView::<R>::segments_needed(&motion, truncation) == Some(SEGMENTS as u32) {
                let table = Ephemeris::<R, SEGMENTS>::within(&motion, kilohertz(), truncation);
                assert!(table.is_ok(), "{}, {truncation:e}: {:?}", vector.name, table.err());
                tables += 1;
            }
        }
    }
    tables
}

/// The number of segments that is stated to be needed is enough.
#[test]
fn a_table_of_the_needed_size_is_not_refused() {
    fn tables<R: EphemerisScalar>() -> [usize; 7] {
        [
            tables_of_the_needed_size::<R, 8>(),
            tables_of_the_needed_size::<R, 9>(),
            tables_of_the_needed_size::<R, 10>(),
            tables_of_the_needed_size::<R, 12>(),
            tables_of_the_needed_size::<R, 16>(),
            tables_of_the_needed_size::<R, 25>(),
            tables_of_the_needed_size::<R, 64>(),
        ]
    }
    for tables in [tables::<f32>(), tables::<f64>(), tables::<I2F30>(), tables::<I2F14>()] {
        assert!(tables[0] > 20 && tables.iter().sum::<usize>() > 100, "{tables:?}");
    }
}

/// Launch, and the number of times that it called the work in between.
fn launched(top: &Top, release: &Release) -> (Result<Motion, ParameterError>, usize) {
    let mut calls = 0;
    let motion = Motion::launch_between(top, &State::release(release).unwrap(), &mut || calls += 1);
    (motion, calls)
}

#[test]
fn a_launch_gives_time_between_its_stages() {
    let parameters = TopParameters {
        transverse_inertia: 3e-5,
        axial_inertia: 2e-5,
        com_height: 0.03,
        mass: 0.05,
        ..TopParameters::default()
    };
    let thrown = |tilt, spin| Release { tilt, spin, ..Release::default() };
    for (top, release) in [
        (Top::sliding(&parameters), thrown(0.35, 150.0)),
        (Top::sliding(&parameters), thrown(1e-3, 30.0)),
        (Top::sliding(&parameters), thrown(0.0, 1.0)),
        (Top::free(&parameters), thrown(0.35, 150.0)),
    ] {
        let (motion, calls) = launched(&top.unwrap(), &release);
        assert!((4..=12).contains(&calls), "{release:?}: {calls} calls");
        assert_eq!(motion, Motion::launch(&top.unwrap(), &State::release(&release).unwrap()));
    }
}
