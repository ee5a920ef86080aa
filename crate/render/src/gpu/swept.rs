//! Pictures that are swept on the processor.

use frond_core::Affine2;

use super::device::Gpu;
use super::target::Target;
use crate::frame::Frame;
use crate::sweep::{Progress, Sweep};
use crate::window::Window;

/// A [`Sweep`] into codes, bit by bit.
#[derive(Debug, Default)]
pub(super) struct Swept {
    sweep: Option<Sweep>,
    codes: Vec<u32>,
    window: Option<Window>,
    /// Pixels that are lit.
    pub lit: u64,
}

impl Swept {
    /// Begins a picture.
    pub fn begin(&mut self, frame: &Frame, to_target: Affine2, window: Window, detail: f64) {
        self.codes.clear();
        self.codes.resize(window.area(), 0);
        self.window = Some(window);
        self.lit = 0;
        match &mut self.sweep {
            Some(sweep) => sweep.restart(frame, to_target, window, detail),
            None => self.sweep = Some(Sweep::new(frame, to_target, window, detail)),
        }
    }

    /// Visits more pieces.
    pub fn go_on(&mut self, visits: u64) -> Progress {
        let (Some(sweep), Some(window)) = (&mut self.sweep, self.window) else { return Progress::Complete };
        let (codes, lit) = (&mut self.codes, &mut self.lit);
        let width = window.width as usize;
        sweep.run(visits, |hit| {
            let (x, y) = hit.pixel;
            codes[y as usize * width + x as usize] = hit.letters.code();
            *lit += 1;
        })
    }

    /// Pieces visited so far.
    pub fn visited(&self) -> u64 {
        self.sweep.as_ref().map_or(0, Sweep::visited)
    }

    /// Hands it to a target of the same size.
    pub fn write(&self, gpu: &Gpu, target: &Target) {
        if self.window == Some(target.window) {
            target.write_codes(gpu, &self.codes);
        }
    }
}
