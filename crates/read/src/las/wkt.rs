//! A tree of well-known text (OGC 12-063r5): `KEYWORD["text", number, KEYWORD[…], …]`.

/// A keyword and the contents of its brackets.
#[derive(Debug)]
pub struct Node {
    keyword: String,
    words: Vec<String>,
    children: Vec<Node>,
}

/// Deepest nesting; no real text is nested deeper.
const DEEPEST: usize = 64;

impl Node {
    /// The trees of a text; there are two in ESRI's pairs of a horizontal and a vertical system. `None` where it is not
    /// well-known text.
    pub fn parse_all(text: &str) -> Option<Vec<Self>> {
        let (mut rest, mut all) = (text.trim(), Vec::new());
        while !rest.is_empty() {
            all.push(Self::branch(&mut rest, 0)?);
            rest = rest.trim_start_matches([',', ' ', '\r', '\n', '\t']);
        }
        (!all.is_empty()).then_some(all)
    }

    fn branch(rest: &mut &str, depth: usize) -> Option<Self> {
        let open = rest.find(['[', '('])?;
        let keyword = rest[..open].trim().to_uppercase();
        if depth > DEEPEST || keyword.is_empty() || !keyword.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') {
            return None;
        }
        *rest = rest[open + 1..].trim_start();
        let mut node = Self { keyword, words: Vec::new(), children: Vec::new() };
        loop {
            if let Some(after) = rest.strip_prefix([']', ')']) {
                *rest = after.trim_start();
                return Some(node);
            }
            if let Some(after) = rest.strip_prefix(',') {
                *rest = after.trim_start();
            } else if let Some(after) = rest.strip_prefix('"') {
                let end = after.find('"')?;
                node.words.push(after[..end].to_owned());
                *rest = after[end + 1..].trim_start();
            } else {
                let end = rest.find(['[', '(', ']', ')', ','])?;
                if rest[end..].starts_with(['[', '(']) {
                    node.children.push(Self::branch(rest, depth + 1)?);
                } else {
                    node.words.push(rest[..end].trim().to_owned());
                    *rest = &rest[end..];
                }
            }
        }
    }

    pub fn is(&self, keywords: &[&str]) -> bool {
        keywords.contains(&self.keyword.as_str())
    }

    pub fn children(&self) -> &[Self] {
        &self.children
    }

    /// The last word that is a number, such as an authority's code.
    pub fn code(&self) -> Option<u16> {
        self.words.iter().rev().find_map(|w| w.parse().ok())
    }

    /// The first child of one of these keywords.
    pub fn child(&self, keywords: &[&str]) -> Option<&Self> {
        self.children.iter().find(|c| c.is(keywords))
    }

    pub fn word(&self, place: usize) -> Option<&str> {
        self.words.get(place).map(String::as_str)
    }

    /// The number that follows its name.
    pub fn number(&self) -> Option<f64> {
        self.word(1)?.parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::Node;

    #[test]
    fn trees_are_read_and_nonsense_is_not() {
        let tree = &Node::parse_all(r#"A["x [y]", 1.5 , B(2), c["z"]]"#).unwrap()[0];
        assert!(tree.is(&["A"]) && tree.number() == Some(1.5) && tree.child(&["C"]).is_some());
        for wrong in ["", "A", "A[", "A[\"", "[1]", "A[B[1]"] {
            assert!(Node::parse_all(wrong).is_none(), "{wrong}");
        }
        assert!(Node::parse_all(&"A[".repeat(100_000)).is_none());
    }
}
