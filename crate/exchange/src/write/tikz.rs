//! TikZ: the pieces of the shape of one size, and the parallelograms that the maps make of its box.

use frond_core::{Affine2, Hull, Ifs, adaptive_cut};
use glam::DVec2;

use crate::system::{Row, System};

/// The most pieces of a figure, and the words that are looked at for them.
const MAX_PIECES: usize = 1500;
const MAX_WORDS: usize = 20_000;
/// The longer side of the figure, in centimetres.
const SIDE: f64 = 8.0;

pub fn write(system: &System, rows: &[Row]) -> Option<String> {
    let maps: Vec<Affine2> = rows.iter().map(|&row| Affine2::from_row(row)).collect();
    let ifs = Ifs::new(maps.clone()).ok()?;
    let hull = Hull::of(&ifs);
    let (min, max) = (hull.min(), hull.max());
    let scale = SIDE / (max - min).max_element().max(1e-9);
    let corners = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
    let parallelogram = |map: &Affine2| {
        let corner = |p: &DVec2| {
            let at = (map.apply(*p) - min) * scale;
            // No sign before what is rounded to zero.
            format!("({:.3},{:.3})", at.x + 0.0, at.y + 0.0).replace("-0.000", "0.000")
        };
        corners.iter().map(corner).collect::<Vec<_>>().join(" -- ") + " -- cycle"
    };
    let mut pieces = Vec::new();
    for step in 0..24 {
        let size = hull.diameter() * 0.5 * 0.8_f64.powi(step);
        let mut finer = Vec::new();
        let outcome = adaptive_cut(&ifs, size, MAX_WORDS, |map, first| {
            if finer.len() <= MAX_PIECES {
                finer.push((*map, first));
            }
        });
        if !outcome.complete || finer.len() > MAX_PIECES {
            break;
        }
        pieces = finer;
    }
    if pieces.is_empty() {
        pieces = maps.iter().copied().enumerate().map(|(k, map)| (map, k)).collect();
    }
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
    for (map, first) in &pieces {
        let colour = first + 1;
        text.push_str(&format!("  \\filldraw[frond{colour}] {};\n", parallelogram(map)));
    }
    text.push_str("  % The maps, as what they make of the box around the shape.\n");
    for map in &maps {
        text.push_str(&format!("  \\draw[gray, thin] {};\n", parallelogram(map)));
    }
    text.push_str("\\end{tikzpicture}\n");
    Some(text)
}
