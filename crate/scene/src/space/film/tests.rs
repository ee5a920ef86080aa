//! Tests of films.

use super::*;
use crate::scene::Path;
use crate::space::document::{CourseName, EaseName, Shape3, SpaceMorph, Timeline};

const HOME: Row3 = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

fn moved(x: f64) -> Row3 {
    let mut row = HOME;
    row[9] = x;
    row
}

fn key(at: f64) -> SpaceKey {
    SpaceKey { at, ..SpaceKey::default() }
}

fn space(repeats: bool, course: CourseName, keys: Vec<SpaceKey>) -> Space {
    let timeline = Some(Timeline { seconds: 6.0, repeats, course, keys });
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
    let film = Film::new(&space(false, CourseName::Straight, keys)).unwrap();
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
            SpaceKey { moved: vec![Some(b)], ease: EaseName::Hold, ..key(3.0) },
        ];
        Film::new(&space(true, CourseName::Smooth, keys))
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
    let film = Film::new(&space(false, CourseName::Straight, keys)).unwrap();
    let middle = film.at(1.0).unwrap().view.unwrap();
    assert!((middle.turn - std::f64::consts::PI).abs() < 1e-9, "{middle:?}");
    assert!((middle.distance - 2.0).abs() < 1e-9 && middle.is_one());
}

#[test]
fn a_loop_of_views_goes_on_round() {
    let view =
        |turn: f64| SpaceView { target: [0.0; 3], distance: 2.0, turn, tilt: 0.2, angle: 0.7, holds: None };
    let quarter = std::f64::consts::FRAC_PI_2;
    let keys = (0..4)
        .map(|k| SpaceKey { view: Some(view(quarter * f64::from(k))), ..key(1.5 * f64::from(k)) })
        .collect();
    let film = Film::new(&space(true, CourseName::Smooth, keys)).unwrap();
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
    let turns = |ease: EaseName, time: f64| {
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
        Film::new(&space(true, CourseName::Straight, keys)).unwrap().at(time).unwrap().view.unwrap().turn
    };
    // Stay, then jump; and the last third ends where the first begins, a turn further.
    for time in [0.0, 1.0, 1.9] {
        assert!(turns(EaseName::Hold, time).abs() < 1e-9, "{time}");
    }
    assert!((turns(EaseName::Hold, 5.9) - 2.0 * third).abs() < 1e-9);
    assert!((turns(EaseName::Even, 5.0) - 2.5 * third).abs() < 1e-9);
    assert!((turns(EaseName::InOut, 0.5) - third * 0.15625).abs() < 1e-9);
}

#[test]
fn a_morph_goes_along_its_path_and_its_keys() {
    let to = Shape3::of_preset("dragon-curled").unwrap();
    let from = SpaceObject::of_preset("tetrahedron").unwrap();
    let points = vec![crate::scene::WayPoint { u: 1.0, v: 0.0, w: 0.0 }];
    let path = Path { points, ..Path::default() };
    let morph = SpaceMorph {
        to: to.clone(),
        mode: crate::scene::ModeName::Polar,
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
    all.timeline = Some(Timeline { seconds: 4.0, repeats: false, course: CourseName::Straight, keys });
    let film = Film::new(&all).unwrap();
    assert!(off(&film.at(0.0).unwrap().objects[0].now, &all.objects[0].shape.maps) < 1e-12);
    assert!((film.at(2.0).unwrap().t.unwrap() - 0.5).abs() < 1e-12);
    // Other numbers of maps cannot be morphed.
    all.objects[0] = SpaceObject::of_preset("sponge").unwrap();
    assert_eq!(Film::new(&all).unwrap_err().code(), "map-counts");
}
