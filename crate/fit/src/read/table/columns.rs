//! Which columns of a table hold its numbers, how they are parted, and how the numbers are written: whatever makes the
//! most sense of the first lines.

use std::cmp::Reverse;

use super::super::problem::Remark;
use super::super::text::short;
use super::number::{Style, may_be_parted};

/// As many fields of a line are looked at to find that out.
const MAX_FIELDS: usize = 64;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parted {
    By(char),
    BySpaces,
}

impl Parted {
    /// All, the one that is to be taken first where several will do: no number has a tab or a semicolon in it.
    const ALL: [Self; 4] = [Self::By('\t'), Self::By(';'), Self::By(','), Self::BySpaces];

    pub fn fields(self, line: &str) -> Fields<'_> {
        Fields { rest: Some(line), parted: self }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::By('\t') => "tabs",
            Self::By(';') => "semicolons",
            Self::By(_) => "commas",
            Self::BySpaces => "blanks",
        }
    }
}

/// The fields of a line.
pub struct Fields<'a> {
    rest: Option<&'a str>,
    parted: Parted,
}

impl<'a> Iterator for Fields<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let rest = self.rest?;
        let Parted::By(sign) = self.parted else {
            let rest = rest.trim_start();
            let end = rest.find(char::is_whitespace).unwrap_or(rest.len());
            self.rest = Some(&rest[end..]);
            return (end > 0).then_some(&rest[..end]);
        };
        // In quotes, signs that part columns are letters like all others.
        let quoted = rest.trim_start().strip_prefix('"').and_then(|inside| {
            let close = inside.find('"')?;
            Some(rest.len() - inside.len() + close)
        });
        let from = quoted.unwrap_or(0);
        let end = rest[from..].find(sign).map(|at| from + at);
        self.rest = end.map(|end| &rest[end + 1..]);
        Some(end.map_or(rest, |end| &rest[..end]))
    }
}

/// The columns that are read.
pub struct Columns {
    pub parted: Parted,
    pub style: Style,
    pub first: usize,
    pub second: Option<usize>,
    /// Whether there are others.
    pub more: bool,
    /// Two columns go before one, then come those with fewer fields that are no numbers, and more lines.
    rank: (bool, Reverse<usize>, usize),
}

/// Finds the first two columns in which most of the lines after the heading have numbers.
pub fn columns(sample: &[&str]) -> Option<Columns> {
    if let Some(style) = decimals(sample) {
        let rank = (false, Reverse(0), sample.len());
        return Some(Columns { parted: Parted::By(';'), style, first: 0, second: None, more: false, rank });
    }
    let mut best: Option<Columns> = None;
    for parted in Parted::ALL {
        let lines: Vec<Vec<&str>> =
            sample.iter().map(|line| parted.fields(line).take(MAX_FIELDS).collect()).collect();
        for style in Style::ALL {
            if let Some(found) = in_style(parted, style, &lines)
                && best.as_ref().is_none_or(|best| found.rank > best.rank)
            {
                best = Some(found);
            }
        }
    }
    best
}

fn in_style(parted: Parted, style: Style, lines: &[Vec<&str>]) -> Option<Columns> {
    let is_number = |line: &Vec<&str>| line.iter().map(|field| style.number(field).is_some()).collect();
    let rows: Vec<Vec<bool>> = lines.iter().map(is_number).collect();
    let begin = rows.iter().position(|row| row.contains(&true))?;
    let (rows, lines) = (&rows[begin..], &lines[begin..]);
    let most = rows.iter().map(Vec::len).max()?;
    let count = |column: usize| rows.iter().filter(|row| row.get(column) == Some(&true)).count();
    let mut full = (0..most).filter(|&column| 2 * count(column) > rows.len());
    let first = full.next()?;
    let second = full.next();
    let fields = lines.iter().flatten().filter(|field| !field.trim().is_empty()).count();
    let numbers = rows.iter().flatten().filter(|&&is| is).count();
    Some(Columns {
        parted,
        style,
        first,
        second,
        more: most > 1 + usize::from(second.is_some()),
        rank: (
            second.is_some(),
            Reverse(1000 * (fields - numbers) / fields),
            second.map_or(count(first), |second| count(first).min(count(second))),
        ),
    })
}

