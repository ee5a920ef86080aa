//! The graphics card from a worker, on a device of its own.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may fail so")]

use frond_web::LocusCompute;
use js_sys::{JSON, Reflect, Uint8Array, global};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{console_log, wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_dedicated_worker);

#[wasm_bindgen_test]
async fn a_worker_decides_loci_on_two_devices() {
    let get = |value: &JsValue, key: &str| Reflect::get(value, &key.into()).unwrap();
    assert!(get(&global(), "document").is_undefined(), "this is to be a worker");
    let (first, second) = match (LocusCompute::create().await, LocusCompute::create().await) {
        (Ok(first), Ok(second)) => (first, second),
        _ => return console_log!("not tested: there is no WebGPU in a worker"),
    };
    console_log!("{}", first.description());
    let family = JSON::parse("{\"sides\": 2}").unwrap();
    let bounds = "{\"u0\": 0.0, \"v0\": 0.0, \"u1\": 0.8, \"v1\": 0.0}";
    let options = JSON::parse(&format!("{{\"width\": 9, \"height\": 1, \"bounds\": {bounds}}}")).unwrap();
    let states = async |compute: &LocusCompute| {
        let seen = JsFuture::from(compute.run_family(family.clone(), options.clone())).await.unwrap();
        get(&seen, "state").unchecked_into::<Uint8Array>().to_vec()
    };
    // s z - 1 and s z + 1 over real s: two points at 0, a segment from 1/2 on, certain from the root of 1/2 on.
    let expected = vec![2, 2, 2, 2, 2, 1, 1, 1, 0];
    assert_eq!(states(&first).await, expected);
    drop(first);
    assert_eq!(states(&second).await, expected, "the other device lives on");
}
