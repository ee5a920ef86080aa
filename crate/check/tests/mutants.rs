//! Certificates that are proofs, and what is left of them when something is changed.

use frond_check::{Certificate, Checked, Pair, Refused, check};

/// Two copies of a segment scaled by `scale`, at its ends: apart below 1/2. They lie in a box that reaches beyond the
/// segment by `margin`.
fn dust(scale: f64, margin: f64) -> Certificate {
    let map = |e| [scale, 0.0, 0.0, scale, e, 0.0];
    let (low, high) = (-margin, 1.0 + margin);
    let mut certificate = Certificate {
        maps: vec![map(0.0), map(1.0 - scale)],
        polygon: vec![[low, low], [high, low], [high, margin], [low, margin]],
        letters: 1,
        side: vec![0, 1],
        pairs: Vec::new(),
        exact: None,
    };
    descend(&mut certificate, vec![0], vec![1]);
    certificate
}

fn descend(certificate: &mut Certificate, u: Vec<u8>, v: Vec<u8>) {
    assert!(u.len() < 60, "these are not apart");
    let reach = |word: &[u8]| {
        let ends = [certificate.polygon[0][0], certificate.polygon[1][0]];
        word.iter().rev().fold(ends, |ends, &i| {
            let [scale, .., e, _] = certificate.maps[usize::from(i)];
            ends.map(|x| scale * x + e)
        })
    };
    if reach(&u)[1] < reach(&v)[0] - 1e-12 {
        certificate.pairs.push(Pair { u, v, normal: [1.0, 0.25] });
        return;
    }
    let first = u.len() <= v.len();
    for letter in 0..certificate.maps.len() as u8 {
        let (mut u, mut v) = (u.clone(), v.clone());
        if first {
            u.push(letter);
        } else {
            v.push(letter);
        }
        descend(certificate, u, v);
    }
}

/// A proof whose tree has several levels.
fn proof() -> Certificate {
    let mut proof = dust(0.49, 0.3);
    for pair in &mut proof.pairs {
        pair.normal[1] = 0.0;
    }
    proof
}

/// The reason why a changed proof is refused.
fn refused(change: impl FnOnce(&mut Certificate)) -> Refused {
    let mut mutant = proof();
    change(&mut mutant);
    assert_ne!(mutant, proof(), "nothing was changed");
    check(&mutant).expect_err("this is no proof any more")
}

#[test]
fn a_proof_is_accepted() {
    let Checked { pairs, longest } = check(&proof()).unwrap();
    assert_eq!(pairs, proof().pairs.len());
    assert!(pairs > 5 && longest > 3, "{pairs} {longest}");
    // Order does not matter, nor what is said twice.
    let mut other = proof();
    other.pairs.reverse();
    other.pairs.push(other.pairs[0].clone());
    assert!(check(&other).is_ok());
    // Blocks of three letters map the polygon into its inside, too.
    let blocks = Certificate { letters: 3, ..proof() };
    assert!(check(&blocks).is_ok());
}

#[test]
fn the_last_digit_counts() {
    // Two halves meet in 1/2. A box that is the segment itself, but for a little height, is mapped to its own ends.
    let halves = |gap: f64| {
        let e = 0.5 + gap;
        Certificate {
            maps: vec![[0.5, 0.0, 0.0, 0.25, 0.0, 0.0], [0.5, 0.0, 0.0, 0.25, e, 0.0]],
            polygon: vec![[-gap, -1.0], [1.0 + 3.0 * gap, -1.0], [1.0 + 3.0 * gap, 1.0], [-gap, 1.0]],
            letters: 1,
            side: vec![0, 1],
            pairs: vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }],
            exact: None,
        }
    };
    // Reaches from -gap/2 to 1/2 + 3 gap/2, against 1/2 + gap - gap/2 and on: not apart, whatever the gap.
    assert_eq!(check(&halves(2.0_f64.powi(-40))).unwrap_err().code(), "not-apart");
    assert_eq!(check(&halves(0.0)).unwrap_err().code(), "not-inside");
    // Two points, and one digit between them.
    let points = |x: f64| Certificate {
        maps: vec![[0.0, 0.0, 0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 0.0, x, 0.0]],
        polygon: vec![[0.0, -1.0], [2.0, -1.0], [2.0, 1.0], [0.0, 1.0]],
        letters: 1,
        side: vec![0, 1],
        pairs: vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }],
        exact: None,
    };
    assert!(check(&points(1.0 + f64::EPSILON)).is_ok());
    assert_eq!(check(&points(1.0)).unwrap_err().code(), "not-apart");
    assert_eq!(check(&points(1.0 - f64::EPSILON)).unwrap_err().code(), "not-apart");
}

#[test]
fn a_pair_less_is_no_proof() {
    for k in 0..proof().pairs.len() {
        let why = refused(|c| {
            c.pairs.remove(k);
        });
        assert_eq!(why.code(), "uncovered", "pair {k}: {why}");
    }
    assert_eq!(refused(|c| c.pairs.clear()).code(), "form");
}

