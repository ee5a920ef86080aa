//! Tests of links.

mod bends;
mod damaged;
mod directed;
mod outlines;

use frond_core::HalfTurns;
use frond_deform::{Continuity, Roughness, Spin};
use proptest::prelude::*;

use super::*;
use crate::curve::{Curve, CurveShape, Curves};
use crate::deformation::*;
use crate::directed::{Directed, DirectedCopy, DirectedShape};
use crate::fit::{Fit, FitMode, FitModel, Graph, GraphKind, GraphPiece, SplineShape};
use crate::scene::{FamilyName, LocusView, MAX_WAY_POINTS, Path, WayPoint};
use crate::space::{Held, SpacePart, SpaceView};
use frond_fit::{Node, Spline};

fn encode(scene: &Scene) -> String {
    super::encode(scene).unwrap()
}

fn any_shape() -> impl Strategy<Value = Shape> {
    let number = prop_oneof![
        4 => -0.3..0.3_f64,
        1 => Just(0.0),
        1 => Just(-0.0),
        1 => Just(1e-300),
        1 => Just(0.1 + 0.2),
        1 => Just(f64::MIN_POSITIVE),
    ];
    let row = proptest::array::uniform6(number);
    let own = (proptest::collection::vec(row, 1..8), "\\PC{0,30}").prop_map(|(maps, name)| {
        let name = tidy(&name);
        let name = if name.is_empty() { "Own shape".to_owned() } else { name };
        Shape { preset: None, name, maps, weights: Vec::new(), exact: Vec::new() }
    });
    let gallery =
        proptest::sample::select(crate::presets()).prop_map(|preset| Shape::of_preset(preset.id).unwrap());
    let shape = prop_oneof![own.prop_filter("no attractor", |shape| shape.ifs().is_ok()), gallery];
    (shape, prop_oneof![Just(0), 1..9_u32]).prop_map(|(mut shape, step)| {
        if step > 0 {
            shape.exact = ["1/3", "sqrt(3)/6", "2**(1/3)+1"].map(str::to_owned)[..step as usize % 4].to_vec();
            shape.weights = (1..=shape.maps.len()).map(|i| f64::from(step * i as u32 % 5) + 0.1).collect();
        }
        shape
    })
}

/// A ring of knots, every third edge a copy: as a link brings it back.
fn any_curve() -> impl Strategy<Value = CurveShape> {
    (3..60_usize, -9..9_i32, proptest::collection::vec(-0.6..0.6_f64, 1..20), "\\PC{0,30}").prop_filter_map(
        "does not shrink",
        |(count, size, wobble, name)| {
            let knot = |i: usize| {
                let angle = std::f64::consts::TAU * i as f64 / count as f64;
                glam::DVec2::from_angle(angle)
                    * f64::from(size).exp2()
                    * (1.0 + 0.3 * wobble[i % wobble.len()])
            };
            let edge = |i: usize| {
                let c = wobble[i % wobble.len()];
                let copy =
                    frond_fit::ArcCopy { from: (i + 1) % count, span: 3, reversed: i.is_multiple_of(2), c };
                (i.is_multiple_of(3) && count > 6).then_some(copy)
            };
            let knots = (0..count).map(knot).collect();
            let curve = frond_fit::ClosedCurve { knots, edges: (0..count).map(edge).collect() };
            let name = tidy(&name);
            let name = if name.is_empty() { "Own curve".to_owned() } else { name };
            Some(CurveShape { name, curve: Curve::from(&curve.quantised().ok()?), ..CurveShape::default() })
        },
    )
}

/// An end of a morph: a closed curve, or the word of a spline in its place.
fn any_end() -> impl Strategy<Value = CurveShape> {
    let spline = any_spline().prop_map(|SplineShape { name, word }| CurveShape {
        name,
        spline: Some(word),
        ..CurveShape::default()
    });
    prop_oneof![2 => any_curve(), 1 => spline]
}

