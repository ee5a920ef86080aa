//! The fast answer in space: one parameter of a locus.

use frond_core::{Affine3, IfsError, SupportTable3};

use crate::magnification::Magnification;
use crate::space::bracket::Closest;
use crate::space::frame::Frame3;
use crate::verdict::{Gap, Sample, State};

/// The memory that [`decide3`] works in; keep one for many calls.
#[derive(Clone, Debug, Default)]
pub struct Scratch3 {
    frame: Frame3,
    table: SupportTable3,
    closest: Closest,
}

/// Cells along an edge of the cube of directions: few, since a finer table takes longer than it saves.
const TABLE_CELLS: usize = 3;
/// How far apart the bounds of a gap may be.
const BRACKET_WIDTH: f64 = 0.05;
/// Volumes are computed: what adds up to more than 1 by this does so exactly.
const VOLUME_THAT_FILLS: f64 = 1.0 + 1e-12;

/// Decides whether the attractor of raw maps of space is connected, and how wide its widest gap is: what
/// [`decide`](crate::decide) does in the plane.
///
/// `epsilon` is relative to the diameter of the attractor; `budget` limits the pairs of pieces looked at (20,000 is
/// plenty for a few maps). `Disconnected` is proved, rounding errors included. `Connected` is the answer only for one
/// map, and for two maps whose volumes leave no room between their pieces. The answer depends on the arguments alone.
pub fn decide3(maps: &[Affine3], epsilon: f64, budget: usize, scratch: &mut Scratch3) -> Sample {
    if let Some(magnification) = Magnification::of3(maps) {
        return decide3(&magnification.magnify3(maps), epsilon, budget, scratch);
    }
    let Scratch3 { frame, table, closest } = scratch;
    match frame.set(maps) {
        Ok(()) => {}
        Err(IfsError::Unproved) => return Sample { state: State::Undecided, gap: f32::NAN },
        // Too large to compute with, which says nothing about the attractor.
        Err(IfsError::NotFinite { .. }) if maps.iter().all(|map| map.is_finite()) => {
            return Sample { state: State::Undecided, gap: f32::NAN };
        }
        Err(_) => return Sample { state: State::NoAttractor, gap: f32::NAN },
    }
    let whole = |state| Sample { state, gap: 0.0 };
    if frame.point || maps.len() == 1 {
        return whole(if maps.len() == 1 { State::Connected } else { State::Touching });
    }
    if maps.len() == 2 && maps.iter().map(|map| map.determinant().abs()).sum::<f64>() >= VOLUME_THAT_FILLS {
        return whole(State::Connected);
    }
    table.set(&frame.maps, frame.factor, TABLE_CELLS, 0.02);
    let diameter = table.diameter(frame.linear);
    let resolution = frame.resolution(epsilon.max(0.0), diameter);
    closest.begin(frame, table);
    let found = closest.bracket(frame, table, resolution, BRACKET_WIDTH, budget);
    // No gap is wider than the shape.
    let Some(Gap { lower, upper }) = found.gap(diameter) else {
        return Sample { state: State::Undecided, gap: 1.0 };
    };
    if upper <= resolution {
        whole(State::Touching)
    } else if lower > 0.0 {
        Sample { state: State::Disconnected, gap: (f64::midpoint(lower, upper) / diameter) as f32 }
    } else {
        Sample { state: State::Undecided, gap: (upper / diameter) as f32 }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;

    fn shrunk(ratio: f64, corners: &[DVec3]) -> Vec<Affine3> {
        let map = |&c: &DVec3| Affine3::similitude(ratio, DQuat::IDENTITY, c * (1.0 - ratio));
        corners.iter().map(map).collect()
    }

    fn decided(maps: &[Affine3]) -> Sample {
        decide3(maps, 1.0 / 600.0, 50_000, &mut Scratch3::default())
    }

    const TETRAHEDRON: [DVec3; 4] = [
        DVec3::new(1.0, 1.0, 1.0),
        DVec3::new(1.0, -1.0, -1.0),
        DVec3::new(-1.0, 1.0, -1.0),
        DVec3::new(-1.0, -1.0, 1.0),
    ];

    #[test]
    fn a_tetrahedron_holds_from_one_half_on() {
        for (ratio, state) in [
            (0.5, State::Touching),
            (0.52, State::Touching),
            (0.6, State::Touching),
            (0.4995, State::Touching),
            (0.49, State::Disconnected),
            (0.3, State::Disconnected),
        ] {
            let sample = decided(&shrunk(ratio, &TETRAHEDRON));
            assert_eq!(sample.state, state, "{ratio}: {sample:?}");
            if state == State::Disconnected {
                // Along an edge as long as the diameter, 1 - 2 r of it is bare.
                let bare = 1.0 - 2.0 * ratio;
                assert!((f64::from(sample.gap) / bare - 1.0).abs() < 0.12, "{ratio}: {sample:?}");
            }
        }
    }

    #[test]
    fn what_is_no_attractor_is_called_so() {
        assert_eq!(decided(&[]).state, State::NoAttractor);
        assert_eq!(decided(&shrunk(1.0, &TETRAHEDRON)).state, State::NoAttractor);
        assert_eq!(decided(&[Affine3::moving(DVec3::splat(f64::NAN))]).state, State::NoAttractor);
        assert_eq!(decided(&shrunk(0.5, &[DVec3::ONE; 3])).state, State::Touching);
        assert_eq!(decided(&shrunk(0.5, &[DVec3::ONE])).state, State::Connected);
        assert_eq!(decided(&shrunk(0.9, &TETRAHEDRON[..2])).state, State::Connected);
        let many = vec![Affine3::scaling(DVec3::splat(0.5)); 100_000];
        assert_eq!(decided(&many).state, State::NoAttractor);
    }

    #[test]
    fn nothing_is_remembered_from_the_last_call() {
        let mut scratch = Scratch3::default();
        let systems = [shrunk(0.45, &TETRAHEDRON), shrunk(0.5, &TETRAHEDRON), shrunk(0.3, &TETRAHEDRON[..2])];
        let first: Vec<Sample> = systems.iter().map(|maps| decided(maps)).collect();
        for k in [2, 0, 1, 0, 2] {
            assert_eq!(decide3(&systems[k], 1.0 / 600.0, 50_000, &mut scratch), first[k]);
        }
        assert_eq!(decide3(&systems[0], 1e-3, 0, &mut scratch).state, State::Disconnected);
        assert_eq!(decide3(&shrunk(0.499_999, &TETRAHEDRON), 0.0, 10, &mut scratch).state, State::Undecided);
        for epsilon in [f64::NAN, -1.0] {
            assert_ne!(decide3(&systems[1], epsilon, 5000, &mut scratch).state, State::Disconnected);
        }
    }
}
