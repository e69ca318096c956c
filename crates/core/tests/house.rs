//! The house is in order: no circle among the files of core, and no import against the order of its contents pages.
//!
//! The order stands in lib.rs and in the mod.rs of rooms, as a list of bullets of the form ``//! * [`name`]: what``: a
//! module uses only those above it. A page that lists some of its modules lists all of them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

type Module = Vec<String>;

/// A source file, by its path below `src`.
struct Source {
    path: String,
    module: Module,
    text: String,
    /// Without comments and tests.
    code: String,
}

impl Source {
    fn new(path: &str, text: &str) -> Self {
        let stem = path.trim_end_matches(".rs");
        let stem = stem.strip_suffix("/mod").unwrap_or(if stem == "lib" { "" } else { stem });
        let module = stem.split('/').filter(|part| !part.is_empty()).map(String::from).collect();
        let lines: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
        let tests = lines.windows(2).position(|w| w[0].trim() == "#[cfg(test)]" && w[1].contains("mod "));
        let code = lines[..tests.unwrap_or(lines.len())].join("\n");
        Self { path: path.into(), module, text: text.into(), code }
    }

    /// Contents pages hand on what their modules define: that is no use of it.
    fn is_page(&self) -> bool {
        self.path == "lib.rs" || self.path.ends_with("mod.rs")
    }

    /// The modules of a contents page in the order in which it lists them.
    fn listed(&self) -> Vec<&str> {
        let bullets = self.text.lines().filter_map(|line| line.strip_prefix("//! * [`"));
        bullets.filter_map(|bullet| bullet.split_once("`]:")).map(|(name, _)| name).collect()
    }
}

/// A `use` statement or a path in the code.
struct Import {
    path: Vec<String>,
    /// The name that it is given.
    name: String,
    is_handed_on: bool,
}

/// The parts of `a::{b, c::{d, e as f}}`, each a path and the name that it is given.
fn expand(tree: &str, before: &[String], out: &mut Vec<(Vec<String>, String)>) {
    let parts = |text: &str| -> Vec<String> {
        text.split("::").map(|p| p.trim().to_string()).filter(|p| !p.is_empty()).collect()
    };
    let Some(open) = tree.find('{') else {
        let (path, name) = tree.split_once(" as ").unwrap_or((tree, ""));
        let mut path: Vec<String> = [before.to_vec(), parts(path)].concat();
        if path.last().is_some_and(|p| p == "self") {
            path.pop();
        }
        let name = if name.is_empty() { path.last().cloned().unwrap_or_default() } else { name.trim().into() };
        return out.push((path, name));
    };
    let before: Vec<String> = [before.to_vec(), parts(&tree[..open])].concat();
    let (mut depth, mut start) = (0, 0);
    let inside = &tree[open + 1..tree.rfind('}').unwrap_or(tree.len())];
    for (i, c) in inside.char_indices().chain([(inside.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let part = inside[start..i].trim();
                start = inside.len().min(i + 1);
                if !part.is_empty() {
                    expand(part, &before, out);
                }
            }
            _ => {}
        }
    }
}

/// What a file imports, by statements and in passing.
fn imports(code: &str) -> Vec<Import> {
    let (mut out, mut rest) = (Vec::new(), String::new());
    let mut lines = code.lines();
    while let Some(line) = lines.next() {
        let line = line.trim();
        let is_handed_on = line.starts_with("pub");
        // `pub(crate) use` and the like: what is left behind the parenthesis.
        let statement = line.strip_prefix("pub").map_or(line, |rest| match rest.strip_prefix('(') {
            Some(scope) => scope.split_once(')').map_or("", |(_, rest)| rest).trim_start(),
            None => rest.trim_start(),
        });
        let Some(tree) = statement.strip_prefix("use ") else {
            rest += line;
            rest.push('\n');
            continue;
        };
        let mut tree = tree.to_string();
        while !tree.contains(';') {
            tree += lines.next().unwrap_or(";").trim();
        }
        let mut parts = Vec::new();
        expand(tree.split(';').next().unwrap_or_default(), &[], &mut parts);
        out.extend(parts.into_iter().map(|(path, name)| Import { path, name, is_handed_on }));
    }
    for root in ["crate::", "super::"] {
        for (at, _) in rest.match_indices(root) {
            // Of `super::super::x` the first alone begins a path.
            if !rest[..at].ends_with("::") && !rest[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_') {
                let end = rest[at..].find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
                let path = rest[at..at + end.unwrap_or(rest.len() - at)].trim_end_matches(':');
                let path: Vec<String> = path.split("::").map(String::from).collect();
                out.push(Import { path, name: String::new(), is_handed_on: false });
            }
        }
    }
    out
}

