//! The two passes of counting.

use std::sync::Arc;

use super::cluster::{Cluster, peaks};
use super::features::Features;
use super::options::{BINS, HoughOptions, MAX_CELLS, PLANE};
use super::pairing::{Buffers, CELLS, Listener, Pairing, Row};
use super::share::gather;

/// A step ends after so many votes.
const VOTES_A_STEP: u64 = 1 << 21;

/// How far counting has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoughProgress {
    /// From 0 to 1; it never falls.
    pub share: f64,
    /// Candidate maps so far, in the first pass.
    pub votes: u64,
}

/// Where a pass is: widths of domains, and lengths of ranges within.
#[derive(Clone, Debug)]
struct Cursor {
    width: usize,
    length: usize,
    part: (usize, usize),
    whole: f64,
    done: f64,
    votes: u64,
}

impl Cursor {
    fn new(pairing: &Pairing, (part, parts): (usize, usize)) -> Self {
        let parts = parts.max(1);
        let whole = pairing.widths().map(|w| pairing.work(w)).sum();
        Self { width: 2, length: 2, part: (part % parts, parts), whole, done: 0.0, votes: 0 }
    }

    fn step(&mut self, pairing: &Pairing, room: &mut Buffers, to: &mut impl Listener) -> HoughProgress {
        let (until, mut units) = (self.votes + VOTES_A_STEP, 0);
        // Units without votes cost something, too.
        while !self.is_done(pairing) && self.votes < until && units < 1 << 14 {
            self.votes += pairing.pair([self.width, self.length], self.part, room, to);
            self.length += 1;
            units += 1;
            if self.length >= pairing.lengths().end {
                self.done += pairing.work(self.width);
                self.length = 2;
                self.width += 1;
            }
        }
        let share = if self.is_done(pairing) { 1.0 } else { (self.done / self.whole).min(1.0) };
        HoughProgress { share, votes: self.votes }
    }

    fn is_done(&self, pairing: &Pairing) -> bool {
        self.width >= pairing.widths().end || pairing.lengths().is_empty()
    }
}

/// The first pass: hits of (a, b, c), in 8 MiB.
#[derive(Clone, Debug)]
pub struct FirstPass {
    pairing: Arc<Pairing>,
    cursor: Cursor,
    room: Buffers,
    hits: Hits,
}

#[derive(Clone, Debug)]
struct Hits(Vec<u32>);

impl Listener for Hits {
    fn wants(&self, _: usize) -> bool {
        true
    }

    fn take(&mut self, row: &Row) {
        for &cell in row.cells {
            if let Some(count) = self.0.get_mut(cell as usize) {
                *count += 1;
            }
        }
    }
}

impl FirstPass {
    /// The share `part.0` of `part.1` of the domain triples.
    #[must_use]
    pub fn new(coarse: &Features, fine: &Features, options: HoughOptions, part: (usize, usize)) -> Self {
        let pairing = Arc::new(Pairing::new(coarse, fine, options));
        let cursor = Cursor::new(&pairing, part);
        // One more for votes that are outside.
        Self { pairing, cursor, room: Buffers::default(), hits: Hits(vec![0; CELLS + 1]) }
    }

    pub(crate) fn pairing(&self) -> &Arc<Pairing> {
        &self.pairing
    }

    /// Goes one step on, of some milliseconds.
    pub fn step(&mut self) -> HoughProgress {
        self.cursor.step(&self.pairing, &mut self.room, &mut self.hits)
    }

    /// Whether all is counted.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.cursor.is_done(&self.pairing)
    }

    /// Hits of the cell of bins a, b, c at (a * 128 + b) * 128 + c; bin 64 is zero.
    #[must_use]
    pub fn counts(&self) -> &[u32] {
        &self.hits.0[..CELLS]
    }

    /// Adds the counts of another share; longer or shorter lists as far as they go.
    pub fn add(&mut self, counts: &[u32]) {
        for (mine, other) in self.hits.0[..CELLS].iter_mut().zip(counts) {
            *mine = mine.saturating_add(*other);
        }
    }

    /// The cells that the second pass is to look at: the highest of those with no higher neighbour, without clutter.
    #[must_use]
    pub fn promising(&self) -> Vec<u32> {
        let counts = self.counts();
        let least = self.pairing.options.least_c;
        let half = BINS as i64 / 2;
        let mut cells: Vec<u32> = (0..CELLS as u32)
            .filter(|&cell| {
                let c = (i64::from(cell) % BINS as i64 - half) as f64 / half as f64;
                counts[cell as usize] >= 4 && c.abs() >= least && is_highest(counts, cell as usize)
            })
            .collect();
        cells.sort_by_key(|&cell| (std::cmp::Reverse(counts[cell as usize]), cell));
        cells.truncate(self.pairing.options.cells);
        cells
    }
}

