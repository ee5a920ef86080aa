//! Curves that come from JavaScript.

use frond_fit::{
    CONTRACTION, ClosedCurve, CurveMorph, MAX_KNOTS, MAX_SPAN, MorphError, MorphedCurve, PackError,
    spectral_norm,
};
use frond_scene::Curve;
use js_sys::Reflect;
use wasm_bindgen::JsValue;

use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{longer_than, read};

/// What is wrong with a curve. Knots and edges count from 1 in messages.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    Few(usize),
    Edges { knots: usize, edges: usize },
    NotFinite(&'static str, usize),
    Arc { edge: usize, knots: usize },
    Growing { edge: usize, factor: f64 },
}

impl Fault {
    fn of(curve: &ClosedCurve) -> Option<Self> {
        let (knots, edges) = (curve.knots.len(), curve.edges.len());
        if knots < 3 {
            return Some(Self::Few(knots));
        }
        if knots != edges {
            return Some(Self::Edges { knots, edges });
        }
        if let Some(i) = curve.knots.iter().position(|p| !(p.x.abs() <= 1e100 && p.y.abs() <= 1e100)) {
            return Some(Self::NotFinite("Knot", i));
        }
        for (edge, copy) in curve.edges.iter().enumerate() {
            let Some(copy) = copy else { continue };
            if copy.c.is_nan() || copy.c.abs() > 1e100 {
                return Some(Self::NotFinite("Edge", edge));
            }
            if copy.from >= knots || copy.span < 2 || copy.span > MAX_SPAN || copy.span >= knots {
                return Some(Self::Arc { edge, knots });
            }
            let factor = curve.map(edge).map_or(0.0, |(linear, _)| spectral_norm(linear));
            if factor.is_nan() || factor > CONTRACTION * (1.0 + 1e-12) {
                return Some(Self::Growing { edge, factor });
            }
        }
        None
    }

    fn code(self) -> &'static str {
        match self {
            Self::Few(_) => "too-few-points",
            Self::Edges { .. } => "wrong-count",
            Self::NotFinite(..) => "not-finite",
            Self::Arc { .. } => "bad-arc",
            Self::Growing { .. } => "not-contractive",
        }
    }

    fn message(self) -> String {
        match self {
            Self::Few(count) => format!("The curve has {count} knots, and it needs three or more. Add some."),
            Self::Edges { knots, edges } => format!(
                "The curve has {knots} knots and {edges} edges. Give one edge a knot, null where it is straight."
            ),
            Self::NotFinite(what, index) => format!(
                "{what} {} holds a number that is not finite or is too large. Mend it or leave it out.",
                index + 1
            ),
            Self::Arc { edge, knots } => format!(
                "Edge {} copies an arc that is not there. Begin at a knot from 0 to {} and span 2 to {} edges.",
                edge + 1,
                knots - 1,
                MAX_SPAN.min(knots - 1)
            ),
            Self::Growing { edge, factor } => format!(
                "Edge {} would be its arc times {factor:.3}, and the most is {CONTRACTION}. Copy a longer arc, or make c smaller.",
                edge + 1
            ),
        }
    }
}

/// A curve that holds together.
pub(super) fn read_curve(value: &JsValue) -> Result<ClosedCurve, JsValue> {
    for key in ["knots", "edges"] {
        let list = Reflect::get(value, &key.into()).unwrap_or(JsValue::UNDEFINED);
        if longer_than(&list, MAX_KNOTS).is_some() {
            let error = PackError::TooManyKnots;
            return Err(failure(error.code(), &error.to_string()));
        }
    }
    let plain: Curve = read("The curve", value.clone())?;
    let curve = ClosedCurve::from(&plain);
    if let Some(fault) = Fault::of(&curve) {
        return Err(failure(fault.code(), &fault.message()));
    }
    if curve.is_sound() { Ok(curve) } else { Err(bad_input("The curve", "a copy does not shrink")) }
}

pub(super) fn of_morph(error: MorphError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// The curve alone.
pub(super) fn woven(curve: &ClosedCurve) -> Result<MorphedCurve, JsValue> {
    Ok(CurveMorph::new(curve, None).map_err(of_morph)?.at(0.0))
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may fail so")]
mod tests {
    use frond_fit::ArcCopy;
    use glam::DVec2;

    use super::*;

    fn hexagon() -> ClosedCurve {
        let mut curve = ClosedCurve::polygon(
            (0..6).map(|i| DVec2::from_angle(f64::from(i) * 1.0471975511965976)).collect(),
        );
        curve.edges[0] = Some(ArcCopy { from: 2, span: 3, reversed: true, c: -0.4 });
        curve
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert_eq!(Fault::of(&hexagon()), None);
        type Break = fn(&mut ClosedCurve);
        let breaks: [(Break, &str); 11] = [
            (|c| c.knots.truncate(2), "too-few-points"),
            (|c| c.edges.truncate(5), "wrong-count"),
            (|c| c.edges.push(None), "wrong-count"),
            (|c| c.knots[3].x = f64::NAN, "not-finite"),
            (|c| c.knots[5].y = -1e200, "not-finite"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { c: f64::NEG_INFINITY, ..copy }), "not-finite"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { from: 6, ..copy }), "bad-arc"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { span: 1, ..copy }), "bad-arc"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { span: usize::MAX, ..copy }), "bad-arc"),
            (|c| c.edges[0] = c.edges[0].map(|copy| ArcCopy { c: 2.0, ..copy }), "not-contractive"),
            (|c| c.knots[2] = c.knots[5], "not-contractive"),
        ];
        for (work, code) in breaks {
            let mut curve = hexagon();
            work(&mut curve);
            let fault = Fault::of(&curve).unwrap();
            assert_eq!(fault.code(), code);
            assert!(fault.message().len() > 30 && !curve.is_sound() || code == "not-finite");
        }
    }
}
