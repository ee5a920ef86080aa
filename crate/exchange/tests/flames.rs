//! Flames as the programs draw them that write them.

use frond_core::Affine3;
use frond_exchange::{Maps, System, import};
use glam::DVec3;

fn read(text: &str) -> System {
    import(text.as_bytes()).expect("a flame").systems.remove(0)
}

fn told(text: &str) -> String {
    import(text.as_bytes()).map(|_| ()).expect_err("nothing to read").to_string()
}

/// A flame of transforms that all halve, with more attributes each.
fn halves(head: &str, more: &[&str]) -> String {
    let place = |k: usize| format!("coefs='.5 0 0 .5 {k} 0'");
    let xforms = more.iter().enumerate().map(|(k, more)| format!("<xform weight='1' {} {more}/>", place(k)));
    format!("<flame {head}>{}</flame>", xforms.collect::<String>())
}

fn half(k: usize) -> [f64; 6] {
    [0.5, 0.0, 0.0, 0.5, k as f64, 0.0]
}

#[test]
fn what_a_flame_hides_is_kept_and_said() {
    for (head, more, words) in [
        ("", ["linear='1'", "linear='1' opacity='0'"], "of one transform. Here they are drawn, too."),
        ("", ["linear='1' opacity='0.5'", "linear='1' plotmode='off'"], "of one transform. Here they"),
        ("", ["linear='1'", "linear='1' opacity='0,0'"], "of one transform. Here they"),
        (
            "",
            ["linear='1' opacity='0'", "linear='1' opacity='0.0'"],
            "of all its transforms. Here they are all",
        ),
        ("soloxform='1'", ["linear='1'", "linear='1'"], "of one transform. Here they"),
    ] {
        let found = read(&halves(head, &more));
        assert_eq!(found.maps, Maps::Plane(vec![half(0), half(1)]), "{more:?}");
        assert!(found.remarks[0].contains("The flame hides the points"), "{:?}", found.remarks);
        assert!(found.remarks[0].contains(words), "{:?}", found.remarks);
    }
    let three = read(&halves("", &["opacity='1'", "opacity='0'", "plotmode='off' opacity='0'"]));
    assert!(three.remarks[0].contains("of 2 transforms"), "{:?}", three.remarks);
    for seen in ["opacity='1'", "opacity='0.01'", "plotmode='on'", "opacity='?'"] {
        assert_eq!(read(&halves("soloxform='-1'", &[seen])).remarks, [""; 0], "{seen}");
    }
    // What is never chosen has no points to hide.
    let unused = read(
        "<flame><xform coefs='.5 0 0 .5 0 0'/><xform weight='0' opacity='0' coefs='.5 0 0 .5 1 0'/></flame>",
    );
    assert_eq!(unused.remarks[0], "One transform has the weight 0: left out.");
}

#[test]
fn what_is_switched_off_is_left_out_and_said() {
    for off in ["0", "false", "No", " off "] {
        let found = read(&halves("", &["", &format!("enabled='{off}'"), "enabled='1'"]));
        assert_eq!(found.maps, Maps::Plane(vec![half(0), half(2)]), "{off}");
        assert_eq!(found.remarks, ["One transform has enabled=\"0\": left out."]);
    }
    let all = told(&halves("name='A'", &["enabled='0'", "enabled='0'"]));
    assert_eq!(
        all,
        "Line 1: None of the 2 transforms of “A” is ever chosen: each has enabled=\"0\". Switch them on."
    );
    let others = told(&halves("", &["enabled='0'", "swirl='1'"]));
    assert!(others.contains("one has no linear part (swirl) and the others enabled=\"0\""), "{others}");
    let layers = "<jwf-flame name='L'><layer visible='0'><xform coefs='.5 0 0 .5 0 0'/></layer></jwf-flame>";
    assert_eq!(read(layers).remarks, ["The flame does not draw this layer."]);
}

