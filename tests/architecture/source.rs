//! Rust sources as text, as far as it takes to see which file uses which.

use std::collections::{BTreeMap, BTreeSet};

use crate::graph::Arrow;

/// One file.
#[derive(Debug, Clone)]
pub struct Source {
    /// Name of its crate in paths.
    pub crate_name: String,
    /// Its path, from the workspace's root.
    pub path: String,
    /// What it holds.
    pub text: String,
}

/// A module's path: the crate's name first.
type Module = Vec<String>;

/// Every use of one file by another, once.
pub fn arrows(sources: &[Source]) -> Vec<Arrow> {
    let tokens: Vec<Vec<Token>> = sources.iter().map(|source| tokens(&source.text)).collect();
    let modules: Vec<Module> = sources.iter().map(|source| module_of(source, sources)).collect();
    let mut file_of: BTreeMap<Module, usize> = BTreeMap::new();
    for (index, module) in modules.iter().enumerate() {
        // A program's `main.rs` is a root beside its library's.
        if !sources[index].path.ends_with("src/main.rs") {
            file_of.insert(module.clone(), index);
        }
    }
    let crates: BTreeSet<&str> = sources.iter().map(|source| source.crate_name.as_str()).collect();
    let mut arrows = BTreeSet::new();
    for (index, source) in sources.iter().enumerate() {
        for path in absolute_paths(&tokens[index], &modules[index], &crates, &file_of) {
            let file = (1..=path.len()).rev().find_map(|length| file_of.get(&path[..length]));
            if let Some(&used) = file.filter(|&&used| used != index) {
                arrows.insert(Arrow { from: source.path.clone(), to: sources[used].path.clone() });
            }
        }
    }
    arrows.into_iter().collect()
}

/// The module that a file is: from where it lies, or from the line that gives it another place.
fn module_of(source: &Source, sources: &[Source]) -> Module {
    let own = source.path.split_once("src/").map_or("", |(_, own)| own);
    let mut parts: Vec<String> = own.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if let Some((folder, name)) = source.path.rsplit_once('/') {
        let line = format!("#[path = \"{name}\"]");
        for parent in sources.iter().filter(|other| other.path.rsplit_once('/').is_some_and(|(f, _)| f == folder)) {
            let Some((_, rest)) = parent.text.split_once(&line) else { continue };
            let Some(name) = rest.split_whitespace().skip_while(|word| *word != "mod").nth(1) else { continue };
            let mut module = module_of(parent, &[]);
            module.push(name.trim_end_matches(';').to_owned());
            return module;
        }
    }
    if parts.last().is_some_and(|last| last == "mod" || last == "lib" || last == "main") {
        parts.pop();
    }
    [vec![source.crate_name.clone()], parts].concat()
}

/// What is left of a source without comments, texts and spaces.
#[derive(Debug, Clone, PartialEq)]
enum Token {
    Word(String),
    /// `::`
    Colons,
    Sign(char),
}

fn tokens(text: &str) -> Vec<Token> {
    let chars: Vec<char> = text.chars().collect();
    let (mut tokens, mut at) = (Vec::new(), 0);
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    while at < chars.len() {
        let (c, next) = (chars[at], chars.get(at + 1).copied().unwrap_or(' '));
        at = match c {
            '/' if next == '/' => end_of_line(&chars, at),
            '/' if next == '*' => end_of_comment(&chars, at),
            '"' => end_of_text(&chars, at),
            'r' | 'b' if raw_hashes(&chars, at).is_some() && (at == 0 || !is_word(chars[at - 1])) => {
                end_of_raw(&chars, at)
            }
            '\'' => end_of_quote(&chars, at),
            ':' if next == ':' => {
                tokens.push(Token::Colons);
                at + 2
            }
            c if is_word(c) => {
                let end = (at..chars.len()).find(|&end| !is_word(chars[end])).unwrap_or(chars.len());
                tokens.push(Token::Word(chars[at..end].iter().collect()));
                end
            }
            c => {
                if !c.is_whitespace() {
                    tokens.push(Token::Sign(c));
                }
                at + 1
            }
        };
    }
    tokens
}

fn end_of_line(chars: &[char], at: usize) -> usize {
    (at..chars.len()).find(|&end| chars[end] == '\n').unwrap_or(chars.len())
}

