//! Shaders without their comments: they are a part of what a visitor downloads. Lines keep their numbers.

use std::env::var_os;
use std::fs;
use std::io::Result;
use std::path::{Path, PathBuf};

fn main() -> Result<()> {
    println!("cargo::rerun-if-changed=shader");
    let to = PathBuf::from(var_os("OUT_DIR").unwrap_or_default()).join("shader");
    strip(Path::new("shader"), &to)
}

/// Copies a folder of shaders, without comments and without white space at the ends of lines.
fn strip(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let to = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() {
            strip(&path, &to)?;
            continue;
        }
        let mut plain = String::new();
        for line in fs::read_to_string(&path)?.lines() {
            // WGSL has no strings, so that this is always a comment.
            plain.push_str(line.split("//").next().unwrap_or_default().trim());
            plain.push('\n');
        }
        fs::write(to, plain)?;
    }
    Ok(())
}
