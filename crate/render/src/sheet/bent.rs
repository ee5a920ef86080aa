//! A sheet that follows a bend.

use frond_deform::{Bend, Cursor, Skin};
use glam::DVec2;

use super::Sheet;

/// A [`Sheet`] and how it follows the mesh of a bend of the [`Sheet::maps`]: moving the mesh costs a weighted sum over
/// its control points for each corner, however deep and rough the bend is.
#[derive(Clone, Debug)]
pub struct BentSheet {
    sheet: Sheet,
    /// Of so many corners each, one after the other.
    skins: Vec<Skin>,
    moves: Vec<DVec2>,
}

/// Corners in a skin: what is looked up for them does not have to be held for all at once.
const CORNERS_A_SKIN: usize = 1 << 14;

impl BentSheet {
    /// The sheet under a bend that was made for [`Sheet::maps`] of this `aspect` and these `parts`; with those of
    /// another shape it is bent some other way. At most `most` cells a side, and no more than the bend can tell apart.
    #[must_use]
    pub fn new(bend: &Bend, aspect: f64, parts: usize, most: usize) -> Self {
        let (side, letters) = Sheet::resolution(parts, bend.ke(), most);
        let sheet = Sheet::new(aspect, side, |place| place);
        let mut skins = Vec::new();
        let mut places = Vec::with_capacity(CORNERS_A_SKIN);
        let pieces = parts.pow(letters as u32);
        let cells = side / pieces;
        let mut row = (usize::MAX, Vec::new());
        for j in 0..=side {
            let piece = (j / cells).min(pieces - 1);
            if row.0 != piece {
                row = (piece, row_of_pieces(bend, parts, letters, piece));
            }
            let y = (j - piece * cells) as f64 / cells as f64;
            for i in 0..=side {
                let piece = (i / cells).min(pieces - 1);
                let x = (i - piece * cells) as f64 / cells as f64;
                places.push((row.1[piece].clone(), DVec2::new(x * sheet.aspect(), y)));
                if places.len() == CORNERS_A_SKIN {
                    skins.push(bend.skin(&places));
                    places.clear();
                }
            }
        }
        skins.push(bend.skin(&places));
        let mut this = Self { sheet, skins, moves: Vec::new() };
        this.follow(bend.mesh().displacements());
        this
    }

    /// The sheet where the mesh takes it.
    #[must_use]
    pub const fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// Moves the control points.
    pub fn follow(&mut self, displacements: &[DVec2]) {
        if self.moves == displacements && !displacements.is_empty() {
            return;
        }
        let corners = self.sheet.corners_mut().chunks_mut(CORNERS_A_SKIN);
        for (corners, skin) in corners.zip(&self.skins) {
            skin.follow(displacements, corners.as_flattened_mut());
        }
        self.moves = displacements.to_vec();
    }
}

/// The pieces of one row of the square, from left to right.
fn row_of_pieces(bend: &Bend, parts: usize, letters: usize, row: usize) -> Vec<Cursor> {
    let mut pieces = vec![bend.whole()];
    for left in (0..letters as u32).rev() {
        let first = row / parts.pow(left) % parts * parts;
        pieces =
            pieces.iter().flat_map(|p| (first..first + parts).map(|letter| bend.child(p, letter))).collect();
    }
    pieces
}
