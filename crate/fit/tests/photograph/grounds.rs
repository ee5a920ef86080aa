//! What leaves lie on, and what they are painted with.

use frond_core::hash;
use glam::{DVec2, DVec3};

use super::{HEIGHT, Paint, WIDTH};

pub fn colour(r: f64, g: f64, b: f64) -> DVec3 {
    DVec3::new(r, g, b)
}

/// Smooth noise between -1 and 1 whose hills are so many pixels wide.
pub fn hills(seed: u32, at: DVec2, wide: DVec2) -> f64 {
    let p = at / wide + DVec2::splat(1000.0);
    let (cell, part) = (p.floor(), p.fract());
    let part = part * part * (DVec2::splat(3.0) - 2.0 * part);
    let corner = |x: f64, y: f64| {
        let i = (cell.x + x) as u32 + 4096 * (cell.y + y) as u32;
        2.0 * f64::from(hash::unit(hash::counter(seed, i))) - 1.0
    };
    let low = corner(0.0, 0.0) * (1.0 - part.x) + corner(1.0, 0.0) * part.x;
    let high = corner(0.0, 1.0) * (1.0 - part.x) + corner(1.0, 1.0) * part.x;
    low * (1.0 - part.y) + high * part.y
}

/// One colour, a little uneven.
pub fn plain(paint: DVec3) -> Paint {
    Box::new(move |at| paint * (1.0 + 0.02 * hills(3, at, DVec2::splat(5.0))))
}

/// Boards with long grain.
pub fn wood(light: DVec3, dark: DVec3) -> Paint {
    Box::new(move |at| {
        let bent = at.y + 9.0 * hills(5, at, DVec2::new(160.0, 60.0));
        let rings = 0.5 + 0.5 * (bent * 0.35 + 2.0 * hills(6, at, DVec2::new(90.0, 20.0))).sin();
        let fibre = 0.5 + 0.5 * hills(7, at, DVec2::new(30.0, 1.5));
        light.lerp(dark, (0.6 * rings + 0.4 * fibre).clamp(0.0, 1.0))
    })
}

/// Ruled paper.
pub fn ruled(paper: DVec3, rule: DVec3) -> Paint {
    Box::new(move |at| if at.y.rem_euclid(16.0) < 1.2 { rule } else { paper })
}

/// Earth with crumbs.
pub fn earth() -> Paint {
    Box::new(|at| {
        let crumbs = hills(11, at, DVec2::splat(4.0)) + 0.6 * hills(12, at, DVec2::splat(11.0));
        colour(0.07, 0.048, 0.03) * (1.0 + 0.55 * crumbs).max(0.15)
    })
}

/// Blades of grass, one over the other.
pub fn grass() -> Paint {
    let mut picture: Vec<DVec3> = (0..WIDTH * HEIGHT).map(|_| colour(0.02, 0.05, 0.012)).collect();
    for blade in 0..2600_u32 {
        let thrown = |k: u32| f64::from(hash::unit(hash::counter(31, 8 * blade + k)));
        let from = DVec2::new(thrown(0) * WIDTH as f64, (1.2 * thrown(1) - 0.2) * HEIGHT as f64);
        let way = DVec2::from_angle(1.57 + 1.6 * (thrown(2) - 0.5));
        let (long, wide, bright) = (25.0 + 45.0 * thrown(3), 1.2 + 1.8 * thrown(4), 0.4 + 0.9 * thrown(5));
        let green = colour(0.10 + 0.05 * thrown(6), 0.26, 0.045) * bright;
        for step in 0..(2.0 * long) as usize {
            let along = step as f64 / 2.0;
            let at = from + way * along + way.perp() * (0.006 * along * along * (thrown(7) - 0.5));
            let half = wide * (1.0 - along / long).max(0.2) / 2.0;
            for side in [-1.0, -0.5, 0.0, 0.5, 1.0] {
                let p = at + way.perp() * half * side;
                if p.x >= 0.0 && p.y >= 0.0 && p.x < WIDTH as f64 && p.y < HEIGHT as f64 {
                    picture[p.y as usize * WIDTH + p.x as usize] = green * (1.0 - 0.25 * side);
                }
            }
        }
    }
    Box::new(move |at| {
        let (x, y) = (at.x.clamp(0.0, WIDTH as f64 - 1.0), at.y.clamp(0.0, HEIGHT as f64 - 1.0));
        picture[y as usize * WIDTH + x as usize]
    })
}

/// A blade with a midrib and veins from `base` to `tip`, lighter where they are.
pub fn blade(paint: DVec3, base: DVec2, tip: DVec2) -> Paint {
    let (way, long) = ((tip - base).normalize(), (tip - base).length());
    Box::new(move |at| {
        let (along, off) = ((at - base).dot(way), (at - base).perp_dot(way).abs());
        let rib = (-(off / 1.6).powi(2)).exp();
        let side = ((along - 0.8 * off).rem_euclid(0.16 * long) / 1.3 - 1.0).powi(2);
        let veins = 0.5 * (-side).exp();
        let shade = 1.0 + 0.13 * hills(21, at, DVec2::splat(24.0)) + 0.05 * hills(22, at, DVec2::splat(4.0));
        paint * shade * (1.0 + 0.45 * rib.max(veins))
    })
}

/// Skin.
pub fn skin() -> Paint {
    Box::new(|at| colour(0.52, 0.28, 0.19) * (1.0 + 0.12 * hills(41, at, DVec2::splat(18.0))))
}

/// A finger: from one end to the other, so thick.
pub fn finger(from: DVec2, to: DVec2, thick: f64) -> Vec<DVec2> {
    let way = (to - from).normalize();
    let round = |middle: DVec2, begin: f64| {
        (0..=12).map(move |k| {
            middle + way.rotate(DVec2::from_angle(begin + std::f64::consts::PI * f64::from(k) / 12.0)) * thick
        })
    };
    round(to, -std::f64::consts::FRAC_PI_2).chain(round(from, std::f64::consts::FRAC_PI_2)).collect()
}
