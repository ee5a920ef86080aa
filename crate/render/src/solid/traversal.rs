//! Walking down the trees of pieces before the eye.

use std::sync::Arc;

use frond_core::{Affine3, Bounds3, Ifs3};
use frond_deform::Piece3;
use glam::DVec3;

use super::fine::{Fine, FinePiece, LONGEST_WORD};
use super::lens::{Footprint, Lens};
use super::points::OBJECT_BIT;
use super::shape::{Shape, single};
use super::{Bent, Camera, DepthBuffer};
use crate::pieces::letters::Letters;

/// The most systems in one picture.
pub const MAX_OBJECTS: usize = 60;
/// Nearer than this part of the distance to the farthest point nothing is seen.
const NEAREST_SHARE: f64 = 1e-3;
/// Pieces are followed in single precision from this size on, in pixels across: what is rounded off them, and off where
/// they are in the picture, is a thousandth of a pixel.
const FINE_SIZE: f64 = 2048.0;
/// What is bent is followed as if it were not from where that is off by this part of a pixel.
const OFF_SIZE: f64 = 0.1;

/// A picture of space in the making: every pixel that a piece in sight reaches, and no other.
///
/// A piece is looked into, the nearest of its parts first, until its ball is within a pixel; one that is out of sight,
/// or behind what is there already, is passed over. So the work is that of what is seen.
#[derive(Clone, Debug)]
pub struct Traversal {
    objects: Vec<Object>,
    lens: Lens,
    buffer: DepthBuffer,
    open: Vec<Node>,
    open_bent: Vec<BentNode>,
    /// Small pieces of one object, this one.
    fine: Fine,
    fine_object: u32,
    parts: Vec<BentNode>,
    order: Vec<(f64, usize)>,
}

/// A shape, and what takes its coordinates to where the eye is at the origin and z is depth.
#[derive(Clone, Debug)]
struct Object {
    shape: Arc<Shape>,
    root: Affine3,
    /// A ball around it as the camera has it.
    seen: (DVec3, f64),
    bent: Option<Bent>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    map: Affine3,
    object: u32,
    letters: Letters,
    depth: u32,
}

/// A piece of an object that is bent, and a ball around it as the camera has it.
#[derive(Clone, Debug)]
struct BentNode {
    piece: Piece3,
    object: u32,
    letters: Letters,
    ball: (DVec3, f64),
}

/// What a picture is taken of: a shape, as bent as it is, and where it lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Subject<'a> {
    pub shape: &'a Arc<Shape>,
    pub bent: Option<&'a Bent>,
    pub bounds: &'a Bounds3,
}

impl Traversal {
    /// A picture of these systems. Those that are too many are left out.
    #[must_use]
    pub fn new(systems: &[Ifs3], camera: &Camera, width: u32, height: u32) -> Self {
        let bounds: Vec<Bounds3> = systems.iter().map(Bounds3::of).collect();
        let shape = |(ifs, bounds)| Arc::new(Shape::new(ifs, bounds));
        let shapes: Vec<Arc<Shape>> = systems.iter().zip(&bounds).map(shape).collect();
        let subjects = shapes.iter().zip(&bounds);
        let subjects = subjects.map(|(shape, bounds)| Subject { shape, bent: None, bounds });
        Self::of(subjects, camera, [width, height], [0, height])
    }

