//! Typed reading of spanned TOML values, where each refusal names the key, the place, and what was expected.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::keys::{self, Keys};
use super::source::Source;
use crate::error::{Error, Result};

/// A table whose keys are all known.
#[derive(Debug, Clone)]
pub(crate) struct Section<'s> {
    source: Source<'s>,
    table: &'s DeTable<'s>,
    span: Range<usize>,
    path: String,
}

/// One value, with the path of keys that leads to it.
#[derive(Debug, Clone)]
pub(crate) struct Item<'s> {
    source: Source<'s>,
    value: &'s DeValue<'s>,
    span: Range<usize>,
    path: String,
}

impl<'s> Section<'s> {
    /// The whole document.
    pub fn document(source: Source<'s>, document: &'s Spanned<DeTable<'s>>) -> Result<Self> {
        // What is missing at the top level is pointed at where it could be written: the first line.
        Self::checked(source, document.get_ref(), 0..0, String::new(), &keys::TOP)
    }

    /// A table that does not stand in the document's text as one: the row of a CSV file, whose text `source` is.
    pub(crate) fn row(source: Source<'s>, table: &'s DeTable<'s>, span: Range<usize>, keys: &Keys) -> Result<Self> {
        Self::checked(source, table, span, String::new(), keys)
    }

    fn checked(
        source: Source<'s>,
        table: &'s DeTable<'s>,
        span: Range<usize>,
        path: String,
        keys: &Keys,
    ) -> Result<Self> {
        let unknown = table
            .iter()
            .filter(|(key, _)| !keys.names.contains(&key.get_ref().as_ref()))
            .min_by_key(|(key, _)| key.span().start);
        if let Some((key, value)) = unknown {
            let message = keys::unknown_key(key.get_ref(), keys, as_number(value.get_ref()), value.get_ref().as_str());
            return Err(source.error(key.span(), message));
        }
        Ok(Self { source, table, span, path })
    }

    /// The same, called by its user's name in messages rather than by its place in a list.
    pub(crate) fn called(mut self, kind: &str, name: &Item) -> Self {
        if let Some(name) = name.as_text().filter(|name| !name.is_empty()) {
            self.path = format!("{kind} \"{name}\"");
        }
        self
    }

    /// The value of a key, if it is given.
    pub fn get(&self, key: &str) -> Option<Item<'s>> {
        let value = self.table.get(key)?;
        Some(Item {
            source: self.source,
            value: value.get_ref(),
            span: value.span(),
            path: match self.path.as_str() {
                "" => key.to_owned(),
                // Behind a name in quotes a dot reads as its end.
                path if path.ends_with('"') => format!("{path}: {key}"),
                path => format!("{path}.{key}"),
            },
        })
    }

    /// The value of a key that must be given; `example` shows how.
    pub fn require(&self, key: &str, example: &str) -> Result<Item<'s>> {
        self.get(key).ok_or_else(|| {
            let place = if self.path.is_empty() { String::new() } else { format!(" in `{}`", self.path) };
            self.error(format!("`{key}` is missing{place}; add for example `{example}`"))
        })
    }

    /// An error at the table as a whole.
    pub fn error(&self, message: impl Into<String>) -> Error {
        self.source.error(self.span.clone(), message)
    }

    /// Whether a key is given.
    pub fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// An error at the name of the first of two keys that is given.
    pub(crate) fn error_at_either(&self, key: &str, other: &str, message: impl Into<String>) -> Error {
        self.error_at_key(if self.has(key) { key } else { other }, message)
    }

    /// An error at the name of a given key.
    pub(crate) fn error_at_key(&self, key: &str, message: impl Into<String>) -> Error {
        let span = self.table.get_key_value(key).map_or(self.span.clone(), |(key, _)| key.span());
        self.source.error(span, message)
    }
}

