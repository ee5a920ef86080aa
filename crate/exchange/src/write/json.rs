//! JSON, a map a line.

use crate::number::decimal;
use crate::system::System;

pub fn write(system: &System) -> String {
    let list = |numbers: &[f64]| {
        let words: Vec<String> = numbers.iter().map(|&x| decimal(x)).collect();
        format!("[{}]", words.join(", "))
    };
    let rows: Vec<String> = system.maps.rows().into_iter().map(|row| format!("    {}", list(row))).collect();
    let mut fields = Vec::new();
    if !system.name.is_empty() {
        fields.push(format!("  \"name\": {}", serde_json::Value::from(system.name.as_str())));
    }
    fields.push(format!("  \"maps\": [\n{}\n  ]", rows.join(",\n")));
    if !system.probabilities.is_empty() {
        fields.push(format!("  \"probabilities\": {}", list(&system.probabilities)));
    }
    format!("{{\n{}\n}}\n", fields.join(",\n"))
}
