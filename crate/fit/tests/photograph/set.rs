//! The twenty photographs.

use frond_fit::{maple_leaf, oak_leaf};
use glam::{DVec2, DVec3};

use super::grounds::{blade, colour, earth, finger, grass, hills, plain, ruled, skin, wood};
use super::{Paint, Photograph, Scene, Thing, flaws};

const GREEN: DVec3 = DVec3::new(0.065, 0.16, 0.03);
const DARK: DVec3 = DVec3::new(0.025, 0.075, 0.018);
const RED: DVec3 = DVec3::new(0.33, 0.035, 0.025);
const YELLOW: DVec3 = DVec3::new(0.56, 0.40, 0.05);
const DESK: DVec3 = DVec3::new(0.66, 0.61, 0.53);

/// Towards the lower right, soft, and half of the light.
const SOFT: (DVec2, f64, f64) = (DVec2::new(16.0, -12.0), 6.0, 0.5);

/// A leaf so many pixels high with its middle there, turned.
fn placed(leaf: &[DVec2], middle: DVec2, high: f64, turn: f64) -> Vec<DVec2> {
    let (sin, cos) = turn.sin_cos();
    let turned = |p: &DVec2| DVec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
    leaf.iter().map(|p| middle + turned(p) * (0.5 * high)).collect()
}

fn thing(
    leaf: &[DVec2],
    middle: DVec2,
    high: f64,
    turn: f64,
    paint: DVec3,
    shadow: (DVec2, f64, f64),
) -> Thing {
    let up = DVec2::from_angle(turn + std::f64::consts::FRAC_PI_2) * (0.5 * high);
    let paint = blade(paint, middle - up, middle + up);
    Thing { outline: placed(leaf, middle, high, turn), paint, leaf: true, shadow }
}

fn on(ground: Paint, things: Vec<Thing>) -> Scene {
    Scene { ground, things, light: Box::new(|_| 1.0), glare: Box::new(|_| 0.0) }
}

const MIDDLE: DVec2 = DVec2::new(205.0, 165.0);

fn maple(paint: DVec3, shadow: (DVec2, f64, f64)) -> Thing {
    thing(&maple_leaf(3), MIDDLE, 230.0, 0.2, paint, shadow)
}

fn oak(paint: DVec3, shadow: (DVec2, f64, f64)) -> Thing {
    thing(&oak_leaf(5), MIDDLE, 250.0, -0.9, paint, shadow)
}

fn sharp(colours: &mut [DVec3]) {
    flaws::noise(colours, 0.008);
}

pub fn all() -> Vec<Photograph> {
    on_desks().into_iter().chain(on_rough_grounds()).chain(many()).chain(badly_taken()).collect()
}

fn on_desks() -> Vec<Photograph> {
    let mut lamp = on(plain(DESK), vec![maple(GREEN, (DVec2::new(22.0, 10.0), 9.0, 0.62))]);
    lamp.light = Box::new(|at| 1.25 - 0.0019 * at.x);
    let deep = (DVec2::new(20.0, -16.0), 5.0, 0.75);
    let long = (DVec2::new(34.0, -20.0), 4.0, 0.7);
    vec![
        on(plain(DESK), vec![maple(GREEN, SOFT)]).photograph("pale desk, soft shadow", sharp),
        on(plain(DESK), vec![oak(DARK, long)]).photograph("pale desk, deep long shadow", sharp),
        lamp.photograph("lamp from the left", sharp),
        on(plain(colour(0.5, 0.5, 0.51)), vec![oak(colour(0.13, 0.1, 0.07), deep)])
            .photograph("dry leaf on grey, deep shadow", sharp),
        on(ruled(colour(0.78, 0.77, 0.72), colour(0.35, 0.45, 0.7)), vec![maple(GREEN, SOFT)])
            .photograph("ruled paper, shadow", sharp),
    ]
}

