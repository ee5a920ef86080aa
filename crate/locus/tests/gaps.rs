//! Bounds of the widest gap are bounds: whatever epsilon, budget, size and coordinates, the true one lies between them.

use frond_core::{Affine2, Affine3, Ifs, Ifs3, IfsError, hash};
use frond_locus::{
    Connectedness, Options, Scratch, State, Verdict, connectedness, connectedness3, decide, decide_bounds,
};
use glam::{DMat2, DMat3, DQuat, DVec2, DVec3};

fn rows(rows: &[[f64; 6]]) -> Vec<Affine2> {
    rows.iter().copied().map(Affine2::from_row).collect()
}

fn answer(maps: &[Affine2], epsilon: f64, budget: usize) -> Connectedness {
    connectedness(&Ifs::new(maps.to_vec()).unwrap(), &Options { epsilon, budget })
}

const EPSILONS: [f64; 6] = [0.1, 1.0 / 600.0, 1e-6, 1e-9, 1e-12, 0.0];

/// The bounds, in the plane, that the two answers give at several epsilons.
fn intervals(maps: &[Affine2], budget: usize) -> Vec<(String, f64, f64)> {
    let full = |epsilon: f64| {
        let a = answer(maps, epsilon, budget);
        let context = format!("{:?} at {epsilon:e}, {budget}", a.verdict);
        assert!(a.gap.upper <= a.diameter, "{a:?}");
        (context, a.gap.lower, a.gap.upper)
    };
    let fast = |epsilon: f64| {
        let known = decide_bounds(maps, epsilon, budget, &mut Scratch::default());
        let context = format!("fast {:?} at {epsilon:e}, {budget}", known.sample.state);
        // What the product is rounded by is no part of the bound.
        let lower = (known.lower * known.diameter * (1.0 - f64::EPSILON)).next_down().max(0.0);
        let upper = known.upper * known.diameter;
        (context, lower, if upper.is_nan() { f64::INFINITY } else { upper.next_up() })
    };
    EPSILONS.into_iter().map(full).chain(EPSILONS.into_iter().map(fast)).collect()
}

/// Checks that one gap may lie between all these bounds; returns the bounds of that.
fn one_gap(all: &[(String, f64, f64)], context: &str) -> (f64, f64) {
    let (mut lower, mut upper) = ((0.0, ""), (f64::INFINITY, ""));
    for (said, low, high) in all {
        assert!(0.0 <= *low && low <= high, "{said}: {low:e} to {high:e}, {context}");
        lower = if *low > lower.0 { (*low, said) } else { lower };
        upper = if *high < upper.0 { (*high, said) } else { upper };
    }
    assert!(lower.0 <= upper.0, "{lower:?} {upper:?} {context}");
    (lower.0, upper.0)
}

#[test]
fn pieces_that_were_joined_for_being_near_count_as_far_apart_as_they_are() {
    let maps = rows(&[
        [0.265625, -0.15625, -0.15625, -0.265625, 2.1905354948383965e-7, 1.2005385239834455e-7],
        [0.265625, -0.078125, -0.078125, -0.265625, 0.265625, -0.15625],
        [0.015625, -0.03125, -0.03125, -0.015625, 0.53125, -0.234375],
        [0.453125, -0.015625, 0.265625, 0.09375, 0.546875, -0.265625],
    ]);
    let (lower, upper) = one_gap(&intervals(&maps, 400_000), "");
    assert!(lower > 1e-7 && upper < 2e-7 && upper < 1.02 * lower, "{lower:e} {upper:e}");
}

#[test]
fn lengths_of_flat_shapes_are_measured_with_the_rounding_of_their_shear() {
    let maps = rows(&[
        [-0.125, 0.0, 0.0, -0.125, 124928.0, -0.75],
        [-0.21875, -16640.0, 3.814697265625e-6, 0.21875, -20480.0, 0.5],
        [-0.125, 0.0, 0.0, -0.125, 22528.0, 0.75],
    ]);
    let (lower, upper) = one_gap(&intervals(&maps, 400_000), "");
    assert!(lower > 81_513.0 && upper < 81_514.0, "{lower} {upper}");
}

