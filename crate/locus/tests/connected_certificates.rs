//! Proofs of connectedness are accepted by the checker, and none is made of what is disconnected.

use frond_check::{Address, Link, check_connected};
use frond_core::{Affine2, Ifs, Morph, MorphOptions, pair};
use frond_locus::{
    Bounds, CertifiedLink, ConnectedCertificate, LocusGrid, Options, ReasonKind, Scratch, State, Verdict,
    connected_certificate, connectedness,
};
use frond_scene::presets;
use frond_testing::cases;
use glam::DVec2;

/// The certificate in the checker's own terms.
fn plain(found: &ConnectedCertificate) -> frond_check::ConnectedCertificate {
    let link = |link: &CertifiedLink| match link {
        CertifiedLink::Point(addresses) => {
            Link::Point { addresses: addresses.clone().map(|[head, repeat]| Address { head, repeat }) }
        }
        CertifiedLink::Between(addresses) => {
            Link::Between { addresses: addresses.clone().map(|[head, repeat]| Address { head, repeat }) }
        }
        CertifiedLink::Area(pair) => Link::Area { pair: *pair },
        CertifiedLink::Difference(pair, steps) => Link::Difference { pair: *pair, steps: steps.clone() },
        CertifiedLink::Crossing(words, far) => Link::Crossing {
            words: words.clone(),
            far: far
                .each_ref()
                .map(|far| frond_check::Far { tail: far.tail.clone(), direction: far.direction.to_array() }),
        },
    };
    frond_check::ConnectedCertificate {
        maps: found.maps.clone(),
        polygon: found.polygon.iter().map(|p| p.to_array()).collect(),
        gap: found.gap,
        near: found.near.clone(),
        links: found.links.iter().map(link).collect(),
        squares: found.squares.as_ref().map(|squares| frond_check::Squares {
            size: squares.size.to_array(),
            cells: squares.cells.iter().map(|&([x, y], [k, l])| (x, y, k, l)).collect(),
        }),
        exact: None,
    }
}

/// A shape of the gallery.
fn shape(id: &str) -> Ifs {
    let preset = presets().into_iter().find(|preset| preset.id == id).expect("a shape of that name");
    Ifs::new(preset.maps.iter().map(|&row| Affine2::from_row(row)).collect()).unwrap()
}

fn certified(ifs: &Ifs) -> Option<frond_check::ConnectedCertificate> {
    connected_certificate(ifs, &Options::default()).map(|found| plain(&found))
}

fn number(link: &Link) -> usize {
    match link {
        Link::Point { .. } => 0,
        Link::Area { .. } => 1,
        Link::Crossing { .. } => 2,
        Link::Difference { .. } => 3,
        Link::Between { .. } => 4,
    }
}

#[test]
fn shapes_that_are_proved_have_certificates() {
    let mut kinds = [0; 5];
    for preset in presets().into_iter().filter(|preset| preset.maps.len() < 8) {
        let ifs = shape(preset.id);
        let verdict = connectedness(&ifs, &Options::default()).verdict;
        let found = certified(&ifs);
        assert_eq!(found.is_some(), verdict == Verdict::Connected, "{}: {verdict:?}", preset.id);
        let Some(found) = found else { continue };
        assert!(check_connected(&found).is_ok(), "{}: {:?}", preset.id, check_connected(&found));
        for link in &found.links {
            kinds[number(link)] += 1;
        }
    }
    // Points are looked for first; but where numbers are any, none are shared.
    let large =
        [(0.2, 0.1), (1.9, -0.3)].map(|(turn, e)| Affine2::similitude(0.75, turn, DVec2::new(e, 0.37)));
    let found = certified(&Ifs::new(large.to_vec()).unwrap()).expect("so much area");
    assert!(check_connected(&found).is_ok());
    assert_eq!(found.links, [Link::Area { pair: [0, 1] }]);
    assert!(kinds[0] > 5 && kinds[2] > 5, "{kinds:?}");
}

