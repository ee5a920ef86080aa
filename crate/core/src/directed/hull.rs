//! Convex polygons around the states of a graph-directed system.

use glam::{DMat2, DVec2};

use crate::bounds::hull2::{DIRECTIONS, Directions, Hull, Link, MOST_ROUNDS};
use crate::directed::contraction::StateDisc;
use crate::directed::system::DirectedIfs;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;

/// Bounds that are computed in all, where many rounds are needed.
const MOST_BOUNDS: usize = 20_000_000;

/// A disc of a state as coordinates: from the unit disc to the plane, and back.
#[derive(Clone, Copy)]
struct Place {
    origin: DVec2,
    disc: StateDisc,
    unit: f64,
}

impl Place {
    fn of(disc: &StateDisc) -> Self {
        // A state of one point has no size of its own.
        let unit = if disc.radius > 0.0 { disc.radius } else { 1.0 };
        Self { origin: disc.centre, disc: *disc, unit }
    }

    /// The map from the coordinates of `inner` to these.
    fn map(&self, map: Affine2, inner: &Self) -> Affine2 {
        // Divided last: of a state that is all but a point the inverse of its size is infinite.
        let linear = self.disc.to_round * map.linear * inner.disc.from_round * inner.unit;
        let shift = self.disc.to_round * (map.apply(inner.origin) - self.origin);
        let [x, y] = [linear.x_axis, linear.y_axis].map(|column| column / self.unit);
        Affine2::new(DMat2::from_cols(x, y), shift / self.unit)
    }

    fn to_plane(self, p: DVec2) -> DVec2 {
        self.origin + self.disc.from_round * (p * self.unit)
    }
}

impl Hull {
    /// The polygons around the states of a graph-directed system.
    ///
    /// The support functions of all of them obey `h_i(d) = max ( h_from(M^T d) + d . t )` over the maps of state i, and
    /// are lowered together as those of one attractor are.
    #[must_use]
    pub fn of_states(system: &DirectedIfs) -> Vec<Self> {
        if let [maps] = system.states() {
            let one = Ifs::new(maps.iter().map(|part| part.map).collect());
            if let Ok(ifs) = one {
                return vec![Self::of(&ifs)];
            }
        }
        let places: Vec<Place> = system.contraction().discs.iter().map(Place::of).collect();
        let directions = Directions::new();
        let links: Vec<Vec<(usize, [Link; DIRECTIONS])>> = system
            .states()
            .iter()
            .zip(&places)
            .map(|(maps, place)| {
                let link = |map: Affine2| {
                    let transposed = map.linear.transpose();
                    directions.directions.map(|d| directions.link(transposed, d, map.translation))
                };
                maps.iter().map(|part| (part.from, link(place.map(part.map, &places[part.from])))).collect()
            })
            .collect();
        let mut support = vec![[1.0; DIRECTIONS]; places.len()];
        // Maps that hardly shrink get there slowly, and each round changes little.
        let arrows: usize = links.iter().map(Vec::len).sum();
        let near = (0.01 * (1.0 - system.contraction().factor)).min(1e-4);
        for _ in 0..MOST_ROUNDS.max(MOST_BOUNDS / (DIRECTIONS * arrows)) {
            let mut change = 0.0_f64;
            for state in 0..places.len() {
                for k in 0..DIRECTIONS {
                    let bound = |(from, links): &(usize, [Link; DIRECTIONS])| links[k].bound(&support[*from]);
                    let new = links[state].iter().map(bound).fold(f64::NEG_INFINITY, f64::max);
                    // Never above the last bound: both hold.
                    let lower = new.min(support[state][k]);
                    change = change.max(support[state][k] - lower);
                    support[state][k] = lower;
                }
            }
            if change < near {
                break;
            }
        }
        let polygon = |(place, support): (&Place, [f64; DIRECTIONS])| {
            let corners = directions.polygon(&support.map(|value| value + 1e-12));
            Self::around(corners.into_iter().map(|p| place.to_plane(p)).collect())
        };
        places.iter().zip(support).map(polygon).collect()
    }
}
