//! Certificates about exact numbers: what is true of these is accepted, and nothing that is not.
#![cfg(feature = "text")]

use frond_check::{
    Certificate, CheckedProof, ConnectedCertificate, Exact, ExactEntry, Link, Pair, Proof, Refused, check,
};

/// Hand-made, and whether the shape is in one piece.
///
/// - `koch`: four pieces from 0 to 1, a third as long, each beginning where the one before it ends.
/// - `segment`: three thirds of a segment.
/// - `gasket`: three halves of an equilateral triangle, by the square root of 3.
/// - `pentagon`: five pieces toward the corners of a regular pentagon, of the ratio at which neighbours share one
///   point. With s = 2 sin 72°, s^4 - 5 s^2 + 5 = 0, the ratio is 4 - s^2, and the corners are (1, 0), (s^2 - 3, s) / 2
///   and so on.
/// - `areas`: boxes that are 5/6 by 2/5 and 5/6 by 4/5 of the whole, and so 1/3 and 2/3 of its area.
/// - `paper`: two halves of a sheet that is as wide as the square root of 2 is.
/// - `line`: two pieces of a segment, each 2/3 of it.
/// - `cantor`: Cantor's dust.
/// - `blocks`: two pieces, where only words of two letters contract the polygon.
const CASES: [(&str, &str, bool); 9] = [
    ("koch", include_str!("exact/koch.json"), true),
    ("segment", include_str!("exact/segment.json"), true),
    ("gasket", include_str!("exact/gasket.json"), true),
    ("pentagon", include_str!("exact/pentagon.json"), true),
    ("areas", include_str!("exact/areas.json"), true),
    ("paper", include_str!("exact/paper.json"), true),
    ("line", include_str!("exact/line.json"), true),
    ("cantor", include_str!("exact/cantor.json"), false),
    ("blocks", include_str!("exact/blocks.json"), false),
];

fn case(name: &str) -> Proof {
    let (_, text, _) = CASES.iter().find(|case| case.0 == name).unwrap();
    Proof::from_json(text).unwrap()
}

fn exact(proof: &mut Proof) -> &mut Exact {
    match proof {
        Proof::Disconnected(certificate) => certificate.exact.as_mut().unwrap(),
        Proof::Connected(certificate) => certificate.exact.as_mut().unwrap(),
        _ => unreachable!(),
    }
}

fn joined(proof: &mut Proof) -> &mut ConnectedCertificate {
    let Proof::Connected(certificate) = proof else { unreachable!() };
    certificate
}

fn apart(proof: &mut Proof) -> &mut Certificate {
    let Proof::Disconnected(certificate) = proof else { unreachable!() };
    certificate
}

/// Why a changed proof is refused.
#[track_caller]
fn refused(name: &str, change: impl FnOnce(&mut Proof)) -> Refused {
    let mut mutant = case(name);
    change(&mut mutant);
    assert_ne!(mutant, case(name), "nothing was changed");
    mutant.check().unwrap_err()
}

/// The exact value of an entry becomes another.
#[track_caller]
fn with_value(name: &str, [map, entry]: [u8; 2], value: &[&str]) -> Refused {
    refused(name, |proof| {
        let found = exact(proof).entries.iter_mut().find(|one| [one.map, one.entry] == [map, entry]).unwrap();
        found.value = value.iter().map(|&text| text.to_owned()).collect();
    })
}

#[test]
fn what_is_true_of_exact_numbers_is_accepted() {
    for (name, _, is_joined) in CASES {
        match case(name).check() {
            Ok(CheckedProof::Connected(found)) => assert!(is_joined && found.links > 0, "{name}"),
            Ok(CheckedProof::Disconnected(found)) => assert!(!is_joined && found.pairs > 0, "{name}"),
            Err(why) => panic!("{name}: {why}"),
        }
    }
}

#[test]
fn of_doubles_the_same_points_are_not_shared() {
    for name in ["koch", "segment", "pentagon"] {
        assert_eq!(refused(name, |proof| joined(proof).exact = None).code(), "link", "{name}");
    }
}

