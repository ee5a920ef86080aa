//! A closed curve as a graph-directed system: its edges are made of copies of each other.

use frond_core::{Affine2, DirectedError, DirectedIfs, DirectedMap, MAX_MAPS, MAX_STATES};
use glam::DVec2;

use crate::closed::{ClosedCurve, complex};

impl ClosedCurve {
    /// The curve as a graph-directed system: state 0 is all of it, state i + 1 is edge i. An edge that copies an arc is
    /// made of copies of the arc's edges, a straight one of two halves of itself.
    ///
    /// # Errors
    /// [`DirectedError`] where there are more edges than states may be, an arc is too long, or the curve is not sound.
    pub fn to_states(&self) -> Result<DirectedIfs, DirectedError> {
        let count = self.knots.len();
        if count >= MAX_STATES {
            return Err(DirectedError::TooManyStates { count: count + 1, most: MAX_STATES });
        }
        let whole = (0..count).map(|edge| DirectedMap { from: edge + 1, map: Affine2::IDENTITY }).collect();
        let mut states = vec![whole];
        for edge in 0..count {
            let Some(copy) = self.edges.get(edge).copied().flatten() else {
                let half = |end: DVec2| DirectedMap {
                    from: edge + 1,
                    map: Affine2::similitude(0.5, 0.0, end * 0.5),
                };
                states.push(vec![half(self.knot(edge)), half(self.knot(edge + 1))]);
                continue;
            };
            // Before anything is added to it.
            if copy.span > MAX_MAPS {
                return Err(DirectedError::TooManyMaps { state: edge + 1, count: copy.span });
            }
            if copy.from >= count {
                return Err(DirectedError::From { state: edge + 1, map: 0, from: copy.from, states: count });
            }
            let map = self.whole_map(edge).unwrap_or(Affine2::IDENTITY);
            states.push(
                (copy.from..copy.from + copy.span)
                    .map(|k| DirectedMap { from: k % count + 1, map })
                    .collect(),
            );
        }
        DirectedIfs::new(states)
    }
}

impl ClosedCurve {
    /// The curve as a graph-directed system whose states run from point to point, in the order of its edges: state 0 is
    /// all of it. State 1 is the segment from 0 to (1, 0), of which straight edges are copies, unless there is none. An
    /// edge that copies an arc is a state, and another one where a copy runs backwards over it. A curve of more than
    /// 64 edges is first parted into arcs.
    ///
    /// It holds more edges than [`to_states`](Self::to_states), since straight ones have no states of their own.
    ///
    /// # Errors
    /// [`DirectedError`] where it would take too many states or maps, or the curve is not sound.
    pub fn to_chain(&self) -> Result<DirectedIfs, DirectedError> {
        DirectedIfs::new(self.chain_states()?)
    }

    /// The states of [`to_chain`](Self::to_chain), without asking whether they have an attractor.
    ///
    /// # Errors
    /// [`DirectedError`] where there would be too many states or maps.
    pub fn chain_states(&self) -> Result<Vec<Vec<DirectedMap>>, DirectedError> {
        let count = self.knots.len();
        if count > MAX_STATES * MAX_MAPS {
            return Err(DirectedError::TooManyStates { count, most: MAX_STATES });
        }
        let arcs = if count > MAX_MAPS { count.div_ceil(MAX_MAPS) } else { 0 };
        let straight = (0..count).any(|edge| self.edges.get(edge).copied().flatten().is_none());
        let mut chain = Chain { curve: self, first: 1 + arcs + usize::from(straight), open: Vec::new() };
        let parts: Vec<DirectedMap> =
            (0..count).map(|edge| chain.part(1 + arcs, edge, false, Affine2::IDENTITY)).collect();
        let mut states = vec![parts.clone()];
        if arcs > 0 {
            let each = count.div_ceil(arcs);
            states[0] = (0..arcs).map(|arc| DirectedMap { from: arc + 1, map: Affine2::IDENTITY }).collect();
            states.extend(parts.chunks(each).map(<[DirectedMap]>::to_vec));
        }
        if straight {
            let half =
                |x| DirectedMap { from: 1 + arcs, map: Affine2::similitude(0.5, 0.0, DVec2::new(x, 0.0)) };
            states.push(vec![half(0.0), half(0.5)]);
        }
        while let Some(&(edge, backward)) = chain.open.get(states.len() - chain.first) {
            let Some((copy, map)) = self.edges[edge].zip(self.whole_map(edge)) else { break };
            if copy.span > MAX_MAPS {
                return Err(DirectedError::TooManyMaps { state: states.len(), count: copy.span });
            }
            if copy.from >= count {
                let (state, from) = (states.len(), copy.from);
                return Err(DirectedError::From { state, map: 0, from, states: count });
            }
            // Backwards over what runs backwards is forwards.
            let back = copy.reversed != backward;
            let mut arc: Vec<usize> = (copy.from..copy.from + copy.span).map(|k| k % count).collect();
            if back {
                arc.reverse();
            }
            states.push(arc.into_iter().map(|k| chain.part(1 + arcs, k, back, map)).collect());
            if states.len() > MAX_STATES {
                return Err(DirectedError::TooManyStates { count: states.len(), most: MAX_STATES });
            }
        }
        Ok(states)
    }

    /// The map that makes an edge of its arc.
    fn whole_map(&self, edge: usize) -> Option<Affine2> {
        let (linear, begin) = self.map(edge)?;
        Some(Affine2::new(linear, self.knots[edge] - linear * begin))
    }
}

