//! The elements of a drawing: where each begins and ends in the text. Attributes are looked up in the text itself, so
//! that nothing of it is copied.

use std::borrow::Cow;
use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::attributes::Attributes;
use quick_xml::events::{BytesStart, Event};

use super::super::problem::ReadError;
use super::super::text::short;

/// Elements of a file.
const MAX_ELEMENTS: usize = 200_000;

/// The attributes that count.
const KNOWN: [&str; 17] = [
    "id",
    "href",
    "transform",
    "display",
    "style",
    "d",
    "points",
    "x",
    "y",
    "width",
    "height",
    "rx",
    "ry",
    "cx",
    "cy",
    "r",
    "viewBox",
];

/// All elements, in the order of the text: those inside an element follow it.
pub struct Tree<'a> {
    text: &'a str,
    nodes: Vec<Node>,
    ids: BTreeMap<Cow<'a, str>, u32>,
}

#[derive(Clone, Copy)]
struct Node {
    /// What stands between the brackets of its first tag.
    tag: (u32, u32),
    /// The first element that is not inside of it.
    end: u32,
}

/// The first tag of an element.
pub struct Tag<'a> {
    /// The name, without a prefix.
    pub name: &'a str,
    values: [Option<&'a str>; KNOWN.len()],
}

impl<'a> Tree<'a> {
    /// Finds the elements of an XML text.
    pub fn read(text: &'a str) -> Result<Self, ReadError> {
        let mut reader = Reader::from_str(text);
        // What stands between tags is not looked at.
        reader.config_mut().allow_dangling_amp = true;
        let mut tree = Self { text, nodes: Vec::new(), ids: BTreeMap::new() };
        let mut open: Vec<u32> = Vec::new();
        loop {
            let event = reader.read_event().map_err(|error| broken(text, reader.error_position(), &error))?;
            let at = reader.buffer_position();
            match event {
                Event::Start(tag) => {
                    open.push(tree.nodes.len() as u32);
                    tree.add(&tag, at - 1)?;
                }
                Event::Empty(tag) => tree.add(&tag, at - 2)?,
                Event::End(_) => {
                    let count = tree.nodes.len() as u32;
                    if let Some(node) = open.pop() {
                        tree.nodes[node as usize].end = count;
                    }
                }
                Event::Eof => break,
                _ => {}
            }
        }
        if let Some(&node) = open.last() {
            let tag = tree.tag(node);
            return Err(broken(text, text.len() as u64, &format!("<{}> is not closed", short(tag.name, 40))));
        }
        match tree.nodes.first() {
            None => Err(broken(text, text.len() as u64, &"there is no element")),
            Some(root) if (root.end as usize) < tree.nodes.len() => {
                let at = tree.nodes[root.end as usize].tag.0;
                Err(broken(text, at.into(), &"more follows after the end of the drawing"))
            }
            Some(_) => Ok(tree),
        }
    }

    /// Takes an element whose tag ends at `end`.
    fn add(&mut self, tag: &BytesStart<'_>, end: u64) -> Result<(), ReadError> {
        if self.nodes.len() == MAX_ELEMENTS {
            return Err(ReadError::TooMany { what: "elements", most: MAX_ELEMENTS });
        }
        let (from, index) = (end as usize - tag.len(), self.nodes.len() as u32);
        let text = &self.text[from..end as usize];
        for attribute in attributes(text) {
            let attribute = attribute.map_err(|error| broken(self.text, from as u64, &error))?;
            if attribute.key.as_ref() == "id" {
                let Cow::Borrowed(id) = attribute.value else { continue };
                self.ids.entry(plain(id)).or_insert(index);
            }
        }
        self.nodes.push(Node { tag: (from as u32, end as u32), end: index + 1 });
        Ok(())
    }

    /// The first tag of an element.
    pub fn tag(&self, node: u32) -> Tag<'a> {
        let text = self.tag_text(node);
        let name = &text[..name_length(text)];
        let mut values = [None; KNOWN.len()];
        for attribute in attributes(text).flatten() {
            let name = attribute.key.as_ref();
            // Links stand in a namespace of their own, or in none.
            let name = if name.ends_with(":href") { "href" } else { name };
            if let (Some(k), Cow::Borrowed(value)) =
                (KNOWN.iter().position(|&known| known == name), attribute.value)
            {
                values[k].get_or_insert(value);
            }
        }
        Tag { name: name.rsplit(':').next().unwrap_or(name), values }
    }

    /// How much text is looked through for the tag of an element.
    pub fn tag_text(&self, node: u32) -> &'a str {
        let (from, end) = self.nodes[node as usize].tag;
        &self.text[from as usize..end as usize]
    }

    /// The elements inside of an element, as a span of all.
    pub fn inside(&self, node: u32) -> (u32, u32) {
        (node + 1, self.nodes[node as usize].end)
    }

    /// What follows an element and all that is inside of it.
    pub fn after(&self, node: u32) -> u32 {
        self.nodes[node as usize].end
    }

    /// The first element of a name.
    pub fn find(&self, id: &str) -> Option<u32> {
        self.ids.get(id).copied()
    }
}

impl<'a> Tag<'a> {
    /// The value of one of the attributes that count.
    pub fn get(&self, name: &str) -> Option<Cow<'a, str>> {
        let k = KNOWN.iter().position(|&known| known == name)?;
        self.values[k].map(plain)
    }

    /// A length in the drawing's own units: whatever unit stands after it is passed over. 0 where there is none, and
    /// for parts of a page (%).
    pub fn number(&self, name: &str) -> f64 {
        let text = self.get(name).unwrap_or_default();
        let text = text.trim().trim_end_matches(|sign: char| sign.is_ascii_alphabetic());
        text.parse().ok().filter(|value: &f64| value.abs() <= 1e9).unwrap_or(0.0)
    }
}

/// The attributes of a tag. That none comes twice is not asked: it would take the square of their number, and does no
/// harm, since the first one counts.
fn attributes(tag: &str) -> Attributes<'_> {
    let mut all = Attributes::new(tag, name_length(tag));
    all.with_checks(false);
    all
}

fn name_length(tag: &str) -> usize {
    tag.find(|sign: char| sign.is_ascii_whitespace()).unwrap_or(tag.len())
}

/// A value with its character references replaced; as it stands where one is unknown.
fn plain(value: &str) -> Cow<'_, str> {
    if value.contains('&') { unescape(value).unwrap_or(Cow::Borrowed(value)) } else { Cow::Borrowed(value) }
}

fn broken(text: &str, at: u64, why: &dyn std::fmt::Display) -> ReadError {
    let before = &text.as_bytes()[..text.len().min(at as usize)];
    let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
    ReadError::Broken { format: "SVG", why: format!("{}, in line {line}", short(&why.to_string(), 120)) }
}
