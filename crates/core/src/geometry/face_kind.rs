//! What a face is made of, as far as beams care.

use super::Solid;

/// What a face belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum FaceKind {
    /// What stands where it is drawn.
    #[default]
    Fixed,
    /// A leaf, a sash: it may stand elsewhere.
    Movable,
    /// A pane: most beams pass it.
    Transparent,
}

impl FaceKind {
    /// Of triangle `t`; a pane in a leaf is a pane.
    pub fn of(solid: &Solid, t: usize) -> Self {
        match () {
            () if solid.is_transparent(t) => Self::Transparent,
            () if solid.is_movable(t) => Self::Movable,
            () => Self::Fixed,
        }
    }

    /// By its number, in the order above.
    pub fn of_number(number: u8) -> Option<Self> {
        [Self::Fixed, Self::Movable, Self::Transparent].get(usize::from(number)).copied()
    }
}
