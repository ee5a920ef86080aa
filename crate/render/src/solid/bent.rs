//! Shapes of space that are bent: what is drawn of them.

use std::sync::Arc;

use frond_core::{Affine3, Bounds3, ChaosGame3, Ifs3, adaptive_cut3};
use frond_deform::{Bend3, Piece3};
use glam::DVec3;

use super::points::{Cloud, Instance3, OBJECT_BIT, Vertex3, gap, rows};
use crate::pieces::letters::Letters;

/// A bent shape in its place.
#[derive(Clone, Debug)]
pub struct Bent {
    ifs: Arc<Ifs3>,
    bend: Arc<Bend3>,
    place: Affine3,
}

/// The fewest points of a piece.
const FEWEST_PIECE_POINTS: usize = 32;
/// The most pieces: each is placed anew in every frame while the mesh moves.
const MOST_PIECES: usize = 1 << 14;
/// Pieces that tell where all of it lies.
const PIECES_BOUNDED: usize = 2000;

impl Bent {
    /// The bend of `ifs`, and what is done to the bent shape.
    #[must_use]
    pub fn new(ifs: Ifs3, bend: Bend3, place: Affine3) -> Self {
        Self { ifs: Arc::new(ifs), bend: Arc::new(bend), place }
    }

    /// The bend.
    #[must_use]
    pub fn bend(&self) -> &Bend3 {
        &self.bend
    }

    /// The shape before it is bent.
    pub(super) fn ifs(&self) -> &Ifs3 {
        &self.ifs
    }

    /// The same in other coordinates.
    pub(super) fn moved(&self, by: Affine3) -> Self {
        Self { place: by * self.place, ..self.clone() }
    }

    /// What takes the bent shape to where it is seen from a camera.
    pub(super) fn place(&self) -> Affine3 {
        self.place
    }

    /// The number of maps.
    pub(super) fn maps(&self) -> usize {
        self.ifs.len()
    }

    /// Where all of it lies: a ball around balls that hold its pieces.
    pub(super) fn bounds(&self) -> Bounds3 {
        let stretch = self.place.stretch();
        let ball = |piece: &Piece3| {
            let (centre, radius) = self.bend.ball(piece);
            (self.place.apply(centre), radius * stretch)
        };
        let mut pieces = vec![self.bend.whole()];
        while pieces.len() * self.maps() <= PIECES_BOUNDED && self.maps() > 1 {
            pieces = pieces.iter().flat_map(|piece| self.parts(piece)).collect();
        }
        let balls: Vec<(DVec3, f64)> = pieces.iter().map(ball).collect();
        let min = balls.iter().map(|(c, r)| *c - *r).fold(DVec3::INFINITY, DVec3::min);
        let max = balls.iter().map(|(c, r)| *c + *r).fold(DVec3::NEG_INFINITY, DVec3::max);
        let centre = 0.5 * (min + max);
        let radius = balls.iter().map(|(c, r)| c.distance(centre) + r).fold(0.0, f64::max);
        Bounds3 { min, max, centre, radius, diameter: (2.0 * radius).min((max - min).length()) }
    }

    fn parts(&self, piece: &Piece3) -> impl Iterator<Item = Piece3> {
        (0..self.maps()).map(|letter| self.bend.child(piece, letter))
    }

    /// About `count` points of it as object `number`, from a seed: one cloud of the unbent shape, placed by pieces that
    /// go where the bend takes them. Inside of them the bend is taken as affine.
    pub(super) fn cloud(&self, number: u32, count: usize, seed: u32) -> Cloud {
        let pieces = self.pieces((count / FEWEST_PIECE_POINTS).min(MOST_PIECES));
        let share = (count / pieces.len().max(1)).max(1);
        let mut positions = vec![0.0_f32; 3 * share];
        let mut letters = vec![0_u8; share];
        let made = ChaosGame3::new(&self.ifs, seed).fill(&mut positions, &mut letters);
        let vertices: Vec<Vertex3> = positions
            .chunks_exact(3)
            .zip(&letters)
            .take(made)
            .map(|(p, &letter)| Vertex3 {
                position: [p[0], p[1], p[2]],
                letters: Letters::NONE.then(usize::from(letter)).packed(),
            })
            .collect();
        let instance = |(piece, letters): &(Piece3, Letters)| Instance3 {
            rows: rows(&(self.place * self.bend.frame(piece))),
            letters: letters.packed() | u32::from(letters.count()) << OBJECT_BIT,
            object: number << OBJECT_BIT,
        };
        let instances: Vec<Instance3> = pieces.iter().map(instance).collect();
        let gap = gap(&self.ifs, &vertices, vertices.len() * instances.len()) * self.place.stretch() as f32;
        Cloud { vertices, instances, gap: if gap.is_finite() { gap } else { 0.0 } }
    }

