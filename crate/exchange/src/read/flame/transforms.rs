//! The transforms of a flame, gathered as they are read.

use frond_core::MAX_MAPS;
use quick_xml::escape::unescape;
use quick_xml::events::BytesStart;

use super::attributes::{all_attributes, attributes};
use super::depth::{Order, Solid, leaves_plane, mixes, of_plane};
use super::numbers::Numbers;
use super::palette::Palette;
use super::transform::Transform;
use crate::read::problem::ImportError;
use crate::system::{Maps, Row, Row3, System};
use crate::text::{name_or, short};

/// Names of functions, and of attributes, that a remark tells.
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
    /// Whether functions of the plane keep z.
    keeps_z: bool,
    /// The number of the only transform that is drawn, from 1.
    solo: Option<usize>,
    /// Whether the flame does not draw this layer.
    unseen: bool,
    /// Whether the file ends before it does.
    pub cut: bool,
    /// Layers that have begun.
    pub layers: usize,
    open: Option<Transform>,
    numbers: Numbers,
    maps: Vec<Row>,
    solids: Vec<Solid>,
    deep: bool,
    weights: Vec<Option<f64>>,
    /// Where each is on the palette.
    places: Vec<f64>,
    pub palette: Palette,
    /// Transforms there are, and of them those without a linear part, without a weight, switched off, with more than
    /// the linear part, and those that are kept though the flame does not draw their points.
    pub count: usize,
    bent: usize,
    unused: usize,
    off: usize,
    partly: usize,
    hidden: usize,
    functions: Vec<String>,
    unknown: Vec<String>,
    left: Vec<&'static str>,
    wrong: Option<(usize, String)>,
}

impl Flame {
    pub fn new(tag: &BytesStart<'_>, line: usize) -> Self {
        let mut flame = Self { line, ..Self::default() };
        for (key, value) in attributes(tag) {
            let value = value.trim();
            match key {
                "name" => {
                    flame.name =
                        unescape(value).map_or_else(|_| name_or(value, ""), |name| name_or(&name, ""));
                }
                "version" => flame.own = value == OWN_VERSION,
                // Of JWildfire and of Apophysis.
                "preserve_z" | "new_linear" => flame.keeps_z |= value == "1",
                "soloxform" => flame.solo = value.parse::<usize>().ok().map(|index| index.saturating_add(1)),
                "post_symmetry_type" if !value.eq_ignore_ascii_case("none") => flame.leave("its symmetry"),
                "palette" => flame.palette.named = true,
                _ => {}
            }
        }
        flame
    }

    /// The next of its layers.
    pub fn layer(&self, tag: &BytesStart<'_>, line: usize) -> Self {
        let unseen =
            attributes(tag).any(|(key, value)| key == "visible" && matches!(value.trim(), "0" | "false"));
        let Self { own, keeps_z, solo, .. } = *self;
        let mut next = Self { name: self.name.clone(), own, keeps_z, solo, unseen, line, ..Self::default() };
        next.layers = self.layers + 1;
        // What the flame says, all layers have.
        if self.left.contains(&"its symmetry") {
            next.leave("its symmetry");
        }
        next
    }

    fn leave(&mut self, what: &'static str) {
        if !self.left.contains(&what) {
            self.left.push(what);
        }
    }

    /// A tag within it that begins.
    pub fn take(&mut self, tag: &BytesStart<'_>, line: impl FnOnce() -> usize) {
        match tag.name().as_ref().to_ascii_lowercase().as_str() {
            "xform" => {
                self.close();
                self.count += 1;
                if self.wrong.is_none() && self.maps.len() <= MAX_MAPS {
                    let line = line();
                    match self.transform(tag, line) {
                        Ok(transform) => self.open = Some(transform),
                        Err(why) => self.wrong = Some((line, why)),
                    }
                }
            }
            "variationgroup" => {
                if let Some(open) = &mut self.open
                    && let Err(why) = miswritten(tag).and_then(|()| open.group(tag, &mut self.numbers))
                {
                    self.wrong = Some((open.line, why));
                    self.open = None;
                }
            }
            "motion" if self.open.is_some() => self.leave("its motion"),
            "finalxform" => {
                self.close();
                self.leave("its final transform");
            }
            "bgxform" => self.leave("its background"),
            "color" | "colors" | "palette" => self.palette.take(tag.name().as_ref(), attributes(tag)),
            "gradient" => self.palette.named = true,
            "symmetry" => self.leave("its symmetry"),
            _ => {}
        }
    }

