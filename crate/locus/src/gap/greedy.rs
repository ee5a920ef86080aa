//! A quick way down to two points that meet.

use frond_core::Affine2;
use glam::{DMat2, DVec2};
use wide::{f32x4, u32x4};

use crate::frame::Frame;
use crate::gap::trails::Step;
use crate::support::extremes::larger;

/// Looks for two points of the attractor, one in each of two pieces, that lie within a given distance of
/// each other: always into those parts whose middles are nearest for their size, and back to the last that was
/// passed over where these are too far apart.
///
/// It proves nothing where it finds nothing, but what it finds is found in a tenth of the time that the descent
/// with support functions takes.
#[derive(Clone, Debug, Default)]
pub(crate) struct GreedySearch {
    lanes: Vec<Lane>,
    /// The same words' linear parts, column by column, where some map is flat: else all pieces are as round as their
    /// discs, and their sizes tell all.
    flat: Vec<Linear>,
    /// The maps of the words that lead from a piece to its parts, one or several letters at once, and their norms.
    words: Vec<(Affine2, f64)>,
    /// The norms of the maps.
    sizes: Vec<f64>,
    /// A point of the attractor, in the frame.
    point: DVec2,
    /// What was passed over.
    passed: Vec<Passed>,
    /// The steps of a search, each with the number of the one before it.
    chain: Vec<(Step, usize)>,
    /// The steps to where the search is.
    trail: Vec<Step>,
}

/// The translations and norms of four words. Single precision is enough to choose by.
#[derive(Clone, Copy, Debug)]
struct Lane {
    x: f32x4,
    y: f32x4,
    size: f32x4,
    /// What a lane's score is raised by: beyond all others where it holds no map. An infinite score would no longer be
    /// a number once that of its map is written into its lowest bits.
    far: f32x4,
}

/// Two pieces: their linear parts, about how large they are, and the difference of their middles.
#[derive(Clone, Copy, Debug)]
struct TwoPieces {
    linear: [DMat2; 2],
    size: [f64; 2],
    /// From the middle of the second to that of the first.
    apart: DVec2,
}

/// A step that was not taken.
#[derive(Clone, Copy, Debug)]
struct Passed {
    /// Where, and by which step it was reached.
    pair: TwoPieces,
    at: usize,
    step: Step,
    score: f32,
}

/// The step before the first.
const NO_STEP: usize = usize::MAX;

/// How far the middles of two pieces may be apart, against the radii of the discs they lie in, squared, to be looked
/// into: mostly a piece does not fill its disc.
const SQUARE_TO_ENTER: f32 = 0.7;
/// The same for a step that led to near points of another system: these are known to have been there.
const SQUARE_TO_FOLLOW: f64 = 1.0;
/// The same against how far the ellipses they lie in reach towards each other.
const SQUARE_TO_ENTER_FLAT: f32 = 0.4;
/// A map that shrinks areas by less than this part of the square of its norm is flat.
const ROUND: f64 = 0.9;
/// Keeps divisors above zero, where the sizes of two pieces add up to 1.
const SMALLEST_DIVISOR: f32 = 1e-20;
/// So many of its last steps are gone back.
const STEPS_BACK: usize = 4;
/// Steps from the end of such a way.
const STEPS_FROM_TRAIL: usize = 40;
/// How often to go back, to what was most promising of all that was passed over.
const MOST_RETURNS: usize = 16;
/// Of so many maps at most words of two letters are looked at.
const MOST_MAPS_TWICE: usize = 4;
/// Steps in all.
const MOST_STEPS: usize = 160;
/// The lowest bits of a score hold the number of its map.
const NUMBER_BITS: u32 = 63;

