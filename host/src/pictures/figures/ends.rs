//! Names of curves at their ends.

use super::chart::{COLORS, Curve, LEFT, text};
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene};

/// Upper bound on the mean width of a letter, pixels.
const WIDTH_OF_LETTER: f64 = 7.4;
/// Least vertical distance of two names, pixels.
const LINE: f64 = 16.0;

/// End of a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// Place, in the units of the axes or in pixels.
    pub(super) place: [f64; 2],
    /// Whether it is inside the frame, away from the right edge.
    pub(super) inside: bool,
}

/// Width of the longest name outside the frame, pixels.
pub(super) fn width_outside(lines: &[Curve], ends: &[End]) -> f64 {
    let outside = lines.iter().zip(ends).filter(|(_, end)| !end.inside);
    outside.map(|(line, _)| width(&line.name)).fold(0.0, f64::max)
}

fn width(name: &str) -> f64 {
    WIDTH_OF_LETTER * name.chars().count() as f64
}

/// Adds the names of the curves beside their ends: right of the frame, whose edge is given, in the order of the ends, without
/// overlap. A curve that ends inside the frame has its name there, where the fewest lines cross it. All places are in pixels.
pub(super) fn name_ends(
    scene: &mut Scene,
    lines: &[Curve],
    ends: &[End],
    points: &[Vec<[f64; 2]>],
    edge: f64,
) {
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by(|&a, &b| ends[a].place[1].total_cmp(&ends[b].place[1]));
    let (inside, outside): (Vec<usize>, Vec<usize>) = order.into_iter().partition(|&i| ends[i].inside);
    for i in inside {
        let place = free_place(ends[i].place, width(&lines[i].name), points, edge);
        scene.add(text(&lines[i].name, place, 13, "#222222"));
    }
    let mut heights: Vec<f64> = outside.iter().map(|&i| ends[i].place[1]).collect();
    spread(&mut heights);
    for (&i, y) in outside.iter().zip(heights) {
        let [end_x, end_y] = ends[i].place;
        scene.add(Primitive::Line {
            x1: end_x,
            y1: end_y,
            x2: edge + 13.0,
            y2: y,
            stroke: Color::from(COLORS[i % COLORS.len()]),
            stroke_width: 1.0,
            stroke_dasharray: None,
        });
        scene.add(text(&lines[i].name, [edge + 17.0, y + 4.5], 13, "#222222"));
    }
}

/// Increases the distances of ordered vertical positions to at least [`LINE`]; the middle of each group of moved
/// positions is kept.
fn spread(heights: &mut [f64]) {
    for _ in 0..100 {
        for i in 1..heights.len() {
            let overlap = LINE - (heights[i] - heights[i - 1]);
            if overlap > 0.0 {
                heights[i - 1] -= 0.5 * overlap;
                heights[i] += 0.5 * overlap;
            }
        }
    }
}

/// Place of a name of this width beside the end of a curve, inside the frame: its left end, and the baseline of its letters. It is right
/// or left of the end, below or above it.
fn free_place([x, y]: [f64; 2], width: f64, curves: &[Vec<[f64; 2]>], edge: f64) -> [f64; 2] {
    const PARTS: u32 = 32;
    let crossed = |[left, baseline]: [f64; 2]| {
        let within = |[x, y]: [f64; 2]| {
            (left..left + width).contains(&x) && (baseline - 13.0..baseline + 4.0).contains(&y)
        };
        let on = |[p, q]: [[f64; 2]; 2]| {
            (0..PARTS).any(|part| {
                let share = f64::from(part) / f64::from(PARTS);
                within([0, 1].map(|k| p[k] + share * (q[k] - p[k])))
            })
        };
        curves.iter().flat_map(|points| points.windows(2)).filter(|pair| on([pair[0], pair[1]])).count()
    };
    let candidates =
        [[x + 9.0, y + 17.0], [x + 9.0, y - 8.0], [x - 9.0 - width, y + 17.0], [x - 9.0 - width, y - 8.0]];
    let inside = candidates.into_iter().filter(|[left, _]| *left > LEFT && *left + width < edge);
    inside.min_by_key(|place| crossed(*place)).unwrap_or(candidates[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_order_and_a_lines_distance() {
        let mut heights = [100.0, 101.0, 101.0, 140.0, 300.0];
        spread(&mut heights);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > LINE - 0.01), "{heights:?}");
        assert_eq!(heights[4], 300.0);
        assert!((heights[..4].iter().sum::<f64>() - 442.0).abs() < 1e-9, "{heights:?}");
    }

    /// A line that falls to the right leaves space below it on the left, and above it on the right.
    #[test]
    fn a_name_inside_the_frame_stands_beside_the_lines() {
        let line = vec![vec![[100.0, 100.0], [500.0, 300.0]]];
        let [end, width] = [[500.0, 300.0], [120.0, 0.0]];
        let [right, left] = [800.0, 600.0].map(|edge| free_place(end, width[0], &line, edge));
        assert!(right[0] > end[0], "{right:?}");
        assert!(left[0] + width[0] < end[0] && left[1] > end[1], "{left:?}");
        let rising = vec![vec![[100.0, 300.0], [500.0, 250.0]]];
        let above = free_place([500.0, 250.0], width[0], &rising, 600.0);
        assert!(above[0] + width[0] < 500.0 && above[1] < 250.0, "{above:?}");
    }
}
