//! Pictures are drawn here whose outline is known, and traced back.

use frond_core::hash;
use frond_fit::{MaskOptions, Notice, Outline, Stroke, TraceError, Tracer, fidelity, maple_leaf, oak_leaf};
use glam::DVec2;
use proptest::prelude::*;

/// A picture whose pixels are coloured by how much of each is inside (16 x 16 samples), y up.
struct Drawn {
    width: usize,
    height: usize,
    cover: Vec<f64>,
}

impl Drawn {
    fn new(width: usize, height: usize, inside: impl Fn(DVec2) -> bool) -> Self {
        const FINE: usize = 16;
        let cover = |i: usize| {
            let (x, y) = (i % width, height - 1 - i / width);
            let sample = |k: usize| {
                let part = |k: usize| (k as f64 + 0.5) / FINE as f64;
                inside(DVec2::new(x as f64 + part(k % FINE), y as f64 + part(k / FINE)))
            };
            (0..FINE * FINE).filter(|&k| sample(k)).count() as f64 / (FINE * FINE) as f64
        };
        Self { width, height, cover: (0..width * height).map(cover).collect() }
    }

    fn polygon(width: usize, height: usize, points: &[DVec2]) -> Self {
        // By rows: where the sides cross the middle of a row of samples.
        const FINE: usize = 16;
        let mut cover = vec![0.0; width * height];
        for row in 0..FINE * height {
            let y = (row as f64 + 0.5) / FINE as f64;
            let mut cuts: Vec<f64> = Vec::new();
            for (i, &a) in points.iter().enumerate() {
                let b = points[(i + 1) % points.len()];
                if (a.y > y) != (b.y > y) {
                    cuts.push(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
                }
            }
            cuts.sort_by(f64::total_cmp);
            let line = &mut cover[(height - 1 - row / FINE) * width..][..width];
            for pair in cuts.chunks_exact(2) {
                for (x, cover) in line.iter_mut().enumerate() {
                    let part = pair[1].min(x as f64 + 1.0) - pair[0].max(x as f64);
                    *cover += part.max(0.0) / FINE as f64;
                }
            }
        }
        Self { width, height, cover }
    }

    fn coloured(&self, inside: [u8; 3], outside: impl Fn(usize, usize) -> [u8; 3], noise: f64) -> Vec<u8> {
        let mut rgba = Vec::new();
        for (i, &cover) in self.cover.iter().enumerate() {
            let ground = outside(i % self.width, i / self.width);
            for k in 0..3 {
                let thrown = f64::from(hash::unit(hash::counter(77, (3 * i + k) as u32))) - 0.5;
                let value =
                    f64::from(inside[k]) * cover + f64::from(ground[k]) * (1.0 - cover) + noise * thrown;
                rgba.push(value.round().clamp(0.0, 255.0) as u8);
            }
            rgba.push(255);
        }
        rgba
    }

    fn plain(&self) -> Vec<u8> {
        self.coloured([0; 3], |_, _| [255; 3], 0.0)
    }

    fn tracer(&self, rgba: &[u8]) -> Tracer {
        Tracer::new(self.width, self.height, rgba).expect("a picture")
    }
}

fn traced(tracer: &Tracer, options: &MaskOptions) -> Vec<DVec2> {
    let mask = tracer.mask(options);
    tracer.outline(&mask, 0).expect("a shape").points
}

fn signed_area(points: &[DVec2]) -> f64 {
    (0..points.len()).map(|i| points[i].perp_dot(points[(i + 1) % points.len()])).sum::<f64>() / 2.0
}

fn paper(x: usize, y: usize) -> [u8; 3] {
    if x.is_multiple_of(10) || y.is_multiple_of(10) { [236, 130, 120] } else { [250, 242, 236] }
}

#[test]
fn a_disc_is_round_to_a_tenth_of_a_pixel() {
    for (radius, x, y) in [(30.0, 50.3, 40.8), (12.0, 30.0, 30.5), (38.5, 50.0, 40.0)] {
        let centre = DVec2::new(x, y);
        let drawn = Drawn::new(100, 80, |p| p.distance(centre) < radius);
        let points = traced(&drawn.tracer(&drawn.plain()), &MaskOptions::default());
        let off = points.iter().map(|p| (p.distance(centre) - radius).abs()).fold(0.0, f64::max);
        assert!(off < 0.1, "radius {radius}: {off}");
        let area = signed_area(&points);
        assert!(
            (area / (std::f64::consts::PI * radius * radius) - 1.0).abs() < 0.01,
            "counter-clockwise: {area}"
        );
        assert_ne!(points.first(), points.last());
    }
}

#[test]
fn rectangles_are_straight_however_they_are_turned() {
    for turn in [0.0, 0.1, 0.5, std::f64::consts::FRAC_PI_4, 1.3] {
        let axis = DVec2::from_angle(turn);
        let centre = DVec2::new(61.4, 50.7);
        let to = |p: DVec2| DVec2::new((p - centre).dot(axis), (p - centre).perp_dot(axis));
        let half = DVec2::new(35.0, 18.0);
        let drawn = Drawn::new(120, 100, |p| to(p).abs().cmplt(half).all());
        for rgba in [drawn.plain(), drawn.coloured([240, 240, 235], |_, _| [12, 20, 16], 0.0)] {
            let points = traced(&drawn.tracer(&rgba), &MaskOptions::default());
            let off = |p: &DVec2| {
                let apart = to(*p).abs() - half;
                apart.max_element().abs()
            };
            // Corners are rounded by the smoothing.
            let near_corner = |p: &DVec2| (to(*p).abs() - half).abs().max_element() < 3.0;
            let sides: Vec<_> = points.iter().filter(|p| !near_corner(p)).collect();
            assert!(sides.len() > 100);
            let most = sides.iter().map(|p| off(p)).fold(0.0, f64::max);
            let corners = points.iter().map(off).fold(0.0, f64::max);
            assert!(most < 0.1 && corners < 0.8, "turned by {turn}: {most}, {corners} at corners");
        }
    }
}

/// A grown leaf, so many pixels long, 50 from the corner.
fn in_picture(leaf: &[DVec2], long: f64) -> Vec<DVec2> {
    let outline = Outline::new(leaf).expect("a leaf");
    let (low, high) = outline.bounds();
    let scale = long / (high - low).max_element();
    leaf.iter().map(|&p| DVec2::splat(50.3) + (p - low) * scale).collect()
}

#[test]
fn grown_leaves_come_back() {
    for leaf in [maple_leaf(3), oak_leaf(5)] {
        let points = in_picture(&leaf, 1200.0);
        let drawn = Drawn::polygon(1300, 1300, &points);
        let traced = traced(&drawn.tracer(&drawn.plain()), &MaskOptions::default());
        let near = fidelity(&Outline::new(&points).expect("a leaf").resampled(20_000), &traced);
        // A hundredth of a percent of the diagonal is a sixth of a pixel.
        assert!(near.rms < 0.03 && near.hausdorff < 0.4, "{near:?}");
        assert!(near.slope_difference().abs() < 0.01, "{near:?}");
    }
}

#[test]
fn a_green_leaf_comes_back_from_noisy_ruled_paper() {
    let points = in_picture(&maple_leaf(3), 600.0);
    let drawn = Drawn::polygon(700, 700, &points);
    let rgba = drawn.coloured([80, 120, 60], paper, 40.0);
    let tracer = drawn.tracer(&rgba);
    let mask = tracer.mask(&MaskOptions::default());
    assert_eq!(mask.notices(), []);
    assert_eq!(mask.components().len(), 1);
    let inside = |i: usize| drawn.cover[i] > 0.5;
    let bytes = mask.bytes();
    let both = (0..bytes.len()).filter(|&i| inside(i) && bytes[i] > 0).count();
    let either = (0..bytes.len()).filter(|&i| inside(i) || bytes[i] > 0).count();
    assert!(both as f64 / either as f64 > 0.99, "{both} of {either}");
    let near = fidelity(
        &Outline::new(&points).expect("a leaf").resampled(20_000),
        &tracer.outline(&mask, 0).expect("a leaf").points,
    );
    assert!(near.rms < 0.06 && near.hausdorff < 0.6, "{near:?}");
}

#[test]
fn what_is_painted_holds_whatever_the_threshold() {
    let drawn = Drawn::new(100, 80, |p| p.distance(DVec2::new(50.0, 40.0)) < 25.0);
    let tracer = drawn.tracer(&drawn.plain());
    let dab = |x, y, keep| Stroke { points: vec![[x, y]], radius: 4.0, keep };
    for threshold in [-0.9, 0.0, 0.9] {
        let strokes = vec![dab(80.0, 40.0, true), dab(50.0, 40.0, false), dab(26.0, 40.0, false)];
        let mask = tracer.mask(&MaskOptions { threshold, strokes, ..MaskOptions::default() });
        let bytes = mask.bytes();
        let at = |x: usize, y: usize| bytes[y * 100 + x] > 0;
        assert!(at(80, 40) && !at(50, 40) && !at(26, 40) && at(60, 40), "at {threshold}");
    }
    // And the outline goes round it.
    let strokes = vec![Stroke { points: vec![[50.0, 40.0], [95.0, 40.0]], radius: 4.0, keep: true }];
    let points = traced(&tracer, &MaskOptions { strokes, ..MaskOptions::default() });
    let right = points.iter().map(|p| p.x).fold(0.0, f64::max);
    assert!((right - 99.0).abs() < 0.6, "{right}");
}

#[test]
fn a_shape_can_be_painted_on_nothing() {
    let tracer = Tracer::new(60, 50, &[255; 4 * 60 * 50]).expect("a picture");
    let strokes = vec![Stroke { points: vec![[30.0, 20.0]], radius: 15.0, keep: true }];
    let points = traced(&tracer, &MaskOptions { strokes, ..MaskOptions::default() });
    let off = points.iter().map(|p| (p.distance(DVec2::new(30.0, 30.0)) - 15.0).abs()).fold(0.0, f64::max);
    assert!(off < 0.8, "{off}");
}

#[test]
fn stalks_come_off_and_specks_go_and_small_holes_are_filled() {
    let blade = |p: DVec2| p.distance(DVec2::new(150.0, 120.0)) < 70.0;
    let drawn = Drawn::new(300, 220, |p| {
        let stalk = (p.x - 150.0).abs() < 3.0 && p.y < 120.0 && p.y > 5.0;
        let speck = p.distance(DVec2::new(20.0, 200.0)) < 2.0;
        (blade(p) && p.distance(DVec2::new(140.0, 130.0)) > 5.0) || stalk || speck
    });
    let tracer = drawn.tracer(&drawn.plain());
    let mask = tracer.mask(&MaskOptions::default());
    assert_eq!(mask.components().len(), 1);
    let whole = std::f64::consts::PI * 70.0 * 70.0;
    assert!(mask.components()[0].area as f64 > whole + 200.0);
    let bare = tracer.mask(&MaskOptions { remove_stalks: true, ..MaskOptions::default() });
    assert!((bare.components()[0].area as f64 - whole).abs() < 60.0, "{}", bare.components()[0].area);
}

#[test]
fn a_threshold_takes_more_or_less() {
    let drawn = Drawn::new(100, 80, |p| p.distance(DVec2::new(50.0, 40.0)) < 25.0);
    // Darker towards its middle.
    let mut rgba = drawn.plain();
    for (i, pixel) in rgba.chunks_exact_mut(4).enumerate() {
        let far = DVec2::new((i % 100) as f64 - 50.0, (i / 100) as f64 - 40.0).length();
        let value = (8.0 * far).min(255.0) as u8;
        pixel[..3].fill(value);
    }
    let tracer = drawn.tracer(&rgba);
    let areas: Vec<_> = [-0.8, -0.4, 0.0, 0.4, 0.8]
        .iter()
        .map(|&threshold| {
            let mask = tracer.mask(&MaskOptions { threshold, ..MaskOptions::default() });
            mask.components().first().map_or(0, |part| part.area)
        })
        .collect();
    assert!(areas.windows(2).all(|pair| pair[0] < pair[1]), "{areas:?}");
}

fn notices(width: usize, height: usize, pixel: impl Fn(usize, usize) -> [u8; 4]) -> Vec<&'static str> {
    let rgba: Vec<u8> = (0..width * height).flat_map(|i| pixel(i % width, i / width)).collect();
    let tracer = Tracer::new(width, height, &rgba).expect("a picture");
    let mask = tracer.mask(&MaskOptions::default());
    let mut all: Vec<Notice> = mask.notices().to_vec();
    if let Ok(traced) = tracer.outline(&mask, 0) {
        all.extend(traced.notices);
    }
    assert!(all.iter().all(|notice| notice.message().len() > 30));
    all.into_iter().map(Notice::code).collect()
}

