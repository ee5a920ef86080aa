//! Verdicts with their evidence, as JavaScript meets them.

use js_sys::{Array, JSON, Reflect};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::js::{get, json, maps_of, text};

#[wasm_bindgen_test]
fn connected_comes_with_a_reason_and_touching_with_what_it_hangs_on() {
    let gasket = frond_web::connectedness(maps_of("gasket"), JsValue::UNDEFINED).unwrap();
    assert_eq!(text(&gasket, "verdict"), "connected");
    let reason = get(&gasket, "reason");
    assert_eq!(text(&reason, "kind"), "shared-points");
    assert!(text(&reason, "text").len() > 20);
    assert_eq!(Array::from(&get(&reason, "assuming")).length(), 0);
    let links = Array::from(&get(&reason, "links"));
    assert_eq!(links.length(), 2);
    let wanted = r#"{"kind":"point","pair":[0,1],"words":["1(2)","2(1)"],"at":[0.5,0]}"#;
    assert_eq!(JSON::stringify(&links.get(0)).unwrap(), wanted);
    assert!(get(&gasket, "closest").is_undefined());

    let koch = frond_web::connectedness(maps_of("koch"), JsValue::UNDEFINED).unwrap();
    assert_eq!(text(&koch, "verdict"), "touching");
    let assuming = Array::from(&get(&get(&koch, "reason"), "assuming"));
    assert_eq!(assuming.get(0).as_string().unwrap(), "0.3333333333333333 is 1/3");
    assert!(get(&koch, "closest").is_object());

    let dust = frond_web::connectedness(maps_of("dust"), JsValue::UNDEFINED).unwrap();
    assert!(get(&dust, "reason").is_undefined());
}

#[wasm_bindgen_test]
fn certificates_are_checked_and_changed_ones_refused() {
    let certificate = frond_web::certificate(maps_of("dust"), JsValue::UNDEFINED).unwrap();
    let check = frond_web::check_certificate(certificate.clone()).unwrap();
    assert_eq!(get(&check, "valid"), JsValue::TRUE, "{}", text(&check, "text"));
    assert_eq!(
        get(&check, "pairs").as_f64(),
        Some(f64::from(Array::from(&get(&certificate, "pairs")).length()))
    );
    // Saved and read again, it is the same to the last digit.
    let saved = JSON::stringify(&certificate).unwrap().as_string().unwrap();
    let again = frond_web::check_certificate(json(&saved)).unwrap();
    assert_eq!(get(&again, "valid"), JsValue::TRUE);
    let pair = Array::from(&get(&certificate, "pairs")).get(0);
    Reflect::set(&pair, &"normal".into(), &json("[0, 0]")).unwrap();
    let changed = frond_web::check_certificate(certificate).unwrap();
    assert_eq!(get(&changed, "valid"), JsValue::FALSE);
    assert!(text(&changed, "text").contains("not apart"), "{}", text(&changed, "text"));
    for nothing in [JsValue::UNDEFINED, json("{}"), json("[]"), json("{\"maps\": [[1]]}"), 5.into()] {
        let refused = frond_web::check_certificate(nothing).unwrap();
        assert_eq!(get(&refused, "valid"), JsValue::FALSE);
    }
    // What is in one piece has none.
    assert!(frond_web::certificate(maps_of("gasket"), JsValue::UNDEFINED).unwrap().is_null());
    assert!(frond_web::certificate(json("{\"maps\": [[2, 0, 0, 2, 0, 0]]}"), JsValue::UNDEFINED).is_err());
}
