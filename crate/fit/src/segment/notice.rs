//! What is said of a picture that may not give what was hoped for.

use thiserror::Error;

use crate::outline::MAX_OUTLINE;

/// What surrounds a picture and is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surround {
    /// A frame of one colour.
    Frame,
    /// A strip along a side or two.
    Strip,
    /// All around a round field, as of a microscope.
    Round,
    /// The clear margin or corners of a card.
    Clear,
}

/// Something that may be amiss with a mask or an outline, though there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Notice {
    /// The piece is cut by the border of the picture.
    TouchesBorder,
    /// There are so many pieces of like size.
    Several(usize),
    /// Nothing stands out.
    Blank,
    /// Nothing stands out, and all of it is dark.
    AllBlack,
    /// It is speckled, and no shape was found in it.
    Noise,
    /// The outline had so many points: fewer were kept.
    Thinned(usize),
    /// The piece has so many holes, which the outline leaves out.
    Holes(usize),
    /// What surrounds the picture is left out.
    Surrounded(Surround),
}

impl Notice {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::TouchesBorder => "touches-border",
            Self::Several(_) => "several",
            Self::Blank => "blank",
            Self::AllBlack => "all-black",
            Self::Noise => "noise",
            Self::Thinned(_) => "thinned",
            Self::Holes(_) => "holes",
            Self::Surrounded(_) => "surrounded",
        }
    }

    /// What it is and what to try, in a sentence or two.
    #[must_use]
    pub fn message(self) -> String {
        match self {
            Self::TouchesBorder => {
                "The shape is cut by the border of the picture, so that a part of its outline is \
                the border. Take a picture with room all round, or paint away what is not the leaf."
                    .into()
            }
            Self::Several(count) => format!(
                "There are {count} shapes of like size. The largest is taken: pick another, or paint away what joins \
                 or surrounds them."
            ),
            Self::Blank => {
                "Nothing stands out from the ground: the picture is of one colour. Move the threshold, \
                paint the shape in, or take a picture on a ground of another colour."
                    .into()
            }
            Self::AllBlack => {
                "The picture is dark all over. Take it in more light, move the threshold, or paint the \
                shape in."
                    .into()
            }
            Self::Noise => {
                "The picture is speckled, and no shape stands out from it. Take one with a plain ground, \
                move the threshold, or paint the shape in."
                    .into()
            }
            Self::Thinned(count) => {
                format!("The outline had {count} points; {MAX_OUTLINE} of them are kept.")
            }
            Self::Holes(1) => {
                "The leaf has a hole, which is filled: an outline is one line around it. Where it is no hole but a gap \
                 at the rim, a stroke that says “not leaf” opens it to the outside."
                    .into()
            }
            Self::Holes(count) => format!(
                "The leaf has {count} holes, which are filled: an outline is one line around it. Where one is no hole \
                 but a gap at the rim, a stroke that says “not leaf” opens it to the outside."
            ),
            Self::Surrounded(Surround::Frame) => {
                "A frame around the picture is left out, and the leaf is looked for inside it. Where the frame is part \
                of the shape, draw a stroke on it that says “leaf”."
                    .into()
            }
            Self::Surrounded(Surround::Strip) => {
                "A strip along the border of the picture is left out, and the leaf is looked for beside it. Where the \
                strip is part of the shape, draw a stroke on it that says “leaf”."
                    .into()
            }
            Self::Surrounded(Surround::Round) => {
                "What surrounds the round field of the picture is left out, and the leaf is looked for inside it. Where \
                the field is the shape, draw a stroke beside it that says “leaf”."
                    .into()
            }
            Self::Surrounded(Surround::Clear) => {
                "The clear margin of the picture is left out, and the leaf is looked for on the card inside it. Where \
                the card is the shape, draw a stroke on the margin that says “leaf”."
                    .into()
            }
        }
    }
}

/// Why a picture cannot be traced.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum TraceError {
    /// A side of no pixels.
    #[error("The picture has no pixels. Choose another.")]
    NoPixels,
    /// More than 4 megapixels.
    #[error(
        "The picture has {width} x {height} pixels, and at most 4194304 are worked on. Make it smaller first."
    )]
    TooLarge {
        /// Pixels across.
        width: usize,
        /// Pixels down.
        height: usize,
    },
    /// Not four bytes a pixel.
    #[error(
        "There are {bytes} bytes for {width} x {height} pixels, and each needs four: red, green, blue and alpha."
    )]
    WrongLength {
        /// Pixels across.
        width: usize,
        /// Pixels down.
        height: usize,
        /// What was given.
        bytes: usize,
    },
    /// The mask has no such piece.
    #[error("{}", no_piece(*.count))]
    NoPiece {
        /// How many there are.
        count: usize,
    },
    /// The piece is so small or thin that no line goes round it.
    #[error("This piece is too small to have an outline. Pick another, or take a larger picture.")]
    TooSmall,
}

fn no_piece(count: usize) -> String {
    match count {
        0 => "The mask is empty, so there is nothing to outline. Move the threshold, or paint the shape in."
            .into(),
        1 => "The mask has one piece only. Pick that.".into(),
        count => {
            format!("The mask has {count} pieces and not so many as the one asked for. Pick one of these.")
        }
    }
}

impl TraceError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoPixels => "no-pixels",
            Self::TooLarge { .. } => "too-large",
            Self::WrongLength { .. } => "bad-input",
            Self::NoPiece { .. } => "no-piece",
            Self::TooSmall => "too-small",
        }
    }
}
