//! Patches, gathered rows and evidence out of their stored forms.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::scan::{Patch, PatchBuilder};
use asbuilt_core::verify::{Evidence, EvidenceModel, VerdictRule};

use crate::bounded;
use crate::checksum::mended;

pub fn patch(data: &[u8]) {
    for bytes in [data.to_vec(), mended(data)] {
        let _ = Patch::beams_of(&bytes);
        if let Ok(patch) = Patch::from_bytes(&bytes) {
            assert_eq!(Patch::from_bytes(&patch.to_bytes()).ok(), Some(patch), "a patch changed through its bytes");
        }
        edits(&bytes);
    }
}

/// What SQL does with a stored patch, which it trusts more than bytes from outside.
pub fn edits(bytes: &[u8]) {
    let Ok((header, content)) = Patch::content_of(bytes) else { return };
    let half = Aabb { min: header.points.min, max: header.points.centre().into() };
    let _ = header.sees(&half, 0.1);
    let _ = Patch::within(bytes, &half);
    let _ = Patch::between(bytes, 0.5, 10.0);
    let _ = Patch::thinned(bytes, 0.05);
    let _ = bounded(|i| Patch::union(&[bytes, bytes], i));
    let _ = bounded(|i| Patch::retiled(&[bytes, bytes], i));
    let _ = content.spacing(header.origins());
}

pub fn gathered(data: &[u8]) {
    let Ok(g) = bounded(|i| PatchBuilder::from_bytes(data, i)) else { return };
    let bytes = g.to_bytes(NEVER).unwrap();
    let again = PatchBuilder::from_bytes(&bytes, NEVER).and_then(|g| g.to_bytes(NEVER));
    assert_eq!(again.ok(), Some(bytes), "rows changed through their bytes");
    let mut twice = g.clone();
    let _ = twice.merge(&g, NEVER);
    for patch in bounded(|i| g.patches(i)).unwrap_or_default() {
        let bytes = patch.to_bytes();
        assert!(Patch::content_of(&bytes).is_ok(), "a packed patch cannot be read");
    }
}

pub fn evidence(data: &[u8]) {
    for bytes in [data.to_vec(), mended(data)] {
        let _ = Evidence::header(&bytes);
        if let Ok(e) = bounded(|i| Evidence::from_bytes(&bytes, i)) {
            same_through_bytes(&e);
            questions(&e);
        }
    }
}

pub fn same_through_bytes(e: &Evidence) {
    let Ok(bytes) = bounded(|i| e.to_bytes(i)) else { return };
    match bounded(|i| Evidence::from_bytes(&bytes, i)) {
        // Not-a-number in a sum is unequal to itself: compare what is stored.
        Ok(again) => assert_eq!(bounded(|i| again.to_bytes(i)).ok(), Some(bytes), "evidence changed through its bytes"),
        Err(asbuilt_core::Error::Interrupted) => {}
        Err(e) => panic!("evidence is refused as its own bytes: {e}"),
    }
}

/// Every question that SQL puts to evidence.
pub fn questions(e: &Evidence) {
    let rule = VerdictRule::default();
    for model in [*e.model(), EvidenceModel::default()] {
        let _ = bounded(|i| e.summary(&model.question, &rule, i));
        let _ = bounded(|i| e.verdict(&model.question, &rule, i));
        let _ = bounded(|i| e.faces(&model.question, i));
        let _ = bounded(|i| e.explain(&model.question, &rule, i));
    }
    let _ = bounded(|i| e.rigid_shift(i)).map(|s| s.map(|s| s.to_text()));
    let mut twice = e.clone();
    let _ = bounded(|i| twice.merge(e, i));
    same_through_bytes(&twice);
}
