//! Closed curves and fits as words of a link.
//!
//! ```text
//! curve-a=maple&curve-b=curve:AaBb..&curve-b-name=My%20leaf
//! fit=outline:closed,260,0&fitted=curve:AaBb..&graph=fif:0.5,0.7,0.3,0,0,0,1;..
//! fit=outline:spline,260,0&bytes=50&spline=AaBb..&spline-name=My%20leaf
//! fit=plane:closed,260,0&plane=0,0,0;..:0.5,0,0,0.5,0,2;..
//! curve-a=fitted&curve-b=curve-a&fitted=curve:AaBb..
//! curve-a=spline:AaBb..&curve-b=maple
//! ```
//!
//! The word of a curve is [`ClosedCurve::to_text`], that of a spline
//! [`Spline::to_text`](frond_fit::Spline::to_text); a piece of a graph is a, b, c, d, e and its domain. A curve that
//! was taken from the fit of the same link, or is that of the other end, is not written twice: `fitted`, `spline` and
//! `curve-a` stand for it. Whether the words of a spline and of a curve of the plane are some is left to those who draw
//! them: what that takes is no part of the module for the first picture.

use std::fmt::Write as _;

use frond_fit::ClosedCurve;

use super::error::LinkError;
use super::words::{
    choice, damaged, escape, joined, name_of, number, numbers, read_list, read_numbers, tidy, unescape,
};
use crate::curve::{Curve, CurveShape, Curves};
use crate::fit::{
    BYTES, Fit, FitMode, FitModel, Graph, GraphKind, GraphPiece, MAX_PIECES, NUMBERS, SplineShape,
    USUAL_BYTES, is_plane_word, is_spline_word,
};

const MODES: [(&str, FitMode); 3] =
    [("outline", FitMode::Outline), ("graph", FitMode::Graph), ("plane", FitMode::Plane)];
const MODELS: [(&str, FitModel); 3] =
    [("closed", FitModel::Closed), ("collage", FitModel::Collage), ("spline", FitModel::Spline)];
const KINDS: [(&str, GraphKind); 3] =
    [("fif", GraphKind::Fif), ("rfif", GraphKind::Rfif), ("pfif", GraphKind::Pfif)];
/// The keys of a curve: of itself and of its name; and what it is called.
type Keys = [&'static str; 3];
const A: Keys = ["curve-a", "curve-a-name", "The first curve"];
const B: Keys = ["curve-b", "curve-b-name", "The second curve"];
const FITTED: Keys = ["fitted", "fitted-name", "The fitted curve"];
const SPLINE: &str = "spline";
const PLANE: &str = "plane";
const SPLINE_NAME: &str = "spline-name";

/// What a value cannot be, and why: the full stop comes after it.
fn as_a(what: &str, why: &impl std::fmt::Display) -> String {
    format!("{what}. {why}").trim_end_matches('.').to_owned()
}

/// The curve of the gallery with this id.
fn gallery(id: &str) -> Option<CurveShape> {
    let preset = frond_fit::curve_preset(id)?;
    Some(CurveShape {
        preset: Some(preset.id.to_owned()),
        name: preset.name.to_owned(),
        curve: Curve::from(&preset.curve),
        spline: None,
    })
}

/// The curves of a link that others may be, by the words that stand for them.
type Given<'a> = [Option<(&'static str, &'a CurveShape)>; 3];

const NONE: &Given<'static> = &[None, None, None];

/// Those of a fit, as a morph takes them: the closed curve, and the spline.
fn taken(fit: Option<&Fit>) -> [Option<CurveShape>; 2] {
    let curve = fit.and_then(|fit| fit.curve.as_ref()).and_then(|shape| {
        Some(CurveShape { preset: None, curve: shape.curve.taken().ok()?, ..shape.clone() })
    });
    let spline = fit.and_then(|fit| fit.spline.as_ref()).map(|shape| CurveShape {
        name: shape.name.clone(),
        spline: Some(shape.word.clone()),
        ..CurveShape::default()
    });
    [curve, spline]
}

/// The curves of a fit, and that of the other end.
fn given<'a>([curve, spline]: &'a [Option<CurveShape>; 2], a: Option<&'a CurveShape>) -> Given<'a> {
    let named = |word, shape: Option<&'a CurveShape>| shape.map(|shape| (word, shape));
    [named(FITTED[0], curve.as_ref()), named(SPLINE, spline.as_ref()), named(A[0], a)]
}

pub(super) fn write_curves(link: &mut String, curves: &Curves, fit: Option<&Fit>) -> Result<(), LinkError> {
    let fitted = taken(fit);
    write_curve(link, A, &curves.a, &given(&fitted, None))?;
    write_curve(link, B, &curves.b, &given(&fitted, Some(&curves.a)))
}

fn write_curve(
    link: &mut String,
    [key, name_key, which]: Keys,
    shape: &CurveShape,
    given: &Given<'_>,
) -> Result<(), LinkError> {
    let same = |found: &CurveShape| {
        found.spline == shape.spline && (shape.spline.is_some() || found.curve == shape.curve)
    };
    if let Some(id) = shape.preset.as_deref().filter(|id| gallery(id).as_ref().is_some_and(same)) {
        let _ = write!(link, "&{key}={id}");
        return Ok(());
    }
    let name = tidy(&shape.name);
    if let Some((word, of)) = given.iter().flatten().find(|(_, of)| same(of)) {
        let _ = write!(link, "&{key}={word}");
        write_name(link, name_key, if name == tidy(&of.name) { "" } else { &name });
        return Ok(());
    }
    if let Some(word) = &shape.spline {
        if !is_spline_word(word) {
            return Err(damaged(key, word));
        }
        let _ = write!(link, "&{key}=spline:{word}");
    } else {
        let unwritten = |source| LinkError::Curve { which, source };
        let text = shape.closed().and_then(|curve| curve.to_text()).map_err(unwritten)?;
        let _ = write!(link, "&{key}=curve:{text}");
    }
    write_name(link, name_key, &name);
    Ok(())
}

fn write_name(link: &mut String, key: &str, name: &str) {
    if !name.is_empty() {
        let _ = write!(link, "&{key}={}", escape(name));
    }
}

/// The name under a key, tidied; none where there is none.
fn read_name<'a>(get: &impl Fn(&str) -> Option<&'a str>, key: &str) -> Option<String> {
    get(key).map(unescape).map(|name| tidy(&name)).filter(|name| !name.is_empty())
}

