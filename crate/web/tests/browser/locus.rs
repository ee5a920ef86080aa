//! The locus by the graphics card, against its twin and through JavaScript.

use frond_core::{Affine2, Morph, MorphOptions};
use frond_locus::{Bounds, LocusGrid, SingleLocus, State, unpack_single};
use frond_render::gpu::{LocusError, LocusGpu, LocusJob};
use frond_web::{LocusCompute, locus, settle_locus};
use glam::DVec2;
use js_sys::{Float32Array, JSON, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{console_log, wasm_bindgen_test};

use crate::js::get;

/// `None` where the browser has no WebGPU.
async fn open() -> Option<LocusGpu> {
    match LocusGpu::open().await {
        Ok(gpu) => {
            console_log!("{}", gpu.description);
            Some(gpu)
        }
        Err(problem) => {
            console_log!("not tested: {problem}");
            None
        }
    }
}

fn dragon() -> [Affine2; 3] {
    let a = Affine2::from_row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]);
    let b = Affine2::from_row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]);
    [a, b * a, b * b]
}

fn gasket() -> [Affine2; 3] {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
    corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5))
}

/// Compares all samples with the twin.
async fn compare(gpu: &LocusGpu, single: &SingleLocus, grid: &LocusGrid) {
    let job = LocusJob {
        maps: single.maps(),
        epsilon: single.epsilon(),
        columns: single.columns(),
        rows: single.rows(),
    };
    let answers = gpu.run(job).await.unwrap();
    let samples = grid.width() * grid.height();
    assert_eq!(answers.len(), samples);
    let (mut differ, mut one, mut states) = (0, 0, [0; 4]);
    for (k, &bits) in answers.iter().enumerate() {
        let (x, y) = (k % grid.width(), k / grid.width());
        let (seen, twin) = (unpack_single(bits), single.decide(x, y));
        states[twin.state as usize] += 1;
        let at = format!("({x}, {y}): {seen:?}, by the twin {twin:?}");
        if (seen.state == State::Undecided) != (twin.state == State::Undecided) {
            one += 1;
        } else if seen.state != twin.state {
            // Both are right: the gap is between zero and epsilon.
            assert!(seen.gap.max(twin.gap) <= 2.0 * single.epsilon(), "{at}");
            differ += 1;
        } else if seen.state == State::Disconnected {
            // A descent that takes another turn still bounds the same gap.
            assert!(seen.gap > 0.4 * twin.gap && twin.gap > 0.4 * seen.gap, "{at}");
        }
    }
    console_log!("{states:?} by the twin; {differ} decided differently, {one} by one of the two");
    assert!(differ * 500 <= samples && one * 50 <= samples, "{differ} {one}");
}

#[wasm_bindgen_test]
async fn the_card_answers_as_its_twin() {
    let Some(gpu) = open().await else { return };
    let morph = Morph::new(&dragon(), &gasket(), &MorphOptions::default()).unwrap();
    let grid = LocusGrid::new(Bounds::default(), 61, 43).unwrap();
    for epsilon in [1.0 / 600.0, 1e-5] {
        compare(&gpu, &SingleLocus::of_morph(&morph, 0.1, &grid, epsilon).unwrap(), &grid).await;
    }
    let bounds = Bounds { u0: -0.75, v0: 0.0, u1: 0.75, v1: 0.75 };
    let grid = LocusGrid::new(bounds, 41, 27).unwrap();
    for sides in [2, 4, 8] {
        compare(&gpu, &SingleLocus::of_polygons(sides, &grid, 1e-3).unwrap(), &grid).await;
    }
    let none = gpu.run(LocusJob { maps: 9, epsilon: 1e-3, columns: &[], rows: &[] }).await;
    assert_eq!(none, Err(LocusError::Size));
}

fn system(maps: &[Affine2]) -> JsValue {
    let rows: Vec<String> = maps.iter().map(|map| format!("{:?}", map.to_row())).collect();
    JSON::parse(&format!("{{\"maps\": [{}]}}", rows.join(","))).unwrap()
}