/// A shape of up to four states, with copies of states that are there.
fn any_directed() -> impl Strategy<Value = DirectedShape> {
    let number = prop_oneof![6 => -0.4..0.4_f64, 1 => Just(0.0), 1 => Just(-0.0), 1 => Just(1e-300), 1 => Just(0.1 + 0.2)];
    let copy =
        (0..64_usize, proptest::array::uniform6(number)).prop_map(|(from, map)| DirectedCopy { from, map });
    let states = proptest::collection::vec(proptest::collection::vec(copy, 1..5), 1..5);
    let own = (states, "\\PC{0,30}").prop_map(|(mut states, name)| {
        let count = states.len();
        states.iter_mut().flatten().for_each(|copy| copy.from %= count);
        let name = tidy(&name);
        let name = if name.is_empty() { "Own shape".to_owned() } else { name };
        DirectedShape { preset: None, name, states, outline: None }
    });
    let gallery = proptest::sample::select(crate::directed_presets())
        .prop_map(|preset| DirectedShape::of_preset(preset.id).unwrap());
    prop_oneof![2 => own.prop_filter("no attractor", |shape| shape.refuse_obvious().is_ok()), 1 => gallery]
}

fn any_half_turns() -> impl Strategy<Value = HalfTurns> {
    prop_oneof![Just(HalfTurns::Signs), Just(HalfTurns::CounterClockwise), Just(HalfTurns::Clockwise)]
}

/// What stands in place of the shapes: nothing, closed curves or graph-directed shapes.
fn any_stand_in() -> impl Strategy<Value = (Option<Curves>, Option<Directed>)> {
    prop_oneof![
        Just((None, None)),
        (any_end(), any_end()).prop_map(|(a, b)| (Some(Curves { a, b }), None)),
        (any_directed(), any_directed(), any_half_turns())
            .prop_map(|(a, b, half_turns)| (None, Some(Directed { a, b, half_turns }))),
    ]
}

fn any_graph() -> impl Strategy<Value = Graph> {
    let kinds = vec![GraphKind::Fif, GraphKind::Rfif, GraphKind::Pfif];
    (proptest::sample::select(kinds), proptest::collection::vec((-0.9..0.9_f64, -1.0..1.0_f64), 2..9))
        .prop_map(|(kind, list)| {
            let width = 1.0 / list.len() as f64;
            let piece = |(i, &(c, e)): (usize, &(f64, f64))| GraphPiece {
                map: [width, 0.1, c, width * i as f64, e],
                domain: [0.0, 1.0],
            };
            Graph { kind, pieces: list.iter().enumerate().map(piece).collect() }
        })
}

fn any_plane() -> impl Strategy<Value = String> {
    "[0-9.,;:e-]{1,200}"
}

fn any_spline() -> impl Strategy<Value = SplineShape> {
    let node = (-300..300_i32, -300..300_i32, any::<bool>());
    (proptest::collection::vec(node, 3..40), "\\PC{0,30}", -6..6_i32).prop_map(|(list, name, size)| {
        let node =
            |&(x, y, on): &(i32, i32, bool)| Node { at: glam::DVec2::new(f64::from(x), f64::from(y)), on };
        let spline = Spline { nodes: list.iter().map(node).collect(), grid: f64::from(size).exp2() };
        let name = tidy(&name);
        let name = if name.is_empty() { "Own curve".to_owned() } else { name };
        SplineShape { name, word: spline.to_text().unwrap() }
    })
}

fn any_fit() -> impl Strategy<Value = Fit> {
    let modes = proptest::sample::select(vec![FitMode::Outline, FitMode::Graph, FitMode::Plane]);
    let models = proptest::sample::select(vec![FitModel::Closed, FitModel::Collage, FitModel::Spline]);
    let spline = (proptest::option::of(any_spline()), prop_oneof![Just(150), 32..=4000_u32]);
    let curve = proptest::option::of(any_curve());
    let graph = proptest::option::of(any_graph());
    let plane = proptest::option::of(any_plane());
    (modes, models, 12..=2000_u32, 0.0..=1.0_f64, curve, (graph, plane), spline).prop_map(
        |(mode, model, numbers, smoothing, curve, (graph, plane), (spline, bytes))| Fit {
            mode,
            model,
            numbers,
            bytes,
            smoothing,
            curve,
            spline,
            graph,
            plane,
        },
    )
}

