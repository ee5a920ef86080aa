//! One map of a fractal curve, with the interval it copies.

use glam::{DMat2, DVec2};

/// One piece of a fractal curve: over `range` the curve is a copy of itself over `domain`.
///
/// ```text
///     | t |     | a   0   0 | | t |   | d |
///   P | x |  =  | bx  cx cxy| | x | + | ex|        Cochran, Hart & Flynn, eq 9; eq 8 where the factor is diagonal;
///     | y |     | by cyx  cy| | y |   | ey|        eq 1 where y is nothing
/// ```
///
/// a and d are kept as they were given, from which the range follows by rounding, or as they follow from the two
/// intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The interval of t that the piece fills.
    pub range: [f64; 2],
    /// The interval of t that it copies; longer than the range.
    pub domain: [f64; 2],
    /// Whether the copy runs backwards: a < 0.
    pub reflected: bool,
    /// (bx, by): what a unit of t adds.
    pub shear: DVec2,
    /// The matrix of c's: the roughness.
    pub factor: DMat2,
    /// (ex, ey).
    pub offset: DVec2,
    /// a and d.
    pub(crate) along: [f64; 2],
}

impl Piece {
    /// The piece whose ends lie where they should: the copy of `domain_ends` is `range_ends` (in the order of t).
    #[must_use]
    pub fn through(
        [range, domain]: [[f64; 2]; 2],
        reflected: bool,
        factor: DMat2,
        range_ends: [DVec2; 2],
        domain_ends: [DVec2; 2],
    ) -> Self {
        let [first, last] = if reflected { [range_ends[1], range_ends[0]] } else { range_ends };
        let rest = (last - factor * domain_ends[1]) - (first - factor * domain_ends[0]);
        let shear = rest / (domain[1] - domain[0]);
        let offset = first - factor * domain_ends[0] - shear * domain[0];
        Self { range, domain, reflected, shear, factor, offset, along: along([range, domain], reflected) }
    }

    /// The piece of a scalar map `[a, b, c, d, e]` (eq 1) over a domain.
    #[must_use]
    pub fn from_map([a, b, c, d, e]: [f64; 5], domain: [f64; 2]) -> Self {
        let ends = domain.map(|t| a * t + d);
        let range = if a < 0.0 { [ends[1], ends[0]] } else { ends };
        let factor = DMat2::from_cols(DVec2::new(c, 0.0), DVec2::ZERO);
        Self {
            range,
            domain,
            reflected: a < 0.0,
            shear: DVec2::new(b, 0.0),
            factor,
            offset: DVec2::new(e, 0.0),
            along: [a, d],
        }
    }

    /// The piece of a map of the plane `[a, bx, by, cx, cxy, cyx, cy, d, ex, ey]` (eq 9) over a domain.
    #[must_use]
    pub fn from_plane_map(map: [f64; 10], domain: [f64; 2]) -> Self {
        let [a, bx, by, cx, cxy, cyx, cy, d, ex, ey] = map;
        let factor = DMat2::from_cols(DVec2::new(cx, cyx), DVec2::new(cxy, cy));
        let along = Self::from_map([a, bx, cx, d, ex], domain);
        Self { shear: DVec2::new(bx, by), factor, offset: DVec2::new(ex, ey), ..along }
    }

    /// The factor of t: negative where reflected, of size below 1.
    #[must_use]
    pub fn a(&self) -> f64 {
        self.along[0]
    }

    /// The shift of t.
    #[must_use]
    pub fn d(&self) -> f64 {
        self.along[1]
    }

    /// `[a, b, c, d, e]` of the x coordinate (eq 1).
    #[must_use]
    pub fn map(&self) -> [f64; 5] {
        [self.a(), self.shear.x, self.factor.x_axis.x, self.d(), self.offset.x]
    }

    /// `[a, bx, by, cx, cxy, cyx, cy, d, ex, ey]` (eq 9).
    #[must_use]
    pub fn plane_map(&self) -> [f64; 10] {
        let Self { shear, factor, offset, .. } = self;
        let [x, y] = [factor.x_axis, factor.y_axis];
        [self.a(), shear.x, shear.y, x.x, y.x, x.y, y.y, self.d(), offset.x, offset.y]
    }

    /// Where in the domain the value at `t` of the range comes from. Ends go to ends exactly.
    #[must_use]
    pub fn source(&self, t: f64) -> f64 {
        let [start, end] = if self.reflected { [self.domain[1], self.domain[0]] } else { self.domain };
        if t <= self.range[0] {
            return start;
        }
        if t >= self.range[1] {
            return end;
        }
        let share = (t - self.range[0]) / (self.range[1] - self.range[0]);
        (start + share * (end - start)).clamp(self.domain[0], self.domain[1])
    }

