//! The Hough transform on the paper's own functions, against a plain loop, and bad input.

mod plain;

use frond_fit::{
    Assembly, Candidate, Features, FirstPass, Found, FractalFunction, Hough, HoughError, HoughOptions, Kind,
    Model, SecondPass, assemble, gather, name_clusters, refine_map, share_cells,
};
use glam::DVec2;
use serde_json::Value;

const TABLE_1: [[f64; 5]; 2] = [[0.5, 0.746, 0.5, -0.5, 0.246], [0.5, -0.199, -0.6, 0.5, 0.189]];

fn table_1() -> (FractalFunction, Features, Features) {
    let function = FractalFunction::pfif(&TABLE_1.map(|map| (map, [-1.0, 1.0]))).unwrap();
    let [coarse, fine] = [65, 129].map(|count| Features::sample(&function, count).unwrap());
    (function, coarse, fine)
}

/// The repository's own copy, whatever FROND_KNOWN names: what is said below of Figure 4 and Table 3 is said of the
/// paper's.
const OWN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/known");

fn file(folder: &str, name: &str) -> Value {
    let text =
        std::fs::read_to_string(format!("{folder}/fit/{name}.json")).expect("the file of exact answers");
    serde_json::from_str(&text).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    let number = |value: &Value| match value {
        Value::String(text) => {
            let mut parts = text.split('/').map(|part| part.parse::<f64>().unwrap());
            parts.next().unwrap() / parts.next().unwrap_or(1.0)
        }
        other => other.as_f64().unwrap(),
    };
    value.as_array().unwrap().iter().map(number).collect()
}

fn hidden(name: &str) -> Features {
    let set = &file(OWN, "hidden_variable")[name];
    let points: Vec<_> =
        numbers(&set["t"]).into_iter().zip(numbers(&set["x"])).map(|(t, x)| DVec2::new(t, x)).collect();
    Features::new(&points).unwrap()
}

fn table_3() -> Vec<([f64; 5], [f64; 2])> {
    let rows = file(OWN, "hidden_variable")["curve"]["table3"].clone();
    let row = |row: &Value| {
        (numbers(&row["abcde"]).try_into().unwrap(), numbers(&row["domain"]).try_into().unwrap())
    };
    rows.as_array().unwrap().iter().map(row).collect()
}

/// Half a bin of each parameter, for features in [-1, 1] x [low, high] or as the interval and heights tell.
fn half_bins(fine: &Features) -> [f64; 5] {
    let ([start, end], [low, high]) = (fine.interval(), fine.heights());
    let (long, tall) = (0.5 * (end - start), 0.5 * (high - low));
    let middle = f64::midpoint(start, end).abs();
    let b = 3.0 * tall / long / 128.0;
    let e = 4.0 * tall / 256.0 + b * middle + f64::midpoint(low, high).abs() / 128.0;
    [1.0 / 128.0, b, 1.0 / 128.0, 2.0 * long / 256.0 + middle / 128.0, e]
}

fn is_near(map: [f64; 5], other: [f64; 5], off: [f64; 5], times: f64) -> bool {
    (0..5).all(|i| (map[i] - other[i]).abs() <= times * off[i] + 1e-9)
}

fn candidates(found: &[Found]) -> Vec<Candidate> {
    found.iter().filter_map(|found| found.candidate).collect()
}

#[test]
fn both_maps_of_table_1_win() {
    let (_, coarse, fine) = table_1();
    let options = HoughOptions { reflected: false, ..HoughOptions::default() };
    let clusters = Hough::new(&coarse, &fine, options).finish();
    let off = half_bins(&fine);
    let found = name_clusters(&coarse, &fine, options, &clusters);
    for map in TABLE_1 {
        // Which of the two is first hangs on where the edges of the bins are.
        let Some(found) = found[..2].iter().find(|found| is_near(found.cluster.map, map, off, 1.0)) else {
            panic!("{map:?} is not {:?}", &clusters[..2]);
        };
        // All triples of the coarse set vote for it, but for flat ones and those that rounding moves.
        assert!((24_000..=43_680).contains(&found.cluster.hits), "{}", found.cluster.hits);
        assert_eq!(found.kind, Kind::Map);
        let refined = found.candidate.unwrap();
        assert_eq!(refined.domain, [-1.0, 1.0]);
        // The two maps meet at 0 to 0.0009 only.
        assert!(is_near(refined.map, map, [1e-9, 1e-3, 2e-3, 1e-9, 1e-3], 1.0), "{refined:?}");
    }
}

