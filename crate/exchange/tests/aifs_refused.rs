//! Programs of IFStile that are wrong, or go on without end: each is refused with a sentence that says what to do.

use frond_exchange::{System, import};

fn system(text: &str) -> System {
    let mut found = import(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(found.systems.len(), 1, "{text}");
    found.systems.remove(0)
}

fn told(text: &str) -> String {
    match import(text.as_bytes()) {
        Ok(found) => panic!("{text}: {found:?}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn what_is_not_read_is_told_with_its_line() {
    let count = |n: usize| vec!["1"; n].join(",");
    for (text, start) in [
        ("@\n$dim=4\nA=2^-1*A", "Line 3: The maps have 4 dimensions, and 1 to 3 are drawn."),
        ("@\n$dim=1000\nA=2^-1*A", "Line 2: $dim is a whole number from 1 to 12."),
        ("@\n$dim=2.5\nA=2^-1*A", "Line 2: $dim is a whole number"),
        ("@\n$subspace=[s,1]\ns=$companion([1,1])\nA=2^-1*A", "Line 2: $subspace asks for cell 1"),
        ("@\n$subspace=[s]\ns=2\nA=2^-1*A", "Line 2: $subspace names no cells"),
        ("@\n$subspace=s\ns=2\nA=2^-1*A", "Line 2: $subspace is a matrix and its cells"),
        ("@\n$subspace=[s,0.5]\ns=2\nA=2^-1*A", "Line 2: The cells of $subspace are whole numbers"),
        ("@\n$subspace=[s,0,0]\ns=2\nA=2^-1*A", "Line 2: $subspace names cell 0 twice"),
        // 1 and -1 are the roots: a shear does not respect the line of one.
        (
            "@\n$dim=2\n$subspace=[[0,1,1,0],0]\nA=2^-1*[1,1,0,1]*A",
            "Line 4: Map 1 of “A” does not act on the subspace",
        ),
        (
            &format!("@\n$dim=12\ns=$companion([{}])\nA=s*A", count(200)),
            "Line 3: A companion matrix has 1 to 12 numbers, and here are 200.",
        ),
        ("@\nA=1/0*A", "Line 2: A number is divided by 0."),
        ("@\nA=[1,0,0,0]^-1*A", "Line 2: A map that has no inverse is inverted"),
        ("@\nA=h*A\nh=k", "Line 3: “k” is not defined."),
        ("@\nx=[x]\nA=x*A", "Line 2: “x” is defined by itself and comes to a list"),
        ("@\nf=[$,1,$()]\nA=[f[0],0]*A", "Line 2: A list is longer than 4096."),
        ("@\nf=[$,1]\nA=f*A", "Line 2: A list is longer than 4096."),
        (
            "@\n$dim=2\n$subspace=[s,1]\ns=$companion([-1,-1,-1])\nA=2^-1*A",
            "Line 3: The matrix of $subspace has 3 dimensions",
        ),
        ("@\n$dim=2\nA=2^-1*(1+$companion([1,2,3]))*A", "Line 3: A map of 2 dimensions meets one of 3."),
        ("@\nA=[1,2][2]*A", "Line 2: A list of 2 is asked for an element"),
        ("@\nA=[1,0*A", "Line 2: A list is not closed."),
        ("@\nA=(1|2*A", "Line 2: A bracket is missing its partner."),
        ("@\nA=[1,2,3]*A", "Line 2: A list of 3 numbers is neither a translation nor a matrix"),
        ("@\nA=(1|2|3|4|5)^3*A", "Line 2: There are more than 64 maps"),
        ("@\nA=(1|A)*A", "Line 2: Sets are united with maps."),
        ("@\nA=A*2", "Line 2: A set stands before “*”"),
        ("@\nA=2^9999*A", "Line 2: A number becomes too large."),
        ("@\nA=1e9999*A", "Line 2: “1e9999” is no number, or has too many digits."),
        ("@\nh=1", "Line 1: No block has an equation"),
        ("@\nA=$e*A", "Line 2: Nothing is in “A”."),
        ("@\nA=nothing(2)*A", "Line 2: “nothing(” is not read"),
        ("@\nA=$what(2)*A", "Line 2: “$what(” is not read"),
        ("@\nA=$number()*A", "Line 2: “$number” stands for many values"),
        ("@\nA=2^-1*A\nno equation", "Line 3: No name and value"),
        ("@\nA=(-1)^(1/2)*A", "Line 2: A broken power"),
    ] {
        let found = told(text);
        assert!(found.starts_with(start), "{text}: {found}");
        assert!(found.ends_with('.') && found.len() < 400, "{found}");
    }
    // What does not shrink is a system without a shape, which says so.
    let problem = |text: &str| system(text).check().unwrap_err().to_string();
    assert!(problem("@\nA=A").contains("no attractor"));
    assert!(problem("@\nA=B\nB=(1|2^-1)*A").contains("no attractor"));
}

#[test]
fn nothing_goes_on_without_end() {
    // Each in an instant, or refused after so many steps.
    let names: String = (1..70).map(|k| format!("n{k}=n{}\n", k - 1)).collect();
    let million = vec!["1"; 1_000_000].join("|");
    let wide: String = (1..20).map(|k| format!("u{k}=(u{}|u{})\n", k - 1, k - 1)).collect();
    let calls: String =
        (1..30).map(|k| format!("@f{k}\n$a=h\nx=1\nret=f{}(x)+f{}(x)\n", k - 1, k - 1)).collect();
    let fraction = |k: usize| format!("{}/{}", 3 * k % 97 + 1, k * k % 89 + 2);
    let dense = (0..144).map(fraction).collect::<Vec<_>>().join(",");
    for (text, part) in [
        ("@a\n$a=h\nr=b()\n@b\n$a=h\nr=a()\n@\nA=a()*A\n".to_owned(), "go on without end"),
        (format!("@\nn0=n69\n{names}A=n69*A\n"), "made of 70 sets"),
        (format!("@\nA=({million})*A\n"), "more than 64 maps"),
        (format!("@\nu0=1\n{wide}A=u19*A\n"), "more than 64 maps"),
        (format!("@f0\n$a=h\nx=1\nret=x\n{calls}@\nA=f29(2)*A\n"), "too many steps"),
        ("@\nf=[$,1,[$,1,$()]]\nA=f*A\n".into(), "longer than 4096"),
        ("@\nf=[$,9-$(),[$,4000-$(),[$,4000-$(),1]]]\nA=f*A\n".into(), "too many steps"),
        ("@\nx=[$,4000-$(),1]\nf=[$,4000-$(),x+x]\nA=f*A\n".into(), "too many steps"),
        (
            "@\n$dim=12\n$subspace=[s,0]\ns=$companion([1,2,3,4,5,6,7,8,9,1,2,3])^5000\nA=s*A\n".into(),
            "too many steps",
        ),
        // Long fractions, which take long.
        (format!("@\n$dim=12\ns=[{dense}]\nA=(((s^-1)*s*s)^-1*s^9)^-7*A\n"), "too many steps"),
        ("@\nf=[1/3,$,4000-$(),$[-1]+1/(7+$())]\nA=f*A\n".repeat(60), "becomes too large"),
        ("@g\n$a=h\n&f=f+1\nret=f\n@\nA=g()*A\n".into(), "go on without end"),
        ("@\n$dim=$dim\nA=2^-1*A\n".into(), "is defined by itself"),
    ] {
        let found = told(&text);
        assert!(found.contains(part), "{}: {found}", &text[..text.len().min(60)]);
    }
}