    /// The rows from `rows[0]` on, before `rows[1]`, of a picture that is `width` x `height` pixels large.
    pub(super) fn of<'a>(
        subjects: impl Iterator<Item = Subject<'a>>,
        camera: &Camera,
        size: [u32; 2],
        rows: [u32; 2],
    ) -> Self {
        let place = Affine3::new(camera.turn, -(camera.turn * camera.eye));
        let object = |Subject { shape, bent, bounds }: Subject| Object {
            shape: Arc::clone(shape),
            root: place * Affine3::new(shape.back, DVec3::ZERO),
            seen: (camera.seen(bounds.centre), bounds.radius),
            bent: bent.map(|bent| bent.moved(place)),
        };
        let objects: Vec<Object> = subjects.take(MAX_OBJECTS).map(object).collect();
        let far = objects.iter().map(|o| o.seen.0.length() + o.seen.1).fold(0.0, f64::max);
        let node = |(number, object): (usize, &Object)| Node {
            map: object.root,
            object: number as u32,
            letters: Letters::NONE,
            depth: 0,
        };
        let plain = objects.iter().enumerate().filter(|(_, object)| object.bent.is_none());
        let mut open: Vec<Node> = plain.map(node).collect();
        let whole = |(number, object): (usize, &Object)| {
            let piece = object.bent.as_ref()?.bend().whole();
            Some(BentNode { piece, object: number as u32, letters: Letters::NONE, ball: object.seen })
        };
        let open_bent = objects.iter().enumerate().filter_map(whole).collect();
        // The nearest is taken first.
        open.sort_by(|a, b| {
            let depth = |node: &Node| objects[node.object as usize].seen.0.z;
            depth(b).total_cmp(&depth(a))
        });
        let lens = Lens::new(camera, size, rows, near(far));
        Self {
            lens,
            buffer: DepthBuffer::new(lens.width, lens.rows[1] - lens.rows[0]),
            objects,
            open,
            open_bent,
            fine: Fine::new(&lens),
            fine_object: 0,
            parts: Vec::new(),
            order: Vec::new(),
        }
    }

    /// Looks at `budget` pieces, or a few more. Whether it is done.
    pub fn run(&mut self, budget: usize) -> bool {
        let mut left = budget;
        while left > 0 {
            let shape = self.objects.get(self.fine_object as usize).map(|object| &object.shape);
            let fine = shape.and_then(|shape| self.fine.step(shape, self.fine_object, &mut self.buffer));
            let looked = if let Some(looked) = fine {
                looked
            } else if let Some(node) = self.open.pop() {
                self.visit(node)
            } else if let Some(node) = self.open_bent.pop() {
                self.visit_bent(&node)
            } else {
                return true;
            };
            left = left.saturating_sub(looked);
        }
        self.fine.is_done() && self.open.is_empty() && self.open_bent.is_empty()
    }

    /// The nearest and the farthest depth that anything can be seen at.
    #[must_use]
    pub fn range(&self) -> [f32; 2] {
        range(self.objects.iter().map(|object| object.seen))
    }

    /// What is seen so far.
    #[must_use]
    pub fn depth_buffer(&self) -> &DepthBuffer {
        &self.buffer
    }

    /// Looks into a piece, or passes it over. How many were looked at.
    fn visit(&mut self, node: Node) -> usize {
        let shape = &self.objects[node.object as usize].shape;
        let (centre, radius) = (node.map.apply(shape.centre), node.map.stretch() * shape.radius);
        let Some(nearest) = self.opens((centre, radius), node.letters, node.object, node.depth) else {
            return 1;
        };
        if nearest > self.lens.near && 2.0 * radius * self.lens.focal <= FINE_SIZE * nearest {
            self.fine_object = node.object;
            self.fine.open(FinePiece {
                linear: single(node.map.linear),
                centre: centre.as_vec3a(),
                radius: radius as f32,
                letters: node.letters,
                depth: node.depth,
            });
            return 1;
        }
        let shape = &self.objects[node.object as usize].shape;
        self.order.clear();
        let depth = |map: &Affine3| node.map.linear.row(2).dot(map.apply(shape.centre));
        self.order.extend(shape.maps.iter().enumerate().map(|(i, map)| (depth(map), i)));
        self.order.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        for &(_, letter) in &self.order {
            self.open.push(Node {
                map: node.map * shape.maps[letter],
                letters: node.letters.then(letter),
                depth: node.depth + 1,
                ..node
            });
        }
        1 + shape.maps.len()
    }

    /// The same of a piece that is bent.
    fn visit_bent(&mut self, node: &BentNode) -> usize {
        let deep = node.piece.letters() as u32;
        let Some(nearest) = self.opens(node.ball, node.letters, node.object, deep) else { return 1 };
        let object = &self.objects[node.object as usize];
        let Some(bent) = &object.bent else { return 1 };
        let place = bent.place();
        let stretch = place.stretch();
        if let Some((frame, off)) = bent.bend().affine(&node.piece)
            && nearest > self.lens.near
            && off * stretch * self.lens.focal <= OFF_SIZE * nearest
        {
            let map = place * frame * Affine3::new(object.shape.back, DVec3::ZERO);
            self.open.push(Node { map, object: node.object, letters: node.letters, depth: deep });
            return 1;
        }
        self.parts.clear();
        self.order.clear();
        for letter in 0..bent.maps() {
            let piece = bent.bend().child(&node.piece, letter);
            let (centre, radius) = bent.bend().ball(&piece);
            let ball = (place.apply(centre), stretch * radius);
            self.order.push((ball.0.z, letter));
            let letters = node.letters.then(letter);
            self.parts.push(BentNode { piece, letters, object: node.object, ball });
        }
        // The nearest is taken first. They are large: their numbers are put in order.
        self.order.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        self.open_bent.extend(self.order.iter().map(|&(_, letter)| self.parts[letter].clone()));
        1 + self.parts.len()
    }

    /// The nearest depth of a piece in this ball if it has to be looked into; one that is a pixel is drawn.
    fn opens(
        &mut self,
        (middle, radius): (DVec3, f64),
        letters: Letters,
        object: u32,
        depth: u32,
    ) -> Option<f64> {
        let code = 1 + (letters.packed() | object << OBJECT_BIT);
        match self.lens.footprint(middle, radius) {
            Footprint::None => {}
            Footprint::Pixel([x, y]) => self.buffer.put(x, y, middle.z as f32, code),
            Footprint::Box(pixels, nearest) => {
                if self.buffer.hides(pixels, nearest as f32) {
                    return None;
                }
                if depth < LONGEST_WORD {
                    return Some(nearest);
                }
                let [x0, y0, x1, y1] = pixels;
                self.buffer.put(u32::midpoint(x0, x1), u32::midpoint(y0, y1), middle.z as f32, code);
            }
        }
        None
    }
}

