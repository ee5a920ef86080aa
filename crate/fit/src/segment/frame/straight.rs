//! A rectangle, perhaps a little turned, and perhaps with round corners.

use crate::segment::binary_image::Bits;

/// Of each side so much is looked at, around its middle: corners may be round.
const SIDE: f64 = 0.7;
/// A side is a line at so many of its places at least: there may be a leaf that touches it from inside.
const STRAIGHT: f64 = 0.6;
/// At so many at most the field reaches beyond it.
const BEYOND: f64 = 0.03;
/// The steepest of its sides, as a scan lies askew.
const STEEPEST: f64 = 0.2;
/// A side is straight to this part of its length.
const STRAY: f64 = 0.006;
/// Both sides are at least this part of those of the picture.
const LEAST_SIDE: f64 = 0.4;

/// A line along a side: its distance from the border at the first row or column, and how that grows.
#[derive(Clone, Copy, Debug)]
struct Line {
    at: f64,
    slope: f64,
}

impl Line {
    fn of(&self, along: usize) -> f64 {
        self.at + self.slope * along as f64
    }
}

/// Four lines: the least and the greatest column by rows, and row by columns, that are within.
#[derive(Debug)]
pub struct Quad {
    left: Line,
    right: Line,
    top: Line,
    bottom: Line,
    /// Left, top, right and bottom of the parts of sides that are straight.
    sides: [f64; 4],
}

impl Quad {
    /// The rectangle that a field is, if it is one.
    pub fn around(field: &Bits) -> Option<Self> {
        let (width, height) = (field.width, field.height);
        let on = |x: usize, y: usize| field.on[y * width + x];
        let rows: Vec<Option<(usize, usize)>> = (0..height).map(|y| ends(width, |x| on(x, y))).collect();
        let columns: Vec<Option<(usize, usize)>> = (0..width).map(|x| ends(height, |y| on(x, y))).collect();
        let (left, right) = sides(&rows)?;
        let (top, bottom) = sides(&columns)?;
        let (y, x) = (height / 2, width / 2);
        let (across, down) = (right.of(y) - left.of(y), bottom.of(x) - top.of(x));
        if across < LEAST_SIDE * width as f64 || down < LEAST_SIDE * height as f64 {
            return None;
        }
        let margin = 0.5 * (1.0 - SIDE);
        let sides = [
            left.of(y) + margin * across,
            top.of(x) + margin * down,
            right.of(y) - margin * across,
            bottom.of(x) - margin * down,
        ];
        Some(Self { left, right, top, bottom, sides })
    }

    /// Whether a pixel lies beyond a side.
    pub fn is_outside(&self, x: usize, y: usize) -> bool {
        let (across, down) = (x as f64, y as f64);
        across < self.left.of(y) - 0.5
            || across > self.right.of(y) + 0.5
            || down < self.top.of(x) - 0.5
            || down > self.bottom.of(x) + 0.5
    }

    /// Whether it lies where a corner may be round.
    pub fn is_corner(&self, x: usize, y: usize) -> bool {
        let [left, top, right, bottom] = self.sides;
        let (x, y) = (x as f64, y as f64);
        (x < left || x > right) && (y < top || y > bottom)
    }
}

/// The first and the last place that is on.
fn ends(count: usize, on: impl Fn(usize) -> bool) -> Option<(usize, usize)> {
    let first = (0..count).find(|&k| on(k))?;
    let last = (first..count).rev().find(|&k| on(k))?;
    Some((first, last))
}

/// The lines along the first and the last ends of rows.
fn sides(ends: &[Option<(usize, usize)>]) -> Option<(Line, Line)> {
    let first = ends.iter().position(Option::is_some)?;
    let last = ends.iter().rposition(Option::is_some)?;
    let skip = ((0.5 * (1.0 - SIDE)) * (last - first) as f64) as usize;
    let (from, to) = (first + skip, last - skip);
    let of = |pick: fn((usize, usize)) -> usize| -> Vec<(f64, f64)> {
        (from..=to).filter_map(|k| Some((k as f64, pick(ends[k]?) as f64))).collect()
    };
    let stray = (STRAY * (last - first) as f64).max(1.5);
    Some((line(&of(|(first, _)| first), stray, 1.0)?, line(&of(|(_, last)| last), stray, -1.0)?))
}

/// The line through most points, if it is through enough of them; `inward` is the direction to the inside.
fn line(points: &[(f64, f64)], stray: f64, inward: f64) -> Option<Line> {
    const PLACES: usize = 12;
    let count = points.len();
    if count < 4 {
        return None;
    }
    let place = |k: usize| points[k * (count - 1) / (PLACES - 1)];
    let near = |line: &Line| {
        points.iter().filter(|(along, at)| (at - line.at - line.slope * along).abs() <= stray).count()
    };
    let mut best: Option<(usize, Line)> = None;
    for i in 0..PLACES {
        for j in i + 1..PLACES {
            let ((a, at_a), (b, at_b)) = (place(i), place(j));
            let slope = if b > a { (at_b - at_a) / (b - a) } else { 0.0 };
            let line = Line { at: at_a - slope * a, slope };
            let on = near(&line);
            if slope.abs() <= STEEPEST && best.is_none_or(|(most, _)| on > most) {
                best = Some((on, line));
            }
        }
    }
    let (on, line) = best?;
    let beyond = |&&(along, at): &&(f64, f64)| inward * (at - line.at - line.slope * along) < -stray;
    let beyond = points.iter().filter(beyond).count() as f64;
    (on as f64 >= STRAIGHT * count as f64 && beyond <= BEYOND * count as f64).then_some(line)
}
