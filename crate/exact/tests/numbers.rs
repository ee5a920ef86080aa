//! Exact numbers against identities of school, and against doubles.

use frond_exact::{ExactError, Number};

fn number(text: &str) -> Number {
    Number::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn identities_hold_exactly() {
    for (one, other) in [
        ("0.1+0.2", "0.3"),
        ("2*cos(pi/5)", "phi"),
        ("sqrt(2)*sqrt(3)", "sqrt(6)"),
        ("cos(pi/3)", "1/2"),
        ("i*i", "-1"),
        ("sin(pi/4)", "1/sqrt(2)"),
        ("phi*phi", "phi+1"),
        ("cos(pi/12)", "(sqrt(6)+sqrt(2))/4"),
        ("1/(1+i)", "(1-i)/2"),
    ] {
        assert!(number(one).minus(&number(other)).unwrap().is_zero(), "{one} {other}");
    }
    // 99/70 is near the root of two, and is not it.
    assert!(!number("sqrt(2)").minus(&number("99/70")).unwrap().is_zero());
}

#[test]
fn expressions_are_near_what_doubles_say() {
    let start = [
        ("1/3", 1.0 / 3.0),
        ("sqrt(2)", 2f64.sqrt()),
        ("sqrt(3)", 3f64.sqrt()),
        ("phi", 1.618_033_988_749_895),
    ];
    let mut all: Vec<(Number, f64)> = start.iter().map(|&(text, value)| (number(text), value)).collect();
    let mut seed = 7u64;
    let mut draw = |below: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % below
    };
    for _ in 0..24 {
        let (a, b) = (all[draw(all.len())].clone(), all[draw(start.len())].clone());
        let (exact, near) = match draw(4) {
            0 => (a.0.plus(&b.0), a.1 + b.1),
            1 => (a.0.minus(&b.0), a.1 - b.1),
            2 => (a.0.times(&b.0), a.1 * b.1),
            _ => (a.0.over(&b.0), a.1 / b.1),
        };
        let exact = exact.unwrap();
        let box_of = exact.enclosure().re;
        let room = 1e-9 * (1.0 + near.abs());
        assert!(box_of.lower() - room <= near && near <= box_of.upper() + room, "{exact} {near} {box_of:?}");
        if near.abs() < 1e3 && near.abs() > 1e-3 {
            all.push((exact, near));
        }
    }
}

#[test]
fn what_is_no_exact_number_is_refused() {
    assert_eq!(Number::parse("1/0").unwrap_err(), ExactError::DivisionByZero);
    assert!(Number::parse("1+").is_err());
    assert!(Number::parse("cos(1)").is_err());
}

#[test]
fn formulas_that_would_grow_without_end_are_refused() {
    for text in [
        format!("{}2{}", "(".repeat(30), ")^64".repeat(30)),
        format!("{}1+sqrt(2){}", "(".repeat(30), ")^64".repeat(30)),
        format!("{}1/3{}", "(".repeat(60), ")²".repeat(60)),
        format!("{}7{}", "sqrt(1+".repeat(25), ")".repeat(25)),
        "1+".repeat(101),
        "(".repeat(200),
        "sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)+sqrt(11)".into(),
        "2^(1/64)+3^(1/64)".into(),
    ] {
        assert!(Number::parse(&text).is_err(), "{text}");
    }
}
