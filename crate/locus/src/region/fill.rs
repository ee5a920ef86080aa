//! A locus by whole boxes of parameters: what is alike far and wide costs little.
//!
//! A box of samples is decided as a whole where its corners and its middle agree and one argument serves all of it:
//!
//! - *disconnected*: the same pieces are apart, in the same directions, throughout ([`Descent::separate`]);
//! - *connected*: the same pieces cross throughout ([`Descent::cross`]), or two maps fill more than all of the plane;
//! - *without attractor*: one map stretches throughout.
//!
//! Else it is split. What the samples at the corners of boxes say, [`decide`](fn@crate::decide) says; so the cost
//! follows the length of the boundaries and how fast the shapes change from one sample to the next: at a great
//! magnification nearly all is decided in large boxes.

use std::ops::Range;

use frond_core::Affine2;
use glam::DVec2;

use crate::decide::{Scratch, decide};
use crate::family::Family;
use crate::grid::{LocusGrid, Tile};
use crate::region::descent::Descent;
use crate::region::extent::Extent;
use crate::region::no_attractor::never_contracts;
use crate::region::power_series_box::PowerSeriesBoxes;
use crate::region::starts::Starts;
use crate::region::trap::Effort;
use crate::verdict::{Sample, State};

impl LocusGrid {
    /// Decides a rectangle of samples, adaptively: the tile holds one row for each of the rows `y`, from the bottom,
    /// with one sample for each of the columns `x`.
    ///
    /// States are those of [`decide`](fn@crate::decide), or proofs for a whole box of samples: such a sample is
    /// `Disconnected` only where its gap is wider than epsilon, and may be `Connected` where `decide` alone says
    /// `Touching`. Gaps inside a disconnected box are interpolated between its corners, and never less than what is
    /// proved: in its middle that is right to 1 in 20 or to 1 in 200 of the diameter. Elsewhere nothing bounds it, as
    /// where another pair of pieces becomes the widest apart; of 30,000 samples of random morphs 99 in 100 were right
    /// to 1 in 10 or to 1 in 250 of the diameter, and 999 in 1000 to twice that.
    ///
    /// Points that come near are looked for first where those of a sample of a coarser grid were. So near points may
    /// be found that `decide` alone does not find, and a sample be `Touching` where it is `Undecided` there, or
    /// `Disconnected` by a gap no wider than epsilon: both are true then. A sample that is decided on its own has the
    /// same answer in whichever rectangle of the grid it is.
    // For any family in one piece of code, which is compiled here: a crate that calls it may be compiled for size.
    #[must_use]
    pub fn patch(
        &self,
        family: &dyn Family,
        epsilon: f64,
        x: Range<usize>,
        y: Range<usize>,
        scratch: &mut Scratch,
    ) -> Tile {
        let x = x.start..x.end.min(self.width());
        let y = y.start..y.end.min(self.height());
        let count = x.len() * y.len();
        let tile = Tile { state: vec![Self::UNTOUCHED; count], gap: vec![f32::NAN; count] };
        let (width, left, bottom) = (x.len(), x.start, y.start);
        let maps = Vec::with_capacity(family.len());
        let descent = Descent::default();
        let mut patch = BoxFill {
            grid: self,
            family,
            epsilon,
            width,
            left,
            bottom,
            tile,
            scratch,
            maps,
            descent,
            starts: Starts::default(),
            series: PowerSeriesBoxes::default(),
            debt: 0.0,
            looks_alone: 0.0,
        };
        if count > 0 {
            patch.fill(Area { x0: x.start, y0: y.start, x1: x.end - 1, y1: y.end - 1 });
        }
        patch.tile
    }
}

/// A rectangle of samples, both ends included.
#[derive(Clone, Copy, Debug)]
struct Area {
    x0: usize,
    y0: usize,
    x1: usize,
    y1: usize,
}

