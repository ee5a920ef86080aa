//! Every check, as named steps in groups: the cheap ones first.

use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use crate::browser;
use crate::circles;
use crate::command::{Outcome, Run, cargo, cargo_wasm, command, run, run_behind, run_beside, target};
use crate::folders;
use crate::fuzz;
use crate::modules::MODULES;
use crate::node::{self, Tool};
use crate::python;
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

/// What a check does.
#[derive(Clone, Copy)]
enum Work {
    /// All of it.
    All(fn() -> Outcome),
    /// Those of its tests that are named, all where none is.
    Named(fn(&[String]) -> Outcome),
    /// All of it, behind the checks that come after it in the list: it takes what they leave of the machine.
    Behind(fn(Run) -> Outcome),
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
        work: Work::Behind(clippy),
    },
    Check {
        group: "rust",
        name: "clippy-wasm",
        what: "clippy, for the browser",
        set_up: lint_wasm,
        work: Work::Behind(clippy_wasm),
    },
    Check {
        group: "rust",
        name: "doc",
        what: "documentation of the crates, without a warning",
        set_up: nothing,
        work: Work::Behind(doc),
    },
    Check {
        group: "rust",
        name: "cargo-test",
        what: "tests of the crates",
        set_up: nothing,
        work: Work::Behind(cargo_test),
    },
    Check {
        group: "rust",
        name: "python",
        what: "the package for Python, where Python is there",
        set_up: wasm::build,
        work: Work::Behind(python::test),
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
        name: "knip",
        what: "no file, export or package that nobody uses",
        set_up: wasm::build,
        work: Work::All(knip),
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
        group: "e2e",
        name: "browsers",
        what: "the site, in Firefox and WebKit",
        set_up: others,
        work: Work::Named(browsers),
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
        name: "fuzz",
        what: "what reads files, links and proofs, on documents that libFuzzer makes; only when named",
        set_up: tools::bolero,
        work: Work::Named(fuzz::all),
    },
    Check {
        group: ON_DEMAND,
        name: "card",
        what: "what this machine's own graphics card draws and decides, natively; only when named",
        set_up: nothing,
        work: Work::All(card),
    },
    Check {
        group: ON_DEMAND,
        name: "hosts",
        what: "the package in other people's programs, from the registry; only when named",
        set_up: e2e,
        work: Work::Named(hosts),
    },
];

/// Runs the checks whose group or name is among `wanted`, or all but those [`ON_DEMAND`]; begins none after the first
/// that fails. After `--` there are names of single tests.
pub fn test(steps: &mut Steps, wanted: &[String]) -> Outcome {
    let (wanted, names) = match wanted.iter().position(|word| word == "--") {
        Some(at) => (&wanted[..at], &wanted[at + 1..]),
        None => (wanted, &[][..]),
    };
    if let Some(word) = wanted.iter().find(|word| !CHECKS.iter().any(|check| check.is(word))) {
        return Err(format!("there is no check `{word}`; there are:\n{}", list()).into());
    }
    let chosen: Vec<&Check> = CHECKS.iter().filter(|check| check.is_chosen(wanted)).collect();
    if !names.is_empty()
        && let Some(check) = chosen.iter().find(|check| !matches!(check.work, Work::Named(_)))
    {
        return Err(format!("`{}` has no single tests that it could run alone", check.name).into());
    }
    run_all(steps, &chosen, names)
}

