//! Graph-directed systems over number fields.

use std::sync::Arc;

use crate::error::ExactError;
use crate::number::field::{Element, Field};
use crate::number::interval::Interval;
use crate::number::matrix::Matrix;
use crate::number::rational::Rational;
use crate::number::roots::ComplexInterval;
use crate::number::value::Number;
use crate::system::real::MOST_DIMENSIONS;
use crate::system::sizes::Sizes;
use crate::system::space::Space;

/// The most states of a system that is given, and the most maps of all of them.
pub const MOST_STATES: usize = 1024;
/// See [`MOST_STATES`].
pub const MOST_MAPS: usize = 4096;
/// How often a state is looked at before copies of copies are given up.
const MOST_VISITS: usize = 4 * MOST_STATES;
/// The most rationals that a vector is made of.
const LARGEST_SIZE: usize = 32;

/// A graph-directed system of affine maps with exact numbers: state i is the union of `map(state from)` over its maps
/// (Mauldin & Williams 1988). State 0 is the one that is meant. A system of one state is an iterated function system.
#[derive(Clone, Debug)]
pub struct System {
    pub(crate) space: Space,
    pub(crate) states: Vec<Vec<Edge>>,
}

/// A map of a state, as it acts on vectors of rationals.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    pub from: usize,
    pub linear: Matrix,
    pub shift: Vec<Rational>,
    pub scaling: Scaling,
}

/// How a map changes lengths.
#[derive(Clone, Debug)]
pub(crate) enum Scaling {
    /// All by one factor, whose square this is where it is known.
    Similar(Option<Number>),
    /// Not all by one factor, as far as is known.
    Other,
}

impl Edge {
    /// Whether it is a state as it is.
    fn is_copy(&self) -> bool {
        self.linear == Matrix::identity(self.shift.len()) && self.shift.iter().all(Rational::is_zero)
    }

    pub const fn is_similar(&self) -> bool {
        matches!(self.scaling, Scaling::Similar(_))
    }
}

/// A map of real space: entries of its matrix row by row, and of its shift, in a real field.
#[derive(Clone, Debug)]
pub struct RealMap {
    /// The state whose copy this is.
    pub from: usize,
    /// The matrix, row by row.
    pub matrix: Vec<Element>,
    /// The shift.
    pub shift: Vec<Element>,
}

/// A map `z -> factor z + shift`, or with the conjugate of z.
#[derive(Clone, Debug)]
pub struct FieldMap {
    /// The state whose copy this is.
    pub from: usize,
    /// What z is multiplied by.
    pub factor: Element,
    /// What is added.
    pub shift: Element,
    /// Whether z is conjugated first.
    pub is_conjugated: bool,
}

/// A map of real space in doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleMap {
    /// The state whose copy this is.
    pub from: usize,
    /// The matrix, row by row; what is beyond the dimension is zero.
    pub matrix: [[f64; MOST_DIMENSIONS]; MOST_DIMENSIONS],
    /// The shift.
    pub shift: [f64; MOST_DIMENSIONS],
}

impl System {
    /// Maps of a line, a plane or space, with entries in a real field.
    ///
    /// # Errors
    /// Where the lists do not fit the dimension, a map has no inverse, the field is not real, or all is too large.
    pub fn of_matrices(
        field: &Arc<Field>,
        dimension: usize,
        states: &[Vec<RealMap>],
    ) -> Result<Self, ExactError> {
        if !field.is_real() {
            return Err(ExactError::NotReal);
        }
        if dimension == 0 || dimension > MOST_DIMENSIONS {
            return Err(ExactError::TooMany { count: dimension, most: MOST_DIMENSIONS });
        }
        let n = field.degree();
        let powers = powers(field, field.chosen());
        let row = |i: usize| {
            let entry = |k: usize| if k / n == i { powers[k % n].re } else { Interval::ZERO };
            (0..dimension * n).map(entry).collect()
        };
        let space = Space::new((0..dimension).map(row).collect())?;
        let edge = |map: &RealMap| {
            if map.matrix.len() != dimension * dimension || map.shift.len() != dimension {
                return Err(ExactError::Malformed);
            }
            if map.matrix.iter().chain(&map.shift).any(|x| x.0.len() != n) {
                return Err(ExactError::Malformed);
            }
            let blocks: Vec<Matrix> = map.matrix.iter().map(|x| field.multiplication(x)).collect();
            let columns: Vec<Vec<Rational>> = (0..dimension * n)
                .map(|k| (0..dimension).flat_map(|i| blocks[i * dimension + k / n].column(k % n)).collect())
                .collect();
            Ok(Edge {
                from: map.from,
                linear: Matrix::from_columns(&columns),
                shift: map.shift.iter().flat_map(|x| x.0.clone()).collect(),
                scaling: scaling_of_matrix(field, dimension, &map.matrix),
            })
        };
        Self::assembled(space, states, edge)
    }

