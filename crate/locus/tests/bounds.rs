//! What the fast answer says it has proved: the bounds of the widest gap, and the ellipse around the attractor.

use frond_core::{Affine2, Ifs, hash};
use frond_locus::{Components, Options, Scratch, State, connectedness, decide, decide_bounds};
use glam::{DMat2, DVec2};

/// A number from -1 to 1.
fn number(seed: u32, index: u32) -> f64 {
    f64::from(hash::counter(seed, index)) / f64::from(u32::MAX) * 2.0 - 1.0
}

/// Some maps, most of them contractions; a third of the systems sheared.
fn system(seed: u32) -> Vec<Affine2> {
    let count = 2 + hash::counter(seed, 100) % 4;
    let size = 0.45 + 0.35 * number(seed, 101);
    let shear = if seed.is_multiple_of(3) { 9.0 * number(seed, 102) } else { 0.0 };
    let by = Affine2::new(DMat2::from_cols(DVec2::X, DVec2::new(shear, 1.0)), DVec2::new(3.0, shear));
    let map = |i: u32| {
        let at = |k| number(seed, 6 * i + k);
        let linear = DMat2::from_cols(DVec2::new(at(0), at(1)), DVec2::new(at(2), at(3)));
        let linear = if seed.is_multiple_of(2) { linear } else { DMat2::from_angle(3.0 * at(0)) };
        Affine2::new(linear * size, DVec2::new(at(4), at(5))).conjugate(by)
    };
    (0..count).filter_map(map).collect()
}

fn points(maps: &[Affine2], count: u32) -> Vec<DVec2> {
    let mut x = maps[0].fixed_point().unwrap_or(DVec2::ZERO);
    (0..count)
        .map(|i| {
            x = maps[hash::counter(5, i) as usize % maps.len()].apply(x);
            x
        })
        .collect()
}

/// The widest edge of the least spanning tree between the pieces, as far as some of their points show it: it is
/// never less than the widest gap.
fn seen(maps: &[Affine2], points: &[DVec2]) -> f64 {
    let clouds: Vec<Vec<DVec2>> =
        maps.iter().map(|map| points.iter().map(|&p| map.apply(p)).collect()).collect();
    let least = |i: usize, j: usize| {
        let all = clouds[i].iter().flat_map(|p| clouds[j].iter().map(|q| p.distance_squared(*q)));
        all.fold(f64::INFINITY, f64::min).sqrt()
    };
    let mut edges: Vec<(f64, usize, usize)> =
        (0..maps.len()).flat_map(|i| (i + 1..maps.len()).map(move |j| (least(i, j), i, j))).collect();
    edges.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut components = Components::new(maps.len());
    edges.into_iter().filter(|&(_, i, j)| components.join(i, j)).map(|(d, ..)| d).fold(0.0, f64::max)
}

#[test]
fn bounds_hold_the_gap_and_the_ellipse_the_attractor() {
    let mut scratch = Scratch::default();
    let (mut counts, count) = ([0; 5], frond_testing::cases(80));
    for seed in 0..count {
        let maps = system(seed);
        let Ok(ifs) = Ifs::new(maps.clone()) else { continue };
        for (epsilon, budget) in [(1e-3, 20_000), (1e-6, 20_000), (1e-12, 4)] {
            let known = decide_bounds(&maps, epsilon, budget, &mut scratch);
            let context = format!("{seed}: {known:?}");
            counts[known.sample.state as usize] += 1;
            let sample = decide(&maps, epsilon, budget, &mut Scratch::default());
            assert_eq!(
                (sample.state, sample.gap.to_bits()),
                (known.sample.state, known.sample.gap.to_bits())
            );
            assert!(0.0 <= known.lower && known.lower <= known.upper, "{context}");
            assert!(known.lower == 0.0 || known.sample.state == State::Disconnected, "{context}");
            if known.sample.state == State::Touching {
                assert!(known.upper <= epsilon * 1.0001, "{context}");
            }
            // What others find lies between the bounds.
            let full = connectedness(&ifs, &Options { epsilon: epsilon / 10.0, budget: 50_000 });
            assert!(full.gap.lower <= known.upper * known.diameter * (1.0 + 1e-12), "{context} {full:?}");
            let cloud = points(&maps, 300);
            assert!(known.lower * known.diameter <= seen(&maps, &cloud), "{context}");
            let ellipse = known.ellipse.expect("an attractor");
            for &p in &cloud {
                assert!((ellipse.to_round * (p - ellipse.centre)).length() <= 1.0 + 1e-9, "{context}");
                let far = cloud.iter().map(|q| p.distance(*q)).fold(0.0, f64::max);
                assert!(far <= known.diameter * (1.0 + 1e-9), "{context}");
            }
            if ellipse.length == 1 {
                for map in &maps {
                    let round = Affine2::new(ellipse.to_round * map.linear * ellipse.from_round, DVec2::ZERO);
                    assert!(round.norm() <= ellipse.factor * (1.0 + 1e-9), "{context}");
                }
            }
        }
    }
    assert!(3 * counts[1] > count && 3 * counts[2] > count && 15 * counts[3] > count, "{counts:?}");
}
