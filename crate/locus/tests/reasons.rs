//! Which shapes are proved to be in one piece, by which reason, and which would be if their numbers meant what they
//! come near.

use frond_core::{Affine2, Ifs};
use frond_locus::{Connectedness, LinkKind, Options, Reason, Verdict, connectedness};
use glam::DVec2;

fn system(rows: &[[f64; 6]]) -> Vec<Affine2> {
    rows.iter().copied().map(Affine2::from_row).collect()
}

fn answer(maps: &[Affine2]) -> Connectedness {
    connectedness(&Ifs::new(maps.to_vec()).unwrap(), &Options { epsilon: 1e-6, ..Options::default() })
}

/// The point of an address as it is shown, by another way than the one that found it: letters from the end, many
/// times over.
fn point(maps: &[Affine2], address: &str) -> DVec2 {
    let (head, repeat) = address.strip_suffix(')').unwrap().split_once('(').unwrap();
    let letters = |part: &str| -> Vec<usize> {
        let split: Vec<&str> = if maps.len() > 9 {
            part.split('.').filter(|letter| !letter.is_empty()).collect()
        } else {
            part.split("").filter(|letter| !letter.is_empty()).collect()
        };
        split.into_iter().map(|letter| letter.parse::<usize>().unwrap() - 1).collect()
    };
    let (head, repeat) = (letters(head), letters(repeat));
    // Innermost first: the repeats read backwards, then the head.
    let mut x = DVec2::ZERO;
    for _ in 0..2000 {
        x = repeat.iter().rev().fold(x, |x, &i| maps[i].apply(x));
    }
    head.iter().rev().fold(x, |x, &i| maps[i].apply(x))
}

/// That the links reach every piece and the addresses are those of one point.
fn check(name: &str, maps: &[Affine2], found: &Connectedness, reason: &Reason) {
    let mut reached = vec![0];
    for _ in maps {
        for link in &reason.links {
            let (i, j) = link.pair;
            assert!(i < j && j < maps.len(), "{name}");
            match (reached.contains(&i), reached.contains(&j)) {
                (true, false) => reached.push(j),
                (false, true) => reached.push(i),
                _ => {}
            }
        }
    }
    assert!(reason.links.is_empty() || reached.len() == maps.len(), "{name}: {reason:?}");
    for link in &reason.links {
        let [a, b] = &link.words;
        if link.kind == LinkKind::Point {
            let (p, q) = (point(maps, a), point(maps, b));
            let near = 1e-9 * found.diameter.max(1e-9);
            assert!(p.distance(q) <= near && p.distance(link.at) <= near, "{name}: {a} {b} {p} {q}");
        } else {
            let has_corners = matches!(link.kind, LinkKind::Crossing | LinkKind::Line);
            let corners = if has_corners { 4 } else { 0 };
            assert_eq!(link.corners.len(), corners, "{name}");
        }
        for (word, i) in [(a, link.pair.0), (b, link.pair.1)] {
            assert!(word.trim_start_matches('(').starts_with(&(i + 1).to_string()), "{name}: {word} for {i}");
        }
    }
}

fn summary(name: &str, maps: &[Affine2]) -> String {
    let found = answer(maps);
    let mut text = format!("{name}: {}", found.verdict.name());
    if let Some(reason) = &found.reason {
        check(name, maps, &found, reason);
        text += &format!(" {}", reason.kind.name());
        if let Some(types) = reason.neighbours {
            text += &format!(" {types}");
        }
        if !reason.is_proof() {
            let said = reason.assuming.iter().map(|one| one.split_once(" is ").unwrap().1);
            text += &format!(" if {}", said.collect::<Vec<_>>().join(", "));
        }
        assert_eq!(reason.is_proof(), found.verdict == Verdict::Connected, "{name}");
    }
    println!("{text}");
    text
}

