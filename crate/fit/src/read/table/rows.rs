//! The lines of a table, and the point that each gives.

use glam::DVec2;

use super::columns::Columns;

/// A line of a table.
pub enum Row<'a> {
    Blank,
    /// What stands behind the sign of a remark.
    Remark(&'a str),
    Line(&'a str),
}

/// The lines of a text, from 1.
pub fn rows(text: &str) -> impl Iterator<Item = (usize, Row<'_>)> {
    // Machines of old ended lines so.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    text.split(end).enumerate().map(|(i, line)| {
        let line = line.trim_end_matches(['\r', '\u{1a}', '\u{c}']);
        let bare = line.trim();
        let remark = ["#", "%", "//"].iter().find_map(|sign| bare.strip_prefix(sign));
        // The brackets around a list of a program.
        let is_bracket = bare.starts_with(['[', ']', '(', ')', '{', '}'])
            && bare.chars().all(|c| matches!(c, '[' | ']' | '(' | ')' | '{' | '}' | ',' | ';' | ' '));
        let row = match remark {
            _ if bare.is_empty() || is_bracket => Row::Blank,
            Some(remark) => Row::Remark(remark.trim_start_matches(['#', '%', '/'])),
            None => Row::Line(line),
        };
        (i + 1, row)
    })
}

/// The number in a field, if it is one.
pub fn finite(columns: &Columns, field: &str) -> Option<f64> {
    columns.style.number(field).filter(|value| value.abs() <= 1e100)
}

/// The point of a line; `row` is x where there is one column.
pub fn point(columns: &Columns, line: &str, row: usize) -> Option<DVec2> {
    let (mut x, mut y) = (None, None);
    let last = columns.second.unwrap_or(0).max(columns.first);
    for (column, field) in columns.parted.fields(line).enumerate().take(last + 1) {
        if column == columns.first {
            x = Some(finite(columns, field)?);
        } else if Some(column) == columns.second {
            y = Some(finite(columns, field)?);
        }
    }
    match columns.second {
        Some(_) => Some(DVec2::new(x?, y?)),
        None => Some(DVec2::new(row as f64, x?)),
    }
}
