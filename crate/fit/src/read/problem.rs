//! Why a file gives no outlines, and what is said of one that does.

use thiserror::Error;

/// Why a file gives neither outlines nor a series.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ReadError {
    /// No bytes, or blanks only.
    #[error("The file is empty. Choose another.")]
    Empty,
    /// More than 64 MiB.
    #[error(
        "The file has {megabytes} megabytes of text, and at most 64 are read. Leave out every second point, or more."
    )]
    TooLarge {
        /// Its size.
        megabytes: usize,
    },
    /// A picture made of pixels: it is to be traced, not read.
    #[error("This is a {format} picture, whatever its name says. Open it as a picture.")]
    Picture {
        /// Its format.
        format: &'static str,
    },
    /// Neither a picture nor a text that is known here.
    #[error("{}", unknown(*.what))]
    Unknown {
        /// What it seems to be.
        what: Option<&'static str>,
    },
    /// The XML or JSON is broken.
    #[error("The {format} breaks off or is miswritten: {why}. Save it again from the program that made it.")]
    Broken {
        /// SVG or JSON.
        format: &'static str,
        /// What and where.
        why: String,
    },
    /// The drawing has entities that hold each other and grow without end.
    #[error("The drawing has entities (<!ENTITY>) that grow without end. Save it again as plain SVG.")]
    Entities,
    /// A drawing, where the feature `svg` is left out.
    #[error("This is a drawing (SVG), and this build reads none: the feature “svg” is left out.")]
    Drawing,
    /// The drawing has more than is looked at.
    #[error("The drawing has too many {what}: at most {most} are looked at. Leave only the outline in it.")]
    TooMany {
        /// What there is too much of, once all that is used more than once is counted as often.
        what: &'static str,
        /// How many of them are looked at.
        most: usize,
    },
    /// Nothing in it has an outline.
    #[error("{}", nothing(.format))]
    Nothing {
        /// What it is.
        format: &'static str,
    },
    /// The text has no numbers where they are looked for.
    #[error(
        "This is a text, and line {line} holds no numbers that could be read: “{text}”. A table has one or two numbers a line, and may have a heading."
    )]
    NoNumbers {
        /// The line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// Too few points.
    #[error("There are {count} points, and {}. Give more.", needs(*.series))]
    TooFew {
        /// How many there are.
        count: usize,
        /// Whether it was read as a series.
        series: bool,
    },
    /// The points enclose no area.
    #[error("The points enclose no area: they lie on a straight line, or go there and back.")]
    Flat,
    /// One column cannot be an outline.
    #[error(
        "There is one number a line, and an outline needs two, x and y. Read it as a series, or add a column."
    )]
    OneColumn,
}

/// What to do with a file of another kind.
fn advice(what: &str) -> &'static str {
    match what {
        "HEIC picture" => "Save it as JPEG and open that: on a phone, share it as “Most compatible”.",
        "PDF" | "PostScript file" => {
            "Save a drawing in it as SVG, a photograph as JPEG, and a table as CSV, and open that."
        }
        "Photoshop picture" => "Save it as PNG or JPEG and open that.",
        "shapefile" | "database" | "map (KMZ)" => "Save its layer as GeoJSON and open that.",
        "film" => "Save one picture of it as JPEG and open that.",
        _ if what.ends_with("picture") => "Save it as JPEG or PNG and open that.",
        _ if what.starts_with("spreadsheet") => "Save its sheet as CSV and open that.",
        _ if what.starts_with("document") || what.starts_with("text") => {
            "Save a table in it as plain text or CSV, and a picture as JPEG, and open that."
        }
        _ if what.starts_with("presentation") => "Save its picture as SVG or JPEG and open that.",
        _ if what.contains("archive") || what.starts_with("packed") => "Unpack it and open what is in it.",
        _ => "",
    }
}

fn unknown(what: Option<&str>) -> String {
    let (is, advice) = what.map_or_else(
        || ("neither a picture nor a text".into(), ""),
        |what| (format!("a {what}"), advice(what)),
    );
    let gap = if advice.is_empty() { "" } else { " " };
    format!(
        "This is {is}.{gap}{advice} What can be read: pictures (PNG, JPEG, WebP), drawings (SVG), tables of numbers \
         (CSV) and GeoJSON."
    )
}

fn nothing(format: &str) -> String {
    match format {
        "SVG" => "The drawing has no shape with an outline: texts, pictures and what stands elsewhere are not read. \
            Turn texts into paths, and trace pictures, before it is saved."
            .into(),
        "maps" => "The JSON has no outline, but rows of numbers as maps have them: open it in Morph.".into(),
        "masks" => "The file has masks of pixels and no polygons. Export polygons from the program that made it, or \
            save a mask as PNG and open that."
            .into(),
        "boxes" => "The file has boxes, circles or points and no polygons. Draw a polygon in the program that made it."
            .into(),
        _ => "The JSON has no outline: GeoJSON and TopoJSON with a Polygon, a MultiPolygon or a LineString are read, \
            and polygons of COCO, LabelMe, VIA and Label Studio."
            .into(),
    }
}

fn needs(series: bool) -> &'static str {
    if series { "a series needs three or more" } else { "an outline needs three or more" }
}

impl ReadError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::TooLarge { .. } => "too-large",
            Self::Picture { .. } => "picture",
            Self::Unknown { .. } => "unknown-file",
            Self::Broken { .. } => "broken",
            Self::Entities => "entities",
            Self::Drawing => "drawing",
            Self::TooMany { .. } => "too-many",
            Self::Nothing { .. } => "nothing",
            Self::NoNumbers { .. } => "no-numbers",
            Self::TooFew { .. } => "too-few-points",
            Self::Flat => "flat",
            Self::OneColumn => "one-column",
        }
    }
}

/// What is to be said of a file that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// A name that does not change, for programs: `crossing`, `thinned`, `gaps`, `closed`, `ignored`, `assumed`,
    /// `several`.
    pub code: &'static str,
    /// A sentence or two that say what to try.
    pub message: String,
}

impl Remark {
    pub(super) fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into() }
    }
}

/// What was met in a drawing and is not an outline, each once, as the reader is told of it.
#[cfg(feature = "svg")]
#[derive(Default)]
pub struct LeftOut(Vec<&'static str>);

#[cfg(feature = "svg")]
impl LeftOut {
    pub fn add(&mut self, what: &'static str) {
        if !self.0.contains(&what) {
            self.0.push(what);
        }
    }

    pub fn remark(&self) -> Option<Remark> {
        let message = || format!("Not looked at: {}.", self.0.join(", "));
        (!self.0.is_empty()).then(|| Remark::new("ignored", message()))
    }
}
