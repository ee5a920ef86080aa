//! A convex polygon that the maps take strictly into its own inside.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::exact::expansion::{sign_of_sum, two_product};
use crate::frame::Frame;

/// The polygon, counter-clockwise.
pub(crate) struct TrappingPolygon {
    /// Its corners in the plane: numbers of few digits where that does.
    pub plane: Vec<DVec2>,
    /// The same corners in the frame.
    pub here: Vec<DVec2>,
    /// Words of this many letters take it into its inside.
    pub letters: usize,
}

/// Of what rounding may do to one support value: an image's, and that of the corners, on both sides.
const ROUNDINGS: f64 = 4.0;
/// How much larger than the attractor it may be where rounding needs so much: pieces are then told apart some letters
/// further down.
const LARGEST_SIZE: f64 = 8.0;
/// Directions tried, coarse to fine: maps that hardly shrink need a polygon that is nearly round.
const DIRECTION_COUNTS: [usize; 3] = [24, 96, 288];
/// How many words of several letters are tried.
const MOST_WORDS: usize = 300;
/// Support values computed at most, over all rounds.
const MOST_SUPPORTS: usize = 40_000_000;
/// Digits after the point that corners are rounded to, in units of the polygon's size; then none at all.
const GRID_BITS: [i32; 4] = [10, 16, 24, 34];

impl TrappingPolygon {
    /// The polygon for the maps of a frame, in which the attractor is of the given diameter.
    ///
    /// Its support values `h` in a fan of directions solve `h(d) = max_i ( h(M_i^T d) + t_i . d ) + delta`, with `h`
    /// between two directions of the fan bounded by the chord: so each map takes the polygon to a distance `delta` from
    /// its edges.
    ///
    /// It may be larger than the attractor by about `slack`, relative to that; `coarsest` is the number of the
    /// coarsest fan to try.
    pub fn find(frame: &Frame, diameter: f64, slack: f64, coarsest: usize) -> Option<Self> {
        let delta = slack * diameter * (1.0 - frame.factor).clamp(1e-4, 1.0);
        // At least what rounding needs: half of it is left when the support values have settled.
        let delta = delta.max(4.0 * ROUNDINGS * frame.rounding);
        if delta >= LARGEST_SIZE * diameter {
            return None;
        }
        let mut blocks = frame.maps.clone();
        for letters in 1.. {
            for &count in &DIRECTION_COUNTS[coarsest..] {
                let fan = Directions::new(count);
                if let Some(support) = fan.settle(&blocks, delta)
                    && let Some(found) = Self::around(frame, &fan.polygon(&support), &blocks, letters)
                {
                    return Some(found);
                }
            }
            if blocks.len() * frame.maps.len() > MOST_WORDS {
                break;
            }
            blocks = blocks.iter().flat_map(|&a| frame.maps.iter().map(move |&b| a * b)).collect();
        }
        None
    }

    /// Rounds the corners as coarsely as can be.
    fn around(frame: &Frame, corners: &[DVec2], blocks: &[Affine2], letters: usize) -> Option<Self> {
        let inverse = frame.from_round.inverse();
        let origin = frame.to_plane(DVec2::ZERO);
        let size = corners.iter().map(|&p| (frame.from_round * p).abs().max_element()).fold(0.0, f64::max);
        let grids = GRID_BITS.map(|digits| 2.0_f64.powi(size.log2().ceil() as i32 - digits));
        grids.into_iter().chain([0.0]).find_map(|grid| {
            let snap = |x: f64| if grid > 0.0 { (x / grid).round() * grid } else { x };
            let snapped =
                corners.iter().map(|&p| frame.to_plane(p)).map(|p| DVec2::new(snap(p.x), snap(p.y)));
            let plane = strictly_convex(snapped.collect())?;
            let here: Vec<DVec2> = plane.iter().map(|&p| inverse * (p - origin)).collect();
            let tolerance = ROUNDINGS * frame.rounding;
            takes_inside(&here, blocks, tolerance).then_some(Self { plane, here, letters })
        })
    }
}

