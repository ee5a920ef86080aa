//! Every check, as named steps in groups: the cheap ones first.

use std::net::TcpListener;
use std::path::Path;
use std::process::Command;
use std::thread;

use crate::browser;
use crate::circles;
use crate::command::{Outcome, cargo, cargo_wasm, run, run_beside, target};
use crate::folders;
use crate::modules::MODULES;
use crate::node::{self, Tool};
use crate::site;
use crate::size;
use crate::step::Steps;
use crate::tools::{self, WASM_TARGET};
use crate::wasm;

/// One check: the group it belongs to, its name, what it is, the set-up it needs and what it does.
struct Check {
    group: &'static str,
    name: &'static str,
    what: &'static str,
    set_up: fn(&mut Steps) -> Outcome,
    work: Work,
}

/// What a check does: all of it, or those of its tests that are named, all where none is.
enum Work {
    All(fn() -> Outcome),
    Named(fn(&[String]) -> Outcome),
}

/// The group of what runs only when it is named.
const ON_DEMAND: &str = "deep";

/// How many times as many examples `deep` tries.
const DEEP_FACTOR: u32 = 50;

const CHECKS: &[Check] = &[
    Check {
        group: "rust",
        name: "fmt",
        what: "layout of the Rust code",
        set_up: tools::components,
        work: Work::All(fmt),
    },
    Check {
        group: "rust",
        name: "circles",
        what: "no circle of imports among the files of a crate",
        set_up: nothing,
        work: Work::All(circles::gate),
    },
    Check {
        group: "rust",
        name: "folders",
        what: "no folder too full, no comment too wide",
        set_up: nothing,
        work: Work::All(folders::gate),
    },
    Check {
        group: "rust",
        name: "clippy",
        what: "clippy, natively",
        set_up: tools::components,
        work: Work::All(clippy),
    },
    Check {
        group: "rust",
        name: "clippy-wasm",
        what: "clippy, for the browser",
        set_up: lint_wasm,
        work: Work::All(clippy_wasm),
    },
    Check {
        group: "rust",
        name: "doc",
        what: "documentation of the crates, without a warning",
        set_up: nothing,
        work: Work::All(doc),
    },
    Check {
        group: "rust",
        name: "cargo-test",
        what: "tests of the crates",
        set_up: nothing,
        work: Work::All(cargo_test),
    },
    Check { group: "web", name: "tsc", what: "types of the page", set_up: wasm::build, work: Work::All(tsc) },
    Check {
        group: "web",
        name: "biome",
        what: "lint and layout of the page",
        set_up: node::packages,
        work: Work::All(biome),
    },
    Check {
        group: "web",
        name: "vitest",
        what: "tests of the page's parts",
        set_up: wasm::build,
        work: Work::Named(vitest),
    },
    Check {
        group: "wasm",
        name: "shaders",
        what: "what graphics cards draw, in Chrome",
        set_up: browser,
        work: Work::Named(shaders),
    },
    Check {
        group: "site",
        name: "size",
        what: "what a visitor downloads",
        set_up: site::build,
        work: Work::All(size::gate),
    },
    Check {
        group: "e2e",
        name: "webgl2",
        what: "the site, on WebGL2",
        set_up: e2e,
        work: Work::Named(|names| play("webgl2", names)),
    },
    Check {
        group: "e2e",
        name: "webgpu",
        what: "the site, on WebGPU",
        set_up: e2e,
        work: Work::Named(|names| play("webgpu", names)),
    },
    Check {
        group: "e2e",
        name: "phone",
        what: "the site, on a small screen",
        set_up: e2e,
        work: Work::Named(|names| play("phone", names)),
    },
    Check {
        group: ON_DEMAND,
        name: "deep",
        what: "tests of the crates with many more examples; only when named",
        set_up: nothing,
        work: Work::All(deep),
    },
    Check {
        group: ON_DEMAND,
        name: "card",
        what: "what this machine's own graphics card draws and decides, natively; only when named",
        set_up: nothing,
        work: Work::All(card),
    },
];

/// Runs the checks whose group or name is among `wanted`, or all but those [`ON_DEMAND`]; stops at the first that
/// fails. After `--` there are names of single tests.
pub fn test(steps: &mut Steps, wanted: &[String]) -> Outcome {
    let (wanted, names) = match wanted.iter().position(|word| word == "--") {
        Some(at) => (&wanted[..at], &wanted[at + 1..]),
        None => (wanted, &[][..]),
    };
    if let Some(word) = wanted.iter().find(|word| !CHECKS.iter().any(|check| check.is(word))) {
        return Err(format!("there is no check `{word}`; there are:\n{}", list()).into());
    }
    let mut chosen = CHECKS.iter().filter(|check| check.is_chosen(wanted));
    if !names.is_empty()
        && let Some(check) = chosen.clone().find(|check| matches!(check.work, Work::All(_)))
    {
        return Err(format!("`{}` has no single tests that it could run alone", check.name).into());
    }
    while let Some(check) = chosen.next() {
        let name = check.title();
        let outcome = steps.prepare(&name, check.set_up).and_then(|()| {
            steps.run(&name, || match check.work {
                Work::All(work) => work(),
                Work::Named(work) => work(names),
            })
        });
        if outcome.is_err() {
            steps.again(format!("cargo xtask test {}", check.name));
            chosen.for_each(|check| steps.leave(check.title()));
            return outcome;
        }
    }
    Ok(())
}

/// The checks as help prints them.
pub fn list() -> String {
    CHECKS
        .iter()
        .map(|check| format!("        {:<5} {:<12} {}\n", check.group, check.name, check.what))
        .collect()
}

