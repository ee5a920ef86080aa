//! The exact answers of tests/known/deform, or of the folder named in `FROND_KNOWN`.

use std::collections::HashMap;
use std::path::PathBuf;

use frond_core::Affine2;
use frond_deform::{
    Bend, Continuity, Cube, Field, Mesh, Place, Roughness, Settings, Spin, permutation, shuffle, step,
    weights,
};
use glam::DVec2;
use serde_json::Value;

fn file(name: &str) -> Value {
    let folder = std::env::var_os("FROND_KNOWN").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/known")),
        PathBuf::from,
    );
    let path = folder.join("deform").join(name).with_extension("json");
    let text = std::fs::read_to_string(path).expect("the file of exact answers");
    serde_json::from_str(&text).expect("JSON")
}

fn cases(name: &str) -> Vec<Value> {
    let cases = file(name)["cases"].as_array().expect("cases").clone();
    assert!(!cases.is_empty());
    cases
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().expect("a number")],
    }
}

fn number(case: &Value, key: &str) -> f64 {
    case[key].as_f64().unwrap_or_else(|| panic!("{key} of {case}"))
}

fn whole(case: &Value, key: &str) -> usize {
    case[key].as_u64().unwrap_or_else(|| panic!("{key} of {case}")) as usize
}

fn code(value: &Value) -> Vec<u8> {
    numbers(value).iter().map(|&x| x as u8).collect()
}

fn point(value: &Value) -> DVec2 {
    DVec2::from_slice(&numbers(value))
}

fn systems() -> HashMap<String, Vec<Affine2>> {
    let file = file("ifs");
    let plane = file.as_object().unwrap().iter().filter(|(_, ifs)| numbers(&ifs["b"][0]).len() == 2);
    plane
        .map(|(name, ifs)| {
            let parts = ifs["A"].as_array().unwrap().iter().zip(ifs["b"].as_array().unwrap());
            let row = |(a, b): (&Value, &Value)| {
                let all: Vec<f64> = numbers(a).into_iter().chain(numbers(b)).collect();
                Affine2::from_row(all.try_into().unwrap())
            };
            (name.clone(), parts.map(row).collect())
        })
        .collect()
}

fn meshes() -> HashMap<String, Mesh> {
    let file = file("meshes");
    let mesh = |mesh: &Value| {
        let bounds = numbers(&mesh["box"]);
        let list: Vec<DVec2> = numbers(&mesh["D"]).chunks(2).map(DVec2::from_slice).collect();
        Mesh::new(DVec2::new(bounds[0], bounds[1]), DVec2::new(bounds[2], bounds[3]), 4, 4, list).unwrap()
    };
    file["meshes"].as_object().unwrap().iter().map(|(name, plain)| (name.clone(), mesh(plain))).collect()
}

fn spin(case: &Value) -> Spin {
    match case["rot"].as_str() {
        Some("none") | None => Spin::None,
        Some("o2") => Spin::Orthogonal,
        Some("so2") => Spin::Rotation,
        Some(other) => panic!("no spin {other}"),
    }
}

#[track_caller]
fn assert_close(found: DVec2, wanted: &Value, tolerance: f64, case: &Value) {
    let wanted = point(wanted);
    let size = wanted.abs().max_element().max(1.0);
    assert!((found - wanted).abs().max_element() <= tolerance * size, "{found} is not {wanted}: {case}");
}

#[test]
fn codes() {
    for case in cases("codes") {
        let mut found = code(&case["code"]);
        shuffle(&mut found, whole(&case, "kb"), whole(&case, "ke"));
        assert_eq!(found, code(&case["out"]), "{case}");
    }
    for case in cases("step") {
        let mut found = code(&case["code"]);
        step(&mut found, whole(&case, "kb"), whole(&case, "k"));
        assert_eq!(found, code(&case["out"]), "{case}");
    }
}

#[test]
fn permutations() {
    for case in cases("perms") {
        let at = |key| whole(&case, key);
        let found = permutation(at("L"), at("n"), at("kb"), at("ke")).unwrap();
        let wanted: Vec<u32> = numbers(&case["perm"]).iter().map(|&x| x as u32).collect();
        assert_eq!(found, wanted, "{case}");
    }
}

#[test]
fn weights_of_terms() {
    for case in cases("weights") {
        let found = weights(number(&case, "delta"), whole(&case, "kb"), whole(&case, "ke"));
        let wanted = numbers(&case["weights"]);
        assert_eq!(found.len(), wanted.len());
        assert!(found.iter().zip(&wanted).all(|(f, w)| (f - w).abs() <= 1e-12), "{found:?}: {case}");
    }
}

