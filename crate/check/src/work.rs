//! How much a check takes, counted in multiplications of machine words.
//!
//! One meter runs through a whole check. It is part of the [`Scene`](crate::polygon::Scene), and whatever computes with
//! long numbers there spends what it takes at the most before it begins. So a claim of a new kind is bounded as soon as
//! it is built of these. The same costs, summed over a certificate before anything is computed, refuse at once what is
//! too large.

use std::cell::Cell;

use num_bigint::BigInt;

use crate::refused::Refused;

/// The most that a check takes: some twenty seconds.
pub(crate) const WORK: u64 = 20_000_000_000;
/// What an operation takes besides its digits: memory for its result.
const OPERATION: u64 = 100;
/// To find a number among many that are sorted, or to go round a loop over plain numbers so often.
pub(crate) const LOOK_UP: u64 = 64;

/// The meter.
pub(crate) struct Work {
    spent: Cell<u64>,
    most: u64,
}

impl Work {
    pub const fn at_most(most: u64) -> Self {
        Self { spent: Cell::new(0), most }
    }

    /// Counts what is about to be done, in a time that does not depend on how much it is.
    pub fn spend(&self, cost: u64) -> Result<(), Refused> {
        self.spent.set(self.spent.get().saturating_add(cost));
        if self.spent.get() > self.most {
            Err(Refused::TooLarge { what: "digits to multiply", most: self.most })
        } else {
            Ok(())
        }
    }

    /// A meter with the same limit of which nothing is spent: for what is planned.
    pub const fn afresh(&self) -> Self {
        Self::at_most(self.most)
    }

    #[cfg(test)]
    pub fn spent(&self) -> u64 {
        self.spent.get()
    }
}

/// What it takes to multiply or divide numbers of so many binary digits, and to add what comes of it.
pub(crate) const fn product(a: u64, b: u64) -> u64 {
    (a / 64 + 1).saturating_mul(b / 64 + 1).saturating_add(OPERATION)
}