/// One column of decimal commas, and not two columns of whole numbers: no whole number is written 05.
fn decimals(sample: &[&str]) -> Option<Style> {
    let padded = |part: &str| part.len() > 1 && part.starts_with('0');
    let begin = sample.iter().position(|line| Style::Comma.number(line).is_some())?;
    let mut found = false;
    for line in &sample[begin..] {
        let (whole, rest) = line.split_once(',')?;
        Style::Comma.number(line)?;
        if padded(whole.trim_start_matches(['+', '-'])) {
            return None;
        }
        found |= padded(rest);
    }
    found.then_some(Style::Comma)
}

impl Columns {
    /// What was assumed where it could be otherwise.
    pub fn assumed(&self, sample: &[&str]) -> Option<Remark> {
        let used: Vec<&str> = sample
            .iter()
            .flat_map(|line| self.parted.fields(line).enumerate().take(MAX_FIELDS))
            .filter(|&(column, _)| column == self.first || Some(column) == self.second)
            .map(|(_, field)| field)
            .filter(|field| self.style.number(field).is_some())
            .collect();
        let example = |sign: char| used.iter().copied().find(|field| field.contains(sign));
        let all_parted = |sign: char| {
            used.iter().filter(|field| field.contains(sign)).all(|field| may_be_parted(field, sign))
        };
        let taken = |what: &str, field: &str| {
            let value = self.style.number(field).unwrap_or_default();
            let field = short(field.trim().trim_matches('"'), 24);
            let columns = match self.second {
                Some(_) => format!("Columns are taken to be parted by {}, and ", self.parted.name()),
                None => "There is taken to be one column, and ".into(),
            };
            format!("{columns}{what}: “{field}” is {value}.")
        };
        let otherwise = " If it parts thousands, take it out of the file.";
        let comma = "the comma to be the decimal sign";
        let message = match (self.style, example(','), example('.')) {
            (Style::Point, ..) if self.parted == Parted::By(',') => self.heading(sample)?,
            (Style::Point, _, Some(field)) if self.parted == Parted::By(';') && all_parted('.') => {
                taken("the point to be the decimal sign", field) + otherwise
            }
            (Style::Comma, Some(field), _) if all_parted(',') => taken(comma, field) + otherwise,
            (Style::Comma, Some(field), _) => taken(comma, field),
            (Style::PointParts, _, Some(field)) => {
                taken(&format!("{comma}, and the point to part thousands"), field)
            }
            (Style::PointParts, Some(field), _) => taken(comma, field),
            (Style::CommaParts, Some(field), _) => taken("the comma to part thousands", field),
            (Style::Either, Some(field), _) => {
                taken("the comma to be a decimal sign, as the point is", field)
            }
            _ => return None,
        };
        Some(Remark::new("assumed", message))
    }

    /// What is said where the heading has other columns than the lines: their commas may be decimal ones.
    fn heading(&self, sample: &[&str]) -> Option<String> {
        let count = |line: &str| self.parted.fields(line).count();
        let has_number = |line: &&str| {
            self.parted.fields(line).take(MAX_FIELDS).any(|field| self.style.number(field).is_some())
        };
        let begin = sample.iter().position(has_number)?;
        let (heading, line) = (sample.get(begin.checked_sub(1)?)?, sample[begin]);
        if count(heading) >= count(line) {
            return None;
        }
        Some(format!(
            "Commas are taken to part columns, so that “{}” is {} of them, though its heading has {}. Where they \
             are decimal signs, part the columns by semicolons.",
            short(line, 24),
            count(line),
            count(heading),
        ))
    }
}