/// A number from -1 to 1.
fn number(seed: u32, index: u32) -> f64 {
    f64::from(hash::counter(seed, index)) / f64::from(u32::MAX) * 2.0 - 1.0
}

/// Some maps: round, singular, reflecting or nearly meeting ones, most of them seen in coordinates that stretch or
/// shear them up to a million times, so that they contract in an ellipse only.
fn system(seed: u32) -> Option<Vec<Affine2>> {
    let at = |k| number(seed, k);
    let pick = |k, of| hash::counter(seed, k) % of;
    let count = 2 + pick(0, 4);
    let size = 0.35 + 0.3 * at(1);
    let map = |i: u32| {
        let at = |k| number(seed, 100 * (i + 1) + k);
        let turned = DMat2::from_angle(3.2 * at(0)) * size;
        let linear = match pick(100 * (i + 1), 6) {
            0 => DMat2::from_diagonal(DVec2::new(size, 0.0)),
            1 => turned * DMat2::from_diagonal(DVec2::new(1.0, -at(1))),
            2 => DMat2::from_cols(DVec2::new(at(1), at(2)), DVec2::new(at(3), at(4))) * (0.7 * size),
            3 => DMat2::from_diagonal(DVec2::splat(size)),
            _ => turned,
        };
        // Coefficients of few digits make gaps that are small, and pieces that all but meet.
        let short = |x: f64| if seed.is_multiple_of(2) { (64.0 * x).round() / 64.0 } else { x };
        Affine2::new(
            DMat2::from_cols_array(&linear.to_cols_array().map(short)),
            DVec2::new(short(at(5)), short(at(6))),
        )
    };
    let stretch = 10.0_f64.powf(3.0 * (1.0 + at(2)));
    let by = match pick(3, 4) {
        0 => DMat2::IDENTITY,
        1 => DMat2::from_cols(DVec2::X, DVec2::new(stretch, 1.0)),
        2 => DMat2::from_diagonal(DVec2::new(stretch, 1.0)) * DMat2::from_angle(at(4)),
        _ => DMat2::from_angle(at(4)) * DMat2::from_cols(DVec2::X, DVec2::new(stretch, 1.0)),
    };
    let maps: Option<Vec<_>> = (0..count).map(|i| map(i).conjugate(Affine2::new(by, DVec2::ZERO))).collect();
    maps.filter(|maps| Ifs::new(maps.clone()).is_ok())
}

/// The same shape in a mirror that takes x for y, exactly, its maps in another order: all roundings are other ones.
fn mirrored(maps: &[Affine2]) -> Vec<Affine2> {
    let rows = maps.iter().rev().map(|map| map.to_row());
    rows.map(|[a, b, c, d, e, f]| Affine2::from_row([d, c, b, a, f, e])).collect()
}

#[test]
fn whatever_epsilon_budget_and_coordinates_one_gap_lies_between_all_bounds() {
    let (mut tried, mut apart) = (0, 0);
    for seed in 0..150 {
        let Some(maps) = system(seed) else { continue };
        let mut all = intervals(&maps, 3000);
        all.extend(intervals(&maps, 60));
        let other = mirrored(&maps);
        if Ifs::new(other.clone()).is_ok() {
            all.extend(intervals(&other, 3000));
        }
        let (lower, _) = one_gap(&all, &format!("{seed}: {maps:?}"));
        tried += 1;
        apart += usize::from(lower > 0.0);
    }
    assert!(tried > 110 && apart > 50, "{tried} {apart}");
}

/// Two or three turned or mirrored similitudes of short numbers, 2^-bits or a half of that; the first fixes 0.
fn short_similitudes(seed: u32, bits: i32) -> Vec<Affine2> {
    let map = |k: u32| {
        let pick = |i, of| hash::counter(seed, 10 * k + i) % of;
        let ratio = 2.0_f64.powi(-bits - pick(0, 2) as i32);
        let (sin, cos) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][pick(1, 4) as usize];
        let mirror = if pick(2, 2) == 0 { 1.0 } else { -1.0 };
        let linear = DMat2::from_cols(DVec2::new(cos, sin), DVec2::new(-sin, cos) * mirror) * ratio;
        let short = |i| f64::from(pick(i, 33)) / 16.0 - 1.0;
        let shift = DVec2::new(short(3), short(4));
        Affine2::new(linear, if k == 0 { DVec2::ZERO } else { shift })
    };
    (0..2 + seed % 2).map(map).collect()
}

