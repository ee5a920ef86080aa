//! The polygon, and how far its images reach.

use num_bigint::BigInt;

use crate::refused::Refused;
use crate::whole::{Factor, Whole};

/// The polygon and the maps as whole numbers.
pub(crate) struct Scene {
    pub maps: Whole<6>,
    pub corners: Whole<2>,
}

/// How far the image of the polygon reaches, as a whole number times `2^-bits`.
#[derive(Clone)]
pub(crate) struct Reach {
    pub far: BigInt,
    pub bits: u64,
}

impl Reach {
    /// Whether this one is less far.
    pub fn is_below(&self, other: &Self) -> bool {
        let most = self.bits.max(other.bits);
        (&self.far << (most - self.bits)) < (&other.far << (most - other.bits))
    }

    pub fn plus(&self, other: &Self) -> Self {
        let most = self.bits.max(other.bits);
        Self { far: (&self.far << (most - self.bits)) + (&other.far << (most - other.bits)), bits: most }
    }

    pub fn times(self, factor: &Factor) -> Self {
        Self { far: self.far * &factor.digits, bits: self.bits + factor.bits }
    }

    pub fn half(self) -> Self {
        Self { bits: self.bits + 1, ..self }
    }

    pub fn negative(self) -> Self {
        Self { far: -self.far, ..self }
    }
}

impl Scene {
    /// Checks that each edge has all other corners strictly on its left.
    ///
    /// That each edge supports the hull of all corners, and that each corner begins one, makes the list the boundary of
    /// that hull: no star, no corner twice, and an inside.
    pub fn check_convex(&self) -> Result<(), Refused> {
        let corners = &self.corners.rows;
        for (edge, [x, y]) in corners.iter().enumerate() {
            let next = (edge + 1) % corners.len();
            let [along_x, along_y] = [&corners[next][0] - x, &corners[next][1] - y];
            for (corner, [p, q]) in corners.iter().enumerate() {
                let is_end = corner == edge || corner == next;
                if !is_end && &along_x * (q - y) - &along_y * (p - x) <= BigInt::ZERO {
                    return Err(Refused::Polygon { edge, corner });
                }
            }
        }
        Ok(())
    }

    /// Checks that a word maps every corner strictly to the left of every edge.
    pub fn check_inside(&self, word: &[u8]) -> Result<(), Refused> {
        let corners = &self.corners.rows;
        for (edge, [x, y]) in corners.iter().enumerate() {
            let [next_x, next_y] = &corners[(edge + 1) % corners.len()];
            // The outer normal, and how far the edge itself is along it.
            let normal = [next_y - y, x - next_x];
            let most = Reach { far: &normal[0] * x + &normal[1] * y, bits: 2 * self.corners.bits };
            if !self.farthest(word, normal, self.corners.bits).is_below(&most) {
                return Err(Refused::NotInside { word: word.to_vec() });
            }
        }
        Ok(())
    }

    /// The greatest `normal . x` over the image of the polygon under a word, where `normal` is given as whole multiples
    /// of `2^-bits`.
    ///
    /// `n . w_i(x) = (M_i^T n) . x + n . t_i`: instead of multiplying the maps, the direction is followed down the
    /// word.
    pub fn farthest(&self, word: &[u8], normal: [BigInt; 2], bits: u64) -> Reach {
        let [mut n_x, mut n_y] = normal;
        let mut moved = BigInt::ZERO;
        for &letter in word {
            let [a, b, c, d, e, f] = &self.maps.rows[usize::from(letter)];
            moved = (moved << self.maps.bits) + &n_x * e + &n_y * f;
            (n_x, n_y) = (&n_x * a + &n_y * c, &n_x * b + &n_y * d);
        }
        let along = |[x, y]: &[BigInt; 2]| &n_x * x + &n_y * y;
        // There are at least three corners.
        let far = self.corners.rows.iter().map(along).max().unwrap_or_default();
        let letters = word.len() as u64 * self.maps.bits;
        Reach { far: far + (moved << self.corners.bits), bits: bits + letters + self.corners.bits }
    }
}
