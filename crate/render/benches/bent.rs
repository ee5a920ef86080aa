//! What drawing a bent gasket costs: `cargo bench -p frond-render --bench bent`. Times in one run are compared with
//! each other, not with those of other machines.

use std::time::Instant;

use frond_core::{Affine2, Hull, Ifs};
use frond_deform::{Bend, Continuity, Mesh, Roughness, Settings, Spin};
use frond_render::bent::{AnchorError, Bent, BentPlan, Cut, Fineness, Moving};
use frond_render::{Detail, Frame, View, Window};
use glam::DVec2;

const WINDOW: Window = Window { width: 1000, height: 800 };
const TARGET: Window = Window { width: 2000, height: 1600 };

/// The middle of the hypotenuse, lifted.
fn mesh(by: f64) -> Mesh {
    let lifted = |i| if [5, 6, 9, 10].contains(&i) { DVec2::splat(by) } else { DVec2::ZERO };
    Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, (0..16).map(lifted).collect()).expect("a mesh")
}

/// The least time of some runs, in milliseconds.
fn least<T>(runs: usize, mut run: impl FnMut() -> T) -> (f64, T) {
    let mut once = || {
        let start = Instant::now();
        let made = run();
        (start.elapsed().as_secs_f64() * 1e3, made)
    };
    (1..runs).fold(once(), |best, _| {
        let next = once();
        if next.0 < best.0 { next } else { best }
    })
}

fn main() {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
    let maps = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
    let ifs = Ifs::new(maps.to_vec()).expect("a gasket");
    let hull = Hull::of(&ifs);
    let frame = Frame::within(&ifs, &hull);
    let view = View::fit(&hull, WINDOW.width, WINDOW.height, 0.1);
    let mut moving_at_nine = 0.0;
    for (ke, delta) in [(9.0, 0.5), (9.0, 0.75), (12.0, 0.5), (12.0, 0.75)] {
        let settings = Settings {
            kb: 0.0,
            ke,
            roughness: Roughness::Constant(delta),
            spin: Spin::None,
            continuity: Continuity::Auto,
            superposed: true,
        };
        let (made, bend) = least(3, || Bend::new(&maps, mesh(0.3), settings, None).expect("a bend"));
        let anchor_error = AnchorError::of(&frame, &bend);
        let bent = Bent::new(&frame, &bend, &anchor_error, (view, WINDOW), (TARGET, 2.0));
        let (planned, rest) = least(3, || {
            let mut plan = BentPlan::default();
            plan.begin(&bent, 600_000, false);
            plan.run(&bent, &Fineness::complete(64.0), u64::MAX, None);
            plan.compose(&frame, Detail::LADDER[0]);
            plan
        });
        println!(
            "gasket ke {ke} delta {delta}: at rest {} pieces, {} points, {:.1} bytes a point; made in {made:.0} ms, \
             planned in {planned:.0} ms{}",
            rest.plan.instances.len(),
            rest.plan.points(),
            rest.bytes_a_point(),
            if rest.plan.exact { "" } else { ", rough" },
        );
        if ke > 9.0 {
            continue;
        }
        let (mut plan, mut moving) = (BentPlan::default(), Moving::default());
        let fineness =
            Fineness { floor: 2.0, margin: Some(500.0), tolerance: 0.25, ..Fineness::complete(32.0) };
        plan.begin(&bent, 24_000, false);
        assert_ne!(plan.run(&bent, &fineness, u64::MAX, Some(&mut moving)), Cut::TooMany);
        let moved = mesh(0.35);
        let (first, ()) = least(1, || plan.follow(&bent, moved.displacements(), &mut moving));
        let (each, ()) = least(10, || {
            plan.follow(&bent, moved.displacements(), &mut moving);
            plan.compose(&frame, Detail::LADDER[0]);
        });
        moving_at_nine = each;
        println!(
            "  moving: {} pieces, {} points, {:.1} bytes a point; {each:.1} ms a frame, the first {first:.0} ms; {:.1} \
             times as fast as planning anew",
            plan.plan.instances.len(),
            plan.plan.points(),
            plan.bytes_a_point() + moving.bytes() as f64 / plan.plan.points() as f64,
            planned / each,
        );
    }
    println!("a frame of moving at ke 9 takes {:.0}% of one at 60 a second", moving_at_nine / 16.7 * 100.0);
}
