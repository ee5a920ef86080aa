//! JSON: maps as the programming interface has them, alone or several, or as other programs have them, or a whole
//! document.

use frond_core::MAX_MAPS;
use frond_scene::{Scene, encode};
use serde_json::Value;

use super::json_map::{number_of, read_map};
use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::colour::read_hex;
use crate::system::{Maps, System};
use crate::text::{name_or, short};

/// What JSON holds.
pub enum Content {
    Systems(Gathered),
    /// The fragment of the link of a document.
    Link(String),
}

/// Reads JSON.
pub fn read_json(text: &str) -> Result<Content, ImportError> {
    let value: Value = serde_json::from_str(text).map_err(|error| ImportError::At {
        code: "json-broken",
        line: error.line(),
        why: format!(
            "The JSON breaks off or is miswritten there ({}). Mend it, or save it again.",
            short(&without_place(&error), 100)
        ),
    })?;
    if ["a", "b", "path"].iter().all(|key| value.get(key).is_some()) {
        return document(value).map(Content::Link);
    }
    let list = match &value {
        // Rows of one system.
        Value::Array(list) if list.iter().all(|row| row.is_array() || read_map(row).is_some()) => {
            std::slice::from_ref(&value)
        }
        Value::Array(list) => list,
        Value::Object(fields) => match fields.get("systems") {
            Some(Value::Array(list)) => list,
            _ => std::slice::from_ref(&value),
        },
        _ => &[],
    };
    let mut all = Gathered::of(list.len());
    for (k, value) in list.iter().take(MAX_SYSTEMS).enumerate() {
        all.take(system(value, k + 1));
    }
    all.finish(nothing()).map(Content::Systems)
}

fn nothing() -> ImportError {
    within(
        "json-nothing",
        "There are no maps in this JSON. They look so: { \"maps\": [[a, b, c, d, e, f], ..] }.".into(),
    )
}

fn within(code: &'static str, why: String) -> ImportError {
    ImportError::Within { code, why }
}

/// What lists of maps are called.
const LISTS: [&str; 10] = [
    "maps",
    "transforms",
    "transformations",
    "functions",
    "affine",
    "affines",
    "matrices",
    "rows",
    "rules",
    "ifs",
];

/// What is wrong, without the line and the column, which are said before.
fn without_place(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.rfind(" at line ").map_or(text.clone(), |at| text[..at].to_owned())
}

fn document(value: Value) -> Result<String, ImportError> {
    let wrong =
        |why: String| within("json-document", format!("This looks like a document of Frond, but {why}."));
    let scene: Scene = serde_json::from_value(value).map_err(|error| {
        wrong(format!("something in it is not as it should be: {}", short(&error.to_string(), 120)))
    })?;
    encode(&scene)
        .map_err(|error| wrong(format!("it cannot be opened. {}", error.to_string().trim_end_matches('.'))))
}

