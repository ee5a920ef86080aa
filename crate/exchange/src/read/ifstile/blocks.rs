//! The blocks of a file, with their definitions as they are written.

use std::collections::BTreeMap;

use crate::read::problem::{ImportError, MAX_SYSTEMS};

/// What is read of such files.
pub const SUBSET: &str = "Of .aifs files Frond reads numbers, translations [x, y], matrices [a, b, c, d], products, whole \
    powers and one equation S = (f | g | ..) * S, in the plane or in space.";
/// Blocks that are looked at: files may have millions.
pub const MAX_BLOCKS: usize = 4 * MAX_SYSTEMS;

pub fn refused(code: &'static str, line: usize, why: &str) -> ImportError {
    ImportError::At { code, line, why: format!("{why} {SUBSET}") }
}

#[derive(Clone, Copy)]
pub struct Definition<'a> {
    pub value: &'a str,
    pub line: usize,
    /// Whether it mentions its own name, and so is a set.
    pub set: bool,
}

pub struct Block<'a> {
    pub parent: Option<usize>,
    pub line: usize,
    pub definitions: BTreeMap<&'a str, Definition<'a>>,
    /// The names of sets, in their order.
    pub sets: Vec<&'a str>,
}

pub fn blocks(text: &str) -> Result<Vec<Block<'_>>, ImportError> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    let mut ids: BTreeMap<&str, usize> = BTreeMap::new();
    for (k, line) in text.lines().enumerate() {
        let number = k + 1;
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() || line.starts_with("@@version") {
            continue;
        }
        if line.starts_with("@@") {
            return Err(refused("aifs-unread", number, "Other files are not fetched."));
        }
        if let Some(head) = line.strip_prefix('@') {
            if blocks.len() == MAX_BLOCKS {
                break;
            }
            let (id, parent) = head.split_once(':').unwrap_or((head, ""));
            let (id, parent) = (id.trim(), parent.trim());
            let parent = ids.get(parent).copied().filter(|_| !parent.is_empty());
            if !id.is_empty() {
                ids.insert(id, blocks.len());
            }
            blocks.push(Block { parent, line: number, definitions: BTreeMap::new(), sets: Vec::new() });
            continue;
        }
        let Some((name, value)) = line.split_once('=') else {
            return Err(refused("aifs-unread", number, "No name and value, name=value, stand here."));
        };
        if blocks.is_empty() {
            blocks.push(Block { parent: None, line: number, definitions: BTreeMap::new(), sets: Vec::new() });
        }
        if let Some(block) = blocks.last_mut() {
            let (name, value) = (name.trim(), value.trim());
            let set = mentions(name, value);
            block.definitions.insert(name, Definition { value, line: number, set });
            // Said twice, it may be no set any more: whoever looks there asks its definition again.
            if set {
                block.sets.push(name);
            }
        }
    }
    Ok(blocks)
}

/// Whether a value has a name in it.
fn mentions(name: &str, value: &str) -> bool {
    let letters = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$' || c == '&';
    value.split(|c| !letters(c)).any(|word| word == name)
}

impl Block<'_> {
    pub fn hidden(&self) -> bool {
        self.definitions.get("$a").is_some_and(|it| it.value.contains('h'))
    }
}
