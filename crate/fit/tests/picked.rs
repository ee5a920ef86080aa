//! Functions of maps that were picked by hand.

use frond_fit::{Features, FractalFunction, Model, Pick, assemble_picked};
use glam::DVec2;

/// Height of the arrowhead curve from `a` to `b` round `c` (heights of corners), at t in [0, 1].
fn arrowhead(t: f64, [a, b, c]: [f64; 3], depth: u32) -> f64 {
    if depth == 0 {
        return a + t * (b - a);
    }
    let middle = |x: f64, y: f64| f64::midpoint(x, y);
    let (p, q, corner) = (middle(a, c), middle(c, b), middle(a, b));
    let third = (3.0 * t).floor().clamp(0.0, 2.0);
    let within = 3.0 * t - third;
    match third as u32 {
        0 => arrowhead(within, [a, p, corner], depth - 1),
        1 => arrowhead(within, [p, q, c], depth - 1),
        _ => arrowhead(within, [q, b, corner], depth - 1),
    }
}

/// The hidden-variable function of Fig 4.
fn hidden(count: usize) -> Features {
    let t = |i: usize| i as f64 / (count - 1) as f64;
    let points: Vec<_> = (0..count).map(|i| DVec2::new(t(i), arrowhead(t(i), [0.0, 1.0, 0.5], 30))).collect();
    Features::new(&points).unwrap()
}

/// Table 3 in the fractions that it rounds.
fn table_3() -> [Pick; 7] {
    let third = 1.0 / 3.0;
    [
        ([-third, 0.0, -0.5, 2.0 / 9.0, 0.375], [5.0 / 18.0, 2.0 / 3.0]),
        ([third, 0.0, -0.5, 2.0 / 27.0, 0.5625], [1.0 / 6.0, 0.5]),
        ([third, 0.0, 0.5, 5.0 / 27.0, 0.0625], [1.0 / 6.0, 4.0 / 9.0]),
        ([third, 0.0, 0.5, third, 0.25], [0.0, 1.0]),
        ([-third, 0.0, -0.5, 22.0 / 27.0, 0.9375], [1.0 / 6.0, 4.0 / 9.0]),
        ([-third, 0.0, 0.5, 25.0 / 27.0, 0.4375], [1.0 / 6.0, 0.5]),
        ([third, 0.0, 0.5, 7.0 / 9.0, 0.625], [5.0 / 18.0, 2.0 / 3.0]),
    ]
    .map(|(map, domain)| Pick { map, domain })
}

#[test]
fn the_seven_maps_of_table_3_make_the_papers_function() {
    let (coarse, fine) = (hidden(55), hidden(163));
    // In another order: where they go is told by the maps.
    let mut picks = table_3();
    picks.rotate_left(3);
    let whole = assemble_picked(&coarse, &fine, &picks, false).unwrap();
    assert_eq!(whole.used, [4, 5, 6, 0, 1, 2, 3].map(Some));
    assert_eq!(whole.model, Model::Pfif);
    let expected = FractalFunction::pfif(&table_3().map(|pick| (pick.map, pick.domain))).unwrap();
    for i in 0..=1000 {
        let t = f64::from(i) / 1000.0;
        assert!((whole.function.at(t) - expected.at(t)).abs() < 1e-9, "at {t}");
    }
    // The paper has 0.000180 with its rounded maps.
    let squares = (0..=20_000).map(|i| f64::from(i) / 20_000.0);
    let squares = squares.map(|t| (whole.function.at(t) - arrowhead(t, [0.0, 1.0, 0.5], 30)).powi(2));
    assert!((squares.sum::<f64>() / 20_001.0 - 1.57e-4).abs() < 1e-6);
    assert!(whole.worst < 0.1, "{}", whole.worst);

    let tied = assemble_picked(&coarse, &fine, &picks, true).unwrap();
    assert_eq!(tied.model, Model::Rfif);
    assert!(tied.function.curve().widest_gap() < 1e-9);
    assert_eq!(tied.function.curve().pieces().len(), 11);
    assert!(tied.mean_square <= whole.mean_square, "{} {}", tied.mean_square, whole.mean_square);
}

#[test]
fn holes_are_straight_and_overlaps_are_cut() {
    let fine = hidden(163);
    let all = table_3();
    for tied in [false, true] {
        // A hole in front, in the middle and behind.
        let whole = assemble_picked(&hidden(55), &fine, &[all[1], all[3], all[5]], tied).unwrap();
        assert_eq!(whole.used, [None, Some(0), None, Some(1), None, Some(2), None], "{tied}");
        assert!(whole.worst.is_finite() && whole.worst < 1.0);
        // The same twice, and one that covers nearly all.
        let wide = Pick { map: [0.9, 0.0, 0.2, 0.05, 0.3], domain: [0.0, 1.0] };
        let whole = assemble_picked(&hidden(55), &fine, &[all[3], all[3], wide], tied).unwrap();
        let ranges: Vec<_> = whole.function.curve().pieces().iter().map(|piece| piece.range).collect();
        assert!(ranges.windows(2).all(|pair| pair[0][1] == pair[1][0]), "{ranges:?}");
        assert_eq!((ranges[0][0], ranges[ranges.len() - 1][1]), (0.0, 1.0));
    }
}

#[test]
fn what_is_no_copy_is_left_out() {
    let (coarse, fine) = (hidden(55), hidden(163));
    let odd = [
        ([f64::NAN; 5], [0.0, 1.0]),
        ([0.5, 0.0, 0.5, 0.0, 0.0], [f64::NAN, 1.0]),
        ([1.5, 0.0, 0.5, 0.0, 0.0], [0.0, 0.5]),
        ([0.0, 0.0, 0.5, 0.3, 0.0], [0.0, 1.0]),
        ([0.5, 0.0, 0.5, 7.0, 0.0], [0.0, 1.0]),
        ([0.5, 0.0, 0.5, 0.0, 0.0], [0.8, 0.2]),
        ([0.5, 0.0, 0.5, 0.0, 0.0], [5.0, 6.0]),
    ]
    .map(|(map, domain)| Pick { map, domain });
    for tied in [false, true] {
        let whole = assemble_picked(&coarse, &fine, &odd, tied).unwrap();
        assert_eq!(whole.used, [None, None], "{tied}");
        let middle = fine.at(whole.function.curve().pieces()[1].range[0]);
        // With tied ends heights are then polished.
        assert!(tied || (whole.function.at(0.25) - 0.5 * middle).abs() < 1e-9, "straight lines");
        assert_eq!(assemble_picked(&coarse, &fine, &[], tied).unwrap().used, [None, None]);
        let steep = Pick { map: [0.5, 0.0, 1.5, 0.0, 0.0], domain: [0.0, 1.0] };
        let whole = assemble_picked(&coarse, &fine, &[steep], tied).map_err(|error| error.code());
        assert_eq!(whole.is_err(), !tied, "with tied ends c is found anew");
    }
}
