//! Tests of bends in links.

use super::*;

#[test]
fn a_deformation_reads_like_words() {
    let mut deform = Deformation::at_rest([0.0, 0.0, 1.0, 1.0]);
    let moves = &mut deform.keys[0].moves;
    (moves[10], moves[11]) = (0.1, 0.25);
    let scene = Scene { tool: Tool::Deform, deform: Some(deform), ..Scene::default() };
    let words =
        "v=1&a=dragon-3&b=gasket&turns=0,-1,0&tool=deform&mesh=4x4:0,0,1,1&bend=0,9,0.75&keys=0:6,0.1,0.25";
    assert_eq!(encode(&scene), words);
    assert_eq!(decode(words), (scene, None));
}

#[test]
fn damaged_deformations_say_which_word_is() {
    let key_of = |words: &str| match decode(&format!("v=1&a=gasket&b=gasket&{words}")).1 {
        Some(LinkError::Value { key, .. }) => key,
        other => panic!("{words}: {other:?}"),
    };
    for (words, key) in [
        ("tool=hammer", "tool"),
        ("mesh=4x4", "mesh"),
        ("mesh=1x4:0,0,1,1", "mesh"),
        ("mesh=17x4:0,0,1,1", "mesh"),
        ("mesh=99999999999999999999x4:0,0,1,1", "mesh"),
        ("mesh=4x4:0,0,0,1", "mesh"),
        ("mesh=4x4:0,0,NaN,1", "mesh"),
        ("mesh=4x4:0,0,1,1&keys=0:17,0,0", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0:0,1,1", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0:1,1", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0:1,1,inf", "keys"),
        ("mesh=4x4:0,0,1,1&keys=0.5:;0.5:", "keys"),
        ("mesh=4x4:0,0,1,1&keys=2:", "keys"),
        ("mesh=4x4:0,0,1,1&bend=3,2,0.5", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,1e9,0.5", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,2,-1", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,2,NaN", "bend"),
        ("mesh=4x4:0,0,1,1&bend=0,2,0.5,0.5", "bend"),
        ("mesh=4x4:0,0,1,1&loop=0", "loop"),
        ("mesh=4x4:0,0,1,1&spin=fast", "spin"),
        ("mesh=4x4:0,0,1,1&join=glue", "join"),
        ("mesh=4x4:0,0,1,1&picture=4", "picture"),
        ("mesh=4x4:0,0,1,1&tint=0,9,1:all:ff0000", "tint"),
        ("mesh=2x2:0,0,1,1&tint=0,9,1:all:ff0000,00ff00,0000ff,gggggg", "tint"),
        ("mesh=2x2:0,0,1,1&tint=0,9,1:some:ff0000,00ff00,0000ff,000000", "tint"),
    ] {
        assert_eq!(key_of(words), key, "{words}");
    }
    let many: Vec<String> = (0..40).map(|i| format!("{}:", f64::from(i) / 40.0)).collect();
    assert_eq!(key_of(&format!("mesh=4x4:0,0,1,1&keys={}", many.join(";"))), "keys");
}
