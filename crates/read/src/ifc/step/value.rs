//! The arguments of a record as values.

use super::record::{comment_end, number, skip_blank, string_end};

/// A STEP value; texts are kept as written between their quotes or dots.
#[derive(Debug, Clone, PartialEq)]
pub enum Value<'a> {
    /// `$` or `*`.
    Absent,
    Reference(u64),
    Number(f64),
    Text(&'a [u8]),
    /// `.NAME.`, without its dots.
    Enumerated(&'a [u8]),
    List(Vec<Value<'a>>),
    /// `IFCPARAMETERVALUE(1.)`: the value inside.
    Typed(&'a [u8], Vec<Value<'a>>),
}

impl<'a> Value<'a> {
    pub fn reference(&self) -> Option<u64> {
        if let Self::Reference(id) = self { Some(*id) } else { None }
    }

    /// The number, even if wrapped in a type.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(x) => Some(*x),
            Self::Typed(_, inner) => inner.first()?.number(),
            _ => None,
        }
    }

    pub fn list(&self) -> &[Self] {
        if let Self::List(all) = self { all } else { &[] }
    }

    pub fn is(&self, name: &str) -> bool {
        matches!(self, Self::Enumerated(e) if e.eq_ignore_ascii_case(name.as_bytes()))
    }

    pub fn text(&self) -> Option<&'a [u8]> {
        if let Self::Text(t) = self { Some(t) } else { None }
    }
}

/// Deepest nesting: no file nests deeper, and a hostile one would overflow the stack.
const MAX_DEPTH: usize = 64;

/// All values of an argument list; `None` where the text is not one.
pub fn values(arguments: &[u8]) -> Option<Vec<Value<'_>>> {
    let mut parser = Parser { text: arguments, at: 0 };
    let all = parser.list(0)?;
    (parser.at >= arguments.len()).then_some(all)
}

struct Parser<'a> {
    text: &'a [u8],
    at: usize,
}

impl<'a> Parser<'a> {
    /// Reads up to a closing bracket, which is not consumed, or to the end.
    fn list(&mut self, depth: usize) -> Option<Vec<Value<'a>>> {
        let mut all = Vec::new();
        loop {
            self.at = skip_blank(self.text, self.at);
            match self.text.get(self.at) {
                None | Some(b')') => return Some(all),
                Some(b',') => self.at += 1,
                Some(_) => all.push(self.value(depth)?),
            }
        }
    }

    fn value(&mut self, depth: usize) -> Option<Value<'a>> {
        let start = self.at;
        match self.text[start] {
            b'$' | b'*' => {
                self.at += 1;
                Some(Value::Absent)
            }
            b'#' => {
                let (id, end) = number(self.text, start + 1)?;
                self.at = end;
                Some(Value::Reference(id))
            }
            b'\'' => Some(Value::Text(self.quoted(start))),
            b'"' => {
                self.at += 2 + self.text[start + 1..].iter().position(|&b| b == b'"')?;
                Some(Value::Text(&self.text[start + 1..self.at - 1]))
            }
            b'.' if self.text.get(start + 1).is_some_and(u8::is_ascii_alphabetic) => {
                let n = self.text[start + 1..].iter().position(|&b| b == b'.')?;
                self.at = start + n + 2;
                Some(Value::Enumerated(&self.text[start + 1..self.at - 1]))
            }
            b'(' => self.inner(depth).map(Value::List),
            b if b.is_ascii_alphabetic() => {
                let n = self.text[start..].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
                self.at = skip_blank(self.text, start + n);
                (self.text.get(self.at) == Some(&b'(')).then_some(())?;
                Some(Value::Typed(&self.text[start..start + n], self.inner(depth)?))
            }
            _ => self.real(start),
        }
    }

    fn inner(&mut self, depth: usize) -> Option<Vec<Value<'a>>> {
        if depth >= MAX_DEPTH {
            return None;
        }
        self.at += 1;
        let all = self.list(depth + 1)?;
        (self.text.get(self.at) == Some(&b')')).then_some(())?;
        self.at += 1;
        Some(all)
    }

    /// A doubled quote belongs to the text.
    fn quoted(&mut self, start: usize) -> &'a [u8] {
        self.at = string_end(self.text, start);
        while self.text.get(self.at) == Some(&b'\'') {
            self.at = string_end(self.text, self.at);
        }
        &self.text[(start + 1).min(self.text.len())..(self.at - 1).max(start + 1).min(self.text.len())]
    }

    fn real(&mut self, start: usize) -> Option<Value<'a>> {
        let is_end = |b: &u8| matches!(b, b',' | b')' | b'/') || b.is_ascii_whitespace();
        let n = self.text[start..].iter().position(is_end).unwrap_or(self.text.len() - start);
        self.at = start + n;
        let x = std::str::from_utf8(&self.text[start..self.at]).ok()?.parse().ok()?;
        Some(Value::Number(x))
    }
}

/// A number as text: the shortest that reads back as the same; STEP wants a point in it, and a capital E.
pub fn real(x: f64) -> String {
    format!("{x:?}").replace('e', "E")
}

/// Every `#number` of a text outside strings and comments: its position, and the number.
pub fn references(text: &[u8], from: usize, mut each: impl FnMut(std::ops::Range<usize>, u64)) {
    let mut at = from;
    while let Some(&b) = text.get(at) {
        at = match b {
            b'\'' => string_end(text, at),
            b'/' if text.get(at + 1) == Some(&b'*') => comment_end(text, at),
            b'#' => match number(text, at + 1) {
                Some((id, end)) => {
                    each(at..end, id);
                    end
                }
                None => at + 1,
            },
            _ => at + 1,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_kinds() {
        let all = values(b"'it''s',$,*,#12,-1.E-3,4,.AREA.,(1.,(#2)),IFCPARAMETERVALUE(180.) /* x */,()").unwrap();
        assert_eq!(all[0], Value::Text(b"it''s"));
        assert_eq!((all[1].clone(), all[3].reference()), (Value::Absent, Some(12)));
        assert_eq!((all[4].number(), all[5].number(), all[8].number()), (Some(-1e-3), Some(4.0), Some(180.0)));
        assert!(all[6].is("area"));
        assert_eq!(all[7].list()[1].list()[0].reference(), Some(2));
        assert_eq!(all[9], Value::List(vec![]));
    }

    #[test]
    fn what_is_no_list_is_none() {
        for wrong in [&b"(1.,"[..], b"abc", b"1.,)", b"#x", &[b'('; 1000]] {
            assert_eq!(values(wrong), None, "{}", String::from_utf8_lossy(wrong));
        }
    }
}
