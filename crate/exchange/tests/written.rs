//! What programs and papers are given: the words themselves, where nothing reads them back here.

use frond_exchange::{ExportFormat, System, export};

fn plane() -> System {
    let root = 3.0_f64.sqrt() / 4.0;
    let rows = vec![[0.5, 0.0, 0.0, 0.25, 1.0 / 3.0, 0.0], [root, -0.25, 0.25, root, 0.0, 1.0]];
    System::plane("A \\b {c}\n d".into(), rows)
}

fn space() -> System {
    let row = |x| [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.25, x, 0.0, 1.0];
    System::space(String::new(), vec![row(0.0), row(1.0)])
}

fn holds(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
}

#[test]
fn python_has_what_it_needs() {
    let text = export(&plane(), ExportFormat::Python).unwrap();
    let rows = "    [0.5, 0, 0, 0.25, 1/3, 0],\n    [sqrt(3)/4, -0.25, 0.25, sqrt(3)/4, 0, 1],\n";
    let linear = "linear = maps[:, :4].reshape(-1, 2, 2)\nshift = maps[:, 4:]\n";
    holds(&text, &["# A \\b {c} d, from Frond.", "\nfrom math import sqrt\n", rows, linear]);
    let text = export(&space(), ExportFormat::Python).unwrap();
    holds(
        &text,
        &["linear = maps[:, :9].reshape(-1, 3, 3)\nshift = maps[:, 9:]\n", "projection=\"3d\"", "np.eye(3)"],
    );
    assert!(!text.contains("sqrt"), "{text}");
}

#[test]
fn papers_have_matrices() {
    let text = export(&plane(), ExportFormat::Latex).unwrap();
    let first = "f_{1}(x) &= \\begin{pmatrix} 0.5 & 0 \\\\ 0 & 0.25 \\end{pmatrix} x + \
                 \\begin{pmatrix} \\frac{1}{3} \\\\ 0 \\end{pmatrix} \\\\[2pt]\n";
    holds(&text, &["% A b c d. Needs \\usepackage{amsmath}.\n", first, "\\frac{\\sqrt{3}}{4} & -0.25"]);
    let text = export(&space(), ExportFormat::Latex).unwrap();
    holds(
        &text,
        &[
            "0.5 & 0 & 0 \\\\ 0 & 0.5 & 0 \\\\ 0 & 0 & 0.25",
            "\\begin{pmatrix} 1 \\\\ 0 \\\\ 1 \\end{pmatrix}",
        ],
    );
}

#[test]
fn figures_lie_in_their_box_in_colours_that_they_define() {
    let rows = vec![
        [0.5, 0.0, 0.0, 0.5, 5.0, -5.0],
        [0.5, 0.0, 0.0, 0.4, 6.0, -5.0],
        [0.3, 0.1, 0.0, 0.4, 6.0, -6.0],
    ];
    let text = export(&System::plane(String::new(), rows), ExportFormat::Tikz).unwrap();
    for line in text.lines().filter(|line| line.contains("draw[")) {
        let numbers = line.split(['(', ')']).skip(1).step_by(2).flat_map(|at| at.split(','));
        let numbers: Vec<f64> = numbers.map(|x| x.parse().unwrap()).collect();
        assert!(numbers.len() >= 6 && numbers.iter().all(|x| (-0.01..8.01).contains(x)), "{line}");
    }
    for (k, place) in text.match_indices("[frond").map(|(at, _)| (at, &text[at + 6..at + 8])) {
        assert!(["1]", "2]", "3]"].contains(&place), "{}", &text[k..k + 80]);
    }
    for colour in 1..=3 {
        holds(&text, &[&format!("\\definecolor{{frond{colour}}}"), &format!("\\filldraw[frond{colour}]")]);
    }
    assert_eq!(text.matches("\\draw[gray").count(), 3);
}

#[test]
fn boards_have_functions_and_lists() {
    let text = export(&plane(), ExportFormat::Geogebra).unwrap();
    let first = "Zip(((0.5) x(P) + (0) y(P) + (1/3), (0) x(P) + (0.25) y(P) + (0)), P, A_{0})";
    let second =
        "Zip(((sqrt(3)/4) x(P) + (-0.25) y(P) + (0), (0.25) x(P) + (sqrt(3)/4) y(P) + (1)), P, A_{0})";
    // Of 2^11 points, the most that are below 3000.
    holds(&text, &[first, second, "SetPointSize(A_{11}, 1)"]);
    assert!(!text.contains("A_{12}"));
    let text = export(&plane(), ExportFormat::Desmos).unwrap();
    let line = |x: &str, y: &str, shift: &str| {
        format!("\\left({x}\\right)p.x+\\left({y}\\right)p.y+\\left({shift}\\right)")
    };
    let root = "\\frac{\\sqrt{3}}{4}";
    let second = format!("\\left({},{}\\right)\n", line(root, "-0.25", "0"), line("0.25", root, "1"));
    let join =
        "A_{1}=\\operatorname{join}\\left(f_{1}\\left(A_{0}\\right),f_{2}\\left(A_{0}\\right)\\right)\n";
    holds(&text, &[&second, join, "\nA_{12}="]);
    assert!(!text.contains("A_{13}"));
    // One list alone cannot be joined.
    let one = System::plane(String::new(), vec![[0.5, 0.0, 0.0, 0.5, 1.0, 0.0]]);
    holds(&export(&one, ExportFormat::Desmos).unwrap(), &["A_{1}=f_{1}\\left(A_{0}\\right)\n"]);
}

#[test]
fn tables_have_headings_and_nothing_is_written_that_is_no_number() {
    holds(&export(&plane(), ExportFormat::Csv).unwrap(), &["a,b,c,d,e,f,p\n0.5,0,0,0.25,"]);
    holds(&export(&space(), ExportFormat::Csv).unwrap(), &["a,b,c,d,e,f,g,h,i,x,y,z,p\n0.5,0,0,0,0.5,"]);
    for wrong in [f64::NAN, f64::INFINITY] {
        let mut system = plane();
        system.probabilities = vec![1.0, wrong];
        for format in ExportFormat::ALL {
            assert_eq!(export(&system, format).unwrap_err().code(), "export-not-finite");
        }
    }
    // Nor what would be read back as something else.
    for wrong in [&[1.0][..], &[0.5, 0.25, 0.25], &[1.0, -1.0], &[1e308, 1e308]] {
        let mut system = plane();
        system.probabilities = wrong.to_vec();
        for format in ExportFormat::ALL {
            assert_eq!(export(&system, format).unwrap_err().code(), "export-weights", "{wrong:?}");
        }
    }
}
