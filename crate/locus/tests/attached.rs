//! Systems whose truth is known by how they are made: maps of all degenerate kinds, attached to shapes in one piece.
//!
//! **Lemma.** Let A be the attractor of some maps, connected, with 0 in it, and add maps `x -> M x + q` with q in A.
//! The attractor A' of all of them is connected.
//!
//! **Proof.** A lies in A', so that the pieces `w_i(A')` of the former maps hang together as those of A do. The new
//! piece and A both have the point q, the image of 0, and A lies in the union of the former pieces. So the graph of the
//! pieces that meet is connected (Hata 1985).
//!
//! The numbers of the shapes are whole multiples of powers of two, few of them, so that q is in A exactly.

use frond_core::{Affine2, Affine3, Bounds3, DirectedIfs, DirectedMap, Hull, Ifs, Ifs3, Morph, MorphOptions};
use frond_locus::{
    Bounded, Bounds, Drift, Family, LocusGrid, Options, Scratch, Scratch3, SingleLocus, State, Verdict,
    certificate, connectedness, connectedness3, decide_bounds, decide3, directed_connectedness,
};
use glam::{DMat2, DMat3, DVec2, DVec3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Connected shapes with 0 in them.
const SHAPES: [&[[f64; 6]]; 6] = [
    // The dragon, the twindragon, a segment, a square, Sierpinski's triangle, and a point.
    &[[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]],
    &[[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [0.5, -0.5, 0.5, 0.5, 1.0, 0.0]],
    &[[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0, 0.5, 0.0]],
    &[
        [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
        [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
        [0.5, 0.0, 0.0, 0.5, 0.0, 0.5],
        [0.5, 0.0, 0.0, 0.5, 0.5, 0.5],
    ],
    &[[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.0, 0.5, 0.0, 0.5]],
    &[[0.5, 0.0, 0.0, 0.25, 0.0, 0.0]],
];

/// Numbers at the ends of what doubles hold, and usual ones: where a quotient or a square goes wrong.
fn entry() -> impl Strategy<Value = f64> {
    let size = prop_oneof![
        3 => Just(0.0),
        3 => Just(f64::MIN_POSITIVE),
        1 => Just(f64::from_bits(1)),
        1 => Just(1.5 * f64::MIN_POSITIVE),
        1 => Just(f64::MIN_POSITIVE.next_down()),
        2 => (-323.0..-1.0_f64).prop_map(|power| 10.0_f64.powf(power)),
        3 => prop_oneof![Just(0.25), Just(0.5), Just(0.75)],
        3 => 0.0..0.9_f64,
    ];
    (size, any::<bool>()).prop_map(|(size, minus)| if minus { -size } else { size })
}

/// A linear part: of such numbers, of rank 1, of a single large number, or a mirrored or turned similitude.
fn linear() -> impl Strategy<Value = DMat2> {
    let row = |[a, b, c, d]: [f64; 4]| DMat2::from_cols(DVec2::new(a, c), DVec2::new(b, d));
    let any = [entry(), entry(), entry(), entry()].prop_map(row);
    let rank_one = [entry(), entry(), entry(), entry()]
        .prop_map(|[a, b, c, d]| DMat2::from_cols(DVec2::new(a, b) * c, DVec2::new(a, b) * d));
    let shear = (1.0..9.0_f64, entry(), 0..2_usize).prop_map(|(power, rest, place)| {
        let large = 10.0_f64.powf(power);
        if place == 0 {
            DMat2::from_cols(DVec2::new(rest, 0.0), DVec2::new(large, rest))
        } else {
            DMat2::from_cols(DVec2::new(rest, large), DVec2::new(0.0, rest))
        }
    });
    let quarter = (0..8_usize, entry()).prop_map(|(turn, scale)| SYMMETRIES[turn] * scale);
    prop_oneof![4 => any, 2 => rank_one, 1 => shear, 2 => quarter]
}

const SYMMETRIES: [DMat2; 8] = [
    DMat2::from_cols_array(&[1.0, 0.0, 0.0, 1.0]),
    DMat2::from_cols_array(&[0.0, 1.0, -1.0, 0.0]),
    DMat2::from_cols_array(&[-1.0, 0.0, 0.0, -1.0]),
    DMat2::from_cols_array(&[0.0, -1.0, 1.0, 0.0]),
    DMat2::from_cols_array(&[1.0, 0.0, 0.0, -1.0]),
    DMat2::from_cols_array(&[-1.0, 0.0, 0.0, 1.0]),
    DMat2::from_cols_array(&[0.0, 1.0, 1.0, 0.0]),
    DMat2::from_cols_array(&[0.0, -1.0, -1.0, 0.0]),
];

/// A shape and where it lies: turned or mirrored, sheared by whole numbers, and of a size that is a power of two.
fn shape() -> impl Strategy<Value = Vec<Affine2>> {
    let size = prop_oneof![3 => Just(0), 1 => -60..60_i32, 1 => -1000..250_i32];
    (0..SHAPES.len(), 0..8_usize, -2..3_i32, size).prop_map(|(shape, turn, shear, size)| {
        let by = SYMMETRIES[turn] * DMat2::from_cols(DVec2::X, DVec2::new(f64::from(shear), 1.0));
        let size = 2.0_f64.powi(size);
        let map = |&row: &[f64; 6]| {
            let map = Affine2::from_row(row);
            Affine2::new(by * map.linear * by.inverse(), by * map.translation * size)
        };
        SHAPES[shape].iter().map(map).collect()
    })
}

/// Points of a shape, exactly: images of 0.
fn points(shape: &[Affine2]) -> Vec<DVec2> {
    let mut points = vec![DVec2::ZERO];
    for _ in 0..3 {
        points = points.iter().flat_map(|&p| shape.iter().map(move |map| map.apply(p))).collect();
    }
    points
}

/// A shape, and linear parts that are attached to it at its points.
#[derive(Clone, Debug)]
struct Attached {
    shape: Vec<Affine2>,
    more: Vec<(DMat2, DVec2)>,
    /// Points of the shape.
    points: Vec<DVec2>,
}

impl Attached {
    fn maps(&self) -> Vec<Affine2> {
        let more = self.more.iter().map(|&(linear, at)| Affine2::new(linear, at));
        self.shape.iter().copied().chain(more).collect()
    }

    /// How far two known points are apart.
    fn extent(&self) -> f64 {
        let all = self.points.iter().flat_map(|p| self.points.iter().map(|q| (*p - *q).abs()));
        // In units of the larger number, so that squares do not vanish.
        all.map(|d| d.max_element() * (d / d.max_element().max(f64::MIN_POSITIVE)).length())
            .fold(0.0, f64::max)
    }
}

fn attached() -> impl Strategy<Value = Attached> {
    let more = proptest::collection::vec((linear(), any::<prop::sample::Index>()), 1..4);
    (shape(), more).prop_map(|(shape, more)| {
        let points = points(&shape);
        let more = more.into_iter().map(|(linear, at)| (linear, points[at.index(points.len())])).collect();
        Attached { shape, more, points }
    })
}

/// The systems of an attached shape whose additional linear parts become these over x, and turn about a little over y.
struct Moving {
    from: Attached,
    to: Vec<DMat2>,
}

impl Family for Moving {
    fn len(&self) -> usize {
        self.from.shape.len() + self.from.more.len()
    }

    fn fill(&self, x: f64, _: f64, maps: &mut Vec<Affine2>) {
        *maps = self.from.maps();
        for (map, &to) in maps[self.from.shape.len()..].iter_mut().zip(&self.to) {
            map.linear = map.linear * (1.0 - x) + to * x;
        }
    }

    fn drift(&self, axis: usize, _: DVec2, _: f64, drifts: &mut Vec<Drift>) {
        drifts.clear();
        drifts.resize(self.len(), Drift::STILL);
        if axis == 0 {
            for (k, drift) in drifts[self.from.shape.len()..].iter_mut().enumerate() {
                drift.speed.linear = self.to[k] - self.from.more[k].0;
            }
        }
    }
}

/// A shape of space: one of the plane in it, mirrored or turned by quarters, or a tetrahedron or a cube of halves; with
/// linear parts attached to it.
#[derive(Clone, Debug)]
struct Attached3 {
    shape: Vec<Affine3>,
    more: Vec<(DMat3, DVec3)>,
}

fn attached3() -> impl Strategy<Value = Attached3> {
    let corner = |k: u32| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2 & 1));
    let halves = move |corners: &[u32]| -> Vec<Affine3> {
        let half = DMat3::from_diagonal(DVec3::splat(0.5));
        corners.iter().map(|&k| Affine3::new(half, corner(k) * 0.5)).collect()
    };
    let lifted = |map: &Affine2| {
        let [a, b, c, d, e, f] = map.to_row();
        let columns = [DVec3::new(a, c, 0.0), DVec3::new(b, d, 0.0), DVec3::new(0.0, 0.0, 0.25)];
        Affine3::new(DMat3::from_cols(columns[0], columns[1], columns[2]), DVec3::new(e, f, 0.0))
    };
    let solid = prop_oneof![
        2 => shape().prop_map(move |maps| maps.iter().map(lifted).collect::<Vec<_>>()),
        1 => Just(halves(&[0, 1, 2, 4])),
        1 => Just(halves(&[0, 1, 2, 3, 4, 5, 6, 7])),
    ];
    let full = proptest::array::uniform9(entry()).prop_map(|numbers| DMat3::from_cols_array(&numbers));
    let rank_one =
        (proptest::array::uniform3(entry()), proptest::array::uniform3(entry())).prop_map(|(a, b)| {
            let [a, b] = [a, b].map(DVec3::from_array);
            DMat3::from_cols(a * b.x, a * b.y, a * b.z)
        });
    let order = (0..6_usize, proptest::array::uniform3(entry())).prop_map(|(order, [a, b, c])| {
        let axes = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]][order];
        let [x, y, z] = axes.map(|k| DVec3::AXES[k]);
        DMat3::from_cols(x * a, y * b, z * c)
    });
    let linear = prop_oneof![2 => full, 1 => rank_one, 1 => order];
    let more = proptest::collection::vec((linear, any::<prop::sample::Index>()), 1..3);
    (solid, 0..6_usize, more).prop_map(|(shape, order, more)| {
        let axes = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]][order];
        let [x, y, z] = axes.map(|k| DVec3::AXES[k]);
        let by = DMat3::from_cols(x, -y, z);
        let turned = |map: &Affine3| Affine3::new(by * map.linear * by.transpose(), by * map.translation);
        let shape: Vec<Affine3> = shape.iter().map(turned).collect();
        let mut points = vec![DVec3::ZERO];
        for _ in 0..2 {
            points = points.iter().flat_map(|&p| shape.iter().map(move |map| map.apply(p))).collect();
        }
        let more = more.into_iter().map(|(linear, at)| (linear, points[at.index(points.len())])).collect();
        Attached3 { shape, more }
    })
}

