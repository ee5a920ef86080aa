//! Points of an attractor, one in each cell of a grid that it reaches.

use frond_core::{Affine3, Ifs3};
use glam::DVec3;

/// The images of a fixed point under all words, each taken further only where it is the first in its cell. All of them
/// are points of the attractor; every other point of it has one near by, since images of what is near are nearer.
pub(super) struct Orbit {
    maps: Vec<Affine3>,
    /// Single precision: what is lost shrinks with every map.
    open: Vec<[f32; 3]>,
    seen: Vec<u64>,
    cells: [usize; 3],
    per_unit: f64,
    found: usize,
}

impl Orbit {
    /// `maps` in coordinates in which the attractor lies between 0 and `extent`; `cell` is the side of a cell.
    pub fn new(ifs: &Ifs3, maps: Vec<Affine3>, extent: DVec3, cell: f64) -> Self {
        let cells = (extent / cell).to_array().map(|count| count.max(0.0) as usize + 1);
        let mut made = Self {
            maps,
            open: Vec::new(),
            seen: vec![0; cells.iter().product::<usize>().div_ceil(64)],
            cells,
            per_unit: 1.0 / cell,
            found: 0,
        };
        debug_assert_eq!(ifs.len(), made.maps.len());
        let start = made.maps[0].fixed_point().unwrap_or(DVec3::ZERO);
        made.open.push(start.as_vec3().to_array());
        made
    }

    /// So many points were found.
    pub fn found(&self) -> usize {
        self.found
    }

    /// Takes `budget` points further, and visits those that are new, each with the map that it is an image under.
    /// Whether all are found.
    pub fn run(&mut self, budget: usize, mut visit: impl FnMut(DVec3, usize)) -> bool {
        for _ in 0..budget {
            let Some([x, y, z]) = self.open.pop() else { return true };
            let from = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
            for (letter, map) in self.maps.iter().enumerate() {
                let point = map.apply(from);
                let cell = self.cell(point);
                let (word, bit) = (cell >> 6, 1 << (cell & 63));
                if self.seen[word] & bit != 0 {
                    continue;
                }
                self.seen[word] |= bit;
                self.found += 1;
                self.open.push(point.as_vec3().to_array());
                visit(point, letter);
            }
        }
        self.open.is_empty()
    }

    fn cell(&self, point: DVec3) -> usize {
        // What rounding has put outside belongs to the border; casts keep what is below 0 at it.
        let at = (point * self.per_unit).to_array();
        let index = |k: usize| (at[k] as usize).min(self.cells[k] - 1);
        (index(2) * self.cells[1] + index(1)) * self.cells[0] + index(0)
    }
}
