//! Baked table: computed on a PC, and compiled in as a constant.
//!
//! `toy_top.rs` was written by `toytop bake host/scenarios/toy_top.toml --hertz 1000 -o core/examples/baked/toy_top.rs`. A chip that
//! reads it needs no set-up, no RAM for the table and no floating point beyond the scalar's own. A number of the table that
//! is changed by accident keeps the program from compiling.

#[allow(unreachable_pub)] // a written file: `pub`, for whichever module includes it
mod toy_top;

use toy_top::TOY_TOP;

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let mut cursor = TOY_TOP.cursor(0);
    for _ in 0..3 {
        let quaternion = cursor.next(&TOY_TOP).quaternion();
        println!("tick {}: quaternion {quaternion:?}", cursor.tick());
    }
    println!("error bound at tick 0: {:.1e} rad", TOY_TOP.error_bound_at(0));

    // A changed number is noticed: at compile time in a constant, at run time here.
    let mut baked = TOY_TOP.to_baked();
    assert_eq!(baked.table()?.at_tick(1000).quaternion(), TOY_TOP.at_tick(1000).quaternion());
    baked.clock.first_phases[0] ^= 1;
    let refusal = baked.table().err().ok_or("a changed table was accepted")?;
    println!("after a changed bit: {refusal}");
    Ok(())
}
