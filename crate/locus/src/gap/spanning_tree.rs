//! Minimum spanning trees.

/// Prim's algorithm.
#[derive(Clone, Debug, Default)]
pub(crate) struct SpanningTree {
    distance: Vec<f64>,
    from: Vec<u8>,
    outside: Vec<u8>,
    /// Which end each piece hangs on, in the order they were taken in.
    steps: Vec<(u8, u8)>,
    /// Whether a piece lies beyond the widest edge; see [`SpanningTree::cut`].
    pub beyond: Vec<bool>,
}

impl SpanningTree {
    /// The weight of the widest edge of the minimum spanning tree of `count` pieces, 0 if there is none. The pieces
    /// that hang on the far end of that edge are `beyond` it.
    pub fn cut(&mut self, count: usize, between: impl Fn(u8, u8) -> f64) -> f64 {
        let widest = self.grow(count, between);
        self.beyond.clear();
        self.beyond.resize(count, false);
        if let Some((bridge, _)) = widest {
            for k in bridge..self.steps.len() {
                let (piece, from) = self.steps[k];
                self.beyond[usize::from(piece)] = k == bridge || self.beyond[usize::from(from)];
            }
        }
        widest.map_or(0.0, |(_, weight)| weight)
    }

    /// Grows the tree from the first piece; returns the place of its widest edge among the steps, and its weight.
    fn grow(&mut self, count: usize, between: impl Fn(u8, u8) -> f64) -> Option<(usize, f64)> {
        let Self { distance, from, outside, steps, .. } = self;
        distance.clear();
        distance.extend((0..count).map(|i| if i == 0 { 0.0 } else { between(0, i as u8) }));
        from.clear();
        from.resize(count, 0);
        outside.clear();
        outside.extend(1..count as u8);
        steps.clear();
        let mut widest: Option<(usize, f64)> = None;
        while !outside.is_empty() {
            let far = |k: &usize| distance[usize::from(outside[*k])];
            let nearest = (0..outside.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0);
            let next = outside.swap_remove(nearest);
            let weight = distance[usize::from(next)];
            if widest.is_none_or(|(_, most)| weight > most) {
                widest = Some((steps.len(), weight));
            }
            steps.push((next, from[usize::from(next)]));
            for &i in outside.iter() {
                let d = between(next, i);
                if d < distance[usize::from(i)] {
                    distance[usize::from(i)] = d;
                    from[usize::from(i)] = next;
                }
            }
        }
        widest
    }
}
