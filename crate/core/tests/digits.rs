//! Shapes of one grid and what they share: by hand, known dimensions, and every address tried.

use std::collections::{BTreeMap, BTreeSet};

use frond_core::{AddressCount, DigitError, DigitSystem, GridIntersection, Hull, grid_intersection};
use frond_testing::cases;
use glam::DVec2;
use proptest::prelude::*;

type Point = [i64; 2];

const THIRDS: [i64; 4] = [3, 0, 0, 3];
const HALVES: [i64; 4] = [2, 0, 0, 2];
/// Multiplication by 1 + i.
const GAUSS: [i64; 4] = [1, -1, 1, 1];

fn system(matrix: [i64; 4], digits: &[Point]) -> DigitSystem {
    DigitSystem::new(matrix, digits.to_vec()).unwrap()
}

fn line(base: i64, digits: &[i64]) -> DigitSystem {
    system([base, 0, 0, base], &digits.iter().map(|&d| [d, 0]).collect::<Vec<_>>())
}

fn copies(found: &GridIntersection) -> Vec<Vec<(usize, usize)>> {
    found.states.iter().map(|state| state.copies.clone()).collect()
}

fn near(found: &GridIntersection, dimension: f64) {
    let own = found.dimension().unwrap();
    assert!((own - dimension).abs() < 1e-9, "{own} is not {dimension}");
}

#[test]
fn cantors_set_and_itself() {
    let cantor = line(3, &[0, 2]);
    let at = |p, q| grid_intersection(&cantor, &cantor, [p, 0], q).unwrap();
    // Not moved: itself, of its own two maps.
    assert_eq!(copies(&at(0, 1)), [[(0, 0), (1, 0)]]);
    near(&at(0, 7), 2.0_f64.ln() / 3.0_f64.ln());
    assert_eq!(at(0, 7).denominator, 1);
    // Moved by 2/3: the right half of the first on the left of the second.
    let half = at(2, 3);
    assert_eq!(copies(&half), [vec![(1, 1)], vec![(0, 1), (1, 1)]]);
    assert_eq!(half.attractor().unwrap().len(), 2);
    // Moved by its length, and a third: the end alone, and both ends of the gap with it.
    assert_eq!(at(1, 1).addresses(), AddressCount::Finite(1));
    assert_eq!(at(1, 3).addresses(), AddressCount::Finite(3));
    assert_eq!(at(1, 1).states[0].shifts, [[1, 0]]);
    let mut ends: Vec<f64> = at(1, 3).points().unwrap().iter().map(|point| point.x).collect();
    ends.sort_by(f64::total_cmp);
    for (end, third) in ends.iter().zip([1.0, 2.0, 3.0]) {
        assert!((3.0 * end - third).abs() < 1e-12, "{ends:?}");
    }
    assert_eq!((ends.len(), at(0, 1).points()), (3, None));
    // By a quarter: two copies of a ninth.
    let quarter = at(1, 4);
    assert_eq!((copies(&quarter), quarter.shifts), (vec![vec![(0, 1), (1, 1)], vec![(1, 0)]], 2));
    near(&quarter, 2.0_f64.ln() / 9.0_f64.ln());
    let maps = quarter.attractor().unwrap();
    let ends: Vec<f64> = maps.iter().map(|map| map.fixed_point().unwrap().x).collect();
    assert!((ends[0] - 0.25).abs() < 1e-12 && (ends[1] - 1.0).abs() < 1e-12, "{ends:?}");
    // Too far: nothing, and no shape for it.
    for far in [at(4, 3), at(-7, 2), at(1_000_000_000_000, 1)] {
        assert!(far.is_empty() && far.system().unwrap().is_none() && far.dimension().is_none());
        assert_eq!((far.addresses(), far.attractor()), (AddressCount::Finite(0), None));
        assert_eq!(far.points(), Some(vec![]));
    }
}

#[test]
fn a_graph_of_several_states_need_not_be_one_system() {
    // Both have 0 and 1 next to each other, so that a shift of 0 leads to shifts of 1 and back to none.
    let (a, b) = (line(4, &[0, 1, 3]), line(4, &[0, 2, 3]));
    let found = grid_intersection(&a, &b, [0, 0], 1).unwrap();
    assert!(found.states.len() > 1 && found.attractor().is_none(), "{:?}", copies(&found));
    assert_eq!(found.addresses(), AddressCount::Uncountable);
    // Countably many points: 0, a third, a ninth, and so on.
    let (a, b) = (line(3, &[0, 1]), line(3, &[0, 2]));
    let found = grid_intersection(&a, &b, [0, 0], 1).unwrap();
    assert_eq!(copies(&found), [vec![(0, 0), (1, 1)], vec![(0, 1)]]);
    assert_eq!((found.addresses(), found.points()), (AddressCount::Countable, None));
    near(&found, 0.0);
}