/// Leaves out corners that do not turn left. `None` if fewer than three are left.
fn strictly_convex(mut corners: Vec<DVec2>) -> Option<Vec<DVec2>> {
    let mut i = 0;
    let mut fine = 0;
    while corners.len() > 2 && fine < corners.len() {
        let count = corners.len();
        let (last, this, next) =
            (corners[(i + count - 1) % count], corners[i % count], corners[(i + 1) % count]);
        if turns_left(last, this, next) {
            fine += 1;
            i = (i + 1) % count;
        } else {
            corners.remove(i);
            fine = 0;
            i = i.saturating_sub(1);
        }
    }
    (corners.len() > 2).then_some(corners)
}

/// Exactly.
fn turns_left(a: DVec2, b: DVec2, c: DVec2) -> bool {
    let fits = |x: f64| x == 0.0 || (1e-120..1e120).contains(&x.abs());
    if ![a, b, c].iter().all(|p| fits(p.x) && fits(p.y)) {
        return false;
    }
    let products = [(b.x, c.y), (-a.x, c.y), (a.x, b.y), (-b.y, c.x), (a.y, c.x), (-a.y, b.x)];
    let terms: Vec<f64> = products.iter().flat_map(|&(p, q)| <[f64; 2]>::from(two_product(p, q))).collect();
    sign_of_sum(&terms) > 0
}

fn takes_inside(corners: &[DVec2], blocks: &[Affine2], tolerance: f64) -> bool {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).all(|(p, q)| {
        let normal = -(*q - *p).perp();
        let most = normal.dot(*p) - tolerance * normal.length();
        blocks.iter().all(|block| {
            let (pulled, moved) = (block.linear.transpose() * normal, block.translation.dot(normal));
            corners.iter().all(|c| pulled.dot(*c) + moved < most)
        })
    })
}

/// Unit vectors at equal angles.
struct Directions {
    directions: Vec<DVec2>,
    step: f64,
}

/// How a support value follows from two others.
struct Lowering {
    low: usize,
    from_low: f64,
    from_high: f64,
    shift: f64,
}

impl Directions {
    fn new(count: usize) -> Self {
        let step = std::f64::consts::TAU / count as f64;
        Self { directions: (0..count).map(|k| DVec2::from_angle(step * k as f64)).collect(), step }
    }

    /// Support values that all maps lower by half of `delta` or more; `None` if they do not settle.
    fn settle(&self, maps: &[Affine2], delta: f64) -> Option<Vec<f64>> {
        let count = self.directions.len();
        let links: Vec<Lowering> =
            self.directions.iter().flat_map(|&d| maps.iter().map(move |map| self.link(map, d))).collect();
        let mut support = vec![1.0; count];
        for _ in 0..MOST_SUPPORTS / links.len() {
            let image = |links: &[Lowering]| {
                let value = |link: &Lowering| {
                    let high = support[(link.low + 1) % count];
                    link.from_low * support[link.low] + link.from_high * high + link.shift
                };
                links.iter().map(value).fold(f64::NEG_INFINITY, f64::max) + delta
            };
            let next: Vec<f64> = links.chunks_exact(maps.len()).map(image).collect();
            let change = next.iter().zip(&support).map(|(new, old)| (new - old).abs()).fold(0.0, f64::max);
            support = next;
            if change < 0.25 * delta {
                return Some(support);
            }
            if support.iter().any(|value| *value > 100.0 || value.is_nan()) {
                return None;
            }
        }
        None
    }

