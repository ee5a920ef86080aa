//! Every proof of disconnection is accepted by the checker, and none is made of what is connected.

use frond_check::{Pair, Refused, check};
use frond_core::{Affine2, Ifs, hash};
use frond_locus::{Certificate, Options, Verdict, certificate, connected_certificate, connectedness};
use frond_testing::cases;
use glam::{DMat2, DVec2};

/// The certificate in the checker's own terms.
fn plain(found: &Certificate) -> frond_check::Certificate {
    let pair = |pair: &frond_locus::Separation| Pair {
        u: pair.u.clone(),
        v: pair.v.clone(),
        normal: pair.normal.to_array(),
    };
    frond_check::Certificate {
        maps: found.maps.clone(),
        polygon: found.polygon.iter().map(|p| p.to_array()).collect(),
        letters: found.letters,
        side: found.side.clone(),
        pairs: found.pairs.iter().map(pair).collect(),
        exact: None,
    }
}

/// Random numbers that are the same on every run.
struct Dice {
    seed: u32,
    count: u32,
}

impl Dice {
    fn roll(&mut self) -> f64 {
        self.count += 1;
        f64::from(hash::counter(self.seed, self.count)) / f64::from(u32::MAX)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }

    fn below(&mut self, count: usize) -> usize {
        (self.roll() * count as f64) as usize
    }

    /// Similitudes, mirrored ones, general maps, singular ones, ones that hardly shrink.
    fn map(&mut self) -> Affine2 {
        let shift = DVec2::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0));
        match self.below(12) {
            0 => Affine2::similitude(self.between(0.9, 0.998), self.between(0.0, 6.3), shift),
            1 => Affine2::from_row([
                self.between(-0.7, 0.7),
                0.0,
                self.between(-0.7, 0.7),
                0.0,
                shift.x,
                shift.y,
            ]),
            2..=5 => {
                let row = [0; 4].map(|_| self.between(-0.6, 0.6));
                Affine2::from_row([row[0], row[1], row[2], row[3], shift.x, shift.y])
            }
            6 => {
                let turned =
                    Affine2::similitude(self.between(0.2, 0.6), self.between(0.0, 6.3), shift).to_row();
                let [a, b, c, d, e, f] = turned;
                Affine2::from_row([a, -b, c, -d, e, f])
            }
            _ => Affine2::similitude(self.between(0.2, 0.6), self.between(0.0, 6.3), shift),
        }
    }

    /// A system that has an attractor; one in three is seen in sheared coordinates, where maps have large norms.
    fn system(&mut self) -> Option<Ifs> {
        let count = 2 + self.below(4);
        let mut maps: Vec<Affine2> = (0..count).map(|_| self.map()).collect();
        if self.below(3) == 0 {
            let shear = 10.0_f64.powf(self.between(0.0, 2.5));
            let turn = Affine2::similitude(1.0, self.between(0.0, 6.3), DVec2::ZERO);
            let place = self.between(-5.0, 5.0);
            let by = turn * Affine2::from_row([1.0, shear, 0.0, 1.0, place, 1.0]);
            maps = maps.iter().map(|map| map.conjugate(by)).collect::<Option<_>>()?;
        }
        Ifs::new(maps).ok()
    }
}

/// What a run of many systems gave.
#[derive(Default)]
struct Tally {
    disconnected: u32,
    sheared: u32,
    pairs: Vec<usize>,
    longest: usize,
    /// Those without a certificate, with their relative gaps.
    without: Vec<(u32, f64)>,
}

impl Tally {
    /// Asks for the verdict and the certificate of a system, and has it checked.
    fn add(&mut self, seed: u32, ifs: &Ifs, options: &Options) {
        let answer = connectedness(ifs, options);
        let found = certificate(ifs, options);
        let checked = found
            .as_ref()
            .map(|found| check(&plain(found)).unwrap_or_else(|why| panic!("{seed}: {why} {:?}", ifs.maps())));
        let connected = connected_certificate(ifs, options);
        assert!(connected.is_none() || answer.verdict != Verdict::Disconnected, "{seed}: {answer:?}");
        if answer.verdict != Verdict::Disconnected {
            assert!(found.is_none(), "{seed}: {answer:?}");
            return;
        }
        self.disconnected += 1;
        self.sheared += u32::from(ifs.maps().iter().any(|map| map.norm() > 1.5));
        let (Some(found), Some(checked)) = (found, checked) else {
            self.without.push((seed, answer.gap.lower / answer.diameter));
            return;
        };
        self.pairs.push(checked.pairs);
        self.longest = self.longest.max(checked.longest);
        // The cut parts none of the components.
        for (a, side) in answer.components.iter().zip(&found.side) {
            for (b, other) in answer.components.iter().zip(&found.side) {
                assert!(a != b || side == other, "{seed}: {answer:?} {:?}", found.side);
            }
        }
    }

