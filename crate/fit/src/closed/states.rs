//! A closed curve as a graph-directed system: its edges are made of copies of each other.

use frond_core::{Affine2, DirectedError, DirectedIfs, DirectedMap, MAX_MAPS, MAX_STATES};
use glam::DVec2;

use crate::closed::ClosedCurve;

impl ClosedCurve {
    /// The curve as a graph-directed system: state 0 is all of it, state i + 1 is edge i. An edge that copies an arc is
    /// made of copies of the arc's edges, a straight one of two halves of itself.
    ///
    /// # Errors
    /// [`DirectedError`] where there are more edges than states may be, an arc is too long, or the curve is not sound.
    pub fn to_states(&self) -> Result<DirectedIfs, DirectedError> {
        let count = self.knots.len();
        if count >= MAX_STATES {
            return Err(DirectedError::TooManyStates { count: count + 1 });
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
            let map = self.map(edge).map_or(Affine2::IDENTITY, |(linear, begin)| {
                Affine2::new(linear, self.knots[edge] - linear * begin)
            });
            states.push(
                (copy.from..copy.from + copy.span)
                    .map(|k| DirectedMap { from: k % count + 1, map })
                    .collect(),
            );
        }
        DirectedIfs::new(states)
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
}
