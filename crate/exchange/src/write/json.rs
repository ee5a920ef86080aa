//! JSON, a map a line.

use crate::system::System;

pub fn write(system: &System) -> String {
    // Numbers and texts are always written.
    let text = |value: &dyn Fn() -> serde_json::Result<String>| value().unwrap_or_default();
    let mut lines = vec!["{".to_owned()];
    if !system.name.is_empty() {
        lines.push(format!("  \"name\": {},", text(&|| serde_json::to_string(&system.name))));
    }
    let rows: Vec<String> = system
        .maps
        .rows()
        .into_iter()
        .map(|row| format!("    {}", text(&|| serde_json::to_string(row))))
        .collect();
    lines.push(format!(
        "  \"maps\": [\n{}\n  ]{}",
        rows.join(",\n"),
        if system.probabilities.is_empty() { "" } else { "," }
    ));
    if !system.probabilities.is_empty() {
        lines
            .push(format!("  \"probabilities\": {}", text(&|| serde_json::to_string(&system.probabilities))));
    }
    lines.push("}\n".into());
    lines.join("\n")
}
