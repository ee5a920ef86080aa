//! Meshes of systems of space: watertight, oriented, as large and as thick as they are to be.

use std::collections::HashSet;

use frond_core::{Affine3, Ifs3};
use frond_render::mesh::file::{MeshFormat, glb, ply, stl};
use frond_render::mesh::{MOST_SAMPLES, Mesh, MeshError, MeshOptions, Mesher};
use frond_scene::presets3;
use glam::{DQuat, DVec3};

const OPTIONS: MeshOptions = MeshOptions { fineness: 40.0, size: 80.0, wall: 3.0 };

fn system(maps: &[Affine3]) -> Ifs3 {
    Ifs3::new(maps.to_vec()).unwrap()
}

fn shrunk(by: f64, corners: &[DVec3]) -> Ifs3 {
    let maps: Vec<Affine3> =
        corners.iter().map(|&c| Affine3::similitude(by, DQuat::IDENTITY, c * (1.0 - by))).collect();
    system(&maps)
}

fn mesh(systems: &[Ifs3], options: MeshOptions) -> Mesh {
    Mesher::new(systems, options).unwrap().finish().unwrap()
}

/// Every edge has two triangles, in opposite directions, and what is enclosed is inside.
#[track_caller]
fn assert_watertight(mesh: &Mesh) {
    let mut edges = HashSet::new();
    for &[a, b, c] in &mesh.triangles {
        for edge in [(a, b), (b, c), (c, a)] {
            assert!(edges.insert(edge), "two triangles go along {edge:?}");
        }
    }
    assert!(!edges.is_empty());
    assert!(edges.iter().all(|&(a, b)| edges.contains(&(b, a))));
    assert!(mesh.volume() > 0.0);
    // Normals point to where the triangles' own do.
    let mut agree = 0;
    for &[a, b, c] in &mesh.triangles {
        let at = |v: u32| DVec3::from_array(mesh.positions[v as usize].map(f64::from));
        let normal = DVec3::from_array(mesh.normals[a as usize].map(f64::from));
        assert!((normal.length() - 1.0).abs() < 1e-3);
        agree += usize::from((at(b) - at(a)).cross(at(c) - at(a)).dot(normal) > 0.0);
    }
    assert!(agree * 10 > mesh.triangles.len() * 9, "{agree} of {}", mesh.triangles.len());
}

#[test]
fn every_shape_of_the_gallery_is_watertight_and_as_large_as_asked() {
    for preset in presets3() {
        let maps: Vec<Affine3> = preset.maps.iter().map(|&row| Affine3::from_row(row)).collect();
        let mesh = mesh(&[system(&maps)], OPTIONS);
        assert_watertight(&mesh);
        let [least, largest] = mesh.bounds();
        assert!(least.abs().max_element() < 1e-3, "{}", preset.id);
        assert!((largest.max_element() - 80.0).abs() < 1e-3, "{}: {largest}", preset.id);
        // Nothing of the gallery but dust is in pieces.
        assert_eq!(mesh.parts() > 1, preset.id == "dust", "{}: {}", preset.id, mesh.parts());
    }
}

#[test]
fn what_is_flat_or_a_curve_or_a_point_is_as_thick_as_the_wall() {
    let sheet = shrunk(0.5, &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.0)]);
    let curve = shrunk(0.5, &[DVec3::ZERO, DVec3::X]);
    let slanted = shrunk(0.5, &[DVec3::ZERO, DVec3::new(1.0, 1.0, 1.0)]);
    let [sheet, curve, slanted] = [[sheet], [curve], [slanted]];
    for wall in [6.0, 8.0, 16.0] {
        let options = MeshOptions { wall, ..OPTIONS };
        let (sheet, curve, slanted) = (mesh(&sheet, options), mesh(&curve, options), mesh(&slanted, options));
        for mesh in [&sheet, &curve, &slanted] {
            assert_watertight(mesh);
            assert_eq!(mesh.parts(), 1);
        }
        let thick = |mesh: &Mesh| f64::from(mesh.bounds()[1].z);
        assert!((thick(&sheet) / wall - 1.0).abs() < 0.12, "{wall}: {}", thick(&sheet));
        assert!((thick(&curve) / wall - 1.0).abs() < 0.12, "{wall}: {}", thick(&curve));
        // A tube with round ends.
        let tube = |length: f64, r: f64| std::f64::consts::PI * r * r * (length + r * 4.0 / 3.0);
        let share = curve.volume() / tube(80.0 - wall, 0.5 * wall);
        assert!((0.75..1.05).contains(&share), "{wall}: {share}");
        let length = (80.0 - wall) * 3.0_f64.sqrt();
        let share = slanted.volume() / tube(length, 0.5 * wall);
        assert!((0.75..1.05).contains(&share), "{wall}: {share}");
    }
}

#[test]
fn hollows_that_nothing_leads_into_are_filled() {
    // The six sides of a cube, of which each is a square.
    let corner = |u: f64, v: f64, k: usize, side: f64| {
        let mut at = DVec3::splat(side);
        (at[(k + 1) % 3], at[(k + 2) % 3]) = (u, v);
        at
    };
    let square = |k: usize, side: f64| {
        let mut linear = glam::DMat3::from_diagonal(DVec3::splat(0.5));
        linear.col_mut(k)[k] = 0.0;
        let at = |(u, v)| Affine3::new(linear, corner(u, v, k, 2.0 * side) * 0.5);
        system(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(at))
    };
    let sides: Vec<Ifs3> = (0..6).map(|side| square(side % 3, f64::from((side / 3) as u8))).collect();
    let mesh = mesh(&sides, OPTIONS);
    assert_watertight(&mesh);
    assert_eq!(mesh.parts(), 1);
    assert!(mesh.volume() > 0.95 * 80.0_f64.powi(3), "{}", mesh.volume());
}

