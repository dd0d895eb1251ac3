//! Rule on imports within a crate: no files import one another in a circle.
//!
//! One file imports another where its code names what stands there, in a `use` or in a path. A `pub use` is a table of contents and
//! imports nothing: names are followed through it to the file where they stand. Tests may import what they test.

use super::known::CIRCLES;
use crate::workspace;
use anyhow::{Context, Result};
use std::collections::{BTreeMap, BTreeSet};

/// Crates with more files in circles than are known, and exceptions that are needed no more.
pub fn check(files: &[String]) -> Result<Vec<String>> {
    let mut crates: BTreeMap<&str, Vec<(String, String)>> = BTreeMap::new();
    for file in files.iter().filter(|file| file.ends_with(".rs")) {
        let Some((package, inside)) = file.split_once("/src/") else { continue };
        if package.starts_with("crates/") || package == "xtask" {
            let text = workspace::text(file)?.with_context(|| format!("{file} is not UTF-8"))?;
            crates.entry(package).or_default().push((inside.to_owned(), text));
        }
    }
    let found: Vec<_> = crates.iter().map(|(package, files)| (*package, imports(files))).collect();
    Ok(judged(&found, &CIRCLES))
}

fn judged(found: &[(&str, Imports)], known: &[(&str, usize)]) -> Vec<String> {
    let mut breaches = Vec::new();
    for (package, imports) in found {
        let most = known.iter().find(|(name, _)| name == package).map_or(0, |(_, count)| *count);
        let circles = circles(imports);
        let count: usize = circles.iter().map(Vec::len).sum();
        if count > most {
            let list: Vec<_> = circles.iter().map(|circle| told(imports, circle)).collect();
            breaches.push(format!(
                "{package}/src: {count} files import one another in circles, more than {most}: {}",
                list.join("\n")
            ));
        }
    }
    for (package, _) in known {
        if found.iter().all(|(name, imports)| name != package || circles(imports).is_empty()) {
            breaches.push(format!(
                "{package}/src: no files import one another in a circle; take its line out of xtask/src/tidy/known.rs"
            ));
        }
    }
    breaches
}

/// What one file declares.
#[derive(Default)]
struct Source {
    file: String,
    /// Names that `use` brings, with their paths.
    names: BTreeMap<String, Vec<String>>,
    /// Paths of `use path::*`.
    globs: Vec<Vec<String>>,
    /// Paths that the code names; of those of `pub use` nothing is here.
    paths: Vec<Vec<String>>,
    /// Names of functions, types, constants and the like.
    items: BTreeSet<String>,
    /// Modules that are for tests alone.
    tests: Vec<String>,
}

/// A crate's files by the path of their module.
type Modules = BTreeMap<Vec<String>, Source>;

/// Which file of a crate imports which others.
type Imports = BTreeMap<String, BTreeSet<String>>;

fn imports(files: &[(String, String)]) -> Imports {
    let mut modules = Modules::new();
    for (file, text) in files {
        let root = file == "lib.rs" || file == "main.rs";
        let module = file.trim_end_matches(".rs").trim_end_matches("/mod");
        let module: Vec<String> =
            if root { Vec::new() } else { module.split('/').map(str::to_owned).collect() };
        // A program beside a library is a file that imports only.
        let module = if file == "main.rs" && files.iter().any(|(other, _)| other == "lib.rs") {
            vec!["main.rs".to_owned()]
        } else {
            module
        };
        modules.insert(module, source(file, &tokens(text)));
    }
    let tests: Vec<Vec<String>> = modules
        .iter()
        .flat_map(|(module, source)| {
            source.tests.iter().map(|name| [&module[..], std::slice::from_ref(name)].concat())
        })
        .collect();
    let in_tests = |module: &[String]| tests.iter().any(|test| module.starts_with(test));
    let mut imports = Imports::new();
    for (module, source) in modules.iter().filter(|(module, _)| !in_tests(module)) {
        let to = imports.entry(source.file.clone()).or_default();
        for path in &source.paths {
            if let Some(Found::Item(file)) = resolved(&modules, module, path, 0)
                && file != source.file
            {
                to.insert(file.to_owned());
            }
        }
    }
    imports
}

/// Where a path leads.
enum Found<'a> {
    Module(Vec<String>),
    Item(&'a str),
}