/// Without the member nothing is written of it.
#[test]
fn certificates_of_doubles_are_written_as_before() {
    let mut proof = case("cantor");
    apart(&mut proof).exact = None;
    let text = apart(&mut proof).to_json().unwrap();
    assert!(!text.contains("exact") && Proof::from_json(&text).unwrap() == proof, "{text}");
    assert!(proof.check().is_ok());
    let mut proof = case("segment");
    assert_eq!(Proof::from_json(&joined(&mut proof).to_json().unwrap()).unwrap(), proof);
    joined(&mut proof).exact = None;
    assert!(!joined(&mut proof).to_json().unwrap().contains("exact"));
}

#[test]
fn numbers_near_those_that_share_a_point_share_none() {
    // 1/3 less 3e-18.
    assert_eq!(with_value("koch", [0, 0], &["333333333333333330/1000000000000000000"]).code(), "link");
    assert_eq!(with_value("segment", [1, 4], &["33333333333333333/100000000000000000"]).code(), "link");
    assert_eq!(with_value("koch", [1, 2], &["0", "16666666666666666/100000000000000000"]).code(), "link");
    // A coefficient of another power that is almost nothing.
    assert_eq!(with_value("koch", [1, 4], &["1/3", "1/100000000000000000"]).code(), "link");
    assert_eq!(with_value("gasket", [2, 0], &["1/2", "1/1000000000000000000"]).code(), "link");
    assert_eq!(with_value("pentagon", [1, 0], &["4", "0", "-1", "1/1000000000000000000"]).code(), "link");
    // The areas leave a little room, and then too little is one digit less.
    assert_eq!(with_value("areas", [0, 0], &["83333333333333333333/100000000000000000000"]).code(), "link");
    assert_eq!(
        with_value("paper", [1, 1], &["0", "-49999999999999999999/100000000000000000000"]).code(),
        "link"
    );
    // Those that are larger than they need be do not.
    let mut more = case("areas");
    exact(&mut more).entries[0].value = vec!["83333333333333333334/100000000000000000000".to_owned()];
    assert!(more.check().is_ok());
    // A map that leaves the line.
    assert!(
        refused("line", |proof| {
            let mut entry = exact(proof).entries[0].clone();
            (entry.entry, entry.value) = (2, vec!["1/100000".to_owned()]);
            exact(proof).entries.push(entry);
            joined(proof).maps[0][2] = 1e-5;
        })
        .code()
            == "link"
    );
}

/// The third point of a link lies between the others, or is one of them, but not beyond.
#[test]
fn a_point_between_others_is_told_from_one_beyond() {
    let with = |numerator: i64, under: &str| {
        let mut proof = case("line");
        // The second map begins at 1/3, where the first one ends, or a little before or beyond.
        let text = format!("{numerator}/{under}");
        for entry in [0, 3] {
            joined(&mut proof).maps[0][entry] = 1.0 / 3.0;
        }
        for one in exact(&mut proof).entries.iter_mut().filter(|one| one.map == 0) {
            one.value = vec![text.clone()];
        }
        proof.check().map_err(|why| why.code())
    };
    assert!(with(1, "3").is_ok());
    assert!(with(33_333_333_333_333_334, "100000000000000000").is_ok());
    assert_eq!(with(33_333_333_333_333_333, "100000000000000000"), Err("link"));
}

#[test]
fn exact_numbers_far_from_their_doubles_are_refused() {
    for (name, place, value) in [
        ("koch", [0, 0], &["1/4"][..]),
        // Two units off, to either side.
        ("koch", [0, 0], &["33333333333333343/100000000000000000"]),
        ("koch", [0, 0], &["33333333333333323/100000000000000000"]),
        ("koch", [1, 1], &["0", "1/6"]),
        ("koch", [1, 1], &["1/6", "0"]),
        ("koch", [1, 1], &[]),
        ("cantor", [1, 4], &["-2/3"]),
        ("pentagon", [0, 0], &["4", "0", "-1", "1/1000000000000000"]),
    ] {
        let why = with_value(name, place, value);
        assert_eq!(
            why,
            Refused::Entry { map: usize::from(place[0]), entry: usize::from(place[1]) },
            "{name} {value:?}"
        );
    }
    // A double of 0 stands for 0 alone.
    let add = |value: &str| {
        let mut proof = case("koch");
        let mut entry = exact(&mut proof).entries[0].clone();
        (entry.entry, entry.value) = (1, vec![value.to_owned()]);
        exact(&mut proof).entries.push(entry);
        proof.check().map(|_| ()).map_err(|why| why.code())
    };
    assert_eq!(add("0"), Ok(()));
    assert_eq!(add(&format!("1/1{}", "0".repeat(400))), Err("entry"));
}