impl GreedySearch {
    /// Gets ready for the maps of `frame`; `false` if it has no point to begin with.
    pub fn set(&mut self, frame: &Frame) -> bool {
        self.sizes.clear();
        self.sizes.extend(frame.maps.iter().map(|map| map.norm()));
        self.words.clear();
        self.words.extend(frame.maps.iter().copied().zip(self.sizes.iter().copied()));
        // Where there are few maps, two letters at once: half as many steps, and each looks farther.
        if self.words.len() <= MOST_MAPS_TWICE {
            let letters = self.words.len();
            for k in 0..letters {
                let (first, size) = self.words[k];
                for l in 0..letters {
                    let (second, other) = self.words[l];
                    self.words.push((first * second, size * other));
                }
            }
            self.words.drain(..letters);
        }
        self.lanes.clear();
        for four in self.words.chunks(4) {
            // A lane without a map is too far away to be chosen, also for a piece that is a mere point.
            let [mut x, mut y, mut size, mut far] = [[0.0; 4], [0.0; 4], [0.0; 4], [f32::MAX; 4]];
            for (k, (map, norm)) in four.iter().enumerate() {
                let DVec2 { x: across, y: up } = map.translation;
                (x[k], y[k], size[k], far[k]) = (across as f32, up as f32, *norm as f32, 0.0);
            }
            let [x, y, size, far] = [x, y, size, far].map(f32x4::new);
            self.lanes.push(Lane { x, y, size, far });
        }
        self.flat.clear();
        let is_flat = |(map, norm): (&Affine2, &f64)| map.determinant().abs() < ROUND * norm * norm;
        if frame.maps.iter().zip(&self.sizes).any(is_flat) {
            self.flat.extend(self.words.chunks(4).map(|four| {
                let mut linear = [[0.0; 4]; 4];
                for (k, (map, _)) in four.iter().enumerate() {
                    for (lanes, entry) in linear.iter_mut().zip(map.linear.to_cols_array()) {
                        lanes[k] = entry as f32;
                    }
                }
                Linear(linear.map(f32x4::new))
            }));
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
        self.trail.clear();
        let pair = self.begin(frame, i, j);
        self.search(frame, pair, reach, MOST_STEPS)
    }

    /// The way to the points that were found last.
    pub fn trail(&self) -> &[Step] {
        &self.trail
    }

    /// [`GreedySearch::meet`], from near where the way to such points of a neighbouring system leads.
    pub fn follow(&mut self, frame: &Frame, i: usize, j: usize, reach: f64, trail: &[Step]) -> Option<f64> {
        self.trail.clear();
        let mut pair = self.begin(frame, i, j);
        // The last ones, as a ring.
        let mut pairs = [pair; STEPS_BACK + 1];
        for &step in trail {
            self.enter(&mut pair, step)?;
            let size = pair.size[0] + pair.size[1];
            if pair.apart.length_squared() > SQUARE_TO_FOLLOW * size * size {
                break;
            }
            self.trail.push(step);
            pairs[self.trail.len() % (STEPS_BACK + 1)] = pair;
        }
        // The last steps may lead astray.
        let start = self.trail.len().saturating_sub(STEPS_BACK);
        self.trail.truncate(start);
        self.search(frame, pairs[start % (STEPS_BACK + 1)], reach, STEPS_FROM_TRAIL)
    }

    /// The way into pieces of attractorlets `i` and `j` that these letters lead to, for [`GreedySearch::follow`]:
    /// always into the larger one first, as far as the words that are looked at together go.
    pub fn way(&self, i: usize, j: usize, letters: &[Vec<u8>; 2]) -> Vec<Step> {
        let count = self.sizes.len();
        let at_once = if self.words.len() > count { 2 } else { 1 };
        let mut left = letters.each_ref().map(|letters| letters.chunks_exact(at_once));
        let mut size = [self.sizes[i], self.sizes[j]];
        let mut way = Vec::new();
        loop {
            let large = usize::from(size[0] < size[1]);
            let next = left[large].next().map(|word| (large, word));
            let Some((large, word)) = next.or_else(|| left[1 - large].next().map(|word| (1 - large, word)))
            else {
                return way;
            };
            let part = word.iter().fold(0, |part, &letter| part * count + usize::from(letter));
            way.push(Step { part: part as u16, large: large as u8 });
            size[large] *= self.words.get(part).map_or(1.0, |word| word.1);
        }
    }

    fn begin(&self, frame: &Frame, i: usize, j: usize) -> TwoPieces {
        let (a, b) = (frame.maps[i], frame.maps[j]);
        TwoPieces {
            linear: [a.linear, b.linear],
            size: [self.sizes[i], self.sizes[j]],
            apart: a.translation - b.translation,
        }
    }

    fn search(&mut self, frame: &Frame, mut pair: TwoPieces, reach: f64, steps: usize) -> Option<f64> {
        self.passed.clear();
        self.chain.clear();
        let mut at = NO_STEP;
        let mut back = 0;
        for _ in 0..steps {
            let [p, q] = pair.linear;
            let squared = frame.square(pair.apart + (p - q) * self.point);
            if squared <= reach {
                let length = self.trail.len();
                while let Some(&(step, from)) = self.chain.get(at) {
                    self.trail.push(step);
                    at = from;
                }
                self.trail[length..].reverse();
                return Some(squared);
            }
            let large = u8::from(pair.size[0] < pair.size[1]);
            let (best, second) = self.nearest_parts(&pair, usize::from(large));
            let step = |score: f32| Step { part: (score.to_bits() & NUMBER_BITS) as u16, large };
            if second < SQUARE_TO_ENTER {
                self.passed.push(Passed { pair, at, step: step(second), score: second });
            }
            let next = if best < SQUARE_TO_ENTER {
                step(best)
            } else {
                back += 1;
                let best = (0..self.passed.len())
                    .min_by(|&a, &b| self.passed[a].score.total_cmp(&self.passed[b].score).then(b.cmp(&a)));
                let passed = self.passed.swap_remove(best.filter(|_| back <= MOST_RETURNS)?);
                (pair, at) = (passed.pair, passed.at);
                passed.step
            };
            self.enter(&mut pair, next)?;
            self.chain.push((next, at));
            at = self.chain.len() - 1;
        }
        None
    }

    /// Scores of the two parts of the larger piece whose middles are nearest to that of the other piece, for how far
    /// the two reach towards each other; with their numbers.
    #[inline(always)]
    fn nearest_parts(&self, pair: &TwoPieces, large: usize) -> (f32, f32) {
        if self.flat.is_empty() { self.nearest_round(pair, large) } else { self.nearest_flat(pair, large) }
    }

    #[inline(always)]
    fn nearest_round(&self, pair: &TwoPieces, large: usize) -> (f32, f32) {
        let [xx, xy, yx, yy] = Linear::splat(pair.linear[large]).0;
        let apart = pair.apart * SIGN[large];
        let [apart_x, apart_y] = [apart.x, apart.y].map(splat);
        let (size, other) = (splat(pair.size[large]), splat(pair.size[1 - large]));
        least_two(self.lanes.iter().map(|lane| {
            let x = apart_x + xx * lane.x + yx * lane.y;
            let y = apart_y + xy * lane.x + yy * lane.y;
            let r = size * lane.size + other;
            (x * x + y * y) / (r * r) + lane.far
        }))
    }

    /// The attractor lies in the unit disc, so that the piece of a map `w` reaches as far along a vector `d` as
    /// `|w^T d|`, over the length of `d`: much less across a flat piece than its size.
    #[inline(always)]
    fn nearest_flat(&self, pair: &TwoPieces, large: usize) -> (f32, f32) {
        // Of about size 1: single precision has no room for squares of squares of what is small.
        let unit = 1.0 / (pair.size[0] + pair.size[1]);
        let [m, other] = [pair.linear[large], pair.linear[1 - large]].map(|m| Linear::splat(m * unit));
        let apart = pair.apart * (SIGN[large] * unit);
        let [apart_x, apart_y] = [apart.x, apart.y].map(splat);
        let enter = f32x4::splat(SQUARE_TO_ENTER / SQUARE_TO_ENTER_FLAT);
        least_two(self.lanes.iter().zip(&self.flat).map(|(lane, &linear)| {
            let [x, y] = m.times([lane.x, lane.y]);
            let between = [apart_x + x, apart_y + y];
            let squared = square(between);
            let part = square(linear.transposed_times(m.transposed_times(between)));
            let whole = square(other.transposed_times(between));
            // The square of the sum of the two reaches, times that of the length of `between`.
            let reach = part + whole + f32x4::splat(2.0) * (part * whole).sqrt();
            enter * squared * squared / (reach + f32x4::splat(SMALLEST_DIVISOR)) + lane.far
        }))
    }

    /// Goes on to a part, if there is one of this number.
    #[inline(always)]
    fn enter(&self, pair: &mut TwoPieces, Step { part, large }: Step) -> Option<()> {
        let large = usize::from(large & 1);
        let (Affine2 { linear, translation }, size) = *self.words.get(usize::from(part))?;
        let m = pair.linear[large];
        pair.apart += m * translation * SIGN[large];
        pair.linear[large] = m * linear;
        pair.size[large] *= size;
        Some(())
    }
}

const SIGN: [f64; 2] = [1.0, -1.0];

fn splat(x: f64) -> f32x4 {
    f32x4::splat(x as f32)
}

/// The two least of all scores, with their numbers in the lowest bits.
#[inline(always)]
fn least_two(scores: impl Iterator<Item = f32x4>) -> (f32, f32) {
    // The two least in each lane.
    let (mut best, mut second) = (f32x4::splat(f32::MAX), f32x4::splat(f32::MAX));
    let mut numbers = u32x4::new([0, 1, 2, 3]);
    for score in scores {
        let score = f32x4::from_bits(score.to_bits() & u32x4::splat(!NUMBER_BITS) | numbers);
        numbers += u32x4::splat(4);
        // Where a score is no number, the other one is taken.
        second = least(greatest(score, best), second);
        best = least(score, best);
    }
    // The two least of all: each lane against the one beside it, then against one of the other two.
    let two = two_least([best, second], |[a, b, c, d]| [b, a, d, c]);
    let [best, second] = two_least(two, |[a, b, c, d]| [c, d, a, b]);
    (best.to_array()[0], second.to_array()[0])
}

/// The linear parts of four maps, column by column.
#[derive(Clone, Copy, Debug)]
struct Linear([f32x4; 4]);

impl Linear {
    #[inline(always)]
    fn splat(m: DMat2) -> Self {
        Self(m.to_cols_array().map(splat))
    }

