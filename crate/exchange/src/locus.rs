//! Samples of a locus, for other programs to work on.

use std::fmt::Write;

use crate::number::decimal;

/// A locus: over a rectangle of parameters the state and the widest gap of each sample, from the lower left, row after
/// row.
#[derive(Clone, Copy, Debug)]
pub struct LocusSamples<'a> {
    /// The least and the largest of the first parameter, then of the second.
    pub bounds: [f64; 4],
    /// Samples across.
    pub width: usize,
    /// 0 connected, 1 touching, 2 disconnected, 3 undecided, 4 no attractor.
    pub state: &'a [u8],
    /// Over the diameter of the attractor.
    pub gap: &'a [f32],
}

impl LocusSamples<'_> {
    fn rows(&self) -> impl Iterator<Item = (f64, f64, u8, f32)> {
        let Self { bounds: [u0, u1, v0, v1], width, state, gap } = *self;
        let height = state.len() / width.max(1);
        // The last is the bound itself, to the last bit.
        let place = |from: f64, to: f64, k: usize, count: usize| {
            if k + 1 == count && count > 1 {
                to
            } else {
                from + (to - from) * k as f64 / (count.max(2) - 1) as f64
            }
        };
        let samples = state.iter().zip(gap).take(width * height).enumerate();
        samples.map(move |(k, (&state, &gap))| {
            (place(u0, u1, k % width, width), place(v0, v1, k / width, height), state, gap)
        })
    }
}

/// A line for each sample, with a heading: `u,v,state,gap`.
#[must_use]
pub fn locus_csv(samples: &LocusSamples<'_>) -> String {
    let mut text = String::from("u,v,state,gap\n");
    for (u, v, state, gap) in samples.rows() {
        // Writing to a string does not fail.
        let _ = writeln!(text, "{},{},{state},{gap}", decimal(u), decimal(v));
    }
    text
}

/// A file of NumPy (format 1.0): an array of records with the fields `u`, `v`, `state` and `gap`, row 0 at the bottom.
#[must_use]
pub fn locus_npy(samples: &LocusSamples<'_>) -> Vec<u8> {
    let width = samples.width.max(1);
    let height = samples.state.len().min(samples.gap.len()) / width;
    let mut head = format!(
        "{{'descr': [('u', '<f8'), ('v', '<f8'), ('state', '|u1'), ('gap', '<f4')], 'fortran_order': False, \
         'shape': ({height}, {width}), }}"
    );
    // With the ten bytes before it, it ends at a multiple of 64.
    let blank = 63 - (10 + head.len()) % 64;
    head.push_str(&" ".repeat(blank));
    head.push('\n');
    let mut made = b"\x93NUMPY\x01\x00".to_vec();
    made.extend((head.len() as u16).to_le_bytes());
    made.extend(head.as_bytes());
    for (u, v, state, gap) in samples.rows().take(width * height) {
        made.extend(u.to_le_bytes());
        made.extend(v.to_le_bytes());
        made.push(state);
        made.extend(gap.to_le_bytes());
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLES: LocusSamples<'_> = LocusSamples {
        bounds: [0.0, 1.0, -1.0, 2.0],
        width: 3,
        state: &[0, 1, 2, 3, 4, 0],
        gap: &[0.0, 0.5, 1.0, 0.1, f32::NAN, 0.0],
    };

    #[test]
    fn a_table_has_a_line_a_sample() {
        let text = "u,v,state,gap\n0,-1,0,0\n0.5,-1,1,0.5\n1,-1,2,1\n0,2,3,0.1\n0.5,2,4,NaN\n1,2,0,0\n";
        assert_eq!(locus_csv(&SAMPLES), text);
    }

    #[test]
    fn an_array_has_a_head_of_64_bytes_or_more_of_them() {
        let made = locus_npy(&SAMPLES);
        let length = usize::from(u16::from_le_bytes([made[8], made[9]]));
        assert_eq!(((10 + length) % 64, made[10 + length - 1]), (0, b'\n'));
        let records = &made[10 + length..];
        assert_eq!(records.len(), 6 * 21);
        assert_eq!(records[21..29], 0.5_f64.to_le_bytes());
        assert_eq!(records[21 + 16], 1);
    }
}