/// Runs the checks in their order. From the first that may run behind others on, those that may do so in a thread of
/// their own, and the others before them: a browser waits for itself in much of its time, and compiling and testing
/// the crates takes one core in much of theirs.
fn run_all(steps: &mut Steps, checks: &[&Check], names: &[String]) -> Outcome {
    let failed = AtomicBool::new(false);
    let may_be_behind = |check: &&Check| matches!(check.work, Work::Behind(_));
    let start = checks.iter().position(&may_be_behind).unwrap_or(checks.len());
    let (behind, before): (Vec<&Check>, Vec<&Check>) =
        checks[start..].iter().copied().partition(&may_be_behind);
    let first = run_these(steps, &checks[..start], names, run, &failed);
    if before.is_empty() || first.is_err() {
        let rest = run_these(steps, &checks[start..], names, run, &failed);
        return first.and(rest);
    }
    // What they need is installed before anything else is under way: nothing is installed twice at once.
    for check in &behind {
        if let Err(problem) = steps.prepare(&check.title(), check.set_up) {
            steps.again(check.alone());
            checks[start..].iter().for_each(|check| steps.leave(check.title()));
            return Err(problem);
        }
    }
    // Said at once: what runs beside it goes on for a while.
    let say = |outcome: &Outcome| {
        if let Err(problem) = outcome {
            eprintln!("\n{problem}");
        }
    };
    thread::scope(|scope| {
        let running = scope.spawn(|| {
            let mut steps = Steps::default();
            let outcome = run_these(&mut steps, &behind, names, run_behind, &failed);
            say(&outcome);
            // An error of this kind does not go from thread to thread: its words do.
            (steps, outcome.map_err(|problem| problem.to_string()))
        });
        let outcome = run_these(steps, &before, names, run, &failed);
        say(&outcome);
        let (others, other) = running.join().map_err(|_| "what runs behind the others could not be run")?;
        steps.add(others);
        outcome.and(other.map_err(Into::into))
    })
}

