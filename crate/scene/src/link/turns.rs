//! Whole extra turns, as links count them and as documents do.
//!
//! They differ where a map turns by half a turn, which is as short either way. Links count from the half turn that is
//! counter-clockwise, as the first ones did, and in space about the axis of the turn wherever it points. Documents
//! count as [`MorphOptions::turns`] says, from the half turn of eq 6. So old links keep the morph that they showed.

use frond_core::{Affine, Dimension, Morph, MorphOptions};

/// The most extra turns of a map, either way.
const MOST_TURNS: i32 = 16;

/// How the turns of a link become those of a document: of each map a sign and an offset.
#[derive(Default)]
pub(crate) struct Counting(Vec<(i32, i32)>);

impl Counting {
    /// For the morph between these maps. Where there is none, both count alike.
    pub fn of<D: Dimension>(from: &[Affine<D>], to: &[Affine<D>], correspondence: &[usize]) -> Self {
        let options = MorphOptions { correspondence: correspondence.to_vec(), ..MorphOptions::default() };
        let Ok(morph) = Morph::new(from, to, &options) else { return Self::default() };
        let mut counting: Vec<_> =
            morph.other_half_turns().into_iter().map(|other| (1, other.max(0))).collect();
        if D::COORDINATES == 3 {
            for (step, turn) in counting.iter_mut().zip(morph.turns()) {
                if *step == (1, 0) && D::angle(&turn) < 0.0 {
                    *step = (-1, 0);
                }
            }
        }
        Self(counting)
    }

    /// The turns of the document, empty where there are none; `None` where there are more than there may be.
    pub fn of_link(&self, turns: Vec<i32>) -> Option<Vec<i32>> {
        if !turns.iter().all(|turns| (-MOST_TURNS - 1..=MOST_TURNS).contains(turns)) {
            return None;
        }
        let mut turns = self.counted(turns, |turns, (sign, offset)| sign * turns + offset);
        // A link of before may ask for one more than there may be.
        turns.iter_mut().for_each(|turns| *turns = (*turns).min(MOST_TURNS));
        turns.iter().all(|&turns| turns >= -MOST_TURNS).then_some(turns)
    }

    /// The turns of the link, empty where there are none.
    pub fn for_link(&self, turns: &[i32]) -> Vec<i32> {
        self.counted(turns.to_vec(), |turns, (sign, offset)| sign * turns.saturating_sub(offset))
    }

    fn counted(&self, mut turns: Vec<i32>, count: fn(i32, (i32, i32)) -> i32) -> Vec<i32> {
        turns.resize(turns.len().max(self.0.len()), 0);
        turns.iter_mut().zip(&self.0).for_each(|(turns, &step)| *turns = count(*turns, step));
        // No turn at all is what an empty list stands for.
        if turns.iter().all(|&turns| turns == 0) {
            turns.clear();
        }
        turns
    }
}
