//! What is exchanged: the maps of one system.

use frond_core::{Affine2, Affine3, DirectedError, DirectedIfs, DirectedMap, Ifs, Ifs3};
pub use frond_scene::{DirectedCopy, Row, Row3};

use crate::ambient::Ambient;
use crate::text::name_or;

/// The maps of a system.
#[derive(Clone, Debug, PartialEq)]
pub enum Maps {
    /// Of the plane.
    Plane(Vec<Row>),
    /// Of space.
    Space(Vec<Row3>),
    /// Of the plane, and of several states, the shape first.
    Directed(Vec<Vec<DirectedCopy>>),
    /// Of space, and of several shapes that lie side by side.
    Objects(Vec<Vec<Row3>>),
}

/// From where a shape is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Camera {
    /// In the plane.
    Plane {
        /// The point in the middle.
        centre: [f64; 2],
        /// The radius of the largest disc around it that is in view.
        radius: f64,
        /// How far the view is turned, in degrees.
        angle: f64,
    },
    /// In space.
    Space {
        /// Where the camera stands.
        eye: [f64; 3],
        /// What it looks at.
        target: [f64; 3],
        /// What is above.
        up: [f64; 3],
        /// Its field of view, in degrees.
        field: f64,
    },
}

impl Maps {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Plane(rows) => rows.len(),
            Self::Space(rows) => rows.len(),
            Self::Directed(states) => states.iter().map(Vec::len).sum(),
            Self::Objects(objects) => objects.iter().map(Vec::len).sum(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The numbers of each map, of all states and objects.
    #[must_use]
    pub fn rows(&self) -> Vec<&[f64]> {
        match self {
            Self::Plane(rows) => rows.iter().map(|row| &row[..]).collect(),
            Self::Space(rows) => rows.iter().map(|row| &row[..]).collect(),
            Self::Directed(states) => states.iter().flatten().map(|copy| &copy.map[..]).collect(),
            Self::Objects(objects) => objects.iter().flatten().map(|row| &row[..]).collect(),
        }
    }
}

/// A system of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct System {
    /// Its name there.
    pub name: String,
    /// Its maps.
    pub maps: Maps,
    /// How often each is chosen in the chaos game, as it is given: one for each map, none negative, their sum finite
    /// and above 0, but it need not be 1. Empty where nothing is said.
    pub probabilities: Vec<f64>,
    /// The colour of each map, red, green and blue. Empty where nothing is said.
    pub colours: Vec<[u8; 3]>,
    /// What was left out or changed in reading it, a sentence each.
    pub remarks: Vec<String>,
    /// The view that its file has.
    pub camera: Option<Camera>,
    /// The exact system that its maps were computed from, where it is known.
    pub ambient: Option<Ambient>,
}

impl System {
    /// A system of which no more is known.
    #[must_use]
    pub const fn of(name: String, maps: Maps) -> Self {
        Self {
            name,
            maps,
            probabilities: Vec::new(),
            colours: Vec::new(),
            remarks: Vec::new(),
            camera: None,
            ambient: None,
        }
    }

    /// A system of the plane.
    #[must_use]
    pub const fn plane(name: String, maps: Vec<Row>) -> Self {
        Self::of(name, Maps::Plane(maps))
    }

    /// A system of space.
    #[must_use]
    pub const fn space(name: String, maps: Vec<Row3>) -> Self {
        Self::of(name, Maps::Space(maps))
    }

    /// Whether it has an attractor that can be drawn.
    ///
    /// # Errors
    /// [`DirectedError`] where it has none.
    pub fn check(&self) -> Result<(), DirectedError> {
        match &self.maps {
            Maps::Directed(states) => {
                let map =
                    |copy: &DirectedCopy| DirectedMap { from: copy.from, map: Affine2::from_row(copy.map) };
                DirectedIfs::new(states.iter().map(|maps| maps.iter().map(map).collect()).collect())
                    .map(|_| ())
            }
            Maps::Objects(objects) => objects.iter().try_for_each(|rows| solid(rows).map(|_| ())),
            _ => self.found_probabilities().map(|_| ()),
        }
    }

    /// Its name in one line, fit for a remark of a program.
    pub(crate) fn title(&self) -> String {
        name_or(&self.name, "Maps")
    }

    /// The probabilities: those given, else in proportion to what each map leaves of areas; equal where there is no
    /// attractor.
    pub(crate) fn weights(&self) -> Vec<f64> {
        let count = self.maps.len();
        if self.probabilities.iter().any(|weight| *weight > 0.0) {
            return self.probabilities.clone();
        }
        self.found_probabilities().unwrap_or_else(|_| vec![1.0 / count.max(1) as f64; count])
    }

    /// Whether the probabilities can be written: none, or one for each map, none negative, with a finite sum.
    pub(crate) fn has_sound_weights(&self) -> bool {
        let given = &self.probabilities;
        (given.is_empty() || given.len() == self.maps.len())
            && given.iter().all(|weight| *weight >= 0.0)
            && given.iter().sum::<f64>().is_finite()
    }

    /// Takes the weights of a file, one place for each map. They are taken where each has one, or not at all, which is
    /// said. What is negative counts as if it were not, which is said, too.
    pub(crate) fn take_weights(&mut self, weights: &[Option<f64>]) {
        let Some(given) = weights.iter().copied().collect::<Option<Vec<f64>>>() else {
            if let Some(without) = weights.iter().position(Option::is_none)
                && weights.iter().any(Option::is_some)
            {
                self.remarks.push(format!(
                    "Map {} has no weight and others have one: all weights are left out. Give each map one.",
                    without + 1
                ));
            }
            return;
        };
        let negative = given.iter().filter(|weight| **weight < 0.0).count();
        if negative > 0 {
            let which =
                if negative == 1 { "One weight is".into() } else { format!("{negative} weights are") };
            self.remarks.push(format!("{which} negative: taken without the sign."));
        }
        let given: Vec<f64> = given.into_iter().map(f64::abs).collect();
        let sum: f64 = given.iter().sum();
        let why = match sum {
            _ if given.is_empty() => return,
            0.0 => "The weights are all 0",
            _ if sum.is_finite() => {
                self.probabilities = given;
                return;
            }
            _ => "The weights are too large: their sum is not finite",
        };
        self.remarks.push(format!("{why}. They are left out."));
    }

    fn found_probabilities(&self) -> Result<Vec<f64>, DirectedError> {
        match &self.maps {
            Maps::Plane(rows) => {
                let maps = rows.iter().map(|&row| Affine2::from_row(row)).collect();
                Ok(Ifs::new(maps)?.probabilities().to_vec())
            }
            Maps::Space(rows) => Ok(solid(rows)?.probabilities().to_vec()),
            // Each state has its own.
            Maps::Directed(_) | Maps::Objects(_) => Ok(Vec::new()),
        }
    }
}

fn solid(rows: &[Row3]) -> Result<Ifs3, DirectedError> {
    Ok(Ifs3::new(rows.iter().map(|&row| Affine3::from_row(row)).collect())?)
}