/// Another root of the polynomial, none, or one of several.
#[test]
fn one_root_is_meant() {
    let ends = |low: &str, high: &str| {
        refused("koch", |proof| exact(proof).root = [low, high].map(str::to_owned)).code()
    };
    assert_eq!(ends("-9/5", "-17/10"), "entry");
    for [low, high] in [
        ["7/4", "9/5"],
        ["9/5", "17/10"],
        ["-2", "2"],
        ["1", "1"],
        ["0", "1"],
        ["2", "17/10"],
        ["-9/5", "9/5"],
    ] {
        assert_eq!(ends(low, high), "root", "{low} {high}");
    }
    let mut wide = case("koch");
    exact(&mut wide).root = ["1/100", "1000000"].map(str::to_owned);
    assert!(wide.check().is_ok());
    // x^3 - x = 0 at -1, 0 and 1, where the ends of the interval have different signs; and three times at 1.
    for (polynomial, low, high) in [
        (&["0", "-1", "0", "1"][..], "-2", "2"),
        (&["-1", "3", "-3", "1"], "0", "3"),
        (&["1", "0", "1"], "-1", "1"),
        (&["3", "0", "-1"], "9/5", "17/10"),
        (&["-3", "0", "2"], "17/10", "9/5"),
        (&["-3", "1", "1"], "17/10", "9/5"),
        (
            &["-3", "0", "1"],
            "-1732050807568877293/1000000000000000000",
            "1732050807568877294/1000000000000000000",
        ),
    ] {
        let why = refused("koch", |proof| {
            exact(proof).polynomial = polynomial.iter().map(|&text| text.to_owned()).collect();
            exact(proof).root = [low, high].map(str::to_owned);
        });
        assert_eq!(why.code(), "root", "{polynomial:?}");
    }
}

/// The same root by other polynomials: a multiple, one with factors, one in other signs.
#[test]
fn other_polynomials_of_the_root_do_as_well() {
    for (polynomial, low, high) in [
        (&["-21", "0", "7"][..], "17/10", "9/5"),
        (&["3", "0", "-1"], "17/10", "9/5"),
        // (x^2 - 3) (x - 5), (x^2 - 3) (3 x - 1) and (x^2 - 3) (1 - 3 x).
        (&["15", "-3", "-5", "1"], "17/10", "9/5"),
        (&["3", "-9", "-1", "3"], "17/10", "9/5"),
        (&["-3", "9", "1", "-3"], "17/10", "9/5"),
    ] {
        let mut proof = case("koch");
        exact(&mut proof).polynomial = polynomial.iter().map(|&text| text.to_owned()).collect();
        exact(&mut proof).root = [low, high].map(str::to_owned);
        assert!(proof.check().is_ok(), "{polynomial:?}: {:?}", proof.check());
    }
    // By half of it, and by a polynomial that begins with 4.
    let mut proof = case("koch");
    exact(&mut proof).polynomial = ["-3", "0", "4"].map(str::to_owned).to_vec();
    exact(&mut proof).root = ["17/20", "9/10"].map(str::to_owned);
    for entry in &mut exact(&mut proof).entries {
        if let [_, second] = &mut *entry.value {
            *second = second.replace('6', "3");
        }
    }
    assert!(proof.check().is_ok(), "{:?}", proof.check());
}

