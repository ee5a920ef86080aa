//! Fractint's `.ifs` files.

use crate::number::decimal;
use crate::read::fractint::SpaceFile;
use crate::system::{Maps, System};
use crate::text::name_or;

/// Writes a system of space as Fractint reads it. Numbers come back to the last bit.
#[must_use]
pub fn write_ifs3(file: &SpaceFile) -> String {
    let mut system = System::space(file.name.clone(), file.maps.clone());
    // One for each map, or none: they are not handed to other maps.
    system.probabilities.clone_from(&file.probabilities);
    if !system.has_sound_weights() {
        system.probabilities.clear();
    }
    write(&system)
}

pub fn write(system: &System) -> String {
    let word = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' };
    let name: String = name_or(&system.name, "").chars().map(word).collect();
    // Fractint would take it for words.
    let name =
        if name.is_empty() || name.eq_ignore_ascii_case("comment") { format!("unnamed{name}") } else { name };
    let sign = if matches!(system.maps, Maps::Space(_)) { " (3D)" } else { "" };
    let mut text = format!("{name}{sign} {{\n");
    for (row, weight) in system.maps.rows().into_iter().zip(system.weights()) {
        for x in row.iter().chain([&weight]) {
            text.push(' ');
            text.push_str(&decimal(*x));
        }
        text.push('\n');
    }
    text.push_str("}\n");
    text
}
