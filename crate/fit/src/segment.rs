//! From a picture to an outline: a mask that is found by itself and can be mended, and the line round a piece of it.
//!
//! Two ways lead to a mask. A picture of two tones is cut by a line in one channel (`threshold`, `otsu`). What lies on
//! a desk with its shadow, or on several kinds of ground, is cut by colours (`colour_cut`): `oklab` is where a shadow
//! is a ray, `colour_model` what colours leaf and ground have, `hint` what was said of places, `random_walk` what
//! follows, `fine_edge` the edge at full size.

mod binary_image;
mod channel;
mod colour_cut;
mod colour_model;
mod components;
mod contour;
mod fine_edge;
mod hint;
mod mask;
mod morphology;
mod notice;
mod oklab;
mod otsu;
mod palette;
mod random_walk;
mod stroke;
mod threshold;
mod trace;
mod working_picture;

pub use channel::Channel;
pub use components::Component;
pub use mask::{Mask, MaskOptions};
pub use notice::{Notice, TraceError};
pub use stroke::Stroke;
pub use trace::Traced;

use std::sync::OnceLock;

use binary_image::Bits;
use colour_cut::ColourCut;
use components::{Parts, fill_holes, parts};
use fine_edge::fine_edge;
use morphology::{close_slits, drop_thin, remove_stalks};
use otsu::{histogram, quantile};
use threshold::{Choice, choose};

/// The most pixels that are worked on: some 100 MiB are needed meanwhile.
pub const MAX_PIXELS: usize = 1 << 22;

/// The most pieces of a mask.
const MAX_PIECES: usize = 64;

/// Classes nearer than this to each other are taken for one colour, in grey values.
const LEAST_CONTRAST: f64 = 14.0;

/// How much likelier leaf is than it seems at the end of the threshold's slider, by its logarithm.
const MOST_MORE: f64 = 6.0;

/// A picture whose spread is to this part between two tones is cut by a line between them.
const TWO_TONES: f64 = 0.975;

/// Traces one picture.
///
/// Which of several channels is looked at, and where the line in it is drawn, is found once, from the picture: whether
/// the leaf is darker or lighter than its ground or cut out of it, and whether there are rules on the ground.
#[derive(Clone, Debug)]
pub struct Tracer {
    width: usize,
    height: usize,
    rgba: Vec<u8>,
    choice: Option<Choice>,
    cut: OnceLock<ColourCut>,
    dark: bool,
    /// The values that all but a 200th lie between.
    range: (f64, f64),
}

impl Tracer {
    /// Looks at a picture: red, green, blue and alpha (not multiplied) of each pixel, row after row from the top.
    ///
    /// # Errors
    /// Where a side is 0, there are more than [`MAX_PIXELS`] pixels, or not four bytes for each.
    pub fn new(width: usize, height: usize, rgba: &[u8]) -> Result<Self, TraceError> {
        if width == 0 || height == 0 {
            return Err(TraceError::NoPixels);
        }
        if width.checked_mul(height).is_none_or(|pixels| pixels > MAX_PIXELS) {
            return Err(TraceError::TooLarge { width, height });
        }
        if rgba.len() != 4 * width * height {
            return Err(TraceError::WrongLength { width, height, bytes: rgba.len() });
        }
        let choice = choose(rgba, width, height);
        let light =
            rgba.chunks_exact(4).map(|p| p[..3].iter().map(|&v| u64::from(v)).sum::<u64>()).sum::<u64>();
        let range = choice.as_ref().map_or((0.0, 255.0), |choice| {
            let counts = histogram(&choice.likeness);
            (f64::from(quantile(&counts, 0.005)), f64::from(quantile(&counts, 0.995)))
        });
        Ok(Self {
            width,
            height,
            rgba: rgba.to_vec(),
            choice,
            cut: OnceLock::new(),
            dark: light < 3 * 40 * (width * height) as u64,
            range,
        })
    }

