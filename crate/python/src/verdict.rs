//! Whether a shape is in one piece, and proofs of it that can be handed on.

use frond_check::{Certificate, CheckedProof, ConnectedCertificate, Proof};
use frond_core::{Affine2, Ifs, IfsError};
use frond_locus::{Connectedness, Options, Reason};
use pyo3::prelude::*;
use serde::Serialize;

use crate::cross::{Problem, Rows, compute, maps, read, system, write};

#[derive(Serialize)]
struct PlainLink<'a> {
    kind: &'static str,
    pair: (usize, usize),
    words: &'a [String; 2],
    at: [f64; 2],
    corners: Vec<[f64; 2]>,
}

impl<'a> PlainLink<'a> {
    fn of(link: &'a frond_locus::Link) -> Self {
        Self {
            kind: link.kind.name(),
            pair: link.pair,
            words: &link.words,
            at: link.at.to_array(),
            corners: link.corners.iter().map(|corner| corner.to_array()).collect(),
        }
    }
}

#[derive(Serialize)]
struct PlainReason<'a> {
    kind: &'static str,
    text: String,
    links: Vec<PlainLink<'a>>,
    assuming: &'a [String],
    neighbours: Option<usize>,
}

/// What is known of a shape, with the reason as JSON: its verdict, gap, overlaps, components, count, closest points,
/// diameter, nodes and reason.
type Told = (
    &'static str,
    (f64, f64),
    Vec<(usize, usize)>,
    Vec<usize>,
    usize,
    Option<[[f64; 2]; 2]>,
    f64,
    usize,
    Option<String>,
);

/// How finely and how long to look.
fn options((epsilon, budget): (Option<f64>, Option<usize>)) -> Options {
    let default = Options::default();
    Options { epsilon: epsilon.unwrap_or(default.epsilon), budget: budget.unwrap_or(default.budget) }
}

/// Whether an attractor is in one piece. Maps without an attractor get a verdict of their own.
#[pyfunction]
pub(crate) fn connectedness(
    py: Python<'_>,
    rows: Rows<'_>,
    asked: (Option<f64>, Option<usize>),
) -> PyResult<Told> {
    let maps = maps(&rows)?;
    compute(py, || match Ifs::new(maps) {
        Ok(ifs) => told(&frond_locus::connectedness(&ifs, &options(asked))),
        Err(IfsError::NoAttractor { .. } | IfsError::Unproved) => Ok((
            "no-attractor",
            (0.0, f64::INFINITY),
            Vec::new(),
            Vec::new(),
            0,
            None,
            f64::INFINITY,
            0,
            None,
        )),
        Err(error) => Err(error.into()),
    })
}

fn told(found: &Connectedness) -> Result<Told, Problem> {
    Ok((
        found.verdict.name(),
        (found.gap.lower, found.gap.upper),
        found.overlaps.clone(),
        found.components.clone(),
        found.count,
        found.closest.map(|(from, to)| [from.to_array(), to.to_array()]),
        found.diameter,
        found.nodes,
        found.reason.as_ref().map(told_reason).transpose()?,
    ))
}

fn told_reason(reason: &Reason) -> Result<String, Problem> {
    write(&PlainReason {
        kind: reason.kind.name(),
        text: reason.text(),
        links: reason.links.iter().map(PlainLink::of).collect(),
        assuming: &reason.assuming,
        neighbours: reason.neighbours,
    })
}

/// A certificate that the attractor is in several pieces, as JSON; none where that is not proved.
#[pyfunction]
pub(crate) fn certificate(
    py: Python<'_>,
    rows: Rows<'_>,
    asked: (Option<f64>, Option<usize>),
) -> PyResult<Option<String>> {
    let maps: Vec<Affine2> = maps(&rows)?;
    compute(py, || {
        let ifs = system(maps, None)?;
        let Some(found) = frond_locus::certificate(&ifs, &options(asked)) else { return Ok(None) };
        Ok(Some(write(&Certificate::from(found))?))
    })
}

/// A certificate that the attractor is in one piece, as JSON; none where none was found.
#[pyfunction]
pub(crate) fn connected_certificate(
    py: Python<'_>,
    rows: Rows<'_>,
    asked: (Option<f64>, Option<usize>),
) -> PyResult<Option<String>> {
    let maps: Vec<Affine2> = maps(&rows)?;
    compute(py, || {
        let ifs = system(maps, None)?;
        let Some(found) = frond_locus::connected_certificate(&ifs, &options(asked)) else { return Ok(None) };
        Ok(Some(write(&ConnectedCertificate::from(found))?))
    })
}

/// Replays a certificate of either kind, given as JSON: whether it is valid, what is to be said of it, its pairs, its
/// links, and the letters of its longest word.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, certificate: &str) -> PyResult<(bool, String, usize, usize, usize)> {
    compute(py, || {
        let value: serde_json::Value = read("The certificate", certificate)?;
        let proof = if value.get("links").is_none() {
            serde_json::from_value(value).map(Proof::Disconnected)
        } else {
            serde_json::from_value(value).map(Proof::Connected)
        };
        let checked = match proof {
            Err(error) => Err(format!("The certificate is not of the right form: {error}.")),
            Ok(proof) => proof.check().map_err(|refused| refused.to_string()),
        };
        Ok(match checked {
            Ok(found) => {
                let text = found.to_string();
                match found {
                    CheckedProof::Disconnected(found) => (true, text, found.pairs, 0, found.longest),
                    CheckedProof::Connected(found) => (true, text, 0, found.links, found.longest),
                }
            }
            Err(text) => (false, text, 0, 0, 0),
        })
    })
}
