//! What names tell of a part: glass, a frame, a leaf. Whole words count, in the languages in which models are drawn.

use serde::{Deserialize, Serialize};

/// What a part of a door or a window is by its name.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Role {
    #[default]
    Unknown,
    /// It stays where it is built in.
    Frame,
    /// It opens.
    Leaf,
}

/// Words that mean glass.
const GLASS: [&str; 29] = [
    "glass",
    "glazed",
    "glazing",
    "glas",
    "verglasung",
    "verglast",
    "scheibe",
    "beglazing",
    "verre",
    "vitrage",
    "vitrages",
    "vitré",
    "vitrée",
    "vidrio",
    "vidrios",
    "acristalamiento",
    "vidro",
    "vidros",
    "envidraçado",
    "vetro",
    "vetri",
    "vetrata",
    "szkło",
    "szklo",
    "sklo",
    "lasi",
    "стекло",
    "остекление",
    "üveg",
];

/// Ends of compound words that mean glass: Isolierglas, Floatglass, Isolierverglasung.
const GLASS_ENDS: [&str; 5] = ["glas", "glass", "glazing", "verglasung", "beglazing"];

/// Words, and beginnings of compounds, beside which glass is no pane: wool and fibre of it, foam, blocks, or what a
/// coat of paint makes opaque.
const NO_PANE: [&str; 33] = [
    "wool",
    "fiber",
    "fibre",
    "fibra",
    "fibres",
    "fleece",
    "foam",
    "foamed",
    "cellular",
    "block",
    "blocks",
    "brick",
    "bricks",
    "concrete",
    "reinforced",
    "mat",
    "mesh",
    "wolle",
    "vlies",
    "faser",
    "schaum",
    "stein",
    "baustein",
    "laine",
    "lana",
    "opaque",
    "opak",
    "spandrel",
    "mirror",
    "spiegel",
    "enamelled",
    "enameled",
    "painted",
];
const NO_PANE_STARTS: [&str; 6] = ["fiber", "fibre", "foam", "schaum", "zell", "doug"];

const FRAMES: [&str; 26] = [
    "frame",
    "lining",
    "jamb",
    "casing",
    "trim",
    "threshold",
    "sill",
    "rahmen",
    "blendrahmen",
    "zarge",
    "türzarge",
    "türrahmen",
    "futter",
    "schwelle",
    "kozijn",
    "dormant",
    "huisserie",
    "bâti",
    "cadre",
    "marco",
    "cerco",
    "aro",
    "telaio",
    "stipite",
    "ościeżnica",
    "karm",
];

const LEAVES: [&str; 25] = [
    "panel",
    "leaf",
    "sash",
    "framing",
    "casement",
    "flügel",
    "türflügel",
    "fensterflügel",
    "flügelrahmen",
    "blatt",
    "türblatt",
    "torblatt",
    "deur",
    "deurblad",
    "raamvleugel",
    "vantail",
    "ouvrant",
    "battant",
    "hoja",
    "folha",
    "anta",
    "battente",
    "skrzydło",
    "dörrblad",
    "dørblad",
];

/// Words in the names of windows that do not open.
const FIXED: [&str; 10] =
    ["fixed", "fest", "festverglast", "festverglasung", "vast", "fixe", "fijo", "fija", "fisso", "fixo"];

/// Whether the name of a window says that it does not open.
pub fn is_fixed(name: &str) -> bool {
    words(name).iter().any(|w| FIXED.contains(&w.as_str()))
}

/// Whether a name means glass that beams pass.
pub fn is_glass(name: &str) -> bool {
    let words = words(name);
    let starts_opaque = |w: &String| NO_PANE_STARTS.iter().any(|start| w.starts_with(start));
    let is_opaque = |w: &String| NO_PANE.contains(&w.as_str()) || starts_opaque(w);
    let ends = |w: &str| GLASS_ENDS.iter().any(|end| w.ends_with(end));
    words.iter().any(|w| GLASS.contains(&w.as_str()) || ends(w)) && !words.iter().any(is_opaque)
}

/// What the name of a part of a door or window tells; nothing where it names both.
pub fn role(name: &str) -> Role {
    let words = words(name);
    let any = |known: &[&str]| words.iter().any(|w| known.contains(&w.as_str()));
    match (any(&FRAMES), any(&LEAVES)) {
        (true, false) => Role::Frame,
        (false, true) => Role::Leaf,
        _ => Role::Unknown,
    }
}

/// Small letters; parted by what is no letter, and where a small letter is followed by a capital.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_small = false;
    for c in name.chars() {
        if !c.is_alphabetic() || (was_small && c.is_uppercase()) {
            words.push(String::new());
        }
        if let Some(last) = words.last_mut().filter(|_| c.is_alphabetic()) {
            last.extend(c.to_lowercase());
        }
        was_small = c.is_lowercase();
    }
    words.retain(|w| !w.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glass_by_name() {
        let panes = [
            "Glass",
            "Glas - klar",
            "Glazing",
            "GLAS_Isolier",
            "Isolierglas",
            "Verre trempé",
            "vidrio 6 mm",
            "Vetro",
            "Glass - Clear, Grey",
            "DoubleGlazing",
            "Dreischeiben-Isolierverglasung",
            "Szkło",
            "Plexiglas",
        ];
        for name in panes {
            assert!(is_glass(name), "{name}");
        }
        let others = [
            "Glass wool",
            "Glaswolle",
            "Douglas",
            "Fiberglass",
            "Fibre de verre",
            "Laine de verre",
            "Glass Block",
            "Schaumglas",
            "Spandrel glass",
            "Glasgow sandstone",
            "Hourglasses",
            "Holz",
            "",
            "Lana di vetro",
            "Glasfaser",
        ];
        for name in others {
            assert!(!is_glass(name), "{name}");
        }
    }

    #[test]
    fn roles_by_name() {
        assert_eq!(role("Door - Frame"), Role::Frame);
        assert_eq!(role("Lining"), Role::Frame);
        assert_eq!(role("Door - Panel"), Role::Leaf);
        assert_eq!(role("Framing"), Role::Leaf);
        assert_eq!(role("Flügel"), Role::Leaf);
        assert_eq!(role("Sash Frame"), Role::Unknown);
        assert_eq!(role("Frameless"), Role::Unknown);
        assert!(is_fixed("M_Fixed:819mm x 759mm") && !is_fixed("Casement: Festival"));
    }
}