    fn show(&mut self, name: &str) {
        self.pairs.sort_unstable();
        let share = |part: usize| self.pairs.get(self.pairs.len() * part / 100).copied().unwrap_or(0);
        println!(
            "{name}: {} disconnected, {} of norm above 1.5, {} without certificate {:?}; pairs: median {}, of 99 in 100 {}, most {:?}; longest word {}",
            self.disconnected,
            self.sheared,
            self.without.len(),
            self.without,
            share(50),
            share(99),
            self.pairs.last(),
            self.longest
        );
    }
}

#[test]
fn every_disconnected_verdict_has_a_certificate() {
    let (mut tally, count) = (Tally::default(), cases(150));
    for seed in 0..count {
        if let Some(ifs) = (Dice { seed, count: 0 }).system() {
            tally.add(seed, &ifs, &Options { epsilon: 1e-5, budget: 30_000 });
        }
    }
    tally.show("random");
    assert!(2 * tally.disconnected > count && 8 * tally.sheared > count && tally.without.is_empty());
}

/// Two to five copies on a polygon, a little too small to meet, moved, turned and sheared: gaps of 1e-2 to 1e-11.
#[test]
fn narrow_gaps_have_certificates_down_to_rounding() {
    let (mut tally, count) = (Tally::default(), cases(30));
    for seed in 0..count {
        let mut dice = Dice { seed: 77_000 + seed, count: 0 };
        let corners = 2 + dice.below(4);
        let critical = if corners < 5 { 0.5 } else { 1.5 - 5.0_f64.sqrt() / 2.0 };
        let scale = critical * (1.0 - 10.0_f64.powf(dice.between(-11.0, -2.0)));
        let corner = |k: usize| DVec2::from_angle(std::f64::consts::TAU * k as f64 / corners as f64);
        let shear = Affine2::from_row([1.0, dice.between(-9.0, 9.0), 0.3, 1.0, dice.between(-9.0, 9.0), 1.0]);
        let maps = (0..corners).map(|k| Affine2::similitude(scale, 0.0, corner(k) * (1.0 - scale)));
        let Some(maps) = maps.map(|map| map.conjugate(shear)).collect::<Option<Vec<_>>>() else { continue };
        tally.add(seed, &Ifs::new(maps).unwrap(), &Options { epsilon: 0.0, budget: 100_000 });
    }
    tally.show("narrow");
    // Squares nearly touch all along an edge: that takes as many pairs as gaps fit on it, and more than the budget.
    assert!(4 * tally.disconnected > 3 * count && 100 * tally.without.len() <= count as usize);
}

impl Dice {
    fn pick(&mut self, of: &[f64]) -> f64 {
        of[self.below(of.len())]
    }

    /// A number of few binary digits.
    fn short(&mut self, most: f64, digits: i32) -> f64 {
        let scale = 2.0_f64.powi(digits);
        (self.between(-most, most) * scale).round() / scale
    }

