//! Which device there is and what it can do: the one place that asks.

use std::rc::Rc;

use thiserror::Error;

use super::canvas::Canvas;
use super::events::{Event, Events, Loss};
use super::interface::{Card, Chain, Frame, ReadBack, Texture};
use super::is_software;

/// Which interface to the graphics card is wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// The one that this is compiled for.
    #[default]
    Auto,
    /// WebGPU only.
    WebGpu,
    /// WebGL2 only.
    WebGl2,
}

/// Why there is no device.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum GpuError {
    /// Neither interface is there, or not the one that was asked for.
    #[error(
        "The browser offers no {wanted} for drawing ({detail}). Switch on hardware acceleration, or use \
         another browser."
    )]
    NoBackend {
        /// What was looked for.
        wanted: &'static str,
        /// What the browser said.
        detail: String,
    },
}

impl GpuError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoBackend { .. } => "no-gpu",
        }
    }
}

/// A device and the canvas that it draws on.
#[derive(Debug)]
pub struct Gpu {
    pub(super) card: Card,
    chain: Chain,
    configured: bool,
    events: Events,
    /// `"webgpu"` or `"webgl2"`.
    pub backend: &'static str,
    /// The name of the graphics card, as far as the browser tells.
    pub description: String,
    /// Whether there is no graphics card, and the processor does its work: then points are dear.
    pub software: bool,
    /// The longest side of what can be drawn to.
    pub max_side: u32,
    /// Whether it can add up weights. Almost every device can; on others there are no densities, and colours are by
    /// map.
    pub(super) densities: bool,
}

impl Gpu {
    /// Opens a device for a canvas, and tells `listener` what happens to it.
    ///
    /// # Errors
    /// [`GpuError::NoBackend`].
    pub async fn open(
        canvas: &Canvas,
        wanted: Wanted,
        listener: Rc<dyn Fn(&Event)>,
    ) -> Result<Self, GpuError> {
        let (name, is_other) = match wanted {
            Wanted::Auto => ("WebGPU or WebGL2", false),
            Wanted::WebGpu => ("WebGPU", Card::BACKEND != "webgpu"),
            Wanted::WebGl2 => ("WebGL2", Card::BACKEND != "webgl2"),
        };
        let refused = |detail: String| GpuError::NoBackend { wanted: name, detail };
        if is_other {
            return Err(refused("not present".into()));
        }
        let events = Events::new(listener);
        let (card, chain) = Chain::open(canvas, events.loss()).await.map_err(refused)?;
        Ok(Self {
            backend: Card::BACKEND,
            software: is_software(card.software, &card.description),
            description: card.description.clone(),
            max_side: card.max_side,
            densities: card.densities,
            configured: false,
            card,
            chain,
            events,
        })
    }

    /// Sets the size of the canvas, in pixels.
    pub(super) fn resize(&mut self, width: u32, height: u32) {
        self.configured = width > 0 && height > 0 && !self.is_lost();
        if self.configured {
            self.chain.resize(&self.card, width, height);
        }
    }

    /// What is shown next, if the canvas can be had now.
    pub(super) fn frame(&self) -> Option<Frame> {
        if self.configured && !self.is_lost() { self.chain.next(&self.card) } else { None }
    }

    /// Shows it.
    pub(super) fn present(&self, frame: Frame) {
        self.chain.present(&self.card, frame);
    }

    /// Begins to read a texture of colours.
    pub(super) fn read(&self, texture: &Texture) -> ReadBack {
        ReadBack::begin(&self.card, texture, self.loss())
    }

    /// Waits until all is drawn that was asked for.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn finish(&self) {
        self.card.finish();
    }

    /// Whether the device is lost, so that no call has an effect any more.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.events.is_lost()
    }

    /// A way to tell that the device is lost.
    #[must_use]
    pub fn loss(&self) -> Loss {
        self.events.loss()
    }

    /// Destroys the device, as if it had been lost.
    pub fn destroy(&self) {
        if !self.is_lost() {
            self.card.destroy();
            self.loss().tell("it was destroyed");
        }
    }
}
