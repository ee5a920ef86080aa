//! Tests of films.

use frond_core::Ease;
use frond_deform::Spin;
use proptest::prelude::*;

use super::*;
use crate::scene::Path;
use crate::space::bend::SpaceBend;
use crate::space::document::{Repeat, Shape3, SpaceMorph, Timeline};

const HOME: Row3 = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

fn moved(x: f64) -> Row3 {
    let mut row = HOME;
    row[9] = x;
    row
}

fn key(at: f64) -> SpaceKey {
    SpaceKey { at, ..SpaceKey::default() }
}

fn space(repeat: Repeat, course: Course, keys: Vec<SpaceKey>) -> Space {
    let timeline = Some(Timeline { seconds: 6.0, repeat, course, keys });
    Space { timeline, ..Space::default() }
}

#[test]
fn without_keys_all_stays() {
    let space = Space::default();
    let film = Film::new(&space).unwrap();
    for time in [0.0, 1e9, -3.0, f64::NAN] {
        let moment = film.at(time).unwrap();
        assert_eq!(moment.objects[0].now, space.objects[0].shape.maps);
        assert_eq!((moment.objects[0].moved, moment.view, moment.t), (HOME, None, None));
    }
}

#[test]
fn an_object_is_moved_by_its_parameters() {
    let keys = vec![
        SpaceKey { moved: vec![Some(moved(0.0))], ..key(0.0) },
        SpaceKey { moved: vec![Some(moved(2.0))], ..key(4.0) },
    ];
    let film = Film::new(&space(Repeat::Once, Course::Straight, keys)).unwrap();
    let moment = film.at(2.0).unwrap();
    assert_eq!(moment.objects[0].moved, moved(1.0));
    // The fixed point of each map moves along (eq 1).
    for (made, now) in moment.objects[0].maps.iter().zip(&moment.objects[0].now) {
        let [made, now] = [made, now].map(|row| Affine3::from_row(*row).fixed_point().unwrap());
        assert!((now - made - DVec3::X).length() < 1e-12);
    }
}

#[test]
fn sheared_keys_are_met_and_mirrored_ones_are_told() {
    let sheared = [1.0, 0.7, 0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 1.5, 1.0, 2.0, 3.0];
    let mut mirrored = sheared;
    mirrored[0] = -1.0;
    let two = |a: Row3, b: Row3| {
        let keys = vec![
            SpaceKey { moved: vec![Some(a)], ..key(0.0) },
            SpaceKey { moved: vec![Some(b)], ease: Ease::Hold, ..key(3.0) },
        ];
        Film::new(&space(Repeat::Round, Course::Smooth, keys))
    };
    let near = |film: &Film, time: f64, row: Row3| {
        let found = film.at(time).unwrap().objects[0].moved;
        assert!(found.iter().zip(row).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} {row:?}");
    };
    let film = two(HOME, sheared).unwrap();
    near(&film, 0.0, HOME);
    near(&film, 3.0, sheared);
    near(&two(mirrored, mirrored).unwrap(), 1.0, mirrored);
    assert_eq!(two(HOME, mirrored).unwrap_err().code(), "film-mirror");
}

#[test]
fn views_go_the_shorter_way_round_and_keep_the_horizon() {
    let view = |turn: f64, distance: f64| SpaceView {
        target: [1.0, 0.0, 0.0],
        distance,
        turn,
        tilt: 0.2,
        angle: 0.7,
        holds: None,
    };
    let keys = vec![
        SpaceKey { view: Some(view(3.0, 1.0)), ..key(0.0) },
        SpaceKey { view: Some(view(-3.0, 4.0)), ..key(2.0) },
    ];
    let film = Film::new(&space(Repeat::Once, Course::Straight, keys)).unwrap();
    let middle = film.at(1.0).unwrap().view.unwrap();
    assert!((middle.turn - std::f64::consts::PI).abs() < 1e-9, "{middle:?}");
    assert!((middle.distance - 2.0).abs() < 1e-9 && middle.is_one());
}

/// Seen from there, everything else being the same.
fn turned_by(turn: f64) -> SpaceView {
    SpaceView { target: [0.0; 3], distance: 2.0, turn, tilt: 0.2, angle: 0.7, holds: None }
}

fn turn_at(film: &Film, time: f64) -> f64 {
    film.at(time).unwrap().view.unwrap().turn
}

