//! Shadows of the presets of space.

use frond_core::{
    Affine3, ChaosGame3, EpsilonFrame, Hull, Ifs, Ifs3, Plane, ProjectError, epsilon_projection,
    exact_projection, invariant_directions,
};
use frond_scene::preset3;
use glam::{DMat3, DQuat, DVec2, DVec3};
use proptest::prelude::*;

fn maps(id: &str) -> Vec<Affine3> {
    preset3(id).unwrap().maps.into_iter().map(Affine3::from_row).collect()
}

#[test]
fn the_shadow_of_the_sponge_from_the_front_is_an_attractor_of_its_own() {
    for (id, direction) in
        [("sponge", DVec3::X), ("tetrahedron", DVec3::new(1.0, 2.0, -0.5)), ("pyramid", DVec3::Z)]
    {
        let plane = Plane::across(direction).unwrap();
        let flat = exact_projection(&maps(id), &plane).unwrap();
        let hull = Hull::of(&Ifs::new(flat.clone()).unwrap());
        let mut positions = vec![0.0; 30_000];
        let mut pieces = vec![0; 10_000];
        ChaosGame3::new(&Ifs3::new(maps(id)).unwrap(), 1).fill(&mut positions, &mut pieces);
        let shadows = plane.shadows(&positions);
        // Each shadow of a point lies in the shadow's piece of the same map.
        for (shadow, piece) in shadows.as_chunks::<2>().0.iter().zip(&pieces) {
            let shadow = DVec2::new(shadow[0].into(), shadow[1].into());
            let map = flat[usize::from(*piece)];
            assert!(shadow.distance(map.apply(hull.centre())) <= map.norm() * hull.radius() + 1e-5, "{id}");
        }
    }
}

#[test]
fn a_direction_that_is_turned_is_refused_by_the_map_that_turns_it() {
    let plane = Plane::across(DVec3::X).unwrap();
    assert_eq!(exact_projection(&maps("dragon"), &plane), Err(ProjectError::NotKept { map: 0 }));
    let mut pair = maps("sponge");
    pair[7].linear *= DMat3::from_quat(DQuat::from_rotation_z(1e-6));
    assert_eq!(exact_projection(&pair, &plane), Err(ProjectError::NotKept { map: 7 }));
}

#[test]
fn directions_that_the_presets_keep_are_found() {
    assert_eq!(invariant_directions(&maps("sponge")).len(), 3);
    assert!(invariant_directions(&maps("dragon-folded")).is_empty());
    for id in ["sponge", "triangle", "pyramid"] {
        for direction in invariant_directions(&maps(id)) {
            let plane = Plane::across(direction).unwrap();
            assert!(exact_projection(&maps(id), &plane).is_ok(), "{id} {direction}");
        }
    }
}

#[test]
fn entries_diverge_as_one_over_epsilon_unless_the_direction_is_kept() {
    let plane = Plane::across(DVec3::new(0.0, 0.0, -1.0)).unwrap();
    let at = |id: &str, epsilon: f64| {
        epsilon_projection(&maps(id), &plane, epsilon, EpsilonFrame::Picture).unwrap()
    };
    let (coarse, fine) = (at("fern", 1e-3), at("fern", 1e-6));
    assert!(
        !fine.diverging.is_empty()
            && fine.diverging.iter().all(|&[map, row, column]| map < 4 && row < 2 && column == 2)
    );
    assert!((fine.largest / coarse.largest - 1e3).abs() < 1.0, "{} {}", fine.largest, coarse.largest);
    let sponge = at("sponge", 1e-6);
    assert!(sponge.diverging.is_empty() && sponge.largest < 0.34);
}

#[test]
fn it_is_conjugation_by_the_flattening() {
    let plane = Plane::across(DVec3::new(0.3, -1.0, 0.2)).unwrap();
    let epsilon = 0.125;
    let found = epsilon_projection(&maps("fern"), &plane, epsilon, EpsilonFrame::Picture).unwrap();
    let to = DMat3::from_cols(plane.right, plane.up, plane.direction()).transpose();
    let by = Affine3::new(DMat3::from_diagonal(DVec3::new(1.0, 1.0, epsilon)) * to, DVec3::ZERO);
    for (map, row) in maps("fern").iter().zip(found.maps) {
        for (x, y) in map.moved(by).unwrap().to_row().iter().zip(row.to_row()) {
            assert!((x - y).abs() < 1e-12, "{x} {y}");
        }
    }
}

