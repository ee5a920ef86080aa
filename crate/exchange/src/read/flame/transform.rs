//! One transform of a flame: what it says, in its attributes and in groups of functions within it.

use frond_core::Affine2;
use quick_xml::events::BytesStart;

use super::attributes::attributes;
use super::depth::{Depth, Planes, Six, Solid};
use super::numbers::Numbers;
use crate::system::Row;
use crate::text::short;

/// The function that is affine, under all its names; the second takes z along.
const LINEAR: [&str; 3] = ["linear", "linear3D", "linear2D"];
/// What moves z only, or nothing at all.
const OF_DEPTH: [&str; 7] =
    ["flatten", "flatten3D", "zscale", "ztranslate", "pre_zscale", "pre_ztranslate", "post_flatten"];
/// What says nothing of where points are.
const OF_LIGHT: [&str; 17] = [
    "color_speed",
    "symmetry",
    "animate",
    "name",
    "var_color",
    "index",
    "motion_frequency",
    "motion_function",
    "coefs_angle",
    "post_angle",
    "mutation_weight",
    "material",
    "material_speed",
    "color_type",
    "targetcolor",
    "target_color",
    "mirror_pre_post_translations",
];
/// What a group of functions says of itself.
const OF_GROUP: [&str; 3] = ["normal", "pre", "post"];
/// No function has a longer name, and no transform more of them.
const MAX_KEY: usize = 100;
const MAX_KEYS: usize = 200;

/// A transform that is being read.
pub struct Transform {
    pub line: usize,
    /// Its number in the flame, from 1.
    pub number: usize,
    pub weight: Option<f64>,
    /// Where it is on the palette.
    pub place: f64,
    before: Planes,
    after: Planes,
    depth: Depth,
    pub linear: f64,
    /// Whether any function is named.
    any: bool,
    named: Vec<String>,
    functions: Vec<String>,
    others: bool,
    /// Whether its points are not drawn.
    pub hidden: bool,
    /// Whether it takes part at all.
    pub off: bool,
    /// What it has that is not read, as a remark tells it.
    pub left: Vec<&'static str>,
    pub unknown: Vec<String>,
}

impl Transform {
    /// What the tag says.
    pub fn new(
        tag: &BytesStart<'_>,
        number: usize,
        line: usize,
        numbers: &mut Numbers,
    ) -> Result<Self, String> {
        let mut new = Self {
            line,
            number,
            weight: None,
            // Where none is said, flam3 goes from end to end.
            place: ((number - 1) % 2) as f64,
            before: Planes::default(),
            after: Planes::default(),
            depth: Depth::default(),
            linear: 0.0,
            any: false,
            named: Vec::new(),
            functions: Vec::new(),
            others: false,
            hidden: false,
            off: false,
            left: Vec::new(),
            unknown: Vec::new(),
        };
        for (key, value) in attributes(tag) {
            new.attribute(key, value, numbers)?;
        }
        Ok(new)
    }

    /// A group of functions within it, each with its settings, as JWildfire writes them for its renderers.
    pub fn group(&mut self, tag: &BytesStart<'_>, numbers: &mut Numbers) -> Result<(), String> {
        // A transform that lists its functions has no others.
        self.any = true;
        attributes(tag)
            .filter(|(key, _)| !OF_GROUP.contains(key))
            .try_for_each(|(key, value)| self.function(key, value, numbers))
    }

    fn attribute(&mut self, key: &str, value: &str, numbers: &mut Numbers) -> Result<(), String> {
        let mut six = || numbers.six(key, value).map(Some);
        match key {
            "coefs" => self.before.xy = six()?,
            "yzCoefs" => self.before.yz = six()?,
            "zxCoefs" => self.before.zx = six()?,
            "post" => self.after.xy = six()?,
            "yzPost" => self.after.yz = six()?,
            "zxPost" => self.after.zx = six()?,
            "weight" => self.weight = Some(single(key, value, numbers)?),
            "color" => self.place = numbers.one(value).unwrap_or(self.place),
            "opacity" => self.hidden |= numbers.one(value).is_some_and(|opacity| opacity < 1e-9),
            "plotmode" => self.hidden |= value.trim().eq_ignore_ascii_case("off"),
            "visible" => self.hidden |= says_no(value),
            "enabled" => self.off |= says_no(value),
            // Ones say nothing.
            "chaos" if value.split_whitespace().all(|word| numbers.one(word) == Some(1.0)) => {}
            "chaos" => self.left.push("which transform may follow which (xaos)"),
            // Of old: the weights of all functions in their order, or the number of one.
            "var" => {
                self.any = true;
                let mut list = value.split_whitespace().map(|word| numbers.one(word));
                self.linear_with(list.next().flatten().unwrap_or(0.0), false);
                self.others |= list.flatten().any(|x| x != 0.0);
            }
            "var1" => {
                self.any = true;
                if numbers.one(value) == Some(0.0) {
                    self.linear_with(1.0, false);
                } else {
                    self.others = true;
                }
            }
            "wfield_type" if !matches!(value.trim(), "NONE" | "0" | "") => {
                self.left.push("its weighting fields, by which functions weigh more in some places");
            }
            _ if OF_LIGHT.contains(&key) || of_jwildfire(key) => {}
            _ if is_curve(key) => {
                if key.ends_with("_enabled") && value.trim().eq_ignore_ascii_case("true") {
                    self.left.push("its motion");
                }
            }
            _ => self.function(key, value, numbers)?,
        }
        Ok(())
    }

