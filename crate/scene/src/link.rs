//! Links: the document as the fragment of a URL.
//!
//! A link is a list of `key=value`, joined by `&`, in plain words where there are any:
//!
//! ```text
//! v=1&a=dragon-3&b=gasket&path=auto:0.12,0.4;0.3,1.6&t=0.5
//! ```
//!
//! What has its default is left out. A shape that is not of the gallery is written
//! `a=maps:0.5,0,0,0.5,0,0;..`, its numbers with as many digits as bring back the same bits, and its name
//! as `a-name`; how often the chaos game takes each map, where that is said, as `a-weights=1,2,0.5`; numbers that its
//! maps mean exactly as `a-exact=1/3,sqrt(3)/6`. Keys that are not known are passed over, so that a link of a later
//! version still shows what this one understands. Turns count from the counter-clockwise half turn where a map turns by
//! half a turn (`link/turns.rs` says why). Old links open for ever: `tests/links.txt` is the collection that proves it.

use std::fmt::Write as _;

use frond_core::shared::is_permutation;
use frond_core::{Colouring, MAX_MAPS, Mode, pair};

use crate::preset::{Row, preset};
use crate::scene::{PathKind, Scene, Shape, Tool, Window};

mod deform;
mod directed;
mod error;
mod fit;
mod locus;
mod space;
pub(crate) mod turns;
pub(crate) mod words;

pub use error::{LinkError, MAX_LINK};

use deform::{read_deform, write_deform};
use directed::{read_directed, write_directed};
use fit::{read_curves, read_fit, write_curves, write_fit};
use locus::{read_locus, read_way_points, write_locus};
use space::{read_space, write_space};
use turns::Counting;
use words::{
    choice, colour_words, damaged, escape, is_colour, joined, name_of, number, numbers, read_colours,
    read_formulas, read_list, read_numbers, tidy, unescape, within,
};

/// The version that is written.
pub const VERSION: u32 = 1;

// What things are called in links; the first is what a link stands for that says nothing.
const PATHS: [(&str, PathKind); 3] =
    [("auto", PathKind::Auto), ("straight", PathKind::Straight), ("drawn", PathKind::Drawn)];
const COLOURS: [(&str, Colouring); 4] = [
    ("map", Colouring::Map),
    ("address", Colouring::Address),
    ("density", Colouring::Density),
    ("grid", Colouring::Grid),
];

/// The link of a document, without the `#`: it opens again.
///
/// # Errors
/// Where it would not: a shape has no attractor, a curve cannot be written, a number is out of its range, or it would
/// be longer than [`MAX_LINK`].
pub fn encode(scene: &Scene) -> Result<String, LinkError> {
    let opened = |link: String| read(&link).map(|_| link);
    write(scene).and_then(opened).map_err(|error| match error {
        LinkError::Value { key, value } => LinkError::Unfit { key, value },
        error => error,
    })
}

fn write(scene: &Scene) -> Result<String, LinkError> {
    let mut link = format!("v={VERSION}");
    for (key, shape) in [("a", &scene.a), ("b", &scene.b)] {
        write_shape(&mut link, key, shape);
    }
    if scene.mode == Mode::Linear {
        link.push_str("&mode=linear");
    }
    if scene.path.kind != PathKind::Auto || !scene.path.points.is_empty() {
        let points: Vec<String> = scene.path.points.iter().map(|point| numbers(&point.numbers())).collect();
        let _ = write!(link, "&path={}", name_of(&PATHS, &scene.path.kind));
        if !points.is_empty() {
            let _ = write!(link, ":{}", joined(&points, ";"));
        }
    }
    if scene.t != 0.0 {
        let _ = write!(link, "&t={}", number(scene.t));
    }
    if !scene.correspondence.is_empty() {
        let letters: Vec<String> = scene.correspondence.iter().map(|i| (i + 1).to_string()).collect();
        let _ = write!(link, "&match={}", joined(&letters, ","));
    }
    let turns = counting(scene).for_link(&scene.turns);
    if !turns.is_empty() {
        let turns: Vec<String> = turns.iter().map(ToString::to_string).collect();
        let _ = write!(link, "&turns={}", joined(&turns, ","));
    }
    if scene.colouring != Colouring::Map {
        let _ = write!(link, "&colour={}", name_of(&COLOURS, &scene.colouring));
    }
    if !scene.palette.is_empty() {
        if let Some(wrong) = scene.palette.iter().find(|text| !is_colour(text)) {
            return Err(damaged("palette", wrong));
        }
        let _ = write!(link, "&palette={}", colour_words(&scene.palette));
    }
    if scene.compare {
        link.push_str("&compare=1");
    }
    if let Some(view) = scene.view {
        let _ = write!(link, "&view={}", numbers(&[view.x, view.y, view.zoom]));
    }
    if let Some(view) = scene.locus {
        write_locus(&mut link, &view);
    }
    if scene.tool != Tool::Morph {
        let _ = write!(link, "&tool={}", name_of(&Tool::NAMES, &scene.tool));
    }
    if let Some(deform) = &scene.deform {
        write_deform(&mut link, deform);
    }
    if let Some(curves) = &scene.curves {
        write_curves(&mut link, curves, scene.fit.as_ref())?;
    }
    if let Some(directed) = &scene.directed {
        write_directed(&mut link, directed);
    }
    if let Some(fit) = &scene.fit {
        write_fit(&mut link, fit)?;
    }
    if let Some(space) = &scene.space {
        write_space(&mut link, space)?;
    }
    if link.len() > MAX_LINK { Err(LinkError::TooLarge { bytes: link.len() }) } else { Ok(link) }
}

