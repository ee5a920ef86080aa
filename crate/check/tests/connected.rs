//! Certificates of attractors in one piece, and what is left of them when something is changed.

use frond_check::{
    Address, CheckedConnected, ConnectedCertificate, Far, Link, Refused, Squares, check_connected,
};

/// Two thin bars laid across each other, each of two halves that reach a little beyond the middle. The polygon is a
/// square about them.
fn plus() -> ConnectedCertificate {
    let maps = vec![
        [0.6, 0.0, 0.0, 0.05, -0.4, 0.0],
        [0.6, 0.0, 0.0, 0.05, 0.4, 0.0],
        [0.05, 0.0, 0.0, 0.6, 0.02, -0.4],
        [0.05, 0.0, 0.0, 0.6, 0.02, 0.4],
    ];
    let polygon = vec![[-1.125, -1.125], [1.125, -1.125], [1.125, 1.125], [-1.125, 1.125]];
    let crossing = |words: [u8; 2], far: [(u8, [f64; 2]); 4]| Link::Crossing {
        words: words.map(|letter| vec![letter]),
        far: far.map(|(letter, direction)| Far { tail: vec![letter; 12], direction }),
    };
    let links = vec![
        // The left half and the lower: left and right, down and up.
        crossing([0, 2], [(0, LEFT), (1, RIGHT), (2, DOWN), (3, UP)]),
        crossing([1, 2], [(0, LEFT), (1, RIGHT), (2, DOWN), (3, UP)]),
        crossing([0, 3], [(0, LEFT), (1, RIGHT), (2, DOWN), (3, UP)]),
    ];
    // Both halves of each bar reach beyond the middle, and no gap is wider than a hundredth.
    let deep = |first: u8, then: u8| [vec![first], vec![then; 12]].concat();
    let near = vec![[deep(0, 1), deep(2, 3)], [deep(1, 0), deep(2, 3)], [deep(0, 1), deep(3, 2)]];
    ConnectedCertificate { maps, polygon, gap: 0.1, near, links, squares: None, exact: None }
}

const LEFT: [f64; 2] = [-1.0, 0.0];
const RIGHT: [f64; 2] = [1.0, 0.0];
const DOWN: [f64; 2] = [0.0, -1.0];
const UP: [f64; 2] = [0.0, 1.0];

/// The gasket, whose pieces share points.
fn gasket() -> ConnectedCertificate {
    let map = |e, f| [0.5, 0.0, 0.0, 0.5, e, f];
    let address = |head: u8, repeat: u8| Address { head: vec![head], repeat: vec![repeat] };
    let point = |a: u8, b: u8| Link::Point { addresses: [address(a, b), address(b, a)] };
    ConnectedCertificate {
        maps: vec![map(0.0, 0.0), map(0.5, 0.0), map(0.25, 0.43)],
        polygon: vec![[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]],
        gap: 1.0,
        near: Vec::new(),
        links: vec![point(0, 1), point(2, 1)],
        squares: None,
        exact: None,
    }
}

/// Two maps whose areas add up to exactly 1.
fn full() -> ConnectedCertificate {
    ConnectedCertificate {
        maps: vec![[0.75, 0.0, 0.0, 0.75, 0.0, 0.0], [0.0, -0.875, 0.5, 0.0, 0.1, 0.3]],
        links: vec![Link::Area { pair: [0, 1] }],
        polygon: vec![[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]],
        ..gasket()
    }
}

/// The reason why a changed proof is refused.
fn refused(mut proof: ConnectedCertificate, change: impl FnOnce(&mut ConnectedCertificate)) -> Refused {
    let before = proof.clone();
    change(&mut proof);
    assert_ne!(proof, before, "nothing was changed");
    check_connected(&proof).expect_err("this is no proof any more")
}

fn crossing(proof: &mut ConnectedCertificate, link: usize) -> (&mut [Vec<u8>; 2], &mut [Far; 4]) {
    match &mut proof.links[link] {
        Link::Crossing { words, far } => (words, far),
        other => panic!("{other:?}"),
    }
}

