//! A way through three parameters, where the plane has none.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use frond_core::shared::{Ranked, Total};
use frond_core::{Affine2, Morph};
use glam::DVec3;

use crate::decide::{Scratch, decide};
use crate::grid::LocusGrid;
use crate::path::field::{Field, GAP_UNSEEN, Lattice, gap_of};
use crate::path::plan::{ENDS, PathPlan};
use crate::path::repair::{LEAST_CHECKS, improve};

/// The steps to the unit of the lattices that are looked through, one after the other.
const STEPS_PER_UNIT: [usize; 2] = [8, 16];
/// Above so many maps only the first is.
const MOST_MAPS_FOR_FINE: usize = 16;
/// How many ways are looked for in each of them.
const MOST_WAYS: usize = 4;
/// How far round a coarse way is looked at finely, in fine steps.
const TUBE_RADIUS: f64 = 3.0;

/// Looks for a path from the first shape to the last through (u, v, w), w in [-1, 1]: that of least widest gap over a
/// coarse lattice, looked at again in a finer tube around it, and checked between the samples of that. A part at a
/// time.
#[derive(Clone, Debug)]
pub(crate) struct VolumeSearch {
    /// The lattices that are still to be looked through.
    steps: std::slice::Iter<'static, usize>,
    space: Option<Space>,
    /// How many ways were looked for in this lattice, and whether the first of them was broken.
    ways: usize,
    apart: bool,
    best: Option<PathPlan>,
}

impl VolumeSearch {
    pub(crate) fn new() -> Self {
        Self { steps: STEPS_PER_UNIT.iter(), space: None, ways: 0, apart: false, best: None }
    }

    /// Decides so many parameters of a lattice, or looks closely at the way that was found in it. The plan, once it is
    /// known.
    pub(crate) fn step(&mut self, morph: &Morph, epsilon: f64, decisions: usize) -> Option<PathPlan> {
        let Some(mut space) = self.space.take().or_else(|| self.next_space(morph, epsilon)) else {
            return Some(self.best.take().unwrap_or_else(straight));
        };
        let Some((gap, way)) = space.search(decisions) else {
            self.space = Some(space);
            return None;
        };
        if self.ways == 0 {
            self.apart = gap > 0.0;
        }
        self.ways += 1;
        let mut field = space.tube(&way);
        let checks = LEAST_CHECKS.max(64 * space.steps);
        let mut tried = improve(morph, &mut field, epsilon, checks, 4);
        tried.plan.apart = self.apart && !tried.plan.holds;
        tried.plan.step = 1.0 / space.steps as f64;
        let parameter = |cell| field.lattice.parameter(field.lattice.place(cell));
        let marked: Vec<DVec3> = tried.marked.iter().map(|&cell| parameter(cell)).collect();
        let done = tried.plan.holds || tried.final_word || marked.is_empty() || self.ways == MOST_WAYS;
        let worst = tried.plan.gap;
        if self.best.as_ref().is_none_or(|best| tried.plan.gap < best.gap) {
            self.best = Some(tried.plan);
        }
        if !done {
            space.mark(&marked, worst);
            self.space = Some(space);
        }
        None
    }

    /// The next lattice, unless there is a path that holds, or the last was.
    fn next_space(&mut self, morph: &Morph, epsilon: f64) -> Option<Space> {
        // The decisions for many maps take long.
        let enough = |best: &PathPlan| best.holds || morph.len() > MOST_MAPS_FOR_FINE;
        if self.best.as_ref().is_some_and(enough) {
            return None;
        }
        self.ways = 0;
        self.steps.next().map(|&steps| Space::new(morph.clone(), epsilon, steps))
    }
}

fn straight() -> PathPlan {
    PathPlan {
        points: ENDS.to_vec(),
        gap: f64::INFINITY,
        holds: false,
        clearance: 0.0,
        worst: None,
        apart: true,
        step: 1.0,
    }
}

/// The box of parameters that is looked through, and what is known of it.
#[derive(Clone, Debug)]
struct Space {
    morph: Morph,
    epsilon: f64,
    steps: usize,
    lattice: Lattice,
    /// NaN where nobody has looked.
    gap: Vec<f64>,
    ends: [usize; 2],
    scratch: Scratch,
    maps: Vec<Affine2>,
}

