//! What a line drawn in one channel gets wrong: slits where a stalk lies across the blade, and stalks that stand off
//! it.

use super::binary_image::{Bits, squared_distances};
use super::components::{Parts, parts};

/// Adds what is a little like the leaf and lies in a gap of it no wider than twice `radius`: the bits of a pale stalk
/// that lies across the blade, of a vein, of a glint. Gaps in which the ground is seen stay.
#[inline(never)]
pub fn close_slits(bits: &mut Bits, likeness: &[u8], weak: f64, radius: f64) {
    let closed = bits.grown(radius).shrunk(radius);
    let mut gap = Bits::above(likeness, bits.width, bits.height, weak);
    for (i, gap) in gap.on.iter_mut().enumerate() {
        *gap &= closed.on[i] && !bits.on[i];
    }
    // Soft edges are a little like the leaf, too, but thin.
    let deep = gap.opened_by_square(1).grown(2.0);
    for (i, on) in bits.on.iter_mut().enumerate() {
        *on |= gap.on[i] && deep.on[i];
    }
}

/// Takes the stalk off each piece: the longest thin part that is as wide at its end as where it begins, so that the
/// tips of lobes and teeth stay. `size` is the side of a square as large as the leaf; stalks are up to a 20th of it
/// wide.
///
/// Returns how many were taken off.
pub fn remove_stalks(bits: &mut Bits, size: f64) -> usize {
    let whole = parts(bits, true, true);
    let mut best: Vec<Option<(f64, Vec<usize>)>> = vec![None; whole.all.len()];
    for part in [0.02, 0.035, 0.055] {
        for (owner, score, pixels) in stalks(bits, &whole, (part * size).max(2.0)) {
            if best[owner].as_ref().is_none_or(|(most, _)| score > *most) {
                best[owner] = Some((score, pixels));
            }
        }
    }
    for &i in best.iter().flatten().flat_map(|(_, pixels)| pixels) {
        bits.on[i] = false;
    }
    best.iter().flatten().count()
}

/// A thin part, by how far its pixels are from the blade.
#[derive(Clone, Copy, Default)]
struct Thin {
    reach: f32,
    near: u32,
    far: u32,
}

impl Thin {
    /// How many times as long as wide it is, where it may be a stalk: less where it tapers.
    fn as_stalk(&self, width: f64) -> Option<f64> {
        let (reach, area) = (f64::from(self.reach), f64::from(self.near + self.far));
        // Of a part that tapers the far half is a third of the near one.
        let even = f64::from(self.far) / f64::from(self.near.max(1));
        let long = reach * reach / area;
        (reach > 1.2 * width && long > 2.5 && even >= 0.6).then(|| long * even.min(1.0))
    }
}

/// What may be a stalk at most so wide: the best of each piece, with its score and its pixels.
fn stalks(bits: &Bits, whole: &Parts, width: f64) -> Vec<(usize, f64, Vec<usize>)> {
    let blade = bits.opened(0.5 * width);
    let mut thin = bits.clone();
    for (thin, &blade) in thin.on.iter_mut().zip(&blade.on) {
        *thin &= !blade;
    }
    let far = squared_distances(&blade, true);
    let thin = parts(&thin, true, true);
    let mut measured = vec![Thin::default(); thin.all.len()];
    let each = || {
        let runs = thin.runs().flat_map(|(run, label)| far[run].iter().map(move |&far| (label, far)));
        runs.filter(|(_, far)| far.is_finite())
    };
    for (label, far) in each() {
        let part = &mut measured[label];
        part.reach = part.reach.max(far.sqrt());
    }
    for (label, far) in each() {
        let part = &mut measured[label];
        if far.sqrt() > 0.5 * part.reach { part.far += 1 } else { part.near += 1 }
    }
    let mut best: Vec<Option<(usize, f64)>> = vec![None; whole.all.len()];
    for (i, part) in thin.all.iter().enumerate() {
        let Some(owner) = whole.of(part.at[1] * bits.width + part.at[0]) else { continue };
        // What is thin all over has no blade to hang on.
        let Some(score) = measured[i].as_stalk(width).filter(|_| part.area < whole.all[owner].area) else {
            continue;
        };
        if best[owner].is_none_or(|(_, most)| score > most) {
            best[owner] = Some((i, score));
        }
    }
    let mut found = Vec::new();
    for (owner, (i, score)) in best.iter().enumerate().filter_map(|(owner, best)| Some((owner, (*best)?))) {
        let pixels = thin.runs().filter(|(_, label)| *label == i).flat_map(|(run, _)| run).collect();
        found.push((owner, score, pixels));
    }
    found
}

