//! The index buffer: connectedness seen in a picture.

use frond_core::{Affine2, Hull, Ifs, hash};
use glam::DVec2;
use thiserror::Error;

use crate::overlap_graph::OverlapGraph;

/// How maps are chosen in the chaos game.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Choice {
    /// Each as likely as any other, as in the paper.
    #[default]
    Uniform,
    /// By the probabilities of the system, which go by area unless others were given: the points fall more
    /// evenly, which the paper recommends.
    Weighted,
}

/// How to fill an index buffer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndexBufferOptions {
    /// Pixels along a side, 1 to [`IndexBuffer::LARGEST`].
    pub size: usize,
    /// Points of the chaos game.
    pub points: u32,
    /// Seed of its random numbers.
    pub seed: u32,
    /// How maps are chosen.
    pub choice: Choice,
    /// By how much the window is larger than the attractor, relative to it: 0 to 10.
    pub margin: f64,
    /// The window itself, lower left and upper right corner in units of the plane; the margin then counts for
    /// nothing. Its pixels are as wide and as high as it is. Points outside are not plotted.
    pub window: Option<[DVec2; 2]>,
}

impl Default for IndexBufferOptions {
    fn default() -> Self {
        Self { size: 600, points: 1_000_000, seed: 1, choice: Choice::Uniform, margin: 0.05, window: None }
    }
}

/// Why an index buffer cannot be filled.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum IndexBufferError {
    /// No pixels, or too many.
    #[error("An index buffer of {size} pixels a side cannot be made. Give 1 to 8192.")]
    Size {
        /// Pixels along a side.
        size: usize,
    },
    /// The margin is negative, not a number or too large.
    #[error("The margin of the index buffer is {margin}. Give 0 to 10.")]
    Margin {
        /// What was given.
        margin: f64,
    },
    /// The window has no area, or numbers that are not finite or too large.
    #[error(
        "The window of the index buffer has no area. Give the lower left corner and then the upper right one, in numbers \
         from -1e100 to 1e100."
    )]
    Window,
}

impl IndexBufferError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Size { .. } => "index-buffer-size",
            Self::Margin { .. } => "index-buffer-margin",
            Self::Window => "index-buffer-window",
        }
    }
}

/// A picture of an attractor in which each pixel holds the map whose piece was plotted there last, and the
/// overlap graph that the collisions made (Burch & Hart 1997, Fig 2).
///
/// What it calls connected depends on the window, the resolution and the number of points: their Table 1.
#[derive(Clone, Debug)]
pub struct IndexBuffer {
    /// `size` x `size` pixels, row 0 on top: 0 where it is empty, else 1 + the map.
    pub pixels: Vec<u8>,
    /// Pixels along a side.
    pub size: usize,
    /// Which pieces were plotted in the same pixel.
    pub graph: OverlapGraph,
}

impl IndexBuffer {
    /// The most pixels along a side.
    pub const LARGEST: usize = 8192;

    /// Plays the chaos game into the buffer. The window is the bounding box of the attractor, made square, if none is
    /// given: then borders between pixels may run through the very points where pieces meet, so that an even number of
    /// pixels never sees the gasket whole at 1/2.
    ///
    /// # Errors
    /// [`IndexBufferError`] for sizes, margins and windows out of range.
    pub fn run(ifs: &Ifs, options: &IndexBufferOptions) -> Result<Self, IndexBufferError> {
        let &IndexBufferOptions { size, points, seed, choice, margin, window } = options;
        if !(1..=Self::LARGEST).contains(&size) {
            return Err(IndexBufferError::Size { size });
        }
        if !(0.0..=10.0).contains(&margin) {
            return Err(IndexBufferError::Margin { margin });
        }
        let hull = Hull::of(ifs);
        let (corner, sides) = window.map_or_else(|| about(&hull, margin), |[low, high]| (low, high - low));
        let scale = DVec2::splat(size as f64) / sides;
        let fits = |p: DVec2| p.abs().max_element() <= LARGEST_NUMBER;
        let is_window = |[low, high]: [DVec2; 2]| fits(low) && fits(high) && sides.cmpgt(DVec2::ZERO).all();
        if window.is_some_and(|window| !(is_window(window) && scale.is_finite())) {
            return Err(IndexBufferError::Window);
        }
        let count = ifs.len();
        let view = View { size, corner, scale, clipped: window.is_some() };
        let start = ifs.maps()[0].fixed_point().unwrap_or(hull.centre());
        let (pixels, seen) = match choice {
            Choice::Uniform => {
                let map = |random: u32| ((u64::from(random) * count as u64) >> 32) as usize;
                play(ifs.maps(), start, points, seed, view, map)
            }
            Choice::Weighted => {
                let upto = thresholds(ifs);
                let map = |random| upto.iter().position(|&most| random <= most).unwrap_or(count - 1);
                play(ifs.maps(), start, points, seed, view, map)
            }
        };

        let mut graph = OverlapGraph::new(count);
        for i in 0..count {
            for j in (0..count).filter(|j| seen[i * (count + 1) + j + 1]) {
                graph.add(i, j);
            }
        }
        Ok(Self { pixels, size, graph })
    }