/// Follows a path that stands in a module; `None` for another crate's.
fn resolved<'a>(modules: &'a Modules, from: &[String], path: &[String], depth: usize) -> Option<Found<'a>> {
    // Names that import one another would lead nowhere.
    if depth > 16 {
        return None;
    }
    let mut at = from.to_vec();
    let mut rest = path;
    match path.first()?.as_str() {
        "crate" => {
            at.clear();
            rest = &path[1..];
        }
        "self" => rest = &path[1..],
        "super" => {
            while rest.first().is_some_and(|word| word == "super") {
                at.pop()?;
                rest = &rest[1..];
            }
        }
        first => {
            let inner = modules.contains_key(&[from, &[first.to_owned()]].concat());
            let known = modules.get(from).is_some_and(|source| source.names.contains_key(first));
            if !(inner || known) {
                return None;
            }
        }
    }
    while let Some((word, after)) = rest.split_first() {
        let below = [&at[..], std::slice::from_ref(word)].concat();
        if modules.contains_key(&below) {
            (at, rest) = (below, after);
            continue;
        }
        let source = modules.get(&at)?;
        if word == "*" {
            // Everything of a table of contents stands elsewhere.
            return (!source.items.is_empty()).then_some(Found::Item(&source.file));
        }
        if source.items.contains(word) {
            return Some(Found::Item(&source.file));
        }
        if let Some(path) = source.names.get(word) {
            // A name of another crate, shown here.
            if path.first() == Some(word) && path.len() == 1 {
                return None;
            }
            match resolved(modules, &at, path, depth + 1)? {
                Found::Item(file) => return Some(Found::Item(file)),
                Found::Module(module) => (at, rest) = (module, after),
            }
            continue;
        }
        let through = source.globs.iter().find_map(|glob| {
            let whole = [&glob[..], rest].concat();
            resolved(modules, &at, &whole, depth + 1)
        });
        return through.or(Some(Found::Item(&source.file)));
    }
    Some(Found::Module(at))
}

/// Words and signs of the code, without comments and texts, up to the tests at its end.
fn tokens(text: &str) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
    let (mut found, mut at) = (Vec::<String>::new(), 0);
    while at < letters.len() {
        let (letter, next) = (letters[at], letters.get(at + 1).copied().unwrap_or(' '));
        if letter == '/' && next == '/' {
            while at < letters.len() && letters[at] != '\n' {
                at += 1;
            }
        } else if letter == '"' {
            // A raw text ends with as many `#` as it begins with.
            let before = found.len();
            let hashes = found.iter().rev().take_while(|token| *token == "#").count();
            let raw = before > hashes
                && matches!(found[before - 1 - hashes].as_str(), "r" | "br")
                && (hashes > 0 || at > 0 && matches!(letters[at - 1], 'r'));
            at += 1;
            while at < letters.len() {
                if raw {
                    let close = letters[at] == '"'
                        && letters[at + 1..].iter().take_while(|l| **l == '#').count() >= hashes;
                    if close {
                        at += hashes;
                        break;
                    }
                } else if letters[at] == '\\' {
                    at += 1;
                } else if letters[at] == '"' {
                    break;
                }
                at += 1;
            }
            at += 1;
        } else if letter == '\'' {
            // A letter in quotes, or the name of a lifetime.
            let escaped = next == '\\';
            let length = if escaped {
                letters[at + 2..].iter().skip(1).position(|l| *l == '\'').map(|end| end + 4)
            } else {
                (letters.get(at + 2) == Some(&'\'')).then_some(3)
            };
            let lifetime = letters[at + 1..].iter().take_while(|letter| is_word(**letter)).count();
            at += length.unwrap_or(1 + lifetime);
        } else if is_word(letter) {
            let end = letters[at..].iter().position(|l| !is_word(*l)).map_or(letters.len(), |n| at + n);
            found.push(letters[at..end].iter().collect());
            at = end;
        } else if letter == ':' && next == ':' {
            found.push("::".to_owned());
            at += 2;
        } else {
            if !letter.is_whitespace() {
                found.push(letter.to_string());
            }
            at += 1;
        }
    }
    found
}

const CFG_TEST: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];

/// Reads the words of a file.
fn source(file: &str, tokens: &[String]) -> Source {
    let mut source = Source { file: file.to_owned(), ..Source::default() };
    let word = |at: usize| tokens.get(at).map_or("", String::as_str);
    let starts = |at: usize, words: &[&str]| words.iter().enumerate().all(|(k, w)| word(at + k) == *w);
    let (mut at, mut shown) = (0, false);
    while at < tokens.len() {
        if starts(at, &CFG_TEST) {
            let after = at + CFG_TEST.len();
            if word(after) == "mod" && word(after + 2) == ";" {
                source.tests.push(word(after + 1).to_owned());
                at = after + 3;
            } else {
                at = end_of_item(tokens, after);
            }
            continue;
        }
        match word(at) {
            "pub" => {
                shown = true;
                at += 1;
                if word(at) == "(" {
                    while at < tokens.len() && word(at) != ")" {
                        at += 1;
                    }
                    at += 1;
                }
                continue;
            }
            "use" => at = used(&mut source, tokens, at + 1, &mut Vec::new(), shown),
            "fn" | "struct" | "enum" | "trait" | "type" | "union" => {
                source.items.insert(word(at + 1).to_owned());
                at += 1;
            }
            "const" | "static" => {
                // Not `const fn` and `*const T`.
                if word(at + 2) == ":" {
                    source.items.insert(word(at + 1).to_owned());
                }
                at += 1;
            }
            "macro_rules" => {
                source.items.insert(word(at + 2).to_owned());
                at += 3;
            }
            "." => at += 2,
            first if is_name(first) => {
                let mut path = vec![first.to_owned()];
                while word(at + 1) == "::" && is_name(word(at + 2)) {
                    path.push(word(at + 2).to_owned());
                    at += 2;
                }
                if path.len() > 1 {
                    source.paths.push(path);
                }
                at += 1;
            }
            _ => at += 1,
        }
        shown = false;
    }
    source
}

