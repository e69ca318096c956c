//! What a file would lose silently: records after a missing semicolon, and records that share a number.

use std::borrow::Cow;

use super::document::{Document, Edits};
use super::record::{Record, Records, comment_end, string_end};

/// The text with the semicolons that it lacks between two records.
pub fn separated<'a>(text: Cow<'a, [u8]>, words: &mut Vec<String>) -> Cow<'a, [u8]> {
    let (mut edits, mut missing, mut swallowed) = (Edits::default(), Vec::new(), Vec::new());
    // Outside texts an equals sign stands nowhere but behind a record's number.
    for record in Records::new(&text).filter(|r| memchr::memchr(b'=', &text[r.arguments.clone()]).is_some()) {
        for (at, is_between) in inner(&text, &record) {
            if is_between {
                edits.replace(at..at, ";");
                missing.push(record.id);
            } else {
                swallowed.push(record.id);
            }
        }
    }
    if !missing.is_empty() {
        words.push(format!("the semicolon behind {} is missing: read as if it stood there", listed(&missing)));
    }
    if !swallowed.is_empty() {
        let all = listed(&swallowed);
        words
            .push(format!("a bracket or a semicolon is missing in {all}: what follows in it is lost; repair the file"));
    }
    if edits.is_empty() { text } else { Cow::Owned(edits.apply(&text)) }
}

/// Where records begin within a record, and whether only a semicolon is missing before them.
fn inner(text: &[u8], record: &Record) -> Vec<(usize, bool)> {
    let (mut at, mut depth, mut out) = (record.arguments.start, 1i32, Vec::new());
    let mut last = None;
    while at < record.arguments.end {
        let b = text[at];
        match b {
            b'#' => last = Some((at, depth)),
            b'(' => depth += 1,
            b')' => depth -= 1,
            b'=' => {
                out.extend(last.take().map(|(start, depth)| (start, depth == 0)));
                depth = 0;
            }
            _ => {}
        }
        at = match b {
            b'\'' => string_end(text, at),
            b'/' if text.get(at + 1) == Some(&b'*') => comment_end(text, at),
            _ => at + 1,
        };
    }
    out
}

/// Different records of one number: only one of them is read.
pub fn doubled(document: &Document, words: &mut Vec<String>) {
    let text = document.text();
    let said = |r: &Record| (text[r.keyword.clone()].to_ascii_uppercase(), &text[r.arguments.clone()]);
    let pairs = document.records().windows(2).filter(|w| w[0].id == w[1].id && said(&w[0]) != said(&w[1]));
    let mut all: Vec<String> = Vec::new();
    for pair in pairs {
        let [a, b] = [0, 1].map(|k| String::from_utf8_lossy(&said(&pair[k]).0).into_owned());
        all.push(format!("#{} ({a}, {b})", pair[0].id));
    }
    if !all.is_empty() {
        let more = if all.len() > 5 { format!(" and {} more", all.len() - 5) } else { String::new() };
        all.truncate(5);
        let all = all.join(", ");
        words.push(format!(
            "different records share a number: {all}{more}; only one of each is read, the other is lost: number the \
             file's records anew"
        ));
    }
}

/// The first of some numbers.
pub fn listed(ids: &[u64]) -> String {
    let first: Vec<String> = ids.iter().take(5).map(|id| format!("#{id}")).collect();
    let more = if ids.len() > 5 { format!(" and {} more", ids.len() - 5) } else { String::new() };
    first.join(", ") + &more
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_semicolon_is_read_and_told() {
        let mended = |text: &str| {
            let mut words = Vec::new();
            let text = separated(Cow::Borrowed(text.as_bytes()), &mut words).into_owned();
            (String::from_utf8(text).unwrap(), words)
        };
        let (text, words) = mended("#1=A('x=(#9=',(1.))\n#2=B(#1) #3=C();#4=D();");
        assert_eq!(text, "#1=A('x=(#9=',(1.))\n;#2=B(#1) ;#3=C();#4=D();");
        assert!(words[0].contains("#1"), "{words:?}");
        let broken = "#1=A((1.)\n#2=B(#1);#4=D();";
        let (text, words) = mended(broken);
        assert_eq!((text.as_str(), words.len()), (broken, 1));
        assert!(mended("#1=A('x=(#9=',(1.));").1.is_empty());
    }

    #[test]
    fn different_records_of_one_number_are_told() {
        let text = b"#1=A(1.);#2=B();#1=A(2.);#2=B();";
        let mut words = Vec::new();
        doubled(&Document::new(text), &mut words);
        assert!(words.len() == 1 && words[0].contains("#1 (A, A)"), "{words:?}");
    }
}
