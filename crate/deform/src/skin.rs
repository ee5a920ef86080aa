//! Points that follow the mesh.

use glam::{DMat2, DVec2};

use crate::mesh::Mesh;

/// How much each control point of a mesh moves a point, as numbers to sum: displacements are linear in the mesh, so
/// that these numbers, shuffled once, serve for every position of its control points.
///
/// Two numbers `a`, `b` a control point, the displacement of which is `a d + b i d` (turned by a right angle); where
/// nothing turns all `b` are 0. Reflecting factors need two numbers more, for the mirror image of `d`.
#[derive(Clone, Debug)]
pub struct Pull<'a> {
    mesh: &'a Mesh,
    turns: Turns,
}

/// What may happen to the direction of a displacement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turns {
    /// It stays: one number a control point.
    None,
    /// It turns and shrinks: two.
    Conformal,
    /// It is changed by any matrix: four.
    Any,
}

impl Turns {
    /// Numbers a control point.
    #[must_use]
    pub const fn numbers(self) -> usize {
        match self {
            Self::None => 1,
            Self::Conformal => 2,
            Self::Any => 4,
        }
    }

    /// What these factors ask for.
    #[must_use]
    pub fn of(factors: &[DMat2]) -> Self {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12;
        let conformal = |m: &DMat2| near(m.x_axis.x, m.y_axis.y) && near(m.x_axis.y, -m.y_axis.x);
        if factors.iter().all(|m| *m == DMat2::IDENTITY) {
            Self::None
        } else if factors.iter().all(conformal) {
            Self::Conformal
        } else {
            Self::Any
        }
    }
}

impl<'a> Pull<'a> {
    /// The pull of the control points of a mesh, wherever they are.
    #[must_use]
    pub const fn new(mesh: &'a Mesh, turns: Turns) -> Self {
        Self { mesh, turns }
    }

    /// How many numbers.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.mesh.columns() * self.mesh.rows() * self.turns.numbers()
    }

    /// Adds `weight` times the pull at `point`, turned by `factor`, to `sum`.
    pub fn add(&self, point: DVec2, factor: DMat2, weight: f64, sum: &mut [f64]) {
        let (x, y) = (factor.x_axis, factor.y_axis);
        // A matrix is a turn with a stretch plus a mirror image with a stretch.
        let parts = [x.x + y.y, x.y - y.x, x.x - y.y, x.y + y.x].map(|part| 0.5 * part * weight);
        let numbers = self.turns.numbers();
        self.mesh.blend(point, |i, share| {
            for (slot, part) in sum[i * numbers..(i + 1) * numbers].iter_mut().zip(parts) {
                *slot += part * share;
            }
        });
    }
}

/// Points together in one block: as many as a vector register or two hold.
const LANES: usize = 8;

/// Points and how they follow a mesh: moving the mesh costs a weighted sum over its control points for each,
/// however deep and rough the shuffle is.
#[derive(Clone, Debug)]
pub struct Skin {
    turns: Turns,
    controls: usize,
    count: usize,
    /// Where the points are at rest, in blocks: all x, then all y.
    rest: Vec<[[f32; LANES]; 2]>,
    /// In blocks: for each number of each control point, that of each lane.
    pulls: Vec<[f32; LANES]>,
}

impl Skin {
    /// No points, following a mesh of so many control points.
    #[must_use]
    pub const fn new(controls: usize, turns: Turns) -> Self {
        Self { turns, controls, count: 0, rest: Vec::new(), pulls: Vec::new() }
    }

    /// Adds a point with what [`Pull`] gives it. Numbers that are missing are 0.
    pub fn push(&mut self, point: DVec2, pull: &[f64]) {
        let width = self.controls * self.turns.numbers();
        let lane = self.count % LANES;
        if lane == 0 {
            self.rest.push([[0.0; LANES]; 2]);
            self.pulls.resize(self.pulls.len() + width, [0.0; LANES]);
        }
        let block = self.count / LANES;
        let [xs, ys] = &mut self.rest[block];
        (xs[lane], ys[lane]) = (point.x as f32, point.y as f32);
        for (slot, &number) in self.pulls[block * width..].iter_mut().zip(pull) {
            slot[lane] = number as f32;
        }
        self.count += 1;
    }

    /// How many points there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.count
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Bytes that each point takes.
    #[must_use]
    pub const fn bytes(&self) -> usize {
        4 * (2 + self.controls * self.turns.numbers())
    }

