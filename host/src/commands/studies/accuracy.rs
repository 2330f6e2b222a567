//! `toytop accuracy`: error of each scalar at ticks 1 to 2^40, against the truth to thirty digits, and its cost.
//!
//! The motions are the built-in ones that nutate and whose tip slides, launched at u = e₁ from numbers that are taken as exact. The number
//! of ticks in a unit of time is a power of two, with at least a thousand ticks in a period and one in a radian, so that tick 2^40 comes
//! after some 10^9 periods.

use super::Report;
use super::budget::{CHIPS, Chip, Limits, Model};
use super::options::{PICTURE, ScalarChoice, ending_in};
use crate::Failure;
use crate::input::builtin;
use crate::input::random::Random;
use crate::motion::ephemeris::{AnyEphemeris, smallest_ephemeris, ticks_per_time};
use crate::motion::{Scalar, first_integrals, greater, natural_scales};
use crate::output::doc_markers::{self, Page};
use crate::output::progress::Progress;
use crate::output::{self, Column, Format, Record};
use crate::pictures::chart::{Chart, Curve};
use crate::pictures::drawing;
use crate::thread_pool;
use crate::truth::exact::{Exact, PreciseOrientation};
use crate::truth::motions::{Numbers, Start};
use crate::truth::precise::{precise, whole};
use clap::Args;
use kuva::render::render::Scene;
use micromath::F32Ext;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::path::PathBuf;
use toytop::{InitialPhases, Motion, Regime, Support};

/// `toytop accuracy`
#[derive(Args)]
pub struct AccuracyArgs {
    /// Scalar types
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    scalar: Vec<ScalarChoice>,
    /// Picture of error against cost, whose name ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot: Option<PathBuf>,
    /// Markdown page whose table is rewritten
    #[arg(long, value_name = "FILE")]
    accept: Option<PathBuf>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &AccuracyArgs) -> Result<Report, Failure> {
    let page = arguments.accept.as_deref().map(|path| Page::read(path, "toytop accuracy: scalars"));
    let page = page.transpose()?;
    let limits = Limits::built_in()?;
    let all = measured(&ScalarChoice::chosen(&arguments.scalar))?;
    let scalars: Vec<_> = all.iter().map(|one| record(one.scalar, &one.all(), &limits)).collect();
    let micromath =
        format!("The sine of micromath, an approximation for f32, is off by up to {:.0e}.\n", micromath());
    let table = || {
        format!(
            "{}\nThe ephemeris in each scalar, over ticks from 1 to 2^{OCTAVES}, against the truth to thirty digits. RMS: root of the\n\
             mean square. Tip: in units of s. Norm: of alpha and beta. Energy: from alpha, beta and their rates (in fixed point, f32),\n\
             relative. Cost of the next tick, at most, from firmware-examples/budgets.toml; cycles are modelled. CSV and JSON have the\n\
             errors over each octave of ticks. {micromath}",
            output::aligned(&scalars, &columns(output::two_digits)),
        )
    };
    let octaves: Vec<_> = all.iter().flat_map(|one| of_octaves(one, &limits)).collect();
    let text = output::render(arguments.format, &output::list("rows", &octaves), table)?;
    if let Some(path) = &arguments.plot {
        drawing::write("--plot", path, &picture(&all, &limits), None)?;
    }
    if let Some(page) = page {
        let rows = output::rows(&scalars, &columns(|x| format!("{x:.0e}")));
        page.write(&format!("{}\n{micromath}", doc_markers::table(&rows)))?;
    }
    Ok(text.into())
}

/// Columns of a scalar and its errors, then of its costs on the chips, each with its heading.
const COLUMNS: [(&str, &str); 11] = [
    ("scalar", ""),
    ("max_orientation_error_rad", "greatest error, rad"),
    ("rms_orientation_error_rad", "RMS error, rad"),
    ("max_tip_error_per_s", "tip, s"),
    ("max_norm_defect", "norm"),
    ("max_energy_defect", "energy"),
    ("m0plus_cycles", "M0+ cycles"),
    ("m4f_cycles", "M4F cycles"),
    ("m7_instructions", "M7 instr."),
    ("m33_instructions", "M33 instr."),
    ("riscv_instructions", "RISC-V instr."),
];

