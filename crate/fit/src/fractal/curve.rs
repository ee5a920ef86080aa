//! Fractal curves: FIF, RFIF and PFIF with values in the plane.

use glam::{DMat2, DVec2};

use crate::error::{FunctionError, MAX_POINTS};
use crate::fractal::piece::Piece;

/// The most letters of an address that an evaluation follows. With a factor of 0.999 the value is then right to 1e-43.
const MAX_DEPTH: usize = 100_000;

/// How often the middle of the curve is taken anew. Any point serves as one, a better one for a smaller disc.
const MIDDLE_ROUNDS: usize = 32;

/// What may be taken for a knot, in parts of a piece.
pub(super) const NEAR_KNOT: f64 = 1e-9;

/// How far pieces may miss each other, as those that are printed with three digits do: in parts of the interval, and of
/// the shorter piece.
const MOST_SLIT: (f64, f64) = (2.5e-3, 0.25);

/// From which side a value is approached. It matters only where pieces do not meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The limit from smaller t.
    Left,
    /// The limit from larger t.
    Right,
}

impl Side {
    pub(crate) const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// A curve (x(t), y(t)) over an interval that is made of smaller copies of parts of itself
/// (Cochran, Hart & Flynn, eqs 3, 6 and 7).
///
/// Where the factors are diagonal it is separable (eq 8); else x and y answer to each other (eq 9), and x alone is a
/// hidden-variable function.
#[derive(Clone, Debug, PartialEq)]
pub struct FractalCurve {
    pieces: Vec<Piece>,
    bound: f64,
    gain: f64,
}

impl FractalCurve {
    /// A partitioned fractal curve (eq 7): any pieces that follow each other without holes, each a copy of any longer
    /// part.
    ///
    /// Numbers that were printed with few digits leave slits between pieces, or make them overlap: up to 1/400 of the
    /// interval and a quarter of the shorter piece is taken for that. In a slit the nearer end goes on; where two
    /// overlap the right one holds.
    ///
    /// # Errors
    /// Where numbers are not finite, pieces do not join, a domain is too short or outside, or a factor's norm is not
    /// below 1.
    pub fn new(mut pieces: Vec<Piece>) -> Result<Self, FunctionError> {
        if pieces.is_empty() {
            return Err(FunctionError::TooFewPoints { count: 0 });
        }
        if pieces.len() > MAX_POINTS {
            return Err(FunctionError::TooManyPoints { count: pieces.len() });
        }
        if let Some(index) = pieces.iter().position(|piece| !piece.is_finite()) {
            return Err(FunctionError::NotFinite { index });
        }
        let (start, end) = (pieces[0].range[0], pieces[pieces.len() - 1].range[1]);
        // Intervals that come from rounded maps may miss each other by rounding; they are then moved to meet.
        let slack = 1e-9 * (end - start).abs();
        for i in 0..pieces.len() {
            if i > 0 {
                let (before, begin) = (pieces[i - 1].range, pieces[i].range[0]);
                let slit = (begin - before[1]).abs();
                let shorter = (before[1] - before[0]).min(pieces[i].range[1] - begin);
                if slit <= slack {
                    pieces[i].range[0] = before[1];
                } else if slit > MOST_SLIT.0 * (end - start) || slit > MOST_SLIT.1 * shorter {
                    return Err(FunctionError::NotJoined { piece: i, begin, end: before[1] });
                }
            }
            let Piece { range, domain, .. } = pieces[i];
            if range[0] >= range[1] {
                return Err(FunctionError::NotIncreasing { index: i + 1 });
            }
            let held = domain.map(|t| t.clamp(start, end));
            let out = (held[0] - domain[0]).abs().max((held[1] - domain[1]).abs());
            let inside = out <= slack.max(MOST_SLIT.0 * (end - start));
            if !inside || domain[1] - domain[0] <= range[1] - range[0] {
                return Err(FunctionError::BadDomain { piece: i });
            }
            if out <= slack {
                pieces[i].domain = held;
            }
            let factor = pieces[i].gain();
            if factor >= 1.0 {
                return Err(FunctionError::NotContractive { piece: i, factor });
            }
        }
        let gain = pieces.iter().map(Piece::gain).fold(0.0, f64::max);
        let height = |piece: &Piece| {
            piece.domain.map(|t| (piece.offset + piece.shear * t).length()).into_iter().fold(0.0, f64::max)
        };
        let bound = pieces.iter().map(height).fold(0.0, f64::max) / (1.0 - gain);
        Ok(Self { pieces, bound, gain })
    }

