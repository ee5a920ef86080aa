//! A locus as a landscape to find a way through.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use frond_core::shared::Total;
use glam::DVec3;

use crate::path::distance_transform::distances;
use crate::verdict::{Sample, State};

/// What counts as the gap of a parameter without an attractor: more than any real one, which is below 1.
pub(crate) const GAP_WITHOUT_ATTRACTOR: f64 = 10.0;
/// What counts as the gap of a parameter that was not looked at: a wall to ways, but not broken ground.
pub(crate) const GAP_UNSEEN: f64 = 20.0;
/// Nearer to an end than this, clearance is asked for in proportion only: the ends often lie on the very boundary.
pub(crate) const END_RADIUS: f64 = 0.125;

/// The gap that a sample counts as: 0 where it holds together, gaps up to `epsilon` among it.
pub(crate) fn gap_of(sample: Sample, epsilon: f64) -> f64 {
    let gap = f64::from(sample.gap);
    match sample.state {
        State::Connected | State::Touching => 0.0,
        State::NoAttractor => GAP_WITHOUT_ATTRACTOR,
        _ if gap.is_nan() => GAP_WITHOUT_ATTRACTOR,
        _ if gap <= epsilon => 0.0,
        _ => gap.min(GAP_WITHOUT_ATTRACTOR),
    }
}

/// What a way must keep to: no gap wider than `widest`, and so much [`Field::room`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terms {
    pub widest: f64,
    pub room: f64,
}

/// A box of parameters (u, v, w), sampled evenly; a plane has one layer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lattice {
    pub size: [usize; 3],
    pub low: DVec3,
    pub high: DVec3,
}

impl Lattice {
    /// How far the samples along each axis lie apart, over the least such distance, and that distance itself.
    fn pitch(&self) -> ([f64; 3], f64) {
        let step = |k: usize| ((self.high[k] - self.low[k]) / (self.size[k].max(2) - 1) as f64).abs();
        let steps = [0, 1, 2].map(step);
        let least = (0..3).filter(|&k| self.size[k] > 1 && steps[k] > 0.0).map(|k| steps[k]);
        let least = least.fold(f64::INFINITY, f64::min);
        if least.is_finite() { (steps.map(|s| s / least), least) } else { ([1.0; 3], 1.0) }
    }

    pub fn count(&self) -> usize {
        self.size[0] * self.size[1] * self.size[2]
    }

    /// The column, row and layer of a cell.
    pub fn place(&self, cell: usize) -> DVec3 {
        let [width, height, _] = self.size;
        DVec3::new((cell % width) as f64, (cell / width % height) as f64, (cell / width / height) as f64)
    }

    /// The cell at fractions of samples; those outside have none.
    pub fn cell(&self, place: DVec3) -> Option<usize> {
        let [x, y, z] = place.round().to_array();
        let [width, height, depth] = self.size.map(|n| n as f64);
        let inside = x >= 0.0 && y >= 0.0 && z >= 0.0 && x < width && y < height && z < depth;
        inside.then(|| (z as usize * self.size[1] + y as usize) * self.size[0] + x as usize)
    }

    /// The parameter at fractions of samples.
    pub fn parameter(&self, place: DVec3) -> DVec3 {
        let along = |k: usize| {
            let last = (self.size[k].max(2) - 1) as f64;
            if place[k] == last {
                self.high[k]
            } else {
                self.low[k] + (self.high[k] - self.low[k]) * place[k] / last
            }
        };
        DVec3::new(along(0), along(1), along(2))
    }

    /// The fractions of samples of a parameter: NaN along a side without extent where it lies beside it.
    pub fn fraction(&self, at: DVec3) -> DVec3 {
        let along = |k: usize| {
            let t = (at[k] - self.low[k]) / (self.high[k] - self.low[k]);
            if self.size[k] == 1 && k == 2 {
                0.0
            } else if !(-1e-9..=1.0 + 1e-9).contains(&t) {
                f64::NAN
            } else {
                t * (self.size[k] - 1) as f64
            }
        };
        DVec3::new(along(0), along(1), along(2))
    }

    /// The up to 26 neighbours of a cell and how far they are, in steps.
    pub fn neighbours(&self, cell: usize) -> impl Iterator<Item = (usize, [bool; 3])> + use<> {
        let [width, height, depth] = self.size;
        let (x, y, z) = (cell % width, cell / width % height, cell / width / height);
        let around = |at: usize, size: usize| at.saturating_sub(1)..=(at + 1).min(size - 1);
        around(z, depth)
            .flat_map(move |layer| around(y, height).map(move |row| (layer, row)))
            .flat_map(move |(layer, row)| around(x, width).map(move |column| (layer, row, column)))
            .filter(move |&at| at != (z, y, x))
            .map(move |(layer, row, column)| {
                ((layer * height + row) * width + column, [column != x, row != y, layer != z])
            })
    }
}