/// The document of a link (with or without the `#`), and what was wrong with it. A link that cannot be read
/// gives the default document: there is always something to show.
///
/// What a link gives, [`encode`] writes as a link that gives it again; where that cannot be, the link is one that
/// cannot be read.
#[must_use]
pub fn decode(link: &str) -> (Scene, Option<LinkError>) {
    let link = link.strip_prefix('#').unwrap_or(link);
    match read(link).and_then(|opened| write(&opened.0).map(|_| opened)) {
        Ok((scene, later)) => (scene, later.then_some(LinkError::Later)),
        Err(error) => (Scene::default(), Some(error)),
    }
}

/// The morph of a link alone: both shapes, the way between them, the moment and the colours, and which tool is open.
/// All else is passed over, damaged or not: for views that show nothing else, and are to be small.
///
/// # Errors
/// Where one of these cannot be read.
pub fn decode_morph(link: &str) -> Result<Scene, LinkError> {
    let link = link.strip_prefix('#').unwrap_or(link);
    if link.len() > MAX_LINK {
        return Err(LinkError::TooLong { bytes: link.len() });
    }
    read_morph(&|key| value_of(link, key))
}

fn value_of<'a>(link: &'a str, key: &str) -> Option<&'a str> {
    link.split('&').find_map(|pair| pair.strip_prefix(key).and_then(|rest| rest.strip_prefix('=')))
}

fn read(link: &str) -> Result<(Scene, bool), LinkError> {
    if link.len() > MAX_LINK {
        return Err(LinkError::TooLong { bytes: link.len() });
    }
    let get = |key: &str| value_of(link, key);
    let later = match get("v") {
        None => false,
        Some(text) => match text.parse::<u32>() {
            Ok(version) if version >= 1 => version > VERSION,
            _ => return Err(damaged("v", text)),
        },
    };
    let mut scene = read_morph(&get)?;
    scene.compare = choice("compare", get("compare"), &[("0", false), ("1", true)])?;
    if let Some(text) = get("view") {
        let [x, y, zoom] = read_numbers::<3>("view", text)?;
        if !(within(&[x, y], 1e100) && (1e-6..=1e15).contains(&zoom)) {
            return Err(damaged("view", text));
        }
        scene.view = Some(Window { x, y, zoom });
    }
    scene.locus = read_locus(&get)?;
    scene.deform = read_deform(&get)?;
    scene.fit = read_fit(&get)?;
    scene.curves = read_curves(&get, scene.fit.as_ref())?;
    scene.directed = read_directed(&get, scene.curves.is_some())?;
    scene.space = read_space(&get)?;
    Ok((scene, later))
}

