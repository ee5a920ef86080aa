//! Pair subdivision against truth known by theorem: tests/known/connectedness.json.

use frond_core::{Affine2, Ifs};
use frond_locus::{Connectedness, Options, Scratch, State, Verdict, certificate, connectedness, decide};
use serde_json::Value;

/// The directory of the vectors: other ones of the same form may be put in their place.
fn known() -> Value {
    let directory = std::env::var("FROND_KNOWN")
        .unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/known").to_owned());
    let text =
        std::fs::read_to_string(format!("{directory}/connectedness.json")).expect("connectedness.json");
    serde_json::from_str(&text).expect("valid JSON")
}

fn maps_of(case: &Value) -> Vec<Affine2> {
    let row = |map: &Value| {
        let numbers: Vec<f64> = map.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        Affine2::from_row(numbers.try_into().unwrap())
    };
    case["maps"].as_array().unwrap().iter().map(row).collect()
}

/// The corners of a regular n-gon drawn together by the factor `scale`.
fn gon(n: u64, scale: f64) -> Vec<Affine2> {
    let corner = |k| glam::DVec2::from_angle(std::f64::consts::TAU * k as f64 / n as f64);
    (0..n).map(|k| Affine2::similitude(scale, 0.0, corner(k) * (1.0 - scale))).collect()
}

fn check(name: &str, maps: &[Affine2], connected: bool, epsilon: f64) -> Connectedness {
    let ifs = Ifs::new(maps.to_vec()).expect(name);
    let answer = connectedness(&ifs, &Options { epsilon, ..Options::default() });
    let sample = decide(maps, epsilon, 100_000, &mut Scratch::default());
    let case = format!("{name} at {epsilon}: {answer:?}, {sample:?}");
    assert_eq!(answer.components.len(), maps.len(), "{case}");
    assert!(answer.gap.lower <= answer.gap.upper, "{case}");
    if connected {
        assert!(matches!(answer.verdict, Verdict::Connected | Verdict::Touching), "{case}");
        assert!(sample.state.holds() && sample.gap == 0.0, "{case}");
        assert!(answer.count == 1 && answer.gap.upper <= 1.01 * epsilon * answer.diameter, "{case}");
    } else {
        assert_eq!(answer.verdict, Verdict::Disconnected, "{case}");
        assert_eq!(sample.state, State::Disconnected, "{case}");
        assert!(answer.count > 1 && answer.gap.lower > 0.0, "{case}");
        let (from, to) = answer.closest.expect("the ends of the gap");
        assert!((from.distance(to) / answer.gap.upper - 1.0).abs() < 1e-6, "{case}");
        let relative = answer.gap.upper / answer.diameter;
        let off = f64::from(sample.gap) / relative;
        // Narrow gaps may be measured only roughly.
        let (least, most) = if relative > 1e-3 { (0.9, 1.12) } else { (0.49, 2.0) };
        assert!(least < off && off < most, "{case}");
    }
    answer
}

/// What is known of a case: the verdict, and why.
fn line(name: &str, answer: &Connectedness, maps: &[Affine2], epsilon: f64) -> String {
    let why = match (&answer.reason, answer.verdict) {
        (Some(reason), _) if reason.is_proof() => reason.kind.name().to_owned(),
        (Some(reason), _) => format!("{} if {}", reason.kind.name(), reason.assuming.join(", ")),
        (None, Verdict::Disconnected) => {
            let options = Options { epsilon, budget: 4_000_000 };
            let found = certificate(&Ifs::new(maps.to_vec()).unwrap(), &options);
            found.map_or("no certificate".to_owned(), |found| format!("{} pairs", found.pairs.len()))
        }
        (None, _) => "no reason".to_owned(),
    };
    format!("{:>12}  {name}: {why}", answer.verdict.name())
}

#[test]
fn cases() {
    let known = known();
    let cases = known["cases"].as_array().unwrap();
    assert!(!cases.is_empty());
    let own = std::env::var_os("FROND_KNOWN").is_none();
    let (mut proved, mut all) = (0, 0);
    for case in cases {
        let connected = case["truth"] == "connected";
        let name = case["name"].as_str().unwrap();
        let maps = maps_of(case);
        for epsilon in [1e-4, 1e-6] {
            check(name, &maps, connected, epsilon);
        }
        let answer = check(name, &maps, connected, 1e-9);
        println!("{}", line(name, &answer, &maps, 1e-9));
        // What is in one piece is so for a reason, for the numbers as given or as meant; of these at least, if not of
        // all.
        assert!(connected || answer.reason.is_none(), "{name}: {answer:?}");
        assert!(!connected || answer.reason.is_some() || !own, "{name}: {answer:?}");
        proved += usize::from(answer.verdict == Verdict::Connected);
        all += usize::from(connected);
    }
    println!("{proved} of {all} that are connected are proved so as they are given");
    // All but those that are made of thirds.
    assert!(4 * proved >= 3 * all || !own, "{proved} of {all}");
}

#[test]
fn thresholds() {
    let known = known();
    let families = known["thresholds"].as_array().unwrap();
    assert!(!families.is_empty());
    for family in families {
        assert_eq!(family["family"], "n-gon");
        let (n, critical) = (family["n"].as_u64().unwrap(), family["critical_scale"].as_f64().unwrap());
        for epsilon in [1e-7, 1e-9] {
            for (name, scale, connected) in [("below", 1.0 - 1e-6, false), ("above", 1.0 + 1e-6, true)] {
                let maps = gon(n, critical * scale);
                let answer = check(&format!("{n}-gon {name}"), &maps, connected, epsilon);
                if epsilon == 1e-9 {
                    println!("{}", line(&format!("{n}-gon {name}"), &answer, &maps, epsilon));
                }
            }
        }
        let at = gon(n, critical);
        let answer =
            connectedness(&Ifs::new(at.clone()).unwrap(), &Options { epsilon: 1e-9, ..Options::default() });
        println!("{}", line(&format!("{n}-gon at the threshold"), &answer, &at, 1e-9));
        assert!(answer.verdict.holds());
    }
}

/// The same shapes turned, sheared and moved, so that no coefficient is what it was: their pieces still meet, often
/// in single points, which rounding moves apart.
#[test]
fn other_coordinates() {
    let known = known();
    let moves = [
        Affine2::similitude(3.7, 0.4, glam::DVec2::new(-2.0, 11.0)),
        Affine2::from_row([1.3, 4.1, -0.2, 0.9, 100.0, -30.0]),
        Affine2::from_row([-0.01, 0.002, 0.003, 0.02, 0.0, 1.0]),
    ];
    for case in known["cases"].as_array().unwrap() {
        let connected = case["truth"] == "connected";
        let name = case["name"].as_str().unwrap();
        for by in moves {
            let moved: Vec<_> = maps_of(case).iter().map(|map| map.conjugate(by).unwrap()).collect();
            check(name, &moved, connected, 1e-9);
            // At no resolution at all nothing is decided that is not so.
            let options = Options { epsilon: 0.0, budget: 20_000 };
            let verdict = connectedness(&Ifs::new(moved).unwrap(), &options).verdict;
            assert_ne!(verdict == Verdict::Disconnected, connected, "{name}: {verdict:?}");
        }
    }
}
