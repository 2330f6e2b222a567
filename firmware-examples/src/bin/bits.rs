//! Hashes of the results of every stage, on a chip or on the host, which must be the same on every machine.

#![cfg_attr(target_os = "none", no_std, no_main)]

use toytop::Workspace;
use toytop_firmware::bits;

#[cfg(target_os = "none")]
#[toytop_firmware::entry]
fn start() -> ! {
    use core::cell::RefCell;
    use critical_section::Mutex;
    // a static, because the stack of the smallest chip is short
    static WORKSPACE: Mutex<RefCell<Workspace>> = Mutex::new(RefCell::new(Workspace::new()));
    critical_section::with(|section| report(&mut WORKSPACE.borrow_ref_mut(section)));
    toytop_firmware::exit()
}

#[cfg(not(target_os = "none"))]
fn main() {
    report(&mut Workspace::new());
}

fn report(workspace: &mut Workspace) {
    bits::of_every_stage(workspace, |motion, stage, hash| {
        #[cfg(target_os = "none")]
        defmt::println!("{=str} {=str} {=u64:016x}", motion, stage, hash);
        #[cfg(not(target_os = "none"))]
        println!("{motion} {stage} {hash:016x}");
    })
    .expect("possible motions");
}
