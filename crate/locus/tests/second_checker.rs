//! A second checker, `tests/check.py`, decides as `frond-check` does on proofs and on what is left of them when
//! something is changed. It is skipped, and says so, where there is no Python.

use std::fs;
use std::path::Path;
use std::process::Command;

use frond_check::{Proof, Refused};
use frond_core::{Affine2, Ifs};
use frond_locus::{Options, certificate, connected_certificate};
use frond_scene::presets;
use frond_testing::cases;
use glam::DVec2;
use serde_json::{Value, json};

/// Larger ones take Python long.
const LONGEST_TEXT: usize = 23_000;

/// Proofs about exact numbers, which their own test describes.
const EXACT: [&str; 9] = [
    include_str!("../../check/tests/exact/koch.json"),
    include_str!("../../check/tests/exact/segment.json"),
    include_str!("../../check/tests/exact/gasket.json"),
    include_str!("../../check/tests/exact/pentagon.json"),
    include_str!("../../check/tests/exact/areas.json"),
    include_str!("../../check/tests/exact/paper.json"),
    include_str!("../../check/tests/exact/line.json"),
    include_str!("../../check/tests/exact/cantor.json"),
    include_str!("../../check/tests/exact/blocks.json"),
];

/// Whole numbers that look like chance (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }
}

/// Proofs of both kinds as the page saves them: of shapes of the gallery, of these made smaller, and one of each link
/// that these have not.
fn proofs() -> Vec<Value> {
    let mut systems: Vec<Vec<Affine2>> = Vec::new();
    for preset in presets().iter().filter(|preset| preset.maps.len() < 8) {
        let maps: Vec<Affine2> = preset.maps.iter().map(|&row| Affine2::from_row(row)).collect();
        for factor in [0.4, 0.7, 0.95] {
            systems.push(maps.iter().map(|map| shrunk(map, factor)).collect());
        }
        systems.push(maps);
    }
    // Copies of one shape and direction never cross.
    systems.extend((0..6).map(|k| {
        let (turn, count) = (0.37 * f64::from(k), 4 + k % 3);
        let places = (0..count).map(|n| 0.8 * DVec2::from_angle(f64::from(n * n) + 0.3 * f64::from(k)));
        places.map(|place| Affine2::similitude(0.56, turn, place)).collect()
    }));
    systems.push(
        [(0.2, 0.1), (1.9, -0.3)]
            .map(|(turn, e)| Affine2::similitude(0.75, turn, DVec2::new(e, 0.37)))
            .to_vec(),
    );
    systems.push([1.0, -1.0].map(|e| Affine2::from_row([0.6, 0.0, 0.0, 0.6, e, 0.0])).to_vec());
    let options = Options::default();
    let found = systems.into_iter().filter_map(|maps| {
        let ifs = Ifs::new(maps).ok()?;
        let apart = certificate(&ifs, &options).map(|found| {
            let pair = |pair: &frond_locus::Separation| json!({ "u": pair.u, "v": pair.v, "normal": pair.normal.to_array() });
            json!({
                "maps": found.maps, "polygon": points(&found.polygon), "letters": found.letters, "side": found.side,
                "pairs": found.pairs.iter().map(pair).collect::<Vec<_>>(),
            })
        });
        apart.or_else(|| connected_certificate(&ifs, &options).map(|found| connected(&found)))
    });
    found.filter(|proof| proof.to_string().len() < LONGEST_TEXT).collect()
}

/// The map with its linear part made smaller, about the point that it fixes.
fn shrunk(map: &Affine2, factor: f64) -> Affine2 {
    let [a, b, c, d, e, f] = map.to_row();
    let under = (1.0 - a) * (1.0 - d) - b * c;
    let fixed = DVec2::new(((1.0 - d) * e + b * f) / under, ((1.0 - a) * f + c * e) / under);
    let row = [a, b, c, d].map(|x| x * factor);
    let rest = fixed - DVec2::new(row[0] * fixed.x + row[1] * fixed.y, row[2] * fixed.x + row[3] * fixed.y);
    Affine2::from_row([row[0], row[1], row[2], row[3], rest.x, rest.y])
}

fn points(points: &[DVec2]) -> Vec<[f64; 2]> {
    points.iter().map(|point| point.to_array()).collect()
}

fn connected(found: &frond_locus::ConnectedCertificate) -> Value {
    use frond_locus::CertifiedLink;
    let address = |[head, repeat]: &[Vec<u8>; 2]| json!({ "head": head, "repeat": repeat });
    let link = |link: &CertifiedLink| match link {
        CertifiedLink::Point(addresses) => {
            json!({ "kind": "point", "addresses": addresses.iter().map(address).collect::<Vec<_>>() })
        }
        CertifiedLink::Between(addresses) => {
            json!({ "kind": "between", "addresses": addresses.iter().map(address).collect::<Vec<_>>() })
        }
        CertifiedLink::Area(pair) => json!({ "kind": "area", "pair": pair }),
        CertifiedLink::Difference(pair, steps) => {
            json!({ "kind": "difference", "pair": pair, "steps": steps })
        }
        CertifiedLink::Crossing(words, far) => {
            let far =
                far.each_ref().map(|far| json!({ "tail": far.tail, "direction": far.direction.to_array() }));
            json!({ "kind": "crossing", "words": words, "far": far })
        }
    };
    let mut proof = json!({
        "maps": found.maps, "polygon": points(&found.polygon), "gap": found.gap, "near": found.near,
        "links": found.links.iter().map(link).collect::<Vec<_>>(),
    });
    if let Some(squares) = &found.squares {
        let cells: Vec<_> = squares.cells.iter().map(|&([x, y], [k, l])| (x, y, k, l)).collect();
        proof["squares"] = json!({ "size": squares.size.to_array(), "cells": cells });
    }
    proof
}

