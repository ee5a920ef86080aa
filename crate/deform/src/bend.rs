//! A shape bent by a mesh, piece by piece.

use std::sync::OnceLock;

use frond_core::{Affine2, Ifs};
use glam::DVec2;

use crate::continuity::footing::Footing;
use crate::continuity::support::{Shape, Support};
use crate::error::BendError;
use crate::mesh::Mesh;
use crate::region::region;
use crate::settings::{Continuity, Roughness, Settings, Tint};
use crate::shuffle::cursor::Cursor;
use crate::shuffle::level_terms::One;
use crate::shuffle::place_terms::Raw;
use crate::shuffle::spin::Spin;
use crate::shuffle::terms::Terms;

/// A fractal deformation at one moment (Fujimoto et al., eqs 12, 18 and 19): where each piece of a shape goes.
///
/// Pieces are reached letter by letter with a [`Cursor`], and each is placed by where its anchors go:
///
/// ```
/// use frond_core::Affine2;
/// use frond_deform::{Bend, Continuity, Mesh, Roughness, Settings, Spin};
/// use glam::DVec2;
///
/// let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
/// let gasket = corners.map(|corner| Affine2::similitude(0.5, 0.0, 0.5 * corner));
/// let mut mesh = Mesh::at_rest(DVec2::ZERO, DVec2::ONE, 4, 4)?;
/// let settings = Settings {
///     kb: 0.0,
///     ke: 9.0,
///     roughness: Roughness::Constant(0.75),
///     spin: Spin::None,
///     continuity: Continuity::Auto,
///     superposed: true,
/// };
/// let mut bend = Bend::new(&gasket, mesh, settings, None)?;
/// let mut moves = vec![DVec2::ZERO; 16];
/// moves[1] = DVec2::new(0.0, 0.3);
/// bend.set_mesh(&moves)?;
/// let piece = bend.child(&bend.child(&bend.whole(), 2), 0);
/// assert!(bend.displaced(&piece)[1].y > 0.5);
/// # Ok::<(), frond_deform::BendError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bend {
    pub(crate) mesh: Mesh,
    pub(crate) raw: Raw,
    pub(crate) terms: Terms,
    pub(crate) support: Support,
    continuity: Continuity,
    ke: f64,
    /// How many letters cursors keep, and how many count for the number of a word.
    pub(crate) kept: usize,
    counted: usize,
    anchors: Vec<DVec2>,
    /// Which corners the anchors are, where there are corners.
    corners: Vec<usize>,
    /// What the evaluation may look at.
    region: (DVec2, DVec2),
    /// The shuffled terms at the nodes of the support, and the sum of their weights where it is not the same all over.
    pub(crate) values: Vec<DVec2>,
    shares: Vec<f64>,
    /// Where the vertices of the lattice go, where there is one.
    goals: Vec<DVec2>,
    tint: Option<(Terms, Vec<[f64; 3]>)>,
    /// How much each control point moves each node, made when it is first asked for.
    pub(crate) pulls: OnceLock<Vec<f32>>,
}

