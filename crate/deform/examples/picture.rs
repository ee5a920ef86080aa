//! The picture of the documentation, a gasket pulled at one corner, smooth and rough: `cargo run --release -p
//! frond-deform --example picture > crate/deform/picture.svg`.

use frond_core::Affine2;
use frond_deform::{Bend, Continuity, Cursor, Mesh, Roughness, Settings, Spin};
use glam::DVec2;

/// Letters of the words whose pieces are drawn.
const LETTERS: usize = 6;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.5, 0.75_f64.sqrt())];
    let maps = corners.map(|corner| Affine2::similitude(0.5, 0.0, corner * 0.5));
    let rest = Mesh::at_rest(DVec2::ZERO, DVec2::ONE, 3, 3)?;
    let mut pulls = vec![DVec2::ZERO; 9];
    // The last row is the top.
    pulls[7] = DVec2::new(0.45, 0.2);
    let pulled = rest.moved(&pulls)?;

    println!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100%\" viewBox=\"0 0 3500 1250\" role=\"img\">"
    );
    println!("<title>A gasket at rest, its top pulled aside, and the same where every part answers</title>");
    for (k, (mesh, ke)) in [(&rest, 0.0), (&pulled, 0.0), (&pulled, 5.0)].into_iter().enumerate() {
        let roughness = Roughness::Constant(0.9);
        let settings = Settings {
            kb: 0.0,
            ke,
            roughness,
            spin: Spin::None,
            continuity: Continuity::Corners,
            superposed: true,
        };
        let bend = Bend::new(&maps, mesh.clone(), settings, None)?;
        let mut path = String::new();
        draw(
            &bend,
            &bend.whole(),
            LETTERS,
            &|p| {
                let at = 900.0 * p + DVec2::new(60.0 + 1150.0 * k as f64, 120.0);
                DVec2::new(at.x, 1200.0 - at.y)
            },
            &mut path,
        );
        println!("<path fill=\"#00835f\" d=\"{path}\"/>");
    }
    println!("</svg>");
    Ok(())
}

/// The pieces of so many letters more, as triangles.
fn draw(bend: &Bend, cursor: &Cursor, letters: usize, place: &dyn Fn(DVec2) -> DVec2, path: &mut String) {
    if letters > 0 {
        for letter in 0..3 {
            draw(bend, &bend.child(cursor, letter), letters - 1, place, path);
        }
        return;
    }
    let [a, b, c, _] = bend.displaced(cursor).map(|corner| place(corner).round());
    let (b, c) = (b - a, c - b);
    *path += &format!("M{} {}l{} {} {} {}z", a.x, a.y, b.x, b.y, c.x, c.y);
}
