//! A photograph on a sheet, by the graphics card.

use bytemuck::{Pod, Zeroable};
use glam::DVec2;

use super::device::Gpu;
use super::interface::{Buffer, Pipeline, Texture, Usage, draw};
use super::pass::{Bound, Draw, Pass};
use super::shaders::SHEET;
use super::words::{Attribute, Blend, Each, Format, Layout, Recipe, Slot};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::sheet::{Level, Photo, Sheet, SheetOptions, draw_sheet, on_target};

/// Corners further away than so many pixels have too few digits on the card: such a close view is drawn on the
/// processor, where it has few triangles.
const FARTHEST_CORNER_PIXELS: f64 = 1e6;
/// The most layers on the average before a sheet is drawn coarser: by a card, and by the processor in its place.
const MOST_LAYERS: (f64, f64) = (64.0, 16.0);

/// What `shader/sheet.wgsl` calls `Shown`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Shown {
    size: [f32; 2],
    factor: i32,
    premultiply: f32,
}

/// The photograph on the card, the sheet, and what it was drawn to.
#[derive(Debug)]
pub(super) struct SheetGpu {
    draw: Pipeline,
    show: Pipeline,
    photo: Texture,
    shown: Buffer,
    corners: Buffer,
    places: Buffer,
    indices: Buffer,
    /// How many indices there are, and the sheet's cells and step that they are for.
    count: u32,
    cells: (usize, usize),
    screen: Vec<[f32; 2]>,
    target: Option<Drawn>,
}

/// What was drawn.
#[derive(Debug)]
struct Drawn {
    texture: Texture,
    factor: u32,
}

/// Where corners are, and their places on the photograph.
const BUFFERS: [Layout; 2] =
    [(Each::Vertex, &[Attribute::Floats(2)]), (Each::Vertex, &[Attribute::Floats(2)])];

impl SheetGpu {
    pub fn new(gpu: &Gpu, photo: &Photo) -> Self {
        let card = &gpu.card;
        let recipe = Recipe {
            shader: SHEET,
            vertex: "sheet_vertex",
            fragment: "sheet_fragment",
            slots: &[(0, Slot::Uniform), (1, Slot::Photo)],
            buffers: &BUFFERS,
            points: false,
            on_top: None,
            // Triangles come from the front to the back: each is laid under what is there.
            blend: Some(Blend::Under),
            onto: &[Format::Colours],
        };
        let (shader, slots) = (["sheet_screen", "sheet_resolve"], [(0, Slot::Uniform), (3, Slot::Pixels)]);
        Self {
            draw: Pipeline::new(card, &recipe),
            show: Pipeline::new(card, &Recipe::full_screen(SHEET, shader, &slots, &[Format::Canvas])),
            photo: upload(gpu, photo),
            shown: Buffer::new(card, "shown", Usage::Uniform),
            corners: Buffer::new(card, "corners", Usage::Items),
            places: Buffer::new(card, "places", Usage::Items),
            indices: Buffer::new(card, "triangles", Usage::Indices),
            count: 0,
            cells: (0, 0),
            screen: Vec::new(),
            target: None,
        }
    }

