//! What the graphics card draws of space: the shaders against their twins, on both backends.

use frond_core::{Affine3, Colouring, Ifs3};
use frond_render::Colours;
use frond_render::gpu::{Event, Stage3, Uniforms3, Wanted};
use frond_render::solid::{
    Camera, Cloud, DepthBuffer, Eye, Lamp, Lighting, Paint, SplatStep, Traversal, fill_holes, light,
};
use glam::{DQuat, DVec3};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::card::{BACKENDS, card, picture_of};

const SIZE: [u32; 2] = [160, 120];
const POINTS: usize = 60_000;

async fn open(wanted: Wanted) -> Stage3 {
    let quiet = |event: &Event| assert!(!matches!(event, Event::Fault(_)), "{event:?}");
    Stage3::new(card(SIZE, wanted, quiet).await)
}

fn colours() -> Colours {
    Colours::new(Colouring::Address, &[], 4)
}

fn systems() -> Vec<Ifs3> {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let maps = corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, c * 0.5)).to_vec();
    let near = Ifs3::new(maps).unwrap();
    let far =
        near.conjugate(Affine3::similitude(0.7, DQuat::from_rotation_y(1.0), DVec3::new(0.6, 0.1, -1.0)));
    vec![near, far.unwrap()]
}

fn camera() -> Camera {
    Camera::around(DVec3::new(0.35, 0.3, 0.1), 2.6, 0.5, 0.4, 0.6).unwrap()
}

/// The share of pixels that differ by more than rounding.
fn differing(a: &[u8], b: &[u8]) -> f64 {
    assert_eq!(a.len(), b.len());
    let off = |(p, q): &(&[u8], &[u8])| p.iter().zip(*q).any(|(x, y)| x.abs_diff(*y) > 6);
    a.chunks(4).zip(b.chunks(4)).filter(off).count() as f64 / (a.len() / 4) as f64
}

fn lit(pixels: &[u8]) -> usize {
    pixels.chunks(4).filter(|p| p[3] > 0).count()
}

async fn pictures(wanted: Wanted) {
    let mut stage = open(wanted).await;
    let (systems, camera) = (systems(), camera());
    // Many points lie side by side, few are splatted.
    for (factor, paint, count) in [(1, Paint::Map, POINTS), (2, Paint::Height, POINTS / 100)] {
        let tints = vec![None, Some([0.9, 0.3, 0.2])];
        let lighting = Lighting { paint, heights: [0.0, 1.0], tints, ..Lighting::default() };
        let mut traversal = Traversal::new(&systems, &camera, SIZE[0] * factor, SIZE[1] * factor);
        let range = traversal.range();
        let eye = Eye::new(&camera, SIZE[0], SIZE[1], range);
        let size = SIZE.map(|side| side * factor);
        let lamp = Lamp::new(&lighting, &camera, SIZE, 1, range);
        let still_lamp = Lamp::new(&lighting, &camera, size, factor, range);
        let clouds: Vec<Cloud> = systems
            .iter()
            .enumerate()
            .map(|(number, ifs)| Cloud::new(ifs, number as u32, count / 2, 1 + number as u32))
            .collect();
        stage.resize(SIZE[0], SIZE[1]);
        stage.set_clouds(&clouds);
        stage.set_uniforms(Uniforms3 { eye, lamp, still_lamp, colours: colours() });

        let drawn = stage.draw();
        let right = !drawn.complete && (count as u64 / 2..=count as u64).contains(&drawn.points);
        assert!(right, "{wanted:?}, {factor}: {drawn:?}");
        let mut buffer = DepthBuffer::new(SIZE[0], SIZE[1]);
        for cloud in &clouds {
            for piece in &cloud.instances {
                cloud.vertices.iter().for_each(|point| eye.draw(&mut buffer, point, piece));
            }
        }
        let gaps: Vec<f32> = clouds.iter().map(|cloud| cloud.gap).collect();
        let steps = SplatStep::steps(lamp.size, lamp.focal, lamp.range[0], &gaps);
        assert_eq!(steps.is_empty(), count == POINTS, "{steps:?}");
        let splat = steps.iter().fold(buffer, |buffer, splat| splat.apply(&buffer));
        let twin = light(&fill_holes(&splat, eye.focal), &lamp, &colours(), None);
        let shown = picture_of(stage.read()).await;
        assert!(lit(&shown) > 2000 && lit(&shown) < shown.len() / 4, "{} lit", lit(&shown));
        // A point that rounding takes to the next pixel changes the light around it.
        assert!(differing(&shown, &twin) < 0.05, "{wanted:?}, points: {}", differing(&shown, &twin));

        assert!(traversal.run(usize::MAX));
        // One of another size is not taken.
        assert!(!stage.put_still(SIZE.map(|side| side + 1), &[], &[]));
        assert!(stage.put_still(size, traversal.depth_buffer().depth(), traversal.depth_buffer().codes()));
        assert!(stage.draw().complete);
        let twin = light(traversal.depth_buffer(), &still_lamp, &colours(), None);
        let shown = picture_of(stage.read()).await;
        assert!(differing(&shown, &twin) < 0.005, "{wanted:?}, complete: {}", differing(&shown, &twin));
        // Other light leaves it complete, another eye does not.
        let darker = Lamp::new(&Lighting { ambient: 0.1, ..lighting }, &camera, size, factor, range);
        stage.set_uniforms(Uniforms3 { eye, lamp, still_lamp: darker, colours: colours() });
        assert!(stage.draw().complete);
        let moved = Eye { focal: eye.focal * 1.1, ..eye };
        stage.set_uniforms(Uniforms3 { eye: moved, lamp, still_lamp, colours: colours() });
        assert!(!stage.draw().complete);
    }
}

#[wasm_bindgen_test(unsupported = pollster::test)]
async fn the_card_draws_what_the_twins_draw() {
    for &wanted in BACKENDS {
        pictures(wanted).await;
    }
}
