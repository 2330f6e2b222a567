//! Tick of an interrupt in a crate of its own, so that `Cargo.toml` can compile it for speed and the set-up, in the program, for size.

#![no_std]

use toytop::{Cursor, Table};

/// Quaternion of the cursor's next tick.
#[inline(never)] // in its caller it would be compiled for size
pub fn next(cursor: &mut Cursor<f32>, table: &Table<f32>) -> [f32; 4] {
    cursor.next(table).quaternion()
}
