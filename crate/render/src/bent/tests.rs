use frond_core::{Colouring, Hull, Ifs};
use frond_deform::{Continuity, Mesh, Roughness, Settings, Spin, Tint};

use super::*;
use crate::coverage::sweep::Progress;
use crate::density::Density;
use crate::picture::bitmap::Bitmap;
use crate::picture::colour::Colours;
use crate::plan::{Detail, PlacedPoints};
use crate::raster::{RasterOptions, rasterize};
use crate::testing::{ifs, of_rows};

pub const WINDOW: Window = Window { width: 120, height: 96 };

fn shape(name: &str) -> Ifs {
    match name {
        "right gasket" => {
            of_rows(&[[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| [0.5, 0.0, 0.0, 0.5, e, f]))
        }
        "twindragon" => of_rows(&[[0.5, 0.5, -0.5, 0.5, -0.5, 0.375], [0.5, 0.5, -0.5, 0.5, 0.5, 0.625]]),
        other => ifs(other),
    }
}

/// Control points over the box of a shape, moved by a share of its size: all of them, each another way, or one alone.
pub fn mesh(ifs: &Ifs, share: f64, pulled: bool) -> Mesh {
    let hull = Hull::of(ifs);
    let size = hull.max() - hull.min();
    let all = |i: i32| DVec2::new(f64::from(i * 7 % 16) - 7.5, f64::from(i * 5 % 16) - 7.5) / 8.0;
    let one = |i: i32| if i == 3 { DVec2::new(1.0, -1.0) } else { DVec2::ZERO };
    let list = (0..16).map(|i| if pulled { one(i) } else { all(i) } * share * size).collect();
    Mesh::new(hull.min(), hull.max(), 4, 4, list).unwrap()
}

pub fn settings(kb: f64, ke: f64, delta: f64, spin: Spin) -> Settings {
    let roughness = Roughness::Constant(delta);
    Settings { kb, ke, roughness, spin, continuity: Continuity::Auto, superposed: true }
}

pub struct Subject {
    frame: Frame,
    pub bend: Bend,
    anchor_error: AnchorError,
    view: View,
}

impl Subject {
    pub fn new(name: &str, bend: impl FnOnce(&Ifs) -> Bend) -> Self {
        let ifs = shape(name);
        let hull = Hull::of(&ifs);
        let frame = Frame::within(&ifs, &hull);
        let bend = bend(&ifs);
        let anchor_error = AnchorError::of(&frame, &bend);
        Self { view: View::fit(&hull, WINDOW.width, WINDOW.height, 0.15), frame, bend, anchor_error }
    }

    pub fn plain(name: &str, share: f64, settings: Settings) -> Self {
        Self::new(name, |ifs| Bend::new(ifs.maps(), mesh(ifs, share, false), settings, None).unwrap())
    }

    pub fn bent(&self) -> Bent<'_> {
        Bent::new(&self.frame, &self.bend, &self.anchor_error, (self.view, WINDOW), (WINDOW, 1.0))
    }

    /// Where the bend takes a point of the attractor.
    fn seen(&self, point: DVec2) -> DVec2 {
        let inverse = self.frame.to_world.inverse().unwrap();
        let mut unit = inverse.apply(point);
        let mut cursor = self.bend.whole();
        for _ in 0..24 {
            // The piece that comes nearest with a point that its map takes there.
            let back = |map: &frond_core::Affine2| map.inverse().map_or(DVec2::INFINITY, |m| m.apply(unit));
            let backs: Vec<DVec2> = self.frame.maps.iter().map(back).collect();
            let near = |i: &usize| backs[*i].length();
            let letter = (0..backs.len()).min_by(|a, b| near(a).total_cmp(&near(b))).unwrap();
            cursor = self.bend.child(&cursor, letter);
            unit = backs[letter];
        }
        self.bend.point(&cursor, self.frame.to_world.apply(unit))
    }

    /// Where the bend takes a point of a small piece.
    fn deep(&self) -> DVec2 {
        let maps = self.frame.maps.len();
        let child = |cursor, i: usize| self.bend.child(&cursor, (i * 5 + 1) % maps);
        let cursor = (0..20).fold(self.bend.whole(), child);
        self.bend.point(&cursor, self.frame.to_world.apply(self.frame.anchor))
    }

    /// The lit pixels, swept.
    fn swept(&self) -> Bitmap {
        let mut sweep = BentSweep::new();
        let bent = self.bent();
        sweep.begin(&bent, 0.0625, false);
        assert_eq!(sweep.run(&bent, u64::MAX), Progress::Complete);
        lit(|i| sweep.codes().0[i] > 0)
    }

    /// The lit pixels by the bend alone, point by point.
    fn point_by_point(&self, apart: f64) -> Bitmap {
        let bent = self.bent();
        let mut seen = Bitmap::new(WINDOW);
        let mut open = vec![self.bend.whole()];
        while let Some(cursor) = open.pop() {
            let places = self.frame.tips.iter().chain([&self.frame.anchor]);
            let points: Vec<DVec2> = places
                .map(|p| bent.eye.at(self.bend.point(&cursor, self.frame.to_world.apply(*p))))
                .collect();
            let middle = points[points.len() - 1];
            let near = points.iter().all(|p| 2.0 * p.distance(middle) <= apart);
            if near && self.bend.even(&cursor) {
                for pixel in points.iter().filter_map(|p| WINDOW.pixel(*p)) {
                    seen.set(pixel);
                }
            } else {
                open.extend((0..self.frame.maps.len()).map(|i| self.bend.child(&cursor, i)));
            }
        }
        seen
    }
}

