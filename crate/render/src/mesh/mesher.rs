//! A mesh in the making.

use frond_core::{Affine3, Bounds3, Ifs3, affinity_dimension};
use glam::DVec3;
use thiserror::Error;

use super::field::Field;
use super::orbit::Orbit;
use super::surface::Mesh;
use super::well_composed::make_well_composed;
use crate::solid::MAX_OBJECTS;

/// The fewest samples along the longest side.
pub const LEAST_FINENESS: f64 = 16.0;
/// The most samples along the longest side.
pub const MOST_FINENESS: f64 = 640.0;
/// The most samples of a grid: ten bytes each.
pub const MOST_SAMPLES: usize = 32_000_000;
/// The most triangles: a file of 300 MB.
pub const MOST_TRIANGLES: usize = 6_000_000;
/// The most points that an attractor is covered with.
const MOST_POINTS: usize = 40_000_000;
/// Half the thinnest wall that the grid shows, in samples.
const LEAST_RADIUS: f64 = 1.5;
/// Samples around all of it.
const MARGIN: f64 = 2.0;
/// Points lie this much closer than samples, or than the wall is thick.
const POINTS_PER_SAMPLE: f64 = 2.0;
const POINTS_PER_RADIUS: f64 = 4.0;
/// From this dimension on a point a sample is enough: it is nearly a body.
const BODY_DIMENSION: f64 = 2.6;
/// What is this much smaller than its coordinates is a point.
const POINT_SIZE: f64 = 1e-12;

/// How a mesh is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// Samples along the longest side.
    pub fineness: f64,
    /// The longest side, in millimetres.
    pub size: f64,
    /// How thick it is at least, in millimetres. The grid may ask for more.
    pub wall: f64,
}

/// Why there is no mesh.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MeshError {
    /// No objects, or too many.
    #[error("There are {count} objects, and a mesh is made of 1 to {MAX_OBJECTS}.")]
    Objects {
        /// How many there are.
        count: usize,
    },
    /// The fineness is none.
    #[error("The fineness is from 16 to 640 samples.")]
    Fineness,
    /// The size is none.
    #[error("The size is from 0.1 to 10000 millimetres.")]
    Size,
    /// The wall is as thick as the whole.
    #[error(
        "The walls would be {wall:.2} mm thick, and the whole is {size:.2} mm. Make the walls thinner, or all of it larger or finer."
    )]
    Wall {
        /// How thick they would be.
        wall: f64,
        /// How large the whole is.
        size: f64,
    },
    /// Coordinates overflow.
    #[error("The shapes are too large or too far away to be measured. Move them nearer to the origin.")]
    NotFinite,
    /// The grid is too large.
    #[error("This takes a grid of {} million samples, and the most is 32 million. Choose a lower fineness.", .samples / 1_000_000)]
    TooFine {
        /// Its samples.
        samples: usize,
    },
    /// There are too many points.
    #[error("This takes more than 40 million points. Choose a lower fineness, or thicker walls.")]
    TooManyPoints,
    /// There are too many triangles.
    #[error("This would be {:.1} million triangles, and the most is 6 million. Choose a lower fineness, or thicker walls.", *.triangles as f64 / 1e6)]
    TooManyTriangles {
        /// How many.
        triangles: usize,
    },
}

impl MeshError {
    /// A short name.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Objects { .. } => "mesh-objects",
            Self::Fineness => "mesh-fineness",
            Self::Size => "mesh-size",
            Self::Wall { .. } => "mesh-wall",
            Self::NotFinite => "not-finite",
            Self::TooFine { .. } => "mesh-too-fine",
            Self::TooManyPoints => "mesh-too-many-points",
            Self::TooManyTriangles { .. } => "mesh-too-many-triangles",
        }
    }
}

/// What is still to be done for an object.
struct Part {
    orbit: Orbit,
    /// From coordinates of the orbit to samples.
    shift: DVec3,
    /// The code of its first map.
    code: u16,
}

/// A mesh in the making: made, it [runs](Mesher::run) until all points are found, and [ends](Mesher::finish) with the
/// mesh.
pub struct Mesher {
    waiting: Vec<Part>,
    field: Field,
    options: MeshOptions,
    step: f64,
    radius: f64,
    found: usize,
    is_point: bool,
}

