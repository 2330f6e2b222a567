//! Relaunch after an impulse: a blow changes ω at once and leaves the orientation as it is.
//!
//! The motion after the blow is another exact motion. The cursor in the interrupt is replaced together with the table.

use toytop::{EphemerisF64, Motion, Release, State, Tick, Top, TopParameters};

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 3.0e-5,
        axial_inertia: 2.0e-5,
        com_height: 0.03,
        mass: 0.05,
        gravity: 9.81,
        ..TopParameters::default()
    })?;
    let state = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    let tick = Tick::hertz(1000)?;
    let before = EphemerisF64::new(&Motion::launch(&top, &state)?, tick)?;

    // At tick 250 a flick of two fingers adds an angular impulse of 4e-4 N m s about the top's own axis r: ω changes by that
    // over C, along r.
    let struck_at = 250;
    let struck = before.at_tick(struck_at).attitude_state().state()?;
    let added = 4.0e-4 / top.axial_inertia();
    let ([x, y, z], [r1, r2, r3]) = (struck.omega(), struck.orientation().axis());
    let state = State::new(struck.orientation(), [x + added * r1, y + added * r2, z + added * r3])?;
    let after = EphemerisF64::new(&Motion::launch(&top, &state)?, tick)?;

    // Tick 0 of the new table is tick 250 of the old one.
    let jump = before.at_tick(struck_at).orientation().distance(&after.at_tick(0).orientation());
    println!("the orientation jumps by {jump:.1e} rad");
    println!("omega before: {:?} rad/s", before.at_tick(struck_at).omega());
    println!("omega after:  {:?} rad/s", after.at_tick(0).omega());
    println!(
        "u a tenth of a second later: {} instead of {}",
        after.at_tick(100).u(),
        before.at_tick(350).u()
    );

    assert!(jump < 1e-12);
    let [.., spin_before] = before.at_tick(struck_at).omega_body();
    let [.., spin_after] = after.at_tick(0).omega_body();
    println!("spin: {spin_before} rad/s before, {spin_after} rad/s after");
    assert!((spin_after - spin_before - added).abs() < 1e-9);
    Ok(())
}
