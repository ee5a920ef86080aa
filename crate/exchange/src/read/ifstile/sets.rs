//! Which names of a block are sets, and what of: a set is what is defined by itself, also by way of others, and what is
//! made of such.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::machine::Machine;
use super::value::{Image, Value};
use crate::read::problem::ImportError;
use crate::text::short;

/// The sets of a block, in the order of their definitions.
#[derive(Default)]
pub struct Sets<'a> {
    pub all: Vec<&'a str>,
    /// Those that are defined by themselves.
    returning: Vec<&'a str>,
}

/// Sets that are made of one another, the shape first.
pub struct Graph<'a> {
    pub names: Vec<&'a str>,
    pub states: Vec<Vec<Image>>,
    /// Of each, the line of its definition.
    pub lines: Vec<usize>,
}

impl<'a> Machine<'_, 'a> {
    /// Finds the sets of the block.
    pub fn find_sets(&mut self) -> Result<Sets<'a>, ImportError> {
        let chain = self.frame().chain.clone();
        let count: usize = chain.iter().map(|&one| self.program.blocks[one].definitions.len()).sum();
        self.charge(1 + count)?;
        let names = self.program.variables(&chain);
        let place: BTreeMap<&str, usize> = names.iter().enumerate().map(|(k, &name)| (name, k)).collect();
        let mut uses: Vec<Vec<usize>> = Vec::with_capacity(names.len());
        for name in &names {
            let Some(definition) = self.definition(name) else { continue };
            let words = self.words(definition)?;
            uses.push(words.iter().filter_map(|word| place.get(word).copied()).collect());
        }
        let returning = returning(&uses);
        // What is made of a set is one.
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); names.len()];
        for (user, used) in uses.iter().enumerate() {
            for &one in used {
                users[one].push(user);
            }
        }
        let mut is_set = returning.clone();
        let mut left: Vec<usize> = (0..names.len()).filter(|&k| returning[k]).collect();
        while let Some(one) = left.pop() {
            for &user in &users[one] {
                if !std::mem::replace(&mut is_set[user], true) {
                    left.push(user);
                }
            }
        }
        let those =
            |which: &[bool]| names.iter().zip(which).filter(|(_, it)| **it).map(|(name, _)| *name).collect();
        Ok(Sets { all: those(&is_set), returning: those(&returning) })
    }

    /// The graph of the sets that one of them is made of; none of what is no set, such as a list of sets.
    pub fn graph(&mut self, sets: &Sets<'a>, root: &'a str) -> Result<Option<Graph<'a>>, ImportError> {
        let numbers = sets.returning.iter().enumerate().map(|(k, &name)| (name, k)).collect();
        let at = self.frames.len() - 1;
        self.frames[at].sets = numbers;
        let line = self.definition(root).map_or(self.line, |it| it.line);
        let mut graph = Graph { names: Vec::new(), states: Vec::new(), lines: Vec::new() };
        let mut place: BTreeMap<usize, usize> = BTreeMap::new();
        let first = sets.returning.iter().position(|&name| name == root);
        let images = match first {
            Some(set) => {
                place.insert(set, 0);
                self.images(root)?
            }
            None => match self.variable(root)? {
                Some(Value::Images(images)) => images,
                _ => return Ok(None),
            },
        };
        // Another name of a set is that set.
        if let (None, [only]) = (first, images.as_slice())
            && only.map.is_identity()
            && let Some(&same) = sets.returning.get(only.set)
        {
            return self.graph(sets, same);
        }
        graph.push(root, line, &images);
        let mut k = 0;
        while k < graph.states.len() {
            let images = graph.states[k].clone();
            for image in images {
                self.charge(1)?;
                if place.contains_key(&image.set) {
                    continue;
                }
                place.insert(image.set, graph.states.len());
                let name = sets.returning[image.set];
                let line = self.definition(name).map_or(self.line, |it| it.line);
                let images = self.images(name)?;
                graph.push(name, line, &images);
            }
            k += 1;
        }
        for image in graph.states.iter_mut().flatten() {
            image.set = place[&image.set];
        }
        self.without_empty(graph).map(Some)
    }

    /// The images that a set is the union of.
    fn images(&mut self, name: &'a str) -> Result<Rc<Vec<Image>>, ImportError> {
        let Some(definition) = self.definition(name) else {
            return self.fail("No equation of a set is here.");
        };
        let value = self.computed(definition)?;
        let here = std::mem::replace(&mut self.line, definition.line);
        let images = match value {
            Value::Images(images) => images,
            // The empty set, or what is left where a map is it.
            Value::Maps(maps) if maps.is_empty() => Rc::default(),
            other => {
                let (name, noun) = (short(name, 20), other.noun());
                return self.fail(format!(
                    "“{name}” is defined by itself and comes to {noun}. A set is a union of its own images: A=(f|g)*A."
                ));
            }
        };
        self.line = here;
        Ok(images)
    }

    /// A graph without the sets that nothing is in.
    fn without_empty(&mut self, mut graph: Graph<'a>) -> Result<Graph<'a>, ImportError> {
        loop {
            let empty: Vec<bool> = graph.states.iter().map(Vec::is_empty).collect();
            if empty[0] {
                self.line = graph.lines[0];
                return self.fail(format!(
                    "Nothing is in “{}”. Unite images of sets in it.",
                    short(graph.names[0], 20)
                ));
            }
            let mut changed = false;
            for images in &mut graph.states {
                let before = images.len();
                images.retain(|image| !empty[image.set]);
                changed |= images.len() < before;
            }
            if !changed {
                break;
            }
        }
        // What nothing is in is copied by nothing any more.
        let kept: Vec<usize> = (0..graph.states.len()).filter(|&k| !graph.states[k].is_empty()).collect();
        let place: BTreeMap<usize, usize> = kept.iter().enumerate().map(|(to, &from)| (from, to)).collect();
        let states = kept.iter().map(|&k| std::mem::take(&mut graph.states[k])).collect::<Vec<_>>();
        let mut graph = Graph {
            names: kept.iter().map(|&k| graph.names[k]).collect(),
            lines: kept.iter().map(|&k| graph.lines[k]).collect(),
            states,
        };
        for image in graph.states.iter_mut().flatten() {
            image.set = place[&image.set];
        }
        Ok(graph)
    }
}

