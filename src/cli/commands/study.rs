//! `study`: error against run time and memory, and the stability suite.

use std::path::PathBuf;

use crate::cli::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::progress::reporter;
use crate::manifest::{self, convert::run_config};
use crate::report::study_page::{PAGE, write_study};
use crate::stages::ingest::ingest;
use crate::stages::stability::{StabilityCase, Verdict, run_stability};
use crate::stages::study::{StudyConfig, StudySpecimen, run_study};
use diffraction_brdf::error::Result;
use diffraction_render::scene::model::Scene;

/// Arguments of `study`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas study snakes.toml --specimen elaphe_guttata --out out/study")]
pub struct StudyArgs {
    /// What to study
    #[arg(default_value = super::MANIFEST)]
    pub manifest: PathBuf,
    /// Only these specimens; may be given several times
    #[arg(long, value_name = "NAME")]
    pub specimen: Vec<String>,
    /// More directions and settings: minutes per specimen instead of seconds
    #[arg(long)]
    pub thorough: bool,
    /// Folder for tables, plots, and JSON
    #[arg(long, value_name = "DIR", default_value = "out/study")]
    pub out: PathBuf,
}

/// Studies, runs the stability suite, and writes.
///
/// # Errors
/// A wrong manifest, a specimen it does not hold, or the disk's.
pub fn run(args: &StudyArgs, global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    if let Some(unknown) = args.specimen.iter().find(|name| manifest.specimens.iter().all(|s| s.name != **name)) {
        return Err(diffraction_brdf::error::Error::Call(format!(
            "{}: no specimen is called `{unknown}`",
            args.manifest.display()
        )));
    }
    let run = run_config(&manifest, &text);
    let progress = reporter(global.quiet);
    let mut failures = Vec::new();
    let mut specimens = Vec::new();
    for section in manifest.specimens.iter().filter(|s| args.specimen.is_empty() || args.specimen.contains(&s.name)) {
        match ingest(section) {
            Ok(ingested) => specimens.push(StudySpecimen {
                name: section.name.clone(),
                fields: ingested.fields,
                optics: section.optics.clone(),
                scenes: scenes_of(&run.scenes, &section.name),
            }),
            Err(error) => failures.push(format!("{}: {error}", section.name)),
        }
    }
    let config = if args.thorough { StudyConfig::thorough() } else { StudyConfig::quick() };
    let study = run_study(&specimens, &config, progress.as_ref());
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

/// The scenes that show a specimen.
fn scenes_of(scenes: &[Scene], specimen: &str) -> Vec<Scene> {
    scenes.iter().filter(|scene| scene.specimen.as_ref().is_none_or(|name| name == specimen)).cloned().collect()
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
