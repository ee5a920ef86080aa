//! From a text file to outlines or a series: drawings, tables and GeoJSON.

mod geo;
mod problem;
mod sniff;
mod svg;
mod table;
mod text;

pub use problem::{ReadError, Remark};
pub use sniff::{FileKind, sniff};

use glam::DVec2;

use crate::outline::{Outline, crossings};
use crate::trace::{MAX_OUTLINE, thinned};

/// The most bytes of a text.
const MAX_BYTES: usize = 64 << 20;
/// The most outlines that are listed.
const MAX_LISTED: usize = 100;
/// The most crossings that are counted.
const MAX_CROSSINGS: usize = 100;
/// An outline that can be fitted has as many points at least, a series one fewer.
const LEAST: usize = 4;

/// What a table is to be taken for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ReadAs {
    /// A series if its first column grows or falls all the way, or is the only one; an outline otherwise.
    #[default]
    Guess,
    /// Outlines.
    Outlines,
    /// A series: it is sorted by its first column.
    Series,
}

/// An outline in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedOutline {
    /// As the file calls it, or what it was there.
    pub name: String,
    /// With y up; at most [`MAX_OUTLINE`] points.
    pub outline: Outline,
    /// How often it crosses itself, up to 100; None where that was too much to find out.
    pub crossings: Option<usize>,
}

/// What was in a file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileContent {
    /// Outlines, the largest first; never none.
    Outlines {
        /// `svg`, `csv` or `geojson`.
        format: &'static str,
        /// At most 100.
        outlines: Vec<NamedOutline>,
        /// What is to be said of it.
        remarks: Vec<Remark>,
    },
    /// Values x of a function of t: three points (t, x) or more, t growing.
    Series {
        /// At most [`MAX_OUTLINE`].
        points: Vec<DVec2>,
        /// What is to be said of it.
        remarks: Vec<Remark>,
        /// Whether the same numbers make an outline, too.
        or_outline: bool,
    },
}

/// A polyline as it stands in a file.
struct Raw {
    name: String,
    points: Vec<DVec2>,
    closed: bool,
    /// Whether it is what others are drawn on.
    ground: bool,
}

/// Reads a text file: SVG, a table of numbers, or GeoJSON, whichever it is.
///
/// ```
/// use frond_fit::{FileContent, ReadAs, read_file};
///
/// let svg = b"<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0 H4 V3 H0 Z'/></svg>";
/// let FileContent::Outlines { outlines, .. } = read_file(svg, ReadAs::Guess)? else { return Ok(()) };
/// assert_eq!(outlines[0].outline.area(), 12.0);
/// # Ok::<(), frond_fit::ReadError>(())
/// ```
///
/// # Errors
/// Where the file is something else, too large, or has no outline and no numbers.
pub fn read_file(bytes: &[u8], read_as: ReadAs) -> Result<FileContent, ReadError> {
    let kind = sniff(bytes);
    match kind {
        FileKind::Empty => return Err(ReadError::Empty),
        FileKind::Picture(format) => return Err(ReadError::Picture { format }),
        FileKind::Other(what) => return Err(ReadError::Unknown { what }),
        FileKind::Svg | FileKind::Json | FileKind::Text => {}
    }
    if bytes.len() > MAX_BYTES {
        return Err(ReadError::TooLarge { megabytes: bytes.len() >> 20 });
    }
    let text = text::decode(bytes);
    match kind {
        FileKind::Svg => {
            let (raws, remarks) = svg::read_svg(&text)?;
            outlines("svg", raws, remarks)
        }
        FileKind::Json => outlines("geojson", geo::read_geo(&text)?, Vec::new()),
        _ => table_content(&text, read_as),
    }
}

