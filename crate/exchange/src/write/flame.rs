//! `.flame` files, which are linear throughout.

use frond_core::{Affine2, Hull, Ifs};
use quick_xml::escape::escape;

use crate::colour::{Rgb, hex};
use crate::number::decimal;
use crate::read::flame::{OWN_VERSION, turned_over};
use crate::system::{Row, System};

/// Pixels of the picture that it asks for.
const SIZE: f64 = 1000.0;

pub fn write(system: &System, rows: &[Row]) -> String {
    let ifs = Ifs::new(rows.iter().map(|&row| Affine2::from_row(row)).collect());
    // Where it lies, so that all of it is seen.
    let (centre, scale) = ifs.map_or((glam::DVec2::ZERO, SIZE / 4.0), |ifs| {
        let hull = Hull::of(&ifs);
        let size = hull.max() - hull.min();
        (0.5 * hull.min() + 0.5 * hull.max(), 0.9 * SIZE / size.max_element().max(1e-300))
    });
    let name = system.title();
    let mut text = format!(
        "<flames name=\"Frond\">\n<flame name=\"{}\" version=\"{OWN_VERSION}\" size=\"{SIZE} {SIZE}\" center=\"{} {}\" scale=\"{}\" \
         background=\"0 0 0\" brightness=\"4\" gamma=\"4\">\n",
        escape(name.as_str()),
        decimal(centre.x),
        decimal(0.0 - centre.y),
        decimal(scale),
    );
    let places: Vec<f64> = (0..rows.len()).map(|k| place(k, rows.len())).collect();
    for (k, (&row, weight)) in rows.iter().zip(system.weights()).enumerate() {
        let [a, b, c, d, e, f] = turned_over(row).map(decimal);
        text.push_str(&format!(
            "   <xform weight=\"{}\" color=\"{:.4}\" linear=\"1\" coefs=\"{a} {c} {b} {d} {e} {f}\"/>\n",
            decimal(weight),
            places[k],
        ));
    }
    if system.colours.len() == rows.len() {
        text.push_str(&palette(&places, &system.colours));
    }
    text.push_str("</flame>\n</flames>\n");
    text
}

/// Where a map is on the palette, from 0 to 1, with as many digits as are written.
fn place(k: usize, count: usize) -> f64 {
    (1e4 * k as f64 / (count - 1).max(1) as f64).round() / 1e4
}

/// A palette that has these colours at these places, and goes evenly from one to the next.
fn palette(places: &[f64], colours: &[Rgb]) -> String {
    let anchors: Vec<usize> = places.iter().map(|place| (255.0 * place).round() as usize).collect();
    let mut text = "   <palette count=\"256\" format=\"RGB\">\n".to_owned();
    for at in 0..256 {
        let next = anchors.partition_point(|&anchor| anchor < at).min(anchors.len() - 1);
        let before = if anchors[next] > at { next.saturating_sub(1) } else { next };
        let span = anchors[next].saturating_sub(anchors[before]).max(1) as f64;
        let gone = (at.min(anchors[next]) - anchors[before]) as f64 / span;
        let mix = |k: usize| {
            let [from, to] = [before, next].map(|i| f64::from(colours[i][k]));
            (from + gone * (to - from)).round() as u8
        };
        let digits = hex([mix(0), mix(1), mix(2)]);
        text.push_str(&digits[1..]);
        if at % 8 == 7 {
            text.push('\n');
        }
    }
    text.push_str("   </palette>\n");
    text
}
