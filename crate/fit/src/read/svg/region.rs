//! Clip paths and masks: the parts of the plane that they leave.

use glam::DVec2;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::simplify::SimplifyShape;
use i_overlay::float::single::SingleFloatOverlay;
use kurbo::{Affine, PathEl, Rect};
use usvg::{ClipPath, Group, Mask, MaskType, Node, Paint};

use super::super::problem::LeftOut;
use super::paths::{FLATNESS, affine, around, elements};
use crate::outline::crossings;

/// Points of all shapes and regions that are cut by each other.
const MAX_CUT: usize = 1 << 20;
/// Crossings of two shapes that are cut by each other.
const MAX_CROSSINGS: usize = 20_000;

/// Closed lines round a part of the plane: the outer ones one way round, those of holes the other.
pub type Region = Vec<Vec<[f64; 2]>>;

/// Cuts shapes: it counts what it costs.
pub struct Cutter {
    /// How near lines are to the curves that they stand for.
    pub tolerance: f64,
    left: usize,
}

fn flat(shapes: Vec<Region>) -> Region {
    shapes.into_iter().flatten().collect()
}

/// A rectangle that lies at `place`.
pub fn frame(rect: Rect, place: Affine) -> Region {
    let corners = [(rect.x0, rect.y0), (rect.x1, rect.y0), (rect.x1, rect.y1), (rect.x0, rect.y1)];
    vec![corners.map(|corner| place * kurbo::Point::from(corner)).map(|p| [p.x, p.y]).to_vec()]
}

/// The box around a region.
pub fn bounds(region: &Region) -> Option<Rect> {
    let mut points = region.iter().flatten().map(|&[x, y]| kurbo::Point::new(x, y));
    let first = points.next()?;
    Some(points.fold(Rect::from_points(first, first), |bounds, p| bounds.union_pt(p)))
}