/// All files and what they hand on.
struct House {
    sources: Vec<Source>,
    modules: BTreeMap<Module, usize>,
    handed_on: BTreeMap<Module, Module>,
}

impl House {
    fn new(sources: Vec<Source>) -> Self {
        let modules = sources.iter().enumerate().map(|(i, s)| (s.module.clone(), i)).collect();
        let mut house = Self { sources, modules, handed_on: BTreeMap::new() };
        let of = |source: &Source| {
            let handed_on = imports(&source.code).into_iter().filter(|import| import.is_handed_on);
            let named = handed_on.filter_map(|import| {
                let path = house.absolute(&source.module, &import.path)?;
                Some(([source.module.clone(), vec![import.name]].concat(), path))
            });
            named.collect::<Vec<_>>()
        };
        house.handed_on = house.sources.iter().flat_map(of).collect();
        house
    }

    /// A path from the root of the crate; `None` for one into another crate.
    fn absolute(&self, from: &[String], path: &[String]) -> Option<Module> {
        let supers = path.iter().take_while(|p| *p == "super").count();
        match path.first()?.as_str() {
            "crate" => Some(path[1..].to_vec()),
            "self" => Some([from, &path[1..]].concat()),
            "super" => Some([&from[..from.len().checked_sub(supers)?], &path[supers..]].concat()),
            _ => {
                let child = [from, &path[..1]].concat();
                self.modules.contains_key(&child).then(|| [from, path].concat())
            }
        }
    }

    /// The file that defines what a path names, as far as pages hand it on; else the last module on the way.
    fn file_of(&self, path: &[String]) -> usize {
        let mut file = self.modules[&Vec::new()];
        for n in 1..=path.len() {
            match (self.modules.get(&path[..n]), self.handed_on.get(&path[..n])) {
                (Some(&module), _) => file = module,
                (None, Some(target)) => return self.file_of(&[&target[..], &path[n..]].concat()),
                (None, None) => return file,
            }
        }
        file
    }

    /// Which files every file uses.
    fn uses(&self) -> Vec<BTreeSet<usize>> {
        let of = |(i, source): (usize, &Source)| {
            let imports = imports(&source.code).into_iter().filter(|import| !(source.is_page() && import.is_handed_on));
            let paths = imports.filter_map(|import| self.absolute(&source.module, &import.path));
            paths.map(|path| self.file_of(&path)).filter(|&j| j != i).collect()
        };
        self.sources.iter().enumerate().map(of).collect()
    }

