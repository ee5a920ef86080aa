//! Ways to points that are near, to be followed in a system much like theirs.

use frond_core::Contraction;

/// A step into a part of one of two pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    /// The number of the part: of the word that leads to it, or of a difference of two translations.
    pub part: u16,
    /// Whether it is a part of the first piece, 0, or of the second, 1; of no account for differences.
    pub large: u8,
}

/// For some pairs of attractorlets the steps that lead into them to two points near each other.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Trails {
    /// The coordinates in which they were looked for, where these are not the plane's own.
    pub coordinates: Option<Contraction>,
    /// The pairs, and where the steps of each end.
    pairs: Vec<(u8, u8, usize)>,
    steps: Vec<Step>,
}

impl Trails {
    pub fn clear(&mut self) {
        self.coordinates = None;
        self.pairs.clear();
        self.steps.clear();
    }

    /// Adds the way to near points of attractorlets `i` and `j`.
    pub fn push(&mut self, i: usize, j: usize, steps: &[Step]) {
        self.steps.extend_from_slice(steps);
        self.pairs.push((i as u8, j as u8, self.steps.len()));
    }

    /// Whether there is a way for this pair.
    pub fn has(&self, i: usize, j: usize) -> bool {
        self.pairs.iter().any(|&(k, l, _)| (usize::from(k), usize::from(l)) == (i, j))
    }

    /// The pairs and their ways, in the order in which they came.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, &[Step])> {
        let mut start = 0;
        self.pairs.iter().map(move |&(i, j, end)| {
            let steps = &self.steps[start..end];
            start = end;
            (i.into(), j.into(), steps)
        })
    }
}
