//! Pictures that are swept on the processor.

use frond_core::Affine2;

use crate::coverage::sweep::{Progress, Sweep};
use crate::picture::bitmap::Bitmap;
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

    /// Begins a picture on which some pixels are lit already, of which the others are to be found: see
    /// [`CpuPass::find`].
    pub fn begin_on(&mut self, frame: &Frame, to_target: Affine2, lit: &Bitmap, detail: f64) {
        self.codes = Vec::new();
        let window = lit.window();
        let sweep = self.sweep.get_or_insert_with(|| Sweep::new(frame, to_target, window, detail));
        sweep.restart_on(frame, to_target, lit, detail);
    }

    /// Visits more pieces, and tells which pixels become lit, with their codes.
    pub fn find(&mut self, visits: u64, light: &mut dyn FnMut((u32, u32), u32)) -> Progress {
        let Some(sweep) = &mut self.sweep else { return Progress::Complete };
        sweep.run(visits, |hit| light(hit.pixel, hit.letters.code()))
    }

    /// Visits more pieces.
    pub fn go_on(&mut self, visits: u64) -> Progress {
        let (mut codes, mut lit) = (std::mem::take(&mut self.codes), self.lit);
        let width = self.window.width as usize;
        let progress = self.find(visits, &mut |(x, y), code| {
            codes[y as usize * width + x as usize] = code;
            lit += 1;
        });
        (self.codes, self.lit) = (codes, lit);
        progress
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