    #[inline(always)]
    fn times(self, [x, y]: [f32x4; 2]) -> [f32x4; 2] {
        let [xx, xy, yx, yy] = self.0;
        [xx * x + yx * y, xy * x + yy * y]
    }

    #[inline(always)]
    fn transposed_times(self, [x, y]: [f32x4; 2]) -> [f32x4; 2] {
        let [xx, xy, yx, yy] = self.0;
        [xx * x + xy * y, yx * x + yy * y]
    }
}

#[inline(always)]
fn square([x, y]: [f32x4; 2]) -> f32x4 {
    x * x + y * y
}

/// The lesser of each two; the second where one is NaN. The machines' own instructions differ in that.
#[inline(always)]
fn least(a: f32x4, b: f32x4) -> f32x4 {
    if cfg!(target_arch = "wasm32") { b.fast_min(a) } else { a.fast_min(b) }
}

#[inline(always)]
fn greatest(a: f32x4, b: f32x4) -> f32x4 {
    if cfg!(target_arch = "wasm32") { b.fast_max(a) } else { a.fast_max(b) }
}

/// The two least of each lane and of the one that takes its place.
#[inline(always)]
fn two_least([best, second]: [f32x4; 2], swap: impl Fn([f32; 4]) -> [f32; 4]) -> [f32x4; 2] {
    let [other, more] = [best, second].map(|four| f32x4::new(swap(four.to_array())));
    [least(best, other), least(greatest(best, other), least(second, more))]
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

    /// The points of two pieces that a way leads to, from the one to the other.
    fn between(search: &GreedySearch, frame: &Frame, [i, j]: [usize; 2], trail: &[Step]) -> DVec2 {
        let mut maps = [frame.maps[i], frame.maps[j]];
        for &Step { part, large } in trail {
            let piece = &mut maps[usize::from(large)];
            *piece = *piece * search.words[usize::from(part)].0;
        }
        maps[0].apply(search.point) - maps[1].apply(search.point)
    }

    #[test]
    fn letters_lead_to_the_pieces_that_they_name() {
        for count in [2, 3, 4, 5, 9] {
            let (mut frame, mut search) = (Frame::default(), GreedySearch::default());
            frame.set(&heap(count)).unwrap();
            assert!(search.set(&frame));
            for lengths in [[0, 0], [2, 4], [6, 0], [4, 4]] {
                let word = |side: usize| (0..lengths[side]).map(|k| ((3 * k + side) % count) as u8).collect();
                let letters: [Vec<u8>; 2] = [word(0), word(1)];
                let way = search.way(0, 1, &letters);
                let piece = |side: usize| {
                    letters[side].iter().fold(frame.maps[side], |map, &k| map * frame.maps[usize::from(k)])
                };
                let exact = piece(0).apply(search.point) - piece(1).apply(search.point);
                let found = between(&search, &frame, [0, 1], &way);
                assert!(found.distance(exact) < 1e-12, "{count} maps, {lengths:?}: {found} {exact}");
            }
        }
    }

    #[test]
    fn a_way_leads_to_the_points_it_is_said_to_lead_to() {
        for count in [3, 4, 5, 9] {
            let mut search = GreedySearch::default();
            let mut trail = Vec::new();
            let mut followed = 0;
            for k in 0..60 {
                // From one system to the next they turn a little, and once for good: then no way leads on.
                let turn = Affine2::similitude(1.0, 0.001 * f64::from(k), DVec2::ZERO);
                let mut maps = heap(count);
                maps[0] = maps[0] * turn;
                if k == 30 {
                    maps[0] = maps[0] * Affine2::similitude(0.1, 3.0, DVec2::X);
                }
                let mut frame = Frame::default();
                frame.set(&maps).unwrap();
                assert!(search.set(&frame));
                let near = 1e-8 * search.extent(&frame);
                // Numbers of size 1, of which the points' distance is a difference.
                let exact = |search: &GreedySearch, square: f64| {
                    let found = frame.square(between(search, &frame, [0, 1], search.trail()));
                    let off = (found - square).abs();
                    assert!(square <= near && off <= 1e-14 * near.sqrt(), "{found} {square}");
                };
                if let Some(square) = search.follow(&frame, 0, 1, near, &trail) {
                    followed += usize::from(!trail.is_empty());
                    exact(&search, square);
                    trail = search.trail().to_vec();
                } else if let Some(square) = search.meet(&frame, 0, 1, near) {
                    exact(&search, square);
                    trail = search.trail().to_vec();
                } else {
                    trail.clear();
                }
            }
            assert!(followed > 40, "{followed} of {count} maps");
        }
    }
}