/// The binary digits of the largest of some numbers.
pub(crate) fn digits<'a>(numbers: impl IntoIterator<Item = &'a BigInt>) -> u64 {
    numbers.into_iter().map(BigInt::bits).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::{Certificate, Pair};
    use crate::connected::{Address, ConnectedCertificate, Far, Link, Squares};
    use crate::exact::{Exact, ExactEntry};
    use crate::proof::Proof;

    const SQUARE: [[f64; 2]; 4] = [[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]];

    /// Two maps to points, so that words of any length are of pieces that are apart.
    fn apart(letters: usize, pairs: usize) -> Proof {
        let pair = |k: usize| {
            let word = |first: u8| [vec![first], vec![k as u8 % 2; letters - 1]].concat();
            Pair { u: word(0), v: word(1), normal: [1.0, 1e-200] }
        };
        let whole = Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] };
        Proof::Disconnected(Certificate {
            maps: vec![[0.1, 0.0, 0.0, 0.1, -1.0, 0.0], [0.1, 0.0, 0.0, 0.1, 1.0, 0.0]],
            polygon: SQUARE.to_vec(),
            letters: 1,
            side: vec![0, 1],
            pairs: (0..pairs).map(pair).chain([whole]).collect(),
            exact: None,
        })
    }

    fn connected(maps: Vec<[f64; 6]>, links: Vec<Link>, squares: Option<Squares>) -> Proof {
        let (polygon, near) = (SQUARE.to_vec(), Vec::new());
        Proof::Connected(ConnectedCertificate { maps, polygon, gap: 1.0, near, links, squares, exact: None })
    }

    /// The halves of a segment share 1/2, whose addresses are written with some letters too many.
    fn points(letters: usize, links: usize) -> Proof {
        let halves = [0.0, 0.5].map(|e| [0.5, 0.0, 0.0, 0.3, e, 0.0]);
        let address = |k: usize| {
            let (head, rest) = (k as u8, 1 - k as u8);
            Address { head: [vec![head], vec![rest; letters]].concat(), repeat: vec![rest; letters] }
        };
        connected(halves.to_vec(), vec![Link::Point { addresses: [0, 1].map(address) }; links], None)
    }

    /// Nine copies of a half, whose differences fill the square from -1 to 1, cut in `side` times `side` squares. Steps
    /// go round: (1/2, 0) = 2 ((1/2, 0) - (1/4, 0)).
    fn copies(side: i32, steps: usize) -> Proof {
        let map = |k: i32| [0.5, 0.0, 0.0, 0.5, f64::from(k % 3) / 4.0, f64::from(k / 3) / 4.0];
        let cell = |k: i32| {
            let (x, y) = (k % side - side / 2, k / side - side / 2);
            let (from, to) = match (x < 0, y < 0) {
                (true, true) => (0, 8),
                (true, false) => (6, 2),
                (false, true) => (2, 6),
                (false, false) => (8, 0),
            };
            (x, y, from, to)
        };
        let pairs = [[0, 1], [1, 2], [3, 4], [4, 5], [6, 7], [7, 8]];
        let across = pairs.map(|pair| Link::Difference { pair, steps: vec![[1, 0]; steps] });
        let up = [[0, 3], [3, 6]].map(|pair| Link::Difference { pair, steps: vec![[3, 0]; steps] });
        let size = [2.0 / f64::from(side); 2];
        let squares = Squares { size, cells: (0..side * side).map(cell).collect() };
        connected((0..9).map(map).collect(), [&across[..], &up].concat(), Some(squares))
    }

    /// Two bars across each other, each of two halves that reach a little beyond the middle, and far parts of so many
    /// letters.
    fn bars(letters: usize) -> Proof {
        let maps = vec![
            [0.6, 0.0, 0.0, 0.05, -0.4, 0.0],
            [0.6, 0.0, 0.0, 0.05, 0.4, 0.0],
            [0.05, 0.0, 0.0, 0.6, 0.02, -0.4],
            [0.05, 0.0, 0.0, 0.6, 0.02, 0.4],
        ];
        let ways = [(0, [-1.0, 0.0]), (1, [1.0, 0.0]), (2, [0.0, -1.0]), (3, [0.0, 1.0])];
        let far = ways.map(|(letter, direction)| Far { tail: vec![letter; letters], direction });
        let link = |[a, b]: [u8; 2]| Link::Crossing { words: [vec![a], vec![b]], far: far.clone() };
        let deep = |first: u8, then: u8| [vec![first], vec![then; letters]].concat();
        let near = vec![[deep(0, 1), deep(2, 3)], [deep(1, 0), deep(2, 3)], [deep(0, 1), deep(3, 2)]];
        let links = [[0, 2], [1, 2], [0, 3]].map(link).to_vec();
        let polygon = [[-1.125, -1.125], [1.125, -1.125], [1.125, 1.125], [-1.125, 1.125]].to_vec();
        Proof::Connected(ConnectedCertificate {
            maps,
            polygon,
            gap: 0.1,
            near,
            links,
            squares: None,
            exact: None,
        })
    }

    fn areas(links: usize) -> Proof {
        let maps = vec![[0.75, 0.0, 0.0, 0.75, 0.0, 0.0], [0.0, -0.875, 0.5, 0.0, 0.1, 0.3]];
        connected(maps, vec![Link::Area { pair: [0, 1] }; links], None)
    }

    /// Two pieces of a segment that overlap: 0.6 x + 1 has the points 2.5 and -0.5, and 0.6 x - 1 has 0.5 between them.
    fn lines(letters: usize, links: usize) -> Proof {
        let maps = [1.0, -1.0].map(|e| [0.6, 0.0, 0.0, 0.6, e, 0.0]).to_vec();
        let address = |head: u8, rest: u8| Address {
            head: [vec![head], vec![rest; letters]].concat(),
            repeat: vec![rest; letters],
        };
        let addresses = [address(0, 0), address(0, 1), address(1, 0)];
        connected(maps, vec![Link::Between { addresses }; links], None)
    }

    /// The same of exact numbers, by a root of a polynomial of that degree.
    fn exactly(mut proof: Proof, degree: usize) -> Proof {
        let (polynomial, root): (&[&str], _) = match degree {
            1 => (&["0", "1"], ["-1", "1"]),
            2 => (&["-3", "0", "1"], ["17/10", "9/5"]),
            _ => (&["-5", "0", "0", "-1", "0", "1"], ["1", "2"]),
        };
        let known = [
            (0.6, "3/5"),
            (0.05, "1/20"),
            (0.1, "1/10"),
            (0.3, "3/10"),
            (0.5, "1/2"),
            (0.75, "3/4"),
            (-0.875, "-7/8"),
            (0.4, "2/5"),
            (0.02, "1/50"),
        ];
        let (maps, exact) = match &mut proof {
            Proof::Connected(ConnectedCertificate { maps, exact, .. }) => (maps, exact),
            Proof::Disconnected(Certificate { maps, exact, .. }) => (maps, exact),
        };
        let mut entries = Vec::new();
        for (k, x) in maps.iter().flatten().enumerate() {
            if let Some((_, text)) = known.iter().find(|(double, _)| double == x) {
                let (map, entry) = ((k / 6) as u8, (k % 6) as u8);
                entries.push(ExactEntry { map, entry, value: vec![(*text).to_owned()] });
            }
        }
        let polynomial = polynomial.iter().map(|&text| text.to_owned()).collect();
        *exact = Some(Exact { polynomial, root: root.map(str::to_owned), entries });
        proof
    }

    /// Proofs of every kind of claim.
    fn proofs() -> [Proof; 24] {
        [
            exactly(apart(2, 1), 1),
            exactly(apart(40, 7), 5),
            exactly(points(1, 1), 1),
            exactly(points(30, 3), 1),
            exactly(points(12, 3), 2),
            exactly(points(12, 3), 5),
            exactly(bars(12), 1),
            exactly(bars(30), 5),
            exactly(areas(1), 2),
            exactly(areas(100), 5),
            exactly(lines(1, 1), 2),
            exactly(lines(30, 3), 5),
            apart(2, 1),
            apart(40, 7),
            points(1, 1),
            points(30, 3),
            copies(4, 0),
            copies(16, 20),
            bars(12),
            bars(30),
            areas(1),
            areas(100),
            lines(1, 1),
            lines(30, 3),
        ]
    }

    #[test]
    fn what_is_planned_is_not_exceeded_and_is_the_limit() {
        for (k, proof) in proofs().iter().enumerate() {
            // The least limit within which it is taken.
            let (mut refused, mut taken) = (0, 1 << 40);
            while refused + 1 < taken {
                let most = u64::midpoint(refused, taken);
                let work = Work::at_most(most);
                match proof.check_within(&work) {
                    Ok(_) => taken = most,
                    Err(Refused::TooLarge { most: told, .. }) => {
                        // Before it begins.
                        assert_eq!((work.spent(), told), (0, most), "proof {k}");
                        refused = most;
                    }
                    Err(other) => panic!("proof {k}: {other}"),
                }
            }
            let work = Work::at_most(taken);
            assert!(proof.check_within(&work).is_ok() && taken < WORK, "proof {k}");
            let spent = work.spent();
            assert!(spent <= taken && taken <= 2 * spent, "proof {k}: {spent} of {taken}");
        }
    }

    fn spent(proof: &Proof) -> u64 {
        let work = Work::at_most(u64::MAX);
        proof.check_within(&work).unwrap();
        work.spent()
    }

    #[test]
    fn work_grows_as_the_certificate_does() {
        // Four times as many squares; twice the letters of numbers that grow with each.
        for (less, more, times) in [
            (copies(32, 0), copies(64, 0), 4),
            (copies(128, 0), copies(256, 0), 4),
            (apart(20, 500), apart(20, 2000), 4),
            (areas(500), areas(2000), 4),
            (points(1, 500), points(1, 2000), 4),
            (lines(1, 500), lines(1, 2000), 4),
            (points(200, 1), points(400, 1), 8),
            (exactly(points(1, 500), 5), exactly(points(1, 2000), 5), 4),
            (exactly(points(100, 1), 5), exactly(points(200, 1), 5), 8),
            (copies(4, 200), copies(4, 400), 8),
        ] {
            let (less, more) = (spent(&less), spent(&more));
            assert!(2 * more < 3 * times * less, "{less} {more}");
        }
    }

    #[test]
    fn what_is_too_large_is_refused_before_it_begins() {
        let too_large = |proof: Proof| {
            let work = Work::at_most(WORK);
            let why = proof.check_within(&work).unwrap_err();
            assert_eq!((why.code(), work.spent()), ("too-large", 0), "{why}");
            assert!(why.to_string().contains("the most that are checked is"), "{why}");
        };
        too_large(apart(1000, 4000));
        too_large(points(499, 2000));
        too_large(lines(499, 2000));
        too_large(copies(16, 999 * 2));
        too_large(areas(1_000_001));
        let change = |proof: Proof, change: &dyn Fn(&mut ConnectedCertificate)| match proof {
            Proof::Connected(mut certificate) => {
                change(&mut certificate);
                Proof::Connected(certificate)
            }
            other => other,
        };
        // Few, of very many digits.
        too_large(change(copies(4, 0), &|proof| {
            let squares = proof.squares.as_mut().unwrap();
            squares.cells = vec![squares.cells[0]; 100_001];
        }));
        too_large(change(copies(4, 999), &|proof| {
            proof.maps.iter_mut().for_each(|row| row[1] = f64::MIN_POSITIVE);
        }));
        too_large(change(points(450, 40), &|proof| proof.maps[0][1] = f64::MIN_POSITIVE));
        too_large(change(bars(30), &|proof| {
            proof.polygon = (0..512).map(|k| [f64::from(k), 0.0]).collect();
            proof.near = vec![proof.near[0].clone(); 2000];
        }));
        too_large(change(bars(900), &|proof| {
            let Link::Crossing { far, .. } = &mut proof.links[0] else { return };
            far[0].direction = [f64::MAX, f64::MIN_POSITIVE];
            proof.links = vec![proof.links[0].clone(); 800];
        }));
    }

    /// Each square leads back to all of them.
    #[test]
    fn squares_that_lead_to_all_squares_are_counted_once() {
        // Differences of 0, 2, .. 14 and 15, 31, .. 127 are all odd numbers between -128 and 128.
        const SIDE: i32 = 128;
        let places: Vec<i32> = (0..8).map(|k| 2 * k).chain((1..=8).map(|k| 16 * k - 1)).collect();
        let by = |odd: i32| {
            let found = (0..256).find(|k| places[k / 16] - places[k % 16] == odd).unwrap();
            [found / 16, found % 16]
        };
        let map = |k: usize| {
            let [x, y] = [k % 16, k / 16].map(|k| f64::from(places[k]) / 2.0);
            [1.0 / 128.0, 0.0, 0.0, 1.0 / 128.0, x, y]
        };
        let cell = |k: i32| {
            let (x, y) = (k % SIDE - SIDE / 2, k / SIDE - SIDE / 2);
            let [from, to] = [by(2 * x + 1), by(2 * y + 1)];
            (x, y, (16 * to[0] + from[0]) as u8, (16 * to[1] + from[1]) as u8)
        };
        let maps: Vec<[f64; 6]> = (0..256).map(map).collect();
        let squares = Squares { size: [1.0, 1.0], cells: (0..SIDE * SIDE).map(cell).collect() };
        let work = Work::at_most(WORK);
        let scene = crate::polygon::Scene::new(&maps, &SQUARE, &work).unwrap();
        let all = crate::difference::Differences::new(&scene, &squares).unwrap();
        assert_eq!(all.all_lead_back(&scene), Ok(true));
        // Looked at one by one, 16,384 squares would take a million for each.
        assert!(work.spent() < 10_000 * squares.cells.len() as u64, "{}", work.spent());
        // One less, and all lead out of what is left.
        let less = Squares { cells: squares.cells[1..].to_vec(), ..squares };
        let all = crate::difference::Differences::new(&scene, &less).unwrap();
        assert_eq!(all.all_lead_back(&scene), Ok(false));
    }
}