impl Space {
    fn new(morph: Morph, epsilon: f64, steps: usize) -> Self {
        let lattice = lattice(steps);
        Self {
            morph,
            epsilon,
            steps,
            lattice,
            gap: vec![f64::NAN; lattice.count()],
            ends: ends(&lattice),
            scratch: Scratch::default(),
            maps: Vec::new(),
        }
    }

    fn decide(&mut self, at: DVec3) -> f64 {
        self.morph.fill3(at.x, at.y, at.z, &mut self.maps);
        let budget = LocusGrid::budget(self.maps.len());
        gap_of(decide(&self.maps, self.epsilon, budget, &mut self.scratch), self.epsilon)
    }

    fn gap(&mut self, cell: usize) -> f64 {
        if self.gap[cell].is_nan() {
            self.gap[cell] = self.decide(self.lattice.parameter(self.lattice.place(cell)));
        }
        self.gap[cell]
    }

    /// Takes the cells next to these parameters for broken, but for the ends.
    fn mark(&mut self, broken: &[DVec3], gap: f64) {
        for &at in broken {
            if let Some(cell) =
                self.lattice.cell(self.lattice.fraction(at)).filter(|c| !self.ends.contains(c))
            {
                self.gap[cell] = self.gap(cell).max(gap.min(crate::path::field::GAP_WITHOUT_ATTRACTOR));
            }
        }
    }

    /// A way of least widest gap, and that gap. The frontier is a heap by the widest gap so far, then by length so far
    /// and to go, and a parameter is decided when its turn comes: where the way is open, few are. Nothing once so many
    /// parameters have been decided: what they said is kept, and the next search comes further.
    fn search(&mut self, mut decisions: usize) -> Option<(f64, Vec<usize>)> {
        let [from, to] = self.ends;
        let goal = self.lattice.place(to);
        let count = self.gap.len();
        let mut before: Vec<usize> = (0..count).collect();
        let mut reached = vec![(f64::INFINITY, f64::INFINITY); count];
        let mut settled = vec![false; count];
        // Cells to come to, the least gap and then the least estimate first: with what each costs and where from.
        let mut heap =
            BinaryHeap::from([Ranked { key: Reverse((Total(0.0), Total(0.0), from)), item: (0.0, from) }]);
        while let Some(step) = heap.pop() {
            let Ranked { key: Reverse((Total(widest), estimate, cell)), item: (so_far, last) } = step;
            if settled[cell] {
                continue;
            }
            if self.gap[cell].is_nan() {
                if decisions == 0 {
                    return None;
                }
                decisions -= 1;
            }
            let own = self.gap(cell);
            if own > widest {
                heap.push(Ranked { key: Reverse((Total(own), estimate, cell)), ..step });
                continue;
            }
            settled[cell] = true;
            before[cell] = last;
            if cell == to {
                let mut way = vec![to];
                while way[way.len() - 1] != from {
                    way.push(before[way[way.len() - 1]]);
                }
                way.reverse();
                return Some((widest, way));
            }
            let here = self.lattice.place(cell);
            for (next, _) in self.lattice.neighbours(cell) {
                if settled[next] {
                    continue;
                }
                let there = self.lattice.place(next);
                // A little dearer off the plane w = 0, to which a way returns where it can.
                let off = self.lattice.parameter(there).z.abs();
                let cost = so_far + here.distance(there) * (1.0 + 0.25 * off);
                let gap = if self.gap[next] > widest { self.gap[next] } else { widest };
                if (gap, cost) < reached[next] {
                    reached[next] = (gap, cost);
                    let estimate = Total(cost + there.distance(goal));
                    heap.push(Ranked { key: Reverse((Total(gap), estimate, next)), item: (cost, cell) });
                }
            }
        }
        Some((f64::INFINITY, self.ends.to_vec()))
    }

