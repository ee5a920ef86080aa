//! Numbers as two whole ones of sixteen bits: how points and pieces are given to what places them.

/// Coordinates of the unit disc are parts of this.
const UNIT: f64 = 32_768.0;
/// The second sixteen bits of a number are parts of 2^-14 of the first.
const LOW: f64 = 16_384.0;
pub const LOW_SHIFT: u32 = 14;

/// A number that is a whole one, at most 32767 either way, and sixteen bits of what is left.
#[inline(never)]
pub fn split(number: f64) -> [i16; 2] {
    // A cast of what is too large gives the largest.
    let high = number.floor() as i16;
    [high, ((number - f64::from(high)) * LOW) as i16]
}

/// The coordinates of a point, high parts first.
pub fn split_point(position: [f32; 2]) -> [[i16; 2]; 2] {
    let [x, y] = position.map(|coordinate| split(f64::from(coordinate) * UNIT));
    [[x[0], y[0]], [x[1], y[1]]]
}
