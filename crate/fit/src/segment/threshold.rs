//! Which channel tells the leaf from its ground, and where the line between them is.

use frond_core::shared::sort_indices;

use super::binary_image::Bits;
use super::channel::{Channel, blur, border, border_colour};
use super::otsu::{Level, histogram, quantile, split};

/// A channel with the line drawn in it.
#[derive(Clone, Debug)]
pub struct Choice {
    pub channel: Channel,
    /// How much each pixel is like the leaf: turned round where the leaf is the darker class.
    pub likeness: Vec<u8>,
    pub level: Level,
    /// Rules on the ground are taken off by a square of so many pixels round each; 0 where there are none.
    pub rules: usize,
    /// 1 for a shape in one piece, towards 0 for speckles.
    pub whole: f64,
    /// Whether it had to be smoothed to be whole.
    pub smoothed: bool,
    /// Between the mean values of leaf and ground.
    pub contrast: f64,
    /// The values of `likeness` that all but a 200th lie between.
    pub range: (f64, f64),
}

/// What is enough to be taken for a shape.
pub const LEAST_SCORE: f64 = 0.5;

/// Rules as wide as twice this and one are found, in pixels.
const RULE_RADII: [usize; 4] = [1, 2, 3, 5];

/// The best channel of a picture; None where no channel has two values.
pub fn choose(rgba: &[u8], width: usize, height: usize) -> Option<Choice> {
    let around = border_colour(rgba, width, height);
    // What is cut out of its ground needs no more judgement.
    if is_cut_out(rgba) {
        let alpha = Channel::Alpha.values(rgba, around);
        let counts = histogram(&alpha);
        let level = split(&counts)?;
        let contrast = level.bright - level.dark;
        return Some(Choice {
            channel: Channel::Alpha,
            likeness: alpha,
            level,
            rules: 0,
            whole: 1.0,
            smoothed: false,
            contrast,
            range: range(&counts),
        });
    }
    let seen = over_white(rgba);
    let rgba = seen.as_deref().unwrap_or(rgba);
    // Sharp, if it will do; smoother where it is speckled.
    let mut best = sharpest(rgba, around, width, height);
    for blurs in [2, 8] {
        if best.as_ref().is_none_or(|(_, choice)| choice.whole >= LEAST_SCORE) {
            break;
        }
        for channel in Channel::OF_COLOUR {
            let mut values = channel.values(rgba, around);
            for _ in 0..blurs {
                values = blur(&values, width);
            }
            let most = best.as_ref().map_or(0.0, |(most, _)| *most);
            let Some(lines) = Lines::new(histogram(&values)).filter(|lines| lines.most >= most) else {
                continue;
            };
            let (score, mut choice) = judge(channel, values, &lines, width, height);
            if best.as_ref().is_none_or(|(most, _)| score > *most) {
                choice.smoothed = true;
                best = Some((score, choice));
            }
        }
    }
    best.map(|(_, choice)| choice)
}

/// The best channel as it is. What a histogram promises is known for all before one is looked at, and the most
/// promising come first: mostly the others cannot win any more then.
#[inline(never)]
fn sharpest(rgba: &[u8], around: [u8; 3], width: usize, height: usize) -> Option<(f64, Choice)> {
    let all = Channel::histograms(rgba, around);
    let mut order: Vec<usize> = (0..all.len()).collect();
    let lines = all.map(Lines::new);
    let most = |i: usize| lines[i].as_ref().map_or(-1.0, |lines| lines.most);
    sort_indices(&mut order, &|i, j| most(j).total_cmp(&most(i)));
    let mut best: Option<(usize, f64, Choice)> = None;
    for i in order {
        let Some(lines) =
            lines[i].as_ref().filter(|lines| lines.most >= best.as_ref().map_or(0.0, |best| best.1))
        else {
            break;
        };
        let channel = Channel::OF_COLOUR[i];
        let (score, choice) = judge(channel, channel.values(rgba, around), lines, width, height);
        // Of equals the plainest.
        if best.as_ref().is_none_or(|(first, most, _)| score > *most || (score == *most && i < *first)) {
            best = Some((i, score, choice));
        }
    }
    best.map(|(_, score, choice)| (score, choice))
}

/// Whether part of a picture is clear, more than a few pixels, and part of it is not.
#[inline(never)]
pub fn is_cut_out(rgba: &[u8]) -> bool {
    let all = rgba.len() / 4;
    let solid = rgba.chunks_exact(4).filter(|pixel| pixel[3] >= 128).count();
    1000 * solid > all && 1000 * (all - solid) > all
}

/// What is half transparent is seen on white; None where nothing is.
#[inline(never)]
fn over_white(rgba: &[u8]) -> Option<Vec<u8>> {
    if rgba.chunks_exact(4).all(|pixel| pixel[3] == 255) {
        return None;
    }
    let mut seen = rgba.to_vec();
    for pixel in seen.chunks_exact_mut(4) {
        let solid = u32::from(pixel[3]);
        for value in &mut pixel[..3] {
            *value = ((u32::from(*value) * solid + 255 * (255 - solid) + 127) / 255) as u8;
        }
    }
    Some(seen)
}

/// The values that all but a 200th lie between.
fn range(counts: &[u64; 256]) -> (f64, f64) {
    (f64::from(quantile(counts, 0.005)), f64::from(quantile(counts, 0.995)))
}

