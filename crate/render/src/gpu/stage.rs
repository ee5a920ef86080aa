//! Drawing an attractor, coarse at once and complete after some frames.

use frond_core::{Colouring, Hull, Ifs};
use frond_deform::Bend;
use glam::DVec2;

use super::device::Gpu;
use super::interface::{Buffer, ReadBack, Texture, Usage};
use super::passes::deformed::{DeformedPass, Make};
use super::passes::image::ImagePass;
use super::passes::plain::PlainPass;
use super::state::{Shown, StageState, Style, Work};
use super::target::{Paint, Target};
use super::words::Format;
use crate::picture::colour::Colours;
use crate::picture::resolve::{picture_of_codes, picture_of_density};
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::sheet::Photo;

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
/// Pictures are points, drawn by the graphics card. At rest the pixels that lie between them are found by a sweep on
/// the processor, and lit one by one, so that the picture is as complete as one that is all swept. Where an
/// attractor overlaps itself so much that points would be drawn without end, or where there is no card and each
/// point is dear, they are swept on the processor instead, which lights each pixel but once.
#[derive(Debug)]
pub struct Stage {
    state: StageState,
    frame: Option<Frame>,
    view: Option<View>,
    straight_colours: Buffer,
    plain: PlainPass,
    deformed: Option<DeformedPass>,
    image: Option<ImagePass>,
}

impl Stage {
    /// A stage on a device, with nothing on it.
    #[must_use]
    pub fn new(gpu: Gpu) -> Self {
        Self {
            frame: None,
            view: None,
            straight_colours: Buffer::new(&gpu.card, "straight colours", Usage::Uniform),
            plain: PlainPass::new(&gpu),
            deformed: None,
            image: None,
            state: StageState::new(gpu),
        }
    }