/// The closed curves of a link: both or none.
pub(super) fn read_curves<'a>(
    get: &impl Fn(&str) -> Option<&'a str>,
    fit: Option<&Fit>,
) -> Result<Option<Curves>, LinkError> {
    let without = |[key, ..]: Keys, [other, ..]: Keys| {
        Err(LinkError::Value { key, value: format!("left out beside “{other}”") })
    };
    let fitted = taken(fit);
    let a = read_curve(get, A, &given(&fitted, None))?;
    let b = read_curve(get, B, &given(&fitted, a.as_ref()))?;
    match (a, b) {
        (Some(a), Some(b)) => Ok(Some(Curves { a, b })),
        (None, None) => Ok(None),
        (Some(_), None) => without(B, A),
        (None, Some(_)) => without(A, B),
    }
}

fn read_curve<'a>(
    get: &impl Fn(&str) -> Option<&'a str>,
    [key, name_key, _]: Keys,
    given: &Given<'_>,
) -> Result<Option<CurveShape>, LinkError> {
    let Some(text) = get(key) else { return Ok(None) };
    if let Some((_, shape)) = given.iter().flatten().find(|(word, _)| *word == text) {
        let name = read_name(get, name_key).unwrap_or_else(|| tidy(&shape.name));
        return Ok(Some(CurveShape { preset: None, name, ..(*shape).clone() }));
    }
    let name = || read_name(get, name_key).unwrap_or_else(|| "Own curve".to_owned());
    if let Some(word) = text.strip_prefix("spline:") {
        let spline = Some(word.to_owned()).filter(|word| is_spline_word(word));
        let spline = Some(spline.ok_or_else(|| damaged(key, text))?);
        return Ok(Some(CurveShape { name: name(), spline, ..CurveShape::default() }));
    }
    let Some(word) = text.strip_prefix("curve:") else {
        return gallery(text).map(Some).ok_or_else(|| damaged(key, text));
    };
    let curve = ClosedCurve::from_text(word)
        .map_err(|error| LinkError::Value { key, value: as_a("read as a curve", &error) })?;
    Ok(Some(CurveShape { name: name(), curve: Curve::from(&curve), ..CurveShape::default() }))
}

