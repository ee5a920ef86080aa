//! From a picture to an outline: a mask that is found by itself and can be mended, and the line round a piece of it.
//!
//! Two ways lead to a mask. A picture of two tones is cut by a line in one channel (`threshold`, `otsu`). What lies on
//! a desk with its shadow, or on several kinds of ground, is cut by colours (`colour_cut`): `oklab` is where a shadow
//! is a ray, `colour_model` what colours leaf and ground have, `hint` what was said of places, `random_walk` what
//! follows, `fine_edge` the edge at full size. A frame around the picture is left out before (`frame`).

mod binary_image;
mod channel;
mod colour_cut;
mod colour_model;
mod components;
mod contour;
mod fine_edge;
mod frame;
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
pub use notice::{Notice, Surround, TraceError};
pub use stroke::Stroke;
pub use trace::Traced;

use std::sync::OnceLock;

use binary_image::Bits;
use colour_cut::ColourCut;
use components::{NONE, fill_holes, parts};
use fine_edge::fine_edge;
use morphology::{close_slits, drop_thin, remove_stalks};
use threshold::{Choice, choose};

/// The most pixels that are worked on: some 100 MiB are needed meanwhile.
pub const MAX_PIXELS: usize = 1 << 22;

/// The most pieces of a mask.
const MAX_PIECES: usize = 64;

/// Classes nearer than this to each other are taken for one colour, in grey values.
const LEAST_CONTRAST: f64 = 14.0;

/// How much likelier leaf is than it seems at the end of the threshold's slider, by its logarithm.
const MOST_MORE: f64 = 6.0;

/// What is inside a round frame has two tones where so much of the spread lies between them (of a bell 0.64), with a
/// sharp edge where pixels of tones between are at most so much of the leaf, and so many along an edge as long as the
/// side of a square of its area; and the leaf is at most so much of what is beside the frame.
const LEAST_SEPARATION: f64 = 0.7;
const MOST_BETWEEN: (f64, f64) = (0.2, 8.0);
const MOST_AT_FRAME: f64 = 0.4;

/// A picture whose spread is to this part between two tones is cut by a line between them.
const TWO_TONES: f64 = 0.975;

/// Frames in frames are looked for so often: a print with a white border on the dark of a scanner is two.
const MOST_FRAMES: usize = 3;

/// What is taken for the leaf in a frame, or for what is framed once more, is so much of what is inside.
const IN_FRAME: (f64, f64) = (0.001, 0.97);

/// Traces one picture.
///
/// Which of several channels is looked at, and where the line in it is drawn, is found once, from the picture: whether
/// the leaf is darker or lighter than its ground or cut out of it, and whether there are rules on the ground. So is
/// whether a frame surrounds it, which is then no part of any mask, unless a hint on the frame says that it is leaf.
#[derive(Clone, Debug)]
pub struct Tracer {
    width: usize,
    height: usize,
    /// The picture without what surrounds it.
    inner: Reading,
    frame: Option<Framed>,
}

/// A frame, and the picture with it.
#[derive(Clone, Debug)]
struct Framed {
    kind: Surround,
    around: Bits,
    rgba: Vec<u8>,
    whole: OnceLock<Reading>,
}

