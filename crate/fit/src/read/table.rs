//! Tables of numbers: points of an outline, or values of a function.

use glam::DVec2;

use super::problem::{ReadError, Remark};
use super::text::short;

/// Lines are kept up to so many points; of more, every second one, and so on.
const KEPT: usize = 1 << 20;
/// As many lines as are looked at to find out how columns are parted.
const SAMPLE: usize = 200;
/// A heading may be so long, in lines.
const HEADING: usize = 30;

/// The numbers in a table.
pub struct Table {
    /// The two first columns of numbers; with one column, x is the row's number from 0.
    pub points: Vec<DVec2>,
    /// Whether there is a second column.
    pub two: bool,
    /// How many lines had numbers.
    pub rows: usize,
    pub remarks: Vec<Remark>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Parted {
    By(char),
    BySpaces,
}

impl Parted {
    const ALL: [Self; 4] = [Self::By('\t'), Self::By(';'), Self::By(','), Self::BySpaces];

    fn fields(self, line: &str) -> Box<dyn Iterator<Item = &str> + '_> {
        match self {
            Self::By(sign) => Box::new(line.split(sign)),
            Self::BySpaces => Box::new(line.split_whitespace()),
        }
    }

    /// A number; with a decimal comma where columns are not parted by commas. It may be NaN.
    fn number(self, field: &str) -> Option<f64> {
        let field = field.trim().trim_matches('"').trim();
        field.parse().ok().or_else(|| match self {
            Self::By(',') => None,
            _ if field.contains('.') || field.matches(',').count() != 1 => None,
            _ => field.replace(',', ".").parse().ok(),
        })
    }
}

/// Reads a table: one or two columns of numbers, or more, of which the first two are taken; parted by tabs, semicolons,
/// commas or blanks; perhaps with a heading, and with comments after `#`, `%` or `//`.
pub fn read_table(text: &str) -> Result<Table, ReadError> {
    // Machines of old ended lines so.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let lines = || {
        text.split(end).enumerate().map(|(i, line)| (i + 1, line.trim())).filter(|(_, line)| {
            !line.is_empty() && !["#", "%", "//"].iter().any(|sign| line.starts_with(sign))
        })
    };
    let Some((first_line, first)) = lines().next() else { return Err(ReadError::Empty) };
    let sample: Vec<&str> = lines().map(|(_, line)| line).take(SAMPLE).collect();
    let found =
        Parted::ALL.iter().filter_map(|&parted| columns(parted, &sample)).max_by_key(|found| found.rank);
    let Some(found) = found else {
        return Err(ReadError::NoNumbers { line: first_line, text: short(first, 40) });
    };
    let mut table = Table { points: Vec::new(), two: found.second.is_some(), rows: 0, remarks: Vec::new() };
    let (mut stride, mut bad, mut bad_count) = (1, Vec::new(), 0);
    if let Some(row) = single_row(found.parted, &sample) {
        table.two = false;
        table.rows = row.len();
        table.points = row;
        return Ok(table);
    }
    for (number, line) in lines() {
        let fields = found.parted.fields(line);
        match point(found.parted, fields, found.first, found.second, table.rows) {
            Some(point) => {
                if table.rows.is_multiple_of(stride) {
                    table.points.push(point);
                }
                table.rows += 1;
                if table.points.len() > KEPT {
                    let mut k = 0;
                    table.points.retain(|_| (k % 2 == 0, k += 1).0);
                    stride *= 2;
                }
            }
            // Before the first numbers stands a heading.
            None if table.rows == 0 && number < first_line + HEADING => {}
            None => {
                bad_count += 1;
                if bad.len() < 5 {
                    bad.push((number, line));
                }
            }
        }
    }
    if bad_count > table.rows || table.rows == 0 {
        let (line, text) = bad.first().copied().unwrap_or((first_line, first));
        return Err(ReadError::NoNumbers { line, text: short(text, 40) });
    }
    if bad_count > 0 {
        table.remarks.push(gaps(&bad, bad_count));
    }
    if stride > 1 {
        let message = format!("Of {} points every {stride}th is kept.", table.rows);
        table.remarks.push(Remark::new("thinned", message));
    }
    if found.more {
        let which = found.second.map_or_else(
            || format!("column {}", found.first + 1),
            |second| format!("columns {} and {}", found.first + 1, second + 1),
        );
        table.remarks.push(Remark::new("ignored", format!("Only {which} of the table were read.")));
    }
    Ok(table)
}

fn gaps(bad: &[(usize, &str)], count: usize) -> Remark {
    let named: Vec<String> = bad.iter().map(|(line, _)| line.to_string()).collect();
    let (word, more) =
        (if count == 1 { "Line" } else { "Lines" }, if count > bad.len() { " and more" } else { "" });
    let example = bad.first().map_or(String::new(), |(_, text)| format!(" (“{}”)", short(text, 24)));
    Remark::new(
        "gaps",
        format!(
            "{word} {}{more} had no finite numbers{example} and {} left out. Where that tears a hole, mend the file.",
            named.join(", "),
            if count == 1 { "was" } else { "were" },
        ),
    )
}

