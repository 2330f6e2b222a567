//! Numbers of the search, the solver and the check, and the reason of each.

/// Number of readings of an orientation or a direction in the first part: enough to average noise, and too few for a phase to slip by a turn.
pub(super) const FIRST_READINGS: usize = 16;
/// Largest number of readings among which these are looked for.
pub(super) const MAX_READINGS: usize = 1024;
/// Length of a part of the measurements over that of the part before. The error of a rate that was found on a part is small enough for one
/// that is four times as long.
pub(super) const PART_FACTOR: usize = 4;
/// Number of guesses of an angle, 30 degrees apart, and of a rate about the axis on each side of 0.
pub(super) const GUESSES: u32 = 12;
/// Angles between the axis and the vertical that are tried, rad.
pub(super) const TILTS: [f64; 5] = [0.25, 0.75, 1.3, 2.0, 2.7];
/// Least rate of a saturated axis over its reading. Bias and mounting may shift the reading, so that it is below 1.
pub(super) const RANGE_FRACTION: f64 = 0.9;
/// Largest difference of the sums of squares of two launches that chance explains. The best of 100 random spins may have a sum 20 below that of
/// the true one; this is twice as much.
pub(super) const CHANCE_COST: f64 = 40.0;
/// Sine of the largest small angle: between the axis of a top that may be upright and the vertical, and between a direction and an
/// undetermined one.
pub(super) const SMALL_ANGLE_SINE: f64 = 0.1;

/// Size of the next correction, in standard deviations, and rise of the sum of squares, that need no further pass. The error of the
/// integration causes such a rise.
pub(super) const CONVERGED: f64 = 0.05;
/// Size of the next correction that needs no further pass over a part of the measurements, in standard deviations. Those of the next part
/// are at most half as large.
pub(super) const PART_CONVERGED: f64 = 0.5;
/// Damping of the first correction, as a part of the information, and least damping after a pass that is no better.
pub(super) const FIRST_DAMPING: f64 = 1e-3;
/// Largest number of passes over one part of the measurements.
pub(super) const MAX_PASSES: u32 = 20;
/// Standard deviation of an unknown that the measurements leave open, in its unit: above 1, and so small that an inverse in `f32` keeps
/// its digits.
pub(super) const OPEN_DEVIATION: f64 = 10.0;

/// Difference that noise does not explain, in standard deviations: a gross error, or the distance of two launches that are not the same.
pub(super) const GROSS_SIGMA: f64 = 10.0;
/// A gross error counts as this number of outliers, so that 5 % of gross errors are as bad as 20 % of outliers.
pub(super) const GROSS_WEIGHT: u32 = 4;
/// One outlier is allowed for every five residuals, and three more, for short blocks.
pub(super) const OUTLIER_PART: u32 = 5;
pub(super) const FEW_OUTLIERS: u32 = 3;
/// Largest excess of a sum of squares that noise explains, in its standard deviations: one in 10⁶ is larger.
pub(super) const MISFIT_SIGMA: f64 = 5.0;
/// Largest sum of squares of the differences from prior values. A fit has at most 16 of them: mean 16, standard deviation 6.
pub(super) const MAX_PRIOR: f64 = 60.0;
/// Least mean square of the residuals, with rates read as degrees, that noise explains: the noise given may be twice too large.
pub(super) const MIN_NOISE: f64 = 0.25;
/// Largest reading of a rate at rest, rad per unit time: a bias explains it.
pub(super) const MAX_RATE_AT_REST: f64 = 0.1;
