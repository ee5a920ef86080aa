//! Tables of numbers: points of an outline, or values of a function.

mod columns;
mod fields;
mod heading;
mod number;
mod parts;
mod rows;
mod tps;

use glam::DVec2;

use self::columns::{Columns, columns};
use self::parts::{Parts, Survey, gather};
use self::rows::{Row, finite, point, rows};
pub use self::tps::{is_tps, read_tps};
use super::content::FileContent;
use super::gather::{About, Gathered, Line};
use super::problem::{ReadError, Remark};
use super::text::short;

/// As many lines as are looked at to find out how columns are parted.
const SAMPLED_LINES: usize = 200;
/// A heading may be so long, in lines.
const LONGEST_HEADING: usize = 30;

/// The numbers in a table.
pub struct Table {
    /// All points of the two columns that are read; with one column, x is the row's number from 0.
    pub line: Line,
    /// Whether there is a second column.
    pub two: bool,
    pub remarks: Vec<Remark>,
    columns: Columns,
    parts: Parts,
}

/// Reads a table: one or two columns of numbers, or more, of which those are taken that the heading calls x and y, or
/// else the first two that do not count rows; parted by tabs, semicolons, commas or blanks; with decimal points or
/// commas; perhaps with a heading, and with comments after `#`, `%` or `//`.
pub fn read_table(text: &str) -> Result<Table, ReadError> {
    let lines = || {
        rows(text).filter_map(|(number, row)| match row {
            Row::Line(line) => Some((number, line)),
            _ => None,
        })
    };
    let Some((first_line, first)) = lines().next() else { return Err(ReadError::Empty) };
    let sample: Vec<&str> = lines().map(|(_, line)| line).take(SAMPLED_LINES).collect();
    let remark = rows(text)
        .take_while(|(_, row)| !matches!(row, Row::Line(_)))
        .filter_map(|(_, row)| if let Row::Remark(remark) = row { Some(remark) } else { None })
        .last();
    let Some(found) = columns(&sample, remark) else {
        return Err(ReadError::NoNumbers { line: first_line, text: short(first, 40) });
    };
    let mut remarks: Vec<Remark> = found.assumed(&sample).into_iter().collect();
    let two = found.second.is_some();
    if let Some(line) = single_row(&found, &sample) {
        return Ok(Table { line, two: false, remarks, columns: found, parts: Parts::One });
    }
    let (mut line, mut survey) = (Line::default(), Survey::of(&found));
    let (mut bad, mut bad_count) = (Vec::new(), 0);
    for (number, row) in rows(text) {
        let text = match row {
            Row::Blank => "",
            Row::Remark(_) => continue,
            Row::Line(text) => text,
        };
        if let Some(point) = point(&found, text, line.count) {
            survey.row(&found, text, point);
            line.push(point);
            continue;
        }
        survey.gap(&found, text);
        // Before the first numbers stands a heading.
        if text.is_empty() || (line.count == 0 && number < first_line + LONGEST_HEADING) {
            continue;
        }
        bad_count += 1;
        if bad.len() < 5 {
            bad.push((number, text));
        }
    }
    let count = line.count;
    if bad_count > count || count == 0 {
        let (line, text) = bad.first().copied().unwrap_or((first_line, first));
        return Err(ReadError::NoNumbers { line, text: short(text, 40) });
    }
    let parts = if two { survey.finish() } else { Parts::One };
    // Where they part outlines they are no gaps.
    if bad_count > 0 && !matches!(parts, Parts::Lines(_)) {
        remarks.push(gaps(&bad, bad_count));
    }
    if line.stride() > 1 {
        let message = format!("Of {count} points every {}th is kept.", line.stride());
        remarks.push(Remark::new("thinned", message));
    }
    remarks.extend(found.used());
    Ok(Table { line, two, remarks, columns: found, parts })
}

impl Table {
    /// Its outlines, and what is to be said of all.
    pub fn into_outlines(self, text: &str) -> Result<FileContent, ReadError> {
        let Self { line, mut remarks, columns, parts, .. } = self;
        let count = line.count;
        let mut gathered = if let Parts::One = parts {
            let mut gathered = Gathered::default();
            gathered.take(&line, About { label: String::from("table"), closed: true, ground: false });
            gathered
        } else {
            drop(line);
            let (gathered, said) = gather(text, &columns, &parts, count);
            remarks.extend(said);
            gathered
        };
        if columns.heading.as_ref().is_some_and(|heading| heading.imagej) {
            gathered.mirror();
            let message = "ImageJ counts y from the top of the picture: the outline is turned upright.";
            remarks.push(Remark::new("assumed", message));
        }
        gathered.finish("csv", remarks, Clone::clone)
    }
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

/// All values in one line: a column that lies down.
fn single_row(columns: &Columns, sample: &[&str]) -> Option<Line> {
    let [text] = sample else { return None };
    let mut line = Line::default();
    for field in columns.parted.fields(text) {
        line.push(DVec2::new(line.count as f64, finite(columns, field)?));
    }
    (line.count > 3).then_some(line)
}

#[cfg(test)]
mod tests {
    use super::super::gather::MAX_KEPT;
    use super::*;

