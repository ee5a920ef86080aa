//! The fields of a line of a table.

/// What stands between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parted {
    By(char),
    BySpaces,
}

impl Parted {
    /// All, the one that is to be taken first where several will do: no number has a tab or a semicolon in it.
    pub const ALL: [Self; 5] = [Self::By('\t'), Self::By(';'), Self::By('|'), Self::By(','), Self::BySpaces];

    pub fn fields(self, line: &str) -> Fields<'_> {
        Fields { rest: Some(line), parted: self }
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::By('\t') => "tabs",
            Self::By(';') => "semicolons",
            Self::By('|') => "bars",
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
