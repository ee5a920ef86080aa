//! What small fits come to, and how long they take: outlines of few corners, grown leaves with few numbers, a
//! photograph of two million pixels, and the outlines (.csv) of the folder named in `FROND_LEAVES`:
//! `FROND_LEAVES=.. cargo bench -p frond-fit --bench small -- [name ..]`.
//!
//! A row: the outline and its points, what was asked for, seconds of processor time, steps, and errors in percent of
//! the diagonal.

use frond_fit::{
    Fitter, MaskOptions, Outline, SplineFitter, Tracer, fidelity, island, maple_leaf, oak_leaf, sugar_maple,
    white_oak,
};
use frond_testing::processor_seconds;
use glam::DVec2;

/// How many numbers outlines of many points are fitted with.
const NUMBERS: [usize; 4] = [12, 24, 60, 120];

/// The photograph, in pixels.
const PHOTOGRAPH: (usize, usize) = (1600, 1200);

fn main() {
    let names: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let wanted = |name: &str| names.is_empty() || names.iter().any(|wanted| name.contains(wanted));
    for (name, points) in small() {
        if wanted(name) {
            by_numbers(name, &points, 12);
            by_bytes(name, &points, 50);
        }
    }
    for (name, points) in leaves() {
        let few = Outline::new(&points).map(|outline| outline.resampled(150).points().to_vec());
        if wanted(&name) {
            few.iter().for_each(|few| by_numbers(&name, few, 12));
            NUMBERS.iter().for_each(|&numbers| by_numbers(&name, &points, numbers));
        }
    }
    if wanted("photograph") {
        photograph();
    }
}

/// Outlines of few corners, and some that are hard to fit.
fn small() -> Vec<(&'static str, Vec<DVec2>)> {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from).to_vec();
    let triangle = [[0.1, 0.2], [3.3, 0.7], [1.4, 2.9]].map(DVec2::from).to_vec();
    let star = |tips: u32| -> Vec<DVec2> {
        let tip = |i: u32| DVec2::from_angle(std::f64::consts::PI * f64::from(i) / f64::from(tips));
        (0..2 * tips).map(|i| tip(i) * if i % 2 == 0 { 1.0 } else { 0.45 }).collect()
    };
    let along = |corners: &[DVec2], each: u32| -> Vec<DVec2> {
        let next = |i: usize| corners[(i + 1) % corners.len()];
        let side = |(i, &a): (usize, &DVec2)| {
            (0..each).map(move |k| (a, i, f64::from(k) / f64::from(each))).collect::<Vec<_>>()
        };
        corners.iter().enumerate().flat_map(side).map(|(a, i, share)| a.lerp(next(i), share)).collect()
    };
    let eight = |count: u32| -> Vec<DVec2> {
        let at = |i: u32| DVec2::from_angle(f64::from(i) / f64::from(count) * std::f64::consts::TAU);
        (0..count).map(|i| DVec2::new(at(i).x, at(i).x * at(i).y)).collect()
    };
    vec![
        ("square of a hundred points", along(&square, 25)),
        ("square", square),
        ("triangle", triangle),
        ("star of three tips", star(3)),
        ("star of five tips", star(5)),
        ("eight", eight(150)),
    ]
}

fn leaves() -> Vec<(String, Vec<DVec2>)> {
    let flower = |i: u32| {
        let angle = f64::from(i) / 150.0 * std::f64::consts::TAU;
        DVec2::from_angle(angle) * (1.0 + 0.25 * (5.0 * angle).cos())
    };
    let grown = [
        ("flower", (0..150).map(flower).collect()),
        ("maple", maple_leaf(1)),
        ("oak", oak_leaf(1)),
        ("sugar maple", sugar_maple(1)),
        ("white oak", white_oak(1)),
        ("island", island(4)),
    ];
    let mut all: Vec<(String, Vec<DVec2>)> =
        grown.into_iter().map(|(name, points)| (name.to_owned(), points)).collect();
    let plane = |points: Vec<[f64; 2]>| points.into_iter().map(DVec2::from).collect();
    all.extend(frond_testing::leaves().into_iter().map(|(name, points)| (name, plane(points))));
    all
}

