//! Every domain triple on every range, and the map that each pairing votes for.

use glam::DVec2;

use super::features::Features;
use super::frame::Frame;
use super::options::{BINS, HoughOptions, MAX_CELLS, PLANE};

/// Cells of (a, b, c).
pub(crate) const CELLS: usize = BINS * BINS * BINS;

/// Cells of (b, c) for one a.
const SLAB: usize = BINS * BINS;

/// Adding it leaves the nearest whole number in the low bits.
const ROUNDING_OFFSET: f32 = 12_582_912.0;

/// The largest |e|, in half heights.
const MOST_E: f64 = 4.0;

/// Triples flatter than this, in half heights, tell no c.
const FLATTEST_TRIPLE: f64 = 1e-5;

/// Votes that share the domain triple, or at least its first point, and a.
pub(crate) struct Row<'a> {
    /// Cell of (a, b, c) of each vote, [`CELLS`] where it is outside.
    pub cells: &'a [u32],
    pub a: f32,
    pub b: &'a [f32],
    pub c: &'a [f32],
    /// First point of the triple.
    pub start: [f32; 2],
    /// Its image, of each vote.
    pub t: &'a [f32],
    pub x: &'a [f32],
}

/// What listens to votes.
pub(crate) trait Listener {
    /// Whether votes with this bin of a are of interest.
    fn wants(&self, a: usize) -> bool;
    fn take(&mut self, row: &Row);
}

/// The two feature sets in a common frame.
#[derive(Clone, Debug)]
pub(crate) struct Pairing {
    pub options: HoughOptions,
    pub frame: Frame,
    /// Both, from -1 to 1.
    pub coarse: Features,
    pub fine: Features,
    t: Vec<f32>,
    x: Vec<f32>,
    /// Distances of t, where both are even.
    steps: Option<[f64; 2]>,
}

/// Room for one row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Buffers {
    cells: Vec<u32>,
    b: Vec<f32>,
    c: Vec<f32>,
    gap: Vec<f32>,
    rise: Vec<f32>,
    t: Vec<f32>,
    x: Vec<f32>,
}

/// Bin of a value that is 64 for 0; far off, a very large number.
fn level(value: f32) -> u32 {
    (value.clamp(-1e4, 1e4) + ROUNDING_OFFSET)
        .to_bits()
        .wrapping_sub(ROUNDING_OFFSET.to_bits() - BINS as u32 / 2)
}

impl Pairing {
    pub fn new(coarse: &Features, fine: &Features, mut options: HoughOptions) -> Self {
        let positive = |x: f64, default: f64| if x.is_finite() && x > 0.0 { x } else { default };
        options.most_b = positive(options.most_b, HoughOptions::default().most_b);
        options.least_a = positive(options.least_a, 0.0);
        options.least_c = positive(options.least_c, 0.0);
        options.cells = options.cells.clamp(1, MAX_CELLS);
        let frame = Frame::of(fine);
        let framed = |features: &Features| {
            let points: Vec<_> = features.points().iter().map(|&p| frame.inside(p)).collect();
            Features::new(&points).unwrap_or_else(|_| features.clone())
        };
        let (coarse, fine) = (framed(coarse), framed(fine));
        let step = |f: &Features| (f.points()[1].x - f.points()[0].x, f.is_even());
        let steps = match (step(&coarse), step(&fine)) {
            ((a, true), (b, true)) => Some([a, b]),
            _ => None,
        };
        let t = fine.points().iter().map(|p| p.x as f32).collect();
        let x = fine.points().iter().map(|p| p.y as f32).collect();
        Self { options, frame, coarse, fine, t, x, steps }
    }

    /// Steps between the bins of a, b, c, d and e.
    pub fn quanta(&self) -> [f64; 5] {
        let half = BINS as f64 / 2.0;
        let plane = PLANE as f64 / 2.0;
        [1.0 / half, self.options.most_b / half, 1.0 / half, 2.0 / plane, MOST_E / plane]
    }

    /// The map in the middle of a bin, in the frame.
    pub fn center(&self, bins: [u16; 5]) -> [f64; 5] {
        let quanta = self.quanta();
        std::array::from_fn(|i| {
            let zero = if i < 3 { BINS / 2 } else { PLANE / 2 };
            (f64::from(bins[i]) - zero as f64) * quanta[i]
        })
    }

