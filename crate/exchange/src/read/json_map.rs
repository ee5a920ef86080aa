//! A map as JSON has it: a row of numbers, an object with its letters, a matrix with a shift, or two formulas of x
//! and y.

use serde_json::{Map, Value};

use crate::formula::{Form, form, value};
use crate::text::number;

/// A map of six numbers or twelve, and its weight.
pub struct JsonMap {
    pub row: Vec<f64>,
    pub weight: Option<f64>,
}

/// More numbers than any map has.
const MOST: usize = 13;
/// The letters of maps of the plane and of space; of space the last three are the shift.
const LETTERS: [&str; 12] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"];
const WEIGHTS: [&str; 8] = ["p", "prob", "probability", "weight", "w", "pi", "percent", "chance"];
const MATRICES: [&str; 5] = ["matrix", "linear", "m", "A", "coefs"];
const SHIFTS: [&str; 7] = ["translation", "translate", "shift", "offset", "vector", "t", "b"];

/// A number, or a formula of numbers in a text.
pub fn number_of(value_of: &Value) -> Option<f64> {
    match value_of {
        Value::Number(number) => number.as_f64().filter(|x| x.is_finite()),
        Value::String(text) => {
            let text = text.trim();
            number(text).or_else(|| value(text))
        }
        _ => None,
    }
}

fn numbers(list: &[Value]) -> Option<Vec<f64>> {
    if list.len() > MOST { None } else { list.iter().map(number_of).collect() }
}

/// Reads a map; None where it is none.
pub fn read_map(value: &Value) -> Option<JsonMap> {
    match value {
        Value::Array(list) => of_list(list),
        Value::Object(fields) => of_object(fields),
        _ => None,
    }
}

fn of_row(row: &[f64]) -> Option<JsonMap> {
    let size = if row.len() > 7 { 12 } else { 6 };
    if row.len() != size && row.len() != size + 1 {
        return None;
    }
    let weight = row.get(size).copied();
    Some(JsonMap { row: row[..size].to_vec(), weight })
}

fn of_list(list: &[Value]) -> Option<JsonMap> {
    if let Some(row) = numbers(list) {
        return of_row(&row);
    }
    if let Some(row) = of_rows(list) {
        return Some(JsonMap { row, weight: None });
    }
    // A weight and two formulas, or the two alone.
    let (first, rest) = list.split_first()?;
    let (weight, forms) = match number_of(first) {
        Some(weight) if list.len() > 1 => (Some(weight), rest),
        _ => (None, list),
    };
    let (x, y) = match forms {
        [Value::String(both)] => both.trim_matches(['(', ')']).split_once(',')?,
        [Value::String(x), Value::String(y)] => (x.as_str(), y.as_str()),
        _ => return None,
    };
    Some(JsonMap { row: of_forms(form(x)?, form(y)?), weight })
}

fn of_forms(x: Form, y: Form) -> Vec<f64> {
    vec![x.x, x.y, y.x, y.y, x.k, y.k]
}

/// Rows of a matrix: two of three, with the shift in the last column, perhaps above 0 0 1, or two of the matrix and one
/// of the shift.
fn of_rows(list: &[Value]) -> Option<Vec<f64>> {
    if list.len() > 4 {
        return None;
    }
    let rows: Vec<Vec<f64>> = list.iter().map(|row| numbers(row.as_array()?)).collect::<Option<_>>()?;
    let row: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
    match row[..] {
        [&[a, b, e], &[c, d, f]] | [&[a, b, e], &[c, d, f], &[0.0, 0.0, 1.0]] => Some(vec![a, b, c, d, e, f]),
        [&[a, b], &[c, d], &[e, f]] => Some(vec![a, b, c, d, e, f]),
        _ => None,
    }
}

fn of_object(fields: &Map<String, Value>) -> Option<JsonMap> {
    let field = |names: &[&str]| names.iter().find_map(|name| fields.get(*name));
    let letter =
        |name: &&str| fields.get(*name).or_else(|| fields.get(&name.to_uppercase())).and_then(number_of);
    let weight = field(&WEIGHTS).and_then(number_of);
    let solid = fields.contains_key("l");
    let letters: Option<Vec<f64>> = LETTERS[..if solid { 12 } else { 6 }].iter().map(letter).collect();
    if let Some(row) = letters {
        return Some(JsonMap { row, weight });
    }
    if let (Some(Value::String(x)), Some(Value::String(y))) = (field(&["x", "fx"]), field(&["y", "fy"])) {
        return Some(JsonMap { row: of_forms(form(x)?, form(y)?), weight });
    }
    let matrix = field(&MATRICES)?.as_array()?;
    let flat = numbers(matrix).or_else(|| {
        Some(matrix.iter().map(|row| numbers(row.as_array()?)).collect::<Option<Vec<_>>>()?.concat())
    });
    let shift = field(&SHIFTS).and_then(|shift| numbers(shift.as_array()?));
    match (flat, shift) {
        (Some(mut row), Some(shift)) if matches!((row.len(), shift.len()), (4, 2) | (9, 3)) => {
            row.extend(shift);
            Some(JsonMap { row, weight })
        }
        (_, None) => {
            let map = of_list(matrix)?;
            Some(JsonMap { weight: weight.or(map.weight), ..map })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_written_in_many_ways() {
        let row = [0.5, -0.25, 0.125, 0.75, 1.0, 2.0];
        for (text, weight) in [
            ("[0.5, -0.25, 0.125, 0.75, 1, 2]", None),
            ("[0.5, -0.25, 0.125, 0.75, 1, 2, 0.3]", Some(0.3)),
            (r#"["1/2", "-1/4", "1/8", "0.75", "cos(0)", "sqrt(4)"]"#, None),
            (r#"{"a": 0.5, "b": -0.25, "c": 0.125, "d": 0.75, "e": 1, "f": 2, "p": 0.3}"#, Some(0.3)),
            (r#"{"A": 0.5, "B": "-1/4", "C": 0.125, "D": 0.75, "E": 1, "F": 2, "weight": "3"}"#, Some(3.0)),
            ("[[0.5, -0.25, 1], [0.125, 0.75, 2]]", None),
            ("[[0.5, -0.25, 1], [0.125, 0.75, 2], [0, 0, 1]]", None),
            ("[[0.5, -0.25], [0.125, 0.75], [1, 2]]", None),
            (r#"{"matrix": [[0.5, -0.25], [0.125, 0.75]], "translation": [1, 2], "prob": 0.3}"#, Some(0.3)),
            (r#"{"matrix": [0.5, -0.25, 0.125, 0.75], "shift": [1, 2]}"#, None),
            (r#"["7", "0.5x - y/4 + 1, .125*x + .75*y + 2"]"#, Some(7.0)),
            (r#"["0.5x - y/4 + 1", ".125*x + .75*y + 2"]"#, None),
            (r#"{"x": "0.5*x - 0.25*y + 1", "y": "x/8 + 3y/4 + 2", "weight": 0.3}"#, Some(0.3)),
        ] {
            let value: Value = serde_json::from_str(text).unwrap();
            let found = read_map(&value).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((&found.row[..], found.weight), (&row[..], weight), "{text}");
        }
        for text in
            ["[1,2,3]", "{}", "3", "[]", "[[1,2],[3]]", r#"["x*y", "x"]"#, r#"{"a": 1, "b": 2}"#, "[[]]"]
        {
            let value: Value = serde_json::from_str(text).unwrap();
            assert!(read_map(&value).is_none(), "{text}");
        }
    }
}
