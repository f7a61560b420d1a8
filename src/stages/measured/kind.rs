//! Kinds of measured values: what each is compared with, and how it is called.

/// What a value is, by what it is compared with. `f` is the BRDF, `⟨·⟩` the mean over cone and slit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// `⟨f cos_theta⟩ / cos_theta_r` in 1/sr.
    Brdf,
    /// `⟨f cos_theta⟩` in 1/sr: power per solid angle relative to the incident power.
    Scatter,
    /// `π ⟨f cos_theta⟩ / ⟨cos_theta⟩`: relative to a white Lambertian seen in the same cone.
    RadianceFactor,
    /// `Ω ⟨f cos_theta⟩`, `Ω` being the cone's solid angle: the share of the incident power that is caught.
    ConeReflectance,
    /// `⟨f cos_theta⟩ / cos_theta_r` times a factor that is fitted.
    RelativeRadiance,
    /// `⟨f cos_theta⟩` times a factor that is fitted.
    RelativePower,
}

/// Names of the kinds as columns.
const KINDS: [(&str, Kind); 7] = [
    ("brdf_per_sr", Kind::Brdf),
    ("scatter_per_sr", Kind::Scatter),
    ("radiance_factor", Kind::RadianceFactor),
    ("reflectance_factor", Kind::RadianceFactor),
    ("cone_reflectance", Kind::ConeReflectance),
    ("relative_radiance", Kind::RelativeRadiance),
    ("relative_power", Kind::RelativePower),
];

impl Kind {
    /// Whether a factor between model and measurement is fitted.
    pub(crate) fn is_relative(self) -> bool {
        matches!(self, Self::RelativeRadiance | Self::RelativePower)
    }

    /// Whether a hundredth part may be its unit.
    fn is_share(self) -> bool {
        matches!(self, Self::RadianceFactor | Self::ConeReflectance)
    }
}

/// The kind that a column's name in lower case says, and whether it is in per cent; `None` for other columns.
pub(crate) fn value_kind(name: &str) -> std::result::Result<Option<(Kind, bool)>, String> {
    let word = name.split(':').next().unwrap_or(name).trim();
    let of = |word: &str| KINDS.iter().find(|(known, _)| *known == word).map(|(_, kind)| *kind);
    if let Some(kind) = of(word) {
        return Ok(Some((kind, false)));
    }
    if let Some(kind) = word.strip_suffix("_percent").and_then(of) {
        return if kind.is_share() { Ok(Some((kind, true))) } else { Err(format!("`{word}` cannot be in per cent")) };
    }
    // Half a name would be a guess at what was measured.
    let started = ["brdf", "scatter", "radiance", "reflectance", "relative", "cone", "btdf", "bsdf"];
    if started.iter().any(|start| word.starts_with(start)) {
        let known: Vec<String> = KINDS.iter().map(|(name, _)| format!("`{name}`")).collect();
        return Err(format!("`{word}` does not say its kind and unit; expected one of {}", known.join(", ")));
    }
    Ok(None)
}

/// The names of all kinds.
pub(crate) fn names() -> Vec<&'static str> {
    KINDS.iter().map(|(name, _)| *name).collect()
}
