//! Which pixels the points of a plan light.

use super::Plan;
use crate::picture::bitmap::Bitmap;
use crate::picture::window::Window;

/// The points of a [`Plan`] placed as the graphics card places them, bit by bit: what stays dark is left to a sweep.
///
/// A point so close to the border of its pixel that a card may round it into the next one lights none for certain.
#[derive(Debug)]
pub struct PlacedPoints {
    lit: Bitmap,
    /// What is placed next: a batch, and an instance within it.
    next: (usize, u32),
}

/// How far within a pixel, in pixels, a point must be to be there for certain. In single precision, places of a target
/// of [`MAX_SIDE`](crate::MAX_SIDE) x 2 pixels are apart by a thousandth.
const CERTAIN: f32 = 1.0 / 256.0;

impl PlacedPoints {
    /// Nothing yet.
    #[must_use]
    pub fn new(window: Window) -> Self {
        Self { lit: Bitmap::new(window), next: (0, 0) }
    }

    /// Begins with a picture in the same memory.
    pub fn begin(&mut self, window: Window) {
        self.lit.reset(window);
        self.next = (0, 0);
    }

    /// Places about `budget` more points. Returns whether all are placed.
    pub fn go_on(&mut self, plan: &Plan, mut budget: u64) -> bool {
        while let Some(batch) = plan.batches.get(self.next.0) {
            let vertices = batch.vertices.start as usize..batch.vertices.end as usize;
            let first = batch.instances.start + self.next.1;
            for instance in &plan.instances[first as usize..batch.instances.end as usize] {
                if budget == 0 {
                    return false;
                }
                for vertex in &plan.vertices[vertices.clone()] {
                    let [x, y] = instance.at(vertex, &plan.sides);
                    let (column, row) = (x.floor(), y.floor());
                    let within = |part: f32| (CERTAIN..=1.0 - CERTAIN).contains(&part);
                    // A cast of what is below 0 gives 0.
                    if column >= 0.0 && row >= 0.0 && within(x - column) && within(y - row) {
                        self.lit.set((column as u32, row as u32));
                    }
                }
                self.next.1 += 1;
                budget = budget.saturating_sub(vertices.len() as u64);
            }
            self.next = (self.next.0 + 1, 0);
        }
        true
    }

    /// The pixels that are lit for certain.
    #[must_use]
    pub fn lit(&self) -> &Bitmap {
        &self.lit
    }
}

#[cfg(test)]
mod tests {
    use frond_core::Hull;

    use super::*;
    use crate::coverage::sweep::{Progress, Sweep};
    use crate::picture::view::View;
    use crate::pieces::frame::Frame;
    use crate::plan::Detail;
    use crate::testing::{PLAIN, ifs};

    const WINDOW: Window = Window { width: 240, height: 180 };

    /// The pixels that a plan lights wherever its points are rounded to, once placed in portions.
    fn placed(plan: &Plan, portion: u64) -> Bitmap {
        let mut placed = PlacedPoints::new(WINDOW);
        while !placed.go_on(plan, portion) {}
        placed.lit
    }

    #[test]
    fn with_what_a_sweep_finds_in_the_dark_a_coarse_plan_is_complete() {
        for name in PLAIN {
            for zoom in [1.0, 300.0] {
                let ifs = ifs(name);
                let hull = Hull::of(&ifs);
                let frame = Frame::within(&ifs, &hull);
                let at = frame.to_world.apply(frame.anchor);
                let fit = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
                let view = if zoom > 1.0 { View { x: at.x, y: at.y, scale: fit.scale * zoom } } else { fit };
                let to_screen = view.onto_screen(frame.to_world, WINDOW);
                let mut plan = Plan::default();
                plan.make(&frame, to_screen, WINDOW, Detail::LADDER[0]);

                let mut whole = Sweep::new(&frame, to_screen, WINDOW, 0.125);
                assert_eq!(whole.run(u64::MAX, |_| ()), Progress::Complete, "{name} x{zoom}");
                let lit = placed(&plan, u64::MAX);
                let mut rest = Sweep::new(&frame, to_screen, WINDOW, 0.125);
                rest.restart_on(&frame, to_screen, &lit, 0.125);
                let mut found = 0;
                assert_eq!(rest.run(u64::MAX, |_| found += 1), Progress::Complete, "{name} x{zoom}");
                assert_eq!(rest.lit().count(), lit.count() + found, "{name} x{zoom}: each is found once");
                assert!(rest.visited() <= whole.visited(), "{name} x{zoom}");
                let pixels = || (0..WINDOW.height).flat_map(|y| (0..WINDOW.width).map(move |x| (x, y)));
                let missed = pixels().filter(|at| whole.lit().get(*at) && !rest.lit().get(*at)).count();
                let extra = pixels().filter(|at| !whole.lit().get(*at) && rest.lit().get(*at)).count();
                assert_eq!(missed, 0, "{name} x{zoom} of {}", whole.lit().count());
                assert!(extra * 200 <= whole.lit().count(), "{name} x{zoom}: {extra} too many");
            }
        }
    }

    #[test]
    fn portions_do_not_matter() {
        let ifs = ifs("fern");
        let hull = Hull::of(&ifs);
        let frame = Frame::within(&ifs, &hull);
        let view = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
        let mut plan = Plan::default();
        plan.make(&frame, view.onto_screen(frame.to_world, WINDOW), WINDOW, Detail::LADDER[0]);
        let pixels = |bitmap: &Bitmap| -> Vec<bool> {
            (0..WINDOW.height).flat_map(|y| (0..WINDOW.width).map(move |x| bitmap.get((x, y)))).collect()
        };
        let whole = pixels(&placed(&plan, u64::MAX));
        assert!(whole.iter().filter(|lit| **lit).count() > 1000);
        assert_eq!(pixels(&placed(&plan, 1)), whole);
        assert_eq!(pixels(&placed(&plan, 5000)), whole);
    }

    #[test]
    fn a_point_on_the_border_of_two_pixels_lights_neither_for_certain() {
        use crate::pieces::letters::Letters;
        use crate::plan::Batch;
        use crate::points::{Instance, Vertex};
        let at = |x: f32, y: f32| {
            let plan = Plan {
                vertices: vec![Vertex::new([x, y], Letters::NONE, 0.0)],
                instances: vec![Instance::new(&frond_core::Affine2::IDENTITY, Letters::NONE, 1.0)],
                batches: vec![Batch { vertices: 0..1, instances: 0..1 }],
                ..Plan::default()
            };
            placed(&plan, 1).count()
        };
        assert_eq!(at(3.5, 4.5), 1);
        for (x, y) in [(3.0, 4.5), (3.5, 4.0), (2.999, 4.5), (-0.5, 4.5), (240.5, 4.5), (f32::NAN, 1.5)] {
            assert_eq!(at(x, y), 0, "{x} {y}");
        }
    }
}
