//! Points of an attractor on a grid, however much its pieces overlap.

use frond_core::Affine2;
use glam::DVec2;

use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;

/// A point of the attractor in unit coordinates, with the first letters of its address.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CloudPoint {
    /// Where it is, within the unit disc.
    pub position: [f32; 2],
    /// Its address.
    pub letters: Letters,
}

/// Grows a set of points of the attractor: each point found is taken through all steps of the frame, and
/// images in cells of a grid that hold no point yet are kept. So the work is bounded by the number of cells,
/// where words may be countless.
///
/// Every point of the attractor that some steps lead to has one of the set within `sqrt 2 / (1 - r)` cells,
/// r being the ratio by which they contract, and mostly within the same cell.
#[derive(Debug)]
pub struct Flood {
    steps: Vec<(Affine2, Letters)>,
    cells: Bitmap,
    points: Vec<CloudPoint>,
    next: usize,
}

impl Flood {
    /// A flood on `size` x `size` cells over the square around the unit disc.
    #[must_use]
    pub fn new(frame: &Frame, size: u32) -> Self {
        let mut flood = Self {
            steps: frame.steps.clone(),
            cells: Bitmap::new(Window { width: size, height: size }),
            points: Vec::new(),
            next: 0,
        };
        flood.keep(frame.anchor, Letters::NONE);
        for (step, letters) in &frame.steps {
            if let Some(fixed) = step.fixed_point() {
                flood.keep(fixed, *letters);
            }
        }
        flood
    }

    /// Takes about `budget` points through a map. Returns whether all are done.
    pub fn run(&mut self, budget: u64) -> bool {
        let turns = (budget / self.steps.len().max(1) as u64).max(1);
        for _ in 0..turns {
            let Some(&CloudPoint { position: [x, y], letters }) = self.points.get(self.next) else {
                return true;
            };
            self.next += 1;
            let point = DVec2::new(f64::from(x), f64::from(y));
            for i in (0..self.steps.len()).rev() {
                let (step, prefix) = self.steps[i];
                self.keep(step.apply(point), prefix.join(letters));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{NASTY, PLAIN, ifs};

    #[test]
    fn every_point_of_the_shape_has_one_of_the_flood_near_it_and_none_is_outside() {
        const SIZE: u32 = 128;
        for name in PLAIN.iter().chain(NASTY) {
            let frame = Frame::of(&ifs(name));
            let mut flood = Flood::new(&frame, SIZE);
            while !flood.run(10_000) {}
            let points: Vec<DVec2> =
                flood.points().iter().map(|p| glam::Vec2::from(p.position).as_dvec2()).collect();
            assert!(points.len() <= (SIZE * SIZE) as usize, "{name}");
            let mut cells = Bitmap::new(Window { width: SIZE, height: SIZE });
            let cell = |p: DVec2| ((p + DVec2::ONE) * f64::from(SIZE / 2)).as_ivec2();
            for point in &points {
                let at = cell(*point);
                cells.set((at.x as u32, at.y as u32));
                assert!(point.length() < 1.001, "{name}: {point}");
            }
            let mut point = frame.anchor;
            let mut far = 0;
            for i in 0..5000 {
                let letter = frond_core::hash::counter(3, i) as usize % frame.maps.len();
                point = frame.maps[letter].apply(point);
                let at = cell(point);
                let near = (-2..=2).any(|dx| {
                    (-2..=2).any(|dy| cells.get(((at.x + dx).max(0) as u32, (at.y + dy).max(0) as u32)))
                });
                far += usize::from(!near);
            }
            assert!(far < 25, "{name}: {far} of 5000");
        }
    }

    #[test]
    fn points_have_the_letters_of_their_piece() {
        let frame = Frame::of(&ifs("gasket"));
        let mut flood = Flood::new(&frame, 64);
        flood.run(u64::MAX);
        for point in flood.into_points() {
            let at = glam::Vec2::from(point.position).as_dvec2();
            let [first, ..] = Letters::of_code(point.letters.code()).unwrap();
            // Its piece is half as large, around the image of the disc's centre.
            let away = at - frame.maps[first].translation;
            assert!(point.letters.count() == 0 || away.length() < 0.51, "{at} {first}");
        }
    }

    #[test]
    fn maps_that_hardly_shrink_are_taken_in_large_steps() {
        let frame = Frame::of(&ifs("slow line"));
        let mut flood = Flood::new(&frame, 256);
        flood.run(u64::MAX);
        assert!(flood.points().len() > 150, "{}", flood.points().len());
    }
}
