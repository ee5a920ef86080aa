//! Systems of space: their parameters, what is known of them, their files.

use frond_core::{
    Affine2, Affine3, Bounds3, ChaosGame3, Contraction3, Place3, affinity_dimension, box_dimension,
    similarity_dimension,
};
use frond_deform::Room3;
use frond_exchange::{FileError, SpaceFile};
use frond_scene::Row3;
use glam::{DMat3, DVec3};
use js_sys::{Float32Array, Uint8Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure, of_ifs};
use crate::boundary::space::{of_transform, read_ifs3, read_map3, read_maps3, read_point3, write_maps3};
use crate::boundary::value::{object, read, write};

/// Throws unless the maps have an attractor together.
#[wasm_bindgen]
pub fn validate3(#[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue) -> Result<(), JsValue> {
    read_ifs3(&maps).map(|_| ())
}

/// The maps of the shape that is moved by `by` (Darwish & Abd-El-Wahab, eq 1). Throws where `by` cannot be undone.
#[wasm_bindgen(unchecked_return_type = "MapRow3[]")]
pub fn conjugate3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3")] by: JsValue,
) -> Result<JsValue, JsValue> {
    let moved = read_ifs3(&maps)?.conjugate(read_map3(by)?).map_err(|error| of_transform(&error))?;
    write_maps3(moved.maps())
}

/// First `inner`, then `outer`.
#[wasm_bindgen(unchecked_return_type = "MapRow3")]
pub fn compose3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3")] outer: JsValue,
    #[wasm_bindgen(unchecked_param_type = "MapRow3")] inner: JsValue,
) -> Result<JsValue, JsValue> {
    write(&(read_map3(outer)? * read_map3(inner)?).to_row())
}

/// The transform that undoes another. Throws where there is none.
#[wasm_bindgen(unchecked_return_type = "MapRow3")]
pub fn invert3(#[wasm_bindgen(unchecked_param_type = "MapRow3")] map: JsValue) -> Result<JsValue, JsValue> {
    write(&read_map3(map)?.undo().map_err(|error| of_transform(&error))?.to_row())
}

/// A turn by `angle` radians about an axis through a point, counter-clockwise seen from its tip.
#[wasm_bindgen(unchecked_return_type = "MapRow3")]
pub fn turning3(
    #[wasm_bindgen(unchecked_param_type = "Point3")] axis: JsValue,
    angle: f64,
    #[wasm_bindgen(unchecked_param_type = "Point3")] through: JsValue,
) -> Result<JsValue, JsValue> {
    let (axis, through) = (read_point3("The axis", axis)?, read_point3("The point", through)?);
    let axis = axis.try_normalize().ok_or_else(|| bad_input("The axis", "it must not be zero"))?;
    if !angle.is_finite() {
        return Err(bad_input("The angle", "a finite number is needed"));
    }
    let turn = Affine3::new(DMat3::from_axis_angle(axis, angle), DVec3::ZERO);
    write(&turn.about(through).to_row())
}

#[derive(Serialize)]
struct PlainPlace {
    shift: [f64; 3],
    turn: [f64; 4],
    scale: [f64; 3],
    exact: bool,
    determinant: f64,
}

/// A transform taken apart by its polar decomposition.
#[wasm_bindgen(unchecked_return_type = "Place3")]
pub fn place3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3")] transform: JsValue,
) -> Result<JsValue, JsValue> {
    let map = read_map3(transform)?;
    let place = Place3::of(map).map_err(|error| of_transform(&error))?;
    let determinant = map.determinant();
    write(&PlainPlace {
        shift: place.shift.to_array(),
        turn: place.turn.to_array(),
        scale: place.scale.to_array(),
        exact: determinant > 0.0 && place.shear == DVec3::ZERO,
        determinant,
    })
}

#[derive(Serialize)]
struct Facts {
    similarity: Option<f64>,
    affinity: f64,
    contractivity: f64,
    centre: [f64; 3],
    radius: f64,
}

/// What there is to say of a system of space.
#[wasm_bindgen(unchecked_return_type = "ShapeFacts3")]
pub fn facts3(#[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue) -> Result<JsValue, JsValue> {
    let ifs = read_ifs3(&maps)?;
    let bounds = Bounds3::of(&ifs);
    let Contraction3 { factor, length, .. } = *ifs.contraction();
    write(&Facts {
        similarity: similarity_dimension(&ifs),
        affinity: affinity_dimension(&ifs),
        contractivity: factor.powf(1.0 / length.max(1) as f64),
        centre: bounds.centre.to_array(),
        radius: bounds.radius,
    })
}

#[derive(Serialize)]
struct PlainRoom {
    min: [f64; 3],
    max: [f64; 3],
    continuous: bool,
    deepest: usize,
}

/// How a shape can be bent: the box that its lattice lies over, and what holds its pieces together.
#[wasm_bindgen(js_name = bendRoom3, unchecked_return_type = "BendRoom3")]
pub fn bend_room3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
) -> Result<JsValue, JsValue> {
    let Room3 { min, max, continuous, deepest } = Room3::of(&read_ifs3(&maps)?);
    write(&PlainRoom { min: min.to_array(), max: max.to_array(), continuous, deepest })
}

