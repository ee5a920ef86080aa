//! A curve as a polyline that is as fine as it is seen.

use glam::{DMat2, DVec2};

use super::morphed_curve::MorphedCurve;

/// The finest tolerance, in parts of the box.
const FINEST_TOLERANCE: f64 = 1e-13;

/// How fine it is outside the window, in parts of the box.
const OUTSIDE_TOLERANCE: f64 = 1.0 / 128.0;

/// The most copies that are followed at once along a stretch. With more of them it is halved, and how far it strays is
/// judged by its middle.
const MOST_PIECES: usize = 6;

/// When a stretch is halved so, a half strays at most so much of the whole: as for a curve of dimension 1.4 or so.
const HALF_STRAY: f64 = 0.7;

/// It strays so much of the whole at least, and so many times what its middle is off.
const SAMPLED_STRAY: (f64, f64) = (0.4, 1.5);

/// For a corner two copies of two copies .. are opened so deep; where an edge has one copy only, deeper.
const CORNER_DOUBLINGS: i32 = 11;

/// Places that are nearer to each other are one.
const SAME_PLACE: f64 = 1e-14;

/// What is left out of corners, in tolerances.
const CORNER_ERROR: f64 = 0.04;

/// A stretch of the curve somewhere, by a matrix: a part of what another stretch is made of.
#[derive(Clone, Copy, Debug)]
struct Piece {
    linear: DMat2,
    norm: f64,
    /// From where to where, by chords; it may go on above 1.
    low: f64,
    high: f64,
    /// The last knot that is not after `low`, and the first that is not before `high`.
    first: usize,
    last: usize,
    flipped: bool,
    /// No point is farther than this from where it would be on the chord, seen through the matrix.
    stray: f64,
}

impl Piece {
    fn at(&self, share: f64) -> f64 {
        let share = if self.flipped { 1.0 - share } else { share };
        self.low + share * (self.high - self.low)
    }
}

/// A stretch of the curve: two exact corners, and between them a straight base and pieces.
struct Stretch {
    t: [f64; 2],
    ends: [DVec2; 2],
    base: [DVec2; 2],
    pieces: Vec<Piece>,
    /// How far it strays, where that is judged.
    judged: Option<f64>,
}

impl Stretch {
    fn stray(&self) -> f64 {
        self.judged.unwrap_or_else(|| self.pieces.iter().map(|piece| piece.stray).sum())
    }

    /// Whether it is nowhere in a window.
    fn misses(&self, [left, bottom, right, top]: [f64; 4], stray: f64) -> bool {
        let [a, b] = self.ends;
        let (low, high) = (a.min(b) - stray, a.max(b) + stray);
        !(low.x <= right && high.x >= left && low.y <= top && high.y >= bottom)
    }
}

impl MorphedCurve {
    /// The curve as a closed polyline, each corner with its t; the first is not repeated.
    ///
    /// The curve is nowhere farther than `tolerance` from it inside the window (left, bottom, right, top; none: all is
    /// inside), and coarse elsewhere; where very many copies are in one stretch, that is judged by samples. Corners are
    /// points of the curve, those of its copies among them. There are at most `most` corners, three or more; a
    /// tolerance that would take more is raised.
    #[must_use]
    pub fn trace(&self, tolerance: f64, window: Option<[f64; 4]>, most: usize) -> Vec<(f64, DVec2)> {
        let most = most.max(3);
        let finest = FINEST_TOLERANCE * self.size;
        let mut tolerance = if tolerance > finest { tolerance } else { finest };
        loop {
            if let Some(points) = self.within(tolerance, window, most) {
                return points;
            }
            if tolerance > 4.0 * self.size {
                break;
            }
            tolerance *= 1.6;
        }
        // Not even its knots are few enough.
        let count = self.knots.len();
        let many = most.min(count);
        (0..many).map(|i| i * count / many).map(|knot| (self.places[knot], self.knots[knot])).collect()
    }

    /// The box around the curve, a millionth of it too large at most: lowest x and y, highest x and y.
    #[must_use]
    pub fn bounds(&self) -> [f64; 4] {
        let points = self.trace(1e-3 * self.size, None, 1 << 16);
        let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = points.iter().fold(start, |(low, high), (_, p)| (low.min(*p), high.max(*p)));
        [low.x, low.y, high.x, high.y]
    }

