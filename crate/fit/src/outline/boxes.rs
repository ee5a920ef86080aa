//! Box counts.

use std::collections::HashSet;

use glam::DVec2;

use super::{Outline, bounds};

/// Where the corner of the grid is put, in boxes: counts are averaged over these, since a single grid is a matter of
/// luck.
const SHIFTS: [DVec2; 4] =
    [DVec2::ZERO, DVec2::new(0.5, 0.25), DVec2::new(0.25, 0.75), DVec2::new(0.75, 0.5)];

/// A field of more boxes is not kept bit by bit.
const MOST_BITS: u64 = 1 << 22;

/// How many boxes of a size, in a grid with a corner at `origin`, a polyline passes through.
///
/// `size` above zero; with another, or a size below 1e-6 of the polyline's, the answer is 0.
#[must_use]
pub fn box_count(points: &[DVec2], closed: bool, origin: DVec2, size: f64) -> usize {
    let (low, high) = bounds(points);
    if points.is_empty() || size.is_nan() || size <= 1e-6 * low.distance(high) {
        return 0;
    }
    let sides = if closed { points.len() } else { points.len().saturating_sub(1).max(1) };
    let mut boxes = Boxes::new((low - origin) / size, (high - origin) / size);
    let first = (points[0] - origin) / size;
    let mut from = (first, box_of(first));
    boxes.note(from.1);
    for i in 0..sides {
        let p = points.get(i + 1).map_or(first, |p| (*p - origin) / size);
        let to = (p, box_of(p));
        // Most sides are short.
        if from.1 != to.1 {
            pass(from, to, &mut boxes);
        }
        from = to;
    }
    boxes.count
}

/// The unit box that a point lies in.
fn box_of(p: DVec2) -> (i64, i64) {
    let floor = |x: f64| {
        let whole = x as i64;
        if x < whole as f64 { whole - 1 } else { whole }
    };
    (floor(p.x), floor(p.y))
}

/// Unit boxes that were passed: as bits, where a field of them is not too large.
struct Boxes {
    low: (i64, i64),
    columns: u64,
    bits: Vec<u64>,
    far: HashSet<(i64, i64)>,
    count: usize,
}

impl Boxes {
    fn new(low: DVec2, high: DVec2) -> Self {
        // One more on each side, for rounding.
        let low = (low.x.floor() as i64 - 1, low.y.floor() as i64 - 1);
        let wide = |from: i64, to: f64| (to.floor() as i64).saturating_sub(from).saturating_add(2) as u64;
        let (columns, rows) = (wide(low.0, high.x), wide(low.1, high.y));
        let field = columns.checked_mul(rows).filter(|&field| field <= MOST_BITS).unwrap_or(0);
        let bits = vec![0; field.div_ceil(64) as usize];
        Self { low, columns, bits, far: HashSet::new(), count: 0 }
    }

    fn note(&mut self, at: (i64, i64)) {
        let (x, y) = (at.0.wrapping_sub(self.low.0) as u64, at.1.wrapping_sub(self.low.1) as u64);
        let place = y.wrapping_mul(self.columns).wrapping_add(x);
        let is_new = match self.bits.get_mut((place / 64) as usize) {
            Some(bits) if x < self.columns && y < MOST_BITS => {
                let bit = 1 << (place % 64);
                let is_new = *bits & bit == 0;
                *bits |= bit;
                is_new
            }
            _ => self.far.insert(at),
        };
        self.count += usize::from(is_new);
    }
}

/// Notes the unit boxes from a to b, one after the other, but for the first.
fn pass((a, mut at): (DVec2, (i64, i64)), (b, end): (DVec2, (i64, i64)), boxes: &mut Boxes) {
    let direction = b - a;
    let steps = at.0.abs_diff(end.0) + at.1.abs_diff(end.1);
    // When the side crosses the next upright and the next level line of the grid.
    let cross = |at: i64, from: f64, direction: f64| {
        let line = if direction > 0.0 { at as f64 + 1.0 } else { at as f64 };
        if direction == 0.0 { f64::INFINITY } else { (line - from) / direction }
    };
    for _ in 0..steps {
        let upright = if at.0 == end.0 { f64::INFINITY } else { cross(at.0, a.x, direction.x) };
        let level = if at.1 == end.1 { f64::INFINITY } else { cross(at.1, a.y, direction.y) };
        if upright <= level {
            at.0 += if direction.x > 0.0 { 1 } else { -1 };
        } else {
            at.1 += if direction.y > 0.0 { 1 } else { -1 };
        }
        boxes.note(at);
    }
}

