//! What the graphics card draws: each shader against its twin, and complete pictures against the ones that
//! are swept on the processor, on both backends.

use std::cell::RefCell;
use std::rc::Rc;

use frond_core::{Affine2, Colouring, Hull, Ifs};
use frond_deform::{Bend, Continuity, Mesh, Roughness, Settings, Spin, Tint};
use frond_render::gpu::{Canvas, Drawn, Event, Stage, Style, Wanted};
use frond_render::{
    Code, Colours, Density, Detail, Frame, Plan, RasterOptions, SplatPlan, Splats, View, Window, rasterize,
    resolve_codes, resolve_density, to_bytes,
};
use wasm_bindgen_test::wasm_bindgen_test;

#[cfg(target_arch = "wasm32")]
use crate::card::shown_on;
use crate::card::{BACKENDS, canvas, card_on, picture_of};

const WINDOW: Window = Window { width: 150, height: 100 };
/// More points than any of the pictures has.
pub const PLENTY: u64 = 100_000_000;

pub type Events = Rc<RefCell<Vec<Event>>>;

/// A stage of the backend, and what happens to it.
pub async fn stage(wanted: Wanted, software: bool) -> (Stage, Events) {
    stage_on(&canvas([WINDOW.width, WINDOW.height]), wanted, software).await
}

/// The same, on a canvas.
async fn stage_on(canvas: &Canvas, wanted: Wanted, software: bool) -> (Stage, Events) {
    let events = Events::default();
    let heard = Rc::clone(&events);
    let mut gpu = card_on(canvas, wanted, move |event| heard.borrow_mut().push(event.clone())).await;
    // The processor stands in for a graphics card here, and would be spared drawing points.
    gpu.software = software;
    (Stage::new(gpu), events)
}

fn similitude(scale: f64, degrees: f64, e: f64, f: f64) -> Affine2 {
    Affine2::similitude(scale, degrees.to_radians(), glam::DVec2::new(e, f))
}

