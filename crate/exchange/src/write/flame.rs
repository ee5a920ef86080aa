//! `.flame` files, which are linear throughout.

use frond_core::{Affine2, Hull, Ifs};
use quick_xml::escape::escape;

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
        (0.5 * (hull.min() + hull.max()), 0.9 * SIZE / size.max_element().max(1e-6))
    });
    let name = system.title();
    let mut text = format!(
        "<flames name=\"Frond\">\n<flame name=\"{}\" version=\"{OWN_VERSION}\" size=\"{SIZE} {SIZE}\" center=\"{:.6} {:.6}\" scale=\"{:.4}\" \
         background=\"0 0 0\" brightness=\"4\" gamma=\"4\">\n",
        escape(name.as_str()),
        centre.x,
        -centre.y,
        scale,
    );
    let colours = (rows.len() - 1).max(1) as f64;
    for (k, (&row, weight)) in rows.iter().zip(system.weights()).enumerate() {
        let [a, b, c, d, e, f] = turned_over(row).map(decimal);
        text.push_str(&format!(
            "   <xform weight=\"{}\" color=\"{:.4}\" linear=\"1\" coefs=\"{a} {c} {b} {d} {e} {f}\"/>\n",
            decimal(weight),
            k as f64 / colours,
        ));
    }
    text.push_str("</flame>\n</flames>\n");
    text
}
