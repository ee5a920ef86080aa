//! Colours as the web writes them.

/// Red, green and blue.
pub type Rgb = [u8; 3];

/// "#rrggbb".
pub fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// The same read.
pub fn read_hex(text: &str) -> Option<Rgb> {
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6)?;
    read_digits(digits.as_bytes())
}

/// Six digits, two for each.
pub fn read_digits(digits: &[u8]) -> Option<Rgb> {
    let digit = |at: usize| char::from(*digits.get(at)?).to_digit(16);
    let byte = |at: usize| Some((16 * digit(at)? + digit(at + 1)?) as u8);
    Some([byte(0)?, byte(2)?, byte(4)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_are_a_colour() {
        assert_eq!(read_hex("#00fF80"), Some([0, 255, 128]));
        assert_eq!(read_hex(&hex([1, 20, 255])), Some([1, 20, 255]));
        for wrong in ["", "#", "00ff80", "#00ff8", "#00ff800", "#00ff8g", "#+1+1+1", "#é0000"] {
            assert_eq!(read_hex(wrong), None, "{wrong}");
        }
    }
}
