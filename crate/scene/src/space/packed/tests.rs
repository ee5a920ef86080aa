//! Tests of the word of a space.

use proptest::prelude::*;
use serde::de::IntoDeserializer;
use serde::de::value::Error as ValueError;

use frond_deform::Spin;

use super::bend::SPINS;
use super::*;
use crate::space::document::{PaintName, natural_objects, natural_space, read_repeat};

fn any_row() -> impl Strategy<Value = Row3> {
    let number = prop_oneof![6 => -0.28..0.28_f64, 1 => Just(0.0), 1 => Just(-0.0), 1 => Just(1e-300)];
    proptest::collection::vec(number, 12).prop_map(|list| list.try_into().unwrap())
}

fn any_shape() -> impl Strategy<Value = Shape3> {
    let ids: Vec<&str> = crate::presets3().iter().map(|preset| preset.id).collect();
    let own = (proptest::collection::vec(any_row(), 1..6), "\\PC{0,20}").prop_map(|(maps, name)| {
        let name = tidy(&name);
        let name = if name.is_empty() { "Own shape".to_owned() } else { name };
        Shape3 { preset: None, name, maps }
    });
    prop_oneof![
        own.prop_filter("no attractor", |shape| shape.ifs().is_ok()),
        proptest::sample::select(ids).prop_map(|id| Shape3::of_preset(id).unwrap()),
    ]
}

fn any_view() -> impl Strategy<Value = SpaceView> {
    (-9.0..9.0_f64, 1e-3..1e3_f64, -9.0..9.0_f64, 0.01..3.1_f64).prop_map(|(x, distance, turn, angle)| {
        SpaceView { target: [x, -x, 0.5 * x], distance, turn, tilt: 0.3 * turn, angle, holds: None }
    })
}

fn any_bend() -> impl Strategy<Value = SpaceBend> {
    let sizes = [2..=3_usize, 2..=4_usize, 2..=3_usize];
    let spin = proptest::sample::select(SPINS.to_vec());
    (sizes, 0.0..=1.0_f64, 0.0..=16.0_f64, 0.0..=1.5_f64, spin).prop_flat_map(
        |(sizes, part, ke, delta, spin)| {
            let by = prop_oneof![Just([0.0; 3]), [-10.0..10.0_f64, 0.0..0.5_f64, -1.0..1.0_f64]];
            proptest::collection::vec(by, sizes.iter().product::<usize>()).prop_map(move |moves| SpaceBend {
                sizes,
                moves,
                kb: part * ke,
                ke,
                delta,
                spin,
            })
        },
    )
}

fn any_object() -> impl Strategy<Value = SpaceObject> {
    let tint = proptest::option::of(Just("#12ab9f".to_owned()));
    let bend = proptest::option::of(any_bend());
    (any_shape(), proptest::option::of(any_row()), tint, bend)
        .prop_map(|(shape, moved, tint, bend)| SpaceObject { shape, moved, tint, bend })
}

