//! Points that pieces are known to share, in exact arithmetic.

use std::collections::HashMap;

use frond_core::Affine2;
use glam::DVec2;

use crate::graph::OverlapGraph;

/// A point of the plane as a fraction in lowest terms: (x / w, y / w), w positive.
type Point = (i128, i128, i128);

/// A map whose six numbers are whole multiples of 2^-bits, given as these multiples.
#[derive(Clone, Copy, Debug)]
struct Dyadic {
    row: [i128; 6],
    bits: u32,
}

/// Fractions of more digits than this are not looked at: few who write 0.5 or 0.375 mean 2^-13.
const BITS: u32 = 12;

/// The graph of the pieces that are proved to share a point: those of equal maps, those of maps that fix the
/// origin, and those that share an image of a fixed point, where all numbers are dyadic fractions of few
/// digits, so that the point is computed exactly. It need not have every edge.
///
/// A classical gasket or dragon is proved connected by it; coefficients like 1/3, which floating point only
/// comes near, prove nothing.
pub(crate) fn shared_points(maps: &[Affine2]) -> OverlapGraph {
    let mut graph = OverlapGraph::new(maps.len());
    for (i, map) in maps.iter().enumerate() {
        for (j, other) in maps[..i].iter().enumerate() {
            if other == map || [map, other].iter().all(|m| m.translation == DVec2::ZERO) {
                graph.add(i, j);
            }
        }
    }
    if !graph.is_connected()
        && let Some(maps) = maps.iter().map(Dyadic::of).collect::<Option<Vec<_>>>()
    {
        add_images(&maps, &mut graph);
    }
    graph
}

/// Adds an edge where a piece holds the same image, under one to three maps, of a fixed point as one before it.
fn add_images(maps: &[Dyadic], graph: &mut OverlapGraph) {
    let mut points: Vec<Point> = maps.iter().filter_map(Dyadic::fixed_point).collect();
    if maps.len() <= 16 {
        // Reflections take corners to one another and back: words of two letters fix them.
        let pairs = maps.iter().flat_map(|a| maps.iter().filter_map(|b| a.after(b)));
        points.extend(pairs.filter_map(|pair| pair.fixed_point()));
    }
    // Two letters before the repeated ones are enough for the classical shapes; 64 maps get none.
    for _ in 0..2 {
        if points.len() * maps.len() <= 2048 {
            let images: Vec<Point> =
                points.iter().flat_map(|&p| maps.iter().filter_map(move |map| map.apply(p))).collect();
            points.extend(images);
            points.sort_unstable();
            points.dedup();
        }
    }
    let mut holder: HashMap<Point, usize> = HashMap::new();
    for (i, map) in maps.iter().enumerate() {
        for image in points.iter().filter_map(|&p| map.apply(p)) {
            graph.add(i, *holder.entry(image).or_insert(i));
        }
    }
}

impl Dyadic {
    fn of(map: &Affine2) -> Option<Self> {
        let scale = f64::from(1_u32 << BITS);
        let mut row = [0; 6];
        for (whole, number) in row.iter_mut().zip(map.to_row()) {
            let scaled = number * scale;
            if scaled.fract() != 0.0 || scaled.abs() >= 1e9 {
                return None;
            }
            *whole = scaled as i128;
        }
        Some(Self { row, bits: BITS })
    }

    /// The map that applies `inner` first; `None` when the numbers outgrow what [`Dyadic::fixed_point`] takes.
    fn after(&self, inner: &Self) -> Option<Self> {
        let ([a, b, c, d, e, f], [p, q, r, s, t, u]) = (self.row, inner.row);
        let one = 1 << inner.bits;
        let row = [
            a * p + b * r,
            a * q + b * s,
            c * p + d * r,
            c * q + d * s,
            a * t + b * u + e * one,
            c * t + d * u + f * one,
        ];
        let bits = self.bits + inner.bits;
        row.iter().all(|x| x.abs() < 1 << 60).then_some(Self { row, bits })
    }

    /// The fixed point, from `(1 - M) p = t` by Cramer's rule.
    fn fixed_point(&self) -> Option<Point> {
        let [a, b, c, d, e, f] = self.row;
        let one = 1 << self.bits;
        let (p, s) = (one - a, one - d);
        lowest(s * e + b * f, c * e + p * f, p * s - b * c)
    }

    /// The image of a point; `None` when the numbers outgrow 127 bits.
    fn apply(&self, (x, y, w): Point) -> Option<Point> {
        let [a, b, c, d, e, f] = self.row;
        let dot = |p: i128, q: i128, r: i128| {
            p.checked_mul(x)?.checked_add(q.checked_mul(y)?)?.checked_add(r.checked_mul(w)?)
        };
        lowest(dot(a, b, e)?, dot(c, d, f)?, w.checked_mul(1 << self.bits)?)
    }
}

fn lowest(x: i128, y: i128, w: i128) -> Option<Point> {
    if w == 0 {
        return None;
    }
    let divisor = gcd(gcd(x, y), w) * w.signum();
    Some((x / divisor, y / divisor, w / divisor))
}

fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    fn maps(rows: &[[f64; 6]]) -> Vec<Affine2> {
        rows.iter().copied().map(Affine2::from_row).collect()
    }

    #[test]
    fn the_gasket_and_the_dragon_share_exact_points() {
        let gasket = maps(&[
            [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.25, 0.375],
        ]);
        assert_eq!(shared_points(&gasket).edges(), [(0, 1), (0, 2), (1, 2)]);
        let (a, b) = (gasket[0], Affine2::from_row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]));
        let dragon_a = Affine2::from_row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]);
        assert!(shared_points(&[dragon_a, b * dragon_a, b * b]).is_connected());
        // One map a little smaller, and it hangs on nothing.
        let off = Affine2 { linear: a.linear * 0.75, ..gasket[1] };
        assert_eq!(shared_points(&[gasket[0], off, gasket[2]]).edges(), [(0, 2)]);
    }

    #[test]
    fn thirds_prove_nothing_but_equal_maps_do() {
        let third = 1.0 / 3.0;
        let cantor = maps(&[
            [third, 0.0, 0.0, third, 0.1, 0.0],
            [third, 0.0, 0.0, third, 0.7, 0.0],
            [third, 0.0, 0.0, third, 0.1, 0.0],
        ]);
        assert_eq!(shared_points(&cantor).edges(), [(0, 2)]);
        let stars = maps(&[[third, 0.0, 0.0, third, 0.0, 0.0], [0.1, 0.2, 0.3, 0.4, 0.0, 0.0]]);
        assert!(shared_points(&stars).is_connected());
    }

    #[test]
    fn large_singular_and_many_maps_are_no_trouble() {
        let wide = maps(&[[0.5, 0.25, 0.0, 0.5, 1e5, -1e5], [0.0, 0.0, 0.0, 0.0, -1e5, 1e5]]);
        assert!(!shared_points(&wide).is_connected());
        let many: Vec<_> = (0..64)
            .map(|i| Affine2::similitude(0.125, 0.0, DVec2::new(f64::from(i % 8), f64::from(i / 8))))
            .collect();
        assert!(shared_points(&many).is_connected());
    }
}
