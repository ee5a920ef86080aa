//! Chains of pieces that join end to end, and morphs that keep every joint.
//!
//! Maps `f_1 .. f_n` are a *zipper* with the ends `s` and `e` and the signature `r` if each `f_k` takes the two ends to
//! `z_(k-1)` and `z_k`, in this order or, where `r_k`, in the other, with `z_0 = s` and `z_n = e` (Aseev, Tetenov &
//! Kravchenko, *On selfsimilar Jordan curves on the plane*, 2003). Koch's curve, Heighway's dragon and Levy's curve are
//! the attractors of zippers; so are the gasket (as the arrowhead curve), the carpet and others, once some of their
//! maps are followed by a symmetry of the shape, which changes no piece.
//!
//! *A zipper that contracts has a connected attractor*: `s` is `f_1` of an end and `e` is `f_n` of one, so that the set
//! of both lies in its own image, and hence in the attractor; neighbours `f_k`, `f_(k+1)` then share the point `z_k`,
//! and pieces of which each shares a point with the next are a connected overlap graph (Hata 1985).
//!
//! *Two zippers with the same ends and signature stay one on the whole straight way between them.* What is asked of the
//! maps, `f_k(s) = f_(k+1)(e)` and its like, is linear in their six numbers, so it holds for `(1 - t) f_k + t g_k`
//! where it holds for `f_k` and `g_k`; a norm in which both contract is convex, so these contract as well.
//! Similarities contract in the usual one. This is the morph of mode [`Linear`](crate::Mode::Linear) along u = v. A
//! similarity takes the ends of any zipper to those of another.

use std::collections::HashSet;

use glam::DVec2;

use crate::ifs::symmetry::symmetries;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::morph::chains::{Grid, chains, ends};
use crate::morph::pairing::{Weighted, refined};
use crate::morph::upright::{Laying, layings};

/// A zipper: maps in their order along the chain.
#[derive(Clone, Debug)]
pub(crate) struct Zipper {
    /// The maps, each maybe after a symmetry of the attractor, and their probabilities.
    pub maps: Vec<Weighted>,
    /// Whether each runs through its piece from its end to its start.
    pub reversed: Vec<bool>,
    /// Start and end.
    pub ends: [DVec2; 2],
    /// A symmetry of the attractor that exchanges start and end, where there is one: it reverses any map.
    flip: Option<Affine2>,
}

/// Two zippers of one signature and with the same ends.
#[derive(Clone, Debug)]
pub(crate) struct Joined {
    /// The maps of the first.
    pub from: Vec<Weighted>,
    /// The maps of the last, which may lie elsewhere than it did.
    pub to: Vec<Weighted>,
    /// The similarity that lays it there, if it had to be.
    pub place: Option<Affine2>,
}

/// What two lists of maps of one length have in common, if both are zippers in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Joints {
    /// Start and end of both.
    pub ends: [DVec2; 2],
    /// The signature of both: whether each map runs from its end to its start.
    pub reversed: Vec<bool>,
}

/// The joints that two lists of maps have in common, to rounding: each map of the one becomes that of the same place in
/// the other, and all joints stay joined on the straight way between them (the top of this file proves it).
#[must_use]
pub fn joints(from: &[Affine2], to: &[Affine2]) -> Option<Joints> {
    let ([first, .., last], true) = (from, from.len() == to.len()) else { return None };
    let mut offered = ends(&[vec![*first], vec![*last]]);
    offered.extend(offered.clone().into_iter().map(|[s, e]| [e, s]));
    offered.into_iter().find_map(|ends| {
        let grid = Grid::new(ends);
        // Where the chain of each has come to.
        let mut at = [ends[0]; 2];
        let mut reversed = Vec::with_capacity(from.len());
        for (&f, &g) in from.iter().zip(to) {
            let joins = |end: DVec2| grid.same(f.apply(end), at[0]) && grid.same(g.apply(end), at[1]);
            let back = !joins(ends[0]);
            if back && !joins(ends[1]) {
                return None;
            }
            reversed.push(back);
            at = [f, g].map(|map| map.apply(ends[usize::from(!back)]));
        }
        at.iter().all(|&end| grid.same(end, ends[1])).then_some(Joints { ends, reversed })
    })
}

