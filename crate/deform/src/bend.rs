//! A shape bent by a mesh, piece by piece.

use frond_core::{Affine2, Hull, Ifs};
use glam::{DMat2, DVec2};

use crate::corners::Corners;
use crate::cursor::Cursor;
use crate::error::BendError;
use crate::mesh::Mesh;
use crate::raw::Raw;
use crate::settings::{Continuity, Settings, Tint};
use crate::skin::{Pull, Skin, Turns};
use crate::smooth::Attribute;
use crate::terms::{DEEPEST, Terms};

/// A fractal deformation at one moment (Fujimoto et al., eqs 12, 18 and 19): where each piece of a shape goes.
///
/// Pieces are reached letter by letter with a [`Cursor`], and each is placed by where its anchors go.
#[derive(Clone, Debug)]
pub struct Bend {
    mesh: Mesh,
    raw: Raw,
    continuity: Continuity,
    settings: Settings,
    terms: Terms,
    anchors: Vec<DVec2>,
    hull: (DVec2, DVec2),
    tint: Option<(Mesh2, Terms, Vec<[f64; 3]>)>,
    kept: usize,
}

type Mesh2 = ();

impl Bend {
    /// The bend of the shape of `maps` by a mesh.
    ///
    /// # Errors
    /// [`BendError`].
    pub fn new(
        maps: &[Affine2],
        mesh: Mesh,
        settings: Settings,
        tint: Option<Tint>,
    ) -> Result<Self, BendError> {
        settings.check()?;
        let controls = mesh.columns() * mesh.rows();
        tint.as_ref().map_or(Ok(()), |tint| tint.check(controls))?;
        let ifs = Ifs::new(maps.to_vec())?;
        let hull = Hull::of(&ifs);
        let ke = settings.ke.min(DEEPEST as f64);
        let settings = Settings { ke, kb: settings.kb.min(ke), ..settings };
        let terms = |kb, ke: f64, roughness, spin, superposed| {
            Terms::new(kb, ke.min(DEEPEST as f64), roughness, spin, superposed)
        };
        let corners = Corners::find(maps);
        let continuity = match settings.continuity {
            Continuity::Auto | Continuity::Corners if corners.is_some() => Continuity::Corners,
            Continuity::Auto | Continuity::Corners => Continuity::Splat,
            asked => asked,
        };
        let centre = hull.centre();
        let half = (0.5 * (hull.max() - hull.min())).max(DVec2::splat(1e-3 * hull.radius().max(1e-9)));
        let anchors = corners.as_ref().filter(|_| continuity == Continuity::Corners).map_or_else(
            || {
                [(-0.7, -0.7), (0.7, -0.7), (0.7, 0.7), (-0.7, 0.7)]
                    .map(|(x, y)| centre + half * DVec2::new(x, y))
                    .to_vec()
            },
            |corners| corners.points().to_vec(),
        );
        let own = terms(settings.kb, settings.ke, settings.roughness, settings.spin, settings.superposed);
        let tint = tint.map(|tint| {
            let roughness = crate::Roughness::Constant(tint.roughness);
            ((), terms(tint.kb, tint.ke, roughness, crate::Spin::None, tint.superposed), tint.colours)
        });
        let kept = tint.as_ref().map_or(0, |(_, terms, _)| terms.depth()).max(own.depth());
        Ok(Self {
            mesh,
            raw: Raw::new(maps, settings.spin),
            continuity,
            settings,
            terms: own,
            anchors,
            hull: (hull.min(), hull.max()),
            tint,
            kept,
        })
    }

    /// Moves the control points.
    ///
    /// # Errors
    /// [`BendError::Mesh`]; the bend is then as it was.
    pub fn set_mesh(&mut self, displacements: &[DVec2]) -> Result<(), BendError> {
        let (low, high) = self.mesh.bounds();
        let (columns, rows) = (self.mesh.columns(), self.mesh.rows());
        self.mesh = Mesh::new(low, high, columns, rows, displacements.to_vec())?;
        Ok(())
    }

