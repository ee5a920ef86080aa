//! Leaves are cut out of photographs made by program: by themselves, and with one hint.

mod photograph;

use frond_fit::{MaskOptions, Stroke, Tracer};
use photograph::{HEIGHT, Photograph, WIDTH, set};

/// The part of what is leaf or taken for it that is both.
fn likeness(mask: &[u8], truth: &[bool]) -> f64 {
    let each = || mask.iter().zip(truth).map(|(&byte, &leaf)| (byte > 0, leaf));
    let both = each().filter(|&(a, b)| a && b).count();
    let either = each().filter(|&(a, b)| a || b).count();
    both as f64 / either.max(1) as f64
}

/// How far each pixel of a region is from its rim, in steps to the side; 0 outside.
fn depths(region: &[bool]) -> Vec<usize> {
    let mut depth: Vec<usize> = region.iter().map(|&on| usize::from(on)).collect();
    for level in 1.. {
        let deep = |i: usize| {
            let (x, y) = (i % WIDTH, i / WIDTH);
            let inner = x > 0 && y > 0 && x + 1 < WIDTH && y + 1 < HEIGHT;
            inner && [i - 1, i + 1, i - WIDTH, i + WIDTH].iter().all(|&j| depth[j] >= level)
        };
        let next: Vec<usize> = (0..depth.len()).filter(|&i| depth[i] == level && deep(i)).collect();
        if next.is_empty() {
            break;
        }
        next.iter().for_each(|&i| depth[i] = level + 1);
    }
    depth
}

/// What a person would paint who sees what is wrong: a straight stroke in the deepest of it, as in the evaluation of
/// Gulshan et al., "Geodesic star convexity for interactive image segmentation" (2010).
fn hint(mask: &[u8], truth: &[bool]) -> Option<Stroke> {
    let wrong = |leaf: bool| -> Vec<bool> {
        mask.iter().zip(truth).map(|(&byte, &is)| is == leaf && (byte > 0) != leaf).collect()
    };
    let (missed, taken) = (depths(&wrong(true)), depths(&wrong(false)));
    let deepest = |depth: &[usize]| (0..depth.len()).max_by_key(|&i| depth[i]).map(|i| (i, depth[i]));
    let ((m, missed_by), (t, taken_by)) = (deepest(&missed)?, deepest(&taken)?);
    let keep = missed_by >= taken_by;
    let (from, depth, most) = if keep { (m, missed, missed_by) } else { (t, taken, taken_by) };
    if most == 0 {
        return None;
    }
    let place = |i: usize| [(i % WIDTH) as f64 + 0.5, (i / WIDTH) as f64 + 0.5];
    let [x0, y0] = place(from);
    let far = |i: usize| (place(i)[0] - x0).hypot(place(i)[1] - y0);
    let least = (most / 2).max(1);
    let straight = |&i: &usize| {
        let [x, y] = place(i);
        let steps = far(i).ceil().max(1.0);
        (0..=steps as usize).all(|k| {
            let part = k as f64 / steps;
            let at = |a: f64, b: f64| (a + (b - a) * part) as usize;
            depth[at(y0, y) * WIDTH + at(x0, x)] >= least
        })
    };
    let to = (0..depth.len())
        .filter(|&i| depth[i] >= least)
        .filter(straight)
        .max_by(|&a, &b| far(a).total_cmp(&far(b)))?;
    let radius = (least as f64 / 2.0).clamp(0.5, 4.0);
    Some(Stroke { points: vec![place(from), place(to)], radius, keep })
}

/// What is cut out well.
const ENOUGH: f64 = 0.95;

#[test]
fn a_leaf_is_cut_out_with_one_hint_at_most() {
    let folder = std::env::var("FROND_PHOTOGRAPHS").ok();
    for photo in set::all() {
        let tracer = Tracer::new(WIDTH, HEIGHT, &photo.rgba).expect("a picture");
        let mask = tracer.mask(&MaskOptions::default()).bytes();
        let none = likeness(&mask, &photo.truth);
        let hints: Vec<Stroke> = hint(&mask, &photo.truth).into_iter().collect();
        let with = tracer.mask(&MaskOptions { hints, ..MaskOptions::default() }).bytes();
        let one = likeness(&with, &photo.truth);
        println!("{:32} {none:.3} {one:.3}", photo.name);
        if let Some(folder) = &folder {
            write(folder, &photo, &mask, &with, &hint(&mask, &photo.truth).into_iter().collect::<Vec<_>>());
        }
        // Who sees that a hint made it worse takes it back.
        assert!(none.max(one) > ENOUGH, "{}: {none} without a hint, {one} with one", photo.name);
        if none > ENOUGH {
            assert!(one > none - 0.04, "{}: a hint that says nothing new makes {one} of {none}", photo.name);
        }
    }
}

/// The picture, and below it what was cut out without a hint, and with it.
fn write(folder: &str, photo: &Photograph, mask: &[u8], with: &[u8], hints: &[Stroke]) {
    let mut ppm = format!("P6\n{WIDTH} {}\n255\n", 3 * HEIGHT).into_bytes();
    ppm.extend(photo.rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    let mut painted = vec![0; WIDTH * HEIGHT];
    for stroke in hints {
        stroke.pixels(WIDTH, HEIGHT, |i| painted[i] = if stroke.keep { 1 } else { 2 });
    }
    for (k, mask) in [mask, with].into_iter().enumerate() {
        for (i, p) in photo.rgba.chunks_exact(4).enumerate() {
            ppm.extend(match (painted[i], mask[i] > 0, photo.truth[i]) {
                (1, ..) if k == 0 => [255, 255, 0],
                (2, ..) if k == 0 => [0, 0, 255],
                (_, true, true) => [p[0], p[1], p[2]],
                (_, false, true) => [0, 255, 255],
                (_, true, false) => [255, 0, 0],
                _ => [255, 0, 255],
            });
        }
    }
    std::fs::write(format!("{folder}/{}.ppm", photo.name.replace([' ', ','], "_")), ppm).expect("written");
}