/// All that a text of JSON holds, as ways to it.
fn places(value: &Value, way: &str, found: &mut Vec<String>) {
    found.push(way.to_owned());
    match value {
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(k, item)| places(item, &format!("{way}/{k}"), found));
        }
        Value::Object(items) => {
            items.iter().for_each(|(name, item)| places(item, &format!("{way}/{name}"), found));
        }
        _ => {}
    }
}

/// The proof with one thing changed.
fn mutant(proof: &Value, random: &mut Random) -> Value {
    let mut changed = proof.clone();
    let mut all = Vec::new();
    places(proof, "", &mut all);
    let place = &all[random.below(all.len())];
    let Some(value) = changed.pointer_mut(place) else { return changed };
    match value {
        Value::Number(number) if number.is_u64() || number.is_i64() => {
            let n = number.as_i64().unwrap_or(0);
            *value = json!([n + 1, n - 1, 0, random.below(4) as i64, 300][random.below(5)]);
        }
        Value::Number(number) => {
            let x = number.as_f64().unwrap_or(0.0);
            let fine = x * 2.0_f64.powi(-(random.below(50) as i32));
            *value = json!([x + fine, x - fine, -x, 0.0, x.next_up(), x.next_down()][random.below(6)]);
        }
        Value::Array(items) if !items.is_empty() => {
            let (k, l) = (random.below(items.len()), random.below(items.len()));
            match random.below(3) {
                0 => drop(items.remove(k)),
                1 => items.insert(l, items[k].clone()),
                _ => items.swap(k, l),
            }
        }
        Value::Object(items) => {
            let name = items.keys().nth(random.below(items.len())).cloned().unwrap_or_default();
            items.remove(&name);
        }
        Value::String(text) if text.starts_with(|c: char| c == '-' || c.is_ascii_digit()) => {
            *value = json!(other_fraction(text, random));
        }
        other => *other = json!(["area", "point", "between"][random.below(3)]),
    }
    changed
}

/// Another fraction, the same one in other words, one that is almost the same, or none.
fn other_fraction(text: &str, random: &mut Random) -> String {
    let (over, under) = text.split_once('/').unwrap_or((text, "1"));
    let tiny = if random.below(2) == 0 { 1 } else { -1 };
    let near = over.parse::<i128>().unwrap_or(0) * 10_i128.pow(18) + tiny;
    match random.below(8) {
        0 => format!("-{text}"),
        1 => format!("{text}0"),
        2 => format!("0{text}"),
        3 => format!("{over}0/{under}0"),
        4 => ["0", "1", "-2", "1/3"][random.below(4)].to_owned(),
        5 => format!("{text} "),
        _ => format!("{near}/{under}{}", "0".repeat(18)),
    }
}

#[test]
fn a_second_checker_decides_alike() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/check.py");
    if !Command::new("python3").arg("--version").output().is_ok_and(|found| found.status.success()) {
        println!("There is no python3: the second checker was not asked.");
        return;
    }
    let proofs = proofs();
    for kind in ["point", "area", "difference", "between", "crossing"] {
        let named = format!("\"kind\":\"{kind}\"");
        assert!(
            proofs.iter().any(|proof| proof.to_string().contains(&named)),
            "none has a link of the kind {kind}"
        );
    }
    let random = &mut Random(7);
    let exact: Vec<Value> = EXACT.iter().map(|text| serde_json::from_str(text).unwrap()).collect();
    let mut mutants: Vec<Value> =
        (0..cases(500)).map(|k| mutant(&proofs[k as usize % proofs.len()], random)).collect();
    mutants.extend((0..cases(500)).map(|k| mutant(&exact[k as usize % exact.len()], random)));
    let lines = proofs.into_iter().chain(exact).chain(mutants).filter_map(|proof| {
        let text = proof.to_string();
        let says = Proof::from_json(&text).map(|proof| proof.check());
        // How much work is too much is a matter of the one that does it.
        if let Ok(Err(Refused::TooLarge { what: "digits to multiply", .. })) = says {
            return None;
        }
        let says = says.map(|says| says.map_err(|why| why.to_string())).map_err(|why| why.to_string());
        let accepted = matches!(says, Ok(Ok(_)));
        Some(json!({ "accepted": accepted, "says": format!("{says:?}"), "proof": proof }).to_string())
    });
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("proofs.jsonl");
    fs::write(&file, lines.collect::<Vec<_>>().join("\n")).unwrap();
    let found = Command::new("python3").arg(script).arg("--compare").arg(file).output().unwrap();
    assert!(
        found.status.success(),
        "{}{}",
        String::from_utf8_lossy(&found.stdout),
        String::from_utf8_lossy(&found.stderr)
    );
}
