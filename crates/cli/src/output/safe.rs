//! Text from elsewhere (names from files, from the server, from the command line), made safe to display.

use std::fmt::Write;

/// What a terminal would obey or hide is written out, as `\x1b` or `\u{202e}`; passwords in connection strings are
/// masked.
pub fn safe(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in masked(text).chars() {
        match c {
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => drop(write!(out, "\\x{:02x}", u32::from(c))),
            c if misleads(c) => drop(write!(out, "\\u{{{:x}}}", u32::from(c))),
            c => out.push(c),
        }
    }
    out
}

/// Characters without a glyph of their own that reorder, separate or hide the text around them. Joiners (200C, 200D)
/// are needed to write Persian and Hindi and stay.
fn misleads(c: char) -> bool {
    matches!(u32::from(c),
        0xAD | 0x61C | 0x180E | 0x200B | 0x200E..=0x200F | 0x2028..=0x202E | 0x2060..=0x206F | 0xFEFF
        | 0xFFF9..=0xFFFB | 0xE0000..=0xE0FFF)
}

/// The text with `***` for the passwords of connection URLs (`//user:password@`) and strings (`password=…`).
fn masked(text: &str) -> String {
    let mut out = text.to_owned();
    let mut from = 0;
    while let Some(at) = out[from..].find("://").map(|i| from + i + 3) {
        // A password may hold anything, blanks and signs of others too.
        let ours = ["postgres://", "postgresql://"].iter().any(|s| out[..at].to_ascii_lowercase().ends_with(s));
        let end = if ours { out.len() } else { at + out[at..].find([' ', '"', '\n']).unwrap_or(out.len() - at) };
        let colon = out[at..end].find([':', '@', '/', ' ']).map(|i| at + i + 1).filter(|&i| out[..i].ends_with(':'));
        let sign = out[at..end].rfind('@').map(|i| at + i);
        let masked = match (colon, sign) {
            (Some(start), Some(end)) if start <= end => Some((start, end)),
            (Some(start), None) if ours && !is_port(&out[start..]) => Some((start, end)),
            _ => None,
        };
        from = at;
        if let Some((start, end)) = masked {
            out.replace_range(start..end, "***");
            from = start + 3;
        }
    }
    from = 0;
    while let Some(start) = out[from..].to_ascii_lowercase().find("password").map(|i| from + i + "password".len()) {
        from = start;
        let after = out[start..].trim_start();
        if let Some(value) = after.strip_prefix('=') {
            let value = value.trim_start();
            // Its end, where it has blanks or quotes, is a guess: all is masked but the rest of a URL's query.
            let (first, len) = (out.len() - value.len(), value.find('&').unwrap_or(value.len()));
            out.replace_range(first..first + len, "***");
            from = first + 3;
        }
    }
    out
}

/// Whether a text begins with a port number, and not with a password whose @ was forgotten.
fn is_port(text: &str) -> bool {
    let after = text.trim_start_matches(|c: char| c.is_ascii_digit());
    after.len() < text.len() && (after.is_empty() || after.starts_with(['/', '?', ' ', '\'', '"', ',', ':']))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_obeys_is_written_out() {
        assert_eq!(safe("wall\x1b[31m\n2\u{9b}\u{202e}x\u{7f}"), "wall\\x1b[31m\\n2\\x9b\\u{202e}x\\x7f");
        assert_eq!(safe("Tür 3 → می‌خواهم 壁"), "Tür 3 → می‌خواهم 壁");
    }

    #[test]
    fn passwords_are_masked() {
        for (text, shown) in [
            ("postgres://me:sec@ret@h:5/db no", "postgres://me:***@h:5/db no"),
            ("postgres://me@h:5/db or @ : %", "postgres://me@h:5/db or @ : %"),
            ("'postgresql://me:a b\"c@h/db' found", "'postgresql://me:***@h/db' found"),
            ("see http://h:80/x or a@b", "see http://h:80/x or a@b"),
            ("postgres://h:5432/db", "postgres://h:5432/db"),
            ("postgres://me:secret#h", "postgres://me:***"),
            ("host=h password='a b\\'c' user=u", "host=h password=***"),
            ("host=h PASSWORD = secret", "host=h PASSWORD = ***"),
            ("postgres://h/db?password=x%20y&user=u", "postgres://h/db?password=***&user=u"),
            ("the password is wrong", "the password is wrong"),
        ] {
            assert_eq!(safe(text), shown);
        }
    }
}