/// Where a side of an area is split: of the places about in its middle the one that lies on the coarsest grid, so that
/// the corners of areas are mostly samples from which others [begin](Starts).
fn halfway(from: usize, to: usize) -> usize {
    let quarter = (to - from).div_ceil(4);
    let (first, last) = (from + quarter, to - quarter);
    if first >= last {
        return from.midpoint(to);
    }
    // All places have the digits that the one before the first and the last have in common, and this is 0 below them.
    let digits = ((first - 1) ^ last).ilog2();
    last >> digits << digits
}

struct BoxFill<'a> {
    grid: &'a LocusGrid,
    family: &'a dyn Family,
    epsilon: f64,
    width: usize,
    left: usize,
    bottom: usize,
    tile: Tile,
    scratch: &'a mut Scratch,
    maps: Vec<Affine2>,
    descent: Descent<6>,
    starts: Starts,
    series: PowerSeriesBoxes,
    /// Looks that were spent on crossings in vain, less what the samples decided since then are worth.
    debt: f64,
    /// How many looks a disconnected sample took on its own of late.
    looks_alone: f64,
}

/// Boxes of fewer open samples are not worth an attempt.
const LEAST_OPEN: usize = 4;
/// The same for telling pieces apart: of a few samples it mostly takes longer, and fails.
const LEAST_OPEN_TO_PART: usize = 8;
/// The same for crossings, which take longer to find.
const LEAST_OPEN_TO_CROSS: usize = 40;
/// Looks spent on telling the pieces of a box apart: so many, or more where its samples would take many on their own.
const LOOKS_TO_SEPARATE: usize = 150;
const MOST_LOOKS_TO_SEPARATE: usize = 1200;
/// Of what they would take, as a look at a box takes some fifteen times as long as one at a sample, and mostly in vain.
const LOOKS_OF_A_BOX: f64 = 0.01;
/// How much one sample says of how many looks others take.
const SHARE_OF_ONE: f64 = 0.1;
/// How hard to look for crossings in a box.
const EFFORT_TO_CROSS: Effort = Effort { looks: 80, tries: 150, near: 2e-3 };
/// Looks that a sample decided on its own is worth: where crossings are hard to find, at most about as long is spent on
/// them in vain as on the samples.
const LOOKS_PER_SAMPLE: f64 = 3.0;
const MOST_DEBT: f64 = 4000.0;
/// How far what is proved of a box may be above what is said of its corners: twice, and a tenth for the diameters that
/// both are relative to, which are bounds.
const MOST_OVER_CORNERS: f64 = 2.2;
/// Where points move farther than this over a box, in parts of the attractor's size, no crossing is likely to last.
const LARGEST_STRAY: f64 = 0.03;