/// The most chains kept of one system.
const MOST_ZIPPERS: usize = 120;
/// The most steps of the search for them.
const MOST_STEPS: usize = 200_000;
/// The most maps of a joined morph.
const MOST_MAPS: usize = 16;

/// The morph between two systems that keeps all joints, turns the last shape least and, of those that turn it as
/// little, moves the maps least; `None` where one of them is no zipper as far as was looked, or their signatures do not
/// come together.
pub(crate) fn joined(from: &Ifs, to: &Ifs) -> Option<Joined> {
    if from.len().max(to.len()) > MOST_MAPS {
        return None;
    }
    let sides = [from, to].map(Side::of);
    let [a, b] = &sides;
    let (first, last) = (a.zippers.first()?, b.zippers.first()?);
    counts(first.maps.len(), last.maps.len()).find_map(|count| {
        let a = grown(&a.zippers, count);
        let b: Vec<Zipper> = grown(&b.zippers, count).into_iter().flat_map(|q| [q.backwards(), q]).collect();
        let groups = [sides[0].group.clone(), sides[1].group.clone()];
        layings(&ends_of(&a), &ends_of(&b), &groups).iter().find_map(|alike| {
            let mut best: Option<(f64, Joined)> = None;
            for laying in alike {
                for p in a.iter().filter(|p| p.ends == laying.ends[0]) {
                    for q in b.iter().filter(|q| q.ends == laying.ends[1]) {
                        let least = best.as_ref().map_or(f64::INFINITY, |(least, _)| *least);
                        best = meet(p, q, laying, least, &sides).or(best);
                    }
                }
            }
            best.map(|(_, found)| found)
        })
    })
}

/// One of two systems.
struct Side {
    zippers: Vec<Zipper>,
    group: Vec<Affine2>,
    /// All maps that make its pieces: each followed by each symmetry.
    variants: Vec<Affine2>,
}

impl Side {
    fn of(ifs: &Ifs) -> Self {
        let group = symmetries(ifs);
        // The maps themselves first.
        let variants =
            group.iter().flat_map(|&sigma| ifs.maps().iter().map(move |&map| map * sigma)).collect();
        Self { zippers: zippers(ifs), group, variants }
    }
}

/// The ends that there are, each pair once.
fn ends_of(all: &[Zipper]) -> Vec<[DVec2; 2]> {
    let mut found: Vec<[DVec2; 2]> = Vec::new();
    for zipper in all {
        if !found.contains(&zipper.ends) {
            found.push(zipper.ends);
        }
    }
    found
}

/// The numbers of maps that both may have when pieces are split into all of theirs, or counted three times, there and
/// back and there; the least first.
fn counts(a: usize, b: usize) -> impl Iterator<Item = usize> {
    (a.max(b)..=MOST_MAPS).filter(move |&count| can_grow(a, count - a) && can_grow(b, count - b))
}

/// Whether so many maps more can come of splitting pieces into `count` and of counting some three times.
fn can_grow(count: usize, more: usize) -> bool {
    count > 1 && (0..=more / 2).any(|thrice| (more - 2 * thrice).is_multiple_of(count - 1))
}

