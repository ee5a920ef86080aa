//! A shape of space bent by a mesh, piece by piece.

use std::sync::Arc;

use frond_core::{Affine3, Bounds3, Dim3, Ifs3};
use glam::{DMat3, DVec3};

use crate::continuity::cells::MOST_CORNERS;
use crate::continuity::corners3::Corners3;
use crate::continuity::lattice3::Lattice3;
use crate::error::BendError;
use crate::mesh3::Mesh3;
use crate::settings::{Roughness, check_bend};
use crate::shuffle::cursor::Cursor;
use crate::shuffle::place_terms::Raw;
use crate::shuffle::spin::Spin;
use crate::shuffle::terms::Terms;

/// How displacements of space are shuffled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings3 {
    /// Locality: letters that stay. 0 to `ke`, whole or not (Fujimoto et al., eq 19).
    pub kb: f64,
    /// Detail: the last letter that is shuffled. It is taken down to what memory allows.
    pub ke: f64,
    /// How much the small parts answer: delta, 0 or more.
    pub roughness: f64,
    /// How displacements turn with the pieces.
    pub spin: Spin,
    /// The formula as it stands, torn where the shuffle tears it, also where the shape has corners that would keep
    /// it together.
    pub raw: bool,
}

/// A fractal deformation of space at one moment (Fujimoto et al., eqs 12, 18 and 19, which hold in any dimension; the
/// paper shows the plane alone): where each piece of a shape goes.
///
/// Where pieces meet in corners ([`Corners3`]) every term is sampled at the corners of its own cells, averaged where
/// cells share one and interpolated inside, barycentric or trilinear: nothing tears, and the plain displacement stays
/// exact. Other shapes are bent by the formula as it stands, and tear where the shuffle tears them.
///
/// ```
/// use frond_core::Affine3;
/// use frond_deform::{Bend3, Mesh3, Settings3, Spin};
/// use glam::{DQuat, DVec3};
///
/// let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let gasket = corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, 0.5 * c));
/// let mut moves = vec![DVec3::ZERO; 27];
/// moves[26] = DVec3::new(0.0, 0.0, 0.5);
/// let mesh = Mesh3::new(DVec3::ZERO, DVec3::ONE, [3, 3, 3], moves)?;
/// let settings = Settings3 { kb: 0.0, ke: 6.0, roughness: 0.5, spin: Spin::None, raw: false };
/// let bend = Bend3::new(&gasket, mesh, settings, None)?;
/// assert!(bend.continuous());
/// let piece = bend.child(&bend.child(&bend.whole(), 2), 0);
/// let (centre, radius) = bend.ball(&piece);
/// assert!(bend.point(&piece, DVec3::Z).distance(centre) <= radius);
/// # Ok::<(), frond_deform::BendError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bend3 {
    mesh: Mesh3,
    raw: Raw<Dim3>,
    terms: Terms,
    /// What the plain displacement counts, and what the shuffled terms do, one after the other.
    plain: f64,
    ke: f64,
    body: Body,
}

/// What is known of where pieces go.
#[derive(Clone, Debug)]
enum Body {
    Corners(Cornered),
    Raw(Round),
}

#[derive(Clone, Debug)]
struct Cornered {
    lattice: Arc<Lattice3>,
    /// The shuffled terms at each vertex.
    values: Vec<DVec3>,
    /// Balls around the bent pieces of each level.
    balls: Vec<Vec<Ball>>,
    /// No second derivative of the mesh is larger where the shape is.
    curvature: f64,
    /// A ball around the unbent shape.
    ball: Ball,
}

/// An unbent shape: a point of it, how far it reaches from there, and how steep the mesh is in it.
#[derive(Clone, Copy, Debug)]
struct Round {
    point: DVec3,
    radius: f64,
    steepness: f64,
}

type Ball = (DVec3, f64);

/// A piece of a bent shape: the word that names it, and about where it goes.
#[derive(Clone, Debug)]
pub struct Piece3 {
    cursor: Cursor<Dim3>,
    /// Of small pieces that are kept together at corners.
    near: Option<Near>,
}

/// An affine map that takes the whole to about where a bent piece is, and how far any of it is off.
#[derive(Clone, Copy, Debug)]
struct Near {
    frame: Affine3,
    off: f64,
}

impl Piece3 {
    /// The map of the piece, unbent.
    #[must_use]
    pub const fn map(&self) -> Affine3 {
        self.cursor.map()
    }

