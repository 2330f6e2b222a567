//! Program with a small set-up and a fast tick: `toytop budget --flash` compiles it for size, and its tick, in the crate `toytop-fast-tick`,
//! for speed. Its flash beyond that of `empty` is the flash of a launch, a table and a tick in `f32`.

#![no_std]
#![no_main]

use core::hint::black_box;

use semihosting::process;
use toytop::{
    Cursor, Motion, ParameterError, Release, State, Table, TableF32, TableMemory, Tick, Top, TopParameters,
    Workspace,
};
use toytop_cost::entry;

#[entry]
fn main() -> ! {
    let (mut workspace, mut memory) = (Workspace::new(), TableMemory::<TableF32>::new());
    let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
    let fits = launch(&black_box(TopParameters::TOY), &black_box(release))
        .and_then(|motion| Ok(memory.set_up(&mut workspace, &motion, Tick::hertz(1000)?, &mut || {})));
    let Ok(Ok(table)) = fits else { process::exit(1) };
    let (mut cursor, mut quaternion) = (table.cursor(0), [0.0; 4]);
    for _ in 0..8 {
        bench_fast_tick(&mut cursor, table, &mut quaternion);
        black_box(quaternion);
    }
    process::exit(0)
}

fn launch(parameters: &TopParameters, release: &Release) -> Result<Motion, ParameterError> {
    Motion::launch(&Top::sliding(parameters)?, &State::from_release(release)?)
}

#[inline(never)]
#[unsafe(no_mangle)]
fn bench_fast_tick(cursor: &mut Cursor<f32>, table: &Table<f32>, out: &mut [f32; 4]) {
    *out = toytop_fast_tick::next(cursor, table);
}
