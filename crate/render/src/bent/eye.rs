//! From the plane to pixels, without a loss of digits.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::picture::view::View;
use crate::picture::window::Window;

/// A [`View`] onto a target: large numbers cancel before they are scaled, so that it is crisp however far one zooms in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    from: DVec2,
    scale: DVec2,
    to: DVec2,
}

impl Eye {
    /// Onto a target of `factor` times as many pixels each way as the window that the view is of.
    pub fn new(view: View, window: Window, factor: f64) -> Self {
        let from = DVec2::new(view.x, view.y);
        let map = view.onto_target(Affine2::new(DMat2::IDENTITY, from), window, factor);
        let scale = DVec2::new(map.linear.x_axis.x, map.linear.y_axis.y);
        Self { from, scale, to: map.translation }
    }

    /// Pixels a unit.
    pub fn scale(&self) -> f64 {
        self.scale.x
    }

    /// Where a point of the plane is seen.
    #[inline]
    pub fn at(&self, point: DVec2) -> DVec2 {
        self.to + self.scale * (point - self.from)
    }

    /// Where the points that a map takes to the plane are seen.
    #[inline]
    pub fn onto(&self, map: &Affine2) -> Affine2 {
        let linear = DMat2::from_diagonal(self.scale) * map.linear;
        Affine2::new(linear, self.at(map.translation))
    }

    /// How far away from each other points are seen at most, whose coordinates were rounded to `f32`.
    pub fn blur(&self, largest: f64) -> f64 {
        f64::from(f32::EPSILON) * largest * self.scale()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_sees_what_the_view_shows() {
        let window = Window { width: 300, height: 200 };
        let view = View { x: 1.0, y: -2.0, scale: 40.0 };
        let inner = Affine2::from_row([0.5, 0.2, -0.1, 0.3, 2.0, -1.0]);
        let eye = Eye::new(view, window, 0.5);
        let wanted = view.onto_target(inner, window, 0.5);
        for point in [DVec2::ZERO, DVec2::new(0.3, -7.0)] {
            assert!((eye.at(inner.apply(point)) - wanted.apply(point)).length() < 1e-9);
            assert!((eye.onto(&inner).apply(point) - wanted.apply(point)).length() < 1e-9);
        }
        let close = View { x: 1e3, y: -1e3, scale: 1e12 };
        let eye = Eye::new(close, window, 1.0);
        let step = eye.at(DVec2::new(1e3 + 1e-11, -1e3)) - eye.at(DVec2::new(1e3, -1e3));
        assert!((step - DVec2::X * 10.0).length() < 1.2, "as far as the coordinates go: {step}");
    }
}
