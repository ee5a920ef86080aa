//! How far pieces reach, in the directions of the fan: worked out once for a piece that is held against many others.

use frond_core::Affine2;

use crate::support::lanes::{DIRECTIONS, SupportLanes, direction};

/// What a piece is in each direction of the fan, times the length of the direction.
#[derive(Clone, Debug)]
pub(crate) struct Silhouette {
    /// An upper bound of how far it reaches.
    pub reach: [f64; DIRECTIONS],
    /// How far one of its points does, and the number of that point.
    pub point: [f64; DIRECTIONS],
    pub number: [u8; DIRECTIONS],
}

impl Silhouette {
    fn of<const L: usize>(map: &Affine2, fan: &SupportLanes<L>) -> Self {
        let turned = map.linear.transpose();
        let mut all = Self { reach: [0.0; DIRECTIONS], point: [0.0; DIRECTIONS], number: [0; DIRECTIONS] };
        for k in 0..DIRECTIONS {
            let d = direction(k);
            let (reach, number) = fan.support(turned * d, 0);
            all.reach[k] = map.translation.dot(d) + reach;
            all.point[k] = d.dot(map.apply(fan.point(number, 0)));
            all.number[k] = number as u8;
        }
        all
    }
}

/// Those of the pieces that were asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Silhouettes {
    known: Vec<Silhouette>,
    /// For each piece the number of its own among these, or [`NOT_YET`].
    number: Vec<u32>,
}

const NOT_YET: u32 = u32::MAX;

impl Silhouettes {
    pub fn clear(&mut self) {
        self.known.clear();
        self.number.clear();
    }

    /// Sees to it that there is one for a piece, `map` in the first lane.
    pub fn prepare<const L: usize>(&mut self, piece: u32, map: &Affine2, fan: &SupportLanes<L>) {
        let piece = piece as usize;
        if self.number.len() <= piece {
            self.number.resize(piece + 1, NOT_YET);
        }
        if self.number[piece] == NOT_YET {
            self.number[piece] = self.known.len() as u32;
            self.known.push(Silhouette::of(map, fan));
        }
    }

    /// That of a piece it was prepared for.
    pub fn get(&self, piece: u32) -> &Silhouette {
        &self.known[self.number[piece as usize] as usize]
    }
}

/// By how much the points of one piece lie beyond the other, and the other's beyond the one, in each direction;
/// either piece swollen by so much.
#[inline]
pub(crate) fn beyond(a: &Silhouette, b: &Silhouette, swell: [f64; 2]) -> [[f64; DIRECTIONS]; 2] {
    let mut by = [[0.0; DIRECTIONS]; 2];
    for k in 0..DIRECTIONS {
        by[0][k] = a.point[k] - b.reach[k] - swell[1] * LENGTHS[k];
        by[1][k] = b.point[k] - a.reach[k] - swell[0] * LENGTHS[k];
    }
    by
}

/// No less than the length of each direction.
const LENGTHS: [f64; DIRECTIONS] = {
    // Directions lie on a square of side 2; of (1, s) they have the length sqrt(1 + s^2), by Heron's rule.
    let mut all = [0.0; DIRECTIONS];
    let mut k = 0;
    while k < DIRECTIONS {
        let a_side = DIRECTIONS / 4;
        let s = (k % a_side) as f64 * (2.0 / a_side as f64) - 1.0;
        let square = 1.0 + s * s;
        let mut root = 1.2;
        let mut step = 0;
        while step < 6 {
            root = 0.5 * (root + square / root);
            step += 1;
        }
        all[k] = root * (1.0 + 4.0 * f64::EPSILON);
        k += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn lengths_are_those_of_the_directions() {
        for (k, &length) in LENGTHS.iter().enumerate() {
            let true_length = direction(k).length();
            assert!(length >= true_length && length < true_length * (1.0 + 1e-14), "{k}: {length}");
        }
    }

    #[test]
    fn no_piece_is_beyond_itself() {
        let third = Affine2::similitude(1.0 / 3.0, 0.7, DVec2::new(0.3, -0.2));
        let maps = [[third], [Affine2::similitude(0.5, -0.2, DVec2::new(-0.4, 0.1))]];
        let mut fan = SupportLanes::<1>::default();
        fan.set(&maps, 1e-6, 100);
        let mut all = Silhouettes::default();
        all.prepare(0, &third, &fan);
        let one = all.get(0);
        for k in 0..DIRECTIONS {
            assert!(one.point[k] <= one.reach[k], "{k}");
            assert!(one.reach[k] - one.point[k] < 0.2, "{k}: a point of it is near there");
        }
        assert!(beyond(one, one, [0.0; 2]).iter().flatten().all(|&by| by <= 0.0));
        assert!(beyond(one, one, [-1.0; 2]).iter().flatten().all(|&by| by > 0.0));
    }
}