/// Whether no neighbour in a, b and c has more hits; of equals the first counts.
fn is_highest(counts: &[u32], cell: usize) -> bool {
    let bins = BINS as i64;
    let at = cell as i64;
    let [a, b, c] = [at / (bins * bins), at / bins % bins, at % bins];
    let mine = counts[cell];
    (0..27).all(|n: i64| {
        let (a, b, c) = (a + n / 9 - 1, b + n / 3 % 3 - 1, c + n % 3 - 1);
        if [a, b, c].iter().any(|bin| !(0..bins).contains(bin)) {
            return true;
        }
        let other = ((a * bins + b) * bins + c) as usize;
        counts[other] < mine || (counts[other] == mine && other >= cell)
    })
}

/// The second pass: hits of (d, e) for each promising cell, in 256 KiB a cell and 4 MiB besides.
#[derive(Clone, Debug)]
pub struct SecondPass {
    pairing: Arc<Pairing>,
    cursor: Cursor,
    room: Buffers,
    planes: Planes,
}

#[derive(Clone, Debug)]
struct Planes {
    pairing: Arc<Pairing>,
    cells: Vec<u32>,
    slabs: Vec<bool>,
    /// 0, or one more than the place of the cell in the list.
    table: Vec<u16>,
    counts: Vec<u32>,
}

impl Listener for Planes {
    fn wants(&self, a: usize) -> bool {
        self.slabs[a]
    }

    fn take(&mut self, row: &Row) {
        for (at, &cell) in row.cells.iter().enumerate() {
            let place = self.table[cell as usize];
            if place == 0 {
                continue;
            }
            let d = row.t[at] - row.a * row.start[0];
            let e = row.x[at] - row.b[at] * row.start[0] - row.c[at] * row.start[1];
            if let Some(bin) = self.pairing.plane_bin(d, e) {
                self.counts[(usize::from(place) - 1) * PLANE * PLANE + bin] += 1;
            }
        }
    }
}

impl SecondPass {
    /// The share `part.0` of `part.1` of the domain triples, for the cells that the first pass found in all shares.
    #[must_use]
    pub fn new(
        coarse: &Features,
        fine: &Features,
        options: HoughOptions,
        cells: &[u32],
        part: (usize, usize),
    ) -> Self {
        Self::of(Arc::new(Pairing::new(coarse, fine, options)), cells, part)
    }

    pub(crate) fn of(pairing: Arc<Pairing>, cells: &[u32], part: (usize, usize)) -> Self {
        let cursor = Cursor::new(&pairing, part);
        let cells: Vec<_> = cells.iter().copied().filter(|&c| (c as usize) < CELLS).take(MAX_CELLS).collect();
        let mut slabs = vec![false; BINS];
        let mut table = vec![0; CELLS + 1];
        for (place, &cell) in cells.iter().enumerate() {
            slabs[cell as usize / (BINS * BINS)] = true;
            table[cell as usize] = place as u16 + 1;
        }
        let counts = vec![0; cells.len() * PLANE * PLANE];
        let planes = Planes { pairing: pairing.clone(), cells, slabs, table, counts };
        Self { pairing, cursor, room: Buffers::default(), planes }
    }

    /// Goes one step on, of some milliseconds.
    pub fn step(&mut self) -> HoughProgress {
        self.cursor.step(&self.pairing, &mut self.room, &mut self.planes)
    }

    /// Whether all is counted.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.cursor.is_done(&self.pairing)
    }

    /// Hits of bins d, e of the n-th cell at (n * 256 + d) * 256 + e; bin 128 is zero.
    #[must_use]
    pub fn counts(&self) -> &[u32] {
        &self.planes.counts
    }

    /// Adds the counts of another share of the same cells.
    pub fn add(&mut self, counts: &[u32]) {
        for (mine, other) in self.planes.counts.iter_mut().zip(counts) {
            *mine = mine.saturating_add(*other);
        }
    }

    /// The highest bins around each cell, among which [`gather`] finds the clusters.
    #[must_use]
    pub fn peaks(&self) -> Vec<Cluster> {
        peaks(&self.pairing, &self.planes.cells, &self.planes.counts)
    }

    /// The clusters, those with most hits first; as many as there are cells at most, none beside a higher one.
    #[must_use]
    pub fn clusters(&self) -> Vec<Cluster> {
        gather(self.peaks(), self.planes.cells.len())
    }
}