/// The slope of log(boxes) against log(1 / size) by least squares: the box dimension at these sizes.
#[must_use]
pub fn box_slope_of(points: &[DVec2], closed: bool, sizes: &[f64]) -> f64 {
    slope_from(points, closed, bounds(points).0, sizes)
}

fn slope_from(points: &[DVec2], closed: bool, origin: DVec2, sizes: &[f64]) -> f64 {
    let mean_log = |size: f64| {
        let logs =
            SHIFTS.map(|shift| (box_count(points, closed, origin - shift * size, size).max(1) as f64).ln());
        logs.iter().sum::<f64>() / logs.len() as f64
    };
    let pairs: Vec<_> = sizes.iter().map(|&size| DVec2::new(-size.ln(), mean_log(size))).collect();
    let mean = pairs.iter().sum::<DVec2>() / pairs.len() as f64;
    let (top, bottom) = pairs.iter().fold((0.0, 0.0), |(top, bottom), &p| {
        let d = p - mean;
        (top + d.x * d.y, bottom + d.x * d.x)
    });
    if bottom > 0.0 { top / bottom } else { 0.0 }
}

/// The box dimension of a closed polyline between 1/64 and 1/256 of the diagonal of `frame`'s box, in a grid that
/// depends on `frame` only: the same for a leaf and all its fits.
#[must_use]
pub fn box_slope(points: &[DVec2], frame: &Outline) -> f64 {
    let diagonal = frame.diagonal();
    let sizes = [64.0, 90.5, 128.0, 181.0, 256.0].map(|parts| diagonal / parts);
    slope_from(points, true, frame.bounds().0, &sizes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_of_a_side_are_counted_by_hand() {
        let side = [DVec2::new(0.5, 0.5), DVec2::new(3.5, 1.5)];
        assert_eq!(box_count(&side, false, DVec2::ZERO, 1.0), 5);
        assert_eq!(box_count(&[side[1], side[0]], false, DVec2::ZERO, 1.0), 5);
        assert_eq!(box_count(&side, false, DVec2::new(0.1, -7.0), 100.0), 1);
        assert_eq!(box_count(&side, false, DVec2::ZERO, f64::NAN), 0);
        assert_eq!(box_count(&[DVec2::ONE], false, DVec2::ZERO, 1.0), 1);
    }

    #[test]
    fn a_field_too_large_for_bits_is_counted_as_well() {
        let line: Vec<DVec2> =
            (0..300).map(|i| DVec2::from_angle(f64::from(i * i)) * f64::from(i % 17)).collect();
        let (low, high) = bounds(&line);
        for size in [0.7, 0.03, 2e-3] {
            let mut sparse =
                Boxes { low: (0, 0), columns: 0, bits: Vec::new(), far: HashSet::new(), count: 0 };
            for (i, &a) in line.iter().enumerate() {
                let [a, b] = [a, line[(i + 1) % line.len()]].map(|p| (p / size, box_of(p / size)));
                sparse.note(a.1);
                pass(a, b, &mut sparse);
            }
            let field = ((high - low) / size).element_product();
            assert_eq!(field > MOST_BITS as f64, size < 0.01);
            assert_eq!(box_count(&line, true, DVec2::ZERO, size), sparse.count, "{size}");
        }
    }

    #[test]
    fn a_line_has_dimension_one_and_the_koch_curve_its_own() {
        let line = [DVec2::ZERO, DVec2::new(1.0, 0.3)];
        let sizes = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0];
        assert!((box_slope_of(&line, false, &sizes) - 1.0).abs() < 0.02);
        let mut koch = vec![DVec2::ZERO, DVec2::X];
        for _ in 0..7 {
            let next = koch.windows(2).flat_map(|w| {
                let third = (w[1] - w[0]) / 3.0;
                let tip = w[0] + third + DVec2::from_angle(std::f64::consts::FRAC_PI_3).rotate(third);
                [w[0], w[0] + third, tip, w[1] - third]
            });
            koch = next.chain([DVec2::X]).collect();
        }
        let sizes = [9.0, 27.0, 81.0, 243.0].map(f64::recip);
        assert!((box_slope_of(&koch, false, &sizes) - 4.0_f64.ln() / 3.0_f64.ln()).abs() < 0.03);
    }
}
