//! Points that stand for the attractor, about one to a cell of a grid.

use glam::DVec2;
use wide::i16x8;

use super::whole::split_point;
use crate::coverage::flood::{CloudPoint, Flood};
use crate::pieces::frame::Frame;

/// Points that are placed at once: the compiler takes four to an instruction where there are eight, and none of four.
pub const LANES: usize = 8;

/// Points of the attractor in unit coordinates.
#[derive(Debug)]
pub struct Cloud {
    pub points: Vec<CloudPoint>,
    /// Where they are in whole numbers, as many as are placed at once: of four and four the x of each and its y, high
    /// parts and low ones. Behind the last of all are zeros.
    pub places: Vec<[[i16x8; 2]; 2]>,
}

impl Cloud {
    /// A cloud of these points.
    pub fn of(points: Vec<CloudPoint>) -> Self {
        let place = |chunk: &[CloudPoint]| {
            let mut parts = [[[0; 8]; 2]; 2];
            for (k, point) in chunk.iter().enumerate() {
                for (part, [x, y]) in parts[k / 4].iter_mut().zip(split_point(point.position)) {
                    [part[2 * (k % 4)], part[2 * (k % 4) + 1]] = [x, y];
                }
            }
            parts.map(|half| half.map(i16x8::new))
        };
        let places = points.chunks(LANES).map(place).collect();
        Self { points, places }
    }
}

/// Clouds for pieces of a size, a little less, and so on.
#[derive(Debug)]
pub struct Clouds {
    clouds: [Option<Cloud>; COUNT],
    /// Points of the attractor, nearer to each other than those of any cloud.
    points: Vec<CloudPoint>,
    largest: f64,
    spacing: f64,
}

/// The number of clouds, and how much smaller the pieces of the next one are: the fourth root of a half.
pub const COUNT: usize = 24;
pub const NEXT: f64 = 0.840_896_415_253_714_5;
/// How many times nearer to each other the points are that those of clouds are chosen of.
const CHOICE: f64 = 2.0;

impl Clouds {
    /// Clouds for pieces of at most `largest` pixels, whose points are `spacing` pixels apart.
    pub fn new(frame: &Frame, largest: f64, spacing: f64) -> Self {
        let mut flood = Flood::new(frame, (largest * CHOICE / spacing).ceil() as u32);
        flood.run(u64::MAX);
        Self { clouds: [const { None }; COUNT], points: flood.into_points(), largest, spacing }
    }

    /// The cloud for pieces of a size, by its number.
    pub fn which(&self, size: f64) -> usize {
        let (mut which, mut upper) = (0, self.largest);
        while which + 1 < COUNT && size <= upper * NEXT {
            upper *= NEXT;
            which += 1;
        }
        which
    }

    /// The cloud for pieces of a size.
    pub fn for_size(&mut self, size: f64) -> &Cloud {
        self.get(self.which(size))
    }

    /// The cloud of such a number.
    pub fn get(&mut self, which: usize) -> &Cloud {
        let (points, spacing) = (&self.points, self.spacing);
        let upper = (0..which).fold(self.largest, |upper, _| upper * NEXT);
        self.clouds[which].get_or_insert_with(|| thinned(points, (upper / spacing).ceil().max(1.0) as usize))
    }
}

/// Of the points in each cell of a grid the one nearest to its middle: points that are spaced evenly leave the fewest
/// pixels out.
fn thinned(points: &[CloudPoint], side: usize) -> Cloud {
    let half = 0.5 * side as f64;
    let mut nearest = vec![(u32::MAX, f32::INFINITY); side * side];
    for (i, point) in points.iter().enumerate() {
        let at = (glam::Vec2::from(point.position).as_dvec2() + DVec2::ONE) * half;
        // A cast of what is below 0 gives 0.
        let (x, y) = ((at.x as usize).min(side - 1), (at.y as usize).min(side - 1));
        let away = (at - DVec2::new(x as f64 + 0.5, y as f64 + 0.5)).length_squared() as f32;
        let cell = &mut nearest[y * side + x];
        if away < cell.1 {
            *cell = (i as u32, away);
        }
    }
    Cloud::of(nearest.iter().filter_map(|(i, _)| points.get(*i as usize).copied()).collect())
}
