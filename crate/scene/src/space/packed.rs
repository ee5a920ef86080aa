//! What there is in space, as a word of a link.
//!
//! ```text
//! o:sponge/l:height,-0.56,0.55,0.35,0.75,0.25/f:0.8,0.35,0.8,0.5,0.2,1/b:0e1015
//! o:tetrahedron/to:dragon-curled/way:auto,0.2,0.4;0.6,0.5/t:0.5
//! o:sponge~b3,3,3,0,3,0.5,0;26,0.2,0,0.4
//! o:natural-0/o:natural-1~m1,0,0,0,1,0,0,0,1,2,0,0~cd5dde6/time:6,1,smooth/k:0,inout~v12,0,0,12,-1.57,0,0.46/k:3,..
//! ```
//!
//! Light is the paint and where it comes from; the finish is shadows and their softness, ambient occlusion, sky
//! light, gloss, and 1 for the tones of film. What was made before there was a finish has none, and older readers
//! pass over it.
//!
//! Parts are joined by `/`, what belongs to one of them by `~`; a shape that is not of the gallery is `maps;` and its
//! rows, then `~n` and its name. A bend is `~b`, the sizes of its lattice, locality, detail, roughness and turn, then
//! the control points that are moved, by number; in a key `~b` is the number of the object and that of its control
//! points, then the same. Numbers have as many digits as bring back the same bits.

mod bend;
mod light;
mod words;

use std::fmt::Write as _;

use bend::{read_bend, read_moves, write_bend, write_moves};
use frond_core::{Course, Ease, Mode};
use light::{read_finish, read_light, write_light};
use thiserror::Error;
use words::{choice, exactly, floats};

use crate::link::turns::Counting;
use crate::link::words::{escape, is_colour, name_of, number, numbers, tidy, unescape};
use crate::scene::{MAX_WAY_POINTS, Path, PathKind, WayPoint};
use crate::space::bend::{SpaceBend, moves_problem};
use crate::space::document::{
    MAX_KEYS3, MAX_OBJECTS3, PAGE_BACKGROUND, Repeat, Shape3, Space, SpaceKey, SpaceLight, SpaceMorph,
    SpaceObject, Timeline, affine,
};
use crate::space::part::{Held, SpaceView};
use crate::space::preset::Row3;

/// The longest word, in bytes: a link holds it, and more.
pub const MAX_PACKED: usize = 48 * 1024;
/// The longest time line, in seconds.
const LONGEST_SECONDS: f64 = 600.0;
/// The shortest.
const SHORTEST_SECONDS: f64 = 0.1;

const EASES: [(&str, Ease); 5] = [
    ("even", Ease::Even),
    ("in", Ease::In),
    ("out", Ease::Out),
    ("inout", Ease::InOut),
    ("hold", Ease::Hold),
];
const COURSES: [(&str, Course); 2] = [("straight", Course::Straight), ("smooth", Course::Smooth)];
/// The first two are older than the third.
const REPEATS: [(&str, Repeat); 3] = [("0", Repeat::Once), ("1", Repeat::Round), ("2", Repeat::PingPong)];
const KINDS: [(&str, PathKind); 3] =
    [("auto", PathKind::Auto), ("straight", PathKind::Straight), ("drawn", PathKind::Drawn)];

/// Why a space cannot be written or read. The message says what to do.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PackedError {
    /// It is longer than a link may be.
    #[error("This is more than a link holds ({bytes} bytes of 49152). Remove objects, maps or keys.")]
    TooLong {
        /// Its length.
        bytes: usize,
    },
    /// A part is not of its form.
    #[error(
        "What this link says of space is damaged at “{part}”. Ask for the link again, or start from here."
    )]
    Damaged {
        /// The beginning of the part.
        part: String,
    },
    /// A number is not finite, or out of its range.
    #[error("A number of {what} is out of its range: {range}.")]
    Number {
        /// Of what.
        what: &'static str,
        /// What is allowed.
        range: &'static str,
    },
    /// There are too many, or none.
    #[error("There are {count} {what}, and {range} are allowed.")]
    Count {
        /// Of what.
        what: &'static str,
        /// How many.
        count: usize,
        /// What is allowed.
        range: &'static str,
    },
    /// A shape has no attractor.
    #[error("“{name}” cannot be drawn. {why}")]
    Shape {
        /// Its name.
        name: String,
        /// Why.
        why: String,
    },
}

