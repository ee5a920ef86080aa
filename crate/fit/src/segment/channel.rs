//! What of a pixel's colour tells the leaf from what lies around it.

/// One number a pixel, 0 to 255.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// How solid it is.
    Alpha,
    /// How light it is.
    Light,
    /// How much red is in it: leaves have little, and red rules as much as white paper.
    Red,
    /// How much green.
    Green,
    /// How much blue.
    Blue,
    /// How far its colours lie apart: 0 for grey.
    Saturation,
    /// How much more green than other colours.
    Greenness,
    /// How far it is from the colour around the picture's border, shade counting less than hue.
    Colour,
}

impl Channel {
    /// All but [`Alpha`](Self::Alpha), the plainest first.
    pub const OF_COLOUR: [Self; 7] =
        [Self::Light, Self::Red, Self::Blue, Self::Green, Self::Saturation, Self::Greenness, Self::Colour];

    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::Alpha => "alpha",
            Self::Light => "light",
            Self::Red => "red",
            Self::Green => "green",
            Self::Blue => "blue",
            Self::Saturation => "saturation",
            Self::Greenness => "greenness",
            Self::Colour => "colour",
        }
    }

    /// Its value in each pixel. `around` is the colour that [`Colour`](Self::Colour) is measured from.
    pub(super) fn values(self, rgba: &[u8], around: [u8; 3]) -> Vec<u8> {
        let paper = Opponent::of(around);
        let value = |pixel: &[u8]| {
            let [r, g, b, a] = [pixel[0], pixel[1], pixel[2], pixel[3]];
            let [red, green, blue] = [r, g, b].map(i32::from);
            match self {
                Self::Alpha => a,
                Self::Light => ((77 * red + 150 * green + 29 * blue + 128) >> 8) as u8,
                Self::Red => r,
                Self::Green => g,
                Self::Blue => b,
                Self::Saturation => r.max(g).max(b) - r.min(g).min(b),
                Self::Greenness => (128 + green - (red + blue) / 2).clamp(0, 255) as u8,
                Self::Colour => Opponent::of([r, g, b]).distance(paper),
            }
        };
        rgba.chunks_exact(4).map(value).collect()
    }
}

/// A colour as its light and two differences of colours.
#[derive(Clone, Copy)]
struct Opponent {
    light: f32,
    yellow: f32,
    red: f32,
}

impl Opponent {
    fn of(rgb: [u8; 3]) -> Self {
        let [r, g, b] = rgb.map(f32::from);
        let light = 0.299 * r + 0.587 * g + 0.114 * b;
        Self { light, yellow: 0.564 * (b - light), red: 0.713 * (r - light) }
    }

    fn distance(self, other: Self) -> u8 {
        let shade = 0.5 * (self.light - other.light);
        let (yellow, red) = (self.yellow - other.yellow, self.red - other.red);
        let hue_squared = yellow * yellow + red * red;
        // 255 at most: what is farther is far enough.
        ((shade * shade + 1.6 * 1.6 * hue_squared).sqrt() + 0.5) as u8
    }
}

/// The middle colour along the border of a picture, by channels.
pub(super) fn border_colour(rgba: &[u8], width: usize, height: usize) -> [u8; 3] {
    let mut counts = [[0_u64; 256]; 3];
    for i in border(width, height) {
        for (counts, &value) in counts.iter_mut().zip(&rgba[4 * i..4 * i + 3]) {
            counts[usize::from(value)] += 1;
        }
    }
    counts.map(|counts| super::otsu::quantile(&counts, 0.5))
}

/// The indices of the pixels along the border: a 50th of the shorter side, one pixel at least.
pub(super) fn border(width: usize, height: usize) -> impl Iterator<Item = usize> {
    let band = (width.min(height) / 50).max(1);
    (0..height).flat_map(move |y| {
        let whole = y < band || y + band >= height;
        let left = 0..if whole { width } else { band.min(width) };
        let right = if whole { width } else { width.saturating_sub(band).max(band) }..width;
        left.chain(right).map(move |x| y * width + x)
    })
}

/// Each value averaged with its eight neighbours, the near ones more.
pub(super) fn blur(values: &[u8], width: usize) -> Vec<u8> {
    let height = values.len() / width.max(1);
    let mut rows = vec![0_u16; values.len()];
    for y in 0..height {
        let row = &values[y * width..(y + 1) * width];
        for x in 0..width {
            let [left, right] = [row[x.saturating_sub(1)], row[(x + 1).min(width - 1)]].map(u16::from);
            rows[y * width + x] = left + 2 * u16::from(row[x]) + right;
        }
    }
    let mut out = Vec::with_capacity(values.len());
    for y in 0..height {
        let (above, below) = (y.saturating_sub(1) * width, (y + 1).min(height - 1) * width);
        for x in 0..width {
            let sum = rows[above + x] + 2 * rows[y * width + x] + rows[below + x];
            out.push(((sum + 8) >> 4) as u8);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_is_counted_once() {
        for (width, height) in [(1, 1), (1, 9), (5, 1), (2, 2), (3, 3), (120, 110)] {
            let mut all: Vec<_> = border(width, height).collect();
            let count = all.len();
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), count, "{width} x {height}");
            assert!(all.iter().all(|&i| i < width * height));
        }
        assert_eq!(border(120, 110).count(), 120 * 110 - 116 * 106);
    }

    #[test]
    fn channels_tell_colours() {
        let rgba = [40, 120, 30, 255, 250, 240, 235, 255, 230, 120, 110, 9];
        let of = |channel: Channel| channel.values(&rgba, [250, 240, 235]);
        assert_eq!(of(Channel::Alpha), [255, 255, 9]);
        assert_eq!(of(Channel::Red), [40, 250, 230]);
        assert_eq!(of(Channel::Saturation), [90, 15, 120]);
        assert_eq!(of(Channel::Greenness), [213, 126, 78]);
        let colour = of(Channel::Colour);
        assert!(colour[1] == 0 && colour[0] > 60 && colour[2] > 60, "{colour:?}");
    }

    #[test]
    fn blur_keeps_what_is_even_and_spreads_a_point() {
        assert_eq!(blur(&[7; 12], 4), [7; 12]);
        let mut point = vec![0; 25];
        point[12] = 160;
        assert_eq!(blur(&point, 5)[11..14], [20, 40, 20]);
        assert_eq!(blur(&[9], 1), [9]);
    }
}
