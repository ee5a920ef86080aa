//! Tests of bent photographs.

use frond_core::hash::counter;

use super::*;

/// A picture whose colours tell the place, with stripes to look at closely.
fn photo(width: u32, height: u32) -> Photo {
    let pixel = |i: u32| {
        let (x, y) = (i % width, i / width);
        [
            (x * 255 / width) as u8,
            (y * 255 / height) as u8,
            if (x / 8 + y / 8) % 2 == 0 { 40 } else { 200 },
            255,
        ]
    };
    Photo::new(&(0..width * height).flat_map(pixel).collect::<Vec<_>>(), width, height).unwrap()
}

fn options(width: u32, height: u32, smooth: bool) -> SheetOptions {
    // A unit is as high as the picture.
    let scale = f64::from(height);
    let view = View { x: f64::from(width) / scale / 2.0, y: 0.5, scale };
    SheetOptions { width, height, view: Some(view), smooth }
}

fn straight(photo: &Photo) -> Vec<u8> {
    photo.levels()[0].pixels.concat()
}

fn psnr(a: &[u8], b: &[u8]) -> f64 {
    let square = |(x, y): (&u8, &u8)| (f64::from(*x) - f64::from(*y)).powi(2);
    let mean = a.iter().zip(b).map(square).sum::<f64>() / a.len() as f64;
    10.0 * (255.0 * 255.0 / mean.max(1e-9)).log10()
}

#[test]
fn a_sheet_at_rest_is_the_picture() {
    for (width, height) in [(160, 120), (90, 141)] {
        let photo = photo(width, height);
        for side in [1, 8, 96] {
            let sheet = Sheet::new(photo.aspect(), side, |p| p);
            let sharp = draw_sheet(&photo, &sheet, &options(width, height, false)).unwrap();
            assert!(psnr(&sharp, &straight(&photo)) > 55.0, "{side}: {}", psnr(&sharp, &straight(&photo)));
            let smooth = draw_sheet(&photo, &sheet, &options(width, height, true)).unwrap();
            assert!(psnr(&smooth, &straight(&photo)) > 26.0, "{side}: {}", psnr(&smooth, &straight(&photo)));
        }
    }
}

#[test]
fn shrunk_it_is_the_mean_of_what_it_shows() {
    let photo = photo(512, 512);
    let sheet = Sheet::new(1.0, 64, |p| p);
    let eighth = draw_sheet(&photo, &sheet, &options(64, 64, true)).unwrap();
    // The stripes of eight pixels are gone but for a trace.
    let blue: Vec<f64> = eighth.chunks_exact(4).map(|p| f64::from(p[2])).collect();
    let mean = blue.iter().sum::<f64>() / blue.len() as f64;
    assert!((mean - 120.0).abs() < 2.0, "{mean}");
}

#[test]
fn magnified_it_keeps_its_edges() {
    // One bright pixel in the middle of dark ones, 100 times as large: dark but for it and what lies between.
    let mut bytes = vec![[0, 0, 0, 255]; 81];
    bytes[40] = [255; 4];
    let photo = Photo::new(&bytes.concat(), 9, 9).unwrap();
    let sheet = Sheet::new(1.0, 16, |p| p);
    let large = draw_sheet(&photo, &sheet, &options(900, 900, true)).unwrap();
    let at = |x: usize, y: usize| large[(y * 900 + x) * 4];
    assert!(at(450, 450) > 250 && at(450, 560) < 3 && at(340, 450) < 3);
}

#[test]
fn nothing_is_missing_inside_however_rough_it_is() {
    // A rough bend whose rim stays outside of the view.
    for seed in 0..6 {
        let rough = [0.0, 0.002, 0.02, 0.2, 1.0, 30.0][seed as usize];
        let mut n = 0;
        let sheet = Sheet::new(1.0, 27, |p| {
            n += 2;
            let noise = |i: u32| f64::from(counter(seed, n + i) % 2001) / 1000.0 - 1.0;
            let rim = p.x == 0.0 || p.y == 0.0 || p.x == 1.0 || p.y == 1.0;
            if rim { p } else { p + DVec2::new(noise(0), noise(1)) * rough }
        });
        for smooth in [false, true] {
            let picture = draw_sheet(&photo(64, 64), &sheet, &options(120, 120, smooth)).unwrap();
            let holes = picture.chunks_exact(4).filter(|pixel| pixel[3] != 255).count();
            assert_eq!(holes, 0, "{rough} {smooth}");
        }
    }
}

