//! Which numbers doubles stand for.

use frond_exact::{ExactError, ExactNumbers, Number, OpenSetCondition, Settings, analyze};

const THIRD: f64 = 1.0 / 3.0;

#[test]
fn a_double_stands_for_the_number_that_it_is_nearest_to() {
    let numbers = ExactNumbers::read(&["1/3", "-√3/6", "cos(60°)/3"]).unwrap();
    let meant = |value: f64| numbers.meant(value);
    assert_eq!(meant(THIRD), Some(Number::parse("1/3").unwrap()));
    assert_eq!(meant(-THIRD), Some(Number::parse("-1/3").unwrap()));
    let root = 3f64.sqrt() / 6.0;
    assert_eq!(meant(root), Some(Number::parse("sqrt(3)/6").unwrap()));
    assert_eq!(meant(-root), Some(Number::parse("-sqrt(3)/6").unwrap()));
    assert_eq!(meant(THIRD.next_up()), None);
    assert_eq!((meant(0.25), meant(f64::NAN)), (None, None));
    assert_eq!((meant(0.0), ExactNumbers::default().meant(THIRD)), (None, None));
    let rows = numbers.rows(&[[THIRD, 0.1, root, -THIRD, 0.5, 0.0]]).unwrap();
    assert_eq!(rows.named(), [(0, 0), (0, 2), (0, 3)]);
    let tenth = rows.field().as_rational(&rows.rows()[0][1]).unwrap().to_string();
    assert_eq!(tenth, "3602879701896397/36028797018963968");
}

#[test]
fn lists_that_say_no_numbers_are_refused() {
    let wrong = |formulas: &[&str]| {
        let wrong = ExactNumbers::read(formulas).unwrap_err();
        (wrong.index, wrong.error)
    };
    assert_eq!(wrong(&["1/2", "i"]), (1, ExactError::NotReal));
    assert_eq!(wrong(&["1/3", "0.3333333333333333"]), (1, ExactError::SameDouble));
    assert_eq!(wrong(&["-1/3", "0.3333333333333333"]), (1, ExactError::SameDouble));
    assert_eq!(wrong(&["1e-350"]), (0, ExactError::NoDouble));
    assert_eq!(wrong(&["10^350"]), (0, ExactError::NotExact { at: 6 }));
    assert_eq!(wrong(&["2*10^64*10^64*10^64*10^64*10^64"]), (0, ExactError::NoDouble));
    assert!(matches!(wrong(&["1/"]), (0, ExactError::NotFormula { .. })));
    assert_eq!(wrong(&["1/2"; 65]), (64, ExactError::TooMany { count: 65, most: 64 }));
    // The same number, also with the other sign.
    assert!(ExactNumbers::read(&["1/3", "2/6", "-1/3", "0", "-0"]).is_ok());
    let rows = ExactNumbers::default().rows(&[[f64::INFINITY; 6]]);
    assert_eq!(rows.unwrap_err(), ExactError::Malformed);
    let numbers = ["sqrt(2)", "sqrt(3)", "sqrt(5)", "sqrt(7)", "sqrt(11)"];
    let row = [2f64, 3.0, 5.0, 7.0, 11.0, 0.0].map(f64::sqrt);
    let rows = ExactNumbers::read(&numbers).unwrap().rows(&[row]);
    assert!(rows.is_err());
}

/// Koch's curve, with the numbers that are said or as doubles.
fn koch(formulas: &[&str]) -> frond_exact::Analysis {
    let (sixth, root) = (1.0 / 6.0, 3f64.sqrt() / 6.0);
    let rows = [
        [THIRD, 0.0, 0.0, THIRD, 0.0, 0.0],
        [sixth, -root, root, sixth, THIRD, 0.0],
        [sixth, root, -root, sixth, 0.5, root],
        [THIRD, 0.0, 0.0, THIRD, 2.0 / 3.0, 0.0],
    ];
    let system = ExactNumbers::read(formulas).unwrap().system(&rows).unwrap();
    analyze(&system, Settings { budget: 1000 }, |_| true).unwrap()
}

#[test]
fn what_is_typed_is_what_is_proved() {
    let exact = koch(&["1/3", "cos(60°)/3", "√3/6", "2/3"]);
    assert_eq!(exact.open_set_condition, OpenSetCondition::Yes);
    // log 4 / log 3 = 1.26185950714291487..
    let dimension = exact.dimension.unwrap();
    assert!(dimension.is_proved && (dimension.value - 1.261_859_507_142_914_9).abs() < 1e-14);
    // As doubles the maps do not even have one ratio.
    assert_ne!(koch(&[]).neighbours, exact.neighbours);
}

