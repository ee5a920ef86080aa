//! What the graph of neighbour maps tells about a system.

use crate::error::ExactError;
use crate::graph::affinity;
use crate::graph::closed_form::closed_form;
use crate::graph::growth::{Weighted, components, exponent};
use crate::graph::neighbours::{Graph, Overlap};
use crate::graph::types::types;
use crate::number::field::{Element, Field};
use crate::number::interval::Interval;
use crate::number::matrix::Matrix;
use crate::number::rational::Rational;
use crate::number::value::Number;
use crate::system::build::{Edge, Scaling, System};
use crate::system::frame::Frame;

/// How much is tried.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The most pairs of pieces.
    pub budget: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { budget: 20_000 }
    }
}

/// Whether there are open sets that the maps send into one another without an overlap (Moran 1946; Hutchinson 1981).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpenSetCondition {
    /// There are, by [`Reason::FiniteType`].
    Yes,
    /// There are none: two words give one piece.
    No,
    /// Not decided.
    Undecided,
}

/// Why an answer is given, or is not.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// All maps are similarities, finitely many neighbour maps are left, and no two words give one piece. Then a ball
    /// meets boundedly many pieces of its size, so the Hausdorff measure of the largest component is positive in the
    /// dimension of Mauldin & Williams; and where the system is strongly connected, that is equivalent to the open set
    /// condition (Schief 1994; Das & Edgar 2005).
    FiniteType,
    /// Two words give one piece.
    ExactOverlap(Overlap),
    /// Pieces are counted once each, by the finitely many types of what is around them (Ngai & Wang 2001).
    TypesCounted {
        /// How many types there are.
        types: usize,
    },
    /// The dimension is that of space, in which the measure is positive, so that there are inner points (Schief 1994).
    FullDimension,
    /// The budget is spent, or the hook has ended the search.
    BudgetSpent {
        /// Pairs that were found.
        pairs: usize,
    },
    /// A map is no similarity.
    NotSimilar,
    /// Not every state is part of every other.
    NotStronglyConnected,
    /// Some pieces are the same, and not all maps scale by one factor.
    RatiosDiffer,
    /// A map alone does not make things smaller, so that pairs are not met by size.
    NotShrinking,
}

/// A Hausdorff dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// The best double.
    pub value: f64,
    /// A bound from below; zero where it is not proved.
    pub lower: f64,
    /// A bound from above, which is always proved.
    pub upper: f64,
    /// Whether the lower bound belongs to it too.
    pub is_proved: bool,
    /// What it is exactly, where that can be said: "log 4 / log 3".
    pub exact: Option<String>,
}

/// The boundary of a shape with inner points.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// State 0 is the boundary of state 0; the others are where two pieces meet.
    pub system: System,
    /// Its dimension.
    pub dimension: Dimension,
}

/// All answers.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// The open set condition.
    pub open_set_condition: OpenSetCondition,
    /// How many neighbour maps there are; `None` where not all were found.
    pub neighbours: Option<usize>,
    /// The dimension; of maps that are no similarities a bound from above, in the plane and of one state, else `None`.
    pub dimension: Option<Dimension>,
    /// Whether there are inner points; `None` where that is not decided.
    pub has_inner_points: Option<bool>,
    /// The boundary, where there are inner points and no piece is there twice.
    pub boundary: Option<Boundary>,
    /// Why.
    pub reasons: Vec<Reason>,
}