    /// A linear part of one of ten kinds: similar, slow, any, short, defective, of numbers of very different sizes,
    /// triangular, singular, flat, diagonal.
    fn part(&mut self, kind: usize) -> [f64; 4] {
        let turned = |scale: f64, angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [scale * cos, -scale * sin, scale * sin, scale * cos]
        };
        match kind {
            0 => turned(self.between(0.05, 0.8), self.between(0.0, 6.3)),
            1 => turned(self.between(0.9, 0.9999), self.between(0.0, 6.3)),
            2 => [0; 4].map(|_| self.between(-0.6, 0.6)),
            3 => [0; 4].map(|_| self.short(1.0, 2)),
            4 => {
                let value = self.pick(&[0.25, 0.5, 0.1, -0.3, 0.7, 0.9]);
                let (sin, cos) = self.between(0.0, 6.3).sin_cos();
                let shear = 10.0_f64.powf(self.between(-1.0, 3.0));
                [value - shear * cos * sin, shear * cos * cos, -shear * sin * sin, value + shear * sin * cos]
            }
            5 => {
                let large = 2.0_f64.powi(self.below(24) as i32 - 4);
                let [a, d] = [0; 2].map(|_| self.short(0.5, 4));
                [a, self.short(1.0, 3) * large, self.short(1.0, 3) / large, d]
            }
            6 => [self.between(0.1, 0.9), self.between(-5.0, 5.0), 0.0, self.between(-0.9, 0.9)],
            7 => {
                let (a, b, by) = (self.between(-0.7, 0.7), self.between(-0.7, 0.7), self.between(-2.0, 2.0));
                [a, a * by, b, b * by]
            }
            8 => [self.between(-0.6, 0.6), 0.0, 0.0, self.between(-0.01, 0.01)],
            _ => [self.between(0.05, 0.9), 0.0, 0.0, self.between(0.05, 0.9)],
        }
    }

    /// Two to six maps of parts alike or not, of coefficients small and large, drawn out, sheared and moved far.
    fn odd_system(&mut self) -> Option<Ifs> {
        let (count, kind) = (2 + self.below(5), self.below(10));
        let (mixed, same, whole) = (self.below(3) == 0, self.below(3) == 0, self.below(2) == 0);
        let size = self.pick(&[1.0, 1.0, 1e-3, 1e3, 1e5, 131_072.0, 1e8]);
        let far = self.pick(&[0.0, 0.0, 10.0, 1e4]);
        let small = self.pick(&[1.0, 1.0, 0.5, 0.3]);
        let shared = self.part(kind);
        let mut map = || {
            let kind = if mixed { self.below(10) } else { kind };
            let [a, b, c, d] = if same { shared } else { self.part(kind) };
            let mut shift = || {
                let x = self.between(-4.0, 4.0);
                size * if whole { x.round() } else { x }
            };
            Affine2::from_row([a, b, c, d, shift(), shift()].map(|x| x * small))
        };
        let mut maps: Vec<Affine2> = (0..count).map(|_| map()).collect();
        let long = 10.0_f64.powf(self.between(0.0, 4.0));
        let turn = Affine2::similitude(1.0, self.between(0.0, 6.3), DVec2::new(far, -far));
        let by = match self.below(6) {
            0 => turn * Affine2::from_row([1.0, long, 0.0, 1.0, 0.0, 1.0]),
            1 => Affine2::from_row([long, 0.0, 0.0, 1.0, far, 0.0]),
            2 => turn * Affine2::from_row([long, 0.0, 0.0, 1.0, 0.0, 0.0]),
            _ => Affine2::IDENTITY,
        };
        maps = maps.iter().map(|map| map.conjugate(by)).collect::<Option<_>>()?;
        Ifs::new(maps).ok()
    }
}

#[test]
fn flat_sheared_and_defective_systems_have_certificates() {
    let (mut tally, count) = (Tally::default(), cases(200));
    for seed in 0..count {
        if let Some(ifs) = (Dice { seed: 99_000 + seed, count: 0 }).odd_system() {
            tally.add(seed, &ifs, &Options::default());
        }
    }
    tally.show("odd");
    // Narrower ones may take more pairs than the budget.
    tally.without.retain(|&(_, gap)| gap > 1e-6);
    assert!(3 * tally.disconnected > count && tally.without.is_empty(), "{:?}", tally.without);
}

/// Hardly any contraction, or only in long words.
#[test]
fn slow_systems_have_certificates() {
    let (mut tally, count) = (Tally::default(), cases(100));
    for seed in 0..count {
        let mut dice = Dice { seed: 88_000 + seed, count: 0 };
        let small = |dice: &mut Dice| {
            Affine2::similitude(
                dice.between(0.001, 0.2),
                dice.between(0.0, 6.3),
                DVec2::new(dice.between(-1.0, 1.0), 1.0),
            )
        };
        let maps = if seed % 2 == 0 {
            let slow = 1.0 - 10.0_f64.powf(dice.between(-3.5, -1.0));
            vec![Affine2::similitude(slow, dice.between(0.0, 6.3), DVec2::ZERO), small(&mut dice)]
        } else {
            // Each shrinks in the long run and stretches at first; together they need words of two to many letters.
            let (p, q) = (dice.between(0.5, 4.0), dice.between(0.0, 0.3));
            let r = dice.between(0.2, 0.99) / p;
            vec![
                Affine2::from_row([q, p, 0.0, q * 0.5, 0.0, 0.0]),
                Affine2::from_row([q * 0.3, 0.0, r, q, 1.0, dice.between(-1.0, 1.0)]),
            ]
        };
        if let Ok(ifs) = Ifs::new(maps) {
            tally.add(seed, &ifs, &Options { epsilon: 1e-6, budget: 60_000 });
        }
    }
    tally.show("slow");
    assert!(6 * tally.disconnected > count);
}