#[test]
fn proofs_of_all_kinds_are_accepted() {
    assert_eq!(check_connected(&plus()), Ok(CheckedConnected { links: 3, longest: 13 }));
    assert_eq!(check_connected(&gasket()), Ok(CheckedConnected { links: 2, longest: 2 }));
    // Addresses of one point need not be as long.
    let mut longer = gasket();
    let Link::Point { addresses: [_, b] } = &mut longer.links[0] else { panic!("a point") };
    b.head = vec![1, 0, 0];
    assert!(check_connected(&longer).is_ok());
    assert!(check_connected(&full()).is_ok());
    // One map is a point, and needs nothing.
    let one =
        ConnectedCertificate { maps: vec![[0.5, 0.0, 0.0, 0.5, 0.0, 0.0]], links: Vec::new(), ..gasket() };
    assert_eq!(check_connected(&one), Ok(CheckedConnected { links: 0, longest: 0 }));
    // Where the pieces turn the other way round, and whichever comes first.
    let mut turned = plus();
    for link in 0..3 {
        let (_, far) = crossing(&mut turned, link);
        far.swap(0, 1);
    }
    assert!(check_connected(&turned).is_ok());
    let (words, far) = crossing(&mut turned, 0);
    words.swap(0, 1);
    *far = [far[2].clone(), far[3].clone(), far[0].clone(), far[1].clone()];
    assert!(check_connected(&turned).is_ok());
}

#[test]
fn pieces_that_do_not_lie_across_each_other_are_refused() {
    let link = |change: &dyn Fn(&mut ConnectedCertificate)| match refused(plus(), change) {
        Refused::Link { link, .. } => link,
        other => panic!("{other}"),
    };
    // An upright bar moved to where the level one ends.
    let wide = ConnectedCertificate { gap: 0.25, ..plus() };
    assert!(check_connected(&wide).is_ok());
    let moved = refused(wide, |proof| proof.maps[2][4] = 0.22);
    assert!(matches!(moved, Refused::Link { link: 0, .. }), "{moved}");
    // A part that does not reach far enough: it is not yet known to lie beyond.
    assert_eq!(link(&|proof| crossing(proof, 0).1[1].tail.truncate(3)), 0);
    // The wrong way, and a way in which nothing is beyond anything.
    assert_eq!(link(&|proof| crossing(proof, 1).1[2].direction = UP), 1);
    assert_eq!(link(&|proof| crossing(proof, 1).1[2].direction = [0.0, 0.0]), 1);
    // Parts of the same end: each is beyond, but they do not alternate.
    assert_eq!(link(&|proof| crossing(proof, 2).1[1] = crossing(proof, 2).1[0].clone()), 2);
    // Through gaps as wide as that one could pass through the other, were there any.
    assert_eq!(link(&|proof| proof.gap = 4.0), 0);
}

#[test]
fn a_gap_that_is_not_shown_is_refused() {
    let is_gap = |change: &dyn Fn(&mut ConnectedCertificate)| {
        let why = refused(plus(), change);
        assert_eq!(why.code(), "gap", "{why}");
    };
    is_gap(&|proof| proof.near.truncate(2));
    is_gap(&|proof| proof.near.clear());
    is_gap(&|proof| proof.near[0][0].truncate(3));
    is_gap(&|proof| proof.gap = 1e-3);
    is_gap(&|proof| proof.near[0][1] = vec![2; 12]);
    // From the top to the middle of the bottom: far only against the direction across the lower edge.
    let deep = |first: u8, then: u8| [vec![first], vec![then; 12]].concat();
    let triangle = ConnectedCertificate {
        polygon: vec![[-0.5, -0.25], [1.5, -0.25], [0.5, 1.5]],
        near: vec![[deep(0, 1), deep(1, 0)], [deep(0, 2), deep(2, 0)]],
        gap: 0.3,
        ..gasket()
    };
    assert!(check_connected(&triangle).is_ok());
    assert_eq!(refused(triangle, |proof| proof.near[1] = [deep(2, 2), deep(0, 1)]).code(), "gap");
    assert_eq!(refused(plus(), |proof| proof.gap = -0.1).code(), "not-finite");
    assert_eq!(refused(plus(), |proof| proof.gap = f64::INFINITY).code(), "not-finite");
}

