//! Outlines that were drawn on pictures: the files of COCO, `LabelMe`, VIA, Label Studio and others, which call the
//! same things by few names. Other objects of JSON with lists of points are read in the same way.

use std::fmt;

use glam::DVec2;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::gather::{Line, MAX_KEPT};
use super::found::Found;
use super::word::Word;

/// The most classes that are named.
const MAX_CLASSES: usize = 1000;
/// Two points are no outline.
const FEWEST_CORNERS: usize = 3;

/// What is known of the whole file.
#[derive(Default)]
pub struct Known {
    pub classes: Vec<(i64, String)>,
    /// Boxes, circles and points that are left out.
    pub others: usize,
    /// Masks of pixels that are left out.
    pub masks: usize,
}

/// What a key holds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Key {
    /// Objects, or lists of them.
    Inner,
    /// Objects by any name.
    Named,
    Points,
    Xs,
    Ys,
    Name,
    Kind,
    /// `name` is a kind in VIA.
    NameOrKind,
    /// Words by the names of attributes.
    Attributes,
    Class,
    Classes,
    Width,
    Height,
    Mask,
    Other,
}

fn key_of(key: &str) -> Key {
    match key {
        "annotations" | "completions" | "shapes" | "objects" | "instances" | "result" | "value"
        | "shape_attributes" | "frames" => Key::Inner,
        "regions" | "_via_img_metadata" => Key::Named,
        "points" | "segmentation" | "polygon" | "polygons" | "path" | "paths" | "exterior" | "vertices"
        | "outline" | "outlines" | "contour" | "contours" | "coordinates" | "coords" => Key::Points,
        "x" | "X" | "xs" | "all_points_x" | "lon" => Key::Xs,
        "y" | "Y" | "ys" | "all_points_y" | "lat" => Key::Ys,
        "label" | "classTitle" | "className" | "title" | "polygonlabels" | "labels" | "category" => Key::Name,
        "name" => Key::NameOrKind,
        "shape_type" | "type" | "geometryType" => Key::Kind,
        "region_attributes" => Key::Attributes,
        "category_id" => Key::Class,
        "categories" => Key::Classes,
        "original_width" => Key::Width,
        "original_height" => Key::Height,
        "counts" | "rle" | "bitmap" => Key::Mask,
        _ => Key::Other,
    }
}

/// What kinds of shapes are no outlines by their corners.
fn is_other(kind: &str) -> bool {
    [
        "rect",
        "circle",
        "ellipse",
        "point",
        "multipoint",
        "box",
        "mask",
        "bitmap",
        "brush",
        "keypoint",
        "cuboid",
    ]
    .iter()
    .any(|start| kind.starts_with(start))
}

fn is_open(kind: &str) -> bool {
    kind.starts_with("line") || kind.starts_with("polyline")
}

/// What a value was.
pub enum Item {
    Other,
    Number(f64),
    Position(DVec2),
}

/// A value anywhere in the file.
pub struct Node<'a> {
    pub found: &'a mut Found,
    pub known: &'a mut Known,
    /// Whether numbers are coordinates.
    pub points: bool,
    /// Whether the keys are names that say nothing.
    pub named: bool,
}

impl Node<'_> {
    fn inner(&mut self, points: bool) -> Node<'_> {
        Node { found: &mut *self.found, known: &mut *self.known, points, named: false }
    }
}

