//! Graph-directed shapes as words of a link.
//!
//! ```text
//! directed-a=snowflake&directed-b=states:2,0.5,0,0,0.5,0,0;..:1,..&directed-b-name=My%20own
//! directed-a=frond&directed-b=curve:Af3..&directed-b-name=Oak
//! ```
//!
//! A closed curve is packed as those of `curve-a` are.
//!
//! States are parted by colons, their maps by semicolons; a map is the number of the state that it copies, from 1, and
//! its six numbers. `directed-half=signs` says that half turns go as eq 6 has it.

use std::fmt::Write as _;

use frond_core::{HalfTurns, MAX_MAPS, MAX_STATES};

use super::error::LinkError;
use super::words::{choice, damaged, escape, joined, name_of, numbers, read_list, tidy, unescape};
use crate::directed::{Directed, DirectedCopy, DirectedShape};

/// The keys of a shape, of itself and of its name, and which end it is.
type Keys = (&'static str, &'static str, char);
const A: Keys = ("directed-a", "directed-a-name", 'A');
const B: Keys = ("directed-b", "directed-b-name", 'B');

/// Which way half turns go. The first links did not say: in what they showed all were counter-clockwise.
const HALF: &str = "directed-half";
const HALF_TURNS: [(&str, HalfTurns); 3] = [
    ("counter-clockwise", HalfTurns::CounterClockwise),
    ("signs", HalfTurns::Signs),
    ("clockwise", HalfTurns::Clockwise),
];

pub(super) fn write_directed(link: &mut String, directed: &Directed) {
    write_one(link, A, &directed.a);
    write_one(link, B, &directed.b);
    if directed.half_turns != HALF_TURNS[0].1 {
        let _ = write!(link, "&{HALF}={}", name_of(&HALF_TURNS, &directed.half_turns));
    }
}

fn write_one(link: &mut String, (key, name_key, _): Keys, shape: &DirectedShape) {
    let gallery = shape.preset.as_deref().and_then(DirectedShape::of_preset);
    if let Some(id) = gallery.filter(|found| found.states == shape.states).and_then(|found| found.preset) {
        let _ = write!(link, "&{key}={id}");
        return;
    }
    let packed = shape.outline.as_deref().and_then(|text| DirectedShape::of_text("", text).ok());
    if let Some(text) = packed.filter(|found| found.states == shape.states).and_then(|found| found.outline) {
        let _ = write!(link, "&{key}=curve:{text}");
        write_name(link, name_key, shape);
        return;
    }
    let copy = |part: &DirectedCopy| format!("{},{}", part.from.saturating_add(1), numbers(&part.map));
    let state = |maps: &Vec<DirectedCopy>| joined(&maps.iter().map(copy).collect::<Vec<_>>(), ";");
    let states: Vec<String> = shape.states.iter().map(state).collect();
    let _ = write!(link, "&{key}=states:{}", joined(&states, ":"));
    write_name(link, name_key, shape);
}

fn write_name(link: &mut String, name_key: &str, shape: &DirectedShape) {
    let name = tidy(&shape.name);
    if !name.is_empty() {
        let _ = write!(link, "&{name_key}={}", escape(&name));
    }
}

/// The graph-directed shapes of a link: both or none. `curves`: whether it has closed curves, which stand in the same
/// place.
pub(super) fn read_directed<'a>(
    get: &impl Fn(&str) -> Option<&'a str>,
    curves: bool,
) -> Result<Option<Directed>, LinkError> {
    let without = |(key, ..): Keys, (other, ..): Keys| {
        Err(LinkError::Value { key, value: format!("left out beside “{other}”") })
    };
    match (read_one(get, A)?, read_one(get, B)?) {
        (Some(_), Some(_)) if curves => {
            Err(LinkError::Value { key: A.0, value: "kept beside “curve-a”".to_owned() })
        }
        (Some(a), Some(b)) => {
            let half_turns = choice(HALF, get(HALF), &HALF_TURNS)?;
            Ok(Some(Directed { a, b, half_turns }))
        }
        (None, None) => Ok(None),
        (Some(_), None) => without(B, A),
        (None, Some(_)) => without(A, B),
    }
}

fn read_one<'a>(
    get: &impl Fn(&str) -> Option<&'a str>,
    (key, name_key, end): Keys,
) -> Result<Option<DirectedShape>, LinkError> {
    let Some(text) = get(key) else { return Ok(None) };
    let name = get(name_key).map(unescape).map(|name| tidy(&name)).filter(|name| !name.is_empty());
    let name = name.unwrap_or_else(|| "Own shape".to_owned());
    if let Some(packed) = text.strip_prefix("curve:") {
        return DirectedShape::of_text(&name, packed).map(Some).map_err(|_| damaged(key, text));
    }
    let Some(states) = text.strip_prefix("states:") else {
        return DirectedShape::of_preset(text).map(Some).ok_or_else(|| damaged(key, text));
    };
    // One more than there may be is enough to be told so.
    let states: Result<Vec<_>, LinkError> =
        states.split(':').take(MAX_STATES + 1).map(|maps| read_state(key, maps)).collect();
    let shape = DirectedShape { preset: None, name, states: states?, outline: None };
    match shape.refuse_obvious() {
        Ok(()) => Ok(Some(shape)),
        Err(source) => Err(LinkError::Directed { end, source }),
    }
}

fn read_state(key: &'static str, text: &str) -> Result<Vec<DirectedCopy>, LinkError> {
    let states = 1..=MAX_STATES;
    let known = |&[from, ..]: &[f64; 7]| from.fract() == 0.0 && states.contains(&(from as usize));
    let rows = read_list::<7>(key, text, MAX_MAPS, known)?;
    let copy = |&[from, a, b, c, d, e, f]: &[f64; 7]| DirectedCopy {
        from: from as usize - 1,
        map: [a, b, c, d, e, f],
    };
    Ok(rows.iter().map(copy).collect())
}
