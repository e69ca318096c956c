//! Text forms: what is accepted reads back the same.

use std::fmt::Debug;

use asbuilt_core::Result;
use asbuilt_core::evidence::Mass;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::uncertain::{Stored, UncertainLine, UncertainPlane, UncertainPoint, UncertainPose};
use asbuilt_core::verify::EvidenceModel;
use asbuilt_core::voxel::Grid;

/// The first byte chooses the type.
pub fn read(data: &[u8]) {
    let Some((which, text)) = data.split_first() else { return };
    let Ok(text) = std::str::from_utf8(text) else { return };
    match which % 8 {
        0 => same(text, Aabb::from_text, Aabb::to_text),
        1 => same(text, Grid::from_text, Grid::to_text),
        2 => same(text, EvidenceModel::from_text, EvidenceModel::to_text),
        3 => same(text, Mass::from_text, Mass::to_text),
        4 => stored::<UncertainPoint, 9>(text),
        5 => stored::<UncertainLine, 27>(text),
        6 => stored::<UncertainPlane, 16>(text),
        _ => stored::<UncertainPose, 36>(text),
    }
}

fn same<T: PartialEq + Debug>(text: &str, from: impl Fn(&str) -> Result<T>, to: impl Fn(&T) -> String) {
    let Ok(value) = from(text) else { return };
    let again = to(&value);
    match from(&again) {
        Ok(back) => {
            assert_eq!(value, back, "{again:?} is another value than {text:?}");
            assert_eq!(to(&back), again);
        }
        Err(e) => panic!("{again:?}, written for {text:?}, is refused: {e}"),
    }
}

fn stored<T: Stored<N> + PartialEq + Debug, const N: usize>(text: &str) {
    // A pose or plane is made unit-length when it is read: the second reading may round, but not fail.
    let Ok(value) = T::from_text(text) else { return };
    let again = value.to_text();
    assert!(T::from_text(&again).is_ok(), "{again:?}, written for {text:?}, is refused");
}
