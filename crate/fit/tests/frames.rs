//! What surrounds a picture is no leaf: frames, strips, round fields, clear margins.

mod photograph;

use frond_core::hash;
use frond_fit::{Mask, MaskOptions, Notice, Stroke, Surround, Tracer};
use photograph::{HEIGHT, WIDTH, set};
use proptest::prelude::*;

const SIZE: [usize; 2] = [360, 280];
const GROUND: [u8; 4] = [208, 204, 190, 255];
const LEAF: [u8; 4] = [70, 115, 55, 255];
const DARK: [u8; 4] = [9, 8, 10, 255];
const WHITE: [u8; 4] = [252, 252, 250, 255];
const CLEAR: [u8; 4] = [0, 0, 0, 0];

/// A toothed leaf, `wide` from its middle to its tips.
fn leaf(x: f64, y: f64, [cx, cy]: [f64; 2], wide: f64) -> bool {
    let (x, y) = (x - cx, (y - cy) / 0.65);
    x.hypot(y) < wide * (1.0 + 0.12 * (9.0 * y.atan2(x)).cos())
}

fn at_home(x: f64, y: f64) -> bool {
    leaf(x, y, [170.0, 145.0], 65.0)
}

/// A picture, perhaps with the noise of a camera.
fn painted(size: [usize; 2], noise: f64, colour: impl Fn(f64, f64) -> [u8; 4]) -> Vec<u8> {
    let mut rgba = Vec::new();
    for i in 0..size[0] * size[1] {
        let [r, g, b, a] = colour((i % size[0]) as f64 + 0.5, (i / size[0]) as f64 + 0.5);
        for (k, value) in [r, g, b].into_iter().enumerate() {
            let thrown = f64::from(hash::unit(hash::counter(5, (3 * i + k) as u32))) - 0.5;
            rgba.push((f64::from(value) + noise * thrown).round().clamp(0.0, 255.0) as u8);
        }
        rgba.push(a);
    }
    rgba
}

fn mask_of(size: [usize; 2], rgba: &[u8]) -> Mask {
    Tracer::new(size[0], size[1], rgba).expect("a picture").mask(&MaskOptions::default())
}

fn surround(mask: &Mask) -> Option<Surround> {
    mask.notices().iter().find_map(|notice| match notice {
        Notice::Surrounded(kind) => Some(*kind),
        _ => None,
    })
}

/// The part of what is leaf or taken for it that is both.
fn likeness(mask: &[u8], truth: impl Fn(usize) -> bool) -> f64 {
    let each = || mask.iter().enumerate().map(|(i, &byte)| (byte > 0, truth(i)));
    let both = each().filter(|&(a, b)| a && b).count();
    both as f64 / each().filter(|&(a, b)| a || b).count().max(1) as f64
}

fn like_home(mask: &Mask) -> f64 {
    let place = |i: usize| ((i % SIZE[0]) as f64 + 0.5, (i / SIZE[0]) as f64 + 0.5);
    likeness(&mask.bytes(), |i| at_home(place(i).0, place(i).1))
}

/// Whether a place lies outside a box.
fn beyond([left, top, right, bottom]: [f64; 4]) -> impl Fn(f64, f64) -> bool {
    move |x, y| x < left || y < top || x > right || y > bottom
}

/// Whether a place lies outside an ellipse.
fn outside(centre: [f64; 2], radii: [f64; 2]) -> impl Fn(f64, f64) -> bool {
    move |x, y| ((x - centre[0]) / radii[0]).hypot((y - centre[1]) / radii[1]) > 1.0
}

type Outside = Box<dyn Fn(f64, f64) -> bool>;