    /// A tag within it that ends.
    pub fn end(&mut self, name: &str) {
        if name.eq_ignore_ascii_case("xform") {
            self.close();
        }
    }

    fn transform(&mut self, tag: &BytesStart<'_>, line: usize) -> Result<Transform, String> {
        // What cannot be read as an attribute may have been the numbers.
        miswritten(tag)?;
        Transform::new(tag, self.count, line, &mut self.numbers)
    }

    /// Takes the transform that is open, of which all is read.
    fn close(&mut self) {
        let Some(mut transform) = self.open.take() else { return };
        let functions = transform.close();
        if transform.off {
            self.off += 1;
            return;
        }
        for what in &transform.left {
            self.leave(what);
        }
        tell(&mut self.functions, &functions);
        tell(&mut self.unknown, &transform.unknown);
        if transform.weight == Some(0.0) && !self.own {
            self.unused += 1;
            return;
        }
        if transform.linear == 0.0 && !(transform.only_raises() && functions.is_empty()) {
            self.bent += 1;
            return;
        }
        self.partly += usize::from(!functions.is_empty());
        let (row, solid) = (transform.row(), transform.solid());
        if !row.iter().chain(&solid.row(self.keeps_z, Order::XFirst)).all(|x| x.is_finite()) {
            let planes = if transform.is_deep() { "coefs, post, their likes of z" } else { "coefs, post" };
            let why = format!(
                "Numbers of transform {} are too large: {planes} and the weight of linear give no finite map.",
                transform.number
            );
            self.wrong = Some((transform.line, why));
            return;
        }
        self.hidden +=
            usize::from(transform.hidden || self.solo.is_some_and(|solo| solo != transform.number));
        self.deep |= transform.is_deep();
        self.maps.push(row);
        self.solids.push(solid);
        self.weights.push(transform.weight);
        self.places.push(transform.place);
    }

    pub fn finish(mut self) -> Result<System, ImportError> {
        self.close();
        let Self { layers, count, bent, unused, off, partly, hidden, line, .. } = self;
        let name = if layers > 1 { name_or(&format!("{} layer {layers}", self.name), "") } else { self.name };
        let whose = if name.is_empty() { "The flame".to_owned() } else { format!("“{name}”") };
        let fail = |code, line, why| Err(ImportError::At { code, line, why });
        if let Some((line, why)) = self.wrong {
            return fail("flame-number", line, format!("{why} Mend it, or leave the transform out."));
        }
        if self.maps.len() > MAX_MAPS {
            let why = format!("{whose} has more than 64 transforms, and the most is 64. Leave some out.");
            return fail("flame-maps", line, why);
        }
        let functions = &self.functions;
        let told = if functions.is_empty() { String::new() } else { format!(" ({})", listed(functions)) };
        if self.maps.is_empty() {
            let have = if bent == 1 { "one has".into() } else { format!("{bent} have") };
            let whom = if name.is_empty() { "the flame" } else { &whose };
            let idle = match (unused, off) {
                (_, 0) => "the weight 0",
                (0, _) => "enabled=\"0\"",
                _ => "the weight 0 or enabled=\"0\"",
            };
            let why = match (count, bent) {
                (0, _) => format!("{whose} has no transform. Choose another, or give it one with coefs."),
                (_, 0) => format!(
                    "None of the {count} transforms of {whom} is ever chosen: each has {idle}. {}",
                    if off > 0 { "Switch them on." } else { "Give them weights." }
                ),
                _ if unused + off > 0 => format!(
                    "Of the {count} transforms of {whom}, {have} no linear part{told} and the others {idle}, so that \
                     nothing is left. {} those that are linear.",
                    if off > 0 { "Switch on" } else { "Give weights to" }
                ),
                _ => format!(
                    "None of the {count} transforms of {whom} has a linear part{told}, so that nothing of it is \
                     affine. Choose a flame with linear=\"1\" in it."
                ),
            };
            return fail("flame-not-affine", line, why);
        }
        let mut left = self.left;
        let kept = self.maps.len();
        let (maps, depth) = maps(self.maps, &self.solids, self.deep, self.keeps_z);
        let mut system = System::of(name, maps);
        let mut say = |words: String| system.remarks.push(words);
        if self.cut {
            say("The file ends before its flame does: there may have been more in it.".into());
        }
        if self.unseen {
            say("The flame does not draw this layer.".into());
        }
        if bent > 0 {
            let which = if bent == 1 { "One has".into() } else { format!("{bent} have") };
            say(format!("{kept} of {count} transforms are kept. {which} no linear part{told}."));
        }
        if partly > 0 {
            let which = if partly == 1 { "one transform".into() } else { format!("{partly} transforms") };
            say(format!("Of {which} only the linear part is kept, not what is added to it{told}."));
        }
        let have = |many: usize| match many {
            1 => "One transform has".into(),
            _ => format!("{many} transforms have"),
        };
        if unused > 0 {
            say(format!("{} the weight 0: left out.", have(unused)));
        }
        if off > 0 {
            say(format!("{} enabled=\"0\": left out.", have(off)));
        }
        match hidden {
            0 => {}
            _ if hidden == kept && kept > 1 => {
                say("The flame hides the points of all its transforms. Here they are all drawn.".into());
            }
            1 => say("The flame hides the points of one transform. Here they are drawn, too.".into()),
            _ => say(format!("The flame hides the points of {hidden} transforms. Here they are drawn, too.")),
        }
        depth.into_iter().for_each(|words| say(words.into()));
        if self.numbers.commas {
            say("Its decimals have commas: 0,5 is read as 0.5.".into());
        }
        let colours = self.palette.colours(&self.places);
        if colours.is_empty() && self.palette.named {
            left.push("its palette, whose colours do not stand in the file");
        } else if !colours.is_empty() && matches!(system.maps, Maps::Space(_)) {
            left.push("its colours");
        } else {
            system.colours = colours;
        }
        if !left.is_empty() {
            system.remarks.push(format!("Left out: {}.", left.join("; ")));
        }
        if !self.unknown.is_empty() {
            let which = listed(&self.unknown);
            system.remarks.push(format!("Left out, because Frond does not know what it means: {which}."));
        }
        system.take_weights(&self.weights);
        Ok(system)
    }
}

