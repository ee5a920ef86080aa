//! What the literature knows of well-known shapes.

use std::sync::Arc;

use frond_exact::{
    Analysis, BigInt, ComplexInterval, Element, Field, FieldMap, Interval, Number, OpenSetCondition, Reason,
    Settings, System, analyze,
};

/// An iterated function system of the plane or a line, as `factor | shift` in formulas.
fn system(maps: &[(&str, &str, bool)]) -> System {
    graph(&[maps.iter().map(|&(factor, shift, is_conjugated)| (0, factor, shift, is_conjugated)).collect()])
}

fn graph(states: &[Vec<(usize, &str, &str, bool)>]) -> System {
    let number = |text: &str| Number::parse(text).unwrap();
    let all: Vec<Number> =
        states.iter().flatten().flat_map(|(_, factor, shift, _)| [number(factor), number(shift)]).collect();
    let (field, elements) = Number::in_one_field(&all).unwrap();
    let mut rest = elements.into_iter();
    let mut next = || -> Element { rest.next().unwrap() };
    let states: Vec<Vec<FieldMap>> = states
        .iter()
        .map(|maps| {
            let map = |&(from, _, _, is_conjugated): &(usize, &str, &str, bool)| {
                let factor = next();
                FieldMap { from, factor, shift: next(), is_conjugated }
            };
            maps.iter().map(map).collect()
        })
        .collect();
    System::of_numbers(&Arc::clone(&field), &states).unwrap()
}

fn found(system: &System) -> Analysis {
    analyze(system, Settings::default(), |_| true).unwrap()
}

fn assert_dimension(analysis: &Analysis, known: f64) {
    let dimension = analysis.dimension.as_ref().unwrap();
    assert!(dimension.is_proved, "{analysis:?}");
    assert!(dimension.lower <= known + 1e-14 && known - 1e-14 <= dimension.upper, "{known} {dimension:?}");
    assert!(dimension.upper - dimension.lower < 1e-11, "{dimension:?}");
}

fn assert_tile(analysis: &Analysis, boundary: f64, neighbours: Option<usize>) {
    assert_eq!(analysis.open_set_condition, OpenSetCondition::Yes, "{:?}", analysis.reasons);
    assert_eq!(analysis.has_inner_points, Some(true));
    let dimension = &analysis.boundary.as_ref().unwrap().dimension;
    assert!((dimension.value - boundary).abs() < 1e-10, "{dimension:?}, known {boundary}");
    assert!(dimension.upper - dimension.lower < 1e-10, "{dimension:?}");
    if neighbours.is_some() {
        assert_eq!(analysis.neighbours, neighbours);
    }
}

/// 2 log x / log 2 with x^3 - x^2 - 2 = 0 (Gilbert 1984; x = 1.695620769559862).
fn dragon() -> f64 {
    2.0 * 1.695_620_769_559_862f64.ln() / 2f64.ln()
}

#[test]
fn curves_and_dusts_have_the_dimension_of_moran() {
    let gasket =
        found(&system(&[("1/2", "0", false), ("1/2", "1/2", false), ("1/2", "(1+i*sqrt(3))/4", false)]));
    assert_eq!(gasket.open_set_condition, OpenSetCondition::Yes);
    assert_eq!(gasket.neighbours, Some(6));
    assert_eq!((gasket.has_inner_points, gasket.boundary.is_none()), (Some(false), true));
    assert_dimension(&gasket, 3f64.ln() / 2f64.ln());

    let koch =
        [("1/3", "0"), ("(1+i*sqrt(3))/6", "1/3"), ("(1-i*sqrt(3))/6", "1/2+i*sqrt(3)/6"), ("1/3", "2/3")];
    let koch = found(&system(&koch.map(|(a, b)| (a, b, false))));
    assert_eq!(koch.open_set_condition, OpenSetCondition::Yes);
    assert_dimension(&koch, 4f64.ln() / 3f64.ln());
    assert_eq!(koch.dimension.unwrap().exact.as_deref(), Some("log 4 / log 3"));

    let dust = found(&system(&[("1/3", "0", false), ("1/3", "2/3", false)]));
    assert_eq!((dust.neighbours, dust.open_set_condition), (Some(0), OpenSetCondition::Yes));
    assert_dimension(&dust, 2f64.ln() / 3f64.ln());
    // (1/2)^s + (1/4)^s = 1: s = log phi / log 2.
    let uneven = found(&system(&[("1/2", "0", false), ("1/4", "3/4", false)]));
    assert_dimension(&uneven, 1.618_033_988_749_895f64.ln() / 2f64.ln());
}

#[test]
fn squares_and_segments_are_tiles() {
    let square = [("1/2", "0"), ("1/2", "1/2"), ("1/2", "i/2"), ("1/2", "(1+i)/2")];
    assert_tile(&found(&system(&square.map(|(a, b)| (a, b, false)))), 1.0, Some(8));
    let segment = found(&system(&[("1/3", "0", false), ("1/3", "1/3", false), ("1/3", "2/3", false)]));
    assert_tile(&segment, 0.0, Some(2));
    // Parts of two sizes: a golden section.
    let section = found(&system(&[("(sqrt(5)-1)/2", "0", false), ("(3-sqrt(5))/2", "(sqrt(5)-1)/2", false)]));
    assert_tile(&section, 0.0, None);
}

