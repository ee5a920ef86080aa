//! Pieces that lie across each other.

use num_bigint::BigInt;

use crate::connected::Far;
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::whole::{Factor, Whole};
use crate::work::{digits, product};

/// A direction as whole numbers times `2^-bits`.
struct Direction {
    at: [BigInt; 2],
    bits: u64,
}

impl Direction {
    fn of(direction: [f64; 2]) -> Result<Self, Refused> {
        let whole = Whole::of(&[direction]).ok_or(Refused::NotFinite { place: "directions" })?;
        Ok(Self { at: whole.rows[0].clone(), bits: whole.bits })
    }

    fn back(&self) -> [BigInt; 2] {
        self.at.clone().map(|x| -x)
    }
}

/// What [`lie_across`] takes.
pub(crate) fn cost_across(scene: &Scene, words: &[Vec<u8>; 2], far: &[Far; 4]) -> Result<u64, Refused> {
    let (mut cost, mut longest) = (0_u64, 0);
    for (k, Far { tail, direction }) in far.iter().enumerate() {
        let (own, other) = (words[k / 2].len(), words[1 - k / 2].len());
        let direction = digits(&Direction::of(*direction)?.at);
        longest = longest.max(direction);
        for (times, letters) in [(1, own + tail.len()), (2, other)] {
            cost = cost.saturating_add(times * scene.cost_farthest(direction, letters));
        }
    }
    Ok(cost.saturating_add(40 * product(longest, longest)))
}

/// Whether the far parts of two pieces show that these lie across each other, where no gap is wider than `gap`.
pub(crate) fn lie_across(
    scene: &Scene,
    words: &[Vec<u8>; 2],
    far: &[Far; 4],
    gap: &Factor,
) -> Result<bool, Refused> {
    let mut directions = Vec::with_capacity(4);
    for (k, Far { tail, direction }) in far.iter().enumerate() {
        let (own, other) = (&words[k / 2], &words[1 - k / 2]);
        let part: Vec<u8> = own.iter().chain(tail).copied().collect();
        let direction = Direction::of(*direction)?;
        if !is_beyond(scene, &part, other, &direction, gap)? {
            return Ok(false);
        }
        directions.push(direction.at);
    }
    let longest = digits(directions.iter().flatten());
    scene.work.spend(40 * product(longest, longest))?;
    let [p, q, r, s] = [0, 1, 2, 3].map(|k| &directions[k]);
    Ok(alternate([p, q], [r, s]))
}

/// Whether two directions are on different sides of two others.
fn alternate([p, q]: [&[BigInt; 2]; 2], [r, s]: [&[BigInt; 2]; 2]) -> bool {
    is_between(p, r, q) && is_between(q, s, p) || is_between(p, s, q) && is_between(q, r, p)
}

/// Whether all of a part is farther along a direction than all of a piece, and half its gaps beside.
///
/// The points within half a step of the piece, steps being those of the gap made as small as the piece is, lie in
/// `w(P) + gap / 2 (w(P) - w(P))`.
fn is_beyond(
    scene: &Scene,
    part: &[u8],
    piece: &[u8],
    direction: &Direction,
    gap: &Factor,
) -> Result<bool, Refused> {
    let to = |word: &[u8], normal: [BigInt; 2]| scene.farthest(word, normal, direction.bits);
    let [there, back] = [to(piece, direction.at.clone())?, to(piece, direction.back())?];
    let wide = there.clone().plus(&back).times(gap).half();
    Ok(there.plus(&wide).is_below(&to(part, direction.back())?.negative()))
}

/// Whether a direction lies strictly between two others, counter-clockwise from `a` to `b`.
fn is_between(a: &[BigInt; 2], x: &[BigInt; 2], b: &[BigInt; 2]) -> bool {
    let cross = |p: &[BigInt; 2], q: &[BigInt; 2]| &p[0] * &q[1] - &p[1] * &q[0];
    let zero = BigInt::ZERO;
    let turn = cross(a, b);
    if turn > zero {
        cross(a, x) > zero && cross(x, b) > zero
    } else if turn < zero {
        // Not in the narrow angle from `b` to `a`.
        cross(b, x) < zero || cross(x, a) < zero
    } else {
        let is_opposite = &a[0] * &b[0] + &a[1] * &b[1] < zero;
        is_opposite && cross(a, x) > zero
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A direction of whole numbers for each of 16 parts of the turn, none twice.
    fn round() -> Vec<[BigInt; 2]> {
        [
            [2, 0],
            [5, 2],
            [1, 1],
            [2, 5],
            [0, 1],
            [-2, 5],
            [-3, 3],
            [-5, 2],
            [-1, 0],
            [-5, -2],
            [-2, -2],
            [-2, -5],
            [0, -7],
            [2, -5],
            [1, -1],
            [5, -2],
        ]
        .map(|[x, y]: [i32; 2]| [x.into(), y.into()])
        .to_vec()
    }

    #[test]
    fn directions_are_in_cyclic_order() {
        let round = round();
        for a in 0..16 {
            for b in 0..16 {
                for x in 0..16 {
                    let after = |k: usize| (k + 16 - a) % 16;
                    let expected = x != a && after(x) < after(b);
                    assert_eq!(is_between(&round[a], &round[x], &round[b]), expected, "{a} {x} {b}");
                }
                let nowhere = [BigInt::ZERO, BigInt::ZERO];
                assert!(!is_between(&round[a], &nowhere, &round[b]), "{a} {b}");
                assert!(!is_between(&nowhere, &round[a], &round[b]), "{a} {b}");
                assert!(!is_between(&round[a], &round[b], &nowhere), "{a} {b}");
            }
        }
    }

    #[test]
    fn two_and_two_alternate_if_one_of_each_lies_between_the_others() {
        let round = round();
        let numbers = 0..16_usize.pow(4);
        for [p, q, r, s] in numbers.map(|k| [k % 16, k / 16 % 16, k / 256 % 16, k / 4096]) {
            let after = |k: usize| (k + 16 - p) % 16;
            let apart = |k: usize| k != p && k != q;
            let expected = p != q && apart(r) && apart(s) && (after(r) < after(q)) != (after(s) < after(q));
            let found = alternate([&round[p], &round[q]], [&round[r], &round[s]]);
            assert_eq!(found, expected, "{p} {q} {r} {s}");
        }
    }
}
