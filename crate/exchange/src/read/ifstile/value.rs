//! What is computed with: numbers, lists and maps.

/// What a name or a bracket stands for.
#[derive(Clone, Debug)]
pub enum Value {
    Number(f64),
    List(Vec<f64>),
    /// Several: any of them.
    Maps(Vec<Map>),
    /// Images of the set.
    Images(Vec<Map>),
}

/// `x' = matrix x + shift`, in two or three dimensions.
#[derive(Clone, Debug)]
pub struct Map {
    pub size: usize,
    pub matrix: [f64; 9],
    pub shift: [f64; 3],
}

impl Map {
    pub fn scaling(size: usize, factor: f64) -> Self {
        let mut map = Self { size, matrix: [0.0; 9], shift: [0.0; 3] };
        (0..size).for_each(|k| map.matrix[k * size + k] = factor);
        map
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Self) -> Self {
        let size = self.size;
        let mut map = Self { size, matrix: [0.0; 9], shift: self.shift };
        for row in 0..size {
            for k in 0..size {
                let x = self.matrix[row * size + k];
                // Not times zero: that keeps infinities and the signs of zeros out.
                if x != 0.0 {
                    for column in 0..size {
                        map.matrix[row * size + column] += x * inner.matrix[k * size + column];
                    }
                    map.shift[row] += x * inner.shift[k];
                }
            }
        }
        map
    }
}