/// Answers what can be answered about state 0 of a system.
///
/// # Errors
/// Where the maps are not seen to contract, or one has no inverse.
pub fn analyze(
    system: &System,
    settings: Settings,
    goes_on: impl FnMut(usize) -> bool,
) -> Result<Analysis, ExactError> {
    let system = &reached(system);
    let frame = Frame::new(system)?;
    let graph = Graph::new(system, &frame, settings.budget, goes_on)?;
    let mut reasons = Vec::new();
    let mut neighbours = None;
    if graph.is_complete {
        neighbours = Some(graph.neighbours().count());
    } else {
        reasons.push(Reason::BudgetSpent { pairs: graph.nodes.len() });
    }
    if !graph.is_sized {
        reasons.push(Reason::NotShrinking);
    }
    let mut open_set_condition = OpenSetCondition::Undecided;
    if let Some(overlap) = &graph.overlap {
        open_set_condition = OpenSetCondition::No;
        reasons.push(Reason::ExactOverlap(overlap.clone()));
    }
    let mut analysis = Analysis {
        open_set_condition,
        neighbours,
        dimension: None,
        has_inner_points: None,
        boundary: None,
        reasons: Vec::new(),
    };
    let Some(steps) = weighted(system) else {
        reasons.push(Reason::NotSimilar);
        let space = system.dimension();
        analysis.dimension = affinity::bound(system).map(|upper| of_bounds((0.0, upper), space, false));
        if let Some(dimension) = &mut analysis.dimension {
            dimension.value = dimension.upper;
            analysis.has_inner_points = (dimension.upper < space as f64).then_some(false);
        }
        analysis.reasons = reasons;
        return Ok(analysis);
    };
    let space = system.dimension();
    let plain = exponent(system.states.len(), &steps, space as f64).unwrap_or((0.0, 0.0));
    let is_finite_type = graph.is_complete && graph.is_sized;
    let mut dimension = of_bounds(plain, space, false);
    if is_finite_type && graph.overlap.is_none() {
        dimension = of_bounds(plain, space, true);
        dimension.exact = symbolic(system)?;
        reasons.push(Reason::FiniteType);
        let parts = components(system.states.len(), &steps);
        if parts.len() == 1 {
            analysis.open_set_condition = OpenSetCondition::Yes;
            if dimension.upper < space as f64 {
                analysis.has_inner_points = Some(false);
            } else if is_full(system)? {
                reasons.push(Reason::FullDimension);
                let full = space as f64;
                let exact = Some(space.to_string());
                dimension = Dimension { value: full, lower: full, upper: full, is_proved: true, exact };
                analysis.has_inner_points = Some(true);
                analysis.boundary = boundary(system, &graph);
            }
        } else {
            reasons.push(Reason::NotStronglyConnected);
        }
    } else if is_finite_type {
        if let Some(ratio) = one_ratio(system)? {
            if let Some((size, steps)) = types(&graph, ratio, settings.budget) {
                let bounds = exponent(size, &steps, space as f64).unwrap_or((0.0, 0.0));
                dimension = of_bounds(bounds, space, true);
                reasons.push(Reason::TypesCounted { types: size });
            } else {
                reasons.push(Reason::BudgetSpent { pairs: settings.budget });
            }
        } else {
            reasons.push(Reason::RatiosDiffer);
        }
    }
    if dimension.upper < space as f64 {
        analysis.has_inner_points = Some(false);
    }
    analysis.dimension = Some(dimension);
    analysis.reasons = reasons;
    Ok(analysis)
}

fn of_bounds((lower, upper): (f64, f64), space: usize, is_proved: bool) -> Dimension {
    let upper = upper.min(space as f64);
    let lower = lower.min(upper);
    Dimension {
        value: f64::midpoint(lower, upper),
        lower: if is_proved { lower } else { 0.0 },
        upper,
        is_proved,
        exact: None,
    }
}

/// The dimension of one state without overlaps, whose maps scale by one factor.
fn symbolic(system: &System) -> Result<Option<String>, ExactError> {
    let [maps] = &system.states[..] else { return Ok(None) };
    if one_ratio(system)?.is_none() {
        return Ok(None);
    }
    let squares = squares(system).unwrap_or_default();
    Ok(squares.first().and_then(|square| closed_form(maps.len(), square)))
}

/// The states that state 0 is made of.
fn reached(system: &System) -> System {
    let (mut order, mut place) = (vec![0], vec![usize::MAX; system.states.len()]);
    place[0] = 0;
    let mut next = 0;
    while next < order.len() {
        for edge in &system.states[order[next]] {
            if place[edge.from] == usize::MAX {
                place[edge.from] = order.len();
                order.push(edge.from);
            }
        }
        next += 1;
    }
    let moved = |edge: &Edge| Edge { from: place[edge.from], ..edge.clone() };
    let states = order.iter().map(|&state| system.states[state].iter().map(moved).collect()).collect();
    System { space: system.space.clone(), states }
}

/// What an edge scales by, `None` where it is no similarity.
fn ratio(system: &System, edge: &Edge) -> Option<Interval> {
    match &edge.scaling {
        Scaling::Similar(Some(square)) => Some(square.enclosure().re.sqrt()),
        Scaling::Similar(None) => Some(system.space.action(&edge.linear).gram().rows[0][0].sqrt()),
        Scaling::Other => None,
    }
}