#[test]
fn an_orbit_from_the_beginning_to_the_end_of_a_loop_never_turns_back() {
    let sixth = std::f64::consts::TAU / 6.0;
    // At the very end, and just before it, where a loop's end could not be reached before.
    for end in [6.0, 5.98] {
        for ease in [Ease::Even, Ease::InOut] {
            let keys = vec![
                SpaceKey { view: Some(turned_by(0.0)), ease, ..key(0.0) },
                SpaceKey { view: Some(turned_by(sixth)), ease, ..key(end) },
            ];
            let film = Film::new(&space(Repeat::Round, Course::Smooth, keys)).unwrap();
            let turns: Vec<f64> = (0..=60).map(|k| turn_at(&film, end * f64::from(k) / 60.0)).collect();
            assert!(turns.is_sorted() && turns[0] == 0.0 && turns[60] == sixth, "{turns:?}");
            // On what is left to the seam it goes back, and nowhere else.
            assert!((0..20).all(|k| (0.0..=sixth).contains(&turn_at(&film, end + 0.001 * f64::from(k)))));
            assert_eq!([-6.0, 12.0].map(|time| turn_at(&film, time)), [0.0; 2]);
        }
    }
    let keys = [0.0, 6.0].map(|at| SpaceKey { view: Some(turned_by(sixth * at / 6.0)), ..key(at) });
    let film = Film::new(&space(Repeat::Round, Course::Smooth, keys.to_vec())).unwrap();
    for k in 0..=12 {
        assert!((turn_at(&film, 0.5 * f64::from(k)) - sixth * f64::from(k) / 12.0).abs() < 1e-12);
    }
}

#[test]
fn a_flight_around_that_ends_as_it_begins_has_no_seam() {
    let whole = std::f64::consts::TAU;
    let around = |parts: &[f64]| {
        let keys = parts
            .iter()
            .enumerate()
            .map(|(k, part)| SpaceKey { view: Some(turned_by(0.4 + whole * part)), ..key(2.0 * k as f64) });
        Film::new(&space(Repeat::Round, Course::Smooth, keys.collect())).unwrap()
    };
    // At an even pace, and at one that has to change at the seam.
    let even = around(&[0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0]);
    let (with, without) = (around(&[0.0, 0.2, 0.6, 1.0]), around(&[0.0, 0.2, 0.6]));
    for k in 0..=24 {
        let time = 0.25 * f64::from(k);
        assert!((turn_at(&even, time) - 0.4 - whole * time / 6.0).abs() < 1e-9, "{time}");
        assert!((turn_at(&with, time) - turn_at(&without, time)).abs() < 1e-9, "{time}");
    }
}

#[test]
fn to_and_fro_comes_back_the_way_it_went() {
    let keys = vec![
        SpaceKey { view: Some(turned_by(0.0)), ..key(0.0) },
        SpaceKey { view: Some(turned_by(0.3)), moved: vec![Some(moved(1.0))], ease: Ease::In, ..key(2.5) },
        SpaceKey { view: Some(turned_by(1.0)), moved: vec![Some(moved(3.0))], ..key(6.0) },
    ];
    let film = Film::new(&space(Repeat::PingPong, Course::Smooth, keys.clone())).unwrap();
    let once = Film::new(&space(Repeat::Once, Course::Smooth, keys)).unwrap();
    for time in [0.0, 0.1, 2.5, 4.0, 5.9, 6.0] {
        let there = once.at(time).unwrap();
        assert_eq!(film.at(time).unwrap(), there);
        assert_eq!(
            film.at(time + 24.0).unwrap().view.map(|view| view.target),
            there.view.clone().map(|view| view.target)
        );
        for back in [12.0 - time, -time] {
            let off = film.at(back).unwrap().view.unwrap().turn - there.view.as_ref().unwrap().turn;
            assert!(off.abs() < 1e-12, "{time} {back}");
        }
    }
}