fn columns(of_number: fn(f64) -> String) -> [Column<'static>; 11] {
    COLUMNS.map(|(name, heading)| (name, heading, of_number))
}

fn record(scalar: Scalar, errors: &Errors, limits: &Limits) -> Record {
    let [angle, tip, norm, energy] = errors.greatest;
    let record = Record::default().with("scalar", scalar.name());
    let errors = [angle, errors.rms(), tip, norm, energy];
    let record =
        COLUMNS[1..].iter().zip(errors).fold(record, |record, ((name, _), error)| record.with(name, error));
    let costs = COLUMNS[6..].iter().zip(&CHIPS);
    costs.fold(record, |record, ((name, _), chip)| record.with(name, limits.next_tick(scalar.name(), chip)))
}

fn of_octaves(accuracy: &Accuracy, limits: &Limits) -> Vec<Record> {
    let record = |(octave, errors): (usize, &Errors)| {
        let first = 1_u64 << octave;
        let last = if octave < OCTAVES { 2 * first - 1 } else { first };
        record(accuracy.scalar, errors, limits).with("first_tick", first).with("last_tick", last)
    };
    accuracy.octaves.iter().enumerate().map(record).collect()
}

/// Greatest error of micromath's sine over one turn.
fn micromath() -> f64 {
    let error = |x: f32| (f64::from(F32Ext::sin(x)) - f64::from(x).sin()).abs();
    (0..=u16::MAX).map(|i| error(1e-4 * f32::from(i))).fold(0.0, f64::max)
}

/// Picture of error against cost: a curve for each chip, with a mark for each scalar.
fn picture(all: &[Accuracy], limits: &Limits) -> Scene {
    let angle = |accuracy: &Accuracy| accuracy.all().greatest[0];
    let curve = |chip: &Chip| {
        let point = |accuracy: &Accuracy| {
            Some([limits.next_tick(accuracy.scalar.name(), chip)? as f64, angle(accuracy)])
        };
        let unit = if Model::of(chip).is_some() { "cycles" } else { "instructions" };
        let points = all.iter().filter_map(point).collect();
        Curve::dots(format!("{}, {unit}", chip.core), points)
    };
    let name = |accuracy: &Accuracy| format!("{} {:.0e}", accuracy.scalar.name(), angle(accuracy));
    let names: Vec<_> = all.iter().map(name).collect();
    let chart = Chart {
        title: "What an orientation costs, and how exact it is",
        labels: [
            "cost of the next tick: modelled cycles, or instructions executed",
            &format!("greatest error over ticks 1 to 2⁴⁰, rad: {}", names.join(", ")),
        ],
        powers: [true; 2],
    };
    chart.draw(&CHIPS.iter().map(curve).collect::<Vec<_>>())
}

/// Binary logarithm of the last tick.
const OCTAVES: usize = 40;

/// Number of ticks in each octave that are evaluated for each motion.
const SAMPLES: u64 = 16;

/// Errors over many ticks.
#[derive(Clone, Copy, Default)]
struct Errors {
    /// Greatest errors: of the orientation, 2 √(|Δα|² + |Δβ|²), rad; of the tip, |Δc|/s; of the norm |α|² + |β|²; of h as computed from α,
    /// β and their rates, in units of its natural scale.
    greatest: [f64; 4],
    /// Sum of the squares of the orientation errors, rad², and their number.
    squares: (f64, u64),
}

impl Errors {
    /// Root of the mean square of the orientation errors, rad.
    fn rms(&self) -> f64 {
        let (sum, count) = self.squares;
        (sum / count.max(1) as f64).sqrt()
    }

    fn merged(self, other: Self) -> Self {
        let ((sum, count), (more, others)) = (self.squares, other.squares);
        Self {
            greatest: std::array::from_fn(|i| greater(self.greatest[i], other.greatest[i])),
            squares: (sum + more, count + others),
        }
    }
}

/// Errors of one scalar over the ticks from 2^k to 2^(k+1) - 1 for each k below `OCTAVES`, and at tick 2^40.
struct Accuracy {
    scalar: Scalar,
    octaves: Vec<Errors>,
}

