//! A plant becomes an outline: each step of the way around the one becomes an edge of the other.

use std::collections::HashMap;

use glam::{DMat2, DVec2};

use crate::bounds::hull2::Hull;
use crate::directed::chain::Ring;
use crate::directed::error::MAX_STATES;
use crate::directed::map::DirectedMap;
use crate::directed::system::DirectedIfs;
use crate::error::MAX_MAPS;
use crate::linear::affine::Affine2;

/// A system that grows from a foot to a tip, as ferns do: a stem, on which the rest of the plant stands and from whose
/// ends its other parts go off.
///
/// The foot is the point that the stem's map keeps, the tip the one that the rest's map keeps. Every part is a copy of
/// the plant that stands on its own foot.
#[derive(Clone, Debug)]
struct Plant {
    stem: Affine2,
    rest: Affine2,
    foot: DVec2,
    tip: DVec2,
    /// The other parts: whether each stands at the end of the stem, or else at its foot.
    parts: Vec<(Affine2, bool)>,
}

/// Feet this far from where they should be, over the diameter, are still taken for being there.
const NEAR_FOOT: f64 = 0.06;
/// The tip is at least so far from the foot, over the diameter.
const LEAST_HEIGHT: f64 = 0.3;

impl Plant {
    /// The stem and the rest that fit best; `None` where none fit.
    fn of(system: &DirectedIfs) -> Option<Self> {
        let [maps] = system.states() else { return None };
        let diameter = Hull::of_states(system).first()?.diameter();
        let mut best: Option<(f64, Self)> = None;
        for (i, stem) in maps.iter().enumerate() {
            for (j, rest) in maps.iter().enumerate().filter(|&(j, _)| j != i) {
                let (Some(foot), Some(tip)) = (stem.map.fixed_point(), rest.map.fixed_point()) else {
                    continue;
                };
                let node = stem.map.apply(tip);
                let mut worst = node.distance(rest.map.apply(foot));
                let mut parts = Vec::new();
                for (_, part) in maps.iter().enumerate().filter(|&(k, _)| k != i && k != j) {
                    let stands = part.map.apply(foot);
                    let (high, low) = (stands.distance(node), stands.distance(foot));
                    worst = worst.max(high.min(low));
                    parts.push((part.map, high <= low));
                }
                let fits = worst <= NEAR_FOOT * diameter && foot.distance(tip) >= LEAST_HEIGHT * diameter;
                if fits && best.as_ref().is_none_or(|(least, _)| worst < *least) {
                    best = Some((worst, Self { stem: stem.map, rest: rest.map, foot, tip, parts }));
                }
            }
        }
        best.map(|(_, plant)| plant)
    }

    /// Whether a part goes off to the left of the line from foot to tip.
    fn left(&self, part: &Affine2) -> bool {
        (self.tip - self.foot).perp_dot(part.apply(self.tip) - part.apply(self.foot)) > 0.0
    }

    /// The way up from foot to tip in so many steps: pieces of the stem and, last, what is left of the plant.
    fn up(&self, count: usize) -> Vec<Step> {
        let mut steps: Vec<Step> = Vec::with_capacity(count);
        let mut rest = Affine2::IDENTITY;
        let mut standing: Vec<Affine2> = Vec::new();
        for _ in 1..count {
            let of = |high: bool| {
                self.parts.iter().filter(move |part| part.1 == high).map(move |part| rest * part.0)
            };
            standing.extend(of(false));
            steps.push(Step { piece: rest * self.stem, back: false, beside: std::mem::take(&mut standing) });
            standing = of(true).collect();
            rest = rest * self.rest;
        }
        steps.push(Step { piece: rest, back: false, beside: standing });
        steps
    }