fn lit(is: impl Fn(usize) -> bool) -> Bitmap {
    let mut bitmap = Bitmap::new(WINDOW);
    for i in (0..WINDOW.area()).filter(|i| is(*i)) {
        bitmap.set((i as u32 % WINDOW.width, i as u32 / WINDOW.width));
    }
    bitmap
}

fn pixels() -> impl Iterator<Item = (u32, u32)> {
    (0..WINDOW.height).flat_map(|y| (0..WINDOW.width).map(move |x| (x, y)))
}

/// What the graphics card makes of a plan.
fn draw(plan: &crate::plan::Plan) -> Vec<u32> {
    let mut picture = vec![0_u32; WINDOW.area()];
    for batch in &plan.batches {
        let range = |range: &std::ops::Range<u32>| range.start as usize..range.end as usize;
        for instance in &plan.instances[range(&batch.instances)] {
            for vertex in &plan.vertices[range(&batch.vertices)] {
                if let Some((x, y)) = instance.place(vertex, &plan.sides, WINDOW) {
                    let pixel = &mut picture[(y * WINDOW.width + x) as usize];
                    *pixel = (*pixel).max(instance.code(vertex));
                }
            }
        }
    }
    picture
}

fn planned(subject: &Subject, detail: Detail) -> BentPlan {
    let bent = subject.bent();
    let mut plan = BentPlan::default();
    plan.begin(&bent, 600_000, false);
    assert_eq!(plan.run(&bent, &Fineness::complete(64.0), u64::MAX, None), Cut::Complete);
    plan.compose(&subject.frame, detail);
    plan
}

/// The shares of the lit pixels of `truth` that are missed, and of those that are lit too many.
fn disagreement(seen: &Bitmap, truth: &Bitmap) -> (f64, f64) {
    let count = |a: &Bitmap, b: &Bitmap| pixels().filter(|at| a.get(*at) && !b.get(*at)).count() as f64;
    let all = truth.count() as f64;
    (count(truth, seen) / all, count(seen, truth) / all)
}

/// Groups of pixels that hang together, at corners too or not.
fn groups(corners: bool, is: impl Fn((u32, u32)) -> bool) -> Vec<Vec<(u32, u32)>> {
    let mut known = Bitmap::new(WINDOW);
    let mut groups = Vec::new();
    for start in pixels().filter(|at| is(*at)) {
        if !known.set(start) {
            continue;
        }
        let mut group = vec![start];
        let mut next = 0;
        while let Some(&(x, y)) = group.get(next) {
            next += 1;
            for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
                let at = (x.wrapping_add_signed(dx), y.wrapping_add_signed(dy));
                let inside = at.0 < WINDOW.width && at.1 < WINDOW.height;
                if inside && (corners || dx == 0 || dy == 0) && is(at) && known.set(at) {
                    group.push(at);
                }
            }
        }
        groups.push(group);
    }
    groups
}

