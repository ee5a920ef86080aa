//! Desmos: a function for each map, and lists of points, each the images of the one before.

use super::depth::depth;
use crate::number::Number;
use crate::system::Row;

/// The most points of the last list: Desmos takes ten thousand.
const MAX_POINTS: usize = 8000;

pub fn write(rows: &[Row]) -> String {
    let mut lines: Vec<String> = rows
        .iter()
        .enumerate()
        .map(|(k, row)| {
            let [a, b, c, d, e, f] = row.map(|x| Number::of(x).tex());
            let line = |x: &str, y: &str, shift: &str| {
                format!("\\left({x}\\right)p.x+\\left({y}\\right)p.y+\\left({shift}\\right)")
            };
            format!(
                "f_{{{}}}\\left(p\\right)=\\left({},{}\\right)",
                k + 1,
                line(&a, &b, &e),
                line(&c, &d, &f)
            )
        })
        .collect();
    lines.push("A_{0}=\\left[\\left(0,0\\right)\\right]".into());
    for k in 0..depth(rows.len(), MAX_POINTS) {
        let images: Vec<String> =
            (1..=rows.len()).map(|map| format!("f_{{{map}}}\\left(A_{{{k}}}\\right)")).collect();
        // One list alone cannot be joined.
        let joined = match &images[..] {
            [only] => only.clone(),
            _ => format!("\\operatorname{{join}}\\left({}\\right)", images.join(",")),
        };
        lines.push(format!("A_{{{}}}={joined}", k + 1));
    }
    lines.join("\n") + "\n"
}