/// Bounds of the widest gap of short similitudes seen in the coordinates that `from` takes to the plane: the points of
/// so many letters are computed without rounding.
fn true_gap(maps: &[Affine2], from: DMat2, letters: usize) -> (f64, f64) {
    let mut points = vec![DVec2::ZERO];
    for _ in 1..letters {
        points = points.iter().flat_map(|&p| maps.iter().map(move |map| map.apply(p))).collect();
    }
    let pieces: Vec<Vec<DVec2>> =
        maps.iter().map(|map| points.iter().map(|&p| map.apply(p)).collect()).collect();
    // How far points of longer words may be from these: translations are no longer than 1.5, ratios no more than a
    // quarter.
    let largest = maps.iter().map(|map| map.norm()).fold(0.0, f64::max);
    let rest = 2.0 * largest.powi(letters as i32) * 2.0;
    let apart = |i: usize, j: usize| {
        let (mut lower, mut upper) = (f64::INFINITY, f64::INFINITY);
        for &p in &pieces[i] {
            for &q in &pieces[j] {
                let there = from * (p - q);
                let length = there.length();
                let along = from.transpose() * there.normalize_or_zero();
                lower = f64::min(lower, length * (1.0 - 1e-15) - rest * along.length() * (1.0 + 1e-9));
                upper = f64::min(upper, length * (1.0 + 1e-15));
            }
        }
        (lower, upper)
    };
    match maps.len() {
        2 => apart(0, 1),
        _ => {
            // The two shorter sides of a triangle are its least spanning tree.
            let sides = [apart(0, 1), apart(1, 2), apart(0, 2)];
            let middle = |mut sides: [f64; 3]| {
                sides.sort_by(f64::total_cmp);
                sides[1]
            };
            (middle(sides.map(|side| side.0)), middle(sides.map(|side| side.1)))
        }
    }
}

#[test]
fn the_gap_of_flat_shapes_is_the_true_one() {
    let (mut apart, mut tight) = (0, 0);
    // Of smaller pieces the truth is known to more digits: to fewer than rounding in doubles would take.
    let small = (360..430).map(|seed| (seed, 3));
    for (seed, bits) in (0..240).map(|seed| (seed, 2)).chain(small) {
        let maps = short_similitudes(seed, bits + seed as i32 % 3);
        let shear = 2.0_f64.powi([3, 6, 8, 11, 14, 17][seed as usize % 6]);
        let from = match seed / 6 % 3 {
            0 => DMat2::from_cols(DVec2::X, DVec2::new(shear, 1.0)),
            1 => DMat2::from_cols(DVec2::new(1.0, shear), DVec2::Y),
            _ => DMat2::from_cols(DVec2::new(shear, 0.0), DVec2::Y),
        };
        // All without rounding: sums of two products of short numbers.
        let flat: Vec<_> =
            maps.iter().map(|map| map.conjugate(Affine2::new(from, DVec2::ZERO)).unwrap()).collect();
        if Ifs::new(flat.clone()).is_err() {
            continue;
        }
        let (lower, upper) = true_gap(&maps, from, if maps.len() == 2 { 8 } else { 6 });
        let known = intervals(&flat, 20_000);
        for (said, low, high) in &known {
            let context =
                format!("{seed}: {said}, {low:e} to {high:e}, truly {lower:e} to {upper:e}, {flat:?}");
            assert!(*low <= upper && lower <= *high, "{context}");
            if bits == 2 && said.starts_with("Disc") {
                apart += 1;
                tight += usize::from(*high <= 1.02 * low);
            }
        }
    }
    // Of some others the budget is spent, or the digits of the coefficients do not tell.
    assert!(apart > 1200 && 100 * tight > 97 * apart, "{apart} {tight}");
}

