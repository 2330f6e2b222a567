//! Program that panics on purpose, which the test command must detect.

#![no_std]
#![no_main]

use core::hint::black_box;

use toytop_firmware::entry;

#[entry]
fn main() -> ! {
    let table = [1, 2, 3];
    let index = black_box(table.len());
    defmt::info!("entry {=usize} of {=usize}", index, table.len());
    defmt::info!("is {=i32}", table[index]);
    toytop_firmware::exit()
}