#[test]
fn a_point_becomes_a_ball() {
    for maps in [vec![Affine3::scaling(DVec3::splat(0.5))], vec![Affine3::scaling(DVec3::ZERO); 3]] {
        for at in [DVec3::ZERO, DVec3::splat(1e6)] {
            let maps: Vec<Affine3> = maps.iter().map(|map| map.about(at)).collect();
            let mesh = mesh(&[system(&maps)], MeshOptions { wall: 20.0, ..OPTIONS });
            assert_watertight(&mesh);
            let [_, size] = mesh.bounds();
            assert!((size - 20.0).abs().max_element() < 1.0, "{size}");
        }
    }
}

#[test]
fn several_objects_are_one_body_with_codes_of_their_own() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let first = shrunk(0.5, &corners);
    let second = first.conjugate(Affine3::moving(DVec3::X * 3.0)).unwrap();
    let both = mesh(&[first, second], OPTIONS);
    assert_watertight(&both);
    assert_eq!(both.parts(), 2);
    let codes: HashSet<u16> = both.codes.iter().copied().collect();
    assert_eq!(codes, (0..8).collect());
    // The first object lies on the left, and its fourth map on top.
    for (point, &code) in both.positions.iter().zip(&both.codes) {
        assert_eq!(code < 4, point[0] < 40.0);
        if point[2] > 16.0 {
            assert!(code % 4 == 3, "{point:?}: {code}");
        }
    }
}

#[test]
fn pieces_are_followed_where_maps_hardly_shrink_or_flatten() {
    let turned = |scale, angle, at: DVec3| {
        Affine3::similitude(scale, DQuat::from_axis_angle(DVec3::ONE.normalize(), angle), at)
    };
    let slow = system(&[turned(0.97, 0.3, DVec3::X * 0.05), turned(0.5, 1.0, DVec3::Z)]);
    assert_watertight(&mesh(&[slow], OPTIONS));
    let flat = system(&[
        Affine3::scaling(DVec3::new(0.5, 0.0, 0.5)),
        Affine3::new(glam::DMat3::from_diagonal(DVec3::new(0.0, 0.6, 0.9)), DVec3::new(0.1, 0.2, 0.1)),
    ]);
    assert_watertight(&mesh(&[flat], OPTIONS));
    let many: Vec<DVec3> =
        (0..64).map(|k| DVec3::new(f64::from(k % 4), f64::from(k / 4 % 4), f64::from(k / 16))).collect();
    assert_watertight(&mesh(&[shrunk(0.25, &many)], OPTIONS));
    let tiny = shrunk(0.5, &[DVec3::ZERO, DVec3::X * 1e-90, DVec3::Y * 1e-90]);
    assert_watertight(&mesh(&[tiny], OPTIONS));
}

#[test]
fn what_cannot_be_made_is_told_before_it_takes_memory() {
    let sheet = shrunk(0.5, &[DVec3::ZERO, DVec3::ONE, DVec3::X, DVec3::Y, DVec3::Z]);
    let refused = |systems: &[Ifs3], options: MeshOptions| match Mesher::new(systems, options) {
        Err(error) => error,
        Ok(_) => panic!("there is a mesh"),
    };
    let systems = std::slice::from_ref(&sheet);
    assert_eq!(refused(&[], OPTIONS), MeshError::Objects { count: 0 });
    for fineness in [f64::NAN, 0.0, -5.0, 1e9] {
        assert_eq!(refused(systems, MeshOptions { fineness, ..OPTIONS }), MeshError::Fineness);
    }
    for size in [f64::NAN, 0.0, -5.0, f64::INFINITY] {
        assert_eq!(refused(systems, MeshOptions { size, ..OPTIONS }), MeshError::Size);
    }
    assert_eq!(
        refused(systems, MeshOptions { wall: 75.0, ..OPTIONS }),
        MeshError::Wall { wall: 75.0, size: 80.0 }
    );
    let MeshError::TooFine { samples } = refused(systems, MeshOptions { fineness: 600.0, ..OPTIONS }) else {
        panic!("it is not too fine");
    };
    assert!(samples > MOST_SAMPLES);
    // No wall at all: as thick as the grid shows.
    for wall in [f64::NAN, -3.0, 0.0] {
        let mesher = Mesher::new(systems, MeshOptions { wall, ..OPTIONS }).unwrap();
        assert_eq!(mesher.wall(), 6.0);
    }
}

#[test]
fn files_are_as_large_as_foretold() {
    let mesh = mesh(&[shrunk(0.5, &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z])], OPTIONS);
    let triangles = mesh.triangles.len() as f64;
    let colours = [[200, 100, 50]; 4];
    for (format, bytes) in [
        (MeshFormat::Stl, stl(&mesh)),
        (MeshFormat::Ply, ply(&mesh, &colours)),
        (MeshFormat::Glb, glb(&mesh, &colours)),
    ] {
        assert!((bytes.len() as f64 / format.bytes(triangles) - 1.0).abs() < 0.02, "{format:?}");
    }
}
