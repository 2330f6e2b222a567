//! Input of a launch: a top, and its state.

pub(crate) mod error;

pub(crate) mod top;

pub(crate) mod state;
