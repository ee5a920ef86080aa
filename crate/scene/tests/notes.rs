//! What the notes of the galleries say in numbers, against the maps that they are about.

use frond_core::{Affine2, Affine3};
use frond_fit::curve_presets;
use frond_scene::{directed_presets, intersection_examples, presets, presets3};

/// Words that name a part without saying whether of a length or of an area.
const PARTS: [&str; 8] = ["halves", "thirds", "quarters", "fourths", "fifths", "sixths", "eighths", "ninths"];
const COUNTS: [(&str, usize); 10] = [
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
    ("seven", 7),
    ("eight", 8),
    ("thirteen", 13),
    ("twenty", 20),
    ("ten", 10),
];

/// A length as a note writes it, and how far from it a map may be: half of a decimal's last digit.
fn length(words: &str) -> (f64, f64) {
    match words {
        "half" => (0.5, 1e-12),
        "a third" => (1.0 / 3.0, 1e-12),
        "a fifth" => (0.2, 1e-12),
        _ => words.strip_prefix("1/√").map_or_else(
            || {
                let decimals = words.split_once('.').unwrap().1.len();
                (words.parse().unwrap(), 0.5 * 10.0_f64.powi(-(decimals as i32)))
            },
            |root| (1.0 / root.parse::<f64>().unwrap().sqrt(), 1e-12),
        ),
    }
}

/// The word before "copies", and the length before "as long".
fn named(note: &str) -> (Option<usize>, Option<(f64, f64)>) {
    let count = note.split_once(" copies").and_then(|(before, _)| {
        let word = before.rsplit(' ').next().unwrap().to_lowercase();
        COUNTS.iter().find(|(name, _)| *name == word).map(|(_, count)| *count)
    });
    let scale = note.split_once(" as long").map(|(before, _)| length(before.rsplit_once("each ").unwrap().1));
    (count, scale)
}

/// The degrees of "by 30 or 90 degrees", in order.
fn degrees(note: &str) -> Option<Vec<f64>> {
    let (before, _) = note.split_once(" degrees")?;
    let list = before.rsplit_once("by ")?.1;
    list.split(" or ").map(|word| word.parse().ok()).collect()
}

/// Holds a note to the stretches of the maps, in all directions.
fn check(id: &str, note: &str, stretches: &[Vec<f64>]) {
    assert!(note.ends_with('.'), "{id}: {note}");
    let lower = note.to_lowercase();
    assert!(!PARTS.iter().any(|part| lower.contains(part)), "{id}: of a length, or of an area? {note}");
    let (count, scale) = named(note);
    let all: Vec<f64> = stretches.iter().flatten().copied().collect();
    let alike = all.iter().all(|x| (x - all[0]).abs() < 1e-9);
    if alike {
        assert_eq!(count, Some(stretches.len()), "{id}: {note}");
        assert!(scale.is_some(), "{id}: {note}");
    }
    if let Some((scale, within)) = scale {
        assert!(all.iter().all(|x| (x - scale).abs() <= within), "{id}: {note} {all:?}");
    }
}

/// How much a matrix stretches along its axes, by the roots of the characteristic polynomial of M^T M.
fn stretches2(row: [f64; 6]) -> Vec<f64> {
    let [a, b, c, d, ..] = row;
    let (sum, product) = (a * a + b * b + c * c + d * d, (a * d - b * c).abs());
    let root = ((sum - 2.0 * product).max(0.0) * (sum + 2.0 * product)).sqrt();
    vec![((sum + root) / 2.0).sqrt(), ((sum - root).max(0.0) / 2.0).sqrt()]
}

#[test]
fn notes_of_the_plane_name_lengths() {
    let mut turned = 0;
    for preset in presets() {
        let stretches: Vec<Vec<f64>> = preset.maps.iter().map(|&row| stretches2(row)).collect();
        check(preset.id, preset.about, &stretches);
        if let Some(wanted) = degrees(preset.about) {
            turned += 1;
            let mut found: Vec<f64> =
                preset.maps.iter().map(|row| row[2].atan2(row[0]).to_degrees().abs().round()).collect();
            found.sort_by(f64::total_cmp);
            found.dedup();
            assert_eq!(found, wanted, "{}: {}", preset.id, preset.about);
        }
    }
    assert_eq!(turned, 2, "the terdragon and Levy's curve say how they turn");
}

