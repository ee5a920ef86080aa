//! A locus as a landscape to find a way through.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::decide::State;
use crate::grid::Locus;

/// What counts as the gap of a parameter without an attractor: more than any real one, which is below 1.
const WALL: f64 = 10.0;

/// A cell of a heap ordered by cost, the least first.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Reached {
    cost: f64,
    cell: usize,
}
impl Eq for Reached {}
impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then_with(|| other.cell.cmp(&self.cell))
    }
}

/// The gaps of a locus and how far each sample is from the nearest broken one.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    width: usize,
    height: usize,
    /// The relative gap of each sample: 0 where it holds together.
    gap: Vec<f64>,
    /// The distance to the nearest broken sample, in samples, in steps along rows, columns and diagonals.
    clearance: Vec<f64>,
    /// The clearance above which more is no better.
    ample: f64,
}

impl Field {
    /// Gaps up to `epsilon` count as none.
    pub fn of(locus: &Locus, epsilon: f64) -> Self {
        let (width, height) = (locus.grid().width(), locus.grid().height());
        let gap = (0..width * height).map(|i| {
            let sample = locus.sample(i % width, i / width);
            match sample.state {
                State::Connected | State::Touching => 0.0,
                State::NoAttractor => WALL,
                _ if sample.gap.is_nan() => WALL,
                _ if f64::from(sample.gap) <= epsilon => 0.0,
                _ => f64::from(sample.gap),
            }
        });
        let gap: Vec<f64> = gap.collect();
        let mut field =
            Self { width, height, clearance: Vec::new(), gap, ample: width.max(height) as f64 / 12.0 };
        field.measure_clearance();
        field
    }

    fn measure_clearance(&mut self) {
        let broken = (0..self.gap.len()).filter(|&i| self.gap[i] > 0.0).map(|i| (i, 0.0));
        self.clearance = self.spread(broken.collect(), |_, _, step| step).0;
    }

    /// Takes cells for broken by `gap` that were found so between the samples.
    pub fn mark(&mut self, cells: impl Iterator<Item = usize>, gap: f64) {
        for cell in cells {
            self.gap[cell] = self.gap[cell].max(gap.min(WALL));
        }
        self.measure_clearance();
    }

    /// The samples along the longer side.
    pub fn side(&self) -> f64 {
        self.width.max(self.height) as f64
    }

    /// The cell of a column and a row, counted in fractions of samples; those outside have none.
    pub fn cell(&self, x: f64, y: f64) -> Option<usize> {
        let (column, row) = (x.round(), y.round());
        let inside = column >= 0.0 && row >= 0.0 && column < self.width as f64 && row < self.height as f64;
        inside.then(|| row as usize * self.width + column as usize)
    }

    /// The widest gap of the samples around a place: one on a sample, two on a line of the grid, else four.
    pub fn gap_around(&self, x: f64, y: f64) -> f64 {
        let corners =
            [(x.floor(), y.floor()), (x.ceil(), y.floor()), (x.floor(), y.ceil()), (x.ceil(), y.ceil())];
        let gap = |(x, y)| self.cell(x, y).map_or(WALL, |cell| self.gap[cell]);
        corners.into_iter().map(gap).fold(0.0, f64::max)
    }

    /// The column and the row of a cell.
    pub fn place(&self, cell: usize) -> (f64, f64) {
        ((cell % self.width) as f64, (cell / self.width) as f64)
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

    /// The gap that a step between neighbours meets: a diagonal one squeezes past two others, and needs one
    /// of them whole.
    pub fn step_gap(&self, from: usize, to: usize) -> f64 {
        let ends = self.gap[from].max(self.gap[to]);
        let (fx, fy, tx, ty) = (from % self.width, from / self.width, to % self.width, to / self.width);
        if fx == tx || fy == ty {
            return ends;
        }
        ends.max(self.gap[fy * self.width + tx].min(self.gap[ty * self.width + fx]))
    }

    /// The widest gap that must be met between two cells, at least.
    pub fn widest(&self, from: usize, to: usize) -> f64 {
        let mut worst = vec![f64::INFINITY; self.gap.len()];
        let mut heap = BinaryHeap::from([Reached { cost: self.gap[from], cell: from }]);
        worst[from] = self.gap[from];
        while let Some(Reached { cost, cell }) = heap.pop() {
            if cell == to {
                return cost;
            }
            if cost > worst[cell] {
                continue;
            }
            for (next, _) in self.neighbours(cell) {
                let through = cost.max(self.step_gap(cell, next));
                if through < worst[next] {
                    worst[next] = through;
                    heap.push(Reached { cost: through, cell: next });
                }
            }
        }
        f64::INFINITY
    }

    /// The cheapest way between two cells that meets no gap wider than `widest`; empty if there is none.
    pub fn cheapest(&self, from: usize, to: usize, widest: f64) -> Vec<usize> {
        let price = |cell: usize, next: usize, step: f64| {
            if self.step_gap(cell, next) > widest {
                f64::INFINITY
            } else {
                step * 0.5 * (self.price(cell) + self.price(next))
            }
        };
        let (cost, before) = self.spread(vec![(from, 0.0)], price);
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

    /// Dijkstra's algorithm from some cells on: the cost of each cell and the one before it.
    fn spread(
        &self,
        start: Vec<(usize, f64)>,
        price: impl Fn(usize, usize, f64) -> f64,
    ) -> (Vec<f64>, Vec<usize>) {
        let mut cost = vec![f64::INFINITY; self.gap.len()];
        let mut before: Vec<usize> = (0..self.gap.len()).collect();
        let mut heap = BinaryHeap::new();
        for (cell, at) in start {
            cost[cell] = at;
            heap.push(Reached { cost: at, cell });
        }
        while let Some(Reached { cost: so_far, cell }) = heap.pop() {
            if so_far > cost[cell] {
                continue;
            }
            for (next, step) in self.neighbours(cell) {
                let total = so_far + price(cell, next, step);
                if total < cost[next] {
                    cost[next] = total;
                    before[next] = cell;
                    heap.push(Reached { cost: total, cell: next });
                }
            }
        }
        (cost, before)
    }

    /// The up to eight neighbours of a cell and how far they are.
    fn neighbours(&self, cell: usize) -> impl Iterator<Item = (usize, f64)> + use<> {
        let (width, height) = (self.width, self.height);
        let (x, y) = (cell % width, cell / width);
        let rows = y.saturating_sub(1)..=(y + 1).min(height - 1);
        rows.flat_map(move |row| {
            let columns = x.saturating_sub(1)..=(x + 1).min(width - 1);
            columns.filter(move |&column| (column, row) != (x, y)).map(move |column| {
                let step = if column == x || row == y { 1.0 } else { std::f64::consts::SQRT_2 };
                (row * width + column, step)
            })
        })
    }
}
