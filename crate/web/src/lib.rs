//! Frond for JavaScript: the one crate that exports to the web.
//!
//! The functions take plain objects and return plain objects. `api.d.ts` and `fit/types.d.ts` have their types. Maps
//! are rows `[a, b, c, d, e, f]`, in space rows of twelve numbers; an IFS is `{ maps, probabilities? }`. What goes
//! wrong is thrown as an error with a stable `code` and a `message` that says what to do. Classes, such as
//! [`LocusTiles`] and `Renderer`, are handles: call `free()` when they are no longer needed.
//!
//! # In which order to read it
//!
//! 1. `boundary`: how values cross. `value` reads and writes maps and options, `error` is what is thrown.
//! 2. `compute`: what describes and draws. `shape` shows best how a function is exported.
//! 3. `bend`, `proof`, `exact`, `curve`, `fit`, `space`, `directed`, `exchange`, `morph`, `text_file` (of `text` and
//!    `svg`): a folder or a file for each of the other modules, a file for what belongs together.
//! 4. `renderers`: the stages of `frond-render` on a canvas, for WebGPU and for WebGL2.
//!
//! Each of these but `boundary` is a feature of the crate; `text_file` is two (`text`, `svg`), and so are `renderers`
//! (`webgpu`, `webgl2`). `cargo xtask build` makes a module of each feature, and one of `compute` and `bend` together:
//! crate/xtask/src/modules.rs names them.
//!
//! [`LocusTiles`]: crate::LocusTiles
#![allow(clippy::missing_errors_doc)]
#![cfg_attr(
    not(all(
        feature = "compute",
        feature = "bend",
        feature = "curve",
        feature = "proof",
        feature = "exact",
        feature = "fit",
        feature = "space",
        feature = "directed",
        feature = "exchange"
    )),
    allow(dead_code, reason = "no module alone needs all conversions")
)]

#[cfg(feature = "bend")]
mod bend;
mod boundary;
#[cfg(feature = "compute")]
mod compute;
#[cfg(feature = "curve")]
mod curve;
#[cfg(feature = "directed")]
pub mod directed;
#[cfg(feature = "exact")]
mod exact;
#[cfg(feature = "exchange")]
pub mod exchange;
#[cfg(feature = "fit")]
pub mod fit;
#[cfg(feature = "morph")]
mod morph;
#[cfg(any(feature = "fit", feature = "svg", feature = "text"))]
mod outlines;
#[cfg(feature = "proof")]
mod proof;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")))]
mod renderers;
#[cfg(feature = "space")]
pub mod space;
#[cfg(any(feature = "svg", feature = "text"))]
pub mod text_file;

#[cfg(feature = "bend")]
pub use bend::*;
#[cfg(feature = "compute")]
pub use boundary::polygon::*;
#[cfg(feature = "compute")]
pub use compute::*;
#[cfg(feature = "curve")]
pub use curve::*;
#[cfg(feature = "exact")]
pub use exact::*;
#[cfg(feature = "morph")]
pub use morph::*;
#[cfg(feature = "proof")]
pub use proof::*;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")))]
pub use renderers::*;
use wasm_bindgen::prelude::*;

#[cfg(any(
    feature = "compute",
    not(any(
        feature = "bend",
        feature = "curve",
        feature = "proof",
        feature = "exact",
        feature = "fit",
        feature = "space",
        feature = "svg",
        feature = "text",
        feature = "exchange",
        feature = "directed",
        feature = "morph"
    ))
))]
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("api.d.ts");

/// What decides and proves speaks of the same things: where it is a module of its own, it has their names from beside
/// it.
#[cfg(all(feature = "proof", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"import type {
  BarnsleyTest, Bounds, Candidate, Certificate, CertificateCheck, CertifyOptions, ConnectedCertificate, Connectedness, FamilyOptions,
  HausdorffDistance, Ifs, IndexBuffer, IndexBufferOptions, Locus, LocusOptions, MorphOptions,
  PathCertificate, PathCheck, PathOptions, PathPlan, PathPoint, PolygonFamily, RatedCandidate, Route
} from "./frond.js";"#;

/// What proves of exact numbers, too.
#[cfg(all(feature = "exact", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const EXACT_TYPES: &str = r#"import type { Analysis, ExactProof, Ifs, ReadNumber } from "./frond.js";"#;

/// What bends, too.
#[cfg(all(feature = "bend", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const BEND_TYPES: &str = r#"import type { Bend, BendFacts, Ifs, RasterOptions } from "./frond.js";"#;

/// What traces and fits, too.
#[cfg(all(feature = "fit", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const FIT_IMPORTS: &str = r#"import type { Curve, Graph } from "./frond.js";"#;
#[cfg(feature = "fit")]
#[wasm_bindgen(typescript_custom_section)]
const FIT_TYPES: &str = include_str!("fit/types.d.ts");

/// And what is about space.
#[cfg(all(feature = "space", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const SPACE_TYPES: &str = r#"import type {
  BendRoom3, Bounds, BoxCount3, Connectedness3, EpsilonProjection, Intersection3, MapRow, MapRow3, MeetExample, MeshFacts,
  MeshFormat, MeshOptions, MorphOptions, PathCheck, PathPlan, PathPoint, Place3, Point3, Preset3, Shadow, ShapeFacts3, Space, SpaceFrame, SpaceLight,
  SpaceObject, SpaceShown, SpaceView
} from "./frond.js";"#;

/// And what reads and writes files.
#[cfg(all(feature = "exchange", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const EXCHANGE_TYPES: &str = r#"import type { DirectedMap, ExportFormat, ExportFormatInfo, ImportedFile, MapRow, MapRow3 } from "./frond.js";"#;

/// And graph-directed shapes.
#[cfg(all(feature = "directed", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const DIRECTED_TYPES: &str = r#"import type {
  Bounds, Curve, DigitSystem, DirectedCertificate, DirectedFacts, DirectedIfs, DirectedMatch, DirectedPreset,
  DirectedRasterOptions, DirectedShape, GridIntersection, HalfTurns, Mode, PointCloud, StateConnectedness
} from "./frond.js";"#;

/// So do closed curves and graphs.
#[cfg(all(feature = "curve", not(feature = "compute")))]
#[wasm_bindgen(typescript_custom_section)]
const CURVE_TYPES: &str =
    r#"import type { Bend, Curve, CurvePreset, Graph, MapRow, PlaneGraph } from "./frond.js";"#;

/// Makes a failure inside the module say where it was, should one ever happen.
#[wasm_bindgen(start)]
pub fn start() {
    #[cfg(target_arch = "wasm32")]
    console_error_panic_hook::set_once();
}
