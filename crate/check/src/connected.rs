//! What is to be checked of an attractor in one piece: plain numbers.

use crate::exact::Exact;

/// A proof that the attractor of maps is in one piece. See the [crate](crate) for what it says.
///
/// Maps are rows as in [`Certificate`](crate::Certificate), words and addresses lists of letters from 0.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ConnectedCertificate {
    /// The maps.
    pub maps: Vec<[f64; 6]>,
    /// The corners of a strictly convex polygon, counter-clockwise, which each map takes into its inside.
    pub polygon: Vec<[f64; 2]>,
    /// No gap is wider, where the polygon itself is 1 wide in all directions. From 1 on that needs no proof.
    pub gap: f64,
    /// Pairs of words whose pieces are so near that no gap is wider. They reach all maps.
    pub near: Vec<[Vec<u8>; 2]>,
    /// What holds pieces together. All of it reaches all maps.
    pub links: Vec<Link>,
    /// Where maps have one linear part, squares full of differences of two points of the attractor.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub squares: Option<Squares>,
    /// Which entries of the maps are exactly what numbers. Without it the doubles are meant.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub exact: Option<Exact>,
}

/// Squares full of differences of two points of the attractor.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Squares {
    /// How wide and how high one is.
    pub size: [f64; 2],
    /// For each how many widths and heights it is from the origin to its lower left corner, and two maps k, l: the
    /// inverse of the linear part takes it, less the difference of their translations `t_k - t_l`, into squares.
    pub cells: Vec<(i32, i32, u8, u8)>,
}

/// What holds the pieces of two maps together.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "kind", rename_all = "lowercase")
)]
pub enum Link {
    /// A point that both have.
    Point {
        /// Its address in the one and in the other.
        addresses: [Address; 2],
    },
    /// The areas of the two are too large to lie side by side.
    Area {
        /// The two maps.
        pair: [u8; 2],
    },
    /// Two copies of one shape and direction are moved by the difference of two points of such a copy.
    Difference {
        /// The two maps i, j.
        pair: [u8; 2],
        /// From `L^-1 (t_j - t_i)` these lead into the squares: pairs of maps k, l, each for
        /// `x -> L^-1 (x - (t_k - t_l))`.
        steps: Vec<[u8; 2]>,
    },
    /// The attractor lies on a line, and two pieces overlap there.
    Between {
        /// Two points of the first piece, and one of the second that lies between them.
        addresses: [Address; 3],
    },
    /// Two pieces lie across each other.
    Crossing {
        /// Their words.
        words: [Vec<u8>; 2],
        /// Two far pieces of the first, then two of the second.
        far: [Far; 4],
    },
}

/// An endless word: `head` once, then `repeat` without end. The point is `w_head(x)`, where `x` is fixed by `w_repeat`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Address {
    /// The letters before those that repeat; there may be none.
    pub head: Vec<u8>,
    /// The letters that repeat.
    pub repeat: Vec<u8>,
}

/// A part of a piece that juts out beyond another piece.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Far {
    /// What its word has behind that of the piece; there may be nothing.
    pub tail: Vec<u8>,
    /// Along this direction it is beyond all of the other piece, and what its gaps may add to that.
    pub direction: [f64; 2],
}