#[test]
fn the_gallery_has_these_reasons() {
    let found: Vec<String> =
        frond_scene::presets().iter().map(|preset| summary(preset.id, &system(&preset.maps))).collect();
    let wanted = [
        "gasket: connected shared-points 6",
        "dragon: connected area",
        "dragon-3: connected neighbours 26",
        "terdragon: connected shared-points",
        "terdragon-mirrored: connected shared-points",
        "twindragon: connected area",
        "levy: connected area",
        "koch: touching shared-points 4 if 1/3, 1/6, sqrt(3)/6, 2/3",
        "carpet: touching neighbours 8 if 1/3, 2/3",
        "vicsek: touching shared-points 4 if 1/3, 2/3",
        "pentagon: touching shared-points 10 if (3 - sqrt(5))/2, (-1 + sqrt(5))/2, (-1 + sqrt(5))/2 sin(72°), (3 - sqrt(5))/4, (3 - sqrt(5))/2 sin(72°)",
        "hexagon: touching shared-points 6 if 1/3, 2/3, sqrt(3)/3",
        "hexaflake: touching shared-points 6 if 1/3, 2/3, sqrt(3)/3",
        "gosper: touching neighbours 6 if 5/14, sqrt(3)/14, 2/7, sqrt(3)/7, 1/14, 3 sqrt(3)/14",
        "fern: touching",
        "maple: connected crossings",
        "tree: connected crossings",
        "spiral: connected crossings",
        "dust: disconnected",
        "twigs: connected crossings",
    ];
    for (found, wanted) in found.iter().zip(wanted) {
        assert_eq!(found, wanted, "what is known of a shape; a new one needs its line in this list");
    }
    assert_eq!(found.len(), wanted.len(), "each shape of the gallery needs its line in this list");
}

