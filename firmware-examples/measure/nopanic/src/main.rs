//! Program that links only if core's set-up, stepper, table, fit and closed forms have no panic path, because its panic handler calls a function that
//! does not exist. It is linked in release, without overflow checks, and not run.

#![no_std]
#![no_main]

use core::hint::black_box;

use panic_never as _;
use toytop::fixed::types::{I2F14, I2F30};
use toytop::scalar::Real;
use toytop::su2::Orientation;
use toytop::{
    BranchPoints, Complex, FirstIntegrals, InitialAngles, Level, Motion, ParameterError, Phase, PointImpulse,
    Release, Sign, Signs, SizedTable, State, Stepper, Table, TableMemory, TableScalar, TableSettings, Tick,
    Top, TopParameters, Workspace,
};
use toytop_closed_forms::ClosedForm;
use toytop_closed_forms::elliptic::{Jacobi, Weierstrass, agm, carlson_rf};
use toytop_fit::{
    Accelerometer, AxisCamera, Fit, FreeRatio, Gyroscope, Magnetometer, Mark, Measurement, Mounting, Noise,
    OrientationCamera, Sensitivity, Sensor, TipCamera,
};

#[cfg(target_arch = "arm")]
use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv_rt::entry;

#[entry]
fn main() -> ! {
    loop {
        // an error is a value
        let _ = black_box(set_up());
        let _ = black_box(elliptic());
    }
}

/// Number that is unknown to the compiler.
fn unknown() -> f64 {
    black_box(0.0)
}

fn complex() -> Complex<f64> {
    Complex::new(unknown(), unknown())
}

fn set_up() -> Result<(), ParameterError> {
    for top in tops() {
        let top = top?;
        black_box((
            top.support(),
            top.transverse_inertia(),
            top.axial_inertia(),
            top.com_height(),
            top.mass_moment(),
            top.gravity(),
            top.e4(),
            top.tip_scale(),
        ));
        for state in [
            State::new(Orientation { alpha: complex(), beta: complex() }, [unknown(); 3]),
            State::from_quaternion_and_gyro([unknown(); 4], [unknown(); 3]),
            State::from_release(&release()),
        ] {
            let state = state?;
            let impulse = PointImpulse { impulse: [unknown(); 3], point: [unknown(); 3] };
            black_box(state.reaction_impulse(&top, &impulse)?);
            let state = state.with_impulse(&top, &impulse)?;
            black_box((state.orientation(), state.omega()));
            black_box(FirstIntegrals::from_state(&top, &state).signs());
            spin(&Motion::launch(&top, &state)?);
            sensitivity(&Motion::launch(&top, &state)?);
        }
        fit(&top);
        let sign = |x| Sign::new(x);
        let signs = Signs { l_plus_n: sign(unknown()), l_minus_n: sign(unknown()) };
        black_box(BranchPoints::from_integrals(&top, unknown(), unknown(), unknown())?);
        let start = InitialAngles { theta: unknown(), arg_alpha: unknown(), arg_beta: unknown() };
        let motion = Motion::from_branch_points(&top, [unknown(); 3], signs, &start)?;
        black_box(motion.branch_points().integrals(&top, signs));
        spin(&motion);
    }
    Ok(())
}

