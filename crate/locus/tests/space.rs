//! Known answers in space.

use frond_core::{Affine2, Affine3, Ifs, Ifs3, Morph3, MorphOptions};
use frond_locus::{
    Bounds, LocusGrid, Options, PathOptions, Reason3Kind, State, Verdict, check_path3, connectedness,
    connectedness3, find_path3, locus3,
};
use glam::{DMat3, DQuat, DVec2, DVec3};

fn shrunk(ratio: f64, corners: &[[f64; 3]]) -> Ifs3 {
    let map =
        |c: &[f64; 3]| Affine3::similitude(ratio, DQuat::IDENTITY, DVec3::from_array(*c) * (1.0 - ratio));
    Ifs3::new(corners.iter().map(map).collect()).unwrap()
}

const TETRAHEDRON: [[f64; 3]; 4] = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
const OCTAHEDRON: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
const PYRAMID: [[f64; 3]; 5] =
    [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 1.25]];

fn sponge(ratio: f64) -> Ifs3 {
    let cells = (0..27).map(|k: u32| [k % 3, k / 3 % 3, k / 9]);
    let kept = cells.filter(|cell| cell.iter().filter(|&&c| c == 1).count() < 2);
    let corners: Vec<[f64; 3]> = kept.map(|c| c.map(|x| f64::from(x) / 2.0)).collect();
    shrunk(ratio, &corners)
}

#[test]
fn half_scale_shapes_that_share_corners_are_connected_with_a_proof() {
    for (corners, points) in [(&TETRAHEDRON[..], 3), (&OCTAHEDRON, 5), (&PYRAMID, 4)] {
        let answer = connectedness3(&shrunk(0.5, corners), &Options::default());
        assert_eq!(answer.verdict, Verdict::Connected, "{answer:?}");
        let reason = answer.reason.unwrap();
        assert!(reason.is_proof() && reason.kind == Reason3Kind::SharedPoints, "{reason:?}");
        assert_eq!(reason.points.len(), points);
        // Each is the middle of two corners: two letters say which.
        for shared in &reason.points {
            for word in &shared.words {
                let letters: Vec<usize> =
                    word.bytes().filter(u8::is_ascii_digit).map(|b| usize::from(b - b'1')).collect();
                let [i, j] = letters.try_into().unwrap();
                let middle = DVec3::from_array(corners[i]).midpoint(DVec3::from_array(corners[j]));
                assert!(shared.at.distance(middle) < 1e-12, "{shared:?}");
            }
        }
        assert_eq!((answer.count, answer.gap.upper), (1, 0.0));
    }
    // All pairs of the tetrahedron meet, and of the octahedron: opposite pieces in its middle.
    assert_eq!(connectedness3(&shrunk(0.5, &TETRAHEDRON), &Options::default()).overlaps.len(), 6);
    assert_eq!(connectedness3(&shrunk(0.5, &OCTAHEDRON), &Options::default()).overlaps.len(), 15);
}

#[test]
fn addresses_are_written_alike_in_the_plane_and_in_space() {
    for (count, wanted) in [(8, ["1(8)", "2(1)"]), (16, ["1.(16)", "2.(1)"])] {
        // A segment of equal parts, of which each shares its end with the next.
        let part = 1.0 / f64::from(count);
        let plane = (0..count).map(|k| Affine2::similitude(part, 0.0, DVec2::new(part * f64::from(k), 0.0)));
        let reason = connectedness(&Ifs::new(plane.collect()).unwrap(), &Options::default()).reason.unwrap();
        assert_eq!(reason.links.iter().find(|link| link.pair == (0, 1)).unwrap().words, wanted);
        let space = (0..count)
            .map(|k| Affine3::similitude(part, DQuat::IDENTITY, DVec3::new(part * f64::from(k), 0.0, 0.0)));
        let reason =
            connectedness3(&Ifs3::new(space.collect()).unwrap(), &Options::default()).reason.unwrap();
        assert_eq!(reason.points.iter().find(|point| point.pair == (0, 1)).unwrap().words, wanted);
    }
}

#[test]
fn a_little_smaller_they_are_apart_by_what_is_bare_of_an_edge() {
    for (corners, edge) in
        [(&TETRAHEDRON[..], 8.0_f64.sqrt()), (&OCTAHEDRON, 2.0_f64.sqrt()), (&PYRAMID, 2.0)]
    {
        for ratio in [0.5 - 1e-6, 0.49, 0.4, 0.2, 0.01] {
            let options = Options { epsilon: 1e-9, budget: 400_000 };
            let answer = connectedness3(&shrunk(ratio, corners), &options);
            assert_eq!(answer.verdict, Verdict::Disconnected, "{ratio} {answer:?}");
            assert_eq!(answer.count, corners.len());
            let (bare, gap) = (edge * (1.0 - 2.0 * ratio), answer.gap);
            // A pyramid's pieces come nearer beside the edge than along it.
            let least = if corners.len() == 5 { 0.9 * bare } else { bare };
            assert!(
                gap.lower <= bare * (1.0 + 1e-9) && least <= gap.upper * (1.0 + 1e-9),
                "{ratio} {gap:?} {bare}"
            );
            assert!(gap.upper - gap.lower <= 0.011 * gap.upper, "{ratio} {gap:?}");
            let (from, to) = answer.closest.unwrap();
            assert!((from.distance(to) - gap.upper).abs() <= 1e-9, "{ratio}");
        }
    }
}