#[test]
fn dragons_have_their_boundaries() {
    let twin = found(&system(&[("(1+i)/2", "0", false), ("(1+i)/2", "1", false)]));
    assert_tile(&twin, dragon(), Some(6));
    let heighway = found(&system(&[("(1+i)/2", "0", false), ("(-1+i)/2", "1", false)]));
    assert_tile(&heighway, dragon(), None);
    // Duvall & Keesling 1999: 1.934007183.
    let levy = found(&system(&[("(1+i)/2", "0", false), ("(1-i)/2", "(1+i)/2", false)]));
    assert_eq!((levy.open_set_condition, levy.has_inner_points), (OpenSetCondition::Yes, Some(true)));
    assert!((levy.boundary.unwrap().dimension.value - 1.934_007_183).abs() < 1e-8);
}

#[test]
fn islands_of_the_triangular_lattice() {
    // The terdragon: log 4 / log 3.
    let terdragon = [
        ("(3+i*sqrt(3))/6", "0"),
        ("-i*sqrt(3)/3", "(3+i*sqrt(3))/6"),
        ("(3+i*sqrt(3))/6", "(3-i*sqrt(3))/6"),
    ];
    assert_tile(&found(&system(&terdragon.map(|(a, b)| (a, b, false)))), 4f64.ln() / 3f64.ln(), None);
    // Gosper's island: seven parts on a hexagonal lattice, 2 log 3 / log 7.
    let w = "(5-i*sqrt(3))/14";
    let unit: Vec<String> = (0..6).map(|k| format!("({w})*cos({k}*pi/3)+({w})*i*sin({k}*pi/3)")).collect();
    let mut maps = vec![(w, "0", false)];
    maps.extend(unit.iter().map(|shift| (w, shift.as_str(), false)));
    assert_tile(&found(&system(&maps)), 2.0 * 3f64.ln() / 7f64.ln(), Some(6));
}

#[test]
fn overlaps_of_the_golden_number_are_counted_once() {
    // x / phi and x / phi + 1 overlap exactly and fill a segment.
    let segment = found(&system(&[("(sqrt(5)-1)/2", "0", false), ("(sqrt(5)-1)/2", "1", false)]));
    assert_eq!(segment.open_set_condition, OpenSetCondition::No);
    assert_dimension(&segment, 1.0);
    // x/3, x/3 + 1, x/3 + 3: log((3 + sqrt 5)/2) / log 3 (Rao & Wen 1998; Ngai & Wang 2001, example 5.4).
    let triple = found(&system(&[("1/3", "0", false), ("1/3", "1", false), ("1/3", "3", false)]));
    assert_eq!(triple.open_set_condition, OpenSetCondition::No);
    assert_dimension(&triple, 2.618_033_988_749_895f64.ln() / 3f64.ln());
    let overlap = triple.reasons.iter().find_map(|reason| match reason {
        Reason::ExactOverlap(overlap) => Some(overlap.clone()),
        _ => None,
    });
    // 0/3 + 3/9 = 1/3 + .. : by hand, f_0 f_2 = f_1 f_0.
    let overlap = overlap.unwrap();
    let mut words = [overlap.first, overlap.second];
    words.sort();
    assert_eq!(words, [vec![0, 2], vec![1, 0]]);
}

#[test]
fn a_search_without_end_ends_by_its_budget() {
    let system = system(&[("2/3", "0", false), ("2/3", "1/3", false)]);
    let analysis = analyze(&system, Settings { budget: 500 }, |_| true).unwrap();
    assert_eq!(analysis.open_set_condition, OpenSetCondition::Undecided);
    assert!(matches!(analysis.reasons[0], Reason::BudgetSpent { .. }));
    assert!(!analysis.dimension.unwrap().is_proved);
    let stopped = analyze(&system, Settings::default(), |pairs| pairs < 100).unwrap();
    assert!(matches!(stopped.reasons[0], Reason::BudgetSpent { pairs } if pairs < 1000));
}

#[test]
fn the_tile_of_rauzy_has_its_boundary() {
    // The roots of x^3 - x^2 - x - 1; the boundary: 2 log x / log 1.8392867 with x^4 = 2 x + 1 (Ito & Kimura 1991).
    let within = ComplexInterval { re: Interval::new(-1.0, 0.0), im: Interval::new(0.1, 1.0) };
    let field = Arc::new(Field::of_root(&[-1, -1, -1, 1].map(BigInt::from), within).unwrap());
    let x = (0..200).fold(1.4f64, |x, _| x.mul_add(2.0, 1.0).sqrt().sqrt());
    let known = 2.0 * x.ln() / 1.839_286_755_214_161f64.ln();
    assert!((known - 1.0933).abs() < 1e-4);
    let (a, one, zero) = (field.generator(), field.one(), field.zero());
    let power = |k| field.power(&a, k).unwrap();
    let map = |from, factor: Element, shift: &Element| FieldMap {
        from,
        factor,
        shift: shift.clone(),
        is_conjugated: false,
    };
    let whole =
        vec![map(0, power(1), &zero), map(0, power(2), &one), map(0, power(3), &field.plus(&a, &one))];
    assert_tile(&found(&System::of_numbers(&field, &[whole]).unwrap()), known, None);
    // The substitution 1 -> 12, 2 -> 13, 3 -> 1.
    let first = (0..3).map(|from| map(from, a.clone(), &zero)).collect();
    let states = [first, vec![map(0, a.clone(), &one)], vec![map(1, a.clone(), &one)]];
    assert_tile(&found(&System::of_numbers(&field, &states).unwrap()), known, None);
}