impl Bend {
    /// The bend of the shape of `maps` by a mesh.
    ///
    /// # Errors
    /// [`BendError`]: for maps without an attractor, a locality above the detail, and numbers that are none.
    pub fn new(
        maps: &[Affine2],
        mesh: Mesh,
        settings: Settings,
        tint: Option<Tint>,
    ) -> Result<Self, BendError> {
        settings.check()?;
        tint.as_ref().map_or(Ok(()), |tint| tint.check(mesh.displacements().len()))?;
        let ifs = Ifs::new(maps.to_vec())?;
        let shape = Shape::of(&ifs, settings.continuity);
        let continuity = shape.continuity(settings.continuity, maps);
        let ke = settings.ke.min(Support::deepest(continuity, maps.len()) as f64);
        let Settings { kb, roughness, spin, superposed, .. } = settings;
        let terms = Terms::new(kb, ke, roughness, spin, superposed);
        let tint = tint.map(|tint| {
            let Tint { colours, kb, ke, roughness, superposed } = tint;
            (Terms::new(kb, ke, Roughness::Constant(roughness), Spin::None, superposed), colours)
        });
        let kept = tint.as_ref().map_or(0, |(terms, _)| terms.depth()).max(terms.depth());
        let anchors = shape.anchors(continuity);
        let corners = shape.corners.as_ref().map_or_else(Vec::new, |corners| corners.anchors());
        let mut this = Self {
            region: region(&ifs, &shape, &anchors),
            raw: Raw::new(maps, spin),
            support: Support::new(continuity, &ifs, &mesh, &terms, &shape),
            counted: if continuity == Continuity::Corners { terms.depth() } else { 0 },
            continuity,
            ke,
            kept,
            anchors,
            corners,
            mesh,
            terms,
            values: Vec::new(),
            shares: Vec::new(),
            goals: Vec::new(),
            tint,
            pulls: OnceLock::new(),
        };
        if this.terms.fixed().is_none() {
            let shares = this.support.fill(&One, &this.mesh, &this.terms, &[]);
            this.shares = shares.into_iter().map(|share| share.x).collect();
        }
        this.refresh();
        Ok(this)
    }

    /// Moves the control points: all that hangs on the shape alone is kept.
    ///
    /// # Errors
    /// [`BendError::Mesh`]; the bend is then as it was.
    pub fn set_mesh(&mut self, displacements: &[DVec2]) -> Result<(), BendError> {
        self.mesh = self.mesh.moved(displacements)?;
        self.refresh();
        Ok(())
    }

    fn refresh(&mut self) {
        let turning = self.raw.turning();
        let Support::Corners(smooth) = &self.support else {
            self.values = self.support.fill(&self.mesh, &self.mesh, &self.terms, turning);
            return;
        };
        let samples = smooth.samples(&self.mesh);
        self.values = smooth.fill_from(&samples, true, &self.mesh, &self.terms, turning);
        let all = self.terms.fixed().map_or(1.0, |weights| weights.plain);
        let goal = |(((i, &vertex), value), sample): (((usize, &DVec2), &DVec2), &DVec2)| {
            vertex + *value + *sample * (all - self.shares.get(i).unwrap_or(&0.0))
        };
        let vertices = smooth.lattice().vertices().iter().enumerate();
        self.goals = vertices.zip(&self.values).zip(&samples).map(goal).collect();
    }

    /// What keeps pieces together: what [`Continuity::Auto`] came to, or what is had instead of what was asked for.
    #[must_use]
    pub const fn continuity(&self) -> Continuity {
        self.continuity
    }

    /// The detail as it is: what was asked for, or what memory allows.
    #[must_use]
    pub const fn ke(&self) -> f64 {
        self.ke
    }

    /// The greatest detail that memory allows for this shape and continuity.
    #[must_use]
    pub fn deepest(&self) -> usize {
        Support::deepest(self.continuity, self.raw.maps.len())
    }

