//! `.aifs` files of IFStile: a part of them, as [`SUBSET`] says it to whoever opens one.
//!
//! A file has blocks, `@id:parent`, of definitions `name=value`; a block has those of its parent, too. `[x, y]` is a
//! translation and `[a, b, c, d]` a matrix, `*` composes, `|` unites, and the shape is a set that is made of its own
//! images: `S=(f|g)*S`. Nothing in a file is run: what is not listed is refused, with its line.

use std::collections::BTreeMap;

use frond_core::MAX_MAPS;

use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::system::System;
use crate::text::{name_or, number, short};

/// What is read of such files.
const SUBSET: &str = "Of .aifs files Frond reads numbers, translations [x, y], matrices [a, b, c, d], products, whole \
    powers and one equation S = (f | g | ..) * S, in the plane or in space.";
/// Blocks within blocks, names within names, brackets within brackets.
const MAX_DEPTH: usize = 32;
/// Said where they go on beyond that.
const ENDLESS: &str = "Names or brackets go on without end.";
/// Blocks that are looked at: files may have millions.
const MAX_BLOCKS: usize = 4 * MAX_SYSTEMS;
/// Steps of arithmetic for one block, and for all of a file.
const MAX_STEPS: usize = 20_000;
const MAX_FILE_STEPS: usize = 2_000_000;
/// So many letters of a text are a step.
const STEP_LETTERS: usize = 64;

/// Reads the blocks that have an equation of a set.
pub fn read_ifstile(text: &str) -> Result<Gathered, ImportError> {
    let blocks = blocks(text)?;
    let mut all = Gathered::default();
    let count = text.lines().filter(|line| line.trim_start().starts_with('@')).count();
    if count > MAX_BLOCKS {
        all.remarks.push(format!("The file has {count} blocks: the first {MAX_BLOCKS} are looked at."));
    }
    let mut left = MAX_FILE_STEPS;
    for (k, block) in blocks.iter().enumerate() {
        if left == 0 {
            let line = block.line;
            all.remarks.push(format!("The file takes too many steps to compute: it is read to line {line}."));
            break;
        }
        // What others are built on is hidden, and may not be complete.
        if !block.hidden() && all.systems.len() < MAX_SYSTEMS {
            all.extend_with(Block::system(&blocks, k, &mut left));
        }
    }
    all.finish(refused("aifs-nothing", 1, "No block has an equation of a set."))
}

fn refused(code: &'static str, line: usize, why: &str) -> ImportError {
    ImportError::At { code, line, why: format!("{why} {SUBSET}") }
}

#[derive(Clone, Copy)]
struct Definition<'a> {
    value: &'a str,
    line: usize,
    /// Whether it mentions its own name, and so is a set.
    set: bool,
}

struct Block<'a> {
    parent: Option<usize>,
    line: usize,
    definitions: BTreeMap<&'a str, Definition<'a>>,
    /// The names of sets, in their order.
    sets: Vec<&'a str>,
}

fn blocks(text: &str) -> Result<Vec<Block<'_>>, ImportError> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    let mut ids: BTreeMap<&str, usize> = BTreeMap::new();
    for (k, line) in text.lines().enumerate() {
        let number = k + 1;
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() || line.starts_with("@@version") {
            continue;
        }
        if line.starts_with("@@") {
            return Err(refused("aifs-unread", number, "Other files are not fetched."));
        }
        if let Some(head) = line.strip_prefix('@') {
            if blocks.len() == MAX_BLOCKS {
                break;
            }
            let (id, parent) = head.split_once(':').unwrap_or((head, ""));
            let (id, parent) = (id.trim(), parent.trim());
            let parent = ids.get(parent).copied().filter(|_| !parent.is_empty());
            if !id.is_empty() {
                ids.insert(id, blocks.len());
            }
            blocks.push(Block { parent, line: number, definitions: BTreeMap::new(), sets: Vec::new() });
            continue;
        }
        let Some((name, value)) = line.split_once('=') else {
            return Err(refused("aifs-unread", number, "No name and value, name=value, stand here."));
        };
        if blocks.is_empty() {
            blocks.push(Block { parent: None, line: number, definitions: BTreeMap::new(), sets: Vec::new() });
        }
        if let Some(block) = blocks.last_mut() {
            let (name, value) = (name.trim(), value.trim());
            let set = mentions(name, value);
            block.definitions.insert(name, Definition { value, line: number, set });
            // Said twice, it may be no set any more: whoever looks there asks its definition again.
            if set {
                block.sets.push(name);
            }
        }
    }
    Ok(blocks)
}

