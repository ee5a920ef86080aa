//! Named steps: each says what it is when it starts, how long it took when it ends, and is counted.

use std::io::Write;
use std::time::{Duration, Instant};

use crate::command::Outcome;

/// The steps of one command, in the order in which they ran.
pub struct Steps {
    began: Instant,
    done: Vec<Step>,
    left: Vec<String>,
    again: Option<String>,
}

impl Default for Steps {
    fn default() -> Self {
        Self { began: Instant::now(), done: Vec::new(), left: Vec::new(), again: None }
    }
}

struct Step {
    name: String,
    time: Duration,
    passed: bool,
}

impl Steps {
    /// Runs `work` as a step. An error gets the step's name.
    pub fn run<T>(&mut self, name: &str, work: impl FnOnce() -> Outcome<T>) -> Outcome<T> {
        println!("==> {name}");
        let start = Instant::now();
        let result = work();
        let time = start.elapsed();
        if result.is_ok() {
            println!("    {name}: done in {}", seconds(time));
        }
        // The programs that run as steps write to the same terminal.
        std::io::stdout().flush()?;
        self.done.push(Step { name: name.to_owned(), time, passed: result.is_ok() });
        result.map_err(|problem| format!("Step `{name}` failed after {}: {problem}", seconds(time)).into())
    }

    /// As [`Steps::run`], but nothing where a step of this name has passed already.
    pub fn once(&mut self, name: &str, work: impl FnOnce() -> Outcome) -> Outcome {
        if self.done.iter().any(|step| step.name == name && step.passed) {
            Ok(())
        } else {
            self.run(name, work)
        }
    }

    /// Counts what `work` needs before it can run as `name`'s failure, where no step of its own has failed.
    pub fn prepare(&mut self, name: &str, work: impl FnOnce(&mut Self) -> Outcome) -> Outcome {
        let result = work(self);
        if result.is_err() && self.done.iter().all(|step| step.passed) {
            self.done.push(Step { name: name.to_owned(), time: Duration::ZERO, passed: false });
        }
        result
    }

    /// Says which command tries alone what has just failed.
    pub fn again(&mut self, command: String) {
        self.again = Some(command);
    }

    /// Says what was not tried, because something failed before.
    pub fn leave(&mut self, name: String) {
        self.left.push(name);
    }

    /// Takes in the steps of a thread beside this one. Of two failures it tells the other's last.
    pub fn add(&mut self, other: Self) {
        self.done.extend(other.done);
        self.left.extend(other.left);
        self.again = other.again.or(self.again.take());
    }

    /// Whether any step ran.
    pub fn any(&self) -> bool {
        !self.done.is_empty()
    }

    /// Prints every step with its time; the last line holds the counts and nothing else.
    pub fn summary(&self) {
        println!("\n{}", self.table());
    }

    /// What [`Steps::summary`] prints.
    pub fn table(&self) -> String {
        let mut lines = Vec::new();
        for step in &self.done {
            let mark = if step.passed { "ok" } else { "FAILED" };
            lines.push(format!("{mark:<9}{:>9}  {}", seconds(step.time), step.name));
        }
        lines.extend(self.left.iter().map(|name| format!("{:<20}{name}", "not run")));
        // Less than the sum where steps ran side by side.
        lines.push(format!("{:<9}{:>9}", "in all", seconds(self.began.elapsed())));
        let passed = self.done.iter().filter(|step| step.passed).count();
        if let Some(step) = self.done.iter().rfind(|step| !step.passed) {
            let again = self.again.as_ref().map_or(String::new(), |command| format!("; alone: {command}"));
            lines.push(format!("\nFAILED   {}{again}", step.name));
        }
        lines.push(format!("{passed} passed, {} failed", self.done.len() - passed));
        lines.join("\n")
    }
}

fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_names_its_step() {
        let mut steps = Steps::default();
        assert_eq!(steps.run("first", || Ok(3)).ok(), Some(3));
        let problem = steps.run("second", || Outcome::<()>::Err("no luck".into())).map_err(|e| e.to_string());
        assert!(problem.is_err_and(|text| text.contains("`second`") && text.contains("no luck")));
        assert_eq!(steps.done.iter().map(|step| step.passed).collect::<Vec<_>>(), [true, false]);
    }

    #[test]
    fn what_cannot_be_prepared_has_failed_once() {
        let mut steps = Steps::default();
        assert!(steps.prepare("check", |_| Err("no browser".into())).is_err());
        assert_eq!(steps.done.iter().filter(|step| !step.passed).count(), 1);

        let mut steps = Steps::default();
        assert!(steps.prepare("check", |steps| steps.run("install", || Err("no network".into()))).is_err());
        assert_eq!(steps.done.iter().map(|step| step.name.as_str()).collect::<Vec<_>>(), ["install"]);
    }

    #[test]
    fn the_last_lines_say_what_failed_and_how_to_try_it_alone() {
        let mut steps = Steps::default();
        assert!(steps.run("fmt: layout", || Ok(())).is_ok());
        assert!(steps.run("tsc: types", || Outcome::<()>::Err("no".into())).is_err());
        steps.again("cargo xtask test tsc".to_owned());
        steps.leave("vitest: parts".to_owned());
        let table = steps.table();
        let lines: Vec<&str> = table.lines().collect();
        let [.., not_run, _, _, failed, counts] = lines[..] else { panic!("{table}") };
        assert!(not_run.starts_with("not run") && not_run.ends_with("vitest: parts"), "{table}");
        assert_eq!(failed, "FAILED   tsc: types; alone: cargo xtask test tsc");
        assert_eq!(counts, "1 passed, 1 failed");
    }

    #[test]
    fn what_ran_beside_is_told_too() {
        let mut steps = Steps::default();
        let mut other = Steps::default();
        assert!(steps.run("webgl2: the site", || Ok(())).is_ok());
        assert!(other.run("clippy: hints", || Outcome::<()>::Err("no".into())).is_err());
        other.again("cargo xtask test clippy".to_owned());
        other.leave("doc: words".to_owned());
        steps.leave("phone: the site".to_owned());
        steps.add(other);
        let table = steps.table();
        for name in ["webgl2: the site", "clippy: hints", "doc: words", "phone: the site"] {
            assert!(table.contains(name), "{table}");
        }
        assert!(table.contains("FAILED   clippy: hints; alone: cargo xtask test clippy"), "{table}");
        assert!(table.ends_with("1 passed, 1 failed"), "{table}");
    }

    #[test]
    fn what_passed_once_is_not_done_again() {
        let mut steps = Steps::default();
        let mut count = 0;
        for _ in 0..3 {
            let done = steps.once("build", || {
                count += 1;
                if count == 1 { Err("not yet".into()) } else { Ok(()) }
            });
            assert_eq!(done.is_err(), count == 1);
        }
        assert_eq!(count, 2);
    }
}
