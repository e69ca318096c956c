//! The header of a PCD file: lines of a keyword and its values, up to DATA.

use anyhow::{Context, Result, anyhow, bail};

use crate::text::Lines;

/// How the points are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Storage {
    Ascii,
    Binary,
    /// LZF, field by field.
    Compressed,
}

/// One field of every point.
#[derive(Debug, Clone)]
pub struct PcdField {
    pub name: String,
    /// `F`, `I` or `U`.
    pub kind: char,
    /// Bytes of one of its values.
    pub size: usize,
    pub count: usize,
}

impl PcdField {
    pub fn bytes(&self) -> usize {
        self.size * self.count
    }
}

#[derive(Debug)]
pub struct PcdHeader {
    pub fields: Vec<PcdField>,
    pub points: u64,
    /// Place, and rotation as a quaternion w, x, y, z.
    pub viewpoint: [f64; 7],
    pub storage: Storage,
}

/// Longest record of any real file.
const MAX_RECORD: usize = 1 << 16;

impl PcdHeader {
    /// Reads up to and with the line DATA.
    pub fn read(lines: &mut Lines) -> Result<Self> {
        let (mut rows, mut storage) = (Vec::new(), None);
        while storage.is_none() {
            let line = lines.next()?.ok_or_else(|| anyhow!("its header ends without a line DATA"))?.to_owned();
            let mut words = line.split_whitespace().map(ToOwned::to_owned);
            let Some(keyword) = words.next().filter(|w| !w.starts_with('#')) else { continue };
            let values: Vec<String> = words.collect();
            if keyword.eq_ignore_ascii_case("DATA") {
                storage = Some(stored(values.first().map_or("", String::as_str), lines.number())?);
            }
            rows.push((keyword.to_uppercase(), values));
            if rows.len() > 100 {
                bail!("line {}: a line DATA expected by now, found \"{line}\"", lines.number());
            }
        }
        let values = |keyword: &str| rows.iter().find(|(k, _)| k == keyword).map(|(_, v)| v.as_slice());
        let number = |keyword: &str| values(keyword).and_then(|v| v.first()?.parse::<u64>().ok());
        let size = number("WIDTH").and_then(|w| w.checked_mul(number("HEIGHT").unwrap_or(1)));
        let points = number("POINTS").or(size).context("its header has no number of POINTS")?;
        let viewpoint = viewpoint(values("VIEWPOINT"))?;
        Ok(Self { fields: fields(&values)?, points, viewpoint, storage: storage.unwrap_or(Storage::Ascii) })
    }

    /// Bytes of a point.
    pub fn record(&self) -> usize {
        self.fields.iter().map(PcdField::bytes).sum()
    }

    /// The field of a name, in any case; the first where there are several.
    pub fn place(&self, name: &str) -> Result<usize> {
        let names = || self.fields.iter().map(|f| f.name.as_str()).collect::<Vec<_>>().join(" ");
        let found = self.fields.iter().position(|f| f.name.eq_ignore_ascii_case(name));
        found.ok_or_else(|| anyhow!("its points have no {name}; they have {}", names()))
    }
}

fn stored(word: &str, line: u64) -> Result<Storage> {
    match word.to_lowercase().as_str() {
        "ascii" => Ok(Storage::Ascii),
        "binary" => Ok(Storage::Binary),
        "binary_compressed" => Ok(Storage::Compressed),
        _ => bail!("line {line}: DATA \"{word}\" is unknown; known are ascii, binary, binary_compressed"),
    }
}

fn fields<'a>(values: &impl Fn(&str) -> Option<&'a [String]>) -> Result<Vec<PcdField>> {
    // Version 0.5 calls them COLUMNS.
    let names = values("FIELDS").or_else(|| values("COLUMNS")).context("its header has no FIELDS")?;
    let numbers = |keyword: &str, default: usize| -> Result<Vec<usize>> {
        let Some(words) = values(keyword) else { return Ok(vec![default; names.len()]) };
        let all = words.iter().map(|w| w.parse().ok()).collect::<Option<Vec<usize>>>();
        let fits = all.filter(|a| a.len() == names.len());
        fits.ok_or_else(|| anyhow!("{keyword} {} does not fit its {} FIELDS", words.join(" "), names.len()))
    };
    let (sizes, counts) = (numbers("SIZE", 4)?, numbers("COUNT", 1)?);
    let kinds: Vec<char> =
        values("TYPE").map_or(vec!['F'; names.len()], |v| v.iter().filter_map(|w| w.chars().next()).collect());
    if kinds.len() != names.len() {
        bail!("TYPE names {} types of {} FIELDS", kinds.len(), names.len());
    }
    let field = |i: usize| PcdField {
        name: names[i].clone(),
        kind: kinds[i].to_ascii_uppercase(),
        size: sizes[i],
        count: counts[i],
    };
    let all: Vec<PcdField> = (0..names.len()).map(field).collect();
    for f in &all {
        if !matches!((f.kind, f.size), ('F', 4 | 8) | ('I' | 'U', 1 | 2 | 4 | 8)) || f.count > MAX_RECORD {
            bail!("field {} has TYPE {}, SIZE {} and COUNT {}, which no PCD has", f.name, f.kind, f.size, f.count);
        }
    }
    let record: usize = all.iter().map(PcdField::bytes).sum();
    if record == 0 || record > MAX_RECORD {
        bail!("a point of {record} bytes is no point");
    }
    Ok(all)
}

fn viewpoint(values: Option<&[String]>) -> Result<[f64; 7]> {
    let Some(words) = values else { return Ok([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]) };
    let numbers: Vec<f64> = words.iter().filter_map(|w| w.parse().ok()).filter(|v: &f64| v.is_finite()).collect();
    let seven: Option<[f64; 7]> = numbers.try_into().ok();
    let sound = seven.filter(|v| v[3..].iter().map(|c| c * c).sum::<f64>() > 1e-12);
    sound.ok_or_else(|| {
        anyhow!("VIEWPOINT {} is no place and rotation (x y z and a quaternion w x y z)", words.join(" "))
    })
}
