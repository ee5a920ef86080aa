//! libFuzzer on each reader of `crate/fuzz`.

use std::fs;
use std::path::{Path, PathBuf};

use crate::command::{Outcome, cargo, root, run, target};

/// How long each reader is tried, in seconds, where `FROND_FUZZ_SECONDS` says nothing else.
const SECONDS: u32 = 60;

/// Tries the readers that are named, or all. A third of the time goes to any bytes, the rest to documents with a few
/// changes. What a run found to reach other code is where the next one begins, in `target/fuzz`.
pub fn all(names: &[String]) -> Outcome {
    let seconds = match std::env::var("FROND_FUZZ_SECONDS") {
        Ok(text) => text.parse().map_err(|_| format!("FROND_FUZZ_SECONDS is {text:?}, no whole number"))?,
        Err(_) => SECONDS,
    };
    let readers = readers()?;
    if let Some(name) = names.iter().find(|name| !readers.contains(name)) {
        return Err(format!("there is no reader `{name}`; there are: {}", readers.join(", ")).into());
    }
    for reader in readers.iter().filter(|reader| names.is_empty() || names.contains(reader)) {
        one(reader, "bytes", (seconds / 3).max(1))?;
        one(reader, "drafts", (seconds - seconds / 3).max(1))?;
    }
    Ok(())
}

/// Those that have documents; a test of `crate/fuzz` sees to it that all have.
fn readers() -> Outcome<Vec<String>> {
    let entries = fs::read_dir(root().join("tests/fuzz"))?;
    let name = |entry: std::io::Result<fs::DirEntry>| entry.ok()?.file_name().into_string().ok();
    let mut names: Vec<String> = entries.filter_map(name).collect();
    names.sort();
    Ok(names)
}

fn one(reader: &str, kind: &str, seconds: u32) -> Outcome {
    println!("    {reader}, {kind}: {seconds} s");
    let folder = target().join("fuzz");
    let made = |path: PathBuf| fs::create_dir_all(&path).map(|()| path);
    let corpus = made(folder.join("corpus").join(reader).join(kind))?;
    let found = made(folder.join("found"))?;
    let line = format!(
        "bolero test {kind}::{reader} --package frond-fuzz --sanitizer NONE -T {seconds}s --timeout 20s \
         --engine-args=-print_final_stats=1 --engine-args=-verbosity=0"
    );
    let mut command = cargo(&line);
    command.arg("--target-dir").arg(folder.join("build")).env_remove("CARGO_TARGET_DIR");
    command.arg("--corpus-dir").arg(corpus).arg("--crashes-dir").arg(&found);
    if kind == "bytes" {
        let mut own = std::ffi::OsString::from("--engine-args=");
        own.push(root().join("tests/fuzz").join(reader));
        command.arg(own);
    }
    run(command.env("FROND_FUZZ_FOUND", &found)).map_err(|problem| told(&problem.to_string(), reader, &found))
}

fn told(problem: &str, reader: &str, found: &Path) -> Box<dyn std::error::Error> {
    format!(
        "{problem}\nThe document that broke it is {}. Give it a name in tests/fuzz/{reader}: \
         `cargo test -p frond-fuzz {reader}` tries it from then on.",
        found.join(reader).display()
    )
    .into()
}