    /// Maps of one line or plane, whose numbers are elements of a field: of a line where the field is real, else of
    /// the complex plane.
    ///
    /// # Errors
    /// As [`System::of_matrices`]; and where a conjugate is asked for that is not in the field.
    pub fn of_numbers(field: &Arc<Field>, states: &[Vec<FieldMap>]) -> Result<Self, ExactError> {
        Self::of_places(field, &[field.chosen()], states)
    }

    /// As [`System::of_numbers`], but each number acts by several of its conjugates at once: the places are numbers of
    /// roots of the polynomial of the field, a real one for a line, another for a plane. All together are at most
    /// three coordinates. (So are self-affine tiles of an expanding number, and windows of model sets.)
    ///
    /// # Errors
    /// As [`System::of_numbers`]. Maps that conjugate need one place alone.
    pub fn of_places(
        field: &Arc<Field>,
        places: &[usize],
        states: &[Vec<FieldMap>],
    ) -> Result<Self, ExactError> {
        let (mut rows, mut sizes) = (Vec::new(), Vec::new());
        for (k, &place) in places.iter().enumerate() {
            if place >= field.roots().len() || places[..k].contains(&place) {
                return Err(ExactError::Malformed);
            }
            let powers = powers(field, place);
            rows.push(powers.iter().map(|power| power.re).collect());
            if !field.roots()[place].is_real {
                rows.push(powers.iter().map(|power| power.im).collect::<Vec<_>>());
            }
            sizes.push(Sizes::new(field, place).ok());
        }
        let space = Space::new(rows)?;
        let edge = |map: &FieldMap| {
            if map.factor.0.len() != field.degree() || map.shift.0.len() != field.degree() {
                return Err(ExactError::Malformed);
            }
            let mut linear = field.multiplication(&map.factor);
            if map.is_conjugated {
                if places != [field.chosen()] {
                    return Err(ExactError::NoConjugate);
                }
                let conjugates: Option<Vec<_>> = (0..field.degree())
                    .map(|k| {
                        let unit = (0..field.degree()).map(|j| Rational::whole(i64::from(j == k))).collect();
                        field.conjugate(&Element(unit)).map(|element| element.0)
                    })
                    .collect();
                linear = linear.times(&Matrix::from_columns(&conjugates.ok_or(ExactError::NoConjugate)?));
            }
            let scaling = if places.len() == 1 {
                Scaling::Similar(sizes[0].as_ref().map(|sizes| sizes.square(&map.factor)))
            } else {
                Scaling::Other
            };
            Ok(Edge { from: map.from, linear, shift: map.shift.0.clone(), scaling })
        };
        Self::assembled(space, states, edge)
    }

    fn assembled<M>(
        space: Space,
        states: &[Vec<M>],
        edge: impl Fn(&M) -> Result<Edge, ExactError>,
    ) -> Result<Self, ExactError> {
        let maps: usize = states.iter().map(Vec::len).sum();
        if states.is_empty() || states.iter().any(Vec::is_empty) {
            return Err(ExactError::Malformed);
        }
        for (count, most) in [(states.len(), MOST_STATES), (maps, MOST_MAPS), (space.size(), LARGEST_SIZE)] {
            if count > most {
                return Err(ExactError::TooMany { count, most });
            }
        }
        let of_state = |maps: &Vec<M>| maps.iter().map(&edge).collect::<Result<Vec<_>, _>>();
        let states = states.iter().map(of_state).collect::<Result<Vec<_>, _>>()?;
        if states.iter().flatten().any(|edge| edge.from >= states.len()) {
            return Err(ExactError::Malformed);
        }
        Ok(Self { space, states })
    }

