//! The programming interface, as JavaScript meets it.

use js_sys::{Array, Float32Array, JSON, Object, Reflect, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::js::{code, get, json, maps_of, text};

#[wasm_bindgen_test]
fn shapes_are_validated_with_stable_codes() {
    assert!(frond_web::validate(maps_of("fern")).is_ok());
    for (ifs, wanted) in [
        ("{\"maps\": []}", "no-maps"),
        ("{\"maps\": [[1, 0, 0, 1, 0, 0]]}", "no-attractor"),
        ("{\"maps\": [[1e300, 0, 0, 1, 0, 0]]}", "not-finite"),
        ("{\"maps\": [[1, 2, 3]]}", "bad-input"),
        ("{\"maps\": \"none\"}", "bad-input"),
        ("{}", "bad-input"),
        ("[]", "bad-input"),
        ("{\"maps\": [[0.5, 0, 0, 0.5, 0, 0]], \"probabilities\": [1, 2]}", "probabilities"),
    ] {
        assert_eq!(code(frond_web::validate(json(ifs))), wanted, "{ifs}");
    }
    for nothing in [JsValue::UNDEFINED, JsValue::NULL, 5.into(), "x".into()] {
        assert_eq!(code(frond_web::validate(nothing)), "bad-input");
    }
    let many = Object::new();
    Reflect::set(&many, &"maps".into(), &Array::new_with_length(1_000_000)).unwrap();
    assert_eq!(code(frond_web::validate(many.into())), "too-many-maps");
}

#[wasm_bindgen_test]
fn the_chaos_game_gives_the_points_that_were_asked_for() {
    let cloud = frond_web::attractor(maps_of("fern"), json("{\"points\": 1000, \"seed\": 5}")).unwrap();
    let positions: Float32Array = get(&cloud, "positions").unchecked_into();
    let pieces: Uint8Array = get(&cloud, "pieces").unchecked_into();
    assert_eq!((positions.length(), pieces.length()), (2000, 1000));
    assert!(positions.to_vec().iter().all(|x| x.is_finite() && x.abs() < 11.0));
    for bad in ["{\"points\": -1}", "{\"points\": 1e12}", "{}"] {
        assert_eq!(code(frond_web::attractor(maps_of("fern"), json(bad))), "bad-input");
    }
}

#[wasm_bindgen_test]
fn verdicts_say_what_they_know() {
    let verdict = |ifs| text(&frond_web::connectedness(ifs, JsValue::UNDEFINED).unwrap(), "verdict");
    assert_eq!(verdict(maps_of("dust")), "disconnected");
    assert_eq!(verdict(maps_of("dragon")), "connected");
    assert_eq!(verdict(json("{\"maps\": [[2, 0, 0, 2, 0, 0]]}")), "no-attractor");
    let dust = frond_web::connectedness(maps_of("dust"), JsValue::UNDEFINED).unwrap();
    assert_eq!(get(&dust, "count").as_f64(), Some(4.0));
    // Ratio 0.4 in the unit square: pieces are 0.2 apart.
    let gap = get(&get(&dust, "gap"), "upper").as_f64().unwrap();
    assert!((gap - 0.2).abs() < 0.005, "{gap}");
}

#[wasm_bindgen_test]
fn a_morph_starts_and_ends_where_it_should() {
    let pairing = frond_web::pair(maps_of("dragon"), maps_of("gasket")).unwrap();
    assert_eq!(Array::from(&get(&pairing, "steps")).length(), 1);
    let ifs = |end: &str| {
        let object = Object::new();
        Reflect::set(&object, &"maps".into(), &get(&pairing, end)).unwrap();
        JsValue::from(object)
    };
    let at = frond_web::interpolate(ifs("from"), ifs("to"), json("{\"u\": 1, \"v\": 1}")).unwrap();
    assert_eq!(JSON::stringify(&get(&at, "maps")).unwrap(), JSON::stringify(&get(&pairing, "to")).unwrap());
    let uneven = frond_web::interpolate(maps_of("dragon"), maps_of("gasket"), json("{\"u\": 1, \"v\": 1}"));
    assert_eq!(code(uneven), "map-counts");
}

#[wasm_bindgen_test]
fn a_locus_holds_both_ends_of_the_morph() {
    let (from, to) = (maps_of("dragon-3"), maps_of("gasket"));
    let locus = frond_web::locus(from.clone(), to.clone(), json("{\"width\": 13, \"height\": 13}")).unwrap();
    let state: Uint8Array = get(&locus, "state").unchecked_into();
    let state = state.to_vec();
    // (0, 0) and (1, 1) are samples 4 and 8 of 13.
    assert!(state[4 * 13 + 4] <= 1 && state[8 * 13 + 8] <= 1);
    assert!(state.contains(&2));
    // Tiles from coarse to fine give the same.
    let options = json("{\"width\": 13, \"height\": 13}");
    let mut tiles = frond_web::LocusTiles::new(from.clone(), to.clone(), options).unwrap();
    let mut pieced = vec![255; 169];
    for (stride, first) in [(4, true), (2, false), (1, false)] {
        let tile: Uint8Array = get(&tiles.run(0, 13, stride, first), "state").unchecked_into();
        for (i, &s) in tile.to_vec().iter().enumerate() {
            if s != 255 {
                pieced[i / 13 * stride * 13 + i % 13] = s;
            }
        }
    }
    assert_eq!(pieced, state);
    for bad in
        ["{\"width\": 0, \"height\": 5}", "{\"width\": 1e9, \"height\": 5}", "{\"width\": -1, \"height\": 1}"]
    {
        assert_eq!(code(frond_web::locus(from.clone(), to.clone(), json(bad))), "locus-size");
    }
}

#[wasm_bindgen_test]
fn documents_go_through_links() {
    let scene = frond_web::default_scene().unwrap();
    let link = frond_web::encode_scene(scene.clone()).unwrap();
    let opened = frond_web::decode_scene(&link).unwrap();
    assert_eq!(JSON::stringify(&get(&opened, "scene")).unwrap(), JSON::stringify(&scene).unwrap());
    assert!(get(&opened, "problem").is_undefined());
    let damaged = frond_web::decode_scene("a=%00&b=<script>").unwrap();
    assert_eq!(text(&get(&damaged, "problem"), "code"), "link-damaged");
    assert_eq!(JSON::stringify(&get(&damaged, "scene")).unwrap(), JSON::stringify(&scene).unwrap());
}

#[wasm_bindgen_test]
fn shapes_are_moved_by_conjugation() {
    let moved = frond_web::conjugate(maps_of("gasket"), json("[2, 0, 0, 2, 5, 7]")).unwrap();
    let bounds = frond_web::bounds(moved).unwrap();
    let min: Vec<f64> = Array::from(&get(&bounds, "min")).iter().filter_map(|x| x.as_f64()).collect();
    assert!((min[0] - 5.0).abs() < 0.02 && (min[1] - 7.0).abs() < 0.02, "{min:?}");
    assert!((get(&bounds, "dimension").as_f64().unwrap() - 3.0_f64.log2()).abs() < 1e-9);
    assert_eq!(code(frond_web::conjugate(maps_of("gasket"), json("[0, 0, 0, 0, 0, 0]"))), "singular");
}

#[wasm_bindgen_test]
fn polar_factors_are_told() {
    let factors = frond_web::polar(json("[0, -0.5, 0.5, 0, 0, 0]")).unwrap();
    assert!((get(&factors, "angle").as_f64().unwrap() - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    assert_eq!(get(&factors, "reflects").as_bool(), Some(false));
}

/// The points of a plan, as rows of two or three numbers.
fn points_of(plan: &JsValue) -> Vec<Vec<f64>> {
    let numbers = |row: JsValue| Array::from(&row).iter().filter_map(|x| x.as_f64()).collect();
    Array::from(&get(plan, "points")).iter().map(numbers).collect()
}

#[wasm_bindgen_test]
fn a_third_axis_finds_the_way_that_the_plane_lacks() {
    let ends = || (maps_of("terdragon-mirrored"), maps_of("gasket"));
    let plan = |options: &str| {
        let (from, to) = ends();
        frond_web::plan_path(from, to, json(options))
    };
    let plane = plan("{\"size\": 31}").unwrap();
    assert_eq!(get(&plane, "holds").as_bool(), Some(false));
    assert_eq!(Array::from(&get(&plane, "worst")).length(), 2);
    let space = plan("{\"size\": 31, \"axes\": 3}").unwrap();
    assert_eq!(get(&space, "holds").as_bool(), Some(true));
    assert!(get(&space, "worst").is_undefined() && get(&space, "clearance").as_f64().unwrap() > 0.0);
    let points = points_of(&space);
    assert_eq!((points[0].clone(), points[points.len() - 1].clone()), (vec![0.0, 0.0], vec![1.0, 1.0]));
    assert!(points.iter().any(|point| point.len() == 3));
    // What comes out goes in.
    let (from, to) = ends();
    let check = frond_web::check(from, to, get(&space, "points"), json("{\"samples\": 801}")).unwrap();
    assert_eq!(get(&check, "holds").as_bool(), Some(true));
    assert_eq!(code(plan("{\"axes\": 4}")), "bad-input");
    for bad in ["[[0, 0], [1]]", "[[0, 0, 0, 0]]", "[[0, null]]", "[0, 1]"] {
        let (from, to) = ends();
        assert_eq!(code(frond_web::check(from, to, json(bad), JsValue::UNDEFINED)), "bad-input", "{bad}");
    }
}

#[wasm_bindgen_test]
fn candidates_are_listed_and_rated() {
    let ends = || (maps_of("terdragon"), maps_of("gasket"));
    let (from, to) = ends();
    let list = Array::from(&frond_web::candidates(from, to, json("{\"limit\": 5}")).unwrap());
    assert_eq!(list.length(), 5);
    let best = list.get(0);
    let (from, to) = ends();
    Reflect::set(&best, &"size".into(), &13.into()).unwrap();
    let rated = frond_web::rate_candidate(from, to, best.clone()).unwrap();
    for key in ["correspondence", "turns", "cost"] {
        assert_eq!(JSON::stringify(&get(&rated, key)).unwrap(), JSON::stringify(&get(&best, key)).unwrap());
    }
    let share = get(&rated, "share").as_f64().unwrap();
    assert!(share > 0.1 && share < 1.0, "{share}");
    let locus = get(&rated, "locus");
    let state: Uint8Array = get(&locus, "state").unchecked_into();
    assert_eq!(state.length(), 169);
    assert!(points_of(&get(&rated, "plan")).len() >= 2);
    let (from, to) = ends();
    assert_eq!(code(frond_web::rate_candidate(from, to, json("{\"turns\": [99, 0, 0]}"))), "turns");
    let uneven = frond_web::candidates(maps_of("dragon"), maps_of("gasket"), JsValue::UNDEFINED);
    assert_eq!(code(uneven), "map-counts");
}

#[wasm_bindgen_test]
fn routes_are_explained() {
    let kinds = |from: &str, to: &str| {
        let list = Array::from(&frond_web::routes(maps_of(from), maps_of(to)).unwrap());
        let kinds: Vec<String> = list.iter().map(|route| text(&route, "kind")).collect();
        for route in list.iter() {
            assert!(text(&route, "about").ends_with('.'));
            let [from, to] = ["from", "to"].map(|end| Array::from(&get(&route, end)).length());
            assert_eq!(from, to);
        }
        kinds
    };
    assert_eq!(kinds("fern", "maple"), ["collapse", "symmetry"]);
    assert_eq!(kinds("dragon", "gasket")[0], "refine");
}

#[wasm_bindgen_test]
fn patches_and_families_agree_with_rows() {
    let options = |more: &str| json(&format!("{{\"width\": 25, \"height\": 22{more}}}"));
    let holds = |tile: &JsValue| {
        let states: Uint8Array = get(tile, "state").unchecked_into();
        states.to_vec().into_iter().map(|state| state < 2).collect::<Vec<_>>()
    };
    for more in ["", ", \"w\": 0.25"] {
        let (from, to) = (maps_of("dragon-3"), maps_of("gasket"));
        let mut tiles = frond_web::LocusTiles::new(from, to, options(more)).unwrap();
        let (rows, patch) = (tiles.run(0, 22, 1, true), tiles.patch(0, 0, 25, 22));
        assert_eq!(holds(&rows), holds(&patch));
        let part = holds(&tiles.patch(3, 5, 10, 9));
        assert_eq!(part.len(), 7 * 4);
        assert!((0..28).all(|k| part[k] == holds(&rows)[(5 + k / 7) * 25 + 3 + k % 7]));
    }
    let code_of = |more: &str| {
        code(frond_web::LocusTiles::new(maps_of("dragon-3"), maps_of("gasket"), options(more)).map(|_| ()))
    };
    assert_eq!(code_of(", \"w\": \"far\""), "bad-input");
    let bounds = ", \"bounds\": {\"u0\": -0.75, \"v0\": 0, \"u1\": 0.75, \"v1\": 0.75}";
    let mut tiles = frond_web::FamilyTiles::new(json("{\"sides\": 2}"), options(bounds)).unwrap();
    let (rows, patch) = (tiles.run(0, 22, 1, true), tiles.patch(0, 0, 25, 22));
    assert_eq!(holds(&rows), holds(&patch));
    assert!(holds(&rows)[0] && !holds(&rows)[12], "s = -0.75 holds and s = 0 does not");
    for sides in ["1", "2.5", "65", "\"two\"", "null"] {
        let family = json(&format!("{{\"sides\": {sides}}}"));
        assert_eq!(code(frond_web::FamilyTiles::new(family, options(bounds)).map(|_| ())), "bad-input");
    }
    assert!((frond_web::critical_scale(6.0).unwrap() - 1.0 / 3.0).abs() < 1e-15);
    assert_eq!(code(frond_web::critical_scale(f64::NAN)), "bad-input");
    let maps: Array =
        get(&frond_web::family_maps(json("{\"sides\": 2}"), json("[0.5, 0.25]")).unwrap(), "maps")
            .unchecked_into();
    assert_eq!(JSON::stringify(&maps).unwrap(), "[[0.5,-0.25,0.25,0.5,1,0],[0.5,-0.25,0.25,0.5,-1,0]]");
    assert_eq!(code(frond_web::family_maps(json("{\"sides\": 2}"), json("[0.5]"))), "bad-input");
}

#[wasm_bindgen_test]
fn paths_are_proved_a_stretch_at_a_time() {
    let prove = |points: &str, options: &str| {
        frond_web::certify_path(maps_of("gasket"), maps_of("gasket"), json(points), json(options))
    };
    let still = prove("[[0, 0], [1, 1]]", "{\"within\": 1e-4}").unwrap();
    assert_eq!(get(&still, "holds"), true);
    assert_eq!(get(&still, "complete"), true);
    assert!(get(&still, "gap").as_f64().unwrap() <= 1e-4);
    let part =
        prove("[[0, 0], [0.5, 0.2, 0.1], [1, 1]]", "{\"t0\": 0.25, \"t1\": 0.5, \"budget\": 50}").unwrap();
    let worst = get(&part, "worst").as_f64().unwrap();
    assert!((0.25..=0.5).contains(&worst), "{worst}");
    for (points, options) in
        [("[[0]]", "{}"), ("[[0, 0, 0, 0]]", "{}"), ("5", "{}"), ("[]", "{\"within\": \"x\"}")]
    {
        assert_eq!(code(prove(points, options)), "bad-input", "{points}");
    }
}
