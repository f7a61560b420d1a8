//! Results of a specimen that the cache may know: its tables, the reference's values, the direct sum's.
//!
//! Every function here returns, bit for bit, what it would return without a cache. Keys hold the prepared heights
//! themselves, so that they say nothing of where a scan lies or what it is called.

use std::cell::Cell;
use std::collections::{HashMap, HashSet};

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::store::{Cache, CacheUse, Take};
use crate::stages::built::Built;
use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_build::accuracy::directions::ErrorDirections;
use diffraction_build::accuracy::reference::{self as accuracy_reference, Reference};
use diffraction_build::accuracy::rows::{self, ErrorRow};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Factor, Material, OpticsConfig};
use diffraction_build::optics::reference;
use diffraction_build::tables::coverage::ranges::Coverage;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Advance, Basis, BuildRecord, Lobe, TableSet, TablesConfig};
use diffraction_build::tables::plan::BuildPlan;

type Pair = (Vec3, Vec3);

/// Share of the cache's limit that one specimen's reference values may take; beyond, those no longer asked for go.
const PAIRS_SHARE: u64 = 4;

/// Bytes of a pair of directions with its value.
const PAIR_BYTES: usize = 9 * 8;

/// What the cache knows of one specimen.
#[derive(Debug)]
pub(crate) struct Known<'a> {
    cache: &'a Cache,
    /// The prepared heights, by their digest.
    heights: String,
    used: Cell<CacheUse>,
}

impl<'a> Known<'a> {
    /// Of the specimen with these prepared heights.
    pub fn new(cache: &'a Cache, fields: &[HeightField]) -> Self {
        let heights = if cache.is_on() { digest_of(fields) } else { String::new() };
        Self { cache, heights, used: Cell::default() }
    }

    /// What was found and what was computed so far; bytes are counted by the cache.
    pub fn used(&self) -> CacheUse {
        self.used.get()
    }

    fn count(&self, count: impl FnOnce(&mut CacheUse)) {
        let mut used = self.used.get();
        count(&mut used);
        self.used.set(used);
    }

    fn key(&self, kind: &str, parts: &Value) -> String {
        self.cache.key(kind, &json!({ "heights": self.heights, "parts": parts }))
    }