impl<'a> Graph<'a> {
    fn push(&mut self, name: &'a str, line: usize, images: &[Image]) {
        self.names.push(name);
        self.lines.push(line);
        self.states.push(images.to_vec());
    }
}

/// Which places lie on a way back to themselves (Tarjan's components, without recursion).
fn returning(uses: &[Vec<usize>]) -> Vec<bool> {
    const UNSEEN: usize = usize::MAX;
    let count = uses.len();
    let (mut order, mut low) = (vec![UNSEEN; count], vec![0; count]);
    let (mut on_stack, mut found) = (vec![false; count], vec![false; count]);
    let (mut stack, mut next) = (Vec::new(), 0);
    for start in 0..count {
        if order[start] != UNSEEN {
            continue;
        }
        let mut way = vec![(start, 0)];
        while let Some(&mut (at, ref mut edge)) = way.last_mut() {
            if *edge == 0 && order[at] == UNSEEN {
                (order[at], low[at]) = (next, next);
                next += 1;
                stack.push(at);
                on_stack[at] = true;
            }
            if let Some(&to) = uses[at].get(*edge) {
                *edge += 1;
                found[at] |= to == at;
                if order[to] == UNSEEN {
                    way.push((to, 0));
                } else if on_stack[to] {
                    low[at] = low[at].min(order[to]);
                }
                continue;
            }
            way.pop();
            if let Some(&(before, _)) = way.last() {
                low[before] = low[before].min(low[at]);
            }
            if low[at] == order[at] {
                let place = stack.iter().rposition(|&one| one == at).unwrap_or(0);
                let component = stack.split_off(place);
                for &one in &component {
                    on_stack[one] = false;
                    found[one] |= component.len() > 1;
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_back_are_found() {
        // 0 -> 1 -> 2 -> 1, 3 -> 3, 4 -> 0, 5.
        let uses = [vec![1], vec![2], vec![1], vec![3], vec![0, 5], vec![]];
        assert_eq!(returning(&uses), [false, true, true, true, false, false]);
    }
}