#[test]
fn what_is_no_number_leaves_a_hole_and_nothing_breaks() {
    let mut n = 0;
    let sheet = Sheet::new(1.0, 20, |p| {
        n += 1;
        match n % 90 {
            7 => DVec2::NAN,
            33 => DVec2::splat(1e300),
            50 => DVec2::new(f64::NEG_INFINITY, 0.0),
            _ => p,
        }
    });
    let picture = draw_sheet(&photo(16, 16), &sheet, &options(100, 100, true)).unwrap();
    let lit = picture.chunks_exact(4).filter(|pixel| pixel[3] > 0).count();
    assert!(lit > 5000 && lit < 10_000, "{lit}");
    for aspect in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        assert_eq!(Sheet::at_rest(aspect).aspect(), 1.0);
    }
    for scale in [1e-290, 1e290] {
        for x in [0.3, 1e300] {
            let view = Some(View { x, y: 0.5, scale });
            let picture =
                draw_sheet(&photo(16, 16), &sheet, &SheetOptions { view, ..options(50, 50, false) });
            assert_eq!(picture.unwrap().len(), 10_000);
        }
    }
    assert!(sheet.fit(0, 0, 9.0).is_valid());
}

#[test]
fn deep_zooms_are_filled_to_the_last_pixel() {
    let photo = photo(64, 64);
    let sheet = Sheet::new(1.0, 128, |p| p + DVec2::new((9.0 * p.y).sin(), (7.0 * p.x).cos()) * 0.01);
    for zoom in 1..13 {
        let view = Some(View { x: 0.371, y: 0.613, scale: 100.0 * 10_f64.powi(zoom) });
        let picture = draw_sheet(&photo, &sheet, &SheetOptions { view, ..options(100, 100, true) }).unwrap();
        let holes = picture.chunks_exact(4).filter(|pixel| pixel[3] != 255).count();
        assert_eq!(holes, 0, "{zoom}");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let (photo, sheet) = (photo(8, 8), Sheet::at_rest(1.0));
    let with = |width, height, view| SheetOptions { width, height, view, smooth: true };
    assert_eq!(draw_sheet(&photo, &sheet, &with(0, 5, None)), Ok(Vec::new()));
    assert_eq!(draw_sheet(&photo, &sheet, &with(9000, 1, None)).unwrap_err().code(), "picture-too-large");
    let view = Some(View { x: 0.0, y: 0.0, scale: f64::NAN });
    assert_eq!(draw_sheet(&photo, &sheet, &with(9, 9, view)), Err(RenderError::View));
    let fitted = draw_sheet(&photo, &sheet, &with(100, 60, None)).unwrap();
    assert_eq!(fitted.chunks_exact(4).filter(|pixel| pixel[3] == 255).count(), 54 * 54);
}

#[test]
fn cells_are_as_fine_as_the_pieces() {
    assert_eq!(Sheet::resolution(2, 9.0, Sheet::FINEST), (512, 9));
    assert_eq!(Sheet::resolution(3, 9.0, Sheet::FINEST), (729, 6));
    assert_eq!(Sheet::resolution(2, 2.5, Sheet::FINEST), (192, 3));
    assert_eq!(Sheet::resolution(2, 0.0, Sheet::FINEST), (192, 0));
    assert_eq!(Sheet::resolution(3, f64::NAN, Sheet::FINEST), (192, 0));
    assert_eq!(Sheet::resolution(2, 1e9, 128), (128, 7));
    let maps = Sheet::maps(1.5, 3);
    assert_eq!(maps[5].apply(DVec2::ZERO), DVec2::new(1.0, 1.0 / 3.0));
}

#[test]
fn a_crumpled_sheet_is_drawn_coarser_and_still_whole() {
    let mut n = 0;
    let sheet = Sheet::new(1.0, 360, |p| {
        n += 1;
        p + DVec2::new(f64::from(n % 13), f64::from(n % 17)) * 5.0 - 40.0
    });
    let window = Window { width: 100, height: 100 };
    let view = options(100, 100, false).view.unwrap();
    let screen: Vec<DVec2> = on_target(&sheet, view, window, 1.0).collect();
    let step = sheet.step(&screen, window, MOST_LAYERS);
    assert!(step > 1 && sheet.side().is_multiple_of(step), "{step}");
    let flat = Sheet::new(1.0, 360, |p| p);
    let screen: Vec<DVec2> = on_target(&flat, view, window, 1.0).collect();
    assert_eq!(flat.step(&screen, window, MOST_LAYERS), 1);
    let none = Sheet::new(1.0, 360, |_| DVec2::NAN);
    let screen: Vec<DVec2> = on_target(&none, view, window, 1.0).collect();
    assert_eq!(none.step(&screen, window, MOST_LAYERS), 1);
}

#[test]
fn what_is_lower_in_the_picture_covers_what_is_above() {
    let photo = Photo::new(&[[255, 0, 0, 255], [0, 0, 255, 255]].concat(), 1, 2).unwrap();
    // Both halves on the same place.
    let sheet = Sheet::new(1.0, 2, |p| DVec2::new(p.x, 1.0 - 2.0 * (p.y - 0.5).abs()));
    let picture = draw_sheet(&photo, &sheet, &options(20, 20, true)).unwrap();
    let [red, _, blue, alpha] = [0, 1, 2, 3].map(|i| picture[(3 * 20 + 10) * 4 + i]);
    assert!(blue > 150 && red < 100 && alpha == 255, "{red} {blue} {alpha}");
}

mod bent {
    use frond_deform::{Bend, Continuity, Mesh, Roughness, Settings, Spin};

    use super::*;

    fn bend(aspect: f64, parts: usize, kb: f64, ke: f64, delta: f64, moves: &[DVec2]) -> Bend {
        let mesh = Mesh::new(DVec2::ZERO, DVec2::new(aspect, 1.0), 4, 4, moves.to_vec()).unwrap();
        let settings = Settings {
            kb,
            ke,
            roughness: Roughness::Constant(delta),
            spin: Spin::None,
            continuity: Continuity::Auto,
            superposed: true,
        };
        Bend::new(&Sheet::maps(aspect, parts), mesh, settings, None).unwrap()
    }

    fn moves(seed: u32, size: f64) -> Vec<DVec2> {
        let noise = |i: u32| f64::from(counter(seed, i) % 2001) / 1000.0 - 1.0;
        (0..16).map(|i| DVec2::new(noise(2 * i), noise(2 * i + 1)) * size).collect()
    }

    #[test]
    fn corners_go_where_the_bend_takes_them() {
        for seed in 0..60 {
            let number = |i: u32, low: f64, high: f64| {
                low + (high - low) * f64::from(counter(seed, i)) / 4_294_967_295.0
            };
            let (parts, aspect) = (2 + seed as usize % 2, number(90, 0.3, 3.0));
            let kb = number(91, 0.0, 4.0);
            let bend =
                bend(aspect, parts, kb, kb + number(92, 0.0, 3.0), number(93, 0.0, 1.2), &moves(seed, 0.2));
            let bent = BentSheet::new(&bend, aspect, parts, 81);
            let sheet = bent.sheet();
            let side = sheet.side();
            let (i, j) = (
                (number(94, 0.0, 1.0) * side as f64) as usize,
                (number(95, 0.0, 1.0) * side as f64) as usize,
            );
            // Letter by letter from the place at rest.
            let mut cursor = bend.whole();
            let mut z = DVec2::new(i as f64 / side as f64 * aspect, j as f64 / side as f64);
            while !bend.even(&cursor) {
                let digit = |t: f64| ((t * parts as f64 + 1e-9) as usize).min(parts - 1);
                let (dx, dy) = (digit(z.x / aspect), digit(z.y));
                cursor = bend.child(&cursor, dx + parts * dy);
                z = z * parts as f64 - DVec2::new(dx as f64 * aspect, dy as f64);
            }
            let wanted = bend.point(&cursor, z);
            let [fx, fy] = sheet.corners()[j * (side + 1) + i];
            let found = DVec2::new(f64::from(fx), f64::from(fy));
            assert!((found - wanted).length() < 1e-4, "{seed}: {found} {wanted} {side}");
        }
    }

    #[test]
    fn there_is_no_hole_at_any_locality_and_detail() {
        let photo = photo(64, 64);
        for parts in [2, 3] {
            for (kb, ke) in [(0.0, 0.0), (0.0, 5.0), (1.0, 5.0), (2.5, 4.5), (3.0, 3.0), (0.0, 12.0)] {
                // The rim of the mesh stays outside of what is looked at.
                let mut moves = moves(parts as u32, 0.15);
                for i in [0, 1, 2, 3, 4, 7, 8, 11, 12, 13, 14, 15] {
                    moves[i] = DVec2::ZERO;
                }
                let bent = BentSheet::new(&bend(1.0, parts, kb, ke, 0.6, &moves), 1.0, parts, 243);
                let view = Some(View { x: 0.5, y: 0.5, scale: 300.0 });
                let picture =
                    draw_sheet(&photo, bent.sheet(), &SheetOptions { view, ..options(120, 120, true) })
                        .unwrap();
                let holes = picture.chunks_exact(4).filter(|pixel| pixel[3] != 255).count();
                assert_eq!(holes, 0, "{parts} {kb} {ke}");
            }
        }
    }

    #[test]
    fn moving_the_mesh_is_making_it_anew() {
        let (first, second) = (moves(3, 0.2), moves(4, 0.2));
        let mut moved = BentSheet::new(&bend(1.4, 2, 1.0, 5.0, 0.7, &first), 1.4, 2, 128);
        let made = BentSheet::new(&bend(1.4, 2, 1.0, 5.0, 0.7, &second), 1.4, 2, 128);
        assert_ne!(moved.sheet(), made.sheet());
        moved.follow(&second);
        assert_eq!(moved.sheet(), made.sheet());
        moved.follow(&[]);
        assert_eq!(moved.sheet(), &Sheet::new(1.4, moved.sheet().side(), |p| p));
    }
}
