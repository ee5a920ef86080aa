//! Numbers at the ends of what doubles hold, and what files make of them: what is read is finite, or it is said, and it
//! can be written and read again.

use frond_exchange::{ExportFormat, Maps, System, export, import};
use proptest::prelude::*;

const DOUBLES: [ExportFormat; 4] =
    [ExportFormat::Json, ExportFormat::Fractint, ExportFormat::Flame, ExportFormat::Csv];

fn number() -> impl Strategy<Value = f64> {
    let ends = [0.0, 1.0, -1.0, 0.5, 3.0, 1e155, 1e200, -1e200, 1e308, -1.7e308, 5e-324, 1e-200, -1e-308];
    proptest::sample::select(ends.to_vec())
}

fn rows(maps: &Maps) -> Vec<&[f64]> {
    maps.rows()
}

fn words(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ")
}

/// Whether each number is one, and each map has its weight or none has.
fn is_sound(system: &System) -> bool {
    let (rows, weights) = (rows(&system.maps), &system.probabilities);
    let sum: f64 = weights.iter().sum();
    rows.iter().copied().flatten().all(|x| x.is_finite())
        && (weights.is_empty() || weights.len() == rows.len() && sum > 0.0 && sum.is_finite())
        && weights.iter().all(|weight| *weight >= 0.0)
}

fn comes_back(system: &System) {
    for format in DOUBLES {
        let text = export(system, format).unwrap();
        let found = import(text.as_bytes()).unwrap().systems.remove(0);
        assert_eq!(rows(&found.maps), rows(&system.maps), "{text}");
        assert!(found.remarks.is_empty() && is_sound(&found), "{:?} {text}", found.remarks);
        if !system.probabilities.is_empty() {
            assert_eq!(found.probabilities, system.probabilities, "{text}");
        }
    }
}

