//! Self-affinity of graphs, found by voting: both passes in parts, and what is made of what they find.
//!
//! Points cross the boundary as flat arrays t0, x0, t1, x1, ..; clusters as eleven numbers each: hits, a, b, c, d, e
//! and their five bins.

use frond_fit::{
    Assembly, BINS, Candidate, Cluster, Components, Features, FirstPass, FunctionError, HoughError,
    HoughOptions, HoughProgress, Kind, Letter, Model, Pick, SecondPass, Series, Within, assemble,
    assemble_picked, assemble_within, gather, in_range, name_clusters, refine_map, share_cells,
};
use js_sys::{Array, Float64Array, Uint32Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use super::outline;
use crate::boundary::error::{bad_input, failure};
use crate::boundary::value::{object, read, write};

/// Numbers that a cluster crosses as.
const NUMBERS_A_CLUSTER: usize = 11;

/// Counts are taken over so many at a time: no second copy of all of them is needed.
const COUNTS_AT_ONCE: u32 = 1 << 16;

fn of_hough(error: HoughError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn of_function(error: FunctionError) -> JsValue {
    failure(error.code(), &error.to_string())
}

pub(super) fn features(flat: &[f64]) -> Result<Features, JsValue> {
    Features::new(&outline::points(flat)?).map_err(of_hough)
}

fn flat(features: &Features) -> Float64Array {
    let numbers: Vec<f64> = features.points().iter().flat_map(|p| p.to_array()).collect();
    Float64Array::from(&numbers[..])
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
struct PlainOptions {
    reflected: bool,
    least_a: f64,
    least_c: f64,
    cells: f64,
    most_b: f64,
}

impl Default for PlainOptions {
    fn default() -> Self {
        let HoughOptions { reflected, least_a, least_c, cells, most_b } = HoughOptions::default();
        Self { reflected, least_a, least_c, cells: cells as f64, most_b }
    }
}

pub(super) fn read_options(options: JsValue) -> Result<HoughOptions, JsValue> {
    let PlainOptions { reflected, least_a, least_c, cells, most_b } = read("The options", options)?;
    // A cast of NaN or a negative number gives 0, of which the fewest are made.
    Ok(HoughOptions { reflected, least_a, least_c, cells: cells as usize, most_b })
}

fn write_progress(HoughProgress { share, votes }: HoughProgress) -> JsValue {
    object(&[("share", share.into()), ("votes", (votes as f64).into())])
}

/// Feature points of a series: `count` at equal distances, smoothed by so many parts of the interval. Points may come
/// in any order; those that are not finite are left out.
#[wasm_bindgen(js_name = seriesFeatures)]
pub fn series_features(points: &[f64], count: f64, smoothing: f64) -> Result<Float64Array, JsValue> {
    let series = Series::new(&outline::points(points)?).map_err(of_hough)?;
    Ok(flat(&series.features(count as usize, smoothing).map_err(of_hough)?))
}

/// The first pass, or a share of it: hits of (a, b, c).
#[wasm_bindgen]
pub struct HoughFirst {
    coarse: Features,
    fine: Features,
    options: HoughOptions,
    pass: FirstPass,
}

#[wasm_bindgen]
impl HoughFirst {
    /// Share `part` of `parts` of the domain triples of `coarse`, on ranges of `fine`.
    #[wasm_bindgen(constructor)]
    pub fn new(
        coarse: &[f64],
        fine: &[f64],
        #[wasm_bindgen(unchecked_param_type = "HoughOptions | null | undefined")] options: JsValue,
        part: f64,
        parts: f64,
    ) -> Result<Self, JsValue> {
        let (coarse, fine, options) = (features(coarse)?, features(fine)?, read_options(options)?);
        let pass = FirstPass::new(&coarse, &fine, options, (part as usize, parts as usize));
        Ok(Self { coarse, fine, options, pass })
    }

    /// Goes some milliseconds on.
    #[wasm_bindgen(unchecked_return_type = "HoughProgress")]
    pub fn step(&mut self) -> JsValue {
        write_progress(self.pass.step())
    }

    /// All counts, to be added to those of another share.
    pub fn counts(&self) -> Uint32Array {
        Uint32Array::from(self.pass.counts())
    }

    /// Adds the counts of another share.
    pub fn add(&mut self, counts: &Uint32Array) -> Result<(), JsValue> {
        let all = self.pass.counts().len();
        if counts.length() as usize != all {
            return Err(bad_input("The list of counts", "it is to be as long as that of `counts`"));
        }
        let mut whole = vec![0; all];
        for from in (0..counts.length()).step_by(COUNTS_AT_ONCE as usize) {
            let until = (from + COUNTS_AT_ONCE).min(counts.length());
            counts.subarray(from, until).copy_to(&mut whole[from as usize..until as usize]);
        }
        self.pass.add(&whole);
        Ok(())
    }

    /// The most hits of any b, at a * 128 + c: what is to be seen while it counts.
    pub fn plane(&self) -> Uint32Array {
        let mut plane = vec![0_u32; BINS * BINS];
        for (row, counts) in self.pass.counts().chunks_exact(BINS).enumerate() {
            let a = row / BINS;
            for (most, &count) in plane[a * BINS..].iter_mut().zip(counts) {
                *most = count.max(*most);
            }
        }
        Uint32Array::from(&plane[..])
    }

    /// The cells that the second pass is to look at, split so that each of `parts` takes about as long.
    #[wasm_bindgen(unchecked_return_type = "Uint32Array<ArrayBuffer>[]")]
    pub fn promising(&self, parts: f64) -> Array {
        let cells = self.pass.promising();
        let parts = (parts as usize).clamp(1, 64);
        let shares = share_cells(&self.coarse, &self.fine, self.options, &cells, parts);
        shares.iter().map(|share| JsValue::from(Uint32Array::from(&share[..]))).collect()
    }
}

/// The second pass for some cells: hits of (d, e).
#[wasm_bindgen]
pub struct HoughSecond {
    pass: SecondPass,
}

#[wasm_bindgen]
impl HoughSecond {
    /// All pairs, for these cells.
    #[wasm_bindgen(constructor)]
    pub fn new(
        coarse: &[f64],
        fine: &[f64],
        #[wasm_bindgen(unchecked_param_type = "HoughOptions | null | undefined")] options: JsValue,
        cells: &[u32],
    ) -> Result<Self, JsValue> {
        let pass =
            SecondPass::new(&features(coarse)?, &features(fine)?, read_options(options)?, cells, (0, 1));
        Ok(Self { pass })
    }

    /// Goes some milliseconds on.
    #[wasm_bindgen(unchecked_return_type = "HoughProgress")]
    pub fn step(&mut self) -> JsValue {
        write_progress(self.pass.step())
    }

    /// The highest bins around each cell.
    pub fn peaks(&self) -> Float64Array {
        Float64Array::from(&peaks(&self.pass)[..])
    }
}

/// The highest bins around each cell, as [`hough_clusters`] takes them.
pub(super) fn peaks(pass: &SecondPass) -> Vec<f64> {
    pass.peaks().iter().flat_map(write_cluster).collect()
}

fn write_cluster(cluster: &Cluster) -> [f64; NUMBERS_A_CLUSTER] {
    let [a, b, c, d, e] = cluster.map;
    let [p, q, r, s, t] = cluster.bins.map(f64::from);
    [f64::from(cluster.hits), a, b, c, d, e, p, q, r, s, t]
}

fn read_clusters(flat: &[f64]) -> Vec<Cluster> {
    let cluster = |row: &[f64]| Cluster {
        hits: row[0] as u32,
        map: std::array::from_fn(|i| row[1 + i]),
        bins: std::array::from_fn(|i| row[6 + i] as u16),
    };
    flat.chunks_exact(NUMBERS_A_CLUSTER).map(cluster).collect()
}

#[derive(Serialize)]
struct PlainFound {
    hits: u32,
    map: [f64; 5],
    /// In the ranges that are counted.
    at: [f64; 5],
    /// Along the principal axes.
    place: [f64; 5],
    kind: &'static str,
    echo: Vec<Letter>,
    candidate: Option<Candidate>,
}

#[derive(Serialize)]
struct PlainClusters {
    found: Vec<PlainFound>,
    space: Option<Components>,
}

/// The clusters among the peaks of all parts, the most hits first: named, refined, and laid out along the principal
/// components of their space.
#[wasm_bindgen(js_name = houghClusters, unchecked_return_type = "HoughClusters")]
pub fn hough_clusters(
    coarse: &[f64],
    fine: &[f64],
    #[wasm_bindgen(unchecked_param_type = "HoughOptions | null | undefined")] options: JsValue,
    peaks: &[f64],
) -> Result<JsValue, JsValue> {
    let (coarse, fine, options) = (features(coarse)?, features(fine)?, read_options(options)?);
    let clusters = gather(read_clusters(peaks), options.cells);
    let components = Components::of(&clusters);
    let found = name_clusters(&coarse, &fine, options, &clusters).into_iter().map(|found| {
        let (kind, echo) = match found.kind {
            Kind::Map => ("map", Vec::new()),
            Kind::Echo(word) => ("echo", word),
            Kind::Clutter => ("clutter", Vec::new()),
        };
        PlainFound {
            hits: found.cluster.hits,
            map: found.cluster.map,
            at: in_range(&found.cluster),
            place: components.map_or([0.0; 5], |components| components.place(&found.cluster)),
            kind,
            echo,
            candidate: found.candidate,
        }
    });
    write(&PlainClusters { found: found.collect(), space: components })
}

/// The part of the graph on which a map holds, and b, c and e of least squares there; null where it holds nowhere.
#[wasm_bindgen(js_name = houghRefine, unchecked_return_type = "HoughCandidate | null")]
pub fn hough_refine(coarse: &[f64], fine: &[f64], map: &[f64]) -> Result<JsValue, JsValue> {
    let map: [f64; 5] = map.try_into().map_err(|_| bad_input("The map", "it has five numbers"))?;
    match refine_map(&features(coarse)?, &features(fine)?, map) {
        Some(candidate) => write(&candidate),
        None => Ok(JsValue::NULL),
    }
}

#[derive(Serialize)]
struct PlainPiece {
    map: [f64; 5],
    domain: [f64; 2],
}

#[derive(Serialize)]
struct PlainGraph {
    kind: &'static str,
    pieces: Vec<PlainPiece>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PlainAssembly {
    graph: PlainGraph,
    used: Vec<Option<usize>>,
    mean_square: f64,
    worst: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    numbers: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polyline: Option<usize>,
}

impl From<Assembly> for PlainAssembly {
    fn from(whole: Assembly) -> Self {
        let kind = match whole.model {
            Model::Fif => "fif",
            Model::Rfif => "rfif",
            Model::Pfif => "pfif",
        };
        let pieces = whole.function.curve().pieces().iter();
        let pieces = pieces.map(|piece| PlainPiece { map: piece.map(), domain: piece.domain }).collect();
        Self {
            graph: PlainGraph { kind, pieces },
            used: whole.used,
            mean_square: whole.mean_square,
            worst: whole.worst,
            numbers: None,
            polyline: None,
        }
    }
}

/// A whole function of the candidates that do it best. With a `tolerance`, in heights of the graph: the one of fewest
/// numbers that is nowhere farther off, never more than a polyline takes; both are told.
#[wasm_bindgen(js_name = houghAssemble, unchecked_return_type = "HoughAssembly")]
pub fn hough_assemble(
    coarse: &[f64],
    fine: &[f64],
    #[wasm_bindgen(unchecked_param_type = "HoughCandidate[]")] candidates: JsValue,
    tolerance: Option<f64>,
) -> Result<JsValue, JsValue> {
    let candidates: Vec<Candidate> = read("The list of candidates", candidates)?;
    let (coarse, fine) = (features(coarse)?, features(fine)?);
    let Some(tolerance) = tolerance else {
        let whole = assemble(&coarse, &fine, &candidates).map_err(of_function)?;
        return write(&PlainAssembly::from(whole));
    };
    let Within { assembly, numbers, polyline } =
        assemble_within(&coarse, &fine, &candidates, tolerance).map_err(of_function)?;
    write(&PlainAssembly { numbers: Some(numbers), polyline: Some(polyline), ..assembly.into() })
}

#[derive(Deserialize)]
struct PlainPick {
    map: [f64; 5],
    domain: [f64; 2],
}

/// A whole function of maps that were picked with their domains. `tied`: ends of pieces meet at feature points.
#[wasm_bindgen(js_name = houghPicked, unchecked_return_type = "HoughAssembly")]
pub fn hough_picked(
    coarse: &[f64],
    fine: &[f64],
    #[wasm_bindgen(unchecked_param_type = "{ map: GraphMap; domain: [from: number, to: number] }[]")]
    picks: JsValue,
    tied: bool,
) -> Result<JsValue, JsValue> {
    let plain: Vec<PlainPick> = read("The list of maps", picks)?;
    let picks: Vec<_> = plain.into_iter().map(|PlainPick { map, domain }| Pick { map, domain }).collect();
    let whole = assemble_picked(&features(coarse)?, &features(fine)?, &picks, tied).map_err(of_function)?;
    write(&PlainAssembly::from(whole))
}