/// A word of maps and of inverses ("2i") without letters that undo each other.
fn reduced(word: &Value) -> Vec<String> {
    let mut letters: Vec<String> = Vec::new();
    for letter in word.as_array().unwrap().iter().map(|letter| letter.as_str().unwrap().to_owned()) {
        let undone =
            letters.last().is_some_and(|last| *last == format!("{letter}i") || format!("{last}i") == letter);
        if undone {
            letters.pop();
        } else {
            letters.push(letter);
        }
    }
    letters
}

/// A table of clusters says of each of which maps it is made: one is a map itself, several an echo. The table is the
/// paper's, or that of the folder in FROND_KNOWN.
#[test]
fn rows_of_one_map_are_maps_and_rows_of_several_are_echoes() {
    let folder = std::env::var("FROND_KNOWN").unwrap_or_else(|_| OWN.to_owned());
    let rows: Vec<(Vec<String>, [f64; 5])> = file(&folder, "table2")["rows"]
        .as_array()
        .expect("the rows of the table")
        .iter()
        .map(|row| (reduced(&row["word"]), numbers(&row["abcde"]).try_into().unwrap()))
        .collect();
    let mut maps: Vec<_> = rows.iter().filter(|(word, _)| word.len() == 1).collect();
    maps.sort_by(|a, b| a.0.cmp(&b.0));
    assert!(maps.len() > 1 && maps.len() < rows.len(), "the table has no maps, or no echoes");
    let spans: Vec<_> = maps.iter().map(|(_, map)| (*map, [-1.0, 1.0])).collect();
    let function = FractalFunction::pfif(&spans).unwrap();
    let [coarse, fine] = [65, 129].map(|count| Features::sample(&function, count).unwrap());
    let options = HoughOptions { reflected: false, ..HoughOptions::default() };
    let clusters = Hough::new(&coarse, &fine, options).finish();
    let off = half_bins(&fine);
    let found = name_clusters(&coarse, &fine, options, &clusters);
    for (word, map) in rows {
        let times = if word.len() == 1 { 1.0 } else { 2.0 };
        let row = found.iter().find(|found| is_near(found.cluster.map, map, off, times));
        let row = row.unwrap_or_else(|| panic!("{word:?} {map:?} is not among {clusters:?}"));
        assert_eq!(matches!(row.kind, Kind::Echo(_)), word.len() > 1, "{word:?} {row:?}");
    }
}

#[test]
fn the_function_of_table_1_is_put_together_again() {
    let (function, coarse, fine) = table_1();
    let options = HoughOptions::default();
    let clusters = Hough::new(&coarse, &fine, options).finish();
    let found = name_clusters(&coarse, &fine, options, &clusters);
    let Assembly { model, function: ours, used, mean_square, worst } =
        assemble(&coarse, &fine, &candidates(&found)).unwrap();
    assert_eq!(model, Model::Fif, "{used:?}");
    assert_eq!(ours.curve().pieces().len(), 2);
    assert!(mean_square < 1e-6 && worst < 2e-3, "{mean_square} {worst}");
    for i in 0..1000 {
        let t = -1.0 + f64::from(i) / 499.5;
        assert!((ours.at(t) - function.at(t)).abs() < 5e-3, "at {t}");
    }
}