/// The maps of the plane, or of space where transforms leave the plane; and what is to be said of it.
fn maps(plane: Vec<Row>, solids: &[Solid], deep: bool, keeps_z: bool) -> (Maps, Option<&'static str>) {
    if !deep {
        return (Maps::Plane(plane), None);
    }
    let rows = |order| -> Vec<Row3> { solids.iter().map(|solid| solid.row(keeps_z, order)).collect() };
    let shrinks = |rows: &[Row3]| System::space(String::new(), rows.to_vec()).check().is_ok();
    let mut all = rows(Order::XFirst);
    let mut words = "Its transforms move z, too: read as a system of space.";
    if !leaves_plane(&all) {
        return (Maps::Plane(all.iter().map(of_plane).collect()), None);
    }
    if !shrinks(&all) {
        let other = rows(Order::ZFirst);
        if solids.iter().any(Solid::has_zx) && shrinks(&other) {
            all = other;
            words = "Its transforms move z, too: read as a system of space. In zxCoefs z is taken to stand first: \
                     with x first, as in JWildfire, the transforms do not shrink.";
        } else if !mixes(&all) {
            let words = "Its depth is left out: along z the transforms do not all shrink. What they do to x and y \
                         does not depend on it.";
            return (Maps::Plane(all.iter().map(of_plane).collect()), Some(words));
        }
    }
    (Maps::Space(all), Some(words))
}

/// Keeps names that a remark may tell, and one more by which it is known that there are others.
fn tell(known: &mut Vec<String>, names: &[String]) {
    for name in names {
        let name = short(name, 24);
        if known.len() <= MOST_TOLD && !known.contains(&name) {
            known.push(name);
        }
    }
}

fn listed(names: &[String]) -> String {
    if names.len() > MOST_TOLD { format!("{} ..", names[..MOST_TOLD].join(", ")) } else { names.join(", ") }
}

fn miswritten(tag: &BytesStart<'_>) -> Result<(), String> {
    if all_attributes(tag).any(|one| one.is_err()) {
        return Err(format!("<{}> is miswritten: each number needs its quotes.", short(tag, 60)));
    }
    Ok(())
}
