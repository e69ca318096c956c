//! The records of a STEP file, one by one; strings and comments are respected.

use std::ops::Range;

/// An instance of the DATA section: `#id=KEYWORD(arguments);`.
#[derive(Debug, Clone)]
pub struct Record {
    pub id: u64,
    /// From `#` to just after the semicolon.
    pub span: Range<usize>,
    /// Empty where an instance is of several types at once.
    pub keyword: Range<usize>,
    /// Between the outer brackets.
    pub arguments: Range<usize>,
}

/// Iterates over the records of a text; anything else (header, section marks) is skipped.
pub struct Records<'a> {
    text: &'a [u8],
    at: usize,
}

impl<'a> Records<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        Self { text, at: 0 }
    }

    fn record(&mut self, start: usize) -> Option<Record> {
        let (id, at) = number(self.text, start + 1)?;
        let at = skip_blank(self.text, at);
        if self.text.get(at) != Some(&b'=') {
            return None;
        }
        let first = skip_blank(self.text, at + 1);
        let last = first + self.text[first..].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
        let open = skip_blank(self.text, last);
        let end = statement_end(self.text, open);
        let close = open + self.text[open..end].iter().rposition(|&b| b == b')')?;
        (self.text[open] == b'(').then(|| Record {
            id,
            span: start..end,
            keyword: first..last,
            arguments: open + 1..close.max(open + 1),
        })
    }
}

impl Iterator for Records<'_> {
    type Item = Record;

    fn next(&mut self) -> Option<Record> {
        loop {
            let start = skip_blank(self.text, self.at);
            let first = *self.text.get(start)?;
            let record = if first == b'#' { self.record(start) } else { None };
            self.at = record.as_ref().map_or_else(|| statement_end(self.text, start), |r| r.span.end);
            if record.is_some() {
                return record;
            }
        }
    }
}

/// The number at this position, and where it ends; one that is too large becomes the largest.
pub fn number(text: &[u8], start: usize) -> Option<(u64, usize)> {
    let digits = text.get(start..)?.iter().take_while(|b| b.is_ascii_digit()).count();
    let end = start + digits;
    (digits > 0).then(|| (std::str::from_utf8(&text[start..end]).map_or(0, |s| s.parse().unwrap_or(u64::MAX)), end))
}

/// The position after white space and comments.
pub fn skip_blank(text: &[u8], mut at: usize) -> usize {
    loop {
        match text.get(at) {
            Some(b) if b.is_ascii_whitespace() || *b == 0 => at += 1,
            Some(b'/') if text.get(at + 1) == Some(&b'*') => at = comment_end(text, at),
            _ => return at.min(text.len()),
        }
    }
}

/// The position after the comment that starts here.
pub fn comment_end(text: &[u8], start: usize) -> usize {
    let inside = text.get(start + 2..).unwrap_or_default();
    inside.windows(2).position(|w| w == b"*/").map_or(text.len(), |n| start + n + 4)
}

/// The position after the string that starts here; a doubled quote is read as two adjacent strings, which does no harm.
pub fn string_end(text: &[u8], start: usize) -> usize {
    let inside = text.get(start + 1..).unwrap_or_default();
    inside.iter().position(|&b| b == b'\'').map_or(text.len(), |n| start + n + 2)
}

/// The position after the next semicolon outside strings and comments.
fn statement_end(text: &[u8], mut at: usize) -> usize {
    while let Some(&b) = text.get(at) {
        at = match b {
            b'\'' => string_end(text, at),
            b'/' if text.get(at + 1) == Some(&b'*') => comment_end(text, at),
            b';' => return at + 1,
            _ => at + 1,
        };
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_and_comments_hide_what_looks_like_a_record() {
        let text = b"HEADER;FILE_NAME('#9=X();');ENDSEC;DATA;\n#1=A('it''s; #2=B()',#3 /* ; #4=C() */,(1.));\n/* #5=D(); */ #18446744073709551615 = e ( ) ;\n#6=(F()G());#7=H(";
        let seen: Vec<(u64, &[u8], &[u8])> =
            Records::new(text).map(|r| (r.id, &text[r.keyword.clone()], &text[r.arguments.clone()])).collect();
        assert_eq!(seen[0].0, 1);
        assert_eq!(seen[0].2, &b"'it''s; #2=B()',#3 /* ; #4=C() */,(1.)"[..]);
        assert_eq!((seen[1].0, seen[1].1), (u64::MAX, &b"e"[..]));
        assert_eq!((seen[2].0, seen[2].1), (6, &b""[..]));
        assert_eq!(seen.len(), 3);
    }
}