    fn points(text: &str) -> Vec<[f64; 2]> {
        read_table(text).expect("a table").line.points().iter().map(|p| p.to_array()).collect()
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

    /// What was assumed, if anything.
    fn assumed(text: &str) -> String {
        let remarks = read_table(text).expect("a table").remarks;
        remarks
            .into_iter()
            .find(|remark| remark.code == "assumed")
            .map_or(String::new(), |remark| remark.message)
    }

    #[test]
    fn decimal_commas_are_told_from_commas_that_part_columns() {
        for text in [
            "1,23;4,56\n-7,5;8,25\n9;0,5",
            "1,23\t4,56\n-7,5\t8,25\n9\t0,5",
            "1,23 4,56\n-7,5 8,25\n9 0,5",
            "x;y\n1,23;4,56\n-7,5;8,25\n9;0,5",
            "x (mm); y (mm)\r\n1,23; 4,56\r\n-7,5; 8,25\r\n9; 0,5\r\n",
            "\"1,23\";\"4,56\"\n\"-7,5\";\"8,25\"\n9;0,5",
            "\"1,23\",\"4,56\"\n\"-7,5\",\"8,25\"\n\"9\",\"0,5\"",
            "name;x;y\na, b;1,23;4,56\nc, d;-7,5;8,25\ne, f;9;0,5",
        ] {
            assert_eq!(points(text), [[1.23, 4.56], [-7.5, 8.25], [9.0, 0.5]], "{text:?}");
            assert!(assumed(text).contains("“1,23” is 1.23"), "{text:?}: {}", assumed(text));
        }
        assert!(
            assumed("1,23;4,56\n7,5;8,25")
                .starts_with("Columns are taken to be parted by semicolons, and the comma")
        );
        // A single line, too.
        assert_eq!(points("1,23;4,56"), [[1.23, 4.56]]);
        // One column: no whole number begins with 0.
        assert_eq!(points("m\n1,05\n2,10\n3,50"), [[0.0, 1.05], [1.0, 2.1], [2.0, 3.5]]);
        assert!(assumed("1,05\n2,10\n3,50").starts_with("There is taken to be one column"));
    }

    #[test]
    fn thousands_are_put_together_where_they_must_be_and_asked_about_where_they_may_be() {
        for (text, first, said) in [
            ("1.234,5;7.890,25\n2;3", [1234.5, 7890.25], "the point to part thousands: “1.234,5” is 1234.5"),
            ("1.234;5,6\n2.345;7,8", [1234.0, 5.6], "the point to part thousands: “1.234” is 1234"),
            ("1,234.5;7,890\n2;3", [1234.5, 7890.0], "the comma to part thousands: “1,234.5” is 1234.5"),
            ("\"1,234.5\",\"7,890\"\n\"2\",\"3\"", [1234.5, 7890.0], "the comma to part thousands"),
            ("1 234,5;7\u{a0}890,25\n2;3", [1234.5, 7890.25], "“1 234,5” is 1234.5"),
            ("1,234\t5,678\n2,345\t6,789", [1.234, 5.678], "If it parts thousands"),
            ("1.234;5.678\n2.345;6.789", [1.234, 5.678], "If it parts thousands"),
            ("1.5;2,5\n0.5;3,5", [1.5, 2.5], "a decimal sign, as the point is: “2,5” is 2.5"),
        ] {
            assert_eq!(points(text)[0], first, "{text:?}");
            assert!(assumed(text).contains(said), "{text:?}: {}", assumed(text));
        }
    }

    #[test]
    fn what_is_plain_is_read_as_ever_and_nothing_is_said() {
        for text in [
            "1,2\n3,4",
            "x,y\n1,23\n4,56",
            "1.5,2\n3,4",
            "1, 2\n3, 4",
            "1;2\n3;4",
            "0.125;0.5\n1.234;2.5",
            "5\n6\n7",
        ] {
            assert_eq!(assumed(text), "", "{text:?}");
        }
        assert_eq!(points("1,23\n4,56"), [[1.0, 23.0], [4.0, 56.0]]);
        // A heading of fewer columns makes that doubtful.
        assert!(assumed("x,y\n1,23,4,56\n7,8,9,1").contains("is 4 of them, though its heading has 2"));
        assert!(
            assumed("height\n5,5\n6,25")
                .contains("Where they are decimal signs, part the columns by semicolons")
        );
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
        assert_eq!((table.line.points().len(), table.line.count), (5, 5));
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
        assert_eq!(table.line.count, 3_000_000);
        let kept = table.line.points().len();
        assert!(kept <= MAX_KEPT && kept > MAX_KEPT / 2);
        assert_eq!(table.remarks[0].code, "thinned");
    }
}