/// Comments nest.
fn end_of_comment(chars: &[char], mut at: usize) -> usize {
    let mut depth = 0;
    while at + 1 < chars.len() {
        match [chars[at], chars[at + 1]] {
            ['/', '*'] => (depth, at) = (depth + 1, at + 2),
            ['*', '/'] if depth == 1 => return at + 2,
            ['*', '/'] => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
    }
    chars.len()
}

fn end_of_text(chars: &[char], at: usize) -> usize {
    let mut end = at + 1;
    while end < chars.len() && chars[end] != '"' {
        end += if chars[end] == '\\' { 2 } else { 1 };
    }
    end + 1
}

/// Number of `#` of a raw text that begins here; `None` where none does.
fn raw_hashes(chars: &[char], at: usize) -> Option<usize> {
    let start = if chars[at] == 'b' { at + 1 } else { at };
    if chars.get(start) != Some(&'r') {
        return None;
    }
    let hashes = chars[start + 1..].iter().take_while(|c| **c == '#').count();
    (chars.get(start + 1 + hashes) == Some(&'"')).then_some(hashes)
}

fn end_of_raw(chars: &[char], at: usize) -> usize {
    let hashes = raw_hashes(chars, at).unwrap_or(0);
    let opening = (at..chars.len()).find(|&place| chars[place] == '"').unwrap_or(at);
    let closes = |&end: &usize| {
        chars[end] == '"' && chars[end + 1..].iter().take(hashes).filter(|c| **c == '#').count() == hashes
    };
    (opening + 1..chars.len()).find(closes).map_or(chars.len(), |end| end + 1 + hashes)
}

/// A character, or the mark of a lifetime.
fn end_of_quote(chars: &[char], at: usize) -> usize {
    match (chars.get(at + 1), chars.get(at + 2)) {
        (Some('\\'), _) => (at + 3..chars.len()).find(|&end| chars[end] == '\'').map_or(chars.len(), |end| end + 1),
        (Some(_), Some('\'')) => at + 3,
        _ => at + 1,
    }
}

/// Every path of a file that leads to a module of the workspace, from its crate's name on.
fn absolute_paths(
    tokens: &[Token],
    file: &Module,
    crates: &BTreeSet<&str>,
    file_of: &BTreeMap<Module, usize>,
) -> Vec<Module> {
    let mut reader = Reader { crates, file_of, names: BTreeMap::new(), own: BTreeSet::new(), found: Vec::new() };
    reader.own = own_modules(tokens);
    // Names first: a `use` line may follow what it is for.
    for uses in [true, false] {
        reader.walk(tokens, file, uses);
    }
    reader.found
}

/// Modules that are written within the file.
fn own_modules(tokens: &[Token]) -> BTreeSet<String> {
    let named = |three: &[Token]| match three {
        [Token::Word(word), Token::Word(name), Token::Sign('{')] if word == "mod" => Some(name.clone()),
        _ => None,
    };
    tokens.windows(3).filter_map(named).collect()
}

struct Reader<'a> {
    crates: &'a BTreeSet<&'a str>,
    file_of: &'a BTreeMap<Module, usize>,
    /// What `use` lines bring in, with what it stands for.
    names: BTreeMap<String, Module>,
    own: BTreeSet<String>,
    found: Vec<Module>,
}

