//! How far the points of an outline and a curve are from each other.

use glam::DVec2;

use crate::outline::{Near, Nearest};

/// The curve's polyline, and what is nearest to what.
#[derive(Clone, Debug)]
pub(crate) struct Distances {
    /// The first corner of each edge, and their number at the end.
    starts: Vec<usize>,
    pub polyline: Vec<DVec2>,
    /// For each point of the outline the nearest of the polyline.
    pub points: Vec<Near>,
    /// For the beginning and the middle of each side of the polyline the nearest of the outline, where that was asked.
    pub back: Vec<[Near; 2]>,
}

/// With so few edges the side that is nearest is guessed first. Where two sides are equally near, that may name the
/// other one, and turns a search elsewhere, which gains nothing where it is long.
const FEW_EDGES: usize = 12;

/// The nearest of a polyline to points of which each is near the one before it.
fn in_a_row(nearest: &Nearest, points: impl Iterator<Item = DVec2>, guessed: bool) -> Vec<Near> {
    let mut guess = 0;
    points
        .map(|p| {
            let near = if guessed { nearest.to_guessed(p, guess) } else { nearest.to(p) };
            guess = near.side;
            near
        })
        .collect()
}

impl Distances {
    /// Measures a polyline with the first corners of its edges; with the outline, if there and back.
    pub fn new(
        starts: Vec<usize>,
        polyline: Vec<DVec2>,
        points: &[DVec2],
        outline: Option<&Nearest>,
    ) -> Self {
        let nearest = Nearest::new(&polyline, true);
        let guessed = starts.len() <= FEW_EDGES + 1;
        let points = in_a_row(&nearest, points.iter().copied(), guessed);
        let side = |i: usize| (polyline[i], polyline[if i + 1 == polyline.len() { 0 } else { i + 1 }]);
        let places = (0..polyline.len()).map(side).flat_map(|(a, b)| [a, a.midpoint(b)]);
        let back = outline.map(|outline| in_a_row(outline, places, guessed)).unwrap_or_default();
        let back = back.chunks_exact(2).map(|both| [both[0], both[1]]).collect();
        Self { starts, polyline, points, back }
    }

    /// The edge of each side.
    pub fn edges(&self) -> Vec<usize> {
        let sides = self.starts.windows(2).enumerate();
        sides.flat_map(|(edge, ends)| std::iter::repeat_n(edge, ends[1] - ends[0])).collect()
    }

    /// For each edge the sum of squares of the points nearest to it, and the index of the farthest of them.
    pub fn shares(&self) -> Vec<(f64, usize)> {
        let edges = self.edges();
        let mut shares = vec![(0.0, 0, -1.0); self.starts.len() - 1];
        for (i, near) in self.points.iter().enumerate() {
            let share = &mut shares[edges[near.side]];
            share.0 += near.squared;
            if near.squared > share.2 {
                (share.1, share.2) = (i, near.squared);
            }
        }
        shares.into_iter().map(|(sum, farthest, _)| (sum, farthest)).collect()
    }
}
