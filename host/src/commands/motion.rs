//! Commands on one motion: its states, constants, events and tables.

pub mod bake;
pub mod constants;
pub mod events;
pub mod state;
