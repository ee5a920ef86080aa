//! Tests of graph-directed shapes in links.

use super::*;

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

/// What the first links showed had every half turn counter-clockwise.
#[test]
fn links_of_graph_directed_shapes_say_which_way_half_turns_go() {
    let link = "v=1&a=gasket&b=gasket&directed-a=snowflake&directed-b=crystal";
    for (word, half_turns) in [
        ("", HalfTurns::CounterClockwise),
        ("&directed-half=signs", HalfTurns::Signs),
        ("&directed-half=clockwise", HalfTurns::Clockwise),
    ] {
        let link = format!("{link}{word}");
        let (scene, problem) = decode(&link);
        assert_eq!((scene.directed.as_ref().map(|now| now.half_turns), problem), (Some(half_turns), None));
        assert_eq!(encode(&scene), link);
    }
    let (_, damaged) = decode(&format!("{link}&directed-half=left"));
    assert_eq!(damaged.map(|problem| problem.code()), Some("link-damaged"));
}

#[test]
fn outlines_among_graph_directed_shapes_are_packed() {
    let curve = frond_fit::curve_presets().remove(0).curve;
    let leaf = DirectedShape::of_outline("Leaf", &curve).unwrap();
    assert_eq!(leaf.system().unwrap().len(), leaf.states.len());
    let fern = DirectedShape::of_preset("frond").unwrap();
    let mut scene = Scene {
        directed: Some(Directed { a: fern, b: leaf.clone(), half_turns: HalfTurns::Clockwise }),
        ..Scene::default()
    };
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
    let scene = Scene {
        directed: Some(Directed { a: large, b: small, half_turns: HalfTurns::Signs }),
        ..Scene::default()
    };
    assert_eq!(crate::link::encode(&scene).unwrap_err().code(), "link-too-long");
}