impl Check {
    fn title(&self) -> String {
        format!("{}: {}", self.name, self.what)
    }

    fn is_chosen(&self, wanted: &[String]) -> bool {
        if wanted.is_empty() { self.group != ON_DEMAND } else { wanted.iter().any(|word| self.is(word)) }
    }

    fn is(&self, word: &str) -> bool {
        self.group == word || self.name == word
    }
}

fn nothing(_: &mut Steps) -> Outcome {
    Ok(())
}

fn lint_wasm(steps: &mut Steps) -> Outcome {
    tools::components(steps)?;
    tools::wasm_target(steps)
}

/// The modules first: the tests use what was compiled for them.
fn browser(steps: &mut Steps) -> Outcome {
    wasm::build(steps)?;
    browser::set_up(steps)
}

fn e2e(steps: &mut Steps) -> Outcome {
    site::build(steps)?;
    browser::set_up(steps)
}

fn fmt() -> Outcome {
    run(&mut cargo("fmt --all --check"))
        .map_err(|problem| format!("{problem}\n`cargo fmt --all` puts it right.").into())
}

fn clippy() -> Outcome {
    run(&mut cargo("clippy --quiet --workspace --all-targets -- --deny warnings"))
}

/// The crates with code for the browser only, and the tests that run there: all modules at once, but for the renderer
/// of WebGL2, which the one of WebGPU excludes.
fn clippy_wasm() -> Outcome {
    let others: Vec<String> = MODULES
        .iter()
        .flat_map(|(_, features)| features.split(','))
        .filter(|feature| *feature != "webgl2")
        .map(|feature| format!("frond-web/{feature}"))
        .collect();
    for features in [others.join(","), "frond-web/webgl2".to_owned()] {
        let line = format!(
            "clippy --quiet --target {WASM_TARGET} --package frond-render --package frond-web --lib --tests \
             --no-default-features --features {features} -- --deny warnings"
        );
        run(&mut cargo_wasm(&line))?;
    }
    Ok(())
}

/// After clippy: what other people's crates say of themselves is there already.
fn doc() -> Outcome {
    run(cargo("doc --quiet --workspace --no-deps").env("RUSTDOCFLAGS", "--deny warnings"))
}

fn cargo_test() -> Outcome {
    run(&mut cargo("test --quiet --workspace"))
}

/// Properties of 256 examples, proptest's own number, have no FROND_CASES to read.
fn deep() -> Outcome {
    let mut command = cargo("test --quiet --workspace");
    for (name, value) in [("FROND_CASES", DEEP_FACTOR), ("PROPTEST_CASES", 256 * DEEP_FACTOR)] {
        if std::env::var_os(name).is_none() {
            command.env(name, value.to_string());
        }
    }
    run(&mut command)
}

/// The same tests try the shaders in the browser, on the software GPU. wgpu for the interfaces of the system takes
/// minutes to compile, and a machine without a card has nothing to try.
fn card() -> Outcome {
    run(&mut with_card("test --package frond-render --test browser -- --nocapture"))
}

/// Cargo, where what needs the card of this machine is compiled: in a folder of its own, or all else would be compiled
/// again.
pub fn with_card(line: &str) -> Command {
    let mut command = cargo(line);
    command.env("RUSTFLAGS", "--cfg frond_card").env("CARGO_TARGET_DIR", target().join("card"));
    command
}

fn tsc() -> Outcome {
    run(&mut Tool::Tsc.command("--project ."))?;
    run(&mut Tool::Tsc.command("--project tests"))
}

fn biome() -> Outcome {
    run(&mut Tool::Biome.command("check --error-on-warnings .")).map_err(|problem| {
        format!("{problem}\n`npm run format` puts right what can be put right without thinking.").into()
    })
}

fn vitest(names: &[String]) -> Outcome {
    run(Tool::Vitest.command("run").args(names))
}

/// Tests of what draws on a graphics card, in the browser that it is for. Each backend is a program of its own: it
/// shares all that is compiled with the module of that backend. They run side by side: most of what the software GPU
/// does for one is done by one core.
fn shaders(names: &[String]) -> Outcome {
    let driver = browser::driver()?;
    thread::scope(|scope| {
        let running = ["webgl2", "webgpu"].map(|backend| {
            let driver = &driver;
            // An error of this kind does not go from thread to thread: its words do.
            scope.spawn(move || shaders_by(backend, names, driver).map_err(|problem| problem.to_string()))
        });
        for run in running {
            run.join().map_err(|_| "the tests of the shaders could not be run")??;
        }
        Ok(())
    })
}

fn shaders_by(backend: &str, names: &[String], driver: &Path) -> Outcome {
    let line = format!(
        "test --release --target {WASM_TARGET} --package frond-render --test browser --no-default-features \
         --features {backend}"
    );
    let mut command = cargo_wasm(&line);
    command.args(names);
    command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", tools::path("wasm-bindgen-test-runner"));
    // Of the system: one that is loaded would fit another browser.
    command.env("CHROMEDRIVER", driver).env("WASM_BINDGEN_TEST_TIMEOUT", "900");
    run_beside(&mut command)
}

/// One project of tests/e2e/playwright.config.ts.
fn play(project: &str, names: &[String]) -> Outcome {
    run(Tool::Playwright
        .command(&format!("test --config tests/e2e/playwright.config.ts --project={project}"))
        .args(names)
        .env("FROND_CHROMIUM", browser::chromium()?)
        .env("FROND_PORT", free_port()?.to_string()))
}

/// A port that nothing listens on, so that no other server is tested by mistake.
pub fn free_port() -> Outcome<u16> {
    Ok(TcpListener::bind("127.0.0.1:0")?.local_addr()?.port())
}
