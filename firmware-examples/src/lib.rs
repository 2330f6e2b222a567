//! Code that the programs in `bin/` share.
//!
//! * on a chip: the entry point, log transport and panic handler of the target ([`entry`], [`exit`]), and a table ([`set_up`]);
//! * anywhere: [`toy_top`], a motion, and [`TOY_TOP`], its table; [`bits`], the hashes that a chip and the host must agree on.

#![cfg_attr(target_os = "none", no_std)]

pub mod bits;
mod top;
#[path = "tables/toy_top.rs"]
mod toy_top_table;

pub use top::toy_top;
pub use toy_top_table::TOY_TOP;

#[cfg(target_os = "none")]
mod chip;
#[cfg(target_os = "none")]
pub use chip::{entry, exit, set_up};
#[cfg(target_arch = "arm")]
pub use chip::{run_systick, start_systick};