/// Nothing is seen nearer than this, if `far` is as far as anything is from the eye.
fn near(far: f64) -> f64 {
    (NEAREST_SHARE * far).max(f64::MIN_POSITIVE)
}

/// The nearest and the farthest depth of balls, as the eye has them.
fn range(balls: impl Iterator<Item = (DVec3, f64)>) -> [f32; 2] {
    let (mut low, mut high, mut far) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
    for (centre, radius) in balls {
        low = low.min(centre.z - radius);
        high = high.max(centre.z + radius);
        far = far.max(centre.length() + radius);
    }
    let near = near(far);
    [low, high].map(|depth| if depth.is_finite() { depth.max(near) } else { near } as f32)
}

/// The nearest and the farthest depth at which a camera can see anything of what has these bounds: what
/// [`Traversal::range`] says.
#[must_use]
pub fn depths(bounds: &[Bounds3], camera: &Camera) -> [f32; 2] {
    range(bounds.iter().take(MAX_OBJECTS).map(|bounds| (camera.seen(bounds.centre), bounds.radius)))
}

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use frond_core::{Affine3, Ifs3};
    use glam::DQuat;

    use super::*;
    use crate::solid::Objects;

    fn scaled(corners: &[DVec3], scale: f64) -> Ifs3 {
        let map = |&c: &DVec3| Affine3::similitude(scale, DQuat::IDENTITY, c * (1.0 - scale));
        Ifs3::new(corners.iter().map(map).collect()).unwrap()
    }

    fn cube() -> Ifs3 {
        let corners: Vec<DVec3> = (0..8)
            .map(|k| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)) * 2.0 - 1.0)
            .collect();
        scaled(&corners, 0.5)
    }

    fn done(systems: &[Ifs3], camera: &Camera, side: u32) -> DepthBuffer {
        let mut traversal = Traversal::new(systems, camera, side, side);
        let mut slices = 0;
        while !traversal.run(100_000) {
            slices += 1;
            assert!(slices < 200, "too much work");
        }
        traversal.depth_buffer().clone()
    }

    #[test]
    fn a_cube_is_seen_as_a_square_at_the_depth_of_its_face() {
        let camera = Camera::looking(DVec3::Z * 11.0, DVec3::ZERO, DVec3::Y, 0.4).unwrap();
        let buffer = done(&[cube()], &camera, 200);
        // The face is at depth 10, half a side is 1 / 10 / tan 0.2 of half the picture.
        let half = (100.0 / (10.0 * 0.2_f64.tan())).floor() as i32;
        for (at, &depth) in buffer.depth().iter().enumerate() {
            let (x, y) = (at as i32 % 200 - 100, at as i32 / 200 - 100);
            let inside = |v: i32| (-half + 1..half - 1).contains(&v);
            let outside = |v: i32| v < -half - 2 || v > half + 1;
            if inside(x) && inside(y) {
                assert!((f64::from(depth) - 10.0).abs() < 0.1, "({x}, {y}): {depth}");
            }
            assert!(!(outside(x) || outside(y)) || depth == f32::INFINITY, "({x}, {y}): {depth}");
        }
    }

    #[test]
    fn a_flattened_shape_takes_no_longer() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let turned = |&c: &DVec3| {
            Affine3::similitude(0.55, DQuat::from_axis_angle(DVec3::ONE.normalize(), 1.0 + c.x), c * 0.45)
        };
        let made = Ifs3::new(corners.iter().map(turned).collect()).unwrap();
        let flat = made.conjugate(Affine3::scaling(DVec3::new(1.0, 1.0, 0.02))).unwrap();
        let camera = Camera::looking(DVec3::new(0.4, -6.0, 3.0), DVec3::splat(0.4), DVec3::Z, 0.4).unwrap();
        let work = |ifs: &Ifs3| {
            let mut traversal = Traversal::new(std::slice::from_ref(ifs), &camera, 120, 120);
            let mut slices = 0;
            while !traversal.run(1000) {
                slices += 1;
                assert!(slices < 3000, "too much work");
            }
            (slices, traversal.depth_buffer().lit())
        };
        let (made, flat) = (work(&made), work(&flat));
        assert!(flat.1 > 300 && flat.0 < 10 * made.0.max(10), "{flat:?} {made:?}");
    }

    #[test]
    fn what_is_nearer_hides_what_is_behind() {
        let camera = Camera::looking(DVec3::Z * 11.0, DVec3::ZERO, DVec3::Y, 0.4).unwrap();
        let behind = cube().conjugate(Affine3::moving(DVec3::new(0.3, 0.0, -40.0))).unwrap();
        for systems in [[cube(), behind.clone()], [behind, cube()]] {
            let buffer = done(&systems, &camera, 100);
            let front = u32::from(systems[0] != cube());
            let middle = buffer.codes()[50 * 100 + 50] - 1;
            assert_eq!(middle >> OBJECT_BIT, front);
        }
    }

    #[test]
    fn an_eye_within_or_behind_or_far_away_is_no_harm() {
        let look = |eye: DVec3, target: DVec3| Camera::looking(eye, target, DVec3::Y, 1.0).unwrap();
        let within = done(&[cube()], &look(DVec3::splat(0.1), DVec3::X), 60);
        assert!(within.lit() > 1000);
        let away = done(&[cube()], &look(DVec3::Z * 5.0, DVec3::Z * 9.0), 60);
        assert_eq!(away.lit(), 0);
        let far = done(&[cube()], &look(DVec3::Z * 1e6, DVec3::ZERO), 60);
        assert_eq!(far.lit(), 1);
        let flat = Ifs3::new(vec![Affine3::scaling(DVec3::ZERO); 2]).unwrap();
        assert_eq!(done(&[flat], &look(DVec3::Z * 5.0, DVec3::ZERO), 60).lit(), 1);
        assert_eq!(done(&[], &look(DVec3::Z * 5.0, DVec3::ZERO), 60).lit(), 0);
    }

    #[test]
    fn bands_of_rows_are_those_of_the_whole_picture() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let objects = Objects::new(vec![cube(), scaled(&corners, 0.45)], vec![], vec![]);
        let camera = Camera::looking(DVec3::new(3.0, 1.7, 4.1), DVec3::ZERO, DVec3::Y, 0.9).unwrap();
        let carve = |rows: Range<u32>| {
            let mut traversal = objects.band(&camera, [90, 70], rows);
            assert!(traversal.run(usize::MAX));
            let buffer = traversal.depth_buffer();
            (buffer.depth().to_vec(), buffer.codes().to_vec())
        };
        let (depth, codes) = carve(0..70);
        assert!(codes.iter().filter(|&&code| code != 0).count() > 500);
        for cut in [1, 35, 36, 69] {
            let (above, below) = (carve(0..cut), carve(cut..70));
            assert_eq!([above.0, below.0].concat(), depth, "{cut}");
            // Pieces of one depth may take turns.
            let lit = |codes: &[u32]| codes.iter().map(|&code| code != 0).collect::<Vec<_>>();
            assert_eq!(lit(&[above.1, below.1].concat()), lit(&codes), "{cut}");
        }
    }

    #[test]
    fn near_a_corner_it_looks_alike_at_any_size() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let ifs = scaled(&corners, 0.5);
        // Half the angle shows half as much of it, which is a copy of the whole.
        let look = |angle: f64| {
            let camera =
                Camera::looking(DVec3::new(20.0, 16.0, 24.0), DVec3::splat(1e-9), DVec3::Y, angle).unwrap();
            done(std::slice::from_ref(&ifs), &camera, 128)
        };
        let first = look(1e-3);
        assert!(first.lit() > 500, "{}", first.lit());
        for halvings in [1, 4, 8, 12] {
            let next = look(1e-3 * 0.5_f64.powi(halvings));
            let pairs = first.codes().iter().zip(next.codes());
            let off = pairs.filter(|(a, b)| (**a == 0) != (**b == 0)).count();
            assert!(off * 20 < first.lit(), "{halvings}: {off} of {}", first.lit());
        }
    }
}