    /// What the buffer says: Fig 2's answer.
    #[must_use]
    pub const fn is_connected(&self) -> bool {
        self.graph.is_connected()
    }
}

/// The largest coordinate of a window.
const LARGEST_NUMBER: f64 = 1e100;

/// The bounding box, made square and larger by the margin: its lower left corner and its sides.
fn about(hull: &Hull, margin: f64) -> (DVec2, DVec2) {
    let side = (hull.max() - hull.min()).max_element() * (1.0 + margin);
    // An attractor that is one point lands in the middle of any window.
    let side = if side > 0.0 { side } else { 1.0 };
    let corner = (hull.min() + hull.max() - DVec2::splat(side)) * 0.5;
    (corner, DVec2::splat(side))
}

/// From the plane to pixels, with y still pointing up.
#[derive(Clone, Copy)]
struct View {
    size: usize,
    corner: DVec2,
    scale: DVec2,
    /// Whether what is outside is left out. Else nothing is outside, but for rounding.
    clipped: bool,
}

/// The game: the pixels, and for each map whether it met an empty pixel or one of each map.
fn play(
    maps: &[Affine2],
    start: DVec2,
    points: u32,
    seed: u32,
    View { size, corner, scale, clipped }: View,
    map: impl Fn(u32) -> usize,
) -> (Vec<u8>, Vec<bool>) {
    let mut pixels = vec![0_u8; size * size];
    let mut seen = vec![false; maps.len() * (maps.len() + 1)];
    let most = DVec2::splat(size as f64);
    let mut x = start;
    for step in 0..points {
        let i = map(hash::counter(seed, step));
        x = maps[i].apply(x);
        let p = (x - corner) * scale;
        if clipped && !(p.cmpge(DVec2::ZERO).all() && p.cmple(most).all()) {
            continue;
        }
        // From above and below: the last pixels hold the upper border, and rounding may carry a point out of a window
        // without a margin.
        let column = (p.x as usize).min(size - 1);
        let row = size - 1 - (p.y as usize).min(size - 1);
        let pixel = &mut pixels[row * size + column];
        seen[i * (maps.len() + 1) + usize::from(*pixel)] = true;
        *pixel = i as u8 + 1;
    }
    (pixels, seen)
}

