//! No folder of sources that is too full to be read, and no comment that is too wide.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::command::{Outcome, root};
use crate::stamp;

/// The most files of one folder. One that has more says why: `Many files:` in the first lines of its README.md, of its
/// mod.rs, lib.rs, main.rs or index.ts, or of the module beside it.
const MOST_FILES: usize = 20;
/// The most columns of a comment.
const WIDEST_COMMENT: usize = 120;
/// The lines in which a folder says why it is full.
const REASON_LINES: usize = 12;

/// Fails where a folder is too full or a comment too wide, and says which.
pub fn gate() -> Outcome {
    let root = root();
    let mut sources = Vec::new();
    for folder in ["crate", "www", "tests"] {
        sources.extend(stamp::files(&root.join(folder))?.into_iter().filter(|file| is_source(&root, file)));
    }
    let mut folders: BTreeMap<&Path, usize> = BTreeMap::new();
    let mut report = String::new();
    for file in &sources {
        let name = file.strip_prefix(&root)?.to_string_lossy().replace('\\', "/");
        if let Some(folder) = file.parent().filter(|_| !is_test(&name)) {
            *folders.entry(folder).or_default() += 1;
        }
        for line in too_wide(&fs::read_to_string(file)?) {
            report += &format!("  {name}:{line}: a comment of more than {WIDEST_COMMENT} columns\n");
        }
    }
    for (folder, count) in folders.into_iter().filter(|(_, count)| *count > MOST_FILES) {
        let name = folder.strip_prefix(&root)?.to_string_lossy().replace('\\', "/");
        if !has_reason(folder) {
            report += &format!(
                "  {name}: {count} files, more than {MOST_FILES}; part it, or begin its index.ts, README.md or \
                 module with `Many files:` and the reason\n"
            );
        }
    }
    if report.is_empty() { Ok(()) } else { Err(format!("some sources are hard to read\n{report}").into()) }
}

fn is_source(root: &Path, file: &Path) -> bool {
    let made = ["pkg", "target", "node_modules", "known", "golden"];
    let inside = file.strip_prefix(root).unwrap_or(file);
    !inside.components().any(|part| made.iter().any(|name| part.as_os_str() == *name))
        && file.extension().is_some_and(|extension| {
            ["rs", "wgsl", "ts", "tsx", "mjs", "css"].iter().any(|known| extension == *known)
        })
}

/// Tests stand beside their code, or in a folder of their own.
fn is_test(name: &str) -> bool {
    name.contains("tests/") || name.ends_with("tests.rs") || name.contains(".test.")
}

/// The lines, counted from 1, with a comment that ends too far to the right.
fn too_wide(text: &str) -> Vec<usize> {
    let is_comment = |line: &str| {
        let start = line.trim_start();
        start.starts_with("//") || start.starts_with("/*") || start.starts_with("* ")
    };
    let lines = text.lines().enumerate();
    lines
        .filter(|(_, line)| is_comment(line) && line.chars().count() > WIDEST_COMMENT)
        .map(|(at, _)| at + 1)
        .collect()
}

fn has_reason(folder: &Path) -> bool {
    let inside = ["README.md", "mod.rs", "lib.rs", "main.rs", "index.ts"].map(|name| folder.join(name));
    let beside: PathBuf = folder.with_extension("rs");
    inside
        .iter()
        .chain([&beside])
        .filter_map(|file| fs::read_to_string(file).ok())
        .any(|text| says_why(&text))
}

fn says_why(text: &str) -> bool {
    text.lines().take(REASON_LINES).any(|line| line.contains("Many files: "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_comments_are_held_to_a_width() {
        let wide = "x".repeat(WIDEST_COMMENT);
        assert_eq!(too_wide(&format!("// {wide}\nlet a = \"{wide}\";\n  /// {wide}\n * {wide}")), [1, 3, 4]);
        assert!(too_wide(&format!("// {}", "é".repeat(WIDEST_COMMENT - 3))).is_empty());
    }

    #[test]
    fn tests_do_not_fill_a_folder() {
        assert!(
            ["crate/a/tests/b.rs", "crate/a/src/b/tests.rs", "www/src/a/b.test.ts"].map(is_test) == [true; 3]
        );
        assert!(["crate/a/src/test.rs", "www/src/a/latest.ts"].map(is_test) == [false; 2]);
    }

    #[test]
    fn a_full_folder_needs_its_reason_in_the_first_lines() {
        assert!(says_why("//! Rooms.\n//!\n//! Many files: one for each exported function."));
        assert!(!says_why(&format!("{}//! Many files: too late.", "//!\n".repeat(REASON_LINES))));
    }
}
