//! The locus by the graphics card.

use std::rc::Rc;

use frond_locus::{LocusGrid, SingleLocus, State, unpack_single};
use frond_render::gpu::{LocusError, LocusGpu, LocusJob};
use js_sys::{Date, Float32Array, Function, Promise, Reflect, Uint8Array, global};
use serde::Deserialize;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::boundary::error::failure;
use crate::boundary::grid::read_grid;
use crate::boundary::value::{object, read, read_morph};

/// Decides loci on the graphics card, by WebGPU, on a device of its own: on the page's thread or in a worker.
///
/// It works in single precision. `connected` and `disconnected` are proved all the same, `touching` says that pieces
/// come within epsilon, and what single precision cannot tell is left `undecided` for `settleLocus`.
#[wasm_bindgen]
pub struct LocusCompute {
    gpu: Rc<LocusGpu>,
}

#[derive(Deserialize)]
struct Plane {
    #[serde(default)]
    w: f64,
}

#[derive(Deserialize)]
struct Polygon {
    sides: f64,
}

#[wasm_bindgen]
impl LocusCompute {
    /// Opens a device. Rejects with the code `no-gpu` where there is no WebGPU.
    pub async fn create() -> Result<LocusCompute, JsValue> {
        let gpu = LocusGpu::open().await.map_err(|error| of_gpu(&error))?;
        Ok(Self { gpu: Rc::new(gpu) })
    }

    /// The adapter's own words; may be empty.
    #[wasm_bindgen(getter)]
    pub fn description(&self) -> String {
        self.gpu.description.clone()
    }

    /// Whether the processor stands in for a graphics card: then nothing is won.
    #[wasm_bindgen(getter)]
    pub fn software(&self) -> bool {
        self.gpu.software
    }

    /// The locus of a morph, with the options of `locus`. Gaps of undecided samples are NaN; `left` is their number,
    /// and `milliseconds` how long it took until the answer was back. Rejects with `single-maps` (more than
    /// 8), `single-fine` (epsilon or the step below what single precision tells apart), `gpu-size` or `gpu-fault`:
    /// leave it to `LocusTiles` then; with `device-lost` forever.
    #[wasm_bindgen(unchecked_return_type = "Promise<Locus & { milliseconds: number; left: number }>")]
    pub fn run(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Ifs")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Ifs")] to: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LocusOptions")] options: JsValue,
    ) -> Promise {
        let gpu = Rc::clone(&self.gpu);
        future_to_promise(async move {
            let start = now();
            let morph = read_morph(&from, &to, &options)?;
            let (grid, epsilon) = read_grid(&options)?;
            let Plane { w } = read("The options", options)?;
            let single = SingleLocus::of_morph(&morph, w, &grid, epsilon);
            decide(&gpu, single.map_err(|error| failure(error.code(), &error.to_string()))?, &grid, start)
                .await
        })
    }

    /// The locus of the systems s z + exp(2 pi i k / sides) over the complex s; else as `run`.
    #[wasm_bindgen(js_name = runFamily, unchecked_return_type = "Promise<Locus & { milliseconds: number; left: number }>")]
    pub fn run_family(
        &self,
        #[wasm_bindgen(unchecked_param_type = "PolygonFamily")] family: JsValue,
        #[wasm_bindgen(unchecked_param_type = "FamilyOptions")] options: JsValue,
    ) -> Promise {
        let gpu = Rc::clone(&self.gpu);
        future_to_promise(async move {
            let start = now();
            let Polygon { sides } = read("The family", family)?;
            let (grid, epsilon) = read_grid(&options)?;
            let single = SingleLocus::of_polygons(sides as usize, &grid, epsilon);
            decide(&gpu, single.map_err(|error| failure(error.code(), &error.to_string()))?, &grid, start)
                .await
        })
    }
}

async fn decide(
    gpu: &LocusGpu,
    single: SingleLocus,
    grid: &LocusGrid,
    start: f64,
) -> Result<JsValue, JsValue> {
    let job = LocusJob {
        maps: single.maps(),
        epsilon: single.epsilon(),
        columns: single.columns(),
        rows: single.rows(),
    };
    let answers = gpu.run(job).await.map_err(|error| of_gpu(&error))?;
    gpu.took(answers.len(), now() - start);
    let samples = answers.iter().copied().map(unpack_single);
    let state: Vec<u8> = samples.clone().map(|sample| sample.state as u8).collect();
    let undecided = |sample: &frond_locus::Sample| sample.state == State::Undecided;
    let left = samples.clone().filter(undecided).count();
    let gap: Vec<f32> = samples.map(|s| if undecided(&s) { f32::NAN } else { s.gap }).collect();
    Ok(object(&[
        ("width", (grid.width() as f64).into()),
        ("height", (grid.height() as f64).into()),
        ("state", Uint8Array::from(&state[..]).into()),
        ("gap", Float32Array::from(&gap[..]).into()),
        ("milliseconds", (now() - start).into()),
        ("left", (left as f64).into()),
    ]))
}

fn of_gpu(error: &LocusError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// Milliseconds since some moment, by the finest clock there is.
fn now() -> f64 {
    let clock = || -> Result<f64, JsValue> {
        let performance = Reflect::get(&global(), &"performance".into())?;
        let now: Function = Reflect::get(&performance, &"now".into())?.dyn_into()?;
        Ok(now.call0(&performance)?.as_f64().unwrap_or(0.0))
    };
    clock().unwrap_or_else(|_| Date::now())
}