#[test]
fn the_fast_count_is_that_of_a_plain_loop() {
    let (function, ..) = table_1();
    // A height of 1 on both sides, as the plain loop wants it.
    let even: [Vec<DVec2>; 2] = [17, 33].map(|count| {
        let features = Features::sample(&function, count).unwrap();
        let [low, high] = Features::sample(&function, 33).unwrap().heights();
        let framed = |p: &DVec2| DVec2::new(p.x, (p.y - f64::midpoint(low, high)) / (0.5 * (high - low)));
        features.points().iter().map(framed).collect()
    });
    // The same with distances that are not even.
    let bent = even.clone().map(|points| {
        points.iter().map(|p| DVec2::new(p.x + 0.2 * p.x * (1.0 - p.x.abs()), p.y)).collect::<Vec<_>>()
    });
    for [coarse, fine] in [even, bent] {
        for reflected in [false, true] {
            let options = HoughOptions { reflected, ..HoughOptions::default() };
            let plain = plain::count(&coarse, &fine, options, 0..100);
            let (coarse, fine) = (Features::new(&coarse).unwrap(), Features::new(&fine).unwrap());
            let mut pass = FirstPass::new(&coarse, &fine, options, (0, 1));
            let mut progress = pass.step();
            while !pass.is_done() {
                progress = pass.step();
            }
            assert_eq!(progress.votes, plain.votes);
            let sum = |counts: &[u32]| counts.iter().map(|&n| u64::from(n)).sum::<u64>();
            let (sure, all) = (sum(&plain.counts), sum(pass.counts()));
            assert!(sure > 50_000 && sure <= all && all <= sure + plain.unsure, "{sure} {all}");
            assert!(plain.unsure * 10 < sure, "{}", plain.unsure);
            let each = plain.counts.iter().zip(pass.counts()).all(|(sure, fast)| sure <= fast);
            assert!(each, "every sure vote is counted where it belongs");
        }
    }
}

#[test]
fn two_shares_add_up_to_the_whole() {
    let (function, ..) = table_1();
    let [coarse, fine] = [33, 65].map(|count| Features::sample(&function, count).unwrap());
    let options = HoughOptions::default();
    let first = |part| {
        let mut pass = FirstPass::new(&coarse, &fine, options, part);
        while !pass.is_done() {
            let _ = pass.step();
        }
        pass
    };
    let (whole, mut one, other) = (first((0, 1)), first((0, 2)), first((1, 2)));
    let halves = [&one, &other].map(|pass| pass.counts().iter().map(|&n| u64::from(n)).sum::<u64>());
    assert!(halves[0].abs_diff(halves[1]) * 10 < halves[0], "the halves are as large: {halves:?}");
    one.add(other.counts());
    assert!(one.counts() == whole.counts());
    let cells = one.promising();
    assert_eq!(cells, whole.promising());
    let second = |part| {
        let mut pass = SecondPass::new(&coarse, &fine, options, &cells, part);
        while !pass.is_done() {
            let _ = pass.step();
        }
        pass
    };
    let mut half = second((0, 2));
    half.add(second((1, 2)).counts());
    assert_eq!(half.clusters(), second((0, 1)).clusters());
    assert_eq!(half.clusters(), Hough::new(&coarse, &fine, options).finish());
}

#[test]
fn two_shares_of_the_cells_find_the_same() {
    let (function, ..) = table_1();
    let [coarse, fine] = [33, 65].map(|count| Features::sample(&function, count).unwrap());
    for reflected in [false, true] {
        let options = HoughOptions { reflected, ..HoughOptions::default() };
        let mut first = FirstPass::new(&coarse, &fine, options, (0, 1));
        while !first.is_done() {
            let _ = first.step();
        }
        let cells = first.promising();
        let shares = share_cells(&coarse, &fine, options, &cells, 2);
        let mut all = shares.concat();
        all.sort_unstable();
        let mut sorted = cells.clone();
        sorted.sort_unstable();
        assert_eq!(all, sorted);
        let mut peaks = Vec::new();
        let mut votes = Vec::new();
        for share in &shares {
            assert!(!share.is_empty());
            let mut pass = SecondPass::new(&coarse, &fine, options, share, (0, 1));
            let mut last = pass.step();
            while !pass.is_done() {
                last = pass.step();
            }
            votes.push(last.votes);
            peaks.extend(pass.peaks());
        }
        assert_eq!(gather(peaks, cells.len()), Hough::new(&coarse, &fine, options).finish());
        assert!(votes[0].abs_diff(votes[1]) * 4 < votes[0] + votes[1], "as much work for each: {votes:?}");
    }
}