pub(super) fn write_fit(link: &mut String, fit: &Fit) -> Result<(), LinkError> {
    let (mode, model) = (name_of(&MODES, &fit.mode), name_of(&MODELS, &fit.model));
    let _ = write!(link, "&fit={mode}:{model},{},{}", fit.numbers, number(fit.smoothing));
    if let Some(curve) = &fit.curve {
        write_curve(link, FITTED, curve, NONE)?;
    }
    if fit.bytes != USUAL_BYTES {
        let _ = write!(link, "&bytes={}", fit.bytes);
    }
    if let Some(shape) = &fit.spline {
        if !shape.is_word() {
            return Err(damaged(SPLINE, &shape.word));
        }
        let _ = write!(link, "&{SPLINE}={}", shape.word);
        write_name(link, SPLINE_NAME, &tidy(&shape.name));
    }
    if let Some(graph) = &fit.graph {
        let piece = |piece: &GraphPiece| numbers(&[&piece.map[..], &piece.domain[..]].concat());
        let pieces: Vec<String> = graph.pieces.iter().map(piece).collect();
        let _ = write!(link, "&graph={}:{}", name_of(&KINDS, &graph.kind), joined(&pieces, ";"));
    }
    if let Some(word) = &fit.plane {
        if !is_plane_word(word) {
            return Err(damaged(PLANE, word));
        }
        let _ = write!(link, "&{PLANE}={word}");
    }
    Ok(())
}

pub(super) fn read_fit<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Option<Fit>, LinkError> {
    let (curve, graph, plane) = (read_curve(get, FITTED, NONE)?, read_graph(get)?, read_plane(get)?);
    let (bytes, spline) = (read_bytes(get)?, read_spline(get)?);
    let Some(text) = get("fit") else {
        let mode = match (&graph, &plane) {
            (Some(_), _) => FitMode::Graph,
            (None, Some(_)) => FitMode::Plane,
            (None, None) => FitMode::Outline,
        };
        let found = curve.is_some() || spline.is_some() || graph.is_some() || plane.is_some();
        let model = if curve.is_none() && spline.is_some() { FitModel::Spline } else { FitModel::Closed };
        return Ok(found.then(|| Fit { mode, model, bytes, curve, spline, graph, plane, ..Fit::default() }));
    };
    let bad = || damaged("fit", text);
    let (mode, rest) = text.split_once(':').ok_or_else(bad)?;
    let (model, rest) = rest.split_once(',').ok_or_else(bad)?;
    let [count, smoothing] = read_numbers::<2>("fit", rest)?;
    let numbers = count as u32;
    if f64::from(numbers) != count || !NUMBERS.contains(&numbers) || !(0.0..=1.0).contains(&smoothing) {
        return Err(bad());
    }
    let mode = choice("fit", Some(mode), &MODES)?;
    let model = choice("fit", Some(model), &MODELS)?;
    Ok(Some(Fit { mode, model, numbers, bytes, smoothing, curve, spline, graph, plane }))
}

fn read_bytes<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<u32, LinkError> {
    let Some(text) = get("bytes") else { return Ok(USUAL_BYTES) };
    text.parse().ok().filter(|bytes| BYTES.contains(bytes)).ok_or_else(|| damaged("bytes", text))
}

fn read_spline<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Option<SplineShape>, LinkError> {
    let Some(word) = get(SPLINE) else { return Ok(None) };
    let name = read_name(get, SPLINE_NAME).unwrap_or_else(|| "Own curve".to_owned());
    let shape = SplineShape { name, word: word.to_owned() };
    if shape.is_word() { Ok(Some(shape)) } else { Err(damaged(SPLINE, word)) }
}

fn read_graph<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Option<Graph>, LinkError> {
    let Some(text) = get("graph") else { return Ok(None) };
    let (kind, list) = text.split_once(':').ok_or_else(|| damaged("graph", text))?;
    let kind = choice("graph", Some(kind), &KINDS)?;
    let rows = read_list::<7>("graph", list, MAX_PIECES, |_| true)?;
    let piece =
        |&[a, b, c, d, e, from, to]: &[f64; 7]| GraphPiece { map: [a, b, c, d, e], domain: [from, to] };
    let graph = Graph { kind, pieces: rows.iter().map(piece).collect() };
    match graph.function() {
        Ok(_) => Ok(Some(graph)),
        Err(error) => Err(LinkError::Value { key: "graph", value: as_a("drawn", &error) }),
    }
}

fn read_plane<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> Result<Option<String>, LinkError> {
    let Some(word) = get(PLANE) else { return Ok(None) };
    if is_plane_word(word) { Ok(Some(word.to_owned())) } else { Err(damaged(PLANE, word)) }
}
