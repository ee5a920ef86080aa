//! No circle of imports among the files of a crate: what is read first stands on nothing that comes later.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;

use crate::command::{Outcome, root};
use crate::imports::{Import, Sources, imports};
use crate::stamp;

/// Fails where files of a crate import from each other in a circle, and says which imports make it.
pub fn gate() -> Outcome {
    let mut report = String::new();
    for entry in fs::read_dir(root().join("crate"))? {
        let folder = entry?.path();
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut sources = Sources::new();
        for file in stamp::files(&folder.join("src"))? {
            if file.extension().is_some_and(|extension| extension == "rs") {
                let path = file.strip_prefix(folder.join("src"))?.to_string_lossy().replace('\\', "/");
                sources.insert(path, fs::read_to_string(&file)?);
            }
        }
        let imports = imports(&sources).map_err(|problem| format!("crate/{name}/src/{problem}"))?;
        report += &said(&format!("crate/{name}/src"), &circles(&imports));
    }
    if report.is_empty() {
        return Ok(());
    }
    Err(format!(
        "files import from each other in a circle\n{report}\
         Let one of each circle's imports go: move what both files need into a file that imports from neither, \
         or hand it over as an argument. A parent only declares and shows its children."
    )
    .into())
}

/// The imports that make each circle, the largest circle first.
fn circles(all: &[Import]) -> Vec<Vec<&Import>> {
    let mut next: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for import in all {
        next.entry(&import.from).or_default().insert(&import.to);
    }
    let reach: BTreeMap<&str, BTreeSet<&str>> = next
        .keys()
        .map(|from| {
            let mut found = BTreeSet::new();
            let mut open = vec![*from];
            while let Some(file) = open.pop() {
                open.extend(next.get(file).into_iter().flatten().filter(|to| found.insert(**to)));
            }
            (*from, found)
        })
        .collect();
    let back = |from: &str, to: &str| reach.get(to).is_some_and(|files| files.contains(from));
    let mut found: BTreeMap<Vec<&str>, Vec<&Import>> = BTreeMap::new();
    for import in all.iter().filter(|import| back(&import.from, &import.to)) {
        let files =
            reach[import.from.as_str()].iter().filter(|file| back(&import.from, file)).copied().collect();
        found.entry(files).or_default().push(import);
    }
    let mut found: Vec<_> = found.into_iter().collect();
    found.sort_by_key(|(files, _)| std::cmp::Reverse(files.len()));
    found.into_iter().map(|(_, imports)| imports).collect()
}

fn said(folder: &str, circles: &[Vec<&Import>]) -> String {
    let mut text = String::new();
    for circle in circles {
        let files: BTreeSet<&str> = circle.iter().map(|import| import.from.as_str()).collect();
        let _ = writeln!(text, "  a circle of {} files in {folder}", files.len());
        for Import { from, to, line, name } in circle {
            let _ = writeln!(text, "    {from}:{line} takes {name} from {to}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<String> {
        let sources = files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        let imports = imports(&sources).expect("the sources can be read");
        said("src", &circles(&imports)).lines().map(|line| line.trim().to_owned()).collect()
    }

    #[test]
    fn two_files_that_name_each_other_are_a_circle_of_two_imports() {
        let files = [
            ("lib.rs", "mod a; mod b; pub use a::A;"),
            ("a.rs", "use crate::b::B; pub struct A(B);"),
            ("b.rs", "pub struct B; impl B {\n fn a() -> Vec<crate::A> { vec![] } }"),
        ];
        assert_eq!(
            found(&files),
            ["a circle of 2 files in src", "a.rs:1 takes B from b.rs", "b.rs:2 takes A from a.rs"]
        );
    }

    #[test]
    fn a_parent_that_only_shows_its_children_is_in_no_circle() {
        let files = [
            ("lib.rs", "mod room;"),
            ("room/mod.rs", "mod a; mod b; pub use {a::A, b::*};"),
            ("room/a.rs", "use super::b; pub struct A(b::B);"),
            ("room/b.rs", "pub struct B;"),
        ];
        assert!(found(&files).is_empty());
        // One that uses what it shows, and is used, is.
        let files = [
            ("lib.rs", "mod room;"),
            ("room.rs", "mod a; pub use a::A; pub struct Of(A);"),
            ("room/a.rs", "pub struct A(Box<super::Of>);"),
        ];
        assert_eq!(found(&files).len(), 3);
    }

    #[test]
    fn paths_in_macros_globs_and_functions_count() {
        for text in
            ["fn a() { vec![crate::b::B] }", "use crate::b::*; fn a() { B }", "fn a() { use super::b::B; }"]
        {
            let files = [
                ("main.rs", "mod a; mod b;"),
                ("a.rs", text),
                ("b.rs", "struct B; fn b() { crate::a::a() }"),
            ];
            let files = files.map(|(name, text)| {
                (name, if name == "a.rs" { text.replace("fn a", "pub fn a") } else { text.into() })
            });
            let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (*name, text.as_str())).collect();
            assert_eq!(found(&files).len(), 3, "{text}");
        }
    }

    #[test]
    fn methods_that_another_file_gives_a_type_are_taken_from_it() {
        let files = [
            ("lib.rs", "mod a; mod b;"),
            ("a.rs", "pub struct A; impl A { fn go(&self) { self.step(); } }"),
            ("b.rs", "use crate::a::A; impl A { pub fn step(&self) {} }"),
        ];
        assert_eq!(found(&files)[1], "a.rs:1 takes .step() from b.rs");
    }

    #[test]
    fn tests_do_not_count() {
        let files = [
            ("lib.rs", "mod a; mod b; #[cfg(test)] mod tests;"),
            ("a.rs", "pub struct A; #[cfg(test)] mod tests { use crate::b::B; }"),
            ("b.rs", "use crate::a::A; pub struct B(A);"),
        ];
        assert!(found(&files).is_empty());
    }
}