    /// The device.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.state.gpu
    }

    /// Sets the size of the canvas in device pixels. Edges are smoothed where `pixel_ratio` (device pixels
    /// for each CSS pixel) is below 2; beyond, pixels are too small to see.
    pub fn resize(&mut self, width: u32, height: u32, pixel_ratio: f64) {
        self.state.resize(width, height, pixel_ratio);
    }

    /// Sets what is drawn. A bend stays, so that one for the new maps must follow if there is any.
    pub fn set_ifs(&mut self, ifs: &Ifs) {
        let hull = Hull::of(ifs);
        self.frame = Some(Frame::within(ifs, &hull));
        self.plain.forget();
        if let Some(deformed) = &mut self.deformed {
            deformed.forget();
        }
        if let Some(image) = &mut self.image {
            image.set_maps(ifs.len());
        }
        self.state.work = Work::Anew;
    }

    /// Sets the part of the plane that is shown. Returns whether it is a view; if not, nothing changes.
    pub fn set_view(&mut self, view: View) -> bool {
        if !view.is_valid() {
            return false;
        }
        if self.view != Some(view) {
            self.view = Some(view);
            self.state.work = Work::Anew;
        }
        true
    }

    /// Sets how it looks.
    pub fn set_style(&mut self, style: Style) {
        let dense = |style: &Style| style.colouring == Colouring::Density;
        let carried = |style: &Style| style.colouring == Colouring::Grid;
        // Codes hold for all colours, sums for one palette, and colours for themselves.
        let other =
            dense(&style) != dense(&self.state.style) || carried(&style) != carried(&self.state.style);
        if other || (dense(&style) && style.palette != self.state.style.palette) {
            self.state.work = Work::Anew;
        }
        self.state.stale |= style != self.state.style;
        self.state.style = style;
    }

    /// Bends the attractor, or no longer. The bend must have been made for the same maps; what they become is set
    /// before.
    pub fn set_bend(&mut self, bend: Option<Bend>) {
        if let Some(image) = &mut self.image {
            image.forget();
        }
        let memory = self.deformed.take();
        if bend.is_none() && memory.is_none() {
            return;
        }
        if bend.is_some() != memory.is_some() {
            // What was swept is not at hand any more.
            self.state.shown =
                self.state.shown.filter(|(shown, _)| !matches!(shown, Shown::SweptFront | Shown::SweptBack));
        }
        self.deformed = bend.map(|bend| DeformedPass::new(bend, memory));
        self.state.work = Work::Anew;
    }

    /// What makes the bend that is drawn at rest, where that takes longer than a frame: the one that was set is drawn
    /// while things change. Both must have been made of the same mesh and the same maps.
    pub fn set_bend_at_rest(&mut self, make: Make) {
        if let Some(deformed) = &mut self.deformed {
            deformed.set_later(make);
        }
    }

    /// Moves the control points of the mesh of the bend: as many as it has, finite. This is cheap. Returns whether
    /// there is such a mesh; if not, nothing changes.
    pub fn move_mesh(&mut self, displacements: &[DVec2]) -> bool {
        let Some(deformed) = &mut self.deformed else { return false };
        let Some(moved) = deformed.move_mesh(displacements) else { return false };
        if moved && self.state.work != Work::Anew {
            self.state.work = Work::Moved;
        }
        true
    }

    /// Draws a photograph in place of the attractor, bent by the bend that is set; with `None` the attractor again. The
    /// maps that are set must be those of its sheet ([`crate::Sheet::maps`]) for the bend to fit.
    pub fn set_photo(&mut self, photo: Option<Photo>) {
        self.image = photo.map(|photo| {
            let maps = self.frame.as_ref().map_or(4, |frame| frame.maps.len());
            ImagePass::new(&self.state.gpu, photo, maps)
        });
        self.state.work = Work::Anew;
        self.state.shown = None;
    }

    /// Draws what is new, or goes on with the complete picture: about `budget` points.
    pub fn draw(&mut self, budget: u64) -> Drawn {
        let ready = self.state.window.area() > 0 && !self.state.gpu.is_lost() && self.view.is_some();
        let Some(frame) = self.frame.take() else {
            return Drawn { complete: false, settled: true, points: 0 };
        };
        if let Some(view) = self.view.filter(|_| ready) {
            let (state, budget) = (&mut self.state, budget.max(10_000));
            if let Some(image) = &mut self.image {
                let bend = self.deformed.as_ref().map(|deformed| (deformed.bend(), deformed.mesh()));
                image.draw(state, bend, view);
            } else {
                match &mut self.deformed {
                    Some(deformed) => deformed.advance(state, &frame, view, budget),
                    None => self.plain.advance(state, &frame, view, budget),
                }
                if self.state.stale {
                    self.paint(&frame);
                    self.present(&frame);
                }
            }
        }
        self.frame = Some(frame);
        let settled = !ready || (self.state.work == Work::Done && !self.state.stale);
        Drawn { complete: self.state.complete && settled && ready, settled, points: self.state.points }
    }

    /// What a picture is coloured with, tinted where the bend carries colours.
    fn colours(&self, frame: &Frame, source: Window, factor: f64, gain: f32) -> Colours {
        let tinted = self.deformed.as_ref().is_some_and(|deformed| deformed.coloured(&self.state, frame));
        self.state.colours(frame, tinted, source, factor, gain)
    }

    /// Makes the picture that is shown, where the processor does it.
    fn paint(&mut self, frame: &Frame) {
        let Some((shown, factor)) = self.state.shown else { return };
        let bytes = match shown {
            Shown::SweptFront | Shown::SweptBack => {
                let back = usize::from(shown == Shown::SweptBack);
                let (codes, source) = match &self.deformed {
                    Some(deformed) => deformed.sweeps[back].codes(),
                    None => self.plain.codes(back),
                };
                picture_of_codes(&self.colours(frame, source, factor, 0.0), codes, self.state.window)
            }
            Shown::SoftSums => {
                let colours = self.colours(frame, self.state.window, 1.0, self.state.density.software_gain());
                picture_of_density(&colours, self.state.density.sums())
            }
            Shown::Front | Shown::Back | Shown::Sums => return,
        };
        let target = self.state.fit(shown, 1.0);
        target.write(&self.state.gpu, &bytes);
        self.state.painted = Some(target);
    }

    /// The target that is shown, and the colours to show it with.
    fn picture(&self, frame: &Frame, premultiply: bool) -> Option<(&Target, Colours)> {
        let (shown, factor) = self.state.shown?;
        let target = match shown {
            Shown::Front => &self.state.front,
            Shown::Back => &self.state.back,
            Shown::Sums => &self.state.sums,
            Shown::SweptFront | Shown::SweptBack | Shown::SoftSums => &self.state.painted,
        };
        let target = target.as_ref()?;
        let colours = self.colours(frame, target.window, factor, self.state.density.gain());
        Some((target, Colours { premultiply: if premultiply { 1.0 } else { 0.0 }, ..colours }))
    }

    /// Puts the picture on the canvas.
    fn present(&mut self, frame: &Frame) {
        let Some((target, colours)) = self.picture(frame, true) else { return };
        let Some(canvas) = self.state.gpu.frame() else { return };
        self.state.colours.set(&self.state.gpu.card, &[colours]);
        target.resolve(&self.state.gpu, self.state.paint(), &canvas.texture);
        self.state.gpu.present(canvas);
        self.state.stale = false;
    }

    /// Begins to read the codes of the picture that is shown, four bytes each, or `None` if it has none.
    #[must_use]
    pub fn read_codes(&self) -> Option<ReadBack> {
        let target = match self.state.shown?.0 {
            Shown::Front => &self.state.front,
            Shown::Back => &self.state.back,
            _ => &None,
        };
        Some(target.as_ref()?.read(&self.state.gpu))
    }

    /// Draws points as vertices, as WebGL2 does, whatever the card computes.
    #[cfg(all(feature = "webgpu", not(target_arch = "wasm32")))]
    pub fn draw_vertices(&mut self) {
        self.plain.splats = None;
        self.state.work = Work::Anew;
    }

    /// Draws the points of the picture that is shown so many times more: what a card does with nothing in its way.
    /// Returns how many there are.
    #[cfg(all(feature = "webgpu", not(target_arch = "wasm32")))]
    pub fn draw_again(&mut self, times: u64) -> u64 {
        let StageState { shown, front, back, points_pass, gpu, pipelines, colours, .. } = &mut self.state;
        let Some(target) = (match shown {
            Some((Shown::Front, _)) => front.as_ref(),
            Some((Shown::Back, _)) => back.as_ref(),
            _ => None,
        }) else {
            return 0;
        };
        (0..times)
            .map(|_| self.plain.draw_again(points_pass, gpu, Paint { pipelines, colours }, target))
            .sum()
    }

    /// Begins to read the picture that is shown, or `None` if there is none.
    #[must_use]
    pub fn read(&self) -> Option<ReadBack> {
        let frame =
            self.frame.as_ref().filter(|_| !self.state.gpu.is_lost() && self.state.window.area() > 0)?;
        if let Some(image) = &self.image {
            return image.read(&self.state);
        }
        let (target, colours) = self.picture(frame, false)?;
        let gpu = &self.state.gpu;
        let texture = Texture::new(&gpu.card, "read", self.state.window, Format::Colours);
        self.straight_colours.set(&gpu.card, &[colours]);
        target.resolve(gpu, Paint { colours: &self.straight_colours, ..self.state.paint() }, &texture);
        Some(gpu.read(&texture))
    }
}