fn read_morph<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Scene, LinkError> {
    let mut scene = Scene::default();
    for (key, name_key, weights_key, exact_key, end, shape) in [
        ("a", "a-name", "a-weights", "a-exact", 'A', &mut scene.a),
        ("b", "b-name", "b-weights", "b-exact", 'B', &mut scene.b),
    ] {
        if let Some(text) = get(key) {
            *shape = read_shape(key, text, get(name_key))?;
        }
        if let Some(text) = get(weights_key) {
            shape.weights =
                read_list::<1>(weights_key, &text.replace(',', ";"), MAX_MAPS, |_| true)?.into_flattened();
        }
        if let Some(text) = get(exact_key) {
            shape.exact = read_formulas(text).ok_or_else(|| damaged(exact_key, text))?;
        }
        shape.ifs().map_err(|source| LinkError::Shape { end, source })?;
    }
    scene.mode = choice("mode", get("mode"), &[("polar", Mode::Polar), ("linear", Mode::Linear)])?;
    if let Some(text) = get("path") {
        let (kind, points) = text.split_once(':').unwrap_or((text, ""));
        scene.path.kind = choice("path", Some(kind), &PATHS)?;
        scene.path.points = read_way_points("path", points)?;
    }
    if let Some(text) = get("t") {
        let [t] = read_numbers::<1>("t", text)?;
        scene.t = t.clamp(0.0, 1.0);
    }
    let maps = scene.a.maps.len().max(scene.b.maps.len());
    if let Some(text) = get("match") {
        let letters: Option<Vec<usize>> =
            text.split(',').map(|part| part.parse::<usize>().ok()?.checked_sub(1)).collect();
        let letters = letters.ok_or_else(|| damaged("match", text))?;
        if !is_permutation(&letters, maps) {
            return Err(damaged("match", text));
        }
        scene.correspondence = letters;
    }
    let mut turns = Vec::new();
    let text = get("turns").unwrap_or_default();
    if !text.is_empty() {
        for part in text.split(',') {
            turns.push(part.parse().map_err(|_| damaged("turns", text))?);
        }
    }
    // A link that names no shape is about the document that everything begins with, and no old link.
    let named = get("a").or(get("b")).is_some();
    let counting = if named { counting(&scene) } else { Counting::default() };
    let fits = turns.is_empty() || turns.len() == maps;
    scene.turns = counting.of_link(turns).filter(|_| fits).ok_or_else(|| damaged("turns", text))?;
    scene.colouring = choice("colour", get("colour"), &COLOURS)?;
    if let Some(text) = get("palette") {
        scene.palette = read_colours(text, MAX_MAPS).ok_or_else(|| damaged("palette", text))?;
    }
    scene.tool = choice("tool", get("tool"), &Tool::NAMES)?;
    Ok(scene)
}

/// How links count the turns of a document's morph; alike where there is none.
fn counting(scene: &Scene) -> Counting {
    let [Ok(a), Ok(b)] = [&scene.a, &scene.b].map(Shape::ifs) else { return Counting::default() };
    let ends = pair(&a, &b);
    Counting::of(&ends.from, &ends.to, &scene.correspondence)
}

fn write_shape(link: &mut String, key: &str, shape: &Shape) {
    write_maps(link, key, shape);
    if !shape.weights.is_empty() {
        let _ = write!(link, "&{key}-weights={}", numbers(&shape.weights));
    }
    if !shape.exact.is_empty() {
        let _ = write!(link, "&{key}-exact={}", joined(&shape.exact, ","));
    }
}

fn write_maps(link: &mut String, key: &str, shape: &Shape) {
    let gallery = shape.preset.as_deref().and_then(preset).filter(|preset| preset.maps == shape.maps);
    if let Some(preset) = gallery {
        let _ = write!(link, "&{key}={}", preset.id);
        return;
    }
    let rows: Vec<String> = shape.maps.iter().map(|row| numbers(row)).collect();
    let _ = write!(link, "&{key}=maps:{}", joined(&rows, ";"));
    let name = tidy(&shape.name);
    if !name.is_empty() {
        let _ = write!(link, "&{key}-name={}", escape(&name));
    }
}

fn read_shape(key: &'static str, text: &str, name: Option<&str>) -> Result<Shape, LinkError> {
    let Some(rows) = text.strip_prefix("maps:") else {
        return Shape::of_preset(text).ok_or_else(|| damaged(key, text));
    };
    let maps: Vec<Row> = read_list(key, rows, MAX_MAPS, |_| true)?;
    let name = name.map(unescape).map(|name| tidy(&name)).filter(|name| !name.is_empty());
    Ok(Shape {
        preset: None,
        name: name.unwrap_or_else(|| "Own shape".to_owned()),
        maps,
        weights: Vec::new(),
        exact: Vec::new(),
    })
}

#[cfg(test)]
mod tests;
