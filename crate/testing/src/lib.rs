//! What the tests and benches of the other crates share: how many examples they try, and how they take time.
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