    /// None where that takes more corners.
    fn within(&self, tolerance: f64, window: Option<[f64; 4]>, most: usize) -> Option<Vec<(f64, DVec2)>> {
        let count = self.knots.len();
        let mut corners = vec![(0.0, self.knots[0])];
        let mut open = Vec::new();
        for edge in 0..count {
            open.push(self.edge(edge));
            while let Some(mut stretch) = open.pop() {
                let stray = stretch.stray();
                let coarse = window.is_some_and(|window| stretch.misses(window, stray));
                let enough = if coarse { tolerance.max(OUTSIDE_TOLERANCE * self.size) } else { tolerance };
                let enough = if stretch.judged.is_some() { enough.max(self.noise(&stretch)) } else { enough };
                if stray <= enough || !stray.is_finite() {
                    if corners.len() == most && edge + 1 < count {
                        return None;
                    }
                    corners.push((stretch.t[1], stretch.ends[1]));
                    continue;
                }
                if open.len() + corners.len() > most {
                    return None;
                }
                let rest = CORNER_ERROR * enough;
                let Some(share) = self.look_into(&mut stretch, rest) else {
                    open.push(stretch);
                    continue;
                };
                let [early, late] = self.cut(&stretch, share, rest);
                open.push(late);
                open.push(early);
            }
        }
        corners.pop();
        (corners.len() <= most).then_some(corners)
    }

    /// How exact corners are where all edges are made of two copies.
    fn noise(&self, stretch: &Stretch) -> f64 {
        let norms: f64 = stretch.pieces.iter().map(|piece| piece.norm).sum();
        2.0 * norms * self.size * self.contraction().powi(CORNER_DOUBLINGS)
    }

    fn edge(&self, edge: usize) -> Stretch {
        let ends = [self.knots[edge], self.knot(edge + 1)];
        let mut base = ends;
        let mut pieces = Vec::new();
        for term in self.terms[edge].iter().flatten() {
            base[0] -= term.linear * term.start;
            base[1] -= term.linear * (term.start + term.chord);
            pieces.push(Piece {
                linear: term.linear,
                norm: term.norm,
                low: term.low,
                high: term.low + term.long,
                first: term.from,
                last: term.from + term.span,
                flipped: term.flipped,
                stray: term.norm * term.reach,
            });
        }
        Stretch { t: [self.places[edge], self.places[edge + 1]], ends, base, pieces, judged: None }
    }

    /// The place of a knot, whose index may have gone round.
    fn place(&self, knot: usize) -> f64 {
        let count = self.knots.len();
        self.places[knot % count] + (knot / count) as f64
    }

    /// Looks at what strays most. Either it says where, from 0 to 1, the stretch should be cut; or a piece that lies
    /// within one edge was replaced by what that edge is made of.
    fn look_into(&self, stretch: &mut Stretch, rest: f64) -> Option<(usize, f64, Option<usize>)> {
        if stretch.judged.is_some() {
            return Some((0, 0.5, None));
        }
        let most = |(_, a): &(usize, &Piece), (_, b): &(usize, &Piece)| a.stray.total_cmp(&b.stray);
        let (index, &piece) = stretch.pieces.iter().enumerate().max_by(most)?;
        if piece.last > piece.first + 1 {
            let middle = 0.5 * (piece.low + piece.high);
            let off = |knot: &usize| (self.place(*knot) - middle).abs();
            let knot = (piece.first + 1..piece.last).min_by(|a, b| off(a).total_cmp(&off(b)))?;
            let long = piece.high - piece.low;
            let share =
                if long > 0.0 { ((self.place(knot) - piece.low) / long).clamp(0.0, 1.0) } else { 0.5 };
            let share = if piece.flipped { 1.0 - share } else { share };
            return Some((index, share, Some(knot)));
        }
        let edge = piece.first % self.knots.len();
        if stretch.pieces.len() + 1 > MOST_PIECES && self.terms[edge].iter().flatten().count() > 1 {
            return Some((index, 0.5, None));
        }
        stretch.pieces.swap_remove(index);
        let (from, long) = (self.place(piece.first), self.places[edge + 1] - self.places[edge]);
        let share = |place: f64| if long > 0.0 { ((place - from) / long).clamp(0.0, 1.0) } else { 0.0 };
        let whole = piece.low == from && piece.high == self.place(piece.last);
        let shares = if whole { [0.0, 1.0] } else { [share(piece.low), share(piece.high)] };
        let knots = [self.knots[edge], self.knot(edge + 1)];
        let mut base = shares.map(|u| knots[0] * (1.0 - u) + knots[1] * u);
        for term in self.terms[edge].iter().flatten() {
            let linear = piece.linear * term.linear;
            let norm = crate::fractal::piece::spectral_norm(linear);
            if norm * term.reach <= rest {
                continue;
            }
            for (base, u) in base.iter_mut().zip(shares) {
                *base -= term.linear * (term.start + term.chord * u);
            }
            let along = if term.flipped { [1.0 - shares[1], 1.0 - shares[0]] } else { shares };
            let places = along.map(|u| term.low + term.long * u);
            let flipped = piece.flipped != term.flipped;
            let mut part = Piece {
                linear,
                norm,
                low: places[0],
                high: places[1],
                first: term.from,
                last: term.from + term.span,
                flipped,
                stray: norm * term.reach,
            };
            if !whole {
                self.tighten(&mut part);
            }
            stretch.pieces.push(part);
        }
        if piece.flipped {
            base.reverse();
        }
        for (sum, base) in stretch.base.iter_mut().zip(base) {
            *sum += piece.linear * base;
        }
        None
    }

