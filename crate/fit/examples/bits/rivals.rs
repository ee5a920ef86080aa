//! What a fit of copies comes to in its own packing.

use frond_fit::{ClosedCurve, DRAWING_LEVELS, DRAWING_TOLERANCE, Fitter, Outline};
use glam::DVec2;

/// Grids, in parts of the diagonal: each is finer than the one before by a root of two.
fn grids(diagonal: f64) -> impl Iterator<Item = f64> {
    (0..28).map(move |i| diagonal / 12.0 * 0.5_f64.powf(f64::from(i) / 2.0))
}

/// What a fit of the program comes to in its own packing, less the 25 bytes of it that say where the curve lies.
pub fn packed(
    outline: &Outline,
    bytes: usize,
    error: &dyn Fn(&[DVec2]) -> f64,
) -> Option<(Vec<DVec2>, usize)> {
    const FRAME: usize = 25;
    let diagonal = outline.diagonal();
    let mut best: Option<(f64, (Vec<DVec2>, usize))> = None;
    // A corner is 14 to 22 bits.
    for bits in [12.0, 15.0, 19.0, 24.0] {
        let numbers = 2 * (8.0 * bytes as f64 / bits) as usize;
        let Ok(fitter) = Fitter::new(outline, numbers.max(12)) else { continue };
        let curve = fitter.finish();
        for grid in grids(diagonal) {
            let Ok(packed) = curve.to_bytes(0.7 * grid) else { continue };
            if packed.len() > bytes + FRAME {
                continue;
            }
            let Ok(back) = ClosedCurve::from_bytes(&packed) else { continue };
            let line = back.polyline(DRAWING_TOLERANCE * diagonal, DRAWING_LEVELS);
            let off = error(&line);
            if best.as_ref().is_none_or(|best| off < best.0) {
                best = Some((off, (line, back.copies())));
            }
        }
    }
    best.map(|best| best.1)
}
