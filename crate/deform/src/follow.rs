//! Places of a bent shape that follow the mesh.

use glam::{DMat2, DVec2};

use crate::bend::Bend;
use crate::continuity::footing::Footing;
use crate::shuffle::cursor::Cursor;
use crate::skin::{Pull, Skin, Turns};

/// The most numbers that are kept of how the nodes of a bend's support follow the mesh: 64 MB.
const MOST_PULLS: usize = 1 << 24;
/// Places that are looked at together where there is no room for as many.
const PORTION: usize = 1 << 16;

impl Bend {
    /// These places, points of pieces as in [`Bend::point`], so that they follow the mesh without the bend: as exact as
    /// `f32` is.
    ///
    /// The first call looks at how each control point moves each node of what keeps pieces together, which costs a
    /// [`Bend::set_mesh`] for each control point or two; later ones use it again.
    #[must_use]
    pub fn skin(&self, places: &[(Cursor, DVec2)]) -> Skin {
        let turns = Turns::of(&self.raw.factors);
        let pull = Pull::new(&self.mesh, turns);
        let width = pull.width();
        let mut skin = Skin::new(self.mesh.displacements().len(), turns);
        if self.values.len().saturating_mul(width) > MOST_PULLS {
            for chunk in places.chunks(PORTION) {
                let all = self.pulls_one_by_one(chunk, &pull, turns);
                for ((cursor, z), pulls) in chunk.iter().zip(all.chunks_exact(width)) {
                    skin.push(cursor.map.apply(*z), pulls);
                }
            }
            return skin;
        }
        let table = self.pulls.get_or_init(|| self.pulls_of_nodes(turns));
        let mut sum = vec![0.0; width];
        for (cursor, z) in places {
            let rest = cursor.map.apply(*z);
            sum.fill(0.0);
            if let Some(footing) = self.support.footing(cursor, self.kept, *z) {
                for (node, share) in footing.iter() {
                    let pulls = &table[node * width..(node + 1) * width];
                    sum.iter_mut().zip(pulls).for_each(|(sum, pull)| *sum += f64::from(*pull) * share);
                }
                pull.add(rest, DMat2::IDENTITY, self.plain(&footing), &mut sum);
            } else {
                let mut room = None;
                let weights = self.terms.at(&self.mesh, rest, &mut room);
                pull.add(rest, DMat2::IDENTITY, weights.plain, &mut sum);
                self.raw.visit(&self.terms, weights, cursor, self.kept, [*z], |_, from, factor, weight| {
                    pull.add(from, factor, weight, &mut sum);
                });
            }
            skin.push(rest, &sum);
        }
        skin
    }

    /// The numbers of all nodes, one node after the other.
    fn pulls_of_nodes(&self, turns: Turns) -> Vec<f32> {
        let controls = self.mesh.displacements().len();
        let width = controls * turns.numbers();
        let mut table = vec![0.0; self.values.len() * width];
        for probe in probes(controls, turns) {
            let values = self.probed(&probe);
            for (numbers, value) in table.chunks_exact_mut(width).zip(&values) {
                for &(number, axis) in &probe.numbers {
                    numbers[number] += value.dot(axis) as f32;
                }
            }
        }
        table
    }

    /// The numbers of places, where there is no room for those of all nodes.
    fn pulls_one_by_one(&self, places: &[(Cursor, DVec2)], pull: &Pull<'_>, turns: Turns) -> Vec<f64> {
        let controls = self.mesh.displacements().len();
        let width = pull.width();
        let footing =
            |(cursor, z): &(Cursor, DVec2)| self.support.footing(cursor, self.kept, *z).unwrap_or_default();
        let footings: Vec<Footing> = places.iter().map(footing).collect();
        let mut sums = vec![0.0; places.len() * width];
        for probe in probes(controls, turns) {
            let values = self.probed(&probe);
            for (sum, footing) in sums.chunks_exact_mut(width).zip(&footings) {
                let value: DVec2 = footing.iter().map(|(node, share)| values[node] * share).sum();
                for &(number, axis) in &probe.numbers {
                    sum[number] += value.dot(axis);
                }
            }
        }
        for ((sum, footing), (cursor, z)) in sums.chunks_exact_mut(width).zip(&footings).zip(places) {
            pull.add(cursor.map.apply(*z), DMat2::IDENTITY, self.plain(footing), sum);
        }
        sums
    }

    fn probed(&self, probe: &Probe) -> Vec<DVec2> {
        let mut list = vec![DVec2::ZERO; self.mesh.displacements().len()];
        probe.moves.iter().for_each(|&(control, by)| list[control] = by);
        // Moved by 1 at most, a mesh is always one.
        self.mesh.moved(&list).map_or_else(
            |_| Vec::new(),
            |mesh| self.support.fill(&mesh, &mesh, &self.terms, self.raw.turning()),
        )
    }
}

/// A mesh to look at how nodes follow: which control points are moved, and which numbers of a [`Pull`] the displacement
/// of a node then adds to, along which axes.
struct Probe {
    moves: Vec<(usize, DVec2)>,
    numbers: Vec<(usize, DVec2)>,
}

/// What tells all numbers of all control points.
fn probes(controls: usize, turns: Turns) -> Vec<Probe> {
    let (x, y) = (0.5 * DVec2::X, 0.5 * DVec2::Y);
    let of = |moves: &[(usize, DVec2)], numbers: &[(usize, DVec2)]| Probe {
        moves: moves.iter().copied().filter(|(control, _)| *control < controls).collect(),
        numbers: numbers.iter().copied().filter(|(number, _)| *number < controls * turns.numbers()).collect(),
    };
    match turns {
        // What is not turned leaves x and y to themselves: a control point for each.
        Turns::None => {
            let pair = |i| [(i, DVec2::X), (i + 1, DVec2::Y)];
            (0..controls).step_by(2).map(|i| of(&pair(i), &pair(i))).collect()
        }
        Turns::Conformal => {
            let numbers = |i| [(2 * i, DVec2::X), (2 * i + 1, DVec2::Y)];
            (0..controls).map(|i| of(&[(i, DVec2::X)], &numbers(i))).collect()
        }
        // The columns of a matrix one by one, each with its halves of the four numbers.
        Turns::Any => (0..controls)
            .flat_map(|i| {
                let at = 4 * i;
                let first = [(at, x), (at + 1, y), (at + 2, x), (at + 3, y)];
                let second = [(at, y), (at + 1, -x), (at + 2, -y), (at + 3, x)];
                [of(&[(i, DVec2::X)], &first), of(&[(i, DVec2::Y)], &second)]
            })
            .collect(),
    }
}
