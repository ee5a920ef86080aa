//! The locus and its points as words of a link.

use std::fmt::Write as _;

use super::error::LinkError;
use super::words::{damaged, number, numbers, read_some, within};
use crate::scene::{FamilyName, LocusView, MAX_WAY_POINTS, WayPoint};

/// Waypoints and views further away than this are a mistake.
const FARTHEST_POINT: f64 = 1e6;

/// `locus=m:0.0227,0.703,100&at=0.02,0.7`; the family is `morph`, `m` (two sides) or its number of sides, the slice `w`
/// a fourth number.
pub(super) fn write_locus(link: &mut String, view: &LocusView) {
    let whole = LocusView { sides: view.sides, at: view.at, ..LocusView::whole(view.family) };
    if view.family == FamilyName::Polygon || *view != whole {
        let family = match (view.family, view.sides) {
            (FamilyName::Morph, _) => "morph".to_owned(),
            (FamilyName::Polygon, 2) => "m".to_owned(),
            (FamilyName::Polygon, sides) => sides.to_string(),
        };
        let _ = write!(link, "&locus={family}:{}", numbers(&[view.x, view.y, view.zoom]));
        if view.w != 0.0 {
            let _ = write!(link, ",{}", number(view.w));
        }
    }
    if let Some(at) = view.at {
        let _ = write!(link, "&at={}", numbers(&at.numbers()));
    }
}

pub(super) fn read_locus<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Option<LocusView>, LinkError> {
    let at = match get("at") {
        None => None,
        Some(text) => {
            let numbers = read_some("at", text)?;
            let point = WayPoint::from_numbers(&numbers).filter(|_| within(&numbers, FARTHEST_POINT));
            Some(point.ok_or_else(|| damaged("at", text))?)
        }
    };
    let Some(text) = get("locus") else {
        return Ok(at.map(|at| LocusView { at: Some(at), ..LocusView::whole(FamilyName::Morph) }));
    };
    let (name, window) = text.split_once(':').unwrap_or((text, ""));
    let (family, sides) = match name {
        "morph" => (FamilyName::Morph, 2),
        "m" => (FamilyName::Polygon, 2),
        _ => (FamilyName::Polygon, name.parse().map_err(|_| damaged("locus", text))?),
    };
    if !(2..=64).contains(&sides) {
        return Err(damaged("locus", text));
    }
    let mut view = LocusView { sides, at, ..LocusView::whole(family) };
    let numbers = if window.is_empty() { Vec::new() } else { read_some("locus", window)? };
    match *numbers {
        [] => {}
        [x, y, zoom] => view = LocusView { x, y, zoom, ..view },
        [x, y, zoom, w] => view = LocusView { x, y, zoom, w, ..view },
        _ => return Err(damaged("locus", text)),
    }
    if !(within(&[view.x, view.y, view.w], FARTHEST_POINT) && (1e-3..=1e15).contains(&view.zoom)) {
        return Err(damaged("locus", text));
    }
    // All of the morph's is what nothing stands for.
    Ok(Some(view).filter(|view| *view != LocusView::whole(FamilyName::Morph)))
}

pub(super) fn read_way_points(key: &'static str, text: &str) -> Result<Vec<WayPoint>, LinkError> {
    if text.is_empty() {
        return Ok(Vec::new());
    }
    let mut way = Vec::new();
    for part in text.split(';') {
        if way.len() == MAX_WAY_POINTS {
            return Err(LinkError::Value { key, value: format!("a list of more than {MAX_WAY_POINTS}") });
        }
        let numbers = read_some(key, part)?;
        let point = WayPoint::from_numbers(&numbers).filter(|_| within(&numbers, FARTHEST_POINT));
        way.push(point.ok_or_else(|| damaged(key, part))?);
    }
    Ok(way)
}