fn arrays(value: &JsValue) -> (Vec<u8>, Vec<f32>) {
    (
        get(value, "state").unchecked_into::<Uint8Array>().to_vec(),
        get(value, "gap").unchecked_into::<Float32Array>().to_vec(),
    )
}

#[wasm_bindgen_test]
async fn card_and_processor_together_decide_everything() {
    if open().await.is_none() {
        return;
    }
    let compute = LocusCompute::create().await.unwrap();
    let (from, to) = (system(&dragon()), system(&gasket()));
    // Fine enough that the card leaves some.
    let options = JSON::parse("{\"width\": 61, \"height\": 40, \"epsilon\": 1e-5}").unwrap();
    let run = compute.run(from.clone(), to.clone(), options.clone());
    // What is under way is finished all the same.
    drop(compute);
    let seen = JsFuture::from(run).await.unwrap();
    assert!(get(&seen, "milliseconds").as_f64().unwrap() > 0.0);
    let left = get(&seen, "left").as_f64().unwrap() as usize;
    let (state, gap) = arrays(&seen);
    assert_eq!((state.len(), gap.len()), (2440, 2440));
    assert_eq!(state.iter().filter(|&&code| code == 3).count(), left);
    assert!(left > 0 && left < 200, "{left}");
    // In two slices.
    Reflect::set(&options, &"most".into(), &5.into()).unwrap();
    let part = settle_locus(from.clone(), to.clone(), options.clone(), state, gap).unwrap();
    assert_eq!(get(&part, "left").as_f64().unwrap() as usize, left - 5);
    let (state, gap) = arrays(&part);
    Reflect::set(&options, &"most".into(), &JsValue::UNDEFINED).unwrap();
    let whole = settle_locus(from.clone(), to.clone(), options.clone(), state, gap).unwrap();
    assert_eq!(get(&whole, "left").as_f64(), Some(0.0));
    let truth = locus(from, to, options).unwrap();
    let ((state, gap), (true_state, true_gap)) = (arrays(&whole), arrays(&truth));
    let holds = |code: u8| code < 2;
    for k in 0..2440 {
        let near = gap[k].max(true_gap[k]) < 3e-5;
        assert!(holds(state[k]) == holds(true_state[k]) || near, "{k}: {} {}", state[k], true_state[k]);
        assert!((gap[k] - true_gap[k]).abs() <= 0.6 * true_gap[k] || near, "{k}: {} {}", gap[k], true_gap[k]);
    }
}

#[wasm_bindgen_test]
async fn what_the_card_cannot_do_is_refused() {
    if open().await.is_none() {
        return;
    }
    let compute = LocusCompute::create().await.unwrap();
    let code = async |from: JsValue, options: &str| {
        let options = JSON::parse(options).unwrap();
        let refused = JsFuture::from(compute.run(from, system(&gasket()), options)).await;
        get(&refused.unwrap_err(), "code").as_string().unwrap()
    };
    assert_eq!(code(system(&gasket()), "{\"width\": 0, \"height\": 4}").await, "locus-size");
    assert_eq!(code(system(&gasket()[..2]), "{\"width\": 4, \"height\": 4}").await, "map-counts");
    let fine = "{\"width\": 4, \"height\": 4, \"epsilon\": 1e-9}";
    assert_eq!(code(system(&gasket()), fine).await, "single-fine");
    assert_eq!(code(JsValue::UNDEFINED, fine).await, "bad-input");
    let large = "{\"width\": 8192, \"height\": 8192}";
    assert_eq!(code(system(&gasket()), large).await, "gpu-size");
    let family = JSON::parse("{\"sides\": 9}").unwrap();
    let options = JSON::parse("{\"width\": 4, \"height\": 4}").unwrap();
    let refused = JsFuture::from(compute.run_family(family, options)).await;
    assert_eq!(get(&refused.unwrap_err(), "code").as_string().unwrap(), "single-maps");
}
