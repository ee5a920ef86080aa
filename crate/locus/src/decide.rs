//! The fast answer: one parameter of a locus.

use frond_core::{Affine2, IfsError};
use glam::{DMat2, DVec2};

use crate::exact::area;
use crate::frame::Frame;
use crate::gap::bracket::CutSearch;
use crate::gap::difference_set::{self, DifferenceSet, Translates};
use crate::gap::greedy::GreedySearch;
use crate::gap::power_series::PowerSeries;
use crate::gap::trails::Trails;
use crate::gap::word_pairs::WordPairs;
use crate::gap::word_tree::WordTree;
use crate::magnification::Magnification;
use crate::support::table::SupportTable;
use crate::verdict::{Bounded, Sample, State};

/// The memory that [`decide`] works in; keep one for many calls.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    pub(crate) frame: Frame,
    pub(crate) support: SupportTable,
    pub(crate) greedy: GreedySearch,
    pub(crate) words: WordTree,
    differences: DifferenceSet,
    series: PowerSeries,
    maps: Vec<Affine2>,
    pub(crate) search: CutSearch,
    /// The ways to near points of the system that was decided last, where others are to follow them.
    trails: Trails,
}

/// Decides whether the attractor of raw maps is connected, and how wide its widest gap is.
///
/// `epsilon` is relative to the diameter of the attractor; `budget` limits the pairs of pieces looked
/// at (20,000 is plenty). The answer depends on the arguments alone, not on what `scratch` was used
/// for before. For bounds of the gap use [`decide_bounds`], for the components and points
/// [`connectedness`](crate::connectedness).
pub fn decide(maps: &[Affine2], epsilon: f64, budget: usize, scratch: &mut Scratch) -> Sample {
    scratch.decide(maps, epsilon, budget, Ask::default()).sample
}

/// [`decide`], with what is proved about the widest gap and about where the attractor lies.
///
/// ```
/// use frond_core::Affine2;
/// use frond_locus::{Scratch, decide_bounds};
///
/// // Cantor's dust, twice as large: its gap is a third of it.
/// let third = 1.0 / 3.0;
/// let maps = [0.0, 4.0 * third].map(|e| Affine2::from_row([third, 0.0, 0.0, third, e, 0.0]));
/// let known = decide_bounds(&maps, 1e-4, 20_000, &mut Scratch::default());
/// assert!(known.lower * known.diameter <= 2.0 * third && 2.0 * third <= known.upper * known.diameter);
/// ```
pub fn decide_bounds(maps: &[Affine2], epsilon: f64, budget: usize, scratch: &mut Scratch) -> Bounded {
    scratch.decide(maps, epsilon, budget, Ask { bounds: true, ..Ask::default() })
}

/// [`decide`] for the maps `s z + exp(2 pi i k / sides)`, k = 0, 1, .. of the complex plane: `s` is `[re, im]`,
/// and there are 2 to 64 sides. For other numbers of sides there is no attractor.
///
/// All pairs of pieces that are as far round from each other are alike; so this is faster where there are
/// many sides. With 2 sides it is the set M of Barnsley & Harrington (1985).
///
/// ```
/// use frond_locus::{Scratch, State, decide_polygon};
///
/// // The hole of M that they found.
/// let hole = decide_polygon(2, [0.0227, 0.703], 1e-6, 20_000, &mut Scratch::default());
/// assert_eq!(hole.state, State::Disconnected);
/// ```
pub fn decide_polygon(
    sides: usize,
    s: [f64; 2],
    epsilon: f64,
    budget: usize,
    scratch: &mut Scratch,
) -> Sample {
    if !(2..=64).contains(&sides) {
        return Bounded::unknown(State::NoAttractor).sample;
    }
    let mut maps = std::mem::take(&mut scratch.maps);
    maps.clear();
    let linear = DMat2::from_cols(DVec2::new(s[0], s[1]), DVec2::new(-s[1], s[0]));
    maps.extend((0..sides).map(|k| Affine2::new(linear, corner(sides, k))));
    let sample = scratch.decide(&maps, epsilon, budget, Ask { polygon: true, ..Ask::default() }).sample;
    scratch.maps = maps;
    sample
}

/// Corner `k` of the regular polygon; of those of 2 and 4 sides exactly.
fn corner(sides: usize, k: usize) -> DVec2 {
    match 4 * k % sides {
        0 => [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y][4 * k / sides],
        _ => DVec2::from_angle(std::f64::consts::TAU * k as f64 / sides as f64),
    }
}