#[test]
fn neighbours_of_the_twin_dragon_meet_in_its_boundary() {
    let dragon = system(GAUSS, &[[0, 0], [1, 0]]);
    // The boundary's dimension is that of x^3 - x^2 - 2 = 0 over the root of 2 (Gilbert 1982).
    let root = {
        let mut x = 1.7_f64;
        (0..50).for_each(|_| x -= (x * x * x - x * x - 2.0) / (3.0 * x * x - 2.0 * x));
        x
    };
    let whole = 2.0 * root.log2();
    let at = |p| grid_intersection(&dragon, &dragon, p, 1).unwrap();
    near(&at([0, 0]), 2.0);
    assert_eq!(copies(&at([0, 0])), [[(0, 0), (1, 0)]]);
    let neighbours: Vec<Point> = (-3..4)
        .flat_map(|x| (-3..4).map(move |y| [x, y]))
        .filter(|&p| p != [0, 0] && !at(p).is_empty())
        .collect();
    // A graph of few kinds, where sets of shifts would be twenty. Some neighbours share a curve, others points.
    assert!(at([1, 0]).states.len() <= 6, "{:?}", at([1, 0]).states);
    let wide = neighbours.iter().filter(|&&p| at(p).dimension().is_some_and(|d| d > 1.0)).count();
    assert!(wide >= 4, "{neighbours:?}");
    for &p in &neighbours {
        assert!(at(p).is_exact && at(p).dimension().unwrap() < whole + 1e-9);
    }
    let widest = neighbours.iter().filter_map(|&p| at(p).dimension()).fold(0.0, f64::max);
    assert!((widest - whole).abs() < 1e-9, "{widest} is not {whole}");
}

#[test]
fn shapes_of_the_plane_share_what_their_digits_share() {
    let square: Vec<Point> = (0..9).map(|k| [k % 3, k / 3]).collect();
    let without =
        |out: &[Point]| -> Vec<Point> { square.iter().copied().filter(|d| !out.contains(d)).collect() };
    let carpet = system(THIRDS, &without(&[[1, 1]]));
    let cross = system(THIRDS, &without(&[[0, 0], [2, 0], [0, 2], [2, 2]]));
    let corners = system(THIRDS, &[[0, 0], [2, 0], [0, 2], [2, 2]]);
    let all = system(THIRDS, &square);
    let none = |a, b| grid_intersection(a, b, [0, 0], 1).unwrap();
    // A whole square around takes nothing away, and corners lie in the carpet.
    for shape in [&carpet, &cross, &corners, &all] {
        let found = none(shape, &all);
        assert_eq!(found.states.len(), 1);
        assert_eq!(found.states[0].copies.len(), shape.digits().len());
        // The other way round, points on edges of the cells of a square have several addresses.
        near(&none(&all, shape), (shape.digits().len() as f64).ln() / 3.0_f64.ln());
    }
    assert_eq!(copies(&none(&corners, &carpet)).concat().len(), 4);
    // The two halves of a square, cut along a diagonal, share the diagonal.
    let gasket = system(HALVES, &[[0, 0], [1, 0], [0, 1]]);
    let turned = system(HALVES, &[[1, 1], [1, 0], [0, 1]]);
    let diagonal = none(&gasket, &turned);
    near(&diagonal, 1.0);
    for point in diagonal.system().unwrap().unwrap().points() {
        assert!((point.x + point.y - 1.0).abs() < 1e-12);
    }
    // Beside each other: a corner.
    let beside = grid_intersection(&gasket, &gasket, [1, 0], 1).unwrap();
    assert_eq!(beside.addresses(), AddressCount::Finite(1));
    assert_eq!(beside.points().unwrap().len(), 1);
    // One point, but the two addresses 0.111.. and 1.000.. of it: 1/2.
    let (bits, half) = (line(2, &[0, 1]), line(2, &[0]));
    let found = grid_intersection(&bits, &half, [1, 0], 2).unwrap();
    assert_eq!((found.addresses(), found.points().unwrap().len()), (AddressCount::Finite(2), 1));
    assert!(beside.system().unwrap().unwrap().points()[0].distance(DVec2::X) < 1e-12);
}

