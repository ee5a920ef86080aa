//! The transforms of a flame, gathered as they are read.

use frond_core::{Affine2, MAX_MAPS};
use quick_xml::escape::unescape;
use quick_xml::events::BytesStart;
use quick_xml::events::attributes::Attributes;

use super::palette::Palette;
use crate::read::problem::ImportError;
use crate::system::{Row, System};
use crate::text::{name_or, number, short};

/// The function that is affine, under all its names.
const LINEAR: [&str; 3] = ["linear", "linear3D", "linear2D"];
/// What moves only a third coordinate, or nothing at all.
const STILL: [&str; 6] = ["flatten", "zscale", "ztranslate", "pre_zscale", "pre_ztranslate", "flatten3D"];
/// What a transform says besides its functions.
const OTHER: [&str; 22] = [
    "weight",
    "color",
    "color_speed",
    "symmetry",
    "animate",
    "opacity",
    "coefs",
    "post",
    "chaos",
    "name",
    "plotmode",
    "var",
    "var1",
    "var_color",
    "index",
    "motion_frequency",
    "motion_function",
    "coefs_angle",
    "post_angle",
    "mutation_weight",
    "material",
    "material_speed",
];
/// No function has a longer name, and no transform more of them.
const MAX_KEY: usize = 100;
const MAX_KEYS: usize = 200;
/// Names of functions that a remark tells.
const MOST_TOLD: usize = 5;

/// What a flame says where Frond wrote it.
pub const OWN_VERSION: &str = "Frond";

/// A flame that is being read.
#[derive(Default)]
pub struct Flame {
    name: String,
    line: usize,
    /// Whether Frond wrote it.
    own: bool,
    /// Whether the file ends before it does.
    pub cut: bool,
    /// Layers that have begun.
    pub layers: usize,
    maps: Vec<Row>,
    weights: Vec<Option<f64>>,
    /// Where each is on the palette.
    places: Vec<f64>,
    pub palette: Palette,
    /// Transforms there are, those without a linear part or a weight, and those with more than it.
    pub count: usize,
    bent: usize,
    unused: usize,
    partly: usize,
    functions: Vec<String>,
    left: Vec<&'static str>,
    wrong: Option<(usize, String)>,
}

impl Flame {
    pub fn new(tag: &BytesStart<'_>, line: usize) -> Self {
        let mut flame = Self { line, ..Self::default() };
        for (key, value) in attributes(tag) {
            match key {
                "name" => {
                    flame.name =
                        unescape(value).map_or_else(|_| name_or(value, ""), |name| name_or(&name, ""));
                }
                "version" => flame.own = value == OWN_VERSION,
                "palette" => flame.palette.named = true,
                _ => {}
            }
        }
        flame
    }

    /// The next of its layers.
    pub fn layer(&self, line: usize) -> Self {
        Self { name: self.name.clone(), own: self.own, layers: self.layers + 1, line, ..Self::default() }
    }

    fn leave(&mut self, what: &'static str) {
        if !self.left.contains(&what) {
            self.left.push(what);
        }
    }

    pub fn take(&mut self, tag: &BytesStart<'_>, line: impl FnOnce() -> usize) {
        match tag.name().as_ref().to_ascii_lowercase().as_str() {
            "xform" => {
                self.count += 1;
                if self.wrong.is_none() && self.maps.len() <= MAX_MAPS {
                    self.wrong = self.transform(tag).err().map(|why| (line(), why));
                }
            }
            "finalxform" => self.leave("its final transform"),
            "bgxform" => self.leave("its background"),
            "color" | "colors" | "palette" => self.palette.take(tag.name().as_ref(), attributes(tag)),
            "gradient" => self.palette.named = true,
            "symmetry" => self.leave("its symmetry"),
            _ => {}
        }
    }