/// The states of edges that are copies, in the order in which they are met.
struct Chain<'a> {
    curve: &'a ClosedCurve,
    /// The state of the first of them.
    first: usize,
    open: Vec<(usize, bool)>,
}

impl Chain<'_> {
    /// The image of an edge, from its beginning to its end or backwards.
    fn part(&mut self, segment: usize, edge: usize, backward: bool, by: Affine2) -> DirectedMap {
        let ends = [self.curve.knot(edge), self.curve.knot(edge + 1)];
        let [begin, end] = if backward { [ends[1], ends[0]] } else { ends };
        if self.curve.edges.get(edge).copied().flatten().is_none() {
            return DirectedMap { from: segment, map: by * Affine2::new(complex(end - begin), begin) };
        }
        let met = self.open.iter().position(|known| *known == (edge, backward));
        let at = met.unwrap_or_else(|| {
            self.open.push((edge, backward));
            self.open.len() - 1
        });
        DirectedMap { from: self.first + at, map: by }
    }
}

#[cfg(test)]
mod tests {
    use frond_core::Hull;

    use super::*;
    use crate::closed::ArcCopy;

    fn square() -> ClosedCurve {
        ClosedCurve::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y])
    }

    #[test]
    fn a_polygon_is_made_of_segments() {
        let system = square().to_states().unwrap();
        assert_eq!((system.len(), system.never_return()), (5, vec![0]));
        for (edge, hull) in Hull::of_states(&system)[1..].iter().enumerate() {
            let ends = [square().knot(edge), square().knot(edge + 1)];
            let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            assert!(hull.min().distance(low) < 1e-2 && hull.max().distance(high) < 1e-2, "{edge}: {hull:?}");
        }
    }

    #[test]
    fn copies_run_from_knot_to_knot() {
        let mut curve = square();
        // The first edge is a copy of the two after it, mirrored and backwards.
        curve.edges[0] = Some(ArcCopy { from: 1, span: 2, reversed: true, c: -0.5 });
        assert!(curve.is_sound());
        let system = curve.to_states().unwrap();
        assert_eq!(system.states()[1].iter().map(|part| part.from).collect::<Vec<_>>(), [2, 3]);
        let map = system.states()[1][0].map;
        // Backwards: where the arc ends the edge begins.
        assert!(map.apply(curve.knots[3]).distance(curve.knots[0]) < 1e-12);
        assert!(map.apply(curve.knots[1]).distance(curve.knots[1]) < 1e-12);
    }

    #[test]
    fn what_is_too_long_or_unsound_is_refused() {
        let ring = ClosedCurve::polygon((0..64).map(|k| DVec2::from_angle(0.09 * f64::from(k))).collect());
        assert_eq!(ring.to_states().unwrap_err().code(), "too-many-states");
        let mut curve = square();
        curve.edges[0] = Some(ArcCopy { from: 0, span: usize::MAX, reversed: false, c: 0.1 });
        assert_eq!(curve.to_states().unwrap_err().code(), "too-many-maps");
        curve.edges[0] = Some(ArcCopy { from: usize::MAX, span: 2, reversed: false, c: 0.1 });
        assert_eq!(curve.to_states().unwrap_err().code(), "state");
        curve.knots[1] = DVec2::NAN;
        curve.edges[0] = None;
        assert_eq!(curve.to_states().unwrap_err().code(), "not-finite");
    }

    #[test]
    fn a_chain_is_the_same_curve_and_each_state_runs_on_from_copy_to_copy() {
        let mut curve = ClosedCurve::polygon(
            (0..9)
                .map(|k| {
                    DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 9.0)
                        * (1.0 + 0.3 * f64::from(k % 2))
                })
                .collect(),
        );
        curve.edges[0] = Some(ArcCopy { from: 3, span: 3, reversed: true, c: -0.5 });
        curve.edges[4] = Some(ArcCopy { from: 8, span: 2, reversed: true, c: 0.4 });
        curve.edges[7] = Some(ArcCopy { from: 0, span: 3, reversed: false, c: 0.3 });
        assert!(curve.is_sound());
        let (chain, states) = (curve.to_chain().unwrap(), curve.to_states().unwrap());
        let (a, b) = (&Hull::of_states(&chain)[0], &Hull::of_states(&states)[0]);
        // Hulls are polygons around shapes, to some 1e-5.
        assert!(a.min().distance(b.min()) + a.max().distance(b.max()) < 1e-4, "{a:?} {b:?}");
        // The first point of each state is that of its first map, as the core takes it.
        let first = chain.points();
        for (state, maps) in chain.states().iter().enumerate().skip(2) {
            let (edge, backward) = [(0, false), (4, false), (7, false), (4, true), (0, true)][state - 2];
            let begin = curve.knot(edge + usize::from(backward));
            assert!(first[state].distance(begin) < 1e-9, "state {state}: {maps:?}");
        }
    }

    #[test]
    fn a_long_chain_is_parted_into_arcs() {
        let ring = ClosedCurve::polygon((0..150).map(|k| DVec2::from_angle(0.04 * f64::from(k))).collect());
        let chain = ring.to_chain().unwrap();
        assert_eq!(chain.states().iter().map(Vec::len).collect::<Vec<_>>(), [3, 50, 50, 50, 2]);
    }
}
