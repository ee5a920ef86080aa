//! Densities without chance: the measure of the whole, carried into its pieces.
//!
//! Each piece is an affine image of all of the attractor, with its part of the measure. So the measure is found once,
//! as masses on a grid in the frame of the attractor, and put on the screen for each piece of some pixels. A mass is
//! shared among the four pixels around it by how near they are, which leaves no pattern of the grid behind.
//!
//! On the grid the measure is the fixed point of Hutchinson's operator ("Fractals and self-similarity", 1981): the sum
//! of its images under the maps, each by the probability of its map. What is repeated comes nearer to it by the factor
//! of the maps each time.

use frond_core::Affine2;
use glam::Vec2;

use super::Density;
use crate::picture::colour::Colours;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;
use crate::pieces::measure::{MassPiece, Sampler};
use crate::splat::cloud::{COUNT, NEXT};

/// The largest pieces, in pixels.
const PIECE: f64 = 48.0;
/// Cells of the grid of the whole, each way: more than twice as many as there are pixels in a piece.
const SIDE: usize = 192;
/// How many masses may be moved before the measure on the grid is taken as it is; and how many it begins with.
const MOST_MOVES: usize = 2_000_000;
const FIRST: usize = 4096;
/// How much nearer to each other the masses come than the first, and how often the maps are applied for it at most.
const REFINED: f64 = 16.0;
const MOST_REPEATS: f64 = 64.0;
/// Pieces looked at, and masses for each pixel of the window and on top, before pieces overlap too much.
const MOST_VISITS: usize = 300_000;
const MOST_MASSES: (usize, usize) = (6, 500_000);

/// A part of the measure that lies in one place, in unit coordinates.
#[derive(Clone, Copy, Debug)]
struct Mass {
    at: Vec2,
    mass: f32,
}

/// Masses that are placed at once.
const LANES: usize = 8;

/// Masses as they are placed: the x of some, their y, and how much they are. The last of all is repeated, and weighs
/// nothing then.
#[derive(Debug)]
struct Masses(Vec<[[f32; LANES]; 3]>);

impl Masses {
    fn of(masses: &[Mass]) -> Self {
        let lanes = |chunk: &[Mass]| {
            let of = |get: fn(&Mass) -> f32| std::array::from_fn(|k| get(&chunk[k.min(chunk.len() - 1)]));
            let weights = std::array::from_fn(|k| chunk.get(k).map_or(0.0, |mass| mass.mass));
            [of(|mass| mass.at.x), of(|mass| mass.at.y), weights]
        };
        Self(masses.chunks(LANES).map(lanes).collect())
    }
}

/// The measure of the whole, for pieces of each size.
#[derive(Debug)]
pub(crate) struct Carried {
    finest: Vec<Mass>,
    classes: [Option<Masses>; COUNT],
    /// The distance of masses on the screen, in pixels.
    spacing: f64,
}

/// Gathers masses in the cells of a grid over the unit square, each at the middle of what it has.
struct Grid {
    side: usize,
    cells: Vec<[f32; 3]>,
}

impl Grid {
    fn new(side: usize) -> Self {
        Self { side, cells: vec![[0.0; 3]; side * side] }
    }

    #[inline]
    fn add(&mut self, at: Vec2, mass: f32) {
        let half = 0.5 * self.side as f32;
        // A cast of what is below 0, or no number, gives 0.
        let cell = |x: f32| (((x + 1.0) * half) as usize).min(self.side - 1);
        let sums = &mut self.cells[cell(at.y) * self.side + cell(at.x)];
        *sums = [sums[0] + mass * at.x, sums[1] + mass * at.y, sums[2] + mass];
    }

    fn take(&mut self) -> Vec<Mass> {
        let full = self.cells.iter_mut().filter(|sums| sums[2] > 0.0);
        full.map(|sums| {
            let [x, y, mass] = std::mem::take(sums);
            Mass { at: Vec2::new(x, y) / mass, mass }
        })
        .collect()
    }
}

/// By how much a map brings points nearer to each other in the mean of all directions: the logarithm of the factor.
fn shrinking(map: &Affine2) -> f64 {
    let norm = map.norm().max(1e-6);
    -(0.5 * map.linear.determinant().abs().ln()).clamp(norm.ln() - 2.0, norm.ln()).min(-1e-3)
}