#[test]
fn directions_must_separate() {
    for k in 0..proof().pairs.len() {
        for (normal, code) in [
            ([-1.0, 0.0], "not-apart"),
            ([0.0, 1.0], "not-apart"),
            ([0.0, 0.0], "not-apart"),
            ([1e-9, 1.0], "not-apart"),
            ([f64::NAN, 0.0], "not-finite"),
            ([f64::INFINITY, 0.0], "not-finite"),
        ] {
            let why = refused(|c| c.pairs[k].normal = normal);
            assert_eq!(why.code(), code, "pair {k}, {normal:?}: {why}");
        }
    }
}

#[test]
fn words_must_cover_and_stay_on_their_side() {
    for k in 0..proof().pairs.len() {
        // Each letter but the first turned into the other: some word is then missing, and some may overlap.
        for at in 1..proof().pairs[k].u.len() {
            let why = refused(|c| c.pairs[k].u[at] ^= 1);
            assert!(["uncovered", "not-apart"].contains(&why.code()), "{why}");
        }
        assert_eq!(refused(|c| c.pairs[k].u[0] = 1).code(), "stray");
        assert_eq!(refused(|c| c.pairs[k].v[0] = 0).code(), "stray");
        assert_eq!(refused(|c| c.pairs[k].u.push(2)).code(), "stray");
        assert_eq!(refused(|c| c.pairs[k].u.push(255)).code(), "stray");
        assert_eq!(refused(|c| c.pairs[k].v.clear()).code(), "stray");
        assert_eq!(refused(|c| c.pairs[k].v.push(0)).code(), "uncovered");
        let swapped = refused(|c| {
            let pair = &mut c.pairs[k];
            std::mem::swap(&mut pair.u, &mut pair.v);
        });
        assert_eq!(swapped.code(), "stray");
    }
}

#[test]
fn a_word_shortened_claims_more_than_is_so() {
    // All pairs below one, replaced by that: it covers all, but what it says is not so.
    let first: Vec<Pair> = vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }];
    assert_eq!(refused(|c| c.pairs.clone_from(&first)).code(), "not-apart");
    // Even if all that is so is said as well.
    assert_eq!(refused(|c| c.pairs.extend(first)).code(), "not-apart");
    for k in 0..proof().pairs.len() {
        let why = refused(|c| {
            c.pairs[k].u.pop();
        });
        assert!(["uncovered", "not-apart", "stray"].contains(&why.code()), "{why}");
    }
}

#[test]
fn coefficients_must_be_those_of_the_proof() {
    assert_eq!(refused(|c| c.maps[0][0] = 0.52).code(), "not-apart");
    assert_eq!(refused(|c| c.maps[1][0] = 0.53).code(), "not-apart");
    assert_eq!(refused(|c| c.maps[0][0] = 1.1).code(), "not-inside");
    assert_eq!(refused(|c| c.maps[0][5] = 9.0).code(), "not-inside");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..6 {
            assert_eq!(refused(|c| c.maps[1][k] = bad).code(), "not-finite");
        }
    }
    assert_eq!(refused(|c| c.maps.clear()).code(), "form");
    assert_eq!(
        refused(|c| {
            c.maps.pop();
        })
        .code(),
        "form"
    );
    // One more map that closes the gap.
    let why = refused(|c| {
        c.maps.push([0.25, 0.0, 0.0, 0.25, 0.375, 0.0]);
        c.side.push(1);
    });
    assert_eq!(why.code(), "uncovered");
}

#[test]
fn the_polygon_must_be_a_proper_one_that_is_mapped_inside() {
    let code = |change: fn(&mut Vec<[f64; 2]>)| refused(|c| change(&mut c.polygon)).code();
    assert_eq!(code(|p| p.reverse()), "polygon");
    assert_eq!(code(|p| p.swap(1, 2)), "polygon");
    assert_eq!(code(|p| p.push(p[0])), "polygon");
    assert_eq!(code(|p| p.insert(1, [0.5, p[0][1]])), "polygon");
    assert_eq!(code(|p| p.insert(1, [0.5, p[0][1] + 0.1])), "polygon");
    // A pentagram winds twice.
    assert_eq!(
        code(|p| {
            *p = (0..5)
                .map(|k| (4.0 * f64::from(k) * 72.0_f64.to_radians() / 2.0).sin_cos())
                .map(|(y, x)| [2.0 * x, 2.0 * y])
                .collect();
        }),
        "polygon"
    );
    assert_eq!(code(|p| p.iter_mut().for_each(|q| *q = [0.0, 0.0])), "polygon");
    assert_eq!(code(|p| p.iter_mut().for_each(|q| q[1] = 0.0)), "polygon");
    assert_eq!(code(|p| p[2][1] = f64::NAN), "not-finite");
    assert_eq!(code(|p| p.truncate(2)), "form");
    assert_eq!(code(|p| p.clear()), "form");
    // Shrunk to less than the attractor; or away from it.
    assert_eq!(code(|p| p.iter_mut().for_each(|q| *q = [0.3 + 0.4 * q[0], 0.4 * q[1]])), "not-inside");
    assert_eq!(code(|p| p.iter_mut().for_each(|q| q[0] += 5.0)), "not-inside");
    assert_eq!(code(|p| p[1] = [0.5, -0.3]), "not-inside");
    // Grown, it proves nothing of pairs this near.
    assert_eq!(code(|p| p.iter_mut().for_each(|q| q.iter_mut().for_each(|x| *x *= 3.0))), "not-apart");
    assert_eq!(
        refused(|c| c.polygon.iter_mut().for_each(|q| q[1] = if q[1] < 0.0 { 0.0 } else { 0.3 })).code(),
        "not-inside",
        "strictly: an edge through the fixed points is mapped to itself"
    );
}

