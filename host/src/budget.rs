//! Costs of calls on emulated chips.
//!
//! QEMU runs the firmware `cost` and logs the blocks of code that it executes; those between the entry of a call and its return are counted.
//! No clock is used: the same ELF gives the same figures.
//!
//! | module | contents |
//! |---|---|
//! | `chips` | chips with their compilers and emulators |
//! | `trace` | blocks of code that QEMU executes |
//! | `model` | cycles of an instruction, from published timings |
//! | `meter` | cost of each call |
//! | `budgets` | allowed costs, `firmware-examples/budgets.toml` |
//! | `corpus` | set-up of many launches |

pub mod budgets;
pub mod chips;
pub mod corpus;
pub mod meter;
mod model;
mod trace;