fn by_numbers(name: &str, points: &[DVec2], numbers: usize) {
    let Ok(outline) = Outline::new(points) else { return };
    let start = processor_seconds();
    let Ok(mut fitter) = Fitter::new(&outline, numbers) else { return };
    let mut steps = 0;
    while !fitter.is_done() {
        fitter.step();
        steps += 1;
    }
    let took = processor_seconds() - start;
    let curve = &fitter.best().curve;
    let line = curve.polyline(1e-4 * outline.diagonal(), 12);
    report(name, &outline, &format!("{numbers} numbers: {}", curve.numbers()), (took, steps), &line);
}

fn by_bytes(name: &str, points: &[DVec2], bytes: usize) {
    let Ok(outline) = Outline::new(points) else { return };
    let start = processor_seconds();
    let mut fitter = SplineFitter::new(&outline, bytes);
    let mut steps = 0;
    while !fitter.is_done() {
        fitter.step();
        steps += 1;
    }
    let took = processor_seconds() - start;
    match fitter.best() {
        Some(fit) => {
            let asked = format!("{bytes} bytes: {}, {} nodes", fit.bytes.len(), fit.spline.nodes.len());
            report(name, &outline, &asked, (took, steps), &fit.spline.polyline(16));
        }
        None => println!("{name:<28} {bytes} bytes: nothing found  {took:.3} s  {steps} steps"),
    }
}

fn report(name: &str, outline: &Outline, asked: &str, (took, steps): (f64, usize), line: &[DVec2]) {
    let near = fidelity(outline, line);
    println!(
        "{name:<28} {:>5} points  {asked:<26} {took:>7.3} s {steps:>5} steps  rms {:.4}  hausdorff {:.3}",
        outline.points().len(),
        near.rms,
        near.hausdorff
    );
}

/// A leaf on paper, with light that falls off and the noise of a camera: its outline is traced and fitted.
fn photograph() {
    let (width, height) = PHOTOGRAPH;
    let rgba = painted(&sugar_maple(1), width, height);
    let start = processor_seconds();
    let Ok(tracer) = Tracer::new(width, height, &rgba) else { return };
    let looked = processor_seconds() - start;
    let mask = tracer.mask(&MaskOptions::default());
    let masked = processor_seconds() - start;
    let Ok(traced) = tracer.outline(&mask, 0) else { return };
    let took = processor_seconds() - start;
    println!(
        "photograph of {width} x {height}: looked at {looked:.3} s, mask {:.3} s, outline {:.3} s, {} points",
        masked - looked,
        took - masked,
        traced.points.len()
    );
    by_numbers("photograph", &traced.points, 60);
}

/// A picture of a green shape on paper.
fn painted(shape: &[DVec2], width: usize, height: usize) -> Vec<u8> {
    let Ok(outline) = Outline::new(shape) else { return Vec::new() };
    let (low, high) = outline.bounds();
    let scale = 0.8 * (width as f64 / (high.x - low.x)).min(height as f64 / (high.y - low.y));
    let centre = DVec2::new(width as f64, height as f64) / 2.0;
    let points: Vec<DVec2> =
        outline.points().iter().map(|p| (*p - low.midpoint(high)) * scale + centre).collect();
    let mut seed = 7_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 40) % 13) as f64 - 6.0
    };
    let mut rgba = Vec::with_capacity(4 * width * height);
    for row in 0..height {
        let y = (height - row) as f64 - 0.5;
        let mut cuts: Vec<f64> = (0..points.len())
            .filter_map(|i| {
                let (a, b) = (points[i], points[(i + 1) % points.len()]);
                ((a.y > y) != (b.y > y)).then(|| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
            })
            .collect();
        cuts.sort_by(f64::total_cmp);
        for column in 0..width {
            let x = column as f64 + 0.5;
            let inside: f64 = cuts
                .chunks_exact(2)
                .map(|cut| (cut[1].min(x + 0.5) - cut[0].max(x - 0.5)).clamp(0.0, 1.0))
                .sum();
            let light =
                1.0 - 0.12 * (x / width as f64 - 0.4).powi(2) - 0.1 * (y / height as f64 - 0.6).powi(2);
            for (leaf, paper) in [(70.0, 244.0), (112.0, 241.0), (48.0, 236.0)] {
                let value = light * (paper + (leaf - paper) * inside.min(1.0)) + noise();
                rgba.push(value.round().clamp(0.0, 255.0) as u8);
            }
            rgba.push(255);
        }
    }
    rgba
}