/// All numbers are brought over one denominator, which is as long as all of them together.
#[test]
fn numbers_that_would_fill_the_memory_are_refused() {
    let double = Certificate {
        maps: vec![[0.25; 6]; 256],
        polygon: vec![[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]],
        letters: 1,
        side: (0..256).map(|k| u8::from(k > 0)).collect(),
        pairs: vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }],
        exact: None,
    };
    let value = |k: usize| (0..16).map(|power| format!("1/{}", 1_000_003 + 2 * (16 * k + power))).collect();
    let entry = |k: usize| ExactEntry { map: (k / 6) as u8, entry: (k % 6) as u8, value: value(k) };
    let polynomial = (0..17).map(|k| {
        if k == 16 {
            "1"
        } else if k == 0 {
            "-2"
        } else {
            "0"
        }
        .to_owned()
    });
    let exact = Exact {
        polynomial: polynomial.collect(),
        root: ["104/100", "105/100"].map(str::to_owned),
        entries: (0..1200).map(entry).collect(),
    };
    let why = check(&Certificate { exact: Some(exact), ..double }).unwrap_err();
    assert!(matches!(why, Refused::TooLarge { what, .. } if what.contains("denominator")), "{why}");
}

#[test]
fn what_is_of_no_form_is_refused() {
    for text in ["", "1/0", "1.5", "1e1", "1/3 ", "+1", "1/-3", "x"] {
        assert_eq!(with_value("koch", [0, 0], &[text]).code(), "form", "{text}");
        assert_eq!(refused("koch", |proof| exact(proof).root[0] = text.to_owned()).code(), "form", "{text}");
    }
    assert_eq!(refused("koch", |proof| exact(proof).polynomial[0] = "-3/1".to_owned()).code(), "form");
    assert_eq!(refused("koch", |proof| exact(proof).polynomial[2] = "0".to_owned()).code(), "form");
    assert_eq!(refused("koch", |proof| exact(proof).polynomial.truncate(1)).code(), "form");
    assert_eq!(refused("koch", |proof| exact(proof).polynomial.clear()).code(), "form");
    assert_eq!(refused("koch", |proof| exact(proof).entries[0].map = 4).code(), "form");
    assert_eq!(refused("koch", |proof| exact(proof).entries[0].entry = 6).code(), "form");
    assert_eq!(refused("koch", |proof| exact(proof).entries[1].entry = 0).code(), "form");
    assert_eq!(with_value("koch", [0, 0], &["1/3", "0", "0"]).code(), "form");
    assert_eq!(
        refused("koch", |proof| {
            exact(proof).polynomial = vec!["1".to_owned(); 18];
        })
        .code(),
        "too-large"
    );
    assert_eq!(with_value("koch", [0, 0], &[&format!("0.{}", "3".repeat(1000))]).code(), "too-large");
    let many = refused("koch", |proof| {
        for entry in &mut exact(proof).entries {
            entry.value = vec!["0".repeat(1000); 2];
        }
        joined(proof).maps = vec![[0.0; 6]; 256];
        let one = exact(proof).entries[0].clone();
        exact(proof).entries = (0..=255).map(|map| ExactEntry { map, ..one.clone() }).collect();
    });
    assert_eq!(many.code(), "too-large");
}

/// One thing changed in each of the proofs: the point is another, or the pieces do not hang together.
#[test]
fn links_that_do_not_hold_are_refused() {
    for name in ["koch", "segment", "gasket", "pentagon"] {
        let count = joined(&mut case(name)).links.len();
        for (link, end, which) in (0..count).flat_map(|k| (0..4).map(move |n| (k, n / 2, n % 2))) {
            let maps = joined(&mut case(name)).maps.len() as u8;
            for letter in 0..maps {
                let mut mutant = case(name);
                let Link::Point { addresses } = &mut joined(&mut mutant).links[link] else { unreachable!() };
                let word = if which == 0 { &mut addresses[end].head } else { &mut addresses[end].repeat };
                if word[0] == letter {
                    continue;
                }
                word[0] = letter;
                assert_eq!(
                    mutant.check().unwrap_err().code(),
                    "link",
                    "{name} {link} {end} {which} {letter}"
                );
            }
        }
        assert_eq!(refused(name, |proof| drop(joined(proof).links.pop())).code(), "unreached");
    }
    assert_eq!(
        refused("line", |proof| {
            let Link::Between { addresses } = &mut joined(proof).links[0] else { unreachable!() };
            // 1/3 is not between 0 and 16/81.
            addresses[1].head = vec![0, 0, 0, 0];
        })
        .code(),
        "link"
    );
}