    /// The mesh as it is.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// What keeps pieces together: what [`Continuity::Auto`] came to, or what is had instead of what was asked for.
    #[must_use]
    pub const fn continuity(&self) -> Continuity {
        self.continuity
    }

    /// The detail as it is: what was asked for, or what memory allows.
    #[must_use]
    pub const fn ke(&self) -> f64 {
        self.settings.ke
    }

    /// The greatest detail that memory allows for this shape.
    #[must_use]
    pub const fn deepest(&self) -> usize {
        DEEPEST
    }

    /// No displacement of a point of the shape, or of an anchor, is longer.
    #[must_use]
    pub fn reach(&self) -> f64 {
        let _ = self.hull;
        2.0 * self.mesh.displacements().iter().map(|d| d.length()).fold(0.0, f64::max)
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
    #[must_use]
    pub fn child(&self, cursor: &Cursor, letter: usize) -> Cursor {
        let letter = letter.min(self.raw.maps.len() - 1);
        cursor.child(letter, &self.raw.maps[letter], self.kept)
    }

    /// Whether the displacement is smooth inside of the piece.
    #[must_use]
    pub fn even(&self, cursor: &Cursor) -> bool {
        cursor.letters() >= self.terms.depth()
    }

    /// Where the anchors of the piece go; the fourth repeats the third where there are three.
    #[must_use]
    pub fn displaced(&self, cursor: &Cursor) -> [DVec2; 4] {
        let at = |i: usize| self.point(cursor, self.anchors[i.min(self.anchors.len() - 1)]);
        [at(0), at(1), at(2), at(3)]
    }

    /// Where the point goes that the piece's map takes `z` to.
    #[must_use]
    pub fn point(&self, cursor: &Cursor, z: DVec2) -> DVec2 {
        let rest = cursor.map.apply(z);
        let weights = self.terms.at(&self.mesh, rest);
        let mut sum = self.mesh.at(rest) * weights.plain;
        self.raw.visit(&self.terms, &weights, cursor, self.kept, z, |from, factor, weight| {
            sum += factor * self.mesh.at(from) * weight;
        });
        rest + sum
    }

    /// The colour that is carried to that point, sRGB, 0 to 1, if the bend has any.
    #[must_use]
    pub fn colour(&self, cursor: &Cursor, z: DVec2) -> Option<[f64; 3]> {
        let (_, terms, colours) = self.tint.as_ref()?;
        let weights = terms.at(&self.mesh, DVec2::ZERO);
        let mut sum = [0.0; 3];
        let mut add = |from: DVec2, weight: f64| {
            self.mesh.blend(from, |i, share| {
                sum.iter_mut().zip(colours[i]).for_each(|(sum, x)| *sum += x * share * weight);
            });
        };
        add(cursor.map.apply(z), weights.plain);
        self.raw.visit(terms, &weights, cursor, self.kept, z, |from, _, weight| add(from, weight));
        Some(sum.map(|x| x.clamp(0.0, 1.0)))
    }

    /// These places, points of pieces as in [`Bend::point`], so that they follow the mesh.
    #[must_use]
    pub fn skin(&self, places: &[(Cursor, DVec2)]) -> Skin {
        let turns = Turns::of(&self.raw.factors);
        let pull = Pull::new(&self.mesh, turns);
        let mut skin = Skin::new(self.mesh.columns() * self.mesh.rows(), turns);
        let mut sum = vec![0.0; pull.width()];
        for (cursor, z) in places {
            let rest = cursor.map.apply(*z);
            let weights = self.terms.at(&self.mesh, rest);
            sum.fill(0.0);
            pull.add(rest, DMat2::IDENTITY, weights.plain, &mut sum);
            self.raw.visit(&self.terms, &weights, cursor, self.kept, *z, |from, factor, weight| {
                pull.add(from, factor, weight, &mut sum);
            });
            skin.push(rest, &sum);
        }
        skin
    }
}