impl BoxFill<'_> {
    fn index(&self, x: usize, y: usize) -> usize {
        (y - self.bottom) * self.width + (x - self.left)
    }

    /// The sample at a place, decided if it was not before.
    fn sample(&mut self, x: usize, y: usize) -> Sample {
        let i = self.index(x, y);
        if let Some(state) = State::from_code(self.tile.state[i]) {
            return Sample { state, gap: self.tile.gap[i] };
        }
        let Self { grid, family, epsilon, scratch, maps, starts, .. } = self;
        let sample = if family.is_set_m() {
            // It is found at once.
            family.fill(grid.u(x), grid.v(y), maps);
            decide(maps, *epsilon, LocusGrid::BUDGET, scratch)
        } else {
            let start = starts.of((x, y), &mut |(x, y), start| {
                family.fill(grid.u(x), grid.v(y), maps);
                scratch.find_trails(maps, *epsilon, LocusGrid::budget(maps.len()), start).clone()
            });
            family.fill(grid.u(x), grid.v(y), maps);
            let sample = scratch.decide_from(maps, *epsilon, LocusGrid::budget(maps.len()), start);
            starts.keep((x, y), scratch.trails());
            sample
        };
        if sample.state == State::Disconnected {
            self.looks_alone += SHARE_OF_ONE * (self.scratch.search.looks() as f64 - self.looks_alone);
        }
        self.debt = (self.debt - LOOKS_PER_SAMPLE).max(0.0);
        self.tile.state[i] = sample.state as u8;
        self.tile.gap[i] = sample.gap;
        sample
    }

    /// Decides all samples of an area.
    fn fill(&mut self, area: Area) {
        let Area { x0, y0, x1, y1 } = area;
        let corners = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].map(|(x, y)| self.sample(x, y));
        let (across, up) = (x1 - x0, y1 - y0);
        if across <= 1 && up <= 1 || self.at_once(area, &corners) {
            return;
        }
        if across >= up {
            let middle = halfway(x0, x1);
            self.fill(Area { x1: middle, ..area });
            self.fill(Area { x0: middle, ..area });
        } else {
            let middle = halfway(y0, y1);
            self.fill(Area { y1: middle, ..area });
            self.fill(Area { y0: middle, ..area });
        }
    }

    /// Decides an area as one box, if it can.
    fn at_once(&mut self, area: Area, corners: &[Sample; 4]) -> bool {
        let Area { x0, y0, x1, y1 } = area;
        let all = |is: fn(State) -> bool| corners.iter().all(|sample| is(sample.state));
        let (apart, whole, none) = (
            all(|state| state == State::Disconnected),
            all(State::holds),
            all(|state| state == State::NoAttractor),
        );
        if !(apart || whole || none) {
            return false;
        }
        let open = self.open(area);
        if open < LEAST_OPEN {
            return false;
        }
        let at = |x, y| DVec2::new(self.grid.u(x), self.grid.v(y));
        let extent = Extent::between(at(x0, y0), at(x1, y1));
        if none {
            let proved = never_contracts(self.family, extent);
            if proved {
                self.cover(area, State::NoAttractor, |_, _| f32::NAN);
            }
            return proved;
        }
        if apart && open < LEAST_OPEN_TO_PART && !self.family.is_set_m() {
            return false;
        }
        let middle = self.sample(halfway(x0, x1), halfway(y0, y1));
        if apart != (middle.state == State::Disconnected) || whole != middle.state.holds() {
            return false;
        }
        if apart { self.part(area, extent, corners, middle, open) } else { self.join(area, extent, open) }
    }

    /// How many samples of an area are not decided yet.
    fn open(&self, area: Area) -> usize {
        let row = |y| self.index(area.x0, y)..=self.index(area.x1, y);
        let open = |y| self.tile.state[row(y)].iter().filter(|&&state| state == LocusGrid::UNTOUCHED).count();
        (area.y0..=area.y1).map(open).sum()
    }

    /// Decides an area that seems disconnected.
    fn part(
        &mut self,
        area: Area,
        extent: Extent,
        corners: &[Sample; 4],
        middle: Sample,
        open: usize,
    ) -> bool {
        let Area { x0, y0, x1, y1 } = area;
        let gaps = corners.map(|sample| f64::from(sample.gap));
        let narrowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let shade = move |x: usize, y: usize| {
            let share = |i: usize, from: usize, to: usize| (i - from) as f64 / (to - from).max(1) as f64;
            let (s, t) = (share(x, x0, x1), share(y, y0, y1));
            let [a, b, c, d] = gaps;
            (a + (b - a) * s) * (1.0 - t) + (c + (d - c) * s) * t
        };
        let seen = f64::from(middle.gap);
        let off = (shade(halfway(x0, x1), halfway(y0, y1)) - seen).abs();
        // The attractor is at least about as large as the disc it lies in.
        if off > (0.05 * seen).max(0.005) {
            return false;
        }
        let proved = if self.family.is_set_m() {
            self.far_from_m(extent, narrowest)
        } else {
            self.apart(extent, narrowest, self.looks_for(open))
        };
        // No gap is more than twice the middle of its bounds: more than that contradicts a corner, and nothing is said.
        let most = MOST_OVER_CORNERS * narrowest;
        let Some(proved) = proved.filter(|&proved| proved > self.epsilon && proved <= most) else {
            return false;
        };
        self.cover(area, State::Disconnected, |x, y| shade(x, y).max(proved) as f32);
        true
    }

    /// How many looks to spend at most on telling the pieces of a box of so many open samples apart.
    fn looks_for(&self, open: usize) -> usize {
        let worth = open as f64 * self.looks_alone * LOOKS_OF_A_BOX;
        (worth as usize).clamp(LOOKS_TO_SEPARATE, MOST_LOOKS_TO_SEPARATE)
    }

    /// A lower bound of the widest gap over its diameter, over a box where it seems no narrower than `narrowest`.
    fn apart(&mut self, extent: Extent, narrowest: f64, looks: usize) -> Option<f64> {
        let lanes = &mut self.descent.lanes;
        if !lanes.set(self.family, extent, &mut self.scratch.frame) || lanes.widest_margin() > 2.0 * narrowest
        {
            return None;
        }
        self.descent.set_support();
        let least = self.descent.separate(0.7 * narrowest, looks)?;
        // Lengths of the plane are between so many times those of the lanes.
        let (long, short) = Affine2::new(self.descent.lanes.from_round, DVec2::ZERO).singular_values();
        Some(least * short / (self.descent.diameter().1 * long) * (1.0 - 1e-12))
    }

    /// The same for the family of the set M.
    fn far_from_m(&mut self, extent: Extent, narrowest: f64) -> Option<f64> {
        let radius = extent.half.length();
        let room = 1.0 - (extent.middle.length() + radius);
        // The attractor is at least as large as the step between its pieces, 2, and at most that over the room; its gap
        // is twice what the series stay away by.
        let least = (0.5 * narrowest).max(self.epsilon / room * (1.0 + 1e-9));
        let away = self.series.stay_away(extent.middle, radius, least);
        away.then_some(least * room * (1.0 - 1e-12))
    }

    /// Decides an area that seems connected.
    fn join(&mut self, area: Area, extent: Extent, open: usize) -> bool {
        // Where too much was spent in vain, nothing is set up for crossings either.
        let worth = open >= LEAST_OPEN_TO_CROSS && self.debt <= MOST_DEBT;
        let proved = if self.family.is_set_m() {
            // The areas of two maps may fill the plane in a box of any size.
            let [nearest, farthest] = extent.distances();
            nearest * nearest > 0.5 + 1e-9 && farthest < 1.0 - 1e-9
        } else {
            !self.family.has_one_linear_part()
                && (worth || self.family.len() <= 2)
                && self.descent.lanes.set(self.family, extent, &mut self.scratch.frame)
                && (self.descent.lanes.areas_fill() || worth && self.crosses())
        };
        if proved {
            self.cover(area, State::Connected, |_, _| 0.0);
        }
        proved
    }

    /// Whether pieces cross throughout the box that the lanes are set for.
    fn crosses(&mut self) -> bool {
        if self.descent.lanes.stray() > LARGEST_STRAY {
            return false;
        }
        self.descent.set_support();
        let found = self.descent.cross(f64::INFINITY, EFFORT_TO_CROSS).is_some();
        if !found {
            self.debt += self.descent.nodes as f64;
        }
        found
    }

    fn cover(&mut self, area: Area, state: State, gap: impl Fn(usize, usize) -> f32) {
        for y in area.y0..=area.y1 {
            for x in area.x0..=area.x1 {
                let i = self.index(x, y);
                // What was decided for itself is known better.
                if state != State::Disconnected || self.tile.state[i] == LocusGrid::UNTOUCHED {
                    self.tile.gap[i] = gap(x, y);
                }
                self.tile.state[i] = state as u8;
            }
        }
    }
}