    /// The way around a piece, from its foot up on one side and down on the other, in an even number of steps. It goes
    /// up on the left where `left`.
    fn around(&self, piece: Affine2, count: usize, left: bool, beside: Vec<Affine2>) -> Vec<Step> {
        if count < 4 {
            return vec![Step { piece, back: false, beside }, Step { piece, back: true, beside: Vec::new() }];
        }
        // A piece that is a mirror image has its left side to the right.
        let side = left == (piece.linear.determinant() >= 0.0);
        let shares = self.shares(count - 2);
        let (mut up, mut down) = (Vec::new(), Vec::new());
        let (mut low, mut high) = (beside, Vec::new());
        let mut place = |at_top: bool, up: &mut Vec<Step>, down: &mut Vec<Step>| {
            for ((part, top), &share) in self.parts.iter().zip(&shares).filter(|((_, top), _)| *top == at_top)
            {
                let part_of = piece * *part;
                if share == 0 {
                    if *top {
                        high.push(part_of);
                    } else {
                        low.push(part_of);
                    }
                    continue;
                }
                let steps = self.around(part_of, share, left, Vec::new());
                if self.left(part) == side {
                    up.extend(steps);
                } else {
                    down.splice(0..0, steps);
                }
            }
        };
        place(false, &mut up, &mut down);
        let stem = up.len();
        place(true, &mut up, &mut down);
        let stem_piece = piece * self.stem;
        up.insert(stem, Step { piece: stem_piece, back: false, beside: low });
        let rest = count - 2 - shares.iter().sum::<usize>();
        up.extend(self.around(piece * self.rest, rest, left, high));
        // Down again: first what stands at the end of the stem, then the stem, then what stands at its foot.
        let at_foot: usize = self
            .parts
            .iter()
            .zip(&shares)
            .filter(|((part, top), _)| !top && self.left(part) != side)
            .map(|(_, share)| share)
            .sum();
        down.insert(down.len() - at_foot, Step { piece: stem_piece, back: true, beside: Vec::new() });
        up.extend(down);
        up
    }

    /// How many of so many steps each part gets: even numbers, by their size, and two or more for the rest.
    fn shares(&self, count: usize) -> Vec<usize> {
        let size = |map: &Affine2| map.linear.determinant().abs().sqrt();
        let all = size(&self.rest) + self.parts.iter().map(|part| size(&part.0)).sum::<f64>();
        let mut left = count - 2;
        let share = |part: &(Affine2, bool)| {
            let wanted = 2 * (0.5 * count as f64 * size(&part.0) / all).round() as usize;
            let share = wanted.min(left);
            left -= share;
            share
        };
        self.parts.iter().map(share).collect()
    }
}

/// A step of a way along a plant: up or down a piece of it. Other pieces stand where an upward step begins.
#[derive(Clone, Debug)]
struct Step {
    piece: Affine2,
    back: bool,
    beside: Vec<Affine2>,
}

/// Two systems of one graph: from a plant to an outline.
#[derive(Clone, Debug)]
pub(crate) struct Around {
    /// Which state of the outline each state becomes; the plant has but one.
    pub outline: Vec<usize>,
    pub plant_maps: Vec<Vec<DirectedMap>>,
    pub outline_maps: Vec<Vec<DirectedMap>>,
    /// Steps of the way around, each of which becomes an edge.
    pub steps: usize,
}