/// What a histogram says of a channel.
struct Lines {
    counts: [u64; 256],
    level: Level,
    contrast: f64,
    /// The best that it may be, however whole the shape is.
    most: f64,
}

impl Lines {
    /// None where there are no two values.
    fn new(counts: [u64; 256]) -> Option<Self> {
        let level = split(&counts)?;
        let contrast = level.bright - level.dark;
        let most = level.separation * contrast / (contrast + 20.0);
        Some(Self { counts, level, contrast, most })
    }
}

/// Draws the line in one channel, and says how well it parts a shape from its ground.
#[inline(never)]
fn judge(channel: Channel, mut values: Vec<u8>, lines: &Lines, width: usize, height: usize) -> (f64, Choice) {
    let Lines { mut counts, mut level, contrast, .. } = *lines;
    let share = |bits: &Bits| {
        let all = border(width, height).count().max(1);
        border(width, height).filter(|&i| bits.on[i]).count() as f64 / all as f64
    };
    let mut bits = Bits::above(&values, width, height, level.level);
    // The ground is what most of the border is of.
    let mut at_border = share(&bits);
    if at_border > 0.5 {
        values.iter_mut().for_each(|value| *value = 255 - *value);
        counts.reverse();
        level = Level {
            level: 255.0 - level.level,
            dark: 255.0 - level.bright,
            bright: 255.0 - level.dark,
            ..level
        };
        bits.on.iter_mut().for_each(|on| *on = !*on);
        at_border = 1.0 - at_border;
    }
    let mut whole = wholeness(&bits);
    let mut rules = 0;
    if whole < LEAST_SCORE {
        let all = bits.count();
        for radius in RULE_RADII {
            let opened = bits.opened_by_square(radius);
            let now = wholeness(&opened);
            // Of speckles some are left, too, but few.
            if now >= LEAST_SCORE && 15 * opened.count() > all {
                (whole, rules, at_border) = (now, radius, share(&opened));
                break;
            }
        }
    }
    let plain = 0.93_f64.powi(rules as i32);
    let score =
        level.separation * (0.1 + 0.9 * whole) * plain * (1.0 - at_border) * contrast / (contrast + 20.0);
    (
        score,
        Choice {
            channel,
            likeness: values,
            level,
            rules,
            whole,
            smoothed: false,
            contrast,
            range: range(&counts),
        },
    )
}

/// How long the edges may be for the area: a leaf with many teeth is whole, rules and speckles are not.
fn wholeness(bits: &Bits) -> f64 {
    let on = bits.count();
    let area = on.min(bits.on.len() - on) as f64;
    // In pictures of a few pixels only every edge is long.
    (20.0 * area.sqrt() / bits.edges().max(1) as f64).min(1.0)
}

impl Choice {
    /// Whether it is nothing but speckles: in pieces, or in one spread only once it is smoothed (0.64 of the spread of
    /// a bell lies between its halves).
    pub fn is_noise(&self) -> bool {
        self.whole < 0.5 * LEAST_SCORE || (self.smoothed && self.level.separation < 0.7)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn painted(width: usize, height: usize, colour: impl Fn(usize, usize) -> [u8; 4]) -> Vec<u8> {
        (0..width * height).flat_map(|i| colour(i % width, i / width)).collect()
    }

    fn disc(x: usize, y: usize) -> bool {
        (x as f64 - 50.0).hypot(y as f64 - 40.0) < 25.0
    }

    #[test]
    fn red_rules_do_not_hide_a_green_leaf() {
        let rgba = painted(100, 80, |x, y| match (disc(x, y), x % 4 == 0 || y % 4 == 0) {
            (true, _) => [70, 110, 50, 255],
            (false, true) => [235, 130, 120, 255],
            (false, false) => [250, 240, 235, 255],
        });
        let choice = choose(&rgba, 100, 80).expect("two colours");
        assert_eq!((choice.channel, choice.rules), (Channel::Red, 0));
        assert_eq!(Bits::above(&choice.likeness, 100, 80, choice.level.level).count(), 1941);
    }

    #[test]
    fn rules_as_dark_as_the_leaf_are_taken_off() {
        let rgba = painted(100, 80, |x, y| {
            let dark = disc(x, y) || x % 6 == 2 || y % 6 == 2;
            if dark { [30, 30, 30, 255] } else { [250, 250, 250, 255] }
        });
        let choice = choose(&rgba, 100, 80).expect("two colours");
        assert_eq!((choice.channel, choice.rules), (Channel::Light, 1));
    }

    #[test]
    fn light_on_dark_and_dark_on_light_and_cut_out_are_the_same() {
        for (inside, outside) in [
            ([0, 0, 0, 255], [255, 255, 255, 255]),
            ([255, 255, 255, 255], [0, 0, 0, 255]),
            ([9, 9, 9, 255], [9, 9, 9, 0]),
        ] {
            let rgba = painted(100, 80, |x, y| if disc(x, y) { inside } else { outside });
            let choice = choose(&rgba, 100, 80).expect("two colours");
            let bits = Bits::above(&choice.likeness, 100, 80, choice.level.level);
            assert!((0..8000).all(|i| bits.on[i] == disc(i % 100, i / 100)), "{inside:?}");
        }
    }

    #[test]
    fn one_colour_is_no_choice() {
        assert!(choose(&painted(9, 9, |_, _| [1, 2, 3, 255]), 9, 9).is_none());
        assert!(choose(&painted(9, 9, |_, _| [1, 2, 3, 0]), 9, 9).is_none());
    }
}
