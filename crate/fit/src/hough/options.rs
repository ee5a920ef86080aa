//! What is counted, and in how many bins.

/// Bins of a, b and c each.
pub const BINS: usize = 128;

/// Bins of d and e each, in the second pass.
pub const PLANE: usize = 256;

/// The most cells whose (d, e) are counted: 200 planes take 50 MiB.
pub const MAX_CELLS: usize = 200;

/// What is counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoughOptions {
    /// Whether mirrored maps (a < 0) are tried, too; it takes twice as long.
    pub reflected: bool,
    /// Maps with a smaller |a| are clutter: almost everything looks alike when it is small. They are not counted.
    pub least_a: f64,
    /// Maps with a smaller |c| are clutter: they flatten everything. They get no cell in the second pass.
    pub least_c: f64,
    /// How many (a, b, c) cells the second pass looks at, at most [`MAX_CELLS`].
    pub cells: usize,
    /// The largest |b|, in heights for a length of the interval.
    pub most_b: f64,
}

impl Default for HoughOptions {
    fn default() -> Self {
        Self { reflected: true, least_a: 0.15, least_c: 0.15, cells: 100, most_b: 3.0 }
    }
}
