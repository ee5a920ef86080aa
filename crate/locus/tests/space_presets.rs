//! The gallery of space: what holds together, and the way from the tetrahedron to a dragon.

use frond_core::{Affine3, Ifs3, Morph3, MorphOptions};
use frond_locus::{Options, PathOptions, Verdict, check_path3, connectedness3, find_path3};
use frond_scene::preset3;
use glam::DVec3;

fn maps(id: &str) -> Vec<Affine3> {
    preset3(id).unwrap().maps.into_iter().map(Affine3::from_row).collect()
}

#[test]
fn the_gallery_holds_together_but_for_the_dust() {
    for (id, verdict) in [
        ("tetrahedron", Verdict::Connected),
        ("dragon-folded", Verdict::Connected),
        ("octahedron", Verdict::Connected),
        ("dust", Verdict::Disconnected),
    ] {
        let answer = connectedness3(&Ifs3::new(maps(id)).unwrap(), &Options::default());
        assert_eq!(answer.verdict, verdict, "{id}: {answer:?}");
    }
    for id in ["tetrahedron-strung", "dragon", "dragon-curled", "pyramid", "triangle", "sponge", "koch"] {
        let answer = connectedness3(&Ifs3::new(maps(id)).unwrap(), &Options::default());
        assert!(answer.verdict.holds(), "{id}: {answer:?}");
    }
    // The stem of the fern is a fern, too, and its frond begins between two of its leaflets.
    let fern = connectedness3(&Ifs3::new(maps("fern")).unwrap(), &Options::default());
    assert!(fern.gap.upper < 0.02 * fern.diameter, "{fern:?}");
}

#[test]
fn the_tetrahedron_becomes_a_dragon_in_one_piece() {
    let morph = Morph3::new(&maps("tetrahedron-strung"), &maps("dragon"), &MorphOptions::default()).unwrap();
    let options = PathOptions { epsilon: 1e-4, size: 13, ..PathOptions::default() };
    let plan = find_path3(&morph, &options).unwrap();
    assert!(plan.holds && plan.gap == 0.0, "{plan:?}");
    assert!(check_path3(&morph, &plan.points, 1e-6, 101).holds);
    // The reason: at every moment the halves share the ends of their threads.
    for k in 0..=20 {
        let maps = morph.at(f64::from(k) / 20.0, f64::from(k) / 20.0);
        let (start, end) = (maps[0].fixed_point().unwrap(), maps[3].fixed_point().unwrap());
        for pair in maps.windows(2) {
            assert!(pair[0].apply(end).distance(pair[1].apply(start)) < 1e-12);
        }
    }
    // It does turn into something else: the middle of an edge of the tetrahedron is far from the dragon's like point.
    let word = |maps: &[Affine3]| (maps[1] * maps[2] * maps[0]).apply(DVec3::ONE);
    assert!(word(&maps("tetrahedron-strung")).distance(word(&maps("dragon"))) > 0.1);
}

#[test]
fn the_way_to_the_curled_dragon_is_not_the_straight_one() {
    let morph = Morph3::new(&maps("tetrahedron"), &maps("dragon-curled"), &MorphOptions::default()).unwrap();
    let options = PathOptions { size: 25, ..PathOptions::default() };
    let plan = find_path3(&morph, &options).unwrap();
    assert!(plan.holds && plan.points.len() < 8, "{plan:?}");
    assert!(check_path3(&morph, &plan.points, options.epsilon, 401).holds);
    let ends = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
    let straight = check_path3(&morph, &ends, options.epsilon, 101);
    assert!(!straight.holds && straight.gap > 0.02, "{straight:?}");
}
