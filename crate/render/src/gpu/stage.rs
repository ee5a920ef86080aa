//! Drawing an attractor, coarse at once and complete after some frames.

use frond_core::{Hull, Ifs};

use super::buffer::uniform;
use super::device::Gpu;
use super::passes::cpu::Swept;
use super::passes::deformed::Bending;
use super::passes::density::Weighed;
use super::passes::image::Sheeted;
use super::passes::points::Planned;
use super::pipelines::Pipelines;
use super::readback::ReadBack;
use super::target::Target;
use super::work::{Shown, Work};
use crate::picture::colour::{Colouring, Look};
use crate::picture::resolve::{picture_of_codes, picture_of_density};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::plan::Plan;
use crate::raster::MAX_SIDE;

/// How a picture looks.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// How pieces are coloured.
    pub colouring: Colouring,
    /// One sRGB colour a map, repeated when there are more maps; empty for Okabe and Ito's.
    pub palette: Vec<[u8; 3]>,
    /// How bright a density is: 1 by default.
    pub exposure: f32,
}

impl Default for Style {
    fn default() -> Self {
        Self { colouring: Colouring::Map, palette: Vec::new(), exposure: 1.0 }
    }
}

/// What [`Stage::draw`] came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// Whether the picture that is shown is complete: every pixel that holds a piece of the attractor
    /// smaller than half a pixel is lit.
    pub complete: bool,
    /// Whether drawing on would change nothing. Without being complete, this is a shape whose pieces
    /// overlap too much to visit them all, or a lost device.
    pub settled: bool,
    /// The number of points in the picture that is shown.
    pub points: u64,
}

/// Draws one attractor on one canvas.
///
/// While things change each call of [`Stage::draw`] makes a whole picture of as many pixels as the budget
/// allows: fewer and larger ones where it is small. When they rest, the next calls draw the complete picture
/// aside and show it when it is ready.
///
/// Pictures are points, drawn by the graphics card. Where an attractor overlaps itself so much that points
/// would be drawn without end, or where there is no card and each point is dear, they are swept on the
/// processor instead, which lights each pixel but once.
#[derive(Debug)]
pub struct Stage {
    pub(super) gpu: Gpu,
    pub(super) pipelines: Pipelines,
    pub(super) window: Window,
    /// Pixels that are drawn for each one shown, each way, when the picture is complete.
    pub(super) sampling: f64,
    pub(super) frame: Option<Frame>,
    pub(super) view: Option<View>,
    pub(super) style: Style,
    pub(super) work: Work,
    /// Whether the picture must be shown again.
    pub(super) stale: bool,
    pub(super) complete: bool,
    pub(super) points: u64,
    /// The picture that is shown, and its pixels for each one shown.
    pub(super) shown: Option<(Shown, f64)>,
    pub(super) front: Option<Target>,
    pub(super) back: Option<Target>,
    pub(super) sums: Option<Target>,
    pub(super) painted: Option<Target>,
    pub(super) look: wgpu::Buffer,
    pub(super) straight_look: wgpu::Buffer,
    pub(super) plan: Plan,
    pub(super) planned: Planned,
    /// What follows the mesh of a bend.
    pub(super) followed: Planned,
    pub(super) bending: Option<Bending>,
    pub(super) sheeted: Option<Sheeted>,
    /// At once, and complete.
    pub(super) swept: [Swept; 2],
    pub(super) weighed: Weighed,
    pub(super) halvings: u32,
}

impl Stage {
    /// A stage on a device, with nothing on it.
    #[must_use]
    pub fn new(gpu: Gpu) -> Self {
        Self {
            pipelines: Pipelines::new(&gpu.device, gpu.format(), gpu.sums),
            window: Window { width: 0, height: 0 },
            sampling: 2.0,
            frame: None,
            view: None,
            style: Style::default(),
            work: Work::Anew,
            stale: false,
            complete: false,
            points: 0,
            shown: None,
            front: None,
            back: None,
            sums: None,
            painted: None,
            look: uniform::<Look>(&gpu.device, "look"),
            straight_look: uniform::<Look>(&gpu.device, "straight look"),
            plan: Plan::default(),
            planned: Planned::new(&gpu),
            followed: Planned::new(&gpu),
            bending: None,
            sheeted: None,
            swept: [Swept::new(), Swept::new()],
            weighed: Weighed::new(&gpu),
            halvings: 1,
            gpu,
        }
    }

    /// The device.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Sets the size of the canvas in device pixels. Edges are smoothed where `pixel_ratio` (device pixels
    /// for each CSS pixel) is below 2; beyond, pixels are too small to see.
    pub fn resize(&mut self, width: u32, height: u32, pixel_ratio: f64) {
        let side = self.gpu.max_side.min(MAX_SIDE);
        let window = Window { width: width.min(side), height: height.min(side) };
        let fits = window.width.max(window.height) * 2 <= self.gpu.max_side;
        self.sampling = if fits && pixel_ratio < 2.0 { 2.0 } else { 1.0 };
        self.window = window;
        self.gpu.resize(window.width, window.height);
        self.work = Work::Anew;
    }

    /// Sets what is drawn. A bend stays, so that one for the new maps must follow if there is any.
    pub fn set_ifs(&mut self, ifs: &Ifs) {
        let hull = Hull::of(ifs);
        self.frame = Some(Frame::within(ifs, &hull));
        if let Some(bending) = &mut self.bending {
            bending.forget();
        }
        if let Some(sheeted) = &mut self.sheeted {
            sheeted.set_maps(ifs.len());
        }
        self.work = Work::Anew;
    }

