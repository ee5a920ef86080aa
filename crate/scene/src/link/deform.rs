//! A deformation as words of a link.
//!
//! ```text
//! tool=deform&mesh=4x4:0,0,1,1&bend=0,9,0.75&keys=0:6,0.1,0.2;0.5:6,-0.1,0.2,11,0,0.3&spin=scaled&loop=4
//! ```
//!
//! A key is its moment and then, for each control point that is not at rest, its number from 1 and how far it is moved.

use std::fmt::Write as _;

use frond_deform::{Continuity, Roughness, Spin};

use super::error::LinkError;
use super::words::{
    choice, colour_words, damaged, joined, name_of, number, numbers, read_colours, read_numbers, read_some,
    within,
};
use crate::deformation::{Deformation, Key, MAX_KEYS, MAX_SIDE, Subject, Tint};

/// Lengths beyond are a mistake.
const FARTHEST_LENGTH: f64 = 1e100;
/// Letters beyond are a mistake; what is too deep for a shape is taken down when it is drawn.
const DEEPEST_LETTER: f64 = 64.0;
/// Roughness beyond is a mistake.
const MOST_ROUGHNESS: f64 = 1e6;
const LOOP_SECONDS: std::ops::RangeInclusive<f64> = 0.5..=60.0;

const SPINS: [(&str, Spin); 4] = [
    ("none", Spin::None),
    ("orthogonal", Spin::Orthogonal),
    ("rotation", Spin::Rotation),
    ("scaled", Spin::Scaled),
];
const JOINS: [(&str, Continuity); 6] = [
    ("auto", Continuity::Auto),
    ("corners", Continuity::Corners),
    ("splat", Continuity::Splat),
    ("raw", Continuity::Raw),
    ("average", Continuity::Average),
    ("published", Continuity::Published),
];
const TERMS: [(&str, bool); 2] = [("all", true), ("last", false)];

pub(super) fn write_deform(link: &mut String, deform: &Deformation) {
    let plain = Deformation::at_rest(deform.bounds);
    let Deformation { columns, rows, .. } = deform;
    let _ = write!(link, "&mesh={columns}x{rows}:{}", numbers(&deform.bounds));
    let delta = match deform.delta {
        Roughness::Constant(delta) => vec![delta],
        Roughness::Corners(deltas) => deltas.to_vec(),
    };
    let _ = write!(link, "&bend={}", numbers(&[&[deform.kb, deform.ke], &delta[..]].concat()));
    let _ = write!(link, "&keys={}", joined(&deform.keys.iter().map(key).collect::<Vec<_>>(), ";"));
    if deform.phase != 0.0 {
        let _ = write!(link, "&phase={}", number(deform.phase));
    }
    if deform.seconds != plain.seconds || !deform.looped {
        let how = if deform.looped { "loop" } else { "once" };
        let _ = write!(link, "&{how}={}", number(deform.seconds));
    }
    if deform.spin != plain.spin {
        let _ = write!(link, "&spin={}", name_of(&SPINS, &deform.spin));
    }
    if deform.continuity != plain.continuity {
        let _ = write!(link, "&join={}", name_of(&JOINS, &deform.continuity));
    }
    if !deform.superposed {
        link.push_str("&terms=last");
    }
    if deform.subject == Subject::Picture {
        let _ = write!(link, "&picture={}", deform.parts);
    }
    if !deform.on {
        link.push_str("&bent=0");
    }
    if let Some(tint) = &deform.tint {
        let terms = name_of(&TERMS, &tint.superposed);
        let colours = colour_words(&tint.colours);
        let _ = write!(link, "&tint={}:{terms}:{colours}", numbers(&[tint.kb, tint.ke, tint.delta]));
    }
}

fn key(key: &Key) -> String {
    let mut text = format!("{}:", number(key.at));
    let pairs = key.moves.chunks_exact(2).enumerate().filter(|(_, pair)| pair.iter().any(|x| *x != 0.0));
    let moved: Vec<String> = pairs.map(|(i, pair)| format!("{},{}", i + 1, numbers(pair))).collect();
    text.push_str(&joined(&moved, ","));
    text
}