    /// The number of letters of its word.
    #[must_use]
    pub const fn letters(&self) -> usize {
        self.cursor.letters()
    }
}

/// The most letters that are shuffled where nothing is kept of the levels.
pub(crate) const DEEPEST_RAW: usize = 16;
/// Bounds are taken this much larger, and by this part of the shape's size: rounding must not make them too small.
const ROUNDED_UP: f64 = 1.0 + 1e-9;
/// An affine map is good enough for a piece, and for its parts after it, while it is off by this part of their size: a
/// smaller part would have most of the smallest pieces looked at for one of their own.
const OFF: f64 = 0.12;
/// Points of the shape that one amid it is chosen of.
const POINTS_TRIED: usize = 400;

impl Bend3 {
    /// The bend of the shape of `maps` by a mesh. `before` is another bend, of which all is taken over that hangs on
    /// the maps and the depth alone, if these are the same.
    ///
    /// # Errors
    /// [`BendError`]: for maps without an attractor, a locality above the detail, and numbers that are none.
    pub fn new(
        maps: &[Affine3],
        mesh: Mesh3,
        settings: Settings3,
        before: Option<&Self>,
    ) -> Result<Self, BendError> {
        let Settings3 { kb, roughness, spin, raw, .. } = settings;
        check_bend(kb, settings.ke, Roughness::Constant(roughness))?;
        let ifs = Ifs3::new(maps.to_vec())?;
        let same = before.filter(|before| before.raw.maps == maps).map(|before| &before.body);
        let kept = same.and_then(|body| if let Body::Corners(it) = body { Some(&it.lattice) } else { None });
        let corners = match kept {
            _ if raw => None,
            Some(lattice) => Some(lattice.corners.clone()),
            None => Corners3::find(maps),
        };
        let deepest = corners.as_ref().map_or(DEEPEST_RAW, |corners| Lattice3::deepest(maps.len(), corners));
        let ke = settings.ke.min(deepest as f64);
        let kb = kb.min(ke);
        let terms = Terms::new(kb, ke, Roughness::Constant(roughness), spin, true);
        let plain = terms.fixed().map_or(1.0, |weights| weights.plain);
        let raw = Raw::new(maps, spin);
        let body = match corners {
            Some(corners) => {
                let kept = kept.filter(|lattice| lattice.depth() == terms.depth()).map(Arc::clone);
                let lattice = kept.unwrap_or_else(|| Arc::new(Lattice3::new(maps, corners, terms.depth())));
                Body::Corners(Cornered::new(&ifs, lattice, &mesh, &terms, plain, raw.turning())?)
            }
            None => Body::Raw(Round::new(&ifs, &mesh)?),
        };
        Ok(Self { mesh, raw, terms, plain, ke, body })
    }

    /// Whether neighbouring pieces agree where they meet.
    #[must_use]
    pub const fn continuous(&self) -> bool {
        matches!(self.body, Body::Corners(_))
    }

    /// The detail as it is: what was asked for, or what memory allows.
    #[must_use]
    pub const fn ke(&self) -> f64 {
        self.ke
    }