fn weighted(system: &System) -> Option<Vec<Weighted>> {
    let mut steps = Vec::new();
    for (from, edges) in system.states.iter().enumerate() {
        for edge in edges {
            steps.push(Weighted { from, to: edge.from, weight: Interval::ONE, ratio: ratio(system, edge)? });
        }
    }
    Some(steps)
}

/// The squares of all ratios in one field, if they are known.
fn squares(system: &System) -> Option<Vec<Number>> {
    let square = |edge: &Edge| match &edge.scaling {
        Scaling::Similar(square) => square.clone(),
        Scaling::Other => None,
    };
    system.states.iter().flatten().map(square).collect()
}

/// The one factor by which all maps scale, if it is exactly one.
fn one_ratio(system: &System) -> Result<Option<Interval>, ExactError> {
    let Some(squares) = squares(system) else { return Ok(None) };
    let (_, elements) = Number::in_one_field(&squares)?;
    let first = squares.first().map(|square| square.enclosure().re.sqrt());
    Ok(first.filter(|_| elements.iter().all(|element| *element == elements[0])))
}

/// Whether the matrix of the sums of `ratio^d` has the eigenvalue one, exactly. Its spectral radius is at most one,
/// since no dimension is more than d; so it is one then.
fn is_full(system: &System) -> Result<bool, ExactError> {
    let Some(squares) = squares(system) else { return Ok(false) };
    let mut powers = Vec::new();
    for square in &squares {
        powers.push(match system.dimension() {
            2 => square.clone(),
            1 => square.root(2)?,
            _ => square.times(&square.root(2)?)?,
        });
    }
    let (field, elements) = Number::in_one_field(&powers)?;
    let n = system.states.len();
    let mut matrix = vec![vec![field.zero(); n]; n];
    let edges =
        system.states.iter().enumerate().flat_map(|(i, edges)| edges.iter().map(move |edge| (i, edge.from)));
    for ((i, j), power) in edges.zip(&elements) {
        matrix[i][j] = field.plus(&matrix[i][j], power);
    }
    for (k, row) in matrix.iter_mut().enumerate() {
        row[k] = field.minus(&row[k], &field.one());
    }
    Ok(is_singular(&field, matrix))
}

fn is_singular(field: &Field, mut rows: Vec<Vec<Element>>) -> bool {
    let n = rows.len();
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&i| !field.is_zero(&rows[i][k])) else { return true };
        rows.swap(k, pivot);
        let Some(inverse) = field.inverse(&rows[k][k]) else { return true };
        let lead = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1).filter(|row| !field.is_zero(&row[k])) {
            let factor = field.times(&row[k], &inverse);
            for (x, l) in row.iter_mut().zip(&lead).skip(k) {
                *x = field.minus(x, &field.times(&factor, l));
            }
        }
    }
    false
}

/// Where a tile meets its neighbours (Gilbert 1987; Strichartz & Wang 1999). No two walks give one piece of it, or two
/// words of the tile would do so; hence its dimension is exact too, as in [`Reason::FiniteType`].
fn boundary(system: &System, graph: &Graph) -> Option<Boundary> {
    let kept: Vec<usize> = graph.neighbours().collect();
    let mut place = vec![usize::MAX; graph.nodes.len()];
    for (k, &node) in kept.iter().enumerate() {
        place[node] = k + 1;
    }
    let size = system.space.size();
    let whole = |to: usize| Edge {
        from: to,
        linear: Matrix::identity(size),
        shift: vec![Rational::ZERO; size],
        scaling: Scaling::Similar(Some(Number::whole(1))),
    };
    let mut states = vec![Vec::new()];
    for &k in &kept {
        let node = &graph.nodes[k];
        let edge = |first: Option<usize>, to: usize| match first {
            Some(map) => Edge { from: place[to], ..system.states[node.first][map].clone() },
            None => whole(place[to]),
        };
        let edges = node.steps.iter().filter(|step| place[step.to] != usize::MAX);
        states.push(edges.map(|step| edge(step.first, step.to)).collect());
        if node.first == 0 {
            states[0].push(whole(place[k]));
        }
    }
    let system = System { space: system.space.clone(), states };
    let steps = weighted(&system)?;
    let bounds = exponent(system.states.len(), &steps, system.dimension() as f64)?;
    let dimension = of_bounds(bounds, system.dimension(), true);
    (!system.states[0].is_empty()).then_some(Boundary { system, dimension })
}
