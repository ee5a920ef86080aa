//! The pipelines of space.

use crate::gpu::interface::{Card, Pipeline};
use crate::gpu::shaders::{SPACE_LIGHT, SPACE_POINTS, SPACE_SPLAT};
use crate::gpu::words::{Attribute, Each, Format, Layout, OnTop, Recipe, Slot};

/// Everything that is the same for all pictures of space.
#[derive(Debug)]
pub(super) struct Pipelines3 {
    pub points: Pipeline,
    pub splat: Pipeline,
    pub fill_holes: Pipeline,
    /// Lights what is there into a picture.
    pub show: Pipeline,
}

/// [`crate::solid::Vertex3`] and [`crate::solid::Instance3`].
const BUFFERS: [Layout; 2] = [
    (Each::Vertex, &[Attribute::Floats(3), Attribute::Word]),
    (
        Each::Instance,
        &[Attribute::Floats(4), Attribute::Floats(4), Attribute::Floats(4), Attribute::Word, Attribute::Word],
    ),
];

/// Codes, and the bits of depths.
const KEPT: [Format; 2] = [Format::Word; 2];

/// Lamp, colours, codes and depths; what splats them has its steps in the lamp's place.
const SLOTS: [(u32, Slot); 4] = [(0, Slot::Uniform), (1, Slot::Uniform), (2, Slot::Words), (3, Slot::Words)];

impl Pipelines3 {
    pub fn new(card: &Card) -> Self {
        let points = Recipe {
            shader: SPACE_POINTS,
            vertex: "points_vertex",
            fragment: "points_fragment",
            slots: &[(0, Slot::Uniform)],
            buffers: &BUFFERS,
            points: true,
            on_top: Some(OnTop::Smallest),
            blend: None,
            onto: &KEPT,
        };
        let on_screen = |shader, fragment, onto: &[Format]| {
            Pipeline::new(card, &Recipe::full_screen(shader, ["screen_vertex", fragment], &SLOTS, onto))
        };
        Self {
            points: Pipeline::new(card, &points),
            splat: on_screen(SPACE_SPLAT, "splat_fragment", &KEPT),
            fill_holes: on_screen(SPACE_LIGHT, "hole_fill_fragment", &KEPT),
            show: on_screen(SPACE_LIGHT, "light_fragment", &[Format::Canvas]),
        }
    }
}