/// All channels of a moment: of the view, of the first object's place, and of the morph.
fn channels(moment: &Moment) -> [f64; 10] {
    let view = moment.view.clone().unwrap();
    let [x, y, z] = view.target;
    let moved = moment.objects[0].moved;
    [x, y, z, view.distance, view.turn, view.tilt, view.angle, moved[9], moved[10], moved[11]]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(64)))]
    #[test]
    fn between_two_keys_nothing_leaves_their_range(
        legs in proptest::collection::vec((prop_oneof![3 => 0.1..1.0_f64, 1 => 1e-3..2e-2_f64], proptest::array::uniform6(-1.0..1.0_f64)), 2..6),
        repeat in proptest::sample::select(vec![Repeat::Once, Repeat::Round, Repeat::PingPong]),
        last in proptest::option::of(1e-3..1.0_f64),
        same in any::<bool>(),
    ) {
        let whole: f64 = legs[1..].iter().map(|(leg, _)| leg).sum::<f64>() + last.unwrap_or(0.0);
        let mut at = 0.0;
        let mut keys = Vec::new();
        for (k, (leg, v)) in legs.iter().enumerate() {
            at += if k == 0 { 0.0 } else { *leg };
            let [x, y, z, turn, tilt, near] = if same && k == 1 { legs[0].1 } else { *v };
            let view = SpaceView { target: [x, y, z], distance: near.exp(), turn: 2.0 * turn, tilt, angle: 0.9, holds: None };
            let row = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, y, z, x];
            keys.push(SpaceKey { view: Some(view), moved: vec![Some(row)], ..key(6.0 * (at / whole).min(1.0)) });
        }
        let film = Film::new(&space(repeat, Course::Smooth, keys.clone())).unwrap();
        let of = |time: f64| channels(&film.at(time).unwrap());
        for two in keys.windows(2) {
            let [a, b] = [of(two[0].at), of(two[1].at)];
            for k in 0..=40 {
                let now = of(two[0].at + (two[1].at - two[0].at) * f64::from(k) / 40.0);
                for (x, (a, b)) in now.into_iter().zip(a.into_iter().zip(b)) {
                    prop_assert!(x >= a.min(b) - 1e-12 && x <= a.max(b) + 1e-12, "{x} {a} {b}");
                }
                if two[0].view == two[1].view {
                    prop_assert_eq!(now, a);
                }
            }
        }
    }
}

#[test]
fn a_loop_of_views_goes_on_round() {
    let view =
        |turn: f64| SpaceView { target: [0.0; 3], distance: 2.0, turn, tilt: 0.2, angle: 0.7, holds: None };
    let quarter = std::f64::consts::FRAC_PI_2;
    let keys = (0..4)
        .map(|k| SpaceKey { view: Some(view(quarter * f64::from(k))), ..key(1.5 * f64::from(k)) })
        .collect();
    let film = Film::new(&space(Repeat::Round, Course::Smooth, keys)).unwrap();
    for k in 0..=24 {
        let time = 0.25 * f64::from(k);
        let turn = film.at(time).unwrap().view.unwrap().turn;
        // A quarter in one and a half seconds, all the way, and over the end.
        let off = (turn - quarter * time / 1.5) / std::f64::consts::TAU;
        assert!((off - off.round()).abs() < 1e-9, "{time}: {turn}");
    }
}

#[test]
fn paces_hold_in_a_loop_that_goes_round() {
    let third = std::f64::consts::TAU / 3.0;
    let turns = |ease: Ease, time: f64| {
        let view = |turn: f64| SpaceView {
            target: [0.0; 3],
            distance: 2.0,
            turn,
            tilt: 0.2,
            angle: 0.7,
            holds: None,
        };
        let key =
            |k: i32| SpaceKey { view: Some(view(third * f64::from(k))), ease, ..key(2.0 * f64::from(k)) };
        let keys = (0..3).map(key).collect();
        Film::new(&space(Repeat::Round, Course::Straight, keys)).unwrap().at(time).unwrap().view.unwrap().turn
    };
    // Stay, then jump; and the last third ends where the first begins, a turn further.
    for time in [0.0, 1.0, 1.9] {
        assert!(turns(Ease::Hold, time).abs() < 1e-9, "{time}");
    }
    assert!((turns(Ease::Hold, 5.9) - 2.0 * third).abs() < 1e-9);
    assert!((turns(Ease::Even, 5.0) - 2.5 * third).abs() < 1e-9);
    assert!((turns(Ease::InOut, 0.5) - third * 0.15625).abs() < 1e-9);
}

