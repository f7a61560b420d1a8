//! The table shaders as text to include in shaders of one's own: no entry point, and a prefix before every name that is global.
//!
//! Words of the WGSL source are renamed, then it is translated: so comments stay in WGSL, and every language has the same names.

use std::collections::BTreeSet;
use std::fmt::Write;

use naga::{Module, ScalarKind, TypeInner};
use serde_json::json;

use super::shader_export::{ShaderLanguage, ShaderSource, fault, glsl_fragment, hlsl_text, msl_text, parsed};
use crate::error::{Error, Result};
use diffraction_brdf::Error as Library;

/// Languages that have includes; SPIR-V has no text.
pub const LANGUAGES: [ShaderLanguage; 5] = [
    ShaderLanguage::Wgsl,
    ShaderLanguage::GlslEs300,
    ShaderLanguage::Glsl450,
    ShaderLanguage::Hlsl,
    ShaderLanguage::Msl,
];

/// How an include's globals are told from those of the program around it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IncludeConfig {
    /// Comes before every global name.
    pub prefix: String,
    /// Binding of the uniform block; those of the textures and the sampler follow. Not in GLSL ES and MSL, which have none.
    pub first_binding: u32,
}

/// Name of an include's file.
pub fn file_name(source: ShaderSource, language: ShaderLanguage) -> String {
    let extension = match language {
        ShaderLanguage::Wgsl => "wgsl",
        ShaderLanguage::GlslEs300 => "es300.glsl",
        ShaderLanguage::Glsl450 => "450.glsl",
        ShaderLanguage::Hlsl => "hlsli",
        ShaderLanguage::Msl => "metal.h",
        ShaderLanguage::Spirv => "spv",
    };
    format!("{}.{extension}", source.name())
}

/// The text that evaluates tables, in a language of [`LANGUAGES`].
///
/// # Errors
/// `Error::Call` for a prefix that is no name or ends in a digit or an underscore twice; `Error::Gpu` if a translation fails, a fault
/// of this program.
pub fn include(source: ShaderSource, language: ShaderLanguage, config: &IncludeConfig) -> Result<String> {
    check_prefix(&config.prefix)?;
    let (wgsl, names) = prefixed(source, config)?;
    let evaluation = without_entry_point(&wgsl)?;
    if language == ShaderLanguage::Wgsl {
        return Ok(evaluation.to_owned());
    }
    let prefix = &config.prefix;
    let text = match language {
        ShaderLanguage::GlslEs300 | ShaderLanguage::Glsl450 => {
            let text = glsl_fragment(&wgsl, &format!("{prefix}{}", source.entry_point()), language)?;
            glsl_evaluation(&text, config)?
        }
        ShaderLanguage::Hlsl => hlsl_text(evaluation, &format!("{prefix}bilinear"), config.first_binding + 4)?,
        ShaderLanguage::Msl => msl_text(evaluation)?,
        ShaderLanguage::Wgsl | ShaderLanguage::Spirv => return Err(fault("text", "it is none that is included")),
    };
    // What the translation adds has names of its own.
    let helper = |word: &str| {
        let added = word.starts_with("naga_") || word.starts_with("Naga") || word.starts_with("_naga_");
        (added && !names.contains(word)).then(|| format!("{prefix}{word}"))
    };
    Ok(renamed(&text, |_, word, _| helper(word)))
}

