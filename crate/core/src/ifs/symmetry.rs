//! Isometries that leave a shape as it is.

use glam::{DMat2, DVec2};

use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::linear::polar2::orthogonal;

/// How far numbers of conjugate maps may differ, in proportion to the shape.
const SAME_NUMBER: f64 = 1e-9;

/// The rotations and reflections of the plane that map the attractor of `ifs` onto itself, as far as its maps show:
/// those with which conjugation permutes the maps. The identity comes first, then the other rotations by their
/// angle, then the reflections.
///
/// If `sigma` is one of them, `w_i o sigma` has the same image of the shape as `w_i`, so that each map may be replaced
/// so on its own without changing the attractor.
#[must_use]
pub(crate) fn symmetries(ifs: &Ifs) -> Vec<Affine2> {
    let maps = ifs.maps();
    let mut found = vec![Affine2::IDENTITY];
    let fixed: Option<Vec<DVec2>> = maps.iter().map(|map| map.fixed_point()).collect();
    let Some(fixed) = fixed else { return found };
    // A symmetry permutes the fixed points, and leaves their centre where it is.
    let centre = fixed.iter().sum::<DVec2>() / fixed.len() as f64;
    let away = |p: &DVec2| p.distance(centre);
    let Some(far) = fixed.iter().copied().max_by(|p, q| away(p).total_cmp(&away(q))) else { return found };
    let size = away(&far);
    if !(size > 0.0 && size.is_finite() && centre.is_finite()) {
        return found;
    }
    for reflects in [false, true] {
        let mut angles: Vec<f64> = fixed
            .iter()
            .filter(|p| (away(p) - size).abs() <= SAME_NUMBER * size)
            .map(|p| {
                let (start, end) = ((far - centre).to_angle(), (p - centre).to_angle());
                // The reflection R(angle) diag(1, -1) takes the direction `start` to `angle - start`.
                let angle = if reflects { end + start } else { end - start };
                let angle = angle.rem_euclid(std::f64::consts::TAU);
                if angle > std::f64::consts::TAU - 1e-9 { 0.0 } else { angle }
            })
            .collect();
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        for angle in angles {
            let linear = orthogonal(angle, reflects);
            let sigma = Affine2::new(linear, centre - linear * centre);
            if (reflects || angle > 1e-9) && permutes(sigma, maps, size) {
                found.push(sigma);
            }
        }
    }
    found
}

/// Whether conjugation by an isometry permutes maps, each as often as it is there.
fn permutes(sigma: Affine2, maps: &[Affine2], size: f64) -> bool {
    let mut left: Vec<Affine2> = maps.to_vec();
    maps.iter().all(|&map| {
        let Some(moved) = map.conjugate(sigma) else { return false };
        let same = |other: &Affine2| {
            let linear: DMat2 = other.linear - moved.linear;
            let moved = (other.translation - moved.translation).length();
            linear.x_axis.length() + linear.y_axis.length() <= SAME_NUMBER
                && moved <= SAME_NUMBER * size * 10.0
        };
        left.iter().position(same).map(|k| left.swap_remove(k)).is_some()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shrunk(r: f64, corners: &[[f64; 2]]) -> Ifs {
        let map = |&[x, y]: &[f64; 2]| Affine2::from_row([r, 0.0, 0.0, r, (1.0 - r) * x, (1.0 - r) * y]);
        Ifs::new(corners.iter().map(map).collect()).unwrap()
    }

    fn count(ifs: &Ifs) -> (usize, usize) {
        let all = symmetries(ifs);
        let reflecting = all.iter().filter(|sigma| sigma.determinant() < 0.0).count();
        (all.len() - reflecting, reflecting)
    }

    #[test]
    fn regular_shapes_have_theirs() {
        let h = 0.75_f64.sqrt();
        assert_eq!(count(&shrunk(0.5, &[[0.0, 0.0], [1.0, 0.0], [0.5, h]])), (3, 3));
        assert_eq!(count(&shrunk(0.4, &[[5.0, 0.0], [6.0, 0.0], [6.0, 1.0], [5.0, 1.0]])), (4, 4));
        assert_eq!(count(&shrunk(0.5, &[[0.0, 0.0], [1.0, 0.0], [0.2, h]])), (1, 0));
        assert_eq!(count(&shrunk(0.5, &[[0.0, 0.0], [1.0, 0.0]])), (2, 2));
        // Halves turned outward: Levy's curve has one mirror, Heighway's dragon nothing.
        let ifs = |rows: [[f64; 6]; 2]| Ifs::new(rows.map(Affine2::from_row).to_vec()).unwrap();
        let levy = ifs([[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [0.5, 0.5, -0.5, 0.5, 0.5, 0.5]]);
        assert_eq!(count(&levy), (1, 1));
        let dragon = ifs([[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]]);
        assert_eq!(count(&dragon), (1, 0));
    }

    #[test]
    fn shapes_without_extent_have_none_but_the_identity() {
        let point = Ifs::new(vec![Affine2::similitude(0.5, 1.0, DVec2::ZERO); 3]).unwrap();
        assert_eq!(symmetries(&point), [Affine2::IDENTITY]);
    }
}
