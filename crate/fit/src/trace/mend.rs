//! What a line drawn in one channel gets wrong: slits where a stalk lies across the blade, and stalks that stand off it.

use super::bits::{Bits, squared_distances};
use super::parts::{NONE, parts};

/// Adds what is a little like the leaf and lies in a gap of it no wider than twice `radius`: the bits of a pale stalk
/// that lies across the blade, of a vein, of a glint. Gaps in which the ground is seen stay.
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

/// Takes the stalk off each piece: the longest thin part, where it is at most `width` wide and five times as long.
///
/// Returns how many were taken off.
pub fn remove_stalks(bits: &mut Bits, width: f64) -> usize {
    let blade = bits.opened(0.5 * width);
    let mut thin = bits.clone();
    for (thin, &blade) in thin.on.iter_mut().zip(&blade.on) {
        *thin &= !blade;
    }
    let far = squared_distances(&blade, true);
    let thin = parts(&thin, true, true);
    let whole = parts(bits, true, true);
    // By pieces of the whole: the longest of the thin parts that hang on it.
    let mut reach = vec![0.0_f32; thin.all.len()];
    for (&label, &far) in thin.labels.iter().zip(&far) {
        if label != NONE && far.is_finite() {
            let reach = &mut reach[label as usize];
            *reach = reach.max(far);
        }
    }
    let mut longest: Vec<Option<usize>> = vec![None; whole.all.len()];
    for (i, part) in thin.all.iter().enumerate() {
        let owner = whole.labels[part.at[1] * bits.width + part.at[0]] as usize;
        if f64::from(reach[i]).sqrt() >= 5.0 * width && longest[owner].is_none_or(|j| reach[j] < reach[i]) {
            longest[owner] = Some(i);
        }
    }
    let mut off = vec![false; thin.all.len()];
    for &i in longest.iter().flatten() {
        off[i] = true;
    }
    for (on, &label) in bits.on.iter_mut().zip(&thin.labels) {
        *on &= label == NONE || !off[label as usize];
    }
    longest.iter().flatten().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(inside: impl Fn(f64, f64) -> bool) -> Bits {
        let on = (0..120 * 100).map(|i| inside((i % 120) as f64 - 60.0, (i / 120) as f64 - 40.0)).collect();
        Bits { width: 120, height: 100, on }
    }

    #[test]
    fn a_stalk_is_taken_off_and_a_tooth_is_not() {
        let blade = |x: f64, y: f64| x.hypot(y) < 25.0 || (x > 0.0 && x < 45.0 && y.abs() < 0.5 * (45.0 - x));
        let bare = drawn(blade);
        let mut with_stalk = drawn(|x, y| blade(x, y) || (x.abs() < 2.0 && y > 0.0 && y < 55.0));
        assert!(with_stalk.count() > bare.count() + 80);
        assert_eq!(remove_stalks(&mut with_stalk, 5.0), 1);
        let left: usize = with_stalk.on.iter().zip(&bare.on).filter(|(a, b)| a != b).count();
        assert!(left <= 12, "{left} pixels differ");
        let mut same = bare.clone();
        assert_eq!((remove_stalks(&mut same, 5.0), same), (0, bare));
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
