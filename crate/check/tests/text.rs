//! Certificates as JSON: what is replayed is what the text says, to the last digit.
#![cfg(feature = "text")]

use frond_check::{Certificate, Pair, Proof, check};

/// Two maps in a square.
fn plain() -> Certificate {
    Certificate {
        maps: vec![[0.25, 0.0, 0.0, 0.25, 0.0, 0.0], [0.25, 0.0, 0.0, 0.25, 0.75, 0.0]],
        polygon: vec![[-0.5, -0.5], [1.5, -0.5], [1.5, 0.5], [-0.5, 0.5]],
        letters: 1,
        side: vec![0, 1],
        pairs: vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }],
        exact: None,
    }
}

/// Whole numbers that look like chance (splitmix64).
fn random(seed: u64) -> impl Iterator<Item = u64> {
    (1..).map(move |k: u64| {
        let mut z = seed.wrapping_add(k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}

/// Finite doubles of every kind: of any size, near 1, and below the normal ones.
fn doubles(seed: u64) -> impl Iterator<Item = f64> {
    let of_a_kind = |(k, bits): (usize, u64)| match k % 3 {
        0 => f64::from_bits(bits),
        1 => (bits >> 11) as f64 * 2.0_f64.powi(-53 + (bits % 8) as i32),
        _ => f64::from_bits(bits & 0x800f_ffff_ffff_ffff),
    };
    random(seed).enumerate().map(of_a_kind).filter(|x| x.is_finite())
}

/// A certificate with these numbers as its first map.
fn read(numbers: [&str; 6]) -> [f64; 6] {
    let text = plain().to_json().unwrap();
    let first = "[0.25,0.0,0.0,0.25,0.0,0.0]";
    assert!(text.contains(first), "{text}");
    let text = text.replacen(first, &format!("[{}]", numbers.join(",")), 1);
    Certificate::from_json(&text).unwrap().maps[0]
}

#[test]
fn a_certificate_comes_back_as_it_was() {
    let mut numbers = doubles(1);
    let mut six = || -> [f64; 6] { std::array::from_fn(|_| numbers.next().unwrap()) };
    let mut certificate = plain();
    certificate.maps = (0..20_000).map(|_| six()).collect();
    certificate.polygon = (0..5_000).map(|_| [six()[0], six()[1]]).collect();
    certificate.pairs =
        (0..5_000).map(|k| Pair { u: vec![0, k as u8], v: vec![1], normal: [six()[2], six()[3]] }).collect();
    let back = Certificate::from_json(&certificate.to_json().unwrap()).unwrap();
    for (a, b) in certificate.maps.iter().zip(&back.maps) {
        assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "{a:?} {b:?}");
    }
    assert_eq!(back, certificate);
}

#[test]
fn other_ways_to_write_a_number_mean_the_same() {
    let mut numbers = doubles(2);
    for _ in 0..500 {
        let x = numbers.next().unwrap();
        // With seventeen digits, with far more, as a whole number, and with all its digits.
        let texts = [format!("{x:.16e}"), format!("{x:e}"), format!("{x:.40e}"), format!("{x:.1100}")];
        for text in texts {
            assert_eq!(read([&text, "0", "0", "1", "0", "0"])[0].to_bits(), x.to_bits(), "{text}");
        }
    }
}

/// Halfway between two doubles the even one is nearest; a digit more, however far out, tells otherwise.
#[test]
fn numbers_between_two_doubles_are_read_as_the_nearest() {
    for (k, bits) in random(3).take(500).enumerate() {
        // Whole numbers of 53 digits and some zeros, base 2, so that the middle of two neighbours is a whole number as
        // well.
        let zeros = 2 + k % 70;
        let low = u128::from(bits >> 11 | 1 << 52) << zeros;
        let high = low + (1 << zeros);
        let middle = low.midpoint(high);
        let even = if (low >> zeros).is_multiple_of(2) { low } else { high };
        let above = format!("{middle}.{}1", "0".repeat(300));
        let read = read([&middle.to_string(), &format!("{middle}e0"), &above, "0", "0", "0"]);
        assert_eq!(read[..3], [even as f64, even as f64, high as f64], "{middle}");
    }
}

/// The two maps shrink a segment to parts that fill it, 0.9225.. and 0.0774.. of it. Read one digit lower, the first
/// would leave a gap.
#[test]
fn a_proof_about_other_maps_than_the_text_has_is_refused() {
    let text = r#"{
        "maps": [[0.9225255699962589, 0, 0, 0.25, 0, 0], [0.0774744300037411, 0, 0, 0.25, 0.8856411526566684, 0]],
        "polygon": [[-1e-200, -1], [0.960018, -1], [0.960018, 1], [-1e-200, 1]],
        "letters": 1, "side": [0, 1], "pairs": [{"u": [0], "v": [1], "normal": [1, 0]}]
    }"#;
    let read = Certificate::from_json(text).unwrap();
    assert_eq!(read.maps[0][0], 0.922_525_569_996_258_9);
    assert!(check(&read).is_err());
}

#[test]
fn what_is_no_certificate_is_refused() {
    let text = plain().to_json().unwrap();
    assert!(text.starts_with("{\"maps\":[[0.25,"), "{text}");
    assert!(check(&Certificate::from_json(&text).unwrap()).is_ok());
    for bad in [
        "",
        "{}",
        "[]",
        "{\"maps\": 3}",
        "{\"maps\":[[1,2]],\"polygon\":[],\"letters\":1,\"side\":[],\"pairs\":[]}",
        &text.replacen("0.25", "1e400", 1),
        &text.replacen("0.25", "NaN", 1),
    ] {
        assert!(Certificate::from_json(bad).is_err(), "{bad}");
    }
}

#[test]
fn what_is_nested_without_end_is_refused() {
    let deep = |open: &str, close: &str| format!("{}{}", open.repeat(200_000), close.repeat(200_000));
    let (lists, objects) = (deep("[", "]"), format!("{}0{}", "{\"a\":".repeat(100_000), "}".repeat(100_000)));
    let whole = plain().to_json().unwrap();
    for nested in [&lists, &objects] {
        for text in [
            nested.clone(),
            format!("{{\"maps\":{nested}}}"),
            format!("{{\"links\":{nested}}}"),
            format!("{{\"links\":[{{\"kind\":\"point\",\"addresses\":{nested}}}],\"maps\":[]}}"),
            format!("{{\"links\":[{{\"more\":{nested},\"kind\":\"area\",\"pair\":[0,1]}}],\"maps\":[]}}"),
        ] {
            assert!(Proof::from_json(&text).is_err());
        }
        // What no certificate has is passed over, or refused.
        let more = whole.replacen('{', &format!("{{\"more\":{nested},"), 1);
        assert!(Proof::from_json(&more).is_ok_and(|proof| proof.check().is_ok()));
    }
    // A million digits are one number, or none.
    let digits = "1".repeat(1_000_000);
    assert_eq!(read([&format!("0.{digits}"), "0", "0", "1", "0", "0"])[0], 1.0 / 9.0);
    assert!(Certificate::from_json(&whole.replacen("0.25", &digits, 1)).is_err());
}
