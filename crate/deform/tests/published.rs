//! The repair of Fujimoto et al., section 5.3, computed anew from their eqs 4, 11 to 13 and 18.

mod common;

use common::{bumps, settings, twindragon, unit_mesh};
use frond_core::Affine2;
use frond_deform::{Bend, Continuity, Mesh, Settings, Spin};
use glam::{DMat2, DVec2};

/// A right gasket, whose pieces count alike.
fn gasket() -> Vec<Affine2> {
    [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f])).to_vec()
}

/// F_v: a Bezier interpolation of degree 3 over the box of the mesh, by its Bernstein polynomials.
fn displacement(mesh: &Mesh, point: DVec2) -> DVec2 {
    let (low, high) = mesh.bounds();
    let t = (point - low) / (high - low);
    let basis = |t: f64| {
        let s = 1.0 - t;
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
    };
    let (across, up) = (basis(t.x), basis(t.y));
    let products = up.iter().flat_map(|y| across.iter().map(move |x| x * y));
    mesh.displacements().iter().zip(products).map(|(d, share)| *d * share).sum()
}

/// The point of a code, and the middle of the shape behind it.
fn position(maps: &[Affine2], code: &[usize], middle: DVec2) -> DVec2 {
    code.iter().rev().fold(middle, |point, &letter| maps[letter].apply(point))
}

/// D_e-uni by its recursion (eq 4): letter k moves before letters kb + 1 to k - 1, for one k after the other.
fn shuffled(code: &[usize], kb: usize, ke: usize) -> Vec<usize> {
    let mut code = code.to_vec();
    for k in kb + 1..=ke {
        let letter = code.remove(k - 1);
        code.insert(kb, letter);
    }
    code
}

/// A bend as the paper has it.
struct Paper<'a> {
    maps: &'a [Affine2],
    mesh: &'a Mesh,
    middle: DVec2,
    kb: usize,
    ke: usize,
    delta: f64,
    turns: bool,
    superposed: bool,
}

impl Paper<'_> {
    /// The displacement of a point (eqs 12, 13 and 18, or 17), every term of it.
    fn at(&self, code: &[usize]) -> DVec2 {
        let &Self { maps, mesh, middle, kb, ke, delta, turns, superposed } = self;
        let powers: Vec<f64> = (0..=ke - kb).map(|j| delta.powi(j as i32)).collect();
        let all: f64 = powers.iter().sum();
        let mut sum = DVec2::ZERO;
        for (k, power) in (kb..).zip(&powers) {
            let weight = if superposed { power / all } else { f64::from(u8::from(k == ke)) };
            let mut v = displacement(mesh, position(maps, &shuffled(code, kb, k), middle));
            if turns {
                let turn: f64 =
                    code[kb..k].iter().map(|&i| maps[i].linear.x_axis.y.atan2(maps[i].linear.x_axis.x)).sum();
                v = DMat2::from_angle(turn) * v;
            }
            sum += v * weight;
        }
        sum
    }

    /// Step 1: the mean over the region of a word, by parts of it that are as small as `letters` more make them.
    fn average(&self, word: &[usize], letters: usize) -> DVec2 {
        let count = self.maps.len();
        let parts = count.pow(letters as u32);
        let mut sum = DVec2::ZERO;
        for number in 0..parts {
            let rest = (0..letters).map(|k| number / count.pow(k as u32) % count);
            let code: Vec<usize> = word.iter().copied().chain(rest).collect();
            sum += self.at(&code);
        }
        sum / parts as f64
    }
}

fn words(maps: usize, letters: usize) -> Vec<Vec<usize>> {
    (0..letters).fold(vec![Vec::new()], |words, _| {
        words.iter().flat_map(|word| (0..maps).map(move |letter| [&word[..], &[letter]].concat())).collect()
    })
}

#[test]
fn every_term_is_averaged_over_the_regions_and_interpolated_between_their_middles() {
    let dragon_mesh = Mesh::new(
        DVec2::splat(-1.2),
        DVec2::splat(1.6),
        4,
        4,
        unit_mesh(&bumps(0.03)).displacements().to_vec(),
    );
    let shapes = [
        (gasket(), unit_mesh(&bumps(0.03)), DVec2::splat(1.0 / 3.0), 7, Spin::None),
        (twindragon(), dragon_mesh.unwrap(), DVec2::new(0.5, 0.5), 11, Spin::Rotation),
    ];
    for (maps, mesh, guess, letters, spin) in shapes {
        // The middle of the shape: the mean of what the maps make of it.
        let mean = |p: DVec2| maps.iter().map(|map| map.apply(p)).sum::<DVec2>() / maps.len() as f64;
        let middle = (0..200).fold(guess, |p, _| mean(p));
        for (kb, ke, delta, superposed) in
            [(0, 3, 0.75, true), (1, 3, 1.0, true), (0, 2, 1.3, true), (2, 4, 0.5, true), (0, 3, 0.5, false)]
        {
            let turns = spin != Spin::None;
            let paper = Paper { maps: &maps, mesh: &mesh, middle, kb, ke, delta, turns, superposed };
            let of = |continuity| {
                let asked =
                    Settings { superposed, ..settings(kb as f64, ke as f64, delta, spin, continuity) };
                Bend::new(&maps, mesh.clone(), asked, None).unwrap()
            };
            let (published, variant) = (of(Continuity::Published), of(Continuity::Average));
            assert_eq!(published.continuity(), Continuity::Published);
            let moved = |bend: &Bend, at: DVec2| bend.point(&bend.whole(), at) - at;
            let mut apart = 0.0_f64;
            let mut values = Vec::new();
            for word in words(maps.len(), ke) {
                let at = position(&maps, &word, middle);
                let wanted = paper.average(&word, letters);
                let found = moved(&published, at);
                let near = found.distance(wanted);
                assert!(near < 1e-4 * published.reach(), "{kb} {ke} {word:?}: {found} {wanted}");
                apart = apart.max(moved(&variant, at).distance(wanted));
                values.push((at, wanted));
            }
            // The variant leaves what shuffles nothing exact, which shows wherever F_v is curved.
            assert!(!superposed || apart > 1e-3 * published.reach(), "{kb} {ke}: {apart}");
            if maps.len() == 3 {
                // Step 2: no other middle lies in the circle around those of one piece, so that they are a triangle.
                for three in values.chunks_exact(3) {
                    let shares = [0.2, 0.5, 0.3];
                    let blend = |pick: fn(&(DVec2, DVec2)) -> DVec2| -> DVec2 {
                        three.iter().zip(shares).map(|(pair, share)| pick(pair) * share).sum()
                    };
                    let (at, wanted) = (blend(|pair| pair.0), blend(|pair| pair.1));
                    let found = moved(&published, at);
                    assert!(found.distance(wanted) < 1e-4 * published.reach(), "{found} {wanted}");
                }
            }
        }
    }
}

#[test]
fn where_nothing_is_separated_nothing_is_averaged() {
    let mesh = unit_mesh(&bumps(0.03));
    for (kb, ke) in [(3.0, 3.0), (2.0, 3.0), (2.5, 3.0), (0.0, 0.0), (0.0, 1.0)] {
        let asked = settings(kb, ke, 0.75, Spin::None, Continuity::Published);
        let bend = Bend::new(&gasket(), mesh.clone(), asked, None).unwrap();
        for at in [DVec2::new(0.1, 0.2), DVec2::new(0.7, 0.05), DVec2::ZERO, DVec2::Y] {
            let found = bend.point(&bend.whole(), at) - at;
            assert!(found.distance(displacement(&mesh, at)) < 1e-12, "{kb} {ke}");
        }
    }
}