#[test]
fn links_that_do_not_reach_all_are_refused() {
    assert_eq!(refused(plus(), |proof| proof.links.truncate(2)), Refused::Unreached { map: 3 });
    assert_eq!(refused(gasket(), |proof| proof.links.clear()), Refused::Unreached { map: 1 });
    assert_eq!(
        refused(gasket(), |proof| proof.links[1] = proof.links[0].clone()),
        Refused::Unreached { map: 2 }
    );
}

#[test]
fn points_and_areas_are_compared_to_the_last_digit() {
    let of_link = |proof, change: &dyn Fn(&mut ConnectedCertificate)| {
        assert_eq!(refused(proof, change).code(), "link");
    };
    of_link(gasket(), &|proof| proof.maps[1][0] = 0.5_f64.next_up());
    of_link(gasket(), &|proof| proof.maps[2][2] = f64::from_bits(1));
    let address = |head: &[u8], repeat: &[u8]| Address { head: head.to_vec(), repeat: repeat.to_vec() };
    of_link(gasket(), &|proof| {
        proof.links[0] = Link::Point { addresses: [address(&[0], &[1]), address(&[1], &[2])] };
    });
    of_link(gasket(), &|proof| {
        proof.links[0] = Link::Point { addresses: [address(&[0], &[1]), address(&[], &[1, 0])] };
    });
    of_link(gasket(), &|proof| proof.links[0] = Link::Area { pair: [0, 1] });
    of_link(full(), &|proof| proof.maps[1][2] = 0.5_f64.next_down());
}

/// A square of nine copies of a half, which overlap: the differences of its points fill the square from -1 to 1, here
/// cut in 16.
fn square() -> ConnectedCertificate {
    let map = |k: i32| [0.5, 0.0, 0.0, 0.5, f64::from(k % 3) / 4.0, f64::from(k / 3) / 4.0];
    let cell = |k: i32| {
        let (x, y) = (k % 4 - 2, k / 4 - 2);
        // On the left by a difference to the left, below by one downwards.
        let (from, to) = match (x < 0, y < 0) {
            (true, true) => (0, 8),
            (true, false) => (6, 2),
            (false, true) => (2, 6),
            (false, false) => (8, 0),
        };
        (x, y, from, to)
    };
    let link = |pair| Link::Difference { pair, steps: Vec::new() };
    let pairs = [[0, 1], [1, 2], [3, 4], [4, 5], [6, 7], [7, 8], [0, 3], [3, 6]];
    ConnectedCertificate {
        maps: (0..9).map(map).collect(),
        polygon: vec![[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]],
        links: pairs.map(link).to_vec(),
        squares: Some(Squares { size: [0.5, 0.5], cells: (0..16).map(cell).collect() }),
        ..gasket()
    }
}

