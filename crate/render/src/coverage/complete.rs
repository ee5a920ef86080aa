//! The codes of a complete picture: points first, and a sweep of what they leave dark.

use frond_core::Affine2;

use crate::coverage::canvas::{Hit, Node};
use crate::coverage::sweep::{Progress, Sweep};
use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::{Code, Letters, ShortCode};
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
    let mut completion = Completion::new(frame, to_screen, window, detail, splats.codes);
    let progress = completion.run(frame, u64::MAX);
    (completion.codes, progress)
}

/// The codes of a complete picture in the making: what points left dark is swept, map by map from the last.
#[derive(Debug)]
pub(crate) struct Completion<C> {
    pub codes: Vec<C>,
    /// Pixels that were lit so far, of those that points left dark or gave to an earlier map.
    pub lit: u64,
    window: Window,
    to_screen: Affine2,
    detail: f64,
    sweep: Sweep,
    settled: Bitmap,
    /// Maps that are not begun yet, and whether one is begun.
    left: usize,
    working: bool,
    /// Whether all maps are swept at once.
    all: bool,
}

impl<C: Code> Completion<C> {
    /// Begins with the codes of points.
    pub fn new(frame: &Frame, to_screen: Affine2, window: Window, detail: f64, codes: Vec<C>) -> Self {
        Self {
            codes,
            lit: 0,
            window,
            to_screen,
            detail,
            sweep: Sweep::new(frame, to_screen, window, detail),
            settled: Bitmap::new(window),
            left: frame.maps.len(),
            working: false,
            all: false,
        }
    }

    /// Visits about `budget` more pieces, and says how far it got.
    pub fn run(&mut self, frame: &Frame, budget: u64) -> Progress {
        let mut visits = 0;
        while self.begin(frame) {
            if visits >= budget {
                return Progress::Working;
            }
            let before = self.sweep.visited();
            let Self { codes, lit, window, .. } = self;
            let progress = self.sweep.run(budget - visits, |hit| {
                *lit += 1;
                put(codes, *window, hit, frame.maps.len());
            });
            visits += self.sweep.visited() - before;
            self.working = progress == Progress::Working;
            if progress == Progress::Probed {
                if self.all {
                    return progress;
                }
                self.sweep_all(frame);
            }
        }
        Progress::Complete
    }

    /// Begins the next map, where none is begun. Returns whether there was one.
    fn begin(&mut self, frame: &Frame) -> bool {
        if self.working || self.left == 0 {
            return self.working;
        }
        self.left -= 1;
        self.working = true;
        let letters = Letters::NONE.then(self.left);
        let least = C::of(letters, frame.maps.len());
        // Later maps lie on top of this one.
        self.settled.light_where(&self.codes, |code| *code >= least);
        let piece = Node { map: self.to_screen * frame.maps[self.left], letters };
        self.sweep.restart_piece_on(frame, piece, &self.settled, self.detail);
        true
    }

    /// Begins once more with all maps: their sweep may make more visits before it gives up, and so may still come to
    /// its end.
    fn sweep_all(&mut self, frame: &Frame) {
        (self.left, self.working, self.all, self.lit) = (0, true, true, 0);
        self.codes.fill(C::default());
        self.sweep.restart(frame, self.to_screen, self.window, self.detail);
    }
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

fn put<C: Code>(codes: &mut [C], window: Window, hit: Hit, maps: usize) {
    let (x, y) = hit.pixel;
    codes[y as usize * window.width as usize + x as usize] = C::of(hit.letters, maps);
}
