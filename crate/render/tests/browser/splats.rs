//! The points that the card computes: the same pixels as the processor's, bit for bit.

use frond_core::{Affine2, Hull, Ifs};
use frond_render::gpu::Wanted;
use frond_render::{Code, Frame, Splats, View, Window};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::card::picture_of;
use crate::render::{PLENTY, assert_no_fault, shape, stage};

/// Shapes of the gallery, flat ones and ones of singular maps among them, seen whole and closely, small and large.
#[wasm_bindgen_test(unsupported = pollster::test)]
async fn computed_codes_are_those_of_the_processor_bit_for_bit() {
    let (mut stage, events) = stage(Wanted::WebGpu, false).await;
    let gallery = frond_scene::presets()
        .into_iter()
        .step_by(3)
        .map(|preset| Ifs::new(preset.maps.into_iter().map(Affine2::from_row).collect()).unwrap());
    let own = ["gasket", "dragon", "fern"].map(shape);
    let flat = Ifs::new(vec![
        Affine2::from_row([0.5, 0.0, 0.2, 0.0, 0.0, 0.0]),
        Affine2::from_row([0.4, 0.3, 0.0, 0.0, 0.5, 0.3]),
        Affine2::from_row([0.0, 0.1, 0.0, 0.6, 0.1, 0.4]),
    ]);
    let mut lit = 0;
    for (number, ifs) in gallery.chain(own).chain([flat.unwrap()]).enumerate() {
        let hull = Hull::of(&ifs);
        let frame = Frame::within(&ifs, &hull);
        let at = frame.to_world.apply(frame.anchor);
        for window in [Window { width: 150, height: 100 }, Window { width: 333, height: 257 }] {
            let whole = View::fit(&hull, window.width, window.height, 0.05);
            for view in [whole, View { x: at.x, y: at.y, scale: 40.0 * whole.scale }] {
                stage.resize(window.width, window.height, 2.0);
                stage.set_ifs(&ifs);
                assert!(stage.set_view(view));
                stage.draw(PLENTY);
                let splats = Splats::draw(&frame, view.onto_screen(frame.to_world, window), window, 0);
                // A card has more points to spare where pieces overlap.
                if !splats.whole {
                    continue;
                }
                let seen: Vec<u32> = bytemuck::pod_collect_to_vec(&picture_of(stage.read_codes()).await);
                let twin: Vec<u32> = splats.codes.into_iter().map(Code::code).collect();
                lit += twin.iter().filter(|code| **code > 0).count();
                let wrong = seen.iter().zip(&twin).filter(|(a, b)| a != b).count();
                assert!(
                    seen.len() == twin.len() && wrong == 0,
                    "shape {number}, {window:?}, {view:?}: {wrong} differ"
                );
            }
        }
    }
    assert!(lit > 200_000, "{lit}");
    assert_no_fault(&events);
}