impl PackedError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooLong { .. } => "space-too-long",
            Self::Damaged { .. } => "space-damaged",
            Self::Number { .. } => "space-number",
            Self::Count { .. } => "space-count",
            Self::Shape { .. } => "space-shape",
        }
    }
}

/// A space as a word.
///
/// # Errors
/// [`PackedError`] where it could not be read back.
pub fn pack(space: &Space) -> Result<String, PackedError> {
    check(space)?;
    let mut word = String::new();
    for object in &space.objects {
        word.push_str(if word.is_empty() { "o:" } else { "/o:" });
        write_shape(&mut word, &object.shape);
        if let Some(moved) = &object.moved {
            let _ = write!(word, "~m{}", numbers(moved));
        }
        let own = object.shape.preset.as_deref().and_then(SpaceObject::of_preset).and_then(|o| o.tint);
        match &object.tint {
            tint if *tint == own => {}
            Some(tint) => {
                let _ = write!(word, "~c{}", tint.trim_start_matches('#'));
            }
            None => word.push_str("~c"),
        }
        if let Some(bend) = &object.bend {
            write_bend(&mut word, bend);
        }
    }
    write_light(&mut word, &space.light);
    if let Some(background) = &space.background {
        let _ = write!(word, "/b:{}", background.trim_start_matches('#'));
    }
    if let Some(morph) = &space.morph {
        write_morph(&mut word, morph, &counting(space, morph));
    }
    if let Some(line) = &space.timeline {
        let (repeat, course) = (name_of(&REPEATS, &line.repeat), name_of(&COURSES, &line.course));
        let _ = write!(word, "/time:{},{repeat},{course}", number(line.seconds));
        for key in &line.keys {
            write_key(&mut word, key);
        }
    }
    if word.len() > MAX_PACKED {
        return Err(PackedError::TooLong { bytes: word.len() });
    }
    Ok(word)
}

fn write_shape(word: &mut String, shape: &Shape3) {
    let gallery = shape.preset.as_deref().and_then(Shape3::of_preset);
    if let Some(id) = gallery.filter(|found| found.maps == shape.maps).and_then(|found| found.preset) {
        word.push_str(&id);
        return;
    }
    word.push_str("maps");
    for row in &shape.maps {
        let _ = write!(word, ";{}", numbers(row));
    }
    let name = tidy(&shape.name);
    if !name.is_empty() {
        let _ = write!(word, "~n{}", escape(&name).replace('~', "%7E"));
    }
}

/// How words count the turns of a morph: as links of the plane do.
fn counting(space: &Space, morph: &SpaceMorph) -> Counting {
    let [from, to] = [&space.objects[0].shape, &morph.to].map(|shape| affine(&shape.maps));
    Counting::of(&from, &to, &morph.correspondence)
}

fn write_morph(word: &mut String, morph: &SpaceMorph, counting: &Counting) {
    word.push_str("/to:");
    write_shape(word, &morph.to);
    if morph.mode == Mode::Linear {
        word.push_str("/mode:linear");
    }
    if morph.path != Path::default() {
        let _ = write!(word, "/way:{}", name_of(&KINDS, &morph.path.kind));
        for point in &morph.path.points {
            let _ = write!(word, ";{}", numbers(&point.numbers()));
        }
    }
    if morph.t != 0.0 {
        let _ = write!(word, "/t:{}", number(morph.t));
    }
    for (key, list) in [
        ("match", morph.correspondence.iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>()),
        ("turns", counting.for_link(&morph.turns).iter().map(ToString::to_string).collect()),
    ] {
        if !list.is_empty() {
            let _ = write!(word, "/{key}:{}", list.join(","));
        }
    }
}