/// Samples of a locus that are proved; every so many of them.
fn proved_samples([from, to]: [&str; 2], side: usize, every: usize) -> Vec<Ifs> {
    let paired = pair(&shape(from), &shape(to));
    let morph = Morph::new(&paired.from, &paired.to, &MorphOptions::default()).unwrap();
    let epsilon = 1.0 / 600.0;
    // A side of 3 k + 1 samples has rows on which all maps are those of one end but for their places.
    let grid = LocusGrid::new(Bounds::default(), side, side).unwrap();
    let scratch = &mut Scratch::default();
    let mut state = grid.patch(&morph, epsilon, 0..side, 0..side, scratch).state;
    grid.prove(&morph, epsilon, 0..side, 0..side, &mut state, scratch);
    let proved = (0..state.len()).filter(|&k| state[k] == State::Connected as u8);
    let mut maps = Vec::new();
    let ifs = |k: usize| {
        morph.fill(grid.u(k % side), grid.v(k / side), &mut maps);
        Ifs::new(maps.clone()).unwrap()
    };
    proved.step_by(every).map(ifs).collect()
}

/// What is proved of the samples of loci can be handed on, and the checker agrees.
#[test]
fn samples_that_are_proved_have_certificates() {
    let mut kinds = [0; 5];
    for (names, side, every) in [
        (["dragon-3", "gasket"], 31, 7),
        (["gasket", "spiral"], 31, 5),
        (["dragon", "dragon-3"], 31, 21),
        (["gosper", "twigs"], 22, 31),
        (["twindragon", "hexaflake"], 22, 17),
        (["vicsek", "tree"], 22, 31),
    ] {
        let proved = proved_samples(names, side, every);
        assert!(proved.len() > 4, "{names:?}: {}", proved.len());
        for (k, ifs) in proved.iter().enumerate() {
            let found = certified(ifs).unwrap_or_else(|| panic!("{names:?}, sample {k}: {:?}", ifs.maps()));
            let checked = check_connected(&found);
            assert!(checked.is_ok(), "{names:?}, sample {k}: {checked:?}");
            for link in &found.links {
                kinds[number(link)] += 1;
            }
        }
    }
    println!("points, areas, crossings, differences: {kinds:?}");
    assert!(kinds[0] > 20 && kinds[2] > 20, "{kinds:?}");
}

/// Copies of one shape and direction never cross: their steps are shown to be differences of its points.
#[test]
fn copies_of_one_shape_have_certificates() {
    let (mut proved, mut turned) = (0, 0);
    for k in 0..cases(24) {
        let turn = 0.37 * f64::from(k);
        let count = 4 + k % 3;
        let places = (0..count).map(|n| 0.8 * DVec2::from_angle(f64::from(n * n) + 0.3 * f64::from(k)));
        let maps: Vec<Affine2> = places.map(|place| Affine2::similitude(0.56, turn, place)).collect();
        let ifs = Ifs::new(maps).unwrap();
        let reason = connectedness(&ifs, &Options::default()).reason.map(|reason| reason.kind);
        if reason != Some(ReasonKind::Differences) {
            continue;
        }
        proved += 1;
        let found = certified(&ifs).unwrap_or_else(|| panic!("{k} has a certificate"));
        assert!(check_connected(&found).is_ok(), "{k}: {:?}", check_connected(&found));
        turned += u32::from(
            found
                .links
                .iter()
                .any(|link| matches!(link, Link::Difference { steps, .. } if !steps.is_empty())),
        );
    }
    println!("{proved} proved by differences, {turned} with steps");
    assert!(proved > 3, "{proved}");
}

#[test]
fn a_certificate_of_other_maps_is_refused() {
    let found = certified(&shape("twigs")).expect("a certificate");
    let dust = certified(&shape("dust"));
    assert_eq!(dust, None);
    // The same pieces, a little smaller: they do not reach each other any more.
    let mut smaller = found.clone();
    for row in &mut smaller.maps {
        for x in &mut row[..4] {
            *x *= 0.4;
        }
    }
    assert!(check_connected(&smaller).is_err());
}

/// A crossing in sheared coordinates, far from the origin.
#[test]
fn certificates_hold_in_other_coordinates() {
    let place = Affine2::from_row([1.0, 3.0, 0.0, 1.0, 3e5, -7.0]);
    for id in ["maple", "twigs", "spiral"] {
        let maps = shape(id).maps().iter().map(|map| map.conjugate(place)).collect::<Option<_>>();
        let found = certified(&Ifs::new(maps.expect("a place")).unwrap());
        let found = found.unwrap_or_else(|| panic!("{id} has a certificate"));
        assert!(check_connected(&found).is_ok(), "{id}: {:?}", check_connected(&found));
    }
}

