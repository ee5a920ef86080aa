//! All readers.

mod links;
mod maps;
mod outlines;
mod png;
mod proofs;

pub use links::{CURVE, LINK, SPACE, SPLINE};
pub use maps::{AIFS, FLAME, FRACTINT, JSON, TABLE};
pub use outlines::{CSV, GEOJSON, SVG, TPS};
pub use png::PNG;
pub use proofs::CERTIFICATE;

/// Hands the names of all readers to a macro, which makes a test of each.
#[macro_export]
macro_rules! all_readers {
    ($tests:ident) => {
        $tests! {
            aifs: AIFS,
            certificate: CERTIFICATE,
            csv: CSV,
            curve: CURVE,
            flame: FLAME,
            fractint: FRACTINT,
            geojson: GEOJSON,
            json: JSON,
            link: LINK,
            png: PNG,
            space: SPACE,
            spline: SPLINE,
            svg: SVG,
            table: TABLE,
            tps: TPS
        }
    };
}