fn tops() -> [Result<Top, ParameterError>; 5] {
    let parameters = || TopParameters {
        transverse_inertia: unknown(),
        axial_inertia: unknown(),
        com_height: unknown(),
        mass: unknown(),
        mass_moment: unknown(),
        gravity: unknown(),
        rotor_momentum: unknown(),
    };
    let by_mass = TopParameters { mass_moment: 0.0, ..parameters() };
    let by_moment = TopParameters { mass: 0.0, ..parameters() };
    [
        Top::sliding(&by_mass),
        Top::sliding(&by_moment),
        Top::fixed(&by_mass),
        Top::fixed(&by_moment),
        Top::free(&by_mass),
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
    black_box(motion.period_advance().map(|averages| averages.phi_radians));
    black_box(motion.min_normal_force());
    if let Ok(form) = ClosedForm::from_motion(motion) {
        black_box((form.at(unknown()), form.nutation_phase(unknown())));
    }
    tick::<f32>(motion);
    tick::<f64>(motion);
    table::<f32, 25>(motion);
    table::<f64, 32>(motion);
    table::<I2F30, 32>(motion);
    table::<I2F14, 16>(motion);
}

/// Calls of the elliptic functions.
fn elliptic() -> Result<(), ParameterError> {
    let jacobi = Jacobi::new(unknown(), unknown())?;
    black_box((jacobi.quarter_period(), jacobi.at(unknown())));
    black_box((agm(unknown(), unknown()), carlson_rf(unknown(), unknown(), unknown())));
    let lattice = Weierstrass::from_roots([unknown(); 3])?;
    black_box((lattice.half_periods(), lattice.quasi_periods(), lattice.invariants()));
    let z = complex();
    black_box((lattice.p(z), lattice.p_prime(z), lattice.differences(z), lattice.zeta(z)));
    black_box((lattice.sigma(z), lattice.ln_sigma(z)));
    Ok(())
}

fn sensitivity(motion: &Motion) {
    let sensitivity = Sensitivity::new(motion);
    let Some(partials) = sensitivity.at(unknown()) else { return };
    black_box((partials.d_orientation(), partials.d_omega(), partials.d_omega_body(), partials.d_tip()));
    black_box((partials.d_tip_angle(), partials.d_axis(), partials.orientation()));
}

/// Calls of a fit without an initial guess, and of the fit of a second block.
fn fit(top: &Top) {
    let noise = Noise { deviation: unknown(), bias_deviation: unknown() };
    let mounting = Mounting { place: [unknown(); 3], ..Mounting::default() };
    let gyroscope = Gyroscope { noise, mounting, range: unknown() };
    let accelerometer = Accelerometer { noise, mounting, range: unknown() };
    let magnetometer = Magnetometer { noise, mounting, field: [unknown(); 3] };
    let mark = Mark { deviation: unknown(), place: [unknown(); 3] };
    let (orientation, axis) =
        (OrientationCamera { deviation: unknown() }, AxisCamera { deviation: unknown() });
    let tip = TipCamera { deviation: unknown() };
    let sensors: [[&dyn Sensor; 4]; 2] =
        [[&gyroscope, &accelerometer, &magnetometer, &mark], [&orientation, &axis, &tip, &mark]];
    for set in &sensors {
        let Ok(mut fit) = Fit::new(top, set, &[FreeRatio::AXIAL_INERTIA]) else { continue };
        let measurement =
            |n: usize| Measurement { time: unknown(), sensor: black_box(n & 3), values: [unknown(); 4] };
        let Ok(fitted) = fit.run((0..black_box(60_usize)).map(measurement)) else { continue };
        black_box(fitted.motion().is_ok());
        black_box(fit.track(&fitted, unknown(), (0..black_box(60_usize)).map(measurement)).is_ok());
    }
}

fn tick<R: Real>(motion: &Motion) {
    let mut stepper = Stepper::<R>::new(motion);
    stepper.step(R::from_f64(unknown()));
    let attitude = stepper.attitude_state();
    let phi = stepper.orientation();
    black_box((phi.u(), phi.axis(), phi.quaternion()));
    black_box((attitude.udot(), attitude.omega(), attitude.omega_body()));
    black_box(State::from_attitude(&attitude).is_ok());
    black_box((stepper.tip(), stepper.tip_velocity(), stepper.tip_angle_rate()));
    black_box(stepper.tip_angle().map(|angle| (angle.to_turns(), angle.to_radians(), angle.principal())));
}

/// Calls of the events of every kind.
fn events<R: TableScalar>(table: &Table<R>, motion: &Motion) {
    let event = table.turning_points(black_box(3)).find(|event| event.upward);
    black_box(event.map(|event| (table.time_of(&event), table.at_event(&event).orientation())));
    black_box(table.tip_angles(Phase::from_turns(unknown()), black_box(3)).next());
    let circle = Level::from_circle(motion.top(), unknown()).ok().map(|[upper, _]| upper);
    let levels =
        [Level::from_u(unknown()).ok(), Level::from_tilt(unknown()).ok(), circle, Level::lift_off(motion)];
    for level in levels.into_iter().flatten() {
        black_box((table.crossings(level, black_box(3)).next(), level.u()));
    }
}

/// Calls of a table: set-up, and all ways to read it.
fn table<R: TableScalar, const SEGMENTS: usize>(motion: &Motion) {
    let Ok(tick) = Tick::hertz(black_box(1000)) else { return };
    let Ok(table) =
        SizedTable::<R, SEGMENTS>::new(motion, TableSettings { truncation: Some(unknown()), ..tick.into() })
    else {
        return;
    };
    black_box(table.at_tick(black_box(7)).orientation());
    let sample = table.at(unknown());
    black_box((sample.tip_over_s(), sample.u(), sample.axis(), sample.quaternion(), sample.tip()));
    black_box((sample.omega(), sample.omega_body(), sample.udot(), sample.tip_velocity()));
    black_box(table.rate_error_bound_at(black_box(3)));
    black_box((sample.tip_angle(), sample.nutation_phase()));
    black_box(sample.state().is_ok());
    let mut cursor = table.cursor(black_box(3));
    black_box((cursor.next(&table).orientation(), cursor.tick()));
    events(&table, motion);
    black_box((table.error_bound_at(black_box(3)), table.capacity()));
    let mut workspace = Workspace::new();
    let settings = TableSettings { tick, epoch: black_box(-7), truncation: Some(unknown()) };
    let mut memory = TableMemory::<SizedTable<R, SEGMENTS>>::new();
    let mut calls = 0;
    let is_ready = memory.set_up(&mut workspace, motion, settings, &mut || calls += 1).is_ok();
    black_box((is_ready, memory.get().map(|table| (cursor.next(table).orientation(), table.error_bound()))));
}