/// The largest random number that chooses each map or one before it.
fn thresholds(ifs: &Ifs) -> Vec<u32> {
    let mut sum = 0.0;
    let add = |p: &f64| {
        sum += p;
        (sum * 4_294_967_296.0 - 1.0) as u32
    };
    ifs.probabilities().iter().map(add).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gasket(scale: f64) -> Ifs {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        Ifs::new(corners.map(|c| Affine2::similitude(scale, 0.0, c * (1.0 - scale))).to_vec()).unwrap()
    }

    fn run(ifs: &Ifs, size: usize) -> IndexBuffer {
        IndexBuffer::run(ifs, &IndexBufferOptions { size, ..Default::default() }).unwrap()
    }

    #[test]
    fn finer_buffers_tell_smaller_gaps_as_in_table_1() {
        // The smallest scale that each resolution calls connected comes up to 1/2.
        let critical = |size| {
            let (mut broken, mut whole) = (0.4, 0.52);
            while whole - broken > 1e-4 {
                let middle = f64::midpoint(broken, whole);
                if run(&gasket(middle), size).is_connected() { whole = middle } else { broken = middle }
            }
            whole
        };
        let scales = [75, 150, 300, 600].map(critical);
        assert!(scales.is_sorted() && scales[0] > 0.47 && scales[0] < 0.499, "{scales:?}");
        assert!(scales[3] > 0.496 && scales[3] < 0.503, "{scales:?}");
    }

    #[test]
    fn a_window_off_the_middle_sees_the_gasket_whole_at_one_half() {
        let even = |size: usize, shift: f64| {
            // The window about the attractor, moved by a part of a pixel.
            let (middle, side) = (DVec2::new(0.5, 0.75_f64.sqrt() / 2.0), 1.05);
            let low = middle - DVec2::splat(side / 2.0 + shift * side / size as f64);
            let options = IndexBufferOptions {
                size,
                window: Some([low, low + DVec2::splat(side)]),
                ..IndexBufferOptions::default()
            };
            IndexBuffer::run(&gasket(0.5), &options).unwrap()
        };
        for size in [64, 150] {
            assert!(!run(&gasket(0.5), size).is_connected() && !even(size, 0.0).is_connected(), "{size}");
            assert!(even(size, 0.3).is_connected(), "{size}");
        }
    }

    #[test]
    fn a_window_shows_its_part_alone() {
        let low = DVec2::ZERO;
        let look = |window| {
            let options = IndexBufferOptions { size: 32, window: Some(window), ..Default::default() };
            IndexBuffer::run(&gasket(0.5), &options)
        };
        // The first piece alone; with its neighbours' corners at the border.
        let first = look([low, DVec2::new(0.49, 0.42)]).unwrap();
        assert!(first.pixels.iter().all(|&p| p <= 1) && first.pixels.contains(&1));
        assert_eq!(first.graph.edges(), []);
        // Nothing of it at all.
        assert!(look([DVec2::splat(5.0), DVec2::splat(6.0)]).unwrap().pixels.iter().all(|&p| p == 0));
        // Wider than high: pixels are, too. The lower left one holds the corner.
        let wide = look([low, DVec2::new(4.0, 0.9)]).unwrap();
        assert!(
            wide.pixels[31 * 32] == 1
                && wide.pixels[..32 * 32].chunks(32).all(|row| row[8..].iter().all(|&p| p == 0))
        );
        for bad in [
            [low, low],
            [DVec2::ONE, low],
            [low, DVec2::X],
            [low, DVec2::splat(f64::NAN)],
            [low, DVec2::INFINITY],
            [DVec2::splat(-1e300), DVec2::splat(1e300)],
            [low, DVec2::splat(5e-324)],
        ] {
            assert_eq!(look(bad).unwrap_err().code(), "index-buffer-window", "{bad:?}");
        }
    }

    #[test]
    fn the_pixels_hold_the_pieces() {
        let buffer = run(&gasket(0.5), 64);
        // The third piece is on top, the first at the lower left.
        let lower = |x: usize, value| (52..60).any(|y| buffer.pixels[y * 64 + x] == value);
        assert!(buffer.pixels[..64 * 16].iter().all(|&p| p == 0 || p == 3));
        assert!(lower(5, 1) && !lower(5, 2) && lower(58, 2) && !lower(58, 1));
        assert_eq!(run(&gasket(0.52), 64).graph.edges(), [(0, 1), (0, 2), (1, 2)]);
        assert_eq!(run(&gasket(0.4), 64).graph.components().labels(), [0, 1, 2]);
    }

    #[test]
    fn weights_reach_a_thin_piece_less_often() {
        let maps = [[0.9, 0.0, 0.0, 0.9, 0.0, 0.0], [0.0, 0.0, 0.0, 0.1, 0.0, 3.0]].map(Affine2::from_row);
        let ifs = Ifs::new(maps.to_vec()).unwrap();
        let lit = |choice| {
            let options = IndexBufferOptions { choice, points: 400, ..Default::default() };
            IndexBuffer::run(&ifs, &options).unwrap().pixels.iter().filter(|&&p| p == 2).count()
        };
        assert!(lit(Choice::Weighted) < lit(Choice::Uniform));
    }

    #[test]
    fn points_and_bad_options_are_no_trouble() {
        let point = Ifs::new(vec![Affine2::similitude(0.0, 0.0, DVec2::new(3.0, 4.0)); 2]).unwrap();
        let options = IndexBufferOptions { size: 1, points: 10, margin: 0.0, ..Default::default() };
        assert!(IndexBuffer::run(&point, &options).unwrap().is_connected());
        assert!(
            !IndexBuffer::run(&point, &IndexBufferOptions { points: 0, ..options }).unwrap().is_connected()
        );
        for (size, margin, code) in [
            (0, 0.0, "index-buffer-size"),
            (1 << 40, 0.0, "index-buffer-size"),
            (9, f64::NAN, "index-buffer-margin"),
        ] {
            let options = IndexBufferOptions { size, margin, ..options };
            assert_eq!(IndexBuffer::run(&point, &options).unwrap_err().code(), code);
        }
    }
}