#[test]
fn digits_of_one_remainder_give_a_bound() {
    let (wide, cantor) = (line(3, &[0, 1, 3]), line(3, &[0, 2]));
    let found = grid_intersection(&wide, &wide, [0, 0], 1).unwrap();
    assert!(!found.is_exact && found.dimension().unwrap() <= 1.0 + 1e-9);
    assert!(grid_intersection(&cantor, &wide, [1, 0], 9).unwrap().is_exact);
}

/// Red where kinds beyond the 64 states of a system made by hand are lost, or the numbers that follow from them.
#[test]
fn hundreds_of_kinds_are_one_system_too() {
    let whole = line(3, &[0, 1, 2]);
    // From 0 to 1, and from 100/257 on: powers of 3 meet every remainder of 257.
    let found = grid_intersection(&whole, &whole, [100, 0], 257).unwrap();
    assert!(found.states.len() > 64, "{}", found.states.len());
    let system = found.system().unwrap().unwrap();
    let hull = &Hull::of_states(&system)[0];
    assert!((hull.min().x - 100.0 / 257.0).abs() < 1e-6 && (hull.max().x - 1.0).abs() < 1e-6);
    assert!((found.dimension().unwrap() - 1.0).abs() < 1e-9);
    assert_eq!(found.addresses(), AddressCount::Uncountable);
}

#[test]
fn what_cannot_be_worked_out_is_said() {
    let code = |a: &DigitSystem, b: &DigitSystem, p, q| {
        grid_intersection(a, b, p, q).map_or_else(|error| error.code(), |_| "fine")
    };
    let (thirds, halves) = (line(3, &[0, 2]), line(2, &[0, 1]));
    assert_eq!(code(&thirds, &halves, [0, 0], 1), "grid-matrices");
    for (p, q) in [([0, 0], 0), ([0, 0], -1), ([1, 0], 1_000_001), ([i64::MIN, 0], 1)] {
        assert_eq!(code(&thirds, &thirds, p, q), "grid-shift");
    }
    assert_eq!(code(&thirds, &thirds, [0, 0], 1_000_000), "fine");
    // An orbit of 3 that is long: 999,983 is a prime.
    let long = code(&line(3, &[0, 1, 2]), &line(3, &[0, 1, 2]), [12_345, 0], 999_983);
    assert_eq!(long, "grid-too-many-shifts");
    let some = code(&thirds, &thirds, [1, 0], 10_007);
    assert!(["fine", "grid-too-many-states"].contains(&some), "{some}");
    let all: Vec<Point> = (0..64).map(|k| [k % 8, k / 8]).collect();
    let full = system([8, 0, 0, 8], &all);
    for p in [[0, 0], [1, 0], [1, 1], [3, 5]] {
        assert_eq!(code(&full, &full, p, 7), "fine");
    }
    // As large as numbers may be.
    let large = system([32, 31, 0, 32], &[[1000, 1000], [-1000, -1000]]);
    let _ = grid_intersection(&large, &large, [999_999_999_999, -1], 1_000_000);
    let slow = system([32, -32, 1, 0], &[[1000, 1000], [-1000, -1000]]);
    let _ = grid_intersection(&slow, &slow, [1, 1], 3);
    assert!(DigitError::TooManyStates.to_string().contains("1024"));
    let whole = line(3, &[0, 1, 2]);
    assert_eq!(code(&whole, &whole, [1, 0], 10_007), "grid-too-many-states");
}

/// The words of so many digits of A with which points of A begin that lie in B + p / q: every pair of words is tried,
/// and a rest counts while it is no longer than those of A - B can be.
fn words(a: &DigitSystem, b: &DigitSystem, p: Point, q: i64, length: usize) -> BTreeSet<Vec<usize>> {
    let [m, n, r, s] = a.matrix();
    let largest = a
        .digits()
        .iter()
        .flat_map(|d| b.digits().iter().map(move |e| (d[0] - e[0]).abs().max((d[1] - e[1]).abs())));
    // Every matrix that is tried turns and scales by the root of 2 or more: lengths are at most 2.5 times the largest.
    let most = 2 * 7 * largest.max().unwrap_or(0).pow(2) * q * q;
    let step = |shifts: &BTreeSet<Point>, only: Option<usize>| -> BTreeSet<Point> {
        let mut next = BTreeSet::new();
        for [x, y] in shifts {
            for (_, d) in a.digits().iter().enumerate().filter(|(i, _)| only.is_none_or(|digit| digit == *i))
            {
                for e in b.digits() {
                    let to = [m * x + n * y + q * (e[0] - d[0]), r * x + s * y + q * (e[1] - d[1])];
                    if to[0] * to[0] + to[1] * to[1] <= most {
                        next.insert(to);
                    }
                }
            }
        }
        next
    };
    // There are finitely many sets of rests: where one comes back, it goes on for ever.
    let goes_on = |shifts: &BTreeSet<Point>| -> bool {
        let mut now = shifts.clone();
        let mut seen = BTreeSet::new();
        while !now.is_empty() && seen.insert(now.clone()) {
            now = step(&now, None);
        }
        !now.is_empty()
    };
    let mut known: BTreeMap<Vec<usize>, BTreeSet<Point>> = BTreeMap::from([(vec![], BTreeSet::from([p]))]);
    for _ in 0..length {
        let mut next = BTreeMap::new();
        for (word, shifts) in &known {
            for digit in 0..a.digits().len() {
                let to = step(shifts, Some(digit));
                if !to.is_empty() {
                    next.insert([&word[..], &[digit]].concat(), to);
                }
            }
        }
        known = next;
    }
    known.into_iter().filter(|(_, shifts)| goes_on(shifts)).map(|(word, _)| word).collect()
}