/// The gaps over a lattice, and how far each sample is from the nearest broken one.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    pub lattice: Lattice,
    pub ends: [usize; 2],
    /// How far samples lie apart along each axis, in units of the finest.
    pitch: [f64; 3],
    /// That unit, in parameters.
    unit: f64,
    /// The relative gap of each sample: 0 where it holds together.
    gap: Vec<f64>,
    /// The distance to the nearest broken sample, in units.
    clearance: Vec<f64>,
    /// The clearance above which more is no better.
    ample: f64,
}

impl Field {
    /// The field of these gaps; `ends` are the cells that a way starts from and leads to.
    pub fn new(lattice: Lattice, gap: Vec<f64>, ends: [usize; 2]) -> Self {
        let (pitch, unit) = lattice.pitch();
        let side = lattice.size.into_iter().max().unwrap_or(1) as f64;
        let mut field = Self { lattice, ends, pitch, unit, gap, clearance: Vec::new(), ample: side / 12.0 };
        field.measure();
        field
    }

    fn measure(&mut self) {
        let gap = &self.gap;
        self.clearance =
            distances(self.lattice.size, self.pitch, |cell| gap[cell] > 0.0 && gap[cell] < GAP_UNSEEN);
    }

    /// Takes cells for broken by `gap` that were found so between the samples.
    pub fn mark(&mut self, cells: &[usize], gap: f64) {
        for &cell in cells {
            self.gap[cell] = self.gap[cell].max(gap.min(GAP_WITHOUT_ATTRACTOR));
        }
        self.measure();
    }

    /// The cell to keep off where `at` is broken: the nearest, unless that is an end, which no way can avoid; then
    /// the neighbour of it that lies towards `at`.
    pub fn culprit(&self, at: DVec3) -> Option<usize> {
        let place = self.lattice.fraction(at);
        let cell = self.lattice.cell(place)?;
        if !self.ends.contains(&cell) {
            return Some(cell);
        }
        let away = place - self.lattice.place(cell);
        let towards =
            |next: usize| (self.lattice.place(next) - self.lattice.place(cell)).normalize().dot(away);
        let next =
            self.lattice.neighbours(cell).map(|(next, _)| next).filter(|next| !self.ends.contains(next));
        next.max_by(|&a, &b| towards(a).total_cmp(&towards(b)))
    }

    /// The samples along the longest side.
    pub fn side(&self) -> f64 {
        self.lattice.size.into_iter().max().unwrap_or(1) as f64
    }

    /// The widest gap of the samples around a place: one on a sample, two on a line of the grid, else four or eight.
    pub fn gap_around(&self, place: DVec3) -> f64 {
        let (low, high) = (place.floor(), place.ceil());
        let mut widest: f64 = 0.0;
        for corner in 0..8 {
            let pick = |k: usize| if corner >> k & 1 == 0 { low[k] } else { high[k] };
            let repeated = (0..3).any(|k| corner >> k & 1 == 1 && low[k] == high[k]);
            if !repeated {
                let cell = self.lattice.cell(DVec3::new(pick(0), pick(1), pick(2)));
                widest = widest.max(cell.map_or(GAP_UNSEEN, |cell| self.gap[cell]));
            }
        }
        widest
    }

    /// The gap of the nearest sample.
    pub fn gap_at(&self, at: DVec3) -> f64 {
        self.lattice.cell(self.lattice.fraction(at)).map_or(0.0, |cell| self.gap[cell])
    }

    /// How far samples lie apart, in parameters.
    pub fn step(&self) -> f64 {
        self.unit
    }

    /// The distance from the nearest broken sample to a cell, in parameters.
    pub fn clearance(&self, cell: usize) -> f64 {
        self.clearance[cell] * self.unit
    }

    /// How roomy a cell is, in units: its clearance, for which less counts as more near the ends.
    pub fn room(&self, cell: usize) -> f64 {
        let scale = DVec3::from_array(self.pitch);
        let place = self.lattice.place(cell);
        let end = self.ends.map(|end| ((self.lattice.place(end) - place) * scale).length());
        let end = end[0].min(end[1]);
        if end <= 3.0 {
            return self.ample;
        }
        let part = (end * self.unit / END_RADIUS).min(1.0);
        (self.clearance[cell] / part).min(self.ample)
    }

