//! A file of any kind: what it is, and what is in it.

use std::borrow::Cow;

use super::content::FileContent;
use super::gather::{FEWEST_POINTS, fewer};
use super::problem::{ReadError, Remark};
use super::sniff::{FileKind, sniff};
#[cfg(feature = "svg")]
use super::svg;
use super::{geo, table, text};
use crate::outline::{MAX_OUTLINE, thinned};

/// The most bytes of a text.
const MAX_BYTES: usize = 64 << 20;

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

/// Reads a text file: SVG, a table of numbers or TPS, or JSON with outlines (`GeoJSON`, `TopoJSON`, the files of
/// programs that label pictures), whichever it is. Lengths are in the units of the file, and y is up.
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
    let (kind, text) = opened(bytes)?;
    match kind {
        #[cfg(feature = "svg")]
        FileKind::Svg => svg::read_svg(&text),
        #[cfg(not(feature = "svg"))]
        FileKind::Svg => Err(ReadError::Drawing),
        FileKind::Json => geo::read_geo(text::past_remarks(&text)).or_else(|error| {
            // Rows in brackets, as programs print them, are no JSON.
            let rows = matches!(error, ReadError::Broken { .. }) && text.trim_start().starts_with('[');
            let table = if rows { table_content(&text, read_as).ok() } else { None };
            table.ok_or(error)
        }),
        _ => table_content(&text, read_as),
    }
}

/// Reads a drawing (SVG) alone: less code, where others read the rest.
///
/// # Errors
/// Where it is too large, or has no outline.
#[cfg(feature = "svg")]
pub fn read_drawing(bytes: &[u8]) -> Result<FileContent, ReadError> {
    svg::read_svg(&opened(bytes)?.1)
}

/// What a text is, and the text.
fn opened(bytes: &[u8]) -> Result<(FileKind, Cow<'_, str>), ReadError> {
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
    Ok((kind, text::decode(bytes)))
}

fn table_content(text: &str, read_as: ReadAs) -> Result<FileContent, ReadError> {
    if table::is_tps(text) {
        return table::read_tps(text);
    }
    let table = table::read_table(text)?;
    let points = table.line.points();
    let goes = |sign: f64| points.windows(2).all(|pair| sign * (pair[1].x - pair[0].x) >= 0.0);
    let differ = points.windows(2).filter(|pair| pair[0].x != pair[1].x).count();
    let monotonic = (goes(1.0) || goes(-1.0)) && 2 * differ >= points.len().saturating_sub(1) && differ > 1;
    let series = match read_as {
        ReadAs::Guess => !table.two || monotonic,
        ReadAs::Outlines if !table.two => return Err(ReadError::OneColumn),
        ReadAs::Outlines => false,
        ReadAs::Series => true,
    };
    if !series {
        return table.into_outlines(text);
    }
    let or_outline = table.two && points.len() >= FEWEST_POINTS;
    let (rows, mut remarks) = (table.line.count, table.remarks);
    let mut points = table.line.into_points();
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    let before = points.len();
    points.dedup_by(|later, earlier| later.x == earlier.x);
    if points.len() < before {
        let message =
            format!("At {} places there was more than one value: the first is kept.", before - points.len());
        remarks.push(Remark::new("gaps", message));
    }
    if points.len() < FEWEST_POINTS {
        return Err(ReadError::TooFew { count: points.len(), series: true });
    }
    if points.len() > MAX_OUTLINE {
        remarks.retain(|remark| remark.code != "thinned");
        remarks.push(fewer(rows));
        points = thinned(&points, MAX_OUTLINE);
    }
    Ok(FileContent::Series { points, remarks, or_outline })
}