/// Both brought to the same ends and signature, and how far the maps then are apart, where that is less than `least`.
fn meet(p: &Zipper, q: &Zipper, laying: &Laying, least: f64, sides: &[Side; 2]) -> Option<(f64, Joined)> {
    let over = (laying.over != Affine2::IDENTITY).then_some(laying.over);
    let laid_at = |map: Affine2| over.map_or(Some(map), |over| map.conjugate(over));
    let (mut from, mut to) = (p.maps.clone(), q.maps.clone());
    let mut cost = 0.0;
    for k in 0..p.maps.len() {
        let (p_map, q_map) = (p.maps[k].0, q.maps[k].0);
        let (mut f, mut g) = (p_map, laid_at(q_map)?);
        if p.reversed[k] != q.reversed[k] {
            // Whichever can be reversed, so that the two are nearer.
            let other_f = p.flip.map(|flip| p_map * flip);
            let other_g = match q.flip {
                Some(flip) => Some((q_map * flip, laid_at(q_map * flip)?)),
                None => None,
            };
            // The plainer of the two where there are both.
            match (other_f, other_g) {
                (Some(other), Some((_, also))) if apart(other, g) <= apart(f, also) => f = other,
                (_, Some((unlaid, also))) => {
                    to[k].0 = unlaid;
                    g = also;
                }
                (Some(other), None) => f = other,
                (None, None) => return None,
            }
        }
        from[k].0 = f;
        cost += apart(f, g);
        if cost.is_nan() || cost >= least {
            return None;
        }
    }
    laying.first(&mut from, &sides[0].variants)?;
    laying.last(&mut to, &sides[1].variants)?;
    let place = laying.place();
    if let Some(place) = place {
        for (map, _) in &mut to {
            *map = map.conjugate(place)?;
        }
    }
    let sound = |maps: &[Weighted]| Ifs::new(maps.iter().map(|one| one.0).collect()).is_ok();
    (sound(&from) && sound(&to)).then_some((cost, Joined { from, to, place }))
}

/// How much a map changes to become another, its turn above all.
fn apart(f: Affine2, g: Affine2) -> f64 {
    let d = f.linear - g.linear;
    d.x_axis.length_squared() + d.y_axis.length_squared()
}

impl Zipper {
    /// The same chain from its other end.
    fn backwards(&self) -> Self {
        let mut back = self.clone();
        back.maps.reverse();
        back.reversed.reverse();
        back.ends.reverse();
        back
    }

    /// With the maps that take the place of map k.
    fn with(&self, k: usize, maps: Vec<Weighted>, reversed: Vec<bool>) -> Self {
        let mut longer = self.clone();
        longer.maps.splice(k..=k, maps);
        longer.reversed.splice(k..=k, reversed);
        longer
    }

    /// Piece k split into the pieces of `whole` in it.
    fn split(&self, k: usize, whole: &Self) -> Self {
        let back = self.reversed[k];
        let mut maps = refined(&self.maps[k..=k], &whole.maps, 0);
        let mut reversed: Vec<bool> = whole.reversed.iter().map(|&r| r != back).collect();
        if back {
            maps.reverse();
            reversed.reverse();
        }
        self.with(k, maps, reversed)
    }

    /// Piece k counted three times: there, back, and there again.
    fn thrice(&self, k: usize) -> Self {
        let back = self.reversed[k];
        let (map, share) = self.maps[k];
        self.with(k, vec![(map, share / 3.0); 3], vec![back, !back, back])
    }
}

/// The zippers with pieces split or counted thrice, so that there are `count` maps.
fn grown(all: &[Zipper], count: usize) -> Vec<Zipper> {
    let Some(first) = all.first() else { return Vec::new() };
    let n = first.maps.len();
    let mut found = Vec::new();
    for whole in all {
        // As many splits as can be, then counting thrice what is left.
        let mut now = vec![whole.clone()];
        while let Some(zipper) = now.first().filter(|zipper| zipper.maps.len() < count) {
            let left = count - zipper.maps.len();
            let splits = n > 1 && left >= n - 1 && can_grow(n, left - (n - 1));
            let mut next = Vec::new();
            for zipper in &now {
                for k in largest_first(&zipper.maps) {
                    next.push(if splits { zipper.split(k, whole) } else { zipper.thrice(k) });
                    if next.len() >= MOST_ZIPPERS {
                        break;
                    }
                }
            }
            now = next;
        }
        found.extend(now.into_iter().filter(|zipper| zipper.maps.len() == count));
        if found.len() >= 4 * MOST_ZIPPERS {
            break;
        }
    }
    found
}