fn is_name(word: &str) -> bool {
    word.starts_with(|letter: char| letter.is_alphabetic() || letter == '_')
}

/// The place after an item: its `;` or its closing brace.
fn end_of_item(tokens: &[String], from: usize) -> usize {
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate().skip(from) {
        match token.as_str() {
            "{" | "(" | "[" => depth += 1,
            ")" | "]" => depth -= 1,
            "}" => {
                depth -= 1;
                if depth == 0 {
                    return at + 1;
                }
            }
            ";" if depth == 0 => return at + 1,
            _ => {}
        }
    }
    tokens.len()
}

/// Reads the tree of a `use` below `above`; gives the place after it.
fn used(source: &mut Source, tokens: &[String], from: usize, above: &mut Vec<String>, shown: bool) -> usize {
    let word = |at: usize| tokens.get(at).map_or("", String::as_str);
    let (mut at, own) = (from, above.len());
    loop {
        match word(at) {
            "{" => {
                at += 1;
                while at < tokens.len() && word(at) != "}" {
                    let next = used(source, tokens, at, above, shown);
                    at = next + usize::from(word(next) == "," || next == at);
                }
                at += 1;
                break;
            }
            "*" => {
                source.globs.push(above.clone());
                if !shown {
                    above.push("*".to_owned());
                    source.paths.push(above.clone());
                }
                at += 1;
                break;
            }
            "::" => at += 1,
            name if is_name(name) => {
                above.push(name.to_owned());
                at += 1;
                if word(at) != "::" {
                    if name == "self" {
                        above.pop();
                    }
                    let mut called = above.last().cloned().unwrap_or_default();
                    if word(at) == "as" {
                        word(at + 1).clone_into(&mut called);
                        at += 2;
                    }
                    source.names.insert(called, above.clone());
                    if !shown {
                        source.paths.push(above.clone());
                    }
                    break;
                }
            }
            // Not a `use` that we know.
            _ => break,
        }
    }
    above.truncate(own);
    at
}

/// Groups of files that import one another in circles: from each a way leads to each other.
fn circles(imports: &Imports) -> Vec<Vec<&str>> {
    let reach = |from: &str| -> BTreeSet<&str> {
        let mut seen = BTreeSet::new();
        let mut next: Vec<&str> = imports.get(from).into_iter().flatten().map(String::as_str).collect();
        while let Some(file) = next.pop() {
            if seen.insert(file) {
                next.extend(imports.get(file).into_iter().flatten().map(String::as_str));
            }
        }
        seen
    };
    let reached: BTreeMap<&str, BTreeSet<&str>> =
        imports.keys().map(|file| (file.as_str(), reach(file))).collect();
    let mut groups: Vec<Vec<&str>> = Vec::new();
    for (file, others) in reached.iter().filter(|(file, others)| others.contains(*file)) {
        let mates = others.iter().filter(|other| reached.get(*other).is_some_and(|back| back.contains(file)));
        let group: Vec<&str> = mates.copied().collect();
        if !groups.contains(&group) {
            groups.push(group);
        }
    }
    groups
}