    /// Pieces that together are all of it, no more than `most`, none much larger than another before it is bent.
    fn pieces(&self, most: usize) -> Vec<(Piece3, Letters)> {
        let sizes = self.ifs.maps().iter().map(|map| map.stretch());
        let (least, largest) = sizes.fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        // Where all maps shrink alike it is known at once how far words go.
        let alike = largest - least <= 1e-6 * largest && self.maps() > 1;
        let depth = if alike { most.max(1).ilog(self.maps()) as usize } else { usize::MAX };
        let (mut size, mut known) = (1.0, 1.0);
        while !alike && size > 1e-6 {
            size *= 0.8;
            if !adaptive_cut3(&self.ifs, size, most, |_, _| ()).complete {
                break;
            }
            known = size;
        }
        let mut open = vec![(self.bend.whole(), Letters::NONE)];
        let mut found = Vec::new();
        while let Some((piece, letters)) = open.pop() {
            let small =
                if alike { piece.letters() >= depth } else { known == 1.0 || piece.map().norm() < known };
            if small {
                found.push((piece, letters));
                continue;
            }
            open.extend(self.parts(&piece).enumerate().map(|(letter, part)| (part, letters.then(letter))));
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use frond_deform::{Mesh3, Settings3, Spin};
    use frond_scene::preset3;

    use super::*;
    use crate::solid::points::Eye;
    use crate::solid::{Camera, DepthBuffer, Objects, Traversal};

    fn bent(id: &str, raw: bool, push: f64) -> (Ifs3, Bent) {
        let maps: Vec<Affine3> = preset3(id).unwrap().maps.into_iter().map(Affine3::from_row).collect();
        let ifs = Ifs3::new(maps.clone()).unwrap();
        let Bounds3 { min, max, .. } = Bounds3::of(&ifs);
        let mut moves = vec![DVec3::ZERO; 27];
        let size = (max - min).max_element() * push;
        moves[26] = DVec3::new(0.5, 0.2, 0.6) * size;
        moves[4] = DVec3::new(-0.3, 0.2, -0.4) * size;
        let mesh = Mesh3::new(min, max, [3; 3], moves).unwrap();
        let settings = Settings3 { kb: 0.5, ke: 3.0, roughness: 0.5, spin: Spin::Orthogonal, raw };
        let bend = Bend3::new(&maps, mesh, settings, None).unwrap();
        let place = Affine3::from_row([0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.2, 0.3, 0.0, 0.1]);
        (ifs.clone(), Bent::new(ifs, bend, place))
    }

    fn carved(objects: &Objects, camera: &Camera, [width, height]: [u32; 2]) -> Traversal {
        let mut traversal = objects.traversal(camera, width, height);
        let mut slices = 0;
        while !traversal.run(100_000) {
            slices += 1;
            assert!(slices < 400, "too much work");
        }
        traversal
    }

    #[test]
    fn points_of_a_bent_shape_fall_where_its_complete_picture_is_lit() {
        for (id, raw, push) in [
            ("tetrahedron", false, 1.0),
            ("sponge", false, 0.5),
            ("fern", false, 0.6),
            ("tetrahedron", true, 0.5),
        ] {
            let (ifs, bent) = bent(id, raw, push);
            let Bounds3 { centre, radius, .. } = bent.bounds();
            let camera = Camera::around(centre, 3.0 * radius, 0.5, 0.4, 0.7).unwrap();
            let moved = ifs.conjugate(bent.place).unwrap();
            let objects = Objects::new(vec![moved], vec![None], vec![Some(bent.clone())]);
            let size = [160, 120];
            let traversal = carved(&objects, &camera, size);
            let lit = traversal.depth_buffer().codes();
            let seen = |p: DVec3| {
                let p = camera.turn * (p - camera.eye);
                let scale = camera.focal(size[1]) / p.z;
                (80.0 + scale * p.x, 60.0 - scale * p.y, p.z)
            };
            // Every point of it lies in a lit pixel or beside one, no farther in front of it than a pixel is wide.
            let unit = 3.0 * camera.eye.distance(centre) / camera.focal(size[1]);
            let mut state = 1_u32;
            for _ in 0..4000 {
                let mut piece = bent.bend.whole();
                while piece.map().norm() > 1e-5 {
                    state = frond_core::hash::counter(state, 5);
                    piece = bent.bend.child(&piece, state as usize % ifs.len());
                }
                let (x, y, z) =
                    seen(bent.place.apply(bent.bend.point(&piece, ifs.maps()[0].fixed_point().unwrap())));
                let near = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))).filter_map(|(dx, dy)| {
                    let (x, y) = (x.floor() as i64 + dx, y.floor() as i64 + dy);
                    let at = (y * 160 + x) as usize;
                    ((0..160).contains(&x) && (0..120).contains(&y) && lit[at] != 0)
                        .then(|| f64::from(traversal.depth_buffer().depth()[at]))
                });
                let nearest = near.fold(f64::INFINITY, f64::min);
                assert!(nearest <= z + unit, "{id} {raw}: {x} {y}, {nearest} at {z}");
            }
            // The cloud, affine in each piece, is all over it.
            let eye = Eye::new(&camera, size[0], size[1], objects.depths(&camera));
            let mut buffer = DepthBuffer::new(size[0], size[1]);
            let cloud = &objects.clouds(300_000.0)[0];
            assert!(cloud.points() > 100_000 && cloud.points() <= 300_000, "{id}: {}", cloud.points());
            for piece in &cloud.instances {
                cloud.vertices.iter().for_each(|point| eye.draw(&mut buffer, point, piece));
            }
            let pairs = || buffer.codes().iter().zip(lit);
            let beyond = pairs().filter(|(a, b)| **a != 0 && **b == 0).count();
            let missed = pairs().filter(|(a, b)| **a == 0 && **b != 0).count();
            let all = traversal.depth_buffer().lit();
            assert!(beyond * 20 < all && missed * 4 < all, "{id} {raw}: {beyond} {missed} of {all}");
            assert!(all > 200, "{id}: {all}");
        }
    }

    #[test]
    fn at_rest_it_looks_as_it_does_unbent() {
        let (ifs, still) = bent("sponge", false, 0.0);
        let moved = ifs.conjugate(still.place).unwrap();
        let plain = Objects::new(vec![moved.clone()], vec![None], vec![None]);
        let bent = Objects::new(vec![moved], vec![None], vec![Some(still)]);
        let camera = Camera::around(plain.centre(), 3.0 * plain.radius(), 0.5, 0.4, 0.7).unwrap();
        let [one, other] = [plain, bent].map(|objects| carved(&objects, &camera, [100, 100]));
        let pairs = one.depth_buffer().depth().iter().zip(other.depth_buffer().depth());
        let near = pairs.filter(|(a, b)| a == b || (**a - **b).abs() < 0.02).count();
        assert!(near > 9900, "{near}");
    }

    #[test]
    fn a_bend_as_large_as_may_be_is_no_harm() {
        for id in ["tetrahedron", "fern"] {
            let (ifs, bent) = bent(id, false, 1e30);
            let objects = Objects::new(vec![ifs], vec![None], vec![Some(bent)]);
            assert!(objects.radius().is_finite() && objects.radius() > 1e20);
            let camera = Camera::around(
                objects.centre() / objects.unit(),
                3.0 * objects.radius() / objects.unit(),
                0.5,
                0.4,
                0.7,
            );
            carved(&objects, &camera.unwrap(), [40, 40]);
            assert!(objects.clouds(1000.0)[0].points() > 0);
        }
    }
}