fn any_point() -> impl Strategy<Value = WayPoint> {
    let w = prop_oneof![1 => Just(0.0), 1 => -1.0..1.0_f64];
    (-1.0..2.0_f64, -1.0..2.0_f64, w).prop_map(|(u, v, w)| WayPoint { u, v, w })
}

fn any_locus() -> impl Strategy<Value = LocusView> {
    let whole = (2..=64_u32, any::<bool>()).prop_map(|(sides, morph)| {
        if morph {
            LocusView::whole(FamilyName::Morph)
        } else {
            LocusView { sides, ..LocusView::whole(FamilyName::Polygon) }
        }
    });
    let w = prop_oneof![Just(0.0), -1.0..1.0_f64];
    (whole, any_point(), 1.5..1e13_f64, w, proptest::option::of(any_point()))
        .prop_map(|(view, WayPoint { u: x, v: y, .. }, zoom, w, at)| LocusView { x, y, zoom, w, at, ..view })
}

prop_compose! {
    fn any_deform()(
        columns in 2..=5_usize,
        rows in 2..=4_usize,
        moved in proptest::collection::vec((0..40_usize, prop_oneof![Just(0.0), -2.0..2.0_f64]), 0..9),
        corner in (-3.0..3.0_f64, -3.0..3.0_f64, 1e-3..9.0_f64, 1e-3..9.0_f64),
        times in proptest::collection::btree_set(0..1000_u32, 1..5),
        (kb, more) in prop_oneof![Just((0.0, 9.0)), (0.0..4.0_f64, 0.0..4.0_f64)],
        delta in prop_oneof![
            (0.0..2.0_f64).prop_map(Roughness::Constant),
            proptest::array::uniform4(0.0..2.0_f64).prop_map(Roughness::Corners)
        ],
        spin in proptest::sample::select(vec![Spin::None, Spin::Orthogonal, Spin::Rotation, Spin::Scaled]),
        continuity in proptest::sample::select(vec![Continuity::Auto, Continuity::Corners, Continuity::Splat, Continuity::Raw, Continuity::Average, Continuity::Published]),
        flags: [bool; 5],
        phase in 0.0..=1.0_f64,
        seconds in 0.5..=60.0_f64,
        colour in 0..0x0100_0000_u32,
    ) -> Deformation {
        let [on, picture, looped, superposed, tinted] = flags;
        let (x, y, width, height) = corner;
        let count = columns * rows;
        let keys = times.into_iter().enumerate().map(|(k, at)| {
            let mut moves = vec![0.0; 2 * count];
            for (i, x) in &moved {
                moves[(i + k) % (2 * count)] = *x;
            }
            Key { at: f64::from(at) / 1000.0, moves }
        });
        let tint = Tint { colours: vec![format!("#{colour:06x}"); count], kb, ke: kb + more, delta: 1.0, superposed };
        Deformation {
            on, columns, rows, phase, seconds, looped, kb, ke: kb + more, delta, spin, continuity, superposed,
            subject: if picture { Subject::Picture } else { Subject::Shape },
            parts: if picture && on { 3 } else { 2 },
            bounds: [x, y, x + width, y + height],
            keys: keys.collect(),
            tint: tinted.then_some(tint),
        }
    }
}

fn any_space() -> impl Strategy<Value = SpacePart> {
    let view =
        (-9.0..9.0_f64, 1e-9..1e9_f64, 0.01..3.1_f64, any::<bool>()).prop_map(|(x, distance, angle, eye)| {
            let holds = eye.then_some(Held::Eye);
            SpaceView { target: [x, -x, 1.0], distance, turn: 2.0 * x, tilt: x, angle, holds }
        });
    let packed = proptest::sample::select(vec![
        "",
        "o:sponge",
        "o:tree~m1,0,0,0,1,0,0,0,1,2,0,0~cff0088/time:6,1,smooth",
    ]);
    (packed, proptest::option::of(view), any::<bool>(), 0.0..600.0_f64).prop_map(|(packed, view, own, at)| {
        SpacePart { packed: packed.to_owned(), own: own && view.is_some(), view, at }
    })
}