    /// Sets the part of the plane that is shown. Returns whether it is a view; if not, nothing changes.
    pub fn set_view(&mut self, view: View) -> bool {
        if !view.is_valid() {
            return false;
        }
        if self.view != Some(view) {
            self.view = Some(view);
            self.work = Work::Anew;
        }
        true
    }

    /// Sets how it looks.
    pub fn set_style(&mut self, style: Style) {
        let dense = |style: &Style| style.colouring == Colouring::Density;
        let carried = |style: &Style| style.colouring == Colouring::Grid;
        // Codes hold for all colours, sums for one palette, and colours for themselves.
        let other = dense(&style) != dense(&self.style) || carried(&style) != carried(&self.style);
        if other || (dense(&style) && style.palette != self.style.palette) {
            self.work = Work::Anew;
        }
        self.stale |= style != self.style;
        self.style = style;
    }

    /// Draws what is new, or goes on with the complete picture: about `budget` points.
    pub fn draw(&mut self, budget: u64) -> Drawn {
        let ready = self.window.area() > 0 && !self.gpu.is_lost() && self.view.is_some();
        let Some(frame) = self.frame.take() else {
            return Drawn { complete: false, settled: true, points: 0 };
        };
        if let Some(view) = self.view.filter(|_| ready) {
            if self.sheeted.is_some() {
                self.draw_sheet(view);
            } else {
                self.advance(&frame, view, budget.max(10_000));
                if self.stale {
                    self.paint(&frame);
                    self.present(&frame);
                }
            }
        }
        self.frame = Some(frame);
        let settled = !ready || (self.work == Work::Done && !self.stale);
        Drawn { complete: self.complete && settled && ready, settled, points: self.points }
    }

    /// The look of a picture: what it is made from, the pixels of that for each one shown, and what sums are
    /// multiplied by.
    pub(super) fn look(&self, frame: &Frame, source: Window, factor: f64, gain: f32) -> Look {
        Look {
            source: [source.width as i32, source.height as i32],
            factor: factor as f32,
            gain: self.style.exposure.max(0.0) * gain,
            tinted: f32::from(u8::from(self.coloured(frame))),
            ..Look::new(self.style.colouring, &self.style.palette, frame.maps.len())
        }
    }

    /// Makes the picture that is shown, where the processor does it.
    fn paint(&mut self, frame: &Frame) {
        let Some((shown, factor)) = self.shown else { return };
        let bytes = match shown {
            Shown::SweptFront | Shown::SweptBack => {
                let back = usize::from(shown == Shown::SweptBack);
                let (codes, source) = match &self.bending {
                    Some(bending) => bending.sweeps[back].codes(),
                    None => self.swept[back].codes(),
                };
                picture_of_codes(&self.look(frame, source, factor, 0.0), codes, self.window)
            }
            Shown::SoftSums => {
                let look = self.look(frame, self.window, 1.0, self.weighed.software_gain());
                picture_of_density(&look, self.weighed.sums(), self.window)
            }
            Shown::Front | Shown::Back | Shown::Sums => return,
        };
        let target = self.fit(shown, 1.0);
        target.write(&self.gpu, &bytes);
        self.painted = Some(target);
    }

    /// The target that is shown, and the look to show it with.
    fn picture(&self, frame: &Frame, premultiply: bool) -> Option<(&Target, Look)> {
        let (shown, factor) = self.shown?;
        let target = match shown {
            Shown::Front => &self.front,
            Shown::Back => &self.back,
            Shown::Sums => &self.sums,
            Shown::SweptFront | Shown::SweptBack | Shown::SoftSums => &self.painted,
        };
        let target = target.as_ref()?;
        let look = self.look(frame, target.window, factor, self.weighed.gain());
        Some((target, Look { premultiply: if premultiply { 1.0 } else { 0.0 }, ..look }))
    }

    /// Puts the picture on the canvas.
    fn present(&mut self, frame: &Frame) {
        let Some((target, look)) = self.picture(frame, true) else { return };
        let Some(canvas) = self.gpu.frame() else { return };
        let view = canvas.texture.create_view(&wgpu::TextureViewDescriptor::default());
        self.gpu.queue.write_buffer(&self.look, 0, bytemuck::bytes_of(&look));
        let pipeline = self.pipelines.show(target.kind);
        let encoder = target.resolve(&self.gpu, &self.pipelines, &self.look, pipeline, &view);
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.queue.present(canvas);
        self.stale = false;
    }

    /// Begins to read the picture that is shown, or `None` if there is none.
    #[must_use]
    pub fn read(&self) -> Option<ReadBack> {
        let frame = self.frame.as_ref().filter(|_| !self.gpu.is_lost() && self.window.area() > 0)?;
        if let Some(sheeted) = &self.sheeted {
            return self.read_sheet(sheeted);
        }
        let (target, look) = self.picture(frame, false)?;
        let texture = ReadBack::texture(&self.gpu, self.window);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        self.gpu.queue.write_buffer(&self.straight_look, 0, bytemuck::bytes_of(&look));
        let pipeline = self.pipelines.read(target.kind);
        let encoder = target.resolve(&self.gpu, &self.pipelines, &self.straight_look, pipeline, &view);
        Some(ReadBack::begin(&self.gpu, encoder, &texture, self.window))
    }
}
