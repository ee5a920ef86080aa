//! What is written comes back: maps bit for bit where a format is a text of doubles, documents as they are.

use frond_exchange::{ExportFormat, Maps, System, export, import};
use frond_scene::{Scene, decode, presets, presets3};
use proptest::prelude::*;

const DOUBLES: [ExportFormat; 4] =
    [ExportFormat::Json, ExportFormat::Fractint, ExportFormat::Flame, ExportFormat::Csv];

fn bits(maps: &Maps) -> Vec<u64> {
    match maps {
        Maps::Plane(rows) => rows.iter().flatten().map(|x| x.to_bits()).collect(),
        Maps::Space(rows) => rows.iter().flatten().map(|x| x.to_bits()).collect(),
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
    prop_oneof!["[A-Za-z ]{0,20}", "\\PC{0,12}", Just("comment".to_owned()), Just("(3D)".to_owned())]
}

fn weights(count: usize) -> impl Strategy<Value = Vec<f64>> {
    prop_oneof![Just(Vec::new()), proptest::collection::vec(1e-3..1.0_f64, count)]
}

fn system() -> impl Strategy<Value = System> {
    let row = || proptest::array::uniform6(number());
    let row3 = || {
        (row(), row())
            .prop_map(|(one, other)| std::array::from_fn(|k| if k < 6 { one[k] } else { other[k - 6] }))
    };
    let maps = prop_oneof![
        3 => proptest::collection::vec(row(), 1..=12).prop_map(Maps::Plane),
        1 => proptest::collection::vec(row3(), 1..=6).prop_map(Maps::Space),
    ];
    (name(), maps).prop_flat_map(|(name, maps)| {
        weights(maps.len()).prop_map(move |probabilities| System {
            name: name.clone(),
            maps: maps.clone(),
            probabilities,
            remarks: Vec::new(),
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
