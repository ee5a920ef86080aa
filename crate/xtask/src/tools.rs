//! The Rust side of the set-up: the wasm target, rustfmt and clippy, and wasm-bindgen at a pinned version.

use std::path::PathBuf;
use std::process::Command;

use crate::command::{Outcome, ask, cargo, command, own_flags, root, run, tools};
use crate::step::Steps;

pub const WASM_TARGET: &str = "wasm32-unknown-unknown";

/// Sees to it that Rust can compile for the browser.
pub fn wasm_target(steps: &mut Steps) -> Outcome {
    let sysroot = ask(command("rustc").args(["--print", "sysroot"])).ok_or("rustc does not run")?;
    if PathBuf::from(sysroot).join("lib/rustlib").join(WASM_TARGET).is_dir() {
        return Ok(());
    }
    steps.run("install the wasm target", || {
        run(command("rustup").args(["target", "add", WASM_TARGET])).map_err(|problem| {
            format!("{problem}\nInstall Rust by rustup, or your system's package of Rust's {WASM_TARGET}.")
                .into()
        })
    })
}

/// Sees to it that rustfmt and clippy are there.
pub fn components(steps: &mut Steps) -> Outcome {
    let missing: Vec<&str> = [("rustfmt", "fmt --version"), ("clippy", "clippy --version")]
        .into_iter()
        .filter(|(_, line)| ask(&mut cargo(line)).is_none())
        .map(|(name, _)| name)
        .collect();
    if missing.is_empty() {
        return Ok(());
    }
    steps.run("install rustfmt and clippy", || {
        run(command("rustup").args(["component", "add"]).args(&missing)).map_err(|problem| {
            format!("{problem}\nInstall Rust by rustup, or {} by your system.", missing.join(" and ")).into()
        })
    })
}

/// Sees to it that wasm-bindgen is there, of the version that Cargo.lock has for the library: they must be one.
pub fn wasm_bindgen(steps: &mut Steps) -> Outcome {
    let lock = std::fs::read_to_string(root().join("Cargo.lock"))?;
    let version = locked(&lock, "wasm-bindgen").ok_or("Cargo.lock holds no wasm-bindgen")?;
    install(steps, "wasm-bindgen", "wasm-bindgen-cli", version, "")
}

/// The version of cargo-bolero, which speaks to the bolero of Cargo.lock.
const BOLERO: &str = "0.13.5";

/// Sees to it that cargo-bolero is there, which compiles the crates so that libFuzzer sees which code is reached.
pub fn bolero(steps: &mut Steps) -> Outcome {
    install(steps, "cargo-bolero", "cargo-bolero", BOLERO, "--features libfuzzer")
}

/// A pinned program.
pub fn tool(name: &str) -> Command {
    command(path(name))
}

/// Where a pinned program is.
pub fn path(name: &str) -> PathBuf {
    tools().join("bin").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

fn install(steps: &mut Steps, program: &str, package: &str, version: &str, features: &str) -> Outcome {
    let has = ask(tool(program).arg("--version")).is_some_and(|text| text.ends_with(&format!(" {version}")));
    if has {
        return Ok(());
    }
    steps.run(&format!("install {package} {version} into {} (once, some minutes)", tools().display()), || {
        // It speaks to drivers on this machine alone, without encryption, which would be a third of what is compiled.
        let line = format!("install {package} --version ={version} --force --no-default-features {features}");
        let build = |locked: &[&str]| {
            let mut command = cargo(&line);
            // Nothing of this workspace's settings is for other people's programs.
            own_flags(&mut command);
            // It works for seconds: what a better optimised program saves takes longer to compile.
            command.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "1");
            command.current_dir(std::env::temp_dir());
            run(command.args(locked).arg("--root").arg(tools()))
        };
        build(&["--locked"])
            // The lock file of a package may name what its registry has since taken back.
            .or_else(|_| {
                println!("    its own lock file cannot be used: choosing versions anew");
                build(&[])
            })
            .map_err(|problem| {
                format!(
                    "{problem}\n{package} {version} could not be installed. It needs a C compiler (`cc`) and the \
                     network, once. By hand: cargo {line} --root {}",
                    tools().display()
                )
                .into()
            })
    })
}

/// The version that a Cargo.lock holds of a package.
fn locked<'a>(lock: &'a str, package: &str) -> Option<&'a str> {
    let name = format!("name = \"{package}\"");
    let mut lines = lock.lines().skip_while(|line| *line != name).skip(1);
    lines.next()?.strip_prefix("version = \"")?.strip_suffix('"')
}

#[cfg(test)]
mod tests {
    use super::locked;

    #[test]
    fn the_version_is_that_of_the_package_of_exactly_this_name() {
        let lock = "[[package]]\nname = \"a-b\"\nversion = \"1.0.0\"\n\n[[package]]\nname = \"a\"\nversion = \"2.0.0\"\n";
        assert_eq!(locked(lock, "a"), Some("2.0.0"));
        assert_eq!(locked(lock, "a-b"), Some("1.0.0"));
        assert_eq!(locked(lock, "b"), None);
    }
}
