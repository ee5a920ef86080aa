//! TikZ: the pieces of the shape of one size, and the parallelograms that the maps make of its box.

use frond_core::Affine2;
use glam::DVec2;

use super::pieces::Pieces;
use crate::system::{Row, System};

/// The most pieces of a figure.
const MAX_PIECES: usize = 1500;
/// The longer side of the figure, in centimetres.
const SIDE: f64 = 8.0;

pub fn write(system: &System, rows: &[Row]) -> Option<String> {
    let shape = Pieces::of(rows, MAX_PIECES)?;
    let scale = SIDE / (shape.max - shape.min).max_element().max(1e-300);
    let polygon = |map: &Affine2, corners: &[DVec2]| {
        let corner = |p: &DVec2| {
            let at = (map.apply(*p) - shape.min) * scale;
            // No sign before what is rounded to zero.
            format!("({:.3},{:.3})", at.x + 0.0, at.y + 0.0).replace("-0.000", "0.000")
        };
        corners.iter().map(corner).collect::<Vec<_>>().join(" -- ") + " -- cycle"
    };
    let mut text = format!(
        "% {}. Needs \\usepackage{{tikz}}.\n\\begin{{tikzpicture}}[line width=0.2pt, line join=round]\n",
        system.title().replace('%', "")
    );
    // A circle of hues: one for each map.
    for k in 0..rows.len() {
        text.push_str(&format!(
            "  \\definecolor{{frond{}}}{{hsb}}{{{:.3},0.65,0.75}}\n",
            k + 1,
            k as f64 / rows.len() as f64
        ));
    }
    for (map, first) in &shape.pieces {
        let colour = first + 1;
        text.push_str(&format!("  \\filldraw[frond{colour}] {};\n", polygon(map, &shape.outline)));
    }
    text.push_str("  % The maps, as what they make of the box around the shape.\n");
    for map in &shape.maps {
        text.push_str(&format!("  \\draw[gray, thin] {};\n", polygon(map, &shape.corners())));
    }
    text.push_str("\\end{tikzpicture}\n");
    Some(text)
}