/// Runs checks one after the other, and begins none after a failure, here or elsewhere.
fn run_these(
    steps: &mut Steps,
    checks: &[&Check],
    names: &[String],
    run: Run,
    failed: &AtomicBool,
) -> Outcome {
    let mut outcome = Ok(());
    for check in checks {
        let name = check.title();
        if failed.load(Ordering::Relaxed) {
            steps.leave(name);
            continue;
        }
        outcome = steps.prepare(&name, check.set_up).and_then(|()| {
            steps.run(&name, || match check.work {
                Work::All(work) => work(),
                Work::Named(work) => work(names),
                Work::Behind(work) => work(run),
            })
        });
        if outcome.is_err() {
            failed.store(true, Ordering::Relaxed);
            steps.again(check.alone());
        }
    }
    outcome
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

    /// The command that tries it alone.
    fn alone(&self) -> String {
        format!("cargo xtask test {}", self.name)
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

fn others(steps: &mut Steps) -> Outcome {
    site::build(steps)?;
    browser::set_up_others(steps)
}

fn fmt() -> Outcome {
    run(&mut cargo("fmt --all --check"))
        .map_err(|problem| format!("{problem}\n`cargo fmt --all` puts it right.").into())
}

fn clippy(run: Run) -> Outcome {
    run(&mut cargo("clippy --quiet --workspace --all-targets -- --deny warnings"))
}

/// The crates with code for the browser only, and the tests that run there: all modules at once, but for the renderer
/// of WebGL2, which the one of WebGPU excludes.
fn clippy_wasm(run: Run) -> Outcome {
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
fn doc(run: Run) -> Outcome {
    run(cargo("doc --quiet --workspace --no-deps").env("RUSTDOCFLAGS", "--deny warnings"))
}

fn cargo_test(run: Run) -> Outcome {
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

fn knip() -> Outcome {
    run(&mut Tool::Knip.command("--no-progress"))
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
    let programs = [("FROND_CHROMIUM", browser::chromium()?)];
    playwright("e2e", &[project], names, &programs)
}

/// A dozen scenarios in the browsers of tests/browsers/browsers.ts other than Chromium. Where the system cannot have
/// WebKit, it says so.
fn browsers(names: &[String]) -> Outcome {
    let mut projects = vec!["firefox"];
    let mut programs = vec![("FROND_FIREFOX", browser::firefox()?)];
    match browser::webkit() {
        Ok(program) => {
            projects.push("webkit");
            programs.push(("FROND_WEBKIT", program));
        }
        Err(missing) => println!("    without WebKit: {missing}"),
    }
    playwright("browsers", &projects, names, &programs)
}

/// Projects of the playwright.config.ts in a folder of tests. What failed is said once more, at the end of all.
fn playwright(folder: &str, projects: &[&str], names: &[String], programs: &[(&str, PathBuf)]) -> Outcome {
    let failed = target().join(format!("{folder}-{}-failed.txt", projects.join("-")));
    // That of another run.
    let _ = fs::remove_file(&failed);
    run(Tool::Playwright
        .command(&format!("test --config tests/{folder}/playwright.config.ts"))
        .args(projects.iter().map(|project| format!("--project={project}")))
        .args(names)
        .envs(programs.iter().map(|(name, path)| (name, path)))
        .env("FROND_PORT", free_port()?.to_string())
        .env("FROND_FAILED", &failed))
    .map_err(|problem| format!("{problem}\n{}", fs::read_to_string(&failed).unwrap_or_default()).into())
}

/// The programs of tests/hosts, or those that are named. They come from the registry.
fn hosts(names: &[String]) -> Outcome {
    run(command("node")
        .arg("tests/hosts/run.mjs")
        .args(names)
        .env("FROND_CHROMIUM", browser::chromium()?)
        .env("FROND_PACKAGE", target().join("package/frond")))
}

/// A port that nothing listens on, so that no other server is tested by mistake.
pub fn free_port() -> Outcome<u16> {
    Ok(TcpListener::bind("127.0.0.1:0")?.local_addr()?.port())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(name: &'static str, work: Work) -> Check {
        Check { group: "all", name, what: "a check", set_up: nothing, work }
    }

    /// What all of these give, and the table of their steps.
    fn tried(checks: &[Check]) -> (bool, String) {
        let mut steps = Steps::default();
        let passed = run_all(&mut steps, &checks.iter().collect::<Vec<_>>(), &[]).is_ok();
        (passed, steps.table())
    }

    #[test]
    fn all_run_in_order_or_behind() {
        let behind = Work::Behind(|run| run(&mut cargo("--version")));
        let (passed, table) = tried(&[
            check("quick", Work::All(|| Ok(()))),
            check("behind", behind),
            check("before", Work::Named(|_| Ok(()))),
        ]);
        assert!(passed && table.ends_with("3 passed, 0 failed"), "{table}");
        let (passed, table) = tried(&[check("alone", behind)]);
        assert!(passed && table.ends_with("1 passed, 0 failed"), "{table}");
    }

    #[test]
    fn what_fails_in_either_place_fails() {
        let no = || Err("no".into());
        let (passed, table) = tried(&[
            check("behind", Work::Behind(|_| Err("no".into()))),
            check("before", Work::All(|| Ok(()))),
        ]);
        assert!(
            !passed && table.contains("FAILED   behind: a check; alone: cargo xtask test behind"),
            "{table}"
        );
        let (passed, table) =
            tried(&[check("behind", Work::Behind(|_| Ok(()))), check("before", Work::All(no))]);
        assert!(
            !passed && table.contains("FAILED   before: a check; alone: cargo xtask test before"),
            "{table}"
        );
    }

    #[test]
    fn nothing_begins_after_a_failure() {
        let never = || -> Outcome { panic!("it began") };
        let (passed, table) = tried(&[
            check("quick", Work::All(|| Err("no".into()))),
            check("behind", Work::Behind(|_| panic!("it began"))),
            check("before", Work::All(never)),
        ]);
        assert!(!passed && table.matches("not run").count() == 2, "{table}");
        assert!(table.ends_with("0 passed, 1 failed"), "{table}");
    }

    #[test]
    fn what_cannot_be_set_up_behind_keeps_the_others_from_beginning() {
        let mut behind = check("behind", Work::Behind(|_| panic!("it began")));
        behind.set_up = |_| Err("no network".into());
        let (passed, table) = tried(&[behind, check("before", Work::All(|| panic!("it began")))]);
        assert!(!passed && table.contains("alone: cargo xtask test behind"), "{table}");
    }
}