    fn transform(&mut self, tag: &BytesStart<'_>) -> Result<(), String> {
        // What cannot be read as an attribute may have been the numbers.
        if all_attributes(tag).any(|one| one.is_err()) {
            return Err(format!("<{}> is miswritten: each number needs its quotes.", short(tag, 60)));
        }
        let (mut coefs, mut post, mut weight) = (None, None, None);
        // Where none is said, flam3 goes from end to end.
        let mut place = ((self.count - 1) % 2) as f64;
        let (mut linear, mut functions, mut named, mut any) = (0.0, Vec::new(), Vec::new(), false);
        for (key, value) in attributes(tag) {
            let one = || {
                number(value.trim()).ok_or_else(|| format!("{key}=\"{}\" is no number.", short(value, 40)))
            };
            match key {
                "coefs" => coefs = Some(columns(key, value)?),
                "post" => post = Some(columns(key, value)?),
                "weight" => weight = Some(one()?),
                "color" => place = number(value.trim()).unwrap_or(place),
                // Ones say nothing.
                "chaos" if value.split_ascii_whitespace().all(|word| number(word) == Some(1.0)) => {}
                "chaos" => self.leave("which transform may follow which (xaos)"),
                // Of old: the weights of all functions in their order, or the number of one.
                "var" => {
                    any = true;
                    let mut list = value.split_ascii_whitespace().map(number);
                    linear += list.next().flatten().unwrap_or(0.0);
                    functions.extend(list.flatten().any(|x| x != 0.0).then_some("others"));
                }
                "var1" => {
                    any = true;
                    if number(value.trim()) == Some(0.0) { linear += 1.0 } else { functions.push("others") }
                }
                _ if LINEAR.contains(&key) => {
                    any = true;
                    linear += one()?;
                }
                _ if OTHER.contains(&key) || STILL.contains(&key) || of_jwildfire(key) => {}
                _ => {
                    // Infinity and what is no number weigh something, too.
                    if let Ok(x) = value.trim().parse::<f64>() {
                        any = true;
                        if key.len() > MAX_KEY {
                            functions.push("others");
                        } else if named.len() < MAX_KEYS {
                            named.push(key);
                            functions.extend((x != 0.0).then_some(key));
                        }
                    }
                }
            }
        }
        // Where nothing is said, a transform is affine.
        if !any {
            linear = 1.0;
        }
        // The settings of a function begin with its name, and stand there where it weighs nothing, too.
        let setting = |key: &str| key.match_indices('_').any(|(at, _)| named.contains(&&key[..at]));
        functions.retain(|key| !setting(key));
        for name in &functions {
            if self.functions.len() <= MOST_TOLD && !self.functions.iter().any(|known| known == name) {
                self.functions.push(short(name, 24));
            }
        }
        if weight == Some(0.0) && !self.own {
            self.unused += 1;
            return Ok(());
        }
        if linear == 0.0 {
            self.bent += 1;
            return Ok(());
        }
        self.partly += usize::from(!functions.is_empty());
        let mut map = coefs.unwrap_or(Affine2::IDENTITY);
        if linear != 1.0 {
            map = Affine2::from_row(map.to_row().map(|x| linear * x));
        }
        if let Some(post) = post.filter(|post| *post != Affine2::IDENTITY) {
            map = post * map;
        }
        let row = turned_over(map.to_row());
        if !row.iter().all(|x| x.is_finite()) {
            return Err(format!(
                "Numbers of transform {} are too large: coefs, post and the weight of linear give no finite map.",
                self.count
            ));
        }
        self.maps.push(row);
        self.weights.push(weight);
        self.places.push(place);
        Ok(())
    }