/// From 1e-289 to 1e93, the translations ten thousand times as long.
#[test]
fn a_shape_of_any_size_has_a_certificate() {
    let (mut tally, mut tried) = (Tally::default(), 0);
    for seed in 0..200 {
        let Some(ifs) = (Dice { seed: 66_000 + seed, count: 0 }).system() else { continue };
        let options = Options { epsilon: 1e-5, budget: 30_000 };
        if certificate(&ifs, &options).is_none() {
            continue;
        }
        for power in [-960, -700, -520, -340, 200, 290, 310] {
            let large = |x: f64| x * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2);
            let row = |map: &Affine2| {
                Affine2::new(map.linear, DVec2::from_array(map.translation.to_array().map(large)))
            };
            tally.add(seed, &Ifs::new(ifs.maps().iter().map(row).collect()).unwrap(), &options);
            tried += 1;
        }
    }
    tally.show("of any size");
    assert!(tried > 400 && tally.disconnected == tried && tally.without.is_empty());
}

#[test]
fn what_is_known_to_be_connected_gets_none() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/known/connectedness.json"));
    let known: serde_json::Value = serde_json::from_str(&text.unwrap()).unwrap();
    for case in known["cases"].as_array().unwrap() {
        let rows: Vec<[f64; 6]> = serde_json::from_value(case["maps"].clone()).unwrap();
        let ifs = Ifs::new(rows.into_iter().map(Affine2::from_row).collect()).unwrap();
        let found = certificate(&ifs, &Options { epsilon: 0.0, budget: 100_000 });
        assert_eq!(found.is_some(), case["truth"] == "disconnected", "{}", case["name"]);
        if let Some(found) = found {
            let checked = check(&plain(&found)).unwrap();
            println!(
                "{}: {} pairs, words of at most {} letters",
                case["name"], checked.pairs, checked.longest
            );
        }
    }
}

