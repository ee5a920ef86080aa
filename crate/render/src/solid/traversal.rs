//! Walking down the trees of pieces before the eye.

use frond_core::{Affine3, Bounds3, Ifs3};
use frond_deform::Piece3;
use glam::{DMat3, DVec3};

use super::points::OBJECT_BIT;
use super::{Bent, Camera, DepthBuffer};
use crate::pieces::letters::Letters;

/// The most systems in one picture.
pub const MAX_OBJECTS: usize = 60;
/// A piece whose ball is smaller than this, in pixels across, is a pixel.
const PIXEL_SIZE: f64 = 1.0;
/// Nearer than this part of the distance to the farthest point nothing is seen.
const NEAREST_SHARE: f64 = 1e-3;
/// The longest word: what is that deep is a pixel, whatever its size.
const LONGEST_WORD: u32 = 400;

/// A picture of space in the making: every pixel that a piece in sight reaches, and no other.
///
/// A piece is looked into, the nearest of its parts first, until its ball is within a pixel; one that is out of sight,
/// or behind what is there already, is passed over. So the work is that of what is seen.
#[derive(Clone, Debug)]
pub struct Traversal {
    objects: Vec<Object>,
    focal: f64,
    near: f64,
    buffer: DepthBuffer,
    open: Vec<Node>,
    open_bent: Vec<BentNode>,
    parts: Vec<BentNode>,
    order: Vec<(f64, usize)>,
}

/// A system in coordinates in which its maps contract, and what takes these to where the eye is at the origin and z is
/// depth. A shape that was flattened is carved as what it was flattened from: its pieces are round there, and long
/// here.
#[derive(Clone, Debug)]
struct Object {
    maps: Vec<Affine3>,
    root: Affine3,
    /// A ball around it, in these coordinates.
    centre: DVec3,
    radius: f64,
    /// One as the camera has it.
    seen: (DVec3, f64),
    bent: Option<Bent>,
}

impl Object {
    fn new(ifs: &Ifs3, bent: Option<&Bent>, bounds: &Bounds3, camera: &Camera) -> Self {
        let place = Affine3::new(camera.turn, -(camera.turn * camera.eye));
        let bent = bent.map(|bent| bent.moved(place));
        let seen = (camera.seen(bounds.centre), bounds.radius);
        let contraction = ifs.contraction();
        let by = Affine3::new(contraction.to_round, DVec3::ZERO);
        let back = Affine3::new(contraction.from_round, DVec3::ZERO);
        let plain = contraction.to_round == DMat3::IDENTITY;
        // Where it cannot be, it is carved as it is.
        let round = if plain { None } else { ifs.conjugate(by).ok() };
        match round {
            Some(ifs) => {
                let Bounds3 { centre, radius, .. } = Bounds3::of(&ifs);
                Self { maps: ifs.maps().to_vec(), root: place * back, centre, radius, seen, bent }
            }
            None => {
                let &Bounds3 { centre, radius, .. } = bounds;
                Self { maps: ifs.maps().to_vec(), root: place, centre, radius, seen, bent }
            }
        }
    }
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

/// What a ball takes up in the picture.
enum Footprint {
    None,
    Pixel([u32; 2]),
    Box([u32; 4], f64),
}

impl Traversal {
    /// A picture of these systems. Those that are too many are left out.
    #[must_use]
    pub fn new(systems: &[Ifs3], camera: &Camera, width: u32, height: u32) -> Self {
        Self::of(systems, &[], camera, width, height)
    }

    /// The same of systems of which some are bent.
    #[must_use]
    pub fn of(systems: &[Ifs3], bends: &[Option<Bent>], camera: &Camera, width: u32, height: u32) -> Self {
        let object = |(number, ifs): (usize, &Ifs3)| {
            let bent = bends.get(number).and_then(Option::as_ref);
            let bounds = bent.map_or_else(|| Bounds3::of(ifs), Bent::bounds);
            Object::new(ifs, bent, &bounds, camera)
        };
        let objects: Vec<Object> = systems.iter().take(MAX_OBJECTS).enumerate().map(object).collect();
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
        Self {
            focal: camera.focal(height),
            near: near(far),
            buffer: DepthBuffer::new(width, height),
            objects,
            open,
            open_bent,
            parts: Vec::new(),
            order: Vec::new(),
        }
    }

