//! One binary for all targets; the environment names the one that is fuzzed.

#![no_main]

use asbuilt_fuzz_targets::{TARGETS, Target};
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

fn target() -> &'static Target {
    static TARGET: OnceLock<&'static Target> = OnceLock::new();
    TARGET.get_or_init(|| {
        let name = std::env::var("ASBUILT_FUZZ_TARGET").expect("ASBUILT_FUZZ_TARGET names a target");
        TARGETS.iter().find(|t| t.name == name).expect("a target of that name")
    })
}

fuzz_target!(|data: &[u8]| (target().run)(data));