#[test]
fn differences_are_checked_square_by_square() {
    assert_eq!(check_connected(&square()), Ok(CheckedConnected { links: 8, longest: 0 }));
    let squares = |change: &dyn Fn(&mut Squares)| {
        let why = refused(square(), |proof| change(proof.squares.as_mut().unwrap()));
        assert_eq!(why, Refused::Squares);
    };
    squares(&|squares| squares.cells.truncate(15));
    squares(&|squares| squares.cells[0].2 = 3);
    squares(&|squares| squares.size[0] = 0.375);
    squares(&|squares| squares.size = [-0.5, 0.5]);
    squares(&|squares| {
        // The same squares, counted from the other side.
        squares.size = [-0.5, -0.5];
        squares.cells.iter_mut().for_each(|cell| (cell.2, cell.3) = (cell.3, cell.2));
    });
    squares(&|squares| squares.size = [0.5, f64::NAN]);
    squares(&|squares| squares.cells.push((2, 0, 1, 0)));
    // Maps that differ in the last digit, or flatten everything.
    assert_eq!(refused(square(), |proof| proof.maps[1][0] = 0.5_f64.next_down()), Refused::Squares);
    let flat = refused(square(), |proof| proof.maps.iter_mut().for_each(|row| row[3] = 0.0));
    assert_eq!(flat, Refused::Squares);
    let link = |change: &dyn Fn(&mut ConnectedCertificate)| {
        let why = refused(square(), change);
        assert_eq!(why.code(), "link", "{why}");
    };
    link(&|proof| proof.squares = None);
    // From (1/2, 0) beyond the rim.
    link(&|proof| proof.links[0] = Link::Difference { pair: [0, 1], steps: vec![[0, 2]] });
    // From the left to the right, without a step between.
    link(&|proof| proof.links[0] = Link::Difference { pair: [0, 2], steps: Vec::new() });
    // Back to where it was: (1/2, 0) = 2 ((1/2, 0) - (1/4, 0)).
    let round = Link::Difference { pair: [0, 1], steps: vec![[1, 0]; 5] };
    let mut longer = square();
    longer.links[0] = round;
    assert!(check_connected(&longer).is_ok());
    let form = |change: &dyn Fn(&mut ConnectedCertificate)| {
        assert_eq!(refused(square(), change).code(), "form");
    };
    form(&|proof| proof.links[0] = Link::Difference { pair: [0, 9], steps: Vec::new() });
    form(&|proof| proof.links[0] = Link::Difference { pair: [0, 1], steps: vec![[0, 9]] });
    form(&|proof| proof.squares.as_mut().unwrap().cells[0].0 = i32::MAX);
    form(&|proof| proof.squares.as_mut().unwrap().cells[0].3 = 9);
}

/// Where the determinant is negative.
#[test]
fn differences_of_mirrored_copies_are_checked() {
    let mut proof = square();
    for row in &mut proof.maps {
        row[3] = -0.5;
    }
    assert_eq!(check_connected(&proof), Ok(CheckedConnected { links: 8, longest: 0 }));
}

#[test]
fn what_is_of_no_form_is_refused() {
    let form = |change: &dyn Fn(&mut ConnectedCertificate)| {
        let why = refused(plus(), change);
        assert!(["form", "too-large", "not-finite", "polygon", "not-inside"].contains(&why.code()), "{why}");
    };
    form(&|proof| proof.maps.clear());
    form(&|proof| proof.maps[0][0] = f64::NAN);
    form(&|proof| proof.maps[0][0] = 1.5);
    form(&|proof| proof.polygon.truncate(2));
    form(&|proof| proof.polygon.reverse());
    form(&|proof| proof.near[0][0].clear());
    form(&|proof| proof.near[0][0][3] = 4);
    form(&|proof| crossing(proof, 0).0[0].clear());
    form(&|proof| crossing(proof, 0).1[0].tail[1] = 9);
    form(&|proof| crossing(proof, 0).1[0].tail = vec![0; 2000]);
    form(&|proof| crossing(proof, 0).1[0].direction[0] = f64::NAN);
    form(&|proof| proof.links[0] = Link::Area { pair: [1, 1] });
    form(&|proof| proof.links[0] = Link::Area { pair: [0, 4] });
    let nothing = Address { head: vec![0], repeat: Vec::new() };
    form(&|proof| proof.links[0] = Link::Point { addresses: [nothing.clone(), nothing.clone()] });
    form(&|proof| proof.near = vec![[vec![0; 1000], vec![2; 1000]]; 6000]);
}

