//! What the parts of a morph come from: which edge a place is on, and what each edge copies.

use super::CurveMorph;
use super::knot_ring::Ring;
use super::morphed_curve::MorphedCurve;

impl CurveMorph {
    /// For each edge the arc that it copies at A and the one at B, by the knot it begins at and its number of edges;
    /// none where it is straight. Knots are those that both curves have in common.
    #[must_use]
    pub fn arcs(&self) -> Vec<[Option<(usize, usize)>; 2]> {
        let arc = |ring: &Ring, edge: usize| ring.edges[edge].as_ref().map(|rough| (rough.from, rough.span));
        (0..self.knots()).map(|edge| [arc(&self.rings[0], edge), arc(&self.rings[1], edge)]).collect()
    }
}

impl MorphedCurve {
    /// The edge that t lies on, by the knot it begins at: of the first where t is not finite.
    #[must_use]
    pub fn edge_at(&self, t: f64) -> usize {
        if t.is_finite() { self.locate(t).0 } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use crate::{CurveMorph, curve_presets};

    #[test]
    fn edges_are_met_in_order_and_copy_arcs_that_exist() {
        let presets = curve_presets();
        let (maple, oak) = (&presets[0].curve, &presets[1].curve);
        let morph = CurveMorph::new(maple, Some(oak)).expect("presets are sound");
        let arcs = morph.arcs();
        assert_eq!(arcs.len(), morph.knots());
        assert!(arcs.iter().flatten().flatten().all(|&(from, span)| from < arcs.len() && span >= 1));
        for end in [0, 1] {
            assert!(arcs.iter().filter(|pair| pair[end].is_some()).count() >= [maple, oak][end].copies());
        }
        let morphed = morph.at(0.3);
        let met: Vec<_> = (0..4000).map(|i| morphed.edge_at(f64::from(i) / 4000.0)).collect();
        assert!(met.is_sorted() && met[0] == 0 && met[3999] + 1 == arcs.len());
        assert_eq!(morphed.edge_at(1.0 + 0.5), morphed.edge_at(0.5));
        assert_eq!(morphed.edge_at(f64::NAN), 0);
    }

    #[test]
    fn one_curve_copies_what_it_copied() {
        let flake =
            curve_presets().into_iter().find(|preset| preset.id == "snowflake").expect("there is one");
        let arcs = CurveMorph::new(&flake.curve, None).expect("presets are sound").arcs();
        for (pair, edge) in arcs.iter().zip(&flake.curve.edges) {
            let arc = edge.as_ref().map(|copy| (copy.from, copy.span));
            assert_eq!(*pair, [arc, arc]);
        }
    }
}