prop_compose! {
    fn any_scene()(
        a in any_shape(),
        b in any_shape(),
        points in proptest::collection::vec(any_point(), 0..6),
        kind in proptest::sample::select(vec![PathKind::Auto, PathKind::Straight, PathKind::Drawn]),
        colouring in proptest::sample::select(COLOURS.map(|(_, colouring)| colouring).to_vec()),
        linear: bool,
        compare: bool,
        t in 0.0..=1.0_f64,
        reversed: bool,
        turn in -2..=2_i32,
        view in proptest::option::of((-5.0..5.0_f64, -5.0..5.0_f64, 0.1..1e9_f64)),
        locus in proptest::option::of(any_locus()),
        (palette, deform, (curves, directed), fit, space) in (
            proptest::collection::vec((0..1_u32 << 24).prop_map(|colour| format!("#{colour:06x}")), 0..9),
            proptest::option::of(any_deform()),
            any_stand_in(),
            proptest::option::of(any_fit()),
            proptest::option::of(any_space()),
        ),
        tool in proptest::sample::select(Tool::NAMES.map(|(_, tool)| tool).to_vec()),
    ) -> Scene {
        let maps = a.maps.len().max(b.maps.len());
        Scene {
            a, b, t, colouring, palette, compare,
            mode: if linear { Mode::Linear } else { Mode::Polar },
            path: Path { kind, points },
            correspondence: if reversed { (0..maps).rev().collect() } else { Vec::new() },
            turns: if turn == 0 { Vec::new() } else { vec![turn; maps] },
            view: view.map(|(x, y, zoom)| Window { x, y, zoom }),
            locus,
            tool, deform, fit, space,
            curves, directed,
        }
    }
}

proptest! {
    #[test]
    fn a_document_comes_back_to_the_last_bit(scene in any_scene()) {
        let link = encode(&scene);
        prop_assert!(link.len() <= MAX_LINK);
        prop_assert!(link.bytes().all(|b| b.is_ascii_graphic() && !b"\"<>`#{}|\\^".contains(&b)), "{link}");
        let (again, problem) = decode(&link);
        prop_assert_eq!(problem, None);
        // -0 equals 0, so bits are compared by the second link.
        prop_assert_eq!(&again, &scene);
        prop_assert_eq!(encode(&again), link);
    }

    #[test]
    fn nothing_makes_it_panic(text in "\\PC{0,200}") {
        let _ = decode(&text);
    }

    #[test]
    fn damaged_links_open_something(scene in any_scene(), at in 0_usize..400, with in "\\PC") {
        let mut link: Vec<char> = encode(&scene).chars().collect();
        let at = at % link.len();
        link.splice(at..=at, with.chars());
        let (opened, problem) = decode(&link.into_iter().collect::<String>());
        prop_assert!(opened.a.ifs().is_ok() && opened.b.ifs().is_ok());
        prop_assert!(problem.is_none_or(|problem| !problem.to_string().is_empty()));
    }
}

#[test]
fn links_read_like_words() {
    let mut scene = Scene::default();
    assert_eq!(encode(&scene), "v=1&a=dragon-3&b=gasket&turns=0,-1,0");
    let at = |u, v| WayPoint { u, v, w: 0.0 };
    scene.path.points = vec![at(0.25, 1.5), at(0.5, -0.125)];
    scene.t = 0.5;
    scene.compare = true;
    scene.correspondence = vec![2, 0, 1];
    scene.turns = vec![0, 1, 0];
    assert_eq!(
        encode(&scene),
        "v=1&a=dragon-3&b=gasket&path=auto:0.25,1.5;0.5,-0.125&t=0.5&match=3,1,2&compare=1"
    );
}

#[test]
fn colours_read_like_words() {
    let scene = Scene { palette: vec!["#ff0000".into(), "#00C0ff".into()], ..Scene::default() };
    let link = "v=1&a=dragon-3&b=gasket&turns=0,-1,0&palette=ff0000,00C0ff";
    assert_eq!(encode(&scene), link);
    assert_eq!(decode(link), (scene, None));
    let many = vec!["000000"; 65].join(",");
    for wrong in ["", "red", "ff00", "ff0000,", "ff0000,#00ff00", &many] {
        let key = match decode(&format!("palette={wrong}")).1 {
            Some(LinkError::Value { key, .. }) => key,
            other => panic!("{wrong}: {other:?}"),
        };
        assert_eq!(key, "palette");
    }
    // What would be more than a colour in a link is none.
    let scene = Scene { palette: vec!["#ff0000&t=0.5".into()], ..Scene::default() };
    assert!(super::encode(&scene).is_err());
}

