//! Links only if no panic path is left in core's set-up and stepper: the panic handler calls a function that does not
//! exist. Linked in release, where overflow checks are off; never run.

#![no_std]
#![no_main]

use core::hint::black_box;

use panic_never as _;
use toytop::fixed::types::{I2F14, I2F30};
use toytop::real::Real;
use toytop::su2::Phi;
use toytop::{
    BranchPoints, Complex, FirstIntegrals, Heaviness, LaunchError, Motion, Release, Sign, Signs, Start,
    State, Stepper, Top,
};

#[cfg(target_arch = "arm")]
use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv_rt::entry;

#[entry]
fn main() -> ! {
    loop {
        // An error is a value here, like any other.
        let _ = black_box(set_up());
        #[cfg(feature = "planted")]
        black_box(planted());
    }
}

/// A number that the compiler knows nothing of.
fn unknown() -> f64 {
    black_box(0.0)
}

fn complex() -> Complex<f64> {
    Complex::new(unknown(), unknown())
}

fn set_up() -> Result<(), LaunchError> {
    for top in tops() {
        let top = top?;
        black_box((top.support(), top.a(), top.c(), top.s(), top.p(), top.g(), top.e4(), top.tip_scale()));
        for state in [
            State::new(Phi { alpha: complex(), beta: complex() }, [unknown(); 3]),
            State::release(&release()),
        ] {
            let state = state?;
            black_box((state.phi(), state.omega()));
            black_box(FirstIntegrals::of(&top, &state).signs());
            black_box(BranchPoints::of(&top, &state)?);
            spin(&Motion::launch(&top, &state)?);
        }
        let sign = |x| Sign::of(x);
        let signs = Signs { l_plus_n: sign(unknown()), l_minus_n: sign(unknown()) };
        let e = BranchPoints::new(unknown(), unknown(), unknown())?;
        black_box(e.integrals(&top, signs));
        black_box(BranchPoints::from_integrals(&top, unknown(), unknown(), unknown())?);
        let start = Start { theta: unknown(), arg_alpha: unknown(), arg_beta: unknown() };
        spin(&Motion::from_branch_points(&top, [unknown(); 3], signs, &start)?);
    }
    Ok(())
}

fn tops() -> [Result<Top, LaunchError>; 4] {
    let sliding = |heaviness| Top::sliding(unknown(), unknown(), unknown(), heaviness, unknown());
    [
        sliding(Heaviness::Mass(unknown())),
        sliding(Heaviness::MassMoment(unknown())),
        Top::fixed(unknown(), unknown(), unknown(), unknown()),
        Top::fixed_with_mass(unknown(), unknown(), unknown(), unknown(), unknown()),
    ]
}

fn release() -> Release {
    Release {
        tilt: unknown(),
        azimuth: unknown(),
        roll: unknown(),
        spin: unknown(),
        precession: unknown(),
        nutation: unknown(),
    }
}

fn spin(motion: &Motion) {
    black_box((motion.top(), motion.regime(), motion.tip_class(), motion.signs()));
    black_box((motion.first_integrals(), motion.branch_points()));
    black_box(motion.averages().map(|averages| averages.phi_per_period()));
    black_box(motion.min_normal_force());
    tick::<f32>(motion);
    tick::<f64>(motion);
    table::<f32, 25, 5>(motion);
    table::<f64, 32, 11>(motion);
    table::<I2F30, 32, 4>(motion);
    table::<I2F14, 16, 3>(motion);
    fixed_tick(motion);
}

fn tick<R: Real>(motion: &Motion) {
    let mut stepper = Stepper::<R>::new(motion);
    stepper.step(R::from_f64(unknown()));
    let (phi, pose, tip) = (stepper.phi(), stepper.pose(), stepper.tip());
    black_box((phi.axis(), pose.u(), pose.udot(), pose.omega(), pose.omega_body()));
    black_box((tip.c, tip.rho(), tip.velocity, tip.speed()));
    black_box(
        tip.angle
            .map(|angle| (angle.phi.to_f64(), angle.phi.to_radians(), angle.phi.principal(), angle.rate)),
    );
}

/// The stepper in fixed point: set-up, both ways, and all that is read off.
fn fixed_tick(motion: &Motion) {
    use toytop::{FixedStepper, Tick};
    let Ok(tick) = Tick::hertz(black_box(1000)) else { return };
    let Ok(mut stepper) = <FixedStepper>::new(motion, tick) else { return };
    stepper.step();
    black_box((stepper.phi(), stepper.u(), stepper.tip(), stepper.tip_angle()));
    stepper.step_back();
    black_box((stepper.phi(), stepper.error_bound()));
}

#[cfg(feature = "planted")]
fn planted() -> u8 {
    let table = [1, 2, 3];
    table[black_box(3)]
}

/// An ephemeris: set-up, every way to read it, and its turning points.
fn table<R: toytop::Tabular, const S: usize, const T: usize>(motion: &Motion) {
    use toytop::{Ephemeris, Tick};
    let Ok(tick) = Tick::hertz(black_box(1000)) else { return };
    let Ok(e) = Ephemeris::<R, S, T>::within(motion, tick, unknown()) else { return };
    black_box(e.at_tick(black_box(7)).phi());
    black_box((e.at(unknown()).phi(), e.at(unknown()).pose(), e.at(unknown()).phi_and_tip()));
    black_box((e.at(unknown()).wide_phi(), e.at(unknown()).wide_tip(), e.at(unknown()).phi().u()));
    let mut c = e.cursor(black_box(3));
    black_box(c.next().phi());
    black_box(e.next_turning_point(black_box(3)));
    black_box(e.error_bound());
    let mut out = [Phi::<R>::IDENTITY; 4];
    e.fill(black_box(0), &mut out);
    black_box(out);
}