#[test]
fn notes_of_space_name_lengths() {
    for preset in presets3() {
        let stretches: Vec<Vec<f64>> = preset
            .maps
            .iter()
            .map(|&row| {
                // Where all columns are as long and at right angles, that is how much it stretches.
                let matrix = Affine3::from_row(row).linear;
                let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
                let across = columns[0].dot(columns[1]).abs()
                    + columns[1].dot(columns[2]).abs()
                    + columns[2].dot(columns[0]).abs();
                let mut lengths = columns.map(|column| column.length()).to_vec();
                lengths.push(lengths[0] + across);
                lengths
            })
            .collect();
        check(preset.id, preset.about, &stretches);
    }
    let angle = |row: [f64; 12]| {
        let matrix = Affine3::from_row(row).linear;
        let trace = matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z;
        ((trace / matrix.determinant().cbrt() - 1.0) / 2.0).acos().to_degrees()
    };
    let curled = presets3().iter().find(|preset| preset.id == "dragon-curled").unwrap();
    assert!(curled.about.contains("a sixth of a turn"));
    assert!(curled.maps.iter().all(|&row| (angle(row) - 60.0).abs() < 1e-9));
    let pyramid = presets3().iter().find(|preset| preset.id == "pyramid").unwrap();
    let middle: f64 = pyramid.maps.iter().map(|row| 2.0 * row[9]).sum::<f64>() / 5.0;
    assert!(pyramid.about.contains("(15, 0, 0)") && (middle - 15.0).abs() < 1e-12);
    let dust = presets3().iter().find(|preset| preset.id == "sponge").unwrap();
    assert_eq!(dust.maps.len(), 20);
}

#[test]
fn notes_of_graphs_name_lengths() {
    for preset in directed_presets() {
        let lower = preset.about.to_lowercase();
        assert!(!PARTS.iter().any(|part| lower.contains(part)), "{}: {}", preset.id, preset.about);
        if let (Some(count), Some((scale, within))) = named(preset.about) {
            let curve = &preset.states[1];
            assert_eq!(curve.len(), count, "{}", preset.about);
            for edge in curve {
                for x in stretches2(Affine2::to_row(edge.map)) {
                    assert!((x - scale).abs() <= within, "{}: {x}", preset.about);
                }
                let turn = edge.map.linear.x_axis.y.atan2(edge.map.linear.x_axis.x).to_degrees() / 36.0;
                assert!(
                    preset.about.contains("multiples of 36 degrees") && (turn - turn.round()).abs() < 1e-9
                );
            }
        }
    }
    for example in intersection_examples() {
        assert!(!PARTS.iter().any(|part| example.why.contains(part)), "{}", example.why);
        if let (_, Some((scale, _))) = named(example.why) {
            assert!(example.first.iter().chain(&example.second).all(|row| (row[0] - scale).abs() < 1e-12));
        }
    }
}

#[test]
fn notes_of_closed_curves_name_lengths() {
    for preset in curve_presets() {
        let lower = preset.about.to_lowercase();
        assert!(!PARTS.iter().any(|part| lower.contains(part)), "{}: {}", preset.id, preset.about);
        if preset.id == "snowflake" {
            assert!(preset.about.ends_with("a copy of the four edges of its side, a third as long."));
            let knot = |i: usize| preset.curve.knots[i % preset.curve.knots.len()];
            for (i, edge) in preset.curve.edges.iter().enumerate() {
                let copied = edge.unwrap();
                assert_eq!(copied.span, 4);
                let (side, own) =
                    (knot(copied.from).distance(knot(copied.from + 4)), knot(i).distance(knot(i + 1)));
                assert!((own / side - 1.0 / 3.0).abs() < 1e-12, "{i}");
            }
        }
    }
}

#[test]
fn lengths_are_read_as_they_are_written() {
    assert_eq!(named("Three copies, each 1/√4 as long, turned."), (Some(3), Some((0.5, 1e-12))));
    assert_eq!(named("Five copies, each 0.38 as long."), (Some(5), Some((0.38, 0.005))));
    assert_eq!(degrees("Turned by 30 or 90 degrees."), Some(vec![30.0, 90.0]));
    assert_eq!(degrees("Turned by multiples of 36 degrees."), None);
    let doubled =
        std::panic::catch_unwind(|| check("", "Two copies, each half as long.", &[vec![0.5], vec![0.4]]));
    assert!(doubled.is_err());
}
