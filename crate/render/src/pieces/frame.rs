//! An attractor brought into the unit disc.

use frond_core::{Affine2, Hull, Ifs};
use glam::{DMat2, DVec2};

use crate::pieces::letters::Letters;

/// An IFS in coordinates of its own: the attractor lies in the unit disc and fills it as well as an
/// ellipse around its hull allows.
///
/// Everything that is drawn is a piece `view * to_world * word` of this unit attractor, so that sizes
/// are read off matrices (the image of the disc is an ellipse), points fit an `f32` whatever the size of
/// the shape, and bounding boxes are tight for flat shapes as well.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The maps, in unit coordinates.
    pub maps: Vec<Affine2>,
    /// The maps once more, with powers of those that shrink little and of their products: each takes the
    /// attractor into itself, and to get anywhere takes few of them. With the first letters of each.
    pub steps: Vec<(Affine2, Letters)>,
    /// One probability a map, summing to 1.
    pub probabilities: Vec<f64>,
    /// From unit coordinates to the world.
    pub to_world: Affine2,
    /// A point of the attractor near the middle, in unit coordinates.
    pub anchor: DVec2,
    /// Points of the attractor that stick out farthest in some direction, in unit coordinates: at most
    /// sixteen, each once. A piece reaches over an edge where one of its tips does.
    pub tips: Vec<DVec2>,
}

/// The number of directions that [`Frame::tips`] are sought in.
pub const TIPS: usize = 16;

/// The least ratio of the axes of the ellipse: a segment gets an ellipse as well.
const LEAST_AXIS_RATIO: f64 = 1e-6;

impl Frame {
    /// The frame of an IFS, by way of its hull.
    #[must_use]
    pub fn of(ifs: &Ifs) -> Self {
        Self::within(ifs, &Hull::of(ifs))
    }

    /// The frame of an IFS whose hull is known already.
    #[must_use]
    pub fn within(ifs: &Ifs, hull: &Hull) -> Self {
        let to_world = enclosing_ellipse(hull.vertices());
        // The ellipse is never singular, see LEAST_AXIS_RATIO.
        let inverse = to_world.linear.inverse();
        let maps: Vec<Affine2> = ifs
            .maps()
            .iter()
            .map(|map| {
                let moved = map.apply(to_world.translation) - to_world.translation;
                Affine2::new(inverse * map.linear * to_world.linear, inverse * moved)
            })
            .collect();
        let steps = steps(&maps);
        let anchor = anchor(&maps);
        let tips = tips(&maps, anchor);
        Self { maps, steps, probabilities: ifs.probabilities().to_vec(), to_world, anchor, tips }
    }
}

/// The map from the unit disc onto an ellipse that holds the points, close to the smallest there is.
pub(crate) fn enclosing_ellipse(points: &[DVec2]) -> Affine2 {
    let count = points.len().max(1) as f64;
    let mean = points.iter().sum::<DVec2>() / count;
    // Along the axes of the spread, so that a slanted segment becomes a thin box.
    let (xx, xy, yy) = points.iter().fold((0.0, 0.0, 0.0), |(xx, xy, yy), p| {
        let d = *p - mean;
        (xx + d.x * d.x, xy + d.x * d.y, yy + d.y * d.y)
    });
    let turn = DMat2::from_angle(0.5 * (2.0 * xy).atan2(xx - yy));
    let back = turn.transpose();
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for p in points {
        let d = back * (*p - mean);
        (low, high) = (low.min(d), high.max(d));
    }
    if !(high - low).is_finite() {
        return Affine2::IDENTITY;
    }
    let centre = mean + turn * ((low + high) * 0.5);
    let half = (high - low) * 0.5;
    let least = half.max_element().max(centre.length() * 1e-15).max(1e-140);
    let box_linear = turn * DMat2::from_diagonal(half.max(DVec2::splat(least * LEAST_AXIS_RATIO)));
    let flat = half.min_element() <= least * LEAST_AXIS_RATIO;
    let inverse = box_linear.inverse();
    let boxed: Vec<DVec2> = points.iter().map(|p| inverse * (*p - centre)).collect();
    let ellipse = if flat { Affine2::IDENTITY } else { khachiyan(&boxed) };
    // Whatever the rounds above came to: all points must be inside.
    let shrink = ellipse.linear.inverse();
    let reach = boxed.iter().map(|p| (shrink * (*p - ellipse.translation)).length()).fold(0.0, f64::max);
    let grown = if reach > 0.0 { reach * (1.0 + 1e-9) } else { 1.0 };
    Affine2::new(box_linear * ellipse.linear * grown, centre + box_linear * ellipse.translation)
}