fn any_space() -> impl Strategy<Value = Space> {
    let light = (any::<bool>(), -3.0..3.0_f64, 0.0..=1.0_f64, any::<bool>());
    let light = light.prop_map(|(height, side, part, finished)| {
        let plain = SpaceLight {
            paint: if height { PaintName::Height } else { PaintName::Map },
            side,
            front: part,
            ambient: 1.0 - part,
            hollows: part,
            fog: 0.5 * part,
            ..SpaceLight::default()
        };
        let filmic = f64::from(u8::from(height));
        let finish = [part, 1.0 - part, 0.5 * part, 0.3, 0.0, filmic];
        if finished { plain.with_finish(finish).unwrap() } else { plain }
    });
    let light = prop_oneof![4 => light, 1 => Just(SpaceLight::fresh()), 1 => Just(SpaceLight::default())];
    let morph =
        proptest::option::of((any_shape(), 0.0..=1.0_f64, any::<bool>()).prop_map(|(to, t, linear)| {
            let points = vec![WayPoint { u: t, v: 0.3, w: 0.0 }, WayPoint { u: 0.7, v: t, w: 0.25 }];
            let kind = if linear { PathKind::Drawn } else { PathKind::Straight };
            let mode = if linear { Mode::Linear } else { Mode::Polar };
            SpaceMorph {
                to,
                mode,
                path: Path { kind, points },
                t,
                correspondence: Vec::new(),
                turns: Vec::new(),
            }
        }));
    let key = (
        0.0..600.0_f64,
        proptest::sample::select(EASES.map(|(_, ease)| ease).to_vec()),
        proptest::option::of(any_view()),
        proptest::option::of(any_row()),
        proptest::option::of(proptest::collection::vec(any_row(), 1..4)),
        proptest::option::of(0.0..=1.0_f64),
        proptest::option::of(any_bend()),
    )
        .prop_map(|(at, ease, view, moved, maps, t, bend)| SpaceKey {
            at,
            ease,
            view,
            moved: moved.map_or(Vec::new(), |row| vec![None, Some(row)]),
            maps: maps.map_or(Vec::new(), |rows| vec![Some(rows)]),
            bends: bend.map_or(Vec::new(), |bend| vec![None, None, Some(bend.moves)]),
            t,
        });
    let line =
        proptest::option::of((0.1..600.0_f64, 0..3_usize, proptest::collection::vec(key, 0..5)).prop_map(
            |(seconds, repeat, keys)| {
                let course = if repeat == 1 { Course::Smooth } else { Course::Straight };
                Timeline { seconds, repeat: REPEATS[repeat].1, course, keys }
            },
        ));
    let background =
        proptest::option::of(prop_oneof![Just("#0e1015".to_owned()), Just(PAGE_BACKGROUND.to_owned())]);
    (proptest::collection::vec(any_object(), 1..5), light, background, morph, line).prop_map(
        |(objects, light, background, morph, timeline)| Space { objects, light, background, morph, timeline },
    )
}

/// Words were written in which half a turn was always counter-clockwise about the axis that points up, and whole turns
/// were counted about the axis wherever it pointed.
#[test]
fn a_word_keeps_the_turns_that_it_showed() {
    let maps = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        format!("maps;{},{},0,{},{},0,0,0,0.5,0,0,0", cos * 0.5, -sin * 0.5, sin * 0.5, cos * 0.5)
    };
    for (from, to, turns, halfway) in [
        (180.0, 0.0, "", 270.0),
        (0.0, 180.0, "", 90.0),
        (180.0, 0.0, "/turns:-1", 90.0),
        (0.0, -90.0, "", -45.0),
        (0.0, -90.0, "/turns:1", -225.0),
        (0.0, 90.0, "/turns:1", 225.0),
    ] {
        let word = format!("o:{}/to:{}{turns}", maps(from), maps(to));
        let space = unpack(&word).unwrap();
        for space in [unpack(&pack(&space).unwrap()).unwrap(), space] {
            let morph = space.morph.unwrap();
            let [first, last] = [&space.objects[0].shape, &morph.to].map(|shape| affine(&shape.maps));
            let at: Vec<frond_core::Affine3> =
                frond_core::Morph3::new(&first, &last, &morph.options()).unwrap().at(0.5, 0.5);
            let angle = at[0].linear.x_axis.y.atan2(at[0].linear.x_axis.x).to_degrees();
            let off = (angle - halfway) / 360.0;
            assert!((off - off.round()).abs() < 1e-9, "{word}: {angle}");
        }
    }
}

proptest! {
    #[test]
    fn what_is_packed_comes_back(space in any_space()) {
        let word = pack(&space).unwrap();
        prop_assert!(!word.contains(['&', '#', ' ']));
        prop_assert_eq!(unpack(&word).unwrap(), space);
    }

    #[test]
    fn no_word_panics(word in "\\PC{0,80}") {
        let _ = unpack(&word);
    }

    #[test]
    fn no_damage_panics(space in any_space(), at in 0..4000_usize, with in "\\PC{0,3}", cut in 0..9_usize) {
        let word = pack(&space).unwrap();
        let at = (at % (word.len() + 1)..=word.len()).find(|&at| word.is_char_boundary(at)).unwrap();
        let end = (at + cut).min(word.len());
        let end = (end..=word.len()).find(|&end| word.is_char_boundary(end)).unwrap();
        if let Ok(read) = unpack(&format!("{}{with}{}", &word[..at], &word[end..])) {
            // What is read can be written, unless it has become too long.
            let again = matches!(pack(&read), Ok(_) | Err(PackedError::TooLong { .. }));
            prop_assert!(again);
        }
    }
}