/// Frames, strips, fields and cards, each around the same leaf.
fn surroundings() -> Vec<(&'static str, Surround, [u8; 4], Outside)> {
    let [w, h] = SIZE.map(|side| side as f64);
    let askew = move |x: f64, y: f64| {
        let (sin, cos) = 0.06_f64.sin_cos();
        let (x, y) = (x - w / 2.0, y - h / 2.0);
        (cos * x + sin * y).abs() > 0.45 * w || (cos * y - sin * x).abs() > 0.44 * h
    };
    let round_corners = move |x: f64, y: f64| {
        let (x, y) = ((x - w / 2.0).abs() - (w / 2.0 - 20.0), (y - h / 2.0).abs() - (h / 2.0 - 20.0));
        x > 0.0 && y > 0.0 && x.hypot(y) > 20.0
    };
    let all = [12.0, 12.0, w - 12.0, h - 12.0];
    vec![
        ("a dark frame", Surround::Frame, DARK, Box::new(beyond(all))),
        ("a white frame", Surround::Frame, WHITE, Box::new(beyond([9.0, 20.0, w - 15.0, h - 7.0]))),
        ("a frame of the leaf's colour", Surround::Frame, LEAF, Box::new(beyond(all))),
        (
            "a thick frame",
            Surround::Frame,
            [90, 20, 20, 255],
            Box::new(beyond([60.0, 50.0, w - 70.0, h - 40.0])),
        ),
        ("a thin frame", Surround::Frame, DARK, Box::new(beyond([2.0, 2.0, w - 2.0, h - 2.0]))),
        ("bars above and below", Surround::Frame, DARK, Box::new(beyond([0.0, 30.0, w, h - 30.0]))),
        ("three sides", Surround::Frame, DARK, Box::new(beyond([20.0, 20.0, w, h - 20.0]))),
        ("a frame askew", Surround::Frame, WHITE, Box::new(askew)),
        ("dark round corners", Surround::Frame, DARK, Box::new(round_corners)),
        ("a strip on the right", Surround::Strip, DARK, Box::new(beyond([0.0, 0.0, w - 40.0, h]))),
        ("a large strip on the left", Surround::Strip, DARK, Box::new(beyond([80.0, 0.0, w, h]))),
        ("a strip of the leaf's colour", Surround::Strip, LEAF, Box::new(beyond([0.0, 25.0, w, h]))),
        ("a strip below", Surround::Strip, WHITE, Box::new(beyond([0.0, 0.0, w, h - 25.0]))),
        ("a round field", Surround::Round, DARK, Box::new(outside([w / 2.0, h / 2.0], [136.0; 2]))),
        ("a field that is cut", Surround::Round, DARK, Box::new(outside([w / 2.0, h / 2.0], [165.0; 2]))),
        ("a field aside", Surround::Round, DARK, Box::new(outside([190.0, 150.0], [115.0; 2]))),
        (
            "an oval",
            Surround::Round,
            [200, 30, 30, 255],
            Box::new(outside([w / 2.0, h / 2.0], [172.0, 130.0])),
        ),
        ("a clear margin", Surround::Clear, CLEAR, Box::new(beyond([0.0, 0.0, w - 30.0, h]))),
        ("a card", Surround::Clear, CLEAR, Box::new(beyond([30.0, 25.0, w - 30.0, h - 35.0]))),
        ("clear round corners", Surround::Clear, CLEAR, Box::new(round_corners)),
        ("a round card", Surround::Clear, CLEAR, Box::new(outside([w / 2.0, h / 2.0], [130.0; 2]))),
    ]
}

#[test]
fn the_leaf_is_found_within_what_surrounds_it() {
    for (name, kind, colour, around) in surroundings() {
        for noise in [0.0, 16.0] {
            let rgba = painted(SIZE, noise, |x, y| match (around(x, y), at_home(x, y)) {
                (true, _) => colour,
                (false, true) => LEAF,
                _ => GROUND,
            });
            let mask = mask_of(SIZE, &rgba);
            assert_eq!(surround(&mask), Some(kind), "{name}, noise {noise}");
            assert_eq!(mask.components().len(), 1, "{name}, noise {noise}");
            let near = like_home(&mask);
            assert!(near > 0.995, "{name}, noise {noise}: {near}");
        }
    }
}

#[test]
fn a_light_leaf_in_a_white_frame_is_found() {
    let frame = beyond([14.0, 14.0, 346.0, 266.0]);
    let rgba = painted(SIZE, 8.0, |x, y| if frame(x, y) || at_home(x, y) { WHITE } else { DARK });
    let mask = mask_of(SIZE, &rgba);
    assert_eq!((surround(&mask), mask.components().len()), (Some(Surround::Frame), 1));
    assert!(like_home(&mask) > 0.995);
}

#[test]
fn a_print_with_a_border_on_a_dark_scan_is_peeled_twice() {
    let (print, border) = (beyond([20.0, 18.0, 340.0, 262.0]), beyond([34.0, 32.0, 326.0, 248.0]));
    let rgba = painted(SIZE, 8.0, |x, y| match (print(x, y), border(x, y), at_home(x, y)) {
        (true, ..) => DARK,
        (_, true, _) => WHITE,
        (.., true) => LEAF,
        _ => [25, 22, 20, 255],
    });
    let mask = mask_of(SIZE, &rgba);
    assert_eq!((surround(&mask), mask.components().len()), (Some(Surround::Frame), 1));
    assert!(like_home(&mask) > 0.99, "{}", like_home(&mask));
}

