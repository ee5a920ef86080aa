//! The development server: Vite for the page, and this program for the Rust crates.

use std::env;
use std::time::Duration;

use crate::command::Outcome;
use crate::node::Tool;
use crate::step::Steps;
use crate::wasm;

/// How often the crates are looked at for changes.
const POLL_INTERVAL: Duration = Duration::from_millis(1000);

/// Serves until it is interrupted.
pub fn serve(steps: &mut Steps, arguments: &[String]) -> Outcome {
    let options = Options::parse(arguments)?;
    wasm::build(steps)?;
    let mut line = "--host 127.0.0.1 --clearScreen false".to_owned();
    if let Some(port) = options.port {
        line += &format!(" --strictPort --port {port}");
    }
    if options.open.unwrap_or_else(has_screen) {
        line += " --open";
    }
    let mut vite = Tool::Vite.start(&line)?;
    let mut inputs = wasm::inputs()?;
    loop {
        std::thread::sleep(POLL_INTERVAL);
        if let Some(status) = vite.try_wait()? {
            return if status.success() { Ok(()) } else { Err(format!("Vite ended ({status})").into()) };
        }
        // A file that is being written may be gone for a moment: look again.
        let Ok(now) = wasm::inputs() else { continue };
        if now != inputs {
            inputs = now;
            // The compiler has said what is wrong; the page stays at the last module that was built.
            if let Err(problem) = wasm::rebuild(steps) {
                eprintln!("{problem}");
            }
        }
    }
}

#[derive(Debug, Default, PartialEq)]
struct Options {
    port: Option<u16>,
    open: Option<bool>,
}

impl Options {
    fn parse(arguments: &[String]) -> Outcome<Self> {
        let mut options = Self::default();
        let mut words = arguments.iter().map(String::as_str);
        while let Some(word) = words.next() {
            match word {
                "--open" => options.open = Some(true),
                "--no-open" => options.open = Some(false),
                _ => {
                    let value = match word.strip_prefix("--port") {
                        Some("") => words.next(),
                        Some(rest) => rest.strip_prefix('='),
                        None => return Err(format!("`cargo xtask serve` takes no `{word}`").into()),
                    };
                    let port = value.and_then(|text| text.parse().ok()).filter(|port| *port != 0);
                    options.port =
                        Some(port.ok_or("--port wants a number from 1 to 65535, e.g. --port 8080")?);
                }
            }
        }
        Ok(options)
    }
}

/// Whether there is a screen on which a browser could open, with a person before it.
fn has_screen() -> bool {
    let screen = cfg!(any(windows, target_os = "macos"))
        || ["DISPLAY", "WAYLAND_DISPLAY"]
            .iter()
            .any(|name| env::var_os(name).is_some_and(|text| !text.is_empty()));
    screen && env::var_os("CI").is_none() && env::var_os("SSH_CONNECTION").is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Option<Options> {
        Options::parse(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>()).ok()
    }

    #[test]
    fn a_port_is_a_number_that_can_be_served() {
        assert_eq!(parse(""), Some(Options::default()));
        assert_eq!(parse("--port 8080"), Some(Options { port: Some(8080), open: None }));
        assert_eq!(parse("--port=1 --open"), Some(Options { port: Some(1), open: Some(true) }));
        for line in ["--port", "--port=", "--port 0", "--port 65536", "--port x", "--ports 1", "8080"] {
            assert_eq!(parse(line), None, "{line}");
        }
    }
}
