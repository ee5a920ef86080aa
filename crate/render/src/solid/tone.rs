//! Between light as it adds up and colours as they are written: a CPU twin of part of `shader/solid/shade.wgsl`.

use std::sync::LazyLock;

use glam::Vec3;

/// Written colours are powers of light: the exponent.
pub(super) const GAMMA: f32 = 2.2;
/// Above this tone the curve of film bends, and comes to white for endless light only.
pub(super) const FILM_KNEE: f32 = 0.55;
/// Entries of a table: neighbours differ by less than a tenth of what a byte can tell.
const ENTRIES: usize = 4096;

/// Powers of all numbers from 0 to 1.
struct Tables {
    /// Of the square root of light, the written tone.
    written: Vec<f32>,
    /// Of the written tone, the light.
    light: Vec<f32>,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let table = |exponent: f32| (0..=ENTRIES).map(|k| (k as f32 / ENTRIES as f32).powf(exponent)).collect();
    Tables { written: table(2.0 / GAMMA), light: table(GAMMA) }
});

fn entry(table: &[f32], at: f32) -> f32 {
    // A cast of what is no number gives 0.
    table[((at * ENTRIES as f32 + 0.5) as usize).min(ENTRIES)]
}

/// Light, as it is written.
pub(super) fn written(light: Vec3) -> Vec3 {
    let tables = &*TABLES;
    Vec3::from_array(light.to_array().map(|c| entry(&tables.written, c.max(0.0).sqrt())))
}

/// What is written, as light.
pub(super) fn light_of(written: Vec3) -> Vec3 {
    let tables = &*TABLES;
    Vec3::from_array(written.to_array().map(|c| entry(&tables.light, c)))
}

/// Light as film takes it: what is bright comes close to white and keeps its hue, and what is dark stays.
pub(super) fn film(light: Vec3) -> Vec3 {
    let most = light.max_element();
    let over = most - FILM_KNEE;
    if over <= 0.0 {
        return light;
    }
    let room = 1.0 - FILM_KNEE;
    let tone = FILM_KNEE + room * over / (over + room);
    // The brighter it is the paler it is.
    let pale = over / (over + 6.0);
    (light * (tone / most)).lerp(Vec3::splat(tone), pale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_back() {
        for k in 0..=255 {
            let tone = k as f32 / 255.0;
            let back = written(light_of(Vec3::splat(tone)));
            assert!((back.x - tone).abs() < 0.3 / 255.0, "{tone}: {back}");
        }
        assert_eq!(written(Vec3::new(f32::NAN, -1.0, 1e30)), Vec3::new(0.0, 0.0, 1.0));
        // Half of white light is written as 186 of 255.
        assert!((written(Vec3::splat(0.5)).x * 255.0 - 186.1).abs() < 0.3);
    }

    #[test]
    fn film_never_cuts_off_and_never_turns_back() {
        let mut before = Vec3::ZERO;
        for k in 1..400 {
            let now = film(Vec3::new(1.0, 0.6, 0.3) * (k as f32 * 0.05));
            assert!(now.cmpgt(before).all() && now.max_element() < 1.0, "{k}: {now}");
            assert!(now.x > now.y && now.y > now.z, "{k}: {now}");
            before = now;
        }
        let dark = Vec3::new(0.5, 0.3, 0.1);
        assert_eq!(film(dark), dark);
    }
}
