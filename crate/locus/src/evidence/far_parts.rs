//! Parts of pieces that jut out, and parts that come near each other, as images of a polygon show it.

use frond_core::Affine2;
use glam::DVec2;

use crate::frame::Frame;
use crate::support::trapping_polygon::TrappingPolygon;

/// Directions in which two pieces are held against each other.
const DIRECTIONS: usize = 256;
/// Letters behind a word at most.
const MOST_LETTERS: usize = 200;
/// Words looked at for a part about a point.
const MOST_LOOKS: usize = 2000;
/// How far outside a part, relative to its width, a point of it may seem to be through rounding.
const POINT_ROOM: f64 = 1e-6;

/// A part of a piece that is beyond another piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Far {
    /// What its word has behind that of the piece: letters from 0.
    pub tail: Vec<u8>,
    /// Along this direction of the plane it is beyond. Not of unit length.
    pub direction: DVec2,
}

/// Images of a polygon under words.
pub(crate) struct FarParts<'a> {
    frame: &'a Frame,
    polygon: &'a TrappingPolygon,
    /// Outer normals of the polygon's edges, and the polygon's width along each.
    edges: Vec<(DVec2, f64)>,
}

impl<'a> FarParts<'a> {
    pub fn new(frame: &'a Frame, polygon: &'a TrappingPolygon) -> Self {
        let mut this = Self { frame, polygon, edges: Vec::new() };
        let corners = &polygon.here;
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(p, q)| {
            let normal = -(*q - *p).perp().normalize_or_zero();
            // Narrower than it may be: distances are then taken for larger.
            let width = this.width(&Affine2::IDENTITY, normal) - 4.0 * frame.rounding;
            (normal, width)
        });
        this.edges = edges.collect();
        this
    }

    fn map(&self, word: &[u8]) -> Affine2 {
        word.iter().fold(Affine2::IDENTITY, |map, &letter| map * self.frame.maps[usize::from(letter)])
    }

    /// How far an image of the polygon reaches along a direction.
    fn reach(&self, map: &Affine2, normal: DVec2) -> f64 {
        let pulled = map.linear.transpose() * normal;
        let far = self.polygon.here.iter().map(|&p| pulled.dot(p)).fold(f64::NEG_INFINITY, f64::max);
        far + map.translation.dot(normal)
    }

    fn width(&self, map: &Affine2, normal: DVec2) -> f64 {
        self.reach(map, normal) + self.reach(map, -normal)
    }

    /// Parts that show that two pieces lie across each other where no gap is wider than `gap`, in widths of the
    /// polygon: two of the first, and two of the second. How far a piece reaches is told to `size` of its width.
    pub fn across(&self, words: [&[u8]; 2], gap: f64, size: f64) -> Option<[Far; 4]> {
        let maps = words.map(|word| self.map(word));
        // By which piece is beyond the other in each direction: for a run of them, the best.
        let mut turns: Vec<(usize, f64, DVec2)> = Vec::new();
        for k in 0..DIRECTIONS {
            let d = DVec2::from_angle(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
            for a in 0..2 {
                let (own, other) = (maps[a], maps[1 - a]);
                let by = self.farthest_point(own, d, size) - self.bar(&other, d, gap);
                match turns.last_mut() {
                    _ if by <= 0.0 => {}
                    Some(last) if last.0 == a => {
                        if by > last.1 {
                            *last = (a, by, d);
                        }
                    }
                    _ => turns.push((a, by, d)),
                }
            }
        }
        // The first turn may go on at the end.
        if turns.len() > 4 && turns.len() % 2 == 1 {
            turns.pop();
        }
        let mut found =
            turns.get(..4)?.iter().map(|&(a, _, d)| self.part_beyond(maps[a], &maps[1 - a], d, gap));
        let [p, q, r, s] = std::array::from_fn(|_| found.next().flatten());
        let four = [p?, q?, r?, s?];
        let [p, q, r, s] = four;
        Some(if turns[0].0 == 0 { [p, r, q, s] } else { [q, s, p, r] })
    }

    /// What a part of the other piece has to be beyond, along a direction of unit length.
    fn bar(&self, piece: &Affine2, d: DVec2, gap: f64) -> f64 {
        let wide = 0.5 * gap * self.width(piece, d);
        self.reach(piece, d) + wide + (16.0 + gap) * self.frame.rounding
    }

    /// The letter behind a word whose part reaches farthest.
    fn farther(&self, map: Affine2, d: DVec2) -> (u8, Affine2) {
        let parts = self.frame.maps.iter().enumerate().map(|(letter, next)| (letter as u8, map * *next));
        let reach = |part: &(u8, Affine2)| self.reach(&part.1, d);
        parts.max_by(|a, b| reach(a).total_cmp(&reach(b))).unwrap_or((0, map))
    }

    fn farthest_point(&self, mut map: Affine2, d: DVec2, size: f64) -> f64 {
        let narrow = size * self.width(&map, d);
        for _ in 0..MOST_LETTERS {
            if self.width(&map, d) < narrow {
                break;
            }
            map = self.farther(map, d).1;
        }
        -self.reach(&map, -d)
    }

    /// The largest part of a piece on the way to its farthest point that is beyond another piece.
    fn part_beyond(&self, piece: Affine2, other: &Affine2, d: DVec2, gap: f64) -> Option<Far> {
        let bar = self.bar(other, d, gap);
        let (mut map, mut tail) = (piece, Vec::new());
        while -self.reach(&map, -d) <= bar {
            if tail.len() >= MOST_LETTERS {
                return None;
            }
            let (letter, next) = self.farther(map, d);
            tail.push(letter);
            map = next;
        }
        Some(Far { tail, direction: self.frame.to_round.transpose() * d })
    }

    /// Words of small parts of two pieces, each about a point of its piece; and how far the parts are from each other
    /// at most, in widths of the polygon. None is wider than `size`.
    pub fn near(&self, pair: [u8; 2], points: [DVec2; 2], size: f64) -> Option<([Vec<u8>; 2], f64)> {
        let mut parts = (0..2).map(|k| self.part_about(pair[k], points[k], size));
        let [(u, a), (v, b)] = [parts.next()??, parts.next()??];
        let far = |n: DVec2| self.reach(&a, n) + self.reach(&b, -n) + 4.0 * self.frame.rounding;
        let upper = self.edges.iter().map(|&(n, width)| far(n).max(far(-n)) / width).fold(0.0, f64::max);
        Some(([u, v], upper))
    }

    /// The word of a small part of the piece of a map, about one of its points: depth first, since it may seem to
    /// be in several parts.
    fn part_about(&self, letter: u8, point: DVec2, size: f64) -> Option<(Vec<u8>, Affine2)> {
        let mut open = vec![(vec![letter], self.frame.maps[usize::from(letter)])];
        for _ in 0..MOST_LOOKS {
            let (word, map) = open.pop()?;
            let is_small = |&(n, width): &(DVec2, f64)| self.width(&map, n) <= size * width;
            if self.edges.iter().all(is_small) {
                return Some((word, map));
            }
            if word.len() >= MOST_LETTERS {
                continue;
            }
            let parts = self.frame.maps.iter().enumerate().map(|(letter, next)| {
                let part = map * *next;
                (self.depth(&part, point), [&*word, &[letter as u8]].concat(), part)
            });
            let mut parts: Vec<_> = parts.filter(|part| part.0 > -POINT_ROOM).collect();
            parts.sort_by(|a, b| a.0.total_cmp(&b.0));
            open.extend(parts.into_iter().map(|(_, word, map)| (word, map)));
        }
        None
    }

    /// How deep a point lies in an image of the polygon, relative to its width; below 0 for one outside.
    fn depth(&self, map: &Affine2, point: DVec2) -> f64 {
        let within = |n: DVec2| {
            let (there, back) = (self.reach(map, n), self.reach(map, -n));
            let along = n.dot(point);
            let room = (there - along).min(along + back);
            room / (there + back).max(f64::MIN_POSITIVE)
        };
        self.edges.iter().map(|&(n, _)| within(n)).fold(f64::INFINITY, f64::min)
    }
}
