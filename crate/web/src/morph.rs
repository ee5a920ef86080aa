//! A morph on other people's pages: what `<frond-view>` draws with. No more than that, so that it is small; rows and
//! pixels cross as typed arrays.

use frond_core::{Affine2, Hull, Ifs, Mode, Morph, MorphOptions, Pairing, pair};
use frond_render::{RasterOptions, View, rasterize_unbent};
use frond_scene::{PathKind, Scene, decode_morph};
use wasm_bindgen::prelude::*;

use crate::boundary::error::{failure, of_ifs, of_morph};

/// The morph of a link. Free it when it is no longer needed.
#[wasm_bindgen]
pub struct LinkedMorph {
    scene: Scene,
    morph: Morph,
    pairing: Pairing,
}

#[wasm_bindgen]
impl LinkedMorph {
    /// The morph of a link or of its fragment. Throws where it cannot be read.
    #[wasm_bindgen(constructor)]
    pub fn new(link: &str) -> Result<Self, JsValue> {
        let fragment = link.split_once('#').map_or(link, |(_, fragment)| fragment);
        let scene = decode_morph(fragment).map_err(|error| failure(error.code(), &error.to_string()))?;
        let [a, b] = [&scene.a, &scene.b].map(|shape| shape.ifs().map_err(|error| of_ifs(&error)));
        let pairing = pair(&a?, &b?);
        // Lists for another number of maps count as none, as in the studio.
        let count = pairing.from.len();
        let options = MorphOptions {
            mode: scene.mode,
            correspondence: Some(scene.correspondence.clone())
                .filter(|list| list.len() == count)
                .unwrap_or_default(),
            turns: Some(scene.turns.clone()).filter(|list| list.len() == count).unwrap_or_default(),
        };
        let morph = Morph::new(&pairing.from, &pairing.to, &options).map_err(|error| of_morph(&error))?;
        Ok(Self { scene, morph, pairing })
    }

    /// The name of the first shape.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn a(&self) -> String {
        self.scene.a.name.clone()
    }

    /// The name of the last shape.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn b(&self) -> String {
        self.scene.b.name.clone()
    }

    /// The moment, 0 to 1.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn t(&self) -> f64 {
        self.scene.t
    }

    /// Whether the way is still to be found: it is to be Frond's, and the link does not hold it.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn unplanned(&self) -> bool {
        self.scene.path.kind == PathKind::Auto && self.scene.path.points.is_empty()
    }

    /// The waypoints between the ends: u, v and w of each.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn path(&self) -> Vec<f64> {
        let straight = self.scene.path.kind == PathKind::Straight;
        let points = if straight { &[][..] } else { &self.scene.path.points };
        points.iter().flat_map(|point| [point.u, point.v, point.w]).collect()
    }

    /// How the linear parts are interpolated: `polar` or `linear`.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn mode(&self) -> String {
        if self.scene.mode == Mode::Linear { "linear" } else { "polar" }.to_owned()
    }

    /// Whole extra turns of the maps; empty for none.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn turns(&self) -> Vec<i32> {
        if self.scene.turns.len() == self.morph.len() { self.scene.turns.clone() } else { Vec::new() }
    }

    /// The colours that the link gives the maps, whole numbers, 0xrrggbb; empty where it gives none.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn palette(&self) -> Vec<u32> {
        self.scene.palette.iter().filter_map(|text| u32::from_str_radix(text.get(1..)?, 16).ok()).collect()
    }

    /// The maps at a parameter, six numbers each.
    #[must_use]
    pub fn maps(&self, u: f64, v: f64, w: Option<f64>) -> Vec<f64> {
        self.morph.at3(u, v, w.unwrap_or_default()).into_iter().flat_map(Affine2::to_row).collect()
    }

    /// The box around the attractor at a parameter: x0, y0, x1, y1. Throws where there is none.
    pub fn bounds(&self, u: f64, v: f64, w: Option<f64>) -> Result<Vec<f64>, JsValue> {
        let hull = Hull::of(&self.ifs(u, v, w.unwrap_or_default())?);
        let (min, max) = (hull.min(), hull.max());
        Ok(vec![min.x, min.y, max.x, max.y])
    }

    /// The picture at a parameter: RGBA with straight alpha, row 0 on top, on a transparent background, of the world
    /// around (x, y), so many pixels a unit. A colour is a whole number, 0xrrggbb; none gives Okabe and Ito's. Throws
    /// where there is no attractor, or the picture is larger than 8192 pixels either way.
    #[allow(clippy::too_many_arguments, reason = "an object would bring all that reads it")]
    pub fn draw(
        &self,
        u: f64,
        v: f64,
        w: Option<f64>,
        width: u32,
        height: u32,
        x: f64,
        y: f64,
        scale: f64,
        palette: Option<Vec<u32>>,
    ) -> Result<Vec<u8>, JsValue> {
        let ifs = self.ifs(u, v, w.unwrap_or_default())?;
        let palette = palette.unwrap_or_default();
        let palette: Vec<[u8; 3]> =
            palette.iter().map(|colour| [(colour >> 16) as u8, (colour >> 8) as u8, *colour as u8]).collect();
        let options = RasterOptions {
            width,
            height,
            view: Some(View { x, y, scale }),
            colouring: self.scene.colouring,
            palette: &palette,
            ..RasterOptions::default()
        };
        rasterize_unbent(&ifs, &options).map_err(|error| failure(error.code(), &error.to_string()))
    }

    fn ifs(&self, u: f64, v: f64, w: f64) -> Result<Ifs, JsValue> {
        let ifs = Ifs::new(self.morph.at3(u, v, w)).map_err(|error| of_ifs(&error))?;
        if self.scene.a.weights.is_empty() && self.scene.b.weights.is_empty() {
            return Ok(ifs);
        }
        let probabilities = self.pairing.probabilities(&self.scene.correspondence, u);
        ifs.with_probabilities(&probabilities).map_err(|error| of_ifs(&error))
    }
}
