//! How dense the measure lies in each pixel of a bent attractor.

use super::{Bent, Cut, Cutter, Fineness};
use crate::density::{Contrast, Density};
use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;
use crate::pieces::measure::{MassPiece, Sampler};

/// Blocks of so many pixels each way are counted as lit or not.
const BLOCK_SIDE: u32 = 8;
/// Pieces have at most this part of the measure, as long as there are not too many.
const LARGEST_MEASURE: f64 = 1.0 / 256.0;
/// The smallest floor that is tried where there are too many pieces, and the number of times that it is doubled.
const FLOOR_RANGE: (f64, i32) = (0.5, 10);

impl Density {
    /// The density of a bent attractor, from at most about `most` pieces, each placed by an affine map and weighed by
    /// the measure, and of as many samples in all as `points` in each pass.
    #[must_use]
    pub fn bent(bent: &Bent<'_>, size: f64, most: usize, points: usize) -> Self {
        let mut pieces = Vec::new();
        let mut cutter = Cutter::default();
        for doublings in -1..FLOOR_RANGE.1 {
            let floor = if doublings < 0 { 0.0 } else { FLOOR_RANGE.0 * f64::from(1 << doublings) };
            let fineness = Fineness {
                floor,
                affine: true,
                mass: LARGEST_MEASURE,
                tolerance: 0.25,
                ..Fineness::complete(size.max(floor))
            };
            pieces.clear();
            cutter.begin(bent, most);
            let cut = cutter.run(bent, &fineness, u64::MAX, |piece| {
                pieces.push(MassPiece { map: piece.placed.map, letters: piece.letters, mass: piece.mass });
            });
            if cut != Cut::TooMany {
                break;
            }
        }
        let blocks = Window {
            width: bent.window.width.div_ceil(BLOCK_SIDE),
            height: bent.window.height.div_ceil(BLOCK_SIDE),
        };
        let mut lit = Bitmap::new(blocks);
        let (mut count, mut seen) = (0, 0.0);
        for piece in &pieces {
            let Some((x, y)) = bent.window.pixel(piece.map.apply(bent.frame.anchor)) else { continue };
            seen += piece.mass;
            count += usize::from(lit.set((x / BLOCK_SIDE, y / BLOCK_SIDE)));
            for tip in &bent.frame.tips {
                let Some((x, y)) = bent.window.pixel(piece.map.apply(*tip)) else { continue };
                count += usize::from(lit.set((x / BLOCK_SIDE, y / BLOCK_SIDE)));
            }
        }
        let lit = count.max(1) * (BLOCK_SIDE * BLOCK_SIDE) as usize;
        let gain = if seen > 0.0 { (lit as f64 / seen) as f32 } else { 0.0 };
        let samples = (points / pieces.len().max(1)).clamp(1, 2048);
        let tone = Contrast::of(bent.frame).tone(&pieces, bent.window);
        Self { pieces, sampler: Sampler::new(bent.frame, samples), gain, lit, tone }
    }
}
