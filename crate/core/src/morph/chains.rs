//! Chains of pieces: in which orders the maps of a system, each in one of its variants, lead from one point to another.

use std::collections::HashMap;

use glam::DVec2;

use crate::linear::affine::Affine2;

/// Points are one if they are no further apart, in proportion to the shape.
const SAME_POINT: f64 = 1e-9;
/// The most pairs of ends that are tried.
const MOST_ENDS: usize = 4000;
/// The most steps of the search for chains with given ends.
const MOST_STEPS: usize = 2000;

/// Pairs of points that may be the ends: the start is a piece's own start or its end, and so is the end.
pub(crate) fn ends(variants: &[Vec<Affine2>]) -> Vec<[DVec2; 2]> {
    let mut found = Vec::new();
    let count = variants.len();
    for (i, j) in (0..count * count).map(|k| (k / count, k % count)).filter(|(i, j)| i != j) {
        for first in &variants[i] {
            for last in &variants[j] {
                let mut offer = |s: Option<DVec2>, e: &dyn Fn(DVec2) -> Option<DVec2>| {
                    let Some(s) = s else { return };
                    let Some(e) = e(s) else { return };
                    if s.is_finite() && e.is_finite() && s != e && found.len() < MOST_ENDS {
                        found.push([s, e]);
                    }
                };
                offer(first.fixed_point(), &|_| last.fixed_point());
                offer(first.fixed_point(), &|s| Some(last.apply(s)));
                offer((*first * *last).fixed_point(), &|s| Some(last.apply(s)));
            }
        }
    }
    found
}

/// Points told apart in proportion to the distance of two of them.
pub(crate) struct Grid {
    origin: DVec2,
    unit: f64,
}

impl Grid {
    pub fn new([s, e]: [DVec2; 2]) -> Self {
        Self { origin: s, unit: s.distance(e).max(f64::MIN_POSITIVE) }
    }

    pub fn same(&self, p: DVec2, q: DVec2) -> bool {
        p.distance(q) <= SAME_POINT * self.unit
    }

    /// A small square of the plane: a point that is the same lies in it or in one beside it.
    pub fn key(&self, p: DVec2) -> [i64; 2] {
        ((p - self.origin) * (1e7 / self.unit)).round().to_array().map(|x| x as i64)
    }
}

/// A step of a chain: by this map, in this variant, from its start or from its end.
#[derive(Clone, Copy)]
pub(crate) struct Step {
    pub map: usize,
    pub with: Affine2,
    pub reversed: bool,
    to: DVec2,
}

/// At most so many chains through all maps from the start to the end; `left` steps may be taken, and fewer are then
/// left.
pub(crate) fn chains(
    variants: &[Vec<Affine2>],
    [s, e]: [DVec2; 2],
    most: usize,
    left: &mut usize,
) -> Vec<Vec<Step>> {
    let grid = Grid::new([s, e]);
    let mut steps: HashMap<[i64; 2], Vec<Step>> = HashMap::new();
    for (map, all) in variants.iter().enumerate() {
        for &with in all {
            let (p, q) = (with.apply(s), with.apply(e));
            for (from, to, reversed) in [(p, q, false), (q, p, true)] {
                let here = steps.entry(grid.key(from)).or_default();
                let known = here
                    .iter()
                    .any(|step| step.map == map && step.reversed == reversed && grid.same(step.to, to));
                if !known {
                    here.push(Step { map, with, reversed, to });
                }
            }
        }
    }
    let allowed = MOST_STEPS.min(*left);
    let mut search = Search { steps, grid, end: e, used: vec![false; variants.len()], left: allowed };
    let mut found = Vec::new();
    search.go(s, &mut Vec::new(), &mut found, most);
    *left -= allowed - search.left;
    found
}

struct Search {
    steps: HashMap<[i64; 2], Vec<Step>>,
    grid: Grid,
    end: DVec2,
    used: Vec<bool>,
    left: usize,
}

impl Search {
    fn go(&mut self, at: DVec2, way: &mut Vec<Step>, found: &mut Vec<Vec<Step>>, most: usize) {
        if way.len() == self.used.len() {
            if self.grid.same(at, self.end) {
                found.push(way.clone());
            }
            return;
        }
        let [x, y] = self.grid.key(at);
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [x.saturating_add(i), y.saturating_add(j)]));
        let next: Vec<Step> = around.filter_map(|key| self.steps.get(&key)).flatten().copied().collect();
        for step in next {
            if self.left == 0 || found.len() >= most {
                return;
            }
            let from = step.with.apply(if step.reversed { self.end } else { self.grid.origin });
            if self.used[step.map] || !self.grid.same(from, at) {
                continue;
            }
            self.left -= 1;
            self.used[step.map] = true;
            way.push(step);
            self.go(step.to, way, found, most);
            way.pop();
            self.used[step.map] = false;
        }
    }
}
