//! Tables: a map a line, six or seven numbers in the plane, twelve or thirteen in space; perhaps a heading. Books,
//! encyclopedias and LaTeX number their rows, name them, and write fractions, roots and typeset signs: so does this.

use frond_core::MAX_MAPS;

use super::decimal::{decimal_word, has_decimal_commas};
use super::equation::equation;
use super::problem::{Gathered, ImportError};
use super::tex::{is_tex, plain_tex};
use crate::formula::{is_minus, value};
use crate::system::{Maps, System};
use crate::text::{number, short};

/// A row of numbers, with the line where it stands.
struct Row {
    line: usize,
    numbers: Vec<f64>,
}

/// Reads a table. Commas part numbers; they are decimal only where no point is anywhere, and semicolons, tabs or blanks
/// part.
pub fn read_table(text: &str) -> Result<Gathered, ImportError> {
    let tex = is_tex(text);
    // Rows of LaTeX end with two backslashes, wherever lines do.
    let lines = || {
        text.lines().enumerate().flat_map(move |(k, line)| {
            let plain = if tex { plain_tex(line) } else { rows_apart(line) };
            let rows: Vec<String> = plain.split('\n').map(|row| row.trim().to_owned()).collect();
            rows.into_iter().map(move |row| (k + 1, row))
        })
    };
    let rows = || {
        lines()
            .map(|(line, row)| (line, row.trim_matches(['\u{1a}', '\u{c}', '\u{feff}']).trim().to_owned()))
            .filter(|(_, row)| {
                !row.is_empty()
                    && !row.starts_with(';')
                    && (is_row_number(row) || !row.starts_with(['#', '%', '/']))
            })
    };
    let has_digits = |line: &str| line.contains(|c: char| c.is_ascii_digit());
    let any = |of: &dyn Fn(&str) -> bool| rows().any(|(_, line)| has_digits(&line) && of(&line));
    let decimal_commas = (any(&|line| line.contains([';', '\t'])) && !any(&|line| line.contains('.')))
        || has_decimal_commas(rows().map(|(_, line)| line));
    let mut table: Vec<Row> = Vec::new();
    let mut heading = None;
    for (line, row) in rows() {
        if let Some(numbers) = equation(&row) {
            table.push(Row { line, numbers });
            too_many(&table, line)?;
            continue;
        }
        let words = words(&row, decimal_commas);
        let values: Vec<Option<f64>> = words.iter().map(|word| read_number(word)).collect();
        let first = values.iter().position(Option::is_some);
        let (Some(first), Some(last)) = (first, values.iter().rposition(Option::is_some)) else {
            // Words alone are a heading, or what stands below.
            if table.is_empty() && !words.is_empty() {
                heading = Some((line, words));
            }
            continue;
        };
        let numbers: Option<Vec<f64>> = values[first..=last].iter().copied().collect();
        let stray = words.iter().zip(&values).find(|(_, value)| value.is_none()).map(|(word, _)| word);
        match (numbers, stray) {
            (Some(numbers), _) if matches!(numbers.len(), 6..=8 | 12..=14) => {
                table.push(Row { line, numbers });
            }
            // What stands above the numbers is a heading.
            (_, Some(_)) if table.is_empty() => heading = Some((line, words)),
            (_, Some(word)) => {
                let why = format!("“{}” is no number. Mend it, or begin a remark with #.", short(word, 40));
                return Err(ImportError::At { code: "table-number", line, why });
            }
            (numbers, None) => return Err(wrong_count(line, numbers.map_or(0, |numbers| numbers.len()))),
        }
        too_many(&table, line)?;
    }
    let mut all = Gathered::default();
    let heading = heading.map(|(line, words)| Heading::of(line, &words)).transpose()?;
    let columns = heading.map_or(Vec::new(), |heading| heading.columns);
    if take_row_numbers(&mut table, columns.len()) {
        all.remarks.push("The first number of each line counts the maps: it is left out.".into());
    }
    if let Some(row) = table.iter().find(|row| !matches!(row.numbers.len(), 6 | 7 | 12 | 13)) {
        return Err(wrong_count(row.line, row.numbers.len()));
    }
    let is_solid = |row: &Row| row.numbers.len() > 7;
    let solid = table.first().is_some_and(is_solid);
    if let Some(row) = table.iter().find(|row| is_solid(row) != solid) {
        let why = "This map is of space and others of the plane, or the other way round. Leave one kind out."
            .into();
        return Err(ImportError::At { code: "table-mixed", line: row.line, why });
    }
    if table.is_empty() {
        return Err(ImportError::Unknown);
    }
    if !solid && reorder(&mut table, &columns) {
        let names: String = columns.iter().map(|&column| format!(" {}", LETTERS[column])).collect();
        all.remarks.push(format!("As the heading says, the columns are{names}."));
    }
    let size = if solid { 12 } else { 6 };
    let weights: Vec<Option<f64>> = table.iter().map(|row| row.numbers.get(size).copied()).collect();
    let maps = if solid {
        Maps::Space(table.iter().map(|row| std::array::from_fn(|k| row.numbers[k])).collect())
    } else {
        Maps::Plane(table.iter().map(|row| std::array::from_fn(|k| row.numbers[k])).collect())
    };
    let mut system = System::of(String::new(), maps);
    system.take_weights(&weights);
    if decimal_commas && text.contains(',') {
        all.remarks.push("Commas are taken for decimal points.".into());
    }
    all.take(Ok(system));
    Ok(all)
}