#[test]
fn what_is_wrong_with_a_picture_is_said() {
    let dice = |x: usize, y: usize, seed| hash::counter(seed, (y * 1000 + x) as u32);
    let grey = |value: u8| [value, value, value, 255];
    assert_eq!(notices(80, 60, |_, _| grey(0)), ["all-black"]);
    assert_eq!(notices(80, 60, |_, _| grey(250)), ["blank"]);
    // As cameras and JPEG files have it.
    assert_eq!(notices(300, 200, |x, y| grey(246 + (dice(x, y, 1) % 8) as u8)), ["blank"]);
    assert_eq!(notices(300, 200, |x, y| grey((dice(x, y, 1) % 12) as u8)), ["all-black"]);
    assert_eq!(notices(80, 60, |_, _| [9, 9, 9, 0]), ["all-black"]);
    let noise = notices(300, 200, |x, y| {
        let thrown = dice(x, y, 2).to_le_bytes();
        [thrown[0], thrown[1], thrown[2], 255]
    });
    assert_eq!(noise.first(), Some(&"noise"), "{noise:?}");
    let disc = |x: usize, y: usize, cx: f64, r: f64| (x as f64 - cx).hypot(y as f64 - 100.0) < r;
    let ink = |dark: bool| grey(if dark { 20 } else { 240 });
    assert_eq!(notices(300, 200, |x, y| ink(disc(x, y, 80.0, 50.0) || disc(x, y, 220.0, 45.0))), ["several"]);
    assert_eq!(notices(300, 200, |x, y| ink(disc(x, y, 10.0, 60.0))), ["touches-border"]);
    assert_eq!(notices(300, 200, |x, y| ink(disc(x, y, 150.0, 60.0))), [""; 0]);
    // A small hole is filled, a large one left open; the outline passes over both.
    let with = |r: f64| move |x, y| ink(disc(x, y, 150.0, 60.0) && !disc(x, y, 150.0, r));
    assert_eq!(notices(300, 200, with(5.0)), ["holes"]);
    assert_eq!(notices(300, 200, with(30.0)), ["holes"]);
    assert_eq!(notices(300, 200, with(1.2)), [""; 0]);
}

