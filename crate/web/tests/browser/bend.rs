//! Fractal deformation, as JavaScript meets it.

use js_sys::{Object, Reflect};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::js::{code, get, json};

fn number(value: &JsValue, key: &str) -> f64 {
    get(value, key).as_f64().unwrap()
}

const GASKET: &str =
    r#"{"maps": [[0.5, 0, 0, 0.5, 0, 0], [0.5, 0, 0, 0.5, 0.5, 0], [0.5, 0, 0, 0.5, 0, 0.5]]}"#;

/// A mesh of four by four over the unit square whose points all move by the same, with some fields changed.
fn bend(dx: f64, dy: f64, change: &str) -> JsValue {
    let moves: Vec<String> = (0..16).map(|_| format!("{dx}, {dy}")).collect();
    let plain = json(&format!(
        r#"{{"columns": 4, "rows": 4, "box": [0, 0, 1, 1], "moves": [{}], "kb": 0, "ke": 6, "delta": 0.75,
            "spin": "none", "continuity": "auto", "superposed": true}}"#,
        moves.join(", ")
    ));
    Object::assign(plain.as_ref().unchecked_ref_object(), json(change).as_ref().unchecked_ref_object()).into()
}

/// `unchecked_ref`, said once.
trait AsObject {
    fn unchecked_ref_object(&self) -> &Object;
}

impl AsObject for JsValue {
    fn unchecked_ref_object(&self) -> &Object {
        wasm_bindgen::JsCast::unchecked_ref(self)
    }
}

#[wasm_bindgen_test]
fn a_block_of_letters_is_reversed() {
    let shuffled = |kb, ke| frond_web::shuffle(5.0, kb, ke, vec![2.0, 4.0, 1.0, 0.0, 1.0]).unwrap();
    assert_eq!(shuffled(1.0, 4.0), [2.0, 0.0, 1.0, 4.0, 1.0]);
    assert_eq!(shuffled(3.0, 3.0), [2.0, 4.0, 1.0, 0.0, 1.0]);
    let code_of =
        |symbols, kb, ke, letters: &[f64]| code(frond_web::shuffle(symbols, kb, ke, letters.to_vec()));
    for (symbols, kb, ke, letters) in [
        (0.0, 0.0, 1.0, &[0.0][..]),
        (2.0, 0.0, 2.0, &[0.0]),
        (2.0, 1.0, 0.0, &[0.0, 1.0]),
        (2.0, 0.5, 1.0, &[0.0, 1.0]),
        (2.0, 0.0, 1.0, &[0.0, 2.0]),
        (f64::NAN, f64::NAN, f64::NAN, &[f64::NAN]),
        (1e9, 0.0, 1.0, &[0.0]),
    ] {
        assert_eq!(code_of(symbols, kb, ke, letters), "bad-input");
    }
}

#[wasm_bindgen_test]
fn a_mesh_that_moves_as_one_moves_all_points_so() {
    let codes = json("[[0, 1, 2, 0, 1, 2], [2, 2, 2, 2, 2, 2], []]");
    let tails = json("[[0.25, 0.25], [0, 1], [0.5, 0]]");
    let bend = bend(0.25, -0.5, "{}");
    let moved = frond_web::deform(json(GASKET), bend.clone(), codes.clone(), tails.clone()).unwrap();
    let rest = frond_web::deform(json(GASKET), self::bend(0.0, 0.0, "{}"), codes, tails).unwrap();
    for i in 0..6 {
        let by = if i % 2 == 0 { 0.25 } else { -0.5 };
        assert!((moved.get_index(i) - rest.get_index(i) - by).abs() < 1e-12);
    }
    let grid = frond_web::mesh_grid(bend, 11).unwrap();
    assert_eq!(grid.length(), 242);
    assert!((grid.get_index(0) - 0.25).abs() < 1e-12 && (grid.get_index(241) - 0.5).abs() < 1e-12);
}

#[wasm_bindgen_test]
fn facts_tell_what_came_of_it() {
    let facts = frond_web::bend_facts(json(GASKET), bend(0.3, 0.4, "{}")).unwrap();
    assert_eq!(Reflect::get(&facts, &"continuity".into()).unwrap(), "corners");
    assert_eq!(number(&facts, "ke"), 6.0);
    assert!(number(&facts, "deepest") >= 12.0);
    assert!(number(&facts, "reach") >= 0.5 - 1e-12);
}

#[wasm_bindgen_test]
fn what_cannot_be_bent_says_why() {
    for change in [
        r#"{"kb": 7}"#,
        r#"{"kb": -1}"#,
        r#"{"delta": -1}"#,
        r#"{"delta": null}"#,
        r#"{"delta": [0.5, 0.5]}"#,
        r#"{"columns": 1}"#,
        r#"{"columns": 1000000, "rows": 1000000}"#,
        r#"{"moves": [0, 0]}"#,
        r#"{"box": [0, 0, 0, 1]}"#,
        r#"{"spin": "fast"}"#,
        r#"{"continuity": "glue"}"#,
        r#"{"tint": {"colours": ["red"], "kb": 0, "ke": 1, "delta": 1, "superposed": true}}"#,
        r##"{"tint": {"colours": ["#ff0000"], "kb": 0, "ke": 1, "delta": 1, "superposed": true}}"##,
    ] {
        assert!(!code(frond_web::bend_facts(json(GASKET), bend(0.0, 0.0, change))).is_empty(), "{change}");
    }
    let code = code(frond_web::bend_facts(json(GASKET), bend(f64::MAX, 0.0, "{}")));
    assert_eq!(code, "mesh-numbers");
}