#[test]
fn functions_may_stand_in_groups_within_a_transform() {
    let flame = |groups: &str| format!("<flame><xform coefs='.5 0 0 .5 1 0'>{groups}</xform></flame>");
    let of = |groups: &str| read(&flame(groups));
    let plain = of("<variationGroup normal='1' jwf_linear3D='1' jwf_julian='0' jwf_julian_power='2'/>");
    assert_eq!((&plain.maps, plain.remarks.len()), (&Maps::Plane(vec![half(1)]), 0));
    let weighed = of("<variationGroup normal='1' jwf2_linear='0.5'></variationGroup>");
    assert_eq!(weighed.maps, Maps::Plane(vec![[0.25, 0.0, 0.0, 0.25, 0.5, 0.0]]));
    let both = of("<variationGroup normal='1' linear='1'/><variationGroup normal='1' jwf_bubble='0.3'/>");
    assert_eq!(
        both.remarks,
        ["Of one transform only the linear part is kept, not what is added to it (bubble)."]
    );
    for (groups, words) in [
        (
            "<variationGroup normal='1' jwf_julian='1' jwf_julian_power='2'/>",
            "has a linear part (julian), so",
        ),
        ("<variationGroup normal='1'/>", "has a linear part, so that"),
        ("<variationgroup julian='1'/>", "has a linear part (julian), so"),
        ("<variationGroup linear='x'/>", "Line 1: linear=\"x\" is no number. Mend it"),
        ("<variationGroup linear=1/>", "is miswritten: each number needs its quotes."),
    ] {
        assert!(told(&flame(groups)).contains(words), "{groups}: {}", told(&flame(groups)));
    }
    // Those of the final transform are none of any other.
    let last = "<flame><xform coefs='.5 0 0 .5 1 0'/><finalxform coefs='1 0 0 1 0 0'><variationGroup normal='1' \
                jwf_julian='1'/></finalxform><xform coefs='.5 0 0 .5 0 0'/></flame>";
    let found = read(last);
    assert_eq!(found.maps, Maps::Plane(vec![half(1), half(0)]));
    assert_eq!(found.remarks, ["Left out: its final transform."]);
    // A file that ends within a transform has it, and says so.
    let cut = read("<flame><xform coefs='.5 0 0 .5 1 0'><variationGroup linear='1'/>");
    assert_eq!((cut.maps.len(), cut.remarks.len()), (1, 1));
}

#[test]
fn settings_of_jwildfire_are_no_functions() {
    let more = "linear3D='1' linear3D_fx_priority='0' wfield_type='NONE' wfield_color_intensity='0.5' wfield_jitter_amount='1' \
                xyRotateCurve_enabled='false' xyRotateCurve_point_count='2' xyRotateCurve_x0='3' linear3D_amountCurve_y0='1' \
                color_type='DIFFUSION' targetcolor='1 0 0' antialias_amount='0.25' mod_hue='1' material='2'";
    assert_eq!(read(&halves("", &[more])).remarks, [""; 0]);
    for (more, words) in [
        ("wfield_type='CELLULAR_NOISE'", "Left out: its weighting fields"),
        ("xyRotateCurve_enabled='true'", "Left out: its motion."),
        ("chaos='1 0'", "Left out: which transform may follow which (xaos)."),
        ("shape='star' linear='1'", "Left out, because Frond does not know what it means: shape."),
        ("bend='1 2 3' linear='1'", "Left out, because Frond does not know what it means: bend."),
        // Of two instances, one more than linear.
        ("linear='1' julian#2#='0.5' julian#2#_power='3'", "not what is added to it (julian)."),
    ] {
        let found = read(&halves("", &[more]));
        assert_eq!(found.maps, Maps::Plane(vec![half(0)]), "{more}");
        assert!(found.remarks.len() == 1 && found.remarks[0].contains(words), "{more}: {:?}", found.remarks);
    }
    // The words of a function that is named are its own.
    let mesh = "linear='1' obj_mesh='0.5' obj_mesh_file='616263'";
    assert_eq!(read(&halves("", &[mesh])).remarks.len(), 1);
    let mirrored = read(&halves("post_symmetry_type='POINT' post_symmetry_order='3'", &[""]));
    assert_eq!(mirrored.remarks, ["Left out: its symmetry."]);
    let twice = read(&halves("", &["linear3D#1#='0.5' linear3D#2#='0.5'"]));
    assert_eq!((&twice.maps, twice.remarks.len()), (&Maps::Plane(vec![half(0)]), 0));
    let moved = "<flame><xform coefs='.5 0 0 .5 0 0'><motion motion_frequency='1' coefs='1 0 0 1 0 0'/></xform></flame>";
    assert_eq!(read(moved).remarks, ["Left out: its motion."]);
}

#[test]
fn decimals_may_have_commas() {
    let found = read(
        "<flame><xform weight='0,25' linear='0,5' julian='0,0' coefs='1,0 0 0 1 0,5 \u{2212}0,25'/>\
         <xform weight='0,75' coefs='0,5 0 0 0,5 0 0' post='1 0 0 1 1,5 0' color='0,3'/></flame>",
    );
    assert_eq!(
        found.maps,
        Maps::Plane(vec![[0.5, 0.0, 0.0, 0.5, 0.25, 0.125], [0.5, 0.0, 0.0, 0.5, 1.5, 0.0]])
    );
    assert_eq!(found.probabilities, [0.25, 0.75]);
    assert_eq!(found.remarks, ["Its decimals have commas: 0,5 is read as 0.5."]);
    // What is added to the linear part is not passed over for its comma.
    let bent = read("<flame><xform linear='1' julian='0,5' coefs='.5 0 0 .5 0 0'/></flame>");
    assert!(bent.remarks[0].contains("(julian)"), "{:?}", bent.remarks);
    assert!(told("<flame><xform weight='1.000,5' coefs='.5 0 0 .5 0 0'/></flame>").contains("is no number"));
}