    /// The channel that tells the leaf from its ground, if any does.
    #[must_use]
    pub fn channel(&self) -> Option<Channel> {
        self.choice.as_ref().map(|choice| choice.channel)
    }

    /// Whether anything stands out.
    fn stands_out(&self) -> Option<&Choice> {
        self.choice.as_ref().filter(|choice| choice.contrast >= LEAST_CONTRAST)
    }

    /// The mask for a threshold, with its pieces.
    #[must_use]
    pub fn mask(&self, options: &MaskOptions) -> Mask {
        let offset = if options.threshold.is_nan() { 0.0 } else { options.threshold.clamp(-1.0, 1.0) };
        let hinted = !options.hints.is_empty();
        let by_colours = (!options.invert && (hinted || self.needs_colours()))
            .then(|| self.cut_by_colours(offset, options))
            .filter(|(bits, _)| hinted || bits.on.contains(&true));
        let (mut bits, level, cover) = match (by_colours, &self.choice) {
            (Some((bits, cover)), _) => (bits, 127.5, Some(cover)),
            // Where nothing stands out, it is only looked for when that is asked for.
            (None, Some(choice)) if offset != 0.0 || options.invert || self.stands_out().is_some() => {
                let (bits, level) = self.find(choice, offset, options);
                (bits, level, None)
            }
            _ => (Bits::new(self.width, self.height), 127.5, None),
        };
        let mut away = stroke::paint(&mut bits, &options.strokes);
        for hint in &options.hints {
            hint.pixels(self.width, self.height, |i| away[i] |= !hint.keep);
        }
        let most = parts(&bits, true, true).largest(1, 1).all.first().map_or(0, |part| part.area / 20);
        let filled = fill_holes(&mut bits, most, |i| away[i]);
        let Parts { labels, all } = parts(&bits, true, true).largest(2, MAX_PIECES);
        let notices = self.notices(&all);
        Mask {
            width: self.width,
            height: self.height,
            labels,
            components: all,
            filled,
            notices,
            level,
            inverted: options.invert,
            cover,
        }
    }

    /// What is found by colours and hints, without specks, and how much of each pixel is leaf.
    fn cut_by_colours(&self, offset: f64, options: &MaskOptions) -> (Bits, Vec<u8>) {
        let cut = self.colours();
        let inside = cut.inside(&options.hints, MOST_MORE * offset);
        let cover = fine_edge(&cut.picture, &inside, self.width, self.height, &self.rgba);
        let mut bits = Bits::above(&cover, self.width, self.height, 127.5);
        let size =
            (parts(&bits, true, true).all.iter().map(|part| part.area).max().unwrap_or(0) as f64).sqrt();
        if options.remove_stalks {
            remove_stalks(&mut bits, size);
        }
        let mut bits = without_specks(&bits, size);
        // What was said to be leaf is no speck.
        for hint in options.hints.iter().filter(|hint| hint.keep) {
            hint.pixels(self.width, self.height, |i| bits.on[i] |= cover[i] > 127);
        }
        (bits, cover)
    }

    /// The same picture by its colours.
    fn colours(&self) -> &ColourCut {
        self.cut.get_or_init(|| {
            let mut cut = ColourCut::new(self.width, self.height, &self.rgba);
            // As on grass: what is not of another colour may still be lighter or plainer.
            if let Some(choice) = self.line().filter(|_| !cut.finds_any()) {
                cut.start_from(&self.find(choice, 0.0, &MaskOptions::default()).0);
            }
            cut
        })
    }

    /// The line in a channel of colour, where it parts a shape from its ground.
    fn line(&self) -> Option<&Choice> {
        self.stands_out().filter(|choice| choice.channel != Channel::Alpha && !choice.is_noise())
    }

    /// Whether a line in one channel leaves too much between two tones: there is shade on the ground, or several kinds
    /// of it.
    fn needs_colours(&self) -> bool {
        self.line().is_some_and(|choice| choice.level.separation < TWO_TONES) && self.colours().has_colour()
    }