    /// Where the points are when the control points are displaced so: x0, y0, x1, y1, .. into `out`, as far as it
    /// reaches. Displacements that are missing are 0.
    pub fn follow(&self, displacements: &[DVec2], out: &mut [f32]) {
        let numbers = self.turns.numbers();
        let width = self.controls * numbers;
        // What one number of one control point adds to x and y.
        let mut moves = vec![[0.0_f32; 2]; width];
        for (slots, d) in moves.chunks_exact_mut(numbers.max(1)).zip(displacements) {
            let (x, y) = (d.x as f32, d.y as f32);
            for (slot, step) in slots.iter_mut().zip([[x, y], [-y, x], [x, -y], [y, x]]) {
                *slot = step;
            }
        }
        let blocks = self.rest.iter().zip(self.pulls.chunks_exact(width.max(1)));
        for (([xs, ys], pulls), out) in blocks.zip(out.chunks_mut(2 * LANES)) {
            let (mut x, mut y) = (*xs, *ys);
            for (pull, step) in pulls.iter().zip(&moves) {
                for lane in 0..LANES {
                    x[lane] += pull[lane] * step[0];
                    y[lane] += pull[lane] * step[1];
                }
            }
            for (pair, (x, y)) in out.chunks_exact_mut(2).zip(x.into_iter().zip(y)) {
                pair.copy_from_slice(&[x, y]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use frond_core::Affine2;
    use proptest::prelude::*;

    use super::*;
    use crate::{Field, Place, Spin, weights};

    /// What eq 18 gives a place, as pulls.
    fn pull_of(
        maps: &[Affine2],
        mesh: &Mesh,
        spin: Spin,
        depths: (usize, usize, f64),
        place: Place<'_>,
    ) -> Vec<f64> {
        let factors: Vec<DMat2> = maps.iter().map(|map| spin.factor(map)).collect();
        let pull = Pull::new(mesh, Turns::of(&factors));
        let field = Field::new(maps, mesh, spin);
        let mut sum = vec![0.0; pull.width()];
        let (kb, ke, delta) = depths;
        for (k, weight) in (kb..).zip(weights(delta, kb, ke)) {
            let mut moved = place.code.to_vec();
            crate::shuffle(&mut moved, kb, k);
            let factor = place.code[kb..k].iter().fold(DMat2::IDENTITY, |m, &i| m * factors[usize::from(i)]);
            pull.add(field.position(Place { code: &moved, ..place }), factor, weight, &mut sum);
        }
        sum
    }

    fn fern() -> Vec<Affine2> {
        [
            [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
            [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
            [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
            [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
        ]
        .map(Affine2::from_row)
        .to_vec()
    }

    proptest! {
        #[test]
        fn a_skin_follows_any_mesh_as_the_formula_does(
            code in proptest::collection::vec(0..4_u8, 6), kb in 0..4_usize, more in 0..3_usize, delta in 0.0..1.5_f64,
            list in proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 16), others in 0..20_usize,
            spin in proptest::sample::select(vec![Spin::None, Spin::Orthogonal, Spin::Rotation, Spin::Scaled]),
        ) {
            let maps = fern();
            let list: Vec<DVec2> = list.into_iter().map(DVec2::from).collect();
            let (min, max) = (DVec2::new(-3.0, 0.0), DVec2::new(3.0, 10.2));
            let mesh = Mesh::new(min, max, 4, 4, list.clone()).unwrap();
            let place = Place { code: &code, tail: DVec2::new(0.1, 2.0) };
            let at = Field::new(&maps, &mesh, spin).position(place);
            let pull = pull_of(&maps, &mesh, spin, (kb, kb + more, delta), place);
            let mut skin = Skin::new(16, Turns::of(&maps.iter().map(|map| spin.factor(map)).collect::<Vec<_>>()));
            // Whatever block and lane it falls into.
            (0..others).for_each(|_| skin.push(DVec2::ONE, &[]));
            skin.push(at, &pull);
            let mut out = vec![f32::NAN; 2 * skin.len()];
            skin.follow(&list, &mut out);
            let found = DVec2::new(f64::from(out[2 * others]), f64::from(out[2 * others + 1]));
            let wanted = at + Field::new(&maps, &mesh, spin).superposed(kb, kb + more, delta, place);
            prop_assert!((found - wanted).length() < 1e-4, "{found} {wanted}");
            prop_assert!(others == 0 || out[..2] == [1.0, 1.0]);
        }
    }

    #[test]
    fn sixteen_weights_fit_eighty_bytes() {
        assert_eq!(Skin::new(16, Turns::None).bytes(), 72);
        let rigid = [DMat2::from_angle(0.3), DMat2::IDENTITY];
        assert_eq!(Turns::of(&rigid), Turns::Conformal);
        assert_eq!(Turns::of(&[DMat2::from_diagonal(DVec2::new(1.0, -1.0))]), Turns::Any);
        let mut none = [7.0];
        Skin::new(0, Turns::None).follow(&[], &mut none);
        assert_eq!(none, [7.0]);
    }
}
