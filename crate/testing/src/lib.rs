//! What the tests and benches of the other crates share: how many examples they try, which outlines, and how they take
//! time.
//!
//! Every run of the tests tries few, so that it is quick; `cargo xtask test deep` tries [many times](VARIABLE) as many.

/// The environment variable that says how many times as many examples are tried; without it, once.
pub const VARIABLE: &str = "FROND_CASES";

/// How many examples a property is tried on, where `quick` are enough for every run.
///
/// # Panics
/// Where [`VARIABLE`] is set to what is no whole number from 1 on: a search that was asked for must not be cut short.
pub fn cases(quick: u32) -> u32 {
    quick.saturating_mul(factor(std::env::var(VARIABLE).ok().as_deref()))
}

fn factor(text: Option<&str>) -> u32 {
    match text.map(str::parse) {
        None => 1,
        Some(Ok(times @ 1..)) => times,
        Some(_) => panic!("{VARIABLE} is {text:?}: it must be a whole number from 1 on"),
    }
}

/// The least time of so many runs, in seconds: what the machine does when it is left alone.
pub fn least_time(runs: usize, mut run: impl FnMut()) -> f64 {
    let time = |()| {
        let start = std::time::Instant::now();
        run();
        start.elapsed().as_secs_f64()
    };
    std::iter::repeat_n((), runs).map(time).fold(f64::INFINITY, f64::min)
}

/// Seconds of processor time of this process, where the system tells them; they do not depend on what else runs.
pub fn processor_seconds() -> f64 {
    let told = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = told.split_whitespace().next().and_then(|n| n.parse::<f64>().ok());
    nanoseconds.map_or(f64::NAN, |n| n * 1e-9)
}

/// The outlines of the folder that `FROND_LEAVES` names, by their names: files .csv, a point x, y a line. None where it
/// is not set.
///
/// # Panics
/// Where the folder or a file in it cannot be read.
pub fn leaves() -> Vec<(String, Vec<[f64; 2]>)> {
    let Some(folder) = std::env::var_os("FROND_LEAVES") else { return Vec::new() };
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.retain(|path| path.extension().is_some_and(|end| end == "csv"));
    files.sort();
    let number = |word: &str| word.trim().parse().ok();
    let read = |path: std::path::PathBuf| {
        let text = std::fs::read_to_string(&path).expect("text");
        let points = text.lines().filter_map(|line| line.split_once(','));
        let points = points.filter_map(|(x, y)| Some([number(x)?, number(y)?])).collect();
        (path.file_stem().and_then(|name| name.to_str()).unwrap_or_default().to_owned(), points)
    };
    files.into_iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::factor;

    #[test]
    fn the_variable_multiplies() {
        assert_eq!([factor(None), factor(Some("1")), factor(Some("20"))], [1, 1, 20]);
    }

    #[test]
    #[should_panic(expected = "whole number")]
    fn what_is_no_number_is_refused() {
        factor(Some("many"));
    }
}
