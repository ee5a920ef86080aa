//! Barnsley's test, on the points of the attractor's orbit.

use frond_core::{Affine2, Hull, Ifs};
use glam::DVec2;

/// How long to iterate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BarnsleyOptions {
    /// The most iterations, the paper's n.
    pub iterations: usize,
    /// The most points in all pieces together: each iteration has as many times more as there are maps.
    pub points: usize,
}

impl Default for BarnsleyOptions {
    fn default() -> Self {
        Self { iterations: 8, points: 20_000 }
    }
}

/// One iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// The largest over the pieces of the least distance from its points to those of any other piece.
    pub distance: f64,
    /// How far points may be from the true pieces, twice: a piece farther than this from all others is apart.
    pub bound: f64,
}

/// The answer of [`barnsley_test`].
#[derive(Clone, Debug, PartialEq)]
pub struct BarnsleyTest {
    /// A piece that is apart from all others, which proves the attractor disconnected. `None` proves
    /// nothing: there may be none, or it takes more iterations to see it, or the pieces hang together in
    /// groups, which this test cannot see.
    pub apart: Option<usize>,
    /// What each iteration found, in the units of the coordinates in which the maps contract: those of the
    /// plane, unless [`frond_core::Contraction::to_round`] is other than the identity.
    pub rounds: Vec<Round>,
    /// Whether the next iteration would have taken more points than allowed.
    pub exhausted: bool,
}

/// Barnsley's test (Burch & Hart 1997, Fig 1): from one point, all words of n letters give points that come
/// nearer to every part of the attractor as n grows; when one piece's points are farther from all other
/// pieces' points than the error allows, the attractor is disconnected.
///
/// The distance is the least one, which is what their equation 4 means and not the Hausdorff distance. It is
/// measured in the norm in which the maps contract, as are their s and R: a map may well stretch in the
/// plane.
#[must_use]
pub fn barnsley_test(ifs: &Ifs, options: &BarnsleyOptions) -> BarnsleyTest {
    let contraction = ifs.contraction();
    let (to, from) = (contraction.to_round, contraction.from_round);
    let round = |map: &Affine2| Affine2::new(to * map.linear * from, to * map.translation);
    let maps: Vec<Affine2> = ifs.maps().iter().map(round).collect();
    let start = to * contraction.centre;
    // Two discs about the first point hold the attractor; the smaller serves.
    let corners = Hull::of(ifs);
    let farthest = corners.vertices().iter().map(|&v| (to * v).distance(start)).fold(0.0, f64::max);
    let radius = farthest.min(contraction.radius) * (1.0 + 1e-9);
    let rounding = 1e-13 * (start.length() + radius);

    let mut points = vec![start];
    let mut rounds = Vec::new();
    let mut test = |points: &[DVec2], bound: f64| {
        let mut pieces: Vec<Vec<DVec2>> =
            maps.iter().map(|map| points.iter().map(|&p| map.apply(p)).collect()).collect();
        for piece in &mut pieces {
            piece.sort_unstable_by(|p, q| p.x.total_cmp(&q.x));
        }
        let nearest = nearest_others(&pieces);
        let distance = nearest.iter().copied().fold(0.0, f64::max);
        rounds.push(Round { distance, bound });
        let apart = nearest.iter().position(|&d| d.is_finite() && d - rounding > bound);
        (apart, pieces.concat())
    };
    let mut apart = None;
    let mut exhausted = false;
    for n in 0..options.iterations {
        exhausted = points.len().saturating_mul(maps.len()) > options.points;
        if exhausted || maps.len() == 1 {
            break;
        }
        (apart, points) = test(&points, 2.0 * shrinkage(ifs, &maps, n + 1) * radius);
        if apart.is_some() {
            break;
        }
    }
    BarnsleyTest { apart, rounds, exhausted }
}

/// The largest factor by which a word of `letters` letters may scale distances, in round coordinates: s^n.
/// Where only longer blocks of maps contract, a word is made of whole blocks and the beginning of another.
fn shrinkage(ifs: &Ifs, maps: &[Affine2], letters: usize) -> f64 {
    let contraction = ifs.contraction();
    let growth = maps.iter().map(|map| map.norm()).fold(1.0, f64::max);
    let rest = contraction.length - 1;
    growth.powi(rest as i32) * contraction.factor.powi((letters / contraction.length) as i32)
}

/// For each list of points, sorted by x, the least distance to a point of another list.
fn nearest_others(pieces: &[Vec<DVec2>]) -> Vec<f64> {
    let mut nearest = vec![f64::INFINITY; pieces.len()];
    for i in 0..pieces.len() {
        for j in i + 1..pieces.len() {
            let least = least_distance(&pieces[i], &pieces[j]);
            nearest[i] = nearest[i].min(least);
            nearest[j] = nearest[j].min(least);
        }
    }
    nearest
}

