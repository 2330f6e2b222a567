//! Set-ups of tables in a crate of their own: an archive compiles them for size, and the ticks in `toytop-c` for speed.

#![no_std]

use toytop::fixed::types::I2F30;
use toytop::{Motion, SetUpError, Table, TableMemory, TableScalar, TableSettings, Workspace};

/// Functions of one scalar. As a static has their addresses, they are compiled here and not where they are called.
pub struct SetUp<R: TableScalar> {
    /// See [`TableMemory::set_up`].
    pub set_up: for<'a> fn(
        &'a mut TableMemory<Table<R>>,
        &mut Workspace,
        &Motion,
        TableSettings,
        &mut dyn FnMut(),
    ) -> Result<&'a Table<R>, SetUpError>,
    /// See [`Table::segments_needed`].
    pub segments_needed: fn(&Motion, f64) -> Result<u32, SetUpError>,
}

impl<R: TableScalar> SetUp<R> {
    const NEW: Self =
        Self { set_up: TableMemory::<Table<R>>::set_up, segments_needed: Table::<R>::segments_needed };
}

/// Functions in `f32`.
pub static F32: SetUp<f32> = SetUp::NEW;
/// Functions in `f64`.
pub static F64: SetUp<f64> = SetUp::NEW;
/// Functions in fixed point of 32 bits.
pub static Q31: SetUp<I2F30> = SetUp::NEW;