/// A circle, file by file, each with those of the circle that it imports.
fn told(imports: &Imports, circle: &[&str]) -> String {
    let of = |file: &&str| {
        let own = imports.get(*file).into_iter().flatten();
        let own: Vec<&str> = own.map(String::as_str).filter(|to| circle.contains(to)).collect();
        format!("\n  {file} -> {}", own.join(", "))
    };
    circle.iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn imports_of(files: &[(&str, &str)]) -> Imports {
        let files: Vec<_> =
            files.iter().map(|(file, text)| ((*file).to_owned(), (*text).to_owned())).collect();
        imports(&files)
    }

    fn of(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        let imports = imports_of(files);
        let own = |circle: Vec<&str>| circle.into_iter().map(str::to_owned).collect();
        circles(&imports).into_iter().map(own).collect()
    }

    #[test]
    fn files_that_name_one_another_stand_in_a_circle() {
        let lib = ("lib.rs", "mod a; mod b; mod c;");
        let a = ("a.rs", "use crate::b::B;\npub struct A(B);");
        let c = ("c.rs", "pub fn c() {}");
        assert!(of(&[lib, a, ("b.rs", "pub struct B;"), c]).is_empty());
        assert_eq!(of(&[lib, a, ("b.rs", "use super::a::{self, A};\npub struct B;"), c]), [["a.rs", "b.rs"]]);
        // Without `use`, and through a third file.
        assert_eq!(of(&[lib, a, ("b.rs", "pub fn B() { crate::a::A }"), c]), [["a.rs", "b.rs"]]);
        let round =
            [("b.rs", "use crate::c;\npub struct B; fn f() { c::c() }"), ("c.rs", "use crate::a::A;")];
        assert!(of(&[lib, a, round[0], c]).is_empty());
        // `c` has no function of that name but is the file that is named.
        assert_eq!(of(&[lib, a, round[0], round[1]]), [["a.rs", "b.rs", "c.rs"]]);
    }

    #[test]
    fn a_table_of_contents_imports_nothing_and_names_are_followed_through_it() {
        let lib = ("lib.rs", "mod a; mod b;\npub use a::A;\npub use b::*;");
        assert!(of(&[lib, ("a.rs", "use crate::B;\npub struct A;"), ("b.rs", "pub struct B;")]).is_empty());
        let both = of(&[
            lib,
            ("a.rs", "use crate::B;\npub struct A;"),
            ("b.rs", "pub struct B;\nfn f(a: crate::A) {}"),
        ]);
        assert_eq!(both, [["a.rs", "b.rs"]]);
        // A parent that uses its child, which uses what stands in the parent.
        let parent = ("p/mod.rs", "mod q;\nuse q::Q;\npub struct P(Q);");
        let child = ("p/q.rs", "use super::P;\npub struct Q;");
        assert_eq!(of(&[("lib.rs", "mod p;"), parent, child]), [["p/mod.rs", "p/q.rs"]]);
        let shown = ("p/mod.rs", "mod q;\npub(crate) use q::Q;\npub struct P;");
        assert!(of(&[("lib.rs", "mod p;"), shown, child]).is_empty());
    }

    #[test]
    fn tests_comments_and_texts_import_nothing() {
        let lib = ("lib.rs", "mod a; mod b;");
        let a = ("a.rs", "use crate::b::B;\npub struct A(B);");
        for b in [
            "pub struct B;\n// use crate::a::A;\n",
            "pub struct B;\nconst T: &str = \"use crate::a::A;\";",
            "pub struct B;\nconst T: &str = r#\"a \" use crate::a::A;\"#;",
            "pub struct B;\nfn f<'a>(x: &'a str) -> char { '\"' }\n#[cfg(test)]\nmod tests { use crate::a::A; }",
            "#[cfg(test)]\nuse crate::a::A;\npub struct B;",
        ] {
            assert!(of(&[lib, a, ("b.rs", b)]).is_empty(), "{b}");
        }
        let tested = ("b.rs", "pub struct B;\n#[cfg(test)]\nmod tests;");
        assert!(of(&[lib, a, tested, ("b/tests.rs", "use crate::a::A;\nuse super::B;")]).is_empty());
        // What stands behind a text or a test is read again.
        let after = "pub struct B;\nconst T: &str = \"x\\\"\";\n#[cfg(test)]\nfn t() { }\nuse crate::a::A;";
        assert_eq!(of(&[lib, a, ("b.rs", after)]), [["a.rs", "b.rs"]]);
    }

    #[test]
    fn an_exception_holds_to_its_number_and_goes_when_it_is_not_needed() {
        let circle = || {
            imports_of(&[
                ("lib.rs", "mod a; mod b;"),
                ("a.rs", "use crate::b::B;\npub struct A;"),
                ("b.rs", "use crate::a::A;\npub struct B;"),
            ])
        };
        let breaches = judged(&[("crates/x", circle())], &[]);
        assert!(
            breaches.len() == 1 && breaches[0].contains("\n  a.rs -> b.rs\n  b.rs -> a.rs"),
            "{breaches:?}"
        );
        assert!(judged(&[("crates/x", circle())], &[("crates/x", 2)]).is_empty());
        let breaches = judged(&[("crates/x", Imports::new())], &[("crates/x", 2)]);
        assert!(breaches.len() == 1 && breaches[0].contains("take its line out"), "{breaches:?}");
    }
}
