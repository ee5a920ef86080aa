//! Points of an attractor on a grid, however much its pieces overlap.

use frond_core::Affine2;
use glam::DVec2;

use crate::bitmap::Bitmap;
use crate::frame::Frame;
use crate::letters::Letters;
use crate::window::Window;

/// A point of the attractor in unit coordinates, with the first letters of its address.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CloudPoint {
    /// Where it is, within the unit disc.
    pub position: [f32; 2],
    /// Its address.
    pub letters: Letters,
}

/// Grows a set of points of the attractor: each point found is taken through all maps, and images in
/// cells of a grid that hold no point yet are kept. So the work is bounded by the number of cells, where
/// words may be countless.
///
/// Every point of the attractor has one of the set within `sqrt 2 / (1 - r)` cells, r being the ratio by
/// which the maps contract, and mostly within the same cell.
#[derive(Debug)]
pub struct Flood {
    maps: Vec<Affine2>,
    cells: Bitmap,
    points: Vec<CloudPoint>,
    next: usize,
}

impl Flood {
    /// A flood on `size` x `size` cells over the square around the unit disc.
    #[must_use]
    pub fn new(frame: &Frame, size: u32) -> Self {
        let mut flood = Self {
            maps: frame.maps.clone(),
            cells: Bitmap::new(Window { width: size, height: size }),
            points: Vec::new(),
            next: 0,
        };
        flood.keep(frame.anchor, Letters::NONE);
        for (letter, map) in frame.maps.iter().enumerate() {
            if let Some(fixed) = map.fixed_point() {
                flood.keep(fixed, Letters::NONE.then(letter).then(letter).then(letter));
            }
        }
        flood
    }

    /// Takes about `budget` points through a map. Returns whether all are done.
    pub fn run(&mut self, budget: u64) -> bool {
        let turns = (budget / self.maps.len().max(1) as u64).max(1);
        for _ in 0..turns {
            let Some(&CloudPoint { position: [x, y], letters }) = self.points.get(self.next) else {
                return true;
            };
            self.next += 1;
            let point = DVec2::new(f64::from(x), f64::from(y));
            for letter in (0..self.maps.len()).rev() {
                let image = self.maps[letter].apply(point);
                self.keep(image, Letters::NONE.then(letter).join(letters));
            }
        }
        self.next >= self.points.len()
    }

    #[inline]
    fn keep(&mut self, point: DVec2, letters: Letters) {
        let half = 0.5 * f64::from(self.cells.window().width);
        let Some(cell) = self.cells.window().pixel((point + DVec2::ONE) * half) else { return };
        if self.cells.set(cell) {
            self.points.push(CloudPoint { position: [point.x as f32, point.y as f32], letters });
        }
    }

    /// The points found so far.
    #[must_use]
    pub fn points(&self) -> &[CloudPoint] {
        &self.points
    }

    /// The points found.
    #[must_use]
    pub fn into_points(self) -> Vec<CloudPoint> {
        self.points
    }
}
