//! The nearest point of a polyline, by a grid of cells.

use glam::DVec2;

use super::bounds;

/// How far rounding may take what lies on the wall of a cell, in parts of the cell, and more.
const MARGIN: f64 = 1e-9;

/// So few sides are all looked at.
const FEW_SIDES: usize = 16;

/// Where the nearest point of a polyline lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// The side, from its point of this index to the next one.
    pub side: usize,
    /// How far along the side, from 0 to 1.
    pub share: f64,
    /// The square of the distance.
    pub squared: f64,
}

/// Finds the nearest point of a polyline.
#[derive(Clone, Debug)]
pub struct Nearest {
    points: Vec<DVec2>,
    sides: usize,
    low: DVec2,
    cell: f64,
    columns: usize,
    rows: usize,
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Nearest {
    /// Prepares a polyline of one point or more; `closed` adds the side from the last to the first.
    ///
    /// With no point every answer is side 0 at an infinite distance.
    #[must_use]
    #[inline(never)]
    pub fn new(points: &[DVec2], closed: bool) -> Self {
        let sides = if closed { points.len() } else { points.len().saturating_sub(1) };
        let (low, high) = if points.is_empty() { (DVec2::ZERO, DVec2::ZERO) } else { bounds(points) };
        let size = high - low;
        let cells = (points.len() as f64).sqrt().clamp(8.0, 512.0) * 1.5;
        // Not finer than the mean side: then a side is in few cells, however tangled the polyline is.
        let length: f64 = points.windows(2).map(|w| w[0].distance(w[1])).sum();
        let side = length / sides.max(1) as f64;
        let cell =
            (size.max_element() / cells).max(side.min(size.max_element() / 8.0)).max(f64::MIN_POSITIVE);
        let columns = ((size.x / cell) as usize).min(2048) + 1;
        let rows = ((size.y / cell) as usize).min(2048) + 1;
        let mut grid = Self {
            points: points.to_vec(),
            sides,
            low,
            cell,
            columns,
            rows,
            starts: vec![0; columns * rows + 1],
            items: Vec::new(),
        };
        for side in 0..sides {
            grid.each_cell(side, |grid, cell| grid.starts[cell + 1] += 1);
        }
        for i in 1..grid.starts.len() {
            grid.starts[i] += grid.starts[i - 1];
        }
        grid.items = vec![0; grid.starts[columns * rows] as usize];
        let mut filled = grid.starts.clone();
        for side in 0..sides {
            grid.each_cell(side, |grid, cell| {
                grid.items[filled[cell] as usize] = side as u32;
                filled[cell] += 1;
            });
        }
        grid
    }

    pub(crate) fn ends(&self, side: usize) -> (DVec2, DVec2) {
        (self.points[side], self.points[if side + 1 == self.points.len() { 0 } else { side + 1 }])
    }

    fn place(&self, p: DVec2) -> (usize, usize) {
        let at = (p - self.low) / self.cell;
        // A cast takes negative numbers and NaN to 0.
        ((at.x as usize).min(self.columns - 1), (at.y as usize).min(self.rows - 1))
    }

    /// The cells that a side may touch: row by row, those between its ends there and one more on each side.
    fn each_cell(&mut self, side: usize, mut act: impl FnMut(&mut Self, usize)) {
        let (mut a, mut b) = self.ends(side);
        if a.y > b.y {
            (a, b) = (b, a);
        }
        let (bottom, top) = (self.place(a).1, self.place(b).1);
        let slope = if b.y > a.y { (b.x - a.x) / (b.y - a.y) } else { 0.0 };
        for row in bottom..=top {
            let y = |r: usize| (self.low.y + r as f64 * self.cell).clamp(a.y, b.y);
            let mut x = [a.x + slope * (y(row) - a.y), a.x + slope * (y(row + 1) - a.y)];
            if bottom == top || slope == 0.0 {
                x = [a.x, b.x];
            }
            let margin = MARGIN * self.cell;
            let left = self.place(DVec2::new(x[0].min(x[1]) - margin, a.y)).0;
            let right = self.place(DVec2::new(x[0].max(x[1]) + margin, a.y)).0;
            for column in left..=right {
                act(self, row * self.columns + column);
            }
        }
    }

    /// The sides that a cell may hold, for all cells.
    pub(crate) fn cells(&self) -> impl Iterator<Item = &[u32]> {
        self.starts.windows(2).map(|w| &self.items[w[0] as usize..w[1] as usize])
    }

    /// The nearest point of the polyline to `p`.
    #[must_use]
    pub fn to(&self, p: DVec2) -> Near {
        self.search(p, Near { side: 0, share: 0.0, squared: f64::INFINITY })
    }

    /// The same, sooner where the side that is guessed is near: points in a row are mostly near the same one. Of sides
    /// that are equally near it may name another one.
    pub(crate) fn to_guessed(&self, p: DVec2, guess: usize) -> Near {
        let mut best = Near { side: 0, share: 0.0, squared: f64::INFINITY };
        if guess < self.sides {
            self.look_at(guess, p, &mut best);
        }
        self.search(p, best)
    }

    /// The nearest point to `p`, where no side is nearer than `best`, that one.
    fn search(&self, p: DVec2, mut best: Near) -> Near {
        if self.sides <= FEW_SIDES {
            if let (0, Some(point)) = (self.sides, self.points.first()) {
                best.squared = point.distance_squared(p);
            }
            (0..self.sides).for_each(|side| self.look_at(side, p, &mut best));
            return best;
        }
        let (column, row) = self.place(p);
        let most = self.columns.max(self.rows);
        for ring in 0..=most {
            let left = column.saturating_sub(ring);
            let right = (column + ring).min(self.columns - 1);
            let bottom = row.saturating_sub(ring);
            let top = (row + ring).min(self.rows - 1);
            for r in bottom..=top {
                let above = outside(p.y, self.low.y, self.cell, r);
                if above * above > best.squared {
                    continue;
                }
                let inner = r.abs_diff(row) < ring;
                let mut c = left;
                while c <= right {
                    if inner && c.abs_diff(column) < ring {
                        // Only the two ends of a row inside the ring belong to it.
                        c = (column + ring).min(self.columns);
                        continue;
                    }
                    let beside = outside(p.x, self.low.x, self.cell, c);
                    if beside * beside + above * above <= best.squared {
                        self.visit(r * self.columns + c, p, &mut best);
                    }
                    c += 1;
                }
            }
            // What was not seen yet lies beyond the walls of these cells. Outside the grid there is nothing.
            let wall = |low: f64, place: usize| low + place as f64 * self.cell;
            let walls = [
                if left > 0 { p.x - wall(self.low.x, left) } else { f64::INFINITY },
                if right + 1 < self.columns { wall(self.low.x, right + 1) - p.x } else { f64::INFINITY },
                if bottom > 0 { p.y - wall(self.low.y, bottom) } else { f64::INFINITY },
                if top + 1 < self.rows { wall(self.low.y, top + 1) - p.y } else { f64::INFINITY },
            ];
            let margin = MARGIN * self.cell;
            if walls.iter().all(|&wall| wall > margin && best.squared <= (wall - margin) * (wall - margin)) {
                break;
            }
        }
        best
    }

    fn visit(&self, cell: usize, p: DVec2, best: &mut Near) {
        for &side in &self.items[self.starts[cell] as usize..self.starts[cell + 1] as usize] {
            self.look_at(side as usize, p, best);
        }
    }

    fn look_at(&self, side: usize, p: DVec2, best: &mut Near) {
        let (a, b) = self.ends(side);
        let (share, squared) = to_side(p, a, b);
        if squared < best.squared {
            *best = Near { side, share, squared };
        }
    }
}

/// How far a coordinate is from the cells of a column or row, at least; 0 inside.
fn outside(x: f64, low: f64, cell: f64, place: usize) -> f64 {
    let from = low + place as f64 * cell;
    let off = if x < from { from - x } else { x - (from + cell) } - MARGIN * cell;
    if off > 0.0 { off } else { 0.0 }
}

/// The nearest point of a side: how far along it, and the square of the distance.
pub(crate) fn to_side(p: DVec2, a: DVec2, b: DVec2) -> (f64, f64) {
    let chord = b - a;
    let scale = chord.length_squared();
    let share = if scale > 0.0 { ((p - a).dot(chord) / scale).clamp(0.0, 1.0) } else { 0.0 };
    (share, p.distance_squared(a + chord * share))
}

#[cfg(test)]
mod tests {
    use super::*;
    use frond_core::hash;

