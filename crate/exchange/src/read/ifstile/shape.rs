//! From the sets of a block to what is drawn: a system of the plane, a graph-directed one, or one of space.

use std::rc::Rc;

use frond_core::{Affine3, MAX_MAPS, MAX_STATES};
use frond_scene::{DirectedCopy, Row3};

use super::affine::Affine;
use super::machine::Machine;
use super::number::Number;
use super::rational::Rational;
use super::roots::simple_modulo;
use super::sets::Graph;
use super::similar::{product, similar};
use super::subspace::{Drawn, Projection, polynomial};
use super::value::{Image, Value};
use crate::ambient::{Ambient, AmbientMap};
use crate::read::problem::ImportError;
use crate::system::{Camera, Maps, System};
use crate::text::short;

/// As many objects as a document of space may have.
const MOST_OBJECTS: usize = frond_scene::MAX_OBJECTS3;

/// Images of states, in space.
type Solid = Vec<Vec<(usize, Affine3)>>;

impl<'a> Machine<'_, 'a> {
    /// The system of a graph.
    pub fn shape(&mut self, graph: &Graph<'a>) -> Result<System, ImportError> {
        let size = self.size();
        let projection = self.projection()?;
        let mut drawn: Vec<Vec<(usize, Drawn)>> = Vec::new();
        for (k, images) in graph.states.iter().enumerate() {
            self.line = graph.lines[k];
            let mut all = Vec::new();
            for (j, image) in images.iter().enumerate() {
                self.charge(size.pow(2) * image.map.words())?;
                let Some(map) = self.drawn(&image.map, projection.as_ref())? else {
                    let name = short(graph.names[k], 20);
                    return self.fail(format!(
                        "Map {} of “{name}” does not act on the subspace of $subspace: it mixes it with the other cells. \
                         Choose a matrix that all maps respect.",
                        j + 1
                    ));
                };
                all.push((image.set, map));
            }
            drawn.push(all);
        }
        let dimensions = drawn.iter().flatten().next().map_or(2, |(_, (_, shift))| shift.len());
        if projection.is_some() {
            straighten(&mut drawn, dimensions);
        }
        let mut remarks = Vec::new();
        self.line = graph.lines[0];
        let maps = match dimensions {
            1 | 2 => self.plane(graph, &drawn, dimensions, &mut remarks)?,
            3 => self.solid(graph, &drawn, &mut remarks)?,
            more => {
                return self.fail(format!(
                    "The maps have {more} dimensions, and 1 to 3 are drawn. Choose a part of the space by $subspace=[M,0]."
                ));
            }
        };
        let mut system = System::of(String::new(), maps);
        if let Some(projection) = &projection {
            self.contracts(&system, graph)?;
            remarks.extend(self.camera_left_out());
            system.ambient = ambient(graph, Some(projection), size);
        } else {
            system.camera = self.camera(dimensions)?;
            system.ambient = ambient(graph, None, size);
        }
        system.remarks = remarks;
        Ok(system)
    }

    /// What `$subspace` says.
    fn projection(&mut self) -> Result<Option<Projection>, ImportError> {
        let Some(definition) = self.definition("$subspace") else { return Ok(None) };
        let value = self.computed(definition)?;
        self.line = definition.line;
        let parts = match &value {
            Value::List(list) => list.to_vec(),
            _ => Vec::new(),
        };
        let [matrix, cells @ ..] = parts.as_slice() else {
            return self.fail("$subspace is a matrix and its cells: $subspace=[M,0].");
        };
        let matrix = self.single(matrix.clone())?;
        if matrix.size != self.size() {
            let (one, other) = (matrix.size, self.size());
            return self.fail(format!(
                "The matrix of $subspace has {one} dimensions, and the maps have {other}. Set $dim={one}, or choose another."
            ));
        }
        let mut chosen = Vec::new();
        for cell in cells {
            match self.number(cell.clone())?.as_whole() {
                Some(cell) => chosen.push(cell),
                None => return self.fail("The cells of $subspace are whole numbers from 0."),
            }
        }
        if chosen.is_empty() {
            return self.fail("$subspace names no cells of its matrix. Name one: $subspace=[M,0].");
        }
        self.charge(100 * matrix.size.pow(3) * matrix.words())?;
        let polynomial = self.told(polynomial(&matrix))?;
        if !simple_modulo(&polynomial) {
            // How often which root is one is found by way of longer fractions.
            let words = polynomial.iter().map(|x| Number::Exact(x.clone()).words()).max().unwrap_or(1);
            self.charge(Number::steps(10 * matrix.size.pow(3), words))?;
        }
        Projection::new(&matrix, &polynomial, &chosen).map(Some).or_else(|why| self.fail(why))
    }

    fn drawn(&self, map: &Affine, projection: Option<&Projection>) -> Result<Option<Drawn>, ImportError> {
        match projection {
            Some(projection) => Ok(projection.project(map)),
            None => {
                let doubles = |list: &[Number]| list.iter().map(Number::double).collect::<Result<_, _>>();
                Ok(Some((self.told(doubles(&map.matrix))?, self.told(doubles(&map.shift))?)))
            }
        }
    }

    fn plane(
        &self,
        graph: &Graph<'a>,
        drawn: &[Vec<(usize, Drawn)>],
        dimensions: usize,
        remarks: &mut Vec<String>,
    ) -> Result<Maps, ImportError> {
        let row = |(matrix, shift): &Drawn| match dimensions {
            1 => [matrix[0], 0.0, 0.0, matrix[0], shift[0], 0.0],
            _ => [matrix[0], matrix[1], matrix[2], matrix[3], shift[0], shift[1]],
        };
        if dimensions == 1 {
            remarks.push("It lies on a line, and is drawn in the plane.".into());
        }
        if let [images] = drawn {
            return Ok(Maps::Plane(images.iter().map(|(_, map)| row(map)).collect()));
        }
        if drawn.len() > MAX_STATES {
            let count = drawn.len();
            return self.fail(format!(
                "The set “{}” is made of {count} sets, and the most is {MAX_STATES}. Put some into others.",
                short(graph.names[0], 20)
            ));
        }
        let copy = |(from, map): &(usize, Drawn)| DirectedCopy { from: *from, map: row(map) };
        Ok(Maps::Directed(drawn.iter().map(|images| images.iter().map(copy).collect()).collect()))
    }

    /// In space there are no graph-directed systems: sets are put into others until one is left, or copies of such.
    fn solid(
        &self,
        graph: &Graph<'a>,
        drawn: &[Vec<(usize, Drawn)>],
        remarks: &mut Vec<String>,
    ) -> Result<Maps, ImportError> {
        let row = |(m, s): &Drawn| -> Row3 { std::array::from_fn(|k| if k < 9 { m[k] } else { s[k - 9] }) };
        let states = drawn
            .iter()
            .map(|images| images.iter().map(|(from, map)| (*from, Affine3::from_row(row(map)))).collect())
            .collect();
        let states = put_in(states);
        let rows = |maps: &[(usize, Affine3)]| maps.iter().map(|(_, map)| map.to_row()).collect::<Vec<_>>();
        let root = &states[0];
        if root.iter().all(|(from, _)| *from == 0) {
            if drawn.len() > 1 {
                remarks.push(format!("Its {} sets are put into each other: it is one system.", drawn.len()));
            }
            return Ok(Maps::Space(rows(root)));
        }
        let alone =
            |&(from, _): &(usize, Affine3)| from != 0 && states[from].iter().all(|(to, _)| *to == from);
        if root.iter().all(alone) && root.len() <= MOST_OBJECTS {
            let objects: Option<Vec<Vec<Row3>>> = root
                .iter()
                .map(|(from, map)| {
                    let back = map.undo().ok()?;
                    let moved = |(_, inner): &(usize, Affine3)| (*map * *inner * back).to_row();
                    Some(states[*from].iter().map(moved).collect())
                })
                .collect();
            if let Some(objects) = objects {
                let count = objects.len();
                remarks
                    .push(format!("It is made of {count} copies of systems: each is an object of its own."));
                return Ok(Maps::Objects(objects));
            }
        }
        let names: Vec<String> =
            graph.names.iter().take(5).map(|name| format!("“{}”", short(name, 20))).collect();
        self.fail(format!(
            "The sets {} are made of each other in space, where Frond draws systems of one set alone. Choose by $root a set \
             that is made of itself, or by $subspace a plane.",
            names.join(", ")
        ))
    }

    /// Refuses what has no attractor on the subspace, and says what to choose.
    fn contracts(&self, system: &System, graph: &Graph<'a>) -> Result<(), ImportError> {
        let Err(error) = system.check() else { return Ok(()) };
        let line = self.definition("$subspace").map_or(graph.lines[0], |it| it.line);
        Err(super::blocks::refused(
            "aifs-unread",
            line,
            &format!("On the subspace of $subspace: {error} Or choose another cell of its matrix."),
        ))
    }

    fn camera_left_out(&self) -> Option<String> {
        self.definition("$camera")
            .map(|_| "Its $camera is left out: the whole shape is in view instead.".to_owned())
    }

    /// The camera, where there is one.
    fn camera(&mut self, dimensions: usize) -> Result<Option<Camera>, ImportError> {
        let Some(definition) = self.definition("$camera") else { return Ok(None) };
        let value = self.computed(definition)?;
        self.line = definition.line;
        let Value::List(parts) = value else { return Ok(None) };
        let parts = self.flat_numbers(&parts)?;
        let x: Vec<f64> = self.told(parts.iter().map(Number::double).collect())?;
        Ok(match (dimensions, x.as_slice()) {
            (1 | 2, &[x, y, radius, angle]) if radius > 0.0 => {
                Some(Camera::Plane { centre: [x, y], radius, angle })
            }
            (3, &[a, b, c, d, e, f, g, h, i, field]) => {
                Some(Camera::Space { eye: [a, b, c], target: [d, e, f], up: [g, h, i], field })
            }
            _ => None,
        })
    }
}

