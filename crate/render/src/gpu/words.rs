//! What buffers, textures and pipelines are, in words that both interfaces understand.

use super::shaders::Shader;

/// What a texture holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    /// A whole number: a code, or the bits of a depth.
    Word,
    /// Sums of weights, of as many bits as the device can add to.
    Sums,
    /// Colours of eight bits.
    Colours,
    /// The same, as the canvas wants it; what is drawn there can be drawn into [`Format::Colours`], too.
    Canvas,
    /// What decides which piece is on top.
    Depth,
}

/// A number or a few of a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) enum Attribute {
    /// So many single floats, 1 to 4.
    Floats(u8),
    /// A whole number.
    Word,
}

impl Attribute {
    /// Bytes that it takes.
    pub const fn size(self) -> u32 {
        match self {
            Self::Floats(count) => 4 * count as u32,
            Self::Word => 4,
        }
    }
}

/// Whose numbers a buffer holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Each {
    Vertex,
    Instance,
}

/// What a buffer holds for each vertex or instance, without gaps. Locations count on from buffer to buffer.
pub(super) type Layout = (Each, &'static [Attribute]);

/// Bytes of an item of such a buffer.
pub(super) fn stride((_, attributes): Layout) -> u32 {
    attributes.iter().map(|attribute| attribute.size()).sum()
}

/// What a shader has at a binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    /// Numbers that are the same for all of a pass.
    Uniform,
    /// A texture of [`Format::Word`].
    Words,
    /// A texture of colours or sums, read pixel by pixel.
    Pixels,
    /// A photograph with its halvings, read between pixels; what reads it has the next binding.
    Photo,
}

/// How what is drawn meets what is there, where it does not replace it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Blend {
    /// It is added.
    Add,
    /// It is laid under it.
    Under,
}

/// Which of two points is on top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OnTop {
    /// The one with the larger depth, and of equal ones the later. Depths hold for the next passes, too.
    Largest,
    /// The one with the smaller depth. Depths are of no use after the pass.
    Smallest,
}

impl OnTop {
    /// The depth of nothing.
    pub const fn nothing(self) -> f32 {
        match self {
            Self::Largest => 0.0,
            Self::Smallest => 1.0,
        }
    }
}

/// What a pipeline is made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recipe<'a> {
    pub shader: Shader,
    pub vertex: &'static str,
    pub fragment: &'static str,
    #[cfg_attr(not(feature = "webgpu"), expect(dead_code, reason = "WebGL2 learns it from what is bound"))]
    pub slots: &'a [(u32, Slot)],
    /// Empty for what covers the whole target with one triangle.
    pub buffers: &'a [Layout],
    /// Whether vertices are points; triangles if not.
    pub points: bool,
    pub on_top: Option<OnTop>,
    pub blend: Option<Blend>,
    #[cfg_attr(not(feature = "webgpu"), expect(dead_code, reason = "WebGL2 learns it from the pass"))]
    pub onto: &'a [Format],
}

impl<'a> Recipe<'a> {
    /// What goes over a whole picture.
    pub const fn full_screen(
        shader: Shader,
        [vertex, fragment]: [&'static str; 2],
        slots: &'a [(u32, Slot)],
        onto: &'a [Format],
    ) -> Self {
        Self { shader, vertex, fragment, slots, buffers: &[], points: false, on_top: None, blend: None, onto }
    }
}