/// The maps of largest area, all that are about as large.
fn largest_first(maps: &[Weighted]) -> Vec<usize> {
    let size = |k: &usize| maps[*k].0.determinant().abs();
    let most = (0..maps.len()).map(|k| size(&k)).fold(0.0, f64::max);
    (0..maps.len()).filter(|k| size(k) >= 0.5 * most).collect()
}

/// The ways to see a system as a zipper, up to its symmetries.
pub(crate) fn zippers(ifs: &Ifs) -> Vec<Zipper> {
    let group = symmetries(ifs);
    let maps = ifs.maps();
    let variants: Vec<Vec<Affine2>> =
        maps.iter().map(|&map| group.iter().map(|&sigma| map * sigma).collect()).collect();
    let mut found = Vec::new();
    let mut seen = HashSet::new();
    let mut left = MOST_STEPS;
    let all = ends(&variants);
    let Some(whole) = all.first().copied().map(Grid::new) else { return found };
    for ends in all {
        let grid = Grid::new(ends);
        // What a symmetry makes of both ends is nothing new.
        let key = |ends: [DVec2; 2]| ends.map(|end| whole.key(end));
        if seen.contains(&key(ends)) {
            continue;
        }
        for sigma in &group {
            let at = ends.map(|end| sigma.apply(end));
            seen.insert(key(at));
            seen.insert(key([at[1], at[0]]));
        }
        let flip = group.iter().copied().find(|sigma| {
            grid.same(sigma.apply(ends[0]), ends[1]) && grid.same(sigma.apply(ends[1]), ends[0])
        });
        let room = MOST_ZIPPERS - found.len();
        found.extend(chains(&variants, ends, room, &mut left).into_iter().map(|chain| Zipper {
            maps: chain.iter().map(|step| (step.with, ifs.probabilities()[step.map])).collect(),
            reversed: chain.iter().map(|step| step.reversed).collect(),
            ends,
            flip,
        }));
        if found.len() >= MOST_ZIPPERS || left == 0 {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Morph, MorphOptions};

    fn ifs(rows: &[[f64; 6]]) -> Ifs {
        Ifs::new(rows.iter().map(|&row| Affine2::from_row(row)).collect()).unwrap()
    }

    fn dragon() -> Ifs {
        ifs(&[[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]])
    }

    fn koch() -> Ifs {
        let (third, s) = (1.0 / 3.0, 0.75_f64.sqrt() / 3.0);
        ifs(&[
            [third, 0.0, 0.0, third, 0.0, 0.0],
            [0.5 * third, -s, s, 0.5 * third, third, 0.0],
            [0.5 * third, s, -s, 0.5 * third, 0.5, s],
            [third, 0.0, 0.0, third, 2.0 * third, 0.0],
        ])
    }

    fn gasket() -> Ifs {
        let h = 0.75_f64.sqrt() / 2.0;
        ifs(&[[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.0, 0.5, 0.25, h]])
    }

    fn plain(maps: &[Weighted]) -> Vec<Affine2> {
        maps.iter().map(|one| one.0).collect()
    }

    /// How far apart the joints of a chain come along the whole straight way, by the numbers of the maps alone.
    fn joints_apart(found: &Joined) -> f64 {
        let options = MorphOptions { mode: crate::Mode::Linear, ..MorphOptions::default() };
        let (from, to) = (plain(&found.from), plain(&found.to));
        let morph = Morph::new(&from, &to, &options).unwrap();
        let Joints { ends: [s, e], reversed } = joints(&from, &to).unwrap();
        (0..=20)
            .map(|k| {
                let t = f64::from(k) / 20.0;
                let maps = morph.at(t, t);
                assert!(Ifs::new(maps.clone()).is_ok(), "at {t}");
                let mut at = s;
                let mut worst = 0.0_f64;
                for (map, &back) in maps.iter().zip(&reversed) {
                    let (from, to) = if back { (e, s) } else { (s, e) };
                    worst = worst.max(map.apply(from).distance(at));
                    at = map.apply(to);
                }
                worst.max(at.distance(e)) / s.distance(e)
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn curves_are_seen_to_be_chains() {
        for (name, system) in [("dragon", dragon()), ("koch", koch()), ("gasket", gasket())] {
            assert!(!zippers(&system).is_empty(), "{name}");
        }
        let signatures: Vec<Vec<bool>> = zippers(&dragon()).into_iter().map(|z| z.reversed).collect();
        assert!(signatures.contains(&vec![false, true]), "{signatures:?}");
        // Two pieces far apart, and the four corners of dust, are none.
        let dust = ifs(&[[0.4, 0.0, 0.0, 0.4, 0.0, 0.0], [0.4, 0.0, 0.0, 0.4, 0.6, 0.0]]);
        assert!(zippers(&dust).is_empty());
    }

    #[test]
    fn joints_stay_joined_all_the_way() {
        let all = [dragon(), koch(), gasket()];
        for (i, a) in all.iter().enumerate() {
            for b in &all[i + 1..] {
                for (a, b) in [(a, b), (b, a)] {
                    let found = joined(a, b).unwrap();
                    assert!(joints_apart(&found) < 1e-12, "{}", joints_apart(&found));
                }
            }
        }
    }

    /// How far the last shape is turned, in degrees; 180 more in a mirror.
    fn turned(a: &Ifs, b: &Ifs) -> f64 {
        joined(a, b).unwrap().place.map_or(0.0, |place| {
            let mirrored = if place.determinant() < 0.0 { 180.0 } else { 0.0 };
            place.linear.x_axis.to_angle().to_degrees() + mirrored
        })
    }

    #[test]
    fn the_last_shape_stays_upright_whichever_end_meets_which() {
        let levy = ifs(&[[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [0.5, 0.5, -0.5, 0.5, 0.5, 0.5]]);
        let all = [dragon(), koch(), gasket(), levy];
        for a in &all {
            for b in &all {
                assert!(turned(a, b).abs() < 1e-6, "{} to {}: {}", a.len(), b.len(), turned(a, b));
            }
        }
    }

    #[test]
    fn a_shape_that_leans_is_turned_no_further_than_it_leans() {
        let lean = Affine2::rotation(0.5);
        let leaning =
            |a: &Ifs| Ifs::new(a.maps().iter().map(|f| f.conjugate(lean).unwrap()).collect()).unwrap();
        for (a, b) in [(koch(), dragon()), (gasket(), koch()), (dragon(), koch())] {
            // The gasket looks the same every third of a turn, and leans no further than half of one from Koch's curve.
            let turn = turned(&a, &leaning(&b)).to_radians();
            assert!((turn + 0.5).abs() < 1e-6, "{turn}");
        }
    }

    #[test]
    fn chains_grow_to_any_number_that_they_can_have() {
        let koch = zippers(&koch());
        for count in [4, 6, 7, 8, 9, 10, 13] {
            assert!(can_grow(4, count - 4));
            let grown = grown(&koch, count);
            assert!(!grown.is_empty(), "{count}");
            for zipper in &grown {
                let maps = plain(&zipper.maps);
                let same = joints(&maps, &maps).unwrap();
                assert_eq!((same.reversed.len(), zipper.maps.len()), (count, count));
            }
        }
        assert!(!can_grow(4, 1) && !can_grow(1, 2));
    }

    #[test]
    fn koch_takes_the_dragon_by_fours() {
        let found = joined(&koch(), &dragon()).unwrap();
        assert_eq!((found.from.len(), found.to.len()), (4, 4));
    }
}