struct Columns {
    parted: Parted,
    first: usize,
    second: Option<usize>,
    more: bool,
    /// Two columns go before one, then more lines before fewer.
    rank: (usize, usize),
}

/// The first two columns in which most of the lines after the heading have numbers.
fn columns(parted: Parted, sample: &[&str]) -> Option<Columns> {
    let numbers = |line: &&str| -> Vec<bool> {
        parted.fields(line).take(64).map(|field| parted.number(field).is_some()).collect()
    };
    let rows: Vec<Vec<bool>> = sample.iter().map(numbers).collect();
    let begin = rows.iter().position(|row| row.contains(&true))?;
    let rows = &rows[begin..];
    let most = rows.iter().map(Vec::len).max()?;
    let count = |column: usize| rows.iter().filter(|row| row.get(column) == Some(&true)).count();
    let mut full = (0..most).filter(|&column| 2 * count(column) > rows.len());
    let first = full.next()?;
    let second = full.next();
    let lines = second.map_or(count(first), |second| count(first).min(count(second)));
    Some(Columns {
        parted,
        first,
        second,
        more: most > 1 + usize::from(second.is_some()),
        rank: (1 + usize::from(second.is_some()), lines),
    })
}

fn point<'a>(
    parted: Parted,
    fields: impl Iterator<Item = &'a str>,
    first: usize,
    second: Option<usize>,
    row: usize,
) -> Option<DVec2> {
    let good = |field: &str| parted.number(field).filter(|value| value.abs() <= 1e100);
    let (mut x, mut y) = (None, None);
    for (column, field) in fields.enumerate().take(second.unwrap_or(first) + 1) {
        if column == first {
            x = Some(good(field)?);
        } else if Some(column) == second {
            y = Some(good(field)?);
        }
    }
    match second {
        Some(_) => Some(DVec2::new(x?, y?)),
        None => Some(DVec2::new(row as f64, x?)),
    }
}

/// All values in one line: a column that lies down.
fn single_row(parted: Parted, sample: &[&str]) -> Option<Vec<DVec2>> {
    let [line] = sample else { return None };
    let values: Option<Vec<f64>> =
        parted.fields(line).map(|field| parted.number(field).filter(|value| value.abs() <= 1e100)).collect();
    let values = values.filter(|values| values.len() > 3)?;
    Some(values.iter().take(KEPT).enumerate().map(|(i, &value)| DVec2::new(i as f64, value)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(text: &str) -> Vec<[f64; 2]> {
        read_table(text).expect("a table").points.iter().map(|p| p.to_array()).collect()
    }

    #[test]
    fn columns_are_parted_in_many_ways() {
        let expected = [[1.5, 2.0], [-3.0, 4e2], [0.25, 6.0]];
        for text in [
            "1.5,2\n-3,4e2\n.25,6",
            "1.5, 2\r\n-3, 4e2\r\n0.25, 6\r\n",
            "1,5;2\n-3;4e2\n0,25;6,0\n",
            "1,5\t2\n-3\t4e2\n0,25\t6\n",
            "  1.5   2\n -3   4e2\n 0.25  6\n",
            "1,5 2\n-3 4e2\n0,25 6\n",
            "\"1.5\",\"2\"\n\"-3\",\"4e2\"\n\"0.25\",\"6\"\n",
            "x,y\n# a comment\n1.5,2\n\n-3,4e2\n0.25,6",
            "1.5,2\r-3,4e2\r0.25,6",
        ] {
            assert_eq!(points(text), expected, "{text:?}");
        }
    }

    #[test]
    fn one_column_counts_rows() {
        assert_eq!(points("height\n5\n6\n7"), [[0.0, 5.0], [1.0, 6.0], [2.0, 7.0]]);
        assert_eq!(points("day;m\n2020-01-01;5,5\n2020-01-02;6\n2020-01-03;7")[0], [0.0, 5.5]);
        assert_eq!(points("4,5,6,7").len(), 4);
    }

    #[test]
    fn gaps_are_named() {
        let table = read_table("x,y\n1,2\nNaN,3\n4,5\n,\n6,7\n8,inf\n9,9\n10,10").expect("a table");
        assert_eq!((table.points.len(), table.rows), (5, 5));
        assert_eq!(table.remarks.len(), 1);
        assert!(table.remarks[0].message.starts_with("Lines 3, 5, 7 had"), "{}", table.remarks[0].message);
    }

    #[test]
    fn what_is_no_table_is_said() {
        let error = read_table("milk, bread\nbutter\n").err();
        assert_eq!(error, Some(ReadError::NoNumbers { line: 1, text: "milk, bread".into() }));
        assert_eq!(read_table("# nothing\n\n").err(), Some(ReadError::Empty));
        let most = read_table("1,2\n3,4\nNaN,1\nx,2\nNA,3\n").err();
        assert!(matches!(most, Some(ReadError::NoNumbers { line: 3, .. })), "{most:?}");
    }

    #[test]
    fn memory_is_bounded() {
        let text = "0,1\n".repeat(3_000_000);
        let table = read_table(&text).expect("a table");
        assert_eq!(table.rows, 3_000_000);
        assert!(table.points.len() <= KEPT && table.points.len() > KEPT / 2);
        assert_eq!(table.remarks[0].code, "thinned");
    }
}