/// An ellipse around points that span [-1, 1] x [-1, 1], within some percent of the smallest: Khachiyan's
/// algorithm (1996), which moves weight to the point that sticks out the farthest.
fn khachiyan(points: &[DVec2]) -> Affine2 {
    let n = points.len();
    let mut weights = vec![1.0 / n as f64; n];
    let mut fit = (DVec2::ZERO, DMat2::IDENTITY);
    for _ in 0..60 {
        let centre: DVec2 = points.iter().zip(&weights).map(|(p, w)| *p * *w).sum();
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for (p, w) in points.iter().zip(&weights) {
            let d = *p - centre;
            xx += w * d.x * d.x;
            xy += w * d.x * d.y;
            yy += w * d.y * d.y;
        }
        let spread = DMat2::from_cols(DVec2::new(xx, xy), DVec2::new(xy, yy)) * 2.0;
        if spread.determinant() <= 1e-18 {
            return Affine2::IDENTITY;
        }
        fit = (centre, spread);
        let inverse = spread.inverse();
        let (mut worst, mut farthest) = (0, 0.0);
        for (i, p) in points.iter().enumerate() {
            let d = *p - centre;
            let distance = d.dot(inverse * d);
            if distance > farthest {
                (worst, farthest) = (i, distance);
            }
        }
        // The lifted distance of the literature is 1 + 2 * farthest, its optimum 3.
        if farthest < 1.05 {
            break;
        }
        let step = 2.0 * (farthest - 1.0) / (3.0 * 2.0 * farthest);
        for weight in &mut weights {
            *weight *= 1.0 - step;
        }
        weights[worst] += step;
    }
    let (centre, spread) = fit;
    // Cholesky: the unit disc's image under a root of the spread is the ellipse.
    let a = spread.x_axis.x.sqrt();
    let b = spread.x_axis.y / a;
    let c = (spread.y_axis.y - b * b).max(1e-18).sqrt();
    Affine2::new(DMat2::from_cols(DVec2::new(a, b), DVec2::new(0.0, c)), centre)
}

/// Maps that shrink to more than the first get powers, up to one that shrinks to the second.
const SLOW_FACTORS: (f64, f64) = (0.95, 0.5);
/// The most powers of each, and the most maps whose products get powers as well.
const MOST_POWERS: usize = 16;
const MOST_PAIRED: usize = 4;

pub(crate) fn steps(maps: &[Affine2]) -> Vec<(Affine2, Letters)> {
    let letter = |i| Letters::NONE.then(i);
    let mut steps: Vec<_> = maps.iter().enumerate().map(|(i, map)| (*map, letter(i))).collect();
    let slow: Vec<_> = steps.iter().copied().filter(|(map, _)| map.norm() > SLOW_FACTORS.0).collect();
    let mut words = slow.clone();
    if slow.len() <= MOST_PAIRED {
        for (i, (a, first)) in slow.iter().enumerate() {
            words.extend(slow[i + 1..].iter().map(|(b, second)| (*a * *b, first.join(*second))));
        }
    }
    for (mut power, mut letters) in words {
        for _ in 0..MOST_POWERS {
            if power.norm() <= SLOW_FACTORS.1 {
                break;
            }
            // The fourth power each time.
            power = power * power;
            (power, letters) = (power * power, letters.join(letters).join(letters));
            // Rounding must not make a step of what overflowed.
            if power.is_finite() {
                steps.push((power, letters));
            }
        }
    }
    steps
}

/// A point of the attractor near the middle of the disc: of some hundred, the nearest.
fn anchor(maps: &[Affine2]) -> DVec2 {
    const POINTS_TRIED: usize = 256;
    // Rounding must not carry it out of the disc, nor an attractor of no size make it infinite.
    let mut points: Vec<DVec2> = maps.iter().filter_map(|map| map.fixed_point()).filter(inside).collect();
    if points.is_empty() {
        points.push(DVec2::ZERO);
    }
    let mut next = 0;
    while next < points.len() && points.len() < POINTS_TRIED {
        let point = points[next];
        points.extend(maps.iter().map(|map| map.apply(point)));
        next += 1;
    }
    let nearest = points.into_iter().min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    nearest.filter(inside).unwrap_or(DVec2::ZERO)
}

fn inside(point: &DVec2) -> bool {
    // False for what is no number.
    point.length_squared() <= 1.0
}

