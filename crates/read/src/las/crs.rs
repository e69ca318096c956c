//! Units of a LAS file's coordinates, as stated by its GeoTIFF keys or its well-known text.

use anyhow::{Context, Result, bail};
use las::Header;
use las::crs::{GeoTiffCrs, GeoTiffData};

use super::wkt::Node;

/// Length in metres of the horizontal and the vertical unit; `None` where the file does not tell it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Units {
    pub across: Option<f64>,
    pub up: Option<f64>,
    /// Whether the file names a coordinate system, understood or not.
    pub has_system: bool,
}

const DEGREES: &str =
    "its coordinates are degrees, which are no lengths: project them first, e.g. with PDAL's filters.reprojection";

/// What the file says.
pub fn units(header: &Header) -> Result<Units> {
    if let Some(bytes) = header.get_wkt_crs_bytes() {
        let text = String::from_utf8_lossy(bytes);
        let text = text.trim_end_matches('\0').trim();
        if !text.is_empty() {
            return of_wkt(text);
        }
    }
    match header.get_geotiff_crs() {
        Ok(Some(keys)) => of_keys(&keys),
        Ok(None) => Ok(Units::default()),
        // Their directory is damaged: what they say of the unit is lost.
        Err(_) => Ok(Units { has_system: true, ..Units::default() }),
    }
}

/// From OGC well-known text, versions 1 and 2.
fn of_wkt(text: &str) -> Result<Units> {
    let mut units = Units { has_system: true, ..Units::default() };
    let Some(roots) = Node::parse_all(text) else { return Ok(units) };
    for system in roots.iter().flat_map(|root| systems(root, 0)) {
        if system.is(&["GEOGCS", "GEOGCRS", "GEODCRS", "GEOGRAPHICCRS", "GEODETICCRS"]) && !is_geocentric(system) {
            bail!(DEGREES);
        }
        if system.is(&PROJECTED) {
            let code = || system.child(&["AUTHORITY", "ID"]).and_then(Node::code);
            units.across = match unit_of(system) {
                None => code().map(of_system).transpose()?.flatten(),
                told => told,
            };
            // The third axis of a system in space.
            let axes: Vec<&Node> = system.children().iter().filter(|c| c.is(&["AXIS"])).collect();
            units.up = axes.get(2).and_then(|axis| axis.child(&UNITS)?.number()).or(units.up);
        } else if system.is(&["VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"]) {
            units.up = unit_of(system);
        }
    }
    Ok(units)
}

const PROJECTED: [&str; 7] =
    ["PROJCS", "PROJCRS", "PROJECTEDCRS", "DERIVEDPROJCRS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"];

/// The systems that a system consists of: all parts of a compound one, the source of a bound one.
fn systems(root: &Node, depth: usize) -> Vec<&Node> {
    if depth > 8 || !root.is(&["COMPD_CS", "COMPOUNDCRS", "BOUNDCRS", "SOURCECRS"]) {
        return vec![root];
    }
    let parts = root.children().iter().filter(|c| !root.is(&["BOUNDCRS"]) || c.is(&["SOURCECRS"]));
    parts.flat_map(|part| systems(part, depth + 1)).collect()
}

fn is_geocentric(system: &Node) -> bool {
    system.child(&["CS"]).is_some_and(|cs| cs.word(0).is_some_and(|w| w.eq_ignore_ascii_case("cartesian")))
}

/// The unit of a system itself, or of its first axis.
fn unit_of(system: &Node) -> Option<f64> {
    let own = system.child(&UNITS);
    own.or_else(|| system.child(&["AXIS"])?.child(&UNITS))?.number().filter(|m| *m > 0.0)
}

const UNITS: [&str; 2] = ["UNIT", "LENGTHUNIT"];