    /// Looks at `budget` pieces at most. Whether it is done.
    pub fn run(&mut self, budget: usize) -> bool {
        for _ in 0..budget {
            if let Some(node) = self.open.pop() {
                self.visit(node);
            } else if let Some(node) = self.open_bent.pop() {
                self.visit_bent(&node);
            } else {
                return true;
            }
        }
        self.open.is_empty() && self.open_bent.is_empty()
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

    fn visit(&mut self, node: Node) {
        let &Object { centre, radius, .. } = &self.objects[node.object as usize];
        let ball = (node.map.apply(centre), node.map.stretch() * radius);
        if !self.opens(ball, node.letters, node.object, node.depth) {
            return;
        }
        let maps = &self.objects[node.object as usize].maps;
        self.order.clear();
        let depth = |map: &Affine3| node.map.linear.row(2).dot(map.apply(centre));
        self.order.extend(maps.iter().enumerate().map(|(i, map)| (depth(map), i)));
        self.order.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        for &(_, letter) in &self.order {
            self.open.push(Node {
                map: node.map * maps[letter],
                letters: node.letters.then(letter),
                depth: node.depth + 1,
                ..node
            });
        }
    }

    fn visit_bent(&mut self, node: &BentNode) {
        if !self.opens(node.ball, node.letters, node.object, node.piece.letters() as u32) {
            return;
        }
        let Some(bent) = &self.objects[node.object as usize].bent else { return };
        let place = bent.place();
        let stretch = place.stretch();
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
    }

    /// Whether a piece in this ball has to be looked into; one that is a pixel is drawn.
    fn opens(&mut self, (middle, radius): (DVec3, f64), letters: Letters, object: u32, depth: u32) -> bool {
        let code = 1 + (letters.packed() | object << OBJECT_BIT);
        match self.footprint(middle, radius) {
            Footprint::None => false,
            Footprint::Pixel([x, y]) => {
                self.buffer.put(x, y, middle.z as f32, code);
                false
            }
            Footprint::Box(pixels, nearest) => {
                if self.buffer.hides(pixels, nearest as f32) {
                    return false;
                }
                if depth < LONGEST_WORD {
                    return true;
                }
                let [x0, y0, x1, y1] = pixels;
                self.buffer.put(u32::midpoint(x0, x1), u32::midpoint(y0, y1), middle.z as f32, code);
                false
            }
        }
    }

    /// Where a ball is seen.
    fn footprint(&self, middle: DVec3, radius: f64) -> Footprint {
        let (width, height) = (f64::from(self.buffer.width()), f64::from(self.buffer.height()));
        if middle.z + radius <= self.near {
            return Footprint::None;
        }
        let nearest = middle.z - radius;
        if nearest <= self.near {
            // The eye may be within: all of the picture, unless it lies to a side.
            let reach = 0.5 * width.hypot(height) / self.focal;
            let aside = middle.x.hypot(middle.y) - radius;
            let beyond = aside > reach * (middle.z + radius);
            let whole = [0, 0, self.buffer.width() - 1, self.buffer.height() - 1];
            // What is that near and no larger is let go: nobody holds a thing against the eye to see it.
            return if beyond || radius < 0.5 * self.near {
                Footprint::None
            } else {
                Footprint::Box(whole, self.near)
            };
        }
        let scale = self.focal / middle.z;
        let (x, y) = (0.5 * width + scale * middle.x, 0.5 * height - scale * middle.y);
        if 2.0 * radius * scale <= PIXEL_SIZE {
            let inside = x >= 0.0 && y >= 0.0 && x < width && y < height;
            return if inside { Footprint::Pixel([x as u32, y as u32]) } else { Footprint::None };
        }
        // The ball is within the cone of this slope around its middle's, by its nearest depth.
        let reach = |along: f64| {
            let off = radius * (1.0 + (along / middle.z).powi(2)).sqrt();
            self.focal * off / nearest
        };
        let (dx, dy) = (reach(middle.x), reach(middle.y));
        let (x0, x1, y0, y1) = (x - dx, x + dx, y - dy, y + dy);
        if x1 < 0.0 || y1 < 0.0 || x0 >= width || y0 >= height {
            return Footprint::None;
        }
        let pixel = |v: f64, side: f64| v.clamp(0.0, side - 1.0) as u32;
        Footprint::Box([pixel(x0, width), pixel(y0, height), pixel(x1, width), pixel(y1, height)], nearest)
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
    use frond_core::{Affine3, Ifs3};
    use glam::DQuat;

    use super::*;

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
}
