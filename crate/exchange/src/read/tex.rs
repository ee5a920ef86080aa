//! Tables of LaTeX as plain ones.

/// Whether a text is of LaTeX: it has its commands, or rows with `&` that end with two backslashes.
pub fn is_tex(text: &str) -> bool {
    ["\\begin{", "\\hline", "\\frac", "\\sqrt"].iter().any(|command| text.contains(command))
        || (text.contains('&') && text.contains("\\\\"))
}

/// Commands that are followed by what is not to be read.
const PASSED_OVER: [&str; 9] =
    ["begin", "end", "cline", "caption", "label", "multicolumn", "phantom", "vspace", "usepackage"];

/// Fractions within fractions are read as far.
const MAX_DEPTH: usize = 4;

/// A line without commands: `&` parts numbers, and rows that end within it are lines of their own.
pub fn plain_tex(line: &str) -> String {
    plain_within(line, MAX_DEPTH)
}

fn plain_within(line: &str, depth: usize) -> String {
    let plain_tex = |text: &str| if depth > 0 { plain_within(text, depth - 1) } else { String::new() };
    let mut plain = String::new();
    let mut rest = line.split_once('%').map_or(line, |(before, _)| before);
    while let Some(letter) = rest.chars().next() {
        let Some(command) = rest.strip_prefix('\\') else {
            rest = &rest[letter.len_utf8()..];
            match letter {
                '$' | '}' => {}
                '{' if rest.starts_with(",}") => {
                    plain.push(',');
                    rest = &rest[2..];
                }
                '{' => {}
                '~' => plain.push(' '),
                _ => plain.push(letter),
            }
            continue;
        };
        let length = command.bytes().take_while(u8::is_ascii_alphabetic).count();
        let name = &command[..length];
        rest = &command[length..];
        match name {
            "" => {
                let sign = rest.chars().next().unwrap_or(' ');
                rest = &rest[sign.len_utf8().min(rest.len())..];
                plain.push(if sign == '\\' { '\n' } else { ' ' });
            }
            "frac" | "tfrac" | "dfrac" => {
                let (above, below);
                (above, rest) = argument(rest);
                (below, rest) = argument(rest);
                plain.push_str(&format!("({})/({})", plain_tex(above), plain_tex(below)));
            }
            "sqrt" => {
                let inner;
                (inner, rest) = argument(rest);
                plain.push_str(&format!("sqrt({})", plain_tex(inner)));
            }
            "cdot" | "times" => plain.push('*'),
            "pi" | "sin" | "cos" | "tan" => plain.push_str(name),
            name if PASSED_OVER.contains(&name) => {
                while rest.trim_start().starts_with(['{', '[']) {
                    (_, rest) = argument(rest);
                }
            }
            _ => {}
        }
    }
    plain
}

/// What stands in braces or brackets next, or else the next letter; and what follows.
fn argument(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let close = match text.chars().next() {
        None => return ("", ""),
        Some('{') => '}',
        Some('[') => ']',
        Some(letter) => return text.split_at(letter.len_utf8()),
    };
    let mut depth = 0_usize;
    for (at, letter) in text.char_indices() {
        match letter {
            '{' | '[' => depth += 1,
            '}' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 && letter == close {
            return (&text[1..at], &text[at + 1..]);
        }
    }
    (&text[1..], "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_become_plain() {
        for (line, wanted) in [
            ("0 & $-0{,}5$ \\\\ 1 & 2", "0 & -0,5 \n 1 & 2"),
            ("\\begin{tabular}[t]{c|c}", ""),
            ("\\frac{\\sqrt{3}}{2} & \\tfrac12 % a remark", "(sqrt(3))/(2) & (1)/(2) "),
            ("1\\,000\\hline", "1 000"),
            ("\\frac{1", "(1)/()"),
            ("\\", " "),
        ] {
            assert_eq!(plain_tex(line), wanted, "{line}");
        }
    }
}