/// The farthest points in some directions, found from within: a farthest point of the attractor is the
/// image of one, so that images of those at hand are tried until nothing is gained.
fn tips(maps: &[Affine2], anchor: DVec2) -> Vec<DVec2> {
    const MOST_ROUNDS: usize = 24;
    let directions: [DVec2; TIPS] =
        std::array::from_fn(|k| DVec2::from_angle(std::f64::consts::TAU * k as f64 / TIPS as f64));
    let mut tips = vec![anchor];
    tips.extend(maps.iter().take(TIPS).filter_map(|map| map.fixed_point()).filter(inside));
    let mut images = Vec::new();
    for _ in 0..MOST_ROUNDS {
        images.clear();
        images.extend_from_slice(&tips);
        images.extend(maps.iter().flat_map(|map| tips.iter().map(|tip| map.apply(*tip))));
        let mut next: Vec<DVec2> = Vec::with_capacity(TIPS);
        for direction in directions {
            let (mut farthest, mut reach) = (None, f64::NEG_INFINITY);
            for image in &images {
                let along = image.dot(direction);
                if along > reach {
                    (farthest, reach) = (Some(*image), along);
                }
            }
            // One tip serves several directions; to know it again need not be exact.
            next.extend(farthest.filter(|far| next.iter().all(|tip| tip.distance_squared(*far) > 1e-6)));
        }
        let settled =
            next.len() == tips.len() && next.iter().zip(&tips).all(|(a, b)| a.distance_squared(*b) < 1e-8);
        tips = next;
        if settled {
            break;
        }
    }
    tips.retain(inside);
    tips
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{NASTY, PLAIN, ifs, of_rows, point_attractor};

    /// Points of the attractor in unit coordinates, by the chaos game.
    fn orbit(frame: &Frame) -> Vec<DVec2> {
        let mut point = frame.anchor;
        (0..3000)
            .map(|i| {
                let letter = frond_core::hash::counter(5, i) as usize % frame.maps.len();
                point = frame.maps[letter].apply(point);
                point
            })
            .collect()
    }

    #[test]
    fn the_attractor_fits_the_unit_disc_and_is_not_lost_in_it() {
        for name in PLAIN.iter().chain(NASTY) {
            let frame = Frame::of(&ifs(name));
            let reach = orbit(&frame).iter().map(|p| p.length()).fold(0.0, f64::max);
            assert!(reach <= 1.0 + 1e-9, "{name}: {reach}");
        }
        for name in PLAIN {
            let reach = orbit(&Frame::of(&ifs(name))).iter().map(|p| p.length()).fold(0.0, f64::max);
            assert!(reach > 0.5, "{name}: {reach}");
        }
    }

    #[test]
    fn no_point_sticks_out_much_farther_than_the_tips() {
        for name in PLAIN {
            let frame = Frame::of(&ifs(name));
            assert!(!frame.tips.is_empty() && frame.tips.len() <= TIPS, "{name}: {}", frame.tips.len());
            for k in 0..64 {
                let direction = DVec2::from_angle(0.1 * f64::from(k));
                let far = |points: &[DVec2]| points.iter().map(|p| p.dot(direction)).fold(-2.0, f64::max);
                let (seen, tips) = (far(&orbit(&frame)), far(&frame.tips));
                assert!(tips > seen - 0.05, "{name} {direction}: {tips} {seen}");
            }
        }
        assert_eq!(Frame::of(&ifs("gasket")).tips.len(), 3);
    }

    #[test]
    fn unit_maps_are_the_maps_of_the_world() {
        for name in PLAIN {
            let ifs = ifs(name);
            let frame = Frame::of(&ifs);
            for (unit, map) in frame.maps.iter().zip(ifs.maps()) {
                let x = DVec2::new(0.3, -0.4);
                let here = frame.to_world.apply(unit.apply(x));
                assert!((here - map.apply(frame.to_world.apply(x))).length() < 1e-9, "{name}");
            }
        }
    }

    #[test]
    fn a_point_and_shapes_of_any_size_have_frames() {
        for size in [1e-12, 1.0, 1e12] {
            for centre in [0.0, 1.0, -1e6] {
                let frame = Frame::of(&of_rows(&[
                    [0.5, 0.0, 0.0, 0.5, centre, 0.0],
                    [0.5, 0.0, 0.0, 0.5, centre + size, 0.0],
                    [0.5, 0.0, 0.0, 0.5, centre, size],
                ]));
                assert!(frame.maps.iter().all(|m| m.is_finite()), "{size} {centre}");
                assert!(frame.anchor.is_finite() && frame.to_world.is_finite());
            }
        }
        let frame = Frame::of(&point_attractor(DVec2::new(1e5, 0.0)));
        assert!(frame.maps[0].is_finite() && frame.to_world.norm() < 1e-3);
    }

    #[test]
    fn the_ellipse_around_a_square_is_nearly_the_smallest() {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
        let sheared = corners.map(|p| DVec2::new(100.0 * p.x + 300.0 * p.y + 7.0, p.y));
        for (points, area) in [(corners, 2.0), (sheared, 200.0)] {
            let found = enclosing_ellipse(&points).determinant().abs();
            assert!(found >= area * 0.999 && found < area * 1.1, "{found} {area}");
        }
    }
}
