//! Every reader on its documents and on drafts, the same ones every time; or, where libFuzzer makes the choices, on
//! any bytes and on drafts.

/// Tries a reader on the documents of its folder, and then on drafts.
#[cfg(not(fuzzing))]
fn replay(reader: &frond_fuzz::Reader) {
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;

    let documents = reader.documents();
    for (name, document) in &documents {
        println!("{}/{name}", reader.name);
        reader.try_on(document);
    }
    let cases = ProptestConfig::with_cases(frond_testing::cases(200));
    let config = ProptestConfig { failure_persistence: None, max_shrink_iters: 60, ..cases };
    let bytes = proptest::collection::vec(any::<u8>(), 0..400);
    let outcome = TestRunner::new(config).run(&bytes, |bytes| {
        let Some(draft) = frond_fuzz::Draft::of_bytes(&bytes) else { return Ok(()) };
        reader.try_on(&draft.write(reader, &documents));
        Ok(())
    });
    outcome.unwrap_or_else(|problem| panic!("{}: {problem}", reader.name));
}

#[cfg(not(fuzzing))]
macro_rules! tests {
    ($($test:ident: $reader:ident),*) => {
        $(
            #[test]
            fn $test() {
                replay(&frond_fuzz::$reader);
            }
        )*

        #[test]
        fn every_folder_is_that_of_a_reader() {
            let mut readers = vec![$(frond_fuzz::$reader.name),*];
            readers.sort_unstable();
            let all = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/fuzz");
            let entries = std::fs::read_dir(all).expect("a folder");
            let mut folders: Vec<_> = entries.map(|entry| entry.expect("an entry").file_name()).collect();
            folders.sort_unstable();
            assert_eq!(folders, readers);
        }
    };
}

#[cfg(fuzzing)]
macro_rules! tests {
    ($($target:ident: $reader:ident),*) => {
        mod bytes {
            $(
                #[test]
                fn $target() {
                    bolero::check!().for_each(|document| frond_fuzz::$reader.try_on(document));
                }
            )*
        }

        mod drafts {
            $(
                #[test]
                fn $target() {
                    let reader = frond_fuzz::$reader;
                    let documents = reader.documents();
                    bolero::check!().with_type::<frond_fuzz::Draft>().for_each(move |draft| {
                        reader.try_on(&draft.write(&reader, &documents));
                    });
                }
            )*
        }
    };
}

frond_fuzz::all_readers!(tests);