#[test]
fn addresses_on_cubes() {
    for case in cases("cube_address") {
        let (dimensions, parts) = match case["cube"].as_str().unwrap() {
            "line2" => (1, 2),
            "line3" => (1, 3),
            "square4" => (2, 2),
            "square9" => (2, 3),
            other => panic!("no cube {other}"),
        };
        let cube = Cube::new(dimensions, parts).unwrap();
        let word = code(&case["code"]);
        if case["point"].is_array() {
            assert_eq!(cube.code(&numbers(&case["point"]), word.len()), word, "{case}");
        }
        if case["cell_lower"].is_array() {
            let (corner, side) = cube.cell(&word);
            let centre: Vec<f64> = corner.iter().map(|x| x + side / 2.0).collect();
            for (found, wanted) in [(corner, "cell_lower"), (centre, "cell_centre")] {
                let wanted = numbers(&case[wanted]);
                assert!(found.iter().zip(&wanted).all(|(f, w)| (f - w).abs() < 1e-12), "{found:?}: {case}");
            }
        }
    }
}

#[test]
fn displacements_of_meshes() {
    let meshes = meshes();
    for case in cases("mesh") {
        let mesh = &meshes[case["mesh"].as_str().unwrap()];
        assert_close(mesh.at(point(&case["x"])), &case["v"], 1e-12, &case);
    }
}

/// Calls `check` with the field and the place of each case of a file.
fn each_field(name: &str, check: impl Fn(&Value, &Field<'_>, Place<'_>)) {
    let (systems, meshes) = (systems(), meshes());
    for case in cases(name) {
        let maps = &systems[case["ifs"].as_str().unwrap()];
        let field = Field::new(maps, &meshes[case["mesh"].as_str().unwrap()], spin(&case));
        let word = code(&case["code"]);
        let place = Place { code: &word, tail: point(&case["tail"]) };
        if case["x"].is_array() {
            assert_close(field.position(place), &case["x"], 1e-12, &case);
        }
        check(&case, &field, place);
    }
}

#[test]
fn single_terms() {
    each_field("eq17", |case, field, place| {
        let v = field.term(whole(case, "kb"), whole(case, "k"), place);
        assert_close(v, &case["v"], 1e-12, case);
        assert_close(field.position(place) + v, &case["p"], 1e-12, case);
        let mut moved = place.code.to_vec();
        shuffle(&mut moved, whole(case, "kb"), whole(case, "k"));
        assert_eq!(moved, code(&case["moved_code"]), "{case}");
    });
}

#[test]
fn superpositions() {
    each_field("eq18", |case, field, place| {
        let v = field.superposed(whole(case, "kb"), whole(case, "ke"), number(case, "delta"), place);
        assert_close(v, &case["v"], 1e-12, case);
        assert_close(field.position(place) + v, &case["p"], 1e-12, case);
    });
    each_field("eq18_varratio", |case, field, place| {
        let delta = numbers(&case["delta_by_first_symbol"])[usize::from(place.code[0])];
        let v = field.superposed(whole(case, "kb"), whole(case, "ke"), delta, place);
        assert_close(v, &case["v"], 1e-12, case);
    });
}

#[test]
fn between_whole_numbers() {
    each_field("eq19", |case, field, place| {
        let (kb, ke) = (number(case, "kb"), number(case, "ke"));
        assert_close(field.term_between(kb, ke, place), &case["v_eq19"], 1e-12, case);
        let v = field.superposed_between(kb, ke, number(case, "delta"), place);
        assert_close(v, &case["v_super"], 1e-12, case);
    });
}

#[test]
fn the_gasket_without_a_tear() {
    let (systems, meshes) = (systems(), meshes());
    for case in cases("gasket_fe") {
        let maps = &systems[case["ifs"].as_str().unwrap()];
        let settings = Settings {
            kb: number(&case, "kb"),
            ke: number(&case, "ke"),
            roughness: Roughness::Constant(number(&case, "delta")),
            spin: Spin::None,
            continuity: Continuity::Auto,
            superposed: true,
        };
        let mesh = meshes[case["mesh"].as_str().unwrap()].clone();
        let bend = Bend::new(maps, mesh, settings, None).unwrap();
        assert_eq!(bend.continuity(), Continuity::Corners);
        let word = code(&case["code"]);
        let cursor = word.iter().fold(bend.whole(), |cursor, &i| bend.child(&cursor, usize::from(i)));
        let tail = point(&case["tail"]);
        let v = bend.point(&cursor, tail) - cursor.map().apply(tail);
        assert_close(v, &case["v"], 1e-11, &case);
    }
}