    /// What is found without a brush.
    fn find(&self, choice: &Choice, offset: f64, options: &MaskOptions) -> (Bits, f64) {
        let (low, high) = self.range;
        let middle = choice.level.level;
        let level = if offset > 0.0 {
            middle - offset * (middle - low + 1.0)
        } else {
            middle - offset * (high - middle + 1.0)
        };
        let mut bits = Bits::above(&choice.likeness, self.width, self.height, level);
        if options.invert {
            bits.on.iter_mut().for_each(|on| *on = !*on);
        }
        if choice.rules > 0 && !options.invert {
            // Without rules, then again what lies close to what is left: teeth are thin, too.
            let wide = bits.opened_by_square(choice.rules).grown(choice.rules as f64 + 1.5);
            bits.on.iter_mut().zip(&wide.on).for_each(|(on, &wide)| *on &= wide);
        }
        let found = parts(&bits, true, true);
        let area = found.all.iter().map(|part| part.area).max().unwrap_or(0);
        if area == 0 {
            return (bits, level);
        }
        let size = (area as f64).sqrt();
        let gap = (0.02 * size).clamp(1.5, 40.0);
        // From here on only what surrounds pieces of some size is looked at.
        let [left, top, right, bottom] = self.around(&found.all, area / 200, gap as usize + 3);
        let mut bits = bits.cut([left, top, right, bottom]);
        if choice.channel != Channel::Alpha && !options.invert {
            let weak = level - 0.35 * (level - choice.level.dark).max(0.0);
            let rows = (top..bottom).map(|y| &choice.likeness[y * self.width + left..y * self.width + right]);
            close_slits(&mut bits, &rows.flatten().copied().collect::<Vec<_>>(), weak, gap);
        }
        if options.remove_stalks {
            remove_stalks(&mut bits, size);
        }
        let bits = without_specks(&bits, size);
        (bits.placed(self.width, self.height, left, top), level)
    }

    /// A box round all pieces of at least an area, and so many pixels more.
    fn around(&self, all: &[Component], least: usize, more: usize) -> [usize; 4] {
        let join = |[a, b, c, d]: [usize; 4], part: &Component| {
            let [left, top, right, bottom] = part.bounds;
            [a.min(left), b.min(top), c.max(right), d.max(bottom)]
        };
        let pieces = all.iter().filter(|part| part.area >= least);
        let [left, top, right, bottom] = pieces.fold([self.width, self.height, 0, 0], join);
        let (right, bottom) = ((right + more).min(self.width), (bottom + more).min(self.height));
        [left.saturating_sub(more), top.saturating_sub(more), right, bottom]
    }

    fn notices(&self, all: &[Component]) -> Vec<Notice> {
        let mut notices = Vec::new();
        match &self.choice {
            Some(choice) if choice.contrast >= LEAST_CONTRAST => {
                let speck = all.first().is_some_and(|first| 2000 * first.area < self.width * self.height);
                if choice.is_noise() || (all.len() > 1 && speck) {
                    notices.push(Notice::Noise);
                }
            }
            _ => notices.push(if self.dark { Notice::AllBlack } else { Notice::Blank }),
        }
        if let Some(first) = all.first() {
            let like = all.iter().filter(|part| 5 * part.area >= first.area).count();
            if like > 1 {
                notices.push(Notice::Several(like));
            }
        } else if notices.is_empty() {
            notices.push(Notice::Blank);
        }
        notices
    }
}

/// Without what is small by itself and beside the largest, and without rules and hairs.
fn without_specks(bits: &Bits, size: f64) -> Bits {
    let pieces = parts(bits, true, true);
    let largest = pieces.all.iter().map(|part| part.area).max().unwrap_or(0);
    let mut bits = pieces.largest((largest / 50).max(12), MAX_PIECES).bits(bits.width, bits.height);
    drop_thin(&mut bits, ((0.008 * size) as usize).max(1));
    bits
}
