//! The blocks of a program, with their definitions as they are written.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use super::syntax::Expression;
use crate::read::problem::{ImportError, MAX_SYSTEMS};
use crate::text::short;

/// Blocks that are looked at: files may have millions.
pub const MAX_BLOCKS: usize = 4 * MAX_SYSTEMS;
/// Parents of parents.
pub const MAX_CHAIN: usize = 32;

pub fn refused(code: &'static str, line: usize, why: &str) -> ImportError {
    ImportError::At { code, line, why: why.to_owned() }
}

pub struct Definition<'a> {
    pub name: &'a str,
    /// It may run over several lines, and have remarks in it.
    pub value: &'a str,
    pub line: usize,
    /// Whether it is computed anew wherever it is named.
    pub substitution: bool,
    pub parsed: OnceCell<Result<Expression<'a>, String>>,
    /// The names that it mentions.
    pub words: OnceCell<Vec<&'a str>>,
}

pub struct Block<'a> {
    pub id: &'a str,
    /// The name of its parent, empty without one.
    pub inherits: &'a str,
    pub parent: Option<usize>,
    pub line: usize,
    pub definitions: Vec<Definition<'a>>,
    index: BTreeMap<&'a str, usize>,
}

impl<'a> Block<'a> {
    const fn new(id: &'a str, inherits: &'a str, line: usize) -> Self {
        Self { id, inherits, parent: None, line, definitions: Vec::new(), index: BTreeMap::new() }
    }

    pub fn own(&self, name: &str) -> Option<&Definition<'a>> {
        self.index.get(name).map(|&at| &self.definitions[at])
    }

    fn define(&mut self, definition: Definition<'a>) {
        // What is said twice is what is said last, where it is said first.
        match self.index.get(definition.name) {
            Some(&at) => self.definitions[at] = definition,
            None => {
                self.index.insert(definition.name, self.definitions.len());
                self.definitions.push(definition);
            }
        }
    }
}

/// All of a file.
pub struct Program<'a> {
    pub blocks: Vec<Block<'a>>,
    pub ids: BTreeMap<&'a str, usize>,
    /// What is to be said of the file as a whole.
    pub remarks: Vec<String>,
}

impl<'a> Program<'a> {
    /// A block and its parents, the nearest first; and whether they inherit each other.
    pub fn chain(&self, block: usize) -> (Vec<usize>, bool) {
        let mut chain = vec![block];
        while let Some(parent) = self.blocks[chain[chain.len() - 1]].parent {
            if chain.contains(&parent) {
                return (chain, true);
            }
            if chain.len() == MAX_CHAIN {
                break;
            }
            chain.push(parent);
        }
        (chain, false)
    }

    pub fn find(&self, chain: &[usize], name: &str) -> Option<&Definition<'a>> {
        chain.iter().find_map(|&block| self.blocks[block].own(name))
    }

    /// Variables in their order, those of parents first; what is defined again stays where it was.
    pub fn variables(&self, chain: &[usize]) -> Vec<&'a str> {
        let mut seen = std::collections::BTreeSet::new();
        let mut names = Vec::new();
        for &block in chain.iter().rev() {
            for definition in &self.blocks[block].definitions {
                if !definition.name.starts_with('$') && seen.insert(definition.name) {
                    names.push(definition.name);
                }
            }
        }
        names
    }

    pub fn hidden(&self, block: usize) -> bool {
        self.blocks[block].own("$a").is_some_and(|it| it.value.contains('h'))
    }
}

/// Lines with their numbers from 1 and their places.
struct Lines<'a> {
    text: &'a str,
    at: usize,
    number: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<(usize, usize, &'a str)> {
        let rest = self.text.get(self.at..).filter(|rest| !rest.is_empty())?;
        let end = rest.find('\n').unwrap_or(rest.len());
        let start = self.at;
        self.at += (end + 1).min(rest.len());
        self.number += 1;
        Some((self.number, start, &rest[..end]))
    }

    fn begins_block(&self) -> bool {
        self.text[self.at..].trim_start_matches([' ', '\t']).starts_with('@')
    }
}

