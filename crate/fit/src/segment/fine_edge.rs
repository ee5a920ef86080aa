//! The edge of a cut that was made at working size, at the size of the picture.

use super::oklab::Linear;
use super::working_picture::WorkingPicture;

/// How far around a place leaf and ground are looked at for their colours there, in pixels of the working size.
const AROUND: usize = 4;

/// Where leaf and ground differ by so much of the light, their colours count as much as what was cut before.
const TELLING: f32 = 0.02;

/// A plane of numbers at working size, between whose pixels it is straight.
struct Plane<'a> {
    picture: &'a WorkingPicture,
    values: Vec<f32>,
}

impl Plane<'_> {
    /// Where it is read for a pixel of the picture: the four pixels around and their shares.
    fn places(picture: &WorkingPicture, x: usize, y: usize) -> [(usize, f32); 4] {
        let place = |at: usize, most: usize| {
            let z = ((at as f32 + 0.5) / picture.factor as f32 - 0.5).clamp(0.0, most as f32 - 1.0);
            let low = z as usize;
            (low, (low + 1).min(most - 1), z - low as f32)
        };
        let (left, right, along) = place(x, picture.width);
        let (top, bottom, down) = place(y, picture.height);
        let at = |x: usize, y: usize| y * picture.width + x;
        [
            (at(left, top), (1.0 - along) * (1.0 - down)),
            (at(right, top), along * (1.0 - down)),
            (at(left, bottom), (1.0 - along) * down),
            (at(right, bottom), along * down),
        ]
    }

    /// The sum of each pixel's surroundings.
    fn around(&self) -> Self {
        let (width, height) = (self.picture.width, self.picture.height);
        let mut sums = self.values.clone();
        let mut line = Vec::new();
        for row in sums.chunks_exact_mut(width) {
            line.clear();
            line.extend_from_slice(row);
            sum_along(&line, |x, sum| row[x] = sum);
        }
        for x in 0..width {
            line.clear();
            line.extend((0..height).map(|y| sums[y * width + x]));
            sum_along(&line, |y, sum| sums[y * width + x] = sum);
        }
        Self { picture: self.picture, values: sums }
    }
}

fn sum_along(line: &[f32], mut put: impl FnMut(usize, f32)) {
    for i in 0..line.len() {
        put(i, line[i.saturating_sub(AROUND)..(i + AROUND + 1).min(line.len())].iter().sum());
    }
}

/// How much of each pixel of the picture is leaf, 0 to 255, from `inside` (0 to 1) at working size. Along the edge a
/// pixel is on the line between the colours of leaf and ground around it, in linear light, as light mixes.
pub fn fine_edge(
    picture: &WorkingPicture,
    inside: &[f32],
    width: usize,
    height: usize,
    rgba: &[u8],
) -> Vec<u8> {
    let plane = |value: &dyn Fn(usize) -> f32| {
        Plane { picture, values: (0..inside.len()).map(value).collect() }.around().values
    };
    // Clearly leaf, clearly ground: edges are of both.
    let sure = |i: usize, leaf: bool| {
        let part = if leaf { inside[i] } else { 1.0 - inside[i] };
        (part - 0.6).max(0.0)
    };
    let mean = |leaf: bool| -> Vec<[f32; 4]> {
        let sums: Vec<Vec<f32>> = (0..3)
            .map(|k| plane(&|i| sure(i, leaf) * picture.light[i][k]))
            .chain([plane(&|i| sure(i, leaf))])
            .collect();
        (0..inside.len()).map(|i| [sums[0][i], sums[1][i], sums[2][i], sums[3][i]]).collect()
    };
    let (leaf, ground) = (mean(true), mean(false));
    let linear = Linear::new();
    let mut out = Vec::with_capacity(width * height);
    for y in 0..height {
        for x in 0..width {
            let places = Plane::places(picture, x, y);
            let value: f32 = places.iter().map(|&(i, part)| part * inside[i]).sum();
            if !(0.03..0.97).contains(&value) {
                out.push((255.0 * value.clamp(0.0, 1.0)).round() as u8);
                continue;
            }
            let read = |of: &[[f32; 4]]| -> Option<[f32; 3]> {
                let sum: [f32; 4] =
                    std::array::from_fn(|k| places.iter().map(|&(i, part)| part * of[i][k]).sum::<f32>());
                (sum[3] > 0.05).then(|| [sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]])
            };
            let i = 4 * (y * width + x);
            let fine = match (read(&leaf), read(&ground)) {
                (Some(leaf), Some(ground)) => mixed(linear.of(&rgba[i..i + 3]), leaf, ground, value),
                _ => value,
            };
            out.push((255.0 * fine.clamp(0.0, 1.0)).round() as u8);
        }
    }
    out
}

/// Which part of a colour is leaf; where leaf and ground are alike it is what it was taken for.
fn mixed(colour: [f32; 3], leaf: [f32; 3], ground: [f32; 3], otherwise: f32) -> f32 {
    let (mut along, mut long) = (0.0, 0.0);
    for k in 0..3 {
        let way = leaf[k] - ground[k];
        along += (colour[k] - ground[k]) * way;
        long += way * way;
    }
    let least = TELLING * TELLING;
    ((along + least * otherwise) / (long + least)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_covered_pixels_are_half() {
        // A straight edge at column 500.25 of a picture that is cut at a fifth of its size.
        let (width, height) = (1000, 900);
        let encode = |z: f64| (255.0 * (1.055 * z.powf(1.0 / 2.4) - 0.055)).round() as u8;
        let rgba: Vec<u8> = (0..width * height)
            .flat_map(|i| {
                let cover = (500.25 - (i % width) as f64).clamp(0.0, 1.0);
                [0.1 * cover + 0.6 * (1.0 - cover), 0.3 * cover + 0.5 * (1.0 - cover), 0.4]
                    .map(encode)
                    .into_iter()
                    .chain([255])
            })
            .collect();
        let picture = WorkingPicture::new(width, height, &rgba);
        assert!(picture.factor > 2);
        let inside: Vec<f32> = (0..picture.colours.len())
            .map(|i| if i % picture.width * picture.factor < 500 { 0.98 } else { 0.02 })
            .collect();
        let fine = fine_edge(&picture, &inside, width, height, &rgba);
        let row = &fine[450 * width..][..width];
        assert!(row[480] > 240 && row[499] > 240 && row[501] < 15 && row[520] < 15, "{:?}", &row[496..504]);
        assert!((f64::from(row[500]) / 255.0 - 0.25).abs() < 0.05, "{}", row[500]);
    }
}
