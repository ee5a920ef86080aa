//! Points that two pieces share, exactly.
//!
//! Pieces that touch in a point do not cross. But where the point has in both an address that repeats itself, as
//! corners have, its place is a fraction of the numbers of the maps, and two fractions can be compared without
//! rounding. Points of few letters are laid on a grid in floating point; those that fall together are compared.

use frond_core::Affine2;
use glam::DVec2;

use crate::exact::address::Address;
use crate::exact::quadratic::QuadraticSystem;
use crate::exact::residue::Residues;
use crate::overlap_graph::Components;

/// The addresses of one point in two pieces.
pub(crate) type Contact = [Address; 2];

/// Points this near are taken for the same at first; in units of the attractor.
const CELLS_PER_UNIT: f64 = 67_108_864.0;
/// Points are made of shorter ones as long as these, in all pieces, are no more.
const MOST_POINTS: usize = 512;
/// Points of two pieces that are compared exactly at most, for one sample.
const MOST_TRIES: u8 = 4;

/// A point by its letters: those before it repeats, and those that repeat.
#[derive(Clone, Copy, Debug)]
struct Letters {
    /// Two at most, then those that repeat, two at most as well.
    letters: [u8; 4],
    head: u8,
    repeat: u8,
}

impl Letters {
    fn repeated(repeat: &[u8]) -> Self {
        let mut letters = [0; 4];
        letters[..repeat.len()].copy_from_slice(repeat);
        Self { letters, head: 0, repeat: repeat.len() as u8 }
    }

    fn behind(self, letter: u8) -> Self {
        let [a, b, c, _] = self.letters;
        Self { letters: [letter, a, b, c], head: self.head + 1, ..self }
    }

    fn split(&self) -> (&[u8], &[u8]) {
        let (head, rest) = self.letters.split_at(usize::from(self.head));
        (head, &rest[..usize::from(self.repeat)])
    }

    /// The address of the point that one map more takes it to.
    fn in_piece(&self, map: u8) -> Option<Address> {
        let (head, repeat) = self.split();
        Address::new([&[map], head].concat(), repeat.to_vec())
    }
}

/// Looks for points that pieces share, and keeps the memory for the next system.
#[derive(Clone, Debug, Default)]
pub(crate) struct Contacts {
    points: Vec<(DVec2, Letters)>,
    /// Cells, with the number of a point and of the map that takes it there.
    cells: Vec<(u64, u32)>,
    tried: Vec<u8>,
    residues: Residues,
    exact: Option<QuadraticSystem>,
}

impl Contacts {
    /// Takes other maps, whose numbers are finite.
    pub fn begin(&mut self, maps: &[Affine2]) {
        self.residues.set(maps);
        self.exact = None;
    }

    /// Whether a point with such addresses is shared by two pieces of these maps, exactly. `round` are the same maps in
    /// coordinates in which the attractor lies in the unit disc.
    pub fn hold(&mut self, maps: &[Affine2], round: impl Fn(u8) -> Affine2, [a, b]: &Contact) -> bool {
        let point = |address: &Address| {
            let word = address.repeat.iter().fold(Affine2::IDENTITY, |word, &k| word * round(k));
            let fixed = word.fixed_point()?;
            Some(address.head.iter().rev().fold(fixed, |point, &k| round(k).apply(point)))
        };
        let near = point(a).zip(point(b)).is_some_and(|(p, q)| p.distance(q) * CELLS_PER_UNIT < 1.0);
        near && self.coincide(maps, a, b)
    }

    fn coincide(&mut self, maps: &[Affine2], a: &Address, b: &Address) -> bool {
        // Mostly they lie together but for rounding, and that is seen at once.
        if self.residues.differ(a, b) {
            return false;
        }
        if self.exact.is_none() {
            self.exact = QuadraticSystem::as_given(maps);
        }
        self.exact.as_ref().is_some_and(|exact| exact.coincide(a, b))
    }

    /// Joins pieces that are not joined yet and share a point, and adds these to those found. Returns how many points
    /// were looked at.
    pub fn join(
        &mut self,
        maps: &[Affine2],
        round: impl Fn(u8) -> Affine2,
        components: &mut Components,
        found: &mut Vec<Contact>,
    ) -> usize {
        let count = maps.len();
        self.list(count, &round);
        self.cells.clear();
        for (k, &(point, _)) in self.points.iter().enumerate() {
            for map in 0..count {
                self.cells.push((cell(round(map as u8).apply(point)), (k * count + map) as u32));
            }
        }
        self.cells.sort_unstable();
        self.tried.clear();
        self.tried.resize(count * count, 0);
        let cells = std::mem::take(&mut self.cells);
        for same in cells.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1) {
            for (n, &(_, first)) in same.iter().enumerate() {
                for &(_, second) in &same[n + 1..] {
                    if components.count() == 1 {
                        break;
                    }
                    self.try_pair(maps, [first, second], components, found);
                }
            }
        }
        self.cells = cells;
        self.cells.len()
    }

    fn try_pair(
        &mut self,
        maps: &[Affine2],
        numbers: [u32; 2],
        components: &mut Components,
        found: &mut Vec<Contact>,
    ) {
        let count = maps.len();
        let [i, j] = numbers.map(|number| number as usize % count);
        if components.joined(i, j) {
            return;
        }
        // Where some points do not fit, others that lie together in the same way hardly will.
        let tried = &mut self.tried[i.min(j) * count + i.max(j)];
        *tried += 1;
        if *tried > MOST_TRIES {
            *tried = MOST_TRIES;
            return;
        }
        let address = |number: u32| {
            let (_, letters) = self.points[number as usize / count];
            letters.in_piece((number as usize % count) as u8)
        };
        let (Some(a), Some(b)) = (address(numbers[0]), address(numbers[1])) else { return };
        if self.coincide(maps, &a, &b) {
            components.join(i, j);
            found.push([a, b]);
        }
    }

    /// The fixed points of one map and of two, and what maps take these to.
    fn list(&mut self, count: usize, round: impl Fn(u8) -> Affine2) {
        self.points.clear();
        let letters = 0..count as u8;
        for i in letters.clone() {
            let fixed = round(i).fixed_point();
            self.points.extend(fixed.map(|point| (point, Letters::repeated(&[i]))));
        }
        for (i, j) in letters.clone().flat_map(|i| letters.clone().map(move |j| (i, j))) {
            let fixed = if i == j { None } else { (round(i) * round(j)).fixed_point() };
            self.points.extend(fixed.map(|point| (point, Letters::repeated(&[i, j]))));
        }
        let mut from = 0;
        for _ in 0..2 {
            let to = self.points.len();
            if to * count > MOST_POINTS {
                break;
            }
            for k in from..to {
                let (point, of) = self.points[k];
                for i in letters.clone().filter(|&i| of.head > 0 || of.repeat > 1 || of.letters[0] != i) {
                    self.points.push((round(i).apply(point), of.behind(i)));
                }
            }
            from = to;
        }
    }
}

/// A cell of a grid off the lines on which numbers that mean something lie.
fn cell(point: DVec2) -> u64 {
    let [x, y] = [point.x, point.y].map(|x| (x * CELLS_PER_UNIT + 0.3719).round() as i32 as u32);
    u64::from(x) << 32 | u64::from(y)
}