/// Dark pixels that no way leads to from the rim.
fn enclosed(lit: &Bitmap) -> usize {
    let rim = |&(x, y): &(u32, u32)| x == 0 || y == 0 || x + 1 == WINDOW.width || y + 1 == WINDOW.height;
    let dark = groups(true, |at| !lit.get(at));
    dark.iter().filter(|group| !group.iter().any(rim)).map(Vec::len).sum()
}

/// kb, ke, delta and spin.
const BENDS: [(f64, f64, f64, Spin); 6] = [
    (1.0, 5.0, 0.75, Spin::None),
    (0.0, 4.0, 0.5, Spin::None),
    (0.5, 3.5, 0.4, Spin::None),
    (0.0, 0.0, 0.5, Spin::None),
    (0.0, 4.0, 0.6, Spin::Scaled),
    (1.5, 4.0, 1.2, Spin::None),
];

#[test]
fn the_lit_pixels_are_those_of_the_bend_point_by_point() {
    // Each shape with other bends than the one before; `deep` tries all of them on all.
    let bends = frond_testing::cases(1) as usize;
    for (first, (name, apart)) in
        [("fern", 0.08), ("right gasket", 0.03), ("carpet", 0.15), ("square", 0.4), ("twindragon", 0.4)]
            .into_iter()
            .enumerate()
    {
        for (kb, ke, delta, spin) in BENDS.into_iter().cycle().skip(first).take(bends.min(BENDS.len())) {
            let subject = Subject::plain(name, 0.12, settings(kb, ke, delta, spin));
            let truth = subject.point_by_point(apart);
            let what = format!("{name} {kb} {ke} {delta} {spin:?}");
            assert!(truth.count() > 800, "{what}: {}", truth.count());
            let (missed, extra) = disagreement(&subject.swept(), &truth);
            assert!(missed < 0.005 && extra < 0.005, "swept {what}: {missed} missed, {extra} too many");
            // Thin shapes take more points for a pixel.
            let full = ["square", "twindragon"].contains(&name);
            let plan = planned(&subject, Detail::LADDER[if full { 3 } else { 5 }]);
            let codes = draw(&plan.plan);
            let (missed, extra) = disagreement(&lit(|i| codes[i] > 0), &truth);
            assert!(plan.plan.exact, "{what}");
            assert!(missed < 0.005 && extra < 0.005, "points {what}: {missed} missed, {extra} too many");
        }
    }
}

#[test]
fn there_are_no_cracks() {
    for (name, deepest) in [("square", 5.0), ("twindragon", 9.0)] {
        for ke in [2.0, 4.5, deepest] {
            for kb in [0.0, 0.4, 1.0, 2.0, ke] {
                let mut subject = Subject::new(name, |ifs| {
                    let settings = settings(kb, ke, 0.6, Spin::None);
                    Bend::new(ifs.maps(), mesh(ifs, 0.25, true), settings, None).unwrap()
                });
                // A twindragon has bays that a pixel may close; a square has none.
                if name == "square" {
                    assert_eq!(enclosed(&subject.swept()), 0, "{name} {kb} {ke}");
                    let codes = draw(&planned(&subject, Detail::LADDER[0]).plan);
                    assert_eq!(enclosed(&lit(|i| codes[i] > 0)), 0, "points of {name} {kb} {ke}");
                }
                // Well inside every pixel is lit.
                (subject.view.x, subject.view.y) = subject.seen(DVec2::splat(0.5)).into();
                for zoom in [16.0, 64.0] {
                    let far = subject.view;
                    subject.view.scale *= zoom;
                    assert_eq!(subject.swept().count(), WINDOW.area(), "{name} {kb} {ke} x{zoom}");
                    let codes = draw(&planned(&subject, Detail::LADDER[2]).plan);
                    let dark = codes.iter().filter(|code| **code == 0).count();
                    assert_eq!(dark, 0, "points of {name} {kb} {ke} x{zoom}");
                    subject.view = far;
                }
            }
        }
    }
}