#[test]
fn words_are_short_where_the_gallery_says_it() {
    assert_eq!(pack(&Space::default()).unwrap(), "o:sponge/f:1");
    let plain = Space { light: SpaceLight::default(), ..Space::default() };
    assert_eq!(pack(&plain).unwrap(), "o:sponge");
    let natural = Space { objects: natural_objects(), ..plain };
    assert_eq!(
        pack(&natural).unwrap(),
        (0..13).map(|k| format!("o:evening-{k}")).collect::<Vec<_>>().join("/")
    );
    assert_eq!(unpack(&pack(&natural).unwrap()).unwrap(), natural);
    // Links of before there was an evening have the scene of then.
    let older = (0..8).map(|k| format!("o:natural-{k}")).collect::<Vec<_>>().join("/");
    let read = unpack(&older).unwrap();
    assert_eq!(pack(&read).unwrap(), older);
    assert_eq!(read.objects[0].shape.name, "Ground");
    let evening = natural_space();
    assert_eq!(unpack(&pack(&evening).unwrap()).unwrap(), evening);
}

#[test]
fn the_background_is_part_of_the_word_and_older_words_have_none() {
    let light = SpaceLight::default();
    let dark = Space { background: Some("#0e1015".to_owned()), light, ..Space::default() };
    assert_eq!(pack(&dark).unwrap(), "o:sponge/b:0e1015");
    assert_eq!(unpack("o:sponge/b:0e1015").unwrap(), dark);
    assert_eq!(unpack("o:sponge/b:page").unwrap().background.as_deref(), Some(PAGE_BACKGROUND));
    assert_eq!(unpack("o:sponge").unwrap().background, None);
}

#[test]
fn words_of_before_there_was_a_finish_have_none() {
    for word in ["o:sponge", "o:sponge/l:height,0.1,0.2,0.3,0.4,0.5"] {
        let read = unpack(word).unwrap();
        assert_eq!(read.light.finish(), [0.0; 6], "{word}");
        assert_eq!(pack(&read).unwrap(), word);
    }
    assert_eq!(unpack("o:sponge").unwrap().light.numbers(), [-0.56, 0.55, 0.35, 0.75, 0.25]);
    // What has a number is as it was when it was given.
    let light = unpack("o:sponge/f:1").unwrap().light;
    assert_eq!(light.numbers(), [-0.56, 0.55, 0.25, 0.35, 0.25]);
    assert_eq!(light.finish(), [0.85, 0.35, 0.8, 0.5, 0.0, 1.0]);
    let mixed = "o:sponge/l:height,0.1,0.2,0.3,0.4,0.5/f:0.1,0.2,0.3,0.4,0.5,0";
    assert_eq!(pack(&unpack(mixed).unwrap()).unwrap(), mixed);
}

#[test]
fn links_of_before_to_and_fro_open_as_they_were() {
    let line =
        |word: &str| unpack(&format!("o:sponge/time:{word}/k:0,even/k:6,even")).unwrap().timeline.unwrap();
    assert_eq!(
        ["6,0,smooth", "6,1,straight", "6,2,smooth"].map(|word| line(word).repeat),
        [Repeat::Once, Repeat::Round, Repeat::PingPong]
    );
    // And so do documents that other programs keep.
    let older = |round: bool| read_repeat(IntoDeserializer::<ValueError>::into_deserializer(round)).unwrap();
    assert_eq!([older(false), older(true)], [Repeat::Once, Repeat::Round]);
    let named = |name: &'static str| read_repeat(IntoDeserializer::<ValueError>::into_deserializer(name));
    assert_eq!(
        ["once", "round", "pingpong"].map(|name| named(name).unwrap()),
        [Repeat::Once, Repeat::Round, Repeat::PingPong]
    );
    assert!(named("twice").unwrap_err().to_string().contains("pingpong"));
}

