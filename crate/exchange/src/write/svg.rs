//! A drawing: the pieces of the shape of one size, a path for each map.

use std::fmt::Write as _;

use super::pieces::Pieces;
use crate::colour::hex;
use crate::system::{Row, System};

/// The most pieces of a drawing.
const MAX_PIECES: usize = 10_000;
/// The longer side, in pixels, and what is left free around.
const SIDE: f64 = 1000.0;
const MARGIN: f64 = 20.0;
/// One for each map, in turn; told apart by everybody, and clear on light and on dark ground.
const COLOURS: [&str; 8] =
    ["#c47800", "#0072b2", "#00835f", "#8f8500", "#2b7fb8", "#c04f00", "#a8558a", "#4a4f5a"];

pub fn write(system: &System, rows: &[Row]) -> Option<String> {
    let shape = Pieces::of(rows, MAX_PIECES)?;
    let extent = shape.max - shape.min;
    let scale = SIDE / extent.max_element().max(1e-300);
    let [width, height] = [extent.x, extent.y].map(|side| (side * scale + 2.0 * MARGIN).ceil());
    let (title, count) = (escaped(&system.title()), shape.pieces.len());
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <title>{title}</title>\n<desc>{count} pieces of one size in {} paths, one for each map. Made by Frond.</desc>\n\
         <g stroke-width=\"0.4\" stroke-linejoin=\"round\">\n",
        rows.len()
    );
    for letter in 0..rows.len() {
        let own = system.colours.get(letter).map(|&colour| hex(colour));
        let colour = own.as_deref().unwrap_or(COLOURS[letter % COLOURS.len()]);
        let _ = write!(text, "<path fill=\"{colour}\" stroke=\"{colour}\" d=\"");
        for (map, _) in shape.pieces.iter().filter(|(_, first)| *first == letter) {
            for (i, point) in shape.outline.iter().enumerate() {
                let at = (map.apply(*point) - shape.min) * scale;
                // y points down in a drawing.
                let (x, y) = (at.x + MARGIN, height - MARGIN - at.y);
                let _ = write!(text, "{}{x:.1} {y:.1}", if i == 0 { 'M' } else { 'L' });
            }
            text.push('Z');
        }
        text.push_str("\"/>\n");
    }
    text.push_str("</g>\n</svg>\n");
    Some(text)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_holds_as_many_pieces_as_it_says_and_stays_within_its_frame() {
        let gasket =
            [[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.0, 0.5, 0.25, 0.5]];
        let flat = [[0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0, 0.5, 0.0]];
        let point = [[0.0; 6]];
        for rows in [&gasket[..], &flat, &point] {
            let system = System::plane("A < B & C".to_owned(), rows.to_vec());
            let text = write(&system, rows).unwrap();
            assert!(text.contains("<title>A &lt; B &amp; C</title>"), "{}", &text[..200]);
            let said: usize =
                text.split("<desc>").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
            assert_eq!(text.matches('Z').count(), said);
            assert!((1..=MAX_PIECES).contains(&said));
            assert_eq!(text.matches("<path").count(), rows.len());
            let size = |name: &str| -> f64 {
                text.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
            };
            let (width, height) = (size("width"), size("height"));
            let paths: String =
                text.split(" d=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
            let numbers: Vec<f64> = paths
                .split(['M', 'L', 'Z', ' '])
                .filter(|x| !x.is_empty())
                .map(|x| x.parse().unwrap())
                .collect();
            for at in numbers.chunks(2) {
                assert!(at[0] >= MARGIN - 0.1 && at[0] <= width - MARGIN + 1.1, "{at:?}");
                assert!(at[1] >= MARGIN - 1.1 && at[1] <= height - MARGIN + 0.1, "{at:?}");
            }
        }
        let mut system = System::plane(String::new(), gasket.to_vec());
        system.colours = vec![[255, 0, 0], [0, 255, 0], [0, 0, 255]];
        assert!(write(&system, &gasket).unwrap().contains("<path fill=\"#00ff00\" stroke=\"#00ff00\""));
        // Of the gasket there are all pieces of some depth.
        let text = write(&System::plane(String::new(), gasket.to_vec()), &gasket).unwrap();
        assert!(text.contains("<desc>6561 pieces"), "{}", &text[..300]);
        assert!(write(&System::plane(String::new(), vec![]), &[[2.0, 0.0, 0.0, 2.0, 0.0, 0.0]]).is_none());
    }
}