impl<'s> Item<'s> {
    /// An error at this value; the message starts with the key's path.
    pub fn error(&self, message: impl AsRef<str>) -> Error {
        let message = format!("`{}` {}", self.path, message.as_ref());
        self.source.error(self.span.clone(), message)
    }

    /// The path of keys, as messages show it.
    pub fn path(&self) -> &str {
        &self.path
    }

    fn expected(&self, expected: &str) -> Error {
        self.error(format!("must be {expected}; found {}", describe(self.value)))
    }

    /// A string.
    pub fn text(&self) -> Result<&'s str> {
        match self.value {
            DeValue::String(text) => Ok(text.as_ref()),
            _ => Err(self.expected("a string in quotes")),
        }
    }

    /// A string with something in it.
    pub(crate) fn text_not_empty(&self) -> Result<&'s str> {
        let text = self.text()?;
        if text.trim().is_empty() {
            return Err(self.error("must not be empty"));
        }
        Ok(text)
    }

    /// The string, if it is one.
    pub(crate) fn as_text(&self) -> Option<&'s str> {
        self.text().ok()
    }

    /// A truth value.
    pub(crate) fn boolean(&self) -> Result<bool> {
        match self.value {
            DeValue::Boolean(value) => Ok(*value),
            _ => Err(self.expected("true or false")),
        }
    }

    /// A finite number, whole or not.
    pub fn number(&self) -> Result<f64> {
        match as_number(self.value) {
            Some(number) if number.is_finite() => Ok(number),
            Some(number) => Err(self.error(format!("must be a finite number; found {number}"))),
            None if self.as_text().is_some_and(has_decimal_comma) => {
                Err(self.expected("a number, with a decimal point and without quotes"))
            }
            None => Err(self.expected("a number")),
        }
    }

    /// A number in `[low, high]`; `unit` may be empty.
    pub(crate) fn number_within(&self, low: f64, high: f64, unit: &str) -> Result<f64> {
        let number = self.number()?;
        if number < low || number > high {
            let unit = spaced(unit);
            let [low, high, number] = [low, high, number].map(keys::short);
            return Err(self.error(format!("must lie between {low} and {high}{unit}; found {number}")));
        }
        Ok(number)
    }

    /// A number in `(low, high]`; `unit` may be empty.
    pub(crate) fn number_above(&self, low: f64, high: f64, unit: &str) -> Result<f64> {
        let number = self.number()?;
        if number <= low || number > high {
            let unit = spaced(unit);
            let [low, high, number] = [low, high, number].map(keys::short);
            return Err(self.error(format!("must be above {low} and at most {high}{unit}; found {number}")));
        }
        Ok(number)
    }

    /// A whole number in `[low, high]`; `unit` may be empty.
    pub(crate) fn integer_within(&self, low: usize, high: usize, unit: &str) -> Result<usize> {
        let DeValue::Integer(integer) = self.value else {
            return Err(self.expected("a whole number"));
        };
        i128::from_str_radix(integer.as_str(), integer.radix())
            .ok()
            .and_then(|value| usize::try_from(value).ok())
            .filter(|value| (low..=high).contains(value))
            .ok_or_else(|| {
                let unit = spaced(unit);
                let found = cut(&integer.to_string());
                self.error(format!("must lie between {low} and {high}{unit}; found {found}"))
            })
    }

    /// The elements of a list.
    pub fn list(&self) -> Result<Vec<Item<'s>>> {
        let DeValue::Array(array) = self.value else {
            return Err(self.expected("a list in square brackets"));
        };
        let item = |(index, value): (usize, &'s Spanned<DeValue<'s>>)| Item {
            source: self.source,
            value: value.get_ref(),
            span: value.span(),
            path: format!("{}[{index}]", self.path),
        };
        Ok(array.iter().enumerate().map(item).collect())
    }

    /// Exactly `N` elements, described by `what` in the message.
    pub(crate) fn list_of<const N: usize>(&self, what: &str) -> Result<[Item<'s>; N]> {
        let DeValue::Array(_) = self.value else {
            return Err(self.expected(what));
        };
        let list = self.list()?;
        let found = list.len();
        list.try_into().map_err(|_| self.error(format!("must be {what}; found {found} elements")))
    }

    /// Whether it is a list.
    pub(crate) fn is_list(&self) -> bool {
        matches!(self.value, DeValue::Array(_))
    }

    /// Whether it is a table.
    pub(crate) fn is_table(&self) -> bool {
        matches!(self.value, DeValue::Table(_))
    }

    /// A table that takes only the given keys; `example` shows one.
    pub fn section(&self, keys: &Keys, example: &str) -> Result<Section<'s>> {
        let DeValue::Table(table) = self.value else {
            return Err(self.expected(&format!("a table such as `{example}`")));
        };
        Section::checked(self.source, table, self.span.clone(), self.path.clone(), keys)
    }

    /// The names and values of a table whose names are the user's own, in their order in the text; `example` shows one.
    pub(crate) fn named_values(&self, example: &str) -> Result<Vec<(String, Item<'s>)>> {
        let DeValue::Table(table) = self.value else {
            return Err(self.expected(&format!("a table such as `{example}`")));
        };
        let mut entries: Vec<_> = table.iter().collect();
        entries.sort_by_key(|(name, _)| name.span().start);
        let item = |(name, value): (&Spanned<_>, &'s Spanned<DeValue<'s>>)| {
            let name: &std::borrow::Cow<str> = name.get_ref();
            let path = format!("{}.{name}", self.path);
            (name.to_string(), Item { source: self.source, value: value.get_ref(), span: value.span(), path })
        };
        Ok(entries.into_iter().map(item).collect())
    }

    /// One of a few words.
    pub fn choice<T: Copy>(&self, options: &[(&str, T)]) -> Result<T> {
        self.choice_besides(options, "")
    }

    /// One of a few words where something else, read elsewhere, would also do; `besides` says what, or is empty.
    pub(crate) fn choice_besides<T: Copy>(&self, options: &[(&str, T)], besides: &str) -> Result<T> {
        let words: Vec<&str> = options.iter().map(|(word, _)| *word).collect();
        let list = words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
        let list = if besides.is_empty() { list } else { format!("{list}, or {besides}") };
        let Some(text) = self.as_text() else {
            return Err(self.expected(&format!("one of {list}")));
        };
        options.iter().find(|(word, _)| *word == text).map(|(_, value)| *value).ok_or_else(|| {
            let hint = keys::nearest(text, &words).map_or(String::new(), |word| format!("; did you mean \"{word}\"?"));
            self.error(format!("must be one of {list}; found \"{text}\"{hint}"))
        })
    }
}

fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

/// What a message shows of a text.
fn cut(text: &str) -> String {
    text.chars().take(40).collect()
}

fn as_number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Integer(integer) => {
            i128::from_str_radix(integer.as_str(), integer.radix()).ok().map(|value| value as f64)
        }
        DeValue::Float(float) => float.as_str().parse().ok(),
        _ => None,
    }
}

/// A value in words.
fn describe(value: &DeValue) -> String {
    match value {
        DeValue::String(text) => format!("the string {:?}", cut(text)),
        DeValue::Integer(integer) => format!("the number {}", cut(&integer.to_string())),
        DeValue::Float(float) => format!("the number {}", cut(&float.to_string())),
        DeValue::Boolean(value) => format!("{value}"),
        DeValue::Datetime(date) => format!("the date {date}"),
        DeValue::Array(array) => format!("a list of {}", array.len()),
        DeValue::Table(_) => "a table".to_owned(),
    }
}

/// Whether a text is a number as it is written with a comma: "48,8".
fn has_decimal_comma(text: &str) -> bool {
    text.contains(',') && text.replacen(',', ".", 1).trim().parse::<f64>().is_ok()
}
