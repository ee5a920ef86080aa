//! Transforms that move z, too, as JWildfire and Apophysis have them.
//!
//! Besides `coefs`, of x and y, a transform may have `yzCoefs` of y and z and `zxCoefs` of x and z. JWildfire (class
//! `TransformationAffineFullStep`) applies the three matrices one after the other and then adds all shifts, which no
//! later matrix moves; in `zxCoefs` x stands first. The same holds for `post`, `yzPost` and `zxPost`. Between the two
//! are the functions: `linear3D` weighs x, y and z, `linear` z only where the flame says that it keeps it, `zscale` and
//! `ztranslate` are of z alone.

use glam::{DMat3, DVec3};

use crate::system::Row3;

/// Six numbers as they stand in a file: two columns, then the shift.
pub type Six = [f64; 6];

const SAME: Six = [1.0, 0.0, 0.0, 1.0, 0.0, 0.0];

/// The affine parts of a transform in its three planes, before the functions or after them.
#[derive(Clone, Copy, Default)]
pub struct Planes {
    pub xy: Option<Six>,
    pub yz: Option<Six>,
    pub zx: Option<Six>,
}

impl Planes {
    /// Whether any but the first says something.
    pub fn is_deep(&self) -> bool {
        [self.yz, self.zx].into_iter().flatten().any(|six| six != SAME)
    }

    /// Whether the order of the numbers of `zxCoefs` means anything.
    fn has_zx(&self) -> bool {
        self.zx.is_some_and(|six| six != SAME)
    }

    fn affine(&self, order: Order) -> (DMat3, DVec3) {
        let [xy, yz, zx] = [self.xy, self.yz, self.zx].map(|six| six.unwrap_or(SAME));
        let (third, [zx_x, zx_z]) = match order {
            Order::XFirst => (in_plane(zx, 0, 2), [zx[4], zx[5]]),
            Order::ZFirst => (in_plane(zx, 2, 0), [zx[5], zx[4]]),
        };
        let shift = DVec3::new(xy[4] + zx_x, xy[5] + yz[4], yz[5] + zx_z);
        (third * in_plane(yz, 1, 2) * in_plane(xy, 0, 1), shift)
    }
}

/// Which coordinate has the first numbers of `zxCoefs`: x in JWildfire, z where a program took it by its name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Order {
    XFirst,
    ZFirst,
}

fn in_plane([a, d, b, e, ..]: Six, first: usize, second: usize) -> DMat3 {
    let mut columns = DMat3::IDENTITY.to_cols_array_2d();
    columns[first][first] = a;
    columns[first][second] = d;
    columns[second][first] = b;
    columns[second][second] = e;
    DMat3::from_cols_array_2d(&columns)
}

/// What a transform does to z between its two affine parts.
#[derive(Clone, Copy)]
pub struct Depth {
    /// What z is multiplied by, then what is added to it, before the functions (`pre_zscale`, `pre_ztranslate`).
    pub before: [f64; 2],
    /// The weights of functions that take z along: always, and where the flame keeps z.
    pub always: f64,
    pub kept: f64,
    /// `ztranslate`.
    pub shift: f64,
    /// `flatten`.
    pub flat: bool,
}

impl Default for Depth {
    fn default() -> Self {
        Self { before: [1.0, 0.0], always: 0.0, kept: 0.0, shift: 0.0, flat: false }
    }
}

/// All that is needed to say what a transform does to space.
#[derive(Clone, Copy)]
pub struct Solid {
    pub before: Planes,
    pub after: Planes,
    pub depth: Depth,
    /// The weight of `linear` under all its names.
    pub linear: f64,
}

impl Solid {
    /// Whether the order of `zxCoefs` or `zxPost` means anything.
    pub fn has_zx(&self) -> bool {
        self.before.has_zx() || self.after.has_zx()
    }

    /// The map, y up; `keeps` where the flame keeps z under functions of the plane.
    pub fn row(&self, keeps: bool, order: Order) -> Row3 {
        let Depth { before, always, kept, shift, flat } = self.depth;
        let (first, first_shift) = self.before.affine(order);
        let (last, last_shift) = self.after.affine(order);
        let along = if flat { 0.0 } else { always + if keeps { kept } else { 0.0 } };
        let weights = DVec3::new(self.linear, self.linear, along);
        let pre = DVec3::new(1.0, 1.0, before[0]);
        let middle = DMat3::from_diagonal(weights * pre);
        let raised = DVec3::new(0.0, 0.0, along * before[1] + if flat { 0.0 } else { shift });
        // From the inside outward, as in the plane: no product is larger than there.
        let matrix = last * (middle * first);
        let moved = last * (middle * first_shift + raised) + last_shift;
        turned_over(&matrix, moved)
    }
}

/// The same map where y points the other way, by rows. Zeros keep no sign.
fn turned_over(matrix: &DMat3, shift: DVec3) -> Row3 {
    let up = |k: usize| if k == 1 { -1.0 } else { 1.0 };
    std::array::from_fn(|i| {
        let x = match i {
            9.. => up(i - 9) * shift[i - 9],
            _ => up(i / 3) * up(i % 3) * matrix.col(i % 3)[i / 3],
        };
        x + 0.0
    })
}

/// Whether maps leave the plane z = 0, where flames begin.
pub fn leaves_plane(rows: &[Row3]) -> bool {
    rows.iter().any(|row| [row[6], row[7], row[11]] != [0.0; 3])
}

/// What the maps do to x and y, which is all of it where these do not depend on z.
pub fn of_plane(row: &Row3) -> [f64; 6] {
    [row[0], row[1], row[3], row[4], row[9], row[10]]
}

/// Whether x and y depend on z.
pub fn mixes(rows: &[Row3]) -> bool {
    rows.iter().any(|row| [row[2], row[5]] != [0.0; 2])
}