#[test]
fn the_gasket_stays_in_one_piece() {
    for (kb, ke, delta) in [(0.0, 7.0, 0.5), (1.0, 7.0, 0.75), (2.5, 6.5, 0.6), (3.0, 7.0, 1.1)] {
        let subject = Subject::plain("right gasket", 0.12, settings(kb, ke, delta, Spin::None));
        let swept = subject.swept();
        assert_eq!(groups(true, |at| swept.get(at)).len(), 1, "{kb} {ke} {delta}");
    }
}

#[test]
fn without_displacements_it_is_the_attractor_itself() {
    for name in ["right gasket", "fern", "twindragon"] {
        let subject = Subject::plain(name, 0.0, settings(0.0, 5.0, 0.7, Spin::Rotation));
        let bent = subject.bent();
        let rest = subject.view.onto_screen(subject.frame.to_world, WINDOW);
        let (codes, _) = crate::coverage::complete::swept_codes(&subject.frame, rest, WINDOW, 0.0625);
        let codes: Vec<u32> = codes.into_iter().map(crate::pieces::letters::Code::code).collect();
        let mut sweep = BentSweep::new();
        sweep.begin(&bent, 0.0625, false);
        sweep.run(&bent, u64::MAX);
        let same = codes.iter().zip(sweep.codes().0).filter(|(a, b)| a == b).count();
        assert!(same * 500 > codes.len() * 499, "{name}: {same} of {}", codes.len());
    }
}

#[test]
fn with_what_a_sweep_finds_in_the_dark_a_coarse_plan_is_complete() {
    for name in ["right gasket", "fern", "twindragon"] {
        let subject = Subject::plain(name, 0.1, settings(1.0, 5.0, 0.6, Spin::None));
        let mut placed = PlacedPoints::new(WINDOW);
        assert!(placed.go_on(&planned(&subject, Detail::LADDER[0]).plan, u64::MAX));
        let (bent, mut rest) = (subject.bent(), BentSweep::new());
        rest.begin_on(&bent, 0.0625, false, placed.lit());
        let mut seen = placed.lit().clone();
        let progress = rest.find(&bent, u64::MAX, &mut |pixel, code| assert!(code > 0 && seen.set(pixel)));
        assert_eq!(progress, Progress::Complete, "{name}");
        let whole = subject.swept();
        let missed = pixels().filter(|at| whole.get(*at) && !seen.get(*at)).count();
        let extra = pixels().filter(|at| !whole.get(*at) && seen.get(*at)).count();
        assert_eq!(missed, 0, "{name} of {}", whole.count());
        assert!(extra * 50 < whole.count(), "{name}: {extra} of {} too many", whole.count());
        assert!(placed.lit().count() < seen.count(), "{name}: this tests nothing");
    }
}

#[test]
fn pieces_follow_the_mesh() {
    for (name, zoom) in [("right gasket", 1.0), ("fern", 1.0), ("square", 1.0), ("right gasket", 1e6)] {
        let settings = settings(1.0, 5.0, 0.6, Spin::Scaled);
        let mut subject = Subject::plain(name, 0.1, settings);
        subject.view.scale *= zoom;
        if zoom > 1.0 {
            (subject.view.x, subject.view.y) = subject.deep().into();
        }
        let bent = subject.bent();
        assert_eq!(Moving::can_skin(&bent), zoom == 1.0, "{name} {zoom}");
        let fineness = Fineness { margin: Some(30.0), ..Fineness::complete(32.0) };
        let (mut plan, mut moving) = (BentPlan::default(), Moving::default());
        plan.begin(&bent, 100_000, false);
        assert_eq!(plan.run(&bent, &fineness, u64::MAX, Some(&mut moving)), Cut::Complete);
        let pieces = moving.len();
        // Far enough to see, near enough for the margin.
        let step = 20.0 / subject.view.scale;
        let moved: Vec<DVec2> = (0..16)
            .map(|i| subject.bend.mesh().displacements()[i] + DVec2::from_angle(i as f64) * step)
            .collect();
        let skinned = Moving::can_skin(&bent);
        let mut after = subject;
        if !skinned {
            after.bend.set_mesh(&moved).unwrap();
        }
        plan.follow(&after.bent(), &moved, &mut moving);
        plan.compose(&after.frame, Detail::LADDER[4]);
        assert_eq!(plan.plan.instances.len(), pieces);
        after.bend.set_mesh(&moved).unwrap();
        after.anchor_error = AnchorError::of(&after.frame, &after.bend);
        let codes = draw(&plan.plan);
        let truth = after.swept();
        assert!(truth.count() > 200, "{name} {zoom}: {}", truth.count());
        let (missed, extra) = disagreement(&lit(|i| codes[i] > 0), &truth);
        assert!(missed < 0.02 && extra < 0.02, "{name} {zoom}: {missed} {extra}");
    }
}