/// Drops pieces that are thin all over: rules, scratches, hairs. The largest stays, whatever it is.
#[inline(never)]
pub fn drop_thin(bits: &mut Bits, radius: usize) {
    let found = parts(bits, true, true).largest(1, usize::MAX);
    let thick = bits.opened_by_square(radius);
    let mut kept = vec![false; found.all.len()];
    if let Some(first) = kept.first_mut() {
        *first = true;
    }
    let (width, height) = (bits.width, bits.height);
    for (run, label) in found.runs() {
        // Near the border it cannot be told how wide it is.
        let inner = |i: usize| {
            let (x, y) = (i % width, i / width);
            x.min(width - 1 - x).min(y).min(height - 1 - y) > 2 * radius
        };
        kept[label] = kept[label] || run.clone().any(|i| thick.on[i] && inner(i));
    }
    *bits = found.bits_where(width, height, |label| kept[label]);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(inside: impl Fn(f64, f64) -> bool) -> Bits {
        let at = |i: i32, side: f64| f64::from(i) - side;
        let on = (0..120 * 100).map(|i| inside(at(i % 120, 60.0), at(i / 120, 40.0))).collect();
        Bits { width: 120, height: 100, on }
    }

    #[test]
    fn a_stalk_is_taken_off_and_a_tooth_is_not() {
        let blade = |x: f64, y: f64| x.hypot(y) < 25.0 || (x > 0.0 && x < 45.0 && y.abs() < 0.5 * (45.0 - x));
        let bare = drawn(blade);
        let mut with_stalk = drawn(|x, y| blade(x, y) || (x.abs() < 2.0 && y > 0.0 && y < 55.0));
        assert!(with_stalk.count() > bare.count() + 80);
        assert_eq!(remove_stalks(&mut with_stalk, 80.0), 1);
        let left: usize = with_stalk.on.iter().zip(&bare.on).filter(|(a, b)| a != b).count();
        assert!(left <= 12, "{left} pixels differ");
        let mut same = bare.clone();
        assert_eq!((remove_stalks(&mut same, 80.0), same), (0, bare));
    }

    #[test]
    fn rules_beside_a_leaf_are_dropped() {
        let mut bits = drawn(|x, y| x.hypot(y) < 25.0 || (x + 40.0).abs() < 2.0 || (x - 40.0).hypot(y) < 6.0);
        drop_thin(&mut bits, 3);
        assert_eq!(bits, drawn(|x, y| x.hypot(y) < 25.0 || (x - 40.0).hypot(y) < 6.0));
        let mut rule = drawn(|x, _| x.abs() < 2.0);
        let before = rule.clone();
        drop_thin(&mut rule, 3);
        assert_eq!(rule, before);
    }

    #[test]
    fn slits_close_where_they_are_a_little_like_the_leaf() {
        let slit = |x: f64, y: f64| (y.abs() < 3.0 && x < 10.0) || (x.abs() < 3.0 && y < -5.0);
        let mut bits = drawn(|x, y| x.hypot(y) < 30.0 && !slit(x, y));
        // A stalk lies in the one that goes to the left; through the one that goes up the ground is seen.
        let likeness: Vec<u8> = (0..120 * 100)
            .map(|i| {
                let (x, y) = ((i % 120) as f64 - 60.0, (i / 120) as f64 - 40.0);
                if bits.on[i] {
                    200
                } else if y.abs() < 3.0 && x.hypot(y) < 30.0 {
                    100
                } else {
                    20
                }
            })
            .collect();
        close_slits(&mut bits, &likeness, 80.0, 4.0);
        let at = |x: usize, y: usize| bits.on[(y + 40) * 120 + x + 60 - 20];
        assert!(at(0, 0) && at(0, 2) && at(25, 0));
        assert!(!bits.on[25 * 120 + 60]);
    }
}