/// The nine numbers and the three as the paper prints them, for a scale along z.
fn as_printed(row: [f64; 12], epsilon: f64) -> [f64; 12] {
    let [a, b, c, d, e, f, g, h, i, j, k, l] = row;
    [a, b, c / epsilon, d, e, f / epsilon, epsilon * g, epsilon * h, i, j, k, epsilon * l]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(200)))]

    #[test]
    fn in_the_axes_of_space_it_is_what_the_paper_prints(
        mut row in proptest::array::uniform12(-1.0..1.0_f64), zeros in proptest::array::uniform12(any::<bool>()),
        axis in 0..3_usize, backwards: bool, epsilon in prop_oneof![Just(1.0), Just(0.1), Just(1e-6), Just(1e-30)],
    ) {
        row.iter_mut().zip(zeros).filter(|(_, zero)| *zero).for_each(|(x, _)| *x = 0.0);
        // Axes are called on in a circle, so that z is the one that is scaled.
        let of = |place: usize| (place + axis + 1) % 3;
        let called: [usize; 12] =
            std::array::from_fn(|n| if n < 9 { 3 * of(n / 3) + of(n % 3) } else { 9 + of(n - 9) });
        let map = Affine3::from_row(row);
        let direction = DVec3::AXES[axis] * if backwards { -1.0 } else { 1.0 };
        let found = epsilon_projection(&[map], &Plane::across(direction).unwrap(), epsilon, EpsilonFrame::Space).unwrap();
        let wanted = as_printed(called.map(|n| row[n]), epsilon);
        for (wanted, n) in wanted.into_iter().zip(called) {
            prop_assert!((found.maps[0].to_row()[n] - wanted).abs() <= 1e-12 * wanted.abs(), "{n}: {wanted}");
        }
        let mut growing: Vec<[usize; 3]> =
            [2, 5].into_iter().filter(|n| row[called[*n]] != 0.0).map(|n| [0, called[n] / 3, called[n] % 3]).collect();
        growing.sort_unstable();
        prop_assert_eq!(found.diverging, growing);
    }

    #[test]
    fn in_the_axes_of_space_both_ways_along_a_direction_are_one(
        row in proptest::array::uniform12(-1.0..1.0_f64), direction in proptest::array::uniform3(-1.0..1.0_f64),
    ) {
        let direction = DVec3::from(direction);
        prop_assume!(direction.length() > 0.01);
        let (map, epsilon) = (Affine3::from_row(row), 0.125);
        let along = direction.normalize();
        let across = DMat3::from_cols(along * along.x, along * along.y, along * along.z);
        let by = Affine3::new(DMat3::IDENTITY + across * (epsilon - 1.0), DVec3::ZERO);
        for way in [direction, -direction] {
            let plane = Plane::across(way).unwrap();
            let found = epsilon_projection(&[map], &plane, epsilon, EpsilonFrame::Space).unwrap();
            for (x, y) in map.moved(by).unwrap().to_row().iter().zip(found.maps[0].to_row()) {
                prop_assert!((x - y).abs() < 1e-12, "{x} {y}");
            }
        }
    }
}

#[test]
fn in_the_axes_of_the_picture_a_shape_seen_along_z_is_mirrored() {
    let plane = Plane::across(DVec3::Z).unwrap();
    let row = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.25, 0.35, 0.45];
    let found = epsilon_projection(&[Affine3::from_row(row)], &plane, 1.0, EpsilonFrame::Picture).unwrap();
    let mirrored = [0.1, -0.2, -0.3, -0.4, 0.5, 0.6, -0.7, 0.8, 0.9, -0.25, 0.35, 0.45];
    assert_eq!(found.maps[0].to_row(), mirrored);
}

#[test]
fn epsilons_that_are_none_are_refused() {
    let plane = Plane::across(DVec3::X).unwrap();
    for bad in [0.0, -1.0, 2.0, f64::NAN, 1e-300] {
        assert_eq!(
            epsilon_projection(&maps("fern"), &plane, bad, EpsilonFrame::Picture),
            Err(ProjectError::Epsilon)
        );
    }
    assert!(
        epsilon_projection(&maps("fern"), &plane, 1e-100, EpsilonFrame::Picture).unwrap().largest.is_finite()
    );
}
