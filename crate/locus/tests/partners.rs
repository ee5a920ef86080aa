//! The gallery's table of pairs that hold is true.

use frond_core::{Affine2, Ifs, Mode, Morph, MorphOptions, RouteKind, pair, ways};
use frond_locus::{PathOptions, check_path, find_path};
use frond_scene::{Preset, presets};
use glam::DVec3;

const TABLE: &str = include_str!("../../../www/src/tools/morph/shapes/partners.txt");

fn rows() -> Vec<(&'static str, Vec<char>)> {
    let row =
        |line: &'static str| line.split_once(' ').map(|(id, marks)| (id, marks.trim().chars().collect()));
    TABLE.lines().filter_map(row).collect()
}

fn ifs(preset: &Preset) -> Ifs {
    Ifs::new(preset.maps.iter().map(|&row| Affine2::from_row(row)).collect()).unwrap()
}

/// Whether a way that keeps joints joined holds, and leaves the last shape upright; of others only the table's maker
/// has the time.
fn holds_by_joints(from: &Ifs, to: &Ifs) -> Option<bool> {
    let way = ways(from, to, 1).into_iter().next().filter(|way| way.kind == RouteKind::Joints)?;
    let options = MorphOptions { mode: Mode::Linear, ..MorphOptions::default() };
    let morph = Morph::new(&way.from, &way.to, &options).unwrap();
    if let Some(place) = way.place {
        assert!(place.determinant() > 0.0 && place.linear.x_axis.to_angle().abs() < 1e-6, "{}", way.about);
    }
    Some(check_path(&morph, &[DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)], 1.0 / 600.0, 1001).holds)
}

#[test]
fn it_has_a_row_for_every_shape_and_is_the_same_from_both_sides() {
    let (rows, all) = (rows(), presets());
    let ids: Vec<&str> = rows.iter().map(|(id, _)| *id).collect();
    assert_eq!(ids, all.iter().map(|preset| preset.id).collect::<Vec<_>>());
    for (i, (id, row)) in rows.iter().enumerate() {
        assert_eq!(row.len(), rows.len(), "{id}");
        for (j, (_, other)) in rows.iter().enumerate() {
            assert_eq!(row[j], other[i], "{id} {j}");
            assert!("=+.".contains(row[j]), "{id} {j}");
        }
    }
}

/// All pairs take a quarter of an hour: a few are drawn of those that hold as they are.
#[test]
fn some_pairs_hold_as_it_says() {
    let (rows, all) = (rows(), presets());
    let mut plain = 0;
    for draw in 0..400 {
        let at = |salt: u32| frond_core::hash::counter(draw, salt) as usize % all.len();
        let (i, j) = (at(0), at(1));
        if i < j && rows[i].1[j] == '=' && plain < frond_testing::cases(8) {
            plain += 1;
            let paired = pair(&ifs(&all[i]), &ifs(&all[j]));
            let morph = Morph::new(&paired.from, &paired.to, &MorphOptions::default()).unwrap();
            let holds = find_path(&morph, &PathOptions::default()).unwrap().holds;
            assert!(holds, "{} to {}", all[i].id, all[j].id);
        }
    }
    assert!(plain > 3, "{plain}");
}

#[test]
fn shapes_that_are_chains_of_pieces_all_hold_with_each_other() {
    let (rows, all) = (rows(), presets());
    let mut other = 0;
    for i in 0..all.len() {
        for j in 0..i {
            if rows[i].1[j] != '='
                && let Some(holds) = holds_by_joints(&ifs(&all[i]), &ifs(&all[j]))
            {
                assert!(holds && rows[i].1[j] == '+', "{} and {}", all[i].id, all[j].id);
                other += 1;
            }
        }
    }
    assert!(other > 3, "{other}");
}
