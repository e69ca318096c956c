//! The kept corpus, as an ordinary test: no sancov, no libFuzzer.

use std::path::Path;

use asbuilt_fuzz_targets::{End, TARGETS, replay, seeds};

#[test]
fn every_kept_input_and_every_seed_is_survived() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus");
    let mut size = 0;
    let mut bad = vec![];
    for target in TARGETS {
        let made = seeds(target.name).into_iter().map(|s| (replay(target, s), format!("seed of {}", target.name)));
        bad.extend(made.filter(|m| m.0 != End::Survived));
        let mut files: Vec<_> =
            std::fs::read_dir(corpus.join(target.name)).into_iter().flatten().flatten().map(|e| e.path()).collect();
        files.sort();
        for file in files {
            let bytes = std::fs::read(&file).unwrap();
            size += bytes.len();
            bad.extend(Some((replay(target, bytes), file.display().to_string())).filter(|m| m.0 != End::Survived));
        }
    }
    assert!(bad.is_empty(), "{bad:#?}");
    assert!(size <= 5 << 20, "the corpus holds {size} bytes; minimise it");
}
