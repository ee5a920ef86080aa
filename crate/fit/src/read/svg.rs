//! Drawings: each closed part of each shape that a browser shows is an outline.
//!
//! usvg resolves what browsers do: style sheets, uses, viewports, units, arcs. [`source`] parses the text, [`limits`]
//! refuses what would grow without end, [`styles`] writes out the properties that usvg does not look for in style
//! sheets, [`visible`] lists what is shown, [`region`] cuts it by clip paths and masks, [`flatten`] makes lines of it.

mod flatten;
mod limits;
mod paths;
mod region;
mod source;
mod styles;
mod transforms;
mod visible;

use std::borrow::Cow;
use std::collections::BTreeMap;

use kurbo::Rect;

use self::flatten::flatten;
use self::visible::{Shape, Visible};
use super::content::FileContent;
use super::problem::{LeftOut, ReadError, Remark};
use super::text::short;

/// Reads the shapes of an SVG as a browser shows them: transformed, used again, clipped, and without what is hidden.
/// Nothing is run or fetched. Coordinates are those of the page, in pixels where the drawing has a size, in single
/// precision as in browsers.
pub fn read_svg(text: &str) -> Result<FileContent, ReadError> {
    let mut left_out = LeftOut::default();
    let text = source::prepared(text)?;
    let text = source::checked(text, &mut left_out)?;
    let written = styles::written_out(&source::parse(&text)?, &mut left_out)?;
    let text = match written {
        Some(written) => source::checked(Cow::Owned(written), &mut left_out)?,
        None => text,
    };
    let tree = source::tree(&source::parse(&text)?)?;
    let Visible { shapes, around, hidden } = Visible::of(&tree, &mut left_out)?;
    let page = Rect::new(0.0, 0.0, tree.size().width().into(), tree.size().height().into());
    let (gathered, parts) = flatten(&shapes, around, page)?;
    let mut remarks: Vec<Remark> = left_out.remark().into_iter().collect();
    match (hidden, shapes.iter().any(|shape| shape.hidden)) {
        (0, _) => {}
        (1, false) => remarks.push(Remark::new("ignored", "A shape that is hidden is left out.")),
        (count, false) => {
            remarks.push(Remark::new("ignored", format!("{count} shapes that are hidden are left out.")));
        }
        (_, true) => {
            let message = "No shape of the drawing is visible, so that those are read that are hidden.";
            remarks.push(Remark::new("assumed", message));
        }
    }
    // A shape of many parts has one name, and its text may be long.
    let mut names = BTreeMap::new();
    for &(shape, _) in gathered.kept.iter().map(|kept| &kept.label) {
        let Shape { name, number, .. } = &shapes[shape];
        names
            .entry(shape)
            .or_insert_with(|| if name.is_empty() { format!("shape {number}") } else { short(name, 40) });
    }
    gathered.finish("svg", remarks, |&(shape, part)| match parts[shape] {
        1 => names[&shape].clone(),
        count => format!("{}, part {} of {count}", names[&shape], part + 1),
    })
}