impl Around {
    /// The plant and the outline brought to one graph, or `None` where they are not such or take too many states.
    ///
    /// The way around the plant takes each leaf up and down: it closes, and has as many steps as the outline has
    /// edges. Inside an edge, which runs from point to point, the plant is taken from foot to tip. Steps that
    /// follow each other share a foot or a tip, edges that become of them an end; and since feet and tips are brought
    /// to the same place in both, they are the same points all the way where numbers go straight ahead.
    pub fn of(plant: &DirectedIfs, outline: &DirectedIfs) -> Option<Self> {
        let own = Plant::of(plant)?;
        let mut ring = Ring::of(outline)?;
        if !ring.edges.len().is_multiple_of(2) {
            ring.split(outline.states());
        }
        let count = ring.edges.len();
        if count < 4 || !count.is_multiple_of(2) {
            return None;
        }
        let corners: Vec<DVec2> =
            ring.edges.iter().map(|edge| edge.map.apply(ring.ends[edge.from][0])).collect();
        let next = |k: usize| corners[(k + 1) % count];
        let area: f64 = (0..count).map(|k| corners[k].perp_dot(next(k))).sum();
        // Up on the left and down on the right is clockwise.
        let steps = own.around(Affine2::IDENTITY, count, area < 0.0, Vec::new());
        if steps.len() != count {
            return None;
        }
        let begin = |step: &Step| step.piece.apply(if step.back { own.tip } else { own.foot });
        let turn = turned(&steps.iter().map(begin).collect::<Vec<DVec2>>(), &corners);
        let mut build = Build { own: &own, ring: &ring, keys: HashMap::new(), open: Vec::new() };
        let size = corners.iter().fold(0.0_f64, |most, corner| most.max(corner.length()));
        let (mut first, mut last) = (Vec::new(), Vec::new());
        for (k, step) in steps.iter().enumerate() {
            let k = (k + turn) % count;
            let (from, to) = (corners[k], next(k));
            let lies = Lies { ends: [from, to], onto: Affine2::IDENTITY, size };
            build.add(step, &ring.edges[k], step.back, &lies, [&mut first, &mut last])?;
        }
        let (mut plant_maps, mut outline_maps) = (vec![first], vec![last]);
        let mut at = 0;
        while at < build.open.len() {
            let (state, back) = build.open[at];
            let (mut first, mut last) = (Vec::new(), Vec::new());
            let edges: Vec<DirectedMap> = if back {
                outline.states()[state].iter().rev().copied().collect()
            } else {
                outline.states()[state].clone()
            };
            let onto = build.onto(state, back)?;
            let which = usize::from(back);
            let place = |edge: &DirectedMap, end: usize| {
                onto.apply(edge.map.apply(ring.ends[edge.from][end ^ which]))
            };
            for (k, (step, edge)) in own.up(edges.len()).iter().zip(&edges).enumerate() {
                // The ends themselves are where the plant has its foot and tip, without rounding.
                let from = if k == 0 { own.foot } else { place(edge, 0) };
                let to = if k + 1 == edges.len() { own.tip } else { place(&edges[k + 1], 0) };
                let lies = Lies { ends: [from, to], onto, size: 1.0 };
                build.add(step, edge, back, &lies, [&mut first, &mut last])?;
            }
            plant_maps.push(first);
            outline_maps.push(last);
            at += 1;
        }
        let mut outline: Vec<usize> = vec![0];
        outline.extend(build.open.iter().map(|(state, _)| *state));
        let mut this = Self { outline, plant_maps, outline_maps, steps: count };
        this.part();
        let fits = |maps: &Vec<DirectedMap>| maps.len() <= MAX_MAPS;
        (this.outline.len() <= MAX_STATES && this.plant_maps.iter().all(fits)).then_some(this)
    }

    /// Where there are more steps than a state may have maps, it becomes several, one after the other.
    fn part(&mut self) {
        if self.plant_maps[0].len() <= MAX_MAPS {
            return;
        }
        let parts = self.plant_maps[0].len().div_ceil(MAX_MAPS);
        let each = self.plant_maps[0].len().div_ceil(parts);
        let after = self.outline.len();
        for all in [&mut self.plant_maps, &mut self.outline_maps] {
            let here = |k: usize| DirectedMap { from: after + k, map: Affine2::IDENTITY };
            let whole = std::mem::replace(&mut all[0], (0..parts).map(here).collect());
            all.extend(whole.chunks(each).map(<[DirectedMap]>::to_vec));
        }
        self.outline.extend(std::iter::repeat_n(0, self.plant_maps.len() - after));
    }
}

/// By how many places corners are turned to lie near points, both about their middle and of one size.
fn turned(points: &[DVec2], corners: &[DVec2]) -> usize {
    let even = |points: &[DVec2]| -> Vec<DVec2> {
        let middle = points.iter().sum::<DVec2>() / points.len() as f64;
        let spread = points.iter().map(|p| p.distance_squared(middle)).sum::<f64>() / points.len() as f64;
        points.iter().map(|&p| (p - middle) / spread.sqrt().max(f64::MIN_POSITIVE)).collect()
    };
    let (points, corners) = (even(points), even(corners));
    let off = |turn: usize| -> f64 {
        let pairs = points.iter().zip(corners.iter().cycle().skip(turn));
        pairs.map(|(p, q)| p.distance_squared(*q)).sum()
    };
    (0..corners.len()).min_by(|&p, &q| off(p).total_cmp(&off(q))).unwrap_or(0)
}

/// Where an edge lies: its ends, what brings the shape that it is a part of to where the plant is, and a length that
/// its numbers do not exceed by much.
struct Lies {
    ends: [DVec2; 2],
    onto: Affine2,
    size: f64,
}