    pub fn finish(self) -> Result<System, ImportError> {
        let Self {
            name,
            layers,
            maps,
            weights,
            places,
            palette,
            count,
            bent,
            unused,
            partly,
            functions,
            mut left,
            wrong,
            line,
            cut,
            ..
        } = self;
        let name = if layers > 1 { name_or(&format!("{name} layer {layers}"), "") } else { name };
        let whose = if name.is_empty() { "The flame".to_owned() } else { format!("“{name}”") };
        let fail = |code, line, why| Err(ImportError::At { code, line, why });
        if let Some((line, why)) = wrong {
            return fail("flame-number", line, format!("{why} Mend it, or leave the transform out."));
        }
        if maps.len() > MAX_MAPS {
            let why = format!("{whose} has more than 64 transforms, and the most is 64. Leave some out.");
            return fail("flame-maps", line, why);
        }
        let told = if functions.len() > MOST_TOLD {
            format!("{} ..", functions[..MOST_TOLD].join(", "))
        } else {
            functions.join(", ")
        };
        if maps.is_empty() {
            let have = if bent == 1 { "one has".into() } else { format!("{bent} have") };
            let whom = if name.is_empty() { "the flame" } else { &whose };
            let why = match (count, bent) {
                (0, _) => format!("{whose} has no transform. Choose another, or give it one with coefs."),
                (_, 0) => format!(
                    "None of the {count} transforms of {whom} is ever chosen: each has the weight 0. Give them weights."
                ),
                _ if unused > 0 => format!(
                    "Of the {count} transforms of {whom}, {have} no linear part ({told}) and the others the weight \
                     0, so that nothing is left. Give weights to those that are linear."
                ),
                _ => format!(
                    "None of the {count} transforms of {whom} has a linear part ({told}), so that nothing of it is \
                     affine. Choose a flame with linear=\"1\" in it."
                ),
            };
            return fail("flame-not-affine", line, why);
        }
        let mut system = System::plane(name, maps);
        if cut {
            system
                .remarks
                .push("The file ends before its flame does: there may have been more in it.".into());
        }
        if bent > 0 {
            let kept = system.maps.len();
            let which = if bent == 1 { "One has".into() } else { format!("{bent} have") };
            system
                .remarks
                .push(format!("{kept} of {count} transforms are kept. {which} no linear part ({told})."));
        }
        if partly > 0 {
            let which = if partly == 1 { "one transform".into() } else { format!("{partly} transforms") };
            system
                .remarks
                .push(format!("Of {which} only the linear part is kept, not what is added to it ({told})."));
        }
        if unused > 0 {
            let which =
                if unused == 1 { "One transform has".into() } else { format!("{unused} transforms have") };
            system.remarks.push(format!("{which} the weight 0: left out."));
        }
        system.colours = palette.colours(&places);
        if system.colours.is_empty() && palette.named {
            left.push("its palette, whose colours do not stand in the file");
        }
        if !left.is_empty() {
            system.remarks.push(format!("Left out: {}.", left.join("; ")));
        }
        system.take_weights(&weights);
        Ok(system)
    }
}

/// What JWildfire says of a transform's light, and of the order of its functions.
fn of_jwildfire(key: &str) -> bool {
    key.starts_with("mod_") || key.ends_with("_fx_priority")
}

/// The map whose six numbers stand in columns; y still points down.
fn columns(key: &str, text: &str) -> Result<Affine2, String> {
    let mut row = [0.0; 6];
    let mut words = text.split_ascii_whitespace();
    // a d b e c f, to rows.
    for k in [0, 2, 1, 3, 4, 5] {
        let word = words.next().unwrap_or_default();
        row[k] = number(word).ok_or_else(|| format!("{key}=\"{}\" is not six numbers.", short(text, 60)))?;
    }
    match words.next() {
        None => Ok(Affine2::from_row(row)),
        Some(_) => Err(format!("{key}=\"{}\" is more than six numbers.", short(text, 60))),
    }
}

/// The same map where y points the other way. Zeros keep their sign, which means nothing and would be written.
pub fn turned_over([a, b, c, d, e, f]: Row) -> Row {
    let negative = |x: f64| if x == 0.0 { x } else { -x };
    [a, negative(b), negative(c), d, e, negative(f)]
}

/// The attributes of a tag, those that are miswritten among them. That none comes twice is not asked, which would take
/// the square of their number.
fn all_attributes<'a>(tag: &'a BytesStart<'_>) -> Attributes<'a> {
    let text: &str = tag;
    let mut all = Attributes::new(text, tag.name().as_ref().len());
    all.with_checks(false);
    all
}

/// Their names and values, as they are written.
fn attributes<'a>(tag: &'a BytesStart<'_>) -> impl Iterator<Item = (&'a str, &'a str)> {
    all_attributes(tag).flatten().filter_map(|attribute| match attribute.value {
        std::borrow::Cow::Borrowed(value) => Some((attribute.key.into_inner(), value)),
        std::borrow::Cow::Owned(_) => None,
    })
}
