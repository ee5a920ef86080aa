//! The exact answers of tests/known/fit, or of the folder named in `FROND_KNOWN`.

use std::path::PathBuf;

use frond_fit::{
    Bounding, CollageFit, CollageOptions, Dimension, FractalFunction, RingMap, Side, fit_collage,
    spectral_norm,
};
use glam::{DMat2, DVec2};
use serde_json::Value;

fn file(name: &str) -> Value {
    let folder = std::env::var_os("FROND_KNOWN").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/known")),
        PathBuf::from,
    );
    let path = folder.join("fit").join(name).with_extension("json");
    let text = std::fs::read_to_string(path).expect("the file of exact answers");
    serde_json::from_str(&text).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        Value::String(text) => vec![ratio(text)],
        other => vec![other.as_f64().expect("a number")],
    }
}

fn ratio(text: &str) -> f64 {
    let mut parts = text.split('/').map(|part| part.parse::<f64>().expect("a whole number"));
    let top = parts.next().expect("a number");
    parts.next().map_or(top, |bottom| top / bottom)
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn rows<const N: usize>(value: &Value) -> Vec<[f64; N]> {
    let items = value.as_array().expect("a list");
    items.iter().map(|item| numbers(item).try_into().expect("as many numbers")).collect()
}

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance, "{what}: {a} is not {b}");
}

fn knots(case: &Value) -> Vec<DVec2> {
    if case["points"].is_array() {
        return rows::<2>(&case["points"]).into_iter().map(DVec2::from).collect();
    }
    let (t, x) = (numbers(&case["t_knots"]), numbers(&case["x_knots"]));
    t.into_iter().zip(x).map(|(t, x)| DVec2::new(t, x)).collect()
}

fn compare(case: &Value, function: &FractalFunction, tolerance: f64) {
    for (piece, map) in function.curve().pieces().iter().zip(rows::<5>(&case["maps_abcde"])) {
        for (ours, theirs) in piece.map().into_iter().zip(map) {
            near(ours, theirs, 1e-12, "a number of a map");
        }
    }
    let exact = if case["F_exact"].is_array() { &case["F_exact"] } else { &case["F"] };
    for (t, value) in numbers(&case["t"]).into_iter().zip(numbers(exact)) {
        near(function.at(t), value, tolerance, &format!("F({t})"));
    }
}

#[test]
fn interpolation_functions() {
    let all = file("fif");
    for name in ["fig1", "fig1_reflect2", "four_point_unequal"] {
        let case = &all[name];
        let reflected: Vec<bool> = numbers(&case["reflect"]).iter().map(|&x| x != 0.0).collect();
        let function = FractalFunction::fif(&knots(case), &numbers(&case["c"]), &reflected).unwrap();
        compare(case, &function, 1e-12);
        if let Some(integral) = case["integral"].as_f64() {
            near(function.integral().expect("whole domains"), integral, 1e-12, "the integral");
            assert_eq!(function.dimension(), Dimension::Equation(number(&case["box_dim_formula"])));
        }
        assert!(function.curve().widest_gap() < 1e-14);
    }
}

#[test]
fn a_recurrent_function() {
    let case = &file("fif")["rfif_2_2"];
    let spans: Vec<_> = rows::<2>(&case["jk"]).into_iter().map(|[j, k]| (j as usize, k as usize)).collect();
    let function = FractalFunction::rfif(&knots(case), &numbers(&case["c"]), &spans).unwrap();
    compare(case, &function, 1e-9);
    for knot in knots(case) {
        near(function.at(knot.x), knot.y, 1e-14, "a knot");
    }
}

#[test]
fn table_1() {
    let case = &file("fif")["table1"];
    let domain: [f64; 2] = numbers(&case["domain"]).try_into().unwrap();
    let maps: Vec<_> = rows::<5>(&case["maps_abcde"]).into_iter().map(|map| (map, domain)).collect();
    let function = FractalFunction::pfif(&maps).unwrap();
    near(function.at(-1.0), number(&case["F_left"]), 1e-15, "the left end");
    near(function.at(1.0), number(&case["F_right"]), 1e-15, "the right end");
    near(function.limit(0.0, Side::Left, 0.0), number(&case["join_left_limit"]), 1e-15, "left of 0");
    near(function.limit(0.0, Side::Right, 0.0), number(&case["join_right_limit"]), 1e-15, "right of 0");
    let Dimension::Equation(dimension) = function.dimension() else { panic!("domains are whole") };
    near(dimension, number(&case["box_dim_formula"]), 1e-12, "the dimension");
    for name in ["features65", "features129"] {
        let features = &case[name];
        for (t, x) in numbers(&features["t"]).into_iter().zip(numbers(&features["x"])) {
            // At images of 0 the function has two values, and the points hold one of them.
            let values = [Side::Left, Side::Right].map(|side| function.limit(t, side, 0.0));
            let off = values.map(|value| (value - x).abs()).into_iter().fold(f64::INFINITY, f64::min);
            assert!(off < 1e-9, "F({t}) is {values:?}, not {x}");
        }
    }
}