#[test]
fn a_distance_that_the_digits_do_not_tell_leaves_the_budget_to_the_widest_gap() {
    // The first two pieces lie beside each other, 5.5e-4 to 5.8e-4 apart in a shape 1700 long.
    let maps = rows(&[
        [512.0, -0.25, 1048576.25, -512.0, 0.0, 0.0],
        [-256.0, 0.125, -524287.875, 256.0, -0.0625, -129.0],
        [256.0, -0.125, 524287.875, -256.0, 0.5, 1024.75],
    ]);
    let said = answer(&maps, 1e-3, 20_000);
    assert!(said.gap.lower > 301.0 && said.gap.upper < 303.0 && said.nodes < 2000, "{said:?}");
}

/// The maps in a plane of another unit.
fn scaled(maps: &[Affine2], power: i32) -> Vec<Affine2> {
    let half = [power / 2, power - power / 2].map(|power| 2.0_f64.powi(power));
    maps.iter().map(|map| Affine2::new(map.linear, map.translation * half[0] * half[1])).collect()
}

#[test]
fn a_shape_of_any_size_has_the_same_gap_in_its_own_unit() {
    // From 1e-160 to 1e98, the translations up to a million times as long.
    let powers = [-531, -400, -333, -331, -200, 200, 305];
    let mut apart = 0;
    for seed in 0..20 {
        let Some(maps) = system(seed) else { continue };
        for epsilon in [1.0 / 600.0, 1e-9] {
            let here = answer(&maps, epsilon, 2000);
            let known = decide_bounds(&maps, epsilon, 2000, &mut Scratch::default());
            apart += usize::from(here.verdict == Verdict::Disconnected);
            for power in powers {
                let large = |x: f64| x * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2);
                let context = format!("{seed}, 2^{power}, {epsilon:e}: {here:?}");
                let there = answer(&scaled(&maps, power), epsilon, 2000);
                assert_eq!((there.verdict, &there.overlaps), (here.verdict, &here.overlaps), "{context}");
                assert_eq!(there.gap.lower.to_bits(), large(here.gap.lower).to_bits(), "{there:?} {context}");
                assert_eq!(there.gap.upper.to_bits(), large(here.gap.upper).to_bits(), "{there:?} {context}");
                assert_eq!(there.diameter, large(here.diameter), "{context}");
                let closest = here.closest.map(|(p, q)| [p.x, p.y, q.x, q.y].map(large));
                assert_eq!(there.closest.map(|(p, q)| [p.x, p.y, q.x, q.y]), closest, "{context}");
                let fast = decide_bounds(&scaled(&maps, power), epsilon, 2000, &mut Scratch::default());
                assert_eq!(fast.sample.state, known.sample.state, "{context}");
                let numbers = [fast.lower, fast.upper, f64::from(fast.sample.gap)];
                let wanted = [known.lower, known.upper, f64::from(known.sample.gap)];
                assert_eq!(
                    numbers.map(f64::to_bits),
                    wanted.map(f64::to_bits),
                    "{fast:?} {known:?} {context}"
                );
                assert_eq!(fast.diameter.to_bits(), large(known.diameter).to_bits(), "{context}");
            }
        }
    }
    assert!(apart > 15, "{apart}");
}

/// Dust in halves of a half, the least that doubles hold: its gap is a half of it.
#[test]
fn shapes_that_are_almost_too_small_for_doubles_are_measured_outward_or_not_at_all() {
    for power in [-500, -900, -1000, -1060, -1072, -1074] {
        let maps =
            scaled(&[0.0, 0.75].map(|e| Affine2::similitude(0.25, 0.0, DVec2::new(e, 0.0))), power + 2);
        // 3 times the power, of which 2 are the gap.
        let gap = maps[1].translation.x / 1.5;
        let (lower, upper) = one_gap(&intervals(&maps, 1000), &format!("2^{power}"));
        assert!(lower <= gap && gap <= upper, "{lower:e} {gap:e} {upper:e}");
        assert!(answer(&maps, 1e-3, 1000).verdict == Verdict::Disconnected);
        assert!(power < -1000 || upper < 1.01 * lower, "{lower:e} {upper:e}");
    }
}

