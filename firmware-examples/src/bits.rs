//! Hash of the results of every stage of core, over several motions. Equal hashes mean equal results, to the last bit.
//!
//! Core uses neither `std` maths nor a fused multiply-add, so a chip, with or without a floating-point unit, must give
//! what the host gives.

use crate::top::released;
use toytop::fixed::types::{I2F14, I2F30};
use toytop::scalar::Real;
use toytop::{
    BranchPoints, Complex, FirstIntegrals, InitialAngles, Motion, Orientation, ParameterError, PeriodAdvance,
    Release, Sample, Sign, Signs, SizedTable, State, Stepper, TableMemory, TableScalar, TableSettings, Tick,
    Top, TopParameters, Workspace,
};

/// Steps of each motion.
const TICKS: usize = 2000;

/// Calls `report` with the name of a motion, the name of a stage, and the hash of the results of the stage.
///
/// * `workspace`: that of the set-ups, for an error of any size, because the tables are small enough for 16 KiB of RAM
///
/// # Errors
/// None: the motions are valid.
pub fn of_every_stage(
    workspace: &mut Workspace,
    mut report: impl FnMut(&str, &str, u64),
) -> Result<(), ParameterError> {
    // one motion at a time, because the stack of the smallest chip is short
    let motions: [(_, fn() -> _, _); 3] = [
        ("toy_top", toy_top, 1e-3),
        ("near_separatrix", near_separatrix, 0.01),
        ("lagrange", lagrange, 0.02),
    ];
    for (name, motion, dt) in motions {
        let motion: Motion = motion()?;
        report(name, "first_integrals", Hash::default().integrals(&motion.first_integrals()).0);
        report(name, "branch_points", Hash::default().branch_points(&motion.branch_points()).0);
        report(name, "averages", Hash::default().averages(motion.period_advance()).0);
        let least_force =
            motion.min_normal_force().map_or(Hash::default(), |force| Hash::default().number(force));
        report(name, "normal_force", least_force.0);
        let [orientation, tip, omega] = ticks::<f32>(&motion, dt);
        report(name, "stepper_f32_phi", orientation.0);
        report(name, "stepper_f32_tip", tip.0);
        report(name, "stepper_f32_omega", omega.0);
        let [orientation, tip, omega] = ticks::<f64>(&motion, dt);
        report(name, "stepper_f64_phi", orientation.0);
        report(name, "stepper_f64_tip", tip.0);
        report(name, "stepper_f64_omega", omega.0);
        for (names, hashes) in [
            (["table_f32", "cursor_f32"], table::<f32, 25>(workspace, &motion)),
            (["table_f64", "cursor_f64"], table::<f64, 8>(workspace, &motion)),
            (["table_q31", "cursor_q31"], table::<I2F30, 32>(workspace, &motion)),
            (["table_q15", "cursor_q15"], table::<I2F14, 16>(workspace, &motion)),
        ] {
            names.into_iter().zip(hashes).for_each(|(stage, hash)| report(name, stage, hash.0));
        }
    }
    Ok(())
}

/// Motion of a toy top in SI units, with all six numbers of a release.
fn toy_top() -> Result<Motion, ParameterError> {
    released(&Release { tilt: 0.35, azimuth: 0.4, roll: -2.0, spin: 150.0, precession: 3.0, nutation: -1.5 })
}

/// Motion with e₃ - e₂ = 1e-3, falling, with loops, C > A; from branch points, in the paper's units.
fn near_separatrix() -> Result<Motion, ParameterError> {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 1.0,
        axial_inertia: 1.5,
        com_height: 1.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })?;
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
    let start = InitialAngles { theta: -2.0, arg_alpha: 0.3, arg_beta: 2.5 };
    Motion::from_branch_points(&top, [-0.5, 0.9995, 1.0005], signs, &start)
}

