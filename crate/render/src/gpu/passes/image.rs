//! What a stage draws while a photograph takes the place of the attractor.

use frond_deform::Bend;
use glam::DVec2;

use crate::gpu::device::Gpu;
use crate::gpu::interface::{ReadBack, Texture};
use crate::gpu::sheet::SheetGpu;
use crate::gpu::state::{StageState, Work};
use crate::gpu::words::Format;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::sheet::{BentSheet, Photo, Sheet};

/// A photograph and the sheet that it is on.
#[derive(Debug)]
pub(in crate::gpu) struct ImagePass {
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

impl ImagePass {
    /// A photograph in place of an attractor of so many maps.
    pub fn new(gpu: &Gpu, photo: Photo, maps: usize) -> Self {
        let (card, rest) = (SheetGpu::new(gpu, &photo), Sheet::at_rest(photo.aspect()));
        let mut image = Self { card, rest, photo, parts: 2, bent: [None, None] };
        image.set_maps(maps);
        image
    }

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
    fn draw_best(
        &mut self,
        bend: Option<(&Bend, &[DVec2])>,
        fine: bool,
        target_view: &TargetView<'_>,
    ) -> (u64, bool) {
        let Self { photo, card, rest, parts, bent } = self;
        let Some((bend, moves)) = bend else { return (target_view.draw(card, photo, rest), true) };
        let which = usize::from(fine || bent[1].is_some());
        let most = [AT_ONCE, Sheet::FINEST][which];
        let chosen = bent[which].get_or_insert_with(|| BentSheet::new(bend, photo.aspect(), *parts, most));
        chosen.follow(moves);
        (target_view.draw(card, photo, chosen.sheet()), which == 1)
    }

    /// What a stage draws: at once with what is at hand, then as fine as can be. `bend` is that of the stage, with the
    /// control points where they are to be.
    pub fn draw(&mut self, state: &mut StageState, bend: Option<(&Bend, &[DVec2])>, view: View) {
        if state.work != Work::Done {
            self.advance(state, bend, view);
        }
        if state.stale {
            self.present(state);
        }
    }

    fn advance(&mut self, state: &mut StageState, bend: Option<(&Bend, &[DVec2])>, view: View) {
        let at_once = matches!(state.work, Work::Anew | Work::Moved);
        let full = state.sampling as u32;
        // Where there is no card each sample is dear.
        let factor = if at_once && state.gpu.software { 1 } else { full };
        let target_view = TargetView { gpu: &state.gpu, view, window: state.window, factor };
        let (triangles, fine) = self.draw_best(bend, !at_once, &target_view);
        state.points = triangles;
        state.complete = fine && factor == full;
        state.work = if state.complete { Work::Done } else { Work::Choose };
        state.stale = true;
    }

    fn present(&self, state: &mut StageState) {
        let Some(canvas) = state.gpu.frame() else { return };
        self.card.resolve(&state.gpu, false, &canvas.texture);
        state.gpu.present(canvas);
        state.stale = false;
    }

    /// Begins to read the picture that is shown.
    pub fn read(&self, state: &StageState) -> Option<ReadBack> {
        let texture = Texture::new(&state.gpu.card, "read", state.window, Format::Colours);
        self.card.resolve(&state.gpu, true, &texture).then(|| state.gpu.read(&texture))
    }
}

/// What is drawn to.
struct TargetView<'a> {
    gpu: &'a Gpu,
    view: View,
    window: Window,
    factor: u32,
}

impl TargetView<'_> {
    fn draw(&self, card: &mut SheetGpu, photo: &Photo, sheet: &Sheet) -> u64 {
        card.draw(self.gpu, photo, sheet, self.view, self.window, self.factor)
    }
}