impl Carried {
    /// The measure of an attractor.
    pub fn of(frame: &Frame, spacing: f64) -> Self {
        let mut samples = Vec::new();
        Sampler::new(frame, FIRST).fill(frame, &mut samples);
        let mut grid = Grid::new(SIDE);
        for sample in &samples {
            grid.add(Vec2::from(sample.position), sample.mass);
        }
        let mut masses = grid.take();
        let parts: Vec<_> =
            frame.maps.iter().zip(&frame.probabilities).filter(|(_, part)| **part > 0.0).collect();
        // Samples come nearer to each other by so much each time, in the mean.
        let shrinks: f64 = parts.iter().map(|(map, part)| **part * shrinking(map)).sum();
        let repeats = (REFINED.ln() / shrinks).ceil().min(MOST_REPEATS) as usize;
        let mut moves = 0;
        for _ in 0..repeats {
            moves += masses.len() * parts.len();
            if moves > MOST_MOVES {
                break;
            }
            for (map, part) in &parts {
                let (linear, translation) = (map.linear.as_mat2(), map.translation.as_vec2());
                for Mass { at, mass } in &masses {
                    grid.add(linear * *at + translation, mass * **part as f32);
                }
            }
            masses = grid.take();
        }
        Self { finest: masses, classes: [const { None }; COUNT], spacing }
    }

    /// The masses for pieces of a size in pixels.
    fn masses(&mut self, size: f64) -> &Masses {
        // A cast of what is below 0, or no number, gives 0.
        let class = (((PIECE / size.max(1e-3)).ln() / -NEXT.ln()) as usize).min(COUNT - 1);
        let (finest, spacing) = (&self.finest, self.spacing);
        self.classes[class].get_or_insert_with(|| {
            let size = PIECE * NEXT.powi(class as i32);
            let mut grid = Grid::new((size / spacing).ceil().max(1.0) as usize);
            for Mass { at, mass } in finest {
                grid.add(*at, *mass);
            }
            Masses::of(&grid.take())
        })
    }

    /// Whether pieces are so small that they are even, and not too many.
    fn is_enough(&mut self, pieces: &[MassPiece], window: Window) -> bool {
        let masses: usize = pieces.iter().map(|piece| self.masses(size(piece)).0.len() * LANES).sum();
        masses <= most_masses(window) && pieces.iter().all(|piece| size(piece) <= PIECE)
    }
}

/// Where pieces of one colour are added up: the weight of each pixel, with some around that take what falls outside.
struct Plane {
    window: Window,
    width: usize,
    weights: Vec<f32>,
    /// The rows that something was added to.
    rows: (usize, usize),
    /// How far a mass reaches on the screen, in pixels.
    spacing: f32,
    /// Whether a mass lies in a pixel, where that is asked.
    hit: Option<Vec<bool>>,
}

/// Pixels around the window, on each side: more than a mass is shared among.
const AROUND: usize = 2;
/// Masses so near to each other leave no pixel of an area out, so that what none lies in is not of the shape.
const SHARP: f64 = 0.5;
/// Added to a number from 0 to 2^22, this leaves the nearest integer in its low bits.
const TO_INTEGER: f32 = 8_388_608.0;
const INTEGER_BITS: u32 = 0x007f_ffff;

impl Plane {
    fn new(window: Window, spacing: f64) -> Self {
        let width = window.width as usize + 2 * AROUND;
        let height = window.height as usize + 2 * AROUND;
        let hit = (spacing <= SHARP).then(|| vec![false; width * height]);
        let weights = vec![0.0; width * height];
        Self { window, width, weights, rows: (height, 0), spacing: spacing as f32, hit }
    }

