//! Numbers and names in a word of space.

pub(super) fn floats(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|part| part.parse::<f64>().ok().filter(|x| x.is_finite())).collect()
}

pub(super) fn exactly<const N: usize>(text: &str) -> Option<[f64; N]> {
    floats(text)?.try_into().ok()
}

pub(super) fn choice<T: Copy>(choices: &[(&str, T)], text: &str) -> Option<T> {
    choices.iter().find_map(|(name, value)| (*name == text).then_some(*value))
}