    /// Groups of files that use each other, directly or by others.
    fn circles(&self) -> Vec<Vec<&str>> {
        let uses = self.uses();
        let reached = |from: usize| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
            while let Some(i) = open.pop() {
                open.extend(uses[i].iter().filter(|&&j| seen.insert(j)));
            }
            seen
        };
        let reach: Vec<BTreeSet<usize>> = (0..uses.len()).map(reached).collect();
        let circle = |i: usize| -> Vec<&str> {
            let others = (0..uses.len()).filter(|&j| reach[i].contains(&j) && reach[j].contains(&i));
            let mut files: Vec<&str> = others.map(|j| self.sources[j].path.as_str()).collect();
            files.sort_unstable();
            files
        };
        let circles: BTreeSet<Vec<&str>> = (0..uses.len()).map(circle).filter(|files| !files.is_empty()).collect();
        circles.into_iter().collect()
    }

    /// The order that the page of a module gives; none for a page without a list of its modules.
    fn order(&self, module: &[String]) -> Vec<&str> {
        let is_child = |name: &&str| self.modules.contains_key(&[module, &[name.to_string()]].concat());
        self.modules.get(module).map_or(Vec::new(), |&page| {
            let listed = self.sources[page].listed().into_iter().filter(is_child).collect::<Vec<_>>();
            if self.sources[page].is_page() { listed } else { Vec::new() }
        })
    }

    /// Imports of what stands below, and modules of which a list does not say where they stand.
    fn against_the_order(&self) -> Vec<String> {
        let mut out = Vec::new();
        for source in self.sources.iter().filter(|s| !s.module.is_empty()) {
            let (name, parent) = source.module.split_last().expect("a module below the root");
            let order = self.order(parent);
            if !order.is_empty() && !order.contains(&name.as_str()) {
                out.push(format!("{} is not in the list of its room", source.path));
            }
        }
        for (i, uses) in self.uses().into_iter().enumerate() {
            let source = &self.sources[i];
            for target in uses.into_iter().map(|j| &self.sources[j]) {
                let common = source.module.iter().zip(&target.module).take_while(|(a, b)| a == b).count();
                let order = self.order(&source.module[..common]);
                let place =
                    |of: &Source| order.iter().position(|name| Some(*name) == of.module.get(common).map(|n| &**n));
                if let (Some(own), Some(theirs)) = (place(source), place(target))
                    && own < theirs
                {
                    out.push(format!("{} uses {}, which stands below it", source.path, target.path));
                }
            }
        }
        out
    }
}

fn read(folder: &Path, below: &str, out: &mut Vec<Source>) {
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let path = format!("{below}{}", entry.file_name().to_str().unwrap());
        if entry.path().is_dir() {
            read(&entry.path(), &format!("{path}/"), out);
        } else if path.ends_with(".rs") {
            out.push(Source::new(&path, &std::fs::read_to_string(entry.path()).unwrap()));
        }
    }
}

fn core() -> House {
    let mut sources = Vec::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "", &mut sources);
    House::new(sources)
}

#[test]
fn no_circles_among_files() {
    let house = core();
    let circles = house.circles();
    assert!(circles.is_empty(), "{circles:?}");
}

#[test]
fn every_import_follows_the_order() {
    let house = core();
    assert!(house.order(&[]).len() > 7 && house.order(&["voxel".into()]).len() > 3, "the lists are found");
    let against = house.against_the_order();
    assert!(against.is_empty(), "{}", against.join("\n"));
}

/// The checks fail where they should.
#[test]
fn disorder_is_found() {
    let house = |files: &[(&str, &str)]| House::new(files.iter().map(|(path, text)| Source::new(path, text)).collect());
    let lib = "//! * [`low`]: first;\n//! * [`high`]: second.\npub mod low;\npub mod high;\npub use high::High;\n";
    let high = "use crate::low::Low;\npub struct High;";
    let good = house(&[("lib.rs", lib), ("low.rs", "struct Low;"), ("high.rs", high)]);
    assert!(good.circles().is_empty() && good.against_the_order().is_empty());
    // By statement over a page, and in passing.
    let low = "use crate::{\n    High as Tall,\n};";
    let bad = house(&[("lib.rs", lib), ("low.rs", low), ("high.rs", "fn f() { super::low::g() }")]);
    assert_eq!(bad.circles(), [["high.rs", "low.rs"]]);
    assert_eq!(bad.against_the_order(), ["low.rs uses high.rs, which stands below it"]);
    // Tests and comments may look anywhere.
    let tested = "// crate::high\n#[cfg(test)]\nmod tests {\n    use crate::high::High;\n}\n";
    assert!(house(&[("lib.rs", lib), ("low.rs", tested), ("high.rs", "")]).against_the_order().is_empty());
    // A room of its own, whose list lacks a file.
    let room = "//! * [`a`]: one.\nmod a;\nmod b;\n";
    let room =
        [("lib.rs", "pub mod room;"), ("room/mod.rs", room), ("room/a.rs", "use super::b::B;"), ("room/b.rs", "")];
    assert_eq!(house(&room).against_the_order(), ["room/b.rs is not in the list of its room"]);
}
