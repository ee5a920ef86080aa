//! Tests of links that cannot be read or written.

use super::*;

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
        exact: Vec::new(),
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

#[test]
fn what_would_not_open_again_is_told_and_not_left_out() {
    let (with_curves, _) = decode("v=1&curve-a=maple&curve-b=oak&fitted=snowflake");
    let code = |change: &dyn Fn(&mut Scene)| {
        let mut scene = with_curves.clone();
        change(&mut scene);
        crate::link::encode(&scene).map_err(|error| (error.code(), error.to_string())).unwrap_err()
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
