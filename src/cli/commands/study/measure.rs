//! The work of `study`: from a manifest to the study's folder.

use super::args::StudyArgs;
use crate::cli::destination;
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::progress::reporter;
use crate::error::Result;
use crate::manifest;
use crate::report::study_page::{PAGE, write_study};
use crate::stages::config::SpecimenConfig;
use crate::stages::ingest::{Scans, ingest};
use crate::stages::study::{FrameClock, drawn, lit_shapes};
use diffraction_brdf::error::Error;
use diffraction_build::optics::config::{Factor, OpticsConfig};
use diffraction_render::scene::model::Scene;
use diffraction_study::stability::{StabilityCase, Verdict, run_stability};
use diffraction_study::study::{GpuClock, SceneSamples, StudyConfig, StudySpecimen, run_study};

/// As [`super::run`].
pub(crate) fn run(args: &StudyArgs, global: &Global) -> Result<Outcome> {
    destination::check_folder(&args.out, Some(args.force))?;
    let (manifest, _) = manifest::load(&args.manifest)?;
    if let Some(unknown) = args.specimen.iter().find(|name| manifest.specimens.iter().all(|s| s.name != **name)) {
        return Err(Error::Call(format!("{}: no specimen is called `{unknown}`", args.manifest.display())).into());
    }
    let is_chosen = |s: &&SpecimenConfig| args.specimen.is_empty() || args.specimen.contains(&s.name);
    if let Some(specimen) = manifest.specimens.iter().filter(is_chosen).find(|s| s.optics.source_deg.is_some()) {
        return Err(Error::Call(format!(
            "{}: specimen \"{}\" has coherence.source_deg, a source of fixed size, and the models that a study compares know one \
             coherence for all wavelengths: give sigma_um for the study, or choose others with --specimen",
            args.manifest.display(),
            specimen.name
        ))
        .into());
    }
    let progress = reporter(global.quiet);
    let config = if args.thorough { StudyConfig::thorough() } else { StudyConfig::quick() };
    let mut failures = Vec::new();
    let mut specimens = Vec::new();
    for given in manifest.specimens.iter().filter(is_chosen) {
        match specimen(given, &manifest.scenes, &config) {
            Ok(specimen) => specimens.push(specimen),
            Err(error) => failures.push(format!("{}: {error}", given.name)),
        }
    }
    let gpu = open_gpu(&config);
    let gpu = gpu.as_ref().map(|clock| clock as &dyn GpuClock).map_err(String::as_str);
    let study = run_study(&specimens, &config, gpu, progress.as_ref());
    failures.extend(study.failures.iter().map(|refusal| format!("{}: {}", refusal.what, refusal.message)));
    let stability = run_stability(args.thorough, progress.as_ref());
    write_study(&args.out, &study, &stability)?;
    let cases = &stability.cases;
    failures.extend(cases.iter().filter_map(fault));
    output::print(&format!(
        "studied {} specimen(s), {} of {} stability cases kept their bound and need their guard\nreport    {}\n",
        study.specimens.len(),
        cases.iter().filter(|case| case.verdict() == Verdict::Kept).count(),
        cases.len(),
        args.out.join(PAGE).display()
    ))?;
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

/// A specimen's prepared scans, and samples of the scenes that show it.
fn specimen(given: &SpecimenConfig, scenes: &[Scene], config: &StudyConfig) -> Result<StudySpecimen> {
    let shows = |scene: &&Scene| scene.specimen.as_ref().is_none_or(|name| *name == given.name);
    let sampled = |scene| Ok(Box::new(drawn(scene, config.picture_samples)?) as Box<dyn SceneSamples>);
    let Scans { fields, optics, .. } = ingest(given)?;
    Ok(StudySpecimen {
        name: given.name.clone(),
        fields,
        // The published series has no other: its tables hold the lobe with all else.
        optics: OpticsConfig { factor: Factor::Scalar, ..optics },
        scenes: scenes.iter().filter(shows).map(sampled).collect::<Result<_>>()?,
        lights: lit_shapes(config.light_pixels),
    })
}

/// A GPU to time evaluation on, or why there is none.
fn open_gpu(config: &StudyConfig) -> std::result::Result<FrameClock, String> {
    if !config.gpu {
        return Err("not asked for".into());
    }
    let found = FrameClock::open().map_err(|error| error.to_string())?;
    found.ok_or_else(|| "no adapter: no Vulkan, Metal or DirectX 12 driver was found".into())
}

/// What is wrong with a case, if anything.
fn fault(case: &StabilityCase) -> Option<String> {
    let StabilityCase { name, measured, bound, guard, .. } = case;
    match case.verdict() {
        Verdict::Kept => None,
        Verdict::Broken => Some(format!("stability, {name}: measured {measured:.2e}, bound {bound:.2e}")),
        Verdict::Blind => Some(format!(
            "stability, {name}: {:.2e} without {}, within the bound of {bound:.2e}: the case shows nothing",
            guard.without, guard.what
        )),
    }
}
