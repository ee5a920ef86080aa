//! Samples inside that meet only along an edge or in a corner, joined.
//!
//! A set of cells is well-composed where no two of it, or of what is outside, meet in an edge or in a corner alone
//! (Latecki, "3D well-composed pictures", 1997). Then a cell of surface nets holds one sheet, and their surface is a
//! manifold. Samples are only added, each between two that are there: it ends, and nothing grows beyond the box.

use super::field::Field;

/// The samples of a cell are numbered by bits: x, y, z. The faces, each as a square's corners in turn.
const FACES: [[usize; 4]; 6] =
    [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];

/// Fills samples until the set inside is well-composed.
pub(super) fn make_well_composed(field: &mut Field) {
    let [nx, ny, nz] = field.size;
    let mut open: Vec<[usize; 3]> = Vec::new();
    for z in 0..nz.saturating_sub(1) {
        for y in 0..ny.saturating_sub(1) {
            for x in 0..nx.saturating_sub(1) {
                open.push([x, y, z]);
                // What one fills the next sees; what it spoils comes at once.
                while let Some(cell) = open.pop() {
                    let Some(corner) = lacking(field, cell) else { continue };
                    let at = [0, 1, 2].map(|k| cell[k] + (corner >> k & 1));
                    let index = field.index(at);
                    field.fill(index);
                    for near in 0..8_usize {
                        let cell = [0, 1, 2].map(|k| at[k].checked_sub(near >> k & 1));
                        if let [Some(x), Some(y), Some(z)] = cell
                            && x + 1 < nx
                            && y + 1 < ny
                            && z + 1 < nz
                        {
                            open.push([x, y, z]);
                        }
                    }
                }
            }
        }
    }
}

/// The corner of a cell that has to be filled: the one nearest to the surface of those that help.
fn lacking(field: &Field, [x, y, z]: [usize; 3]) -> Option<usize> {
    let [nx, ny, _] = field.size;
    let first = field.index([x, y, z]);
    let value =
        |corner: usize| field.value[first + (corner & 1) + (corner >> 1 & 1) * nx + (corner >> 2) * nx * ny];
    let inside = (0..8).fold(0_u8, |set, corner| set | u8::from(value(corner) < 0.0) << corner);
    if inside == 0 || inside == 255 {
        return None;
    }
    let is = |corner: usize| inside >> corner & 1 == 1;
    let nearest = |corners: &mut dyn Iterator<Item = usize>| {
        corners.filter(|&corner| !is(corner)).min_by(|&a, &b| value(a).total_cmp(&value(b)))
    };
    for face in FACES {
        let [a, b, c, d] = face.map(is);
        if a == c && b == d && a != b {
            return nearest(&mut face.into_iter());
        }
    }
    // Two opposite corners alone.
    let alone = if inside.count_ones() == 2 { inside } else { !inside };
    let opposite = (0..4).any(|corner| alone == 1 << corner | 1 << (7 - corner));
    if opposite { nearest(&mut (0..8)) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cell of this set, in the midst of a grid.
    fn cell(inside: u8) -> Field {
        let mut field = Field::new([4, 4, 4], 1.0);
        field.signed();
        for corner in (0..8).filter(|corner| inside >> corner & 1 == 1) {
            let index = field.index([0, 1, 2].map(|k| 1 + (corner >> k & 1)));
            field.fill(index);
        }
        field
    }

    #[test]
    fn all_cells_become_well_composed_and_lose_nothing() {
        let mut filled = 0;
        for inside in 0..=255_u8 {
            let before = cell(inside);
            let mut field = cell(inside);
            make_well_composed(&mut field);
            for (x, y, z) in (0..27).map(|k| (k % 3, k / 3 % 3, k / 9)) {
                assert_eq!(lacking(&field, [x, y, z]), None, "{inside:08b}");
            }
            for (was, is) in before.value.iter().zip(&field.value) {
                assert!(*was >= 0.0 || *is < 0.0, "{inside:08b}");
                filled += usize::from(*was >= 0.0 && *is < 0.0);
            }
        }
        assert!(filled > 100, "{filled}");
    }

    #[test]
    fn what_is_well_composed_stays() {
        for inside in [0b0000_0001, 0b0000_0011, 0b0000_0111, 0b0111_1111, 0b1111_1111, 0b0001_0111] {
            let mut field = cell(inside);
            make_well_composed(&mut field);
            assert_eq!(field.value, cell(inside).value, "{inside:08b}");
        }
    }
}