    /// A lattice of half the step, decided around a way.
    fn tube(&mut self, way: &[usize]) -> Field {
        let fine = lattice(2 * self.steps);
        let mut gap = vec![GAP_UNSEEN; fine.count()];
        let ends = ends(&fine);
        let reach = TUBE_RADIUS as i32;
        for (k, &cell) in way.iter().enumerate() {
            let here = 2.0 * self.lattice.place(cell);
            let next = 2.0 * self.lattice.place(way[(k + 1).min(way.len() - 1)]);
            for middle in [here, 0.5 * (here + next)] {
                for shift in (-reach..=reach).flat_map(|z| {
                    (-reach..=reach).flat_map(move |y| (-reach..=reach).map(move |x| [x, y, z]))
                }) {
                    let place = middle + DVec3::from_array(shift.map(f64::from));
                    if place.distance(middle) > TUBE_RADIUS {
                        continue;
                    }
                    if let Some(cell) = fine.cell(place).filter(|&cell| gap[cell] >= GAP_UNSEEN) {
                        gap[cell] = self.decide(fine.parameter(place));
                    }
                }
            }
        }
        Field::new(fine, gap, ends)
    }
}

/// u and v from -1 to 2, w from -1 to 1, so many steps to the unit.
fn lattice(steps: usize) -> Lattice {
    Lattice {
        size: [3 * steps + 1, 3 * steps + 1, 2 * steps + 1],
        low: DVec3::NEG_ONE,
        high: DVec3::new(2.0, 2.0, 1.0),
    }
}

/// The cells of the ends.
fn ends(lattice: &Lattice) -> [usize; 2] {
    // They are on the lattice.
    ENDS.map(|end| lattice.cell(lattice.fraction(end)).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use frond_core::MorphOptions;

    use super::*;

    fn morph(ratio: f64) -> Morph {
        let maps = |ratio: f64, angle: f64| {
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.8]].map(glam::DVec2::from_array);
            corners.map(|corner| Affine2::similitude(ratio, angle, (1.0 - ratio) * corner))
        };
        Morph::new(&maps(0.5, 0.0), &maps(ratio, 2.5), &MorphOptions::default()).unwrap()
    }

    #[test]
    fn no_way_over_the_lattice_has_a_smaller_gap_than_the_one_found() {
        let morph = morph(0.5);
        for seed in 0..30 {
            let mut space = Space::new(morph.clone(), 1e-3, 2);
            for cell in 0..space.gap.len() {
                // Most of the lattice is broken, so that the ways are few.
                let drawn = f64::from(frond_core::hash::counter(seed, cell as u32) % 1000) / 1000.0;
                space.gap[cell] = if drawn < 0.05 || space.ends.contains(&cell) { 0.0 } else { drawn };
            }
            let all = space.gap.clone();
            let (gap, way) = space.search(usize::MAX).unwrap();
            assert_eq!(way.iter().map(|&cell| all[cell]).fold(0.0, f64::max), gap);
            let touching = |a: usize, b: usize| space.lattice.neighbours(a).any(|(next, _)| next == b);
            assert!(way.windows(2).all(|two| touching(two[0], two[1])));
            assert_eq!([way[0], way[way.len() - 1]], space.ends);
            // Everything that can be reached over smaller gaps only.
            let mut seen = vec![false; all.len()];
            let mut open = vec![space.ends[0]];
            while let Some(cell) = open.pop() {
                if all[cell] < gap && !std::mem::replace(&mut seen[cell], true) {
                    open.extend(space.lattice.neighbours(cell).map(|(next, _)| next));
                }
            }
            assert!(!seen[space.ends[1]], "{seed}: {gap}");
        }
    }

    #[test]
    fn a_search_in_parts_finds_what_it_finds_at_once() {
        let morph = morph(0.55);
        let whole = Space::new(morph.clone(), 1e-2, 4).search(usize::MAX);
        let mut space = Space::new(morph, 1e-2, 4);
        let mut parts = 0;
        let found = loop {
            parts += 1;
            if let Some(found) = space.search(10) {
                break found;
            }
        };
        assert!(parts > 3, "{parts}");
        assert_eq!(Some(found), whole);
    }

    #[test]
    fn where_the_way_is_open_few_parameters_are_decided() {
        let morph = morph(0.62);
        let mut space = Space::new(morph, 1e-2, 8);
        let (gap, way) = space.search(usize::MAX).unwrap();
        let decided = space.gap.iter().filter(|gap| !gap.is_nan()).count();
        assert!(gap == 0.0 && decided < space.gap.len() / 4, "{gap} {decided} {}", way.len());
    }
}
