//! Tables: a map a line, six or seven numbers in the plane, twelve or thirteen in space; perhaps a heading.

use frond_core::MAX_MAPS;

use super::problem::{Gathered, ImportError};
use crate::system::{Maps, System};
use crate::text::{number, short};

/// Reads a table. Commas part numbers; they are decimal only where semicolons or tabs part, and no point is anywhere.
pub fn read_table(text: &str) -> Result<Gathered, ImportError> {
    let rows = || {
        let lines = text
            .lines()
            .enumerate()
            .map(|(k, line)| (k + 1, line.trim_matches(['\u{1a}', ' ', '\t', '\u{c}'])));
        lines.filter(|(_, line)| !line.is_empty() && !line.starts_with(['#', ';', '%', '/']))
    };
    let has_digits = |line: &str| line.contains(|c: char| c.is_ascii_digit());
    let any = |of: &dyn Fn(&str) -> bool| rows().any(|(_, line)| has_digits(line) && of(line));
    let decimal_commas = any(&|line| line.contains([';', '\t'])) && !any(&|line| line.contains('.'));
    let mut table = Vec::new();
    for (line, words) in rows() {
        let plain = if decimal_commas { words.replace(',', ".") } else { words.to_owned() };
        let words = plain.split([',', ';', '\t', ' ']).filter(|word| !word.is_empty());
        let read: Result<Vec<f64>, &str> = words.map(|word| number(word).ok_or(word)).collect();
        match read {
            Ok(numbers) if matches!(numbers.len(), 6 | 7 | 12 | 13) => table.push((line, numbers)),
            Ok(numbers) if numbers.is_empty() => {}
            Ok(numbers) => {
                let why = format!(
                    "{} stand here. A map of the plane has six or seven numbers, one of space twelve or thirteen.",
                    if numbers.len() == 1 { "1 number".into() } else { format!("{} numbers", numbers.len()) }
                );
                return Err(ImportError::At { code: "table-count", line, why });
            }
            // What stands above the numbers is a heading.
            Err(_) if table.is_empty() => {}
            Err(word) => {
                let why = format!("“{}” is no number. Mend it, or begin a remark with #.", short(word, 40));
                return Err(ImportError::At { code: "table-number", line, why });
            }
        }
        if table.len() > MAX_MAPS {
            let why = "There are more than 64 maps from here on, and the most is 64. Leave some out.".into();
            return Err(ImportError::At { code: "table-maps", line, why });
        }
    }
    let solid = table.first().is_some_and(|(_, row)| row.len() > 7);
    if let Some((line, _)) = table.iter().find(|(_, row)| (row.len() > 7) != solid) {
        let why = "This map is of space and others of the plane, or the other way round. Leave one kind out."
            .into();
        return Err(ImportError::At { code: "table-mixed", line: *line, why });
    }
    if table.is_empty() {
        return Err(ImportError::Unknown);
    }
    let size = if solid { 12 } else { 6 };
    let weights: Vec<Option<f64>> = table.iter().map(|(_, row)| row.get(size).copied()).collect();
    let maps = if solid {
        Maps::Space(table.iter().map(|(_, row)| std::array::from_fn(|k| row[k])).collect())
    } else {
        Maps::Plane(table.iter().map(|(_, row)| std::array::from_fn(|k| row[k])).collect())
    };
    let mut system = System::of(String::new(), maps);
    system.take_weights(&weights);
    let mut all = Gathered::default();
    if decimal_commas && text.contains(',') {
        all.remarks.push("Commas are taken for decimal points.".into());
    }
    all.take(Ok(system));
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn maps(text: &str) -> Result<Vec<[f64; 6]>, ImportError> {
        let mut found = read_table(text)?;
        match found.systems.remove(0).maps {
            Maps::Plane(rows) => Ok(rows),
            Maps::Space(_) => Ok(Vec::new()),
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
        // Six numbers with commas might be twelve without: they are.
        assert_eq!(maps("0,5 0,0 0,0 0,5 1,0 0,0"), Ok(vec![]));
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