#[test]
fn shapes_that_are_too_large_for_doubles_are_refused() {
    let Some(maps) = system(1) else { panic!() };
    for power in [333, 500, 1000] {
        let maps = scaled(&maps, power);
        assert!(matches!(Ifs::new(maps.clone()), Err(IfsError::NotFinite { .. })));
        // That there is no attractor would be wrong to say.
        let sample = decide(&maps, 1e-3, 1000, &mut Scratch::default());
        assert!(sample.state == State::Undecided && sample.gap.is_nan(), "{sample:?}");
    }
}

/// Three to five similitudes of space, seen in coordinates that stretch and shear them up to a thousand times.
fn system3(seed: u32) -> Vec<Affine3> {
    let at = |k| number(seed, k);
    let stretch = 10.0_f64.powf(1.5 * (1.0 + at(0)));
    let by = DMat3::from_cols(DVec3::X, DVec3::new(stretch, 1.0, 0.0), DVec3::new(at(1), stretch, 1.0));
    let back = by.inverse();
    let map = |k: u32| {
        let at = |i| number(seed, 100 * (k + 1) + i);
        let turn = DQuat::from_scaled_axis(3.0 * DVec3::new(at(0), at(1), at(2)));
        let linear = DMat3::from_quat(turn) * (0.4 + 0.1 * at(3));
        Affine3::new(by * linear * back, by * DVec3::new(at(4), at(5), at(6)))
    };
    (0..3 + seed % 3).map(map).collect()
}

#[test]
fn in_space_bounds_are_bounds_as_well_at_any_size() {
    let mut apart = 0;
    for seed in 0..25 {
        let maps = system3(seed);
        let Ok(ifs) = Ifs3::new(maps.clone()) else { continue };
        let mut all = Vec::new();
        for epsilon in EPSILONS {
            let options = Options { epsilon, budget: 2000 };
            let here = connectedness3(&ifs, &options);
            apart += usize::from(here.verdict == Verdict::Disconnected);
            all.push((format!("{epsilon:e}"), here.gap.lower, here.gap.upper));
            for power in [-531, -400, -200, 200, 290] {
                let large = |x: f64| x * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2);
                let t = |t: DVec3| DVec3::from_array(t.to_array().map(large));
                let there = maps.iter().map(|map| Affine3::new(map.linear, t(map.translation))).collect();
                let there = connectedness3(&Ifs3::new(there).unwrap(), &options);
                assert_eq!(there.verdict, here.verdict, "{seed} {power}");
                let bounds = [here.gap.lower, here.gap.upper, here.diameter].map(large);
                assert_eq!([there.gap.lower, there.gap.upper, there.diameter], bounds, "{seed} {power}");
            }
        }
        one_gap(&all, &format!("{seed}: {maps:?}"));
    }
    assert!(apart > 40, "{apart}");
}

#[test]
fn pieces_that_barely_meet_do_not_keep_others_from_being_seen_to() {
    // Of a fern on its way to a maple: the first map lays all of the attractor along a line, and what it lies beside is
    // told from it only by more looks than there are, while others cross it in plain sight.
    let maps = rows(&[
        [-0.00956521739130435, 0.0, 0.0, 0.04521739130434782, 0.0, -0.4956521739130434],
        [
            1.0258634743508195,
            0.06744060920283255,
            -0.07142689232533345,
            0.9686107769330377,
            0.0,
            0.6086956521739132,
        ],
        [
            0.11705893393691205,
            -0.14433258308013483,
            0.09649565541137711,
            0.12710834874755123,
            -0.28913043478260864,
            0.27826086956521756,
        ],
        [
            -0.6483623087651778,
            0.31096385270715143,
            0.22935313791600592,
            0.1806472139307551,
            0.28913043478260864,
            0.07652173913043483,
        ],
    ]);
    assert_eq!(decide(&maps, 1e-4, 20_000, &mut Scratch::default()).state, State::Touching);
}