    /// Finds the knots next to a piece's ends, and how far it strays.
    fn tighten(&self, piece: &mut Piece) {
        while piece.first + 1 < piece.last && self.place(piece.first + 1) <= piece.low {
            piece.first += 1;
        }
        while piece.last > piece.first + 1 && self.place(piece.last - 1) >= piece.high {
            piece.last -= 1;
        }
        let (a, b) = (self.place(piece.first), self.place(piece.last));
        let (p, q) = (self.knot(piece.first), self.knot(piece.last));
        let mut most = 0.0_f64;
        let mut before = 0.0;
        for knot in piece.first + 1..=piece.last {
            let share = if b > a { (self.place(knot) - a) / (b - a) } else { 0.0 };
            let off = if knot == piece.last { 0.0 } else { self.knot(knot).distance(p + (q - p) * share) };
            most = most.max(off.max(before) + self.radii[(knot - 1) % self.knots.len()]);
            before = off;
        }
        // Cut within an edge, its chord is another one.
        let cut = a < piece.low || b > piece.high;
        piece.stray = piece.stray.min(piece.norm * most * if cut { 2.0 } else { 1.0 });
    }

    /// The knot inside a piece that is at a place, but for rounding.
    fn knot_at(&self, piece: &Piece, place: f64) -> Option<usize> {
        let inside = piece.first + 1..piece.last;
        inside.into_iter().find(|&knot| (self.place(knot) - place).abs() <= SAME_PLACE)
    }

    /// Cuts a stretch in two, at a share at which a piece has a knot, or blindly.
    fn cut(
        &self,
        stretch: &Stretch,
        (index, share, knot): (usize, f64, Option<usize>),
        rest: f64,
    ) -> [Stretch; 2] {
        let t = stretch.t[0] + share * (stretch.t[1] - stretch.t[0]);
        let base = stretch.base[0] * (1.0 - share) + stretch.base[1] * share;
        let mut corner = base;
        let mut sides = [Vec::with_capacity(stretch.pieces.len()), Vec::with_capacity(stretch.pieces.len())];
        for (i, piece) in stretch.pieces.iter().enumerate() {
            // Two copies often have knots at one place.
            let own = knot.filter(|_| i == index).or_else(|| self.knot_at(piece, piece.at(share)));
            let place = own.map_or_else(|| piece.at(share), |knot| self.place(knot));
            let source = match own {
                Some(knot) => self.knot(knot),
                None => self.value(place, rest / piece.norm, 1 << CORNER_DOUBLINGS),
            };
            corner += piece.linear * source;
            let (mut below, mut above) = (*piece, *piece);
            (below.high, above.low) = (place, place);
            if let Some(knot) = own {
                (below.last, above.first) = (knot, knot);
            }
            if knot.is_some() {
                self.tighten(&mut below);
                self.tighten(&mut above);
            }
            let parts = if piece.flipped { [above, below] } else { [below, above] };
            for (side, part) in sides.iter_mut().zip(parts) {
                side.push(part);
            }
        }
        let judged = knot.is_none().then(|| {
            let off = corner.distance(stretch.ends[0].midpoint(stretch.ends[1]));
            let stray = stretch.stray();
            (SAMPLED_STRAY.0 * stray).max(SAMPLED_STRAY.1 * off).min(HALF_STRAY * stray)
        });
        let [early, late] = sides;
        let [first, last] = stretch.ends;
        [
            Stretch {
                t: [stretch.t[0], t],
                ends: [first, corner],
                base: [stretch.base[0], base],
                pieces: early,
                judged,
            },
            Stretch {
                t: [t, stretch.t[1]],
                ends: [corner, last],
                base: [base, stretch.base[1]],
                pieces: late,
                judged,
            },
        ]
    }
}