pub fn shape(name: &str) -> Ifs {
    let s = 0.5_f64.sqrt();
    Ifs::new(match name {
        "gasket" => [[0.0, 0.0], [0.5, 0.0], [0.25, 0.433]].map(|[e, f]| similitude(0.5, 0.0, e, f)).to_vec(),
        "dragon" => vec![similitude(s, 45.0, 0.0, 0.0), similitude(s, 135.0, 1.0, 0.0)],
        "fern" => [
            [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
            [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
            [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
            [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        ]
        .map(Affine2::from_row)
        .to_vec(),
        "overlap" => vec![similitude(0.9, 0.0, 0.0, 0.0), similitude(0.9, 40.0, 0.1, 0.0)],
        _ => panic!("no shape is called {name}"),
    })
    .unwrap()
}

struct Subject {
    ifs: Ifs,
    frame: Frame,
    view: View,
}

fn subject(name: &str) -> Subject {
    let ifs = shape(name);
    let hull = Hull::of(&ifs);
    let frame = Frame::within(&ifs, &hull);
    Subject { view: View::fit(&hull, WINDOW.width, WINDOW.height, 0.05), frame, ifs }
}

fn style(colouring: Colouring) -> Style {
    Style { colouring, ..Style::default() }
}

/// Puts a subject on a stage and makes the first picture.
fn show(stage: &mut Stage, subject: &Subject, colouring: Colouring, pixel_ratio: f64, budget: u64) -> u64 {
    stage.resize(WINDOW.width, WINDOW.height, pixel_ratio);
    stage.set_ifs(&subject.ifs);
    assert!(stage.set_view(subject.view));
    stage.set_style(style(colouring));
    stage.draw(budget).points
}

fn settle(stage: &mut Stage) -> Drawn {
    settle_by(stage, PLENTY)
}

/// Draws on, so many points a frame, until nothing changes any more.
fn settle_by(stage: &mut Stage, budget: u64) -> Drawn {
    for _ in 0..1000 {
        let drawn = stage.draw(budget);
        if drawn.settled {
            return drawn;
        }
    }
    panic!("it does not come to an end");
}

/// The whole picture by a function of its pixels.
fn picture(pixel: impl Fn([i32; 2]) -> [f32; 4]) -> Vec<u8> {
    let rows = 0..WINDOW.height as i32;
    rows.flat_map(|y| (0..WINDOW.width as i32).map(move |x| [x, y]))
        .flat_map(|at| to_bytes(pixel(at)))
        .collect()
}

/// Fails unless all but a few pixels are the same to `tolerance`, and the picture shows something.
fn assert_same(what: &str, seen: &[u8], expected: &[u8], tolerance: u8) {
    assert_eq!(seen.len(), expected.len(), "{what}");
    let pixels = || seen.chunks_exact(4).zip(expected.chunks_exact(4));
    let lit = pixels().filter(|(_, b)| b[3] > 0).count();
    let dark = pixels().filter(|(a, _)| a[3] == 0).count();
    assert!(lit > 500 && dark > 500, "{what}: {lit} lit, {dark} dark: this tests nothing");
    let differs = |a: &[u8], b: &[u8]| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > tolerance);
    let wrong = pixels().filter(|(a, b)| differs(a, b)).count();
    // Rounding may carry a point on an edge over it.
    assert!(wrong * 200 <= lit, "{what}: {wrong} of {lit} pixels differ");
}

pub fn assert_no_fault(events: &Events) {
    assert_eq!(*events.borrow(), [], "nothing may go wrong");
}

/// What the shaders should make of a plan, by their twins.
fn by_twins(subject: &Subject, colouring: Colouring, factor: f64, plan: &Plan) -> Vec<u8> {
    let target = target(factor);
    let mut codes = vec![0_u32; target.area()];
    for batch in &plan.batches {
        let range = |range: &std::ops::Range<u32>| range.start as usize..range.end as usize;
        for instance in &plan.instances[range(&batch.instances)] {
            for vertex in &plan.vertices[range(&batch.vertices)] {
                if let Some((x, y)) = instance.place(vertex, &plan.sides, target) {
                    let pixel = &mut codes[(y * target.width + x) as usize];
                    *pixel = (*pixel).max(instance.code(vertex));
                }
            }
        }
    }
    let mut colours = Colours::new(colouring, &[], subject.ifs.len());
    colours.source = [target.width as i32, target.height as i32];
    colours.factor = factor as f32;
    picture(|at| resolve_codes(&colours, &codes, at))
}

/// The first picture of a subject, how many points it has, and the picture of the processor.
fn at_once(subject: &Subject, colouring: Colouring, factor: f64) -> (u64, Vec<u8>) {
    if cfg!(not(feature = "webgpu")) {
        let plan = plan(subject, factor);
        return (plan.points(), by_twins(subject, colouring, factor, &plan));
    }
    let target = target(factor);
    let to_target = subject.view.onto_target(subject.frame.to_world, WINDOW, factor);
    let splats = Splats::draw(&subject.frame, to_target, target, 0);
    let mut colours = Colours::new(colouring, &[], subject.ifs.len());
    colours.source = [target.width as i32, target.height as i32];
    colours.factor = factor as f32;
    let mut plan = SplatPlan::default();
    assert!(plan.make(&subject.frame, to_target, target, target.width));
    let codes: Vec<u32> = splats.codes.into_iter().map(Code::code).collect();
    (plan.count, picture(|at| resolve_codes(&colours, &codes, at)))
}

fn target(factor: f64) -> Window {
    let side = |pixels: u32| (f64::from(pixels) * factor).ceil() as u32;
    Window { width: side(WINDOW.width), height: side(WINDOW.height) }
}

fn plan(subject: &Subject, factor: f64) -> Plan {
    let target = target(factor);
    let mut plan = Plan::default();
    let to_target = subject.view.onto_target(subject.frame.to_world, WINDOW, factor);
    plan.make(&subject.frame, to_target, target, Detail::LADDER[0]);
    plan
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn points_and_their_colours_are_those_of_the_twins() {
    for &wanted in BACKENDS {
        let (mut stage, events) = stage(wanted, false).await;
        for name in ["gasket", "dragon", "fern"] {
            let subject = subject(name);
            for colouring in [Colouring::Map, Colouring::Address] {
                for (pixel_ratio, factor) in [(1.0, 2.0), (2.0, 1.0)] {
                    let what = format!("{name} {wanted:?} {colouring:?} {factor}");
                    let points = show(&mut stage, &subject, colouring, pixel_ratio, PLENTY);
                    let (planned, expected) = at_once(&subject, colouring, factor);
                    assert_eq!(points, planned, "{what}");
                    assert_same(&what, &picture_of(stage.read()).await, &expected, 1);
                }
            }
        }
        assert_no_fault(&events);
    }
}

#[cfg(target_arch = "wasm32")]
#[wasm_bindgen_test]
async fn the_canvas_shows_what_is_read() {
    for &wanted in BACKENDS {
        let canvas = canvas([WINDOW.width, WINDOW.height]);
        let (mut stage, events) = stage_on(&canvas, wanted, false).await;
        // It is another picture upside down.
        show(&mut stage, &subject("fern"), Colouring::Map, 2.0, PLENTY);
        let shown = shown_on(&canvas);
        assert_same(&format!("{wanted:?}"), &shown, &picture_of(stage.read()).await, 1);
        assert_no_fault(&events);
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn a_small_budget_gives_a_whole_picture_of_fewer_pixels() {
    for &wanted in BACKENDS {
        let (mut stage, events) = stage(wanted, false).await;
        let subject = subject("dragon");
        let points = show(&mut stage, &subject, Colouring::Map, 2.0, 20_000);
        assert!(points <= 20_000, "{points}");
        let pictures = [1.0, 0.5, 0.25, 0.125].map(|factor| at_once(&subject, Colouring::Map, factor));
        let (_, expected) = pictures.into_iter().find(|(planned, _)| *planned == points).unwrap();
        assert_same(&format!("{wanted:?}"), &picture_of(stage.read()).await, &expected, 2);
        assert!(!stage.draw(20_000).complete);
        assert_no_fault(&events);
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn densities_are_those_of_the_twins() {
    for &wanted in BACKENDS {
        for software in [false, true] {
            let (mut stage, events) = stage(wanted, software).await;
            let subject = subject("fern");
            let budget = 100_000;
            show(&mut stage, &subject, Colouring::Density, 1.0, budget);
            let drawn = settle(&mut stage);
            assert!(drawn.complete);
            let seen = picture_of(stage.read()).await;
            // The same pieces and samples, as often.
            let samples = (budget as usize / (2 * 384)).clamp(32, 2048);
            let mut density = Density::new(&subject.frame, subject.view, WINDOW, 384, samples);
            let mut colours = Colours::new(Colouring::Density, &[], subject.ifs.len());
            let mut sums = vec![[0.0; 4]; WINDOW.area()];
            let (mut points, mut passes, mut scratch) = (0, 0.0, Vec::new());
            while points < drawn.points {
                points +=
                    density.accumulate(&subject.frame, &colours, WINDOW, &mut scratch, &mut sums) as u64;
                passes += 1.0;
            }
            assert_eq!(points, drawn.points);
            colours.source = [WINDOW.width as i32, WINDOW.height as i32];
            colours.gain = density.tone_gain() / passes;
            colours.slope = density.tone.slope;
            let expected = picture(|at| resolve_density(&colours, &sums, at));
            // Half floats keep eleven bits, and lose a little with each sum.
            assert_same(&format!("{wanted:?} software {software}"), &seen, &expected, 6);
            assert_no_fault(&events);
        }
    }
}

/// Shares of lit pixels that one picture has and the other has not. One pixel is allowed for: of a view with few, such
/// as the thread at the end of a frond, it is a share that says nothing, and single precision may put a point that lies
/// on the border of two pixels into the other one.
fn disagreement(seen: &[u8], truth: &[u8]) -> (f64, f64) {
    let pixels = || seen.chunks_exact(4).zip(truth.chunks_exact(4));
    let lit = pixels().filter(|(_, b)| b[3] > 0).count();
    let missed = pixels().filter(|(a, b)| a[3] == 0 && b[3] > 0).count();
    let extra = pixels().filter(|(a, b)| a[3] > 0 && b[3] == 0).count();
    let share = |count: usize| count.saturating_sub(1) as f64 / lit as f64;
    (share(missed), share(extra))
}

/// Pixels that one picture leaves dark and the other does not.
fn pixels_missed(seen: &[u8], truth: &[u8]) -> usize {
    seen.chunks_exact(4).zip(truth.chunks_exact(4)).filter(|(a, b)| a[3] == 0 && b[3] > 0).count()
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn at_rest_the_picture_is_complete() {
    for &wanted in BACKENDS {
        let (mut stage, events) = stage(wanted, false).await;
        for name in ["gasket", "dragon", "fern"] {
            // With a small budget there are few points, and more is left to be filled.
            for (zoom, budget) in [(1.0, PLENTY), (1.0, 50_000), (1e6, PLENTY)] {
                let mut subject = subject(name);
                if zoom > 1.0 {
                    // Close to a point of the shape.
                    let anchor = subject.frame.to_world.apply(subject.frame.anchor);
                    subject.view = View { x: anchor.x, y: anchor.y, scale: subject.view.scale * zoom };
                }
                show(&mut stage, &subject, Colouring::Map, 1.0, PLENTY);
                let drawn = settle_by(&mut stage, budget);
                assert!(drawn.complete && drawn.points > 1000, "{name} {wanted:?} {drawn:?}");
                let options = RasterOptions {
                    width: WINDOW.width,
                    height: WINDOW.height,
                    view: Some(subject.view),
                    ..RasterOptions::default()
                };
                let truth = rasterize(&subject.ifs, &options).unwrap();
                let seen = picture_of(stage.read()).await;
                let (_, extra) = disagreement(&seen, &truth);
                let missed = pixels_missed(&seen, &truth);
                assert!(
                    missed == 0 && extra < 0.005,
                    "{name} {wanted:?} x{zoom} by {budget}: {missed} {extra}"
                );
            }
        }
        assert_no_fault(&events);
    }
}

/// A bend whose control points are moved by so much of the shape's size, each another way, with colours or none.
fn bend(subject: &Subject, share: f64, ke: f64, tinted: bool) -> Bend {
    let hull = Hull::of(&subject.ifs);
    let size = hull.max() - hull.min();
    let list = moves(share, size);
    let mesh = Mesh::new(hull.min(), hull.max(), 4, 4, list).unwrap();
    let settings = Settings {
        kb: 1.0,
        ke,
        roughness: Roughness::Constant(0.6),
        spin: Spin::None,
        continuity: Continuity::Auto,
        superposed: true,
    };
    let colours = (0..16).map(|i| [f64::from(i % 4) / 3.0, f64::from(i / 4) / 3.0, 0.5]).collect();
    let tint = Tint { colours, kb: 0.0, ke: 2.0, roughness: 0.5, superposed: true };
    Bend::new(subject.ifs.maps(), mesh, settings, tinted.then_some(tint)).unwrap()
}

fn moves(share: f64, size: glam::DVec2) -> Vec<glam::DVec2> {
    let way = |i: i32| glam::DVec2::new(f64::from(i * 7 % 16) - 7.5, f64::from(i * 5 % 16) - 7.5) / 8.0;
    (0..16).map(|i| way(i) * share * size).collect()
}

fn bent_truth(subject: &Subject, bend: &Bend, colouring: Colouring) -> Vec<u8> {
    let options = RasterOptions {
        width: WINDOW.width,
        height: WINDOW.height,
        view: Some(subject.view),
        colouring,
        bend: Some(bend),
        ..RasterOptions::default()
    };
    rasterize(&subject.ifs, &options).unwrap()
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn bent_pictures_are_those_of_the_processor() {
    for &wanted in BACKENDS {
        for software in [false, true] {
            let (mut stage, events) = stage(wanted, software).await;
            for name in ["gasket", "dragon", "fern"] {
                let subject = subject(name);
                let what = format!("{name} {wanted:?} software {software}");
                show(&mut stage, &subject, Colouring::Map, 1.0, PLENTY);
                stage.set_bend(Some(bend(&subject, 0.08, 5.0, false)));
                let first = stage.draw(PLENTY);
                assert!(first.points > 500 && !first.settled, "{what} {first:?}");
                let drawn = settle(&mut stage);
                assert!(drawn.complete, "{what} {drawn:?}");
                let truth = bent_truth(&subject, &bend(&subject, 0.08, 5.0, false), Colouring::Map);
                let seen = picture_of(stage.read()).await;
                let (extra, missed) = (disagreement(&seen, &truth).1, pixels_missed(&seen, &truth));
                assert!(missed == 0 && extra < 0.01, "{what}: {missed} {extra}");
                // Moved, first in a hurry, then at rest.
                let size = Hull::of(&subject.ifs).max() - Hull::of(&subject.ifs).min();
                assert!(!stage.move_mesh(&[glam::DVec2::ZERO]), "{what}: too few");
                assert!(stage.move_mesh(&moves(0.11, size)), "{what}");
                let moved = bent_truth(&subject, &bend(&subject, 0.11, 5.0, false), Colouring::Map);
                assert!(!stage.draw(PLENTY).complete);
                let (missed, extra) = disagreement(&picture_of(stage.read()).await, &moved);
                assert!(missed < 0.1 && extra < 0.1, "{what} moving: {missed} {extra}");
                assert!(settle(&mut stage).complete, "{what}");
                let seen = picture_of(stage.read()).await;
                let (extra, missed) = (disagreement(&seen, &moved).1, pixels_missed(&seen, &moved));
                assert!(missed == 0 && extra < 0.01, "{what} moved: {missed} {extra}");
                stage.set_bend(None);
            }
            assert_no_fault(&events);
        }
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn bends_carry_colours_and_densities() {
    for &wanted in BACKENDS {
        for software in [false, true] {
            let (mut stage, events) = stage(wanted, software).await;
            let subject = subject("dragon");
            show(&mut stage, &subject, Colouring::Grid, 1.0, PLENTY);
            stage.set_bend(Some(bend(&subject, 0.05, 4.0, true)));
            assert!(settle(&mut stage).complete);
            let seen = picture_of(stage.read()).await;
            let truth = bent_truth(&subject, &bend(&subject, 0.05, 4.0, true), Colouring::Grid);
            let (missed, extra) = disagreement(&seen, &truth);
            assert!(missed < 0.01 && extra < 0.01, "{wanted:?}: {missed} {extra}");
            // Pieces of one colour need not be the same ones: on the whole the colours are.
            let opaque = || {
                seen.chunks_exact(4).zip(truth.chunks_exact(4)).filter(|(a, b)| a[3] == 255 && b[3] == 255)
            };
            let off: u32 =
                opaque().map(|(a, b)| u32::from(a[0].abs_diff(b[0])) + u32::from(a[1].abs_diff(b[1]))).sum();
            assert!(off as usize <= 12 * opaque().count(), "{wanted:?}: {off} of {}", opaque().count());
            assert!(opaque().all(|(a, _)| a[2].abs_diff(128) <= 2), "{wanted:?}: blue is the same all over");
            stage.set_style(style(Colouring::Density));
            assert!(settle(&mut stage).complete, "{wanted:?}");
            let (_, extra) = disagreement(&picture_of(stage.read()).await, &truth);
            assert!(extra < 0.02, "{wanted:?} dense: {extra}");
            assert_no_fault(&events);
        }
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn swept_pictures_are_those_of_the_processor() {
    for &wanted in BACKENDS {
        for (name, software) in [("dragon", true), ("overlap", true), ("overlap", false)] {
            let (mut stage, events) = stage(wanted, software).await;
            let subject = subject(name);
            show(&mut stage, &subject, Colouring::Map, 1.0, 1_000_000);
            let drawn = settle(&mut stage);
            // Words explode: what is shown is whole, but not known to be.
            assert_eq!(drawn.complete, name == "dragon", "{drawn:?}");
            let options = RasterOptions {
                width: WINDOW.width,
                height: WINDOW.height,
                view: Some(subject.view),
                ..RasterOptions::default()
            };
            let truth = rasterize(&subject.ifs, &options).unwrap();
            assert_same(&format!("{name} {wanted:?}"), &picture_of(stage.read()).await, &truth, 1);
            assert_no_fault(&events);
        }
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn a_change_of_colours_needs_no_new_points() {
    for &wanted in BACKENDS {
        let (mut stage, events) = stage(wanted, false).await;
        let subject = subject("gasket");
        show(&mut stage, &subject, Colouring::Map, 2.0, PLENTY);
        settle(&mut stage);
        stage.set_style(Style { palette: vec![[255, 0, 0]], ..style(Colouring::Map) });
        assert!(stage.draw(10_000).complete, "it is still the complete picture");
        let seen = picture_of(stage.read()).await;
        let lit: Vec<_> = seen.chunks_exact(4).filter(|pixel| pixel[3] > 0).collect();
        assert!(lit.len() > 500 && lit.iter().all(|pixel| **pixel == [255, 0, 0, 255]));
        assert_no_fault(&events);
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn views_that_are_none_and_canvases_of_no_size_draw_nothing() {
    for &wanted in BACKENDS {
        let (mut stage, events) = stage(wanted, false).await;
        assert!(stage.draw(PLENTY).settled && stage.read().is_none(), "nothing was set yet");
        let subject = subject("gasket");
        show(&mut stage, &subject, Colouring::Map, 1.0, PLENTY);
        let before = picture_of(stage.read()).await;
        for scale in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
            assert!(!stage.set_view(View { x: 0.0, y: 0.0, scale }));
        }
        settle(&mut stage);
        assert!(disagreement(&before, &picture_of(stage.read()).await).0 < 0.1, "the last view stays");
        stage.resize(0, 50, 1.0);
        assert!(stage.draw(PLENTY).settled && stage.read().is_none());
        stage.resize(WINDOW.width, WINDOW.height, 1.0);
        assert!(!stage.draw(PLENTY).settled);
        stage.resize(1_000_000, 4, 1.0);
        stage.draw(PLENTY);
        assert_no_fault(&events);
    }
}
