//! Measuring: benches of the crates, natively, and of the page, in Chromium. Nothing here is a test.

use std::fs;
use std::net::TcpStream;
use std::path::Path;
use std::process::Child;
use std::time::{Duration, Instant};

use crate::browser;
use crate::command::{Outcome, cargo, command, root, run};
use crate::node::Tool;
use crate::site;
use crate::stamp;
use crate::step::Steps;
use crate::test::{free_port, with_card};

/// The native benches that need the card of this machine.
const ON_CARD: [&str; 2] = ["locus_gpu", "stage_gpu"];

/// Runs the benches whose name is among `wanted`, or all.
///
/// A native bench is a file `crate/<crate>/benches/<name>.rs`. A page bench is a program `tests/bench/<name>.mjs` for
/// Node: FROND_URL is the address of the built site, FROND_CHROMIUM the browser.
pub fn bench(steps: &mut Steps, wanted: &[String]) -> Outcome {
    let native = native()?;
    let pages = page()?;
    let all: Vec<&str> = native.iter().map(|(_, name)| name).chain(&pages).map(String::as_str).collect();
    if let Some(word) = wanted.iter().find(|word| !all.contains(&word.as_str())) {
        return Err(format!("there is no bench `{word}`; there are: {}", all.join(", ")).into());
    }
    let chosen = |name: &String| wanted.is_empty() || wanted.contains(name);
    for (package, name) in native.iter().filter(|(_, name)| chosen(name)) {
        steps.run(&format!("bench {name}"), || {
            let line = format!("bench --package {package} --bench {name}");
            run(&mut if ON_CARD.contains(&name.as_str()) { with_card(&line) } else { cargo(&line) })
        })?;
    }
    if pages.iter().any(&chosen) {
        site::build(steps)?;
        browser::set_up(steps)?;
        let server = Server::start()?;
        for name in pages.iter().filter(|name| chosen(name)) {
            steps.run(&format!("bench {name}"), || {
                run(command("node")
                    .arg(format!("tests/bench/{name}.mjs"))
                    .env("FROND_URL", &server.address)
                    .env("FROND_CHROMIUM", browser::chromium()?))
            })?;
        }
    }
    Ok(())
}

/// The native benches, each as its package and its name.
fn native() -> Outcome<Vec<(String, String)>> {
    let mut found = Vec::new();
    for folder in fs::read_dir(root().join("crate"))? {
        let folder = folder?.path();
        let Some(package) = folder.file_name().map(|name| format!("frond-{}", name.to_string_lossy())) else {
            continue;
        };
        found.extend(names(&folder.join("benches"), "rs")?.into_iter().map(|name| (package.clone(), name)));
    }
    found.sort();
    Ok(found)
}

/// The page benches.
fn page() -> Outcome<Vec<String>> {
    names(&root().join("tests/bench"), "mjs")
}

/// Names, without the ending, of the files right in a folder that have this ending.
fn names(folder: &Path, ending: &str) -> Outcome<Vec<String>> {
    Ok(stamp::files(folder)?
        .into_iter()
        .filter(|file| file.parent() == Some(folder) && file.extension().is_some_and(|own| own == ending))
        .filter_map(|file| file.file_stem().map(|name| name.to_string_lossy().into_owned()))
        .collect())
}

/// The built site, served for as long as this lives.
struct Server {
    process: Child,
    address: String,
}

impl Server {
    fn start() -> Outcome<Self> {
        let port = free_port()?;
        let line = format!("preview --host 127.0.0.1 --strictPort --logLevel warn --port {port}");
        let process = Tool::Vite.start(&line)?;
        let server = Self { process, address: format!("http://127.0.0.1:{port}/") };
        let start = Instant::now();
        while TcpStream::connect(("127.0.0.1", port)).is_err() {
            if start.elapsed() > Duration::from_secs(20) {
                return Err("the server of the built site did not answer within 20 s".into());
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        Ok(server)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It may have ended by itself: then there is nothing left to end.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