#[cfg(feature = "text")]
#[test]
fn certificates_of_both_kinds_are_told_apart_as_text() {
    use frond_check::{Certificate, CheckedProof, Pair, Proof};
    for proof in [plus(), gasket(), square()] {
        let back = Proof::from_json(&proof.to_json().unwrap()).unwrap();
        assert!(matches!(back.check(), Ok(CheckedProof::Connected(_))));
        assert_eq!(back, Proof::Connected(proof));
    }
    let third = |e| [0.3, 0.0, 0.0, 0.3, e, 0.0];
    let dust = Certificate {
        maps: vec![third(0.0), third(0.7)],
        polygon: vec![[-0.5, -0.5], [1.5, -0.5], [1.5, 0.5], [-0.5, 0.5]],
        letters: 1,
        side: vec![0, 1],
        pairs: vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }],
        exact: None,
    };
    let back = Proof::from_json(&dust.to_json().unwrap()).unwrap();
    assert!(matches!(back.check(), Ok(CheckedProof::Disconnected(_))));
    for text in ["", "{}", "[]", r#"{"links":[]}"#, r#"{"links":[{"kind":"faith"}],"maps":[]}"#] {
        assert!(Proof::from_json(text).is_err(), "{text}");
    }
}

/// A segment from -2.5 to 2.5 of two parts that overlap, along (1, 2).
fn segment(scale: f64) -> ConnectedCertificate {
    let map = |sign: f64| [scale, 0.0, 0.0, scale, sign, 2.0 * sign];
    let end = |head: u8, repeat: u8| Address { head: vec![head], repeat: vec![repeat] };
    ConnectedCertificate {
        maps: vec![map(1.0), map(-1.0)],
        polygon: vec![[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]],
        // The first piece reaches from the image of the one end to that of the other; the second begins below it.
        links: vec![Link::Between { addresses: [end(0, 1), end(0, 0), end(1, 0)] }],
        ..gasket()
    }
}

#[test]
fn segments_that_overlap_on_a_line_are_accepted() {
    for scale in [0.5, 0.5_f64.next_up(), 0.6, 0.75] {
        assert!(check_connected(&segment(scale)).is_ok(), "{scale}");
    }
}

#[test]
fn what_does_not_overlap_on_a_line_is_refused() {
    let refused = |certificate: &ConnectedCertificate| check_connected(certificate).map_err(|why| why.code());
    assert_eq!(refused(&segment(0.5_f64.next_down())), Err("link"));
    // Off the line by the last digit. Moved, both copies still lie on one line, since they are copies of one shape.
    for k in 0..4 {
        let mut bent = segment(0.6);
        bent.maps[1][k] = if bent.maps[1][k] == 0.0 { 1e-300 } else { bent.maps[1][k].next_up() };
        assert_eq!(refused(&bent), Err("link"), "number {k}");
    }
    // Two points of the first piece that are one, or not of one piece; the third outside; letters of no map.
    let with = |letters: [[u8; 2]; 3]| {
        let addresses = letters.map(|[head, repeat]| Address { head: vec![head], repeat: vec![repeat] });
        ConnectedCertificate { links: vec![Link::Between { addresses }], ..segment(0.6) }
    };
    assert_eq!(refused(&with([[0, 0], [0, 0], [1, 0]])), Err("link"));
    assert_eq!(refused(&with([[0, 0], [0, 0], [0, 0]])), Err("link"));
    assert_eq!(refused(&with([[0, 1], [0, 0], [1, 1]])), Err("link"));
    assert_eq!(refused(&with([[0, 1], [1, 1], [1, 0]])), Err("form"));
    assert_eq!(refused(&with([[0, 1], [0, 0], [2, 0]])), Err("form"));
    assert_eq!(refused(&with([[0, 1], [0, 0], [0, 0]])), Err("unreached"));
    // Pieces of the plane that are nowhere near a line.
    let plane = ConnectedCertificate { maps: plus().maps, ..with([[0, 1], [0, 0], [1, 0]]) };
    assert_eq!(refused(&plane), Err("link"));
}
