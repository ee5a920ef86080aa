//! Colours by how they are seen.

/// A colour in Oklab (Ottosson, "A perceptual color space for image processing", 2020): how light it is, 0 to 1, how
/// much redder than green, how much yellower than blue.
///
/// It is made of cube roots of linear light, so that all three scale together: of the same thing in `k` times as much
/// light each is the cube root of `k` times as large. A shadow moves a colour along the ray to black, and nowhere else.
pub type Oklab = [f32; 3];

/// From bytes of sRGB to linear light, 0 to 1.
pub struct Linear([f32; 256]);

impl Linear {
    pub fn new() -> Self {
        Self(std::array::from_fn(|byte| {
            let z = byte as f32 / 255.0;
            if z <= 0.040_45 { z / 12.92 } else { ((z + 0.055) / 1.055).powf(2.4) }
        }))
    }

    pub fn of(&self, rgb: &[u8]) -> [f32; 3] {
        [rgb[0], rgb[1], rgb[2]].map(|byte| self.0[usize::from(byte)])
    }
}

/// Of linear light.
pub fn oklab([r, g, b]: [f32; 3]) -> Oklab {
    let long = (0.412_221_46 * r + 0.536_332_55 * g + 0.051_445_995 * b).cbrt();
    let medium = (0.211_903_5 * r + 0.680_699_5 * g + 0.107_396_96 * b).cbrt();
    let short = (0.088_302_46 * r + 0.281_718_85 * g + 0.629_978_7 * b).cbrt();
    [
        0.210_454_26 * long + 0.793_617_8 * medium - 0.004_072_047 * short,
        1.977_998_5 * long - 2.428_592_2 * medium + 0.450_593_7 * short,
        0.025_904_037 * long + 0.782_771_77 * medium - 0.808_675_77 * short,
    ]
}

/// The square of how far two colours are apart where hue counts more than light.
pub fn apart(p: Oklab, q: Oklab) -> f32 {
    let [light, red, yellow] = [0.5 * (p[0] - q[0]), p[1] - q[1], p[2] - q[2]];
    light * light + red * red + yellow * yellow
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: Oklab, wanted: Oklab) -> bool {
        found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 2e-4)
    }

    #[test]
    fn colours_are_where_the_paper_has_them() {
        let of = |rgb: [u8; 3]| oklab(Linear::new().of(&rgb));
        assert!(near(of([255, 255, 255]), [1.0, 0.0, 0.0]));
        assert!(near(of([0, 0, 0]), [0.0, 0.0, 0.0]));
        // CSS Color 4 gives these for red, lime and blue.
        assert!(near(of([255, 0, 0]), [0.627_95, 0.224_86, 0.125_85]));
        assert!(near(of([0, 255, 0]), [0.866_44, -0.233_89, 0.179_50]));
        assert!(near(of([0, 0, 255]), [0.452_01, -0.032_46, -0.311_53]));
    }

    #[test]
    fn a_shadow_is_on_the_ray_to_black() {
        let lit = [0.5, 0.3, 0.1];
        let [l, a, b] = oklab(lit);
        let [shade_l, shade_a, shade_b] = oklab(lit.map(|z| z / 8.0));
        assert!(near([2.0 * shade_l, 2.0 * shade_a, 2.0 * shade_b], [l, a, b]));
    }
}