/// The uniform block as a description in JSON and as a struct in C with its offsets asserted.
///
/// # Errors
/// As [`include()`].
pub fn block(source: ShaderSource, config: &IncludeConfig) -> Result<(serde_json::Value, String)> {
    check_prefix(&config.prefix)?;
    let (module, _) = parsed(&source.wgsl())?;
    let name = if matches!(source, ShaderSource::Tables | ShaderSource::TablesFiltered | ShaderSource::TablesSampled) {
        "TableParams"
    } else {
        "SpectralParams"
    };
    let found = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name));
    let Some((_, naga::Type { inner: TypeInner::Struct { members, span }, .. })) = found else {
        return Err(fault("WGSL", format!("it has no struct {name}")));
    };
    let c_name = format!("{}{name}", config.prefix);
    let mut text = format!(
        "/* The bytes of the uniform block, little-endian. */\n#include <stddef.h>\n#include <stdint.h>\n\ntypedef struct {c_name} {{\n"
    );
    let (mut fields, mut asserts, mut reached) = (Vec::new(), String::new(), 0);
    for member in members {
        let member_name = member.name.as_deref().unwrap_or("unnamed");
        if member.offset > reached {
            let _ = writeln!(text, "    uint8_t unused_{reached}[{}];", member.offset - reached);
        }
        let (scalar, lengths, bytes) = c_field(&module, member.ty)?;
        let dimensions: String = lengths.iter().map(|length| format!("[{length}]")).collect();
        let _ = writeln!(text, "    {scalar} {member_name}{dimensions};");
        let _ = writeln!(
            asserts,
            "_Static_assert(offsetof({c_name}, {member_name}) == {}, \"{member_name}\");",
            member.offset
        );
        fields.push(json!({ "name": member_name, "offset": member.offset, "bytes": bytes, "scalar": scalar, "lengths": lengths }));
        reached = member.offset + bytes;
    }
    if *span > reached {
        let _ = writeln!(text, "    uint8_t unused_{reached}[{}];", span - reached);
    }
    let _ = write!(text, "}} {c_name};\n\n{asserts}_Static_assert(sizeof({c_name}) == {span}, \"size\");\n");
    Ok((json!({ "name": name, "bytes": span, "byte_order": "little-endian", "fields": fields }), text))
}

/// A field as C has it: its scalar, the lengths of its arrays from the outer to the inner one, and its bytes.
fn c_field(module: &Module, ty: naga::Handle<naga::Type>) -> Result<(&'static str, Vec<u32>, u32)> {
    let named = |kind: ScalarKind| match kind {
        ScalarKind::Uint => Ok("uint32_t"),
        ScalarKind::Sint => Ok("int32_t"),
        ScalarKind::Float => Ok("float"),
        _ => Err(fault("C", "a field is neither a number nor a vector")),
    };
    match module.types[ty].inner {
        TypeInner::Scalar(scalar) => Ok((named(scalar.kind)?, vec![], 4)),
        TypeInner::Vector { size, scalar } => Ok((named(scalar.kind)?, vec![size as u32], 4 * size as u32)),
        TypeInner::Array { base, size: naga::ArraySize::Constant(count), stride } => {
            let (scalar, mut lengths, _) = c_field(module, base)?;
            lengths.insert(0, count.get());
            Ok((scalar, lengths, count.get() * stride))
        }
        _ => Err(fault("C", "a field is neither a number nor a vector")),
    }
}

fn check_prefix(prefix: &str) -> Result<()> {
    let starts = prefix.starts_with(|c: char| c.is_ascii_alphabetic());
    let is_name = prefix.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    // GLSL keeps two underscores and `gl_` to itself, WGSL and naga names that begin with them.
    if starts && is_name && !prefix.contains("__") && !["gl_", "naga"].iter().any(|kept| prefix.starts_with(kept)) {
        return Ok(());
    }
    Err(Error::from(Library::Call(format!(
        "the prefix {prefix:?} cannot begin names of every shading language: take letters, digits and single underscores, a letter first, such as \"sunbeam_\""
    ))))
}

