//! Proofs about exact numbers, of shapes of which it is known whether they hang together.

use frond_exact::{ExactNumber, ExactNumbers};
use frond_locus::{ExactProof, LinkKind, Options, Unproved, prove_exact};

/// Rows of formulas.
#[derive(Default)]
struct Shape {
    rows: Vec<[f64; 6]>,
    formulas: Vec<String>,
}

impl Shape {
    fn number(&mut self, formula: &str) -> f64 {
        if !self.formulas.iter().any(|known| known == formula) {
            self.formulas.push(formula.into());
        }
        ExactNumber::read(formula).unwrap_or_else(|error| panic!("{formula}: {error}")).value()
    }

    /// `z -> (a + b i) z + e + f i`, by formulas of a, b, e and f.
    fn turned(mut self, [a, b, e, f]: [&str; 4]) -> Self {
        let [a, b, e, f] = [a, b, e, f].map(|formula| self.number(formula));
        self.rows.push([a, -b, b, a, e, f]);
        self
    }

    fn of(maps: &[[&str; 4]]) -> Self {
        maps.iter().fold(Self::default(), |shape, map| shape.turned(*map))
    }

    /// Copies of one size without a turn.
    fn copies(ratio: &str, shifts: &[[String; 2]]) -> Self {
        shifts.iter().fold(Self::default(), |shape, [e, f]| shape.turned([ratio, "0", e, f]))
    }

    fn proof(&self) -> ExactProof {
        let numbers = ExactNumbers::read(&self.distinct()).unwrap();
        prove_exact(&self.rows, &numbers, &Options::default(), 20_000)
    }

    /// One formula for each double: the list has room for so many.
    fn distinct(&self) -> Vec<&str> {
        let mut seen: Vec<u64> = Vec::new();
        let is_new = |formula: &&String| {
            let bits = ExactNumber::read(formula).unwrap().value().abs().to_bits();
            let is_new = !seen.contains(&bits);
            seen.push(bits);
            is_new
        };
        self.formulas.iter().filter(is_new).map(String::as_str).collect()
    }

    /// The same doubles, which stand for themselves.
    fn as_doubles(&self) -> ExactProof {
        prove_exact(&self.rows, &ExactNumbers::default(), &Options::default(), 2000)
    }
}

#[track_caller]
fn assert_connected(shape: &Shape) {
    let ExactProof::Connected { certificate, reason } = shape.proof() else {
        panic!("{:?}", shape.proof());
    };
    assert_eq!(certificate.maps, shape.rows);
    assert!(frond_check::check_connected(&certificate).is_ok());
    assert!(certificate.exact.is_some());
    assert!(reason.is_proof() && reason.links.len() + 1 >= shape.rows.len());
    assert!(reason.links.iter().all(|link| link.pair.0 < link.pair.1 && link.at.is_finite()));
}

#[track_caller]
fn assert_disconnected(shape: &Shape) {
    let ExactProof::Disconnected { certificate } = shape.proof() else {
        panic!("{:?}", shape.proof());
    };
    assert!(certificate.exact.is_some() && frond_check::check(&certificate).is_ok());
}

fn koch() -> Shape {
    Shape::of(&[
        ["1/3", "0", "0", "0"],
        ["cos(60°)/3", "sin(60°)/3", "1/3", "0"],
        ["cos(60°)/3", "-sin(60°)/3", "1/2", "√3/6"],
        ["1/3", "0", "2/3", "0"],
    ])
}

#[test]
fn the_curve_of_koch_is_in_one_piece_as_it_is_typed() {
    let koch = koch();
    assert_connected(&koch);
    let ExactProof::Connected { reason, .. } = koch.proof() else { return };
    let links: Vec<_> = reason.links.iter().map(|link| (link.kind, link.pair, &link.words)).collect();
    let words = [["1(4)", "2(1)"], ["2(4)", "3(1)"], ["3(4)", "4(1)"]].map(|words| words.map(String::from));
    let wanted: Vec<_> =
        words.iter().enumerate().map(|(k, words)| (LinkKind::Point, (k, k + 1), words)).collect();
    assert_eq!(links, wanted);
    assert!(reason.links[1].at.distance(glam::DVec2::new(0.5, 3f64.sqrt() / 6.0)) < 1e-15);
    // A third as a double is not a third.
    assert!(!matches!(koch.as_doubles(), ExactProof::Connected { .. }));
}

fn thirds(shifts: &[&str]) -> Shape {
    Shape::copies("1/3", &shifts.iter().map(|e| [(*e).into(), "0".into()]).collect::<Vec<_>>())
}

#[test]
fn thirds_of_a_segment() {
    assert_connected(&thirds(&["0", "1/3", "2/3"]));
    assert_disconnected(&thirds(&["0", "2/3"]));
    assert!(!matches!(thirds(&["0", "1/3", "2/3"]).as_doubles(), ExactProof::Connected { .. }));
    // By maps without an inverse, of which the neighbour graph is not computed.
    let mut flat = thirds(&["0", "1/3", "2/3"]);
    flat.rows.iter_mut().for_each(|row| row[3] = 0.0);
    assert_connected(&flat);
    // A single map, and maps of one point.
    assert_connected(&thirds(&["1/3"]));
    let mut point = thirds(&["2/3", "2/3"]);
    point.rows[1] = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    assert_connected(&point);
}