    /// Bin of d and e in a plane.
    pub fn plane_bin(&self, d: f32, e: f32) -> Option<usize> {
        let quanta = self.quanta();
        let bin = |value: f32, quantum: f64| {
            let bin = level(value / quantum as f32).wrapping_add((PLANE - BINS) as u32 / 2) as usize;
            (bin < PLANE).then_some(bin)
        };
        Some(bin(d, quanta[3])? * PLANE + bin(e, quanta[4])?)
    }

    fn a_bin(&self, a: f64) -> Option<usize> {
        let bin = level((a * BINS as f64 / 2.0) as f32) as usize;
        (bin < BINS && a.abs() >= self.options.least_a - 1e-9).then_some(bin)
    }

    /// Widths of domains, in steps of the coarse set.
    pub fn widths(&self) -> std::ops::Range<usize> {
        2..self.coarse.points().len()
    }

    /// Lengths of ranges, in steps of the fine set.
    pub fn lengths(&self) -> std::ops::Range<usize> {
        2..self.fine.points().len()
    }

    /// How much work there is with domains of a width, to a factor.
    pub fn work(&self, width: usize) -> f64 {
        (self.coarse.points().len() - width) as f64 * (width - 1) as f64 * width as f64
    }

    /// All votes with domains of a width and ranges of a length: conditions 1 to 3, then eqs 10 to 14. Returns how
    /// many.
    pub fn pair(
        &self,
        [width, length]: [usize; 2],
        share: (usize, usize),
        room: &mut Buffers,
        to: &mut impl Listener,
    ) -> u64 {
        match self.steps {
            Some(steps) => self.pair_even([width, length], steps, share, room, to),
            None => self.pair_any([width, length], share, room, to),
        }
    }

    /// How far the triple's middle is from its chord.
    fn sag(&self, i: usize, j: usize, k: usize) -> f64 {
        let points = self.coarse.points();
        let (first, last) = (points[i], points[k]);
        points[j].y - first.y - (points[j].x - first.x) / (last.x - first.x) * (last.y - first.y)
    }

    /// Where all is even, which point is nearest depends on widths and lengths only, so ranges go by in rows.
    ///
    /// Eq 14 without its matrix: c is the middle's distance from the chord, range over domain; b is what is then left
    /// of the chord's rise.
    fn pair_even(
        &self,
        [w, s]: [usize; 2],
        steps: [f64; 2],
        (part, parts): (usize, usize),
        room: &mut Buffers,
        to: &mut impl Listener,
    ) -> u64 {
        let size = s as f64 * steps[1] / (w as f64 * steps[0]);
        if size >= 1.0 - 1e-9 {
            return 0;
        }
        let (many, domains) = (self.x.len() - s, self.coarse.points().len() - w);
        let fine = self.fine.points();
        let (first, last) = (&fine[..many], &fine[s..]);
        let mut votes = 0;
        for reflected in [false, true] {
            let a = if reflected { -size } else { size };
            let Some(slab) = self.a_bin(a) else { continue };
            if (reflected && !self.options.reflected) || !to.wants(slab) {
                continue;
            }
            let (from, until) = if reflected { (last, first) } else { (first, last) };
            room.rise.clear();
            room.rise.extend(from.iter().zip(until).map(|(from, until)| (until.y - from.y) as f32));
            let (t, x) =
                if reflected { (&self.t[s..], &self.x[s..]) } else { (&self.t[..many], &self.x[..many]) };
            for p in 1..w {
                let q = if reflected { w - p } else { p };
                let offset = ((2 * s * q + w - 1) / (2 * w)).clamp(1, s - 1);
                let along = q as f64 / w as f64;
                let middle = &fine[offset..offset + many];
                room.gap.clear();
                let chord = first.iter().zip(last).map(|(first, last)| first.y + along * (last.y - first.y));
                // Small differences of large numbers, once for all domains: doubles cost nothing here.
                room.gap.extend(middle.iter().zip(chord).map(|(middle, chord)| (middle.y - chord) as f32));
                for i in (0..domains).filter(|i| (i + w) % parts == part) {
                    let sag = self.sag(i, i + p, i + w);
                    if sag.abs() < FLATTEST_TRIPLE {
                        continue;
                    }
                    let points = self.coarse.points();
                    let domain = points[i + w] - points[i];
                    let base = (slab * SLAB) as u32;
                    self.place(room, 1.0 / sag, domain, base);
                    votes += many as u64;
                    to.take(&Row {
                        cells: &room.cells,
                        a: a as f32,
                        b: &room.b,
                        c: &room.c,
                        start: points[i].as_vec2().to_array(),
                        t,
                        x,
                    });
                }
            }
        }
        votes
    }

