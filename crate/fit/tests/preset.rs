//! The closed curves of the gallery.

use frond_fit::{
    ClosedCurve, Outline, crossings, curve_preset, curve_presets, fidelity, island, sugar_maple, white_oak,
};
use glam::DVec2;

#[test]
fn the_gallery_is_whole_and_sound() {
    let presets = curve_presets();
    assert_eq!(
        presets.iter().map(|p| p.id).collect::<Vec<_>>(),
        ["sugar-maple", "white-oak", "snowflake", "island"]
    );
    for preset in &presets {
        let curve = &preset.curve;
        assert!(curve.is_sound(), "{}", preset.id);
        let line = curve.polyline(5e-3, 10);
        let outline = Outline::new(&line).unwrap();
        assert_eq!(outline.points()[0], line[0], "{} runs counter-clockwise", preset.id);
        assert_eq!(crossings(&line, 5), Some(vec![]), "{}", preset.id);
    }
}

#[test]
fn baked_fits_are_near_their_outlines() {
    for (id, points) in [("sugar-maple", sugar_maple(1)), ("white-oak", white_oak(1)), ("island", island(4))]
    {
        let preset = curve_presets().into_iter().find(|p| p.id == id).unwrap();
        let outline = Outline::new(&points).unwrap();
        assert!(preset.curve.numbers() <= 260);
        let near = fidelity(&outline, &preset.curve.polyline(1e-4 * outline.diagonal(), 12));
        assert!(near.rms < 0.07 && near.hausdorff < 0.4, "{id}: {near:?}");
        assert!(near.slope_difference().abs() < 0.03, "{id}: {near:?}");
    }
}

#[test]
fn leaves_that_are_no_more_in_the_gallery_are_what_they_were() {
    let gallery = curve_presets();
    for (id, knots) in [("maple", 100), ("oak", 99)] {
        assert!(gallery.iter().all(|preset| preset.id != id));
        let former = curve_preset(id).unwrap();
        assert!(former.curve.is_sound() && former.curve.knots.len().abs_diff(knots) < 16, "{id}");
    }
    for preset in gallery {
        assert_eq!(curve_preset(preset.id), Some(preset));
    }
    assert_eq!(curve_preset("willow"), None);
}

#[test]
fn the_snowflake_is_that_of_koch() {
    let flake = curve_presets().into_iter().find(|p| p.id == "snowflake").unwrap().curve;
    let depth = 5;
    // Koch's rule, side by side.
    let mut koch: Vec<DVec2> = (0..3).map(|side| flake.knots[4 * side]).collect();
    for _ in 0..depth {
        let count = koch.len();
        let side = |i: usize| {
            let (a, b) = (koch[i], koch[(i + 1) % count]);
            let third = (b - a) / 3.0;
            let turn = DVec2::from_angle(-std::f64::consts::FRAC_PI_3);
            [a, a + third, a + third + turn.rotate(third), b - third]
        };
        koch = (0..count).flat_map(side).collect();
    }
    let ours = flake.polyline(0.0, depth - 1);
    assert_eq!(ours.len(), koch.len());
    for (a, b) in ours.iter().zip(&koch) {
        assert!(a.distance(*b) < 1e-12, "{a} {b}");
    }
}

#[test]
fn packing_keeps_the_gallery() {
    for preset in curve_presets() {
        let back = ClosedCurve::from_bytes(&preset.curve.to_bytes(1e-9).unwrap()).unwrap();
        assert_eq!(back.copies(), preset.curve.copies());
        for (a, b) in back.knots.iter().zip(&preset.curve.knots) {
            assert!(a.distance(*b) < 1e-8);
        }
    }
}