/// Puts the sets that are not made of themselves into those that are made of them.
fn put_in(mut states: Solid) -> Solid {
    loop {
        let without_self = |k: &usize| !states[*k].is_empty() && states[*k].iter().all(|(from, _)| from != k);
        let used = |k: usize| states.iter().flatten().any(|(from, _)| *from == k);
        let small = |k: usize| {
            let put = |images: &Vec<(usize, Affine3)>| {
                images.iter().map(|(from, _)| if *from == k { states[k].len() } else { 1 }).sum::<usize>()
            };
            states.iter().map(put).all(|count| count <= MAX_MAPS)
        };
        let Some(k) = (1..states.len()).filter(without_self).find(|&k| used(k) && small(k)) else {
            return states;
        };
        let inner = std::mem::take(&mut states[k]);
        for images in &mut states {
            *images = images
                .iter()
                .flat_map(|&(from, map)| {
                    let of = if from == k { inner.as_slice() } else { &[] };
                    let put = of.iter().map(move |&(to, one)| (to, map * one));
                    put.chain((from != k).then_some((from, map)))
                })
                .collect();
        }
    }
}

/// Takes coordinates in which all maps are similitudes, where there are such.
fn straighten(drawn: &mut [Vec<(usize, Drawn)>], size: usize) {
    let matrices: Vec<&[f64]> = drawn.iter().flatten().map(|(_, (matrix, _))| matrix.as_slice()).collect();
    let Some((to, back)) = similar(&matrices, size) else { return };
    for (_, (matrix, shift)) in drawn.iter_mut().flatten() {
        *matrix = product(&product(&to, matrix, size), &back, size);
        *shift = (0..size).map(|k| (0..size).map(|j| to[k * size + j] * shift[j]).sum()).collect();
    }
}

/// The exact system, where all its numbers are rational.
fn ambient(graph: &Graph<'_>, projection: Option<&Projection>, dim: usize) -> Option<Ambient> {
    let ratios =
        |list: &[Number]| list.iter().map(|x| x.exact().map(Rational::ratio)).collect::<Option<Vec<_>>>();
    let map = |Image { map, set }: &Image| {
        let map: &Rc<Affine> = map;
        Some(AmbientMap { from: *set, matrix: ratios(&map.matrix)?, shift: ratios(&map.shift)? })
    };
    let states = graph.states.iter().map(|images| images.iter().map(map).collect()).collect::<Option<_>>()?;
    Some(Ambient { dim, subspace: projection.map(|it| it.subspace.clone()), states })
}
