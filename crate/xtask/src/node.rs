//! The page's side of the set-up: Node, and the packages of package-lock.json.

use std::path::PathBuf;
use std::process::{Child, Command, Stdio};

use crate::command::{Outcome, ask, command, root, run};
use crate::stamp::{self, Hash};
use crate::step::Steps;

/// The least version that Vite and its like run on.
const OLDEST_NODE: (u32, u32) = (20, 19);

/// Programs that come as packages.
#[derive(Clone, Copy)]
pub enum Tool {
    Biome,
    Knip,
    Playwright,
    Tsc,
    Vite,
    Vitest,
    WasmOpt,
}

impl Tool {
    /// Runs it by Node itself: no shell, no `npx`, nothing that might look for it on the network.
    pub fn command(self, line: &str) -> Command {
        let mut command = command("node");
        command.arg(self.script()).args(line.split_whitespace());
        command
    }

    /// Starts a server, which ends when this program does, however that ends: then its input ends.
    pub fn start(self, line: &str) -> Outcome<Child> {
        let mut command = command("node");
        command
            .args(["--import", "data:text/javascript,process.stdin.on('end',()=>process.exit()).resume()"]);
        command.arg(self.script()).args(line.split_whitespace()).stdin(Stdio::piped());
        command.spawn().map_err(|error| format!("{} did not start: {error}", self.script().display()).into())
    }

    fn script(self) -> PathBuf {
        let script = match self {
            Self::Biome => "@biomejs/biome/bin/biome",
            Self::Knip => "knip/bin/knip.js",
            Self::Playwright => "@playwright/test/cli.js",
            Self::Tsc => "typescript/bin/tsc",
            Self::Vite => "vite/bin/vite.js",
            Self::Vitest => "vitest/vitest.mjs",
            Self::WasmOpt => "binaryen/bin/wasm-opt",
        };
        root().join("node_modules").join(script)
    }
}

/// Sees to it that Node is there and that the packages are those of the lock file.
pub fn packages(steps: &mut Steps) -> Outcome {
    let text = ask(command("node").arg("--version"))
        .ok_or("Node is not installed, or not on the path. Frond needs Node 20.19 or later, with npm.")?;
    let version =
        parse(&text).ok_or_else(|| format!("`node --version` says {text:?}, which is no version"))?;
    if version < OLDEST_NODE {
        return Err(format!(
            "Node is {text}: Frond needs Node {}.{} or later.",
            OLDEST_NODE.0, OLDEST_NODE.1
        )
        .into());
    }
    let stamp = root().join("node_modules/.frond-stamp");
    let mut hash = Hash::new(&[]);
    hash.path(&root().join("package-lock.json"))?;
    if stamp::holds(&stamp, &hash.text()) {
        return Ok(());
    }
    steps.run("install the npm packages", || {
        let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
        run(command(npm).args(["ci", "--no-audit", "--no-fund"])).map_err(|problem| {
            format!("{problem}\nThe packages of package-lock.json could not be installed; it needs the network, once.")
        })?;
        stamp::write(&stamp, &hash.text())
    })
}

/// `v20.19.1` as (20, 19).
fn parse(version: &str) -> Option<(u32, u32)> {
    let mut numbers = version.strip_prefix('v')?.split('.').map(str::parse);
    Some((numbers.next()?.ok()?, numbers.next()?.ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_as_numbers() {
        assert_eq!(parse("v20.19.43"), Some((20, 19)));
        assert!(parse("v9.99.0").is_some_and(|version| version < OLDEST_NODE));
        assert!(parse("v100.0.0-nightly").is_some_and(|version| version > OLDEST_NODE));
        assert_eq!(parse("20.19.0"), None);
        assert_eq!(parse("v20"), None);
    }
}