/// The states of both, as they are met.
struct Build<'a> {
    own: &'a Plant,
    ring: &'a Ring,
    /// The number of a state of the outline that is run through from its first point, or back from its last.
    keys: HashMap<(usize, bool), usize>,
    open: Vec<(usize, bool)>,
}

impl Build<'_> {
    /// A step and what stands beside it become an edge, of a state that is run through from its last point where
    /// `back`.
    fn add(
        &mut self,
        step: &Step,
        edge: &DirectedMap,
        back: bool,
        &Lies { ends: [from, to], onto, size }: &Lies,
        [first, last]: [&mut Vec<DirectedMap>; 2],
    ) -> Option<()> {
        let inner = self.onto(edge.from, back)?.inverse()?;
        // What runs backwards over the same points is the same state.
        let key = match self.ring.backwards[edge.from] {
            Some(twin) if twin == edge.from => (twin, false),
            Some(twin) if twin < edge.from => (twin, !back),
            _ => (edge.from, back),
        };
        let state = self.keys.len() + 1;
        let state = *self.keys.entry(key).or_insert_with(|| {
            self.open.push(key);
            state
        });
        if state > MAX_STATES {
            return None;
        }
        let (foot, tip) = if step.back { (to, from) } else { (from, to) };
        let map = self.tied(onto * edge.map * inner, [foot, tip], size);
        for piece in std::iter::once(&step.piece).chain(&step.beside) {
            first.push(DirectedMap { from: state, map: *piece });
            last.push(DirectedMap { from: state, map });
        }
        Some(())
    }

    /// The similarity that takes the ends of a state to foot and tip.
    fn onto(&self, state: usize, back: bool) -> Option<Affine2> {
        let [mut first, mut last] = self.ring.ends[state];
        if back {
            std::mem::swap(&mut first, &mut last);
        }
        let (here, there) = (last - first, self.own.tip - self.own.foot);
        // there / here as complex numbers.
        let by = DVec2::new(there.dot(here), here.perp_dot(there)) / here.length_squared();
        let linear = DMat2::from_cols(by, by.perp());
        linear.is_finite().then(|| Affine2::new(linear, self.own.foot - linear * first))
    }

    /// A map with its numbers on a grid, so that it takes the foot and the tip to two points exactly where these are 0
    /// and (0, 1).
    fn tied(&self, map: Affine2, [foot, tip]: [DVec2; 2], size: f64) -> Affine2 {
        if self.own.foot != DVec2::ZERO || self.own.tip != DVec2::Y {
            return map;
        }
        let grid = 2.0_f64.powi(size.max(f64::MIN_POSITIVE).log2().ceil() as i32 - GRID_BITS);
        let on = |v: DVec2| (v / grid).round() * grid;
        let (foot, tip) = (on(foot), on(tip));
        Affine2::new(DMat2::from_cols(on(map.linear.x_axis), tip - foot), foot)
    }
}