/// What lies on a line, or is a point, has a certificate that the checker takes.
#[test]
fn segments_and_points_have_certificates() {
    let row = |rows: &[[f64; 6]]| -> Vec<Affine2> { rows.iter().copied().map(Affine2::from_row).collect() };
    let line = [
        // Two parts that overlap; mirrored; of three maps, of which two share a point; along y.
        row(&[[0.6, 0.0, 0.0, 0.6, 1.0, 0.0], [0.6, 0.0, 0.0, 0.6, -1.0, 0.0]]),
        row(&[[-0.6, 0.0, 0.0, 0.3, 1.0, 0.0], [0.7, 0.0, 0.0, -0.6, -1.0, 0.0]]),
        row(&[[-0.7, 0.3, 0.0, 0.3, 1.0, 0.0], [-0.6, 0.0, 0.0, 0.0, -1.0, 0.0]]),
        row(&[
            [0.5, 0.0, 0.0, 0.5, 0.0, 0.0],
            [0.5, 0.0, 0.0, 0.5, 0.5, 0.0],
            [0.3, 0.0, 0.0, 0.5, 0.17, 0.0],
        ]),
        row(&[
            [0.4, 0.0, 0.0, 0.0, 0.0, 0.0],
            [0.4, 0.0, 0.0, 0.0, 0.3, 0.0],
            [-0.4, 0.0, 0.0, 0.0, 1.0, 0.0],
        ]),
        row(&[[0.3, 0.0, 0.2, 0.6, 0.0, 1.0], [0.1, 0.0, 0.0, -0.6, 0.0, -1.0]]),
    ];
    for maps in &line {
        let ifs = Ifs::new(maps.clone()).unwrap();
        let answer = connectedness(&ifs, &Options::default());
        assert_eq!(answer.verdict, Verdict::Connected, "{maps:?} {answer:?}");
        let reason = answer.reason.unwrap();
        assert_eq!(reason.kind, ReasonKind::Line, "{reason:?}");
        assert!(reason.text().contains("lies on a line"), "{}", reason.text());
        let found = certified(&ifs).unwrap_or_else(|| panic!("no certificate for {maps:?}"));
        assert_eq!(check_connected(&found).map(|checked| checked.links), Ok(found.links.len()), "{maps:?}");
        assert!(found.links.iter().any(|link| number(link) == 4), "{found:?}");
    }
    // A third that is not reached, and segments that are a little too short, have none.
    let mut less = line[0].clone();
    less.iter_mut().for_each(|map| map.linear.x_axis.x = 0.4999);
    assert_eq!(certified(&Ifs::new(less).unwrap()), None);
    let fixed = |scale: f64, turn: f64| {
        let linear = Affine2::similitude(scale, turn, DVec2::ZERO).linear;
        let quarter = linear.to_cols_array().map(|x| (x * 64.0).round() / 64.0);
        let linear = glam::DMat2::from_cols_array(&quarter);
        Affine2::new(linear, DVec2::new(3.0, -4.0) - linear * DVec2::new(3.0, -4.0))
    };
    let points = [
        row(&[[0.5, 0.1, -0.3, 0.25, 5.0, 6.0]]),
        row(&[[0.0; 6]]),
        row(&[[0.9, 0.0, 0.0, -0.9, 1e-9, 0.0]]),
        row(&[[0.5, 0.1, -0.3, 0.25, 5.0, 6.0]; 3]),
        row(&[[0.5, 3.0, 0.0, 0.25, 0.0, 0.0], [0.1, -0.3, 0.2, 0.7, 0.0, 0.0]]),
        vec![fixed(0.5, 0.3), fixed(0.75, 1.0), fixed(0.9, 2.0)],
        row(&[[f64::MIN_POSITIVE, 0.0, 0.0, 0.0, 1e6, -3.0]; 2]),
    ];
    for maps in &points {
        let ifs = Ifs::new(maps.clone()).unwrap();
        assert_eq!(connectedness(&ifs, &Options::default()).verdict, Verdict::Connected, "{maps:?}");
        let found = certified(&ifs).unwrap_or_else(|| panic!("no certificate for {maps:?}"));
        assert_eq!(check_connected(&found).map(|checked| checked.links), Ok(maps.len() - 1), "{maps:?}");
    }
    // They come near one point, but not exactly.
    let near = vec![fixed(0.5, 0.3), Affine2::similitude(0.3, 1.0, DVec2::new(0.1, 0.2))];
    let apart = certified(&Ifs::new(near).unwrap());
    assert!(apart.is_none_or(|found| check_connected(&found).is_ok()));
}