impl Cutter {
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, left: MAX_CUT }
    }

    /// What a path covers; `None` where it is too much to find out.
    pub fn covered(
        &mut self,
        path: &usvg::tiny_skia_path::Path,
        place: Affine,
        rule: FillRule,
    ) -> Option<Region> {
        // What a clip path lets through may be much smaller than it.
        let size = around(path, place)?.size().to_vec2().hypot();
        let mut lines = Region::new();
        let lifted = elements(path).map(|element| place * element);
        kurbo::flatten(lifted, self.tolerance.max(FLATNESS * size), |element| match element {
            PathEl::MoveTo(p) => lines.push(vec![[p.x, p.y]]),
            PathEl::LineTo(p) => {
                if let Some(line) = lines.last_mut() {
                    line.push([p.x, p.y]);
                }
            }
            _ => {}
        });
        lines.retain(|line| line.len() > 2);
        self.afford(&lines, &Vec::new())?;
        Some(flat(lines.simplify_shape(rule)))
    }

    pub fn cut(&mut self, a: &Region, b: &Region, rule: OverlayRule) -> Option<Region> {
        self.afford(a, b)?;
        Some(flat(a.overlay(b, rule, FillRule::NonZero)))
    }

    /// Whether lines have few enough points and crossings.
    fn afford(&mut self, a: &Region, b: &Region) -> Option<()> {
        let line: Vec<DVec2> = a.iter().chain(b).flatten().map(|&p| DVec2::from(p)).collect();
        let finite = line.iter().all(|p| p.abs().max_element() <= 1e9);
        self.left = self.left.checked_sub(line.len()).filter(|_| finite)?;
        (line.len() < 4 || crossings(&line, MAX_CROSSINGS).is_some_and(|found| found.len() < MAX_CROSSINGS))
            .then_some(())
    }

    /// What is left by a clip path of a group that lies at `place`; `None` where that is too much to find out.
    pub fn clip(&mut self, clip: &ClipPath, place: Affine) -> Option<Region> {
        let place = place * affine(clip.transform());
        let inside = self.union(clip.root(), place)?;
        match clip.clip_path() {
            Some(outer) => {
                let outer = self.clip(outer, place * affine(clip.transform()).inverse())?;
                self.cut(&inside, &outer, OverlayRule::Intersect)
            }
            None => Some(inside),
        }
    }

    /// All that the paths of a clip path cover.
    fn union(&mut self, group: &Group, place: Affine) -> Option<Region> {
        let mut all = Region::new();
        for node in group.children() {
            let region = match node {
                Node::Group(group) => {
                    let place = place * affine(group.transform());
                    let mut region = self.union(group, place)?;
                    if let Some(clip) = group.clip_path() {
                        let clip = self.clip(clip, place)?;
                        region = self.cut(&region, &clip, OverlayRule::Intersect)?;
                    }
                    region
                }
                Node::Path(path) if path.is_visible() => {
                    let rule = path.fill().map_or(FillRule::NonZero, |fill| rule(fill.rule()));
                    self.covered(path.data(), place, rule)?
                }
                _ => continue,
            };
            all = if all.is_empty() { region } else { self.cut(&all, &region, OverlayRule::Union)? };
        }
        Some(all)
    }

    /// What is left by a mask: where more than half of it is let through.
    pub fn mask(&mut self, mask: &Mask, place: Affine, left_out: &mut LeftOut) -> Option<Region> {
        let sides = mask.rect();
        let rect =
            Rect::new(sides.left().into(), sides.top().into(), sides.right().into(), sides.bottom().into());
        let frame = frame(rect, place);
        let mut all = Region::new();
        self.paint(mask.root(), place, (mask.kind(), 1.0), &mut all, left_out)?;
        let all = self.cut(&all, &frame, OverlayRule::Intersect)?;
        match mask.mask() {
            Some(outer) => {
                let outer = self.mask(outer, place, left_out)?;
                self.cut(&all, &outer, OverlayRule::Intersect)
            }
            None => Some(all),
        }
    }

    fn paint(
        &mut self,
        group: &Group,
        place: Affine,
        (kind, opacity): (MaskType, f32),
        all: &mut Region,
        left_out: &mut LeftOut,
    ) -> Option<()> {
        for node in group.children() {
            match node {
                Node::Group(group) => {
                    let opacity = opacity * group.opacity().get();
                    self.paint(group, place * affine(group.transform()), (kind, opacity), all, left_out)?;
                }
                Node::Path(path) if path.is_visible() => {
                    let Some(fill) = path.fill() else {
                        left_out.add("strokes of masks");
                        continue;
                    };
                    let light = match fill.paint() {
                        Paint::Color(color) => {
                            let [r, g, b] =
                                [color.red, color.green, color.blue].map(|part| f32::from(part) / 255.0);
                            0.2126 * r + 0.7152 * g + 0.0722 * b
                        }
                        _ => {
                            left_out.add("masks that fade");
                            1.0
                        }
                    };
                    let opacity = opacity * fill.opacity().get();
                    let light = if kind == MaskType::Alpha { 1.0 } else { light };
                    // What is dark and hides lights below it takes from the mask.
                    let operation = match (light * opacity > 0.5, opacity > 0.5) {
                        (true, _) => OverlayRule::Union,
                        (false, true) => OverlayRule::Difference,
                        (false, false) => continue,
                    };
                    let region = self.covered(path.data(), place, rule(fill.rule()))?;
                    *all = self.cut(all, &region, operation)?;
                }
                Node::Path(_) => {}
                _ => left_out.add("pictures and texts of masks"),
            }
        }
        Some(())
    }
}

/// Which way inside and outside are told apart.
pub fn rule(rule: usvg::FillRule) -> FillRule {
    match rule {
        usvg::FillRule::NonZero => FillRule::NonZero,
        usvg::FillRule::EvenOdd => FillRule::EvenOdd,
    }
}