    /// Adds a piece.
    fn add(&mut self, map: &Affine2, masses: &Masses, heavy: f32) {
        let [a, b, c, d, e, f] = map.to_row();
        let [a, b, c, d] = [a, b, c, d].map(|x| x as f32);
        // From the middle of a pixel to the next one, among those around as well.
        let [e, f] = [e, f].map(|x| (x - 0.5 + AROUND as f64) as f32);
        let most = [self.window.width, self.window.height].map(|side| (side as usize + AROUND) as f32);
        let sharp = self.spacing.recip();
        let reach = (c * c + d * d).sqrt() + 1.0;
        let row = |y: f32| (y.max(0.0) as usize).min(self.window.height as usize + AROUND);
        self.rows = (self.rows.0.min(row(f - reach)), self.rows.1.max(row(f + reach) + 2));
        for [xs, ys, weights] in &masses.0 {
            let mut at = [0_u32; LANES];
            let mut nearest = [0_u32; LANES];
            let mut shares = [[0.0_f32; LANES]; 4];
            for k in 0..LANES {
                let place = |x: f32, most: f32| {
                    // Not `max` and `min`, which look for what is no number.
                    let x = if x > 0.0 { x } else { 0.0 };
                    let x = if x < most { x } else { most };
                    let low = x - 0.5 + TO_INTEGER;
                    let part = (x - (low - TO_INTEGER) - 0.5) * sharp + 0.5;
                    let part = if part > 0.0 { part } else { 0.0 };
                    (low.to_bits() & INTEGER_BITS, if part < 1.0 { part } else { 1.0 })
                };
                let (x, right) = place(a * xs[k] + b * ys[k] + e, most[0]);
                let (y, below) = place(c * xs[k] + d * ys[k] + f, most[1]);
                at[k] = y * self.width as u32 + x;
                nearest[k] = at[k] + u32::from(right > 0.5) + u32::from(below > 0.5) * self.width as u32;
                let weight = weights[k] * heavy;
                let lower = weight * below;
                let upper = weight - lower;
                shares[1][k] = upper * right;
                shares[0][k] = upper - shares[1][k];
                shares[3][k] = lower * right;
                shares[2][k] = lower - shares[3][k];
            }
            for k in 0..LANES {
                let at = at[k] as usize;
                if let Some([left, right]) = self.weights.get_mut(at..at + 2) {
                    (*left, *right) = (*left + shares[0][k], *right + shares[1][k]);
                }
                if let Some([left, right]) = self.weights.get_mut(at + self.width..at + self.width + 2) {
                    (*left, *right) = (*left + shares[2][k], *right + shares[3][k]);
                }
            }
            if let Some(hit) = &mut self.hit {
                for at in nearest {
                    if let Some(hit) = hit.get_mut(at as usize) {
                        *hit = true;
                    }
                }
            }
        }
    }

    /// Moves what was added to sums of weighted colours, and of weights.
    fn fold(&mut self, [r, g, b]: [f32; 3], sums: &mut [[f32; 4]]) {
        let rows = self.rows.0.max(AROUND)..self.rows.1.min(self.window.height as usize + AROUND);
        for y in rows {
            let weights = &mut self.weights[y * self.width + AROUND..][..self.window.width as usize];
            let sums = &mut sums[(y - AROUND) * self.window.width as usize..];
            for (weight, sum) in weights.iter_mut().zip(sums) {
                let w = std::mem::take(weight);
                *sum = [sum[0] + w * r, sum[1] + w * g, sum[2] + w * b, sum[3] + w];
            }
        }
        self.rows = (self.weights.len(), 0);
    }

    /// Moves what was shared with pixels that no mass lies in to the heaviest beside them in which one does.
    fn sharpen(&self, sums: &mut [[f32; 4]]) {
        let Some(hit) = &self.hit else { return };
        let (width, height) = (self.window.width as usize, self.window.height as usize);
        let is_hit = |x: usize, y: usize| hit[(y + AROUND) * self.width + x + AROUND];
        for y in 0..height {
            for x in 0..width {
                if sums[y * width + x][3] == 0.0 || is_hit(x, y) {
                    continue;
                }
                let spread = std::mem::take(&mut sums[y * width + x]);
                let beside = (y.saturating_sub(1)..(y + 2).min(height))
                    .flat_map(|y| (x.saturating_sub(1)..(x + 2).min(width)).map(move |x| (x, y)))
                    .filter(|(x, y)| is_hit(*x, *y))
                    .map(|(x, y)| y * width + x);
                if let Some(to) = beside.max_by(|a, b| sums[*a][3].total_cmp(&sums[*b][3])) {
                    sums[to] = std::array::from_fn(|k| sums[to][k] + spread[k]);
                }
            }
        }
    }
}

/// The size of a piece, in pixels.
fn size(piece: &MassPiece) -> f64 {
    2.0 * piece.map.norm()
}

/// How many masses are placed before pieces overlap too much.
fn most_masses(window: Window) -> usize {
    MOST_MASSES.0 * window.area() + MOST_MASSES.1
}

/// The pieces in a window that are so small that the measure is carried into them, or `None` where they are too many.
pub(crate) fn small_pieces(
    frame: &Frame,
    to_screen: Affine2,
    window: Window,
    carried: &mut Carried,
) -> Option<Vec<MassPiece>> {
    let most = most_masses(window);
    let (mut pieces, mut visits, mut masses) = (Vec::new(), 0, 0);
    let mut stack = vec![MassPiece { map: to_screen, letters: Letters::NONE, mass: 1.0 }];
    while let Some(piece) = stack.pop() {
        visits += 1;
        if visits > MOST_VISITS || masses > most {
            return None;
        }
        if window.extent_within(&piece.map, 1.0).is_none() {
            continue;
        }
        let size = size(&piece);
        if piece.letters.count() > 0 && size <= PIECE {
            masses += carried.masses(size).0.len() * LANES;
            pieces.push(piece);
            continue;
        }
        for (letter, map) in frame.maps.iter().enumerate() {
            let mass = piece.mass * frame.probabilities[letter];
            if mass > 0.0 {
                stack.push(MassPiece { map: piece.map * *map, letters: piece.letters.then(letter), mass });
            }
        }
    }
    Some(pieces)
}