#[test]
fn a_locus_reads_like_words() {
    let mut scene = Scene::default();
    scene.path.points = vec![WayPoint { u: 0.25, v: 1.5, w: -0.5 }];
    scene.locus = Some(LocusView {
        at: Some(WayPoint { u: 0.02, v: 0.7, w: 0.0 }),
        ..LocusView::whole(FamilyName::Polygon)
    });
    let link = "v=1&a=dragon-3&b=gasket&path=auto:0.25,1.5,-0.5&turns=0,-1,0&locus=m:0,0,1&at=0.02,0.7";
    assert_eq!(encode(&scene), link);
    assert_eq!(decode(link), (scene, None));
    let at = decode("at=0.5,0.25,1").0.locus.unwrap();
    assert_eq!((at.family, at.zoom, at.at.unwrap().w), (FamilyName::Morph, 1.0, 1.0));
    let view = decode("locus=5").0.locus.unwrap();
    assert_eq!(view, LocusView { sides: 5, ..LocusView::whole(FamilyName::Polygon) });
}

#[test]
fn an_edited_shape_of_the_gallery_is_written_out() {
    let mut scene = Scene::default();
    scene.b.maps[0][0] = 0.45;
    scene.b.name = "Gasket & more".to_owned();
    let link = encode(&scene);
    assert!(
        link.contains("&b=maps:0.45,0,0,0.5,0,0;") && link.contains("&b-name=Gasket%20%26%20more&"),
        "{link}"
    );
    let (again, problem) = decode(&link);
    assert_eq!(problem, None);
    assert_eq!((again.b.preset, again.b.name), (None, "Gasket & more".to_owned()));
}

#[test]
fn an_empty_link_is_the_default() {
    for link in ["", "#", "v=1", "#v=1", "colour=map"] {
        assert_eq!(decode(link), (Scene::default(), None));
    }
}

/// Links that were given out: they must open for ever, and as what they were.
#[test]
fn old_links_still_open() {
    let corpus = include_str!("../../tests/links.txt");
    let mut count = 0;
    for line in corpus.lines().filter(|line| !line.is_empty() && !line.starts_with("//")) {
        let (scene, problem) = decode(line);
        assert_eq!(problem, None, "{line}");
        assert_eq!(encode(&scene), line);
        count += 1;
    }
    assert!(count >= 8);
}

/// The second map of the dragon of three turns by half a turn. Links were written that leave it open which, when it was
/// counter-clockwise from either end; eq 6 of Burch & Hart (1997) has it clockwise from the dragon on.
#[test]
fn a_link_keeps_the_half_turn_that_it_showed() {
    let halfway = |scene: &Scene| {
        let ends = pair(&scene.a.ifs().unwrap(), &scene.b.ifs().unwrap());
        let (correspondence, turns) = (scene.correspondence.clone(), scene.turns.clone());
        let options = frond_core::MorphOptions { mode: scene.mode, correspondence, turns };
        let morph: frond_core::Morph = frond_core::Morph::new(&ends.from, &ends.to, &options).unwrap();
        morph.at(0.5, 0.5)[1].to_row().map(|x| (x * 1e9).round() / 1e9)
    };
    // Half as large, turned by so many quarters from lying along the x axis, at (3/4, 0).
    let turned = |cos: f64, sin: f64| [cos * 0.5, -sin * 0.5, sin * 0.5, cos * 0.5, 0.75, 0.0];
    let (back, forward) = (turned(0.0, 1.0), turned(0.0, -1.0));
    let opened = |link: &str| decode_morph(link).unwrap();
    for (link, shown) in [
        ("v=1&a=dragon-3&b=gasket", forward),
        ("v=1&a=dragon-3&b=gasket&turns=0,0,0", forward),
        ("v=1&a=dragon-3&b=gasket&turns=0,-1,0", back),
        ("v=1&a=gasket&b=dragon-3", back),
        ("v=1&a=gasket&b=dragon-3&turns=0,-1,0", forward),
        ("", back),
    ] {
        let scene = opened(link);
        assert_eq!(halfway(&scene), shown, "{link}");
        assert_eq!(halfway(&opened(&encode(&scene))), shown, "{link}");
        assert_eq!(decode(link), (scene, None), "{link}");
    }
    // As far as turns go.
    for turns in [-16, 15] {
        let scene = Scene { turns: vec![0, turns, 0], ..Scene::default() };
        assert_eq!(decode(&encode(&scene)), (scene, None));
    }
    for beyond in ["17", "-18", "99999999999"] {
        assert!(decode(&format!("v=1&a=dragon-3&b=gasket&turns=0,{beyond},0")).1.is_some(), "{beyond}");
    }
}

