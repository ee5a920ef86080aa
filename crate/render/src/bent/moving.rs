//! Pieces that follow the mesh.

use frond_deform::{Cursor, Skin};
use glam::DVec2;

use super::{Bent, Placed, bend_to};
use crate::pieces::letters::Letters;

/// The pieces of a [`BentPlan`](super::BentPlan) as they move with the mesh: the anchors of each are skinned, sixteen
/// weights for a mesh of 4 x 4, however deep the bend is.
#[derive(Debug, Default)]
pub struct Moving {
    pieces: Vec<(Cursor, Letters, u32)>,
    skins: Vec<Skin>,
    places: Vec<f32>,
}

/// Pieces that are skinned together.
const PIECES_A_SKIN: usize = 4096;
/// How far off, in pixels, a skinned anchor may be.
const ANCHOR_TOLERANCE: f64 = 0.1;

impl Moving {
    /// Forgets all pieces.
    pub fn clear(&mut self) {
        self.pieces.clear();
        self.skins.clear();
    }

    pub(super) fn push(&mut self, cursor: Cursor, letters: Letters, tint: u32) {
        self.pieces.push((cursor, letters, tint));
    }

    /// How many pieces there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pieces.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Whether single precision is enough. If not, the bend itself must have the mesh that is followed.
    #[must_use]
    pub fn can_skin(bent: &Bent<'_>) -> bool {
        let to_world = bent.frame.to_world;
        let largest = to_world.translation.abs().max_element() + to_world.norm() + bent.bend.reach();
        bent.eye.blur(largest) <= ANCHOR_TOLERANCE
    }

    /// Tells for each piece where it is when the control points of the mesh are displaced so, its letters and its tint.
    pub(super) fn follow(
        &mut self,
        bent: &Bent<'_>,
        displacements: &[DVec2],
        mut put: impl FnMut(&Placed, Letters, u32),
    ) {
        if !Self::can_skin(bent) {
            for (cursor, letters, tint) in &self.pieces {
                put(&bent.placed(cursor), *letters, *tint);
            }
            return;
        }
        let anchors = bent.bend.anchors();
        if self.skins.is_empty() {
            let skin = |pieces: &[(Cursor, Letters, u32)]| {
                let places = pieces
                    .iter()
                    .flat_map(|(cursor, ..)| anchors.iter().map(move |anchor| (cursor.clone(), *anchor)));
                bent.bend.skin(&places.collect::<Vec<_>>())
            };
            self.skins = self.pieces.chunks(PIECES_A_SKIN).map(skin).collect();
        }
        for (skin, pieces) in self.skins.iter().zip(self.pieces.chunks(PIECES_A_SKIN)) {
            self.places.resize(2 * skin.len(), 0.0);
            skin.follow(displacements, &mut self.places);
            let each = self.places.chunks_exact(2 * anchors.len().max(1));
            for (place, (_, letters, tint)) in each.zip(pieces) {
                let at = |i: usize| {
                    let i = 2 * i.min(anchors.len() - 1);
                    DVec2::new(f64::from(place[i]), f64::from(place[i + 1]))
                };
                let points = bend_to([at(0), at(1), at(2), at(3)], &bent.eye);
                put(&bent.sides.placed(points), *letters, *tint);
            }
        }
    }

    /// Bytes that it holds.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let skins: usize = self.skins.iter().map(|skin| skin.len() * skin.bytes()).sum();
        skins + size_of_val(&self.pieces[..]) + size_of_val(&self.places[..])
    }
}
