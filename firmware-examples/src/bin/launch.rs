//! Set-up on the chip: a motion from measured initial conditions, and the refusal of impossible numbers.

#![no_std]
#![no_main]

use toytop::{Motion, ParameterError, Release, State, Top, TopParameters};
use toytop_firmware::{entry, exit};

/// Measurement of a release, in the units of the sensor.
struct Measured {
    /// Tilt from the vertical, tenths of a degree.
    tilt: u16,
    /// Spin, revolutions in a minute.
    spin: i16,
    /// Rate of precession, mrad/s.
    precession: i16,
}

#[entry]
fn main() -> ! {
    let measured = Measured { tilt: 203, spin: 1432, precession: 850 };
    // No body has more than C = 2A, that of a flat disc: the second C is a typing error for 3.7e-5.
    for axial_inertia in [2.0e-5, 7.3e-5, 3.7e-5] {
        match launch(axial_inertia, &measured) {
            Ok(motion) => log(&motion),
            // The top is refused with the reason, and the program continues.
            Err(error) => defmt::warn!("refused: {}", error),
        }
    }
    exit()
}

fn launch(axial_inertia: f64, measured: &Measured) -> Result<Motion, ParameterError> {
    let top = Top::sliding(&TopParameters { axial_inertia, ..TopParameters::TOY })?;
    let release = Release {
        tilt: (f64::from(measured.tilt) / 10.0).to_radians(),
        spin: f64::from(measured.spin) * (core::f64::consts::TAU / 60.0),
        precession: f64::from(measured.precession) / 1000.0,
        ..Release::default()
    };
    Motion::launch(&top, &State::from_release(&release)?)
}

fn log(motion: &Motion) {
    defmt::info!("{}", motion);
    if let Some(averages) = motion.period_advance() {
        defmt::info!("nutates in {=f64} s, precesses {=f64} rad", averages.period, averages.phi_radians);
    }
    if let Some(force) = motion.min_normal_force() {
        defmt::info!("presses on the plane with {=f64} of its weight or more", force);
    }
}