fn told(text: &str) -> String {
    import(text.as_bytes()).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn a_flame_whose_products_overflow_is_refused() {
    for (xform, what) in [
        ("coefs='1e200 0 0 1e200 0 0' post='1e200 0 0 1e200 0 0'", "coefs and post"),
        ("coefs='1e200 0 0 1e200 0 0' linear='1e200'", "coefs and linear"),
        ("coefs='.5 0 0 .5 0 0' linear='1e308' linear3D='1e308'", "linear and its other name"),
        ("coefs='0 0 0 0 1e200 0' post='1e200 0 0 1 0 0'", "a shift"),
        ("coefs='0 0 0 0 1e308 1e308' post='1 0 1 0 0 0'", "a sum"),
    ] {
        let flame = |name: &str, more: &str| {
            format!("<flame name='{name}'>\n<xform coefs='.5 0 0 .5 0 0'/>\n{more}</flame>\n")
        };
        let wrong = flame("A", &format!("<xform {xform}/>"));
        let why = told(&wrong);
        assert!(why.starts_with("Line 3: Numbers of transform 2 are too large"), "{what}: {why}");
        assert!(why.ends_with("Mend it, or leave the transform out."), "{what}: {why}");
        // Good ones of the same file are read, and it is said that one is not.
        let found = import(format!("<flames>{wrong}{}</flames>", flame("B", "")).as_bytes()).unwrap();
        assert_eq!(found.systems.len(), 1);
        assert!(found.remarks[0].contains("transform 2"), "{:?}", found.remarks);
    }
    // What weighs something that is no number is not passed over.
    for weight in ["1e999", "nan", "-inf"] {
        let text = format!("<flame><xform linear='1' swirl='{weight}' coefs='.5 0 0 .5 0 0'/></flame>");
        let remarks = import(text.as_bytes()).unwrap().systems.remove(0).remarks;
        assert!(remarks.len() == 1 && remarks[0].contains("(swirl)"), "{remarks:?}");
    }
}

#[test]
fn a_script_that_computes_no_number_is_refused_where_it_does() {
    for (text, start) in [
        // Each of these would come out as a finite map again.
        ("@\n$dim=2\nh=1/0\nA=(1/h)*A", "Line 3: A number is divided by 0."),
        ("@\nh=0^-1\nA=(1/h)*A", "Line 2: A number is divided by 0."),
        ("@\nA=(1/(exp(500)*exp(500)))*A", "Line 2: A number becomes too large."),
        ("@\nA=(1/(10^4000))*A", "Line 2: A number becomes too large."),
        ("@\nA=((0-8)^(1/3)*0)*A", "Line 2: A broken power of a negative number is no number."),
        ("@\nA=0/0*A", "Line 2: A number is divided by 0."),
        // And these as an infinite one.
        ("@\nf=[1e200,0,0,1]\nA=(f*f|.5)*A", "Line 3: A number becomes too large."),
        (
            "@\nf=[1e200,0,0,1]\nA=.5*A|(.5|f)*f*A",
            "Line 3: Of 2 products, in number 2: A number becomes too large.",
        ),
        ("@\nA=[1e300,0]^2*1e300*[1e300,0]*A", "Line 2: A number becomes too large."),
        ("@\nA=[1e200,0,0,1]^2*A", "Line 2: A number becomes too large."),
    ] {
        assert!(told(text).starts_with(start), "{text}: {}", told(text));
    }
    // What is rational stays exact, however large it is on the way.
    for (factor, wanted) in [
        ("(1e200*1e200)*1e-400/4", 0.25),
        ("(1e308+1e308)*1e-309", 0.2),
        ("10^400/10^401", 0.1),
        ("0*(1e308-(0-1e308))", 0.0),
        ("1/(1e200*1e200)", 0.0),
    ] {
        let found = import(format!("@\nA={factor}*A").as_bytes()).unwrap().systems.remove(0);
        assert_eq!(found.maps, Maps::Plane(vec![[wanted, 0.0, 0.0, wanted, 0.0, 0.0]]), "{factor}");
    }
}

/// Whatever its size, a shape fills its figure. Beyond 1e100 there is none.
#[test]
fn drawings_fill_their_frame() {
    for (width, is_drawn) in [(1e101, false), (1e99, true), (1.0, true), (1e-12, true), (1e-60, true)] {
        // From 0 to twice the shift.
        let maps = [0.0, width / 2.0].map(|x| [0.5, 0.0, 0.0, 0.25, x, 0.0]);
        let system = System::plane(String::new(), maps.to_vec());
        comes_back(&system);
        for (format, rightmost) in [(ExportFormat::Svg, "1020.0 "), (ExportFormat::Tikz, "(8.000,")] {
            match export(&system, format) {
                Ok(text) => assert!(is_drawn && text.contains(rightmost), "{width} {text:.300}"),
                Err(error) => assert!(!is_drawn && error.code() == "no-attractor", "{error}"),
            }
        }
        let flame = export(&system, ExportFormat::Flame).unwrap();
        let value = |key: &str| -> f64 {
            let from = flame.split_once(&format!("{key}=\"")).unwrap().1;
            from.split([' ', '"']).next().unwrap().parse().unwrap()
        };
        if is_drawn {
            let (pixels, centre) = (value(" scale") * width, value("center") / width);
            assert!((pixels - 900.0).abs() < 1.0 && (centre - 0.5).abs() < 1e-3, "{flame}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(400)))]

    /// The product, computed anew: as a row, y down, then turned over.
    #[test]
    fn a_flame_is_finite_or_refused(
        coefs in proptest::array::uniform6(number()),
        post in proptest::option::of(proptest::array::uniform6(number())),
        linear in number(),
        weights in proptest::option::of(proptest::array::uniform2(number())),
    ) {
        prop_assume!(linear != 0.0 && !weights.is_some_and(|weights| weights.contains(&0.0)));
        let weight = |k: usize| weights.map_or_else(String::new, |it| format!("weight='{:e}'", it[k]));
        let after = post.map_or_else(String::new, |post| format!("post='{}'", words(&post)));
        let text = format!(
            "<flame><xform {} coefs='.5 0 0 .5 0 0'/><xform {} linear='{linear:e}' coefs='{}' {after}/></flame>",
            weight(0), weight(1), words(&coefs)
        );
        let [pa, pd, pb, pe, pc, pf] = post.unwrap_or([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        let product = |of: fn(f64) -> f64| {
            let [pa, pd, pb, pe, pc, pf] = [pa, pd, pb, pe, pc, pf].map(of);
            let [a, d, b, e, c, f] = coefs.map(|x| of(linear * x));
            [
                pa * a + pb * d, of(-(pa * b + pb * e)), of(-(pd * a + pe * d)), pd * b + pe * e,
                pa * c + pb * f + pc, of(-(pd * c + pe * f + pf)),
            ]
        };
        match import(text.as_bytes()) {
            Ok(found) => {
                let system = &found.systems[0];
                prop_assert!(is_sound(system), "{system:?}");
                let scale = product(f64::abs).map(|x| 1e-12 * x + 1e-320);
                for ((x, wanted), off) in rows(&system.maps)[1].iter().zip(product(|x| x)).zip(scale) {
                    prop_assert!((x - wanted).abs() <= off, "{x} {wanted}: {text}");
                }
                comes_back(system);
            }
            Err(error) => {
                prop_assert_eq!(error.code(), "flame-number");
                // Some sum is about too large.
                prop_assert!(product(f64::abs).iter().any(|x| x.is_nan() || *x > 1e307), "{error}: {text}");
            }
        }
    }

    #[test]
    fn weights_are_those_of_the_maps_or_none(
        weights in proptest::collection::vec(proptest::option::weighted(0.9, number()), 1..6),
    ) {
        let of = |k: usize| weights[k].map_or_else(String::new, |x| format!("{x:e}"));
        let lines = |row: &str| (0..weights.len()).map(|k| format!("{row} {}\n", of(k))).collect::<String>();
        let given: Option<Vec<f64>> = weights.iter().map(|x| x.map(f64::abs)).collect();
        let wanted = given.filter(|given| (f64::MIN_POSITIVE * f64::EPSILON..=f64::MAX).contains(&given.iter().sum()));
        let is_said = weights.iter().flatten().any(|x| *x < 0.0)
            || wanted.is_none() && weights.iter().any(Option::is_some);
        let (flat, solid) = (lines(".5 0 0 .5 0 0"), lines(".5 0 0 0 .5 0 0 0 .5 0 0 0"));
        for text in [format!("a {{\n{flat}}}"), format!("a (3D) {{\n{solid}}}"), flat, solid] {
            let system = import(text.as_bytes()).unwrap().systems.remove(0);
            prop_assert_eq!(&system.probabilities, &wanted.clone().unwrap_or_default(), "{}", text);
            prop_assert_eq!(!system.remarks.is_empty(), is_said || text.contains("e 0\n"), "{}", text);
        }
    }

    #[test]
    fn what_is_written_holds_numbers(
        rows in proptest::collection::vec(proptest::array::uniform6(number()), 1..5),
        small in proptest::bool::ANY,
        shift in number(),
    ) {
        // Half of them have an attractor.
        let shrunk = |row: &[f64; 6]| [0.5, 0.0, 0.0, 0.25, shift * (row[4] / 2.0), row[5] / 2.0];
        let rows: Vec<_> = if small { rows.iter().map(shrunk).collect() } else { rows };
        prop_assume!(rows.iter().flatten().all(|x| x.is_finite()));
        let system = System::plane(String::new(), rows);
        comes_back(&system);
        for format in ExportFormat::ALL {
            match export(&system, format) {
                Ok(text) => prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{text}"),
                Err(error) => prop_assert_eq!(error.code(), "no-attractor"),
            }
        }
    }
}