    /// One real matrix per map, from an iterated function system of exact numbers: the entries row by row, then the
    /// shift. The numbers may come from different fields.
    ///
    /// # Errors
    /// As [`System::of_matrices`]; and where the field of all numbers is too large.
    pub fn of_rows(dimension: usize, states: &[Vec<(usize, Vec<Number>)>]) -> Result<Self, ExactError> {
        let all: Vec<Number> = states.iter().flatten().flat_map(|(_, row)| row.clone()).collect();
        let (field, elements) = Number::in_one_field(&all)?;
        let mut rest = elements.into_iter();
        let squares = dimension * dimension;
        let mut made = Vec::new();
        for state in states {
            let mut maps = Vec::new();
            for (from, row) in state {
                if row.len() != squares + dimension {
                    return Err(ExactError::Malformed);
                }
                let matrix = rest.by_ref().take(squares).collect();
                maps.push(RealMap { from: *from, matrix, shift: rest.by_ref().take(dimension).collect() });
            }
            made.push(maps);
        }
        Self::of_matrices(&field, dimension, &made)
    }

    /// How many real coordinates points have.
    #[must_use]
    pub const fn dimension(&self) -> usize {
        self.space.dimension()
    }

    /// How many states there are.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.states.len()
    }

    /// The same shapes without maps that only copy a state as it is: that state's maps stand in for them. `None` where
    /// such copies go in a circle, or would be more than [`MOST_MAPS`].
    #[must_use]
    pub fn without_copies(&self) -> Option<Self> {
        let mut done: Vec<Option<Vec<Edge>>> = vec![None; self.states.len()];
        // A state waits for those that it copies; more states than there are wait in a circle.
        let mut waiting: Vec<usize> = (0..self.states.len()).rev().collect();
        let (mut maps, mut visits) = (0, 0);
        while let Some(&state) = waiting.last() {
            visits += 1;
            if done[state].is_some() {
                waiting.pop();
                continue;
            }
            let copied = |edge: &Edge| edge.is_copy().then_some(edge.from);
            let missing = self.states[state].iter().filter_map(copied).find(|&from| done[from].is_none());
            if let Some(missing) = missing {
                if waiting.len() > 2 * self.states.len() || visits > MOST_VISITS {
                    return None;
                }
                waiting.push(missing);
                continue;
            }
            let edges: Vec<Edge> = self.states[state]
                .iter()
                .flat_map(|edge| match done[edge.from].as_ref().filter(|_| edge.is_copy()) {
                    Some(others) => others.clone(),
                    None => vec![edge.clone()],
                })
                .collect();
            maps += edges.len();
            if maps > MOST_MAPS {
                return None;
            }
            done[state] = Some(edges);
            waiting.pop();
        }
        let states = done.into_iter().collect::<Option<_>>()?;
        Some(Self { space: self.space.clone(), states })
    }

    /// The maps of each state in doubles, to be drawn.
    #[must_use]
    pub fn in_doubles(&self) -> Vec<Vec<DoubleMap>> {
        let double = |edge: &Edge| DoubleMap {
            from: edge.from,
            matrix: self.space.action(&edge.linear).rows.map(|row| row.map(Interval::middle)),
            shift: self.space.point(&edge.shift).map(Interval::middle),
        };
        self.states.iter().map(|maps| maps.iter().map(double).collect()).collect()
    }
}

fn powers(field: &Field, place: usize) -> Vec<ComplexInterval> {
    let unit = |k: usize| (0..field.degree()).map(|j| Rational::whole(i64::from(j == k))).collect::<Vec<_>>();
    (0..field.degree()).map(|k| field.enclosure_at(&unit(k), place)).collect()
}

/// Similar, if the product of the transpose with the matrix is a multiple of the identity.
fn scaling_of_matrix(field: &Arc<Field>, dimension: usize, matrix: &[Element]) -> Scaling {
    let gram = |i: usize, j: usize| {
        (0..dimension).fold(field.zero(), |sum, k| {
            field.plus(&sum, &field.times(&matrix[k * dimension + i], &matrix[k * dimension + j]))
        })
    };
    let first = gram(0, 0);
    let pairs = (0..dimension).flat_map(|i| (0..=i).map(move |j| (i, j)));
    if pairs.into_iter().all(|(i, j)| if i == j { gram(i, j) == first } else { field.is_zero(&gram(i, j)) }) {
        return Scaling::Similar(Some(Number::new(field, first)));
    }
    Scaling::Other
}
