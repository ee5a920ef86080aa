//! The codes of a complete picture: points first, and a sweep of what they leave dark.

use frond_core::Affine2;

use crate::coverage::canvas::{Hit, Node};
use crate::coverage::sweep::{Progress, Sweep};
use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::{Letters, ShortCode};
use crate::splat::Splats;

/// About how many points there are first.
const POINTS_FIRST: u64 = 3_000_000;

/// The codes of the pixels of a window, and whether they are known to be all. `to_screen` takes unit coordinates to
/// pixels, and `detail`, in pixels, is how far the attractor must reach into a pixel to light it for certain.
///
/// Points light most pixels ([`Splats`]), and a sweep of each map finds the others. The first letters are those that a
/// sweep alone finds; the second and third may be of another piece where the one on top reaches hardly into a pixel.
#[must_use]
pub fn codes(frame: &Frame, to_screen: Affine2, window: Window, detail: f64) -> (Vec<ShortCode>, Progress) {
    let splats = Splats::draw(frame, to_screen, window, POINTS_FIRST);
    if !splats.whole {
        return swept_codes(frame, to_screen, window, detail);
    }
    let mut codes = splats.codes;
    let mut settled = Bitmap::new(window);
    let mut sweep = Sweep::new(frame, to_screen, window, detail);
    let maps = frame.maps.len();
    for (letter, map) in frame.maps.iter().enumerate().rev() {
        let letters = Letters::NONE.then(letter);
        let least = ShortCode::of(letters, maps);
        // Later maps lie on top of this one.
        settled.light_where(&codes, |code| *code >= least);
        sweep.restart_piece_on(frame, Node { map: to_screen * *map, letters }, &settled, detail);
        if sweep.run(u64::MAX, |hit| put(&mut codes, window, hit, frame.maps.len())) == Progress::Probed {
            // A sweep of all maps may make more visits before it gives up, and so may still come to its end.
            return swept_codes(frame, to_screen, window, detail);
        }
    }
    (codes, Progress::Complete)
}

/// The same by a sweep alone, which takes ten times as long where pieces do not overlap without end.
pub(crate) fn swept_codes(
    frame: &Frame,
    to_screen: Affine2,
    window: Window,
    detail: f64,
) -> (Vec<ShortCode>, Progress) {
    let mut codes = vec![ShortCode::default(); window.area()];
    let mut sweep = Sweep::new(frame, to_screen, window, detail);
    let progress = sweep.run(u64::MAX, |hit| put(&mut codes, window, hit, frame.maps.len()));
    (codes, progress)
}

fn put(codes: &mut [ShortCode], window: Window, hit: Hit, maps: usize) {
    let (x, y) = hit.pixel;
    codes[y as usize * window.width as usize + x as usize] = ShortCode::of(hit.letters, maps);
}