#[test]
fn tiles_and_curves_have_theirs() {
    let half = 0.5;
    let board = |n: usize, keep: &dyn Fn(usize, usize) -> bool| -> Vec<Affine2> {
        let s = 1.0 / n as f64;
        let cells = (0..n * n).map(|k| (k % n, k / n)).filter(|&(x, y)| keep(x, y));
        cells.map(|(x, y)| Affine2::similitude(s, 0.0, DVec2::new(x as f64 * s, y as f64 * s))).collect()
    };
    let minus = Affine2::similitude(half, std::f64::consts::PI, DVec2::new(0.75, 0.75));
    let triangle =
        [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::similitude(half, 0.0, DVec2::new(e, f)));
    // Rounded wherever it could be: but the numbers still come near to some that were typed.
    let by = Affine2::from_row([1.1, 0.3, -0.2, 0.7, 3.3, -4.1]);
    let cases: Vec<(&str, Vec<Affine2>, &str)> = vec![
        ("square of four", board(2, &|_, _| true), "connected neighbours 8"),
        ("square of sixteen", board(4, &|_, _| true), "connected neighbours 8"),
        ("square of sixty-four", board(8, &|_, _| true), "connected neighbours 8"),
        ("square of nine", board(3, &|_, _| true), "touching neighbours 8 if 1/3, 2/3"),
        ("square of twenty-five", board(5, &|_, _| true), "touching neighbours 8 if 1/5, 2/5, 3/5, 4/5"),
        ("diagonals", board(4, &|x, y| x == y || x + y == 3), "connected neighbours 8"),
        (
            "levy of three",
            {
                let levy = system(&[[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [0.5, 0.5, -0.5, 0.5, 0.5, 0.5]]);
                vec![levy[0], levy[1] * levy[0], levy[1] * levy[1]]
            },
            "connected neighbours 97",
        ),
        (
            "triangle with a turned middle",
            [triangle.as_slice(), &[minus]].concat(),
            "touching neighbours 21 if 0",
        ),
        ("gasket elsewhere", triangle.iter().map(|map| map.conjugate(by).unwrap()).collect(), "touching"),
        (
            "octagon",
            {
                let r = 1.0 / (2.0 + 2.0_f64.sqrt());
                let corner = |k| DVec2::from_angle(std::f64::consts::FRAC_PI_4 * f64::from(k));
                (0..8).map(|k| Affine2::similitude(r, 0.0, corner(k) * (1.0 - r))).collect()
            },
            "touching neighbours 8 if (2 - sqrt(2))/2, sqrt(2)/2",
        ),
    ];
    for (name, maps, wanted) in cases {
        let found = summary(name, &maps);
        assert!(found.starts_with(&format!("{name}: {wanted}")), "{found}, not {wanted}");
    }
}

/// One digit decides: what is proved of a number is not proved of its neighbour.
#[test]
fn proofs_hang_on_the_last_digit() {
    let gasket = |scale: f64| {
        [[0.0, 0.0], [1.0, 0.0], [0.3, 0.8]]
            .map(|c| Affine2::similitude(scale, 0.0, DVec2::from_array(c) * (1.0 - scale)))
            .to_vec()
    };
    let exact = answer(&gasket(0.5));
    assert_eq!(exact.verdict, Verdict::Connected);
    let less = answer(&gasket(0.5 - f64::EPSILON / 4.0));
    assert_ne!(less.verdict, Verdict::Connected, "{less:?}");
    // As given, thirds do not meet, and it is not said that they do; as meant, they do.
    let third = 1.0 / 3.0;
    let line = |a: f64| [0.0, third, a].map(|e| Affine2::similitude(third, 0.0, DVec2::new(e, 0.0))).to_vec();
    let thirds = answer(&line(2.0 / 3.0));
    assert_eq!(thirds.verdict, Verdict::Touching);
    let reason = thirds.reason.unwrap();
    assert_eq!(reason.assuming, ["0.3333333333333333 is 1/3", "0.6666666666666666 is 2/3"]);
    assert!(reason.text().starts_with("If "), "{}", reason.text());
    // A few digits off, it is still named.
    assert!(answer(&line(0.666_666_666_666_667)).reason.is_some());
    assert!(answer(&line(0.666_666_666_7)).reason.is_none());
}

#[test]
fn one_map_equal_maps_and_common_points() {
    let kind = |maps: &[Affine2]| {
        let found = answer(maps);
        (found.verdict, found.reason.map(|reason| reason.kind.name()))
    };
    let map = Affine2::from_row([0.3, 0.1, -0.2, 0.4, 5.0, 6.0]);
    assert_eq!(kind(&[map]), (Verdict::Connected, Some("one-map")));
    assert_eq!(kind(&[map; 5]), (Verdict::Connected, Some("equal-maps")));
    let about = |scale: f64, c: DVec2| Affine2::similitude(scale, 0.0, c * (1.0 - scale));
    let c = DVec2::new(3.0, 4.0);
    assert_eq!(kind(&[about(0.5, c), about(0.25, c)]), (Verdict::Connected, Some("common-point")));
    // Fifths come near only.
    assert_eq!(kind(&[about(0.2, c), about(0.4, c)]), (Verdict::Touching, Some("common-point")));
    assert_eq!(kind(&[about(0.2, c), about(0.4, -c)]).0, Verdict::Disconnected);
}

#[test]
fn copies_of_one_shape_and_direction_meet_by_their_differences() {
    let four = |factor: f64| {
        let at = [[0.0, 0.0], [0.61, 0.04], [0.03, 0.57], [0.52, 0.63]];
        at.map(|at| Affine2::similitude(factor, 0.3, DVec2::from_array(at))).to_vec()
    };
    let found = answer(&four(0.5));
    assert_eq!(found.verdict, Verdict::Connected);
    let reason = found.reason.as_ref().unwrap();
    assert_eq!((reason.kind.name(), reason.links.len()), ("differences", 3));
    check("four halves", &four(0.5), &found, reason);
    assert!(reason.links.iter().all(|link| link.kind == LinkKind::Difference));
    // As small as this there is room between them.
    assert_eq!(answer(&four(0.4)).verdict, Verdict::Disconnected);
}
