//! Hashes of the results of every stage, on a chip or on the host, which must be the same on every machine.

#![cfg_attr(target_os = "none", no_std, no_main)]

use toytop::SetUp;
use toytop_firmware::bits;

#[cfg(target_os = "none")]
#[toytop_firmware::entry]
fn start() -> ! {
    use core::cell::RefCell;
    use critical_section::Mutex;
    // a static, because the stack of the smallest chip is short
    static SET_UP: Mutex<RefCell<SetUp>> = Mutex::new(RefCell::new(SetUp::with_truncation(f64::MAX)));
    critical_section::with(|section| report(&mut SET_UP.borrow_ref_mut(section)));
    toytop_firmware::exit()
}

#[cfg(not(target_os = "none"))]
fn main() {
    report(&mut SetUp::with_truncation(f64::MAX));
}

fn report(set_up: &mut SetUp) {
    bits::of_every_stage(set_up, |motion, stage, hash| {
        #[cfg(target_os = "none")]
        defmt::println!("{=str} {=str} {=u64:016x}", motion, stage, hash);
        #[cfg(not(target_os = "none"))]
        println!("{motion} {stage} {hash:016x}");
    })
    .expect("possible motions");
}
