//! What pictures of space cost on one processor: `cargo bench -p frond-render --bench solid`. Times in one run are
//! compared with each other, not with those of other machines.

use std::sync::LazyLock;
use std::time::Instant;

use frond_core::{Affine3, Colouring, Ifs3};
use frond_deform::{Bend3, Mesh3, Settings3, Spin};
use frond_render::solid::{Bent, Camera, Lamp, Lighting, Objects, light};
use frond_render::{Colours, solid::DepthBuffer};
use frond_scene::{Space, SpaceObject, natural_objects, preset3};
use glam::DVec3;

const SIZES: [[u32; 2]; 4] = [[225, 150], [450, 300], [900, 600], [1800, 1200]];
const PALETTE: [[u8; 3]; 3] = [[200, 90, 60], [60, 140, 90], [70, 90, 180]];

/// Seconds of this thread, where the system tells: others may have their turn meanwhile.
fn now() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let spent = told.and_then(|told| told.split(' ').next()?.parse::<f64>().ok());
    spent.map_or_else(|| START.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

/// What a run takes on the average of as many as fit half a second, in milliseconds.
fn time<T>(mut run: impl FnMut() -> T) -> (f64, T) {
    let start = now();
    let mut made = run();
    let mut runs = 1.0;
    while now() - start < 0.5 {
        made = run();
        runs += 1.0;
    }
    ((now() - start) * 1e3 / runs, made)
}

/// The objects and the camera of a space as a visitor sees it first, and once more from a little farther round.
fn of_space(space: &Space) -> (Objects, [Camera; 2]) {
    let systems =
        space.objects.iter().map(|object| object.shape.ifs().expect("a system")).collect::<Vec<_>>();
    let count = systems.len();
    let objects = Objects::new(systems, vec![None; count], vec![None; count]);
    let view = space.whole_view();
    let camera = |more: f64| {
        let target = DVec3::from_array(view.target);
        Camera::around(target, view.distance, view.turn + more, view.tilt, view.angle).expect("a camera")
    };
    (objects, [camera(0.0), camera(0.02)])
}

fn bent_sponge() -> (Objects, [Camera; 2]) {
    let maps: Vec<Affine3> =
        preset3("sponge").expect("a shape").maps.into_iter().map(Affine3::from_row).collect();
    let ifs = Ifs3::new(maps.clone()).expect("a system");
    let mut moves = vec![DVec3::ZERO; 27];
    moves[26] = DVec3::new(0.25, 0.1, 0.3);
    moves[4] = DVec3::new(-0.15, 0.1, -0.2);
    let mesh = Mesh3::new(DVec3::ZERO, DVec3::ONE, [3; 3], moves).expect("a mesh");
    let settings = Settings3 { kb: 0.5, ke: 3.0, roughness: 0.5, spin: Spin::Orthogonal, raw: false };
    let bend = Bend3::new(&maps, mesh, settings, None).expect("a bend");
    let bent = Bent::new(ifs.clone(), bend, Affine3::IDENTITY);
    let objects = Objects::new(vec![ifs], vec![None], vec![Some(bent)]);
    let camera = |turn: f64| {
        let (centre, radius) = (objects.centre(), objects.radius());
        Camera::around(centre, 3.1 * radius, turn, 0.42, 0.7).expect("a camera")
    };
    let cameras = [camera(0.5), camera(0.52)];
    (objects, cameras)
}

/// What two pictures have in common if they are the same.
fn mark(buffer: &DepthBuffer) -> u64 {
    let pairs = buffer.depth().iter().zip(buffer.codes());
    pairs.fold(0xcbf2_9ce4_8422_2325, |mark, (depth, code)| {
        (mark ^ u64::from(depth.to_bits()) ^ u64::from(*code) << 32).wrapping_mul(0x100_0000_01b3)
    })
}

fn main() {
    let only = std::env::args().skip(1).find(|word| !word.starts_with('-'));
    let one = |id: &str| {
        let object = SpaceObject::of_preset(id).expect("a shape");
        of_space(&Space { objects: vec![object], ..Space::default() })
    };
    let natural = || of_space(&Space { objects: natural_objects(), ..Space::default() });
    for id in ["sponge", "tetrahedron", "fern", "tree", "cloud", "natural", "bent sponge"] {
        if only.as_ref().is_some_and(|only| !id.contains(only.as_str())) {
            continue;
        }
        let (objects, cameras) = match id {
            "natural" => natural(),
            "bent sponge" => bent_sponge(),
            _ if preset3(id).is_none() => continue,
            _ => one(id),
        };
        for [width, height] in SIZES {
            let mut carving = Vec::new();
            let mut last = None;
            for camera in &cameras {
                let (took, traversal) = time(|| {
                    let mut traversal = objects.traversal(camera, width, height);
                    while !traversal.run(1_000_000) {}
                    traversal
                });
                carving.push(took);
                last = Some(traversal);
            }
            let traversal = last.expect("a picture");
            let buffer = traversal.depth_buffer();
            let lighting = objects.lit(Lighting::default());
            let lamp = Lamp::new(&lighting, &cameras[1], [width, height], 1, traversal.range());
            let colours = Colours::new(Colouring::Map, &PALETTE, 20);
            let (painted, _) = time(|| light(buffer, &lamp, &colours, None));
            println!(
                "{id} {width} x {height}: carved in {:.1} and {:.1} ms, painted in {painted:.1} ms; {} pixels lit, {:x}",
                carving[0],
                carving[1],
                buffer.lit(),
                mark(buffer),
            );
        }
    }
}
