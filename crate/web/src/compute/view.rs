//! Which part of the plane a picture shows.

use frond_render::View;
use serde::Deserialize;

#[derive(Deserialize)]
pub(super) struct PlainView {
    x: f64,
    y: f64,
    scale: f64,
}

impl From<PlainView> for View {
    fn from(PlainView { x, y, scale }: PlainView) -> Self {
        Self { x, y, scale }
    }
}
