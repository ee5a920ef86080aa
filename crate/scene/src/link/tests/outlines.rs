//! Tests of closed curves and fits in links.

use super::*;

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
        "curve-a=spline&curve-b=maple",
        "curve-a=spline:A&curve-b=maple",
        "curve-a=spline:AA+A&curve-b=maple",
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
    let shape = CurveShape { name: "A leaf".to_owned(), curve: Curve::from(&curve), ..CurveShape::default() };
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
    let of = |name: &str, curve: &Curve| CurveShape {
        name: name.to_owned(),
        curve: curve.clone(),
        ..CurveShape::default()
    };
    let fitted = of("Leaf", &Curve::from(&frond_fit::ClosedCurve::from(&moved).quantised().unwrap()));
    let taken = of("Leaf", &fitted.curve.taken().unwrap());
    let fit = Fit { curve: Some(fitted), ..Fit::default() };
    let alone = crate::link::encode(&Scene { fit: Some(fit.clone()), ..Scene::default() }).unwrap();
    let curves = Curves { a: taken.clone(), b: CurveShape { name: "Other".to_owned(), ..taken } };
    let mut scene = Scene { fit: Some(fit), curves: Some(curves), ..Scene::default() };
    let link = crate::link::encode(&scene).unwrap();
    assert_eq!(link.len() - alone.len(), "&curve-a=fitted&curve-b=fitted&curve-b-name=Other".len(), "{link}");
    assert_eq!(decode(&link), (scene.clone(), None));
    // Without the fit it stands there once.
    scene.fit = None;
    let link = crate::link::encode(&scene).unwrap();
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
    let link = crate::link::encode(&scene).unwrap();
    let words = format!("&fit=outline:spline,260,0&bytes=50&spline={}&spline-name=Leaf", shape.word);
    assert!(link.ends_with(&words), "{link}");
    assert_eq!(decode(&link), (scene.clone(), None));
    assert!(shape.word.len() < 32, "{}", shape.word);
    scene.fit.as_mut().unwrap().spline.as_mut().unwrap().word.push('&');
    assert_eq!(crate::link::encode(&scene).map_err(|error| error.code()), Err("link-unfit"));
}

#[test]
fn a_spline_that_is_bent_stands_in_a_link_as_its_word_and_once() {
    let (gallery, _) = decode("v=1&curve-a=maple&curve-b=oak");
    let oak = gallery.curves.unwrap().b;
    let word = "ArD2Sst0yl5_ukz6f1W7bH7QZZArw72oRfqqS7rYKZ7lvzYslYyPymBzZ2GeQou2DRUP5EGfUCWQ0cpg".to_owned();
    let leaf = CurveShape { name: "Leaf".to_owned(), spline: Some(word.clone()), ..CurveShape::default() };
    let mut scene = Scene { curves: Some(Curves { a: leaf.clone(), b: oak.clone() }), ..Scene::default() };
    let link = crate::link::encode(&scene).unwrap();
    assert!(link.ends_with(&format!("&curve-a=spline:{word}&curve-a-name=Leaf&curve-b=oak")), "{link}");
    assert_eq!(decode(&link), (scene.clone(), None));
    // Nor is it written twice where it is the fit's, too, or the other end.
    let spline = Some(SplineShape { name: "Leaf".to_owned(), word: word.clone() });
    scene.fit = Some(Fit { model: FitModel::Spline, spline, ..Fit::default() });
    let link = crate::link::encode(&scene).unwrap();
    assert!(link.contains("&curve-a=spline&curve-b=oak&") && link.matches(&word).count() == 1, "{link}");
    assert_eq!(decode(&link), (scene.clone(), None));
    scene.fit = None;
    scene.curves = Some(Curves { a: leaf.clone(), b: leaf.clone() });
    let link = crate::link::encode(&scene).unwrap();
    assert!(link.ends_with("&curve-a-name=Leaf&curve-b=curve-a"), "{link}");
    assert_eq!(decode(&link), (scene, None));
    // Two of them are two, though neither has knots.
    let other = CurveShape { spline: Some(word[..40].to_owned()), ..leaf.clone() };
    let both = Scene { curves: Some(Curves { a: leaf, b: other }), ..Scene::default() };
    let link = crate::link::encode(&both).unwrap();
    assert_eq!((link.matches("=spline:").count(), decode(&link)), (2, (both, None)), "{link}");
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