fn too_many(table: &[Row], line: usize) -> Result<(), ImportError> {
    if table.len() > MAX_MAPS {
        let why = "There are more than 64 maps from here on, and the most is 64. Leave some out.".into();
        return Err(ImportError::At { code: "table-maps", line, why });
    }
    Ok(())
}

/// Rows in brackets that stand in one line, as programs print them.
fn rows_apart(line: &str) -> String {
    let mut line = line.to_owned();
    for between in ["],[", "], [", "},{", "}, {", "),(", "), ("] {
        if line.contains(between) {
            line = line.replace(between, "\n");
        }
    }
    line
}

fn wrong_count(line: usize, count: usize) -> ImportError {
    let why = format!(
        "{} stand here. A map of the plane has six or seven numbers, one of space twelve or thirteen.",
        if count == 1 { "1 number".into() } else { format!("{count} numbers") }
    );
    ImportError::At { code: "table-count", line, why }
}

/// Whether a line begins with `#1`, which counts rows and begins no remark.
fn is_row_number(line: &str) -> bool {
    let rest = line.strip_prefix('#').unwrap_or_default();
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    digits > 0 && rest[digits..].starts_with([' ', '\t', ':', ',', ';', '|', '.', ')'])
}

/// The words of a line, without the brackets of programs around them and the rules between rows.
fn words(line: &str, decimal_commas: bool) -> Vec<String> {
    let parts = |c: char| {
        c.is_whitespace()
            || matches!(c, ';' | '|' | '&' | '[' | ']' | '{' | '}')
            || c == ',' && !decimal_commas
    };
    let words = line.split(parts).map(|word| {
        let mut word = word.trim_matches(|c: char| matches!(c, '"' | '\'' | '\u{200b}' | '\u{feff}'));
        let [open, closed] = ['(', ')'].map(|sign| word.matches(sign).count());
        // Brackets that nothing closes are off its beginning, those that nothing opens off its end.
        let first = word.bytes().take_while(|&byte| byte == b'(').count().min(open.saturating_sub(closed));
        let last =
            word.bytes().rev().take_while(|&byte| byte == b')').count().min(closed.saturating_sub(open));
        word = &word[first..word.len() - last];
        if decimal_commas { decimal_word(word) } else { word.to_owned() }
    });
    words.filter(|word| !word.chars().all(|c| is_minus(c) || matches!(c, '=' | '+' | ':'))).collect()
}

fn read_number(word: &str) -> Option<f64> {
    let word = word.strip_suffix('%').unwrap_or(word);
    // Names such as p stand above numbers, and none is one.
    number(word).or_else(|| if word.len() > 1 { value(word) } else { None })
}

/// The names of a map's numbers, and of its weight.
const LETTERS: [&str; 7] = ["a", "b", "c", "d", "e", "f", "p"];

/// What a heading says.
struct Heading {
    /// Which of a map's numbers each column has, where that is said of all six; what else is there has no place.
    columns: Vec<usize>,
}

