//! Pictures of attractors: on the CPU, complete, for thumbnails and as truth in tests; and with wgpu, on
//! WebGPU or WebGL2, for the stage.
//!
//! A picture shows every pixel that a piece of the attractor reaches into, and no other. [`rasterize`]
//! makes one from an [`Ifs`](frond_core::Ifs).
//!
//! Both ways begin with a [`Frame`]: the attractor brought into the unit disc by the smallest ellipse around
//! its hull, so that a piece is a matrix, its size is read off the matrix, and its points fit an `f32`
//! whatever the size of the shape and however far one zooms in. A [`View`] takes it to the screen, in `f64`.
//!
//! - A [`Sweep`] walks down the tree of pieces and skips what is outside of the window or lit already. Where
//!   pieces overlap without end it goes over to a [`Flood`] of points on a grid.
//! - A lit pixel holds a code, the first [`Letters`] of its piece. A [`Look`] makes colours of codes.
//! - A [`Density`] spreads samples after the measure; [`tone`] makes light of it.
//!
//! Each shader in `shader/` has a twin here with the same arithmetic, and tests that compare them.

mod bitmap;
mod colour;
mod cut;
mod density;
mod flood;
mod frame;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2")))]
pub mod gpu;
#[cfg(any(test, all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl2"))))]
mod half;
mod letters;
mod measure;
mod plan;
mod points;
mod probe;
mod raster;
mod resolve;
mod sweep;
#[cfg(test)]
mod testing;
pub mod tone;
mod view;
mod window;

pub use bitmap::Bitmap;
pub use colour::{Colouring, Look, OKABE_ITO};
pub use cut::{Piece, cut, cut_at_random};
pub use density::Density;
pub use flood::{CloudPoint, Flood};
pub use frame::Frame;
pub use letters::{CODES, KEPT, Letters};
pub use measure::{MassPiece, Sample, Sampler, pieces_by_mass};
pub use plan::{Batch, Detail, Plan};
pub use points::{Instance, Vertex};
pub use raster::{MAX_SIDE, RasterOptions, RenderError, codes, rasterize};
pub use resolve::{resolve_codes, resolve_density, to_bytes};
pub use sweep::{Hit, Progress, Sweep};
pub use view::View;
pub use window::{Extent, PixelBox, Window};

#[cfg(test)]
mod experiment {
    use super::*;
    #[test]
    fn slow_cases() {
        for (name, rows) in [
            ("almost one", vec![[0.999999,0.,0.,0.999999,0.,0.],[0.999999,0.,0.,0.999999,0.,1.]]),
            ("almost one turned", vec![[0.9999*0.8,-0.9999*0.6,0.9999*0.6,0.9999*0.8,0.,0.],[0.9999,0.,0.,0.9999,0.,1.]]),
            ("0.99", vec![[0.99,0.,0.,0.99,0.,0.],[0.99*0.8,-0.99*0.6,0.99*0.6,0.99*0.8,1.,1.]]),
            ("0.97 x3", vec![[0.97,0.,0.,0.97,0.,0.],[0.97*0.8,-0.97*0.6,0.97*0.6,0.97*0.8,1.,1.],[0.97,0.,0.,-0.97,3.,1.]]),
            ("64 of .9", (0..64).map(|i| { let t = i as f64; [0.9*t.cos(), -0.9*t.sin(), 0.9*t.sin(), 0.9*t.cos(), t, -t*0.3] }).collect()),
            ("thin", vec![[0.9,0.,0.,0.01,0.,0.],[0.9,0.,0.,0.01,0.3,0.5],[0.9,0.3,0.,0.5,0.3,0.5]]),
        ] {
            let t = std::time::Instant::now();
            let Ok(ifs) = frond_core::Ifs::new(rows.into_iter().map(frond_core::Affine2::from_row).collect()) else { println!("{name} none"); continue };
            let hull = frond_core::Hull::of(&ifs);
            println!("{name} hull {:?} {} {}", t.elapsed(), hull.min(), hull.max());
            let fit = View::fit(&hull, 144, 104, 0.05);
            for (w, h) in [(144, 104), (1000, 700)] {
            for (what, view) in [("fit", None), ("far", Some(View { x: 0.0, y: 0.0, scale: fit.scale * 0.001 })), ("x100 centre", Some(View { scale: fit.scale * 100.0, ..fit })), ("x1e4 edge", Some(View { y: hull.max().y, scale: fit.scale * 1e4, ..fit })), ("odd", Some(View { x: 0., y: 0., scale: 3e-8 }))] {
                for colouring in [Colouring::Map, Colouring::Density] {
                let t = std::time::Instant::now();
                let p = rasterize(&ifs, &RasterOptions { width: w, height: h, view, colouring, ..RasterOptions::default() }).unwrap();
                println!("  {w} {what} {colouring:?}: {:?} lit {}", t.elapsed(), p.chunks(4).filter(|p| p[3] > 0).count());
            }}}
        }
    }
}
