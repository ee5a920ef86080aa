//! Strokes of a brush that mend a mask.

use super::binary_image::Bits;

/// A stroke of a round brush over a mask.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Where the brush went: columns and rows in pixels, the upper left corner is (0, 0). One point is a dab.
    pub points: Vec<[f64; 2]>,
    /// Half its width in pixels. What is not finite, or below zero, paints nothing.
    pub radius: f64,
    /// Whether it puts in or takes away.
    pub keep: bool,
}

impl Stroke {
    /// The same on a picture that was made smaller so many times.
    pub fn shrunk(&self, factor: usize) -> Self {
        let factor = factor as f64;
        let points = self.points.iter().map(|p| p.map(|z| z / factor)).collect();
        Self { points, radius: self.radius / factor, keep: self.keep }
    }

    /// How far its ends and turns lie apart: the diagonal of the box around it.
    pub fn long(&self) -> f64 {
        let finite = || self.points.iter().filter(|p| p[0].abs() < 1e9 && p[1].abs() < 1e9);
        let side = |axis: usize| {
            let each = || finite().map(|p| p[axis]);
            each().fold(f64::NEG_INFINITY, f64::max) - each().fold(f64::INFINITY, f64::min)
        };
        side(0).max(0.0).hypot(side(1).max(0.0))
    }

    /// Calls for each pixel whose centre the brush passes over, perhaps more than once.
    pub fn pixels(&self, width: usize, height: usize, mut paint: impl FnMut(usize)) {
        let finite = |p: &&[f64; 2]| p[0].abs() < 1e9 && p[1].abs() < 1e9;
        let points: Vec<[f64; 2]> = self.points.iter().filter(finite).copied().collect();
        // The pixel under the tip is meant, however thin it is.
        let radius = self.radius.min((width + height) as f64).max(0.5);
        if self.radius.is_nan() || self.radius < 0.0 {
            return;
        }
        let count = points.len();
        for k in 0..count.saturating_sub(1).max(count.min(1)) {
            let (a, b) = (points[k], points[(k + 1).min(count - 1)]);
            let range = |axis: usize, most: usize| {
                let low = (a[axis].min(b[axis]) - radius).floor().clamp(0.0, most as f64);
                let high = (a[axis].max(b[axis]) + radius).ceil().clamp(0.0, most as f64);
                low as usize..high as usize
            };
            for y in range(1, height) {
                for x in range(0, width) {
                    if distance([x as f64 + 0.5, y as f64 + 0.5], a, b) <= radius {
                        paint(y * width + x);
                    }
                }
            }
        }
    }
}

fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (way, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let long = way[0] * way[0] + way[1] * way[1];
    let along = if long > 0.0 { ((from[0] * way[0] + from[1] * way[1]) / long).clamp(0.0, 1.0) } else { 0.0 };
    (from[0] - along * way[0]).hypot(from[1] - along * way[1])
}

/// Paints strokes over a mask, the later over the earlier. Returns for each pixel whether it was painted away.
pub fn paint(bits: &mut Bits, strokes: &[Stroke]) -> Vec<bool> {
    let mut away = vec![false; bits.on.len()];
    for stroke in strokes {
        stroke.pixels(bits.width, bits.height, |i| {
            bits.on[i] = stroke.keep;
            away[i] = !stroke.keep;
        });
    }
    away
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_is_as_wide_and_as_long_as_it_is_drawn() {
        let mut bits = Bits::new(60, 40);
        let stroke = |points: &[[f64; 2]], radius, keep| Stroke { points: points.to_vec(), radius, keep };
        paint(&mut bits, &[stroke(&[[10.0, 20.0], [50.0, 20.0]], 5.0, true)]);
        // A stadium: 40 x 10 and a disc.
        assert!((bits.count() as f64 - (400.0 + 78.5)).abs() < 8.0, "{}", bits.count());
        let away = paint(&mut bits, &[stroke(&[[30.0, 20.0]], 4.0, false)]);
        assert_eq!(away.iter().filter(|&&away| away).count(), 52);
        assert!(!bits.on[20 * 60 + 30] && bits.on[20 * 60 + 20]);
    }

    #[test]
    fn odd_strokes_paint_what_they_can() {
        let mut bits = Bits::new(5, 5);
        let bad = [f64::NAN, 2.0];
        for (points, radius) in [
            (vec![], 1.0),
            (vec![bad], 1.0),
            (vec![[1.0, 1.0]], f64::NAN),
            (vec![[1.0, 1.0]], -1.0),
            (vec![[-1e300, 0.0], [1e300, 0.0]], 1.0),
            (vec![[-40.0, -40.0]], 3.0),
        ] {
            paint(&mut bits, &[Stroke { points, radius, keep: true }]);
            assert_eq!(bits.count(), 0);
        }
        paint(&mut bits, &[Stroke { points: vec![[1.2, 3.9]], radius: 0.0, keep: true }]);
        assert_eq!((bits.count(), bits.on[16]), (1, true));
        paint(&mut bits, &[Stroke { points: vec![[2.0, 2.0]], radius: f64::INFINITY, keep: true }]);
        assert_eq!(bits.count(), 25);
    }
}