    fn function(&mut self, key: &str, value: &str, numbers: &mut Numbers) -> Result<(), String> {
        if of_jwildfire(key) || is_curve(key) {
            return Ok(());
        }
        let name = bare(key);
        let name = &*name;
        if LINEAR.contains(&name) {
            self.any = true;
            self.linear_with(single(key, value, numbers)?, name == "linear3D");
        } else if OF_DEPTH.contains(&name) {
            self.of_depth(name, single(key, value, numbers)?);
        } else if let Some(x) = numbers.one(value).or_else(|| value.trim().parse::<f64>().ok()) {
            // Infinity and what is no number weigh something, too.
            self.any = true;
            if name.len() > MAX_KEY {
                self.others = true;
            } else if self.named.len() < MAX_KEYS {
                self.named.push(name.to_owned());
                self.functions.extend((x != 0.0).then(|| name.to_owned()));
            }
        } else if self.unknown.len() < MAX_KEYS {
            self.unknown.push(short(name, MAX_KEY));
        }
        Ok(())
    }

    fn linear_with(&mut self, weight: f64, deep: bool) {
        self.linear += weight;
        if deep { self.depth.always += weight } else { self.depth.kept += weight }
    }

    fn of_depth(&mut self, name: &str, amount: f64) {
        let Depth { before: [scale, shift], always, shift: after, flat, .. } = &mut self.depth;
        match name {
            "zscale" => *always += amount,
            "ztranslate" => *after += amount,
            "pre_zscale" => (*scale, *shift) = (*scale * amount, *shift * amount),
            "pre_ztranslate" => *shift += amount,
            _ => *flat |= amount != 0.0,
        }
        // What only raises a point is a function, too: x and y are none of it.
        self.any |= amount != 0.0 && !name.starts_with("pre_");
    }

    /// Whether a key is a setting of a function that is named: it begins with its name, and stands there where the
    /// function weighs nothing, too.
    fn is_setting(&self, key: &str) -> bool {
        key.match_indices('_').any(|(at, _)| self.named.iter().any(|name| *name == key[..at]))
    }

    /// Once all is read: the functions that it has besides `linear`.
    pub fn close(&mut self) -> Vec<String> {
        // Where nothing is said, a transform is affine.
        if !self.any {
            self.linear_with(1.0, false);
        }
        let mut functions = std::mem::take(&mut self.functions);
        functions.retain(|key| !self.is_setting(key));
        functions.extend(self.others.then(|| "others".to_owned()));
        let unknown = std::mem::take(&mut self.unknown);
        self.unknown = unknown.into_iter().filter(|key| !self.is_setting(key)).collect();
        functions
    }

    /// Whether it says anything of z besides what all do.
    pub fn is_deep(&self) -> bool {
        let Depth { before, shift, .. } = self.depth;
        self.before.is_deep() || self.after.is_deep() || before != [1.0, 0.0] || shift != 0.0
    }

    /// Whether it takes all points to one, whose height is said: affine, though `linear` weighs nothing.
    pub fn only_raises(&self) -> bool {
        self.linear == 0.0 && (self.depth.always != 0.0 || self.depth.shift != 0.0 || self.depth.flat)
    }

    /// What it does to space.
    pub const fn solid(&self) -> Solid {
        Solid { before: self.before, after: self.after, depth: self.depth, linear: self.linear }
    }

    /// What it does to x and y where nothing is said of z; y up.
    pub fn row(&self) -> Row {
        let affine = |six: Option<Six>| {
            // a d b e c f, to rows.
            six.map(|[a, d, b, e, c, f]| Affine2::from_row([a, b, d, e, c, f]))
        };
        let mut map = affine(self.before.xy).unwrap_or(Affine2::IDENTITY);
        if self.linear != 1.0 {
            map = Affine2::from_row(map.to_row().map(|x| self.linear * x));
        }
        if let Some(post) = affine(self.after.xy).filter(|post| *post != Affine2::IDENTITY) {
            map = post * map;
        }
        turned_over(map.to_row())
    }
}

fn single(key: &str, value: &str, numbers: &mut Numbers) -> Result<f64, String> {
    numbers.one(value).ok_or_else(|| format!("{key}=\"{}\" is no number.", short(value, 40)))
}

fn says_no(value: &str) -> bool {
    ["0", "false", "no", "off"].iter().any(|no| value.trim().eq_ignore_ascii_case(no))
}

/// What JWildfire says of a transform's light, of the order of its functions, and of fields that weigh them.
fn of_jwildfire(key: &str) -> bool {
    key.starts_with("mod_")
        || key.ends_with("_fx_priority")
        || key.starts_with("wfield_")
        || key.starts_with("antialias_")
}

/// What JWildfire says of how a number changes with time.
fn is_curve(key: &str) -> bool {
    key.contains("Curve_")
}

/// The name of a function without what JWildfire puts before it (`jwf_`, `jwf2_`) and the number of its instance
/// (`#2#`).
fn bare(key: &str) -> String {
    let name = key
        .strip_prefix("jwf")
        .and_then(|rest| rest.trim_start_matches(|c: char| c.is_ascii_digit()).strip_prefix('_'));
    let name = name.unwrap_or(key);
    match name.split_once('#').and_then(|(start, rest)| Some((start, rest.split_once('#')?.1))) {
        Some((start, end)) => format!("{start}{end}"),
        None => name.to_owned(),
    }
}

/// The same map where y points the other way. Zeros keep their sign, which means nothing and would be written.
pub fn turned_over([a, b, c, d, e, f]: Row) -> Row {
    let negative = |x: f64| if x == 0.0 { x } else { -x };
    [a, negative(b), negative(c), d, e, negative(f)]
}
