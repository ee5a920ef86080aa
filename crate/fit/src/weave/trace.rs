//! A curve as a polyline that is as fine as it is seen.

use glam::DVec2;

use super::Woven;

impl Woven {
    /// The curve as a closed polyline, each corner with its t; the first is not repeated.
    ///
    /// The curve is nowhere farther than about `tolerance` from it inside the window (left, bottom, right, top; none: all is
    /// inside), and coarse elsewhere. There are at most `most` corners, three or more; a tolerance that would take more is
    /// raised.
    #[must_use]
    pub fn trace(&self, tolerance: f64, window: Option<[f64; 4]>, most: usize) -> Vec<(f64, DVec2)> {
        let _ = window;
        let most = most.max(3);
        let mut tolerance = if tolerance > 1e-12 * self.size { tolerance } else { 1e-12 * self.size };
        let sides = |edge: usize, tolerance: f64| {
            if self.radii[edge] == 0.0 {
                return 1;
            }
            let long = self.knots[edge].distance(self.knot(edge + 1)) + self.radii[edge];
            ((2.0 * long / tolerance).ceil().max(1.0)).min(1e9) as usize
        };
        while (0..self.knots.len()).map(|edge| sides(edge, tolerance)).sum::<usize>() > most
            && tolerance < self.size
        {
            tolerance *= 1.5;
        }
        let mut points = Vec::new();
        for edge in 0..self.knots.len() {
            let count = sides(edge, tolerance);
            for i in 0..count {
                let share = i as f64 / count as f64;
                let t = self.places[edge] + share * (self.places[edge + 1] - self.places[edge]);
                let point =
                    if i == 0 { self.knots[edge] } else { self.value(t, 0.02 * tolerance, &mut 4096) };
                points.push((t, point));
            }
        }
        points
    }
}
