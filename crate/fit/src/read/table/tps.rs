//! TPS files of tpsDig (F. J. Rohlf): landmarks and curves of several specimens, with y up.

use glam::DVec2;

use super::super::content::FileContent;
use super::super::gather::{About, FEWEST_POINTS, Gathered, Line};
use super::super::problem::{ReadError, Remark};
use super::super::text::short;
use super::number::Style;

/// What a curve or the landmarks of a specimen are called.
#[derive(Clone)]
struct Label {
    specimen: usize,
    name: String,
    part: usize,
    of: usize,
}

/// Whether a text is a TPS file: its first line that is no remark says how many landmarks there are.
pub fn is_tps(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty()).take(8);
    lines.any(|line| {
        let (key, value) = line.split_once('=').unwrap_or((line, ""));
        let key = key.trim().to_ascii_uppercase();
        matches!(&*key, "LM" | "LM3" | "LM2") && value.trim().parse::<u32>().is_ok()
    })
}

/// Reads the specimens. The outline of one is each of its curves, where one does not go on at the end of another, or
/// else its landmarks.
pub fn read_tps(text: &str) -> Result<FileContent, ReadError> {
    let mut all = Reader::default();
    for (k, line) in text.lines().enumerate() {
        let line = line.trim_matches(|c: char| c.is_whitespace() || c == '\u{1a}');
        if line.is_empty() || line.starts_with(['#', '"']) {
            continue;
        }
        match line.split_once('=') {
            Some((key, value)) => all.key(&key.trim().to_ascii_uppercase(), value.trim()),
            None => match point(line) {
                Some((point, three)) => all.point(point, three),
                None => {
                    all.bad += 1;
                    all.first_bad.get_or_insert((k + 1, line));
                }
            },
        }
    }
    all.end();
    all.finish()
}

fn point(line: &str) -> Option<(DVec2, bool)> {
    let split = |c: char| c.is_whitespace() || c == ';';
    let mut numbers =
        line.split(split).filter(|word| !word.is_empty()).map(|word| Style::Either.number(word));
    let mut next = || numbers.next().flatten().filter(|value| value.abs() <= 1e100);
    let (x, y) = (next()?, next()?);
    Some((DVec2::new(x, y), next().is_some()))
}

#[derive(Default)]
struct Reader<'a> {
    gathered: Gathered<Label>,
    /// Those that have begun.
    specimens: usize,
    image: &'a str,
    id: &'a str,
    landmarks: Line,
    curve: Line,
    /// The curves of this specimen that were taken, and all that are longer than a few points.
    parts: usize,
    in_curve: bool,
    begins: bool,
    scaled: bool,
    left_landmarks: usize,
    three: bool,
    bad: usize,
    first_bad: Option<(usize, &'a str)>,
}

impl<'a> Reader<'a> {
    fn key(&mut self, key: &str, value: &'a str) {
        match key {
            "LM" | "LM2" | "LM3" => {
                self.end();
                self.specimens += 1;
            }
            "CURVES" | "OUTLINES" => self.in_curve = true,
            "POINTS" | "POINTS3" => (self.in_curve, self.begins) = (true, true),
            "IMAGE" => self.image = value,
            "ID" => self.id = value,
            "SCALE" => self.scaled |= Style::Either.number(value).is_some_and(|scale| scale != 1.0),
            _ => {}
        }
    }

    fn point(&mut self, point: DVec2, three: bool) {
        self.three |= three;
        if !self.in_curve {
            return self.landmarks.push(point);
        }
        // A curve may go on where the one before it ends.
        let goes_on = self.curve.ends_at(point);
        if std::mem::take(&mut self.begins) {
            if goes_on {
                return;
            }
            self.end_curve();
        }
        self.curve.push(point);
    }

    fn take(&mut self, line: &Line) {
        let label = Label { specimen: self.specimens, name: String::new(), part: self.parts, of: 0 };
        self.parts += 1;
        self.gathered.take(line, About { label, closed: true, ground: false });
    }

    fn end_curve(&mut self) {
        let line = std::mem::take(&mut self.curve);
        // What is shorter marks a place.
        if line.count >= FEWEST_POINTS {
            self.take(&line);
        }
        self.curve = line;
        self.curve.clear();
    }

    /// Ends a specimen, whose name stands behind its points.
    fn end(&mut self) {
        self.end_curve();
        let landmarks = std::mem::take(&mut self.landmarks);
        if self.parts == 0 && landmarks.count > 0 {
            self.take(&landmarks);
        } else {
            self.left_landmarks += landmarks.count;
        }
        self.landmarks = landmarks;
        self.landmarks.clear();
        if self.parts > 0 {
            let name = match (self.image, self.id) {
                ("", "") => format!("specimen {}", self.specimens),
                ("", id) => format!("specimen {}", short(id, 24)),
                (image, _) => short(image, 40),
            };
            let own = self.gathered.kept.iter_mut().filter(|kept| kept.label.specimen == self.specimens);
            own.for_each(|kept| {
                kept.label.name.clone_from(&name);
                kept.label.of = self.parts;
            });
        }
        (self.image, self.id, self.parts, self.in_curve, self.begins) = ("", "", 0, false, false);
    }