fn write_key(word: &mut String, key: &SpaceKey) {
    let _ = write!(word, "/k:{},{}", number(key.at), name_of(&EASES, &key.ease));
    if let Some(view) = &key.view {
        let _ = write!(word, "~v{}", numbers(&view_numbers(view)));
    }
    for (index, moved) in key.moved.iter().enumerate() {
        if let Some(row) = moved {
            let _ = write!(word, "~p{index},{}", numbers(row));
        }
    }
    for (index, maps) in key.maps.iter().enumerate() {
        if let Some(maps) = maps {
            let _ = write!(word, "~q{index}");
            for row in maps {
                let _ = write!(word, ";{}", numbers(row));
            }
        }
    }
    for (index, moves) in key.bends.iter().enumerate() {
        if let Some(moves) = moves {
            let _ = write!(word, "~b{index},{}", moves.len());
            write_moves(word, moves);
        }
    }
    if let Some(t) = key.t {
        let _ = write!(word, "~t{}", number(t));
    }
}

pub(crate) fn view_numbers(view: &SpaceView) -> [f64; 7] {
    let [x, y, z] = view.target;
    [x, y, z, view.distance, view.turn, view.tilt, view.angle]
}

/// A view from its seven numbers; `None` where there is none.
pub(crate) fn view_of(
    [x, y, z, distance, turn, tilt, angle]: [f64; 7],
    holds: Option<Held>,
) -> Option<SpaceView> {
    let view = SpaceView { target: [x, y, z], distance, turn, tilt, angle, holds };
    view.is_one().then_some(view)
}

/// What a word says.
///
/// # Errors
/// [`PackedError`] where it is damaged, or a shape has no attractor.
pub fn unpack(word: &str) -> Result<Space, PackedError> {
    if word.len() > MAX_PACKED {
        return Err(PackedError::TooLong { bytes: word.len() });
    }
    let mut space = Space { objects: Vec::new(), light: SpaceLight::default(), ..Space::default() };
    for part in word.split('/') {
        // Parts that are not known are of a later version.
        let Some((key, text)) = part.split_once(':') else { return Err(damaged(part)) };
        let read = match key {
            "o" => read_object(text).map(|object| space.objects.push(object)),
            "l" => read_light(text, &space.light).map(|light| space.light = light),
            "f" => read_finish(text, &space.light).map(|light| space.light = light),
            "b" => {
                let page = text == PAGE_BACKGROUND;
                space.background = Some(if page { text.to_owned() } else { format!("#{text}") });
                Some(())
            }
            "to" => read_shape(text).map(|(to, _)| {
                let (mode, path) = (Mode::Polar, Path::default());
                space.morph = Some(SpaceMorph {
                    to,
                    mode,
                    path,
                    t: 0.0,
                    correspondence: Vec::new(),
                    turns: Vec::new(),
                });
            }),
            "mode" | "way" | "t" | "match" | "turns" => {
                space.morph.as_mut().and_then(|morph| read_choice(morph, key, text))
            }
            "time" => read_line(text).map(|line| space.timeline = Some(line)),
            "k" => read_key(text).and_then(|key| space.timeline.as_mut().map(|line| line.keys.push(key))),
            _ => Some(()),
        };
        read.ok_or_else(|| damaged(part))?;
        if space.objects.len() > MAX_OBJECTS3 {
            break;
        }
    }
    if let Some(mut morph) = space.morph.take().filter(|_| !space.objects.is_empty()) {
        morph.turns = counting(&space, &morph).of_link(morph.turns).ok_or(MATCHING)?;
        space.morph = Some(morph);
    }
    check(&space)?;
    Ok(space)
}

const MATCHING: PackedError =
    PackedError::Number { what: "the matching", range: "each map is named once, with up to 16 turns" };

fn damaged(part: &str) -> PackedError {
    PackedError::Damaged { part: tidy(part).chars().take(24).collect() }
}

/// A shape, and what else is said of it.
fn read_shape(text: &str) -> Option<(Shape3, Vec<&str>)> {
    let mut fields = text.split('~');
    let first = fields.next()?;
    let (names, rest): (Vec<&str>, Vec<&str>) = fields.partition(|field| field.starts_with('n'));
    let Some(rows) = first.strip_prefix("maps;") else {
        return Some((Shape3::of_preset(first)?, rest));
    };
    let maps = rows.split(';').map(exactly::<12>).collect::<Option<Vec<Row3>>>()?;
    let name = names.first().map(|name| tidy(&unescape(&name[1..]))).filter(|name| !name.is_empty());
    Some((Shape3 { preset: None, name: name.unwrap_or_else(|| "Own shape".to_owned()), maps }, rest))
}

