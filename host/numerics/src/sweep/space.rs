//! Motions of a sweep of the paper's constants, by their index.

use super::Axis;
use crate::Failure;
use crate::input::random::Random;
use std::fmt;
use toytop::{Motion, ParameterError, Sign, Signs, Start, Top, TopParameters};

/// Signs of l + n and l - n. The two other pairs are mirror images.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SignChoice {
    /// l + n > 0, l - n > 0
    Same,
    /// l + n > 0 > l - n
    Different,
    /// Both
    Both,
}

/// Axes, signs and sample that determine all motions of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Space {
    /// e₁, e₂, e₃, A/(ps) and C/A.
    pub axes: [Axis; 5],
    /// Signs of l + n and l - n.
    pub signs: SignChoice,
    /// Number of motions to draw, and the seed; `None` for the grid of all combinations.
    pub sample: Option<(u64, u64)>,
}

/// Numbers of one motion of a sweep, in units with p = s = g = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Branch points.
    pub e: [f64; 3],
    /// A/(ps).
    pub a: f64,
    /// C/A.
    pub c_over_a: f64,
    /// Signs of l + n and l - n.
    pub signs: Signs,
}

/// Options in the order of the axes, each with the allowed range of its numbers.
const LIMITS: [(&str, [f64; 2]); 5] = [
    ("--e1", [-1.0, 1.0]),
    ("--e2", [-1.0, 1.0]),
    ("--e3", [1.0, 1e14]),
    ("--a-over-ps", [1e-6, 1e12]),
    ("--c-over-a", [1e-6, 2.0]),
];

/// Greatest number of draws until e₁ <= e₂.
const DRAWS: u32 = 1000;
/// Least percentage of the draws that must be in order, so that [`DRAWS`] consecutive draws out of order are
/// practically impossible.
const LEAST_SHARE: u64 = 5;

/// Options of `toytop sweep` that select the motions.
impl fmt::Display for Space {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (axis, (name, _)) in self.axes.iter().zip(LIMITS) {
            write!(f, "{name}={axis} ")?;
        }
        let signs = clap::ValueEnum::to_possible_value(&self.signs);
        write!(f, "--signs {}", signs.as_ref().map_or("", |value| value.get_name()))?;
        match self.sample {
            Some((motions, seed)) => write!(f, " --motions {motions} --seed {seed}"),
            None => Ok(()),
        }
    }
}

impl Space {
    /// Checks the axes.
    ///
    /// # Errors
    /// [`Failure::Input`]: numbers out of their limits, a range in a grid, or too few pairs with e₁ <= e₂.
    pub fn check(&self) -> Result<(), Failure> {
        for (axis, (name, [low, high])) in self.axes.iter().zip(LIMITS) {
            let [least, greatest] = axis.ends();
            if least < low || greatest > high {
                return Err(Failure::Input(format!("{name}: {axis}: must be within [{low}, {high}]")));
            }
            if self.sample.is_none() && axis.count().is_none() {
                return Err(Failure::Input(format!(
                    "{name}: {axis} in a grid: must be LOW..HIGH/PLACES or numbers (or draw a sample: --motions N)"
                )));
            }
        }
        if let Some((_, seed)) = self.sample {
            let trials = 100 * LEAST_SHARE;
            let drawn = (0..trials).filter(|&i| {
                let [e1, e2] = self.draw_pair(&mut Random::new(seed, i));
                e1 <= e2
            });
            if drawn.count() < trials as usize / 100 * LEAST_SHARE as usize {
                return Err(Failure::Input(
                    "--e1, --e2: must have e1 <= e2 in at least one of 20 draws".into(),
                ));
            }
        } else if self.sizes().iter().try_fold(1_u64, |product, &size| product.checked_mul(size)).is_none() {
            return Err(Failure::Input("a grid: must have at most 2^64 places".into()));
        }
        Ok(())
    }