    /// Draws a sheet, with `factor` x `factor` samples for each pixel of the window. Returns how many triangles it
    /// took.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        photo: &Photo,
        sheet: &Sheet,
        view: View,
        window: Window,
        factor: u32,
    ) -> u64 {
        let target = Window { width: window.width * factor, height: window.height * factor };
        let screen: Vec<DVec2> = on_target(sheet, view, window, f64::from(factor)).collect();
        // Not a number is not near either.
        if !screen.iter().all(|p| p.x.abs() < FARTHEST_CORNER_PIXELS && p.y.abs() < FARTHEST_CORNER_PIXELS) {
            self.draw_without(gpu, photo, sheet, view, window);
            return sheet.side().pow(2) as u64 * 2;
        }
        let step = sheet.step(&screen, target, if gpu.software { MOST_LAYERS.1 } else { MOST_LAYERS.0 });
        self.prepare(gpu, sheet, step);
        self.screen.clear();
        self.screen.extend(screen.iter().map(|p| p.as_vec2().to_array()));
        self.corners.fill(&gpu.card, &self.screen);
        let size = [target.width as f32, target.height as f32];
        self.shown.set(&gpu.card, &[Shown { size, factor: factor as i32, premultiply: 1.0 }]);
        let drawn = self.fit(gpu, target, factor);
        let pass = Pass {
            pipeline: &self.draw,
            bindings: &[(0, Bound::Uniform(&self.shown)), (1, Bound::Texture(&self.photo))],
            onto: &[&drawn.texture],
            depth: None,
            clear: true,
        };
        let all = Draw {
            buffers: [Some((&self.corners, 0)), Some((&self.places, 0))],
            indices: Some(&self.indices),
            count: self.count,
            instances: 1,
        };
        draw(&gpu.card, &pass, [all]);
        self.target = Some(drawn);
        u64::from(self.count / 3)
    }

    /// The same on the processor.
    fn draw_without(&mut self, gpu: &Gpu, photo: &Photo, sheet: &Sheet, view: View, window: Window) {
        let options =
            SheetOptions { width: window.width, height: window.height, view: Some(view), smooth: true };
        let Ok(mut picture) = draw_sheet(photo, sheet, &options) else { return };
        for pixel in picture.as_chunks_mut::<4>().0 {
            let [r, g, b, a] = pixel.map(u32::from);
            *pixel = [r, g, b, 255].map(|c| ((c * a + 127) / 255) as u8);
        }
        let drawn = self.fit(gpu, window, 1);
        drawn.texture.write(&gpu.card, 0, window, &picture);
        self.target = Some(drawn);
    }

    /// The target, of the right size.
    fn fit(&mut self, gpu: &Gpu, window: Window, factor: u32) -> Drawn {
        if let Some(kept) = self.target.take().filter(|kept| kept.texture.window == window) {
            return Drawn { factor, ..kept };
        }
        Drawn { texture: Texture::new(&gpu.card, "sheet", window, Format::Colours), factor }
    }

    /// Fills the buffers that hold whatever the corners are, but where they are.
    fn prepare(&mut self, gpu: &Gpu, sheet: &Sheet, step: usize) {
        if self.cells == (sheet.side(), step) {
            return;
        }
        let vertices = sheet.corners().len();
        if self.cells.0 != sheet.side() {
            let places: Vec<[f32; 2]> = (0..vertices).map(|i| sheet.place(i).as_vec2().to_array()).collect();
            self.places.fill(&gpu.card, &places);
        }
        let indices: Vec<u32> = sheet.triangles(step).flatten().collect();
        self.indices.fill(&gpu.card, &indices);
        self.count = indices.len() as u32;
        self.cells = (sheet.side(), step);
    }

    /// Makes a picture of what was drawn, if anything was: for the canvas, or straight for reading. Returns whether it
    /// was.
    pub fn resolve(&self, gpu: &Gpu, straight: bool, picture: &Texture) -> bool {
        let Some(Drawn { texture, factor }) = &self.target else { return false };
        let size = [texture.window.width as f32, texture.window.height as f32];
        let premultiply = if straight { 0.0 } else { 1.0 };
        self.shown.set(&gpu.card, &[Shown { size, factor: *factor as i32, premultiply }]);
        let pass = Pass {
            pipeline: &self.show,
            bindings: &[(0, Bound::Uniform(&self.shown)), (3, Bound::Texture(texture))],
            onto: &[picture],
            depth: None,
            clear: true,
        };
        draw(&gpu.card, &pass, [Draw::SCREEN]);
        true
    }
}

/// The photograph with its halvings, as far as the card takes them.
fn upload(gpu: &Gpu, photo: &Photo) -> Texture {
    let fits = |level: &&Level| level.width.max(level.height) <= gpu.max_side;
    let levels: Vec<_> = photo.levels().iter().filter(fits).collect();
    let window = levels.first().map_or(Window { width: 1, height: 1 }, |level| window_of(level));
    let texture = Texture::photo(&gpu.card, window, levels.len().max(1) as u32);
    for (i, level) in (0..).zip(&levels) {
        texture.write(&gpu.card, i, window_of(level), level.pixels.as_flattened());
    }
    texture
}

fn window_of(level: &Level) -> Window {
    Window { width: level.width, height: level.height }
}