/// The source with the prefix before all that is global and bindings from the first one on, and the new names.
fn prefixed(source: ShaderSource, config: &IncludeConfig) -> Result<(String, BTreeSet<String>)> {
    let wgsl = source.wgsl();
    let (module, _) = parsed(&wgsl)?;
    let mut names: BTreeSet<String> =
        module.functions.iter().filter_map(|(_, function)| function.name.clone()).collect();
    names.extend(module.constants.iter().filter_map(|(_, constant)| constant.name.clone()));
    names.extend(module.global_variables.iter().filter_map(|(_, variable)| variable.name.clone()));
    names.extend(module.types.iter().filter_map(|(_, ty)| ty.name.clone()));
    names.extend(module.entry_points.iter().map(|entry| entry.name.clone()));
    let text = renamed(&wgsl, |before, word, after| {
        let is_field = before.ends_with('.');
        // A field, a parameter or a local variable with a type; what is global follows `var`, `var<uniform>` or `const`.
        let is_declared = after.trim_start().starts_with(':')
            && !["var", "const", ">"].iter().any(|start| before.trim_end().ends_with(start));
        (names.contains(word) && !is_field && !is_declared).then(|| format!("{}{word}", config.prefix))
    });
    let mut moved = String::with_capacity(text.len());
    let mut pieces = text.split("@binding(");
    moved += pieces.next().unwrap_or_default();
    for piece in pieces {
        let (number, rest) = piece.split_once(')').unwrap_or((piece, ""));
        let number: u32 = number.parse().map_err(|_| fault("WGSL", "a binding is no number"))?;
        let _ = write!(moved, "@binding({}){rest}", number + config.first_binding);
    }
    parsed(&moved)?;
    Ok((moved, names.iter().map(|name| format!("{}{name}", config.prefix)).collect()))
}

/// Every word of code replaced that `new` has another one for, which sees what comes before and after; comments stay.
fn renamed(text: &str, new: impl Fn(&str, &str, &str) -> Option<String>) -> String {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    let bytes = text.as_bytes();
    let (mut out, mut at) = (String::with_capacity(text.len()), 0);
    while at < bytes.len() {
        let rest = &text[at..];
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if is_word(bytes[at]) {
            bytes[at..].iter().take_while(|byte| is_word(**byte)).count()
        } else {
            rest.chars().next().map_or(1, char::len_utf8)
        };
        let (piece, after) = rest.split_at(length);
        let is_name = is_word(bytes[at]) && !bytes[at].is_ascii_digit();
        match is_name.then(|| new(&text[..at], piece, after)).flatten() {
            Some(other) => out += &other,
            None => out += piece,
        }
        at += length;
    }
    out
}

/// What stands before the entry point, which is the last function of every source, and the comment above it.
fn without_entry_point(wgsl: &str) -> Result<&str> {
    let end = wgsl.rfind("@fragment").ok_or_else(|| fault("WGSL", "it has no entry point"))?;
    let before = wgsl[..end].trim_end();
    let comment: usize =
        before.lines().rev().take_while(|line| line.starts_with("//")).map(|line| line.len() + 1).sum();
    Ok(before[..before.len().saturating_sub(comment)].trim_end())
}

/// Functions of a translated fragment shader, its block and textures by their own names.
fn glsl_evaluation(text: &str, IncludeConfig { prefix, first_binding }: &IncludeConfig) -> Result<String> {
    let end = text.find("void main()").ok_or_else(|| fault("GLSL", "it has no entry point"))?;
    let is_of_entry = |line: &str| {
        ["#version", "smooth in ", "flat in ", "layout(location = "].iter().any(|start| line.starts_with(start))
    };
    let kept: Vec<&str> = text[..end].lines().filter(|line| !is_of_entry(line)).collect();
    let bindings = ["params", "tables", "cross_terms", "lobe", "bilinear", "lobe_gaussians", "sampling"];
    let named = |word: &str| {
        let number = word.strip_prefix("_group_0_binding_")?.strip_suffix("_fs")?.parse::<usize>().ok()?;
        bindings.get(number.checked_sub(*first_binding as usize)?).map(|name| format!("{prefix}{name}"))
    };
    let body = renamed(&kept.join("\n"), |_, word, _| named(word));
    Ok(format!("{}\n", body.trim()))
}