    /// Number of motions.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.sample.map_or_else(|| self.sizes().iter().product(), |(motions, _)| motions)
    }

    /// Numbers of the motion with this index. In a grid C/A changes fastest, then the other axes from the last to e₁,
    /// and the signs slowest.
    #[must_use]
    pub fn place(&self, number: u64) -> Place {
        let Some((_, seed)) = self.sample else { return self.on_the_grid(number) };
        let mut random = Random::new(seed, number);
        let mut pair = self.draw_pair(&mut random);
        for _ in 1..DRAWS {
            if pair[0] <= pair[1] {
                break;
            }
            pair = self.draw_pair(&mut random);
        }
        let [e1, e2] = pair;
        let [_, _, e3, a, c_over_a] = &self.axes;
        Place {
            e: [e1, e2, e3.draw(&mut random)],
            a: a.draw(&mut random),
            c_over_a: c_over_a.draw(&mut random),
            signs: self.signs_at(u64::from(random.one_in(2))),
        }
    }

    fn draw_pair(&self, random: &mut Random) -> [f64; 2] {
        let [e1, e2, ..] = &self.axes;
        [e1.draw(random), e2.draw(random)]
    }

    fn on_the_grid(&self, number: u64) -> Place {
        let sizes = self.sizes();
        let mut rest = number;
        let mut places = [0; 6];
        for (place, size) in places.iter_mut().zip(sizes).rev() {
            (*place, rest) = (rest % size, rest / size);
        }
        let [signs, e1, e2, e3, a, c_over_a] = places;
        let at = |axis: usize, place| self.axes[axis].at(place);
        Place {
            e: [at(0, e1), at(1, e2), at(2, e3)],
            a: at(3, a),
            c_over_a: at(4, c_over_a),
            signs: self.signs_at(signs),
        }
    }

    /// Numbers of values of the signs and of the axes.
    fn sizes(&self) -> [u64; 6] {
        let mut sizes = [if self.signs == SignChoice::Both { 2 } else { 1 }; 6];
        for (size, axis) in sizes.iter_mut().skip(1).zip(&self.axes) {
            *size = axis.count().unwrap_or(1);
        }
        sizes
    }

    fn signs_at(&self, place: u64) -> Signs {
        let different = match self.signs {
            SignChoice::Same => false,
            SignChoice::Different => true,
            SignChoice::Both => place == 1,
        };
        Signs { l_plus_n: Sign::Plus, l_minus_n: if different { Sign::Minus } else { Sign::Plus } }
    }
}

impl Place {
    /// Motion of these numbers, which starts at u = e₁.
    ///
    /// # Errors
    /// `e2`: e₁ > e₂, which occurs in a grid.
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: self.a,
            axial_inertia: self.c_over_a * self.a,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        })?;
        Motion::from_branch_points(&top, self.e, self.signs, &Start::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(axes: [&str; 5], signs: SignChoice, sample: Option<(u64, u64)>) -> Space {
        Space { axes: axes.map(|text| text.parse().unwrap()), signs, sample }
    }

    #[test]
    fn a_grid_has_every_combination_once() {
        let space = space(["-0.5..0.5/3", "0.6,0.7", "1..3/5", "0.1,1", "0.5..2/4"], SignChoice::Both, None);
        space.check().unwrap();
        assert_eq!(space.count(), 2 * 3 * 2 * 5 * 2 * 4);
        let mut all: Vec<_> = (0..space.count()).map(|i| format!("{:?}", space.place(i))).collect();
        assert_eq!(space.place(0).c_over_a, 0.5);
        assert_eq!(space.place(1).c_over_a, 1.0);
        all.sort();
        all.dedup();
        assert_eq!(all.len() as u64, space.count());
        assert!((0..space.count()).all(|i| space.place(i).motion().is_ok()));
    }

    #[test]
    fn a_sample_is_launched_everywhere_and_depends_on_the_seed() {
        let axes = ["-1..1", "-1..1", "log:1..1e4", "log:1e-3..1e3", "0.02..2"];
        let [one, two] = [1, 2].map(|seed| space(axes, SignChoice::Both, Some((2000, seed))));
        one.check().unwrap();
        let mut different = 0;
        for i in 0..one.count() {
            let place = one.place(i);
            assert!(place.motion().is_ok(), "{place:?}");
            assert!(place != two.place(i) && place == one.place(i));
            different += usize::from(place.signs.l_minus_n == Sign::Minus);
        }
        assert!((850..1150).contains(&different), "{different}");
    }

    #[test]
    fn what_cannot_be_swept_is_refused() {
        let good = ["0.1..0.5/3", "0.6", "1", "1", "1"];
        let with = |axis: usize, text: &'static str, sample| {
            let mut axes = good;
            axes[axis] = text;
            space(axes, SignChoice::Same, sample).check()
        };
        assert!(with(0, "0.1", None).is_ok());
        for (axis, text) in [(0, "-1.1..1/3"), (1, "0.2,1.1"), (2, "0.9"), (3, "0"), (4, "2.1"), (0, "0..1")]
        {
            assert!(with(axis, text, None).is_err(), "{text}");
        }
        assert!(with(0, "0.59..0.61", Some((9, 1))).is_ok());
        assert!(with(0, "0.61..0.7", Some((9, 1))).is_err());
        assert!(with(0, "0.599..0.7", Some((9, 1))).is_err());
    }
}