impl<'de> DeserializeSeed<'de> for Node<'_> {
    type Value = Item;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Item, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Node<'_> {
    type Value = Item;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("outlines")
    }

    fn visit_unit<E>(self) -> Result<Item, E> {
        Ok(Item::Other)
    }

    fn visit_bool<E>(self, _: bool) -> Result<Item, E> {
        Ok(Item::Other)
    }

    fn visit_f64<E>(self, value: f64) -> Result<Item, E> {
        Ok(Item::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Item, E> {
        Ok(Item::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Item, E> {
        Ok(Item::Number(value as f64))
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<Item, E> {
        Ok(Item::Other)
    }

    /// Positions, or the numbers of one, or those of several one behind the other.
    fn visit_seq<A: SeqAccess<'de>>(mut self, mut seq: A) -> Result<Item, A::Error> {
        let (mut line, mut flat) = (Line::default(), Line::default());
        let (mut x, mut first, mut numbers) = (None, None, 0_usize);
        let (points, mut ends) = (self.points, None);
        while let Some(item) = seq.next_element_seed(self.inner(points))? {
            match item {
                Item::Number(value) if points && value.abs() <= 1e100 => {
                    numbers += 1;
                    match x.take() {
                        None => x = Some(value),
                        Some(x) => {
                            first.get_or_insert(DVec2::new(x, value));
                            flat.push(DVec2::new(x, value));
                        }
                    }
                }
                Item::Position(p) => {
                    ends = Some((ends.map_or(p, |(start, _)| start), p));
                    line.push(p);
                }
                Item::Number(_) | Item::Other => {}
            }
        }
        match numbers {
            2 | 3 => return Ok(first.map_or(Item::Other, Item::Position)),
            _ if numbers >= 2 * FEWEST_CORNERS && numbers % 2 == 0 => {
                let closed = flat.returns();
                self.found.take(&flat, closed);
            }
            _ => {}
        }
        if line.count >= FEWEST_CORNERS {
            self.found.take(&line, ends.is_some_and(|(start, end)| start == end));
        }
        Ok(Item::Other)
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<Item, A::Error> {
        let mut own = Found::default();
        if self.named {
            while map.next_key::<IgnoredAny>()?.is_some() {
                map.next_value_seed(self.inner(false))?;
            }
            return Ok(Item::Other);
        }
        let mut about = About::default();
        while let Some(key) = map.next_key_seed(Word)? {
            let key = key.as_deref().map_or(Key::Other, key_of);
            let known = &mut *self.known;
            match key {
                Key::Inner | Key::Named | Key::Points => {
                    let (points, named) = (key == Key::Points, key == Key::Named);
                    map.next_value_seed(Node { found: &mut own, known, points, named })?;
                }
                Key::Xs => map.next_value_seed(Numbers { list: &mut about.xs })?,
                Key::Ys => map.next_value_seed(Numbers { list: &mut about.ys })?,
                Key::Name => about.name = map.next_value_seed(Word)?.or(about.name),
                Key::Kind => about.kind = map.next_value_seed(Word)?.or(about.kind),
                Key::NameOrKind => {
                    let word = map.next_value_seed(Word)?;
                    let is_kind = word
                        .as_deref()
                        .is_some_and(|word| is_other(word) || is_open(word) || word.starts_with("polygon"));
                    let place = if is_kind { &mut about.kind } else { &mut about.name };
                    *place = word.or(place.take());
                }
                Key::Attributes => about.name = map.next_value_seed(FirstWord)?.or(about.name),
                Key::Class => about.class = map.next_value_seed(Word)?.and_then(|class| class.parse().ok()),
                Key::Classes => map.next_value_seed(Classes { known })?,
                Key::Width => about.width = map.next_value_seed(Word)?.and_then(|size| size.parse().ok()),
                Key::Height => about.height = map.next_value_seed(Word)?.and_then(|size| size.parse().ok()),
                Key::Mask => {
                    self.known.masks += 1;
                    map.next_value::<IgnoredAny>()?;
                }
                Key::Other => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        if let (true, [x], [y]) = (self.points, &about.xs[..], &about.ys[..]) {
            return Ok(Item::Position(DVec2::new(*x, *y)));
        }
        about.settle(&mut own, self.known);
        self.found.absorb(own);
        Ok(Item::Other)
    }
}

/// What an object says of the outlines in it.
#[derive(Default)]
struct About {
    name: Option<String>,
    kind: Option<String>,
    class: Option<i64>,
    xs: Vec<f64>,
    ys: Vec<f64>,
    width: Option<f64>,
    height: Option<f64>,
}

impl About {
    fn settle(self, own: &mut Found, known: &mut Known) {
        let kind = self.kind.unwrap_or_default().to_ascii_lowercase();
        if self.xs.len() == self.ys.len() && self.xs.len() >= FEWEST_CORNERS {
            let mut line = Line::default();
            self.xs.iter().zip(&self.ys).for_each(|(&x, &y)| line.push(DVec2::new(x, y)));
            let closed = line.returns();
            own.take(&line, closed);
        }
        if is_other(&kind) {
            known.others += 1;
            *own = Found::default();
            return;
        }
        if !is_open(&kind) {
            own.gathered.close();
        }
        // Label Studio counts in hundredths of the picture.
        if let (Some(width), Some(height)) = (self.width, self.height) {
            own.gathered.change(|p| 0.01 * p * DVec2::new(width, height));
        }
        for kept in &mut own.gathered.kept {
            kept.label.closed = true;
            kept.label.class = kept.label.class.or(self.class);
            if kept.label.name.is_none() {
                kept.label.name.clone_from(&self.name);
            }
        }
    }
}

/// A number, a list of numbers, or an object of numbers, as tables become JSON.
struct Numbers<'a> {
    list: &'a mut Vec<f64>,
}

impl<'de> DeserializeSeed<'de> for Numbers<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<(), D::Error> {
        from.deserialize_any(self)
    }
}

impl Numbers<'_> {
    fn push(self, value: f64) {
        if self.list.len() < MAX_KEPT && value.abs() <= 1e100 {
            self.list.push(value);
        }
    }
}

impl<'de> Visitor<'de> for Numbers<'_> {
    type Value = ();

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("numbers")
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_bool<E>(self, _: bool) -> Result<(), E> {
        Ok(())
    }

    fn visit_str<E>(self, _: &str) -> Result<(), E> {
        Ok(())
    }

    fn visit_f64<E>(self, value: f64) -> Result<(), E> {
        self.push(value);
        Ok(())
    }

    fn visit_i64<E>(self, value: i64) -> Result<(), E> {
        self.push(value as f64);
        Ok(())
    }

    fn visit_u64<E>(self, value: u64) -> Result<(), E> {
        self.push(value as f64);
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        while seq.next_element_seed(Numbers { list: &mut *self.list })?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while map.next_key::<IgnoredAny>()?.is_some() {
            map.next_value_seed(Numbers { list: &mut *self.list })?;
        }
        Ok(())
    }
}

/// The first word in an object, whatever its key.
struct FirstWord;

impl<'de> DeserializeSeed<'de> for FirstWord {
    type Value = Option<String>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Option<String>, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for FirstWord {
    type Value = Option<String>;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("attributes")
    }

    fn visit_unit<E>(self) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Option<String>, A::Error> {
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Option<String>, A::Error> {
        let mut first: Option<String> = None;
        while map.next_key::<IgnoredAny>()?.is_some() {
            let word = map.next_value_seed(Word)?;
            first = first.or(word.filter(|word| !word.is_empty()));
        }
        Ok(first)
    }
}

/// The names of classes, by their numbers.
struct Classes<'a> {
    known: &'a mut Known,
}

impl<'de> DeserializeSeed<'de> for Classes<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<(), D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Classes<'_> {
    type Value = ();

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("classes")
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_str<E>(self, _: &str) -> Result<(), E> {
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        while seq.next_element_seed(Classes { known: &mut *self.known })?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let (mut id, mut name) = (None, None);
        while let Some(key) = map.next_key_seed(Word)? {
            let value = map.next_value_seed(Word)?;
            match key.as_deref() {
                Some("id") => id = value.and_then(|value| value.parse().ok()),
                Some("name") => name = value,
                _ => {}
            }
        }
        if let (Some(id), Some(name), true) = (id, name, self.known.classes.len() < MAX_CLASSES) {
            self.known.classes.push((id, name));
        }
        Ok(())
    }
}
