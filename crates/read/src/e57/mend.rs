//! XML of an E57 file that the library refuses, corrected: in Latin-1, or with an extension declared twice.

use std::fs::File;
use std::io::{BufReader, Read, Seek};
use std::path::Path;

use anyhow::{Context, Result};
use e57::E57Reader;
use encoding_rs::WINDOWS_1252;

use crate::overlay::Overlay;

/// Size of the checksummed pages that the file is made of, and how much of each is content.
const PAGE: usize = 1024;
const CONTENT: usize = PAGE - 4;
/// Positions in the file's header of the file's length and of the XML's place and length (ASTM E2807-11, table 1).
const LENGTH_AT: usize = 16;
const XML_AT: usize = 24;

pub type E57File = E57Reader<BufReader<Overlay<File>>>;

/// Opens the file; where the library refuses it, with its XML corrected. Also returns what was done.
pub fn open(path: &Path) -> Result<(E57File, Vec<String>)> {
    let again = || anyhow::Ok(Overlay::new(File::open(path).context("cannot open it")?)?);
    let refused = match reader(again()?) {
        Ok(reader) => return Ok((reader, Vec::new())),
        Err(refused) => refused,
    };
    let mut file = again()?;
    let Some((xml, note)) = mended(&mut file) else { return Err(refused) };
    put_xml(&mut file, &xml)?;
    Ok((reader(file)?, vec![note]))
}

fn reader(mut file: Overlay<File>) -> Result<E57File> {
    file.rewind()?;
    E57Reader::new(BufReader::new(file)).context("not a readable E57 file")
}

/// The XML as it should be; `None` where it is correct already, or cannot be read at all.
fn mended(file: &mut Overlay<File>) -> Option<(String, String)> {
    file.rewind().ok()?;
    let bytes = E57Reader::raw_xml(&mut *file).ok()?;
    match std::str::from_utf8(&bytes) {
        Err(_) => {
            let text = WINDOWS_1252.decode(&bytes).0.into_owned();
            Some((once(&text).unwrap_or(text), "its XML is not UTF-8, and was read as Latin-1".into()))
        }
        Ok(text) => Some((once(text)?, "its XML declares an extension twice, which was read once".into())),
    }
}

/// The XML with every namespace of its root declared once; `None` where it is so already.
fn once(xml: &str) -> Option<String> {
    let start = xml.find("<e57Root")?;
    let end = start + xml[start..].find('>')?;
    let (mut out, mut rest, mut seen) = (xml[..start].to_owned(), &xml[start..end], Vec::new());
    while let Some(at) = rest.find("xmlns") {
        let (before, declaration) = rest.split_at(at);
        let (name, value) = declaration.split_once('=')?;
        let quote = value.trim_start().chars().next().filter(|c| matches!(c, '"' | '\''))?;
        let opened = declaration.find(quote)? + 1;
        let closed = opened + declaration[opened..].find(quote)? + 1;
        out.push_str(before);
        if !seen.contains(&name.trim()) {
            out.push_str(&declaration[..closed]);
            seen.push(name.trim());
        }
        rest = &declaration[closed..];
    }
    out.push_str(rest);
    out.push_str(&xml[end..]);
    (out.len() < xml.len()).then_some(out)
}

/// Writes the XML into pages after the file's end, and its place into the header.
fn put_xml(file: &mut Overlay<File>, xml: &str) -> Result<()> {
    let start = file.len().next_multiple_of(PAGE as u64);
    let pages: Vec<u8> = xml.as_bytes().chunks(CONTENT).flat_map(page).collect();
    let mut head = vec![0; CONTENT];
    file.rewind()?;
    file.read_exact(&mut head)?;
    let end = start + pages.len() as u64;
    for (at, value) in [(LENGTH_AT, end), (XML_AT, start), (XML_AT + 8, xml.len() as u64)] {
        head[at..at + 8].copy_from_slice(&value.to_le_bytes());
    }
    file.put(0, page(&head));
    file.put(start, pages);
    Ok(())
}

/// A page of content and its checksum, which is big-endian.
fn page(content: &[u8]) -> Vec<u8> {
    let mut page = content.to_vec();
    page.resize(CONTENT, 0);
    let checksum = crc32c::crc32c(&page).to_be_bytes();
    page.extend(checksum);
    page
}

#[cfg(test)]
mod tests {
    use super::once;

    #[test]
    fn namespaces_stand_once() {
        let twice =
            r#"<?xml?><e57Root type="Structure" xmlns="a" xmlns:nor="b" xmlns:nor="b"><x xmlns:nor="c"/></e57Root>"#;
        let right = twice.replacen(r#" xmlns:nor="b""#, "", 1);
        assert_eq!(once(twice).unwrap().replace("  ", " ").replace(" >", ">"), right);
        assert_eq!(once(&right), None);
        assert_eq!(once("<e57Root xmlns"), None);
    }
}