    /// A fractal interpolation curve through knots (section 2.4): each piece a copy of the whole, reflected where told.
    ///
    /// # Errors
    /// As [`new`](Self::new), and where lists are of other lengths or t does not increase.
    pub fn fif(
        t: &[f64],
        knots: &[DVec2],
        factors: &[DMat2],
        reflected: &[bool],
    ) -> Result<Self, FunctionError> {
        let last = t.len().saturating_sub(1);
        let spans: Vec<_> = reflected.iter().map(|&back| if back { (last, 0) } else { (0, last) }).collect();
        Self::rfif(t, knots, factors, &spans)
    }

    /// A recurrent fractal curve through knots: piece i is a copy of the curve from knot `spans[i].0` to `spans[i].1`
    /// (eqs 4 and 5), backwards where the first is the larger.
    ///
    /// # Errors
    /// As [`fif`](Self::fif).
    pub fn rfif(
        t: &[f64],
        knots: &[DVec2],
        factors: &[DMat2],
        spans: &[(usize, usize)],
    ) -> Result<Self, FunctionError> {
        if t.len() < 2 || knots.len() < 2 {
            return Err(FunctionError::TooFewPoints { count: t.len().min(knots.len()) });
        }
        if t.len() > MAX_POINTS {
            return Err(FunctionError::TooManyPoints { count: t.len() });
        }
        let pieces = t.len() - 1;
        for given in [knots.len() - 1, factors.len(), spans.len()] {
            if given != pieces {
                return Err(FunctionError::WrongCount { pieces, given });
            }
        }
        let finite = |&i: &usize| !(t[i].abs() <= 1e100 && knots[i].abs().max_element() <= 1e100);
        if let Some(index) = (0..t.len()).find(finite) {
            return Err(FunctionError::NotFinite { index });
        }
        if let Some(index) = (1..t.len()).find(|&i| t[i] <= t[i - 1]) {
            return Err(FunctionError::NotIncreasing { index });
        }
        let piece = |i: usize| {
            let (from, to) = spans[i];
            if from.max(to) > pieces || from == to {
                return Err(FunctionError::BadDomain { piece: i });
            }
            let (low, high) = (from.min(to), from.max(to));
            let intervals = [[t[i], t[i + 1]], [t[low], t[high]]];
            let ends = [knots[i], knots[i + 1]];
            Ok(Piece::through(intervals, from > to, factors[i], ends, [knots[low], knots[high]]))
        };
        Self::of_plane((0..pieces).map(piece).collect::<Result<_, _>>()?)
    }

    /// A partitioned fractal curve from maps `[a, bx, by, cx, cxy, cyx, cy, d, ex, ey]` (eq 9) and their domains, in
    /// any order.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_maps(maps: &[([f64; 10], [f64; 2])]) -> Result<Self, FunctionError> {
        let mut pieces: Vec<_> =
            maps.iter().map(|&(map, domain)| Piece::from_plane_map(map, domain)).collect();
        if let Some(index) = pieces.iter().position(|piece| !piece.is_finite()) {
            return Err(FunctionError::NotFinite { index });
        }
        pieces.sort_by(|a, b| a.range[0].total_cmp(&b.range[0]));
        Self::of_plane(pieces)
    }

    /// The same as [`new`](Self::new), and says of a factor that lengthens which direction it does.
    fn of_plane(pieces: Vec<Piece>) -> Result<Self, FunctionError> {
        let long = pieces.iter().position(|piece| piece.is_finite() && piece.gain() >= 1.0);
        if let Some(piece) = long {
            let (factor, direction) = (pieces[piece].gain(), pieces[piece].longest().to_array());
            return Err(FunctionError::Lengthens { piece, factor, direction });
        }
        Self::new(pieces)
    }

    /// The pieces, from left to right.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The first and the last t.
    #[must_use]
    pub fn interval(&self) -> [f64; 2] {
        [self.pieces[0].range[0], self.pieces[self.pieces.len() - 1].range[1]]
    }

    /// No point of the curve is farther from the origin.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// The middle and the radius of a disc that holds the curve. Unlike the bound the radius does not hang on where
    /// the curve lies.
    #[must_use]
    pub fn disc(&self) -> (DVec2, f64) {
        let image = |piece: &Piece, t: f64, at: DVec2| piece.shear * t + piece.factor * at + piece.offset;
        let mut middle = DVec2::ZERO;
        for _ in 0..MIDDLE_ROUNDS {
            let of = |piece: &Piece| image(piece, f64::midpoint(piece.domain[0], piece.domain[1]), middle);
            middle = self.pieces.iter().map(of).sum::<DVec2>() / self.pieces.len() as f64;
        }
        // Every piece takes the disc into itself.
        let off = |piece: &Piece| {
            piece.domain.map(|t| image(piece, t, middle).distance(middle)).into_iter().fold(0.0, f64::max)
        };
        (middle, self.pieces.iter().map(off).fold(0.0, f64::max) / (1.0 - self.gain))
    }