    /// What a step of length 1 costs at a cell: 1 far from everything broken, more near it, much more on it
    /// and in proportion to the gap.
    pub fn price(&self, cell: usize) -> f64 {
        let gap = self.gap[cell];
        if gap > 0.0 {
            return 40.0 + 400.0 * gap;
        }
        let near = (1.0 - self.clearance[cell] / self.ample).max(0.0);
        1.0 + 3.0 * near * near + 6.0 / (self.clearance[cell] * self.clearance[cell]).max(1.0)
    }

    /// The gap that a step between neighbours meets: a diagonal one squeezes past others, and needs one way of
    /// straight steps that is whole.
    pub fn step_gap(&self, from: usize, to: usize) -> f64 {
        let ends = self.gap[from].max(self.gap[to]);
        let (p, q) = (self.lattice.place(from), self.lattice.place(to));
        let differing = (0..3).filter(|&k| p[k] != q[k]);
        if differing.clone().count() < 2 {
            return ends;
        }
        let by = differing.map(|k| {
            let mut corner = p;
            corner[k] = q[k];
            self.lattice
                .cell(corner)
                .map_or(GAP_UNSEEN, |corner| self.gap[corner].max(self.step_gap(corner, to)))
        });
        ends.max(by.fold(f64::INFINITY, f64::min))
    }

    /// Whether a way on these terms may take a step between neighbours.
    pub fn allows(&self, from: usize, to: usize, terms: Terms) -> bool {
        self.step_gap(from, to) <= terms.widest && self.room(to) >= terms.room
    }

    /// The widest gap that must be met between the ends, at least.
    pub fn widest(&self) -> f64 {
        self.bottleneck(self.gap[self.ends[0]], |from, to| self.step_gap(from, to))
    }

    /// The most room that a way between the ends can have all along, where it meets no gap wider than `widest`.
    pub fn roomiest(&self, widest: f64) -> f64 {
        let step = |from: usize, to: usize| {
            if self.step_gap(from, to) > widest { f64::INFINITY } else { -self.room(from).min(self.room(to)) }
        };
        -self.bottleneck(-self.ample, step)
    }

    /// The least over all ways between the ends of the greatest `value` of their steps, and `start` at least.
    fn bottleneck(&self, start: f64, value: impl Fn(usize, usize) -> f64) -> f64 {
        let [from, to] = self.ends;
        let mut worst = vec![f64::INFINITY; self.gap.len()];
        let mut heap = BinaryHeap::from([Reverse((Total(start), from))]);
        worst[from] = start;
        while let Some(Reverse((Total(cost), cell))) = heap.pop() {
            if cell == to {
                return cost;
            }
            if cost > worst[cell] {
                continue;
            }
            for (next, _) in self.lattice.neighbours(cell) {
                // Nothing is won by looking at a step that starts no better than where it leads.
                if worst[next] <= cost {
                    continue;
                }
                let through = cost.max(value(cell, next));
                if through < worst[next] {
                    worst[next] = through;
                    heap.push(Reverse((Total(through), next)));
                }
            }
        }
        f64::INFINITY
    }

    /// The cheapest way between the ends on these terms; empty if there is none.
    pub fn cheapest(&self, terms: Terms) -> Vec<usize> {
        let [from, to] = self.ends;
        let mut cost = vec![f64::INFINITY; self.gap.len()];
        let mut before: Vec<usize> = (0..self.gap.len()).collect();
        let mut heap = BinaryHeap::from([Reverse((Total(0.0), from))]);
        cost[from] = 0.0;
        while let Some(Reverse((Total(so_far), cell))) = heap.pop() {
            if cell == to {
                break;
            }
            if so_far > cost[cell] {
                continue;
            }
            for (next, moved) in self.lattice.neighbours(cell) {
                if so_far >= cost[next] || !self.allows(cell, next, terms) {
                    continue;
                }
                let step = (0..3).filter(|&k| moved[k]).map(|k| self.pitch[k].powi(2)).sum::<f64>().sqrt();
                let total = so_far + step * 0.5 * (self.price(cell) + self.price(next));
                if total < cost[next] {
                    cost[next] = total;
                    before[next] = cell;
                    heap.push(Reverse((Total(total), next)));
                }
            }
        }
        if cost[to].is_infinite() {
            return Vec::new();
        }
        let mut way = vec![to];
        while way[way.len() - 1] != from {
            way.push(before[way[way.len() - 1]]);
        }
        way.reverse();
        way
    }
}
