//! Why a certificate is no proof.

use thiserror::Error;

/// Why a certificate is refused. Maps, corners and pairs are counted from 1 in messages, from 0 in fields.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum Refused {
    /// It is too large to be checked in reasonable time. Work with its numbers is counted in multiplications of machine
    /// words ("digits to multiply").
    #[error("The certificate has too many {what}: the most that are checked is {most}.")]
    TooLarge {
        /// What there are too many of.
        what: &'static str,
        /// How many are allowed.
        most: u64,
    },
    /// A number is NaN or infinite.
    #[error("The certificate holds a number that is not finite among its {place}.")]
    NotFinite {
        /// The list it is in.
        place: &'static str,
    },
    /// Something that must be there is missing or of the wrong form.
    #[error("The certificate is not of the right form: {why}.")]
    Form {
        /// What is wrong.
        why: &'static str,
    },
    /// The polygon is not strictly convex, or not counter-clockwise, or without an inside.
    #[error(
        "The polygon is not strictly convex and counter-clockwise: corner {} is not to the left of edge {}.", .corner + 1, .edge + 1
    )]
    Polygon {
        /// The edge that begins at this corner ..
        edge: usize,
        /// .. does not have this corner on its left.
        corner: usize,
    },
    /// A word maps the polygon to somewhere not inside it.
    #[error("The polygon is not mapped into its inside by the word {}.", crate::refused::shown(.word))]
    NotInside {
        /// The word, letters from 0.
        word: Vec<u8>,
    },
    /// The maps are not parted in two.
    #[error("The cut does not part the maps in two: {why}.")]
    Cut {
        /// What is wrong.
        why: &'static str,
    },
    /// A word is empty, holds a letter that is no map, or begins on the wrong side.
    #[error("Pair {} does not go across the cut.", .pair + 1)]
    Stray {
        /// Index of the pair.
        pair: usize,
    },
    /// Some pieces are not shown to be apart by any of the pairs.
    #[error(
        "The pairs do not cover all: the pieces {} and {} are not shown to be apart.", crate::refused::shown(.u), crate::refused::shown(.v)
    )]
    Uncovered {
        /// One word.
        u: Vec<u8>,
        /// The other.
        v: Vec<u8>,
    },
    /// The direction of a pair does not separate its pieces.
    #[error(
        "Pair {} is not apart: its direction does not separate the pieces {} and {}.", .pair + 1, crate::refused::shown(.u), crate::refused::shown(.v)
    )]
    NotApart {
        /// Index of the pair.
        pair: usize,
        /// Its first word.
        u: Vec<u8>,
        /// Its second word.
        v: Vec<u8>,
    },
    /// That no gap is wider than it says is not shown.
    #[error("A gap may be wider: {why}.")]
    Gap {
        /// What is wrong.
        why: &'static str,
    },
    /// A link does not hold two pieces together.
    #[error("Link {} does not hold: {why}.", .link + 1)]
    Link {
        /// Index of the link.
        link: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// The squares are not shown to hold differences only.
    #[error(
        "The squares are not shown to hold nothing but differences: one does not lead back into them, or the maps do not \
         share one linear part that has an inverse."
    )]
    Squares,
    /// The number that others are given by is not shown to be one.
    #[error(
        "The exact numbers are not given by one root: the polynomial does not change its sign between the ends of \
         the interval, or its derivative, computed for the whole interval at once, may be 0 there."
    )]
    Root,
    /// An exact number is not shown to be the one that its double stands for.
    #[error(
        "Number {} of map {} is not within a unit in the last place of its double.", .entry + 1, .map + 1
    )]
    Entry {
        /// Index of a map.
        map: usize,
        /// Index in its row.
        entry: usize,
    },
    /// Some maps are not reached.
    #[error("The links do not reach all pieces: none leads from the first to piece {}.", .map + 1)]
    Unreached {
        /// Index of a map.
        map: usize,
    },
}

impl Refused {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooLarge { .. } => "too-large",
            Self::NotFinite { .. } => "not-finite",
            Self::Form { .. } => "form",
            Self::Polygon { .. } => "polygon",
            Self::NotInside { .. } => "not-inside",
            Self::Cut { .. } => "cut",
            Self::Stray { .. } => "stray",
            Self::Uncovered { .. } => "uncovered",
            Self::NotApart { .. } => "not-apart",
            Self::Gap { .. } => "gap",
            Self::Link { .. } => "link",
            Self::Squares => "squares",
            Self::Root => "root",
            Self::Entry { .. } => "entry",
            Self::Unreached { .. } => "unreached",
        }
    }
}

/// A word as people read it: letters from 1, joined by dots, the middle of long ones left out.
pub(crate) fn shown(word: &[u8]) -> String {
    const ENDS: usize = 12;
    let letters =
        |part: &[u8]| part.iter().map(|i| (usize::from(*i) + 1).to_string()).collect::<Vec<_>>().join(".");
    if word.is_empty() {
        "(empty)".to_owned()
    } else if word.len() <= 2 * ENDS {
        letters(word)
    } else {
        format!("{} .. {}", letters(&word[..ENDS]), letters(&word[word.len() - ENDS..]))
    }
}
