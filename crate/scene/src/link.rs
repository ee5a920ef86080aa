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
//! as `a-name`. Keys that are not known are passed over, so that a link of a later version still shows what
//! this one understands. Old links open for ever: `tests/links.txt` is the collection that proves it.

use std::fmt::Write as _;

use frond_core::{IfsError, MAX_MAPS};
use thiserror::Error;

use crate::preset::{Row, preset};
use crate::scene::{Colouring, MAX_WAY_POINTS, ModeName, PathKind, Scene, Shape, Window};

/// The longest link, in bytes.
pub const MAX_LINK: usize = 64 * 1024;
/// The version that is written.
pub const VERSION: u32 = 1;
/// The longest name of a shape, in characters.
const MAX_NAME: usize = 60;
/// Way points and views further away than this are a mistake.
const FAR: f64 = 1e6;

/// Why a link could not be read. The message says what to do.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum LinkError {
    /// Longer than [`MAX_LINK`].
    #[error(
        "This link has {bytes} bytes, and the most is 65536. It may have been pasted twice: copy it again."
    )]
    TooLong {
        /// Its length in bytes.
        bytes: usize,
    },
    /// A value is not of its form.
    #[error("This link is damaged: “{key}” cannot be {value}. Ask for the link again, or start from here.")]
    Value {
        /// The key.
        key: &'static str,
        /// What is wrong.
        value: String,
    },
    /// A shape of the link has no attractor.
    #[error("Shape {end} of this link cannot be drawn. {source}")]
    Shape {
        /// `A` or `B`.
        end: char,
        /// Why.
        source: IfsError,
    },
    /// The link has the version of a later Frond.
    #[error(
        "This link was made by a later version of Frond. What this one understands is shown: reload the page to update it."
    )]
    Later,
}

impl LinkError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooLong { .. } => "link-too-long",
            Self::Value { .. } => "link-damaged",
            Self::Shape { .. } => "link-shape",
            Self::Later => "link-later",
        }
    }
}

/// The link of a document, without the `#`.
#[must_use]
pub fn encode(scene: &Scene) -> String {
    let mut link = format!("v={VERSION}");
    for (key, shape) in [("a", &scene.a), ("b", &scene.b)] {
        write_shape(&mut link, key, shape);
    }
    if scene.mode == ModeName::Linear {
        link.push_str("&mode=linear");
    }
    let kind = match scene.path.kind {
        PathKind::Auto => "auto",
        PathKind::Straight => "straight",
        PathKind::Drawn => "drawn",
    };
    if scene.path.kind != PathKind::Auto || !scene.path.points.is_empty() {
        let points: Vec<String> = scene.path.points.iter().map(|point| numbers(point)).collect();
        let _ = write!(link, "&path={kind}");
        if !points.is_empty() {
            let _ = write!(link, ":{}", points.join(";"));
        }
    }
    if scene.t != 0.0 {
        let _ = write!(link, "&t={}", number(scene.t));
    }
    if !scene.correspondence.is_empty() {
        let letters: Vec<String> = scene.correspondence.iter().map(|i| (i + 1).to_string()).collect();
        let _ = write!(link, "&match={}", letters.join(","));
    }
    if scene.turns.iter().any(|&turns| turns != 0) {
        let turns: Vec<String> = scene.turns.iter().map(ToString::to_string).collect();
        let _ = write!(link, "&turns={}", turns.join(","));
    }
    match scene.colouring {
        Colouring::Map => {}
        Colouring::Address => link.push_str("&colour=address"),
        Colouring::Density => link.push_str("&colour=density"),
    }
    if scene.compare {
        link.push_str("&compare=1");
    }
    if let Some(view) = scene.view {
        let _ = write!(link, "&view={}", numbers(&[view.x, view.y, view.zoom]));
    }
    link
}

/// The document of a link (with or without the `#`), and what was wrong with it. A link that cannot be read
/// gives the default document: there is always something to show.
#[must_use]
pub fn decode(link: &str) -> (Scene, Option<LinkError>) {
    let link = link.strip_prefix('#').unwrap_or(link);
    match read(link) {
        Ok((scene, later)) => (scene, later.then_some(LinkError::Later)),
        Err(error) => (Scene::default(), Some(error)),
    }
}

