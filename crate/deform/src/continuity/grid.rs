//! A function between the nodes of a grid.

use glam::DVec2;

use crate::continuity::footing::Footing;

/// A grid over a box, of squares or nearly, on which functions are quadratic B-splines: they and their slopes are
/// continuous. Outside of the box they stay what they are on its edge.
///
/// A grid of twice as many squares each way holds all functions of this one, without any loss ([`Grid::refine`]), so
/// that what is spread over grids of several sizes is read off the finest alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    low: DVec2,
    step: DVec2,
    /// Squares.
    columns: usize,
    rows: usize,
}

impl Grid {
    /// At least one square each way, each about `spacing` wide or less.
    pub fn new(low: DVec2, size: DVec2, spacing: f64) -> Self {
        let side = |length: f64| ((length / spacing).ceil() as usize).clamp(1, 1024);
        let (columns, rows) = (side(size.x), side(size.y));
        Self { low, step: size / DVec2::new(columns as f64, rows as f64), columns, rows }
    }

    /// Twice as fine.
    pub fn halved(self) -> Self {
        Self { step: 0.5 * self.step, columns: 2 * self.columns, rows: 2 * self.rows, ..self }
    }

    /// The width of a square.
    pub fn spacing(&self) -> f64 {
        self.step.max_element()
    }

    pub const fn width(&self) -> usize {
        self.columns + 2
    }

    pub const fn nodes(&self) -> usize {
        self.width() * (self.rows + 2)
    }

    /// The nine nodes around a point, and what they count.
    #[inline]
    pub fn footing(&self, point: DVec2) -> Footing {
        let place = (point - self.low) / self.step;
        let (x, across) = weights(place.x, self.columns);
        let (y, up) = weights(place.y, self.rows);
        let mut footing = Footing::default();
        for (j, wy) in up.into_iter().enumerate() {
            for (i, wx) in across.into_iter().enumerate() {
                footing.add(((y + j) * self.width() + x + i) as u32, wx * wy);
            }
        }
        footing
    }

    /// The same function on the grid that is twice as fine (Chaikin 1974).
    pub fn refine(&self, values: &[DVec2]) -> Vec<DVec2> {
        let fine = self.halved();
        let place = |i: usize| if i.is_multiple_of(2) { (i / 2, 0.25) } else { (i / 2, 0.75) };
        let mut list = Vec::with_capacity(fine.nodes());
        for j in 0..fine.rows + 2 {
            let (y, up) = place(j);
            let (below, above) = (&values[y * self.width()..], &values[(y + 1) * self.width()..]);
            for i in 0..fine.columns + 2 {
                let (x, across) = place(i);
                let mix = |row: &[DVec2]| row[x] * (1.0 - across) + row[x + 1] * across;
                list.push(mix(below) * (1.0 - up) + mix(above) * up);
            }
        }
        list
    }

    /// The nodes beside a node.
    pub fn neighbours(&self, node: usize) -> impl Iterator<Item = usize> + use<> {
        let (width, height) = (self.width(), self.rows + 2);
        let (x, y) = (node % width, node / width);
        let sides = [
            (x > 0).then(|| node - 1),
            (x + 1 < width).then_some(node + 1),
            (y > 0).then(|| node - width),
            (y + 1 < height).then_some(node + width),
        ];
        sides.into_iter().flatten()
    }
}

/// The first of the three nodes that a place counted in squares hangs on, and what each counts.
#[inline]
fn weights(place: f64, squares: usize) -> (usize, [f64; 3]) {
    let last = squares as f64;
    // A NaN is taken to the first.
    let place = place.max(0.0).min(last);
    let square = place.floor().min(last - 1.0);
    let t = place - square;
    (square as usize, [0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(grid: &Grid, values: &[DVec2], point: DVec2) -> DVec2 {
        grid.footing(point).iter().map(|(node, share)| values[node] * share).sum()
    }

    #[test]
    fn a_finer_grid_holds_the_same_function() {
        let grid = Grid::new(DVec2::new(-1.0, 2.0), DVec2::new(3.0, 1.0), 0.3);
        let values: Vec<DVec2> =
            (0..grid.nodes()).map(|i| DVec2::new((i * 7 % 11) as f64, (i * 5 % 13) as f64)).collect();
        let (fine, again) = (grid.halved(), grid.refine(&values));
        assert_eq!(fine.nodes(), again.len());
        for i in 0..200 {
            let point = DVec2::new(-1.2 + 0.017 * f64::from(i), 1.9 + 0.37 * f64::from(i) % 1.2);
            assert!((at(&grid, &values, point) - at(&fine, &again, point)).length() < 1e-12, "{point}");
        }
    }

    #[test]
    fn it_has_no_edges_inside() {
        let grid = Grid::new(DVec2::ZERO, DVec2::ONE, 0.2);
        let values: Vec<DVec2> = (0..grid.nodes()).map(|i| DVec2::new((i * 7 % 11) as f64, 0.0)).collect();
        let value = |x: f64| at(&grid, &values, DVec2::new(x, 0.3 + 0.4 * x)).x;
        let slope = |x: f64| (value(x + 1e-6) - value(x - 1e-6)) / 2e-6;
        // Between nodes the slope changes by some 100 a unit: nowhere does it jump.
        for i in 1..999 {
            let x = f64::from(i) / 1000.0;
            assert!((slope(x + 1e-4) - slope(x)).abs() < 0.2, "{x}: {} {}", slope(x), slope(x + 1e-4));
        }
        assert!(at(&grid, &values, DVec2::NAN).is_finite());
        assert_eq!(value(-3.0), at(&grid, &values, DVec2::new(0.0, 0.0)).x);
    }
}