/// Numbers of an outline are kept to so many digits.
const GRID_BITS: i32 = 36;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::directed::morph::DirectedMorph;
    use crate::morph::options::Mode;

    /// A fern from 0 to (0, 1) whose leaves stand at the end of its stem, in numbers that doubles hold.
    fn fern() -> DirectedIfs {
        let maps = [
            [0.0, -0.03125, 0.0, 0.125, 0.0, 0.0],
            [0.84375, 0.03125, -0.03125, 0.875, -0.03125, 0.125],
            [0.1875, -0.25, 0.25, 0.1875, -0.03125, 0.125],
            [-0.1875, 0.25, 0.25, 0.1875, -0.03125, 0.125],
        ];
        let maps = maps.map(|row| DirectedMap { from: 0, map: Affine2::from_row(row) });
        DirectedIfs::new(vec![maps.to_vec()]).unwrap()
    }

    /// A polygon: segments from corner to corner.
    fn polygon(corners: &[[f64; 2]]) -> DirectedIfs {
        let corner = |k: usize| DVec2::from_array(corners[k % corners.len()]);
        let edge = |k: usize| {
            let along = corner(k + 1) - corner(k);
            DirectedMap { from: 1, map: Affine2::new(DMat2::from_cols(along, along.perp()), corner(k)) }
        };
        let half = |x: f64| DirectedMap { from: 1, map: Affine2::similitude(0.5, 0.0, DVec2::new(x, 0.0)) };
        let edges: Vec<DirectedMap> = (0..corners.len()).map(edge).collect();
        let halves = vec![half(0.0), half(0.5)];
        if edges.len() <= MAX_MAPS {
            return DirectedIfs::new(vec![edges, halves]).unwrap();
        }
        let parts: Vec<Vec<DirectedMap>> = edges.chunks(50).map(<[DirectedMap]>::to_vec).collect();
        let whole = (0..parts.len()).map(|k| DirectedMap { from: k + 2, map: Affine2::IDENTITY });
        DirectedIfs::new([vec![whole.collect(), halves], parts].concat()).unwrap()
    }

    fn star(count: usize) -> DirectedIfs {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / count as f64;
            (DVec2::from_angle(angle) * if k.is_multiple_of(2) { 1.0 } else { 0.6 }).to_array()
        };
        polygon(&(0..count).map(corner).collect::<Vec<_>>())
    }

    #[test]
    fn a_plant_is_told_from_its_maps() {
        let plant = Plant::of(&fern()).unwrap();
        assert_eq!((plant.foot, plant.tip, plant.parts.len()), (DVec2::ZERO, DVec2::Y, 2));
        assert!(plant.parts.iter().all(|part| part.1));
        // Sierpinski's triangle does not grow from anywhere: its third part is off by a fourth of it.
        let half = |x, y| DirectedMap { from: 0, map: Affine2::similitude(0.5, 0.0, DVec2::new(x, y)) };
        let gasket = DirectedIfs::new(vec![vec![half(0.0, 0.0), half(0.5, 0.0), half(0.25, 0.5)]]).unwrap();
        assert!(Plant::of(&gasket).is_none());
    }

    #[test]
    fn the_way_around_closes_and_both_ends_are_the_shapes() {
        for count in [4, 7, 12, 31, 64, 90] {
            let (plant, outline) = (fern(), star(count));
            let around = Around::of(&plant, &outline).unwrap();
            assert_eq!(around.steps, count.next_multiple_of(2));
            for (states, wanted) in [(&around.plant_maps, &plant), (&around.outline_maps, &outline)] {
                let found = DirectedIfs::new(states.clone()).unwrap();
                let (found, wanted) = (&Hull::of_states(&found)[0], &Hull::of_states(wanted)[0]);
                let off = found.min().distance(wanted.min()).max(found.max().distance(wanted.max()));
                assert!(off < 2e-3, "{count}: {off}");
            }
        }
    }

    #[test]
    fn steps_that_follow_each_other_share_a_point_all_the_way() {
        for outline in [star(16), star(90)] {
            for (from, to) in [(fern(), outline.clone()), (outline.clone(), fern())] {
                let morph = DirectedMorph::new(&from, &to, Mode::Linear).unwrap();
                for k in 0..=8 {
                    let t = f64::from(k) / 8.0;
                    let states = morph.at(t, t);
                    let whole = |part: &DirectedMap| part.map == Affine2::IDENTITY;
                    let parts = if states[0].iter().all(whole) {
                        states[0].iter().flat_map(|part| states[part.from].clone()).collect()
                    } else {
                        states[0].clone()
                    };
                    let ends = |part: &DirectedMap| [DVec2::ZERO, DVec2::Y].map(|p| part.map.apply(p));
                    let all: Vec<[DVec2; 2]> = parts.iter().map(ends).collect();
                    // Each shares a foot or a tip with one before it.
                    for k in 1..all.len() {
                        let near = |[a, b]: &[DVec2; 2]| {
                            [a, b].iter().any(|p| all[k].iter().any(|q| p.distance(*q) < 1e-9))
                        };
                        assert!(all[..k].iter().any(near), "{t}: {k} of {}", all.len());
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_outline_is_matched_otherwise() {
        let square = |x, y| DirectedMap { from: 0, map: Affine2::similitude(0.5, 0.0, DVec2::new(x, y)) };
        let own = DirectedIfs::new(vec![vec![square(0.0, 0.0), square(0.5, 0.0), square(0.0, 0.5)]]).unwrap();
        assert!(Around::of(&fern(), &own).is_none());
        assert!(Around::of(&star(8), &star(8)).is_none());
    }
}