    /// The mesh as it is now.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// No displacement of a point of the shape, or of an anchor, is longer; in units of the plane.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.mesh.reach(self.region.0, self.region.1)
    }

    /// Three points, or the four corners of a parallelogram in cyclic order, of the plane: those of a piece are their
    /// images under its map.
    #[must_use]
    pub fn anchors(&self) -> &[DVec2] {
        &self.anchors
    }

    /// The word of no letters.
    #[must_use]
    pub const fn whole(&self) -> Cursor {
        Cursor::WHOLE
    }

    /// One letter more. There must be a map of that number; if there is not, the last is taken.
    #[inline]
    #[must_use]
    pub fn child(&self, cursor: &Cursor, letter: usize) -> Cursor {
        let letter = letter.min(self.raw.maps.len() - 1);
        cursor.child(letter, &self.raw.maps, self.kept, self.counted)
    }

    /// Whether the displacement is smooth inside of the piece: its word is as long as the deepest term that counts.
    #[inline]
    #[must_use]
    pub fn even(&self, cursor: &Cursor) -> bool {
        cursor.letters() >= self.terms.depth()
    }

    /// Where the anchors of the piece go; the fourth repeats the third where there are three.
    #[inline]
    #[must_use]
    pub fn displaced(&self, cursor: &Cursor) -> [DVec2; 4] {
        let last = self.anchors.len() - 1;
        if let Support::Corners(smooth) = &self.support
            && cursor.letters() <= self.counted
        {
            let cell = smooth.lattice().cell(cursor.letters(), cursor.index as usize);
            return std::array::from_fn(|i| self.goals[cell[self.corners[i.min(last)]] as usize]);
        }
        let anchors = |i: usize| self.anchors[i.min(last)];
        if let (Support::Raw, Some(weights), 2) = (&self.support, self.terms.fixed(), last) {
            // All at once: what is known of the word serves all three.
            let zs = [anchors(0), anchors(1), anchors(2)];
            let mut goals = zs.map(|z| cursor.map.apply(z));
            goals.iter_mut().for_each(|goal| *goal += self.mesh.at(*goal) * weights.plain);
            self.raw.visit(&self.terms, weights, cursor, self.kept, zs, |i, from, factor, weight| {
                goals[i] += factor * self.mesh.at(from) * weight;
            });
            return [goals[0], goals[1], goals[2], goals[2]];
        }
        let mut list = [DVec2::ZERO; 4];
        for (slot, &anchor) in list.iter_mut().zip(&self.anchors) {
            *slot = self.point(cursor, anchor);
        }
        if last < 3 {
            list[3] = list[2];
        }
        list
    }

    /// Where the point goes that the piece's map takes `z` to.
    ///
    /// A word that is too short to be shuffled goes on: with corners, through the pieces that hold the point; else with
    /// the letter whose fixed point is nearest, over and over.
    #[must_use]
    pub fn point(&self, cursor: &Cursor, z: DVec2) -> DVec2 {
        let rest = cursor.map.apply(z);
        if let Some(footing) = self.support.footing(cursor, self.kept, z) {
            let shuffled: DVec2 = footing.iter().map(|(node, share)| self.values[node] * share).sum();
            let plain = self.plain(&footing);
            return if plain == 0.0 { rest + shuffled } else { rest + shuffled + self.mesh.at(rest) * plain };
        }
        let mut room = None;
        let weights = self.terms.at(&self.mesh, rest, &mut room);
        let mut sum = self.mesh.at(rest) * weights.plain;
        self.raw.visit(&self.terms, weights, cursor, self.kept, [z], |_, from, factor, weight| {
            sum += factor * self.mesh.at(from) * weight;
        });
        rest + sum
    }

    /// What the displacement counts that is not shuffled.
    #[inline]
    pub(crate) fn plain(&self, footing: &Footing) -> f64 {
        match self.terms.fixed() {
            _ if self.support.holds_all() => 0.0,
            Some(weights) => weights.plain,
            None => 1.0 - footing.iter().map(|(node, share)| self.shares[node] * share).sum::<f64>(),
        }
    }

    /// The colour that is carried to that point, sRGB, 0 to 1, if the bend has any.
    #[must_use]
    pub fn colour(&self, cursor: &Cursor, z: DVec2) -> Option<[f64; 3]> {
        let (terms, colours) = self.tint.as_ref()?;
        let mut room = None;
        let rest = cursor.map.apply(z);
        let weights = terms.at(&self.mesh, rest, &mut room);
        let mut sum = [0.0; 3];
        let mut add = |from: DVec2, weight: f64| {
            self.mesh.blend(from, |i, share| {
                sum.iter_mut().zip(colours[i]).for_each(|(sum, x)| *sum += x * share * weight);
            });
        };
        add(rest, weights.plain);
        self.raw.visit(terms, weights, cursor, self.kept, [z], |_, from, _, weight| add(from, weight));
        Some(sum.map(|x| x.clamp(0.0, 1.0)))
    }
}
