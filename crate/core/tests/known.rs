//! The exact answers of tests/known, or of the folder named in `FROND_KNOWN`.

use std::path::PathBuf;

use frond_core::{Affine2, Affine3, Mode, Morph, MorphOptions};
use glam::{DMat2, DMat3, DVec2, DVec3};
use serde_json::Value;

fn known(name: &str) -> Vec<Value> {
    let folder = std::env::var_os("FROND_KNOWN").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/known")),
        PathBuf::from,
    );
    let text = std::fs::read_to_string(folder.join(name)).expect("the file of exact answers");
    let file: Value = serde_json::from_str(&text).expect("JSON");
    let cases = file["cases"].as_array().expect("cases").clone();
    assert!(!cases.is_empty());
    cases
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().expect("a number")],
    }
}

fn row(value: &Value) -> Affine2 {
    Affine2::from_row(numbers(value).try_into().expect("six numbers"))
}

fn assert_close(found: &[f64], wanted: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), wanted.len());
    let size = wanted.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    for (f, w) in found.iter().zip(wanted) {
        assert!((f - w).abs() <= tolerance * size, "{what}: {found:?} is not {wanted:?}");
    }
}

#[test]
fn morphs() {
    for (i, case) in known("morph.json").iter().enumerate() {
        let (from, to) = (row(&case["from"]), row(&case["to"]));
        let (u, v) = (case["u"].as_f64().unwrap(), case["v"].as_f64().unwrap());
        for (mode, name) in [(Mode::Polar, "polar"), (Mode::Linear, "linear")] {
            let options = MorphOptions { mode, ..MorphOptions::default() };
            let morph = Morph::new(&[from], &[to], &options).unwrap();
            let found = morph.at(u, v)[0].to_row();
            assert_close(&found, &numbers(&case[name]), 1e-12, &format!("case {i}, {name}"));
            if mode == Mode::Polar {
                let (angle, turn) = morph.turns()[0];
                let wanted = [&case["theta0"], &case["dtheta"]].map(|x| x.as_f64().unwrap());
                assert_close(&[angle, turn], &wanted, 1e-12, &format!("case {i}, angles"));
            }
        }
    }
}

#[test]
fn conjugations() {
    for (i, case) in known("conjugation.json").iter().enumerate() {
        let get = |name: &str| numbers(&case[name]);
        let mut wanted = get("result_linear");
        wanted.extend(get("result_translation"));
        // Both ways to conjugate: with an error that says why not, and without.
        let both = |found: Vec<f64>| assert_close(&found, &wanted, 1e-9, &format!("case {i}"));
        let found: Vec<f64> = if get("translation").len() == 2 {
            let map = |linear: &str, translation: &str| {
                let m: [f64; 4] = get(linear).try_into().unwrap();
                Affine2::new(DMat2::from_cols_array(&m).transpose(), DVec2::from_slice(&get(translation)))
            };
            let by = map("by_linear", "by_translation");
            let map = map("linear", "translation");
            both(map.conjugate(by).unwrap().to_row().to_vec());
            map.moved(by).unwrap().to_row().to_vec()
        } else {
            let map = |linear: &str, translation: &str| {
                let m: [f64; 9] = get(linear).try_into().unwrap();
                Affine3::new(DMat3::from_cols_array(&m).transpose(), DVec3::from_slice(&get(translation)))
            };
            let by = map("by_linear", "by_translation");
            let map = map("linear", "translation");
            both(map.conjugate(by).unwrap().to_row().to_vec());
            map.moved(by).unwrap().to_row().to_vec()
        };
        both(found);
    }
}