#[test]
fn the_cut_must_be_one() {
    let code = |side: &[u8]| refused(|c| c.side = side.to_vec()).code();
    assert_eq!(code(&[1, 0]), "stray");
    assert_eq!(code(&[0, 0]), "cut");
    assert_eq!(code(&[1, 1]), "cut");
    assert_eq!(code(&[0, 2]), "cut");
    assert_eq!(code(&[0]), "form");
    assert_eq!(code(&[0, 1, 1]), "form");
    assert_eq!(refused(|c| c.letters = 0).code(), "form");
    // Of three pieces, the first two meet: the cut must not go between them.
    let third = |e: f64| [0.25, 0.0, 0.0, 0.25, e, 0.0];
    let mut three = Certificate {
        maps: vec![third(0.0), third(0.25), third(0.75)],
        polygon: vec![[-0.1, -0.1], [1.1, -0.1], [1.1, 0.1], [-0.1, 0.1]],
        letters: 1,
        side: vec![0, 0, 1],
        pairs: [0, 1].map(|i| Pair { u: vec![i], v: vec![2], normal: [1.0, 0.0] }).to_vec(),
        exact: None,
    };
    assert!(check(&three).is_ok());
    three.side = vec![0, 1, 1];
    three.pairs = [1, 2].map(|j| Pair { u: vec![0], v: vec![j], normal: [1.0, 0.0] }).to_vec();
    assert_eq!(check(&three).unwrap_err(), Refused::NotApart { pair: 0, u: vec![0], v: vec![1] });
}

#[test]
fn blocks_must_all_contract() {
    // Nilpotent, of large norm: no box round in the plane is mapped into itself by single letters.
    let maps = vec![[0.0, 1.2, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.6, 0.0, 0.0, 2.0]];
    let square = vec![[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]];
    let mut blocks =
        Certificate { maps, polygon: square, letters: 1, side: vec![0, 1], pairs: Vec::new(), exact: None };
    blocks.pairs.push(Pair { u: vec![0], v: vec![1], normal: [0.0, 1.0] });
    assert_eq!(check(&blocks).unwrap_err(), Refused::NotInside { word: vec![0] });
    // Not even those of two letters; a flat box of single ones does.
    blocks.letters = 2;
    assert!(check(&blocks).is_err());
    blocks.letters = 1;
    blocks.polygon = vec![[-6.0, -4.0], [6.0, -4.0], [6.0, 4.9], [-6.0, 4.9]];
    assert!(matches!(check(&blocks).unwrap_err(), Refused::NotInside { .. }));
}

#[test]
fn what_is_too_large_is_refused_at_once() {
    let too_large = |change: fn(&mut Certificate)| assert_eq!(refused(change).code(), "too-large");
    too_large(|c| c.maps = vec![[0.1; 6]; 1_000_000]);
    too_large(|c| c.polygon = vec![[0.0; 2]; 100_000]);
    too_large(|c| c.letters = 40);
    too_large(|c| c.letters = usize::MAX);
    too_large(|c| c.pairs[0].u = vec![0; 1001]);
    too_large(|c| c.pairs = vec![c.pairs[0].clone(); 1_000_001]);
    too_large(|c| {
        let pair = Pair { u: vec![0; 900], v: vec![1; 900], normal: [1.0, 0.0] };
        c.pairs = vec![pair; 10_000];
    });
    // Few, but each of very many digits.
    too_large(|c| {
        c.maps[0][1] = 1e-300;
        let pair = Pair { u: vec![0; 900], v: vec![1; 900], normal: [1.0, 0.0] };
        c.pairs = vec![pair; 5000];
    });
    // The smallest and the largest doubles are numbers like others.
    let mut wide = proof();
    wide.maps[0][1] = f64::from_bits(1);
    assert!(check(&wide).is_ok());
    wide.maps[0][5] = f64::MAX;
    assert_eq!(check(&wide).unwrap_err().code(), "not-inside");
}

#[test]
fn messages_tell_where() {
    let why = refused(|c| c.pairs[0].normal = [-1.0, 0.0]).to_string();
    assert!(why.starts_with("Pair 1 is not apart"), "{why}");
    let why = refused(|c| {
        c.pairs.pop();
    });
    assert!(why.to_string().contains("are not shown to be apart"), "{why}");
}