fn sound(known: &Bounded) -> bool {
    let Bounded { sample, lower, upper, diameter, .. } = *known;
    match sample.state {
        State::Connected | State::Touching => {
            lower == 0.0 && upper >= 0.0 && diameter >= 0.0 && diameter.is_finite()
        }
        State::Disconnected => lower > 0.0 && lower <= upper && upper <= 1.0 && diameter.is_finite(),
        State::Undecided | State::NoAttractor => true,
    }
}

fn examples(quick: u32) -> ProptestConfig {
    let cases = frond_testing::cases(quick);
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1997),
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(examples(800))]

    #[test]
    fn what_is_attached_leaves_a_shape_of_the_plane_in_one_piece(attached in attached(), fine in any::<bool>()) {
        let maps = attached.maps();
        let Ok(ifs) = Ifs::new(maps.clone()) else { return Ok(()) };
        let epsilon = if fine { 1e-12 } else { 1.0 / 600.0 };
        let options = Options { epsilon, budget: 4000 };
        let full = connectedness(&ifs, &options);
        prop_assert!(full.verdict != Verdict::Disconnected && full.gap.lower == 0.0, "{full:?}");
        prop_assert!(full.gap.upper >= 0.0 && full.gap.upper <= full.diameter, "{full:?}");
        let extent = attached.extent() * (1.0 - 1e-12);
        prop_assert!(full.diameter.is_finite() && full.diameter >= extent, "{full:?} {extent}");
        let known = decide_bounds(&maps, epsilon, 4000, &mut Scratch::default());
        prop_assert!(known.sample.state != State::Disconnected && known.lower == 0.0, "{known:?}");
        prop_assert!(sound(&known), "{known:?}");
        prop_assert!(!known.sample.state.holds() || known.diameter >= extent, "{known:?} {extent}");
        let hull = Hull::of(&ifs);
        prop_assert!(hull.vertices().iter().all(|v| v.is_finite()) && hull.diameter() >= extent, "{hull:?}");
    }
}

