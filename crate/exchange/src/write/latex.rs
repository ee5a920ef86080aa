//! LaTeX: the maps as matrices.

use crate::number::Number;
use crate::system::{Maps, System};

pub fn write(system: &System) -> String {
    let size = match system.maps {
        Maps::Plane(_) | Maps::Directed(_) => 2,
        Maps::Space(_) | Maps::Objects(_) => 3,
    };
    let matrix = |numbers: &[f64], columns: usize| {
        let rows: Vec<String> = numbers
            .chunks(columns)
            .map(|row| row.iter().map(|&x| Number::of(x).tex()).collect::<Vec<_>>().join(" & "))
            .collect();
        format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", rows.join(" \\\\ "))
    };
    let lines: Vec<String> = system
        .maps
        .rows()
        .into_iter()
        .enumerate()
        .map(|(k, row)| {
            let (linear, shift) = row.split_at(size * size);
            format!("  f_{{{}}}(x) &= {} x + {}", k + 1, matrix(linear, size), matrix(shift, 1))
        })
        .collect();
    let name: String = system.title().chars().filter(|c| !matches!(c, '\\' | '{' | '}')).collect();
    format!(
        "% {name}. Needs \\usepackage{{amsmath}}.\n\\begin{{align*}}\n{}\n\\end{{align*}}\n",
        lines.join(" \\\\[2pt]\n")
    )
}
