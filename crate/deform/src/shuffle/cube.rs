//! Codes of the points of a unit cube.

/// The address mapping of the unit cube of so many dimensions, cut into `parts` along each (Fujimoto et al., Fig
/// 1): the symbol of a cell is `ix + parts * iy + ..`, x fastest, 0 at the lower left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cube {
    dimensions: usize,
    parts: usize,
}

impl Cube {
    /// `None` for no dimension, fewer than two parts, or more symbols than 256.
    #[must_use]
    pub fn new(dimensions: usize, parts: usize) -> Option<Self> {
        let symbols = parts.checked_pow(u32::try_from(dimensions).ok()?)?;
        let fits = dimensions > 0 && parts > 1 && symbols <= crate::MAX_SYMBOLS;
        fits.then_some(Self { dimensions, parts })
    }

    /// The number of symbols, L.
    #[must_use]
    pub const fn symbols(&self) -> usize {
        self.parts.pow(self.dimensions as u32)
    }

    /// The first `letters` symbols of the code of a point, which is taken into the cube first. Cells hold their
    /// lower sides, but the last ones also the upper.
    #[must_use]
    pub fn code(&self, point: &[f64], letters: usize) -> Vec<u8> {
        let parts = self.parts as f64;
        let mut left: Vec<f64> = (0..self.dimensions)
            .map(|axis| point.get(axis).copied().unwrap_or(0.0).clamp(0.0, 1.0))
            .map(|x| if x.is_nan() { 0.0 } else { x })
            .collect();
        let mut symbol = || {
            let mut symbol = 0;
            for x in left.iter_mut().rev() {
                let digit = (*x * parts).floor().min(parts - 1.0);
                *x = (*x * parts - digit).clamp(0.0, 1.0);
                symbol = symbol * self.parts + digit as usize;
            }
            symbol as u8
        };
        (0..letters).map(|_| symbol()).collect()
    }

    /// The lower corner of the cell of a code, and the length of its sides. Symbols beyond the last are taken
    /// modulo their number.
    #[must_use]
    pub fn cell(&self, code: &[u8]) -> (Vec<f64>, f64) {
        let mut corner = vec![0.0; self.dimensions];
        let mut side = 1.0;
        for &symbol in code {
            side /= self.parts as f64;
            let mut left = usize::from(symbol) % self.symbols();
            for x in &mut corner {
                *x += (left % self.parts) as f64 * side;
                left /= self.parts;
            }
        }
        (corner, side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degenerate_cubes_and_points() {
        assert_eq!(Cube::new(0, 2), None);
        assert_eq!(Cube::new(2, 1), None);
        assert_eq!(Cube::new(2, 17), None);
        assert_eq!(Cube::new(usize::MAX, 2), None);
        let square = Cube::new(2, 2).unwrap();
        assert_eq!(square.code(&[f64::NAN, f64::INFINITY], 2), [2, 2]);
        assert_eq!(square.code(&[], 1), [0]);
        assert_eq!(square.cell(&[]), (vec![0.0, 0.0], 1.0));
        assert_eq!(square.cell(&[255]).0, [0.5, 0.5]);
    }

    #[test]
    fn a_code_names_the_cell_that_holds_the_point() {
        let cube = Cube::new(3, 3).unwrap();
        let code = cube.code(&[0.1, 0.5, 0.99], 5);
        let (corner, side) = cube.cell(&code);
        for (x, low) in [0.1, 0.5, 0.99].into_iter().zip(corner) {
            assert!(low <= x + 1e-12 && x < low + side + 1e-12);
        }
    }
}