/// Proofs that were found, changed in one place.
#[test]
fn mutants_are_refused() {
    let mut kinds = std::collections::BTreeMap::new();
    let count = cases(60);
    for seed in 0..count {
        let mut dice = Dice { seed, count: 0 };
        let Some(ifs) = dice.system() else { continue };
        let Some(found) = certificate(&ifs, &Options { epsilon: 1e-5, budget: 30_000 }) else { continue };
        let proof = plain(&found);
        check(&proof).unwrap();
        let k = dice.below(proof.pairs.len());
        let map = dice.below(proof.maps.len());
        let corner = dice.below(proof.polygon.len());
        let mut refuse = |name: &'static str, change: &dyn Fn(&mut frond_check::Certificate)| {
            let mut mutant = proof.clone();
            change(&mut mutant);
            let why: Refused = check(&mutant).expect_err(name);
            *kinds.entry((name, why.code())).or_insert(0) += 1;
        };
        refuse("pair removed", &|c| {
            c.pairs.remove(k);
        });
        refuse("direction turned round", &|c| c.pairs[k].normal = c.pairs[k].normal.map(|x| -x));
        refuse("direction of no length", &|c| c.pairs[k].normal = [0.0; 2]);
        refuse("words exchanged", &|c| {
            let pair = &mut c.pairs[k];
            std::mem::swap(&mut pair.u, &mut pair.v);
        });
        refuse("letter beyond the maps", &|c| c.pairs[k].v.push(c.maps.len() as u8));
        refuse("word longer", &|c| c.pairs[k].v.push(0));
        refuse("map that does not shrink", &|c| c.maps[map] = [1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        refuse("map far away", &|c| c.maps[map][4] += 1e6);
        refuse("number that is none", &|c| c.maps[map][dice.count as usize % 6] = f64::NAN);
        refuse("polygon clockwise", &|c| c.polygon.reverse());
        refuse("corner twice", &|c| c.polygon.insert(corner, c.polygon[corner]));
        refuse("corner drawn in", &|c| {
            let count = c.polygon.len() as f64;
            let sum = c.polygon.iter().fold([0.0; 2], |sum, p| [sum[0] + p[0], sum[1] + p[1]]);
            c.polygon[corner] = sum.map(|x| x / count);
        });
        refuse("polygon shrunk to a tenth", &|c| {
            let first = c.polygon[corner];
            for p in &mut c.polygon {
                *p = [0, 1].map(|k| first[k] + 0.1 * (p[k] - first[k]));
            }
        });
        refuse("sides exchanged", &|c| c.side.iter_mut().for_each(|s| *s = 1 - *s));
        refuse("no cut", &|c| c.side.fill(1));
        refuse("one map the other side", &|c| c.side[map] = 1 - c.side[map]);
        refuse("a map more", &|c| {
            c.maps.push(c.maps[0]);
            c.side.push(1 - c.side[0]);
        });
        refuse("no pairs", &|c| c.pairs.clear());
    }
    for ((name, code), count) in &kinds {
        println!("{count:5}  {name}: {code}");
    }
    assert!(kinds.len() >= 18 && kinds.values().sum::<u32>() > 7 * count);
}

/// The maps in coordinates that are stretched along both axes by powers of two.
fn stretched(maps: &[Affine2], [x, y]: [i32; 2]) -> Vec<Affine2> {
    let [x, y] = [x, y].map(|power| 2.0_f64.powi(power));
    let row = |map: &Affine2| {
        let [a, b, c, d, e, f] = map.to_row();
        Affine2::from_row([a, b * (x / y), c * (y / x), d, e * x, f * y])
    };
    maps.iter().map(row).collect()
}

#[test]
fn stretched_shapes_have_certificates() {
    // Thirds of quarter turns, in coordinates of their own.
    let (b, c) = (5_726_623_061.333_333, 1.940_255_363_782_246_8e-11);
    let (e, f) = (699_050.666_666_666_6, 4.069_010_416_666_666_4e-5);
    let found = [[0.0, -b, c, 0.0, -e, 0.0], [0.0, b, -c, 0.0, e, 0.0], [0.0, b, c, 0.0, -e, f]];
    let mut all = vec![found.map(Affine2::from_row).to_vec()];
    let mut dice = Dice { seed: 12, count: 0 };
    for k in 0..cases(60) as i32 {
        let turned = |dice: &mut Dice| {
            let quarter = [[0.0, -1.0, 1.0, 0.0], [1.0, 0.0, 0.0, -1.0], [0.0, 1.0, 1.0, 0.0]][dice.below(3)];
            let scale = dice.between(0.2, 0.35);
            let [p, q, r, s] = quarter.map(|x| x * scale);
            Affine2::from_row([p, q, r, s, dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)])
        };
        let maps: Vec<Affine2> = (0..3).map(|_| turned(&mut dice)).collect();
        all.push(stretched(&maps, [k % 60 - 20, (17 * k) % 60 - 30]));
    }
    let mut apart = 0;
    for maps in all {
        let Ok(ifs) = Ifs::new(maps.clone()) else { continue };
        let answer = connectedness(&ifs, &Options::default());
        if answer.verdict != Verdict::Disconnected {
            continue;
        }
        apart += 1;
        let found = certificate(&ifs, &Options::default());
        let found =
            found.unwrap_or_else(|| panic!("no certificate: {maps:?} {:?} {}", answer.gap, answer.diameter));
        assert!(check(&plain(&found)).is_ok(), "{maps:?}: {:?}", check(&plain(&found)));
    }
    assert!(apart > 30, "{apart}");
}

/// The verdict may come of few looks where pairs for a certificate take more.
#[test]
fn flat_copies_that_come_near_have_certificates_however_small_the_budget() {
    let mut dice = Dice { seed: 8, count: 0 };
    let mut gaps = Vec::new();
    for k in 0..cases(150) {
        let (wide, high) = (dice.between(0.2, 1.0), dice.between(0.05, 0.5));
        let copy = |_| {
            let shift = DVec2::new(dice.between(-wide, wide), dice.between(-high, high));
            Affine2::new(DMat2::from_diagonal(DVec2::new(0.328_125, 0.738_148_05)), shift)
        };
        let ifs = Ifs::new((0..8).map(copy).collect()).unwrap();
        let of = |budget: usize| connectedness(&ifs, &Options { budget, ..Options::default() });
        // The least that is enough for the verdict.
        let (mut less, mut enough) = (0, 20_000);
        if of(enough).verdict != Verdict::Disconnected {
            continue;
        }
        while enough - less > 1 {
            let budget = usize::midpoint(less, enough);
            if of(budget).verdict == Verdict::Disconnected { enough = budget } else { less = budget }
        }
        let answer = of(enough);
        gaps.push(answer.gap.lower / answer.diameter);
        let found = certificate(&ifs, &Options { budget: enough, ..Options::default() });
        let found = found.unwrap_or_else(|| panic!("{k}, {enough} looks: {:?}", answer.gap));
        assert!(check(&plain(&found)).is_ok(), "{k}: {:?}", check(&plain(&found)));
    }
    gaps.sort_by(f64::total_cmp);
    assert!(gaps.len() > 10 && gaps[0] < 0.02, "{gaps:?}");
}
