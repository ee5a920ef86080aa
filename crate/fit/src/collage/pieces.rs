//! The paper's fit of an outline, and its polyline piece by piece.

use glam::DVec2;

use super::{CollageError, CollageFit, CollageOptions, fit_collage};
use crate::outline::{Outline, features};

/// The most points of its polyline.
const MOST_DRAWN: usize = 1 << 17;

impl CollageFit {
    /// The fit of so many feature points of an outline.
    ///
    /// # Errors
    /// As [`fit_collage`].
    pub fn of(outline: &Outline, count: usize, options: &CollageOptions) -> Result<Self, CollageError> {
        let ring: Vec<_> = features(outline, count).into_iter().map(|i| outline.points()[i]).collect();
        fit_collage(&ring, options)
    }

    /// The attractor, piece by piece with both ends, at eight times as many points as there are feature points.
    #[must_use]
    pub fn pieces(&self) -> Vec<Vec<DVec2>> {
        let points = self.maps.len() * self.intervals;
        let finer = (MOST_DRAWN / points.max(1)).clamp(1, 8);
        // The same maps between more points: a domain begins where it did.
        let mut fine = self.clone();
        fine.intervals *= finer;
        fine.maps.iter_mut().for_each(|map| map.start *= finer);
        let (points, ends) = fine.attractor();
        let piece = |(part, end): (&[DVec2], DVec2)| part.iter().copied().chain([end]).collect();
        points.chunks(fine.intervals).zip(ends).map(piece).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grown::maple_leaf;

    #[test]
    fn pieces_of_the_papers_fit_pass_its_points_and_meet_where_they_are_tied() {
        let outline = Outline::new(&maple_leaf(2)).unwrap();
        for tied in [false, true] {
            let options = CollageOptions { tied, ..CollageOptions::default() };
            let fit = CollageFit::of(&outline, 261, &options).unwrap();
            let pieces = fit.pieces();
            assert_eq!(pieces.len(), 29);
            let (points, _) = fit.attractor();
            for (k, piece) in pieces.iter().enumerate() {
                assert_eq!(piece.len(), 8 * fit.intervals + 1);
                for m in 0..fit.intervals {
                    let missed = piece[8 * m].distance(points[k * fit.intervals + m]);
                    assert!(missed < 1e-9, "{missed}");
                }
            }
            let gap = |k: usize| pieces[k][pieces[k].len() - 1].distance(pieces[(k + 1) % 29][0]);
            let widest = (0..29).map(gap).fold(0.0, f64::max);
            assert!((widest - fit.gaps().0).abs() < 1e-9);
            assert_eq!(widest < 1e-9, tied);
        }
    }
}
