//! Crate for programs in C, `core/c`: its archives, its header, and its examples.

mod archive;
mod examples;
mod header;

pub(crate) use archive::{list, make};
pub(crate) use header::{compile as check_header, overwrite as overwrite_header};

pub(crate) use examples::{cmake as check_cmake, on_chip as check_on_chip, on_host as check_on_host};