    fn random(i: u32) -> f64 {
        f64::from(hash::unit(hash::counter(7, i)))
    }

    #[test]
    fn the_grid_finds_what_a_search_of_all_sides_finds() {
        let points: Vec<_> = (0..200).map(|i| DVec2::new(random(2 * i), 0.1 * random(2 * i + 1))).collect();
        // Sides that go all over it, and short ones in a ring, which leave most cells empty.
        let ring: Vec<_> = (0..400).map(|i| DVec2::from_angle(f64::from(i) / 63.5) * 0.5 + 0.5).collect();
        for points in [points, ring] {
            let nearest = Nearest::new(&points, true);
            for i in 0..500 {
                let p = DVec2::new(3.0 * random(1000 + 2 * i) - 1.0, 3.0 * random(1001 + 2 * i) - 1.0);
                let all = (0..points.len()).map(|s| to_side(p, points[s], points[(s + 1) % points.len()]).1);
                assert_eq!(nearest.to(p).squared, all.fold(f64::INFINITY, f64::min), "{p}");
            }
        }
    }

    #[test]
    fn degenerate_polylines_have_answers() {
        assert_eq!(Nearest::new(&[], true).to(DVec2::ONE).squared, f64::INFINITY);
        assert_eq!(Nearest::new(&[DVec2::ZERO], false).to(DVec2::X).squared, 1.0);
        assert_eq!(Nearest::new(&[DVec2::ZERO; 4], true).to(DVec2::X).squared, 1.0);
        assert_eq!(Nearest::new(&[DVec2::ZERO, DVec2::X], true).to(DVec2::NAN).squared, f64::INFINITY);
        let upright = Nearest::new(&[DVec2::ZERO, DVec2::Y * 5.0], false);
        assert_eq!(upright.to(DVec2::new(2.0, 3.0)), Near { side: 0, share: 0.6, squared: 4.0 });
    }
}
