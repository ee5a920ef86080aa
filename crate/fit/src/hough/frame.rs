//! The units in which votes are counted.

use glam::DVec2;

use super::features::Features;

/// From the features' own units to an interval and heights from -1 to 1, and back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    middle: DVec2,
    half: DVec2,
}

impl Frame {
    pub fn of(fine: &Features) -> Self {
        let ([start, end], [low, high]) = (fine.interval(), fine.heights());
        let tall = 0.5 * (high - low);
        let half = DVec2::new(0.5 * (end - start), if tall > 0.0 { tall } else { 1.0 });
        Self { middle: DVec2::new(f64::midpoint(start, end), f64::midpoint(low, high)), half }
    }

    pub fn inside(&self, p: DVec2) -> DVec2 {
        (p - self.middle) / self.half
    }

    /// A map between points of the frame as one between points as they were given.
    pub fn out(&self, [a, b, c, d, e]: [f64; 5]) -> [f64; 5] {
        let slope = b * self.half.y / self.half.x;
        let shift = self.middle.x + self.half.x * d - a * self.middle.x;
        let rise = self.middle.y + self.half.y * e - slope * self.middle.x - c * self.middle.y;
        [a, slope, c, shift, rise]
    }

    /// The other way round.
    pub fn into(self, [a, b, c, d, e]: [f64; 5]) -> [f64; 5] {
        let slope = b * self.half.x / self.half.y;
        let shift = (d + a * self.middle.x - self.middle.x) / self.half.x;
        let rise = (e + b * self.middle.x + c * self.middle.y - self.middle.y) / self.half.y;
        [a, slope, c, shift, rise]
    }

    /// t of the frame as it was given.
    pub fn t(&self, t: f64) -> f64 {
        self.middle.x + self.half.x * t
    }

    /// A difference of heights as it was given.
    pub fn height(&self, x: f64) -> f64 {
        self.half.y * x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_goes_into_the_frame_and_out_again() {
        let points = [(1990.0, 3.0), (2000.0, -5.0), (2024.0, 40.0)].map(DVec2::from);
        let frame = Frame::of(&Features::new(&points).unwrap());
        let map = [-0.4, 0.3, 0.6, 2800.0, -7.0];
        for (a, b) in frame.out(frame.into(map)).into_iter().zip(map) {
            assert!((a - b).abs() < 1e-9);
        }
        // Where a point goes is the same in both.
        let [a, b, c, d, e] = map;
        let p = DVec2::new(2003.0, 11.0);
        let image = frame.inside(DVec2::new(a * p.x + d, b * p.x + c * p.y + e));
        let ([a, b, c, d, e], q) = (frame.into(map), frame.inside(p));
        assert!(image.distance(DVec2::new(a * q.x + d, b * q.x + c * q.y + e)) < 1e-9);
    }
}