impl Mesher {
    /// Of these systems, as one body. Vertices have as codes the numbers of their first maps, counted through all
    /// systems.
    ///
    /// # Errors
    /// If there are no systems, or a mesh of this fineness would be too large.
    pub fn new(systems: &[Ifs3], options: MeshOptions) -> Result<Self, MeshError> {
        let MeshOptions { fineness, size, wall } = options;
        if systems.is_empty() || systems.len() > MAX_OBJECTS {
            return Err(MeshError::Objects { count: systems.len() });
        }
        if !(LEAST_FINENESS..=MOST_FINENESS).contains(&fineness) {
            return Err(MeshError::Fineness);
        }
        if !(0.1..=10_000.0).contains(&size) {
            return Err(MeshError::Size);
        }
        // In units of samples from here on.
        let step = size / fineness;
        let radius = (0.5 * wall / step).max(LEAST_RADIUS);
        if 2.0 * radius > 0.9 * fineness {
            return Err(MeshError::Wall { wall: 2.0 * radius * step, size });
        }
        let bounds: Vec<Bounds3> = systems.iter().map(Bounds3::of).collect();
        let least = bounds.iter().map(|b| b.min).fold(DVec3::INFINITY, DVec3::min);
        let largest = bounds.iter().map(|b| b.max).fold(DVec3::NEG_INFINITY, DVec3::max);
        let longest = (largest - least).max_element();
        let is_point = longest <= POINT_SIZE * least.abs().max(largest.abs()).max_element();
        let scale = if is_point { 0.0 } else { (fineness - 2.0 * radius) / longest };
        if !(longest.is_finite() && scale.is_finite()) {
            return Err(MeshError::NotFinite);
        }
        let border = radius + MARGIN;
        let grid = ((largest - least) * scale + 2.0 * border).to_array().map(|side| side.ceil() as usize + 1);
        let samples = grid.iter().product();
        if samples > MOST_SAMPLES {
            return Err(MeshError::TooFine { samples });
        }
        let mut code = 0_usize;
        let part = |(ifs, bounds): (&Ifs3, &Bounds3)| {
            let first = code;
            code += ifs.len();
            let moved =
                |map: &Affine3| Affine3::new(map.linear, (map.apply(bounds.min) - bounds.min) * scale);
            let body = affinity_dimension(ifs) > BODY_DIMENSION;
            let sample = if body { 1.0 } else { 1.0 / POINTS_PER_SAMPLE };
            let cell = sample.max(radius / POINTS_PER_RADIUS);
            let extent = (bounds.max - bounds.min) * scale;
            Part {
                orbit: Orbit::new(ifs, ifs.maps().iter().map(moved).collect(), extent, cell),
                shift: (bounds.min - least) * scale + border,
                code: first as u16,
            }
        };
        let waiting = systems.iter().zip(&bounds).map(part).collect();
        Ok(Self { waiting, field: Field::new(grid, radius), options, step, radius, found: 0, is_point })
    }

    /// Takes about `budget` points further. Whether all are found.
    ///
    /// # Errors
    /// If there are too many.
    pub fn run(&mut self, budget: usize) -> Result<bool, MeshError> {
        let Some(Part { orbit, shift, code }) = self.waiting.last_mut() else { return Ok(true) };
        let done = orbit.run(budget, |point, letter| self.field.put(point + *shift, *code + letter as u16));
        let found = self.found + orbit.found();
        if found > MOST_POINTS {
            return Err(MeshError::TooManyPoints);
        }
        if done {
            self.found = found;
            self.waiting.pop();
        }
        Ok(self.waiting.is_empty())
    }

    /// So many points were found.
    #[must_use]
    pub fn found(&self) -> usize {
        self.found + self.waiting.last().map_or(0, |part| part.orbit.found())
    }

    /// How thick it is at least, in millimetres: what was asked for, or the least that the grid shows.
    #[must_use]
    pub fn wall(&self) -> f64 {
        2.0 * self.radius * self.step
    }

    /// The surface.
    ///
    /// # Errors
    /// If it has too many triangles.
    pub fn finish(mut self) -> Result<Mesh, MeshError> {
        while !self.run(1_000_000)? {}
        self.field.signed();
        make_well_composed(&mut self.field);
        self.field.fill_hollows();
        let triangles = 2 * self.field.crossings();
        if triangles > MOST_TRIANGLES {
            return Err(MeshError::TooManyTriangles { triangles });
        }
        let mut mesh = Mesh::of(&self.field);
        drop(self.field);
        let [least, largest] = mesh.bounds();
        let longest = f64::from((largest - least).max_element());
        // What bounds are too wide by, and surface nets too narrow.
        let scale = if self.is_point { self.step } else { self.options.size / longest };
        mesh.place(scale as f32);
        Ok(mesh)
    }
}
