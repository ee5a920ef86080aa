//! Chromium and its driver, for the tests: found, or installed where that can be done without asking.

use std::env;
use std::path::PathBuf;

use crate::command::{Outcome, ask, command, run};
use crate::step::Steps;

const CHROMIUM_VARIABLE: &str = "FROND_CHROMIUM";
const DRIVER_VARIABLE: &str = "FROND_CHROMEDRIVER";

const CHROMIUM: &[&str] = &[
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
];
const DRIVER: &[&str] =
    &["chromedriver", "/usr/lib/chromium/chromedriver", "/usr/lib/chromium-browser/chromedriver"];

/// The browser of the end-to-end tests: FROND_CHROMIUM, or what the system has.
pub fn chromium() -> Outcome<PathBuf> {
    find(CHROMIUM_VARIABLE, CHROMIUM)
}

/// The driver that the tests of the shaders need, of the same version as the browser: FROND_CHROMEDRIVER, or the
/// system's.
pub fn driver() -> Outcome<PathBuf> {
    find(DRIVER_VARIABLE, DRIVER)
}

/// Sees to it that both are there.
pub fn set_up(steps: &mut Steps) -> Outcome {
    let found = || chromium().and(driver());
    let Err(missing) = found() else { return Ok(()) };
    // Where a variable names them, it is the variable that has to be put right.
    let named = [CHROMIUM_VARIABLE, DRIVER_VARIABLE].iter().any(|name| env::var_os(name).is_some());
    if named || !is_root() || on_path(&["apt-get"]).is_none() {
        return Err(missing);
    }
    steps.run("install Chromium by apt-get (once, some minutes)", || {
        let apt = |line: &str| {
            run(command("apt-get").args(line.split_whitespace()).env("DEBIAN_FRONTEND", "noninteractive"))
        };
        apt("update --quiet")?;
        // Without a font, text in pictures of the page would be empty boxes.
        apt("install --quiet --yes --no-install-recommends chromium chromium-driver fonts-liberation")
            .map_err(|problem| format!("{problem}\n{missing}"))?;
        found().map(|_| ())
    })
}

fn find(variable: &str, names: &[&str]) -> Outcome<PathBuf> {
    match env::var_os(variable).map(PathBuf::from) {
        Some(path) if path.is_file() => Ok(path),
        Some(path) => Err(format!("{variable} is {}, which is no file", path.display()).into()),
        None => Ok(on_path(names).ok_or_else(|| {
            format!(
                "{} is not installed, and this cannot install it here. Install Chromium and its driver (Debian: \
                 apt-get install chromium chromium-driver; Fedora: dnf install chromium chromedriver; macOS: brew \
                 install --cask chromium chromedriver), or say where it is in {variable}.",
                names[0]
            )
        })?),
    }
}

/// The first of these programs that is a file; a name without a folder is looked for on the path.
fn on_path(names: &[&str]) -> Option<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    names.iter().find_map(|name| {
        // Joined to a folder, an absolute name stays what it is.
        env::split_paths(&path).map(|folder| folder.join(name)).find(|file| file.is_file())
    })
}

fn is_root() -> bool {
    cfg!(unix) && ask(command("id").arg("-u")).is_some_and(|id| id == "0")
}