#[test]
fn light_may_fade_towards_the_rim() {
    // From the middle of the picture as far as its corners, and at the blurred edge of a round field.
    let vignette = |x: f64, y: f64| ((x - 180.0) / 180.0).hypot((y - 140.0) / 140.0);
    let field = |x: f64, y: f64| (x - 185.0).hypot(y - 142.0) / 128.0;
    type Far<'a> = &'a dyn Fn(f64, f64) -> f64;
    for (far, from, over) in [(&vignette as Far<'_>, 0.65, 0.5), (&vignette, 0.9, 0.15), (&field, 0.85, 0.3)]
    {
        let rgba = painted(SIZE, 5.0, |x, y| {
            let lit = ((from + over - far(x, y)) / over).clamp(0.0, 1.0);
            let colour = if at_home(x, y) { LEAF } else { GROUND };
            [0, 1, 2, 3].map(|k| if k == 3 { 255 } else { (f64::from(colour[k]) * lit) as u8 })
        });
        let mask = mask_of(SIZE, &rgba);
        assert!(like_home(&mask) > 0.98, "from {from}: {}", like_home(&mask));
    }
}

#[test]
fn a_leaf_that_the_frame_cuts_is_cut() {
    let frame = beyond([30.0, 20.0, 340.0, 260.0]);
    let cut = |x: f64, y: f64| leaf(x, y, [50.0, 140.0], 40.0) && !frame(x, y);
    for colour in [LEAF, [28, 30, 22, 255]] {
        let rgba = painted(SIZE, 6.0, |x, y| match (frame(x, y), cut(x, y)) {
            (true, _) => DARK,
            (_, true) => colour,
            _ => GROUND,
        });
        let tracer = Tracer::new(SIZE[0], SIZE[1], &rgba).expect("a picture");
        let mask = tracer.mask(&MaskOptions::default());
        let place = |i: usize| ((i % SIZE[0]) as f64 + 0.5, (i / SIZE[0]) as f64 + 0.5);
        let near = likeness(&mask.bytes(), |i| cut(place(i).0, place(i).1));
        assert!(near > 0.95, "{colour:?}: {near}");
        let traced = tracer.outline(&mask, 0).expect("a leaf");
        assert_eq!(traced.notices, [Notice::TouchesBorder]);
    }
}

#[test]
fn shapes_are_no_frames() {
    let veins = |x: f64, y: f64| (y - 140.0).abs() < 2.0 || (x - (y - 140.0).abs() * 0.4) % 40.0 < 3.0;
    let oval = |x: f64, y: f64| {
        let x = (x - 180.0) / 172.0;
        (y - 140.0).abs() < 90.0 * (1.0 - x * x).max(0.0).sqrt() * (1.0 - 0.15 * x)
    };
    let hole = |x: f64, y: f64, r: f64| (x - 200.0).hypot(y - 150.0) < r;
    type Inside = Box<dyn Fn(f64, f64) -> [u8; 4]>;
    let ink = |inside: bool| if inside { LEAF } else { GROUND };
    let shapes: Vec<(&str, Inside)> = vec![
        ("a large leaf", Box::new(move |x, y| ink(leaf(x, y, [180.0, 140.0], 155.0)))),
        (
            "an oval leaf with veins",
            Box::new(move |x, y| match (oval(x, y), veins(x, y)) {
                (true, true) => [150, 180, 120, 255],
                (inside, _) => ink(inside),
            }),
        ),
        (
            "a roundish leaf with a hole",
            Box::new(move |x, y| {
                let (x, y) = (x - 180.0, y - 140.0);
                let wide = 125.0 * (1.0 + 0.05 * (3.0 * y.atan2(x)).cos());
                ink(x.hypot(y) < wide && !hole(x + 180.0, y + 140.0, 20.0))
            }),
        ),
        ("a disc", Box::new(move |x, y| ink((x - 180.0).hypot(y - 140.0) < 130.0))),
        (
            "a ball",
            Box::new(move |x, y| {
                let far = (x - 180.0).hypot(y - 140.0) / 130.0;
                let lit = 0.2 + 0.8 * (1.0 - far * far).max(0.0).sqrt();
                let colour = |k: usize| (lit * [200.0, 90.0, 40.0][k]) as u8;
                if far < 1.0 { [colour(0), colour(1), colour(2), 255] } else { GROUND }
            }),
        ),
        ("a rectangle", Box::new(move |x, y| ink(!beyond([20.0, 20.0, 340.0, 260.0])(x, y)))),
        ("a leaf cut by the picture", Box::new(move |x, y| ink(leaf(x, y, [340.0, 140.0], 120.0)))),
        ("half a picture", Box::new(move |x, _| ink(x < 150.0))),
        (
            "a ring",
            Box::new(move |x, y| {
                let far = (x - 180.0).hypot(y - 140.0);
                ink((30.0..85.0).contains(&far))
            }),
        ),
        ("a cut-out", Box::new(move |x, y| if at_home(x, y) { LEAF } else { CLEAR })),
        (
            "a cut-out with veins",
            Box::new(move |x, y| match (oval(x, y), veins(x, y)) {
                (false, _) => CLEAR,
                (_, true) => [200, 220, 180, 255],
                _ => LEAF,
            }),
        ),
        (
            "a plain card",
            Box::new(move |x, y| if beyond([20.0, 20.0, 340.0, 260.0])(x, y) { CLEAR } else { LEAF }),
        ),
    ];
    for (name, colour) in shapes {
        for noise in [0.0, 12.0] {
            let mask = mask_of(SIZE, &painted(SIZE, noise, &colour));
            assert_eq!(surround(&mask), None, "{name}, noise {noise}");
        }
    }
}

#[test]
fn a_hint_on_what_was_left_out_takes_it_back() {
    for (name, _, colour, around) in surroundings().into_iter().step_by(2) {
        let rgba = painted(SIZE, 0.0, |x, y| match (around(x, y), at_home(x, y)) {
            (true, _) => colour,
            (false, true) => LEAF,
            _ => GROUND,
        });
        let tracer = Tracer::new(SIZE[0], SIZE[1], &rgba).expect("a picture");
        let first = (0..SIZE[0] * SIZE[1]).map(|i| [(i % SIZE[0]) as f64 + 0.5, (i / SIZE[0]) as f64 + 0.5]);
        let at = first.into_iter().find(|&[x, y]| around(x, y)).expect("something around");
        let hints = vec![Stroke { points: vec![at], radius: 0.5, keep: true }];
        let mask = tracer.mask(&MaskOptions { hints, ..MaskOptions::default() });
        assert_eq!(surround(&mask), None, "{name}");
        // A hint within, or one that says that the frame is no leaf, leaves it out as before.
        for (at, keep) in [([170.0, 145.0], true), (at, false)] {
            let hints = vec![Stroke { points: vec![at], radius: 3.0, keep }];
            let mask = tracer.mask(&MaskOptions { hints, ..MaskOptions::default() });
            assert!(surround(&mask).is_some() && like_home(&mask) > 0.98, "{name}: {}", like_home(&mask));
        }
    }
    // The card itself, with its outline at a fraction of a pixel.
    let card = beyond([30.0, 25.0, 330.0, 245.0]);
    let rgba = painted(SIZE, 0.0, |x, y| match (card(x, y), at_home(x, y)) {
        (true, _) => CLEAR,
        (_, true) => LEAF,
        _ => GROUND,
    });
    let tracer = Tracer::new(SIZE[0], SIZE[1], &rgba).expect("a picture");
    let hints = vec![Stroke { points: vec![[5.0, 5.0], [9.0, 90.0]], radius: 2.0, keep: true }];
    let mask = tracer.mask(&MaskOptions { hints, ..MaskOptions::default() });
    let traced = tracer.outline(&mask, 0).expect("the card");
    assert!((traced.area() - 300.0 * 220.0).abs() < 20.0, "{}", traced.area());
    // A corner may be smaller than the brush: where a stroke begins counts.
    let begun = vec![Stroke { points: vec![[10.0, 10.0], [170.0, 145.0]], radius: 9.0, keep: true }];
    let mask = tracer.mask(&MaskOptions { hints: begun, ..MaskOptions::default() });
    assert_eq!(surround(&mask), None);
    // The brush paints on a frame as elsewhere.
    let strokes = vec![Stroke { points: vec![[15.0, 140.0]], radius: 8.0, keep: true }];
    let painted = tracer.mask(&MaskOptions { strokes, ..MaskOptions::default() });
    assert!(painted.bytes()[140 * SIZE[0] + 15] > 0 && painted.components().len() == 2);
}

#[test]
fn what_is_left_out_is_said_in_words_of_its_own() {
    let kinds = [Surround::Frame, Surround::Strip, Surround::Round, Surround::Clear];
    let mut words: Vec<String> = kinds.iter().map(|&kind| Notice::Surrounded(kind).message()).collect();
    assert!(words.iter().all(|words| words.contains("is left out") && words.contains("“leaf”")));
    words.dedup();
    assert_eq!(words.len(), 4);
    assert_eq!(Notice::Surrounded(Surround::Strip).code(), "surrounded");
}

/// Each photograph in one kind of frame after the other is cut out as without one.
#[test]
fn photographs_in_frames_are_cut_out_as_without() {
    let [w, h] = [WIDTH, HEIGHT].map(|side| side as f64);
    let frames: [(Outside, [u8; 4]); 5] = [
        (Box::new(beyond([8.0, 8.0, w - 8.0, h - 8.0])), DARK),
        (Box::new(beyond([16.0, 12.0, w - 12.0, h - 16.0])), WHITE),
        (Box::new(beyond([0.0, 0.0, 0.93 * w, h])), DARK),
        (Box::new(beyond([0.0, 0.08 * h, w, h])), WHITE),
        (Box::new(beyond([14.0, 14.0, w - 14.0, h - 14.0])), CLEAR),
    ];
    for (k, photo) in set::all().into_iter().enumerate() {
        let size = [WIDTH, HEIGHT];
        let bare = mask_of(size, &photo.rgba);
        assert_eq!(surround(&bare), None, "{}", photo.name);
        let (around, colour) = &frames[k % frames.len()];
        let is_around = |i: usize| around((i % WIDTH) as f64 + 0.5, (i / WIDTH) as f64 + 0.5);
        let mut rgba = photo.rgba.clone();
        for (i, pixel) in rgba.chunks_exact_mut(4).enumerate().filter(|(i, _)| is_around(*i)) {
            let noise = if colour[3] > 0 { (i * 7919 % 5) as u8 } else { 0 };
            pixel.copy_from_slice(colour);
            pixel[1] = pixel[1].saturating_sub(noise);
        }
        let framed = mask_of(size, &rgba);
        let before = likeness(&bare.bytes(), |i| photo.truth[i]);
        let after = likeness(&framed.bytes(), |i| photo.truth[i] && !is_around(i));
        println!("{:32} {before:.3} {after:.3}", photo.name);
        assert!(after > before - 0.03, "{}: {before} without a frame, {after} with one", photo.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(96)))]

    #[test]
    fn no_frame_breaks_anything(
        size in proptest::array::uniform2(1_usize..70),
        inset in proptest::array::uniform4(-3.0..20.0),
        round: bool,
        wide in 0.0..30.0,
        colours in proptest::array::uniform3(proptest::array::uniform4(0_u8..3)),
        noise in 0.0..60.0,
        hint in proptest::option::of((-5.0..75.0, -5.0..75.0, 0.0..9.0)),
        options in any::<[bool; 2]>(),
    ) {
        let [w, h] = size.map(|side| side as f64);
        let [left, top, right, bottom] = inset;
        let straight = beyond([left, top, w - right, h - bottom]);
        let disc = outside([w / 2.0 + left, h / 2.0 + top], [w.min(h) / 2.0 + right; 2]);
        let [outer, ground, inner] = colours.map(|colour| colour.map(|value| [0, 120, 255][usize::from(value)]));
        let rgba = painted(size, noise, |x, y| {
            let around = if round { disc(x, y) } else { straight(x, y) };
            match (around, leaf(x, y, [w / 2.0, h / 2.0], wide)) {
                (true, _) => outer,
                (_, true) => inner,
                _ => ground,
            }
        });
        let tracer = Tracer::new(size[0], size[1], &rgba).expect("a picture");
        let hints = hint.map(|(x, y, radius)| Stroke { points: vec![[x, y]], radius, keep: options[0] });
        let options =
            MaskOptions { invert: options[1], hints: hints.into_iter().collect(), ..MaskOptions::default() };
        let mask = tracer.mask(&options);
        let on = mask.bytes().iter().filter(|&&byte| byte > 0).count();
        prop_assert_eq!(on, mask.components().iter().map(|part| part.area).sum::<usize>());
        for k in 0..mask.components().len() {
            let _ = tracer.outline(&mask, k);
        }
    }
}