impl Reader<'_> {
    /// Reads `use` lines, or all other paths.
    fn walk(&mut self, tokens: &[Token], file: &Module, uses: bool) {
        // Modules within the file that are open, with the depth of braces they opened at.
        let (mut open, mut depth, mut at): (Vec<(String, usize)>, usize, usize) = (Vec::new(), 0, 0);
        while at < tokens.len() {
            match &tokens[at..] {
                [Token::Word(word), Token::Word(name), Token::Sign('{'), ..] if word == "mod" && name == "tests" => {
                    at = closing_brace(tokens, at + 2);
                }
                [Token::Word(word), Token::Word(name), Token::Sign('{'), ..] if word == "mod" => {
                    open.push((name.clone(), depth));
                    (depth, at) = (depth + 1, at + 3);
                }
                [Token::Sign('{'), ..] => (depth, at) = (depth + 1, at + 1),
                [Token::Sign('}'), ..] => {
                    (depth, at) = (depth.saturating_sub(1), at + 1);
                    open.retain(|(_, opened)| *opened < depth);
                }
                [Token::Word(word), ..] if word == "use" => {
                    let end = (at..tokens.len()).find(|&end| tokens[end] == Token::Sign(';')).unwrap_or(tokens.len());
                    if uses {
                        let module = inside(file, &open);
                        self.read_use(&tokens[at + 1..end], &module);
                    }
                    at = end;
                }
                [Token::Word(_), Token::Colons, ..] if at == 0 || tokens[at - 1] != Token::Colons => {
                    let path = leading_words(&tokens[at..]);
                    at += 2 * path.len() - 1;
                    if !uses {
                        let module = inside(file, &open);
                        self.found.extend(self.absolute(&path, &module));
                    }
                }
                _ => at += 1,
            }
        }
    }

    fn read_use(&mut self, tokens: &[Token], module: &Module) {
        let mut at = 0;
        for (path, name) in tree(tokens, &mut at) {
            let Some(path) = self.absolute(&path, module) else { continue };
            if let Some(name) = name {
                self.names.insert(name, path.clone());
            }
            self.found.push(path);
        }
    }

    /// A path from the crate's name on; `None` where it leads out of the workspace.
    fn absolute(&self, path: &[String], module: &Module) -> Option<Module> {
        let (first, rest) = path.split_first()?;
        let child = [module.clone(), vec![first.clone()]].concat();
        let start = match first.as_str() {
            "crate" => module[..1].to_vec(),
            "self" => module.clone(),
            "super" => module[..module.len() - 1].to_vec(),
            name if self.file_of.contains_key(&child) && !self.own.contains(name) => child,
            name if self.names.contains_key(name) => self.names[name].clone(),
            name if self.crates.contains(name) => vec![first.clone()],
            _ => return None,
        };
        let mut whole = start;
        for part in rest {
            match part.as_str() {
                "super" => drop(whole.pop()),
                "self" | "*" => {}
                _ => whole.push(part.clone()),
            }
        }
        Some(whole)
    }
}

/// Where the brace that opens at `at` is closed.
fn closing_brace(tokens: &[Token], at: usize) -> usize {
    let mut depth = 0;
    for (place, token) in tokens.iter().enumerate().skip(at) {
        match token {
            Token::Sign('{') => depth += 1,
            Token::Sign('}') if depth == 1 => return place + 1,
            Token::Sign('}') => depth -= 1,
            _ => {}
        }
    }
    tokens.len()
}

fn inside(file: &Module, open: &[(String, usize)]) -> Module {
    file.iter().cloned().chain(open.iter().map(|(name, _)| name.clone())).collect()
}

/// `a::b::c` as its words.
fn leading_words(tokens: &[Token]) -> Vec<String> {
    let mut words = Vec::new();
    for pair in tokens.chunks(2) {
        let Token::Word(word) = &pair[0] else { break };
        words.push(word.clone());
        if pair.get(1) != Some(&Token::Colons) {
            break;
        }
    }
    words
}

/// The paths of a `use` line with the name that each brings in, braces multiplied out.
fn tree(tokens: &[Token], at: &mut usize) -> Vec<(Vec<String>, Option<String>)> {
    let mut prefix: Vec<String> = Vec::new();
    loop {
        match tokens.get(*at) {
            Some(Token::Word(word)) if word == "as" => {
                let Some(Token::Word(name)) = tokens.get(*at + 1) else { return Vec::new() };
                *at += 2;
                return vec![(prefix, Some(name.clone()))];
            }
            Some(Token::Word(word)) => {
                prefix.push(word.clone());
                *at += 1;
            }
            Some(Token::Colons) => *at += 1,
            Some(Token::Sign('*')) => {
                *at += 1;
                return vec![(prefix, None)];
            }
            Some(Token::Sign('{')) => {
                *at += 1;
                return branches(&prefix, tokens, at);
            }
            _ => {
                let is_self = prefix.last().is_some_and(|word| word == "self");
                let name = prefix.iter().rev().nth(usize::from(is_self)).cloned();
                return vec![(prefix, name)];
            }
        }
    }
}

fn branches(prefix: &[String], tokens: &[Token], at: &mut usize) -> Vec<(Vec<String>, Option<String>)> {
    let mut all = Vec::new();
    loop {
        match tokens.get(*at) {
            None => return all,
            Some(Token::Sign('}')) => {
                *at += 1;
                return all;
            }
            Some(Token::Sign(',')) => *at += 1,
            Some(_) => {
                let before = *at;
                for (path, name) in tree(tokens, at) {
                    let name = if path == ["self"] { prefix.last().cloned() } else { name };
                    all.push((prefix.iter().cloned().chain(path).collect(), name));
                }
                // What is no path of a `use` line must not hold the reader up.
                *at = (*at).max(before + 1);
            }
        }
    }
}
