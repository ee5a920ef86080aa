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

/// The cases of a file that are of a kind, whatever they are called, with their names.
fn cases(name: &str, kind: &str, is: impl Fn(&Value) -> bool) -> Vec<(String, Value)> {
    let all: Vec<(String, Value)> = match file(name) {
        Value::Object(cases) => cases.into_iter().collect(),
        Value::Array(cases) => cases.into_iter().enumerate().map(|(i, case)| (i.to_string(), case)).collect(),
        other => panic!("{name}.json has no cases: {other}"),
    };
    let found: Vec<_> = all.into_iter().filter(|(_, case)| is(case)).collect();
    assert!(!found.is_empty(), "{name}.json has no {kind}");
    found
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
    assert!((a - b).abs() <= tolerance * b.abs().max(1.0), "{what}: {a} is not {b}");
}

fn knots(case: &Value) -> Vec<DVec2> {
    if case["points"].is_array() {
        return rows::<2>(&case["points"]).into_iter().map(DVec2::from).collect();
    }
    let (t, x) = (numbers(&case["t_knots"]), numbers(&case["x_knots"]));
    t.into_iter().zip(x).map(|(t, x)| DVec2::new(t, x)).collect()
}

fn compare(name: &str, case: &Value, function: &FractalFunction, tolerance: f64) {
    let maps = rows::<5>(&case["maps_abcde"]);
    assert_eq!(function.curve().pieces().len(), maps.len(), "{name}");
    for (piece, map) in function.curve().pieces().iter().zip(maps) {
        for (ours, theirs) in piece.map().into_iter().zip(map) {
            near(ours, theirs, 1e-12, &format!("{name}, a number of a map"));
        }
    }
    let exact = if case["F_exact"].is_array() { &case["F_exact"] } else { &case["F"] };
    let (times, values) = (numbers(&case["t"]), numbers(exact));
    assert!(!times.is_empty() && times.len() == values.len(), "{name}");
    for (t, value) in times.into_iter().zip(values) {
        near(function.at(t), value, tolerance, &format!("{name}, F({t})"));
    }
    for knot in knots(case) {
        near(function.at(knot.x), knot.y, tolerance, &format!("{name}, a knot"));
    }
    if let Some(integral) = case["integral"].as_f64() {
        near(function.integral().expect("whole domains"), integral, 1e-12, &format!("{name}, the integral"));
    }
    if let Some(dimension) = case["box_dim_formula"].as_f64() {
        let Dimension::Equation(found) = function.dimension() else { panic!("{name}: domains are whole") };
        near(found, dimension, 1e-12, &format!("{name}, the dimension"));
    }
}

#[test]
fn interpolation_functions() {
    for (name, case) in
        cases("fif", "interpolation function", |case| case["c"].is_array() && case["jk"].is_null())
    {
        let reflected: Vec<bool> = match &case["reflect"] {
            Value::Null => vec![false; numbers(&case["c"]).len()],
            flags => numbers(flags).iter().map(|&x| x != 0.0).collect(),
        };
        let function = FractalFunction::fif(&knots(&case), &numbers(&case["c"]), &reflected).unwrap();
        compare(&name, &case, &function, 1e-12);
        let size = knots(&case).iter().fold(1.0, |most: f64, knot| most.max(knot.y.abs()));
        assert!(function.curve().widest_gap() < 1e-14 * size, "{name}");
    }
}

#[test]
fn recurrent_functions() {
    for (name, case) in cases("fif", "recurrent function", |case| case["jk"].is_array()) {
        let spans: Vec<_> =
            rows::<2>(&case["jk"]).into_iter().map(|[j, k]| (j as usize, k as usize)).collect();
        let function = FractalFunction::rfif(&knots(&case), &numbers(&case["c"]), &spans).unwrap();
        compare(&name, &case, &function, 1e-9);
    }
}

