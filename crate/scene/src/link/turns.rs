//! Whole extra turns, as links count them and as documents do.
//!
//! They differ where a map turns by half a turn, which is as short either way. Links count from the half turn that is
//! counter-clockwise, as the first ones did, and in space about the axis of the turn wherever it points. Documents
//! count as [`MorphOptions::turns`] says, from the half turn of eq 6. So old links keep the morph that they showed.

use frond_core::{Affine, Dimension, Morph, MorphOptions};

/// The most extra turns of a map, either way.
const MOST_TURNS: i32 = 16;

/// How the turns of a link become those of a document: of each map a sign and an offset.
pub(crate) struct Counting(Vec<(i32, i32)>);

impl Counting {
    /// Where there is no morph, both count alike.
    pub const NONE: Self = Self(Vec::new());

    /// For the morph between these maps.
    pub fn of<D: Dimension>(from: &[Affine<D>], to: &[Affine<D>], correspondence: &[usize]) -> Self {
        let options = MorphOptions { correspondence: correspondence.to_vec(), ..MorphOptions::default() };
        let Ok(morph) = Morph::new(from, to, &options) else { return Self::NONE };
        let step = |(turn, other): (D::Turn, i32)| match other {
            0 if D::COORDINATES == 3 && D::angle(&turn) < 0.0 => (-1, 0),
            other => (1, other.max(0)),
        };
        Self(morph.turns().into_iter().zip(morph.other_half_turns()).map(step).collect())
    }

    /// The turns of the document, empty where there are none; `None` where there are more than there may be.
    pub fn of_link(&self, turns: &[i32]) -> Option<Vec<i32>> {
        let allowed = -MOST_TURNS..=MOST_TURNS;
        let turns = self.counted(turns, |turns, sign, offset| {
            let counted = turns.checked_mul(sign)?.checked_add(offset)?;
            // A link of before may ask for one more than there may be.
            let near = if allowed.contains(&turns) { counted.min(MOST_TURNS) } else { counted };
            allowed.contains(&near).then_some(near)
        });
        turns.into_iter().collect::<Option<Vec<i32>>>().map(some_or_none)
    }

    /// The turns of the link, empty where there are none.
    pub fn for_link(&self, turns: &[i32]) -> Vec<i32> {
        some_or_none(self.counted(turns, |turns, sign, offset| sign * turns.saturating_sub(offset)))
    }

    fn counted<T>(&self, turns: &[i32], count: impl Fn(i32, i32, i32) -> T) -> Vec<T> {
        let step = |i: usize| self.0.get(i).copied().unwrap_or((1, 0));
        let of = |i: usize| {
            let (sign, offset) = step(i);
            count(turns.get(i).copied().unwrap_or(0), sign, offset)
        };
        (0..self.0.len().max(turns.len())).map(of).collect()
    }
}

/// No turn at all is what an empty list stands for.
fn some_or_none(turns: Vec<i32>) -> Vec<i32> {
    if turns.iter().all(|&turns| turns == 0) { Vec::new() } else { turns }
}