fn table_content(text: &str, read_as: ReadAs) -> Result<FileContent, ReadError> {
    let table = table::read_table(text)?;
    let way = |sign: f64| table.points.windows(2).all(|pair| sign * (pair[1].x - pair[0].x) >= 0.0);
    let differ = table.points.windows(2).filter(|pair| pair[0].x != pair[1].x).count();
    let one_way = (way(1.0) || way(-1.0)) && 2 * differ >= table.points.len().saturating_sub(1) && differ > 1;
    let series = match read_as {
        ReadAs::Guess => !table.two || one_way,
        ReadAs::Outlines if !table.two => return Err(ReadError::OneColumn),
        ReadAs::Outlines => false,
        ReadAs::Series => true,
    };
    if !series {
        let closed = true;
        let raw = Raw { name: "table".into(), points: table.points, closed, ground: false };
        return outlines("csv", vec![raw], table.remarks);
    }
    let or_outline = table.two && table.points.len() >= LEAST;
    let (mut points, mut remarks) = (table.points, table.remarks);
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    let before = points.len();
    points.dedup_by(|later, earlier| later.x == earlier.x);
    if points.len() < before {
        let message =
            format!("At {} places there was more than one value: the first is kept.", before - points.len());
        remarks.push(Remark::new("gaps", message));
    }
    if points.len() + 1 < LEAST {
        return Err(ReadError::TooFew { count: points.len(), series: true });
    }
    let points = fewer(points, table.rows, &mut remarks);
    Ok(FileContent::Series { points, remarks, or_outline })
}

/// At most [`MAX_OUTLINE`] points of `all`, and word of it.
fn fewer(points: Vec<DVec2>, all: usize, remarks: &mut Vec<Remark>) -> Vec<DVec2> {
    if points.len() <= MAX_OUTLINE {
        return points;
    }
    let message = format!("There are {all} points, more than are needed: {MAX_OUTLINE} of them are kept.");
    remarks.retain(|remark| remark.code != "thinned");
    remarks.push(Remark::new("thinned", message));
    thinned(&points, MAX_OUTLINE)
}

fn outlines(
    format: &'static str,
    raws: Vec<Raw>,
    mut remarks: Vec<Remark>,
) -> Result<FileContent, ReadError> {
    let mut all: Vec<(bool, f64, NamedOutline)> = Vec::new();
    let mut first_error = None;
    let mut opened = 0;
    for raw in raws {
        let count = raw.points.len();
        let points = fewer(raw.points, count, &mut remarks);
        match Outline::new(&points) {
            Ok(outline) if outline.points().len() >= LEAST => {
                opened += usize::from(!raw.closed);
                // What crosses itself may have no area: its box has.
                let (low, high) = outline.bounds();
                let size = outline.area().max(1e-3 * (high - low).element_product());
                all.push((raw.ground, size, NamedOutline { name: raw.name, outline, crossings: None }));
            }
            Ok(outline) => {
                let count = outline.points().len();
                first_error.get_or_insert(ReadError::TooFew { count, series: false });
            }
            Err(_) if count < LEAST => {
                first_error.get_or_insert(ReadError::TooFew { count, series: false });
            }
            Err(_) => {
                first_error.get_or_insert(ReadError::Flat);
            }
        }
    }
    if all.is_empty() {
        return Err(first_error.unwrap_or(ReadError::Nothing { format: "SVG" }));
    }
    all.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
    if all.len() > MAX_LISTED {
        let message = format!("There are {} outlines: the {MAX_LISTED} largest are listed.", all.len());
        remarks.push(Remark::new("ignored", message));
        all.truncate(MAX_LISTED);
    }
    if opened > 0 {
        let message = match opened {
            1 => "A line that was open was closed by a straight side.".into(),
            count => format!("{count} lines that were open were closed by straight sides."),
        };
        remarks.push(Remark::new("closed", message));
    }
    let mut outlines: Vec<NamedOutline> = all.into_iter().map(|(_, _, named)| named).collect();
    let mut looked_at = 0;
    for named in &mut outlines {
        looked_at += named.outline.points().len();
        if looked_at <= 5 * MAX_OUTLINE {
            named.crossings = crossings(named.outline.points(), MAX_CROSSINGS).map(|found| found.len());
        }
    }
    if let Some(count) = outlines.first().and_then(|first| first.crossings).filter(|&count| count > 0) {
        let more = if count >= MAX_CROSSINGS { " or more" } else { "" };
        let message = format!(
            "The outline crosses itself {count} times{more}. It can be fitted, but inside and outside are not told \
             apart there: mend it, or pick another."
        );
        remarks.push(Remark::new("crossing", message));
    }
    Ok(FileContent::Outlines { format, outlines, remarks })
}