/// Whether a value has a name in it.
fn mentions(name: &str, value: &str) -> bool {
    let letters = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$' || c == '&';
    value.split(|c| !letters(c)).any(|word| word == name)
}

impl<'a> Block<'a> {
    fn hidden(&self) -> bool {
        self.definitions.get("$a").is_some_and(|it| it.value.contains('h'))
    }

    /// The system of a block; nothing where it has no set. What steps it takes are taken from those that are left.
    fn system(blocks: &'a [Self], k: usize, left: &mut usize) -> Option<Result<System, ImportError>> {
        let most = MAX_STEPS.min(*left);
        let mut scope = Scope { chain: Vec::new(), size: 2, set: "", line: blocks[k].line, steps: 0, most };
        let mut next = Some(k);
        while let Some(block) = next.filter(|_| scope.chain.len() < MAX_DEPTH) {
            scope.chain.push(&blocks[block]);
            next = blocks[block].parent;
        }
        let found = scope.find_set().and_then(|set| {
            scope.set = set.unwrap_or_default();
            set.map(|_| scope.read()).transpose()
        });
        *left -= scope.steps.min(*left);
        found.transpose()
    }
}

/// What a name or a bracket stands for.
#[derive(Clone, Debug)]
enum Value {
    Number(f64),
    List(Vec<f64>),
    /// Several: any of them.
    Maps(Vec<Map>),
    /// Images of the set.
    Images(Vec<Map>),
}

/// `x' = matrix x + shift`, in two or three dimensions.
#[derive(Clone, Debug)]
struct Map {
    size: usize,
    matrix: [f64; 9],
    shift: [f64; 3],
}

impl Map {
    fn scaling(size: usize, factor: f64) -> Self {
        let mut map = Self { size, matrix: [0.0; 9], shift: [0.0; 3] };
        (0..size).for_each(|k| map.matrix[k * size + k] = factor);
        map
    }

    /// First `inner`, then this.
    fn after(&self, inner: &Self) -> Self {
        let size = self.size;
        let mut map = Self { size, matrix: [0.0; 9], shift: self.shift };
        for row in 0..size {
            for k in 0..size {
                let x = self.matrix[row * size + k];
                // Not times zero: that keeps infinities and the signs of zeros out.
                if x != 0.0 {
                    for column in 0..size {
                        map.matrix[row * size + column] += x * inner.matrix[k * size + column];
                    }
                    map.shift[row] += x * inner.shift[k];
                }
            }
        }
        map
    }
}

/// The definitions of a block, its parents' behind its own.
struct Scope<'a> {
    chain: Vec<&'a Block<'a>>,
    size: usize,
    set: &'a str,
    line: usize,
    steps: usize,
    /// The most steps.
    most: usize,
}