    /// The tables of a plan, and what building them took.
    ///
    /// # Errors
    /// Those of building.
    pub fn tables(&self, input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<Built> {
        if !self.cache.is_on() {
            return Built::measured(input, plan, advance);
        }
        // How tables are stored changes nothing before it, but that the series is refused where its format is too coarse.
        let storage = input.tables.storage.filter(|_| input.tables.basis == Basis::Taylor);
        let settings = TablesConfig { storage, ..input.tables.clone() };
        let parts = json!({ "optics": behind_front(input.optics), "settings": settings, "plan": plan_parts(plan) });
        let key = self.key("tables", &parts);
        if let Some(found) = self.cache.load(&key).and_then(|bytes| decode_tables(&bytes, input, plan)) {
            self.count(|used| used.tables_found += 1);
            return Ok(found);
        }
        let built = Built::measured(input, plan, advance)?;
        self.cache.store_parts(&key, &mut |take| encode_tables(&built, take));
        self.count(|used| used.tables_built += 1);
        Ok(built)
    }

    /// [`accuracy_reference::evaluate`], asked where it is not known.
    ///
    /// # Errors
    /// Those of the transforms.
    pub fn reference(
        &self,
        input: &BuildInput,
        plan: &BuildPlan,
        nodes: usize,
        errors: ErrorDirections,
        pictures: impl IntoIterator<Item = Pair>,
    ) -> Result<Reference> {
        let evaluate =
            |errors, pictures| accuracy_reference::evaluate(input.fields, input.optics, plan, nodes, errors, pictures);
        if !self.cache.is_on() {
            return evaluate(errors, pictures.into_iter().collect::<Vec<_>>());
        }
        let pictures: Vec<Pair> = pictures.into_iter().collect();
        let [pairs_key, errors_key] = self.reference_keys(input, plan, nodes, &errors);
        let mut known = self.cache.load(&pairs_key).and_then(|bytes| decode_pairs(&bytes)).unwrap_or_default();
        let mut asked = HashSet::new();
        let missing: Vec<Pair> = pictures
            .iter()
            .copied()
            .filter(|pair| !known.contains_key(&bits(pair)) && asked.insert(bits(pair)))
            .collect();
        let counted = self.cache.load(&errors_key).and_then(|bytes| decode_counted(&bytes, &errors, input.optics));
        let (fixed, is_counted) = (errors.pairs.len(), counted.is_some());
        self.count(|used| {
            let computed = missing.len() + if is_counted { 0 } else { fixed };
            used.pairs_computed += computed as u64;
            used.pairs_found += (fixed + pictures.len()).saturating_sub(computed) as u64;
        });
        let wanted = if is_counted { ErrorDirections::default() } else { errors };
        let fresh = match wanted.pairs.is_empty() && missing.is_empty() {
            true => Reference::default(),
            false => evaluate(wanted, missing.clone())?,
        };
        let first = fresh.pairs.len() - missing.len();
        let found = missing.iter().zip(fresh.xyz[first..].iter().copied());
        known.extend(found.map(|(pair, xyz)| (bits(pair), xyz)));
        let mut all = match counted {
            None => fresh.counted(fixed),
            Some(mut known) => {
                accuracy_reference::bound_groups(input.fields, input.optics, &mut known.groups, &known.pairs)?;
                known
            }
        };
        if !is_counted {
            self.cache.store(&errors_key, &encode_counted(&all));
        }
        all.xyz.extend(pictures.iter().map(|pair| known[&bits(pair)]));
        all.pairs.extend(&pictures);
        if !missing.is_empty() {
            // Other plans hold other frequencies: what asks for more than this one has is nothing for them.
            let held = |pair: &Pair| plan.spectra.holds(input.optics, wave_vector_change(pair.0, pair.1));
            for pair in missing.iter().filter(|pair| !held(pair)) {
                known.remove(&bits(pair));
            }
            self.keep_pairs(&pairs_key, known, &pictures);
        }
        Ok(all)
    }

    /// Keys of the values at pictures' pairs, and of those on which errors are counted.
    fn reference_keys(
        &self,
        input: &BuildInput,
        plan: &BuildPlan,
        nodes: usize,
        errors: &ErrorDirections,
    ) -> [String; 2] {
        let transforms = json!({ "optics": input.optics, "spectra": transforms_parts(plan) });
        let parts = json!({
            "transforms": transforms, "plan": plan_parts(plan), "nodes": nodes,
            "pairs": files::sha256_hex(&pair_bytes(&errors.pairs)),
        });
        [self.key("pictures", &transforms), self.key("errors", &parts)]
    }

    /// Keeps the values at pictures' pairs: where they are too many, those that were asked for last.
    fn keep_pairs(&self, key: &str, mut known: HashMap<[u64; 6], Xyz>, asked: &[Pair]) {
        if (known.len() * PAIR_BYTES) as u64 > self.cache.limit_bytes() / PAIRS_SHARE {
            let asked: HashSet<[u64; 6]> = asked.iter().map(bits).collect();
            known.retain(|pair, _| asked.contains(pair));
        }
        self.cache.store(key, &encode_pairs(&known));
    }

    /// [`rows::direct_row`] with the direct sum's values where they are known.
    ///
    /// # Errors
    /// Those of the reference.
    pub(crate) fn direct_row(&self, input: &BuildInput, reference_set: &Reference) -> Result<ErrorRow> {
        rows::direct_row(reference_set, &|pairs| {
            let sum = || reference::brdf_xyz_batch(input.fields, input.optics, pairs);
            if !self.cache.is_on() {
                return sum();
            }
            let parts = json!({ "optics": input.optics, "pairs": files::sha256_hex(&pair_bytes(pairs)) });
            let key = self.key("direct sum", &parts);
            let found = self.cache.load(&key).and_then(|bytes| triples(&numbers(&bytes)?, pairs.len()));
            if let Some(xyz) = found {
                return Ok(xyz);
            }
            let xyz = sum()?;
            self.cache.store(&key, &xyz.iter().flatten().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>());
            Ok(xyz)
        })
    }
}

/// The optics as tables depend on them: a material that is the same at every wavelength stands in front of them, with all that
/// belongs to it.
fn behind_front(optics: &OpticsConfig) -> OpticsConfig {
    match optics.dispersion {
        Some(_) => optics.clone(),
        None => OpticsConfig { material: Material::Ideal, shadowing: false, factor: Factor::Scalar, ..optics.clone() },
    }
}

/// Digest of heights and spacings.
fn digest_of(fields: &[HeightField]) -> String {
    let mut digest = Sha256::new();
    for field in fields {
        let (rows, columns) = field.heights_nm.dim();
        [rows, columns].iter().for_each(|count| digest.update((*count as u64).to_le_bytes()));
        field.pitch_nm.iter().for_each(|number| digest.update(number.to_le_bytes()));
        for row in field.heights_nm.outer_iter() {
            let bytes: Vec<u8> = row.iter().flat_map(|number| number.to_le_bytes()).collect();
            digest.update(bytes);
        }
    }
    digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Everything that a value of the transforms depends on besides heights and optics. Frequencies are not among it: which of
/// them a plan holds changes none. Nor is the memory: a plan that does not fit it is none.
fn transforms_parts(plan: &BuildPlan) -> Value {
    json!({ "phase_scale_per_nm": plan.spectra.phase_scale_per_nm, "tolerance": plan.spectra.tolerance })
}

/// Everything that a plan settles beyond what follows from heights and optics.
fn plan_parts(plan: &BuildPlan) -> Value {
    let rings: Vec<Value> = plan
        .rings
        .iter()
        .map(|ring| json!([ring.radius, ring.abs_w, ring.quadrature.wavelengths_nm, ring.quadrature.weights]))
        .collect();
    json!({
        "grid": plan.texels.grid.size,
        "coverage": plan.coverage.as_ref().map(|coverage| files::sha256_hex(&coverage.to_bytes())),
        "filter": [plan.filter.width, plan.filter.samples as f64],
        "rings": rings,
        "spectra": [transforms_parts(plan), json!(plan.spectra.frequency), json!(plan.spectra.memory_bytes)],
        "abs_w": plan.abs_w,
        "nodes_bound": plan.nodes_bound,
        "fine_tolerance": plan.fine_tolerance,
        "lobe": [json!(plan.lobe_radius), json!(plan.lobe_seen), json!(plan.crosses)],
    })
}

fn bits((wi, wo): &Pair) -> [u64; 6] {
    [wi[0], wi[1], wi[2], wo[0], wo[1], wo[2]].map(f64::to_bits)
}

fn pair_bytes(pairs: &[Pair]) -> Vec<u8> {
    pairs.iter().flat_map(bits).flat_map(u64::to_le_bytes).collect()
}

/// Bytes as numbers; `None` where some are left over.
fn numbers(bytes: &[u8]) -> Option<Vec<f64>> {
    let (eights, rest) = bytes.as_chunks::<8>();
    rest.is_empty().then(|| eights.iter().map(|eight| f64::from_le_bytes(*eight)).collect())
}

fn triples(numbers: &[f64], count: usize) -> Option<Vec<Xyz>> {
    let (triples, rest) = numbers.as_chunks::<3>();
    (rest.is_empty() && triples.len() == count).then(|| triples.to_vec())
}

/// Sorted, so that equal contents are equal bytes.
fn encode_pairs(known: &HashMap<[u64; 6], Xyz>) -> Vec<u8> {
    let mut rows: Vec<_> = known.iter().collect();
    rows.sort_unstable_by_key(|(pair, _)| **pair);
    let words = rows.into_iter().flat_map(|(pair, xyz)| pair.iter().copied().chain(xyz.map(f64::to_bits)));
    words.flat_map(u64::to_le_bytes).collect()
}

fn decode_pairs(bytes: &[u8]) -> Option<HashMap<[u64; 6], Xyz>> {
    let numbers = numbers(bytes)?;
    let (rows, rest) = numbers.as_chunks::<9>();
    let row = |row: &[f64; 9]| (std::array::from_fn(|n| row[n].to_bits()), [row[6], row[7], row[8]]);
    rest.is_empty().then(|| rows.iter().map(row).collect())
}

fn encode_counted(reference: &Reference) -> Vec<u8> {
    let parts = reference.diffuse.iter().chain([&reference.as_tables]);
    let numbers = reference.xyz.iter().chain(parts.flatten()).flatten();
    numbers.flat_map(|number| number.to_le_bytes()).collect()
}

fn decode_counted(bytes: &[u8], errors: &ErrorDirections, optics: &OpticsConfig) -> Option<Reference> {
    let as_tables = if optics.dispersion.is_some() { 3 } else { 0 };
    let (numbers, fixed) = (numbers(bytes)?, errors.pairs.len());
    if numbers.len() != (12 + as_tables) * fixed {
        return None;
    }
    let (xyz, rest) = numbers.split_at(3 * fixed);
    let (diffuse, as_tables) = rest.split_at(9 * fixed);
    let diffuse = triples(diffuse, 3 * fixed)?;
    Some(Reference {
        groups: errors.groups.clone(),
        pairs: errors.pairs.clone(),
        xyz: triples(xyz, fixed)?,
        as_tables: triples(as_tables, as_tables.len() / 3)?,
        diffuse: [0, 1, 2].map(|n| diffuse[n * fixed..(n + 1) * fixed].to_vec()),
    })
}

/// What stands before the numbers of tables.
#[derive(Debug, Serialize, Deserialize)]
struct Header {
    record: BuildRecord,
    build_s: f64,
    processor_s: Option<f64>,
    memory_bytes: Option<u64>,
    tables: Vec<[usize; 3]>,
    coherent: Option<[usize; 3]>,
    cross: Vec<[usize; 3]>,
    lobe_radius: f64,
    prefilter_width: f64,
    usable_radius: f64,
}

fn shape(table: &Array3<f32>) -> [usize; 3] {
    table.dim().into()
}

/// A line of JSON, then the numbers of all arrays in order, row by row: all at once they would stand in memory a second time.
fn encode_tables(built: &Built, take: Take) {
    let Built { set, record, seconds, processor_s, memory_bytes } = built;
    let lobe = set.lobe.as_ref();
    let cross = lobe.map_or(&[][..], |lobe| &lobe.cross);
    let header = json!({
        "record": record,
        "build_s": seconds,
        "processor_s": processor_s,
        "memory_bytes": memory_bytes,
        "tables": set.tables.iter().map(shape).collect::<Vec<_>>(),
        "coherent": lobe.map(|lobe| shape(&lobe.coherent)),
        "cross": cross.iter().map(shape).collect::<Vec<_>>(),
        "lobe_radius": lobe.map_or(0.0, |lobe| lobe.radius_max),
        "prefilter_width": set.prefilter_width,
        "usable_radius": set.usable_radius,
    });
    take(format!("{header}\n").as_bytes());
    for array in set.tables.iter().chain(lobe.map(|lobe| &lobe.coherent)).chain(cross) {
        for row in array.outer_iter() {
            take(&row.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>());
        }
    }
}

fn decode_tables(bytes: &[u8], input: &BuildInput, plan: &BuildPlan) -> Option<Built> {
    let end = bytes.iter().position(|byte| *byte == b'\n')?;
    let header: Header = serde_json::from_slice(&bytes[..end]).ok()?;
    let mut rest = &bytes[end + 1..];
    let mut take = |shape: &[usize; 3]| {
        let count = shape.iter().try_fold(4usize, |count, side| count.checked_mul(*side))?;
        let (own, after) = rest.split_at_checked(count)?;
        rest = after;
        let numbers = own.as_chunks::<4>().0.iter().map(|four| f32::from_le_bytes(*four)).collect();
        Array3::from_shape_vec(*shape, numbers).ok()
    };
    let tables = header.tables.iter().map(&mut take).collect::<Option<_>>()?;
    let lobe = match &header.coherent {
        None => None,
        Some(shape) => Some(Lobe {
            coherent: take(shape)?,
            radius_max: header.lobe_radius,
            cross: header.cross.iter().map(&mut take).collect::<Option<_>>()?,
        }),
    };
    let set = TableSet {
        basis: input.tables.basis,
        tables,
        lobe,
        prefilter_width: header.prefilter_width,
        front_factor: input.optics.front_factor(),
        restriction: plan.coverage.as_ref().and_then(Coverage::range_texture),
        usable_radius: header.usable_radius,
    };
    let Header { record, build_s: seconds, processor_s, memory_bytes, .. } = header;
    rest.is_empty().then_some(Built { set, record, seconds, processor_s, memory_bytes })
}
