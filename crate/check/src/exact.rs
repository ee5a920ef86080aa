//! What numbers are meant where a double can only come near: plain texts.

/// Entries of maps that are exactly numbers of one field, `Q[x] / (p)`: powers of one root of a polynomial `p`, with
/// fractions before them. A fraction is a text such as `"-3"` or `"7/4"`.
///
/// `1/3` needs no root: the polynomial `["0", "1"]`, that is x, whose root 0 is in `["-1", "1"]`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Exact {
    /// Whole numbers, the constant term first.
    pub polynomial: Vec<String>,
    /// The ends of an interval, fractions. The one root in it is meant.
    pub root: [String; 2],
    /// What is exact. All other entries are the doubles of the maps.
    pub entries: Vec<ExactEntry>,
}

/// One entry of one map.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ExactEntry {
    /// Which map.
    pub map: u8,
    /// Which number of its row `[a, b, c, d, e, f]`, from 0 to 5.
    pub entry: u8,
    /// Fractions: the coefficients of 1, of the root, of its square and so on. Those that are not there are 0.
    pub value: Vec<String>,
}