impl<'a> Scope<'a> {
    fn find(&self, name: &str) -> Option<Definition<'a>> {
        self.chain.iter().find_map(|block| block.definitions.get(name).copied())
    }

    /// The same to be read: that takes the longer the longer it is.
    fn look(&mut self, name: &str) -> Result<Option<Definition<'a>>, ImportError> {
        let found = self.find(name);
        self.charge(1 + found.map_or(0, |it| it.value.len() / STEP_LETTERS))?;
        Ok(found)
    }

    /// The name of the only set.
    fn find_set(&mut self) -> Result<Option<&'a str>, ImportError> {
        let mut found: Option<&str> = None;
        for depth in 0..self.chain.len() {
            self.step()?;
            let block = self.chain[depth];
            for &name in &block.sets {
                self.step()?;
                match found {
                    _ if !self.find(name).is_some_and(|it| it.set) => {}
                    Some(set) if set != name => {
                        let (one, other) = (short(set, 20), short(name, 20));
                        return self.fail(&format!("“{one}” and “{other}” are two sets."));
                    }
                    _ => found = Some(name),
                }
            }
        }
        Ok(found)
    }

    fn fail<T>(&self, why: &str) -> Result<T, ImportError> {
        Err(refused("aifs-unread", self.line, why))
    }

    fn read(&mut self) -> Result<System, ImportError> {
        if let Some(it) = self.find("$subspace") {
            self.line = it.line;
            return self.fail("$subspace is not read.");
        }
        self.size = match self.find("$dim") {
            None | Some(Definition { value: "2", .. }) => 2,
            Some(Definition { value: "3", .. }) => 3,
            Some(it) => {
                self.line = it.line;
                return self.fail("$dim is neither 2 nor 3.");
            }
        };
        let Some(Definition { value, line, .. }) = self.look(self.set)? else {
            return self.fail("No equation of a set is here.");
        };
        self.line = line;
        let Value::Images(maps) = self.value(value, 0)? else {
            return self.fail("This is no equation of a set by its images.");
        };
        if maps.iter().any(|map| !map.matrix.iter().chain(&map.shift).all(|x| x.is_finite())) {
            return self.fail("A number becomes too large.");
        }
        let name = self.look("$n")?;
        let name = name.map_or_else(String::new, |it| name_or(it.value.trim_matches('"'), ""));
        Ok(if self.size == 2 {
            let row = |Map { matrix: m, shift: s, .. }: Map| [m[0], m[1], m[2], m[3], s[0], s[1]];
            System::plane(name, maps.into_iter().map(row).collect())
        } else {
            let row =
                |map: Map| std::array::from_fn(|k| if k < 9 { map.matrix[k] } else { map.shift[k - 9] });
            System::space(name, maps.into_iter().map(row).collect())
        })
    }

    fn step(&mut self) -> Result<(), ImportError> {
        self.charge(1)
    }

    fn charge(&mut self, steps: usize) -> Result<(), ImportError> {
        self.steps += steps;
        if self.steps > self.most { self.fail("This takes too many steps to compute.") } else { Ok(()) }
    }

    fn value(&mut self, text: &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut rest = text;
        let value = self.union(&mut rest, depth)?;
        if rest.trim().is_empty() {
            return Ok(value);
        }
        let why = format!("“{}” is not read.", short(rest, 30));
        self.fail(&why)
    }

    fn name(&mut self, name: &'a str, depth: usize) -> Result<Value, ImportError> {
        self.step()?;
        match name {
            _ if name == self.set => return Ok(Value::Images(vec![Map::scaling(self.size, 1.0)])),
            "$i" => return Ok(Value::Maps(vec![Map::scaling(self.size, 1.0)])),
            "$pi" => return Ok(Value::Number(std::f64::consts::PI)),
            _ => {}
        }
        if depth > MAX_DEPTH {
            return self.fail(ENDLESS);
        }
        let Some(Definition { value, line, .. }) = self.look(name)? else {
            let why = format!("“{}” is not read.", short(name, 30));
            return self.fail(&why);
        };
        let here = std::mem::replace(&mut self.line, line);
        let value = self.value(value, depth + 1)?;
        self.line = here;
        Ok(value)
    }

    fn union(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut value = self.sum(rest, depth)?;
        while take(rest, '|') {
            self.step()?;
            let next = self.sum(rest, depth)?;
            value = match (value, next) {
                (Value::Images(one), Value::Images(other)) => Value::Images(self.few([one, other].concat())?),
                (Value::Images(_), _) | (_, Value::Images(_)) => {
                    return self.fail("Images of the set are united with what is none.");
                }
                (one, other) => {
                    let both = [self.maps(one)?, self.maps(other)?].concat();
                    Value::Maps(self.few(both)?)
                }
            };
        }
        Ok(value)
    }

    fn sum(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut value = self.product(rest, depth)?;
        loop {
            let sign = if take(rest, '+') {
                1.0
            } else if take(rest, '-') {
                -1.0
            } else {
                return Ok(value);
            };
            self.step()?;
            let next = self.product(rest, depth)?;
            let (Value::Number(one), Value::Number(other)) = (value, next) else {
                return self.fail("Sums are read of numbers alone.");
            };
            value = Value::Number(one + sign * other);
        }
    }

    fn product(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut value = self.power(rest, depth)?;
        loop {
            let times = take(rest, '*');
            if !times && !take(rest, '/') {
                return Ok(value);
            }
            self.step()?;
            let next = self.power(rest, depth)?;
            value = match (value, next, times) {
                (Value::Number(one), Value::Number(other), true) => Value::Number(one * other),
                (Value::Number(one), Value::Number(other), false) => Value::Number(one / other),
                (_, _, false) => return self.fail("Quotients are read of numbers alone."),
                (Value::Images(_), _, _) => return self.fail("A set stands before “*”."),
                (one, Value::Images(images), _) => Value::Images(self.composed(one, &images)?),
                (one, other, _) => {
                    let other = self.maps(other)?;
                    Value::Maps(self.composed(one, &other)?)
                }
            };
        }
    }

    fn power(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let mut negative = false;
        while take(rest, '-') {
            self.step()?;
            negative = !negative;
        }
        let value = self.raised(rest, depth)?;
        match value {
            value if !negative => Ok(value),
            Value::Number(x) => Ok(Value::Number(-x)),
            other => {
                let maps = self.maps(other)?;
                Ok(Value::Maps(self.composed(Value::Number(-1.0), &maps)?))
            }
        }
    }

    fn raised(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        let value = self.atom(rest, depth)?;
        if !take(rest, '^') {
            return Ok(value);
        }
        let sign = if take(rest, '-') { -1.0 } else { 1.0 };
        let Value::Number(power) = self.atom(rest, depth)? else { return self.fail("A power is no number.") };
        match value {
            Value::Number(x) => Ok(Value::Number(x.powf(sign * power))),
            Value::Images(_) => self.fail("A set has no power."),
            other if sign > 0.0 && (0.0..=MAX_MAPS as f64).contains(&power) && power.fract() == 0.0 => {
                let maps = self.maps(other)?;
                let mut all = vec![Map::scaling(self.size, 1.0)];
                for _ in 0..power as usize {
                    self.step()?;
                    all = self.composed(Value::Maps(maps.clone()), &all)?;
                }
                Ok(Value::Maps(all))
            }
            _ => self.fail("Powers of maps are read from 0 to 64."),
        }
    }

    fn atom(&mut self, rest: &mut &'a str, depth: usize) -> Result<Value, ImportError> {
        self.step()?;
        if depth > MAX_DEPTH {
            return self.fail(ENDLESS);
        }
        if take(rest, '(') {
            let value = self.union(rest, depth + 1)?;
            return if take(rest, ')') { Ok(value) } else { self.fail("A bracket is missing its partner.") };
        }
        if take(rest, '[') {
            let mut list = Vec::new();
            loop {
                match self.union(rest, depth + 1)? {
                    Value::Number(x) if list.len() < 9 => list.push(x),
                    Value::Number(_) => return self.fail("A list is longer than a matrix."),
                    _ => return self.fail("Lists are read of numbers alone."),
                }
                if take(rest, ']') {
                    return Ok(Value::List(list));
                }
                if !take(rest, ',') {
                    return self.fail("A list is not closed.");
                }
            }
        }
        let word = word(rest);
        if word.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return match number(word) {
                Some(x) => Ok(Value::Number(x)),
                None => self.fail(&format!("“{}” is no number.", short(word, 30))),
            };
        }
        if word.is_empty() {
            let why = if rest.is_empty() {
                "Something is missing at the end.".into()
            } else {
                format!("“{}” is not read.", short(rest, 30))
            };
            return self.fail(&why);
        }
        if rest.starts_with(['(', '[']) {
            let why = format!("“{}{}” is not read.", short(word, 30), &rest[..1]);
            return self.fail(&why);
        }
        self.name(word, depth)
    }

    /// A number scales, a list is a translation or a matrix.
    fn maps(&self, value: Value) -> Result<Vec<Map>, ImportError> {
        let size = self.size;
        match value {
            Value::Maps(maps) => Ok(maps),
            Value::Number(x) => Ok(vec![Map::scaling(size, x)]),
            Value::List(list) if list.len() == size => {
                let mut map = Map::scaling(size, 1.0);
                map.shift[..size].copy_from_slice(&list);
                Ok(vec![map])
            }
            Value::List(list) if list.len() == size * size => {
                let mut map = Map::scaling(size, 0.0);
                map.matrix[..size * size].copy_from_slice(&list);
                Ok(vec![map])
            }
            Value::List(list) => {
                let why =
                    format!("A list of {} numbers is neither a translation nor a matrix here.", list.len());
                self.fail(&why)
            }
            Value::Images(_) => self.fail("A set stands where a map should be."),
        }
    }

    fn composed(&mut self, outer: Value, inner: &[Map]) -> Result<Vec<Map>, ImportError> {
        let outer = self.maps(outer)?;
        if outer.len() * inner.len() > MAX_MAPS {
            return self.fail("There are more than 64 maps, and the most is 64.");
        }
        self.charge(outer.len() * inner.len())?;
        Ok(outer.iter().flat_map(|one| inner.iter().map(|other| one.after(other))).collect())
    }

    fn few(&self, maps: Vec<Map>) -> Result<Vec<Map>, ImportError> {
        if maps.len() > MAX_MAPS {
            self.fail("There are more than 64 maps, and the most is 64.")
        } else {
            Ok(maps)
        }
    }
}

