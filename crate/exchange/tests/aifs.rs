//! Programs of IFStile: what the language says, against values from elsewhere, and what is not read.

use std::f64::consts::PI;

use frond_core::{Affine2, DirectedIfs, DirectedMap, Ifs, directed_dimension, similarity_dimension};
use frond_exchange::{Camera, ExportFormat, Imported, Maps, System, export, import};

fn read(text: &str) -> Imported {
    import(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn system(text: &str) -> System {
    let mut found = read(text);
    assert_eq!(found.systems.len(), 1, "{text}");
    found.systems.remove(0)
}

fn rows(text: &str) -> Vec<[f64; 6]> {
    match system(text).maps {
        Maps::Plane(rows) => rows,
        other => panic!("{other:?}"),
    }
}

fn told(text: &str) -> String {
    match import(text.as_bytes()) {
        Ok(found) => panic!("{text}: {found:?}"),
        Err(error) => error.to_string(),
    }
}

/// What an expression comes to, as the shift of a map.
fn value(expression: &str) -> f64 {
    rows(&format!("@\n$dim=2\nv={expression}\nA=[v,0]*2^-1*A\n"))[0][4]
}

/// The numbers of a list.
fn list(expression: &str) -> Vec<f64> {
    let count = value(&format!("({expression})()"));
    (0..count as usize).map(|k| value(&format!("({expression})[{k}]"))).collect()
}

fn near(found: &[f64], wanted: &[f64]) {
    assert_eq!(found.len(), wanted.len());
    assert!(
        found.iter().zip(wanted).all(|(x, y)| (x - y).abs() < 4e-16 * (1.0 + y.abs())),
        "{found:?} {wanted:?}"
    );
}

/// `z -> a z + b`, or of its conjugate.
fn complex((a, b): (f64, f64), (e, f): (f64, f64), mirrored: bool) -> [f64; 6] {
    if mirrored { [a, b, b, -a, e, f] } else { [a, -b, b, a, e, f] }
}

type Point = (f64, f64);

fn times((a, b): Point, (c, d): Point) -> Point {
    (a * c - b * d, a * d + b * c)
}

fn minus((a, b): Point, (c, d): Point) -> Point {
    (a - c, b - d)
}

fn over(x: Point, (c, d): Point) -> Point {
    let square = c * c + d * d;
    times(x, (c / square, -d / square))
}

#[test]
fn an_equation_of_a_set_is_a_system() {
    let dragon = [[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]];
    for text in [
        "@\n$dim=2\nf1=[0,0]*[0.5,-0.5,0.5,0.5]\nf2=[1,0]*[-0.5,-0.5,0.5,-0.5]\nS=(f1|f2)*S",
        "@@version 4\n@ # by hand\nA = [.5,-1/2,2^-1,0.5]*A | [1,0] * [-.5,-.5,5e-1,-.5] * A\r\n",
        "@base\n$a=h\nh=2^-1\nS=(f|g)*S\n@:base\n$dim=2\n$n=Dragon\nf=h*[1,-1,1,1]\ng=[1,0]*h*[-1,-1,1,-1]",
        // By the root i of x² + 1: z (1 + i)/2 and 1 - z (1 - i)/2.
        "@\n$dim=2\n$subspace=[s,0]\ns=$companion([1,0])\nA=((1-s)^-1|[1,0]*-1*(1+s)^-1)*A",
        // Over lines, with a remark between.
        "@\nA=( [.5,-.5, # the first\n .5,.5]\n | [1,0]*[-.5,-.5,.5,-.5] )*A\n",
    ] {
        assert_eq!(rows(text), dragon, "{text}");
    }
    // A scale before a shift scales it, too.
    assert_eq!(
        rows("@\nA=(2^-1*[1,0]|[1,0]*2^-1)*A"),
        [[0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.0, 0.5, 1.0, 0.0]]
    );
    assert_eq!(rows("@\nf=[.5,0,0,.5]\ng=[1,0]\nA=f^2*A|f*g*A|-f*A|1/(2*$i)*A|$e*A").len(), 4);
    // A quotient of maps undoes the second one first.
    assert_eq!(rows("@\nA=[1,0]*4^-1/[0,1]*A"), [[0.25, 0.0, 0.0, 0.25, 1.0, -0.25]]);
    assert_eq!(system("@\n$dim=3\nA=([1,0,0]|[0,0,0])*2^-1*A").maps.len(), 2);
}

#[test]
fn blocks_inherit_and_hidden_ones_are_no_shapes() {
    let found = |letter: char| read(&format!("@b\n$a={letter}\nA=[.5,0,0,.5]*A\n@:b\n$n=Two\n"));
    let names = |letter| found(letter).systems.into_iter().map(|it| it.name).collect::<Vec<_>>();
    assert_eq!(names('h'), ["Two"]);
    assert_eq!(names('x'), ["", "Two"]);
    // A parent may come later, and a set is what mentions itself where it is last defined.
    assert_eq!(rows("@:late\nh=.25\n@late\n$a=h\nh=.5\nA=h*A\n")[0][0], 0.25);
    let half = "[.5,0,0,.5]";
    let found = read(&format!("@b\n$a=h\nA={half}*A\nB=(1|A)*B\n@:b\nA={half}\n"));
    assert_eq!(found.systems[0].maps.len(), 2);
    // Blocks that inherit each other have the definitions of both.
    let found = read("@a:b\nh=.5\n$n=One\n@b:a\nA=h*A\n$n=Two\n");
    assert_eq!(found.systems.iter().map(|it| &it.name[..]).collect::<Vec<_>>(), ["One", "Two"]);
    assert!(found.systems[0].remarks[0].contains("inherit each other"), "{:?}", found.systems[0].remarks);
}

#[test]
fn blocks_are_functions() {
    let turn = "@turn\n$a=h\na=90\nk=1\nx=a*asin(1)/90\nret=[k*cos(x),-k*sin(x),k*sin(x),k*cos(x)]\n";
    let quarter = [[0.0, -0.5, 0.5, 0.0, 1.0, 0.0]];
    for map in [
        "turn(90,1/2)",
        "turn(450,0.5)",
        "$new(turn,k,.5)",
        "$new(turn,1,.5)",
        "turn()*.5",
        "half()",
        "half(-270)",
        "$new(half,a,90).ret",
    ] {
        let text = format!("{turn}@half:turn\n$a=h\nk=1/2\n@\n$dim=2\nf={map}\nA=[1,0]*f*A\n");
        assert_eq!(rows(&text), quarter, "{map}");
    }
    // They may call themselves, as long as that ends.
    let sum = "@sum\n$a=h\nn=0\nret=if(n,n+sum(n-1),0)\n";
    let text = |n: u32| format!("{sum}@\nA=[sum({n}),0]*2^-1*A");
    assert_eq!(rows(&text(6))[0][4], 21.0);
    assert!(told(&text(5000)).contains("go on without end"));
    let field = "@c\n$a=h\nx=7\ny=[x,8]\n@\nA=[c.y[1]+$new(c,x,2).y[0],0]*2^-1*A";
    assert_eq!(rows(field)[0][4], 10.0);
}

#[test]
fn numbers_are_what_mathematics_says() {
    for (expression, wanted) in [
        ("2+3*4-1", 13.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("2^-1^2", 0.5),
        ("2^-2^-1", 0.5_f64.sqrt()),
        ("2^0.5--2^0.5", 8.0_f64.sqrt()),
        ("7%3", 1.0),
        ("-7%3", 2.0),
        ("7%-3", -2.0),
        ("7%0", 7.0),
        ("1/3+1/6", 0.5),
        ("1/3", 1.0 / 3.0),
        ("0.1+0.2", 0.3),
        ("cos($pi/3)", 0.5),
        ("sin(2*asin(1)/6)", 0.5),
        ("4^(1/2)", 2.0),
        ("exp(1)", std::f64::consts::E),
        ("log(2)", std::f64::consts::LN_2),
        ("atan(1)", PI / 4.0),
        ("arg([-1,0])", PI),
        ("abs(-3)+floor(2.5)+ceil(-2.5)", 3.0),
        ("if(1)", 1.0),
        ("if(0)", 0.0),
        ("if(-1,2,3)", 3.0),
        ("if(0,1,0.5,2,3)", 2.0),
        ("if(2,3)", -1.0),
        ("if([1,2,3],[1,2,0])", 1.0),
        ("if([1,1],4,5)", 4.0),
        ("if([1,0],4,5)", 5.0),
        ("if(0,1/0,6)", 6.0),
        ("$numden(6/4)[0]", 3.0),
        ("$numden($pi,0.002)[0]", 22.0),
        ("$charpoly([1,2,3,4])[0]", -2.0),
        ("$charpoly([1,2,3,4])[1]", -5.0),
    ] {
        assert!((value(expression) - wanted).abs() < 1e-15, "{expression}: {}", value(expression));
    }
    // A substitution is computed where it is named, and names may be said in any order.
    assert_eq!(rows("@\nA=[f(),x]*2^-1*A\n&f=[x,x]\nx=y+1\ny=2\n")[0][4..], [2.0, 3.0]);
}

#[test]
fn lists_are_made_and_looked_at() {
    for (expression, wanted) in [
        ("[$,5-$(),$()]", &[0.0, 1.0, 2.0, 3.0, 4.0][..]),
        ("[0,1,$,7-$(),$[-1]+$[-2]]", &[0.0, 1.0, 1.0, 2.0, 3.0, 5.0, 8.0]),
        ("[0,$(0)[0]+1,$(0)[1]+1]", &[0.0, 1.0, 2.0]),
        ("[9,$,3-$(),$()*10,8,$,6-$(),7]", &[9.0, 10.0, 20.0, 8.0, 7.0, 7.0]),
        ("[5,[6,$(1)[0]]][1]", &[6.0, 5.0]),
        ("[[1,2],[3,4]][]", &[1.0, 2.0, 3.0, 4.0]),
        ("[1,3,5,7][1:3]", &[3.0, 5.0]),
        ("[1,3,5,7][::-2]", &[7.0, 3.0]),
        ("[10,20,30,40,50][[0,2,-1]]", &[10.0, 30.0, 50.0]),
        ("[1,2]+[10,20]", &[11.0, 22.0]),
        ("-[1,2]", &[-1.0, -2.0]),
        ("3*[1,2,3]", &[3.0, 6.0, 9.0]),
        ("[1,2]^(3/2)", &[1.5, 3.0]),
        ("[1,2,3]^-2", &[-2.0, -4.0, -6.0]),
        // The older form of lists without end, and none at all.
        ("[$,if(4-$(),$()*$(),$)]", &[0.0, 1.0, 4.0, 9.0]),
        ("[0,1,$,if(5-$(),$[-1]+$[-2],$)]", &[0.0, 1.0, 1.0, 2.0, 3.0]),
        ("[7,$]", &[7.0]),
        // Columns, of as many dimensions as there are numbers.
        ("$companion([5,6,7])[][2]", &[-5.0, -6.0, -7.0]),
        ("$charpoly($companion([5,6,7]))", &[5.0, 6.0, 7.0]),
    ] {
        assert_eq!(list(expression), wanted, "{expression}");
    }
    assert_eq!(value("[1/0,2](1)"), 2.0);
    assert_eq!(value("[1,3,5,7]()"), 4.0);
    // The orbit of -0.75 + 0.1 i under z² + c, step by step, as long as it is small: 33 of them.
    let orbit = "[[0,0,0],$,if(200-$())*if(4-$[-1][2]),[$(1)[-1],$[0][0],$[0][1],$[1]^2-$[2]^2-0.75,\
                 2*$[1]*$[2]+0.1,$[3]^2+$[4]^2][-3:]]";
    let mut z = (0.0_f64, 0.0_f64);
    let mut count = 1.0;
    while z.0 * z.0 + z.1 * z.1 < 4.0 {
        z = (z.0 * z.0 - z.1 * z.1 - 0.75, 2.0 * z.0 * z.1 + 0.1);
        count += 1.0;
    }
    // Exact numbers grow too long on the way: doubles do not.
    let rough = orbit.replace("-0.75", "-0.75*exp(0)*cos(0)*sin(1)/sin(1)");
    assert_eq!(value(&format!("({rough})()")), count);
}

#[test]
fn maps_may_be_lists_of_maps() {
    let both = [[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0]];
    for union in ["(1|[1,0])", "$union([1,[1,0]])", "(O[0]|O[-1])", "(1|O[1]^2*O[1]^-1)"] {
        assert_eq!(rows(&format!("@\nO=[1,[1,0]]\nA=2^-1*{union}*A")), both, "{union}");
    }
    let nested = rows("@\nh=[1,0,0,-1]\nA=2^-1*$union([1,[[3,0],[1,h]]])*A");
    let more = rows("@\nh=[1,0,0,-1]\nA=2^-1*(1|[3,0]*(1|h))*A");
    assert!(nested == more && more.len() == 3, "{nested:?}");
    assert_eq!(rows("@\ns=$exchange()\nd=$diagonal([1/2,1/4])\nA=d*s*A"), [[0.0, 0.5, 0.25, 0.0, 0.0, 0.0]]);
}

/// The complex root of x³ + x² + x - 1: its real root by Newton, then the quadratic rest.
fn tribonacci() -> Point {
    let mut x = 0.5_f64;
    for _ in 0..60 {
        x -= (x * x * x + x * x + x - 1.0) / (3.0 * x * x + 2.0 * x + 1.0);
    }
    let half = -f64::midpoint(1.0, x);
    (half, (x * x + x + 1.0 - half * half).sqrt())
}

#[test]
fn a_subspace_is_a_plane_of_a_root() {
    // Rauzy's fractal.
    let found =
        system("@\n$dim=3\n$subspace=[g,0]\ng=$companion([-1,1,1])\nA=(g^-1|g^-2*[0,1,0]|g^-3*[0,1,1])*A");
    let Maps::Plane(rows) = &found.maps else { panic!() };
    let root = tribonacci();
    let one = over((1.0, 0.0), root);
    let (two, three) = (times(one, one), times(one, times(one, one)));
    let square = times(root, root);
    let shift = times(three, (root.0 + square.0, root.1 + square.1));
    let wanted = [
        complex(one, (0.0, 0.0), false),
        complex(two, times(two, root), false),
        complex(three, shift, false),
    ];
    for (row, wanted) in rows.iter().zip(&wanted) {
        near(row, wanted);
    }
    let maps = rows.iter().map(|&row| Affine2::from_row(row)).collect();
    assert!((similarity_dimension(&Ifs::new(maps).unwrap()).unwrap() - 2.0).abs() < 1e-12);
    // What it was computed from is kept as it is.
    let ambient = found.ambient.unwrap();
    let cell = &ambient.subspace.as_ref().unwrap().cells[0];
    let whole = |x: i64| num_rational::Ratio::from_integer(num_bigint::BigInt::from(x));
    assert_eq!((ambient.dim, &cell.polynomial), (3, &[-1, 1, 1, 1].map(whole).to_vec()));
    // The inverse of x is x² + x + 1.
    assert_eq!(ambient.states[0][0].matrix, [1, 1, 0, 1, 0, 1, 1, 0, 0].map(whole));
    assert_eq!(ambient.states[0][1].from, 0);
}

#[test]
fn what_is_zero_on_a_subspace_is_zero() {
    // The eighth root of 1 makes 1 + s - s^3 the number 1 + √2, which turns nothing.
    let text = "@\n$dim=4\n$subspace=[s,0]\ns=$companion([1,0,0,0])\nA=(1+s-s^3)^-1*(1|[1,0,0,0])*A\n";
    let ratio = 0.414_213_562_373_095_05;
    assert_eq!(rows(text), [[ratio, 0.0, 0.0, ratio, 0.0, 0.0], [ratio, 0.0, 0.0, ratio, ratio, 0.0]]);
}

#[test]
fn several_sets_are_states_and_a_reflection_is_conjugation() {
    // Robinson's triangles by their corners: an acute one (apex 36 degrees) and an obtuse one (108 degrees).
    let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
    let turn = |degrees: f64| (degrees.to_radians().cos(), degrees.to_radians().sin());
    let between = |a: Point, b: Point| (a.0 + (b.0 - a.0) / golden, a.1 + (b.1 - a.1) / golden);
    let origin = (0.0, 0.0);
    let (acute, obtuse) = ([origin, (1.0, 0.0), turn(36.0)], [origin, (1.0, 0.0), turn(108.0)]);
    let map = |from: [Point; 3], to: [Point; 3]| {
        let along = minus(to[1], to[0]);
        [false, true]
            .map(|mirrored| complex(along, to[0], mirrored))
            .into_iter()
            .find(|row| {
                let (x, y) = from[2];
                let third = (row[0] * x + row[1] * y + row[4], row[2] * x + row[3] * y + row[5]);
                minus(third, to[2]).0.hypot(minus(third, to[2]).1) < 1e-12
            })
            .unwrap()
    };
    let [a, b, c] = acute;
    let p = between(a, b);
    let [d, e, f] = obtuse;
    let (q, r) = (between(e, d), between(e, f));
    let wanted = [
        vec![(0, map(acute, [c, p, b])), (1, map(obtuse, [p, c, a]))],
        vec![(1, map(obtuse, [r, f, d])), (1, map(obtuse, [q, r, e])), (0, map(acute, [r, q, d]))],
    ];
    // The same in the fifth roots of -1: t = 1/golden, k conjugates, and points are polynomials in s.
    let text = "@\n$dim=4\n$subspace=[s,0]\n$root=K\ns=$companion([1,-1,1,-1])\nk=s^-3*$exchange()\n\
                t=s^2-s^3\none=[1,0,0,0]\nb=one\nc=s*one*s^-1\nat=[1,0,0,0]\n\
                K=(s*at*s^-1)*(t-s)*K|(t*at*t^-1)*(s-t)*D\n\
                q=1-t\nr=1+(s^3-1)*t\n\
                D=(r*at*r^-1)*(s^3-r)*D|(q*at*q^-1)*(r-q)*k*D|(r*at*r^-1)*(q-r)*k*K\n";
    let Maps::Directed(states) = system(text).maps else { panic!() };
    for (state, wanted) in states.iter().zip(&wanted) {
        for (copy, (from, row)) in state.iter().zip(wanted) {
            assert_eq!(copy.from, *from);
            assert!(copy.map.iter().zip(row).all(|(x, y)| (x - y).abs() < 1e-14), "{:?} {row:?}", copy.map);
        }
    }
    let map = |copy: &frond_exchange::DirectedCopy| DirectedMap {
        from: copy.from,
        map: Affine2::from_row(copy.map),
    };
    let states = states.iter().map(|maps| maps.iter().map(map).collect()).collect();
    let system = DirectedIfs::new(states).unwrap();
    assert!((directed_dimension(&system, 0).unwrap() - 2.0).abs() < 1e-12);
}

#[test]
fn cells_are_counted_as_often_as_they_are_there() {
    let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
    // Twice the golden matrix: the plane of its two cells of the larger eigenvalue.
    let text = "@\n$dim=4\n$subspace=[g,0,1]\ng=[0,1,0,0, 1,1,0,0, 0,0,0,1, 0,0,1,1]\nA=g^-1*(1|[1,0,0,0]|[0,0,1,0])*A";
    for row in rows(text) {
        near(&row[..4], &[1.0 / golden, 0.0, 0.0, 1.0 / golden]);
    }
    let text = |cells: &str| text.replace("g,0,1", cells);
    // One of them is a line.
    assert_eq!(rows(&text("g,0"))[1][5], 0.0);
    assert!(system(&text("g,1")).remarks[0].contains("on a line"));
    assert!(
        told(&text("g,2,3"))
            .starts_with("Line 3: On the subspace of $subspace: These maps have no attractor")
    );
    assert!(
        told(&text("g,0,1,2,3")).starts_with("Line 3: The cells of $subspace have 4 dimensions together")
    );
    // A cell that is not diagonal has two dimensions.
    let row = rows("@\n$dim=2\n$subspace=[m,0]\nm=[1/2,1,0,1/2]\nA=(m|[0,1]*m)*A")[0];
    let [a, b, c, d, ..] = row;
    assert!(
        (a + d - 1.0).abs() < 1e-15 && (a * d - b * c - 0.25).abs() < 1e-15 && b.abs() + c.abs() > 0.1,
        "{row:?}"
    );
    // Turns of a skewed lattice become turns where a subspace has no coordinates of its own.
    let text = "@\n$dim=2\n$subspace=[m,0,1]\nm=2\ns=$companion([1,-1])\nA=2^-1*(1|[1,0]|s*[1,0])*A";
    let Maps::Plane(found) = system(text).maps else { panic!() };
    assert!(found.iter().all(|&row| Affine2::from_row(row).is_similitude(1e-12)), "{found:?}");
}

#[test]
fn shapes_of_space_are_systems_or_objects() {
    // Sets that are put into another: one system.
    let found = system("@\n$dim=3\nA=2^-1*(1|[1,0,0]*B)*A\nB=1\n");
    assert_eq!(found.maps.len(), 2);
    let found = system("@\n$dim=3\nA=2^-1*A|2^-1*[1,0,0]*B\nB=2^-1*([0,1,0]|[0,0,1])*A\n");
    assert!(matches!(&found.maps, Maps::Space(rows) if rows.len() == 3 && rows[2][0] == 0.25), "{found:?}");
    // A set of copies of another: as many objects, each the system moved along.
    let found = system("@\n$dim=3\n$root=R\nA=2^-1*(1|[1,0,0])*A\nR=A|[0,6,0]*A\n");
    let Maps::Objects(objects) = &found.maps else { panic!("{found:?}") };
    assert_eq!(objects[1][1], [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.5, 3.0, 0.0]);
    // Two that are made of themselves and of each other.
    let text = "@\n$dim=3\nA=2^-1*A|2^-1*[1,0,0]*B\nB=2^-1*B|2^-1*[0,1,0]*A\n";
    assert!(told(text).contains("“A”, “B” are made of each other in space"));
}

#[test]
fn sets_that_are_no_part_of_each_other_are_shapes_of_their_own() {
    let found = read("@\n$n=Two\nA=2^-1*(1|[1,0])*A\nB=3^-1*(1|[1,0]|[0,1])*B\nC=A|[3,0]*B\n");
    let names: Vec<_> = found.systems.iter().map(|it| (&it.name[..], it.maps.len())).collect();
    assert_eq!(names, [("Two", 2), ("Two, B", 3), ("Two, C", 7)]);
    let found = read("@\n$root=B\nA=2^-1*A\nB=3^-1*(1|[1,0])*B\n");
    assert_eq!(found.systems[0].maps.len(), 2);
    // Another name of a set is that set.
    assert_eq!(
        read("@\n$root=B\nA=2^-1*(1|[1,0])*A\nB=A\n").systems[0].maps,
        Maps::Plane(rows("@\nA=2^-1*(1|[1,0])*A"))
    );
    // Sets may be kept in lists, which are no sets.
    let found = read("@\nA=2^-1*(1|[1,0])*A\nB=3^-1*(1|[1,0]|[0,1])*B\nC=[A,B]\nD=C[1]|[4,0]*C[0]\n");
    let counts: Vec<_> = found.systems.iter().map(|it| it.maps.len()).collect();
    assert_eq!(counts, [2, 3, 7]);
    assert!(told("@\n$root=C\nA=2^-1*A\nC=[A,A]\n").starts_with("Line 2: $root names “C”, which is no set."));
    assert!(told("@\n$root=X\nA=2^-1*A\n").starts_with("Line 2: $root names “X”"));
}

#[test]
fn views_come_with_shapes() {
    let plane = system("@\n$camera=[1,2,3,45]\nA=2^-1*(1|[1,0])*A\n");
    assert_eq!(plane.camera, Some(Camera::Plane { centre: [1.0, 2.0], radius: 3.0, angle: 45.0 }));
    let space = system("@\n$dim=3\n$camera=[[0,0,-3],[0,0,1],[0,1,0],30]\nA=2^-1*([0,0,0]|[1,0,0])*A\n");
    let wanted =
        Camera::Space { eye: [0.0, 0.0, -3.0], target: [0.0, 0.0, 1.0], up: [0.0, 1.0, 0.0], field: 30.0 };
    assert_eq!(space.camera, Some(wanted));
    // On a subspace its coordinates are others.
    let other =
        system("@\n$dim=2\n$subspace=[s,0]\n$camera=[1,2,3,4]\ns=$companion([1,-1])\nA=2^-1*(1|[1,0])*A\n");
    assert!(other.camera.is_none() && other.remarks[0].contains("$camera"), "{:?}", other.remarks);
}

#[test]
fn scripts_files_and_templates_are_left_out_and_said() {
    let found = read("export const a=1;\nexport function f(x){ return x; }\n@@\n@\nA=2^-1*A\n");
    assert!(found.remarks[0].contains("script") && found.systems.len() == 1, "{:?}", found.remarks);
    assert!(told("export const $aifs=[{A:'2^-1*A'}];\n@@\n@\nA=f(2)*A\n").contains("“f(” is not read"));
    let found = read("@@import other.aifs\n@\nA=2^-1*A\n@:other\nA=2^-1*A\n");
    assert!(found.remarks[0].contains("other.aifs") && found.systems.len() == 1, "{:?}", found.remarks);
    assert!(found.remarks[1].contains("There is no block “other”"), "{:?}", found.remarks);
    let finder = "@f\n&T=$vector()\nh=T\nA=2^-1*(1|h)*A\n";
    let found = read(&format!("{finder}@:f\nh=[1,0]\n@:f\nh=[0,1]*$number($integer(0,3))\n"));
    assert!(found.remarks[0].starts_with("2 blocks are templates"), "{:?}", found.remarks);
    assert!(told(finder).contains("finder chooses one"));
    assert!(system("@\n$background=1\nA=2^-1*A").remarks[0].starts_with("$background"));
}

#[test]
fn programs_are_written_that_open_again() {
    let names = ["Fougère", ""];
    for text in [
        "@\nA=3^-1*(1|[1,0]|[0,-1e-7]*[0,1,-1,0])*A\n",
        "@\n$dim=3\nA=2^-1*([0,0,0]|[1,0,0]|[0,1/3,0])*A\n",
        "@\n$dim=4\n$subspace=[s,0]\ns=$companion([1,-1,1,-1])\nA=(s-s^4)^-1*([1,0,0,0]*A|B)\nB=(s-s^4)^-1*([0,1,0,0]*A|[0,0,1,1]*B)\n",
        "@\n$dim=3\n$root=R\nA=2^-1*(1|[1,0,0])*A\nR=A|[0,6,0]*A\n",
    ] {
        for name in names {
            let mut one = system(text);
            one.name = name.into();
            let written = export(&one, ExportFormat::Aifs).unwrap();
            let again = system(&written);
            assert_eq!(again.name, name);
            if let Maps::Objects(_) = one.maps {
                assert!(again.maps.len() == one.maps.len() && again.check().is_ok(), "{written}");
            } else {
                assert_eq!(again.maps, one.maps, "{written}");
            }
            let other = export(&one, ExportFormat::Fractint);
            assert_eq!(other.is_err(), matches!(one.maps, Maps::Directed(_) | Maps::Objects(_)));
        }
    }
}
