//! Record numbers beyond 32 bits, which the geometry library cannot represent.

use std::borrow::Cow;
use std::collections::HashMap;

use super::document::{Document, Edits, MAX_NUMBER};
use super::value::references;

/// Gives free numbers to records beyond the library's range; `original` holds what each was.
pub fn within_reach<'a>(text: Cow<'a, [u8]>, original: &mut HashMap<u64, u64>) -> Result<Cow<'a, [u8]>, String> {
    if !has_long_number(&text) {
        return Ok(text);
    }
    let document = Document::new(&text);
    let mut is_endless = false;
    references(&text, 0, |_, id| is_endless |= id == u64::MAX);
    if is_endless {
        return Err("a record has a number of more than 19 digits: number its records anew".into());
    }
    let mut free = document.free_numbers();
    let mut small: HashMap<u64, u64> = HashMap::new();
    for record in document.records().iter().filter(|r| r.id > MAX_NUMBER) {
        small.entry(record.id).or_insert_with(|| free.next().unwrap_or(MAX_NUMBER));
    }
    let mut edits = Edits::default();
    references(&text, 0, |piece, id| {
        if let Some(new) = small.get(&id) {
            edits.replace(piece, format!("#{new}"));
        } else if id > MAX_NUMBER {
            // It refers to nothing, and must not be taken for another.
            edits.replace(piece, "$");
        }
    });
    original.extend(small.into_iter().map(|(big, new)| (new, big)));
    Ok(if edits.is_empty() { text } else { Cow::Owned(edits.apply(&text)) })
}

/// Whether a number may lie beyond 32 bits.
fn has_long_number(text: &[u8]) -> bool {
    const DIGITS: usize = 10;
    let behind = |at: usize| text.get(at + 1..at + 1 + DIGITS).unwrap_or_default();
    memchr::memchr_iter(b'#', text).any(|at| behind(at).iter().filter(|b| b.is_ascii_digit()).count() == DIGITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn big_numbers_become_free_ones_wherever_they_stand() {
        let mut original = HashMap::new();
        let text = b"#21=W('#5000000001',#5000000001);#5000000001=W(#21,#4294967317,#6000000000);#4294967317=X();";
        let seen = within_reach(Cow::Borrowed(text), &mut original).unwrap().into_owned();
        let seen = String::from_utf8(seen).unwrap();
        assert_eq!(seen, "#21=W('#5000000001',#23);#23=W(#21,#22,$);#22=X();");
        assert_eq!(original, HashMap::from([(22, 4294967317), (23, 5000000001)]));
        // None refers to another by chance, even where no record is that far.
        let dangling = within_reach(Cow::Borrowed(b"#1=X(#4294967298);#2=Y();"), &mut original).unwrap();
        assert_eq!(&dangling[..], b"#1=X($);#2=Y();");
        let endless = within_reach(Cow::Borrowed(b"#1=X(#99999999999999999999);"), &mut original);
        assert!(endless.unwrap_err().contains("19 digits"));
    }
}
