//! A quick way down to two points that meet.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::support::extremes::larger;
use crate::support::f64x4::F64x4;

/// Looks for two points of the attractor, one in each of two pieces, that lie within a given distance of
/// each other: always into those parts whose middles are nearest for their size, and back to the last that was
/// passed over where these are too far apart.
///
/// It proves nothing where it finds nothing, but what it finds is found in a tenth of the time that the descent
/// with support functions takes.
#[derive(Clone, Debug, Default)]
pub(crate) struct GreedySearch {
    lanes: Vec<Lane>,
    sizes: Vec<f64>,
    /// A point of the attractor, in the frame.
    point: DVec2,
    /// What was passed over.
    passed: Vec<(TwoPieces, usize)>,
}

/// The translations and norms of four maps.
#[derive(Clone, Copy, Debug, Default)]
struct Lane {
    x: F64x4,
    y: F64x4,
    size: F64x4,
    /// What a lane's score is raised by: beyond all others where it holds no map. An infinite score would no longer be
    /// a number once that of its map is written into its lowest bits.
    far: F64x4,
}

/// Two pieces: their linear parts, about how large they are, and the difference of their middles.
#[derive(Clone, Copy, Debug)]
struct TwoPieces {
    linear: [DMat2; 2],
    size: [f64; 2],
    /// From the middle of the second to that of the first.
    apart: DVec2,
}

/// How far the middles of two pieces may be apart, against the radii of the discs they lie in, squared, to be looked
/// into: mostly a piece does not fill its disc.
const SQUARE_TO_ENTER: f64 = 0.4;
/// How often to go back.
const MOST_RETURNS: usize = 16;
/// Steps in all.
const MOST_STEPS: usize = 160;
/// The lowest bits of a score hold the number of its map.
const NUMBER_BITS: u64 = 63;

impl GreedySearch {
    /// Gets ready for the maps of `frame`; `false` if it has no point to begin with.
    pub fn set(&mut self, frame: &Frame) -> bool {
        self.lanes.clear();
        self.sizes.clear();
        for four in frame.maps.chunks(4) {
            // A lane without a map is too far away to be chosen, also for a piece that is a mere point.
            let mut lane = Lane { far: F64x4::splat(f64::MAX), ..Lane::default() };
            for (k, map) in four.iter().enumerate() {
                let size = map.norm();
                lane.far.0[k] = 0.0;
                (lane.x.0[k], lane.y.0[k], lane.size.0[k]) = (map.translation.x, map.translation.y, size);
                self.sizes.push(size);
            }
            self.lanes.push(lane);
        }
        let point = frame.maps.iter().find_map(|map| map.fixed_point());
        self.point = point.unwrap_or_default();
        point.is_some()
    }

    /// The square of a distance that the attractor has at least across, in the plane: between images of one of its
    /// points.
    pub fn extent(&self, frame: &Frame) -> f64 {
        let images = || frame.maps.iter().map(|map| map.apply(self.point));
        let far = |p: DVec2| images().map(|q| frame.square(q - p)).fold(0.0, larger);
        larger(far(self.point), images().map(far).fold(0.0, larger))
    }

    /// The square of the distance in the plane of two points of the pieces of maps `i` and `j`, if it was found
    /// to be `reach` or less.
    pub fn meet(&mut self, frame: &Frame, i: usize, j: usize, reach: f64) -> Option<f64> {
        let (a, b) = (frame.maps[i], frame.maps[j]);
        let mut pair = TwoPieces {
            linear: [a.linear, b.linear],
            size: [self.sizes[i], self.sizes[j]],
            apart: a.translation - b.translation,
        };
        self.passed.clear();
        let mut back = 0;
        for _ in 0..MOST_STEPS {
            let [p, q] = pair.linear;
            let between = pair.apart + p * self.point - q * self.point;
            let squared = frame.square(between);
            if squared <= reach {
                return Some(squared);
            }
            let (best, second) = self.nearest_parts(&pair);
            if second < SQUARE_TO_ENTER {
                self.passed.push((pair, number(second)));
            }
            if best < SQUARE_TO_ENTER {
                pair = self.enter(frame, pair, number(best));
            } else {
                back += 1;
                let (passed, part) = self.passed.pop().filter(|_| back <= MOST_RETURNS)?;
                pair = self.enter(frame, passed, part);
            }
        }
        None
    }