/// A picture, and what tells the leaf from its ground there.
#[derive(Clone, Debug)]
struct Reading {
    width: usize,
    height: usize,
    rgba: Vec<u8>,
    choice: Option<Choice>,
    cut: OnceLock<ColourCut>,
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
        let mut frame: Option<Framed> = None;
        let mut inner = None;
        for _ in 0..MOST_FRAMES {
            let seen = inner.as_ref().map_or(rgba, |inner: &Reading| &inner.rgba);
            let Some((next, around, kind)) = next_frame(seen, width, height, frame.as_ref()) else { break };
            inner = Some(next);
            let framed = frame.get_or_insert_with(|| Framed {
                kind,
                around: Bits::new(width, height),
                rgba: rgba.to_vec(),
                whole: OnceLock::new(),
            });
            framed.around = around;
        }
        let inner = inner.unwrap_or_else(|| Reading::new(width, height, rgba.to_vec()));
        Ok(Self { width, height, inner, frame })
    }

    /// The picture as it is looked at with these hints: without its frame, unless one that is drawn on it says that it
    /// is leaf.
    fn reading(&self, hints: &[Stroke]) -> (&Reading, Option<&Framed>) {
        match &self.frame {
            Some(frame) if hints.iter().any(|hint| frame.is_meant(hint)) => {
                (frame.whole(self.width, self.height), None)
            }
            frame => (&self.inner, frame.as_ref()),
        }
    }

    /// The channel that tells the leaf from its ground, if any does.
    #[must_use]
    pub fn channel(&self) -> Option<Channel> {
        self.inner.choice.as_ref().map(|choice| choice.channel)
    }

    /// The mask for a threshold, with its pieces.
    #[must_use]
    pub fn mask(&self, options: &MaskOptions) -> Mask {
        let offset = if options.threshold.is_nan() { 0.0 } else { options.threshold.clamp(-1.0, 1.0) };
        let (seen, frame) = self.reading(&options.hints);
        // A hint on the frame says that it is looked at, and no more.
        let on_frame = |hint: &&Stroke| self.frame.as_ref().is_some_and(|frame| frame.is_meant(hint));
        let hints: Vec<Stroke> = options.hints.iter().filter(|hint| !on_frame(hint)).cloned().collect();
        let (mut bits, level, cover) = seen.leaf(offset, options, &hints);
        if let Some(frame) = frame {
            bits.on.iter_mut().zip(&frame.around.on).for_each(|(on, around)| *on &= !around);
        }
        let mut away = stroke::paint(&mut bits, &options.strokes);
        for hint in &options.hints {
            hint.pixels(self.width, self.height, |i| away[i] |= !hint.keep);
        }
        let most = parts(&bits, true, true).largest(1, 1).all.first().map_or(0, |part| part.area / 20);
        let filled = fill_holes(&mut bits, most, |i| away[i]);
        let pieces = parts(&bits, true, true).largest(2, MAX_PIECES);
        let labels = pieces.labels();
        let mut all = pieces.all;
        let mut notices = seen.notices(&all);
        if let Some(frame) = frame {
            frame.mark_cut(&labels, &mut all);
            notices.push(Notice::Surrounded(frame.kind));
        }
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
            framed: frame.is_some(),
        }
    }
}

/// The picture without its next frame, all that is left out of it by then, and what it is; None where there is none, or
/// no leaf inside.
fn next_frame(
    rgba: &[u8],
    width: usize,
    height: usize,
    before: Option<&Framed>,
) -> Option<(Reading, Bits, Surround)> {
    // What is cut out of its ground is the shape, unless it is a card with a leaf on it.
    let frames = frame::likely(rgba, width, height, !threshold::is_cut_out(rgba));
    frames.into_iter().find_map(|found| {
        let mut around = found.around;
        if let Some(before) = before {
            around.on.iter_mut().zip(&before.around.on).for_each(|(on, before)| *on |= before);
        }
        let reading = Reading::new(width, height, frame::without(rgba, &around));
        reading.shows_leaf(&around, found.is_round).then_some((reading, around, found.kind))
    })
}

impl Framed {
    fn whole(&self, width: usize, height: usize) -> &Reading {
        self.whole.get_or_init(|| Reading::new(width, height, self.rgba.clone()))
    }

    /// Whether a hint says that the frame is leaf: it begins there, or most of it is drawn there. Corners may be
    /// smaller than the brush.
    fn is_meant(&self, hint: &Stroke) -> bool {
        let around = |i: usize| self.around.on[i];
        let (width, height) = (self.around.width, self.around.height);
        let (mut on, mut all, mut begins) = (0_usize, 0_usize, false);
        if hint.keep {
            hint.pixels(width, height, |i| (on, all) = (on + usize::from(around(i)), all + 1));
            let tip = Stroke {
                points: hint.points.first().copied().into_iter().collect(),
                radius: 0.75,
                keep: true,
            };
            tip.pixels(width, height, |i| begins |= around(i));
        }
        begins || 2 * on > all
    }

    /// A piece that the frame cuts is cut, as by the border of the picture.
    fn mark_cut(&self, labels: &[u32], all: &mut [Component]) {
        let width = self.around.width;
        for (i, _) in self.around.on.iter().enumerate().filter(|(_, on)| **on) {
            let (x, y) = (i % width, i / width);
            let near = [
                (x > 0).then(|| i - 1),
                (x + 1 < width).then_some(i + 1),
                (y > 0).then(|| i - width),
                (y + 1 < self.around.height).then_some(i + width),
            ];
            for label in near.into_iter().flatten().map(|near| labels[near]).filter(|&label| label != NONE) {
                all[label as usize].touches_border = true;
            }
        }
    }
}

impl Reading {
    fn new(width: usize, height: usize, rgba: Vec<u8>) -> Self {
        let choice = choose(&rgba, width, height);
        Self { width, height, rgba, choice, cut: OnceLock::new() }
    }

