//! What has been found so far.

use super::super::gather::{About, Gathered, Line};
use super::evidence::Evidence;

/// What a line is called.
pub struct Label {
    pub name: Option<String>,
    /// How many lines came before it.
    pub index: usize,
    pub closed: bool,
    /// The number of its class, which is named elsewhere.
    pub class: Option<i64>,
}

/// The lines of a part of the text.
#[derive(Default)]
pub struct Found {
    pub gathered: Gathered<Label>,
    pub count: usize,
    pub evidence: Evidence,
}

impl Found {
    pub fn take(&mut self, line: &Line, closed: bool) {
        if line.count > 0 {
            let label = Label { name: None, index: self.count, closed: false, class: None };
            self.gathered.take(line, About { label, closed, ground: false });
            self.count += 1;
        }
    }

    pub fn absorb(&mut self, mut later: Self) {
        self.evidence.absorb(&later.evidence, later.count > 0);
        if later.count == 0 {
            return;
        }
        later.gathered.kept.iter_mut().for_each(|kept| kept.label.index += self.count);
        self.gathered.absorb(later.gathered);
        self.count += later.count;
    }

    /// Names those that have no name yet.
    pub fn name(&mut self, name: &str) {
        for kept in &mut self.gathered.kept {
            kept.label.name.get_or_insert_with(|| name.to_owned());
        }
    }
}
