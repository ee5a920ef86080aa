//! What a traversal keeps of a system, whatever camera looks at it.

use frond_core::{Affine3, Bounds3, Ifs3};
use glam::{DMat3, DVec3, Mat3A, Vec3A, Vec4};

/// Parts to a group: so many are computed side by side.
pub(super) const LANES: usize = 4;

/// A system in coordinates in which its maps contract. A shape that was flattened is carved as what it was flattened
/// from: its pieces are round there, and long here.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub maps: Vec<Affine3>,
    /// Takes these coordinates to those of the system.
    pub back: DMat3,
    /// A ball around it, in these coordinates.
    pub centre: DVec3,
    pub radius: f64,
    /// The parts of a piece in single precision, in groups.
    pub groups: Vec<Group>,
    /// Their linear parts.
    pub linear: Vec<Mat3A>,
    /// The largest of their sizes.
    pub largest: f32,
    /// All maps scale all lengths alike: the size of a piece is the product of the sizes of its letters.
    pub similar: bool,
}

/// Some parts of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    /// From the centre of the whole to theirs.
    pub x: Vec4,
    pub y: Vec4,
    pub z: Vec4,
    /// The radii of balls around them, if that of the whole is 1: upper bounds.
    pub size: Vec4,
}

/// Maps are similitudes to this part of their size.
const SIMILAR: f64 = 1e-9;
/// Bounds are taken this much larger: rounding must not make them too small.
const ROUNDED_UP: f64 = 1.0 + 1e-6;

impl Shape {
    /// The shape of a system with these bounds.
    pub fn new(ifs: &Ifs3, bounds: &Bounds3) -> Self {
        let contraction = ifs.contraction();
        let by = Affine3::new(contraction.to_round, DVec3::ZERO);
        let plain = contraction.to_round == DMat3::IDENTITY;
        // Where it cannot be, it is carved as it is.
        let round = if plain { None } else { ifs.conjugate(by).ok() };
        match round {
            Some(ifs) => Self::of(&ifs, contraction.from_round, &Bounds3::of(&ifs)),
            None => Self::of(ifs, DMat3::IDENTITY, bounds),
        }
    }

    fn of(ifs: &Ifs3, back: DMat3, &Bounds3 { centre, radius, .. }: &Bounds3) -> Self {
        let maps = ifs.maps().to_vec();
        let lane = |maps: &[Affine3], of: &dyn Fn(&Affine3) -> f64| {
            Vec4::from_array(std::array::from_fn(|i| maps.get(i).map_or(0.0, |map| of(map) as f32)))
        };
        let groups = maps.chunks(LANES).map(|maps| Group {
            x: lane(maps, &|map| (map.apply(centre) - centre).x),
            y: lane(maps, &|map| (map.apply(centre) - centre).y),
            z: lane(maps, &|map| (map.apply(centre) - centre).z),
            size: lane(maps, &|map| map.stretch() * ROUNDED_UP),
        });
        let groups: Vec<Group> = groups.collect();
        Self {
            linear: maps.iter().map(|map| single(map.linear)).collect(),
            largest: groups.iter().map(|group| group.size.max_element()).fold(0.0, f32::max),
            similar: maps.iter().all(|map| map.is_similitude(SIMILAR)),
            groups,
            maps,
            back,
            centre,
            radius,
        }
    }
}

/// What is smaller than this part of a matrix's largest entry is taken for 0.
const NOTHING_SHARE: f64 = 1e-12;

/// A matrix in single precision. What is left of an angle's rounding is let go: its squares would be numbers so small
/// that processors take a hundred times as long for them.
pub(super) fn single(m: DMat3) -> Mat3A {
    let least = NOTHING_SHARE * m.to_cols_array().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let entry = |x: f64| if x.abs() < least { 0.0 } else { x as f32 };
    let column = |k: usize| Vec3A::from_array(m.col(k).to_array().map(entry));
    Mat3A::from_cols(column(0), column(1), column(2))
}
