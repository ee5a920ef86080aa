//! Maps as equations: `f(x, y) = (0.85x + 0.04y, -0.04x + 0.85y + 1.6)`, or x' = .., y' = .. in one line.

use crate::formula::{Form, form};

/// More equal signs than that are in no such line.
const MOST_PARTS: usize = 3;

/// The six numbers of a map that a line has as two formulas of x and y.
pub fn equation(line: &str) -> Option<Vec<f64>> {
    if !line.contains(['x', 'y']) || !line.contains([',', ';']) {
        return None;
    }
    let line = line.trim().trim_end_matches(['.', ',', ';']);
    let right = if line.matches('=').count() == 1 { line.split_once('=')?.1 } else { line };
    let parts = parts(within_brackets(right.trim()))?;
    let [x, y] = parts[..] else { return None };
    let side = |part: &str| form(part.rsplit_once('=').map_or(part, |(_, right)| right));
    let (x, y) = (side(x)?, side(y)?);
    let is_constant = |form: Form| form.x == 0.0 && form.y == 0.0;
    let names = Form { x: 1.0, y: 0.0, k: 0.0 };
    // Names of columns are no map, and two numbers alone are a point.
    (x != names && (!is_constant(x) || !is_constant(y))).then(|| vec![x.x, x.y, y.x, y.y, x.k, y.k])
}

/// What stands in brackets, where they are around all of it.
fn within_brackets(text: &str) -> &str {
    let mut depth = 0_usize;
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => {
                depth = depth.saturating_sub(1);
                if depth == 0 && at + 1 < text.len() {
                    return text;
                }
            }
            _ if depth == 0 => return text,
            _ => {}
        }
    }
    text.get(1..text.len().saturating_sub(1)).unwrap_or(text)
}

/// What commas and semicolons part outside brackets.
fn parts(text: &str) -> Option<Vec<&str>> {
    let (mut depth, mut start, mut parts) = (0_usize, 0, Vec::new());
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            ',' | ';' if depth == 0 => {
                parts.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
        if parts.len() > MOST_PARTS {
            return None;
        }
    }
    parts.push(&text[start..]);
    Some(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_read_from_their_formulas() {
        for line in [
            "f2(x, y) = (0.85x + 0.04y, -0.04x + 0.85y + 1.6)",
            "f2 = 0.85*x + 0.04*y, \u{2212}0.04*x + 0.85*y + 1.6",
            "x' = 0.85x + 0.04y; y' = 1.6 + 0.85y - 0.04x",
            "(0.85x + 0.04y, -0.04x + 0.85y + 8/5),",
        ] {
            assert_eq!(equation(line), Some(vec![0.85, 0.04, -0.04, 0.85, 0.0, 1.6]), "{line}");
        }
        for line in ["x,y", "leaf,area,x,y", "x, y, z", "f(x, y) = (1, 2)", "x = (1", "x²,y", "()xy,", "1,2"]
        {
            assert_eq!(equation(line), None, "{line}");
        }
    }
}