impl Heading {
    fn of(line: usize, words: &[String]) -> Result<Self, ImportError> {
        let plain = |word: &String| -> String {
            word.to_lowercase().chars().filter(|c| c.is_alphanumeric()).collect()
        };
        let words: Vec<String> = words.iter().map(plain).collect();
        let is_angle = |word: &&String| {
            matches!(&***word, "θ" | "theta" | "φ" | "phi" | "ϕ" | "ϑ" | "angle" | "angles" | "rotation")
        };
        if let Some(angle) = words.iter().find(is_angle) {
            let why = format!(
                "The heading has an angle (“{angle}”). Frond reads matrices: with scales r and s and angles θ and φ, \
                 write a = r cos θ, b = -s sin φ, c = r sin θ, d = s cos φ."
            );
            return Err(ImportError::At { code: "table-angles", line, why });
        }
        let letter = |word: &String| match &**word {
            "a" | "a11" => Some(0),
            "b" | "a12" => Some(1),
            "c" | "a21" => Some(2),
            "d" | "a22" => Some(3),
            "e" | "b1" | "tx" | "dx" | "e1" => Some(4),
            "f" | "b2" | "ty" | "dy" | "e2" => Some(5),
            "p" | "pi" | "prob" | "probability" | "weight" => Some(6),
            _ => None,
        };
        let mut columns: Vec<usize> = words.iter().filter_map(letter).collect();
        // Before the letters stands the name of the map, behind them its weight.
        if !columns.contains(&6) && words.last().is_some_and(|word| word == "w") {
            columns.push(6);
        }
        // A row may be named by f.
        if words.first().is_some_and(|word| word == "f")
            && columns.iter().filter(|&&column| column == 5).count() == 2
        {
            columns.remove(0);
        }
        let whole = (0..6).all(|k| columns.iter().filter(|&&column| column == k).count() == 1);
        let one_weight = columns.iter().filter(|&&column| column == 6).count() < 2;
        Ok(Self { columns: if whole && one_weight { columns } else { Vec::new() } })
    }
}

/// Takes the number before each map, where they count it from 0 or 1: first numbers that grow so are in no matrix that
/// shrinks.
fn take_row_numbers(table: &mut [Row], named: usize) -> bool {
    let start = table.first().map_or(0.0, |row| row.numbers[0]);
    let counts = |(k, row): (usize, &Row)| row.numbers[0] == start + k as f64;
    if ![0.0, 1.0].contains(&start) || !table.iter().enumerate().all(counts) {
        return false;
    }
    let over = |row: &Row| matches!(row.numbers.len(), 8 | 14);
    let may = |row: &Row| matches!(row.numbers.len(), 7 | 13) && named != row.numbers.len();
    let several = table.len() > 2 || (table.len() == 2 && start == 1.0);
    if table.is_empty() || !(table.iter().all(over) || (several && table.iter().all(may))) {
        return false;
    }
    table.iter_mut().for_each(|row| {
        row.numbers.remove(0);
    });
    true
}