/// Points that are thrown to count boxes.
const POINTS_COUNTED: usize = 1_000_000;

/// The box dimension, counted from a million points: long work, for a worker.
#[wasm_bindgen(unchecked_return_type = "BoxCount3")]
pub fn boxes3(#[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue) -> Result<JsValue, JsValue> {
    let ifs = read_ifs3(&maps)?;
    let mut positions = vec![0.0_f32; 3 * POINTS_COUNTED];
    let made = ChaosGame3::new(&ifs, 1).fill(&mut positions, &mut vec![0_u8; POINTS_COUNTED]);
    let found = box_dimension(&positions[..3 * made]);
    let counts: Vec<(f64, f64)> = found.counts.iter().map(|&(side, count)| (side, count as f64)).collect();
    Ok(object(&[("dimension", found.dimension.into()), ("counts", write(&counts)?)]))
}

#[derive(Deserialize)]
pub(super) struct Throwing {
    pub points: f64,
    #[serde(default)]
    pub seed: u32,
}

/// The most points of one call.
const MOST_POINTS: f64 = 16_000_000.0;

impl Throwing {
    pub(super) fn read(options: JsValue) -> Result<(usize, u32), JsValue> {
        let Self { points, seed } = read("The options", options)?;
        if (1.0..=MOST_POINTS).contains(&points) {
            Ok((points as usize, seed))
        } else {
            Err(bad_input("points", "1 to 16000000 are allowed"))
        }
    }
}

/// Points by the chaos game: `{ positions, pieces }`, x0, y0, z0, x1, .. and the last map of each.
#[wasm_bindgen(unchecked_return_type = "{ positions: Float32Array; pieces: Uint8Array }")]
pub fn attractor3(
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ points: number; seed?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let ifs = read_ifs3(&maps)?;
    let (count, seed) = Throwing::read(options)?;
    let (mut positions, mut pieces) = (vec![0.0_f32; 3 * count], vec![0_u8; count]);
    let made = ChaosGame3::new(&ifs, seed).fill(&mut positions, &mut pieces);
    Ok(object(&[
        ("positions", Float32Array::from(&positions[..3 * made]).into()),
        ("pieces", Uint8Array::from(&pieces[..made]).into()),
    ]))
}

#[derive(Serialize)]
struct PlainFile {
    name: String,
    maps: Vec<Row3>,
    probabilities: Vec<f64>,
    remarks: Vec<String>,
}

/// The systems of space of a Fractint file, `name (3D) { .. }`, read as `importFile` does; `countFlat` says how many of
/// the plane are passed over. `probabilities` are one for each map, or none; `remarks` say what was left out. Throws
/// with the line where it is wrong.
#[wasm_bindgen(
    js_name = parseIfs3,
    unchecked_return_type = "{ name: string; maps: MapRow3[]; probabilities: number[]; remarks: string[] }[]"
)]
pub fn parse_file(text: &str) -> Result<JsValue, JsValue> {
    let found = frond_exchange::parse_ifs3(text).map_err(|error| of_file(&error))?;
    let plain =
        |SpaceFile { name, maps, probabilities, remarks }| PlainFile { name, maps, probabilities, remarks };
    write(&found.systems.into_iter().map(plain).collect::<Vec<_>>())
}

/// How many systems of the plane a Fractint file has. Throws as `parseIfs3`, but not for a file of these alone.
#[wasm_bindgen(js_name = countFlat)]
pub fn count_flat(text: &str) -> Result<usize, JsValue> {
    match frond_exchange::parse_ifs3(text) {
        Ok(found) => Ok(found.flat),
        Err(FileError::Flat { count, .. }) => Ok(count),
        Err(error) => Err(of_file(&error)),
    }
}

fn of_file(error: &FileError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// A system as Fractint reads it.
#[wasm_bindgen(js_name = writeIfs3)]
pub fn write_file(
    name: &str,
    #[wasm_bindgen(unchecked_param_type = "MapRow3[]")] maps: JsValue,
) -> Result<String, JsValue> {
    let ifs = read_ifs3(&maps)?;
    let file = SpaceFile {
        name: name.to_owned(),
        maps: ifs.maps().iter().map(|map| map.to_row()).collect(),
        probabilities: ifs.probabilities().to_vec(),
        remarks: Vec::new(),
    };
    Ok(frond_exchange::write_ifs3(&file))
}

/// Maps of the plane as maps of space, flat at z = 0: across the plane each shrinks as it does along it on the whole.
#[wasm_bindgen(unchecked_return_type = "MapRow3[]")]
pub fn lift(#[wasm_bindgen(unchecked_param_type = "MapRow[]")] maps: JsValue) -> Result<JsValue, JsValue> {
    let rows: Vec<[f64; 6]> = read("The maps", maps)?;
    if rows.len() > frond_core::MAX_MAPS {
        return Err(of_ifs(&frond_core::IfsError::TooManyMaps { count: rows.len() }));
    }
    let lifted: Vec<Row3> =
        rows.into_iter().map(|row| Affine3::lifted(&Affine2::from_row(row)).to_row()).collect();
    let maps = write(&lifted)?;
    read_maps3(&maps)?;
    Ok(maps)
}