    /// The contractivity under the metric of eq 2: max((1 + A) / 2, C), A the largest |a| and C the largest norm of a
    /// factor.
    #[must_use]
    pub fn contractivity(&self) -> f64 {
        let a = self.pieces.iter().map(|piece| piece.a().abs()).fold(0.0, f64::max);
        f64::midpoint(1.0, a).max(self.gain)
    }

    /// Index of the piece that holds `t`, seen from a side.
    pub(crate) fn piece_at(&self, t: f64, side: Side) -> usize {
        let index = match side {
            Side::Right => self.pieces.partition_point(|piece| piece.range[0] <= t),
            Side::Left => self.pieces.partition_point(|piece| piece.range[0] < t),
        };
        let index = index.clamp(1, self.pieces.len()) - 1;
        let into_slit = t - self.pieces[index].range[1];
        let is_next_nearer = |next: &Piece| into_slit > 0.0 && next.range[0] - t < into_slit;
        index + usize::from(self.pieces.get(index + 1).is_some_and(is_next_nearer))
    }

    /// The point at `t` (taken to the nearest end of the interval; NaN to the first), as near as numbers of 53 bits can
    /// follow its address: where some factor is near 1 and its piece is short, the error may be 1e-3 of the height.
    /// [`precise_at`](Self::precise_at) takes longer, and is right.
    ///
    /// Where pieces do not meet it is the limit from the right, at the last end that from the left.
    #[must_use]
    pub fn at(&self, t: f64) -> DVec2 {
        self.limit(t, Side::Right, 0.0)
    }

    /// The limit of the curve at `t` from a side, within a distance of `tolerance`.
    ///
    /// It follows the address of t, one letter a step, until what is left is too small to be seen. A parameter that has
    /// come as near to a knot as its rounding allows is taken to be that knot, as long as that is very near: an error
    /// of t grows with every letter, and a rough curve would show it.
    #[must_use]
    pub fn limit(&self, t: f64, side: Side, tolerance: f64) -> DVec2 {
        let [start, end] = self.interval();
        let mut t = if t > start { t.min(end) } else { start };
        let mut side = if t <= start {
            Side::Right
        } else if t >= end {
            Side::Left
        } else {
            side
        };
        let floor = tolerance.max(1e-18 * self.bound);
        // A step rounds the share of the range and the place in the domain, whose ends are themselves rounded.
        let unit = 4.0 * f64::EPSILON * start.abs().max(end.abs());
        let mut error = unit;
        let (mut sum, mut factor) = (DVec2::ZERO, DMat2::IDENTITY);
        for _ in 0..MAX_DEPTH {
            let index = self.piece_at(t, side);
            let mut piece = &self.pieces[index];
            let [low, high] = piece.range;
            if t - low <= error && t != low {
                // The value on the other side of a knot is another one only where pieces do not meet.
                t = low;
                if side == Side::Left && index > 0 {
                    piece = &self.pieces[index - 1];
                }
            } else if high - t <= error && t != high {
                t = high;
                if side == Side::Right && index + 1 < self.pieces.len() {
                    piece = &self.pieces[index + 1];
                }
            }
            if t == piece.range[0] || t == piece.range[1] {
                error = unit;
            }
            let source = piece.source(t);
            if piece.reflected {
                side = side.other();
            }
            error = (error / piece.a().abs() + unit).min(NEAR_KNOT * (high - low));
            sum += factor * (piece.shear * source + piece.offset);
            factor *= piece.factor;
            t = source;
            let left = factor.x_axis.abs().max_element().max(factor.y_axis.abs().max_element());
            if 2.0 * left * self.bound <= floor {
                break;
            }
        }
        sum
    }

    /// Where a piece is seen: its range, less what the next one lies over.
    pub(crate) fn seen(&self, index: usize) -> [f64; 2] {
        let [low, high] = self.pieces[index].range;
        [low, self.pieces.get(index + 1).map_or(high, |next| high.min(next.range[0]))]
    }

    /// The address of `t`: the pieces that hold it, the largest first, `letters` of them.
    #[must_use]
    pub fn address(&self, t: f64, letters: usize) -> Vec<usize> {
        let [start, end] = self.interval();
        let mut t = if t > start { t.min(end) } else { start };
        let mut side = if t >= end { Side::Left } else { Side::Right };
        let mut step = || {
            let index = self.piece_at(t, side);
            t = self.pieces[index].source(t);
            if self.pieces[index].reflected {
                side = side.other();
            }
            index
        };
        (0..letters).map(|_| step()).collect()
    }
}