/// The least distance between points of two lists sorted by x: a sweep that looks only as far to the
/// sides as the best distance so far.
fn least_distance(p: &[DVec2], q: &[DVec2]) -> f64 {
    let mut best = f64::INFINITY;
    let mut start = 0;
    for a in p {
        while start < q.len() && (a.x - q[start].x) * (a.x - q[start].x) > best && q[start].x < a.x {
            start += 1;
        }
        for b in &q[start..] {
            let across = b.x - a.x;
            if across > 0.0 && across * across > best {
                break;
            }
            best = best.min(a.distance_squared(*b));
        }
    }
    best.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gasket(scale: f64) -> Vec<Affine2> {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        corners.map(|c| Affine2::similitude(scale, 0.0, c * (1.0 - scale))).to_vec()
    }

    fn test(maps: Vec<Affine2>) -> BarnsleyTest {
        barnsley_test(&Ifs::new(maps).unwrap(), &BarnsleyOptions::default())
    }

    #[test]
    fn small_gaskets_fall_apart_and_the_bound_closes_in() {
        let small = test(gasket(0.4));
        assert!(small.apart.is_some() && small.rounds.len() < 5, "{small:?}");
        let bounds = |t: &BarnsleyTest| t.rounds.iter().map(|r| r.bound).collect::<Vec<_>>();
        let larger = test(gasket(0.49));
        assert!(larger.rounds.len() > small.rounds.len());
        let whole = test(gasket(0.5));
        assert!(whole.apart.is_none() && whole.rounds.len() == 8, "{whole:?}");
        assert!(bounds(&whole).windows(2).all(|w| (w[1] / w[0] - 0.5).abs() < 1e-12));
        assert!(whole.rounds.iter().all(|r| r.distance <= r.bound));
    }

    #[test]
    fn the_sheared_gasket_gives_the_same_answer() {
        let shear = Affine2::from_row([1.0, 40.0, 0.0, 1.0, 3.0, -2.0]);
        for (scale, apart) in [(0.4, true), (0.5, false)] {
            let turned = gasket(scale).into_iter().enumerate();
            let turned = turned.map(|(k, m)| {
                Affine2::new(m.linear * glam::DMat2::from_angle(k as f64 * 2.0), m.translation)
            });
            let plain: Vec<_> = turned.collect();
            let sheared: Vec<_> = plain.iter().map(|m| m.conjugate(shear).unwrap()).collect();
            assert!(sheared.iter().any(|m| m.norm() > 7.0));
            if apart {
                assert!(test(plain).apart.is_some() && test(sheared).apart.is_some());
            } else {
                assert_eq!(test(plain).apart, test(sheared).apart);
            }
        }
    }

    #[test]
    fn pairs_of_pieces_are_what_it_cannot_see() {
        // Two columns of two touching pieces: apart, but no piece alone is.
        let third = 1.0 / 3.0;
        let rows = [[0.0, 0.0], [2.0 * third, 0.0], [0.0, 0.5], [2.0 * third, 0.5]];
        let maps = rows.map(|[e, f]| Affine2::from_row([third, 0.0, 0.0, 0.5, e, f]));
        let found = test(maps.to_vec());
        assert_eq!(found.apart, None);
        assert!(found.exhausted || found.rounds.len() == 8);
    }

    #[test]
    fn one_map_one_point_and_no_iterations() {
        assert_eq!(test(gasket(0.5)[..1].to_vec()).apart, None);
        assert_eq!(test(vec![Affine2::similitude(0.0, 0.0, DVec2::X); 3]).apart, None);
        let none =
            barnsley_test(&Ifs::new(gasket(0.3)).unwrap(), &BarnsleyOptions { iterations: 0, points: 9 });
        assert_eq!((none.apart, none.rounds.len()), (None, 0));
        let capped =
            barnsley_test(&Ifs::new(gasket(0.5)).unwrap(), &BarnsleyOptions { iterations: 50, points: 100 });
        assert!(capped.exhausted && capped.rounds.len() == 4, "{capped:?}");
    }

    #[test]
    fn the_sweep_finds_what_comparing_all_finds() {
        let cloud = |seed: u32| {
            let at = |i| f64::from(frond_core::hash::unit(frond_core::hash::counter(seed, i)));
            let mut points: Vec<_> = (0..200).map(|i| DVec2::new(at(2 * i), at(2 * i + 1))).collect();
            points.sort_unstable_by(|p, q| p.x.total_cmp(&q.x));
            points
        };
        for seed in 0..20 {
            let (p, q) = (cloud(seed), cloud(seed + 100));
            let all = p.iter().flat_map(|a| q.iter().map(|b| a.distance(*b))).fold(f64::INFINITY, f64::min);
            assert!((least_distance(&p, &q) - all).abs() < 1e-15);
        }
    }
}