fn on_rough_grounds() -> Vec<Photograph> {
    let pale = || wood(colour(0.52, 0.36, 0.2), colour(0.36, 0.22, 0.11));
    let dark = || wood(colour(0.12, 0.06, 0.03), colour(0.05, 0.024, 0.012));
    let pencil = Thing {
        outline: finger(DVec2::new(300.0, 40.0), DVec2::new(390.0, 280.0), 6.0),
        paint: plain(YELLOW),
        leaf: false,
        shadow: (DVec2::new(5.0, -4.0), 2.0, 0.5),
    };
    let brown = colour(0.24, 0.10, 0.035);
    vec![
        on(pale(), vec![maple(GREEN, SOFT)]).photograph("wood, shadow", sharp),
        on(dark(), vec![oak(YELLOW, SOFT)]).photograph("yellow on dark wood", sharp),
        on(pale(), vec![oak(brown, SOFT)]).photograph("brown on wood", sharp),
        on(earth(), vec![maple(RED, SOFT), pencil]).photograph("red on earth, with a pencil", sharp),
        on(grass(), vec![oak(YELLOW, SOFT)]).photograph("yellow on grass", sharp),
        on(grass(), vec![maple(colour(0.085, 0.2, 0.06), SOFT)]).photograph("green on grass", sharp),
    ]
}

fn many() -> Vec<Photograph> {
    let at = |x: f64, y: f64| MIDDLE + DVec2::new(x, y);
    let three = vec![
        thing(&maple_leaf(3), at(-105.0, 40.0), 150.0, 0.3, GREEN, SOFT),
        thing(&oak_leaf(5), at(95.0, 55.0), 150.0, -0.4, YELLOW, SOFT),
        thing(&maple_leaf(8), at(10.0, -75.0), 130.0, 2.6, RED, SOFT),
    ];
    let mut touching = vec![
        thing(&oak_leaf(5), at(78.0, 14.0), 210.0, -0.1, GREEN, SOFT),
        thing(&maple_leaf(3), at(-62.0, 0.0), 230.0, 0.3, GREEN, SOFT),
    ];
    touching[0].leaf = false;
    let mut held = vec![thing(&maple_leaf(3), MIDDLE + DVec2::new(0.0, 20.0), 220.0, 0.0, GREEN, SOFT)];
    let (stalk, rim) = (MIDDLE + DVec2::new(12.0, -20.0), DVec2::new(330.0, -60.0));
    for (to, from) in [(stalk, rim), (stalk + DVec2::new(24.0, -14.0), rim + DVec2::new(50.0, 20.0))] {
        held.push(Thing {
            outline: finger(from, to, 17.0),
            paint: skin(),
            leaf: false,
            shadow: (DVec2::new(6.0, -5.0), 3.0, 0.4),
        });
    }
    let to_rim = thing(&maple_leaf(3), DVec2::new(260.0, 150.0), 400.0, 1.9, GREEN, SOFT);
    vec![
        on(plain(DESK), three).photograph("three leaves", sharp),
        on(plain(DESK), touching).photograph("two that touch, one meant", sharp),
        on(plain(DESK), held).photograph("held by a hand", sharp),
        on(plain(DESK), vec![to_rim]).photograph("reaching the rim", sharp),
    ]
}

fn badly_taken() -> Vec<Photograph> {
    let mut shining = on(plain(DESK), vec![oak(GREEN, SOFT)]);
    shining.glare = Box::new(|at| {
        let hill = hills(51, at, DVec2::new(40.0, 26.0)) + 0.4 * hills(52, at, DVec2::splat(9.0));
        0.7 * ((hill - 0.25) / 0.5).clamp(0.0, 1.0)
    });
    let mut corners = on(plain(DESK), vec![maple(GREEN, SOFT)]);
    corners.light = Box::new(|at| 1.1 / (1.0 + ((at - MIDDLE).length() / 230.0).powi(4)));
    vec![
        shining.photograph("glare", sharp),
        corners.photograph("dark corners", sharp),
        on(plain(DESK), vec![oak(GREEN, SOFT)]).photograph("noise", |c| flaws::noise(c, 0.07)),
        on(plain(DESK), vec![maple(GREEN, SOFT)]).photograph("JPEG blocks", |c| {
            flaws::noise(c, 0.01);
            flaws::blocks(c, 0.06);
        }),
        on(plain(DESK), vec![oak(colour(0.5, 0.54, 0.38), SOFT)]).photograph("low contrast", sharp),
    ]
}
