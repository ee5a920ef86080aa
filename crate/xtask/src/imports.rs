//! Which file of a crate takes what from which other file.
//!
//! An import is counted between the file that names a thing and the file that defines it, through all re-exports. So a
//! `mod.rs` that only declares its children and shows them with `pub use` imports nothing, and who takes a child's type
//! from it imports from the child. What a file shows and uses itself counts. So does a method that a file calls of a
//! type of its own where another file gives the type that method. Tests do not count: nobody has to read them first.

use std::collections::BTreeMap;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::{Attribute, ImplItem, Item, ItemUse, UseTree, Visibility};

use crate::command::Outcome;

/// The sources of a crate: the text of each `.rs` file by its path below `src`, with `/` between folders.
pub type Sources = BTreeMap<String, String>;

/// That `from` takes `name` from `to`, first in `line`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    pub from: String,
    pub to: String,
    pub line: usize,
    pub name: String,
}

/// The imports among the files of a crate, each name between two files once.
pub fn imports(sources: &Sources) -> Outcome<Vec<Import>> {
    let mut tree = Tree { sources, modules: BTreeMap::new(), files: BTreeMap::new() };
    for root in ["lib.rs", "main.rs"] {
        if sources.contains_key(root) {
            tree.read(root, &[])?;
        }
    }
    Ok(tree.imports())
}

/// Names from a module to a thing, or from the root to a module.
type Path = Vec<String>;

struct Tree<'a> {
    sources: &'a Sources,
    modules: BTreeMap<Path, Module>,
    files: BTreeMap<String, File>,
}

/// What can be named in a module.
#[derive(Default)]
struct Module {
    /// The file of each thing that is defined here.
    items: BTreeMap<String, String>,
    /// The path of each thing that is imported or shown here.
    bound: BTreeMap<String, Path>,
    globs: Vec<Path>,
}

/// What a file names.
#[derive(Default)]
struct File {
    uses: Vec<Use>,
    /// Paths in its code, each with the module that it stands in.
    paths: Vec<(Path, Path, usize)>,
    /// Each word of its code and each method that it calls, where it stands first.
    words: BTreeMap<String, usize>,
    calls: BTreeMap<String, usize>,
    /// The methods that it gives to a type, with the module and the path that name the type.
    methods: Vec<(Path, Path, Vec<String>)>,
}

struct Use {
    module: Path,
    path: Path,
    line: usize,
    /// The name that it binds; none for a glob.
    name: Option<String>,
    shown: bool,
}

/// Where a path ends: at a module, or at a thing in a file.
enum End {
    Module(Path),
    Item { file: String, name: String },
}