    /// The mesh.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh3 {
        &self.mesh
    }

    /// The word of no letters.
    #[must_use]
    pub fn whole(&self) -> Piece3 {
        self.piece(Cursor::WHOLE, None)
    }

    /// One letter more. There must be a map of that number; if there is not, the last is taken.
    #[must_use]
    pub fn child(&self, piece: &Piece3, letter: usize) -> Piece3 {
        let letter = letter.min(self.raw.maps.len() - 1);
        let depth = self.terms.depth();
        let counted = if self.continuous() { depth } else { 0 };
        let cursor = piece.cursor.child(letter, &self.raw.maps, depth, counted);
        let inner = |near: Near| Near { frame: near.frame * self.raw.maps[letter], off: near.off };
        self.piece(cursor, piece.near.map(inner))
    }

    /// A piece, from what is known of it by the one that it is a part of.
    fn piece(&self, cursor: Cursor<Dim3>, near: Option<Near>) -> Piece3 {
        let Body::Corners(it) = &self.body else { return Piece3 { cursor, near: None } };
        if cursor.letters() < it.lattice.depth() {
            return Piece3 { cursor, near: None };
        }
        let good = near.filter(|near| near.off <= OFF * near.frame.stretch() * it.ball.1);
        let near = good.unwrap_or_else(|| self.near(&cursor, it).0);
        Piece3 { cursor, near: Some(near) }
    }

    /// A ball that holds all points of the bent piece.
    ///
    /// With corners, between which the shuffled terms are interpolated, the piece lies in the hull of its bent corners,
    /// but for what the plain displacement is off from its tangent; a small one lies near its image under an affine
    /// map. Else each term takes the piece to a piece, and adds no more than the mesh is steep there; of terms deeper
    /// than the word nothing is known but the first letters.
    #[must_use]
    pub fn ball(&self, piece: &Piece3) -> (DVec3, f64) {
        let it = match &self.body {
            Body::Corners(it) => it,
            Body::Raw(round) => return self.ball_of_terms(&piece.cursor, round),
        };
        let known = it.balls.get(piece.letters()).and_then(|level| level.get(piece.cursor.index as usize));
        match (known, piece.near) {
            (Some(ball), _) => *ball,
            (None, Some(Near { frame, off })) => {
                let radius = frame.stretch() * it.ball.1;
                if off <= OFF * radius {
                    return (frame.apply(it.ball.0), (radius + off) * ROUNDED_UP);
                }
                // Large pieces, of which no affine map says enough.
                let (_, goals, slack) = self.near(&piece.cursor, it);
                ball_around(&goals[..it.lattice.corners.points().len()], slack)
            }
            (None, None) => it.balls[0][0],
        }
    }

    /// An affine map of space that takes the whole, unbent, about to where the bent piece is: through its bent corners,
    /// or by how the bend changes amid it.
    #[must_use]
    pub fn frame(&self, piece: &Piece3) -> Affine3 {
        match &self.body {
            Body::Corners(it) => piece.near.unwrap_or_else(|| self.near(&piece.cursor, it).0).frame,
            Body::Raw(round) => {
                let step = (0.5 * round.radius).max(1e-9);
                let at = |z: DVec3| self.point(piece, z);
                let origin = at(round.point);
                let side = |axis: DVec3| (at(round.point + axis * step) - origin) / step;
                let sides = DMat3::from_cols(side(DVec3::X), side(DVec3::Y), side(DVec3::Z));
                Affine3::new(sides, origin - sides * round.point)
            }
        }
    }

    /// The same, and how far any point of the piece is from where that map takes it, if that is known. Both hold for
    /// its parts.
    #[must_use]
    pub fn affine(&self, piece: &Piece3) -> Option<(Affine3, f64)> {
        let (Body::Corners(it), Some(_)) = (&self.body, piece.near) else { return None };
        // What was found for a larger piece may hold for this one, but is off by more.
        let Near { frame, off } = self.near(&piece.cursor, it).0;
        Some((frame, off))
    }

    /// Where the point goes that the piece's map takes `z` to.
    ///
    /// A word that is too short to be shuffled goes on: with corners, through the pieces that hold the point; else with
    /// the letter whose fixed point is nearest, over and over.
    #[must_use]
    pub fn point(&self, piece: &Piece3, z: DVec3) -> DVec3 {
        let rest = piece.map().apply(z);
        let plain = if self.plain == 0.0 { DVec3::ZERO } else { self.mesh.at(rest) * self.plain };
        match &self.body {
            Body::Corners(it) => {
                let (lattice, mut cursor, mut z) = (&it.lattice, piece.cursor.clone(), z);
                while cursor.letters() < lattice.depth() {
                    let (letter, inner) = lattice.part(z);
                    let depth = lattice.depth();
                    (cursor, z) = (cursor.child(letter, &self.raw.maps, depth, depth), inner);
                }
                rest + plain + it.shuffled(&cursor, z)
            }
            Body::Raw(_) => {
                let mut sum = rest + plain;
                let (kept, weights) = (self.terms.depth(), self.terms.fixed());
                let Some(weights) = weights else { return sum };
                self.raw.visit(&self.terms, weights, &piece.cursor, kept, [z], |_, from, factor, weight| {
                    sum += factor * self.mesh.at(from) * weight;
                });
                sum
            }
        }
    }

    /// An affine map through where the corners of a piece go, the plain displacement by its tangent amid the piece;
    /// these places, and how far the tangent is off.
    fn near(&self, cursor: &Cursor<Dim3>, it: &Cornered) -> (Near, [DVec3; MOST_CORNERS], f64) {
        let (map, corners) = (cursor.map(), &it.lattice.corners);
        let points = corners.points();
        let middle = map.apply(points.iter().sum::<DVec3>() / points.len() as f64);
        let (value, slope) =
            if self.plain == 0.0 { (DVec3::ZERO, DMat3::ZERO) } else { self.mesh.slope(middle) };
        let mut goals = [DVec3::ZERO; MOST_CORNERS];
        let mut far = 0.0_f64;
        for (goal, &corner) in goals.iter_mut().zip(points) {
            let point = map.apply(corner);
            far = far.max(point.distance_squared(middle));
            *goal = point + it.shuffled(cursor, corner) + (value + slope * (point - middle)) * self.plain;
        }
        let (origin, sides) = if corners.grid().is_some() {
            let side = |bit: usize| {
                let pairs = (0..8).filter(|i| i & bit == 0);
                pairs.map(|i| goals[i | bit] - goals[i]).sum::<DVec3>() * 0.25
            };
            let sides = DMat3::from_cols(side(1), side(2), side(4));
            (goals.iter().sum::<DVec3>() * 0.125 - sides * DVec3::splat(0.5), sides)
        } else {
            let side = |i: usize| goals[i] - goals[0];
            (goals[0], DMat3::from_cols(side(1), side(2), side(3)))
        };
        let frame = Affine3::new(sides, origin) * corners.frame();
        // What is interpolated between corners is off from an affine map by what it is off there, at most.
        let off = |(goal, &corner): (&DVec3, &DVec3)| frame.apply(corner).distance(*goal);
        let slack = 0.5 * self.plain * it.curvature * far;
        let off = goals.iter().zip(points).map(off).fold(0.0, f64::max) + slack;
        (Near { frame, off }, goals, slack)
    }

    /// With s_k the map of the letters beyond k and R_k that of the letters kb + 1 to k in reverse, term k looks at the
    /// piece H R_k s_k, H being the first kb letters.
    fn ball_of_terms(&self, cursor: &Cursor<Dim3>, round: &Round) -> Ball {
        let map = cursor.map();
        let mut centre = map.apply(round.point);
        let mut radius = map.stretch() * round.radius;
        let mut add = |from: Affine3, turn: Option<DMat3>, weight: f64| {
            let value = self.mesh.at(from.apply(round.point));
            let differs = round.steepness * from.stretch() * round.radius;
            match turn {
                Some(turn) => {
                    centre += turn * value * weight;
                    radius += weight * differs * Affine3::new(turn, DVec3::ZERO).stretch();
                }
                // It may point anywhere.
                None => radius += weight * (differs + value.length()),
            }
        };
        add(map, Some(DMat3::IDENTITY), self.plain);
        let Some(weights) = self.terms.fixed() else { return (centre, radius) };
        let word = cursor.kept(self.terms.depth());
        let mut rests = [Affine3::IDENTITY; DEEPEST_RAW + 1];
        rests[word.len()] = cursor.deep;
        for (k, &letter) in word.iter().enumerate().rev() {
            rests[k] = self.raw.maps[usize::from(letter)] * rests[k + 1];
        }
        for family in &self.terms.families {
            let letter = |k: usize| word.get(k).map(|&letter| usize::from(letter));
            let head = (0..family.kb)
                .filter_map(letter)
                .fold(Affine3::IDENTITY, |map, letter| map * self.raw.maps[letter]);
            let (mut block, mut turn) = (Affine3::IDENTITY, DMat3::IDENTITY);
            for (k, rest) in rests.iter().enumerate().take(family.end).skip(family.kb + 1) {
                let known = letter(k - 1);
                if let Some(letter) = known {
                    block = self.raw.maps[letter] * block;
                    turn *= self.raw.factors[letter];
                }
                let weight = if k < family.first { 0.0 } else { weights.list[family.slot(k)] };
                if weight == 0.0 {
                    continue;
                }
                match known {
                    Some(_) => add(head * block * *rest, Some(turn), weight),
                    None => {
                        let from = if word.len() <= family.kb { map } else { head };
                        add(from, (!self.raw.turned).then_some(DMat3::IDENTITY), weight);
                    }
                }
            }
        }
        (centre, radius * ROUNDED_UP)
    }
}