    /// Whether there is little light in all of it.
    fn is_dark(&self) -> bool {
        let pixels = self.rgba.chunks_exact(4);
        let light: u64 = pixels.map(|p| p[..3].iter().map(|&v| u64::from(v)).sum::<u64>()).sum();
        light < 3 * 40 * (self.width * self.height) as u64
    }

    /// Whether anything stands out.
    fn stands_out(&self) -> Option<&Choice> {
        self.choice.as_ref().filter(|choice| choice.contrast >= LEAST_CONTRAST)
    }

    /// Whether there is a leaf inside a frame: something stands out there. Inside what is round, and may be a shape
    /// of its own, it must be more than a shade, and seldom reach the frame.
    #[inline(never)]
    fn shows_leaf(&self, around: &Bits, is_round: bool) -> bool {
        let Some(choice) = self.line() else { return false };
        let on = Bits::above(&choice.likeness, self.width, self.height, choice.level.level).on;
        let share = |of: &dyn Fn(usize) -> bool| {
            let all = (0..on.len()).filter(|&i| of(i));
            let (leaf, count) =
                all.fold((0_usize, 0_usize), |(leaf, count), i| (leaf + usize::from(on[i]), count + 1));
            leaf as f64 / count.max(1) as f64
        };
        let inside = share(&|i| !around.on[i]);
        let rim = || {
            let near = around.grown(2.0);
            share(&|i| near.on[i] && !around.on[i])
        };
        let is_sharp = || {
            let (dark, quarter) = (choice.level.dark, 0.25 * choice.contrast);
            let between = |i: &usize| {
                let above = f64::from(choice.likeness[*i]) - dark;
                !around.on[*i] && above > quarter && above < 3.0 * quarter
            };
            let area = on.iter().zip(&around.on).filter(|&(&on, &around)| on && !around).count() as f64;
            let between = (0..on.len()).filter(between).count() as f64;
            between <= MOST_BETWEEN.0 * area + MOST_BETWEEN.1 * area.sqrt()
        };
        let may_be_leaf = inside > IN_FRAME.0 && inside < IN_FRAME.1;
        let is_two_toned = || choice.level.separation > LEAST_SEPARATION && is_sharp();
        may_be_leaf && (!is_round || (is_two_toned() && rim() < MOST_AT_FRAME))
    }

    /// What is found, how much like the leaf a pixel must be, and how much of each pixel is leaf where colours told.
    fn leaf(&self, offset: f64, options: &MaskOptions, hints: &[Stroke]) -> (Bits, f64, Option<Vec<u8>>) {
        let hinted = !hints.is_empty();
        let by_colours = (!options.invert && (hinted || self.needs_colours()))
            .then(|| self.cut_by_colours(offset, options, hints))
            .filter(|(bits, _)| hinted || bits.on.contains(&true));
        match (by_colours, &self.choice) {
            (Some((bits, cover)), _) => (bits, 127.5, Some(cover)),
            // Where nothing stands out, it is only looked for when that is asked for.
            (None, Some(choice)) if offset != 0.0 || options.invert || self.stands_out().is_some() => {
                let (bits, level) = self.find(choice, offset, options);
                (bits, level, None)
            }
            _ => (Bits::new(self.width, self.height), 127.5, None),
        }
    }

    /// What is found by colours and hints, without specks, and how much of each pixel is leaf.
    fn cut_by_colours(&self, offset: f64, options: &MaskOptions, hints: &[Stroke]) -> (Bits, Vec<u8>) {
        let cut = self.colours();
        let inside = cut.inside(hints, MOST_MORE * offset);
        let cover = fine_edge(&cut.picture, &inside, self.width, self.height, &self.rgba);
        let mut bits = Bits::above(&cover, self.width, self.height, 127.5);
        let size =
            (parts(&bits, true, true).all.iter().map(|part| part.area).max().unwrap_or(0) as f64).sqrt();
        if options.remove_stalks {
            remove_stalks(&mut bits, size);
        }
        let mut bits = without_specks(&bits, size);
        // What was said to be leaf is no speck.
        for hint in hints.iter().filter(|hint| hint.keep) {
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
    #[inline(never)]
    fn find(&self, choice: &Choice, offset: f64, options: &MaskOptions) -> (Bits, f64) {
        let (low, high) = choice.range;
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
            _ => notices.push(if self.is_dark() { Notice::AllBlack } else { Notice::Blank }),
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