    /// The norm of the factor: how much heights are multiplied by at most.
    #[must_use]
    pub fn gain(&self) -> f64 {
        spectral_norm(self.factor)
    }

    /// The unit vector whose image is longest, its first number not negative.
    #[must_use]
    pub fn longest(&self) -> DVec2 {
        let DMat2 { x_axis: x, y_axis: y } = self.factor;
        // What turns with the vector, and what turns against it, point one way.
        let turn = f64::atan2(x.y - y.x, x.x + y.y);
        let mirror = f64::atan2(x.y + y.x, x.x - y.y);
        let along = DVec2::from_angle(0.5 * (mirror - turn));
        if along.x < 0.0 { -along } else { along }
    }

    pub(crate) fn is_finite(&self) -> bool {
        let numbers = [self.range, self.domain].into_iter().flatten();
        let values = [self.shear, self.offset, self.factor.x_axis, self.factor.y_axis];
        numbers
            .chain(values.into_iter().flat_map(|v| v.to_array()))
            .chain(self.along)
            .all(|x| x.abs() <= 1e100)
    }
}

/// a and d that bring a domain to a range.
pub(crate) fn along([range, domain]: [[f64; 2]; 2], reflected: bool) -> [f64; 2] {
    let size = (range[1] - range[0]) / (domain[1] - domain[0]);
    let a = if reflected { -size } else { size };
    [a, range[0] - a * domain[usize::from(reflected)]]
}

/// The largest singular value.
#[must_use]
pub fn spectral_norm(m: DMat2) -> f64 {
    // Of [[a, c], [b, d]]: half the sum of the lengths of its conformal and its anticonformal part, doubled.
    let (x, y) = (m.x_axis, m.y_axis);
    let turn = f64::hypot(x.x + y.y, x.y - y.x);
    let mirror = f64::hypot(x.x - y.y, x.y + y.x);
    0.5 * (turn + mirror)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_norm_is_the_longest_image_of_a_unit_vector() {
        for (m, norm) in [
            (DMat2::from_diagonal(DVec2::new(0.3, -0.7)), 0.7),
            (DMat2::from_angle(0.4) * 0.5, 0.5),
            (DMat2::from_cols(DVec2::new(0.0, 0.0), DVec2::new(2.0, 0.0)), 2.0),
        ] {
            assert!((spectral_norm(m) - norm).abs() < 1e-15);
        }
    }

    #[test]
    fn no_vector_has_a_longer_image_than_the_longest() {
        for (a, b, c, d) in
            [(0.7, 0.7, 0.7, 0.7), (0.3, -0.9, 0.2, 0.1), (-0.5, 0.0, 0.0, 0.8), (0.1, 1.0, -1.0, 0.2)]
        {
            let factor = DMat2::from_cols(DVec2::new(a, c), DVec2::new(b, d));
            let piece = Piece { factor, ..Piece::from_map([0.5, 0.0, 0.0, 0.0, 0.0], [0.0, 1.0]) };
            let longest = piece.longest();
            assert!((longest.length() - 1.0).abs() < 1e-12);
            assert!(((factor * longest).length() - piece.gain()).abs() < 1e-12, "{factor}");
        }
    }

    #[test]
    fn a_map_comes_back_from_its_piece() {
        for map in [[0.5, 0.746, 0.5, -0.5, 0.246], [-0.4, -1.35, -0.5, 0.6, 1.25]] {
            let piece = Piece::from_map(map, [-1.0, 1.0]);
            for (a, b) in piece.map().into_iter().zip(map) {
                assert!((a - b).abs() < 1e-15);
            }
            assert_eq!(piece.reflected, map[0] < 0.0);
        }
    }

    #[test]
    fn maps_of_the_plane_are_what_they_were() {
        for a in [0.4, -0.4] {
            let map = [a, 0.2, -0.3, 0.5, 0.25, -0.125, -0.5, 0.5, 2.0, -1.0];
            let piece = Piece::from_plane_map(map, [0.0, 1.0]);
            for (got, wanted) in piece.plane_map().into_iter().zip(map) {
                assert!((got - wanted).abs() < 1e-15, "{got} {wanted}");
            }
            // Eq 9 by hand: x becomes bx t + cx x + cxy y + ex.
            let there = piece.shear * 0.5 + piece.factor * DVec2::new(1.0, 2.0) + piece.offset;
            assert!(there.distance(DVec2::new(0.1 + 0.5 + 0.5 + 2.0, -0.15 - 0.125 - 1.0 - 1.0)) < 1e-15);
        }
    }
}
