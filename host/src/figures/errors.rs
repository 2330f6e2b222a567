//! The error of the orientation against time: of the core, which does not grow, and of its rivals.

use super::chart::{Chart, Line};
use crate::Failure;
use crate::progress::Progress;
use crate::race::{Entrant, MOMENTS, Race};
use kuva::render::render::Scene;

pub(super) const ENTRANTS: [Entrant; 7] = [
    Entrant::EphemerisF64,
    Entrant::StepperF64(64),
    Entrant::FullSolver(1e-15),
    Entrant::RungeKutta(64),
    Entrant::Exponential(64),
    Entrant::EphemerisF32,
    Entrant::StepperF32(64),
];

/// Periods at which is looked, through one period each.
const PERIODS: [u64; 13] = [1, 2, 4, 8, 16, 32, 64, 128, 256, 400, 512, 800, 1000];

/// Periods, and the greatest error in the period that follows, rad.
pub(crate) fn measured(race: &Race, entrant: Entrant) -> Result<Vec<[f64; 2]>, Failure> {
    let per_period = u64::from(MOMENTS);
    let moments: Vec<u64> = PERIODS.iter().flat_map(|n| (n - 1) * per_period + 1..=n * per_period).collect();
    let (errors, _) = race.errors(entrant, &moments, &race.truth(&moments))?;
    let worst = errors.chunks(MOMENTS as usize).map(|part| part.iter().copied().fold(0.0, f64::max));
    Ok(PERIODS
        .iter()
        .map(|&n| n as f64 * f64::from(MOMENTS) * race.share())
        .zip(worst)
        .map(|(n, error)| [n, error])
        .collect())
}

pub(super) fn picture(progress: &mut Progress) -> Result<Scene, Failure> {
    let race = Race::new()?;
    let mut lines = Vec::new();
    for entrant in ENTRANTS {
        let points = measured(&race, entrant)?;
        lines.push(Line { name: format!("{}, {}", entrant.name(), entrant.effort()), points, marked: true });
        progress.add(1);
    }
    let chart = Chart {
        title: "Error against time: s = A = p = 1, C = 0.6, e = 0.7, 0.9, 1.85",
        labels: ["nutation periods", "error of the orientation, rad"],
        powers: [true; 2],
    };
    Ok(chart.draw(&lines))
}