    fn finish(self) -> Result<FileContent, ReadError> {
        let mut remarks = Vec::new();
        let mut say = |code, message: String| remarks.push(Remark::new(code, message));
        if self.scaled {
            say("ignored", "SCALE is left out: the outlines are in pixels, as their points are.".into());
        }
        if self.left_landmarks > 0 {
            let message = format!("{} landmarks beside the curves are left out.", self.left_landmarks);
            say("ignored", message);
        }
        if self.three {
            say("ignored", "Points have more than two numbers: only x and y are read.".into());
        }
        if let Some((line, text)) = self.first_bad {
            let others = if self.bad > 1 { format!(" and {} others", self.bad - 1) } else { String::new() };
            let message =
                format!("Line {line} (“{}”){others} had no point and was left out.", short(text, 24));
            say("gaps", message);
        }
        // Two specimens of one picture, or without a name of their own, are told apart by their number.
        let names: Vec<(String, usize)> =
            self.gathered.kept.iter().map(|kept| (kept.label.name.clone(), kept.label.specimen)).collect();
        self.gathered.finish("csv", remarks, |label| {
            let shared =
                names.iter().any(|(name, specimen)| *name == label.name && *specimen != label.specimen);
            let mut name = label.name.clone();
            if shared {
                name = format!("{name}, specimen {}", label.specimen);
            }
            if label.of > 1 {
                name = format!("{name}, curve {}", label.part + 1);
            }
            name
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> (Vec<(String, f64)>, Vec<String>) {
        assert!(is_tps(text), "{text}");
        let FileContent::Outlines { outlines, remarks, .. } = read_tps(text).expect("specimens") else {
            panic!("outlines")
        };
        let named = outlines.iter().map(|one| (one.name.clone(), one.outline.area())).collect();
        (named, remarks.into_iter().map(|remark| remark.message).collect())
    }

    const SQUARE: &str = "0 0\n2 0\n2 2\n0 2\n";
    const WIDE: &str = "0 0\n4 0\n4 2\n0 2\n";

    fn named(list: &[(&str, f64)]) -> Vec<(String, f64)> {
        list.iter().map(|(name, area)| ((*name).to_string(), *area)).collect()
    }

    #[test]
    fn each_specimen_has_its_outline() {
        let text = format!(
            "LM=0\r\nCURVES=1\r\nPOINTS=4\r\n{SQUARE}IMAGE=a.jpg\r\nID=0\r\nSCALE=0.01\r\nLM=4\r\n{WIDE}ID=1\r\n\x1a"
        );
        let (found, remarks) = told(&text);
        assert_eq!(found, named(&[("specimen 1", 8.0), ("a.jpg", 4.0)]));
        assert_eq!(remarks, ["SCALE is left out: the outlines are in pixels, as their points are."]);
    }

    #[test]
    fn curves_that_go_on_are_one_outline_and_others_are_not() {
        let (found, remarks) =
            told("lm=1\n9 9\nCURVES=2\nPOINTS=3\n0 0\n2 0\n2 2\nPOINTS=2\n2 2\n0 2\nIMAGE=a\nCOMMENT=old\n");
        assert_eq!(found, named(&[("a", 4.0)]));
        assert_eq!(remarks, ["1 landmarks beside the curves are left out."]);
        let (found, _) = told(&format!("LM=0\nOUTLINES=2\nPOINTS=4\n{WIDE}POINTS=4\n{SQUARE}IMAGE=a\n"));
        assert_eq!(found, named(&[("a, curve 1", 8.0), ("a, curve 2", 4.0)]));
    }

    #[test]
    fn specimens_of_one_picture_are_told_apart() {
        let (found, _) = told(&format!("LM=4\n{SQUARE}IMAGE=a\nID=0\nLM=4\n{WIDE}IMAGE=a\nID=1\n"));
        assert_eq!(found, named(&[("a, specimen 2", 8.0), ("a, specimen 1", 4.0)]));
        let (found, remarks) = told("LM3=4\n0 0 1\n2,5 0 1\n2,5 2 1\n0 2 1\nx\n");
        assert_eq!(found, named(&[("specimen 1", 5.0)]));
        assert_eq!(remarks.len(), 2, "{remarks:?}");
    }

    #[test]
    fn others_are_no_such_files() {
        for text in ["x,y\n1,2\n", "LM\n1 2\n", "a=1\nb=2\n", ""] {
            assert!(!is_tps(text), "{text}");
        }
    }
}