impl Accuracy {
    /// Errors over all ticks.
    fn all(&self) -> Errors {
        self.octaves.iter().copied().fold(Errors::default(), Errors::merged)
    }
}

/// Errors of each of the scalars over all motions.
fn measured(scalars: &[Scalar]) -> Result<Vec<Accuracy>, Failure> {
    let motions: Vec<_> =
        builtin::scenarios().iter().filter_map(|scenario| numbers(&scenario.motion)).collect();
    let progress = Progress::new(motions.len() as u64, "motions");
    let errors = |numbers: &Numbers| of_motion(numbers, scalars).inspect(|_| progress.add(1));
    // in the order of the motions, so that sums do not depend on the order in which threads finish
    let found: Vec<_> = thread_pool::of_all_cores()?
        .install(|| motions.par_iter().map(errors).collect::<Result<_, Failure>>())?;
    let together = |(index, &scalar): (usize, &Scalar)| {
        let mut octaves = vec![Errors::default(); OCTAVES + 1];
        for motion in &found {
            octaves.iter_mut().zip(&motion[index]).for_each(|(sum, errors)| *sum = sum.merged(*errors));
        }
        Accuracy { scalar, octaves }
    };
    Ok(scalars.iter().enumerate().map(together).collect())
}

/// Numbers of a motion, if [`Exact`] can compute it.
fn numbers(motion: &Motion) -> Option<Numbers> {
    let (top, e) = (motion.top(), motion.branch_points());
    let known = motion.regime() == Regime::Nutating && top.support() == Support::Sliding;
    let (a, c) = (top.transverse_inertia(), top.axial_inertia());
    let phases = InitialPhases::default();
    known.then(|| Numbers {
        top: [a, c, top.com_height(), top.mass_moment(), top.gravity(), 0.0],
        start: Start::BranchPoints { e: [e.e1, e.e2, e.e3], signs: motion.signs(), phases },
    })
}

/// Errors of each scalar on a motion, by octave.
fn of_motion(numbers: &Numbers, scalars: &[Scalar]) -> Result<Vec<Vec<Errors>>, Failure> {
    let motion = numbers.motion().map_err(|error| Failure::Input(format!("{numbers:?}: {error}")))?;
    let tables =
        scalars.iter().map(|&scalar| smallest_ephemeris(scalar, &motion)).collect::<Result<Vec<_>, _>>()?;
    let truth = Exact::new(numbers);
    let rate = ticks_per_time(&motion);
    let mut random = Random::new(1, 0);
    let mut found = vec![vec![Errors::default(); OCTAVES + 1]; scalars.len()];
    for octave in 0..=OCTAVES {
        let first = 1_u64 << octave;
        for _ in 0..SAMPLES.min(first) {
            let more = if octave < OCTAVES { random.uniform() * first as f64 } else { 0.0 };
            let n = (first + more as u64) as i64;
            let phi = truth.at(&(whole(n) / precise(rate)));
            for (table, octaves) in tables.iter().zip(&mut found) {
                // this quotient is exact, because the rate is a power of two
                let errors = errors(&motion, &**table, (n, n as f64 / rate), &phi);
                octaves[octave] = octaves[octave].merged(errors);
            }
        }
    }
    Ok(found)
}

/// Errors at a tick and its time.
fn errors(
    motion: &Motion,
    table: &dyn AnyEphemeris,
    (n, t): (i64, f64),
    truth: &PreciseOrientation,
) -> Errors {
    let found = table.at_tick(n, t);
    let orientation = found.sample.orientation();
    let angle = truth.distance(&orientation);
    let truth = truth.to_f64();
    let tip = found.tip_over_s - (truth.alpha * truth.beta).scaled(2.0);
    let norm = (orientation.norm_squared() - 1.0).abs();
    let greatest = [angle, tip.norm_squared().sqrt(), norm, energy(motion, table, t)];
    Errors { greatest, squares: (angle * angle, 1) }
}

fn energy(motion: &Motion, table: &dyn AnyEphemeris, t: f64) -> f64 {
    let instant = table.at(t);
    let phi = instant.sample.orientation();
    let [.., h] = first_integrals(motion.top(), &phi, instant.rate.omega_fixed(&phi));
    let [.., scale] = natural_scales(motion);
    (h - motion.first_integrals().h).abs() / scale
}
