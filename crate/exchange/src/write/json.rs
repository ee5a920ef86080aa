//! JSON, a map a line.

use crate::colour::hex;
use crate::number::decimal;
use crate::system::System;
use crate::text::name_or;

pub fn write(system: &System) -> String {
    let list = |numbers: &[f64]| {
        let words: Vec<String> = numbers.iter().map(|&x| decimal(x)).collect();
        format!("[{}]", words.join(", "))
    };
    let rows: Vec<String> = system.maps.rows().into_iter().map(|row| format!("    {}", list(row))).collect();
    let mut fields = Vec::new();
    // In one line: a letter that steers a machine makes a file no text.
    let name = name_or(&system.name, "");
    if !name.is_empty() {
        fields.push(format!("  \"name\": {}", serde_json::Value::from(name)));
    }
    fields.push(format!("  \"maps\": [\n{}\n  ]", rows.join(",\n")));
    // Zeros alone say nothing, and would be left out again.
    if system.probabilities.iter().any(|weight| *weight > 0.0) {
        fields.push(format!("  \"probabilities\": {}", list(&system.probabilities)));
    }
    if !system.colours.is_empty() && system.colours.len() == system.maps.len() {
        let words: Vec<String> = system.colours.iter().map(|&one| format!("\"{}\"", hex(one))).collect();
        fields.push(format!("  \"colours\": [{}]", words.join(", ")));
    }
    format!("{{\n{}\n}}\n", fields.join(",\n"))
}