impl Cornered {
    /// The shuffled terms at the point that a piece's map takes `z` to: of a piece that is no larger than the finest
    /// cells, or at a corner of a larger one.
    fn shuffled(&self, cursor: &Cursor<Dim3>, z: DVec3) -> DVec3 {
        let cell = self.lattice.cell(cursor.letters().min(self.lattice.depth()), cursor.index as usize);
        let shares = self.lattice.corners.weights(cursor.deep.apply(z));
        cell.iter()
            .zip(shares)
            .fold(DVec3::ZERO, |sum, (&vertex, share)| sum + self.values[vertex as usize] * share)
    }

    fn new(
        ifs: &Ifs3,
        lattice: Arc<Lattice3>,
        mesh: &Mesh3,
        terms: &Terms,
        plain: f64,
        factors: &[DMat3],
    ) -> Result<Self, BendError> {
        let points = lattice.corners.points();
        let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
        let curvature = mesh.over(low, high)?.curvature();
        let samples: Vec<DVec3> = lattice.vertices.iter().map(|&vertex| mesh.at(vertex)).collect();
        // The roughness is the same all over.
        let values = lattice.cells().fill::<Dim3>(&samples, factors, terms, |_, _, _| 0.0);
        let goals: Vec<DVec3> = lattice
            .vertices
            .iter()
            .zip(&values)
            .zip(&samples)
            .map(|((&vertex, value), sample)| vertex + *value + *sample * plain)
            .collect();
        let count = points.len();
        let middle = points.iter().sum::<DVec3>() / count as f64;
        let far = points.iter().map(|point| point.distance_squared(middle)).fold(0.0, f64::max);
        let mut words = vec![1.0];
        for _ in 0..lattice.depth() {
            words = words
                .iter()
                .flat_map(|size| lattice.maps.iter().map(move |map| size * map.stretch()))
                .collect();
        }
        // Interpolated between corners a plain displacement is off by half its second derivative times the mean square
        // of how far these are, at most (Taylor at the point, the corners weighted so that their mean is the point).
        let slack = |size: f64| 0.5 * plain * curvature * far * size * size;
        let last = lattice.levels[lattice.depth()].cells.chunks_exact(count).zip(&words);
        let of_cell = |(cell, size): (&[u32], &f64)| {
            let mut list = [DVec3::ZERO; MOST_CORNERS];
            list.iter_mut().zip(cell).for_each(|(slot, &vertex)| *slot = goals[vertex as usize]);
            ball_around(&list[..count], slack(*size))
        };
        let mut balls: Vec<Vec<Ball>> = vec![last.map(of_cell).collect()];
        for _ in 0..lattice.depth() {
            let parts = balls[balls.len() - 1].chunks_exact(lattice.maps.len());
            balls.push(parts.map(ball_of_balls).collect());
        }
        balls.reverse();
        let Bounds3 { centre, radius, .. } = Bounds3::of(ifs);
        Ok(Self { lattice, values, balls, curvature, ball: (centre, radius) })
    }
}

