//! Space as words of a link.
//!
//! ```text
//! space=o:tetrahedron/to:dragon-curled&space-view=0,0,0,5,0.5,0.42,0.7&space-at=1.5
//! ```
//!
//! The first word is what [`pack`](crate::pack) writes: who shows space reads it. A view is its target, its distance,
//! turn, tilt and angle, then `eye` where that stays; `space-own=1` says that it goes before that of the time line.

use std::fmt::Write as _;

use super::error::LinkError;
use super::words::{damaged, number, numbers, read_numbers, within};
use crate::space::{Held, MAX_PACKED, SpacePart, view_numbers, view_of};

/// Moments further away than this are a mistake.
const FARTHEST_MOMENT: f64 = 1e6;

/// Whether a word can stand in a link as it is.
fn stands(packed: &str) -> bool {
    packed.len() <= MAX_PACKED && packed.bytes().all(|c| c.is_ascii_graphic() && !matches!(c, b'&' | b'#'))
}

pub(super) fn write_space(link: &mut String, space: &SpacePart) -> Result<(), LinkError> {
    if !stands(&space.packed) {
        return Err(damaged("space", &space.packed));
    }
    let _ = write!(link, "&space={}", space.packed);
    if let Some(view) = space.view.as_ref().filter(|view| view.is_one()) {
        let _ = write!(link, "&space-view={}", numbers(&view_numbers(view)));
        if view.holds.is_some() {
            link.push_str(",eye");
        }
    }
    if space.own && space.view.is_some() {
        link.push_str("&space-own=1");
    }
    if space.at != 0.0 && within(&[space.at], FARTHEST_MOMENT) {
        let _ = write!(link, "&space-at={}", number(space.at));
    }
    Ok(())
}

pub(super) fn read_space<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Option<SpacePart>, LinkError> {
    let Some(packed) = get("space") else { return Ok(None) };
    if !stands(packed) {
        return Err(damaged("space", packed));
    }
    // A view or a moment that is none leaves the rest as it is: to look again is easy.
    let view = get("space-view").and_then(|text| {
        let (list, holds) = text.strip_suffix(",eye").map_or((text, None), |list| (list, Some(Held::Eye)));
        view_of(read_numbers::<7>("space-view", list).ok()?, holds)
    });
    let at = get("space-at").and_then(|text| read_numbers::<1>("space-at", text).ok());
    let at = at.map(|[at]| at).filter(|at| within(&[*at], FARTHEST_MOMENT)).unwrap_or(0.0);
    let own = view.is_some() && get("space-own") == Some("1");
    Ok(Some(SpacePart { packed: packed.to_owned(), view, own, at }))
}
