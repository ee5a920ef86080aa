//! Numbers as a stranger writes them.

use std::ops::Range;

/// The ends of what can be written, what is next to limits of readers, and what is no number.
const ODD: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "7",
    "16",
    "17",
    "63",
    "64",
    "65",
    "100",
    "255",
    "256",
    "1000",
    "1001",
    "65536",
    "0.5",
    "-0.5",
    ".5",
    "5.",
    "+1",
    "1e0",
    "1E5",
    "1e-5",
    "1e9",
    "1e15",
    "1e16",
    "1e21",
    "1e100",
    "1e150",
    "1e155",
    "1e-155",
    "1e300",
    "-1e300",
    "1e308",
    "1.7976931348623157e308",
    "1e309",
    "-1e309",
    "1e-300",
    "2.2250738585072014e-308",
    "5e-324",
    "1e-400",
    "3.0000000000000004",
    "0.1",
    "0.30000000000000004",
    "0.3333333333333333",
    "9007199254740993",
    "2147483647",
    "-2147483649",
    "4294967296",
    "9223372036854775808",
    "-9223372036854775809",
    "18446744073709551616",
    "1e99999999999",
    "1e-99999999999",
    "nan",
    "NaN",
    "-nan",
    "inf",
    "-inf",
    "Infinity",
    "-Infinity",
    "null",
    "NA",
    "1e",
    "1e+",
    "-",
    "+",
    ".",
    "..",
    "1.2.3",
    "1-2",
    "--1",
    "+-1",
    "0x10",
    "0b1",
    "1_000",
    "1,5",
    "1.000,5",
    "1'000",
    "1 000",
    "1/3",
    "1/0",
    "-2/3",
    "½",
    "√2",
    "2^0.5",
    "50%",
    "3px",
    "2mm",
    "90deg",
    "1e-7px",
    "1f",
    "1.5d",
    "∞",
    "−1",
    "1·10^5",
    "１",
    "٣",
    "\"1\"",
    "",
];

/// A number out of two bytes: an odd one, one of many digits, or any double.
pub fn odd(kind: u8, bits: u64) -> String {
    match kind {
        0..=159 => ODD[bits as usize % ODD.len()].to_owned(),
        160..=175 => "7".repeat(1 + bits as usize % 2000),
        176..=191 => format!("0.{}{}", "0".repeat(bits as usize % 700), bits >> 32),
        192..=199 => format!("{}e-{}", bits >> 40, bits % 400),
        200..=223 => format!("{:?}", f64::from_bits(bits)),
        224..=239 => (bits as i8).to_string(),
        _ => format!("{}", f64::from(bits as i32) / f64::from(1 << 24)),
    }
}

/// Where the numbers of a text are.
pub fn places(text: &[u8]) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        if !text[at].is_ascii_digit() {
            at += 1;
            continue;
        }
        let back =
            text[..at].iter().rev().take_while(|byte| matches!(byte, b'-' | b'+' | b'.')).take(2).count();
        let inner = |i: usize| {
            let sign = matches!(text[i], b'-' | b'+') && matches!(text[i - 1], b'e' | b'E');
            let power = matches!(text[i], b'e' | b'E')
                && text.get(i + 1).is_some_and(|b| matches!(b, b'0'..=b'9' | b'-' | b'+'));
            text[i].is_ascii_digit() || text[i] == b'.' || sign || power
        };
        let end = (at..text.len()).find(|&i| !inner(i)).unwrap_or(text.len());
        found.push(at - back..end);
        at = end;
    }
    found
}