#[test]
fn table_3() {
    let case = &file("hidden_variable")["curve"];
    let maps: Vec<_> = case["table3"]
        .as_array()
        .unwrap()
        .iter()
        .map(|row| (numbers(&row["abcde"]).try_into().unwrap(), numbers(&row["domain"]).try_into().unwrap()))
        .collect();
    let function = FractalFunction::pfif(&maps).unwrap();
    let (t, x) = (numbers(&case["t"]), numbers(&case["x"]));
    for (t, value) in t.iter().zip(numbers(&case["table3_F_at_k243"])) {
        near(function.at(*t), value, 1e-9, &format!("F({t})"));
    }
    let worst = t.iter().zip(&x).map(|(&t, x)| (function.at(t) - x).abs()).fold(0.0, f64::max);
    assert!(worst < 0.0859, "{worst}");
}

fn ring_map(map: &Value) -> RingMap {
    let [xx, xy, yx, yy] = numbers(&map["C"]).try_into().unwrap();
    let vector = |key: &str| DVec2::from_slice(&numbers(&map[key]));
    RingMap {
        start: map["st"].as_u64().unwrap() as usize,
        reversed: map["r"] == 1,
        factor: DMat2::from_cols(DVec2::new(xx, yx), DVec2::new(xy, yy)),
        step: vector("b"),
        offset: vector("e"),
    }
}

/// The maps of the file stand for the curve that the file says, gaps and all. No leaf is needed for it.
#[test]
fn the_attractors_of_fitted_maps() {
    for case in file("leaf_rfif").as_array().unwrap() {
        let maps: Vec<_> = case["maps"].as_array().unwrap().iter().map(ring_map).collect();
        let intervals = case["M"].as_u64().unwrap() as usize;
        let fit = CollageFit { maps, intervals, collage: 0.0 };
        let (points, _) = fit.attractor();
        let knots = rows::<2>(&case["attractor_knots"]);
        assert_eq!(points.len(), knots.len());
        for (ours, theirs) in points.iter().zip(knots) {
            assert!(ours.distance(theirs.into()) < 2e-6, "{ours}");
        }
        // 1136.6 is the diagonal of the leaf.
        near(100.0 * fit.gaps().1 / 1_136.611_191_217_12, number(&case["gap_mean_pct"]), 1e-6, "the gap");
    }
}

/// The fit itself, where the leaf is at hand: a folder of outlines named in `FROND_LEAVES`.
#[test]
fn the_fit_of_a_leaf() {
    let Some(folder) = std::env::var_os("FROND_LEAVES") else { return };
    for case in file("leaf_rfif").as_array().unwrap() {
        let path = PathBuf::from(&folder).join(case["leaf"].as_str().unwrap()).with_extension("csv");
        let text = std::fs::read_to_string(path).expect("the leaf");
        let leaf: Vec<DVec2> = text
            .lines()
            .filter_map(|line| line.split_once(','))
            .map(|(x, y)| DVec2::new(x.trim().parse().unwrap(), y.trim().parse().unwrap()))
            .collect();
        let points: Vec<_> = numbers(&case["feature_indices"]).iter().map(|&i| leaf[i as usize]).collect();
        let options = CollageOptions {
            maps: case["K"].as_u64().unwrap() as usize,
            separable: case["mode"] == "sep",
            bounding: Bounding::Clipped,
            ..CollageOptions::default()
        };
        let fit = fit_collage(&points, &options).unwrap();
        for (ours, theirs) in fit.maps.iter().zip(case["maps"].as_array().unwrap()) {
            let theirs = ring_map(theirs);
            assert_eq!((ours.start, ours.reversed), (theirs.start, theirs.reversed));
            assert!(spectral_norm(ours.factor - theirs.factor) < 1e-8, "{ours:?} {theirs:?}");
            assert!(ours.offset.distance(theirs.offset) < 1e-5 && ours.step.distance(theirs.step) < 1e-5);
        }
        near(fit.collage, number(&case["collage_sse"]), 1e-5, "the collage");
    }
}