impl Tree<'_> {
    fn read(&mut self, file: &str, module: &[String]) -> Outcome {
        let parsed = syn::parse_file(&self.sources[file])
            .map_err(|error| format!("{file}:{}: {error}", error.span().start().line))?;
        self.files.insert(file.to_owned(), File::default());
        self.items(file, module, parsed.items)
    }

    fn items(&mut self, file: &str, module: &[String], items: Vec<Item>) -> Outcome {
        self.modules.entry(module.to_vec()).or_default();
        for item in items.into_iter().filter(|item| !is_test(item)) {
            match item {
                Item::Use(item) => self.bind(file, module, &item, true),
                Item::Mod(item) => {
                    let inner = [module, &[item.ident.to_string()]].concat();
                    if let Some((_, items)) = item.content {
                        self.items(file, &inner, items)?;
                    } else {
                        let stem = inner.join("/");
                        let names = [format!("{stem}.rs"), format!("{stem}/mod.rs")];
                        let found = names.iter().find(|name| self.sources.contains_key(*name));
                        self.read(found.ok_or_else(|| format!("{file}: no file of `mod {stem}`"))?, &inner)?;
                    }
                }
                item => {
                    if let (Some(name), Some(module)) = (name_of(&item), self.modules.get_mut(module)) {
                        module.items.insert(name, file.to_owned());
                    }
                    self.methods(file, module, &item);
                    self.scan(file, module, item.to_token_stream());
                }
            }
        }
        Ok(())
    }

    /// Notes a `use`; where it is one of a module, then the names that it binds there, too.
    fn bind(&mut self, file: &str, module: &[String], item: &ItemUse, of_module: bool) {
        let mut leaves = Vec::new();
        leaves_of(&item.tree, &[], &mut leaves);
        for (path, name) in leaves {
            if let (true, Some(bound)) = (of_module, self.modules.get_mut(module)) {
                match &name {
                    Some(name) => drop(bound.bound.insert(name.clone(), path.clone())),
                    None => bound.globs.push(path.clone()),
                }
            }
            if let Some(file) = self.files.get_mut(file) {
                let shown = !matches!(item.vis, Visibility::Inherited);
                file.uses.push(Use { module: module.to_vec(), path, line: line(item), name, shown });
            }
        }
    }

    fn methods(&mut self, file: &str, module: &[String], item: &Item) {
        let Item::Impl(item) = item else { return };
        let (None, syn::Type::Path(of)) = (&item.trait_, &*item.self_ty) else { return };
        let names = item.items.iter().filter_map(|item| match item {
            ImplItem::Fn(method) => Some(method.sig.ident.to_string()),
            _ => None,
        });
        let path = of.path.segments.iter().map(|part| part.ident.to_string()).collect();
        if let Some(file) = self.files.get_mut(file) {
            file.methods.push((module.to_vec(), path, names.collect()));
        }
    }

    /// Notes the paths, the words and the calls among the tokens of an item, those in macros too.
    fn scan(&mut self, file: &str, module: &[String], tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mark = |at: usize, wanted: char| matches!(tokens.get(at), Some(TokenTree::Punct(mark)) if mark.as_char() == wanted);
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let after_dot = at > 0 && mark(at - 1, '.');
            at += 1;
            match token {
                TokenTree::Group(group) => self.scan(file, module, group.stream()),
                TokenTree::Ident(word) if *word == "use" => {
                    let end =
                        (at..tokens.len()).find(|at| mark(*at, ';')).map_or(tokens.len(), |end| end + 1);
                    if let Ok(item) = syn::parse2(tokens[at - 1..end].iter().cloned().collect()) {
                        self.bind(file, module, &item, false);
                        at = end;
                    }
                }
                TokenTree::Ident(word) => {
                    let mut path = vec![word.to_string()];
                    while let (true, true, Some(TokenTree::Ident(next))) =
                        (mark(at, ':'), mark(at + 1, ':'), tokens.get(at + 2))
                    {
                        path.push(next.to_string());
                        at += 3;
                    }
                    let line = line(word);
                    let Some(file) = self.files.get_mut(file) else { return };
                    let called = mark(at, ':')
                        || matches!(tokens.get(at), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis);
                    if called && after_dot {
                        file.calls.entry(path[0].clone()).or_insert(line);
                    } else if path.len() > 1 {
                        if path[0] == "Self" {
                            file.calls.entry(path[1].clone()).or_insert(line);
                        }
                        file.words.entry(path[0].clone()).or_insert(line);
                        file.paths.push((module.to_vec(), path, line));
                    } else {
                        file.words.entry(word.to_string()).or_insert(line);
                    }
                }
                _ => {}
            }
        }
    }

    /// Follows a path that stands in a module, through what is imported there.
    fn follow(&self, module: &[String], path: &[String], depth: usize) -> Option<End> {
        const LONGEST_CHAIN_OF_REEXPORTS: usize = 16;
        if depth > LONGEST_CHAIN_OF_REEXPORTS {
            return None;
        }
        let mut here = module.to_vec();
        for (index, name) in path.iter().enumerate() {
            let last = index + 1 == path.len();
            match name.as_str() {
                "crate" => here = Vec::new(),
                "self" => {}
                "super" => drop(here.pop()),
                name => match self.look_up(&here, name, last, depth)? {
                    End::Module(inner) => here = inner,
                    item @ End::Item { .. } => return Some(item),
                },
            }
        }
        Some(End::Module(here))
    }

    /// What a name means in a module. A module and a function can bear one name: the last of a path is rather not a
    /// module.
    fn look_up(&self, here: &[String], name: &str, last: bool, depth: usize) -> Option<End> {
        let module = self.modules.get(here)?;
        let child = [here, &[name.to_owned()]].concat();
        let child = || self.modules.contains_key(&child).then(|| End::Module(child.clone()));
        let item =
            || module.items.get(name).map(|file| End::Item { file: file.clone(), name: name.to_owned() });
        let bound = || {
            let path = module.bound.get(name)?;
            // `use name;` and `use name::{..}` of a child or of another crate do not lead back to themselves.
            if path[0] == name && path.len() == 1 { None } else { self.follow(here, path, depth + 1) }
        };
        let shown = || {
            module.globs.iter().find_map(|glob| match self.follow(here, glob, depth + 1)? {
                End::Module(of) if of != here => self.look_up(&of, name, last, depth + 1),
                _ => None,
            })
        };
        if last { item().or_else(bound).or_else(child) } else { child().or_else(item).or_else(bound) }
            .or_else(shown)
    }

    fn imports(&self) -> Vec<Import> {
        let mut found = BTreeMap::new();
        let mut note = |from: &str, line: usize, end: Option<End>| {
            if let Some(End::Item { file: to, name }) = end
                && to != from
            {
                found.entry((from.to_owned(), to, name)).or_insert(line);
            }
        };
        for (from, file) in &self.files {
            for one in &file.uses {
                match &one.name {
                    Some(name) if one.shown && !file.words.contains_key(name) => {}
                    Some(_) => note(from, one.line, self.follow(&one.module, &one.path, 0)),
                    None => {
                        let Some(End::Module(of)) = self.follow(&one.module, &one.path, 0) else { continue };
                        let own = &self.modules[&one.module];
                        for (word, line) in
                            file.words.iter().filter(|(word, _)| !own.items.contains_key(*word))
                        {
                            note(from, *line, self.look_up(&of, word, true, 0));
                        }
                    }
                }
            }
            for (module, path, line) in &file.paths {
                note(from, *line, self.follow(module, path, 0));
            }
            for (module, path, methods) in &file.methods {
                let Some(End::Item { file: of, .. }) = self.follow(module, path, 0) else { continue };
                for method in methods {
                    if let (true, Some(line)) = (of != *from, self.files[&of].calls.get(method)) {
                        note(
                            &of,
                            *line,
                            Some(End::Item { file: from.clone(), name: format!(".{method}()") }),
                        );
                    }
                }
            }
        }
        found.into_iter().map(|((from, to, name), line)| Import { from, to, line, name }).collect()
    }
}