    /// Scores of the two parts of the larger piece whose middles are nearest to that of the other piece, for their
    /// size; with their numbers.
    #[inline(always)]
    fn nearest_parts(&self, pair: &TwoPieces) -> (f64, f64) {
        let large = usize::from(pair.size[0] < pair.size[1]);
        let m = pair.linear[large];
        let (size, other) = (pair.size[large], pair.size[1 - large]);
        let apart = pair.apart * SIGN[large];
        let (mut best, mut second) = (f64::INFINITY, f64::INFINITY);
        for (block, lane) in self.lanes.iter().enumerate() {
            let x =
                F64x4::splat(apart.x) + F64x4::splat(m.x_axis.x) * lane.x + F64x4::splat(m.y_axis.x) * lane.y;
            let y =
                F64x4::splat(apart.y) + F64x4::splat(m.x_axis.y) * lane.x + F64x4::splat(m.y_axis.y) * lane.y;
            let r = F64x4::splat(size) * lane.size + F64x4::splat(other);
            let score = (x * x + y * y) / (r * r) + lane.far;
            let numbered = |k: usize| {
                let number = (4 * block + k) as u64;
                f64::from_bits(score.0[k].to_bits() & !NUMBER_BITS | number)
            };
            // The two least, without a branch.
            let ([a, b], [c, d]) = (ordered(numbered(0), numbered(1)), ordered(numbered(2), numbered(3)));
            let [least, more] = ordered(a, c);
            let next = ordered(more, ordered(b, d)[0])[0];
            let [least, more] = ordered(least, best);
            (best, second) = (least, ordered(ordered(next, second)[0], more)[0]);
        }
        (best, second)
    }

    #[inline(always)]
    fn enter(&self, frame: &Frame, mut pair: TwoPieces, part: usize) -> TwoPieces {
        let large = usize::from(pair.size[0] < pair.size[1]);
        let Affine2 { linear, translation } = frame.maps[part];
        let m = pair.linear[large];
        pair.apart += m * translation * SIGN[large];
        pair.linear[large] = m * linear;
        pair.size[large] *= self.sizes[part];
        pair
    }
}

const SIGN: [f64; 2] = [1.0, -1.0];

#[inline(always)]
fn number(score: f64) -> usize {
    (score.to_bits() & NUMBER_BITS) as usize
}

#[inline(always)]
fn ordered(a: f64, b: f64) -> [f64; 2] {
    if a < b { [a, b] } else { [b, a] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Maps that shrink a little around places so near each other that all pieces overlap.
    fn heap(count: usize) -> Vec<Affine2> {
        let map = |k: usize| {
            let at = DVec2::new((k % 3) as f64, (k % 2) as f64);
            Affine2::similitude(0.7, 0.3 * k as f64, at * 0.2)
        };
        (0..count).map(map).collect()
    }

    #[test]
    fn pieces_that_overlap_are_found_to_meet_however_many_maps_there_are() {
        for count in 3..=13 {
            let (mut frame, mut search) = (Frame::default(), GreedySearch::default());
            frame.set(&heap(count)).unwrap();
            assert!(search.set(&frame));
            let near = 1e-6 * search.extent(&frame);
            for (i, j) in (0..count).flat_map(|j| (0..j).map(move |i| (i, j))) {
                let found = search.meet(&frame, i, j, near);
                assert!(found.is_some_and(|square| square <= near), "maps {i} and {j} of {count}");
            }
        }
    }
}
