//! `.flame` files of flam3, Apophysis, JWildfire and others: XML, a `flame` with an `xform` for each transform; in
//! JWildfire also a `jwf-flame` of several `layer`s, each of which is read as a system.
//!
//! A transform is an affine map, `coefs`, a sum of functions of the plane ("variations"), each with its weight, and
//! perhaps a second affine map, `post`. Of the functions only `linear` is affine: with its weight it is read, with all
//! others it is not. Numbers stand in columns, `a d b e c f` for x' = a x + b y + c and y' = d x + e y + f, and y
//! points down. `color` says where on the flame's palette a transform is: the colour there is kept.
//!
//! A transform of weight 0 is never chosen, and no part of the picture that other programs draw: it is left out, but
//! from flames that Frond wrote, whose shape has all maps. So is one with `enabled="0"`. One whose points are not drawn
//! (`opacity="0"`, `plotmode="off"`) takes part all the same, since the others copy its points: its map is kept, and a
//! remark says that Frond draws them, too. Transforms that move z make a system of space; `depth` says how.
//!
//! What is read: `attributes` and `numbers` first, then `transform`, `depth`, `transforms` (all of a flame), `palette`.

mod attributes;
mod depth;
mod numbers;
mod palette;
mod transform;
mod transforms;

use quick_xml::Reader;
use quick_xml::events::Event;

use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::text::{Lines, short};
pub use transform::turned_over;
use transforms::Flame;
pub use transforms::OWN_VERSION;

/// What a flame is called.
const FLAMES: [&str; 2] = ["flame", "jwf-flame"];
/// The tags by which a file with flames is known.
pub const SIGNS: [&str; 3] = ["flame", "flames", "jwf-flame"];
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
                    open = Some(flame.layer(&tag, lines.line(at)));
                    if flame.layers > 0 || flame.count > 0 {
                        finish(flame);
                    }
                }
            }
            Event::Start(tag) => {
                if let Some(flame) = &mut open {
                    flame.palette.end();
                    flame.take(&tag, || lines.line(at));
                }
            }
            Event::Empty(tag) => {
                if let Some(flame) = &mut open {
                    flame.palette.end();
                    flame.take(&tag, || lines.line(at));
                    flame.end(tag.name().as_ref());
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
            Event::End(tag) => {
                if let Some(flame) = &mut open {
                    flame.palette.end();
                    flame.end(tag.name().as_ref());
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    if let Some(mut flame) = open {
        flame.cut = true;
        finish(flame);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Maps, System};

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