#[test]
fn a_morph_goes_along_its_path_and_its_keys() {
    let to = Shape3::of_preset("dragon-curled").unwrap();
    let from = SpaceObject::of_preset("tetrahedron").unwrap();
    let points = vec![crate::scene::WayPoint { u: 1.0, v: 0.0, w: 0.0 }];
    let path = Path { points, ..Path::default() };
    let morph = SpaceMorph {
        to: to.clone(),
        mode: frond_core::Mode::Polar,
        path,
        t: 1.0,
        correspondence: Vec::new(),
        turns: Vec::new(),
    };
    let mut all = Space { objects: vec![from], morph: Some(morph), ..Space::default() };
    let end = Film::new(&all).unwrap().at(0.0).unwrap();
    assert_eq!(end.t, Some(1.0));
    let off = |a: &[Row3], b: &[Row3]| {
        a.iter().flatten().zip(b.iter().flatten()).fold(0.0_f64, |most, (x, y)| most.max((x - y).abs()))
    };
    assert!(off(&end.objects[0].now, &to.maps) < 1e-12);
    let keys = vec![SpaceKey { t: Some(0.0), ..key(0.0) }, SpaceKey { t: Some(1.0), ..key(4.0) }];
    all.timeline = Some(Timeline { seconds: 4.0, repeat: Repeat::Once, course: Course::Straight, keys });
    let film = Film::new(&all).unwrap();
    assert!(off(&film.at(0.0).unwrap().objects[0].now, &all.objects[0].shape.maps) < 1e-12);
    assert!((film.at(2.0).unwrap().t.unwrap() - 0.5).abs() < 1e-12);
    // Round and round too it goes evenly to its end, and jumps back from there.
    for (repeat, course) in [(Repeat::Round, Course::Smooth), (Repeat::PingPong, Course::Smooth)] {
        if let Some(line) = &mut all.timeline {
            (line.repeat, line.course) = (repeat, course);
        }
        let film = Film::new(&all).unwrap();
        for k in 0..=8 {
            let t = film.at(0.5 * f64::from(k)).unwrap().t.unwrap();
            assert!((t - f64::from(k) / 8.0).abs() < 1e-12, "{repeat:?} {k}: {t}");
        }
    }
    // Other numbers of maps cannot be morphed.
    all.objects[0] = SpaceObject::of_preset("sponge").unwrap();
    assert_eq!(Film::new(&all).unwrap_err().code(), "map-counts");
}

#[test]
fn a_lattice_goes_from_key_to_key() {
    let moves = |x: f64| {
        let mut moves = vec![[0.0; 3]; 8];
        moves[7] = [x, 0.0, -x];
        moves
    };
    let bend =
        SpaceBend { sizes: [2, 2, 2], moves: moves(9.0), kb: 0.0, ke: 3.0, delta: 0.5, spin: Spin::None };
    let bent = |keys: Vec<SpaceKey>| {
        let mut space = space(Repeat::Once, Course::Straight, keys);
        space.objects[0].bend = Some(bend.clone());
        space
    };
    let at = |bends: Vec<f64>| -> Vec<SpaceKey> {
        let key = |(i, x): (usize, &f64)| SpaceKey { bends: vec![Some(moves(*x))], ..key(2.0 * i as f64) };
        bends.iter().enumerate().map(key).collect()
    };
    let film = Film::new(&bent(at(vec![0.0, 1.0, -1.0]))).unwrap();
    for (time, x) in [(-1.0, 0.0), (1.0, 0.5), (2.0, 1.0), (3.0, 0.0), (9.0, -1.0)] {
        let found = film.at(time).unwrap().objects[0].bend.clone().unwrap();
        assert!((found[7][0] - x).abs() < 1e-12 && (found[7][2] + x).abs() < 1e-12, "{time}: {found:?}");
        assert_eq!(found[..7], moves(0.0)[..7]);
    }
    // Where no key says of it, or of another lattice, it is what the object says.
    let other = vec![SpaceKey { bends: vec![Some(vec![[1.0; 3]; 27])], ..key(0.0) }];
    for keys in [vec![key(0.0)], other] {
        assert_eq!(Film::new(&bent(keys)).unwrap().at(0.0).unwrap().objects[0].bend, None);
    }
    let mut plain = bent(at(vec![0.0, 1.0]));
    plain.objects[0].bend = None;
    assert_eq!(Film::new(&plain).unwrap().at(1.0).unwrap().objects[0].bend, None);
}
