//! The work for the bench of the skin: points of the gasket under a mesh of four by four, ke = 9.

use std::cell::RefCell;

use frond_core::{Affine2, hash};
use frond_deform::{
    Bend, Continuity, Cursor, Field, Mesh, Place, Pull, Roughness, Settings, Skin, Spin, Turns,
};
use glam::{DMat2, DVec2};

const KE: usize = 9;
const DELTA: f64 = 0.75;

struct Work {
    skin: Skin,
    out: Vec<f32>,
}

thread_local! {
    static WORK: RefCell<Option<Work>> = const { RefCell::new(None) };
}

fn maps() -> [Affine2; 3] {
    [DVec2::ZERO, DVec2::X, DVec2::Y].map(|c| Affine2::similitude(0.5, 0.0, c * 0.5))
}

fn moves(by: f64) -> Vec<DVec2> {
    (0..16).map(|i| DVec2::splat(by * f64::from(i))).collect()
}

fn mesh() -> Mesh {
    Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, moves(0.02)).expect("a mesh")
}

fn code(i: u32) -> [u8; KE] {
    std::array::from_fn(|k| (hash::counter(i, k as u32) % 3) as u8)
}

/// Makes so many points that follow the mesh.
#[unsafe(no_mangle)]
pub extern "C" fn prepare(count: u32) {
    let (maps, mesh) = (maps(), mesh());
    let field = Field::new(&maps, &mesh, Spin::None);
    let pull = Pull::new(&mesh, Turns::None);
    let mut skin = Skin::new(16, Turns::None);
    for i in 0..count {
        let point = field.position(Place { code: &code(i), tail: DVec2::splat(1.0 / 3.0) });
        let mut sum = [0.0; 16];
        pull.add(point, DMat2::IDENTITY, 1.0, &mut sum);
        skin.push(point, &sum);
    }
    let out = vec![0.0; 2 * count as usize];
    WORK.with_borrow_mut(|work| *work = Some(Work { skin, out }));
}

/// Moves the mesh, and all points with it.
#[unsafe(no_mangle)]
pub extern "C" fn follow(by: f64) -> f32 {
    WORK.with_borrow_mut(|work| {
        let Some(Work { skin, out }) = work else { return 0.0 };
        skin.follow(&moves(by), out);
        out[out.len() / 2]
    })
}

/// The same for so many points by the formula, one at a time (eq 18).
#[unsafe(no_mangle)]
pub extern "C" fn formula(count: u32) -> f64 {
    let (maps, mesh) = (maps(), mesh());
    let field = Field::new(&maps, &mesh, Spin::None);
    let at = |i| field.superposed(0, KE, DELTA, Place { code: &code(i), tail: DVec2::splat(1.0 / 3.0) });
    (0..count).map(at).sum::<DVec2>().x
}

/// All cells down to `ke` letters, through the word tree.
#[unsafe(no_mangle)]
pub extern "C" fn tree(ke: u32) -> f64 {
    let settings = Settings {
        kb: 0.0,
        ke: f64::from(ke),
        roughness: Roughness::Constant(DELTA),
        spin: Spin::None,
        continuity: Continuity::Corners,
        superposed: true,
    };
    let Ok(bend) = Bend::new(&maps(), mesh(), settings, None) else { return f64::NAN };
    walk(&bend, &bend.whole(), ke).x
}

/// Where the corners of all cells go, in sum.
fn walk(bend: &Bend, cursor: &Cursor, letters: u32) -> DVec2 {
    if letters == 0 {
        return bend.displaced(cursor).into_iter().take(3).sum();
    }
    (0..3).map(|letter| walk(bend, &bend.child(cursor, letter), letters - 1)).sum()
}
