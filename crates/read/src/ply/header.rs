//! The header of a PLY file, brought into the form that the `ply-rs-bw` crate knows: no byte order mark, line ends of
//! one kind, names in lower case and unique, no comments, and 64-bit integers declared as doubles, which are equally
//! long.

use std::io::{BufRead, Cursor};

use anyhow::{Context, Result, bail};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::Header;

use super::Vertex;

/// A longer header is not a header, bytes.
const LONGEST: u64 = 1 << 20;

/// Reads the header; returns it and the number of its lines.
pub fn read(file: &mut impl BufRead) -> Result<(Header, u64)> {
    let (mut text, mut lines) = (String::new(), 0);
    let mut seen: Vec<String> = Vec::new();
    loop {
        let Some(line) = next_line(file).context("cannot read its header")? else {
            bail!("its header ends without end_header");
        };
        lines += 1;
        let words: Vec<&str> = line.split_whitespace().collect();
        if !is_known(&words) {
            bail!("line {lines}: \"{}\" is no line of a PLY header", line.chars().take(60).collect::<String>());
        }
        match words.first().map(|w| w.to_lowercase()).as_deref() {
            None | Some("comment" | "obj_info") => continue,
            Some("property") => {
                if let ([_, kind, name], true) = (&words[..], text.contains("format binary")) {
                    refuse_whole(kind, name)?;
                }
                text.push_str(&property(&words, &mut seen));
            }
            Some(keyword) => {
                if keyword == "element" {
                    seen.clear();
                }
                text.push_str(&words.join(" ").to_lowercase());
            }
        }
        text.push('\n');
        if text.ends_with("end_header\n") {
            break;
        }
        if text.len() as u64 > LONGEST {
            bail!("line {lines}: end_header expected by now");
        }
    }
    let mut reader = Reader::new(Cursor::new(text));
    let header = Parser::<Vertex>::new().read_header(&mut reader).context("not a readable PLY file")?;
    Ok((header, lines))
}

/// An integer of 64 bits, by any of its names.
fn is_long(kind: &str) -> bool {
    ["int64", "uint64", "longlong", "ulonglong", "long", "ulong"].contains(&kind)
}

/// The library does not know integers of 64 bits; read as doubles they would be nonsense.
fn refuse_whole(kind: &str, name: &str) -> Result<()> {
    if is_long(&kind.to_lowercase()) && ["x", "y", "z"].contains(&name.to_lowercase().as_str()) {
        bail!("its {name} is of type {kind}: write it as double");
    }
    Ok(())
}

/// Whether a line is one that a header can have.
fn is_known(words: &[&str]) -> bool {
    const TYPES: [&str; 16] = [
        "char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "uint8", "int16", "uint16",
        "int32", "uint32", "float32", "float64",
    ];
    let small: Vec<String> = words.iter().map(|w| w.to_lowercase()).collect();
    let small: Vec<&str> = small.iter().map(String::as_str).collect();
    let is_type = |word: &str| TYPES.contains(&word) || is_long(word);
    match small[..] {
        [] | ["comment" | "obj_info", ..] | ["ply"] | ["end_header"] => true,
        ["format", "ascii" | "binary_little_endian" | "binary_big_endian", version] => version.starts_with('1'),
        ["element", _, count] => count.parse::<u64>().is_ok(),
        ["property", "list", count, item, _] => is_type(count) && is_type(item),
        ["property", one, _] => is_type(one),
        _ => false,
    }
}

/// The line of a property: types as the library knows them, a name that is unique.
fn property(words: &[&str], seen: &mut Vec<String>) -> String {
    let Some((name, types)) = words.split_last() else { return String::new() };
    let known = |word: &&str| match word.to_lowercase().as_str() {
        long if is_long(long) => "double".into(),
        other => other.to_owned(),
    };
    let mut name = name.to_lowercase();
    while seen.contains(&name) {
        name.push_str("_again");
    }
    seen.push(name.clone());
    let types: Vec<String> = types.iter().map(known).collect();
    format!("{} {name}", types.join(" "))
}

/// A line without its end (LF, CR, or both) and byte order mark, whatever its encoding.
fn next_line(file: &mut impl BufRead) -> std::io::Result<Option<String>> {
    let mut line = Vec::new();
    loop {
        let mut byte = [0];
        if file.read(&mut byte)? == 0 {
            return Ok((!line.is_empty()).then(|| String::from_utf8_lossy(&line).into_owned()));
        }
        match byte[0] {
            b'\n' => break,
            b'\r' => {
                if file.fill_buf()?.first() == Some(&b'\n') {
                    file.consume(1);
                }
                break;
            }
            _ if line.len() as u64 > LONGEST => break,
            other => line.push(other),
        }
    }
    let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&line);
    Ok(Some(String::from_utf8_lossy(line).into_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_of_every_make_are_read() {
        let plain = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float X\nproperty uint64 t\nproperty float t\nend_header\n";
        for (what, text) in [
            ("plain", plain.to_owned()),
            ("mark", format!("\u{feff}{plain}")),
            ("CR", plain.replace('\n', "\r")),
            ("CR LF", plain.replace('\n', "\r\n")),
        ] {
            let (header, lines) = read(&mut Cursor::new(format!("{text}1 2 3").into_bytes())).unwrap();
            let names: Vec<&str> = header.elements["vertex"].properties.keys().map(String::as_str).collect();
            assert_eq!((names, lines), (vec!["x", "t", "t_again"], 7), "{what}");
        }
        let latin = b"ply\nformat ascii 1.0\ncomment cr\xe9\xe9\nelement vertex 1\nproperty float x\nend_header\n";
        assert!(read(&mut Cursor::new(latin.to_vec())).is_ok());
        assert!(read(&mut Cursor::new(b"ply\nformat ascii 1.0\n".to_vec())).is_err());
        for wrong in ["format asci 1.0", "property half x", "element vertex many", "vertex 3"] {
            let text = format!("ply\n{wrong}\nend_header\n");
            let said = read(&mut Cursor::new(text.into_bytes())).unwrap_err().to_string();
            assert!(said.contains(&format!("line 2: \"{wrong}\"")), "{said}");
        }
    }
}
