//! The pieces of a shape that a drawing is made of.

use frond_core::{Affine2, Hull, Ifs, adaptive_cut};
use glam::DVec2;

/// A shape as a drawing of not too many pieces, each the image of one outline.
pub struct Pieces {
    /// The maps of the shape.
    pub maps: Vec<Affine2>,
    /// Its bounding box.
    pub min: DVec2,
    pub max: DVec2,
    /// Around all of the shape, counter-clockwise: points of its convex hull.
    pub outline: Vec<DVec2>,
    /// The word of each piece, and its first letter.
    pub pieces: Vec<(Affine2, usize)>,
}

/// Directions in which the outline takes the farthest point of the hull.
const DIRECTIONS: u32 = 16;
/// Words that are looked at for each piece that may be drawn.
const WORDS_A_PIECE: usize = 14;

impl Pieces {
    /// All pieces of one size, as small as makes at most `most` of them; the first ones where even these are more.
    /// None where there is no attractor.
    pub fn of(rows: &[[f64; 6]], most: usize) -> Option<Self> {
        let maps: Vec<Affine2> = rows.iter().map(|&row| Affine2::from_row(row)).collect();
        let ifs = Ifs::new(maps.clone()).ok()?;
        let hull = Hull::of(&ifs);
        let mut pieces: Vec<_> = maps.iter().copied().enumerate().map(|(k, map)| (map, k)).collect();
        for step in 0..32 {
            let size = hull.diameter() * 0.5 * 0.8_f64.powi(step);
            let mut finer = Vec::new();
            let outcome = adaptive_cut(&ifs, size, most * WORDS_A_PIECE, |map, first| {
                if finer.len() <= most {
                    finer.push((*map, first));
                }
            });
            if !outcome.complete || finer.len() > most {
                break;
            }
            pieces = finer;
        }
        Some(Self { maps, min: hull.min(), max: hull.max(), outline: outline(&hull), pieces })
    }

    /// The box around the shape, counter-clockwise.
    pub fn corners(&self) -> [DVec2; 4] {
        let (min, max) = (self.min, self.max);
        [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)]
    }
}

fn outline(hull: &Hull) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = Vec::new();
    for k in 0..DIRECTIONS {
        let direction = DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / f64::from(DIRECTIONS));
        let farthest =
            hull.vertices().iter().copied().max_by(|p, q| p.dot(direction).total_cmp(&q.dot(direction)));
        points.extend(farthest.filter(|point| !points.contains(point)));
    }
    points
}