/// How many brackets of a line stay open.
fn opened(line: &str) -> isize {
    let code = line.split('#').next().unwrap_or_default();
    code.bytes().fold(0, |depth, byte| match byte {
        b'(' | b'[' => depth + 1,
        b')' | b']' => depth - 1,
        _ => depth,
    })
}

pub fn read(text: &str) -> Result<Program<'_>, ImportError> {
    let mut program = Program { blocks: Vec::new(), ids: BTreeMap::new(), remarks: Vec::new() };
    let mut lines = Lines { text, at: 0, number: 0 };
    if let Some(script) = script_end(text) {
        while lines.at < script {
            lines.next();
        }
        program.remarks.push(
            "The script that the file begins with is not run: Frond reads what stands behind it.".into(),
        );
    }
    let mut count = 0;
    while let Some((number, start, whole)) = lines.next() {
        let line = whole.split('#').next().unwrap_or_default().trim();
        if line.is_empty() || line == "@@" || line.starts_with("@@version") {
            continue;
        }
        if let Some(file) = line.strip_prefix("@@") {
            let file = short(file.strip_prefix("import").unwrap_or(file), 40);
            program.remarks.push(format!(
                "Line {number}: other files are not fetched ({file}). Paste what is needed of it into this one."
            ));
            continue;
        }
        if let Some(head) = line.strip_prefix('@') {
            count += 1;
            if count <= MAX_BLOCKS {
                let (id, parent) = head.split_once(':').unwrap_or((head, ""));
                let (id, parent) = (id.trim(), parent.trim());
                if !id.is_empty() {
                    program.ids.insert(id, program.blocks.len());
                }
                program.blocks.push(Block::new(id, parent, number));
            }
            continue;
        }
        if count > MAX_BLOCKS {
            continue;
        }
        let Some((name, _)) = line.split_once('=') else {
            let why = if is_script(line) {
                "Here stands a script, and Frond runs none. In IFStile, save the blocks that it makes, and open those."
            } else {
                "No name and value, name=value, stand here. Write both, or put # before a remark."
            };
            return Err(refused("aifs-unread", number, why));
        };
        let mut depth = opened(whole);
        let mut end = start + whole.len();
        let raw = name.trim().starts_with("$n") || name.trim() == "$a";
        while depth > 0 && !raw && !lines.begins_block() {
            let Some((_, at, more)) = lines.next() else { break };
            depth += opened(more);
            end = at + more.len();
        }
        if program.blocks.is_empty() {
            program.blocks.push(Block::new("", "", number));
        }
        let value = text[start..end].split_once('=').map_or("", |(_, value)| value);
        let name = name.trim();
        let (name, substitution) = name.strip_prefix('&').map_or((name, false), |name| (name, true));
        if let Some(block) = program.blocks.last_mut() {
            let value = if raw { value.trim() } else { value.trim().trim_end_matches(';') };
            let (parsed, words) = (OnceCell::new(), OnceCell::new());
            block.define(Definition { name, value, line: number, substitution, parsed, words });
        }
    }
    if count > MAX_BLOCKS {
        program.remarks.push(format!("The file has {count} blocks: the first {MAX_BLOCKS} are looked at."));
    }
    for k in 0..program.blocks.len() {
        let parent = program.ids.get(program.blocks[k].inherits).copied();
        // A block that names itself has no other parent.
        program.blocks[k].parent = parent.filter(|&parent| parent != k);
    }
    Ok(program)
}

fn is_script(line: &str) -> bool {
    ["export ", "import ", "const ", "let ", "function ", "//", "/*", "{", "}"]
        .iter()
        .any(|start| line.starts_with(start))
}

/// Where a script ends that stands before the blocks.
fn script_end(text: &str) -> Option<usize> {
    let (mut at, mut before) = (0, false);
    for line in text.split_inclusive('\n') {
        let code = line.trim();
        at += line.len();
        if code == "@@" || code.starts_with("@@#") {
            return before.then_some(at);
        }
        if !before && code.starts_with('@') {
            return None;
        }
        before |= !code.is_empty() && !code.starts_with('#');
    }
    None
}
