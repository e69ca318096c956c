//! The kept corpus, an ordinary test: no sancov, no libFuzzer.

use std::path::Path;

use asbuilt_fuzz_targets::{TARGETS, seeds};

#[test]
fn every_kept_input_and_every_seed_is_survived() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus");
    let mut size = 0;
    for target in TARGETS {
        seeds(target.name).iter().for_each(|s| (target.run)(s));
        let mut files: Vec<_> =
            std::fs::read_dir(corpus.join(target.name)).into_iter().flatten().flatten().map(|e| e.path()).collect();
        files.sort();
        for file in files {
            let bytes = std::fs::read(&file).unwrap();
            size += bytes.len();
            println!("{}", file.display());
            (target.run)(&bytes);
        }
    }
    assert!(size <= 5 << 20, "the corpus holds {size} bytes; minimise it");
}