#[test]
fn the_sponge_holds_if_a_third_is_a_third() {
    let answer = connectedness3(&sponge(1.0 / 3.0), &Options::default());
    assert_eq!(answer.verdict, Verdict::Touching, "{answer:?}");
    let reason = answer.reason.unwrap();
    assert!(!reason.is_proof() && reason.assuming[0].contains("is 1/3"), "{}", reason.text());
    assert_eq!(answer.overlaps.len() % 2, 0);
    let less = connectedness3(&sponge(1.0 / 3.0 - 1e-3), &Options { epsilon: 1e-6, ..Options::default() });
    assert_eq!((less.verdict, less.count), (Verdict::Disconnected, 20), "{less:?}");
    let gap = 1.5e-3;
    assert!(less.gap.lower <= gap && gap <= less.gap.upper * (1.0 + 1e-9), "{:?}", less.gap);
}

#[test]
fn dust_is_dust_and_a_filled_cube_is_whole() {
    let corners: Vec<[f64; 3]> = (0..8).map(|k: u32| [k & 1, k >> 1 & 1, k >> 2].map(f64::from)).collect();
    let dust = connectedness3(&shrunk(1.0 / 3.0, &corners), &Options::default());
    assert_eq!((dust.verdict, dust.count), (Verdict::Disconnected, 8));
    assert!(dust.gap.lower <= 1.0 / 3.0 && 1.0 / 3.0 <= dust.gap.upper + 1e-12, "{:?}", dust.gap);
    let cube = connectedness3(&shrunk(0.5, &corners), &Options::default());
    assert_eq!(cube.verdict, Verdict::Connected, "{cube:?}");
    // A space twin-dragon: two maps of half the volume, turned so that they fill it.
    let linear = DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X * 0.5);
    let twin = [DVec3::ZERO, DVec3::X].map(|shift| Affine3::new(linear, shift));
    let answer = connectedness3(&Ifs3::new(twin.to_vec()).unwrap(), &Options::default());
    assert_eq!(answer.verdict, Verdict::Connected);
    assert_eq!(answer.reason.unwrap().kind, Reason3Kind::Volume);
}

#[test]
fn other_coordinates_change_no_verdict() {
    let shear = Affine3::shear([30.0, 2.0, 0.0, -10.0, 0.0, 0.0]);
    for (ratio, verdict) in [(0.5, Verdict::Connected), (0.48, Verdict::Disconnected)] {
        let answer =
            connectedness3(&shrunk(ratio, &TETRAHEDRON).conjugate(shear).unwrap(), &Options::default());
        assert_eq!(answer.verdict, verdict, "{ratio} {answer:?}");
        let far = Affine3::moving(DVec3::new(15.0, -4.0, 1.0)) * Affine3::rotation(DVec3::ONE, 0.8).unwrap();
        let answer =
            connectedness3(&shrunk(ratio, &TETRAHEDRON).conjugate(far).unwrap(), &Options::default());
        assert!(answer.verdict.holds() == (verdict == Verdict::Connected), "{ratio} {answer:?}");
    }
}

#[test]
fn a_turned_system_keeps_its_gap() {
    // Turned pieces, where nothing lies along an axis.
    let axes = [[1.0, 0.2, 0.0], [0.0, 1.0, 0.5], [0.3, 0.0, 1.0]];
    let maps = axes.map(|a| {
        let a = DVec3::from_array(a);
        Affine3::similitude(0.35, DQuat::from_axis_angle(a.normalize(), 2.0), a)
    });
    let plain = connectedness3(&Ifs3::new(maps.to_vec()).unwrap(), &Options::default());
    assert_eq!(plain.verdict, Verdict::Disconnected);
    let turn = Affine3::rotation(DVec3::new(0.3, -1.0, 0.4), 1.1).unwrap();
    let turned =
        connectedness3(&Ifs3::new(maps.to_vec()).unwrap().conjugate(turn).unwrap(), &Options::default());
    assert!(plain.gap.lower <= turned.gap.upper && turned.gap.lower <= plain.gap.upper);
    assert!((plain.gap.upper / turned.gap.upper - 1.0).abs() < 0.02);
}

#[test]
fn the_budget_holds_and_what_is_left_open_is_undecided() {
    let options = Options { epsilon: 0.0, budget: 50 };
    let answer = connectedness3(&shrunk(0.5 - 1e-12, &TETRAHEDRON), &options);
    assert_eq!(answer.verdict, Verdict::Undecided);
    assert!(answer.nodes < 200);
}

#[test]
fn the_locus_of_a_morph_in_space_has_its_ends_and_a_path() {
    // The tetrahedron grows by a tenth and turns: it holds all the way.
    let from = shrunk(0.5, &TETRAHEDRON);
    let to: Vec<Affine3> = shrunk(0.55, &TETRAHEDRON)
        .maps()
        .iter()
        .zip(TETRAHEDRON)
        .map(|(map, c)| {
            let turn = DQuat::from_axis_angle(DVec3::from_array(c).normalize(), 2.0);
            Affine3::new(map.linear * DMat3::from_quat(turn), map.translation)
        })
        .collect();
    let morph = Morph3::new(from.maps(), &to, &MorphOptions::default()).unwrap();
    let grid = LocusGrid::new(Bounds::default(), 13, 13).unwrap();
    let locus = locus3(&grid, &morph, 1e-2).unwrap();
    assert!(locus.sample(4, 4).state.holds(), "{:?}", locus.sample(4, 4));
    assert_eq!(locus.sample(4, 4).state, State::Touching);
    let plan =
        find_path3(&morph, &PathOptions { epsilon: 1e-2, size: 13, ..PathOptions::default() }).unwrap();
    assert_eq!(
        (plan.points[0], plan.points[plan.points.len() - 1]),
        (DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0))
    );
    let check = check_path3(&morph, &plan.points, 1e-2, 300);
    assert!((check.gap - plan.gap).abs() <= 0.3 * plan.gap.max(0.01), "{plan:?} {check:?}");
}
