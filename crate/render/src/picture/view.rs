//! Which part of the plane a picture shows.

use frond_core::{Affine2, Hull};
use glam::{DMat2, DVec2};

use crate::picture::window::Window;

/// A window onto the plane: the world point in its middle and how many pixels a unit takes.
///
/// y points up in the world and down in a picture, whose row 0 is on top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// World x of the middle of the picture.
    pub x: f64,
    /// World y of the middle of the picture.
    pub y: f64,
    /// Pixels a unit, above 0.
    pub scale: f64,
}

/// In pixels: above the rounding errors of `f32` on a screen, and far too little to see.
const PIXEL_OFFSET: f64 = 1.0 / 1024.0;

impl View {
    /// The view that shows all of `hull`, with `margin` of the shorter side left free all around
    /// (0.05 is a twentieth; at most 0.45 is taken).
    #[must_use]
    pub fn fit(hull: &Hull, width: u32, height: u32, margin: f64) -> Self {
        let centre = hull.centre();
        let extent = hull.max() - hull.min();
        let sides = DVec2::new(f64::from(width.max(1)), f64::from(height.max(1)));
        let free = sides - DVec2::splat(2.0 * margin.clamp(0.0, 0.45) * sides.min_element());
        // A shape of no size is shown as if it had one, or its rounding errors would fill the picture.
        let rounding = 1e-9 * centre.length();
        let least = if extent.max_element() > rounding { rounding } else { rounding.max(1.0) };
        let scale = (free / extent.max(DVec2::splat(least.max(1e-290)))).min_element();
        Self { x: centre.x, y: centre.y, scale: scale.clamp(1e-290, 1e290) }
    }

    /// Whether this is a view at all: finite numbers and a scale above 0.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.scale.is_finite() && self.scale > 0.0
    }

    /// The map from the world to the pixels of a picture, (0, 0) being its upper left corner.
    #[must_use]
    pub fn to_screen(&self, window: Window) -> Affine2 {
        let middle = DVec2::new(f64::from(window.width), f64::from(window.height)) * 0.5;
        let linear = DMat2::from_diagonal(DVec2::new(self.scale, -self.scale));
        Affine2::new(linear, middle - linear * DVec2::new(self.x, self.y))
    }

    /// `to_screen * inner`, without the loss of digits that taking it apart would bring far from the
    /// origin: where the view zooms in, the large numbers cancel before they are scaled.
    ///
    /// A thousandth of a pixel is added: shapes have edges that fall exactly between two pixels (a segment
    /// in the middle of a fitted view), and rounding errors would throw their points to one side or the
    /// other.
    #[must_use]
    pub fn onto_screen(&self, inner: Affine2, window: Window) -> Affine2 {
        let middle = DVec2::new(f64::from(window.width), f64::from(window.height)) * 0.5;
        let linear = DMat2::from_diagonal(DVec2::new(self.scale, -self.scale));
        let middle = middle + DVec2::splat(PIXEL_OFFSET);
        let moved = inner.translation - DVec2::new(self.x, self.y);
        Affine2::new(linear * inner.linear, middle + linear * moved)
    }

    /// The same onto a target of `factor` times as many pixels each way, such as one that is drawn twice as
    /// large to be shrunk later.
    #[must_use]
    pub fn onto_target(&self, inner: Affine2, window: Window, factor: f64) -> Affine2 {
        let scale = Affine2::new(DMat2::from_diagonal(DVec2::splat(factor)), DVec2::ZERO);
        scale * self.onto_screen(inner, window)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{ifs, point_attractor};

    #[test]
    fn a_fitted_shape_lies_within_the_margin_and_touches_it() {
        let hull = Hull::of(&ifs("gasket"));
        for (width, height) in [(400, 100), (100, 400), (1, 1)] {
            let view = View::fit(&hull, width, height, 0.1);
            let to_screen = view.to_screen(Window { width, height });
            let (low, high) = (to_screen.apply(hull.min()), to_screen.apply(hull.max()));
            let free = 0.1 * f64::from(width.min(height));
            let spare = [low.x - free, f64::from(height) - free - low.y, f64::from(width) - free - high.x];
            assert!(spare.iter().all(|s| *s > -1e-9), "{spare:?}");
            assert!(spare.iter().any(|s| *s < 1e-9), "{spare:?}");
        }
    }

    #[test]
    fn y_points_up_in_the_world_and_down_on_the_screen() {
        let view = View { x: 1.0, y: 2.0, scale: 10.0 };
        let to_screen = view.to_screen(Window { width: 200, height: 100 });
        assert_eq!(to_screen.apply(DVec2::new(1.0, 2.0)), DVec2::new(100.0, 50.0));
        assert_eq!(to_screen.apply(DVec2::new(2.0, 3.0)), DVec2::new(110.0, 40.0));
    }

    #[test]
    fn a_point_is_shown_at_a_scale_that_means_something() {
        let view = View::fit(&Hull::of(&point_attractor(DVec2::new(3e5, -2.0))), 300, 200, 0.05);
        assert!(view.is_valid() && view.scale < 1000.0, "{view:?}");
        assert!(View::fit(&Hull::of(&point_attractor(DVec2::ZERO)), 0, 0, 9.0).is_valid());
    }

    #[test]
    fn views_that_are_none_are_known() {
        for (x, scale) in [(f64::NAN, 1.0), (0.0, 0.0), (0.0, -1.0), (0.0, f64::INFINITY)] {
            assert!(!View { x, y: 0.0, scale }.is_valid());
        }
    }
}
