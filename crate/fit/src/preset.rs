//! Closed curves to begin with.

use glam::DVec2;

use crate::closed::{ArcCopy, ClosedCurve};

/// A closed curve of the gallery.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePreset {
    /// A name that does not change, for programs.
    pub id: &'static str,
    /// What it is called.
    pub name: &'static str,
    /// What it is, in a sentence.
    pub about: &'static str,
    /// The curve, counter-clockwise.
    pub curve: ClosedCurve,
}

/// The curve of this id: one of the gallery, or one that was in it once. Its id then stands in links.
#[must_use]
pub fn curve_preset(id: &str) -> Option<CurvePreset> {
    match id {
        "maple" => baked("maple", "Maple leaf", "A star of five lobes.", include_bytes!("preset/maple.bin")),
        "oak" => baked("oak", "Oak leaf", "Pointed lobes.", include_bytes!("preset/oak.bin")),
        _ => curve_presets().into_iter().find(|preset| preset.id == id),
    }
}

fn baked(id: &'static str, name: &'static str, about: &'static str, bytes: &[u8]) -> Option<CurvePreset> {
    ClosedCurve::from_bytes(bytes).ok().map(|curve| CurvePreset { id, name, about, curve })
}

/// The gallery of closed curves: a maple leaf, an oak leaf, Koch's snowflake and an island.
///
/// All but the snowflake are fits of 260 numbers to [`sugar_maple`](crate::sugar_maple)(1),
/// [`white_oak`](crate::white_oak)(1) and [`island`](crate::island)(4), made by `examples/bake.rs`.
#[must_use]
pub fn curve_presets() -> Vec<CurvePreset> {
    [
        baked(
            "sugar-maple",
            "Maple leaf",
            "A leaf of five lobes with pointed teeth, as sugar maples have.",
            include_bytes!("preset/sugar-maple.bin"),
        ),
        baked(
            "white-oak",
            "Oak leaf",
            "Round lobes and narrow bays, as white oaks have them.",
            include_bytes!("preset/white-oak.bin"),
        ),
        Some(CurvePreset {
            id: "snowflake",
            name: "Snowflake",
            about: "Koch's curve three times round: every edge is a copy of the four edges of its side, a third as long.",
            curve: snowflake(),
        }),
        baked(
            "island",
            "Island",
            "A coast that is as rough however near it is seen.",
            include_bytes!("preset/island.bin"),
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Three of Koch's curves: 12 knots, each edge a copy of the four of its side.
fn snowflake() -> ClosedCurve {
    let corner = |side: u32| DVec2::from_angle((90.0 + 120.0 * f64::from(side)).to_radians());
    let mut knots = Vec::with_capacity(12);
    for side in 0..3 {
        let (a, b) = (corner(side), corner(side + 1));
        let third = (b - a) / 3.0;
        let tip = a + third + DVec2::from_angle(-std::f64::consts::FRAC_PI_3).rotate(third);
        knots.extend([a, a + third, tip, b - third]);
    }
    let copy = |edge: usize| Some(ArcCopy { from: edge / 4 * 4, span: 4, reversed: false, c: 1.0 });
    ClosedCurve { knots, edges: (0..12).map(copy).collect() }
}
