//! Where a bend looks at its mesh.

use frond_core::{Affine2, Ifs};
use glam::DVec2;

use crate::continuity::support::Shape;

/// The most words that are looked at.
const MOST_WORDS: usize = 1024;

/// A box that holds the shape and the images of the anchors under all words.
///
/// With corners it is theirs, since the maps take them into themselves. Else short words are looked at one by one, and
/// longer ones end in points of a disc that the maps take into itself, of which those short words are taken again.
pub(crate) fn region(ifs: &Ifs, shape: &Shape, anchors: &[DVec2]) -> (DVec2, DVec2) {
    if shape.corners.is_some() {
        return (shape.low, shape.high);
    }
    let found = ifs.contraction();
    let to_round = |point: DVec2| found.to_round * (point - found.centre);
    let far = anchors.iter().map(|&anchor| to_round(anchor).length()).fold(found.radius, f64::max);
    // In blocks of several letters, a word may end amid one, where maps need not shrink.
    let norm =
        |map: &Affine2| Affine2::new(found.to_round * map.linear * found.from_round, DVec2::ZERO).norm();
    let stretch = ifs.maps().iter().map(norm).fold(0.0, f64::max);
    let shift = ifs.maps().iter().map(|map| to_round(map.apply(found.centre)).length()).fold(0.0, f64::max);
    let radius = (1..found.length).fold(far, |radius, _| radius.max(shift + stretch * radius));

    let (mut low, mut high) = (shape.low, shape.high);
    let mut hold = |point: DVec2, room: DVec2| {
        low = low.min(point - room);
        high = high.max(point + room);
    };
    let mut words = vec![Affine2::IDENTITY];
    while words.len() * ifs.len() <= MOST_WORDS && ifs.len() > 1 {
        for word in &words {
            anchors.iter().for_each(|&anchor| hold(word.apply(anchor), DVec2::ZERO));
        }
        words = words.iter().flat_map(|word| ifs.maps().iter().map(move |map| *word * *map)).collect();
    }
    for word in &words {
        let rows = (word.linear * found.from_round).transpose();
        hold(word.apply(found.centre), radius * DVec2::new(rows.x_axis.length(), rows.y_axis.length()));
    }
    (low, high)
}
