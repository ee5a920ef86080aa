//! The pipelines of the plane.

use super::interface::{Card, Pipeline};
use super::shaders::{POINTS, RESOLVE};
use super::words::{Attribute, Blend, Each, Format, Layout, OnTop, Recipe, Slot};

/// What pixels of a target hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The code of the topmost piece.
    Codes,
    /// Sums of weights.
    Density,
    /// Colours, made on the processor.
    Picture,
}

impl Kind {
    pub const fn format(self) -> Format {
        match self {
            Self::Codes => Format::Word,
            Self::Density => Format::Sums,
            Self::Picture => Format::Colours,
        }
    }

    /// The binding of a target's texture where it is shown.
    pub const fn texture_binding(self) -> u32 {
        match self {
            Self::Codes => 2,
            Self::Density => 3,
            Self::Picture => 4,
        }
    }
}

/// Everything that is the same for all pictures.
#[derive(Debug)]
pub(super) struct Pipelines {
    /// Draw points into a target.
    points: [Pipeline; 2],
    /// Show a target.
    shows: [Pipeline; 3],
}

/// [`crate::Vertex`] and [`crate::Instance`].
const BUFFERS: [Layout; 2] = [
    (Each::Vertex, &[Attribute::Floats(2), Attribute::Word, Attribute::Floats(1)]),
    (
        Each::Instance,
        &[
            Attribute::Floats(4),
            Attribute::Floats(2),
            Attribute::Word,
            Attribute::Floats(1),
            Attribute::Floats(2),
            Attribute::Word,
        ],
    ),
];

impl Pipelines {
    pub fn new(card: &Card) -> Self {
        Self {
            points: [Kind::Codes, Kind::Density].map(|kind| draw(card, kind)),
            shows: [Kind::Codes, Kind::Density, Kind::Picture].map(|kind| show(card, kind)),
        }
    }

    /// Nothing is drawn into pictures.
    pub fn points(&self, kind: Kind) -> Option<&Pipeline> {
        self.points.get(kind as usize)
    }

    pub fn show(&self, kind: Kind) -> &Pipeline {
        &self.shows[kind as usize]
    }
}

/// A pipeline that draws points.
fn draw(card: &Card, kind: Kind) -> Pipeline {
    let (vertex, fragment, on_top, blend) = match kind {
        // Later maps lie over earlier ones, in whatever order they are drawn.
        Kind::Codes => ("codes_vertex", "codes_fragment", Some(OnTop::Largest), None),
        Kind::Density | Kind::Picture => ("density_vertex", "density_fragment", None, Some(Blend::Add)),
    };
    let recipe = Recipe {
        shader: POINTS,
        vertex,
        fragment,
        slots: &[(0, Slot::Uniform), (1, Slot::Uniform)],
        buffers: &BUFFERS,
        points: true,
        on_top,
        blend,
        onto: &[kind.format()],
    };
    Pipeline::new(card, &recipe)
}

/// A pipeline that makes a picture of a target.
fn show(card: &Card, kind: Kind) -> Pipeline {
    let (fragment, slot) = match kind {
        Kind::Codes => ("codes_resolve", Slot::Words),
        Kind::Density => ("density_resolve", Slot::Pixels),
        Kind::Picture => ("picture_resolve", Slot::Pixels),
    };
    let slots = [(1, Slot::Uniform), (kind.texture_binding(), slot)];
    let recipe = Recipe::full_screen(RESOLVE, ["screen_vertex", fragment], &slots, &[Format::Canvas]);
    Pipeline::new(card, &recipe)
}
