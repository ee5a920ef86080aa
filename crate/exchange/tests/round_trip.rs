//! What is written comes back: maps bit for bit where a format is a text of doubles, documents as they are.

use frond_exchange::{ExportFormat, Maps, System, export, import};
use frond_scene::{Scene, decode, presets, presets3};
use proptest::prelude::*;

const DOUBLES: [ExportFormat; 4] =
    [ExportFormat::Json, ExportFormat::Fractint, ExportFormat::Flame, ExportFormat::Csv];

fn bits(maps: &Maps) -> Vec<u64> {
    maps.rows().into_iter().flatten().map(|x| x.to_bits()).collect()
}

/// The name that a format can hold: one line of at most 60 letters, in JSON as it is, in a flame what stands for none,
/// in Fractint's files one word. Tables have no names.
fn held(name: &str, format: ExportFormat) -> String {
    let letters = |c: char| if c.is_control() { ' ' } else { c };
    let line = name.chars().map(letters).collect::<String>();
    let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
    let cut = |text: String| {
        if text.chars().count() > 60 { text.chars().take(59).chain(['…']).collect() } else { text }
    };
    match format {
        ExportFormat::Json => cut(line),
        ExportFormat::Flame if line.is_empty() => "Maps".into(),
        ExportFormat::Flame => cut(line),
        ExportFormat::Fractint => {
            let word = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' };
            let word: String = cut(line).chars().map(word).collect();
            let words = word.is_empty() || word.eq_ignore_ascii_case("comment");
            if words { format!("unnamed{word}") } else { word }
        }
        _ => String::new(),
    }
}

fn comes_back(system: &System) {
    for format in DOUBLES {
        if matches!(system.maps, Maps::Space(_)) && !format.takes_space() {
            continue;
        }
        let text = export(system, format).unwrap();
        let found = import(text.as_bytes()).unwrap_or_else(|error| panic!("{format:?}: {error}\n{text}"));
        assert_eq!(found.systems.len(), 1, "{format:?}");
        assert_eq!(bits(&found.systems[0].maps), bits(&system.maps), "{format:?}\n{text}");
        assert_eq!(found.systems[0].name, held(&system.name, format), "{format:?}\n{text}");
        assert_eq!((&found.remarks, &found.systems[0].remarks), (&vec![], &vec![]), "{format:?}\n{text}");
        if matches!(format, ExportFormat::Json | ExportFormat::Flame) {
            assert_eq!(found.systems[0].colours, system.colours, "{format:?}");
        }
        if !system.probabilities.is_empty() {
            assert_eq!(found.systems[0].probabilities, system.probabilities, "{format:?}");
        }
    }
}

#[test]
fn the_galleries_come_back() {
    for preset in presets() {
        comes_back(&System::plane(preset.name.into(), preset.maps));
    }
    for preset in presets3() {
        comes_back(&System::space(preset.name.into(), preset.maps.clone()));
    }
}

#[test]
fn any_name_comes_back_in_one_line() {
    let half = vec![[0.5, 0.0, 0.0, 0.5, 0.1, 0.0]; 2];
    for name in [
        "",
        " \t\r\n ",
        "a \"b\" 'c'",
        "</flame><flame name=\"x\">",
        "&amp; &lt; &#10; &bad; & <![CDATA[x]]> -->",
        "one\ntwo\r\nthree\u{2028}four\u{85}five",
        "{ } } { (3D) ; comment",
        "comment",
        "Fougère, фрактал, 羊歯, 🌿, e\u{301}",
        "\0\u{1b}[31m\u{7f}",
        "@a:b",
        "<flame/>",
        "\\ \\u0041 \\\"",
        &"é".repeat(100_000),
        &" \"".repeat(50_000),
        &"x".repeat(60),
        &"x".repeat(61),
    ] {
        comes_back(&System::plane(name.into(), half.clone()));
        let space = [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 1.0];
        comes_back(&System::space(name.into(), vec![space; 2]));
    }
}

#[test]
fn maps_that_are_never_chosen_come_back() {
    let mut system = System::plane("Fern".into(), vec![[0.5, 0.0, 0.0, 0.5, 0.1, 0.0]; 3]);
    for weights in [[0.0, 1.0, 0.0], [1.0, 0.0, 5e-324], [1e308, 0.0, 0.0], [0.0, 0.0, 0.25]] {
        system.probabilities = weights.to_vec();
        comes_back(&system);
    }
}

#[test]
fn a_document_comes_back() {
    let (scene, _) = decode(
        "v=1&a=fern&b=maps:0.5,0,0,0.5,0.1,0;0.5,0,0,0.5,0.7,0.3&b-name=Mine&t=0.25&path=drawn:0.1,0.2",
    );
    let text = serde_json::to_string(&scene).unwrap();
    let link = import(text.as_bytes()).unwrap().link.unwrap();
    assert_eq!(decode(&link), (scene, None));
    assert_ne!(decode(&link).0, Scene::default());
}

/// Any double that files hold, and many that people write.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => proptest::num::f64::NORMAL | proptest::num::f64::ZERO | proptest::num::f64::SUBNORMAL,
        2 => -2.0..2.0_f64,
        1 => (-40..40_i32).prop_map(|k| f64::from(k) / 12.0),
        1 => (-40..40_i32).prop_map(|k| f64::from(k) * 3.0_f64.sqrt() / 6.0),
    ]
}

fn name() -> impl Strategy<Value = String> {
    let odd = "[a-c \"'<>&;{}()@#\\\\\n\r\t]{0,70}";
    prop_oneof![
        "[A-Za-z ]{0,20}",
        "\\PC{0,12}",
        odd,
        proptest::collection::vec(any::<char>(), 0..20).prop_map(String::from_iter),
        Just("comment".to_owned()),
        Just("(3D)".to_owned()),
    ]
}

fn weights(count: usize) -> impl Strategy<Value = Vec<f64>> {
    let weight = prop_oneof![3 => 1e-3..1.0_f64, 1 => Just(0.0)];
    let some = |weights: &Vec<f64>| weights.iter().sum::<f64>() > 0.0;
    prop_oneof![
        Just(Vec::new()),
        proptest::collection::vec(weight, count).prop_filter("one of them is above zero", some)
    ]
}

fn system() -> impl Strategy<Value = System> {
    let row = || proptest::array::uniform6(number());
    let row3 = || {
        (row(), row())
            .prop_map(|(one, other)| std::array::from_fn(|k| if k < 6 { one[k] } else { other[k - 6] }))
    };
    let maps = prop_oneof![
        3 => proptest::collection::vec(row(), 1..=20).prop_map(Maps::Plane),
        1 => proptest::collection::vec(row3(), 1..=6).prop_map(Maps::Space),
    ];
    (name(), maps, any::<bool>()).prop_flat_map(|(name, maps, coloured)| {
        let count = if coloured && matches!(maps, Maps::Plane(_)) { maps.len() } else { 0 };
        let colours = proptest::collection::vec(any::<[u8; 3]>(), count);
        (weights(maps.len()), colours).prop_map(move |(probabilities, colours)| System {
            probabilities,
            colours,
            ..System::of(name.clone(), maps.clone())
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(200)))]

    #[test]
    fn every_system_comes_back(system in system()) {
        comes_back(&system);
    }

    #[test]
    fn every_form_can_be_written(system in system()) {
        for format in ExportFormat::ALL {
            match export(&system, format) {
                Ok(text) => prop_assert!(text.len() > 20),
                Err(error) => prop_assert!(["export-plane-only", "no-attractor"].contains(&error.code()), "{error}"),
            }
        }
    }
}