/// The deformation of a link, if it has one: that is, if it has a mesh.
pub(super) fn read_deform<'a>(
    get: &impl Fn(&str) -> Option<&'a str>,
) -> Result<Option<Deformation>, LinkError> {
    let Some(text) = get("mesh") else { return Ok(None) };
    let wrong = || damaged("mesh", text);
    let (sides, bounds) = text.split_once(':').ok_or_else(wrong)?;
    let (columns, rows) = sides.split_once('x').ok_or_else(wrong)?;
    let side = |text: &str| text.parse().ok().filter(|side| (2..=MAX_SIDE).contains(side)).ok_or_else(wrong);
    let bounds = read_numbers::<4>("mesh", bounds)?;
    let [x0, y0, x1, y1] = bounds;
    if !(within(&bounds, FARTHEST_LENGTH) && x1 > x0 && y1 > y0) {
        return Err(wrong());
    }
    let mut deform = Deformation::at_rest(bounds);
    (deform.columns, deform.rows) = (side(columns)?, side(rows)?);
    let count = deform.columns * deform.rows;
    deform.keys = match get("keys") {
        None => vec![Key { at: 0.0, moves: vec![0.0; 2 * count] }],
        Some(text) => read_keys(text, count)?,
    };
    if let Some(text) = get("bend") {
        (deform.kb, deform.ke, deform.delta) = read_bend(text)?;
    }
    if let Some(text) = get("phase") {
        let [phase] = read_numbers::<1>("phase", text)?;
        deform.phase = phase.clamp(0.0, 1.0);
    }
    for (name, looped) in [("loop", true), ("once", false)] {
        if let Some(text) = get(name) {
            let [seconds] = read_numbers::<1>(name, text)?;
            if !LOOP_SECONDS.contains(&seconds) {
                return Err(damaged(name, text));
            }
            (deform.seconds, deform.looped) = (seconds, looped);
        }
    }
    deform.spin = choice("spin", get("spin"), &SPINS)?;
    deform.continuity = choice("join", get("join"), &JOINS)?;
    deform.superposed = choice("terms", get("terms"), &TERMS)?;
    deform.on = choice("bent", get("bent"), &[("1", true), ("0", false)])?;
    if let Some(text) = get("picture") {
        deform.subject = Subject::Picture;
        deform.parts = choice("picture", Some(text), &[("2", 2), ("3", 3)])?;
    }
    deform.tint = get("tint").map(|text| read_tint(text, count)).transpose()?;
    Ok(Some(deform))
}

fn read_bend(text: &str) -> Result<(f64, f64, Roughness), LinkError> {
    let list: Option<Vec<f64>> = text.split(',').take(7).map(|part| part.parse().ok()).collect();
    let (kb, ke, delta) = match list.as_deref() {
        Some(&[kb, ke, delta]) => (kb, ke, Roughness::Constant(delta)),
        Some(&[kb, ke, a, b, c, d]) => (kb, ke, Roughness::Corners([a, b, c, d])),
        _ => return Err(damaged("bend", text)),
    };
    let rough = |delta: &f64| (0.0..=MOST_ROUGHNESS).contains(delta);
    let fits = match &delta {
        Roughness::Constant(delta) => rough(delta),
        Roughness::Corners(deltas) => deltas.iter().all(rough),
    };
    let deep = (0.0..=DEEPEST_LETTER).contains(&ke) && (0.0..=ke).contains(&kb);
    if fits && deep { Ok((kb, ke, delta)) } else { Err(damaged("bend", text)) }
}

fn read_keys(text: &str, count: usize) -> Result<Vec<Key>, LinkError> {
    let mut keys: Vec<Key> = Vec::new();
    for part in text.split(';') {
        if keys.len() == MAX_KEYS {
            return Err(LinkError::Value { key: "keys", value: format!("a list of more than {MAX_KEYS}") });
        }
        let wrong = || damaged("keys", part);
        let (at, moved) = part.split_once(':').ok_or_else(wrong)?;
        let [at] = read_numbers::<1>("keys", at)?;
        let in_order = keys.last().is_none_or(|last| last.at < at);
        if !((0.0..=1.0).contains(&at) && in_order) {
            return Err(wrong());
        }
        let mut moves = vec![0.0; 2 * count];
        let words: Vec<&str> = if moved.is_empty() { Vec::new() } else { moved.split(',').collect() };
        let (triples, rest) = words.as_chunks::<3>();
        if !rest.is_empty() {
            return Err(wrong());
        }
        for [point, x, y] in triples {
            let point =
                point.parse::<usize>().ok().filter(|point| (1..=count).contains(point)).ok_or_else(wrong)?;
            for (axis, word) in [x, y].into_iter().enumerate() {
                let [x] = read_numbers::<1>("keys", word)?;
                if !within(&[x], FARTHEST_LENGTH) {
                    return Err(wrong());
                }
                moves[2 * (point - 1) + axis] = x;
            }
        }
        keys.push(Key { at, moves });
    }
    Ok(keys)
}

fn read_tint(text: &str, count: usize) -> Result<Tint, LinkError> {
    let wrong = || damaged("tint", text);
    let mut parts = text.splitn(3, ':');
    let [head, terms, colours] = [(); 3].map(|()| parts.next().unwrap_or(""));
    let list = read_some("tint", head)?;
    let &[kb, ke, delta] = &list[..] else { return Err(wrong()) };
    let superposed = choice("tint", Some(terms), &TERMS)?;
    let colours = read_colours(colours, count).filter(|colours| colours.len() == count).ok_or_else(wrong)?;
    let fits = (0.0..=DEEPEST_LETTER).contains(&ke)
        && (0.0..=ke).contains(&kb)
        && (0.0..=MOST_ROUGHNESS).contains(&delta);
    if fits { Ok(Tint { colours, kb, ke, delta, superposed }) } else { Err(wrong()) }
}
