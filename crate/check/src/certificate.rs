//! What is to be checked: plain numbers.

use crate::exact::Exact;

/// A proof that the attractor of maps is in several pieces. See the [crate](crate) for what it says.
///
/// Maps are rows `[a, b, c, d, e, f]`, with `x' = a x + b y + e` and `y' = c x + d y + f`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Certificate {
    /// The maps.
    pub maps: Vec<[f64; 6]>,
    /// The corners of a strictly convex polygon, counter-clockwise.
    pub polygon: Vec<[f64; 2]>,
    /// Words of this many letters map the polygon into its inside. Mostly 1.
    pub letters: usize,
    /// For each map the side of the cut that it is on, 0 or 1.
    pub side: Vec<u8>,
    /// Pairs of words that are apart.
    pub pairs: Vec<Pair>,
    /// Which entries of the maps are exactly what numbers. Without it the doubles are meant.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub exact: Option<Exact>,
}

/// Two words whose pieces are apart, and a direction that shows it.
///
/// A word `[i, j, .., k]` of letters from 0 stands for the map that applies `w_k` first and `w_i` last.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pair {
    /// A word that begins on side 0.
    pub u: Vec<u8>,
    /// A word that begins on side 1.
    pub v: Vec<u8>,
    /// All of the piece of `u` is less far in this direction than all of the piece of `v`. Of any length but 0.
    pub normal: [f64; 2],
}