fn read_object(text: &str) -> Option<SpaceObject> {
    let (shape, fields) = read_shape(text)?;
    let tint = shape.preset.as_deref().and_then(SpaceObject::of_preset).and_then(|object| object.tint);
    let mut object = SpaceObject { shape, moved: None, tint, bend: None };
    for field in fields {
        if let Some(row) = field.strip_prefix('m') {
            object.moved = Some(exactly(row)?);
        } else if let Some(tint) = field.strip_prefix('c') {
            object.tint = if tint.is_empty() { None } else { Some(format!("#{tint}")) };
        } else if let Some(bend) = field.strip_prefix('b') {
            object.bend = Some(read_bend(bend)?);
        }
    }
    Some(object)
}

fn read_choice(morph: &mut SpaceMorph, key: &str, text: &str) -> Option<()> {
    match key {
        "mode" => morph.mode = choice(&[("polar", Mode::Polar), ("linear", Mode::Linear)], text)?,
        "way" => {
            let mut parts = text.split(';');
            morph.path.kind = choice(&KINDS, parts.next()?)?;
            let point = |part: &str| WayPoint::from_numbers(&floats(part)?);
            morph.path.points = parts.take(MAX_WAY_POINTS + 1).map(point).collect::<Option<_>>()?;
        }
        "t" => [morph.t] = exactly(text)?,
        "match" => {
            let letter = |part: &str| part.parse::<usize>().ok()?.checked_sub(1);
            morph.correspondence = text.split(',').map(letter).collect::<Option<_>>()?;
        }
        _ => morph.turns = text.split(',').map(|part| part.parse().ok()).collect::<Option<_>>()?,
    }
    Some(())
}

fn read_line(text: &str) -> Option<Timeline> {
    let mut parts = text.split(',');
    let seconds = parts.next()?.parse().ok()?;
    let repeat = choice(&REPEATS, parts.next()?)?;
    let course = choice(&COURSES, parts.next()?)?;
    Some(Timeline { seconds, repeat, course, keys: Vec::new() })
}

fn read_key(text: &str) -> Option<SpaceKey> {
    let mut fields = text.split('~');
    let (at, ease) = fields.next()?.split_once(',')?;
    let mut key = SpaceKey { at: at.parse().ok()?, ease: choice(&EASES, ease)?, ..SpaceKey::default() };
    for field in fields {
        let kind = field.chars().next()?;
        let rest = &field[kind.len_utf8()..];
        match kind {
            'v' => key.view = Some(view_of(exactly(rest)?, None)?),
            'p' => {
                let (index, row) = rest.split_once(',')?;
                *entry(&mut key.moved, index)? = Some(exactly(row)?);
            }
            'q' => {
                let (index, rows) = rest.split_once(';')?;
                let rows = rows.split(';').map(exactly).collect::<Option<_>>()?;
                *entry(&mut key.maps, index)? = Some(rows);
            }
            'b' => {
                let (index, moves) = rest.split_once(',')?;
                *entry(&mut key.bends, index)? = Some(read_moves(moves)?);
            }
            't' => key.t = Some(exactly::<1>(rest)?[0]),
            _ => {}
        }
    }
    Some(key)
}

/// The entry of a list for an object, the list made longer where it must be.
fn entry<'a, T>(list: &'a mut Vec<Option<T>>, index: &str) -> Option<&'a mut Option<T>> {
    let index: usize = index.parse().ok().filter(|&index| index < MAX_OBJECTS3)?;
    while list.len() <= index {
        list.push(None);
    }
    list.get_mut(index)
}

