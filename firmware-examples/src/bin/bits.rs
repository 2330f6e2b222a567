//! Hashes of the results of every stage, on a chip or on the host, which must be the same on every machine.

#![cfg_attr(target_os = "none", no_std, no_main)]

use toytop_firmware::bits;

#[cfg(target_os = "none")]
#[toytop_firmware::entry]
fn start() -> ! {
    main();
    toytop_firmware::exit()
}

fn main() {
    bits::of_every_stage(|motion, stage, hash| {
        #[cfg(target_os = "none")]
        defmt::println!("{=str} {=str} {=u64:016x}", motion, stage, hash);
        #[cfg(not(target_os = "none"))]
        println!("{motion} {stage} {hash:016x}");
    })
    .expect("possible motions");
}
