//! What a file is: by its content, and by its name where the content is text that could be several formats.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::text::lines::encoding;

/// Models and scans.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileContents {
    /// A building model.
    Model,
    /// Laser scans or points.
    Scan,
}

/// The formats that can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileFormat {
    Ifc,
    E57,
    /// LAS and LAZ.
    Las,
    Ply,
    Pcd,
    Ptx,
    /// One point per line: XYZ, PTS, ASC, TXT, CSV.
    Text,
}

impl FileFormat {
    /// The name that people use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ifc => "IFC",
            Self::E57 => "E57",
            Self::Las => "LAS/LAZ",
            Self::Ply => "PLY",
            Self::Pcd => "PCD",
            Self::Ptx => "PTX",
            Self::Text => "text of points",
        }
    }
}

const ENDINGS: [(&str, FileFormat); 12] = [
    ("ifc", FileFormat::Ifc),
    ("e57", FileFormat::E57),
    ("las", FileFormat::Las),
    ("laz", FileFormat::Las),
    ("ply", FileFormat::Ply),
    ("pcd", FileFormat::Pcd),
    ("ptx", FileFormat::Ptx),
    ("pts", FileFormat::Text),
    ("xyz", FileFormat::Text),
    ("asc", FileFormat::Text),
    ("txt", FileFormat::Text),
    ("csv", FileFormat::Text),
];

/// Tells models from scans.
pub fn kind(path: &Path) -> Result<FileContents> {
    Ok(if form(path)? == FileFormat::Ifc { FileContents::Model } else { FileContents::Scan })
}

/// What a file is. Files that begin like no known format are classified by their ending, whose reader says what is
/// wrong with them.
pub fn form(path: &Path) -> Result<FileFormat> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    let by_name = ENDINGS.iter().find(|(e, _)| *e == ending).map(|(_, form)| *form);
    let mut head = Vec::new();
    let file = File::open(path).with_context(|| format!("{}: cannot open it", path.display()))?;
    file.take(4096).read_to_end(&mut head).with_context(|| format!("{}: cannot read it", path.display()))?;
    match by_content(&head).or(by_name) {
        Some(FileFormat::Text) if is_ptx(&head) => Ok(FileFormat::Ptx),
        Some(form) => Ok(form),
        None if is_text(&head) => Ok(FileFormat::Text),
        None => {
            let known: Vec<&str> = ENDINGS.iter().map(|(e, _)| *e).collect();
            bail!("{}: unknown kind of file \".{ending}\"; known are {}", path.display(), known.join(", "))
        }
    }
}

/// By the marks that binary formats, PLY, PCD and STEP begin with.
fn by_content(head: &[u8]) -> Option<FileFormat> {
    let text = encoding(head).decode(head).0;
    let text = text.trim_start();
    let has = |marks: &[&str]| marks.iter().any(|m| text.starts_with(m));
    match head {
        _ if head.starts_with(b"ASTM-E57") => Some(FileFormat::E57),
        _ if head.starts_with(b"LASF") => Some(FileFormat::Las),
        _ if has(&["ply\n", "ply\r"]) => Some(FileFormat::Ply),
        _ if has(&["# .PCD", "# .pcd"]) || has(&["VERSION "]) && text.contains("FIELDS") => Some(FileFormat::Pcd),
        _ if has(&["ISO-10303-21"]) || has(&["/*"]) && text.contains("ISO-10303-21") => Some(FileFormat::Ifc),
        _ => None,
    }
}

fn is_text(head: &[u8]) -> bool {
    let text = encoding(head).decode(head).0;
    !head.is_empty() && !text.chars().any(|c| c.is_control() && !c.is_whitespace())
}

/// How a PTX begins: two counts, four lines of three numbers, four lines of four.
fn is_ptx(head: &[u8]) -> bool {
    let text = encoding(head).decode(head).0;
    let mut counts = text.split(['\n', '\r']).filter(|l| !l.trim().is_empty()).map(|l| l.split_whitespace().count());
    [1, 1, 3, 3, 3, 3, 4, 4, 4, 4].into_iter().all(|expected| counts.next() == Some(expected))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_goes_before_the_name() {
        let ptx = "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n";
        for (name, content, expected) in [
            ("a.xyz", "ply\nformat", Some(FileFormat::Ply)),
            ("a.ply", "\u{feff}ply\r\nformat", Some(FileFormat::Ply)),
            ("a.txt", "1 2 3\n", Some(FileFormat::Text)),
            ("a.dat", "1 2 3\n", Some(FileFormat::Text)),
            ("a", "\u{feff}ISO-10303-21;", Some(FileFormat::Ifc)),
            ("a.ifc", "/* by us */\nISO-10303-21;", Some(FileFormat::Ifc)),
            ("a.xyz", ptx, Some(FileFormat::Ptx)),
            ("a.las", "LASF\x01\x02", Some(FileFormat::Las)),
            ("a.ifc", "nonsense", Some(FileFormat::Ifc)),
            ("a.bin", "\x01\x02\x03", None),
        ] {
            let path = std::env::temp_dir().join(format!("asbuilt-content-{}-{name}", std::process::id()));
            std::fs::write(&path, content).unwrap();
            assert_eq!(form(&path).ok(), expected, "{name}: {content}");
            std::fs::remove_file(path).unwrap();
        }
    }
}
