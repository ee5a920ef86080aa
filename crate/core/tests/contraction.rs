//! Coordinates that were found for some maps serve others that are much like them.

use frond_core::{Affine2, Contraction};
use glam::DVec2;

/// Three similarities of one size about three corners, sheared so far that none shrinks in the plane as it is.
fn sheared(size: f64) -> Vec<Affine2> {
    let shear = Affine2::from_row([1.0, 50.0, 0.0, 1.0, 0.0, 0.0]);
    let turned = [0.0, 2.0, 4.0].map(|angle| Affine2::similitude(size, angle, DVec2::new(angle, size)));
    turned.iter().map(|map| map.conjugate(shear).unwrap()).collect()
}

#[test]
fn the_coordinates_of_maps_serve_others_like_them() {
    let found = Contraction::find(&sheared(0.5)).unwrap();
    assert!(sheared(0.5)[1].norm() > 1.0);
    let near = sheared(0.51);
    let other = Contraction::in_coordinates_of(&found, &near).unwrap();
    assert_eq!(other.to_round, found.to_round);
    assert!((0.5..0.53).contains(&other.factor), "{}", other.factor);
    for map in &near {
        // Each takes the disc into itself.
        let far = (other.to_round * (map.apply(other.centre) - other.centre)).length();
        let norm = Affine2::new(other.to_round * map.linear * other.from_round, DVec2::ZERO).norm();
        assert!(norm <= other.factor * (1.0 + 1e-12), "{norm}");
        assert!(far + norm * other.radius <= other.radius * (1.0 + 1e-9), "{far} {norm}");
    }
}

#[test]
fn they_do_not_serve_slower_maps_nor_lists_that_are_none() {
    let found = Contraction::find(&sheared(0.5)).unwrap();
    for size in [0.6, 0.95, 1.1, f64::NAN] {
        let maps: Vec<Affine2> =
            sheared(0.5).iter().map(|map| Affine2::new(map.linear * (size / 0.5), map.translation)).collect();
        assert_eq!(Contraction::in_coordinates_of(&found, &maps), None, "{size}");
    }
    assert_eq!(Contraction::in_coordinates_of(&found, &[]), None);
}

#[test]
fn other_translations_change_no_more_than_the_disc() {
    for size in [0.5, 0.8] {
        let maps = sheared(size);
        let shifted: Vec<Affine2> = (0..3)
            .map(|k| Affine2::new(maps[k].linear, maps[k].translation * 3.0 + DVec2::splat(k as f64)))
            .collect();
        let (found, other) = (Contraction::find(&maps).unwrap(), Contraction::find(&shifted).unwrap());
        assert_ne!(found, other);
        assert_eq!(found.moved(&shifted), Some(other));
    }
    let found = Contraction::find(&sheared(0.5)).unwrap();
    assert_eq!(found.moved(&[Affine2::similitude(f64::NAN, 0.0, DVec2::ZERO)]), None);
}
