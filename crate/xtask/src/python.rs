//! The package for Python: a wheel, and its tests in a fresh environment. What both need comes from Python's registry
//! at pinned versions, into environments of their own below target/.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{Outcome, Run, ask, command, no_arguments, run, target};
use crate::step::Steps;

/// What builds the wheel; crate/python/pyproject.toml names the same.
const MATURIN: &str = "1.16.0";

const MISSING: &str =
    "Python 3.10 or later with venv and pip is missing (`python3`, or the one that FROND_PYTHON names)";

/// Writes the wheel for users into target/python.
pub fn build(steps: &mut Steps, arguments: &[String]) -> Outcome {
    no_arguments("python", arguments)?;
    let python = find().ok_or(MISSING)?;
    let wheel = steps.run("build the wheel", || wheel(&python, "wheel", run))?;
    println!("\nThe wheel is {}: `pip install` takes it.", wheel.display());
    Ok(())
}

/// Installs a wheel, optimised as for all tests, into a fresh environment, and tries it there. Where there is no
/// Python, it says so.
pub fn test(run: Run) -> Outcome {
    let Some(python) = find() else {
        println!("{MISSING}: the package for Python was not tried");
        return Ok(());
    };
    let wheel = wheel(&python, "dev", run)?;
    let place = folder().join("test");
    run(command(&python).args(["-m", "venv", "--clear"]).arg(&place))?;
    run(pip(&place).args(["--requirement", "tests/python/requirements.txt"]).arg(wheel))?;
    // It writes nothing beside the tests.
    let tests = ["-B", "-m", "pytest", "-p", "no:cacheprovider", "tests/python", "-q"];
    run(command(program(&place, "python")).args(tests))
}

/// A Python that is new enough.
fn find() -> Option<String> {
    let named = std::env::var("FROND_PYTHON").ok();
    let names = named.map_or_else(|| vec!["python3".to_owned(), "python".to_owned()], |name| vec![name]);
    let asked = "import sys, venv, ensurepip; print(sys.version_info >= (3, 10))";
    names.into_iter().find(|name| ask(command(name).args(["-c", asked])).is_some_and(|text| text == "True"))
}

/// The path of a new wheel.
fn wheel(python: &str, profile: &str, run: Run) -> Outcome<PathBuf> {
    let place = folder().join("maturin");
    let has = ask(command(program(&place, "maturin")).arg("--version"));
    if has.is_none_or(|text| text != format!("maturin {MATURIN}")) {
        run(command(python).args(["-m", "venv", "--clear"]).arg(&place))?;
        run(pip(&place).arg(format!("maturin=={MATURIN}")))?;
    }
    let out = folder().join(profile);
    if out.exists() {
        fs::remove_dir_all(&out)?;
    }
    run(command(program(&place, "maturin"))
        .args(["build", "--quiet", "--manifest-path", "crate/python/Cargo.toml", "--profile", profile])
        .args(["--interpreter", python])
        .arg("--out")
        .arg(&out))?;
    let made = fs::read_dir(&out)?.next().ok_or("maturin has made no wheel")?;
    Ok(made?.path())
}

fn folder() -> PathBuf {
    target().join("python")
}

/// A program of an environment.
fn program(place: &Path, name: &str) -> PathBuf {
    let folder = if cfg!(windows) { "Scripts" } else { "bin" };
    place.join(folder).join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

fn pip(place: &Path) -> Command {
    let mut pip = command(program(place, "python"));
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-input"]);
    pip
}