impl Density {
    /// Adds all of the measure at once, with masses `spacing` pixels from each other: for each pixel the sum of
    /// weighted colours, and of weights. `to_screen` is the map to the screen where nothing is bent; what is bent is
    /// made of the pieces of this density. Returns false, and adds nothing, where pieces overlap too much for that.
    pub(crate) fn carry(
        &self,
        frame: &Frame,
        to_screen: Option<Affine2>,
        colours: &Colours,
        (window, spacing): (Window, f64),
        sums: &mut [[f32; 4]],
    ) -> bool {
        let mut carried = Carried::of(frame, spacing);
        let found = to_screen.map(|to_screen| small_pieces(frame, to_screen, window, &mut carried));
        let pieces = match &found {
            Some(Some(pieces)) => pieces,
            None if carried.is_enough(&self.pieces, window) => &self.pieces,
            _ => return false,
        };
        let mut plane = Plane::new(window, spacing);
        // Map by map, since the first letter of a piece alone says its colour.
        for letter in 0..frame.maps.len() {
            let code = Letters::NONE.then(letter).code();
            let first =
                |piece: &&MassPiece| Letters::of_code(piece.letters.code()).is_some_and(|l| l[0] == letter);
            for piece in pieces.iter().filter(first) {
                plane.add(&piece.map, carried.masses(size(piece)), piece.mass as f32 * self.gain);
            }
            plane.fold(colours.colour(code), sums);
        }
        plane.sharpen(sums);
        true
    }
}

#[cfg(test)]
mod tests {
    use frond_core::{Colouring, Hull, Ifs};
    use glam::DVec2;

    use super::*;
    use crate::picture::view::View;
    use crate::testing::{NASTY, PLAIN, ifs, of_rows, some_ifs};

    const WINDOW: Window = Window { width: 160, height: 120 };

    struct Subject {
        frame: Frame,
        view: View,
        colours: Colours,
    }

    fn subject(ifs: &Ifs, zoom: f64) -> Subject {
        let hull = Hull::of(ifs);
        let frame = Frame::within(ifs, &hull);
        let fit = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
        let at = frame.to_world.apply(frame.anchor);
        let view = if zoom > 1.0 { View { x: at.x, y: at.y, scale: fit.scale * zoom } } else { fit };
        Subject { colours: Colours::new(Colouring::Density, &[], ifs.len()), frame, view }
    }

    fn carried(subject: &Subject, spacing: f64) -> Option<Vec<[f32; 4]>> {
        let Subject { frame, view, colours } = subject;
        let density = Density::new(frame, *view, WINDOW, 128, 512);
        let to_screen = view.onto_screen(frame.to_world, WINDOW);
        let mut sums = vec![[0.0; 4]; WINDOW.area()];
        density.carry(frame, Some(to_screen), colours, (WINDOW, spacing), &mut sums).then_some(sums)
    }

    /// The same by chance, of many points.
    fn thrown(subject: &Subject) -> Vec<[f32; 4]> {
        let Subject { frame, view, colours } = subject;
        let mut density = Density::new(frame, *view, WINDOW, 512, 2048);
        let mut sums = vec![[0.0; 4]; WINDOW.area()];
        for _ in 0..8 {
            density.accumulate(frame, colours, WINDOW, &mut Vec::new(), &mut sums);
        }
        sums.iter().map(|sum| sum.map(|x| x / 8.0)).collect()
    }

    /// Sums over squares of pixels, without edges: what lies on one is not on either side by chance.
    fn blocks(sums: &[[f32; 4]], side: usize) -> Vec<[f32; 4]> {
        let across = WINDOW.width as usize / side + 2;
        let mut blocks = vec![[0.0; 4]; across * (WINDOW.height as usize / side + 2)];
        let split = |at: usize| (at / side, (at % side) as f32 / side as f32);
        for (i, sum) in sums.iter().enumerate() {
            let ((x, right), (y, below)) =
                (split(i % WINDOW.width as usize), split(i / WINDOW.width as usize));
            for (at, share) in [
                (y * across + x, (1.0 - right) * (1.0 - below)),
                (y * across + x + 1, right * (1.0 - below)),
                ((y + 1) * across + x, (1.0 - right) * below),
                ((y + 1) * across + x + 1, right * below),
            ] {
                blocks[at] = std::array::from_fn(|k| blocks[at][k] + share * sum[k]);
            }
        }
        blocks
    }