/// What is asked for.
#[derive(Clone, Copy, Default)]
struct Ask<'a> {
    /// The maps are those of a regular polygon.
    polygon: bool,
    /// Also the diameter and bounds where the verdict does not need them.
    bounds: bool,
    /// Ways to near points of a system much like this one, to begin with; then this one's are kept, too.
    start: Option<&'a Trails>,
    /// Nothing but these ways.
    ways_alone: bool,
}

impl Scratch {
    /// [`decide`] for one of many systems that are much like each other. The answer depends on the arguments alone:
    /// another `start` may find near points where none were found, and no answer contradicts another.
    ///
    /// Of a gap that is not proved wider than epsilon either may be said, `Touching` or `Disconnected`, and which it is
    /// hangs on what is met on the way: then it is what [`decide`] says.
    pub(crate) fn decide_from(
        &mut self,
        maps: &[Affine2],
        epsilon: f64,
        budget: usize,
        start: &Trails,
    ) -> Sample {
        let found = self.decide(maps, epsilon, budget, Ask { start: Some(start), ..Ask::default() });
        if found.sample.state != State::Disconnected || found.lower > epsilon {
            return found.sample;
        }
        let trails = std::mem::take(&mut self.trails);
        let alone = self.decide(maps, epsilon, budget, Ask::default()).sample;
        self.trails = trails;
        if alone.state == State::Undecided { found.sample } else { alone }
    }

    /// The ways to near points that [`Scratch::decide_from`] finds.
    pub(crate) fn find_trails(
        &mut self,
        maps: &[Affine2],
        epsilon: f64,
        budget: usize,
        start: &Trails,
    ) -> &Trails {
        self.decide(maps, epsilon, budget, Ask { start: Some(start), ways_alone: true, ..Ask::default() });
        &self.trails
    }

    /// Those of the system decided last, by [`Scratch::decide_from`].
    pub(crate) fn trails(&self) -> &Trails {
        &self.trails
    }

    fn decide(&mut self, maps: &[Affine2], epsilon: f64, budget: usize, ask: Ask<'_>) -> Bounded {
        let found = match Magnification::of(maps) {
            Some(magnification) => {
                magnification.bounded(self.bracket(&magnification.magnify(maps), epsilon, budget, ask))
            }
            None => self.bracket(maps, epsilon, budget, ask),
        };
        found.or_undecided()
    }

