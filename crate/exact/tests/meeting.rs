//! Which pieces meet, with points of both.

use frond_exact::{ExactError, ExactNumber, ExactNumbers, Meeting, Number, System, meeting};

type Rows = Vec<[f64; 6]>;

/// What is found, each point checked by its coordinates.
fn found(rows: &Rows, formulas: &[&str], budget: usize) -> Meeting {
    let exact = ExactNumbers::read(formulas).unwrap().rows(rows).unwrap();
    let found = meeting(&exact.system().unwrap(), budget, |_| true).unwrap();
    for point in &found.points {
        let letters = |word: &[usize]| word.iter().map(|&letter| letter as u8).collect::<Vec<u8>>();
        let words =
            [0, 1].map(|k| [&point.addresses[k].head, &point.addresses[k].repeat].map(|word| letters(word)));
        assert!(exact.coincide([0, 1].map(|k| [&words[k][0][..], &words[k][1][..]])), "{point:?}");
        assert_eq!([0, 1].map(|k| point.addresses[k].head[0]), point.pieces);
    }
    // A tree for each set, and no more.
    assert_eq!(found.points.len(), rows.len() - found.count());
    found
}

fn value(formula: &str) -> f64 {
    ExactNumber::read(formula).unwrap().value()
}

fn copies(ratio: f64, shifts: &[[f64; 2]]) -> Rows {
    shifts.iter().map(|[e, f]| [ratio, 0.0, 0.0, ratio, *e, *f]).collect()
}

#[test]
fn the_pieces_of_curves_hang_together() {
    let third = 1.0 / 3.0;
    let (sixth, root) = (1.0 / 6.0, 3f64.sqrt() / 6.0);
    let koch = vec![
        [third, 0.0, 0.0, third, 0.0, 0.0],
        [sixth, -root, root, sixth, third, 0.0],
        [sixth, root, -root, sixth, 0.5, root],
        [third, 0.0, 0.0, third, 2.0 / 3.0, 0.0],
    ];
    let exact = found(&koch, &["1/3", "1/6", "√3/6", "2/3"], 5000);
    assert_eq!((exact.count(), exact.is_complete), (1, true));
    // In doubles they miss each other, or nothing is known of it.
    let double = found(&koch, &[], 200);
    assert!(double.count() > 1);
    // A dragon of Heighway, whose pieces share a curve.
    let heighway = vec![[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]];
    assert_eq!(found(&heighway, &[], 5000).count(), 1);
    // Maps of different ratios: a golden section.
    let [large, small] = ["(√5-1)/2", "(3-√5)/2"].map(value);
    let section = vec![[large, 0.0, 0.0, large, 0.0, 0.0], [small, 0.0, 0.0, small, large, 0.0]];
    assert_eq!(found(&section, &["(√5-1)/2", "(3-√5)/2"], 5000).count(), 1);
}

#[test]
fn what_does_not_meet_is_told() {
    let third = 1.0 / 3.0;
    let dust = found(&copies(third, &[[0.0, 0.0], [2.0 / 3.0, 0.0]]), &["1/3", "2/3"], 5000);
    assert_eq!((dust.sets, dust.is_complete), (vec![0, 1], true));
    // Two that meet at (1/2, 0), and one far above.
    let three = vec![
        [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
        [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
        [0.125, 0.0, 0.0, 0.125, 0.0, 5.0],
    ];
    let three = found(&three, &[], 5000);
    assert_eq!((three.sets, three.is_complete), (vec![0, 0, 1], true));
    // Five pentagons in a ring at the golden ratio, and at a ratio that is a little smaller.
    let pentagon = |ratio: &str| {
        let shift = |k: usize, word: &str| format!("{word}({}°)*(1-{ratio})", 72 * k + 18);
        let shifts: Vec<[String; 2]> = (0..5).map(|k| [shift(k, "cos"), shift(k, "sin")]).collect();
        let rows =
            copies(value(ratio), &shifts.iter().map(|of| [value(&of[0]), value(&of[1])]).collect::<Vec<_>>());
        let mut formulas: Vec<String> = shifts.into_iter().flatten().collect();
        formulas.push(ratio.into());
        found(&rows, &formulas.iter().map(String::as_str).collect::<Vec<_>>(), 5000)
    };
    let golden = pentagon("((3-√5)/2)");
    assert_eq!((golden.count(), golden.is_complete), (1, true));
    let smaller = pentagon("(381/1000)");
    assert_eq!((smaller.count(), smaller.is_complete), (5, true));
}

#[test]
fn only_systems_of_one_state_with_inverses_are_looked_at() {
    let flat = ExactNumbers::default().system(&[[0.5, 0.0, 0.0, 0.0, 0.0, 0.0]; 2]).unwrap();
    assert_eq!(meeting(&flat, 100, |_| true).unwrap_err(), ExactError::Singular { state: 0, map: 0 });
}

#[test]
fn a_search_that_is_stopped_says_so() {
    let rows = copies(0.75, &[[0.0, 0.0], [0.25, 0.1]]);
    let system = ExactNumbers::default().system(&rows).unwrap();
    assert!(!meeting(&system, 200, |_| true).unwrap().is_complete);
    assert!(!meeting(&system, 5000, |pairs| pairs < 50).unwrap().is_complete);
}

#[test]
fn copies_of_states_give_way_to_their_maps() {
    let row = |from: usize, factor: &str, shift: &str| {
        (from, vec![Number::parse(factor).unwrap(), Number::parse(shift).unwrap()])
    };
    let halves = vec![row(1, "1/2", "0"), row(1, "1/2", "1/2")];
    let system = System::of_rows(1, &[vec![row(1, "1", "0"), row(0, "1/3", "0")], halves]).unwrap();
    let maps: Vec<_> = system.without_copies().unwrap().in_doubles()[0]
        .iter()
        .map(|map| (map.from, map.matrix[0][0], map.shift[0]))
        .collect();
    assert_eq!(maps, [(1, 0.5, 0.0), (1, 0.5, 0.5), (0, 1.0 / 3.0, 0.0)]);
    let circle = System::of_rows(1, &[vec![row(1, "1", "0")], vec![row(0, "1", "0")]]).unwrap();
    assert!(circle.without_copies().is_none());
}
