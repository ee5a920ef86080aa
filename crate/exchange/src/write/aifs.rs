//! Programs of IFStile: a row of numbers a map.

use crate::number::decimal;
use crate::system::{Maps, System};
use crate::text::name_or;

pub fn write(system: &System) -> String {
    let size = if matches!(system.maps, Maps::Space(_) | Maps::Objects(_)) { 3 } else { 2 };
    // A line of its own, and no remark.
    let name = name_or(&system.name, "").replace('#', "");
    let mut text = String::from("@\n");
    if !name.is_empty() {
        text.push_str(&format!("$n={name}\n"));
    }
    text.push_str(&format!("$dim={size}\n"));
    let map = |row: &[f64]| {
        let list = |numbers: &[f64]| numbers.iter().map(|&x| decimal(x)).collect::<Vec<_>>().join(",");
        let (matrix, shift) = row.split_at(size * size);
        format!("[{}]*[{}]", list(shift), list(matrix))
    };
    let mut count = 0;
    let mut define = |row: &[f64], text: &mut String| {
        text.push_str(&format!("h{count}={}\n", map(row)));
        count += 1;
        format!("h{}", count - 1)
    };
    let mut equations = String::new();
    match &system.maps {
        Maps::Directed(states) => {
            equations.push_str("$root=A0\n");
            for (k, copies) in states.iter().enumerate() {
                let images: Vec<String> = copies
                    .iter()
                    .map(|copy| format!("{}*A{}", define(&copy.map, &mut text), copy.from))
                    .collect();
                equations.push_str(&format!("A{k}={}\n", images.join("|")));
            }
        }
        Maps::Objects(objects) => {
            let names: Vec<String> = (0..objects.len()).map(|k| format!("A{k}")).collect();
            equations.push_str(&format!("$root=A\nA={}\n", names.join("|")));
            for (rows, name) in objects.iter().zip(&names) {
                let maps: Vec<String> = rows.iter().map(|row| define(row, &mut text)).collect();
                equations.push_str(&format!("{name}=({})*{name}\n", maps.join("|")));
            }
        }
        maps => {
            let names: Vec<String> = maps.rows().into_iter().map(|row| define(row, &mut text)).collect();
            equations.push_str(&format!("A=({})*A\n", names.join("|")));
        }
    }
    text + &equations
}