#[test]
fn close_views_are_as_complete_as_far_ones() {
    for name in ["right gasket", "fern", "twindragon"] {
        let mut subject = Subject::plain(name, 0.1, settings(1.0, 6.0, 0.6, Spin::None));
        let at = subject.deep();
        subject.view = View { x: at.x, y: at.y, scale: subject.view.scale * 1e6 };
        let plan = planned(&subject, Detail::LADDER[3]);
        assert!(plan.plan.instances.len() < 20_000, "{name}: {}", plan.plan.instances.len());
        let truth = subject.swept();
        assert!(truth.count() > 200, "{name}: {}", truth.count());
        assert!(truth.get((WINDOW.width / 2, WINDOW.height / 2)), "{name}: the point itself");
        let codes = draw(&plan.plan);
        let (missed, extra) = disagreement(&lit(|i| codes[i] > 0), &truth);
        assert!(missed < 0.02 && extra < 0.01, "{name}: {missed} {extra}");
    }
}

#[test]
fn pieces_are_cut_within_bounds() {
    for name in crate::testing::NASTY {
        let subject = Subject::plain(name, 0.1, settings(0.0, 8.0, 0.9, Spin::Orthogonal));
        let bent = subject.bent();
        let mut plan = BentPlan::default();
        plan.begin(&bent, 2000, false);
        plan.run(&bent, &Fineness::complete(16.0), u64::MAX, None);
        plan.compose(&subject.frame, Detail::LADDER[0]);
        assert!(plan.plan.instances.len() <= 2000, "{name}: {}", plan.plan.instances.len());
        let mut sweep = BentSweep::new();
        sweep.begin(&bent, 0.5, false);
        sweep.run(&bent, 200_000);
        assert!(sweep.visited() <= 200_000, "{name}");
    }
}

#[test]
fn rough_plans_have_no_piece_below_the_floor_taken_apart() {
    let subject = Subject::plain("right gasket", 0.1, settings(0.0, 9.0, 0.8, Spin::None));
    let bent = subject.bent();
    let count = |floor: f64| {
        let mut plan = BentPlan::default();
        plan.begin(&bent, 600_000, false);
        let cut = plan.run(&bent, &Fineness { floor, ..Fineness::complete(32.0) }, u64::MAX, None);
        plan.compose(&subject.frame, Detail::LADDER[0]);
        (cut, plan.plan.instances.len(), plan.plan.exact)
    };
    let (all, some, few) = (count(0.0), count(4.0), count(16.0));
    assert_eq!((all.0, all.2), (Cut::Complete, true));
    assert_eq!((some.0, some.2), (Cut::Rough, false));
    assert!(all.1 > 2 * some.1 && some.1 > 2 * few.1, "{all:?} {some:?} {few:?}");
}