#[test]
fn progress_rises_and_ends_at_one() {
    let (_, coarse, fine) = table_1();
    let mut hough = Hough::new(&coarse, &fine, HoughOptions::default());
    let (mut share, mut steps) = (0.0, 0);
    while !hough.is_done() {
        assert!(hough.clusters().is_empty());
        let progress = hough.step();
        assert!(progress.share >= share && progress.share <= 1.0);
        share = progress.share;
        steps += 1;
    }
    assert!(steps > 100 && share == 1.0, "{steps} steps to {share}");
}

#[test]
fn the_seven_maps_of_table_3_are_found() {
    let (coarse, fine) = (hidden("features55"), hidden("features163"));
    let options = HoughOptions::default();
    let clusters = Hough::new(&coarse, &fine, options).finish();
    let off = half_bins(&fine);
    for (map, _) in table_3() {
        let rank = clusters.iter().position(|cluster| is_near(cluster.map, map, off, 2.0));
        assert!(rank.is_some(), "{map:?} is not among {clusters:?}");
    }
    let found = name_clusters(&coarse, &fine, options, &clusters);
    // Their middles are refined to the rationals that they are, at least where the graph copies itself exactly.
    let exact = table_3().into_iter().filter(|(map, _)| {
        let of = |candidate: Candidate| is_near(candidate.map, *map, [1e-6; 5], 1.0);
        found.iter().filter_map(|found| found.candidate).any(of)
    });
    assert!(exact.count() >= 5);
    let whole = assemble(&coarse, &fine, &candidates(&found)).unwrap();
    assert_eq!(whole.model, Model::Rfif);
    assert!(whole.function.curve().widest_gap() < 1e-9);
    // The paper's seven maps, picked and refined by hand, have 0.000180.
    assert!(whole.mean_square < 1.8e-4, "{} {:?} {:?}", whole.mean_square, whole.model, whole.used);
    assert!(whole.used.len() <= 12 && whole.used.iter().all(Option::is_some), "{:?}", whole.used);
}

#[test]
fn what_is_nearly_the_identity_does_not_pass_for_a_fit() {
    // Pieces that do not meet: near a jump hardly anything holds but copies that move nothing.
    let maps = [[0.4, 0.9, 0.35, 0.0, 0.1], [0.3, -0.7, -0.45, 0.4, 1.08], [0.3, 0.25, 0.4, 0.7, 0.29]];
    let function = FractalFunction::pfif(&maps.map(|map| (map, [0.0, 1.0]))).unwrap();
    let [coarse, fine] = [65, 129].map(|count| Features::sample(&function, count).unwrap());
    let options = HoughOptions::default();
    let clusters = Hough::new(&coarse, &fine, options).finish();
    let found = name_clusters(&coarse, &fine, options, &clusters);
    for found in &found {
        let [a, _, c, ..] = found.cluster.map;
        assert!(a.min(c) <= 0.92 || found.kind == Kind::Clutter, "{found:?}");
    }
    let whole = assemble(&coarse, &fine, &candidates(&found)).unwrap();
    assert!(whole.mean_square < 2e-3, "{} {:?}", whole.mean_square, whole.used);
}

