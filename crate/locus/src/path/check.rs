//! Along a path: where it is, and where it breaks.

use frond_core::{Affine2, Morph, along};
use glam::DVec3;

use crate::decide::{Scratch, decide};
use crate::grid::LocusGrid;
use crate::path::field::{GAP_WITHOUT_ATTRACTOR, gap_of};
use crate::verdict::Sample;

/// A family of systems over (u, v, w), of the plane or of space.
pub(crate) trait Parameters {
    /// What samples are decided in.
    type Memory: Default;

    /// Decides one parameter.
    fn sample(&self, at: DVec3, epsilon: f64, memory: &mut Self::Memory) -> Sample;
}

impl Parameters for Morph {
    type Memory = (Scratch, Vec<Affine2>);

    fn sample(&self, at: DVec3, epsilon: f64, (scratch, maps): &mut Self::Memory) -> Sample {
        self.fill3(at.x, at.y, at.z, maps);
        decide(maps, epsilon, LocusGrid::budget(maps.len()), scratch)
    }
}

/// What [`check_path`] found.
#[derive(Clone, Debug, PartialEq)]
pub struct PathCheck {
    /// The widest relative gap met; infinite where there is no attractor, 0 where all holds.
    pub gap: f64,
    /// Whether no sample was broken: none apart by more than epsilon, none undecided, none without attractor.
    pub holds: bool,
    /// The broken stretches, as fractions of the length of the path in (u, v, w).
    pub breaks: Vec<(f64, f64)>,
    /// The parameter where the gap was widest; `None` where all holds.
    pub worst: Option<DVec3>,
}

/// Decides `samples` parameters (u, v, w) spread evenly along a path, both ends included, and reports where it
/// breaks. Of no points nothing is known, and so they do not hold.
#[must_use]
pub fn check_path(morph: &Morph, points: &[DVec3], epsilon: f64, samples: usize) -> PathCheck {
    judge(morph, points, epsilon, samples, |_| ())
}

/// [`check_path`], which also tells each broken sample.
pub(crate) fn judge<P: Parameters>(
    morph: &P,
    points: &[DVec3],
    epsilon: f64,
    samples: usize,
    mut tell: impl FnMut(DVec3),
) -> PathCheck {
    if points.is_empty() {
        return PathCheck { gap: f64::INFINITY, holds: false, breaks: Vec::new(), worst: None };
    }
    let mut check = PathCheck { gap: 0.0, holds: true, breaks: Vec::new(), worst: None };
    let samples = samples.max(2);
    let half = 0.5 / (samples - 1) as f64;
    let mut memory = P::Memory::default();
    let mut was_broken = false;
    for k in 0..samples {
        let t = k as f64 / (samples - 1) as f64;
        let at = along(points, t);
        let gap = gap_of(morph.sample(at, epsilon, &mut memory), epsilon);
        let broken = gap > 0.0;
        if broken {
            let gap = if gap >= GAP_WITHOUT_ATTRACTOR { f64::INFINITY } else { gap };
            tell(at);
            check.holds = false;
            if check.worst.is_none() || gap > check.gap {
                check.worst = Some(at);
                check.gap = gap;
            }
            match check.breaks.last_mut() {
                Some(last) if was_broken => last.1 = (t + half).min(1.0),
                _ => check.breaks.push(((t - half).max(0.0), (t + half).min(1.0))),
            }
        }
        was_broken = broken;
    }
    check
}