/// An exact number is said to be another entry, whose double is another one.
#[test]
fn entries_at_other_places_are_refused() {
    for (name, ..) in CASES {
        let mut proof = case(name);
        let maps = match &proof {
            Proof::Connected(certificate) => certificate.maps.clone(),
            Proof::Disconnected(certificate) => certificate.maps.clone(),
            _ => unreachable!(),
        };
        let double = |[map, entry]: [u8; 2]| maps[usize::from(map)][usize::from(entry)];
        let entries = exact(&mut proof).entries.clone();
        for (k, [map, entry]) in (0..entries.len()).flat_map(|k| (0..12).map(move |n| (k, [n / 6, n % 6]))) {
            if double([map, entry]) == double([entries[k].map, entries[k].entry]) {
                continue;
            }
            let mut mutant = case(name);
            let one = &mut exact(&mut mutant).entries[k];
            (one.map, one.entry) = (map, entry);
            // It may be there twice now.
            let code = mutant.check().unwrap_err().code();
            assert!(["entry", "form"].contains(&code), "{name} {k} {map} {entry}: {code}");
        }
    }
}

/// Doubles show that these two pieces are apart. Their exact numbers, a unit in the last place larger, touch.
#[test]
fn what_is_apart_by_less_than_a_unit_is_not_shown_to_be() {
    let below = 0.5_f64.next_down();
    let beyond = 2.0_f64.powi(-45);
    // Down both sides of the middle.
    let word =
        |first: u8, letters: usize, last: &[u8]| [&[first][..], &vec![1 - first; letters], last].concat();
    let pair = |u, v| Pair { u, v, normal: [1.0, 0.0] };
    let levels = (0..14)
        .flat_map(|k| [pair(word(0, k, &[0]), word(1, k, &[])), pair(word(0, k + 1, &[]), word(1, k, &[1]))]);
    let certificate = Certificate {
        maps: [0.0, 0.5].map(|e| [below, 0.0, 0.0, 0.25, e, 0.0]).to_vec(),
        polygon: vec![[-beyond, -1.0], [1.0 + beyond, -1.0], [1.0 + beyond, 1.0], [-beyond, 1.0]],
        letters: 1,
        side: vec![0, 1],
        pairs: levels.chain([pair(word(0, 14, &[]), word(1, 14, &[]))]).collect(),
        exact: None,
    };
    assert!(check(&certificate).is_ok(), "{:?}", check(&certificate));
    let with = |maps: &[u8], value: &str| {
        let entry = |&map: &u8| ExactEntry { map, entry: 0, value: vec![value.to_owned()] };
        let exact = Exact {
            polynomial: ["0", "1"].map(str::to_owned).to_vec(),
            root: ["-1", "1"].map(str::to_owned),
            entries: maps.iter().map(entry).collect(),
        };
        check(&Certificate { exact: Some(exact), ..certificate.clone() }).map_err(|why| why.code())
    };
    assert!(with(&[], "1/2").is_ok());
    assert_eq!(with(&[0, 1], "1/2"), Err("not-apart"));
    // The first one is enough: it reaches up to 1/2.
    assert_eq!(with(&[0], "1/2"), Err("not-apart"));
}

#[test]
fn corners_and_directions_are_checked_of_exact_numbers() {
    assert_eq!(refused("koch", |proof| joined(proof).polygon[0] = [0.6, -0.6]).code(), "not-inside");
    assert_eq!(refused("koch", |proof| joined(proof).polygon[2] = [-1.5, -2.0]).code(), "polygon");
    assert_eq!(refused("cantor", |proof| apart(proof).polygon[0] = [0.1, -0.1]).code(), "not-inside");
    assert_eq!(refused("cantor", |proof| apart(proof).pairs[0].normal = [-1.0, 0.0]).code(), "not-apart");
    assert_eq!(refused("cantor", |proof| apart(proof).side = vec![1, 0]).code(), "stray");
    assert_eq!(refused("blocks", |proof| apart(proof).letters = 1).code(), "not-inside");
    assert_eq!(refused("blocks", |proof| apart(proof).pairs[0].normal = [0.0, 1.0]).code(), "not-apart");
}