#[test]
fn one_point_has_several_addresses() {
    let rows = [0.0, THIRD, 2.0 / 3.0].map(|e| [THIRD, 0.0, 0.0, 0.0, e, 0.0]);
    let exact = ExactNumbers::read(&["1/3", "2/3"]).unwrap().rows(&rows).unwrap();
    // 1/3 = 0.0222.. = 0.1000.. to the base three.
    assert!(exact.coincide([[&[0], &[2]], [&[1], &[0]]]));
    assert!(exact.coincide([[&[1], &[2, 2]], [&[2, 0, 0], &[0]]]));
    assert!(!exact.coincide([[&[0], &[2]], [&[1], &[1]]]));
    assert!(!exact.coincide([[&[0], &[2]], [&[1], &[7]]]) && !exact.coincide([[&[0], &[]], [&[0], &[]]]));
    // In doubles the points are apart.
    let double = ExactNumbers::default().rows(&rows).unwrap();
    assert!(!double.coincide([[&[0], &[2]], [&[1], &[0]]]));
    // Two maps by half of the area each.
    let half = 0.5f64.sqrt();
    let rows = [[half, 0.0, 0.0, -half, 0.0, 0.0], [0.0, half, half, 0.0, 1.0, 0.0]];
    let fills =
        |formulas: &[&str]| ExactNumbers::read(formulas).unwrap().rows(&rows).unwrap().areas_fill(0, 1);
    assert!(fills(&["1/√2"]));
    assert_eq!(fills(&[]), half * half >= 0.5 && fills(&["0.7071067811865476"]));
}

#[test]
fn the_root_is_isolated_by_few_digits() {
    let within = |formula: &str, value: f64| {
        let numbers = ExactNumbers::read(&[formula]).unwrap();
        let rows = numbers.rows(&[[value, 0.0, 0.0, 0.5, 0.0, 0.0]]).unwrap();
        rows.root_within().unwrap().map(|x| x.to_f64())
    };
    assert_eq!(within("√3/6", 3f64.sqrt() / 6.0), [1.732_050, 1.732_051]);
    assert_eq!(within("1/3", THIRD), [-1.0, 1.0]);
}

#[test]
fn carpets_of_rectangles_have_a_bound_of_their_dimension() {
    // Rectangles of 1/4 by 1/2: for s from 1 to 2 the singular values add up to n (1/2) (1/4)^(s - 1), which is one for
    // n = 3 at s = 1 + log(3/2) / log 4 (Falconer 1988).
    let rows = [[0.0, 0.0], [0.25, 0.5], [0.75, 0.0]].map(|[e, f]| [0.25, 0.0, 0.0, 0.5, e, f]);
    let of = |rows: &[[f64; 6]]| {
        let system = ExactNumbers::default().system(rows).unwrap();
        analyze(&system, Settings::default(), |_| true).unwrap()
    };
    let found = of(&rows);
    let dimension = found.dimension.unwrap();
    let known = 1.0 + 1.5f64.ln() / 4f64.ln();
    assert!(known <= dimension.upper && dimension.upper < known + 1e-8, "{known} {dimension:?}");
    assert_eq!((dimension.is_proved, dimension.lower, dimension.value), (false, 0.0, dimension.upper));
    assert_eq!(found.has_inner_points, Some(false));
    // Two of them: 2 (1/2)^s = 1 at s = 1.
    let upper = of(&rows[..2]).dimension.unwrap().upper;
    assert!((1.0..1.0 + 1e-8).contains(&upper), "{upper}");
    // Eight fill a square: there is no bound below that of the plane.
    let eight: Vec<[f64; 6]> =
        (0..8).map(|k| [0.25, 0.0, 0.0, 0.5, f64::from(k % 4) / 4.0, f64::from(k / 4) / 2.0]).collect();
    let full = of(&eight);
    assert_eq!((full.dimension.unwrap().upper, full.has_inner_points), (2.0, None));
    // A word may be much smaller than its letters: each stretches one axis that the other shrinks.
    let turned = [[0.0, -0.25, 0.75, 0.0, 0.0, 0.0], [0.0, -0.25, 0.75, 0.0, 1.0, 0.0]];
    let upper = of(&turned).dimension.unwrap().upper;
    // Of two letters the linear part is that of a turn by a half and -3/16: 4 (3/16)^(s/2 * 2) = 1 at log 4 /
    // log(16/3).
    assert!((upper - 4f64.ln() / (16.0f64 / 3.0).ln()).abs() < 1e-8, "{upper}");
}