/// Each leaf of a tree of names, with the name that it binds: none for a glob.
fn leaves_of(tree: &UseTree, before: &[String], found: &mut Vec<(Path, Option<String>)>) {
    let with = |name: String| if name == "self" { before.to_vec() } else { [before, &[name]].concat() };
    match tree {
        UseTree::Path(path) if before.is_empty() => leaves_of(&path.tree, &[path.ident.to_string()], found),
        UseTree::Path(path) => leaves_of(&path.tree, &with(path.ident.to_string()), found),
        UseTree::Name(name) => {
            let path = with(name.ident.to_string());
            let bound = path.last().cloned();
            found.push((path, bound));
        }
        UseTree::Rename(name) => found.push((with(name.ident.to_string()), Some(name.rename.to_string()))),
        UseTree::Glob(_) => found.push((before.to_vec(), None)),
        UseTree::Group(group) => group.items.iter().for_each(|tree| leaves_of(tree, before, found)),
    }
}

fn name_of(item: &Item) -> Option<String> {
    Some(match item {
        Item::Const(item) => item.ident.to_string(),
        Item::Enum(item) => item.ident.to_string(),
        Item::Fn(item) => item.sig.ident.to_string(),
        Item::Macro(item) => item.ident.as_ref()?.to_string(),
        Item::Static(item) => item.ident.to_string(),
        Item::Struct(item) => item.ident.to_string(),
        Item::Trait(item) => item.ident.to_string(),
        Item::Type(item) => item.ident.to_string(),
        Item::Union(item) => item.ident.to_string(),
        _ => return None,
    })
}

fn is_test(item: &Item) -> bool {
    let attributes: &[Attribute] = match item {
        Item::Const(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    };
    attributes.iter().any(|attribute| {
        let words = attribute.meta.to_token_stream().to_string().replace(' ', "");
        words == "cfg(test)" || words.starts_with("cfg(all(test,")
    })
}

fn line(of: &impl Spanned) -> usize {
    of.span().start().line
}
