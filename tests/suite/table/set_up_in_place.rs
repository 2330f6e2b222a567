//! Tables set up in the memory of a program are compared with tables by value, and with the size and the time that a set-up may need.

use fixed::types::{I2F14, I2F30};
use std::sync::mpsc;
use std::{mem, thread};
use toytop::{
    Motion, Release, SetUpError, SizedTable, State, Table, TableF32, TableMemory, TableScalar, TableSettings,
    Tick, Top, Workspace,
};
use toytop_tests::{TOY, kilohertz, vectors};

fn equal_the_ones_by_value<R: TableScalar>() {
    const SEGMENTS: usize = 128;
    let (mut workspace, mut memory) = (Workspace::new(), TableMemory::<SizedTable<R, SEGMENTS>>::new());
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let mut calls = 0;
        let table = memory.set_up(&mut workspace, &motion, kilohertz(), &mut || calls += 1);
        match (table, SizedTable::<R, SEGMENTS>::new(&motion, kilohertz())) {
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
fn a_refusal_takes_no_longer_than_a_table() {
    let motion = vectors::motion("exact_near_separatrix_straddle");
    let calls = |memory: &mut TableMemory<Table<f32>>| {
        let mut calls = 0;
        let refused = memory.set_up(&mut Workspace::new(), &motion, kilohertz(), &mut || calls += 1).err();
        (refused, calls)
    };
    let refused = calls(&mut TableMemory::<SizedTable<f32, 16>>::new());
    let ready = calls(&mut TableMemory::<SizedTable<f32, 64>>::new());
    let truncation = f64::from(f32::EPSILON);
    assert_eq!(refused.0, Some(SetUpError::TableTooSmall { truncation, segments: 16 }));
    assert_eq!(ready.0, None);
    assert!((50..ready.1).contains(&refused.1), "{} and {} calls", refused.1, ready.1);
}

/// Number of tables of exactly as many segments as are needed, of all vectors and of many allowed errors. A table with a segment less is refused.
fn tables_of_the_needed_size<R: TableScalar, const SEGMENTS: usize>() -> usize {
    let mut tables = 0;
    for vector in vectors::tabulated() {
        let motion = vector.motion().unwrap();
        for truncation in (0..30).map(|power| R::TRUNCATION * 2.5_f64.powi(power)) {
            let needed = Table::<R>::segments_needed(&motion, truncation);
            let segments = SEGMENTS as u32;
            let (exactly, enough) = (needed == Ok(segments), needed.is_ok_and(|n| n <= segments));
            if exactly || needed == Ok(segments + 1) || SEGMENTS == 16 {
                let table = SizedTable::<R, SEGMENTS>::new(
                    &motion,
                    TableSettings { truncation: Some(truncation), ..kilohertz().into() },
                );
                assert_eq!(table.is_ok(), enough, "{}, {truncation:e}: {needed:?}", vector.name);
                tables += usize::from(exactly);
            }
        }
    }
    tables
}

/// The number of segments that is stated to be needed is enough, and a smaller table is refused. A larger error needs fewer segments.
#[test]
fn a_table_fits_if_it_has_as_many_segments_as_needed() {
    let motion = vectors::motion("exact_near_separatrix_straddle");
    assert_eq!(TableF32::segments_needed(&motion, f64::from(f32::EPSILON)), Ok(27));
    let settings = TableSettings { truncation: Some(1e-4), ..kilohertz().into() };
    assert!(SizedTable::<f32, 16>::new(&motion, settings).is_ok());
    fn tables<R: TableScalar>() -> [usize; 8] {
        [
            tables_of_the_needed_size::<R, 8>(),
            tables_of_the_needed_size::<R, 9>(),
            tables_of_the_needed_size::<R, 10>(),
            tables_of_the_needed_size::<R, 12>(),
            tables_of_the_needed_size::<R, 16>(),
            tables_of_the_needed_size::<R, 26>(),
            tables_of_the_needed_size::<R, 27>(),
            tables_of_the_needed_size::<R, 64>(),
        ]
    }
    for tables in [tables::<f32>(), tables::<f64>(), tables::<I2F30>(), tables::<I2F14>()] {
        assert!(tables[0] > 20 && tables.iter().sum::<usize>() > 100, "{tables:?}");
    }
}

#[test]
fn a_launch_gives_time_between_its_stages() {
    for (top, tilt, spin) in [
        (Top::sliding(&TOY), 0.35, 150.0),
        (Top::sliding(&TOY), 1e-3, 30.0),
        (Top::sliding(&TOY), 0.0, 1.0),
        (Top::free(&TOY), 0.35, 150.0),
    ] {
        let (top, mut calls) = (top.unwrap(), 0);
        let state = State::from_release(&Release { tilt, spin, ..Release::default() }).unwrap();
        let motion = Motion::launch_with_pauses(&top, &state, &mut || calls += 1);
        assert!((4..=20).contains(&calls), "{tilt}, {spin}: {calls} calls");
        assert_eq!(motion, Motion::launch(&top, &state));
    }
}

/// Two threads exchange two tables: one samples every tick, as an interrupt does, and the other sets tables up.
#[test]
fn tables_are_handed_over_while_they_are_sampled() {
    const EXCHANGES: i64 = 5;
    type Memory = Box<TableMemory<TableF32>>;
    let set_up = |mut memory: Memory, name, epoch| {
        let (motion, tick) = (vectors::motion(name), Tick::hertz(16).unwrap());
        let settings = TableSettings { tick, epoch, truncation: Some(1e-3) };
        memory.set_up(&mut Workspace::new(), &motion, settings, &mut || {}).unwrap();
        memory
    };
    let first = set_up(Memory::default(), "generic_AneC", 0);
    let spare = set_up(Memory::default(), "fig3_diff_e3_3", 100);
    let (ready, fresh) = mpsc::sync_channel::<Memory>(1);
    let (done, used) = mpsc::sync_channel::<Memory>(1);
    let interrupt = thread::spawn(move || {
        let (mut memory, mut exchanges) = (first, Vec::new());
        let mut cursor = memory.get().unwrap().cursor(0);
        while exchanges.len() < EXCHANGES as usize {
            let tick = cursor.tick() + 1;
            if let Ok(new) = fresh.try_recv() {
                exchanges.push(tick);
                cursor = new.get().unwrap().cursor(tick);
                done.send(mem::replace(&mut memory, new)).unwrap();
            }
            let table = memory.get().unwrap();
            let sampled = cursor.next(table).orientation();
            assert_eq!(cursor.tick(), tick);
            assert_eq!(sampled, table.at_tick(tick).orientation());
        }
        exchanges
    });
    ready.send(spare).unwrap();
    for epoch in 1..EXCHANGES {
        ready.send(set_up(used.recv().unwrap(), "generic_AneC", epoch)).unwrap();
    }
    let exchanges = interrupt.join().unwrap();
    assert!(exchanges.is_sorted_by(|a, b| a < b), "{exchanges:?}");
}

/// A table can be read after its set-up only.
#[test]
fn memory_has_a_table_after_a_set_up() {
    let [easy, hard, rising] =
        ["exact_generic_pp", "near_separatrix_straddle", "exact_aperiodic"].map(vectors::motion);
    let settings = TableSettings::new(kilohertz());
    let mut memory = TableMemory::<SizedTable<f64, 48>>::new();
    assert!(memory.get().is_none());
    let mut workspace = Workspace::new();
    assert!(memory.set_up(&mut workspace, &easy, settings, &mut || {}).is_ok());
    assert!(memory.get().unwrap().error_bound().after(1e9) < 1e-12);
    for (truncation, motion) in [(1e-19, &hard), (1e-15, &rising), (f64::INFINITY, &easy), (-1.0, &easy)] {
        assert!(memory.set_up(&mut workspace, &easy, settings, &mut || {}).is_ok());
        let settings = TableSettings { truncation: Some(truncation), ..settings };
        assert!(memory.set_up(&mut workspace, motion, settings, &mut || {}).is_err());
        assert!(memory.get().is_none());
    }
}
