//! Programs of the encyclopedia of IFStile, where its folder is there: each opens, has a shape, and has the dimension
//! that its page prints.

use std::path::Path;

use frond_core::{Affine2, Affine3, DirectedIfs, DirectedMap, directed_dimension};
use frond_exchange::{Maps, System, import};

/// The first number of a text such as "≈ 1.585" or "2 (solid)".
fn printed(text: &str) -> Option<f64> {
    let start = text.find(|c: char| c.is_ascii_digit())?;
    let end =
        text[start..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |end| start + end);
    text[start..end].parse().ok()
}

/// The similarity dimension; none where maps are no similitudes.
fn dimension(system: &System) -> Option<f64> {
    match &system.maps {
        Maps::Plane(rows) => {
            let maps = rows.iter().map(|&row| DirectedMap { from: 0, map: Affine2::from_row(row) }).collect();
            directed_dimension(&DirectedIfs::new(vec![maps]).ok()?, 0)
        }
        Maps::Directed(states) => {
            let map = |copy: &frond_exchange::DirectedCopy| DirectedMap {
                from: copy.from,
                map: Affine2::from_row(copy.map),
            };
            let states = states.iter().map(|maps| maps.iter().map(map).collect()).collect();
            directed_dimension(&DirectedIfs::new(states).ok()?, 0)
        }
        Maps::Space(rows) => solid(rows),
        Maps::Objects(objects) => {
            objects.iter().map(|rows| solid(rows)).try_fold(0.0, |most, x| Some(f64::max(most, x?)))
        }
    }
}

/// By Moran's equation.
fn solid(rows: &[[f64; 12]]) -> Option<f64> {
    let ratio = |row: &[f64; 12]| {
        let linear = Affine3::from_row(*row).linear;
        let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
        let square = x.length_squared();
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * square;
        let alike = near(y.length_squared(), square) && near(z.length_squared(), square);
        let right = near(x.dot(y), 0.0) && near(y.dot(z), 0.0) && near(z.dot(x), 0.0);
        (alike && right).then(|| square.sqrt())
    };
    let ratios = rows.iter().map(ratio).collect::<Option<Vec<_>>>()?;
    let (mut low, mut high) = (0.0, 20.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        let sum: f64 = ratios.iter().map(|ratio| ratio.powf(middle)).sum();
        if sum > 1.0 { low = middle } else { high = middle }
    }
    Some(low)
}

#[test]
fn programs_of_the_encyclopedia_open_with_their_dimensions() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/ifsdb/programs.json");
    let Ok(text) = std::fs::read_to_string(folder) else { return };
    let all: serde_json::Value = serde_json::from_str(&text).unwrap();
    let mut wrong = Vec::new();
    for entry in all["entries"].as_array().unwrap() {
        let variants = entry["variants"].as_object().into_iter().flatten();
        let programs =
            [("", &entry["aifs"])].into_iter().chain(variants.map(|(name, text)| (&name[..], text)));
        for (variant, program) in programs {
            let slug = format!("{} {variant}", entry["slug"].as_str().unwrap());
            let system = match import(program.as_str().unwrap().as_bytes()) {
                Ok(found) if found.systems.len() == 1 => found.systems.into_iter().next().unwrap(),
                Ok(found) => {
                    wrong.push(format!("{slug}: {} systems", found.systems.len()));
                    continue;
                }
                Err(error) => {
                    wrong.push(format!("{slug}: {error}"));
                    continue;
                }
            };
            if let Err(error) = system.check() {
                wrong.push(format!("{slug}: {error}"));
            }
            let found = dimension(&system);
            let wanted = printed(entry["dimension"].as_str().unwrap()).unwrap();
            // Pages print three digits behind the point, cut or rounded, and of the exact shape where a program has
            // 0.333 for a third.
            if found.is_none_or(|found| (found - wanted).abs() > 2e-3) {
                wrong.push(format!("{slug}: {found:?} and not {wanted}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