/// Motion with a held tip, whose axis passes the vertical at a small distance; from α, β and ω.
fn lagrange() -> Result<Motion, ParameterError> {
    let top = Top::fixed(&TopParameters {
        transverse_inertia: 1.0,
        axial_inertia: 0.7,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })?;
    let phi = Orientation { alpha: Complex::new(0.6, 0.0), beta: Complex::new(0.0, 0.8) };
    Motion::launch(&top, &State::new(phi, [0.1, -1.3, 0.9])?)
}

/// Hashes of Φ, tip and ω at every step; dt changes from step to step, also in sign.
fn ticks<R: Real + Into<f64>>(motion: &Motion, dt: f64) -> [Hash; 3] {
    let mut stepper = Stepper::<R>::new(motion);
    let mut hashes = [Hash::default(); 3];
    for factor in [1.0, 0.5, -0.25, 2.0].into_iter().cycle().take(TICKS) {
        stepper.step(R::from_f64(dt * factor));
        let Orientation { alpha, beta } = stepper.orientation();
        let [orientation, tip, omega] = hashes;
        let tip = tip.complex(stepper.tip()).complex(stepper.tip_velocity());
        hashes = [
            orientation.complex(alpha).complex(beta),
            stepper
                .tip_angle()
                .map_or(tip, |angle| tip.number(angle.to_turns()).number(stepper.tip_angle_rate())),
            omega.numbers(stepper.attitude_state().omega()),
        ];
    }
    hashes
}

/// Hashes of orientation, tip and ω of samples at distant ticks, and of orientation and tip at consecutive ticks.
#[inline(never)] // one table at a time, too
fn table<R: TableScalar<Quantity: Into<f64>> + Into<f64>, const SEGMENTS: usize>(
    workspace: &mut Workspace,
    motion: &Motion,
) -> [Hash; 2] {
    let mut hashes = [Hash::default(); 2];
    let mut memory = TableMemory::<SizedTable<R, SEGMENTS>>::new();
    let Ok(tick) = Tick::hertz(1000) else { return hashes };
    let settings = TableSettings { truncation: Some(f64::MAX), ..TableSettings::new(tick) };
    let Ok(table) = memory.set_up(workspace, motion, settings, &mut || {}) else { return hashes };
    let with_sample = |hash: Hash, sample: Sample<'_, R>| {
        let Orientation { alpha, beta } = sample.orientation();
        hash.complex(alpha).complex(beta).number(sample.u()).complex(sample.tip())
    };
    let mut cursor = table.cursor(-3);
    for n in (-7_i64..).take(TICKS) {
        let [any, next] = hashes;
        // from years before the launch to years after it
        let apart = table.at_tick(n << 33);
        hashes = [with_sample(any, apart).numbers(apart.omega()), with_sample(next, cursor.next(table))];
    }
    hashes
}

/// Hash FNV-1a of 64 bits.
#[derive(Clone, Copy)]
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    fn number(self, number: impl Into<f64>) -> Self {
        let bytes = number.into().to_bits().to_le_bytes();
        Self(bytes.iter().fold(self.0, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)))
    }

    fn complex<R: Into<f64>>(self, z: Complex<R>) -> Self {
        self.numbers([z.re, z.im])
    }

    fn numbers(self, numbers: impl IntoIterator<Item: Into<f64>>) -> Self {
        numbers.into_iter().fold(self, Self::number)
    }

    fn integrals(self, integrals: &FirstIntegrals) -> Self {
        let FirstIntegrals { l, n, h, l_plus_n, l_minus_n, .. } = *integrals;
        self.numbers([l, n, h, l_plus_n, l_minus_n])
    }

    fn branch_points(self, e: &BranchPoints) -> Self {
        let BranchPoints {
            e1,
            e2,
            e3,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            e3_minus_one,
            ..
        } = *e;
        self.numbers([e1, e2, e3, one_plus_e1, one_minus_e2, e2_minus_e1, e3_minus_e2, e3_minus_one])
    }

    fn averages(self, averages: Option<PeriodAdvance>) -> Self {
        averages.map_or(self, |averages| {
            let PeriodAdvance { period, alpha_turns, beta_turns, .. } = averages;
            self.numbers([period, alpha_turns, beta_turns])
        })
    }
}