fn system(value: &Value, number: usize) -> Result<System, ImportError> {
    let name = value.get("name").and_then(Value::as_str).map_or_else(String::new, |name| name_or(name, ""));
    let whose = if name.is_empty() { format!("System {number}") } else { format!("“{name}”") };
    let wrong = |code, why: &str| within(code, format!("{whose}: {why}"));
    let list = LISTS.iter().find_map(|name| value.get(*name)).unwrap_or(value);
    let Some(list) = list.as_array() else { return Err(nothing()) };
    if list.len() > MAX_MAPS {
        return Err(wrong(
            "json-maps",
            &format!("there are {} maps, and the most is 64. Leave some out.", list.len()),
        ));
    }
    let numbers = |list: &Value| -> Option<Vec<f64>> { list.as_array()?.iter().map(number_of).collect() };
    let (mut rows, mut weights) = (Vec::new(), Vec::new());
    for (k, row) in list.iter().enumerate() {
        let Some(map) = read_map(row) else {
            let why = format!(
                "map {} is no list of six numbers, or twelve for space, with a weight or without one, and no object \
                 with the letters a to f.",
                k + 1
            );
            return Err(wrong("json-map", &why));
        };
        rows.push(map.row);
        weights.push(map.weight);
    }
    let Some(size) = rows.first().map(Vec::len) else { return Err(nothing()) };
    if rows.iter().any(|row| row.len() != size) {
        return Err(wrong("json-map", "some maps are of the plane and some of space. Leave one kind out."));
    }
    let maps = if size == 12 {
        Maps::Space(rows.iter().map(|row| std::array::from_fn(|k| row[k])).collect())
    } else {
        Maps::Plane(rows.iter().map(|row| std::array::from_fn(|k| row[k])).collect())
    };
    let mut system = System::of(name, maps);
    if let Some(given) = value.get("probabilities") {
        match numbers(given) {
            Some(given) if given.len() == rows.len() => {
                system.take_weights(&given.into_iter().map(Some).collect::<Vec<_>>());
            }
            _ => system.remarks.push("Its probabilities are not one number for each map: left out.".into()),
        }
    } else {
        system.take_weights(&weights);
    }
    if let Some(given) = value.get("colours") {
        let colours = given.as_array().filter(|list| list.len() == rows.len()).and_then(|list| {
            list.iter().map(|one| one.as_str().and_then(read_hex)).collect::<Option<Vec<_>>>()
        });
        match colours {
            Some(colours) => system.colours = colours,
            None => system.remarks.push("Its colours are not one \"#rrggbb\" for each map: left out.".into()),
        }
    }
    Ok(system)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn systems(text: &str) -> Vec<System> {
        match read_json(text).unwrap() {
            Content::Systems(all) => all.systems,
            Content::Link(link) => panic!("{link}"),
        }
    }

    #[test]
    fn maps_are_read_alone_or_several() {
        let half = [0.5, 0.0, 0.0, 0.5, 1.0, 0.0];
        let row = "[0.5, 0, 0, 5e-1, 1, 0]";
        for text in [
            format!("[{row}]"),
            format!("{{\"maps\":[{row}]}}"),
            format!("[{{\"maps\":[{row}]}}]"),
            format!("{{\"systems\":[{{\"maps\":[{row}]}}]}}"),
        ] {
            assert_eq!(systems(&text)[0].maps, Maps::Plane(vec![half]), "{text}");
        }
        let two = systems(&format!(
            "[{{\"name\":\" Fern \",\"maps\":[{row}],\"probabilities\":[2]}},{{\"maps\":[{row}]}}]"
        ));
        assert_eq!((two[0].name.as_str(), &two[0].probabilities[..]), ("Fern", &[2.0][..]));
        assert_eq!(two.len(), 2);
    }

    #[test]
    fn maps_of_other_programs_are_read() {
        let fern = vec![[0.0, 0.0, 0.0, 0.16, 0.0, 0.0], [0.85, 0.04, -0.04, 0.85, 0.0, 1.6]];
        for text in [
            "[[0, 0, 0, 0.16, 0, 0, 0.01], [0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85]]",
            r#"{"name": "fern", "transforms": [{"a": 0, "b": 0, "c": 0, "d": 0.16, "e": 0, "f": 0, "p": 0.01},
                {"a": 0.85, "b": 0.04, "c": -0.04, "d": 0.85, "e": 0, "f": 1.6, "p": 0.85}]}"#,
            r#"[{"a": 0, "b": 0, "c": 0, "d": 0.16, "e": 0, "f": 0, "p": 0.01},
                {"a": 0.85, "b": 0.04, "c": -0.04, "d": 0.85, "e": 0, "f": 1.6, "p": 0.85}]"#,
            r#"{"iterations": 28, "transformations": [["0.01", "0, .16*y"], ["0.85", ".85*x + .04*y, -.04*x + .85*y + 1.6"]]}"#,
            r#"{"maps": [["0", "0", "0", "4/25", "0", "0"], [0.85, "1/25", "-1/25", 0.85, 0, "8/5"]], "probabilities": ["1/100", 0.85]}"#,
        ] {
            let found = systems(text).remove(0);
            assert_eq!(found.maps, Maps::Plane(fern.clone()), "{text}");
            assert_eq!(found.probabilities, [0.01, 0.85], "{text}");
        }
    }

    #[test]
    fn a_document_is_a_link() {
        let (graph, _) = frond_scene::decode("directed-a=sun&directed-b=states:1,0.5,0,0,0.5,0,0");
        assert!(graph.directed.is_some());
        for scene in [Scene::default(), graph] {
            // What is said beside it is passed over.
            let mut value = serde_json::to_value(&scene).unwrap();
            value["about"] = "A document of Frond".into();
            let Content::Link(link) = read_json(&value.to_string()).unwrap() else { panic!() };
            assert_eq!(frond_scene::decode(&link), (scene, None));
        }
    }

    #[test]
    fn mistakes_are_told() {
        let told = |text: &str| read_json(text).map(|_| ()).unwrap_err().to_string();
        assert!(
            told("{\n\"maps\": [\n[1,2,]]}").starts_with("Line 3: The JSON breaks off"),
            "{}",
            told("{\n\"maps\": [\n[1,2,]]}")
        );
        assert!(told("{}").starts_with("There are no maps"));
        assert!(told("3").starts_with("There are no maps"));
        assert!(told("[[1,2,3,4,5,6],[1,2]]").contains("map 2 is no list"));
        assert!(
            told(&format!("[{}[1,2,3,4,5,6]]", "[1,2,3,4,5,6],".repeat(64))).contains("there are 65 maps")
        );
        assert!(told("{\"a\":1,\"b\":2,\"path\":3}").starts_with("This looks like a document of Frond"));
    }
}