#[test]
fn errors_have_codes_and_say_what_to_do() {
    assert_eq!(Tracer::new(0, 3, &[]).err(), Some(TraceError::NoPixels));
    assert_eq!(Tracer::new(2, 3, &[0; 23]).err().map(|e| e.code()), Some("bad-input"));
    assert_eq!(Tracer::new(10_000, 5000, &[]).err().map(|e| e.code()), Some("too-large"));
    assert_eq!(Tracer::new(usize::MAX, 2, &[]).err().map(|e| e.code()), Some("too-large"));
    let tracer = Tracer::new(20, 20, &[200; 1600]).expect("a picture");
    let mask = tracer.mask(&MaskOptions::default());
    assert_eq!(tracer.outline(&mask, 0), Err(TraceError::NoPiece { count: 0 }));
}

#[test]
fn a_comb_is_thinned() {
    // Teeth of two pixels all over: more than 100,000 points round it.
    let drawn = |x: usize, y: usize| x % 4 < 2 || y == 0;
    let rgba: Vec<u8> = (0..600 * 600)
        .flat_map(|i| {
            let (x, y) = (i % 600, i / 600);
            let on = (20..580).contains(&x) && (20..580).contains(&y) && drawn(x, y - 20);
            [0, 0, 0, if on { 255 } else { 0 }]
        })
        .collect();
    let tracer = Tracer::new(600, 600, &rgba).expect("a picture");
    let mask = tracer.mask(&MaskOptions::default());
    let traced = tracer.outline(&mask, 0).expect("a comb");
    assert_eq!(traced.points.len(), 100_000);
    assert_eq!(traced.notices[0].code(), "thinned");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(64)))]

    #[test]
    fn nothing_panics(
        width in 1_usize..24,
        height in 1_usize..24,
        seed in 0_u32..1000,
        colours in 1_u32..6,
        threshold in prop_oneof![-1.5..1.5, Just(f64::NAN)],
        invert: bool,
        remove_stalks: bool,
        hinted: bool,
        stroke in proptest::collection::vec((-10.0..30.0, -10.0..30.0), 0..4),
        radius in prop_oneof![0.0..9.0, Just(f64::NAN), Just(1e300)],
    ) {
        let byte = |i: usize, k: u32| (hash::counter(seed, 4 * (i as u32 / 3) + k) % colours * 51) as u8;
        let rgba: Vec<u8> = (0..width * height).flat_map(|i| [0, 1, 2, 3].map(|k| byte(i, k))).collect();
        let tracer = Tracer::new(width, height, &rgba).expect("a picture");
        let points = stroke.iter().map(|&(x, y)| [x, y]).collect();
        let strokes = vec![Stroke { points, radius, keep: seed % 2 == 0 }];
        let hints = if hinted { strokes.clone() } else { Vec::new() };
        let mask = tracer.mask(&MaskOptions { threshold, invert, remove_stalks, hints, strokes });
        let on = mask.bytes().iter().filter(|&&byte| byte > 0).count();
        prop_assert_eq!(on, mask.components().iter().map(|part| part.area).sum::<usize>());
        for i in 0..mask.components().len() + 1 {
            if let Ok(traced) = tracer.outline(&mask, i) {
                prop_assert!(traced.points.len() >= 4 && signed_area(&traced.points) > 0.0);
                let inside = |p: &DVec2| p.cmpge(DVec2::ZERO).all() && p.x <= width as f64 && p.y <= height as f64;
                prop_assert!(traced.points.iter().all(inside));
            }
        }
    }
}