proptest! {
    #![proptest_config(examples(100))]

    #[test]
    fn no_certificate_says_that_what_is_attached_is_in_pieces(attached in attached()) {
        let Ok(ifs) = Ifs::new(attached.maps()) else { return Ok(()) };
        let found = certificate(&ifs, &Options { epsilon: 1e-9, budget: 2000 });
        prop_assert!(found.is_none(), "{found:?}");
    }

    #[test]
    fn no_box_and_no_graphics_card_says_that_what_is_attached_is_in_pieces(
        from in attached(),
        to in proptest::collection::vec(linear(), 3),
    ) {
        let family = Moving { from, to };
        let grid = LocusGrid::new(Bounds { u0: 0.0, v0: 0.0, u1: 1.0, v1: 1.0 }, 9, 4).unwrap();
        for epsilon in [1.0 / 600.0, 1e-9] {
            let tile = grid.patch(&family, epsilon, 0..9, 0..4, &mut Scratch::default());
            prop_assert!(!tile.state.contains(&(State::Disconnected as u8)), "{:?} {:?}", tile.state, family.from);
        }
        let mut maps = Vec::new();
        family.fill(0.0, 0.0, &mut maps);
        // Single precision rounds: that is reckoned with.
        let linear = MorphOptions::default();
        let still = Morph::new(&maps, &maps, &linear).ok().and_then(|morph| {
            SingleLocus::of_morph(&morph, 0.0, &grid, 1.0 / 600.0).ok()
        });
        for x in [0, 4] {
            let state = still.as_ref().map_or(State::Undecided, |locus| locus.decide(x, 1).state);
            prop_assert!(state != State::Disconnected, "{maps:?}");
        }
    }

    #[test]
    fn what_is_attached_leaves_a_shape_of_space_in_one_piece(attached in attached3(), fine in any::<bool>()) {
        let more = attached.more.iter().map(|&(linear, at)| Affine3::new(linear, at));
        let maps: Vec<Affine3> = attached.shape.iter().copied().chain(more).collect();
        let Ok(ifs) = Ifs3::new(maps.clone()) else { return Ok(()) };
        let epsilon = if fine { 1e-12 } else { 1.0 / 600.0 };
        let full = connectedness3(&ifs, &Options { epsilon, budget: 400 });
        prop_assert!(full.verdict != Verdict::Disconnected && full.gap.lower == 0.0, "{full:?}");
        prop_assert!(full.gap.upper <= full.diameter && full.diameter.is_finite(), "{full:?}");
        let sample = decide3(&maps, epsilon, 400, &mut Scratch3::default());
        prop_assert!(sample.state != State::Disconnected && sample.state != State::NoAttractor, "{sample:?}");
        let bounds = Bounds3::of(&ifs);
        let fixed = maps.iter().filter_map(|map| map.fixed_point());
        let slack = 1e-9 * bounds.radius;
        for p in fixed {
            let d = p - bounds.centre;
            let size = d.abs().max_element().max(f64::MIN_POSITIVE);
            prop_assert!(size * (d / size).length() <= bounds.radius + slack, "{bounds:?} {p}");
        }
    }

    /// The shape and a state that is a copy of it, or a point: what is attached is a copy of either.
    #[test]
    fn what_is_attached_leaves_states_in_one_piece(attached in attached(), of in 0..3_usize) {
        let mut states = vec![Vec::new(), Vec::new()];
        states[0].extend(attached.shape.iter().map(|&map| DirectedMap { from: 0, map }));
        let more = attached.more.iter().enumerate();
        states[0].extend(more.map(|(k, &(linear, at))| DirectedMap {
            from: (k + of) % 2,
            map: Affine2::new(linear, at),
        }));
        // With 0 in it, as it is in the first.
        let linear = DMat2::from_diagonal(DVec2::splat(0.25));
        states[1].push(DirectedMap { from: usize::from(of == 2), map: Affine2::new(linear, DVec2::ZERO) });
        let Ok(system) = DirectedIfs::new(states) else { return Ok(()) };
        for state in directed_connectedness(&system, &Options { epsilon: 1e-6, budget: 400 }) {
            prop_assert!(state.verdict != Verdict::Disconnected && state.gap.lower == 0.0, "{state:?}");
            prop_assert!(state.gap.upper >= 0.0 && state.diameter >= 0.0, "{state:?}");
        }
    }
}