    /// The support in direction `d` of an image is that of the set in the direction pulled back, and this is at most
    /// what the two directions of the fan beside it give.
    fn link(&self, map: &Affine2, d: DVec2) -> Lowering {
        let pulled: DVec2 = DMat2::transpose(&map.linear) * d;
        let turn = pulled.y.atan2(pulled.x).rem_euclid(std::f64::consts::TAU) / self.step;
        let low = (turn.floor() as usize).min(self.directions.len() - 1);
        let angle = (turn - low as f64).clamp(0.0, 1.0) * self.step;
        let scale = pulled.length() / self.step.sin();
        Lowering {
            low,
            from_low: scale * (self.step - angle).sin(),
            from_high: scale * angle.sin(),
            shift: d.dot(map.translation),
        }
    }

    /// The corners of what is within the support values.
    fn polygon(&self, support: &[f64]) -> Vec<DVec2> {
        let far = 2.0 * support.iter().copied().fold(1.0, f64::max);
        let mut polygon = [(-far, -far), (far, -far), (far, far), (-far, far)].map(DVec2::from).to_vec();
        for (direction, &most) in self.directions.iter().zip(support) {
            let over = |p: DVec2| direction.dot(p) - most;
            let mut clipped = Vec::with_capacity(polygon.len() + 1);
            for (i, &p) in polygon.iter().enumerate() {
                let q = polygon[(i + 1) % polygon.len()];
                let (over_p, over_q) = (over(p), over(q));
                if over_p <= 0.0 {
                    clipped.push(p);
                }
                if over_p * over_q < 0.0 {
                    clipped.push(p + (q - p) * (over_p / (over_p - over_q)));
                }
            }
            polygon = clipped;
        }
        polygon
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn enclosure(rows: &[[f64; 6]]) -> Option<TrappingPolygon> {
        let maps: Vec<Affine2> = rows.iter().copied().map(Affine2::from_row).collect();
        let mut frame = Frame::default();
        frame.set(&maps).unwrap();
        TrappingPolygon::find(&frame, 1.0, 0.02, 0)
    }

    #[test]
    fn gaskets_ferns_and_segments_are_enclosed() {
        let gasket = enclosure(&[
            [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.25, 0.375],
        ])
        .unwrap();
        assert_eq!(gasket.letters, 1);
        // All numbers are short, and the triangle is inside.
        assert!(gasket.plane.iter().all(|p| (p.x * 4096.0).fract() == 0.0), "{:?}", gasket.plane);
        let (min, max) = gasket
            .plane
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(a, b), p| (a.min(*p), b.max(*p)));
        assert!(min.x < 0.0 && min.y < 0.0 && max.x > 1.0 && max.y > 0.75 && max.x < 1.2, "{min} {max}");
        let fern = [
            [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
            [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
            [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
            [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        ];
        assert!(enclosure(&fern).is_some());
        assert!(enclosure(&[[0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.3, 0.0, 0.0, 0.0, 0.5, 0.0]]).is_some());
        // Maps of large norm that contract in longer words only.
        assert!(enclosure(&[[0.0, 1.2, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.6, 0.0, 1.0, 1.0]]).is_some());
        // Hardly shrinking.
        assert!(enclosure(&[[0.995, 0.0, 0.0, 0.995, 0.0, 0.0], [0.0, -0.5, 0.5, 0.0, 0.5, 0.0]]).is_some());
    }

    #[test]
    fn corners_that_do_not_turn_left_go() {
        let p = |x, y| DVec2::new(x, y);
        let square =
            vec![p(0.0, 0.0), p(0.5, 0.0), p(1.0, 0.0), p(1.0, 0.0), p(1.0, 1.0), p(0.5, 0.9), p(0.0, 1.0)];
        assert_eq!(strictly_convex(square).unwrap(), [p(0.0, 0.0), p(1.0, 0.0), p(1.0, 1.0), p(0.0, 1.0)]);
        assert!(strictly_convex(vec![p(0.1, 0.2), p(0.1, 0.2), p(0.3, 0.4)]).is_none());
        assert!(strictly_convex(vec![]).is_none());
    }
}
