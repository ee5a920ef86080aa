//! Which shapes are proved to be in one piece, by which reason, and which would be if their numbers meant what they come
//! near.

use frond_core::{Affine2, Ifs};
use frond_locus::{Connectedness, Options, connectedness};

fn answer(rows: &[[f64; 6]]) -> Connectedness {
    let maps = rows.iter().copied().map(Affine2::from_row).collect();
    connectedness(&Ifs::new(maps).unwrap(), &Options { epsilon: 1e-6, ..Options::default() })
}

fn line(name: &str, found: &Connectedness) -> String {
    let reason = found.reason.as_ref().map_or("no reason".to_owned(), |reason| {
        let links: Vec<String> = reason.links.iter().map(|link| link.words.join("=")).collect();
        format!(
            "{} {:?} {} | {}",
            reason.kind.name(),
            reason.neighbours,
            links.join(" "),
            reason.assuming.join(", ")
        )
    });
    format!("{name}: {} by {reason} [{}]", found.verdict.name(), found.nodes)
}

#[test]
fn gallery() {
    for preset in frond_scene::presets() {
        let now = std::time::Instant::now();
        let found = answer(&preset.maps);
        println!("{} {:?}", line(preset.id, &found), now.elapsed());
    }
}