/// Puts numbers into their order, where the heading says another. Whether it did.
fn reorder(table: &mut [Row], columns: &[usize]) -> bool {
    let in_order = columns.windows(2).all(|pair| pair[0] < pair[1]);
    if columns.is_empty() || in_order || table.iter().any(|row| row.numbers.len() != columns.len()) {
        return false;
    }
    for row in table {
        let mut ordered = row.numbers.clone();
        columns.iter().zip(&row.numbers).for_each(|(&column, &number)| ordered[column] = number);
        row.numbers = ordered;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn maps(text: &str) -> Result<Vec<[f64; 6]>, ImportError> {
        let mut found = read_table(text)?;
        match found.systems.remove(0).maps {
            Maps::Plane(rows) => Ok(rows),
            _ => Ok(Vec::new()),
        }
    }

    const HALF: [f64; 6] = [0.5, 0.0, 0.0, 0.5, 1.0, 0.0];

    #[test]
    fn numbers_are_parted_by_blanks_commas_or_semicolons() {
        for text in [
            ".5 0 0 .5 1 0",
            "a,b,c,d,e,f,p\n0.5,0,0,0.5,1,0,1\n",
            "# a remark\r\n5e-1\t0\t0\t.5\t1\t0\r\n",
            "a;b;c;d;e;f\n0,5;0;0;0,5;1;0",
            "0.5; 0; 0; 0.5; 1; 0",
        ] {
            assert_eq!(maps(text), Ok(vec![HALF]), "{text}");
        }
        // Twelve whole numbers would shrink nothing: commas are decimal ones.
        for text in [
            "0,5 0,0 0,0 0,5 1,0 0,0",
            "0,5 0 0 0,5 1 0",
            "0,5, 0, 0, 0,5, 1, 0",
            "0,5\u{a0}0\u{2009}0 0,5 1 0",
        ] {
            assert_eq!(maps(text), Ok(vec![HALF]), "{text}");
            assert_eq!(read_table(text).unwrap().remarks, ["Commas are taken for decimal points."]);
        }
        assert_eq!(maps("1,2,3,4,5,6"), Ok(vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]]));
    }

    /// The fern of Barnsley, as Wikipedia and books print it.
    const FERN: [[f64; 6]; 2] = [[0.0, 0.0, 0.0, 0.16, 0.0, 0.0], [0.85, 0.04, -0.04, 0.85, 0.0, 1.6]];

    #[test]
    fn rows_are_read_as_books_print_them() {
        for text in [
            "0 0 0 0.16 0 0 0.01\n0.85 0.04 \u{2212}0.04 0.85 0 1.60 0.85",
            "0\u{a0}0\u{a0}0\u{a0}0.16\u{a0}0\u{a0}0\u{a0}0.01\n.85\u{2009}.04\u{2009}–.04\u{2009}.85\u{2009}0\u{2009}1.6\u{2009}.85",
            "T1 0 0 0 0.16 0 0 0.01\nT2 0.85 0.04 -0.04 0.85 0 1.6 0.85",
            "w\ta\tb\tc\td\te\tf\tp\tPortion generated\nƒ1\t0\t0\t0\t0.16\t0\t0\t0.01\tStem\nƒ2\t0.85\t0.04\t−0.04\t0.85\t0.00\t1.60\t0.85\tSuccessively smaller leaflets\n",
            "f1: 0 0 0 0.16 0 0 0.01\nf2: 0.85 0.04 -0.04 0.85 0 1.6 0.85\nThe first point is drawn at the origin.",
            "1 0 0 0 0.16 0 0 0.01\n2 0.85 0.04 -0.04 0.85 0 1.6 0.85",
            "1. 0 0 0 0.16 0 0 0.01\n2. 0.85 0.04 -0.04 0.85 0 1.6 0.85",
            "1) 0 0 0 0.16 0 0 0.01\n2) 0.85 0.04 -0.04 0.85 0 1.6 0.85",
            "#1 0 0 0 0.16 0 0 0.01\n#2 0.85 0.04 -0.04 0.85 0 1.6 0.85",
            "| map | a | b | c | d | e | f | p |\n|---|---|---|---|---|---|---|---|\n| f1 | 0 | 0 | 0 | 0.16 | 0 | 0 | 0.01 |\n| f2 | 0.85 | 0.04 | −0.04 | 0.85 | 0 | 1.6 | 0.85 |",
            "\\begin{tabular}{ccccccc}\na & b & c & d & e & f & p\\\\\n\\hline\n0 & 0 & 0 & 0.16 & 0 & 0 & 0.01\\\\\n0.85 & 0.04 & $-0.04$ & 0.85 & 0 & 1.6 & 0.85\\\\\n\\end{tabular}",
            "$f_1$ & 0 & 0 & 0 & 0{,}16 & 0 & 0 & 0{,}01 \\\\ $f_2$ & 0{,}85 & 0{,}04 & $-$0{,}04 & 0{,}85 & 0 & 1{,}6 & 0{,}85",
            "[0, 0, 0, 0.16, 0, 0, 0.01],\n[0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85],",
            "ifs = [\n (0, 0, 0, 0.16, 0, 0, 0.01),\n (0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85),\n]",
            "[0, 0, 0, 0.16, 0, 0, 0.01], [0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85]",
            "{{0, 0, 0, 0.16, 0, 0, 0.01}, {0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85}}",
            "p a b c d e f\n0.01 0 0 0 0.16 0 0\n0.85 0.85 0.04 -0.04 0.85 0 1.6",
            "a c b d e f p\n0 0 0 0.16 0 0 0.01\n0.85 -0.04 0.04 0.85 0 1.6 0.85",
            "e;f;a;b;c;d;p\n0;0;0;0;0;0,16;0,01\n0;1,6;0,85;0,04;−0,04;0,85;0,85",
        ] {
            let all = read_table(text).unwrap_or_else(|error| panic!("{error}: {text}"));
            let system = &all.systems[0];
            assert_eq!(system.maps, Maps::Plane(FERN.to_vec()), "{text}");
            assert_eq!(system.probabilities, [0.01, 0.85], "{text}");
            let numbered = text.starts_with('1');
            assert_eq!(all.remarks.iter().any(|remark| remark.contains("counts")), numbered, "{text}");
            let other = ["p a", "a c", "e;"].iter().any(|start| text.starts_with(start));
            assert_eq!(all.remarks.iter().any(|remark| remark.contains("heading")), other, "{text}");
        }
    }

    #[test]
    fn equations_are_maps() {
        let text = "f1(x, y) = (0, 0.16y)\nf2(x, y) = (0.85x + 0.04y, −0.04x + 0.85y + 1.6)";
        assert_eq!(maps(text), Ok(FERN.to_vec()));
        assert!(maps(&"x' = x/2, y' = y/2\n".repeat(65)).unwrap_err().to_string().starts_with("Line 65"));
    }

    #[test]
    fn formulas_and_shares_are_read() {
        let third = 1.0 / 3.0;
        let (sixth, third_y) = (3.0_f64.sqrt() / 6.0, 1.5);
        let wanted =
            vec![[third, 0.0, 0.0, third, 0.0, 0.0], [1.0 / 6.0, -sixth, sixth, 1.0 / 6.0, third, third_y]];
        for text in [
            "1/3 0 0 1/3 0 0\n1/6 -sqrt(3)/6 sqrt(3)/6 1/6 1/3 3/2",
            "1/3 0 0 1/3 0 0 25%\n1/6 −√3/6 √3/6 1/6 1/3 3/2 75%",
            "$\\frac{1}{3}$ & 0 & 0 & $\\tfrac13$ & 0 & 0 \\\\ $\\frac{1}{6}$ & $-\\frac{\\sqrt{3}}{6}$ & $\\frac{\\sqrt{3}}{6}$ & 1/6 & 1/3 & 3/2 \\\\",
        ] {
            assert_eq!(maps(text), Ok(wanted.clone()), "{text}");
        }
    }

    #[test]
    fn what_is_no_matrix_is_said() {
        let told = |text: &str| maps(text).unwrap_err().to_string();
        assert!(
            told("r s theta phi e f p\n0 .16 0 0 0 0 .01\n").starts_with("Line 1: The heading has an angle")
        );
        assert!(told("1 2 3 4 5 6 7 8\n3 2 3 4 5 6 7 8\n").starts_with("Line 1: 8 numbers stand here."));
        // Six numbers and their weight are never taken for a count and six numbers.
        assert_eq!(maps("0 0 0 .16 0 0 .01\n").unwrap(), [FERN[0]]);
        assert_eq!(maps("0 0 0 .5 0 0 .5\n1 0 0 .5 0 0 .5\n").unwrap()[1][0], 1.0);
    }

    #[test]
    fn mistakes_are_named_with_their_line() {
        let told = |text: &str| maps(text).unwrap_err().to_string();
        assert!(told("1 2 3 4 5 6\n1 2 3\n").starts_with("Line 2: 3 numbers stand here."));
        assert!(told("1 2 3 4 5 6\n\nx 2 3 4 5 6\n").starts_with("Line 3: “x” is no number."));
        assert!(told(&"1 2 3 4 5 6\n".repeat(65)).starts_with("Line 65: There are more than 64 maps"));
        assert!(told("1 2 3 4 5 6\n1 2 3 4 5 6 7 8 9 0 1 2\n").starts_with("Line 2: This map is of space"));
        assert_eq!(maps("nothing at all"), Err(ImportError::Unknown));
    }
}
