//! Pictures that are swept on the processor.

use frond_core::Affine2;

use crate::coverage::sweep::{Progress, Sweep};
use crate::picture::window::Window;
use crate::pieces::frame::Frame;

/// A [`Sweep`] into codes, bit by bit.
#[derive(Debug)]
pub(in crate::gpu) struct CpuPass {
    sweep: Option<Sweep>,
    codes: Vec<u32>,
    window: Window,
    /// Pixels that are lit.
    pub lit: u64,
}

impl CpuPass {
    pub fn new() -> Self {
        Self { sweep: None, codes: Vec::new(), window: Window { width: 0, height: 0 }, lit: 0 }
    }

    /// Begins a picture.
    pub fn begin(&mut self, frame: &Frame, to_target: Affine2, window: Window, detail: f64) {
        self.codes.clear();
        self.codes.resize(window.area(), 0);
        self.window = window;
        self.lit = 0;
        match &mut self.sweep {
            Some(sweep) => sweep.restart(frame, to_target, window, detail),
            None => self.sweep = Some(Sweep::new(frame, to_target, window, detail)),
        }
    }

    /// Visits more pieces.
    pub fn go_on(&mut self, visits: u64) -> Progress {
        let Some(sweep) = &mut self.sweep else { return Progress::Complete };
        let (codes, lit) = (&mut self.codes, &mut self.lit);
        let width = self.window.width as usize;
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

    /// Codes, one a pixel, and the window they are of.
    pub fn codes(&self) -> (&[u32], Window) {
        (&self.codes, self.window)
    }
}