/// The words of the graph.
fn ways(found: &GridIntersection, length: usize) -> Vec<Vec<usize>> {
    let mut known = if found.is_empty() { vec![] } else { vec![(vec![], 0)] };
    for _ in 0..length {
        let longer = known.iter().flat_map(|(word, state): &(Vec<usize>, usize)| {
            found.states[*state].copies.iter().map(move |&(digit, to)| ([&word[..], &[digit]].concat(), to))
        });
        known = longer.collect();
    }
    known.into_iter().map(|(word, _)| word).collect()
}

/// A grid, two sets of digits and a shift: often alike, of one digit, far apart, or on the line.
fn any_question() -> impl Strategy<Value = (DigitSystem, DigitSystem, Point, i64)> {
    let matrix = prop::sample::select(vec![
        THIRDS,
        HALVES,
        GAUSS,
        [-1, -1, 1, -1],
        [2, -1, 1, 2],
        [4, 0, 0, 4],
        [0, -2, 2, 0],
        [-3, 0, 0, -3],
    ]);
    let digit = prop_oneof![3 => prop::array::uniform2(0..3_i64), 1 => (0..4_i64).prop_map(|x| [x, 0])];
    let digits = prop::collection::btree_set(digit, 1..4);
    let second = prop::option::weighted(0.6, digits.clone());
    let part = prop_oneof![2 => Just(0), 5 => -5..6_i64];
    (matrix, digits, second, [part.clone(), part], 1..5_i64).prop_map(|(matrix, first, second, p, q)| {
        let second = second.unwrap_or_else(|| first.clone());
        let of = |digits: BTreeSet<Point>| system(matrix, &digits.into_iter().collect::<Vec<_>>());
        (of(first), of(second), p, q)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(150)))]

    /// Red where a shift is lost or one too many is kept, where sets of shifts are joined that differ, or states
    /// merged.
    #[test]
    fn the_graph_has_the_addresses_that_trying_all_of_them_finds((a, b, p, q) in any_question()) {
        let found = match grid_intersection(&a, &b, p, q) {
            Ok(found) => found,
            Err(DigitError::TooManyStates) => return Ok(()),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        for length in [0, 1, 4] {
            let own = ways(&found, length);
            let each: BTreeSet<_> = own.iter().cloned().collect();
            if found.states.iter().any(|state| state.shifts.len() > 1) {
                prop_assert_eq!(own.len(), each.len(), "an address is there twice");
            }
            prop_assert_eq!(each, words(&a, &b, p, q, length));
        }
        // The same set from the other side, moved back, has as many points and the same dimension.
        let back = grid_intersection(&b, &a, p.map(|x| -x), q);
        if let Ok(back) = back {
            prop_assert_eq!(back.is_empty(), found.is_empty());
            if a.keeps_apart() && b.keeps_apart() {
                let (one, other) = (found.dimension().unwrap_or(0.0), back.dimension().unwrap_or(0.0));
                prop_assert!((one - other).abs() < 1e-6, "{one} {other}");
            }
        }
        // And what it is said to be the attractor of has its dimension, where nothing overlaps.
        if let (Some(maps), true) = (found.attractor(), found.is_exact) {
            let ifs = frond_core::Ifs::new(maps).unwrap();
            let dimension = frond_core::similarity_dimension(&ifs).unwrap_or(0.0);
            prop_assert!((dimension - found.dimension().unwrap()).abs() < 1e-6);
        }
    }
}
