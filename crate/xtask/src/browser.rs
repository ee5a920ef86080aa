//! Chromium and its driver, and the other browsers, for the tests: found, or installed where that can be done without
//! asking.

use std::env;
use std::path::PathBuf;

use crate::command::{Outcome, ask, command, run};
use crate::step::Steps;

const CHROMIUM_VARIABLE: &str = "FROND_CHROMIUM";
const DRIVER_VARIABLE: &str = "FROND_CHROMEDRIVER";
const FIREFOX_VARIABLE: &str = "FROND_FIREFOX";
const WEBKIT_VARIABLE: &str = "FROND_WEBKIT";

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
const FIREFOX: &[&str] = &[
    "firefox-esr",
    "firefox",
    "/Applications/Firefox.app/Contents/MacOS/firefox",
    "C:\\Program Files\\Mozilla Firefox\\firefox.exe",
];
/// The small browser of WebKitGTK, which Debian has outside of the path.
const WEBKIT: &[&str] = &[
    "/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser",
    "/usr/lib/aarch64-linux-gnu/webkit2gtk-4.1/MiniBrowser",
];
/// What drives it, and the display that it needs.
const WEBKIT_NEEDS: &[&str] = &["WebKitWebDriver", "Xvfb"];

const INSTALL_CHROMIUM: &str = "Install Chromium and its driver (Debian: apt-get install chromium chromium-driver; \
     Fedora: dnf install chromium chromedriver; macOS: brew install --cask chromium chromedriver)";
const INSTALL_FIREFOX: &str = "Install Firefox (Debian: apt-get install firefox-esr; Fedora: dnf install firefox; macOS: \
     brew install --cask firefox)";
const INSTALL_WEBKIT: &str = "Install WebKitGTK (Debian: apt-get install webkit2gtk-driver xvfb)";

/// The browser of the end-to-end tests: FROND_CHROMIUM, or what the system has.
pub fn chromium() -> Outcome<PathBuf> {
    find(CHROMIUM_VARIABLE, CHROMIUM, INSTALL_CHROMIUM)
}

/// The driver that the tests of the shaders need, of the same version as the browser: FROND_CHROMEDRIVER, or the
/// system's.
pub fn driver() -> Outcome<PathBuf> {
    find(DRIVER_VARIABLE, DRIVER, INSTALL_CHROMIUM)
}

/// Mozilla's own build: FROND_FIREFOX, or what the system has.
pub fn firefox() -> Outcome<PathBuf> {
    find(FIREFOX_VARIABLE, FIREFOX, INSTALL_FIREFOX)
}

/// The engine of Safari: FROND_WEBKIT, or what the system has. Debian and its like alone have it.
pub fn webkit() -> Outcome<PathBuf> {
    let browser = find(WEBKIT_VARIABLE, WEBKIT, INSTALL_WEBKIT)?;
    match WEBKIT_NEEDS.iter().find(|name| on_path(&[name]).is_none()) {
        Some(name) => Err(format!("{name} is not installed. {INSTALL_WEBKIT}.").into()),
        None => Ok(browser),
    }
}

/// Sees to it that Chromium and its driver are there.
pub fn set_up(steps: &mut Steps) -> Outcome {
    let found = || chromium().and(driver()).map(|_| ());
    // Without a font, text in pictures of the page would be empty boxes.
    install(
        steps,
        "Chromium",
        "chromium chromium-driver fonts-liberation",
        &[CHROMIUM_VARIABLE, DRIVER_VARIABLE],
        found,
    )
}

/// Sees to it that Firefox is there, and WebKit where the system can have it.
pub fn set_up_others(steps: &mut Steps) -> Outcome {
    let fonts = "fonts-liberation";
    let found = || firefox().map(|_| ());
    install(steps, "Firefox", &format!("firefox-esr {fonts}"), &[FIREFOX_VARIABLE], found)?;
    if !can_install() {
        return Ok(());
    }
    let found = || webkit().map(|_| ());
    install(steps, "WebKit", &format!("webkit2gtk-driver xvfb {fonts}"), &[WEBKIT_VARIABLE], found)
}

/// Installs Debian's packages where what they bring is not there yet.
fn install(
    steps: &mut Steps,
    what: &str,
    packages: &str,
    variables: &[&str],
    found: impl Fn() -> Outcome,
) -> Outcome {
    let Err(missing) = found() else { return Ok(()) };
    // Where a variable names them, it is the variable that has to be put right.
    let named = variables.iter().any(|name| env::var_os(name).is_some());
    if named || !can_install() {
        return Err(missing);
    }
    steps.run(&format!("install {what} by apt-get (once, some minutes)"), || {
        let apt = |line: &str| {
            run(command("apt-get").args(line.split_whitespace()).env("DEBIAN_FRONTEND", "noninteractive"))
        };
        apt("update --quiet")?;
        apt(&format!("install --quiet --yes --no-install-recommends {packages}"))
            .map_err(|problem| format!("{problem}\n{missing}"))?;
        found()
    })
}

fn can_install() -> bool {
    is_root() && on_path(&["apt-get"]).is_some()
}

fn find(variable: &str, names: &[&str], install: &str) -> Outcome<PathBuf> {
    match env::var_os(variable).map(PathBuf::from) {
        Some(path) if path.is_file() => Ok(path),
        Some(path) => Err(format!("{variable} is {}, which is no file", path.display()).into()),
        None => Ok(on_path(names).ok_or_else(|| {
            format!(
                "{} is not installed, and this cannot install it here. {install}, or say where it is in {variable}.",
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