/// What JWildfire does to a point, step by step as in its sources: the three planes, all shifts, then the same after
/// the functions, here `linear3D` alone. y points down.
fn of_jwildfire(before: [[f64; 6]; 3], linear: f64, after: [[f64; 6]; 3], p: DVec3) -> DVec3 {
    let affine = |[xy, yz, zx]: [[f64; 6]; 3], p: DVec3| {
        let (x, y, z) = (xy[0] * p.x + xy[2] * p.y, xy[1] * p.x + xy[3] * p.y, p.z);
        let (y, z) = (yz[0] * y + yz[2] * z, yz[1] * y + yz[3] * z);
        let (x, z) = (zx[0] * x + zx[2] * z, zx[1] * x + zx[3] * z);
        DVec3::new(x + xy[4] + zx[4], y + xy[5] + yz[4], z + yz[5] + zx[5])
    };
    affine(after, linear * affine(before, p))
}

#[test]
fn transforms_that_move_z_are_a_system_of_space() {
    let before =
        [[0.5, 0.1, -0.2, 0.4, 1.0, 2.0], [0.9, 0.3, -0.1, 0.8, 0.25, 0.5], [0.7, 0.2, 0.1, 0.6, -1.0, 3.0]];
    let after =
        [[0.8, 0.1, 0.2, 0.9, 0.3, 0.1], [0.7, 0.2, 0.1, 0.6, 0.5, 0.4], [0.9, -0.1, 0.1, 0.8, 0.2, 0.6]];
    let six = |six: [f64; 6]| six.map(|x| x.to_string()).join(" ");
    let text = format!(
        "<flame version='JWildfire V8.00'><xform weight='2' linear3D='0.5' coefs='{}' yzCoefs='{}' zxCoefs='{}' post='{}' \
         yzPost='{}' zxPost='{}'/><xform weight='1' linear3D='1' coefs='.5 0 0 .5 0 0'/></flame>",
        six(before[0]),
        six(before[1]),
        six(before[2]),
        six(after[0]),
        six(after[1]),
        six(after[2]),
    );
    let found = read(&text);
    let Maps::Space(rows) = &found.maps else { panic!("{found:?}") };
    assert_eq!(found.remarks, ["Its transforms move z, too: read as a system of space."]);
    assert_eq!(found.probabilities, [2.0, 1.0]);
    let up = |p: DVec3| DVec3::new(p.x, -p.y, p.z);
    for p in [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(0.3, -0.7, 1.9)] {
        let off = Affine3::from_row(rows[0]).apply(up(p)) - up(of_jwildfire(before, 0.5, after, p));
        assert!(off.length() < 1e-12, "{p}: {off}");
    }
    // Without a function that keeps it, z is lost.
    assert_eq!(rows[1], [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn functions_of_z_are_read() {
    let third = |more: &str, head: &str| {
        let found = read(&format!(
            "<flame {head}><xform {more} coefs='.5 0 0 .5 0 0'/><xform linear='0.5' ztranslate='0.25' coefs='1 0 0 1 0 0'/></flame>"
        ));
        let Maps::Space(rows) = found.maps else { panic!("{more}") };
        assert_eq!(rows[1][11], 0.25);
        [rows[0][6], rows[0][7], rows[0][8], rows[0][11]]
    };
    for (more, head, wanted) in [
        ("linear='1'", "", [0.0, 0.0, 0.0, 0.0]),
        ("linear='0.5'", "preserve_z='1'", [0.0, 0.0, 0.5, 0.0]),
        ("linear='0.5'", "version='Apophysis 7X' new_linear='1'", [0.0, 0.0, 0.5, 0.0]),
        ("linear3D='0.5'", "", [0.0, 0.0, 0.5, 0.0]),
        ("linear='1' zscale='0.5' ztranslate='0,125'", "", [0.0, 0.0, 0.5, 0.125]),
        ("linear3D='0.5' pre_zscale='0.5' pre_ztranslate='3'", "", [0.0, 0.0, 0.25, 1.5]),
        ("linear3D='0.5' ztranslate='4' flatten='1'", "", [0.0, 0.0, 0.0, 0.0]),
        // In a flame of space nothing but ztranslate is a point at its height.
        ("ztranslate='0.5'", "", [0.0, 0.0, 0.0, 0.5]),
    ] {
        assert_eq!(third(more, head), wanted, "{more} {head}");
    }
}

#[test]
fn a_flame_that_stays_in_its_plane_is_of_the_plane() {
    let flat =
        |more: &str| read(&format!("<flame><xform linear3D='1' coefs='1 0 0 .5 0 0' {more}/></flame>"));
    // y is halved once more, and x by the third plane.
    let found = flat("yzCoefs='.5 0 0 1 0 0' zxCoefs='.25 0 0 1 0 0' zscale='3'");
    assert_eq!((found.maps, found.remarks.len()), (Maps::Plane(vec![[0.25, 0.0, 0.0, 0.25, 0.0, 0.0]]), 0));
    // Planes that say nothing change not a bit.
    let same = flat("yzCoefs='1 0 0 1 0 0' zxPost='1.0 0 0 1.0 0.0 0'");
    assert_eq!((same.maps, same.remarks.len()), (Maps::Plane(vec![[1.0, 0.0, 0.0, 0.5, 0.0, 0.0]]), 0));
}

#[test]
fn depth_that_does_not_shrink_is_left_out_and_said() {
    let found = read(
        "<flame><xform linear3D='1' coefs='.5 0 0 .5 0 0' yzCoefs='.5 0 0 .5 0 0'/>\
         <xform linear3D='1' coefs='.5 0 0 .5 .5 0' yzCoefs='1 0 0 1 0 .5'/></flame>",
    );
    assert_eq!(
        found.maps,
        Maps::Plane(vec![[0.5, 0.0, 0.0, 0.25, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0]])
    );
    assert!(found.remarks[0].starts_with("Its depth is left out: along z the transforms do not all shrink."));
    // Where x depends on z there is no plane to read: its problem is that of a system of space.
    let mixed = read(
        "<flame><xform linear3D='1' coefs='.5 0 0 .5 0 0' zxCoefs='1 0 .5 1 0 1'/>\
         <xform linear3D='1' coefs='.5 0 0 .5 .5 0'/></flame>",
    );
    assert!(matches!(mixed.maps, Maps::Space(_)));
    assert!(mixed.check().is_err());
}

#[test]
fn the_third_plane_may_have_z_first() {
    let corner = |x: f64, y: f64, z: f64| {
        format!(
            "<xform linear3D='1' coefs='1 0 0 .5 {x} {y}' zxCoefs='1 0 0 .5 0 0' yzCoefs='1 0 0 .5 0 {z}'/>"
        )
    };
    let found = read(&format!("<flame>{}{}</flame>", corner(0.0, 0.0, 0.0), corner(0.5, 0.25, 0.125)));
    let half = |x, y, z| [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5, x, y, z];
    assert_eq!(found.maps, Maps::Space(vec![half(0.0, 0.0, 0.0), half(0.5, -0.25, 0.125)]));
    assert!(found.remarks[0].contains("In zxCoefs z is taken to stand first"), "{:?}", found.remarks);
}

#[test]
fn numbers_of_z_that_are_too_large_are_refused() {
    for more in [
        "yzCoefs='1 0 0 1e200 0 0' yzPost='1 0 0 1e200 0 0'",
        "linear3D='1e200' zscale='1e200' yzCoefs='1 0 0 1e200 0 0'",
        "zxPost='1 0 0 1e200 0 0' ztranslate='1e200'",
    ] {
        let why = told(&format!("<flame>\n<xform linear3D='1' coefs='.5 0 0 .5 0 0' {more}/></flame>"));
        assert!(why.starts_with("Line 2: Numbers of transform 1 are too large"), "{more}: {why}");
    }
    for (more, why) in [
        ("yzCoefs='1 2 3'", "Line 2: yzCoefs=\"1 2 3\" is not six numbers."),
        ("zxPost='1 2 3 4 5 6 7'", "Line 2: zxPost=\"1 2 3 4 5 6 7\" is more than six numbers."),
        ("zscale='x'", "Line 2: zscale=\"x\" is no number."),
    ] {
        assert!(
            told(&format!("<flame>\n<xform coefs='.5 0 0 .5 0 0' {more}/></flame>")).starts_with(why),
            "{more}"
        );
    }
}

#[test]
fn colours_of_space_are_said_to_be_left_out() {
    let palette = "<palette count='2' format='RGB'>FF0000 00FF00</palette>";
    let xform = "<xform linear3D='1' color='0' coefs='.5 0 0 .5 0 0' yzCoefs='1 0 0 .5 0 1'/>";
    let found = read(&format!("<flame>{xform}{palette}</flame>"));
    assert!(found.colours.is_empty());
    assert_eq!(found.remarks.last().map(String::as_str), Some("Left out: its colours."));
}