#[test]
fn table_3_is_a_recurrent_function_of_eleven_pieces() {
    let function = FractalFunction::pfif(&table_3()).unwrap();
    let recurrent = function.to_recurrent(100).unwrap();
    let breaks: Vec<_> = recurrent.points.iter().map(|p| (p.x * 54.0).round() as i32).collect();
    assert_eq!(breaks, [0, 7, 9, 13, 15, 18, 24, 27, 36, 41, 47, 54]);
    let ours = recurrent.function().unwrap();
    assert_eq!(ours.curve().pieces().len(), 11);
    let gap = function.curve().widest_gap();
    for i in 0..=2000 {
        let t = f64::from(i) / 2000.0;
        let off = (ours.at(t) - function.at(t)).abs();
        assert!(off <= 1e-9 + 4.0 * gap, "{off} at {t}, {gap}");
    }
    assert!(ours.curve().widest_gap() < 1e-9);
    assert_eq!(function.to_recurrent(9), None);
}

#[test]
fn endless_cuts_are_no_recurrent_function() {
    // Where the second piece begins to copy is in no ratio to anything.
    let (low, a) = (0.05 * f64::sqrt(2.0), 0.5 / 0.9);
    let maps =
        [([0.5, 0.0, 0.5, 0.0, 0.0], [0.0, 1.0]), ([a, 0.1, 0.3, 0.5 - a * low, 0.0], [low, low + 0.9])];
    let function = FractalFunction::pfif(&maps).unwrap();
    assert_eq!(function.to_recurrent(1000), None);
}

#[test]
fn bad_features_are_told() {
    let line = |count: usize| -> Vec<_> { (0..count).map(|i| DVec2::new(i as f64, 0.5)).collect() };
    assert_eq!(Features::new(&line(2)), Err(HoughError::TooFewFeatures { count: 2 }));
    assert_eq!(Features::new(&line(1026)), Err(HoughError::TooManyFeatures { count: 1026 }));
    let mut bad = line(9);
    bad[4].y = f64::NAN;
    assert_eq!(Features::new(&bad), Err(HoughError::NotFinite { index: 4 }));
    bad[4] = bad[3];
    assert_eq!(Features::new(&bad), Err(HoughError::NotIncreasing { index: 4 }));
    assert!(Features::resample(&line(100_000), 129).unwrap().is_even());
    assert!(Features::resample(&line(10), 0).is_err());
}

#[test]
fn odd_graphs_end_without_panics() {
    let shape = |f: fn(f64) -> f64, count: i32| {
        let points: Vec<_> =
            (0..count).map(|i| DVec2::new(f64::from(i), f(f64::from(i) / f64::from(count - 1)))).collect();
        Features::new(&points).unwrap()
    };
    let shapes: [fn(f64) -> f64; 5] =
        [|_| 0.0, |t| t, |t| t * 1e99, |t| if t > 0.5 { 1e-99 } else { 0.0 }, |t| 1e6 + (9.0 * t).sin()];
    for f in shapes {
        for (a, b) in [(3, 3), (9, 3), (3, 9), (9, 17)] {
            let (coarse, fine) = (shape(f, a), shape(f, b));
            for wild in [
                HoughOptions::default(),
                HoughOptions { least_a: f64::NAN, least_c: -1.0, cells: 0, most_b: 0.0, reflected: true },
            ] {
                let clusters = Hough::new(&coarse, &fine, wild).finish();
                let found = name_clusters(&coarse, &fine, wild, &clusters);
                let whole = assemble(&coarse, &fine, &candidates(&found)).unwrap();
                assert!(whole.worst.is_finite());
            }
        }
    }
    let (coarse, fine) = (shape(|t| t * (1.0 - t), 9), shape(|t| t * (1.0 - t), 17));
    for map in [[f64::NAN; 5], [1e200; 5], [0.0; 5], [-0.5, 0.0, 0.25, 5.0, 0.0]] {
        let _ = refine_map(&coarse, &fine, map);
        let odd = Candidate { map, domain: [f64::NAN, 1.0], points: 3, rms: 0.0 };
        assert!(assemble(&coarse, &fine, &[odd]).is_ok());
    }
}
