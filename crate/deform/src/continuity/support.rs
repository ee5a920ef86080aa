//! What keeps the pieces of a bend together.

use frond_core::{Affine2, Hull, Ifs};
use glam::{DMat2, DVec2};

use crate::continuity::average::Average;
use crate::continuity::corners::Corners;
use crate::continuity::footing::Footing;
use crate::continuity::lattice::Lattice;
use crate::continuity::smooth::Smooth;
use crate::continuity::splat::Splat;
use crate::mesh::Mesh;
use crate::settings::Continuity;
use crate::shuffle::cursor::Cursor;
use crate::shuffle::level_terms::Source;
use crate::shuffle::terms::{DEEPEST, Terms};

/// How the shuffled terms are made continuous: as a table of a displacement for each of some nodes, and a rule of which
/// nodes a point hangs on.
#[derive(Clone, Debug)]
pub(crate) enum Support {
    /// Not at all: there is no table.
    Raw,
    Corners(Box<Smooth>),
    Splat(Box<Splat>),
    Average(Box<Average>),
}

/// What is known of a shape before it is bent.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub corners: Option<Corners>,
    /// A box around the shape, and a point amid it.
    pub low: DVec2,
    pub high: DVec2,
    pub middle: DVec2,
}

impl Shape {
    pub fn of(ifs: &Ifs, asked: Continuity) -> Self {
        let wanted = matches!(asked, Continuity::Auto | Continuity::Corners);
        if let Some(corners) = wanted.then(|| Corners::find(ifs.maps())).flatten() {
            let low = corners.points().iter().copied().fold(DVec2::INFINITY, DVec2::min);
            let high = corners.points().iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
            let middle = corners.points().iter().sum::<DVec2>() / corners.points().len() as f64;
            return Self { corners: Some(corners), low, high, middle };
        }
        let hull = Hull::of(ifs);
        // The point that the maps leave where it is on the average: the middle of what they do.
        let share = 1.0 / ifs.len() as f64;
        let mean = ifs.maps().iter().fold(Affine2::new(DMat2::ZERO, DVec2::ZERO), |sum, map| {
            Affine2::new(sum.linear + map.linear * share, sum.translation + map.translation * share)
        });
        let inside = |p: &DVec2| p.cmpge(hull.min()).all() && p.cmple(hull.max()).all();
        let middle = mean.fixed_point().filter(inside).unwrap_or(hull.centre());
        Self { corners: None, low: hull.min(), high: hull.max(), middle }
    }

    /// What is had where this is asked for.
    pub fn continuity(&self, asked: Continuity, maps: &[Affine2]) -> Continuity {
        match asked {
            Continuity::Auto | Continuity::Corners if self.corners.is_some() => Continuity::Corners,
            Continuity::Auto if is_tree(maps) => Continuity::Raw,
            Continuity::Auto | Continuity::Corners => Continuity::Splat,
            other => other,
        }
    }

    /// Points whose images tell where a piece goes: corners, or points about as far out as most of the shape.
    pub fn anchors(&self, continuity: Continuity) -> Vec<DVec2> {
        if let Some(corners) = self.corners.as_ref().filter(|_| continuity == Continuity::Corners) {
            return corners.anchors().into_iter().map(|i| corners.points()[i]).collect();
        }
        let (middle, half) = (0.5 * (self.low + self.high), 0.5 * (self.high - self.low));
        let half = half.max(DVec2::splat(1e-3 * half.max_element().max(1e-12)));
        let list: &[(f64, f64)] = match continuity {
            Continuity::Splat => &[(-0.7, -0.7), (0.7, -0.7), (0.7, 0.7), (-0.7, 0.7)],
            _ => &[(-0.7, -0.6), (0.7, -0.6), (0.0, 0.8)],
        };
        list.iter().map(|&(x, y)| middle + half * DVec2::new(x, y)).collect()
    }
}

/// Whether a shape looks like a tree: a map that flattens all (a stem), or areas that differ more than sixfold
/// (leaflets on a frond). Such pieces hardly touch, or only where one hides the other; what would glue them to their
/// neighbours would stop the leaflets from swaying.
fn is_tree(maps: &[Affine2]) -> bool {
    let flat = |map: &Affine2| {
        let (large, small) = map.singular_values();
        small <= 0.08 * large
    };
    let areas = maps.iter().map(|map| map.determinant().abs());
    let (least, most) = areas.fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
    maps.len() > 1 && (maps.iter().any(flat) || least < 0.15 * most)
}

impl Support {
    /// The most letters that memory allows.
    pub fn deepest(continuity: Continuity, maps: usize) -> usize {
        let most = match continuity {
            Continuity::Corners => Lattice::deepest(maps),
            Continuity::Splat => Splat::deepest(maps),
            Continuity::Average | Continuity::Published => Average::deepest(maps),
            Continuity::Raw | Continuity::Auto => DEEPEST,
        };
        most.min(DEEPEST)
    }

    pub fn new(continuity: Continuity, ifs: &Ifs, mesh: &Mesh, terms: &Terms, shape: &Shape) -> Self {
        let (maps, place) = (ifs.maps(), (shape.low, shape.high));
        match (continuity, &shape.corners) {
            (Continuity::Corners, Some(corners)) => {
                Self::Corners(Box::new(Smooth::new(Lattice::new(maps, corners.clone(), terms.depth()))))
            }
            (Continuity::Splat, _) => Self::Splat(Box::new(Splat::new(maps, terms, shape.middle, place))),
            (Continuity::Average | Continuity::Published, _) => {
                let all = continuity == Continuity::Published;
                Self::Average(Box::new(Average::new(ifs, mesh, terms, place, all)))
            }
            _ => Self::Raw,
        }
    }

    /// Whether the table holds all terms, also those that shuffle nothing.
    pub const fn holds_all(&self) -> bool {
        matches!(self, Self::Average(average) if average.averages_all())
    }

    /// The table: the shuffled terms at each node, or all of them.
    pub fn fill<S: Source>(&self, source: &S, mesh: &Mesh, terms: &Terms, factors: &[DMat2]) -> Vec<DVec2> {
        match self {
            Self::Raw => Vec::new(),
            Self::Corners(smooth) => smooth.fill(source, mesh, terms, factors),
            Self::Splat(splat) => splat.fill(source, mesh, terms, factors),
            Self::Average(average) => average.fill(source, mesh, terms, factors),
        }
    }

    /// Which nodes the point hangs on that a piece's map takes `z` to. `None` where there is no table.
    #[inline]
    pub fn footing(&self, cursor: &Cursor, kept: usize, z: DVec2) -> Option<Footing> {
        match self {
            Self::Raw => None,
            Self::Corners(smooth) => Some(smooth.footing(cursor, kept, z)),
            Self::Splat(splat) => Some(splat.footing(cursor.map.apply(z))),
            Self::Average(average) => Some(average.footing(cursor.map.apply(z))),
        }
    }
}