/// From GeoTIFF keys (OGC 19-008r4).
fn of_keys(keys: &GeoTiffCrs) -> Result<Units> {
    let find = |id: u16| keys.entries.iter().find(|e| e.id == id).map(|e| &e.data);
    let code = |id: u16| match find(id) {
        Some(GeoTiffData::U16(code)) if *code != 0 => Some(*code),
        _ => None,
    };
    let size = |id: u16| match find(id) {
        Some(GeoTiffData::Doubles(sizes)) => sizes.first().copied(),
        _ => None,
    };
    // GTModelTypeGeoKey: geographic; or where it is missing, a geographic system and no projected one.
    let has = |id: u16| code(id).is_some_and(|code| code != 32_767);
    let is_bare = !matches!(code(1024), Some(1 | 3)) && !has(3072) && !has(3076);
    if code(1024) == Some(2) || (is_bare && (has(2048) || has(2054))) {
        bail!(DEGREES);
    }
    let unit = |key: u16, size_key: u16| match code(key) {
        Some(32_767) => size(size_key).map(Ok),
        Some(code) => Some(metres(code)),
        None => None,
    };
    // The system's own unit where no key tells it.
    let across = match unit(3076, 3077) {
        Some(metres) => Some(metres?),
        None => code(3072).map(of_system).transpose()?.flatten(),
    };
    let up = match unit(4099, 4100) {
        Some(metres) => Some(metres?),
        None => code(4096).and_then(of_vertical_system),
    };
    Ok(Units { across, up, has_system: !keys.entries.is_empty() })
}

/// Units of length by their EPSG code.
fn metres(code: u16) -> Result<f64> {
    Ok(match code {
        9001 => 1.0,
        9002 => 0.3048,
        9003 => 1200.0 / 3937.0,
        9005 => 0.304_797_265_4,
        9014 => 1.8288,
        9030 => 1852.0,
        9036 => 1000.0,
        9037 => 0.914_398_404_5,
        9084 => 0.914_398_555,
        9094 => 0.304_799_71,
        9095 => 0.304_799_47,
        9096 => 0.9144,
        9101..=9122 => bail!(DEGREES),
        _ => bail!("its unit of length is EPSG:{code}, which is not known: convert it to metres first"),
    })
}

/// The unit of a projected system by its EPSG code, where known.
fn of_system(code: u16) -> Result<Option<f64>> {
    let Some(definition) = crs_definitions::from_code(code) else { return Ok(None) };
    let word = |key: &str| definition.proj4.split_whitespace().find_map(|w| w.strip_prefix(key));
    if word("+proj=") == Some("longlat") {
        bail!(DEGREES);
    }
    if let Some(size) = word("+to_meter=") {
        return Ok(size.parse().ok());
    }
    Ok(match word("+units=") {
        Some("m") => Some(1.0),
        Some("ft") => Some(0.3048),
        Some("us-ft") => Some(1200.0 / 3937.0),
        Some("km") => Some(1000.0),
        other => bail!("its system EPSG:{code} counts in {}, which is not known", other.unwrap_or("no unit")),
    })
}

/// Vertical systems in feet; the others in use are in metres.
fn of_vertical_system(code: u16) -> Option<f64> {
    match code {
        // NAVD88 and NGVD29 in US survey feet, NAVD88 in feet.
        6360 | 5702 => Some(1200.0 / 3937.0),
        8228 => Some(0.3048),
        5600..=5799 | 7837 | 3855 => Some(1.0),
        _ => None,
    }
}