#[test]
fn the_morph_of_a_link_is_read_alone_and_passes_over_the_rest() {
    let link = "v=1&a=koch&b=gasket&mode=linear&path=drawn:0.2,0.8&t=0.3&colour=address";
    let (scene, _) = decode(link);
    assert_eq!(decode_morph(&format!("#{link}")), Ok(scene.clone()));
    // What it does not show may be damaged or of a later version.
    let rest = "&view=nowhere&locus=?&mesh=x&curve-a=maple&space=!";
    assert_eq!(decode_morph(&format!("{link}{rest}")), Ok(scene));
    assert_eq!(decode_morph("tool=space").map(|scene| scene.tool), Ok(Tool::Space));
    for damaged in ["a=nobody", "t=x", "path=drawn:1", "match=2", "a=maps:2,0,0,2,0,0", "tool=hammer"] {
        assert!(decode_morph(damaged).is_err(), "{damaged}");
    }
    assert!(matches!(decode_morph(&"a".repeat(MAX_LINK + 1)), Err(LinkError::TooLong { .. })));
}

#[test]
fn exact_numbers_of_a_shape_are_formulas() {
    let (scene, problem) = decode("v=1&a=maps:0.3,0,0,0.3,0,0&a-exact=1/3,sqrt(3)/6,2**0.5%2B1&b=koch");
    assert_eq!(
        (&scene.a.exact[..], problem),
        (&["1/3", "sqrt(3)/6", "2**0.5+1"].map(str::to_owned)[..], None)
    );
    assert!(encode(&scene).contains("&a-exact=1/3,sqrt(3)/6,2**0.5+1&b=koch"));
    let (long, many) = ("1".repeat(201), ["1"; 65].join(","));
    for bad in ["", "1/3,", "1/3;2", "SQRT(2)", "1%203", "%E2%88%9A3", "2^3", "a=b", &long, &many] {
        let (opened, problem) = decode(&format!("v=1&a=gasket&a-exact={bad}&b=koch"));
        assert_eq!(opened, Scene::default(), "{bad}");
        assert!(matches!(problem, Some(LinkError::Value { key: "a-exact", .. })), "{bad}");
    }
    let loud = Scene { a: Shape { exact: vec!["π".to_owned()], ..scene.a.clone() }, ..scene };
    assert!(matches!(super::encode(&loud), Err(LinkError::Unfit { key: "a-exact", .. })));
}

#[test]
fn weights_are_one_a_map_and_can_be_drawn_by() {
    let (scene, problem) = decode("v=1&a=gasket&a-weights=0,2,0.5&b=koch");
    assert_eq!((&scene.a.weights[..], problem), (&[0.0, 2.0, 0.5][..], None));
    assert!(encode(&scene).contains("a=gasket&a-weights=0,2,0.5&b=koch"));
    assert_eq!(scene.a.ifs().unwrap().probabilities(), [0.0, 0.8, 0.2]);
    for bad in ["1,2", "1,2,3,4", "0,0,0", "-1,1,1", "1,x,1", "1;1;1x", "", "1e308,1e308,1e308"] {
        let (opened, problem) = decode(&format!("v=1&a=gasket&a-weights={bad}&b=koch"));
        let empty = bad.is_empty();
        assert_eq!((opened == Scene::default(), problem.is_some()), (!empty, !empty), "{bad}");
    }
}
