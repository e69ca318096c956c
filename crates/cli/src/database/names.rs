//! The names that statements use: nothing is left to the search path.

/// The tables of models and scans, and the one with their layout's number.
pub const TABLES: [&str; 4] = ["building_object", "station", "scan", "asbuilt_layout"];

/// The schemas in which the extension and the tables live.
#[derive(Debug, Clone)]
pub struct Names {
    /// The extension's; `None` where the database has none.
    pub extension: Option<String>,
    /// The tables'.
    pub home: String,
}

impl Names {
    /// A statement with `@ext.` and `@scan` (and the other tables) replaced by full names.
    pub fn sql(&self, template: &str) -> String {
        let extension = format!("{}.", quoted(self.extension.as_deref().unwrap_or("pg_catalog")));
        let mut out = String::with_capacity(template.len() + 256);
        let mut rest = template;
        while let Some(at) = rest.find('@') {
            out.push_str(&rest[..at]);
            rest = &rest[at + 1..];
            if let Some(after) = rest.strip_prefix("ext.") {
                out.push_str(&extension);
                rest = after;
            } else if let Some(table) = TABLES.iter().find(|t| rest.starts_with(**t)) {
                out.push_str(&self.table(table));
                rest = &rest[table.len()..];
            } else {
                out.push('@');
            }
        }
        out + rest
    }

    /// A table's full name.
    pub fn table(&self, table: &str) -> String {
        format!("{}.{}", quoted(&self.home), quoted(table))
    }

    /// The same names for a template for PostgreSQL's `format`.
    pub fn for_format(&self) -> Self {
        let doubled = |name: &String| name.replace('%', "%%");
        Self { extension: self.extension.as_ref().map(doubled), home: doubled(&self.home) }
    }

    /// The search path of the program's own statements. Built-in names come first, so that nobody else's name can take
    /// their place (CVE-2018-1058).
    pub fn path(&self) -> String {
        let extension = self.extension.as_deref().map_or(String::new(), |e| format!("{}, ", quoted(e)));
        format!("pg_catalog, {extension}pg_temp")
    }
}

/// An SQL identifier.
pub fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('"', "\"\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_full_and_replaced_once() {
        let names = Names { extension: Some("a\"@scan".into()), home: "@ext.".into() };
        assert_eq!(
            names.sql("SELECT @ext.f(x) FROM @scan WHERE x @> y"),
            "SELECT \"a\"\"@scan\".f(x) FROM \"@ext.\".\"scan\" WHERE x @> y"
        );
        assert_eq!(names.path(), "pg_catalog, \"a\"\"@scan\", pg_temp");
    }
}