    /// How far two pictures differ, as a part of the first.
    fn differ(a: &[[f32; 4]], b: &[[f32; 4]]) -> f32 {
        let apart = |(a, b): (&[f32; 4], &[f32; 4])| (0..4).map(|k| (a[k] - b[k]).abs()).sum::<f32>();
        let total: f32 = a.iter().flatten().sum();
        a.iter().zip(b).map(apart).sum::<f32>() / total
    }

    #[test]
    fn what_is_carried_lies_where_what_is_thrown_does() {
        let uneven = ifs("gasket").with_probabilities(&[0.7, 0.2, 0.1]).unwrap();
        let seldom = ifs("fern").with_probabilities(&[0.001, 0.9, 0.0, 0.099]).unwrap();
        let named = PLAIN.iter().map(|name| ((*name).to_owned(), ifs(name)));
        let random = (0..20).map(|seed| (format!("some {seed}"), some_ifs(seed)));
        let weighted = [("uneven".to_owned(), uneven), ("seldom".to_owned(), seldom)];
        let mut seen = 0;
        for (name, ifs) in named.chain(weighted).chain(random) {
            for zoom in [1.0, 30.0] {
                let subject = subject(&ifs, zoom);
                let Some(sums) = carried(&subject, 0.4) else { continue };
                seen += 1;
                let thrown = thrown(&subject);
                // Points that hit nothing: what is far away from the window's middle may be empty.
                if thrown.iter().all(|sum| sum[3] == 0.0) {
                    continue;
                }
                let apart = differ(&blocks(&thrown, 8), &blocks(&sums, 8));
                assert!(apart < 0.12, "{name} x{zoom}: {apart}");
            }
        }
        assert!(seen > 2 * PLAIN.len(), "{seen}");
    }

    #[test]
    fn a_square_is_even_at_any_angle() {
        for degrees in [0.0_f64, 7.0, 30.0, 45.0] {
            let turn = Affine2::similitude(1.0, degrees.to_radians(), DVec2::new(3.0, -2.0));
            let subject = subject(&ifs("square").conjugate(turn).unwrap(), 1.0);
            for (spacing, most) in [(0.4, 0.04), (0.8, 0.05)] {
                let sums = carried(&subject, spacing).unwrap();
                let middle = (50..70).flat_map(|y| (70..90).map(move |x| y * 160 + x));
                let weights: Vec<f32> = middle.map(|at| sums[at][3]).collect();
                let mean = weights.iter().sum::<f32>() / weights.len() as f32;
                let spread = weights.iter().map(|w| (w - mean).powi(2)).sum::<f32>() / weights.len() as f32;
                assert!(spread.sqrt() < most * mean, "{degrees} {spacing}: {} {mean}", spread.sqrt());
            }
        }
    }

    #[test]
    fn no_mass_is_lost_and_none_is_made() {
        for (name, spacing) in PLAIN.iter().flat_map(|name| [(name, 0.4), (name, 0.8)]) {
            let subject = subject(&ifs(name), 1.0);
            let density = Density::new(&subject.frame, subject.view, WINDOW, 128, 512);
            let total: f32 = carried(&subject, spacing).unwrap().iter().map(|sum| sum[3]).sum();
            assert!((total / density.gain - 1.0).abs() < 1e-3, "{name}: {}", total / density.gain);
        }
    }

    #[test]
    fn what_overlaps_without_end_is_left_to_chance_and_nothing_else_is() {
        for name in PLAIN.iter().chain(NASTY) {
            for zoom in [1.0, 1e6] {
                let sums = carried(&subject(&ifs(name), zoom), 0.4);
                assert!(sums.is_some() || NASTY.contains(name), "{name} x{zoom}");
                assert!(sums.is_none_or(|sums| sums.iter().flatten().all(|x| x.is_finite())), "{name}");
            }
        }
        let flat = of_rows(&[[0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]]);
        let sums = carried(&subject(&flat, 1.0), 0.4).unwrap();
        assert!(sums.iter().flatten().all(|x| x.is_finite()) && sums.iter().any(|sum| sum[3] > 0.0));
    }
}
