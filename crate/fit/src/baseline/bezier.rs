//! Cubic Bézier segments, as those who trace pictures use.

use glam::DVec2;

use crate::outline::{Outline, features};

/// Times that points look for their places on a segment anew.
const PROJECTION_ROUNDS: usize = 12;

/// Numbers of a segment: two handles, and one of its ends.
const NUMBERS_A_SEGMENT: usize = 6;

/// The outline's points from `from` over `many` of them, as one segment.
#[derive(Clone, Debug)]
struct Segment {
    from: usize,
    many: usize,
    handles: [DVec2; 4],
    error: f64,
    /// How many points after `from` the farthest is.
    farthest: usize,
}

fn at([a, b, c, d]: [DVec2; 4], t: f64) -> DVec2 {
    let s = 1.0 - t;
    a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
}

/// The two handles between fixed ends, by least squares at given places.
fn solve(points: &[DVec2], places: &[f64], ends: [DVec2; 2]) -> [DVec2; 4] {
    let (mut bb, mut bc, mut cc) = (0.0, 0.0, 0.0);
    let (mut right_b, mut right_c) = (DVec2::ZERO, DVec2::ZERO);
    for (p, &t) in points.iter().zip(places) {
        let s = 1.0 - t;
        let (b, c) = (3.0 * s * s * t, 3.0 * s * t * t);
        let rest = *p - ends[0] * (s * s * s + b) - ends[1] * (c + t * t * t);
        (bb, bc, cc) = (bb + b * b, bc + b * c, cc + c * c);
        right_b += rest * b;
        right_c += rest * c;
    }
    // Handles are sought from the ends on: with few points they stay there.
    let raise = 1e-9 * (bb + cc) + f64::MIN_POSITIVE;
    let (bb, cc) = (bb + raise, cc + raise);
    let determinant = bb * cc - bc * bc;
    if determinant.is_nan() || determinant <= 0.0 {
        return [ends[0], ends[0].lerp(ends[1], 1.0 / 3.0), ends[0].lerp(ends[1], 2.0 / 3.0), ends[1]];
    }
    let b = (right_b * cc - right_c * bc) / determinant;
    let c = (right_c * bb - right_b * bc) / determinant;
    [ends[0], ends[0] + b, ends[1] + c, ends[1]]
}

impl Segment {
    fn new(outline: &[DVec2], from: usize, many: usize) -> Self {
        let points: Vec<_> = (0..=many).map(|i| outline[(from + i) % outline.len()]).collect();
        let ends = [points[0], points[many]];
        let mut places = vec![0.0];
        for pair in points.windows(2) {
            places.push(places[places.len() - 1] + pair[0].distance(pair[1]));
        }
        let whole = places[many].max(f64::MIN_POSITIVE);
        places.iter_mut().for_each(|place| *place /= whole);
        let mut handles = solve(&points, &places, ends);
        for _ in 0..PROJECTION_ROUNDS {
            for (place, p) in places.iter_mut().zip(&points) {
                *place = nearer(handles, *place, *p);
            }
            handles = solve(&points, &places, ends);
        }
        let squares = points.iter().zip(&places).map(|(p, &t)| p.distance_squared(at(handles, t)));
        let (mut error, mut farthest, mut most) = (0.0, many / 2, -1.0);
        for (i, square) in squares.enumerate() {
            error += square;
            if square > most && i > 0 && i < many {
                (farthest, most) = (i, square);
            }
        }
        Self { from, many, handles, error, farthest }
    }
}

/// A step of Newton's to the place that is nearest to p.
fn nearer(handles: [DVec2; 4], t: f64, p: DVec2) -> f64 {
    let [a, b, c, d] = handles;
    let s = 1.0 - t;
    let first = ((b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t)) * 3.0;
    let second = ((c - b * 2.0 + a) * s + (d - c * 2.0 + b) * t) * 6.0;
    let off = at(handles, t) - p;
    let slope = first.length_squared() + off.dot(second);
    let next = if slope > 0.0 { t - off.dot(first) / slope } else { t };
    if next.is_finite() { next.clamp(0.0, 1.0) } else { t }
}

/// Cubic Bézier segments end to end, of 6 numbers each (3 of them at least), whose handles are found by least squares;
/// the segment that is farthest off is cut at its farthest point, again and again. Each by its two ends and, between
/// them, its two handles.
#[must_use]
pub fn bezier_segments(outline: &Outline, numbers: usize) -> Vec<[DVec2; 4]> {
    let points = outline.points();
    let total = points.len();
    let many = (numbers / NUMBERS_A_SEGMENT).clamp(3, total);
    let marks = features(outline, many.min(6));
    let mut segments: Vec<Segment> = (0..marks.len())
        .map(|i| {
            let steps = (marks[(i + 1) % marks.len()] + total - marks[i]) % total;
            Segment::new(points, marks[i], if steps == 0 { total } else { steps })
        })
        .collect();
    while segments.len() < many {
        let worst = |(_, a): &(usize, &Segment), (_, b): &(usize, &Segment)| a.error.total_cmp(&b.error);
        let parts = segments.iter().enumerate().filter(|(_, segment)| segment.many > 1);
        let Some((index, segment)) = parts.max_by(worst) else { break };
        let (from, many, cut) = (segment.from, segment.many, segment.farthest.clamp(1, segment.many - 1));
        segments[index] = Segment::new(points, from, cut);
        segments.insert(index + 1, Segment::new(points, (from + cut) % total, many - cut));
    }
    segments.iter().map(|segment| segment.handles).collect()
}

/// [`bezier_segments`] as a closed polyline of about `count` points.
#[must_use]
pub fn bezier(outline: &Outline, numbers: usize, count: usize) -> Vec<DVec2> {
    let segments = bezier_segments(outline, numbers);
    let each = (count / segments.len().max(1)).max(1);
    let sides = |handles: &[DVec2; 4]| {
        let handles = *handles;
        (0..each).map(move |i| at(handles, i as f64 / each as f64))
    };
    segments.iter().flat_map(sides).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::fidelity;

    #[test]
    fn a_circle_takes_few_segments() {
        let circle: Vec<_> = (0..720).map(|i| DVec2::from_angle(f64::from(i).to_radians() / 2.0)).collect();
        let outline = Outline::new(&circle).unwrap();
        let near = fidelity(&outline, &bezier(&outline, 24, 2000));
        let polyline = fidelity(&outline, &crate::split_polyline(&outline, 24));
        assert!(near.hausdorff < 0.1 * polyline.hausdorff, "{near:?} {polyline:?}");
        let finer = fidelity(&outline, &bezier(&outline, 60, 2000));
        assert!(finer.rms < 0.5 * near.rms, "{finer:?} {near:?}");
    }

    #[test]
    fn any_size_has_an_answer() {
        let outline = Outline::new(&[DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]).unwrap();
        for (numbers, count) in [(0, 0), (6, 1), (24, 100), (10_000, 10)] {
            let line = bezier(&outline, numbers, count);
            assert!(line.len() >= 3 && line.iter().all(|p| p.is_finite()), "{numbers} {count}");
        }
    }
}
