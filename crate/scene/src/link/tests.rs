//! Tests of links.

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
        Shape { preset: None, name, maps, weights: Vec::new() }
    });
    let gallery =
        proptest::sample::select(crate::presets()).prop_map(|preset| Shape::of_preset(preset.id).unwrap());
    let shape = prop_oneof![own.prop_filter("no attractor", |shape| shape.ifs().is_ok()), gallery];
    (shape, prop_oneof![Just(0), 1..9_u32]).prop_map(|(mut shape, step)| {
        if step > 0 {
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
            Some(CurveShape { preset: None, name, curve: Curve::from(&curve.quantised().ok()?) })
        },
    )
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

/// What stands in place of the shapes: nothing, closed curves or graph-directed shapes.
fn any_stand_in() -> impl Strategy<Value = (Option<Curves>, Option<Directed>)> {
    prop_oneof![
        Just((None, None)),
        (any_curve(), any_curve()).prop_map(|(a, b)| (Some(Curves { a, b }), None)),
        (any_directed(), any_directed()).prop_map(|(a, b)| (None, Some(Directed { a, b }))),
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
        continuity in proptest::sample::select(vec![Continuity::Auto, Continuity::Corners, Continuity::Splat, Continuity::Raw, Continuity::Average]),
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
    assert_eq!(encode(&scene), "v=1&a=dragon-3&b=gasket");
    let at = |u, v| WayPoint { u, v, w: 0.0 };
    scene.path.points = vec![at(0.25, 1.5), at(0.5, -0.125)];
    scene.t = 0.5;
    scene.compare = true;
    scene.correspondence = vec![2, 0, 1];
    assert_eq!(
        encode(&scene),
        "v=1&a=dragon-3&b=gasket&path=auto:0.25,1.5;0.5,-0.125&t=0.5&match=3,1,2&compare=1"
    );
}

#[test]
fn colours_read_like_words() {
    let scene = Scene { palette: vec!["#ff0000".into(), "#00C0ff".into()], ..Scene::default() };
    let link = "v=1&a=dragon-3&b=gasket&palette=ff0000,00C0ff";
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
    let link = "v=1&a=dragon-3&b=gasket&path=auto:0.25,1.5,-0.5&locus=m:0,0,1&at=0.02,0.7";
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
        link.contains("&b=maps:0.45,0,0,0.5,0,0;") && link.ends_with("&b-name=Gasket%20%26%20more"),
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

#[test]
fn bad_links_give_the_default_and_a_reason() {
    let many = format!("a=maps:{}", vec!["0.1,0,0,0.1,0,0"; 65].join(";"));
    let points = format!("path=drawn:{}", vec!["0,0"; 65].join(";"));
    for (link, code) in [
        ("a=", "link-damaged"),
        ("a=nobody", "link-damaged"),
        ("a=maps:", "link-shape"),
        ("a=maps:1,2,3", "link-damaged"),
        ("a=maps:1,2,3,4,5,6,7", "link-damaged"),
        ("a=maps:NaN,0,0,0,0,0", "link-damaged"),
        ("a=maps:inf,0,0,0,0,0", "link-damaged"),
        ("a=maps:1e999,0,0,0,0,0", "link-damaged"),
        ("a=maps:1e200,0,0,0,0,0", "link-shape"),
        ("a=maps:1,0,0,1,0,0", "link-shape"),
        ("b=maps:0.5,0,0,0.5,0,0;2,0,0,2,0,0", "link-shape"),
        (many.as_str(), "link-damaged"),
        (points.as_str(), "link-damaged"),
        ("path=drawn:1,2,3,4", "link-damaged"),
        ("path=drawn:1", "link-damaged"),
        ("at=1", "link-damaged"),
        ("at=1,NaN", "link-damaged"),
        ("locus=1:0,0,1", "link-damaged"),
        ("locus=65", "link-damaged"),
        ("locus=morph:0,0,0", "link-damaged"),
        ("locus=morph:1e300,0,1", "link-damaged"),
        ("locus=m:0,0", "link-damaged"),
        ("path=round", "link-damaged"),
        ("path=drawn:1", "link-damaged"),
        ("path=drawn:1e300,0", "link-damaged"),
        ("t=now", "link-damaged"),
        ("t=NaN", "link-damaged"),
        ("match=1,1,2", "link-damaged"),
        ("match=0,1,2", "link-damaged"),
        ("match=99999999999999999999", "link-damaged"),
        ("turns=1", "link-damaged"),
        ("turns=1,2,99", "link-damaged"),
        ("view=0,0,0", "link-damaged"),
        ("view=0,0,-1", "link-damaged"),
        ("view=0,0", "link-damaged"),
        ("compare=yes", "link-damaged"),
        ("colour=<script>", "link-damaged"),
        ("v=0", "link-damaged"),
        ("v=x", "link-damaged"),
    ] {
        let (scene, problem) = decode(link);
        assert_eq!(scene, Scene::default(), "{link}");
        assert_eq!(problem.map(|problem| problem.code()), Some(code), "{link}");
    }
    let huge = format!("a={}", "maps:".repeat(20_000));
    assert_eq!(decode(&huge).1.map(|problem| problem.code()), Some("link-too-long"));
}

#[test]
fn a_later_version_shows_what_is_understood() {
    let (scene, problem) = decode("v=2&a=koch&weather=rain");
    assert_eq!(scene.a.preset.as_deref(), Some("koch"));
    assert_eq!(problem, Some(LinkError::Later));
}

#[test]
fn the_largest_document_fits_a_link() {
    let shape = Shape {
        preset: None,
        name: "ä".repeat(60),
        maps: vec![[-0.123_456_789_012_345_67e-7; 6]; 64],
        weights: Vec::new(),
    };
    let mut scene = Scene { a: shape.clone(), b: shape, ..Scene::default() };
    let x = -0.123_456_789_012_345_67;
    scene.path.points = vec![WayPoint { u: x, v: x, w: x }; MAX_WAY_POINTS];
    scene.turns = vec![-16; 64];
    scene.correspondence = (0..64).collect();
    let link = encode(&scene);
    assert!(link.len() < MAX_LINK / 2, "{}", link.len());
    assert_eq!(decode(&link), (scene, None));
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

#[test]
fn a_deformation_reads_like_words() {
    let mut deform = Deformation::at_rest([0.0, 0.0, 1.0, 1.0]);
    let moves = &mut deform.keys[0].moves;
    (moves[10], moves[11]) = (0.1, 0.25);
    let scene = Scene { tool: Tool::Deform, deform: Some(deform), ..Scene::default() };
    let words = "v=1&a=dragon-3&b=gasket&tool=deform&mesh=4x4:0,0,1,1&bend=0,9,0.75&keys=0:6,0.1,0.25";
    assert_eq!(encode(&scene), words);
    assert_eq!(decode(words), (scene, None));
}

#[test]
fn damaged_deformations_say_which_word_is() {
    let key_of = |words: &str| match decode(&format!("v=1&a=gasket&b=gasket&{words}")).1 {
        Some(LinkError::Value { key, .. }) => key,
        other => panic!("{words}: {other:?}"),
    };
    for (words, key) in [
        ("tool=hammer", "tool"),
        ("mesh=4x4", "mesh"),
        ("mesh=1x4:0,0,1,1", "mesh"),
        ("mesh=17x4:0,0,1,1", "mesh"),
        ("mesh=99999999999999999999x4:0,0,1,1", "mesh"),
        ("mesh=4x4:0,0,0,1", "mesh"),
        ("mesh=4x4:0,0,NaN,1", "mesh"),
        ("mesh=4x4:0,0,1,1&keys=0:17,0,0", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0:0,1,1", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0:1,1", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0:1,1,inf", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0.5:;0.5:", "keys"),
        ("mesh=4x4:0,0,1,1&keys=2:", "keys"),
        ("mesh=4x4:0,0,1,1&bend=3,2,0.5", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,1e9,0.5", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,2,-1", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,2,NaN", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,2,0.5,0.5", "bend"),
        ("mesh=4x4:0,0,1,1&loop=0", "loop"),
        ("mesh=4x4:0,0,1,1&spin=fast", "spin"),
        ("mesh=4x4:0,0,1,1&join=glue", "join"),
        ("mesh=4x4:0,0,1,1&picture=4", "picture"),
        ("mesh=4x4:0,0,1,1&tint=0,9,1:all:ff0000", "tint"),
        ("mesh=2x2:0,0,1,1&tint=0,9,1:all:ff0000,00ff00,0000ff,gggggg", "tint"),
        ("mesh=2x2:0,0,1,1&tint=0,9,1:some:ff0000,00ff00,0000ff,000000", "tint"),
    ] {
        assert_eq!(key_of(words), key, "{words}");
    }
    let many: Vec<String> = (0..40).map(|i| format!("{}:", f64::from(i) / 40.0)).collect();
    assert_eq!(key_of(&format!("mesh=4x4:0,0,1,1&keys={}", many.join(";"))), "keys");
}

#[test]
fn fits_that_cannot_be_are_said_to_be_damaged() {
    let curve = "curve-a=curve:AAAA&curve-b=curve:AAAA";
    let graphs = [
        "graph=fif:",
        "graph=fif:1,0,0,0,0,0,1",
        "graph=fif:0.5,0,2,0,0,0,1",
        "graph=tree:0.5,0,0.5,0,0,0,1",
    ];
    let fits = [
        "fit=outline",
        "fit=outline:closed",
        "fit=outline:closed,11,0",
        "fit=outline:closed,260.5,0",
        "fit=outline:closed,260,NaN",
        "fit=leaf:closed,260,0",
        "bytes=31",
        "spline=A",
        "spline=AA+A",
        "curve-a=curve-a&curve-b=maple",
        "curve-a=maple&curve-b=fitted",
    ];
    let planes = ["plane=", "plane=0,0,0;1,1,x", "plane=0,0,0%3B1"];
    for words in [curve].iter().chain(&graphs).chain(&fits).chain(&planes) {
        let (scene, problem) = decode(&format!("v=1&{words}"));
        assert!(problem.is_some(), "{words}");
        assert_eq!(scene, Scene::default());
    }
}

#[test]
fn a_fit_of_260_numbers_takes_less_than_4_kilobytes() {
    let knots: Vec<_> = (0..90)
        .map(|i| glam::DVec2::from_angle(f64::from(i) * 0.0698) * (1.0 + 0.001 * f64::from(i * i % 11)))
        .collect();
    let edge =
        |i: usize| frond_fit::ArcCopy { from: (i * 7) % 90, span: 3 + i % 6, reversed: i % 2 == 1, c: 0.01 };
    let edges: Vec<_> = (0..90).map(|i| (i % 9 < 4).then(|| edge(i))).collect();
    let curve = frond_fit::ClosedCurve { knots, edges };
    let shape = CurveShape { preset: None, name: "A leaf".to_owned(), curve: Curve::from(&curve) };
    assert_eq!(curve.numbers(), 260);
    let mut link = String::new();
    write_curves(&mut link, &Curves { a: shape.clone(), b: shape }, None).unwrap();
    assert!(link.len() > 500 && link.len() < 4096, "{}", link.len());
}

#[test]
fn a_curve_that_is_fitted_and_stands_at_both_ends_is_written_once() {
    let (gallery, _) = decode("v=1&curve-a=maple&curve-b=oak");
    let leaf = gallery.curves.unwrap().a.curve;
    let moved = Curve { knots: leaf.knots.iter().map(|&[x, y]| [3.0 * x + 7.0, 3.0 * y]).collect(), ..leaf };
    let of =
        |name: &str, curve: &Curve| CurveShape { preset: None, name: name.to_owned(), curve: curve.clone() };
    let fitted = of("Leaf", &Curve::from(&frond_fit::ClosedCurve::from(&moved).quantised().unwrap()));
    let taken = of("Leaf", &fitted.curve.taken().unwrap());
    let fit = Fit { curve: Some(fitted), ..Fit::default() };
    let alone = super::encode(&Scene { fit: Some(fit.clone()), ..Scene::default() }).unwrap();
    let curves = Curves { a: taken.clone(), b: CurveShape { name: "Other".to_owned(), ..taken } };
    let mut scene = Scene { fit: Some(fit), curves: Some(curves), ..Scene::default() };
    let link = super::encode(&scene).unwrap();
    assert_eq!(link.len() - alone.len(), "&curve-a=fitted&curve-b=fitted&curve-b-name=Other".len(), "{link}");
    assert_eq!(decode(&link), (scene.clone(), None));
    // Without the fit it stands there once.
    scene.fit = None;
    let link = super::encode(&scene).unwrap();
    assert!(link.ends_with("&curve-b=curve-a&curve-b-name=Other"), "{link}");
    assert_eq!(decode(&link), (scene, None));
}

#[test]
fn a_spline_is_its_bytes_in_letters() {
    let node = |x: f64, y: f64, on: bool| Node { at: glam::DVec2::new(x, y), on };
    let nodes =
        vec![node(0.0, 0.0, true), node(40.0, 2.0, false), node(30.0, 50.0, true), node(-20.0, 30.0, false)];
    let spline = Spline { nodes, grid: 0.125 };
    let shape = SplineShape { name: "Leaf".to_owned(), word: spline.to_text().unwrap() };
    let fit = Fit { model: FitModel::Spline, bytes: 50, spline: Some(shape.clone()), ..Fit::default() };
    let mut scene = Scene { fit: Some(fit), ..Scene::default() };
    let link = super::encode(&scene).unwrap();
    let words = format!("&fit=outline:spline,260,0&bytes=50&spline={}&spline-name=Leaf", shape.word);
    assert!(link.ends_with(&words), "{link}");
    assert_eq!(decode(&link), (scene.clone(), None));
    assert!(shape.word.len() < 32, "{}", shape.word);
    scene.fit.as_mut().unwrap().spline.as_mut().unwrap().word.push('&');
    assert_eq!(super::encode(&scene).map_err(|error| error.code()), Err("link-unfit"));
}

#[test]
fn what_would_not_open_again_is_told_and_not_left_out() {
    let (with_curves, _) = decode("v=1&curve-a=maple&curve-b=oak&fitted=snowflake");
    let code = |change: &dyn Fn(&mut Scene)| {
        let mut scene = with_curves.clone();
        change(&mut scene);
        super::encode(&scene).map_err(|error| (error.code(), error.to_string())).unwrap_err()
    };
    fn far(curve: &mut CurveShape) {
        curve.curve.knots[0] = [1e150, 0.0];
    }
    let (size, words) = code(&|scene| far(&mut scene.curves.as_mut().unwrap().b));
    assert!(size == "size" && words.starts_with("The second curve cannot be kept in a link."), "{words}");
    let (_, words) = code(&|scene| far(scene.fit.as_mut().unwrap().curve.as_mut().unwrap()));
    assert!(words.starts_with("The fitted curve"), "{words}");
    assert_eq!(code(&|scene| scene.curves.as_mut().unwrap().a.curve.edges.clear()).0, "unsound");
    let (unfit, words) = code(&|scene| scene.t = f64::NAN);
    assert!(unfit == "link-unfit" && words.contains("“t”"), "{words}");
    let part = SpacePart { packed: "o:sponge&b=koch".to_owned(), ..SpacePart::default() };
    assert_eq!(code(&|scene| scene.space = Some(part.clone())).0, "link-unfit");
    assert_eq!(code(&|scene| scene.a.maps = vec![[2.0, 0.0, 0.0, 2.0, 0.0, 0.0]]).0, "link-shape");
    let moves = |k: usize| vec![-0.123_456_789_012_345_67 * k as f64; 512];
    let keys = (0..32).map(|k| Key { at: k as f64 / 32.0, moves: moves(k + 1) }).collect();
    let large = Deformation { columns: 16, rows: 16, keys, ..Deformation::at_rest([0.0, 0.0, 1.0, 1.0]) };
    let (long, words) = code(&|scene| scene.deform = Some(large.clone()));
    assert!(long == "link-too-long" && words.contains("65536"), "{words}");
}

#[test]
fn a_link_that_would_grow_too_long_to_be_written_is_refused() {
    let moves = (1..=256).map(|point| format!("{point},9e9,9e9")).collect::<Vec<_>>().join(",");
    let keys: Vec<String> = (0..15).map(|k| format!("{k}e-2:{moves}")).collect();
    let link = format!("mesh=16x16:0,0,1,1&keys={}", keys.join(";"));
    assert!(link.len() < MAX_LINK, "{}", link.len());
    let (scene, problem) = decode(&link);
    assert_eq!((scene, problem.map(|problem| problem.code())), (Scene::default(), Some("link-too-long")));
}

#[test]
fn what_stands_for_nothing_opens_as_nothing() {
    for link in ["locus=morph:", "locus=morph", "locus=morph:0.5,0.5,1", "turns=0,0,0"] {
        assert_eq!(decode(link), (Scene::default(), None), "{link}");
    }
}

#[test]
fn curves_of_the_gallery_are_written_by_their_names() {
    let (scene, problem) = decode("v=1&curve-a=maple&curve-b=snowflake");
    assert_eq!(problem, None);
    let curves = scene.curves.clone().unwrap();
    assert_eq!((curves.a.preset.as_deref(), curves.b.preset.as_deref()), (Some("maple"), Some("snowflake")));
    assert!(encode(&scene).ends_with("&curve-a=maple&curve-b=snowflake"));
    // One that was changed is no longer that of the gallery.
    let mut changed = scene;
    if let Some(curves) = &mut changed.curves {
        curves.b.curve.knots[0][0] += 0.5;
    }
    assert!(encode(&changed).contains("&curve-b=curve:"));
    assert!(decode("v=1&curve-a=willow&curve-b=maple").1.is_some());
    for (link, words) in [
        ("v=1&curve-a=maple", "“curve-b” cannot be left out beside “curve-a”"),
        ("v=1&curve-b=maple", "“curve-a” cannot be left out beside “curve-b”"),
    ] {
        let (scene, problem) = decode(link);
        let problem = problem.unwrap();
        assert!(scene.curves.is_none() && problem.code() == "link-damaged");
        assert!(problem.to_string().contains(words), "{problem}");
    }
}

#[test]
fn graph_directed_shapes_read_like_words() {
    let (scene, problem) = decode(
        "v=1&directed-a=snowflake&directed-b=states:2,0.5,0,0,0.5,0,0;1,0.5,0,0,0.5,0.5,0:1,0.3,0,0,0.3,0,0.1",
    );
    assert_eq!(problem, None);
    let directed = scene.directed.clone().unwrap();
    assert_eq!(directed.a, DirectedShape::of_preset("snowflake").unwrap());
    assert_eq!((directed.b.name.as_str(), directed.b.states[0][0].from), ("Own shape", 1));
    assert!(encode(&scene).contains("&directed-a=snowflake&directed-b=states:2,0.5,0,0,0.5,0,0;1,"));
    // One that was changed is no longer that of the gallery.
    let mut changed = scene;
    if let Some(directed) = &mut changed.directed {
        directed.a.states[0][0].map[4] += 0.5;
    }
    assert!(encode(&changed).contains("&directed-a=states:2,"));
}

#[test]
fn outlines_among_graph_directed_shapes_are_packed() {
    let curve = frond_fit::curve_presets().remove(0).curve;
    let leaf = DirectedShape::of_outline("Leaf", &curve).unwrap();
    assert_eq!(leaf.system().unwrap().len(), leaf.states.len());
    let fern = DirectedShape::of_preset("frond").unwrap();
    let mut scene = Scene { directed: Some(Directed { a: fern, b: leaf.clone() }), ..Scene::default() };
    let link = encode(&scene);
    assert!(link.contains("&directed-a=frond&directed-b=curve:") && link.len() < 2000, "{link}");
    let (again, problem) = decode(&link);
    assert_eq!((again.directed, problem), (scene.directed.clone(), None));
    // What is edited is no longer that curve.
    if let Some(directed) = &mut scene.directed {
        directed.b.states[0][0].map[4] += 0.5;
    }
    let edited = encode(&scene);
    assert!(edited.contains("&directed-b=states:"), "{}", edited.len());
    let (_, damaged) = decode("v=1&directed-a=frond&directed-b=curve:zzzz");
    assert_eq!(damaged.map(|problem| problem.code()), Some("link-damaged"));
}

#[test]
fn graph_directed_shapes_that_cannot_be_are_told_of() {
    let half = "0.5,0,0,0.5,0,0";
    let many = |one: &str, by: &str| vec![one; 65].join(by);
    let one = format!("1,{half}");
    for (a, code, words) in [
        ("willow".to_owned(), "link-damaged", "“directed-a” cannot be “willow”"),
        ("states:".to_owned(), "link-shape", "State 1 has no maps"),
        (format!("states:{one}:"), "link-shape", "State 2 has no maps"),
        (format!("states:2,{half}"), "link-shape", "copies state 2, and there is one"),
        (format!("states:0,{half}"), "link-damaged", "“directed-a” cannot be “0,0.5"),
        (format!("states:1.5,{half}"), "link-damaged", "“directed-a” cannot be “1.5,0.5"),
        (format!("states:1e300,{half}"), "link-damaged", "cannot be “1e300,0.5"),
        (format!("states:NaN,{half}"), "link-damaged", "cannot be “NaN,0.5"),
        (
            "states:2,1,0,0,1,0,0:1,1,0,0,1,0,0".to_owned(),
            "link-shape",
            "scales by 1.0000, and has to shrink",
        ),
        (format!("states:{}", many(&one, ";")), "link-damaged", "a list of more than 64"),
        (format!("states:{}", many(&one, ":")), "link-shape", "There are 65 states, and the most is 64"),
    ] {
        let (scene, problem) = decode(&format!("v=1&directed-a={a}&directed-b=quilt"));
        let problem = problem.unwrap();
        assert_eq!((scene, problem.code()), (Scene::default(), code), "{a}");
        assert!(problem.to_string().contains(words), "{a}: {problem}");
    }
    for (link, words) in [
        ("v=1&directed-a=quilt", "“directed-b” cannot be left out beside “directed-a”"),
        ("v=1&directed-b=quilt", "“directed-a” cannot be left out beside “directed-b”"),
        (
            "v=1&curve-a=maple&curve-b=oak&directed-a=quilt&directed-b=quilt",
            "“directed-a” cannot be kept beside “curve-a”",
        ),
    ] {
        let (scene, problem) = decode(link);
        assert_eq!(scene, Scene::default());
        assert!(problem.as_ref().unwrap().to_string().contains(words), "{problem:?}");
    }
}

#[test]
fn the_largest_graph_is_told_to_be_too_long_for_a_link() {
    let copy = DirectedCopy { from: 63, map: [-0.123_456_789_012_345_67e-7; 6] };
    let large =
        DirectedShape { preset: None, name: String::new(), states: vec![vec![copy; 64]; 64], outline: None };
    assert!(large.system().is_ok());
    let small = DirectedShape::of_preset("quilt").unwrap();
    let scene = Scene { directed: Some(Directed { a: large, b: small }), ..Scene::default() };
    assert_eq!(super::encode(&scene).unwrap_err().code(), "link-too-long");
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
