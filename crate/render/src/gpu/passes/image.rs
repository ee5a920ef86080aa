//! What a stage draws while a photograph takes the place of the attractor.

use frond_deform::Bend;
use glam::DVec2;

use crate::gpu::device::Gpu;
use crate::gpu::readback::ReadBack;
use crate::gpu::sheet::SheetGpu;
use crate::gpu::stage::Stage;
use crate::gpu::work::Work;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::sheet::{BentSheet, Photo, Sheet};

/// A photograph and the sheet that it is on.
#[derive(Debug)]
pub(in crate::gpu) struct Sheeted {
    photo: Photo,
    card: SheetGpu,
    rest: Sheet,
    /// Parts each way that the bend takes the square apart into.
    parts: usize,
    /// Made at once, and as fine as the bend.
    bent: [Option<BentSheet>; 2],
}

/// The most cells along a side of a sheet that is made at once.
const AT_ONCE: usize = 128;

impl Sheeted {
    /// Forgets what it knows of a bend.
    pub fn forget(&mut self) {
        self.bent = [None, None];
    }

    /// Takes a square apart into `maps` parts.
    pub fn set_maps(&mut self, maps: usize) {
        self.parts = if maps == 9 { 3 } else { 2 };
        self.forget();
    }

    /// Sees to it that there is a sheet, the finer one if that is wanted, and draws the best there is. Returns how many
    /// triangles that took, and whether it is as fine as the bend.
    fn draw(&mut self, bend: Option<(&Bend, &[DVec2])>, fine: bool, sight: &Sight<'_>) -> (u64, bool) {
        let Self { photo, card, rest, parts, bent } = self;
        let Some((bend, moves)) = bend else { return (sight.draw(card, photo, rest), true) };
        let which = usize::from(fine || bent[1].is_some());
        let most = [AT_ONCE, Sheet::FINEST][which];
        let chosen = bent[which].get_or_insert_with(|| BentSheet::new(bend, photo.aspect(), *parts, most));
        chosen.follow(moves);
        (sight.draw(card, photo, chosen.sheet()), which == 1)
    }
}

/// What is drawn to.
struct Sight<'a> {
    gpu: &'a Gpu,
    view: View,
    window: Window,
    factor: u32,
}

impl Sight<'_> {
    fn draw(&self, card: &mut SheetGpu, photo: &Photo, sheet: &Sheet) -> u64 {
        card.draw(self.gpu, photo, sheet, self.view, self.window, self.factor)
    }
}

impl Stage {
    /// Draws a photograph in place of the attractor, bent by the bend that is set; with `None` the attractor again. The
    /// maps that are set must be those of its sheet ([`Sheet::maps`]) for the bend to fit.
    pub fn set_photo(&mut self, photo: Option<Photo>) {
        self.sheeted = photo.map(|photo| {
            let maps = self.frame.as_ref().map_or(4, |frame| frame.maps.len());
            let mut sheeted = Sheeted {
                card: SheetGpu::new(&self.gpu, &photo),
                rest: Sheet::at_rest(photo.aspect()),
                photo,
                parts: 2,
                bent: [None, None],
            };
            sheeted.set_maps(maps);
            sheeted
        });
        self.work = Work::Anew;
        self.shown = None;
    }

    /// What [`Stage::draw`] does for a photograph: at once with what is at hand, then as fine as can be.
    pub(in crate::gpu) fn draw_sheet(&mut self, view: View) {
        let Some(mut sheeted) = self.sheeted.take() else { return };
        if self.work != Work::Done {
            self.advance_sheet(&mut sheeted, view);
        }
        if self.stale {
            self.present_sheet(&sheeted);
        }
        self.sheeted = Some(sheeted);
    }

    fn advance_sheet(&mut self, sheeted: &mut Sheeted, view: View) {
        let at_once = matches!(self.work, Work::Anew | Work::Moved);
        let full = self.sampling as u32;
        // Where there is no card each sample is dear.
        let factor = if at_once && self.gpu.software { 1 } else { full };
        let bend = self.bending.as_ref().map(|bending| (bending.bend(), bending.mesh()));
        let sight = Sight { gpu: &self.gpu, view, window: self.window, factor };
        let (triangles, fine) = sheeted.draw(bend, !at_once, &sight);
        self.points = triangles;
        self.complete = fine && factor == full;
        self.work = if self.complete { Work::Done } else { Work::Choose };
        self.stale = true;
    }

    fn present_sheet(&mut self, sheeted: &Sheeted) {
        let Some(canvas) = self.gpu.frame() else { return };
        let view = canvas.texture.create_view(&wgpu::TextureViewDescriptor::default());
        if let Some(encoder) = sheeted.card.resolve(&self.gpu, false, &view) {
            self.gpu.queue.submit([encoder.finish()]);
        }
        self.gpu.queue.present(canvas);
        self.stale = false;
    }

    /// What [`Stage::read`] does for a photograph.
    pub(in crate::gpu) fn read_sheet(&self, sheeted: &Sheeted) -> Option<ReadBack> {
        let texture = ReadBack::texture(&self.gpu, self.window);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let encoder = sheeted.card.resolve(&self.gpu, true, &view)?;
        Some(ReadBack::begin(&self.gpu, encoder, &texture, self.window))
    }
}