    fn bracket(&mut self, maps: &[Affine2], epsilon: f64, budget: usize, ask: Ask<'_>) -> Bounded {
        let Ask { polygon, bounds, start, ways_alone } = ask;
        let Self { frame, support, greedy, words, differences, series, search, trails, .. } = self;
        trails.clear();
        search.forget_looks();
        let equal = polygon || difference_set::are_equal(maps);
        let proved = equal && difference_set::fill(&maps[0]);
        if proved && !bounds && maps[0].norm() < 1.0 - 1e-9 && maps.iter().all(|map| map.is_finite()) {
            let sample = Sample { state: State::Connected, gap: 0.0 };
            return Bounded { sample, ..Bounded::unknown(State::Connected) };
        }
        let proved = proved || area::at_once(maps);
        // Two maps of one linear part need no more than sums: the quickest way there is.
        let known = if equal && !proved { series.decide(maps, epsilon, bounds) } else { None };
        if let Some(known) = known.filter(|_| !bounds) {
            return known;
        }
        match frame.set_like(maps, start.and_then(|start| start.coordinates.as_ref())) {
            Ok(found) => trails.coordinates = found.filter(|found| start.is_some() && found.length == 1),
            Err(IfsError::Unproved) => return Bounded::unknown(State::Undecided),
            // Too large to compute with, which says nothing about the attractor.
            Err(IfsError::NotFinite { .. }) if maps.iter().all(|map| map.is_finite()) => {
                return Bounded::unknown(State::Undecided);
            }
            Err(_) => return Bounded::unknown(State::NoAttractor),
        }
        let ellipse = Some(frame.ellipse());
        let whole = |state, upper, diameter| Bounded {
            sample: Sample { state, gap: 0.0 },
            lower: 0.0,
            upper,
            diameter,
            ellipse,
        };
        let equal = equal && frame.length == 1;
        if frame.point {
            return whole(if proved { State::Connected } else { State::Touching }, 0.0, 0.0);
        }
        if proved {
            // The attractor lies in the unit disc of the frame.
            return whole(State::Connected, 0.0, 2.0 * frame.stretch);
        }
        if let Some(known) = known {
            return Bounded { ellipse, ..known };
        }
        search.begin(maps.len(), polygon);
        let areas = || maps.iter().map(difference_set::area);
        if areas().any(|area| area >= 0.5) {
            search.join_proved(|i, j| difference_set::area(&maps[i]) + difference_set::area(&maps[j]) >= 1.0);
            if search.is_whole() {
                return whole(State::Connected, 0.0, 2.0 * frame.stretch);
            }
        }
        let (bracket, diameter) = if equal {
            differences.set(frame, polygon);
            let near = epsilon * epsilon * differences.extent(frame);
            for (i, j, trail) in start.iter().flat_map(|start| start.iter()) {
                search.join_near_pair(i, j, || {
                    let found = differences.follow(frame, i, j, near, trail)?;
                    trails.push(i, j, differences.trail());
                    Some(found)
                });
            }
            search.join_near(|i, j| {
                let found = differences.meet(frame, i, j, near)?;
                if start.is_some() {
                    trails.push(i, j, differences.trail());
                }
                Some(found)
            });
            if search.is_whole() && !bounds {
                return whole(State::Touching, f64::INFINITY, f64::NAN);
            }
            differences.bound(frame, support);
            // The differences reach as far to both sides.
            let diameter = frame.diameter(0.5 * support.diameter(frame.from_round));
            let resolution = frame.resolution(epsilon, diameter);
            let size = 0.5 * support.diameter(DMat2::IDENTITY);
            let mut translates = Translates::new(frame, support, differences, resolution, size);
            let bracket = search.bracket(&mut translates, resolution, budget, !ways_alone);
            if start.is_some() {
                for &(i, j, parts) in search.meetings() {
                    if !trails.has(i, j) {
                        let way = parts.map(|(node, _)| differences.way(node));
                        trails.push(i, j, &way.unwrap_or_default());
                    }
                }
            }
            (bracket, diameter)
        } else {
            let met = |i: usize, j: usize| (frame.maps[i] == frame.maps[j]).then_some(0.0);
            let has_point = greedy.set(frame);
            if has_point {
                let near = epsilon * epsilon * greedy.extent(frame);
                for (i, j, trail) in start.iter().flat_map(|start| start.iter()) {
                    search.join_near_pair(i, j, || {
                        let found = greedy.follow(frame, i, j, near, trail)?;
                        trails.push(i, j, greedy.trail());
                        Some(found)
                    });
                }
                search.join_near(|i, j| {
                    met(i, j).or_else(|| {
                        let found = greedy.meet(frame, i, j, near)?;
                        if start.is_some() {
                            trails.push(i, j, greedy.trail());
                        }
                        Some(found)
                    })
                });
            } else {
                search.join_near(met);
            }
            if search.is_whole() && !bounds {
                return whole(State::Touching, f64::INFINITY, f64::NAN);
            }
            if frame.factor < FACTOR_FOR_ROUGH_TABLE {
                support.sketch(&frame.maps, 0.02 * (1.0 - frame.factor), 64);
            } else {
                support.set(&frame.maps, 0.012 * (1.0 - frame.factor), 64);
            }
            let diameter = frame.diameter(support.diameter(frame.from_round));
            let resolution = frame.resolution(epsilon, diameter);
            let mut pairs = WordPairs::new(frame, support, words);
            pairs.begin(resolution, resolution);
            let bracket = search.bracket(&mut pairs, resolution, budget, !ways_alone);
            if start.is_some() && has_point {
                for &(i, j, parts) in search.meetings() {
                    if !trails.has(i, j) {
                        let letters = parts.map(|(u, v)| [u, v].map(|part| words.letters(part)));
                        let way = greedy.way(i, j, &letters.unwrap_or_default());
                        trails.push(i, j, &way);
                    }
                }
            }
            (bracket, diameter)
        };
        let relative = |length: f64| length / diameter;
        let (lower, upper) = (
            relative(bracket.lower) * (1.0 - LAST_ROUNDING),
            relative(search.bottleneck() + frame.off()) * (1.0 + LAST_ROUNDING),
        );
        if search.is_whole() {
            return whole(State::Touching, upper, diameter);
        }
        let sample = if lower > 0.0 {
            let middle = f64::midpoint(bracket.lower, bracket.upper);
            Sample { state: State::Disconnected, gap: relative(middle) as f32 }
        } else {
            Sample { state: State::Undecided, gap: relative(bracket.upper) as f32 }
        };
        Bounded { sample, lower, upper, diameter, ellipse }
    }
}

/// Maps that shrink more slowly than this add up what a rough support is too wide.
const FACTOR_FOR_ROUGH_TABLE: f64 = 0.8;
/// What the last few operations may add to a bound, relative to it.
const LAST_ROUNDING: f64 = 1e-14;
