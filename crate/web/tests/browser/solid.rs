//! What JavaScript is told of space.

use frond_web::space::*;
use js_sys::{Array, JSON, Object, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::js::{code, get, json};

fn preset(id: &str) -> JsValue {
    let all: Array = gallery3().unwrap().unchecked_into();
    let found = all.iter().find(|preset| get(preset, "id").as_string().as_deref() == Some(id));
    get(&found.unwrap(), "maps")
}

fn tetrahedron() -> JsValue {
    preset("tetrahedron")
}

fn view() -> JsValue {
    default_view(default_space().unwrap()).unwrap()
}

fn look(width: u32, height: u32, factor: u32) -> JsValue {
    json(&format!(
        r##"{{"width": {width}, "height": {height}, "factor": {factor}, "palette": [], "ground": "#101418"}}"##
    ))
}

fn light() -> JsValue {
    get(&default_space().unwrap(), "light")
}

fn objects() -> Array {
    let space = default_space().unwrap();
    get(&space, "objects").unchecked_into()
}

#[wasm_bindgen_test]
fn a_space_goes_into_a_link_and_back() {
    let space = default_space().unwrap();
    let word = pack_space(space.clone()).unwrap();
    let again = unpack_space(&word).unwrap();
    assert_eq!(JSON::stringify(&again).unwrap(), JSON::stringify(&space).unwrap());
    assert_eq!(code(unpack_space("o:nothing")), "space-damaged");
    assert_eq!(code(pack_space(json(r#"{"objects": []}"#))), "space-count");
    let many = format!(r#"{{"objects": [{}]}}"#, ["1"; 100_000].join(","));
    assert_eq!(code(pack_space(json(&many))), "space-count");
    assert_eq!(code(pack_space(json(r#"{"objects": 7}"#))), "bad-input");
}

#[wasm_bindgen_test]
fn a_turn_and_its_inverse_leave_the_parameters() {
    let maps = tetrahedron();
    let turn = turning3(json("[1, 2, 3]"), 0.7, json("[4, 5, 6]")).unwrap();
    let there = conjugate3(maps.clone(), turn.clone()).unwrap();
    let back = conjugate3(there, invert3(turn).unwrap()).unwrap();
    let numbers = |value: &JsValue| -> Vec<f64> {
        let rows: Array = value.clone().unchecked_into();
        rows.iter()
            .flat_map(|row| Array::from(&row).iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>())
            .collect()
    };
    assert!(numbers(&back).iter().zip(numbers(&maps)).all(|(a, b)| (a - b).abs() < 1e-12));
    let flat = json("[1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]");
    assert_eq!(code(conjugate3(maps.clone(), flat.clone())), "transform-singular");
    assert_eq!(code(invert3(flat)), "transform-singular");
    let tiny = json("[1e-300, 0, 0, 0, 1e-300, 0, 0, 0, 1e-300, 0, 0, 0]");
    assert_eq!(code(conjugate3(maps, tiny)), "transform-scale");
    assert_eq!(code(turning3(json("[0, 0, 0]"), 1.0, json("[0, 0, 0]"))), "bad-input");
    let many = json(&format!("[{}]", ["[]"; 1_000_000].join(",")));
    assert_eq!(code(validate3(many)), "too-many-maps");
}

#[wasm_bindgen_test]
fn a_picture_is_carved_and_painted() {
    let picture = SpacePicture::new(objects()).unwrap();
    let mut carve = picture.carve(view(), 120.0, 90.0).unwrap();
    while !carve.run(20_000.0) {}
    let pixels = carve.paint(light(), look(60, 45, 2)).unwrap().to_vec();
    assert_eq!(pixels.len(), 60 * 45 * 4);
    let lit = pixels.chunks(4).filter(|p| p[3] > 0).count();
    let colours: std::collections::BTreeSet<&[u8]> = pixels.chunks(4).collect();
    assert!((300..2600).contains(&lit) && colours.len() > 50, "{lit} lit, {} colours", colours.len());
    assert_eq!(code(carve.paint(light(), look(60, 45, 1))), "bad-input");
    assert_eq!(code(picture.carve(view(), 0.0, 90.0)), "bad-input");
    assert_eq!(code(picture.carve(view(), 1e9, 90.0)), "bad-input");
    let none = view();
    Reflect::set(&none, &"distance".into(), &0.0.into()).unwrap();
    assert_eq!(code(picture.carve(none, 9.0, 9.0)), "camera-no-direction");
    assert_eq!(code(SpacePicture::new(Array::new())), "bad-input");
}

#[wasm_bindgen_test]
fn scenes_of_any_size_are_seen_alike() {
    let carved = |scale: f64| {
        let space = default_space().unwrap();
        let objects: Array = get(&space, "objects").unchecked_into();
        let by = json(&format!("[{scale:e},0,0,0,{scale:e},0,0,0,{scale:e},0,0,0]"));
        let object = objects.get(0);
        let maps = conjugate3(get(&object, "maps"), by.clone()).unwrap();
        Reflect::set(&object, &"moved".into(), &by).unwrap();
        let view = default_view(space).unwrap();
        let shown = Object::new();
        Reflect::set(&shown, &"maps".into(), &maps).unwrap();
        let picture = SpacePicture::new(Array::of1(&shown)).unwrap();
        let mut carve = picture.carve(view, 60.0, 45.0).unwrap();
        while !carve.run(20_000.0) {}
        let pixels = carve.paint(light(), look(60, 45, 1)).unwrap().to_vec();
        pixels.chunks(4).filter(|p| p[3] > 0).count()
    };
    let plain = carved(1.0);
    for scale in [1e-60, 1e-9, 1e9, 1e60] {
        let lit = carved(scale);
        assert!(lit.abs_diff(plain) < 40, "{scale:e}: {lit} and {plain}");
    }
}

#[wasm_bindgen_test]
fn what_a_renderer_is_given_has_its_sizes() {
    let picture = SpacePicture::new(objects()).unwrap();
    let clouds = picture.clouds(40_000.0);
    assert_eq!(clouds.length(), 1);
    let length = |value: &JsValue, key: &str| get(&get(value, key), "length").as_f64().unwrap();
    assert!(length(&clouds.get(0), "vertices") > 1000.0);
    assert!(length(&clouds.get(0), "instances") > 1000.0);
    let bytes = picture.uniforms(view(), light(), look(60, 45, 2)).unwrap();
    assert_eq!(Object::keys(bytes.unchecked_ref::<Object>()).length(), 4);
    assert_eq!(length(&bytes, "lamp"), length(&bytes, "stillLamp"));
}

#[wasm_bindgen_test]
fn films_verdicts_paths_and_shadows() {
    let space = unpack_space("o:tetrahedron/to:dragon-curled/t:0.5").unwrap();
    let moment = SpaceMotion::new(space).unwrap().at(0.0).unwrap();
    assert_eq!(get(&moment, "t").as_f64(), Some(0.5));
    let bad = unpack_space("o:sponge/to:dragon-curled").unwrap();
    assert_eq!(code(SpaceMotion::new(bad)), "map-counts");
    let verdict = |maps| get(&connectedness3(maps, JsValue::UNDEFINED).unwrap(), "verdict").as_string();
    assert_eq!(verdict(tetrahedron()).as_deref(), Some("connected"));
    assert_eq!(verdict(preset("dust")).as_deref(), Some("disconnected"));
    assert_eq!(verdict(json("[[2,0,0,0,2,0,0,0,2,0,0,0]]")).as_deref(), Some("no-attractor"));
    let mut locus =
        SpaceLocus::new(tetrahedron(), preset("dragon-curled"), json(r#"{"width": 7, "height": 7}"#))
            .unwrap();
    let tile = locus.run(0, 7, 1);
    assert_eq!(get(&get(&tile, "state"), "length").as_f64(), Some(49.0));
    let kept: Array = directions(tetrahedron()).unwrap().unchecked_into();
    assert_eq!(kept.length(), 3);
    assert_eq!(Array::from(&project(tetrahedron(), json("[0, 0, 1]")).unwrap()).length(), 4);
    assert_eq!(code(project(preset("dragon"), json("[0, 0, 1]"))), "project-not-kept");
    assert_eq!(code(parse_file("a (3D) { 1 2 }")), "ifs-count");
    let word = write_file("tetra", tetrahedron()).unwrap();
    assert_eq!(Array::from(&parse_file(&word).unwrap()).length(), 1);
    let lifted: Array = lift(json("[[0.5,0,0,0.5,0,0],[0.5,0,0,0.5,0.5,0]]")).unwrap().unchecked_into();
    assert_eq!(lifted.length(), 2);
    let examples: Array = examples().unwrap().unchecked_into();
    for example in examples.iter() {
        let met = intersection3(get(&example, "first"), get(&example, "second"), json(r#"{"points": 100}"#));
        let is = !get(&met.unwrap(), "attractor").is_null();
        assert_eq!(Some(is), get(&example, "isAttractor").as_bool());
    }
}