    /// b, c and their cells from gaps and rises. No branch: it is to be done many at a time.
    fn place(&self, room: &mut Buffers, inverse: f64, domain: DVec2, base: u32) {
        let many = room.gap.len();
        room.cells.resize(many, 0);
        room.b.resize(many, 0.0);
        room.c.resize(many, 0.0);
        let (inverse, height, narrow) = (inverse as f32, domain.y as f32, (1.0 / domain.x) as f32);
        let [unit_b, unit_c] = [1, 2].map(|i| (1.0 / self.quanta()[i]) as f32);
        let inputs = room.gap.iter().zip(&room.rise);
        let outputs = room.cells.iter_mut().zip(&mut room.b).zip(&mut room.c);
        for ((&gap, &rise), ((cell, to_b), to_c)) in inputs.zip(outputs) {
            let c = gap * inverse;
            let b = (rise - c * height) * narrow;
            let (level_b, level_c) = (level(b * unit_b), level(c * unit_c));
            let inside = (level_b | level_c) < BINS as u32;
            let at = base.wrapping_add(level_b.wrapping_mul(BINS as u32)).wrapping_add(level_c);
            *cell = if inside { at } else { CELLS as u32 };
            (*to_b, *to_c) = (b, c);
        }
    }

    /// Any distances: the nearest point is looked for, and the middles of a domain are a row.
    fn pair_any(
        &self,
        [w, s]: [usize; 2],
        (part, parts): (usize, usize),
        room: &mut Buffers,
        to: &mut impl Listener,
    ) -> u64 {
        let (coarse, fine) = (self.coarse.points(), self.fine.points());
        let mut votes = 0;
        for i in (0..coarse.len() - w).filter(|i| (i + w) % parts == part) {
            let domain = coarse[i + w] - coarse[i];
            for l in 0..fine.len() - s {
                let size = (fine[l + s].x - fine[l].x) / domain.x;
                if size >= 1.0 - 1e-9 {
                    continue;
                }
                for reflected in [false, true] {
                    let a = if reflected { -size } else { size };
                    let Some(slab) = self.a_bin(a) else { continue };
                    if (reflected && !self.options.reflected) || !to.wants(slab) {
                        continue;
                    }
                    let (from, until) =
                        if reflected { (fine[l + s], fine[l]) } else { (fine[l], fine[l + s]) };
                    let mut row = 0;
                    room.clear();
                    for p in 1..w {
                        let sag = self.sag(i, i + p, i + w);
                        if sag.abs() < FLATTEST_TRIPLE {
                            continue;
                        }
                        let image = from.x + a * (coarse[i + p].x - coarse[i].x);
                        let middle = fine[self.fine.nearest(image).clamp(l + 1, l + s - 1)].y;
                        let along = (coarse[i + p].x - coarse[i].x) / domain.x;
                        room.gap.push(((middle - from.y - along * (until.y - from.y)) / sag) as f32);
                        room.rise.push((until.y - from.y) as f32);
                        room.t.push(from.x as f32);
                        room.x.push(from.y as f32);
                        row += 1;
                    }
                    self.place(room, 1.0, domain, (slab * SLAB) as u32);
                    votes += row;
                    to.take(&Row {
                        cells: &room.cells,
                        a: a as f32,
                        b: &room.b,
                        c: &room.c,
                        start: coarse[i].as_vec2().to_array(),
                        t: &room.t,
                        x: &room.x,
                    });
                }
            }
        }
        votes
    }
}

impl Buffers {
    fn clear(&mut self) {
        for list in [&mut self.gap, &mut self.rise, &mut self.t, &mut self.x] {
            list.clear();
        }
    }
}
