//! Bent photographs: what the graphics card draws against what the processor does.

use std::cell::RefCell;
use std::rc::Rc;

use frond_core::Ifs;
use frond_deform::{Bend, Continuity, Mesh, Roughness, Settings, Spin};
use frond_render::gpu::{Event, Stage, Wanted};
use frond_render::{BentSheet, Photo, Sheet, SheetOptions, View, draw_sheet};
use glam::DVec2;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::card::{BACKENDS, card, picture_of, print};

const SIZE: (u32, u32) = (180, 120);

/// A photograph whose colours tell the place, with a corner that can be seen through.
fn bytes(width: u32, height: u32) -> Vec<u8> {
    let pixel = |i: u32| {
        let (x, y) = (i % width, i / width);
        let blue = if (x / 5 + y / 5) % 2 == 0 { 40 } else { 190 };
        let alpha = if x + y < 20 { 90 } else { 255 };
        [(x * 255 / width) as u8, (y * 255 / height) as u8, blue, alpha]
    };
    (0..width * height).flat_map(pixel).collect()
}

fn moves(size: f64) -> Vec<DVec2> {
    (0..16)
        .map(|i| DVec2::new(f64::from(i * 7 % 16) - 7.5, f64::from(i * 5 % 16) - 7.5) * size / 8.0)
        .collect()
}

fn bend(aspect: f64, parts: usize, kb: f64, ke: f64, size: f64) -> Bend {
    let mesh = Mesh::new(DVec2::ZERO, DVec2::new(aspect, 1.0), 4, 4, moves(size)).unwrap();
    let settings = Settings {
        kb,
        ke,
        roughness: Roughness::Constant(0.4),
        spin: Spin::None,
        continuity: Continuity::Auto,
        superposed: true,
    };
    Bend::new(&Sheet::maps(aspect, parts), mesh, settings, None).unwrap()
}

type Faults = Rc<RefCell<Vec<Event>>>;

/// A stage of the backend, and what goes wrong with it.
async fn stage(wanted: Wanted) -> (Stage, Faults) {
    let events = Faults::default();
    let heard = Rc::clone(&events);
    let gpu = card([SIZE.0, SIZE.1], wanted, move |event| heard.borrow_mut().push(event.clone())).await;
    (Stage::new(gpu), events)
}

fn settle(stage: &mut Stage) {
    for _ in 0..10 {
        let drawn = stage.draw(1_000_000);
        if drawn.settled {
            assert!(drawn.complete && drawn.points > 0);
            return;
        }
    }
    panic!("it does not come to an end");
}

/// The mean difference of bytes, and the share of pixels that are clearly others.
fn differences(a: &[u8], b: &[u8]) -> (f64, f64) {
    assert_eq!(a.len(), b.len());
    let sum: u64 = a.iter().zip(b).map(|(x, y)| u64::from(x.abs_diff(*y))).sum();
    let far = |(p, q): (&[u8; 4], &[u8; 4])| p.iter().zip(q).any(|(x, y)| x.abs_diff(*y) > 40);
    let others = a.as_chunks::<4>().0.iter().zip(b.as_chunks::<4>().0).filter(|pair| far(*pair)).count();
    (sum as f64 / a.len() as f64, others as f64 / (a.len() / 4) as f64)
}

/// What the stage shows must be what the processor draws.
async fn compare(stage: &mut Stage, photo: &Photo, sheet: &Sheet, view: View, what: &str) {
    settle(stage);
    let seen = picture_of(stage.read()).await;
    let options = SheetOptions { width: SIZE.0, height: SIZE.1, view: Some(view), smooth: true };
    let twin = draw_sheet(photo, sheet, &options).unwrap();
    let (mean, others) = differences(&seen, &twin);
    print(&format!("{what}: {mean:.3} a byte, {others:.4} of the pixels"));
    assert!(mean < 1.5 && others < 0.01, "{what}: {mean} {others}");
    let lit = |picture: &[u8]| picture.as_chunks::<4>().0.iter().filter(|p| p[3] > 0).count();
    assert!(lit(&seen).abs_diff(lit(&twin)) * 200 < lit(&twin).max(200), "{what}");
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn the_card_draws_what_the_processor_does() {
    let photo = Photo::new(&bytes(150, 100), 150, 100).unwrap();
    let aspect = photo.aspect();
    for &wanted in BACKENDS {
        let (mut stage, events) = stage(wanted).await;
        stage.resize(SIZE.0, SIZE.1, 1.0);
        stage.set_ifs(&Ifs::new(Sheet::maps(aspect, 2)).unwrap());
        stage.set_photo(Some(photo.clone()));
        let near = View { x: 0.75, y: 0.5, scale: 100.0 };
        assert!(stage.set_view(near));
        compare(&mut stage, &photo, &Sheet::at_rest(aspect), near, "at rest").await;
        for (parts, kb, ke) in [(2, 0.0, 4.0), (2, 1.0, 6.0), (3, 0.5, 3.0), (2, 5.0, 5.0)] {
            stage.set_ifs(&Ifs::new(Sheet::maps(aspect, parts)).unwrap());
            stage.set_bend(Some(bend(aspect, parts, kb, ke, 0.2)));
            let mut bent = BentSheet::new(&bend(aspect, parts, kb, ke, 0.2), aspect, parts, Sheet::FINEST);
            compare(&mut stage, &photo, bent.sheet(), near, &format!("{parts} {kb} {ke}")).await;
            // The mesh moves, and nothing else.
            assert!(stage.move_mesh(&moves(-0.1)));
            bent.follow(&moves(-0.1));
            compare(&mut stage, &photo, bent.sheet(), near, "moved").await;
            // Close, and so close that the card has not digits enough.
            for scale in [3e3, 1e8] {
                let close = View { x: 0.61, y: 0.43, scale };
                assert!(stage.set_view(close));
                compare(&mut stage, &photo, bent.sheet(), close, &format!("at {scale}")).await;
            }
            assert!(stage.set_view(near));
        }
        // Back to the attractor, which the bend still bends.
        stage.set_bend(None);
        stage.set_photo(None);
        let mut steps = 0;
        while !stage.draw(10_000_000).settled {
            steps += 1;
            assert!(steps < 1000);
        }
        let seen = picture_of(stage.read()).await;
        assert!(seen.as_chunks::<4>().0.iter().filter(|p| p[3] > 0).count() > 10_000);
        let faults = events.borrow();
        assert!(faults.is_empty(), "{faults:?}");
    }
}
