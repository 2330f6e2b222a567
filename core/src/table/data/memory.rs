//! Memory for a table, which cannot be read before its set-up.

use crate::table::data::{SizedTable, Table};
use crate::table::evaluation::TableScalar;
use core::ops::{Deref, DerefMut};

/// Memory of a table, in a static for example. The table cannot be read before its set-up.
#[derive(Debug)]
#[repr(C)] // the C interface reads it by its address
pub struct TableMemory<T: ?Sized> {
    /// Whether the last set-up succeeded.
    pub(crate) is_set_up: bool,
    pub(crate) table: T,
}

impl<R: TableScalar, const SEGMENTS: usize> TableMemory<SizedTable<R, SEGMENTS>> {
    /// Memory without a table. A static of it takes no flash.
    #[must_use]
    pub const fn new() -> Self {
        Self { is_set_up: false, table: SizedTable::EMPTY }
    }
}

impl<R: TableScalar, const SEGMENTS: usize> Default for TableMemory<SizedTable<R, SEGMENTS>> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: TableScalar> TableMemory<Table<R>> {
    /// Table, if the last set-up succeeded.
    #[must_use]
    pub fn get(&self) -> Option<&Table<R>> {
        self.is_set_up.then_some(&self.table)
    }
}

impl<R: TableScalar, const SEGMENTS: usize> Deref for TableMemory<SizedTable<R, SEGMENTS>> {
    type Target = TableMemory<Table<R>>;

    fn deref(&self) -> &Self::Target {
        self
    }
}

impl<R: TableScalar, const SEGMENTS: usize> DerefMut for TableMemory<SizedTable<R, SEGMENTS>> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        self
    }
}