/// Factors from x, y and z to metres, and what to tell the user about them.
pub fn factors(told: Units, given: Option<crate::Unit>) -> Result<([f64; 3], Vec<String>)> {
    use crate::unit::{called, check};
    if let Some(across) = told.across {
        check(across, given).context("coordinates")?;
    }
    let given = given.map(crate::Unit::metres);
    let across = told.across.or(given).unwrap_or(1.0);
    let up = told.up.or(given).unwrap_or(across);
    let mut notes = Vec::new();
    if told.has_system && told.across.is_none() && given.is_none() {
        notes.push(
            "it names a system of coordinates, but no unit of length that is understood: metres were taken; if they are \
             others, say --file-unit"
                .into(),
        );
    }
    if across != 1.0 || up != 1.0 {
        let heights = if told.up.is_some() || told.across.is_none() { "" } else { ", of which it says nothing" };
        notes.push(format!(
            "coordinates in {}, heights in {}{heights}: converted to metres",
            called(across),
            called(up)
        ));
    }
    Ok(([across, across, up], notes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use las::crs::GeoTiffKeyEntry;

    const US: f64 = 1200.0 / 3937.0;

    fn round(x: f64) -> f64 {
        (x * 1e9).round() / 1e9
    }

    #[test]
    fn well_known_texts_tell_units() {
        let utm = r#"PROJCS["UTM",GEOGCS["WGS 84",DATUM["x",SPHEROID["y",6378137,298.25]],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],UNIT["metre",1]]"#;
        let feet = utm.replace("\"metre\",1]", "\"US survey foot\",0.3048006096012192]");
        let both = format!("COMPD_CS[\"both\",{utm},VERT_CS[\"NAVD88\",VERT_DATUM[\"d\",2005],UNIT[\"foot\",0.3048]]]");
        let two = r#"PROJCRS["x",BASEGEOGCRS["y",DATUM["z",ELLIPSOID["e",1,2]]],CS[Cartesian,2],AXIS["E",east,LENGTHUNIT["foot",0.3048]]]"#;
        for (text, across, up) in [
            (utm, Some(1.0), None),
            (feet.as_str(), Some(0.304_800_609_601_219_2), None),
            (both.as_str(), Some(1.0), Some(0.3048)),
            (two, Some(0.3048), None),
            ("nonsense", None, None),
            (&utm[..utm.len() - 1], None, None),
            (&format!("BOUNDCRS[SOURCECRS[{two}],TARGETCRS[{utm}]]"), Some(0.3048), None),
            (&format!("{utm},VERTCS[\"h\",VDATUM[\"d\"],UNIT[\"Foot\",0.3048]]"), Some(1.0), Some(0.3048)),
            (r#"PROJCS["NY",AUTHORITY["EPSG","2263"]]"#, Some(US), None),
        ] {
            let units = of_wkt(text).unwrap();
            assert_eq!((units.across.map(round), units.up), (across.map(round), up), "{text}");
            // What is not understood is said.
            assert_eq!(factors(units, None).unwrap().1.is_empty(), across == Some(1.0) && up.is_none(), "{text}");
        }
        assert!(of_wkt(r#"GEOGCS["WGS 84",UNIT["degree",0.0174532925199433]]"#).is_err());
        assert!(of_wkt(r#"GEOGCRS["WGS 84",CS[ellipsoidal,2]]"#).is_err());
    }

    fn keys(all: &[(u16, u16)]) -> GeoTiffCrs {
        GeoTiffCrs {
            entries: all.iter().map(|&(id, code)| GeoTiffKeyEntry { id, data: GeoTiffData::U16(code) }).collect(),
        }
    }

    #[test]
    fn keys_tell_units() {
        for (all, across, up) in [
            (&[(1024, 1), (3076, 9003), (4099, 9002)][..], Some(US), Some(0.3048)),
            // New York Long Island and UTM 32N, by their codes alone.
            (&[(3072, 2263)], Some(US), None),
            (&[(3072, 32_632)], Some(1.0), None),
            (&[(3076, 9001), (4096, 6360)], Some(1.0), Some(US)),
            (&[], None, None),
        ] {
            let found = of_keys(&keys(all)).unwrap();
            let same = |a: Option<f64>, b: Option<f64>| {
                a.is_some() == b.is_some() && (a.unwrap_or(0.0) - b.unwrap_or(0.0)).abs() < 1e-12
            };
            assert!(same(found.across, across) && same(found.up, up), "{all:?}: {found:?}");
        }
        assert!(
            of_keys(&keys(&[(2048, 4326)])).is_err()
                && of_keys(&keys(&[(1024, 1), (2048, 4326), (3076, 9001)])).is_ok()
        );
        assert!(of_keys(&keys(&[(1024, 2)])).is_err() && of_keys(&keys(&[(3076, 9999)])).is_err());
    }
}