/// Whether all of it is in range, and every shape one.
fn check(space: &Space) -> Result<(), PackedError> {
    let count = |what, count: usize, most: usize, range| {
        if (1..=most).contains(&count) { Ok(()) } else { Err(PackedError::Count { what, count, range }) }
    };
    let held = |what, list: &[f64], range, fits: &dyn Fn(f64) -> bool| {
        let good = list.iter().all(|&x| x.is_finite() && fits(x));
        if good { Ok(()) } else { Err(PackedError::Number { what, range }) }
    };
    const FINITE: &str = "numbers below 1e100 are";
    let far = |x: f64| x.abs() <= 1e100;
    count("objects", space.objects.len(), MAX_OBJECTS3, "1 to 60")?;
    for object in &space.objects {
        shape(&object.shape)?;
        if let Some(moved) = &object.moved {
            held("a place", moved, FINITE, &far)?;
        }
        if let Some(range) = object.bend.as_ref().and_then(SpaceBend::problem) {
            return Err(PackedError::Number { what: "a bend", range });
        }
        if object.tint.as_ref().is_some_and(|tint| !is_colour(tint)) {
            return Err(PackedError::Number { what: "a colour", range: "#rrggbb is what one looks like" });
        }
    }
    if space.background.as_ref().is_some_and(|colour| colour != PAGE_BACKGROUND && !is_colour(colour)) {
        return Err(PackedError::Number { what: "the background", range: "#rrggbb or page is what one is" });
    }
    held("the light", &space.light.numbers()[..1], "angles below 1e6 are allowed", &|x| x.abs() <= 1e6)?;
    held("the light", &space.light.numbers()[1..], "0 to 1 are allowed", &|x| (0.0..=1.0).contains(&x))?;
    held("the light", &space.light.finish(), "0 to 1 are allowed", &|x| (0.0..=1.0).contains(&x))?;
    if let Some(morph) = &space.morph {
        shape(&morph.to)?;
        held("the path", &[morph.t], "0 to 1 are allowed", &|x| (0.0..=1.0).contains(&x))?;
        if morph.path.points.len() > MAX_WAY_POINTS {
            let count = morph.path.points.len();
            return Err(PackedError::Count { what: "waypoints", count, range: "64" });
        }
        for point in &morph.path.points {
            held("the path", &point.numbers(), "numbers below 1e6 are allowed", &|x| x.abs() <= 1e6)?;
        }
        let from = space.objects[0].shape.maps.len().max(morph.to.maps.len());
        let mut sorted = morph.correspondence.clone();
        sorted.sort_unstable();
        let whole = sorted.is_empty() || sorted.into_iter().eq(0..from);
        let turns = morph.turns.is_empty()
            || morph.turns.len() == from && morph.turns.iter().all(|turns| (-16..=16).contains(turns));
        if !whole || !turns {
            return Err(MATCHING);
        }
    }
    let Some(line) = &space.timeline else { return Ok(()) };
    held("the time line", &[line.seconds], "0.1 to 600 seconds are allowed", &|x| {
        (SHORTEST_SECONDS..=LONGEST_SECONDS).contains(&x)
    })?;
    if line.keys.len() > MAX_KEYS3 {
        return Err(PackedError::Count { what: "keys", count: line.keys.len(), range: "100" });
    }
    for key in &line.keys {
        held("a key", &[key.at], "0 to 600 seconds are allowed", &|x| (0.0..=LONGEST_SECONDS).contains(&x))?;
        held("a key", key.t.as_slice(), "0 to 1 are allowed", &|x| (0.0..=1.0).contains(&x))?;
        if key.view.as_ref().is_some_and(|view| !view.is_one()) {
            return Err(PackedError::Number {
                what: "a view",
                range: "a distance above 0 and an angle below pi are needed",
            });
        }
        if let Some(range) = key.bends.iter().flatten().find_map(|moves| moves_problem(moves)) {
            return Err(PackedError::Number { what: "a key", range });
        }
        for row in key.moved.iter().flatten().chain(key.maps.iter().flatten().flatten()) {
            held("a key", row, FINITE, &far)?;
        }
    }
    Ok(())
}

fn shape(shape: &Shape3) -> Result<(), PackedError> {
    match shape.ifs() {
        Ok(_) => Ok(()),
        Err(error) => Err(PackedError::Shape { name: tidy(&shape.name), why: error.to_string() }),
    }
}

#[cfg(test)]
mod tests;