#[test]
fn damage_is_told() {
    let many = "o:sponge/".repeat(61);
    for (word, code) in [
        ("", "space-damaged"),
        ("o:nothing", "space-damaged"),
        ("o:maps;1,2,3", "space-damaged"),
        ("o:maps;2,0,0,0,2,0,0,0,2,0,0,0", "space-shape"),
        ("l:map,0,0,0,0,0", "space-count"),
        (many.trim_end_matches('/'), "space-count"),
        ("o:sponge/l:map,0,2,0,0,0", "space-number"),
        ("o:sponge/f:2,0,0,0,0,0", "space-number"),
        ("o:sponge/f:0,0,0,0,0,0.5", "space-damaged"),
        ("o:sponge/f:0,0,0,0,0", "space-damaged"),
        ("o:sponge/f:2", "space-damaged"),
        ("o:sponge/time:0,1,smooth", "space-number"),
        ("o:sponge/time:1e9,1,smooth", "space-number"),
        ("o:sponge/time:6,3,smooth", "space-damaged"),
        ("o:sponge/k:0,even", "space-damaged"),
        ("o:sponge/to:dust/match:1,1", "space-number"),
        ("o:sponge/time:6,1,smooth/k:0,even~v0,0,0,-1,0,0,1", "space-damaged"),
        ("o:sponge~mNaN,0,0,0,1,0,0,0,1,0,0,0", "space-damaged"),
        ("o:sponge~c12", "space-number"),
        ("o:sponge/b:12", "space-number"),
        ("o:sponge/b:", "space-number"),
        ("o:sponge/b:éééé", "space-number"),
    ] {
        assert_eq!(unpack(word).map_err(|error| error.code().to_owned()), Err(code.to_owned()), "{word}");
    }
    // Of a later version.
    assert!(unpack("o:sponge/water:deep").is_ok());
}

#[test]
fn a_bend_that_is_none_is_refused_in_words() {
    let good = "o:sponge~b3,3,3,0,3,0.5,1;26,0.2,0,-0.4";
    let bend = unpack(good).unwrap().objects.remove(0).bend.unwrap();
    assert_eq!((bend.moves[26], bend.moves[25], bend.spin), ([0.2, 0.0, -0.4], [0.0; 3], Spin::Orthogonal));
    for bad in [
        "1,3,3,0,3,0.5,0",
        "3,3,7,0,3,0.5,0",
        "3,3,3,4,3,0.5,0",
        "3,3,3,0,17,0.5,0",
        "3,3,3,0,3,-1,0",
        "3,3,3,0,3,NaN,0",
        "3,3,3,0,3,0.5,4",
        "3,3,3,0,3,0.5",
        "3,3,3,0,3,0.5,0;27,0,0,1",
        "3,3,3,0,3,0.5,0;1,0,0",
        "3,3,3,0,3,0.5,0;1,0,0,11",
        "3,3,3,0,3,0.5,0;1,0,0,inf",
        "99999999999,3,3,0,3,0.5,0",
    ] {
        let error = unpack(&format!("o:sponge~b{bad}")).unwrap_err();
        assert!(!error.to_string().is_empty(), "{bad}");
    }
}

#[test]
fn lattices_of_keys_are_written_short_and_refused_where_they_are_none() {
    let word = "o:sponge~b3,3,3,0,3,0.5,0/time:6,1,smooth/k:0,even~b0,27/k:3,even~b0,27;26,0.2,0,0.4";
    let space = unpack(word).unwrap();
    let keys = &space.timeline.as_ref().unwrap().keys;
    assert_eq!(keys[0].bends, vec![Some(vec![[0.0; 3]; 27])]);
    assert_eq!(keys[1].bends[0].as_ref().unwrap()[26], [0.2, 0.0, 0.4]);
    assert_eq!(pack(&space).unwrap(), word);
    for bad in ["~b0,217", "~b0,-1", "~b60,27", "~b0,27;27,0,0,0", "~b0,27;0,0,0", "~b0,27;0,11,0,0", "~b0"] {
        assert!(unpack(&word.replacen("~b0,27", bad, 1)).is_err(), "{bad}");
    }
}
