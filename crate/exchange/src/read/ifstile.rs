//! `.aifs` programs of IFStile: all of the language that describes systems.
//!
//! A file has blocks, `@id:parent`, of definitions `name=value`; a block has those of its parent, too. `[x, y]` is a
//! translation and `[a, b, c, d]` a matrix, `*` composes, `|` unites, and shapes are sets that are made of images of
//! sets: `S=(f|g)*S`. Numbers stay rational as long as they can. `$subspace` chooses what is drawn of a space of more
//! dimensions; only then is anything rounded. Blocks are functions, too, and lists may be made by conditions: so all
//! steps are counted. Scripts are never run, other files never fetched. The language is described on the site of
//! IFStile.
//!
//! To be read in this order: `blocks` and `syntax`, what is written; `rational`, `number`, `affine` and `value`, what
//! is computed with; `machine`, `operators`, `arrays`, `builtin` and `evaluate`, how; `sets`, which names are sets;
//! `fixed`, `roots`, `subspace` and `similar`, what is drawn of a space; `shape`, what comes out.

mod affine;
mod arrays;
mod blocks;
mod builtin;
mod evaluate;
mod fixed;
mod machine;
mod number;
mod operators;
mod rational;
mod roots;
mod sets;
mod shape;
mod similar;
mod subspace;
mod syntax;
mod value;

use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::system::System;
use crate::text::{name_or, short};
use blocks::{Program, refused};
use builtin::TEMPLATE;
use evaluate::evaluate;
use machine::{Frame, Machine};

/// Steps of arithmetic for one block, and for all of a file.
const MAX_STEPS: usize = 1_000_000;
const MAX_FILE_STEPS: usize = 4_000_000;
/// Shapes of one block that are not made of each other.
const MAX_SHAPES: usize = 16;
/// What is read, or says nothing of shapes.
const KNOWN: [&str; 6] = ["$n", "$a", "$dim", "$subspace", "$root", "$camera"];

/// Reads the blocks that have an equation of a set.
pub fn read_ifstile(text: &str) -> Result<Gathered, ImportError> {
    let program = blocks::read(text)?;
    let mut all = Gathered::default();
    let (mut left, mut templates, mut first_template) = (MAX_FILE_STEPS, 0, None);
    for k in 0..program.blocks.len() {
        // What others are built on is hidden, and may not be complete.
        if left == 0 || program.hidden(k) || all.systems.len() >= MAX_SYSTEMS {
            continue;
        }
        match shapes(&program, k, &mut left) {
            Ok(found) => all.extend_with_all(found),
            Err(error) if error.code() == TEMPLATE => {
                templates += 1;
                first_template.get_or_insert(error);
            }
            // What the file has no steps left for is not wrong.
            Err(_) if left == 0 => {}
            Err(error) => all.take(Err(error)),
        }
    }
    if left == 0 {
        all.remarks.push("The file takes too many steps to compute: not all of its blocks are read.".into());
    }
    if templates > 0 && !all.systems.is_empty() {
        let words = if templates == 1 {
            "1 block is a template".into()
        } else {
            format!("{templates} blocks are templates")
        };
        all.remarks.push(format!("{words} of IFStile's finder, and left out: each stands for many shapes."));
    }
    let mut said = program.remarks;
    said.append(&mut all.remarks);
    all.remarks = said;
    all.finish(first_template.unwrap_or_else(|| {
        refused("aifs-nothing", 1, "No block has an equation of a set. Write one, such as S=(f|g)*S.")
    }))
}

/// The systems of a block: the one that `$root` names, or its first set, and sets that are no part of one before.
/// What steps they take are taken from those that are left.
fn shapes(program: &Program<'_>, k: usize, left: &mut usize) -> Result<Vec<System>, ImportError> {
    let (chain, circle) = program.chain(k);
    let line = program.blocks[k].line;
    let most = MAX_STEPS.min(*left);
    let mut machine = Machine::new(program, Frame::new(chain, Vec::new(), 2), line, most, evaluate);
    let found = read_shapes(&mut machine, k, circle);
    *left -= (most - machine.steps).min(*left);
    found
}

fn read_shapes(machine: &mut Machine<'_, '_>, k: usize, circle: bool) -> Result<Vec<System>, ImportError> {
    let program = machine.program;
    let sets = machine.find_sets()?;
    if sets.all.is_empty() {
        return Ok(Vec::new());
    }
    let block = &program.blocks[k];
    if !block.inherits.is_empty() && block.parent.is_none() && block.id != block.inherits {
        let parent = short(block.inherits, 20);
        return machine
            .fail(format!("There is no block “{parent}” in the file, which this one inherits. Add it."));
    }
    machine.measure()?;
    let mut names = sets.all.clone();
    let root = machine.definition("$root").map(|it| (it.value.trim(), it.line));
    if let Some((root, line)) = root {
        machine.line = line;
        let Some(at) = names.iter().position(|name| *name == root) else {
            return machine.fail(format!("$root names “{}”, which is no set of the block.", short(root, 20)));
        };
        names.rotate_left(at);
    }
    let mut remarks = left_out(machine);
    if circle {
        remarks.push(
            "Its block and another inherit each other: each is read with what the other defines.".into(),
        );
    }
    let title = machine.definition("$n").map_or("", |it| it.value);
    machine.charge(title.len() / 64)?;
    let title = name_or(title.trim_matches('"'), "");
    let mut done: Vec<&str> = Vec::new();
    let mut systems = Vec::new();
    for (at, name) in names.iter().enumerate() {
        if done.contains(name) {
            continue;
        }
        if systems.len() == MAX_SHAPES {
            let count = names[at..].iter().filter(|name| !done.contains(name)).count();
            remarks.push(format!("The block has {count} sets more, which are left out."));
            break;
        }
        let Some(graph) = machine.graph(&sets, name)? else {
            if let Some((_, line)) = root.filter(|(root, _)| root == name) {
                machine.line = line;
                let name = short(name, 20);
                return machine.fail(format!(
                    "$root names “{name}”, which is no set. Name one that is made of images of sets, as in S=(f|g)*S."
                ));
            }
            continue;
        };
        done.push(name);
        done.extend(&graph.names);
        let mut system = machine.shape(&graph)?;
        system.name = match (title.is_empty(), systems.is_empty()) {
            (_, true) => title.clone(),
            (true, false) => short(name, 20),
            (false, false) => name_or(&format!("{title}, {}", short(name, 20)), ""),
        };
        systems.push(system);
    }
    if let Some(first) = systems.first_mut() {
        first.remarks.extend(remarks);
    }
    Ok(systems)
}

/// What is said of variables of the language that are not read.
fn left_out(machine: &Machine<'_, '_>) -> Vec<String> {
    let chain = &machine.frame().chain;
    let mut names: Vec<&str> = chain
        .iter()
        .flat_map(|&one| &machine.program.blocks[one].definitions)
        .map(|it| it.name)
        .filter(|name| name.starts_with('$') && !KNOWN.contains(name))
        .take(6)
        .collect();
    names.sort_unstable();
    names.dedup();
    if names.is_empty() {
        return Vec::new();
    }
    let words: Vec<String> = names.iter().map(|name| short(name, 20)).collect();
    vec![format!("{} of the block says nothing here, and is left out.", words.join(", "))]
}