#[test]
fn colours_are_carried() {
    let colours: Vec<[f64; 3]> =
        (0..16).map(|i| if i % 4 < 2 { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] }).collect();
    let tint = Tint { colours, kb: 0.0, ke: 0.0, roughness: 0.0, superposed: true };
    let ifs = shape("square");
    let bend =
        Bend::new(ifs.maps(), mesh(&ifs, 0.05, false), settings(0.0, 3.0, 0.5, Spin::None), Some(tint))
            .unwrap();
    let options = RasterOptions {
        width: WINDOW.width,
        height: WINDOW.height,
        colouring: Colouring::Grid,
        bend: Some(&bend),
        ..RasterOptions::default()
    };
    let picture = rasterize(&ifs, &options).unwrap();
    let at = |x: u32| &picture[4 * (WINDOW.width * (WINDOW.height / 2) + x) as usize..][..4];
    assert!(at(25)[0] > 200 && at(25)[2] < 60 && at(25)[3] == 255, "{:?}", at(25));
    assert!(at(95)[2] > 200 && at(95)[0] < 60 && at(95)[3] == 255, "{:?}", at(95));
    // Without colours of its own, each map has one.
    let plain =
        Bend::new(ifs.maps(), mesh(&ifs, 0.05, false), settings(0.0, 3.0, 0.5, Spin::None), None).unwrap();
    let by_map =
        |colouring| rasterize(&ifs, &RasterOptions { colouring, bend: Some(&plain), ..options }).unwrap();
    assert_eq!(by_map(Colouring::Grid), by_map(Colouring::Map));
    // And the card's pieces have them as well.
    let hull = Hull::of(&ifs);
    let frame = Frame::within(&ifs, &hull);
    let anchor_error = AnchorError::of(&frame, &bend);
    let view = View::fit(&hull, WINDOW.width, WINDOW.height, 0.05);
    let bent = Bent::new(&frame, &bend, &anchor_error, (view, WINDOW), (WINDOW, 1.0));
    let mut plan = BentPlan::default();
    plan.begin(&bent, 600_000, true);
    plan.run(&bent, &Fineness::complete(3.0), u64::MAX, None);
    plan.compose(&frame, Detail::LADDER[0]);
    let colours = Colours { tinted: 1.0, ..Colours::new(Colouring::Grid, &[], 4) };
    let tints: Vec<[f32; 3]> = plan.plan.instances.iter().map(|i| colours.colour(i.tint + 1)).collect();
    assert!(plan.plan.tinted && tints.iter().any(|c| c[0] > 0.95) && tints.iter().any(|c| c[2] > 0.95));
}

#[test]
fn densities_are_those_of_the_measure() {
    let subject = Subject::plain("square", 0.04, settings(0.0, 3.0, 0.5, Spin::None));
    let bent = subject.bent();
    let mut density = Density::bent(&bent, 16.0, 60_000, 100_000);
    let total: f64 = density.pieces.iter().map(|piece| piece.mass).sum();
    assert!((total - 1.0).abs() < 1e-9 && density.pieces.iter().all(|piece| piece.mass < 0.004), "{total}");
    let colours = Colours::new(Colouring::Density, &[], 4);
    let mut sums = vec![[0.0; 4]; WINDOW.area()];
    for _ in 0..4 {
        density.accumulate(&subject.frame, &colours, WINDOW, &mut Vec::new(), &mut sums);
    }
    let truth = subject.swept();
    let outside =
        pixels().filter(|&(x, y)| sums[(y * WINDOW.width + x) as usize][3] > 0.0 && !truth.get((x, y)));
    assert!(outside.count() * 200 < truth.count());
    let mean = sums.iter().map(|sum| sum[3]).sum::<f32>() / (4.0 * truth.count() as f32);
    assert!((0.8..1.25).contains(&mean), "{mean}");
}

#[test]
fn windows_of_no_size_and_views_of_nothing_are_dark() {
    let mut subject = Subject::plain("right gasket", 0.1, settings(0.0, 5.0, 0.6, Spin::None));
    subject.view.x = 1e9;
    assert!(planned(&subject, Detail::LADDER[0]).plan.instances.is_empty());
    assert_eq!(subject.swept().count(), 0);
    let none = Window { width: 0, height: 0 };
    let bent =
        Bent::new(&subject.frame, &subject.bend, &subject.anchor_error, (subject.view, none), (none, 1.0));
    let mut sweep = BentSweep::new();
    sweep.begin(&bent, 0.1, false);
    assert_eq!(sweep.run(&bent, 1000), Progress::Complete);
    assert!(Density::bent(&bent, 16.0, 100, 100).pieces.is_empty());
}