#[test]
fn pentagons_at_the_golden_ratio_and_below() {
    let pentagon = |ratio: &str| {
        let shift = |k: usize, word: &str| format!("{word}({}°)*(1-{ratio})", 72 * k + 18);
        let shifts: Vec<[String; 2]> = (0..5).map(|k| [shift(k, "cos"), shift(k, "sin")]).collect();
        Shape::copies(ratio, &shifts)
    };
    assert_connected(&pentagon("((3-√5)/2)"));
    assert_disconnected(&pentagon("(3819/10000)"));
}

#[test]
fn tiles_are_in_one_piece() {
    let terdragon =
        [["1/2", "√3/6", "0", "0"], ["0", "-√3/3", "1/2", "√3/6"], ["1/2", "√3/6", "1/2", "-√3/6"]];
    assert_connected(&Shape::of(&terdragon));
    // Seven parts of Gosper's island: the factor is (5 - i sqrt 3) / 14.
    let mut gosper = Shape::of(&[["5/14", "-√3/14", "0", "0"]]);
    for k in 0..6 {
        let [c, s] = ["cos", "sin"].map(|word| format!("{word}({}°)", 60 * k));
        let [e, f] = [format!("(5{c}+√3{s})/14"), format!("(5{s}-√3{c})/14")];
        gosper = gosper.turned(["5/14", "-√3/14", &e, &f]);
    }
    assert_connected(&gosper);
}

/// Dragons whose numbers are doubles: with a third beside them, so that something is exact.
#[test]
fn dragons_are_in_one_piece() {
    for maps in [
        [["1/2", "1/2", "0", "0"], ["-1/2", "1/2", "1/3", "0"]],
        [["1/2", "1/2", "0", "0"], ["1/2", "-1/2", "1/6", "1/6"]],
    ] {
        assert_connected(&Shape::of(&maps));
    }
}

#[test]
fn flakes_are_in_one_piece() {
    let mut hexaflake = Shape::of(&[["1/3", "0", "0", "0"]]);
    for k in 0..6 {
        let [e, f] = ["cos", "sin"].map(|word| format!("{word}({}°)*2/3", 60 * k));
        hexaflake = hexaflake.turned(["1/3", "0", &e, &f]);
    }
    assert_connected(&hexaflake);
    let shifts = [["0", "0"], ["2/3", "0"], ["1/3", "1/3"], ["0", "2/3"], ["2/3", "2/3"]];
    assert_connected(&Shape::copies("1/3", &shifts.map(|shift| shift.map(String::from))));
    // Without its middle, Vicsek's cross is four dusts.
    let corners = [["0", "0"], ["2/3", "0"], ["0", "2/3"], ["2/3", "2/3"]];
    assert_disconnected(&Shape::copies("1/3", &corners.map(|shift| shift.map(String::from))));
}

#[test]
fn the_pentadendrite_is_in_one_piece() {
    // Six steps in the directions 0, 72, 0, -144, -72 and 0 degrees: their sum is S = (9 + sqrt 5)/4 - i sin 36, and
    // 1/S = ((9 + sqrt 5)/4 + i sin 36) / (6 + sqrt 5).
    let (directions, mut sum) = ([0, 72, 0, -144, -72, 0], [String::from("0"), "0".into()]);
    let over = |c: &str, s: &str| {
        [format!("((9+√5)/4*({c})-sin(36°)*({s}))/(6+√5)"), format!("((9+√5)/4*({s})+sin(36°)*({c}))/(6+√5)")]
    };
    let mut shape = Shape::default();
    for direction in directions {
        let [c, s] = ["cos", "sin"].map(|word| format!("{word}({direction}°)"));
        let [[a, b], [e, f]] = [over(&c, &s), over(&sum[0], &sum[1])];
        shape = shape.turned([&a, &b, &e, &f]);
        sum = [format!("{}+{c}", sum[0]), format!("{}+{s}", sum[1])];
    }
    assert_connected(&shape);
}

#[test]
fn what_is_not_proved_says_why() {
    let grows = Shape::of(&[["4/3", "0", "0", "0"], ["1/3", "0", "1", "0"]]);
    assert_eq!(grows.proof(), ExactProof::Undecided(Unproved::NoAttractor));
    let infinite = prove_exact(&[[f64::NAN; 6]; 2], &ExactNumbers::default(), &Options::default(), 10);
    assert!(matches!(infinite, ExactProof::Undecided(Unproved::Numbers(_))));
    let roots = ["√2", "√3", "√5", "√7", "√11"].map(|root| format!("{root}/10"));
    let shape = Shape::of(&[[&roots[0], &roots[1], "0", "0"], [&roots[2], &roots[3], &roots[4], "0"]]);
    assert!(matches!(shape.proof(), ExactProof::Undecided(Unproved::Numbers(_))));
}
