//! Running other programs, from the root of the repository, with messages that say what failed.

use std::error::Error;
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

/// What every task returns; the error is a sentence for the person at the terminal.
pub type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// How a command is run: [`run`], [`run_beside`] or [`run_behind`].
pub type Run = fn(&mut Command) -> Outcome;

/// The root of the repository.
pub fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here).to_path_buf()
}

/// Where Cargo writes what it builds.
pub fn target() -> PathBuf {
    match std::env::var_os("CARGO_TARGET_DIR") {
        Some(directory) => root().join(directory),
        None => root().join("target"),
    }
}

/// Where the pinned tools are installed: in a folder of Frond's own among the caches of who runs this, so that every
/// checkout has them and no other project's version is touched; below target/ where there is no such place.
pub fn tools() -> PathBuf {
    let set = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    set("XDG_CACHE_HOME")
        .or_else(|| set("LOCALAPPDATA"))
        .or_else(|| set("HOME").map(|home| home.join(".cache")))
        .filter(|caches| caches.is_absolute())
        .map_or_else(|| root().join("target/tools"), |caches| caches.join("frond/tools"))
}

/// A program run from the root, with the pinned tools first on the path and the exact answers set.
pub fn command(program: impl Into<OsString>) -> Command {
    let mut command = Command::new(program.into());
    command.current_dir(root());
    let old = std::env::var_os("PATH").unwrap_or_default();
    let paths = std::iter::once(tools().join("bin")).chain(std::env::split_paths(&old));
    // A path that cannot be joined (it holds a separator) cannot come out of split_paths.
    if let Ok(path) = std::env::join_paths(paths) {
        command.env("PATH", path);
    }
    if std::env::var_os("FROND_KNOWN").is_none() {
        command.env("FROND_KNOWN", root().join("tests/known"));
    }
    command
}

/// Cargo, with the words of `line` as arguments.
pub fn cargo(line: &str) -> Command {
    let mut command = command(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(line.split_whitespace());
    command
}

/// Cargo for the browser.
pub fn cargo_wasm(line: &str) -> Command {
    let mut command = cargo(line);
    own_flags(&mut command);
    command
}

/// Lets the flags of .cargo/config.toml hold: those of the environment would replace them.
pub fn own_flags(command: &mut Command) {
    for name in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_RUSTFLAGS"] {
        command.env_remove(name);
    }
}

/// Runs it to the end, with its output on the terminal.
pub fn run(command: &mut Command) -> Outcome {
    let status = command.status().map_err(|error| not_started(command, &error))?;
    ended(command, status)
}

/// As [`run`], for what runs beside others: its output is printed in one piece, at its end.
pub fn run_beside(command: &mut Command) -> Outcome {
    let output = command.stdin(Stdio::null()).output().map_err(|error| not_started(command, &error))?;
    let mut terminal = std::io::stdout().lock();
    terminal.write_all(&output.stdout)?;
    terminal.write_all(&output.stderr)?;
    terminal.flush()?;
    ended(command, output.status)
}

/// As [`run_beside`], for what is to leave the machine to all else: where the system has `nice`, by that.
pub fn run_behind(command: &mut Command) -> Outcome {
    if ask(Command::new("nice").args(["-n", "19", "true"])).is_none() {
        return run_beside(command);
    }
    let mut nice = Command::new("nice");
    nice.args(["-n", "19"]).arg(command.get_program()).args(command.get_args());
    if let Some(folder) = command.get_current_dir() {
        nice.current_dir(folder);
    }
    for (name, value) in command.get_envs() {
        match value {
            Some(value) => nice.env(name, value),
            None => nice.env_remove(name),
        };
    }
    run_beside(&mut nice)
}

/// What it prints, or nothing where it cannot be run: for asking whether a tool is there.
pub fn ask(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Refuses arguments where a command takes none.
pub fn no_arguments(name: &str, arguments: &[String]) -> Outcome {
    match arguments.first() {
        None => Ok(()),
        Some(word) => Err(format!("`cargo xtask {name}` takes no `{word}`: see `cargo xtask help`").into()),
    }
}

/// The command as one would type it: the program by its name, paths from the root on.
fn shown(command: &Command) -> String {
    let name = Path::new(command.get_program()).file_name().unwrap_or_default();
    let words = std::iter::once(name).chain(command.get_args());
    let line = words.map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ");
    line.replace(&format!("{}/", root().display()), "")
}

fn ended(command: &Command, status: ExitStatus) -> Outcome {
    if status.success() { Ok(()) } else { Err(format!("`{}` failed ({status})", shown(command)).into()) }
}

fn not_started(command: &Command, error: &std::io::Error) -> String {
    format!("`{}` could not be started: {error}", command.get_program().to_string_lossy())
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn what_runs_behind_is_the_same_command_and_fails_as_it_does() {
        let mut script = command("sh");
        script.args([
            "-c",
            "test \"$FROND_WORD\" = said && test -z \"$HOME\" && pwd | grep -qx \"$1\"",
            "sh",
            "/",
        ]);
        script.env("FROND_WORD", "said").env_remove("HOME").current_dir("/");
        assert!(run_behind(&mut script).is_ok());
        assert!(run_behind(script.env("FROND_WORD", "unsaid")).is_err());
    }
}
