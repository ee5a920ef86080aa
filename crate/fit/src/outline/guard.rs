//! Keeps fits from crossing themselves where their outline does not.

use glam::DVec2;

use super::{Outline, contacts};

/// The most contacts of an outline that are kept in mind: beyond, it is too tangled to be followed.
const MOST_SPOTS: usize = 256;

/// A fit may cross itself so near, in parts of the diagonal, to where its outline meets itself.
const SPOT_REACH: f64 = 0.01;

/// Where a fit may cross itself: where its outline does, and nowhere else.
#[derive(Clone, Debug)]
pub struct Guard {
    spots: Vec<DVec2>,
    reach: f64,
}

impl Guard {
    /// That of an outline; none where it meets itself so often that nothing can be asked.
    #[must_use]
    pub fn new(outline: &Outline) -> Option<Self> {
        let points = outline.points();
        let found = contacts(points, MOST_SPOTS)?;
        if found.len() >= MOST_SPOTS {
            return None;
        }
        let spots = found.into_iter().map(|pair| place(points, pair)).collect();
        Some(Self { spots, reach: SPOT_REACH * outline.diagonal() })
    }

    /// Whether the outline itself meets itself nowhere: then this holds for what passes.
    #[must_use]
    pub fn is_strict(&self) -> bool {
        self.spots.is_empty()
    }

    /// Whether a closed polyline meets itself at most where the outline does.
    #[must_use]
    pub fn passes(&self, line: &[DVec2]) -> bool {
        self.faults(line).is_some_and(|faults| faults.is_empty())
    }

    /// Some pairs of sides that meet where the outline does not; none where there are too many to tell.
    pub(crate) fn faults(&self, line: &[DVec2]) -> Option<Vec<(usize, usize)>> {
        let most = if self.is_strict() { 64 } else { 16 * MOST_SPOTS };
        let mut found = contacts(line, most)?;
        let full = found.len() >= most;
        found.retain(|&pair| {
            let at = place(line, pair);
            self.spots.iter().all(|spot| spot.distance(at) > self.reach)
        });
        if full && found.is_empty() { None } else { Some(found) }
    }
}

/// About where two sides meet.
fn place(points: &[DVec2], (i, j): (usize, usize)) -> DVec2 {
    let side = |i: usize| [points[i], points[(i + 1) % points.len()]];
    let ([a, b], [c, d]) = (side(i), side(j));
    let across = (b - a).perp_dot(d - c);
    let share = (c - a).perp_dot(d - c) / across;
    if share.is_finite() { a.lerp(b, share.clamp(0.0, 1.0)) } else { b.midpoint(c) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_its_outline_does_a_fit_may_do_there_alone() {
        let ring = |turns: f64, wobble: f64| -> Vec<DVec2> {
            let at = |i: i32| std::f64::consts::TAU * turns * f64::from(i) / 200.0;
            (0..200).map(|i| DVec2::from_angle(at(i)) * (1.0 + wobble * at(i).sin())).collect()
        };
        let eight: Vec<_> = ring(1.0, 0.0).iter().map(|p| DVec2::new(p.x, p.x * p.y)).collect();
        let circle = Outline::new(&ring(1.0, 0.2)).unwrap();
        let strict = Guard::new(&circle).unwrap();
        assert!(strict.is_strict() && strict.passes(circle.points()) && !strict.passes(&eight));
        let lax = Guard::new(&Outline::new(&eight).unwrap()).unwrap();
        assert!(!lax.is_strict() && lax.passes(&eight));
        let aside: Vec<_> = eight.iter().map(|p| *p + DVec2::X).collect();
        assert!(!lax.passes(&aside), "it crosses elsewhere");
        let tangle: Vec<_> = (0..999).map(|i| DVec2::from_angle(f64::from(i) * 2.5)).collect();
        assert!(Guard::new(&Outline::new(&tangle).unwrap()).is_none());
    }
}