/// Tables of maps that all copy one domain, and may leave a jump where they meet.
#[test]
fn tables_of_maps() {
    let is_table = |case: &Value| case["domain"].is_array() && case["maps_abcde"].is_array();
    for (name, case) in cases("fif", "table of maps", is_table) {
        let domain: [f64; 2] = numbers(&case["domain"]).try_into().unwrap();
        let rows = rows::<5>(&case["maps_abcde"]);
        let function =
            FractalFunction::pfif(&rows.iter().map(|&map| (map, domain)).collect::<Vec<_>>()).unwrap();
        let tell = |what: &str| format!("{name}, {what}");
        for (t, key) in domain.into_iter().zip(["F_left", "F_right"]) {
            near(function.at(t), number(&case[key]), 1e-14, &tell(key));
        }
        // Where the piece that begins at the left ends.
        let ends = |[a, _, _, d, _]: &[f64; 5]| domain.map(|t| a * t + d);
        let first = rows.iter().map(ends).find(|ends| ends.iter().any(|t| (t - domain[0]).abs() < 1e-12));
        let [from, to] = first.expect("a piece at the left end");
        let join = from.max(to);
        for (side, key) in [(Side::Left, "join_left_limit"), (Side::Right, "join_right_limit")] {
            near(function.limit(join, side, 0.0), number(&case[key]), 1e-14, &tell(key));
        }
        let Dimension::Equation(dimension) = function.dimension() else {
            panic!("{name}: domains are whole")
        };
        near(dimension, number(&case["box_dim_formula"]), 1e-12, &tell("the dimension"));
        let sets: Vec<&Value> =
            case.as_object().unwrap().values().filter(|set| set["t"].is_array()).collect();
        assert!(!sets.is_empty(), "{name} has no feature points");
        for features in sets {
            for (t, x) in numbers(&features["t"]).into_iter().zip(numbers(&features["x"])) {
                // At images of a jump the function has two values, and the points hold one of them.
                let values = [Side::Left, Side::Right].map(|side| function.limit(t, side, 0.0));
                let off = values.map(|value| (value - x).abs()).into_iter().fold(f64::INFINITY, f64::min);
                assert!(off < 1e-9, "{name}: F({t}) is {values:?}, not {x}");
            }
        }
    }
}

/// Tables of maps with a domain each, for functions whose values are given: a table and the values of its function are
/// told by what is in them.
#[test]
fn tables_of_maps_with_domains() {
    let is_table = |value: &Value| value[0]["abcde"].is_array() && value[0]["domain"].is_array();
    let has_table = |case: &Value| case.as_object().is_some_and(|case| case.values().any(is_table));
    for (name, case) in cases("hidden_variable", "table of maps with domains", has_table) {
        let times = numbers(&case["t"]);
        for (table, list) in case.as_object().unwrap().iter().filter(|(_, value)| is_table(value)) {
            let row = |row: &Value| {
                (numbers(&row["abcde"]).try_into().unwrap(), numbers(&row["domain"]).try_into().unwrap())
            };
            let maps: Vec<_> = list.as_array().unwrap().iter().map(row).collect();
            let function = FractalFunction::pfif(&maps).unwrap();
            let prefix = format!("{table}_F");
            let values = case.as_object().unwrap().iter().find(|(key, _)| key.starts_with(&prefix));
            let values = numbers(values.unwrap_or_else(|| panic!("{name} has no values of {table}")).1);
            assert!(!times.is_empty() && times.len() == values.len(), "{name}");
            for (&t, value) in times.iter().zip(values) {
                near(function.at(t), value, 1e-9, &format!("{name}, {table}: F({t})"));
            }
        }
    }
}

/// The fits of leaves, as the file has them.
fn leaves() -> Vec<(String, Value)> {
    cases("leaf_rfif", "fit of a leaf", |case| case["maps"].is_array())
}

/// The diagonal of a leaf, which the file gives by its errors: as a sum of squares over the points of all ranges, and
/// as a mean in per cent of the diagonal.
fn diagonal(case: &Value) -> f64 {
    let points = number(&case["K"]) * (number(&case["M"]) + 1.0);
    let mean = (number(&case["collage_sse"]) / points).sqrt();
    100.0 * mean / number(&case["collage_rms_pct_diag"])
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
    for (name, case) in leaves() {
        let maps: Vec<_> = case["maps"].as_array().unwrap().iter().map(ring_map).collect();
        let intervals = case["M"].as_u64().unwrap() as usize;
        let fit = CollageFit { maps, intervals, separable: case["mode"] == "sep", collage: 0.0 };
        let (points, _) = fit.attractor();
        let knots = rows::<2>(&case["attractor_knots"]);
        assert_eq!(points.len(), knots.len());
        for (ours, theirs) in points.iter().zip(knots) {
            assert!(ours.distance(theirs.into()) < 2e-9 * diagonal(&case), "{name}: {ours}");
        }
        near(
            100.0 * fit.gaps().1 / diagonal(&case),
            number(&case["gap_mean_pct"]),
            1e-6,
            &format!("{name}, the gap"),
        );
    }
}

/// The fit itself, where the leaf is at hand: a folder of outlines named in `FROND_LEAVES`.
#[test]
fn the_fit_of_a_leaf() {
    let Some(folder) = std::env::var_os("FROND_LEAVES") else { return };
    for (name, case) in leaves() {
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
        near(fit.collage, number(&case["collage_sse"]), 1e-9, &format!("{name}, the collage"));
    }
}