/// A ball around points, with room around them.
fn ball_around(points: &[DVec3], room: f64) -> Ball {
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    let centre = 0.5 * (low + high);
    let far = points.iter().map(|point| point.distance_squared(centre)).fold(0.0, f64::max).sqrt();
    (centre, (far + room) * ROUNDED_UP + 1e-14 * centre.length())
}

fn ball_of_balls(balls: &[Ball]) -> Ball {
    let low = balls.iter().map(|(centre, radius)| *centre - *radius).fold(DVec3::INFINITY, DVec3::min);
    let high = balls.iter().map(|(centre, radius)| *centre + *radius).fold(DVec3::NEG_INFINITY, DVec3::max);
    let centre = 0.5 * (low + high);
    let far = balls.iter().map(|(point, radius)| point.distance(centre) + radius).fold(0.0, f64::max);
    (centre, far * ROUNDED_UP)
}

impl Round {
    fn new(ifs: &Ifs3, mesh: &Mesh3) -> Result<Self, BendError> {
        let bounds = Bounds3::of(ifs);
        let room = DVec3::splat((1e-6 * bounds.radius).max(1e-12 * bounds.centre.length()).max(1e-90));
        let steepness = mesh.over(bounds.min - room, bounds.max + room)?.steepness();
        // A point of the shape: its images are as well, so that all that is looked at lies in its box.
        let start = ifs.maps()[0].fixed_point().unwrap_or(bounds.centre);
        let orbit = (0..POINTS_TRIED).scan(start, |point, step| {
            let letter = frond_core::hash::counter(step as u32, 7) as usize % ifs.len();
            *point = ifs.maps()[letter].apply(*point);
            Some(*point)
        });
        let nearer = |a: &DVec3, b: &DVec3| a.distance(bounds.centre).total_cmp(&b.distance(bounds.centre));
        let point = orbit.min_by(nearer).unwrap_or(start);
        let radius = point.distance(bounds.centre) + bounds.radius;
        Ok(Self { point, radius, steepness })
    }
}