fn take(rest: &mut &str, sign: char) -> bool {
    *rest = rest.trim_start();
    rest.strip_prefix(sign).map(|after| *rest = after).is_some()
}

/// A number or a name.
fn word<'a>(rest: &mut &'a str) -> &'a str {
    let text = *rest;
    let is_number = text.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let mut before = ' ';
    let end = text.find(|c: char| {
        // A sign belongs to a number behind its exponent.
        let exponent = is_number && matches!(before, 'e' | 'E') && matches!(c, '+' | '-');
        before = c;
        !(exponent
            || c.is_ascii_alphanumeric()
            || c == '_'
            || (is_number && c == '.')
            || (!is_number && matches!(c, '$' | '&')))
    });
    let (word, after) = text.split_at(end.unwrap_or(text.len()));
    *rest = after;
    word
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::Maps;

    fn rows(text: &str) -> Vec<[f64; 6]> {
        match read_ifstile(text).unwrap().systems.remove(0).maps {
            Maps::Plane(rows) => rows,
            Maps::Space(_) => Vec::new(),
        }
    }

    fn told(text: &str) -> String {
        read_ifstile(text).map(|_| ()).unwrap_err().to_string()
    }

    #[test]
    fn an_equation_of_a_set_is_a_system() {
        let dragon = [[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]];
        for text in [
            "@\n$dim=2\nf1=[0,0]*[0.5,-0.5,0.5,0.5]\nf2=[1,0]*[-0.5,-0.5,0.5,-0.5]\nS=(f1|f2)*S",
            "@@version 4\n@ # by hand\nA = [.5,-1/2,2^-1,0.5]*A | [1,0] * [-.5,-.5,5e-1,-.5] * A\r\n",
            "@base\n$a=h\nh=2^-1\nS=(f|g)*S\n@:base\n$dim=2\n$n=Dragon\nf=h*[1,-1,1,1]\ng=[1,0]*h*[-1,-1,1,-1]",
        ] {
            assert_eq!(rows(text), dragon, "{text}");
        }
        // A scale before a shift scales it, too.
        assert_eq!(
            rows("@\nA=(2^-1*[1,0]|[1,0]*2^-1)*A"),
            [[0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.0, 0.5, 1.0, 0.0]]
        );
        assert_eq!(rows("@\nf=[.5,0,0,.5]\ng=[1,0]\nA=f^2*A|f*g*A|-f*A").len(), 3);
        let solid = read_ifstile("@\n$dim=3\nA=([1,0,0]|[0,0,0])*2^-1*A").unwrap().systems.remove(0);
        assert_eq!(solid.maps.len(), 2);
    }

    #[test]
    fn hidden_blocks_are_no_shapes_of_their_own() {
        let found = |letter: char| read_ifstile(&format!("@b\n$a={letter}\nA=[.5,0,0,.5]*A\n@:b\n$n=Two\n"));
        let names = |letter| found(letter).unwrap().systems.into_iter().map(|it| it.name).collect::<Vec<_>>();
        assert_eq!(names('h'), ["Two"]);
        assert_eq!(names('x'), ["", "Two"]);
    }

    #[test]
    fn a_set_is_what_mentions_itself_where_it_is_last_defined() {
        let half = "[.5,0,0,.5]";
        assert_eq!(rows(&format!("@b\nA={half}*A\nB=(1|A)*B\n@:b\nA={half}\n"))[1][0], 0.5);
        assert_eq!(rows(&format!("@\nA=A*A\nA={half}\nB=A*B\n")).len(), 1);
        assert!(told(&format!("@\nA={half}*A\nB={half}*B\n")).contains("“A” and “B” are two sets."));
    }

    #[test]
    fn what_is_not_read_is_told_with_its_line() {
        for (text, start) in [
            ("@\n$dim=2\n$subspace=[s,0]\nA=A", "Line 3: $subspace"),
            ("@\n$dim=4\nA=A", "Line 2: $dim"),
            ("@\ns=$companion([1,1])\nA=s*A", "Line 2: “$companion(”"),
            ("@\nA=h*A\nh=k", "Line 3: “k”"),
            ("@\nA=h*B|A\nB=h*A|B", "Line 1: “A” and “B” are two sets."),
            ("@\nA=[1,0*A", "Line 2: Lists"),
            ("@\nA=[1,2,3]*A", "Line 2: A list of 3 numbers"),
            ("@\nA=(1|2|3|4|5)^3*A", "Line 2: There are more than 64 maps"),
            ("@\na=b\nb=a\nA=a*A", "Line 2: Names or brackets go on"),
            ("@@import x.aifs", "Line 1: Other files are not fetched."),
            ("@\nh=1", "Line 1: No block has an equation"),
            ("@\nA=2^9999*A", "Line 2: A number becomes too large."),
        ] {
            assert!(told(text).starts_with(start), "{text}: {}", told(text));
            assert!(told(text).ends_with(SUBSET));
        }
    }
}