fn read(link: &str) -> Result<(Scene, bool), LinkError> {
    if link.len() > MAX_LINK {
        return Err(LinkError::TooLong { bytes: link.len() });
    }
    let get = |key: &str| {
        link.split('&').find_map(|pair| pair.strip_prefix(key).and_then(|rest| rest.strip_prefix('=')))
    };
    let later = match get("v") {
        None => false,
        Some(text) => match text.parse::<u32>() {
            Ok(version) if version >= 1 => version > VERSION,
            _ => return Err(damaged("v", text)),
        },
    };
    let mut scene = Scene::default();
    for (key, name_key, end, shape) in
        [("a", "a-name", 'A', &mut scene.a), ("b", "b-name", 'B', &mut scene.b)]
    {
        if let Some(text) = get(key) {
            *shape = read_shape(key, text, get(name_key))?;
            shape.ifs().map_err(|source| LinkError::Shape { end, source })?;
        }
    }
    scene.mode = choice("mode", get("mode"), &[("polar", ModeName::Polar), ("linear", ModeName::Linear)])?;
    if let Some(text) = get("path") {
        let (kind, points) = text.split_once(':').unwrap_or((text, ""));
        let kinds = [("auto", PathKind::Auto), ("straight", PathKind::Straight), ("drawn", PathKind::Drawn)];
        scene.path.kind = choice("path", Some(kind), &kinds)?;
        scene.path.points = read_list("path", points, MAX_WAY_POINTS, |point| within(point, FAR))?;
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
        let mut sorted = letters.clone();
        sorted.sort_unstable();
        if !sorted.into_iter().eq(0..maps) {
            return Err(damaged("match", text));
        }
        scene.correspondence = letters;
    }
    if let Some(text) = get("turns") {
        let turns: Option<Vec<i32>> = text.split(',').map(|part| part.parse().ok()).collect();
        let turns = turns.filter(|turns| turns.len() == maps && turns.iter().all(|t| (-16..=16).contains(t)));
        scene.turns = turns.ok_or_else(|| damaged("turns", text))?;
    }
    let colours = [("map", Colouring::Map), ("address", Colouring::Address), ("density", Colouring::Density)];
    scene.colouring = choice("colour", get("colour"), &colours)?;
    scene.compare = choice("compare", get("compare"), &[("0", false), ("1", true)])?;
    if let Some(text) = get("view") {
        let [x, y, zoom] = read_numbers::<3>("view", text)?;
        if !(within(&[x, y], 1e100) && (1e-6..=1e15).contains(&zoom)) {
            return Err(damaged("view", text));
        }
        scene.view = Some(Window { x, y, zoom });
    }
    Ok((scene, later))
}

/// The value among `choices`; the first one is the default.
fn choice<T: Copy>(key: &'static str, text: Option<&str>, choices: &[(&str, T)]) -> Result<T, LinkError> {
    match text {
        None => Ok(choices[0].1),
        Some(text) => choices
            .iter()
            .find_map(|(name, value)| (*name == text).then_some(*value))
            .ok_or_else(|| damaged(key, text)),
    }
}

fn write_shape(link: &mut String, key: &str, shape: &Shape) {
    let gallery = shape.preset.as_deref().and_then(preset).filter(|preset| preset.maps == shape.maps);
    if let Some(preset) = gallery {
        let _ = write!(link, "&{key}={}", preset.id);
        return;
    }
    let rows: Vec<String> = shape.maps.iter().map(|row| numbers(row)).collect();
    let _ = write!(link, "&{key}=maps:{}", rows.join(";"));
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
    Ok(Shape { preset: None, name: name.unwrap_or_else(|| "Own shape".to_owned()), maps })
}

fn read_list<const N: usize>(
    key: &'static str,
    text: &str,
    most: usize,
    fits: impl Fn(&[f64; N]) -> bool,
) -> Result<Vec<[f64; N]>, LinkError> {
    if text.is_empty() {
        return Ok(Vec::new());
    }
    let mut list = Vec::new();
    for part in text.split(';') {
        if list.len() == most {
            return Err(LinkError::Value { key, value: format!("a list of more than {most}") });
        }
        let numbers = read_numbers::<N>(key, part)?;
        if !fits(&numbers) {
            return Err(damaged(key, part));
        }
        list.push(numbers);
    }
    Ok(list)
}

fn read_numbers<const N: usize>(key: &'static str, text: &str) -> Result<[f64; N], LinkError> {
    let mut numbers = [0.0; N];
    let mut parts = text.split(',');
    for number in &mut numbers {
        let value = parts.next().and_then(|part| part.parse::<f64>().ok()).filter(|x| x.is_finite());
        *number = value.ok_or_else(|| damaged(key, text))?;
    }
    if parts.next().is_some() { Err(damaged(key, text)) } else { Ok(numbers) }
}

fn within(point: &[f64], most: f64) -> bool {
    point.iter().all(|x| x.abs() <= most)
}

fn damaged(key: &'static str, text: &str) -> LinkError {
    // A short piece is enough to recognise it by.
    let short: String = tidy(text).chars().take(24).collect();
    let dots = if text.chars().count() > 24 { "…" } else { "" };
    LinkError::Value { key, value: format!("“{short}{dots}”") }
}

/// Numbers with as many digits as bring back the same bits.
fn numbers(list: &[f64]) -> String {
    list.iter().map(|&x| number(x)).collect::<Vec<_>>().join(",")
}

fn number(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").map_or(text.clone(), ToOwned::to_owned)
}

/// A name without control characters and not too long.
fn tidy(name: &str) -> String {
    name.chars().filter(|c| !c.is_control()).take(MAX_NAME).collect::<String>().trim().to_owned()
}

fn escape(text: &str) -> String {
    let mut escaped = String::new();
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            escaped.push(char::from(byte));
        } else {
            let _ = write!(escaped, "%{byte:02X}");
        }
    }
    escaped
}

fn unescape(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut plain = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        let hex = bytes.get(i + 1..i + 3).and_then(|pair| std::str::from_utf8(pair).ok());
        let byte = hex.filter(|_| bytes[i] == b'%').and_then(|pair| u8::from_str_radix(pair, 16).ok());
        plain.push(byte.unwrap_or(bytes[i]));
        i += if byte.is_some() { 3 } else { 1 };
    }
    String::from_utf8_lossy(&plain).into_owned()
}

#[cfg(test)]
mod tests;
