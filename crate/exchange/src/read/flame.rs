//! `.flame` files of flam3, Apophysis, JWildfire and others: XML, a `flame` with an `xform` for each transform; in
//! JWildfire also a `jwf-flame` of several `layer`s, each of which is read as a system.
//!
//! A transform is an affine map, `coefs`, a sum of functions of the plane ("variations"), each with its weight, and
//! perhaps a second affine map, `post`. Of the functions only `linear` is affine: with its weight it is read, with all
//! others it is not. Numbers stand in columns, `a d b e c f` for x' = a x + b y + c and y' = d x + e y + f, and y
//! points down. `color` says where on the flame's palette a transform is: the colour there is kept.
//!
//! A transform of weight 0 is never chosen, and no part of the picture that other programs draw: it is left out, but
//! from flames that Frond wrote, whose shape has all maps.

use frond_core::{Affine2, MAX_MAPS};
use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::attributes::Attributes;
use quick_xml::events::{BytesStart, Event};

use super::flame_palette::Palette;
use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::system::{Row, System};
use crate::text::{Lines, name_or, number, short};

/// What a flame is called.
const FLAMES: [&str; 2] = ["flame", "jwf-flame"];
/// The tags by which a file with flames is known.
pub const SIGNS: [&str; 3] = ["flame", "flames", "jwf-flame"];
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
/// What a flame says where Frond wrote it.
pub const OWN_VERSION: &str = "Frond";
/// No function has a longer name, and no transform more of them.
const MAX_KEY: usize = 100;
const MAX_KEYS: usize = 200;
/// Names of functions that a remark tells.
const MOST_TOLD: usize = 5;

/// Reads the linear part of each flame.
pub fn read_flames(text: &str) -> Result<Gathered, ImportError> {
    let mut reader = Reader::from_str(text);
    // What stands between tags is not looked at.
    reader.config_mut().allow_dangling_amp = true;
    let mut lines = Lines::of(text);
    let (mut all, mut open, mut count): (Gathered, Option<Flame>, usize) = (Gathered::default(), None, 0);
    let mut finish = |flame: Flame| {
        count += 1;
        if count <= MAX_SYSTEMS {
            all.take(flame.finish());
        }
    };
    loop {
        // Where a tag begins.
        let at = reader.buffer_position();
        let event = reader.read_event().map_err(|error| ImportError::At {
            code: "flame-broken",
            line: lines.line(reader.error_position()),
            why: format!(
                "The XML breaks off or is miswritten there ({}). Save it again.",
                short(&error.to_string(), 100)
            ),
        })?;
        match event {
            Event::Start(tag) if is_flame(tag.name().as_ref()) => {
                if let Some(flame) = open.replace(Flame::new(&tag, lines.line(at))) {
                    finish(flame);
                }
            }
            Event::Empty(tag) if is_flame(tag.name().as_ref()) => finish(Flame::new(&tag, lines.line(at))),
            Event::Start(tag) if is_layer(tag.name().as_ref()) => {
                if let Some(flame) = open.take() {
                    open = Some(flame.layer(lines.line(at)));
                    if flame.layers > 0 || flame.count > 0 {
                        finish(flame);
                    }
                }
            }
            Event::Start(tag) | Event::Empty(tag) => {
                if let Some(flame) = &mut open {
                    flame.palette.end();
                    flame.take(&tag, || lines.line(at));
                }
            }
            Event::Text(text) => {
                if let Some(flame) = &mut open {
                    flame.palette.take_text(&text);
                }
            }
            Event::End(tag) if is_flame(tag.name().as_ref()) => {
                if let Some(flame) = open.take() {
                    finish(flame);
                }
            }
            Event::End(_) => {
                if let Some(flame) = &mut open {
                    flame.palette.end();
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    if let Some(flame) = open {
        finish(Flame { cut: true, ..flame });
    }
    if count > MAX_SYSTEMS {
        all.remarks.push(format!("The file has {count} flames: the first {MAX_SYSTEMS} are looked at."));
    }
    all.finish(ImportError::Within {
        code: "flame-nothing",
        why: "There is no flame in this file. One looks so: <flame name=\"..\"><xform weight=\"1\" linear=\"1\" coefs=\"..\"/></flame>."
            .into(),
    })
}

/// Some programs write it with a capital letter.
fn is_flame(tag: &str) -> bool {
    FLAMES.iter().any(|name| tag.eq_ignore_ascii_case(name))
}

fn is_layer(tag: &str) -> bool {
    tag.eq_ignore_ascii_case("layer")
}

/// A flame that is being read.
#[derive(Default)]
struct Flame {
    name: String,
    line: usize,
    /// Whether Frond wrote it.
    own: bool,
    /// Whether the file ends before it does.
    cut: bool,
    /// Layers that have begun.
    layers: usize,
    maps: Vec<Row>,
    weights: Vec<Option<f64>>,
    /// Where each is on the palette.
    places: Vec<f64>,
    palette: Palette,
    /// Transforms there are, those without a linear part or a weight, and those with more than it.
    count: usize,
    bent: usize,
    unused: usize,
    partly: usize,
    functions: Vec<String>,
    left: Vec<&'static str>,
    wrong: Option<(usize, String)>,
}

impl Flame {
    fn new(tag: &BytesStart<'_>, line: usize) -> Self {
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
    fn layer(&self, line: usize) -> Self {
        Self { name: self.name.clone(), own: self.own, layers: self.layers + 1, line, ..Self::default() }
    }

    fn leave(&mut self, what: &'static str) {
        if !self.left.contains(&what) {
            self.left.push(what);
        }
    }

    fn take(&mut self, tag: &BytesStart<'_>, line: impl FnOnce() -> usize) {
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
                    if let Some(x) = number(value.trim()) {
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
        self.maps.push(turned_over(map.to_row()));
        self.weights.push(weight);
        self.places.push(place);
        Ok(())
    }

    fn finish(self) -> Result<System, ImportError> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::Maps;

    fn flames(text: &str) -> Vec<System> {
        read_flames(text).unwrap().systems
    }

    fn told(text: &str) -> String {
        read_flames(text).map(|_| ()).unwrap_err().to_string()
    }

    const FILE: &str = "<?xml version='1.0'?>
        <Flames name='pack'>
        <flame name='A &amp; B' size='10 10' palette='3'>
          <xform weight='0.5' color='0' linear='1' coefs='1 2 3 4 5 6'/>
          <xform weight='2' linear3D='0.5' coefs='1 0 0 1 2 4' post='0 1 -1 0 1 0'/>
        </flame>
        <flame>
          <xform weight='-1' linear='1' julian='0.25' julian_power='2' julian_dist='1' coefs='.5 0 0 .5 0 0'/>
          <xform weight='1' spherical='1' coefs='.5 0 0 .5 0 0'/>
          <xform weight='0' linear='1' coefs='.5 0 0 .5 0 0'/>
          <finalxform linear='1' coefs='1 0 0 1 0 0'/>
          <color index='0' rgb='1 2 3'/>
        </flame>
        </Flames>";

    #[test]
    fn columns_are_rows_and_y_points_up() {
        let [first, _] = &flames(FILE)[..] else { panic!() };
        assert_eq!(first.name, "A & B");
        let Maps::Plane(rows) = &first.maps else { panic!() };
        // x' = x + 3 y + 5, y' = 2 x + 4 y + 6 with y down.
        assert_eq!(rows[0], [1.0, -3.0, -2.0, 4.0, 5.0, -6.0]);
        // Halved, then turned by a quarter and moved by 1: x' = -(y + 4)/2 + 1, y' = (x + 2)/2 with y down.
        assert_eq!(rows[1], [0.0, 0.5, -0.5, 0.0, -1.0, -1.0]);
        assert_eq!(first.probabilities, [0.5, 2.0]);
        assert_eq!(first.remarks, ["Left out: its palette, whose colours do not stand in the file."]);
    }

    #[test]
    fn each_map_keeps_its_colour() {
        let xform = |color: &str| format!("<xform {color} coefs='.5 0 0 .5 0 0'/>");
        let palette = "<palette count='4' format='RGB'>\n  FF0000 00FF00\n  0000FF 101112 </palette>";
        let flame = |list: &[&str]| {
            let xforms: String = list.iter().map(|color| xform(color)).collect();
            flames(&format!("<flame>{xforms}<finalxform color='1'/>{palette}<edit>by Ada</edit></flame>"))
                .remove(0)
        };
        let found = flame(&["color='0.34'", "color='1'", "color='0'"]);
        assert_eq!(found.colours, [[0, 255, 0], [16, 17, 18], [255, 0, 0]]);
        // As flam3 does, from end to end.
        assert_eq!(flame(&["", "", ""]).colours, [[255, 0, 0], [16, 17, 18], [255, 0, 0]]);
    }

    #[test]
    fn what_changes_nothing_is_not_said_to_be_left_out() {
        let remarks = |chaos: &str| {
            flames(&format!("<flame><xform chaos='{chaos}' coefs='.5 0 0 .5 0 0'/></flame>"))
                .remove(0)
                .remarks
        };
        assert_eq!(remarks("1 1.0 1 "), [""; 0]);
        assert_eq!(remarks("1 0.5"), ["Left out: which transform may follow which (xaos)."]);
    }

    #[test]
    fn layers_are_systems() {
        let layer = |x: u8| {
            format!(
                "<layer weight='1'><xform linear3D='1' linear3D_fx_priority='-1' mod_gamma='0.5' material='2' coefs='.5 0 0 .5 {x} 0'/></layer>"
            )
        };
        let head = "<flames><jwf-flame name='Deep'>";
        let found = flames(&format!("{head}{}{}</jwf-flame>{}</flames>", layer(1), layer(2), "<flame/>"));
        let names: Vec<&str> = found.iter().map(|system| &*system.name).collect();
        assert_eq!(names, ["Deep", "Deep layer 2"]);
        for (system, x) in found.iter().zip([1.0, 2.0]) {
            assert_eq!(system.maps, Maps::Plane(vec![[0.5, 0.0, 0.0, 0.5, x, 0.0]]));
            assert_eq!(system.remarks, [""; 0]);
        }
    }

    #[test]
    fn capital_letters_make_no_other_tags() {
        let found = flames("<Flames><Flame name='A'><XForm coefs='.5 0 0 .5 0 0'/></Flame></Flames>");
        assert_eq!((found.len(), found[0].maps.len()), (1, 1));
    }

    #[test]
    fn what_is_not_affine_is_counted_and_said() {
        let [_, second] = &flames(FILE)[..] else { panic!() };
        assert_eq!(second.maps.len(), 1);
        assert_eq!(
            second.remarks,
            [
                "1 of 3 transforms are kept. One has no linear part (julian, spherical).",
                "Of one transform only the linear part is kept, not what is added to it (julian, spherical).",
                "One transform has the weight 0: left out.",
                "Left out: its final transform.",
                "One weight is negative: taken without the sign.",
            ]
        );
    }

    #[test]
    fn what_is_never_chosen_is_left_out_of_flames_of_others() {
        let xform =
            |weight: u8, kind: &str| format!("<xform weight='{weight}' {kind}='1' coefs='.5 0 0 .5 0 0'/>");
        let flame = |by: &str, list: &[String]| format!("<flame version='{by}'>{}</flame>", list.concat());
        let both = [xform(0, "linear"), xform(2, "linear")];
        let [own, other] = ["Frond", "Apophysis 7X"].map(|by| flames(&flame(by, &both)).remove(0));
        assert_eq!((own.maps.len(), own.remarks.len(), &own.probabilities[..]), (2, 0, &[0.0, 2.0][..]));
        assert_eq!(
            (other.maps.len(), &*other.remarks),
            (1, &["One transform has the weight 0: left out.".into()][..])
        );
        for (list, why) in [
            (vec![], "The flame has no transform."),
            (vec![xform(0, "linear")], "None of the 1 transforms of the flame is ever chosen"),
            (
                vec![xform(0, "linear"), xform(1, "swirl")],
                "Of the 2 transforms of the flame, one has no linear part",
            ),
            (vec![xform(1, "swirl")], "None of the 1 transforms of the flame has a linear part (swirl)"),
        ] {
            let told = told(&flame("", &list));
            assert!(told.starts_with(&format!("Line 1: {why}")), "{told}");
        }
    }

    #[test]
    fn settings_of_functions_are_none_themselves() {
        let xform = "linear='1' julian='0' julian_power='2' pre_blur='0' curl='0.1' curl_c1='3' coefs='.5 0 0 .5 0 0'";
        let found = flames(&format!("<flame><xform {xform}/></flame>"));
        assert_eq!(
            found[0].remarks,
            ["Of one transform only the linear part is kept, not what is added to it (curl)."]
        );
    }

    #[test]
    fn transforms_of_old_are_read() {
        let old = |more: &str| format!("<flame><xform {more} coefs='.5 0 0 .5 1 0'/></flame>");
        for linear in ["", "var='1 0 0'", "var1='0'", "linear='1'"] {
            let Maps::Plane(rows) = &flames(&old(linear))[0].maps else { panic!() };
            assert_eq!(rows[0], [0.5, 0.0, 0.0, 0.5, 1.0, 0.0], "{linear}");
        }
        for bent in ["var='0 1 0'", "var1='2'", "swirl='1'", "linear='0'"] {
            assert!(told(&old(bent)).starts_with("Line 1: None of the 1 transforms"), "{bent}");
        }
    }

    #[test]
    fn mistakes_are_named_with_their_line() {
        assert!(
            told("<flame>\n<xform coefs='1 2 3'/></flame>")
                .starts_with("Line 2: coefs=\"1 2 3\" is not six numbers.")
        );
        assert!(
            told("<flame>\n\n<xform weight='x' coefs='1 2 3 4 5 6'/></flame>")
                .starts_with("Line 3: weight=\"x\" is no number.")
        );
        // A number without its quotes is not passed over, as if the map stayed where it is.
        for wrong in ["coefs=.5", "coefs='.5 0 0 .5 0 0' weight=2", "coefs"] {
            let told = told(&format!("<flame>\n<xform {wrong}/></flame>"));
            assert!(told.starts_with("Line 2: <xform coefs") && told.contains("quotes"), "{told}");
        }
        // The line where a tag begins.
        assert!(told("<flame>\n<xform\n coefs='1 2 3'\n/></flame>").starts_with("Line 2: coefs"));
        assert!(
            told("<a>\n</a>\n<flame\n name='a'>\n<x/></flame>").starts_with("Line 3: “a” has no transform.")
        );
        assert!(told("<flame name='a'></flame>").starts_with("Line 1: “a” has no transform."));
        assert!(told("<flames></flames>").starts_with("There is no flame"));
        assert!(told("<flame>\n</flames>").starts_with("Line 2: The XML breaks off"));
        let many = format!("<flame>{}</flame>", "<xform coefs='.1 0 0 .1 0 0'/>".repeat(65));
        assert!(told(&many).contains("more than 64 transforms"));
    }
}
