//! Which channel of a file is the height: by its unit, by its name, or because the caller says so.

use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::RawScan;

/// One image of a file with several.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Channel {
    /// Its number in the file, which `page` counts.
    pub(super) page: usize,
    pub(super) name: String,
    /// Whether its numbers are lengths; `None` where the file does not say.
    pub(super) is_length: Option<bool>,
}

/// What a channel's name tells of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Named {
    /// A height: 0 measured, 1 by a sensor, 2 from the drive or without saying.
    Height(u8),
    /// Something else, such as the amplitude.
    Other,
    /// Nothing.
    Unknown,
}

/// Words of names that are no heights, and of names that are.
const OTHERS: [&str; 23] = [
    "amplitude",
    "phase",
    "deflection",
    "error",
    "friction",
    "lateral",
    "current",
    "potential",
    "adhesion",
    "modulus",
    "stiffness",
    "dissipation",
    "deformation",
    "indentation",
    "intensity",
    "frequency",
    "capacitance",
    "mask",
    "temperature",
    "force",
    "luminance",
    "brightness",
    "voltage",
];
const HEIGHTS: [&str; 11] = [
    "height",
    "topo",
    "z-axis",
    "z axis",
    "zaxis",
    "zsensor",
    "z sensor",
    "z-sensor",
    "z detector",
    "z drive",
    "elevation",
];

/// Judges a channel by its name. A name with words of both kinds ("phase-shift topography") tells nothing.
pub(super) fn named(name: &str) -> Named {
    let name = name.to_lowercase();
    let has = |words: &[&str]| words.iter().any(|word| name.contains(word));
    let is_height = has(&HEIGHTS) || matches!(name.trim(), "z" | "h");
    match (is_height, has(&OTHERS)) {
        (true, false) if name.contains("measured") => Named::Height(0),
        (true, false) if has(&["sensor", "detector"]) => Named::Height(1),
        (true, false) => Named::Height(2),
        (false, true) => Named::Other,
        _ => Named::Unknown,
    }
}

/// Whether a name says that the scanner moved back.
fn is_backward(name: &str) -> bool {
    let name = name.to_lowercase();
    ["retrace", "backward", "bwd"].iter().any(|word| name.contains(word))
}

impl Channel {
    /// Place in the order of preference, forward before backward; `None` for what is not a height.
    fn rank(&self) -> Option<(u8, bool)> {
        let place = match (named(&self.name), self.is_length) {
            (Named::Height(place), Some(true) | None) => place,
            (Named::Unknown, Some(true)) => 3,
            _ => return None,
        };
        Some((place, is_backward(&self.name)))
    }
}

/// Which of `channels` is read, as its place in the list, and what is worth saying about it. Without the caller's word it is the one
/// height, or the best of several kinds: measured before sensor before drive, forward before backward.
///
/// # Errors
/// No channel or several fit; the names are listed.
pub(super) fn choose(channels: &[Channel], config: &ReadConfig) -> Parsed<(usize, Option<String>)> {
    if let Some(place) = asked(channels, config)? {
        return Ok((place, None));
    }
    let Some(best) = channels.iter().filter_map(Channel::rank).min() else {
        return Err(Refusal::new(
            format!("no channel of this file is a height ({})", list(channels)),
            "export the height channel; or name the channel that is one after all: ".to_owned()
                + &suggest(channels, config),
        ));
    };
    let all: Vec<usize> = (0..channels.len()).filter(|&place| channels[place].rank() == Some(best)).collect();
    let [only] = all[..] else {
        return Err(Refusal::new(
            format!("the file has several channels that may be the height ({})", list(channels)),
            format!("say which one: {}", suggest(&channels[all[0]..], config)),
        ));
    };
    // One of each other kind, the way there if there is one.
    let of_kind = |kind: u8| {
        let fits = channels.iter().filter(|channel| channel.rank().is_some_and(|rank| rank.0 == kind));
        fits.min_by_key(|channel| channel.rank())
    };
    let others = (best.0 + 1..3).filter_map(of_kind);
    let names: Vec<_> = others.map(|channel| format!("{:?}", channel.name)).collect();
    let remark = (!names.is_empty()).then(|| {
        format!(
            "channel {:?} is read; {} would be a height too ({} chooses)",
            channels[only].name,
            names.join(", "),
            config.words.channel.replace("{}", "NAME")
        )
    });
    Ok((only, remark))
}

/// The channel that the caller names or numbers.
fn asked(channels: &[Channel], config: &ReadConfig) -> Parsed<Option<usize>> {
    let by_page = match config.page {
        None => None,
        Some(page) => {
            let place = channels.iter().position(|channel| channel.page == page);
            Some(place.ok_or_else(|| {
                Refusal::new(
                    format!("page {page} holds no channel, counted from 0 ({})", list(channels)),
                    format!("set {} to one of these, or leave it out", config.words.page.replace("{}", "N")),
                )
            })?)
        }
    };
    let Some(name) = &config.channel else { return Ok(by_page) };
    let wanted = name.trim().to_lowercase();
    let plain = |channel: &Channel| channel.name.trim().to_lowercase();
    let fits: [&dyn Fn(&Channel) -> bool; 2] =
        [&|channel| plain(channel) == wanted, &|channel| plain(channel).contains(&wanted)];
    for fit in fits {
        let fitting: Vec<usize> = (0..channels.len()).filter(|&place| fit(&channels[place])).collect();
        let forward: Vec<usize> =
            fitting.iter().copied().filter(|&place| !is_backward(&channels[place].name)).collect();
        let place = match (&fitting[..], &forward[..], by_page) {
            ([], ..) => continue,
            (_, _, Some(page)) if fitting.contains(&page) => page,
            ([only], _, None) | (_, [only], None) => *only,
            (_, _, Some(page)) => {
                return Err(Refusal::new(
                    format!("page {} is channel {:?}, not {name:?}", channels[page].page, channels[page].name),
                    "name the page or the channel, not both",
                ));
            }
            _ => {
                return Err(Refusal::new(
                    format!("several channels fit the name {name:?} ({})", list(channels)),
                    format!(
                        "say which one by its number: {}",
                        config.words.page.replace("{}", &channels[fitting[0]].page.to_string())
                    ),
                ));
            }
        };
        return Ok(Some(place));
    }
    Err(Refusal::new(
        format!("no channel is named {name:?} ({})", list(channels)),
        format!("name one of these, or leave {} out", config.words.channel.replace("{}", "NAME")),
    ))
}

/// The channels with their numbers, for messages; of very many, heights first.
pub(super) fn list(channels: &[Channel]) -> String {
    const SHOWN: usize = 20;
    let mut order: Vec<&Channel> = channels.iter().collect();
    if channels.len() > SHOWN {
        order.sort_by_key(|channel| channel.rank().is_none());
    }
    let mut lines: Vec<String> = order
        .into_iter()
        .take(SHOWN)
        .map(|channel| match channel.name.as_str() {
            "" => format!("page {}: no name", channel.page),
            name => format!("page {}: {name}", channel.page),
        })
        .collect();
    if channels.len() > SHOWN {
        lines.push(format!("... {} in all", channels.len()));
    }
    lines.join("; ")
}

/// How to ask for the best of `channels`: the first whose name does not speak against it.
pub(super) fn suggest(channels: &[Channel], config: &ReadConfig) -> String {
    let by_rank = |channel: &&Channel| (channel.rank().is_none(), channel.rank(), named(&channel.name) == Named::Other);
    let Some(best) = channels.iter().min_by_key(by_rank) else {
        return config.words.page.replace("{}", "N");
    };
    let is_unique = channels.iter().filter(|other| other.name == best.name).count() == 1;
    if is_unique && !best.name.is_empty() {
        config.words.channel.replace("{}", &best.name)
    } else {
        config.words.page.replace("{}", &best.page.to_string())
    }
}

/// Refuses the only channel of a file whose name says that it is no height, unless the caller asked for it or says what its numbers mean.
pub(super) fn check_name(raw: &RawScan, config: &ReadConfig) -> Parsed<()> {
    let Some(name) = raw.channel.as_deref().filter(|name| named(name) == Named::Other) else { return Ok(()) };
    if config.page.is_some() || config.channel.is_some() || config.height.is_some() {
        return Ok(());
    }
    Err(Refusal::new(
        format!("its channel is {name:?}, not a height"),
        format!(
            "export the height or topography channel; or, if this one is a height after all, ask for it: {}",
            config.words.channel.replace("{}", name)
        ),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn channels(names: &[(&str, Option<bool>)]) -> Vec<Channel> {
        let one = |(page, &(name, is_length)): (usize, &(&str, _))| Channel { page, name: name.to_owned(), is_length };
        names.iter().enumerate().map(one).collect()
    }

    fn chosen(names: &[(&str, Option<bool>)], config: &ReadConfig) -> Parsed<usize> {
        choose(&channels(names), config).map(|(place, _)| place)
    }

    #[test]
    fn names_of_many_instruments() {
        for name in ["measuredHeight (trace)", "Measured Height"] {
            assert_eq!(named(name), Named::Height(0), "{name}");
        }
        for name in ["Height Sensor", "ZSensorRetrace", "Z-Axis Sensor", "capacitiveSensorHeight", "Z Detector"] {
            assert_eq!(named(name), Named::Height(1), "{name}");
        }
        for name in ["Height", "HeightTrace", "Topography", "TOPO", "Z-Axis", "Z Height", "height", "Z Drive", "Z"] {
            assert_eq!(named(name), Named::Height(2), "{name}");
        }
        for name in ["AmplitudeRetrace", "Phase", "vDeflection", "Peak Force Error", "Friction force", "Adhesion"] {
            assert_eq!(named(name), Named::Other, "{name}");
        }
        for name in ["", "Channel 1", "Phase-shift topography", "Detail"] {
            assert_eq!(named(name), Named::Unknown, "{name}");
        }
    }

    #[test]
    fn the_one_height_is_chosen_and_others_are_told_of() {
        let plain = ReadConfig::default();
        let asylum = [
            ("HeightRetrace", Some(true)),
            ("AmplitudeRetrace", Some(true)),
            ("PhaseRetrace", Some(false)),
            ("ZSensorRetrace", Some(true)),
        ];
        let (place, remark) = choose(&channels(&asylum), &plain).unwrap();
        assert_eq!(place, 3);
        assert!(remark.unwrap().contains("\"HeightRetrace\""));
        assert_eq!(choose(&channels(&asylum[..3]), &plain).unwrap(), (0, None));
        // Forward before backward, without a word: every file has both.
        let both = [("Z-Axis (backward)", Some(true)), ("Z-Axis (forward)", Some(true)), ("Phase", Some(false))];
        assert_eq!(choose(&channels(&both), &plain).unwrap(), (1, None));
        // The unit counts where the name tells nothing, and against a name.
        assert_eq!(chosen(&[("Height", Some(false)), ("Data 1", Some(true))], &plain), Ok(1));
    }

    #[test]
    fn what_is_not_clear_is_listed() {
        let plain = ReadConfig::default();
        let refusal = chosen(&[("Detail", Some(true)), ("Rest", Some(true))], &plain).unwrap_err();
        assert!(refusal.what.contains("page 0: Detail; page 1: Rest"), "{}", refusal.what);
        assert!(refusal.fix.contains("channel = \"Detail\""), "{}", refusal.fix);
        let refusal = chosen(&[("Height", Some(true)), ("Height", Some(true))], &plain).unwrap_err();
        assert!(refusal.fix.contains("page = 0"), "{}", refusal.fix);
        let refusal = chosen(&[("Intensity", None), ("Data", None)], &plain).unwrap_err();
        assert!(refusal.what.contains("no channel") && refusal.fix.contains("\"Data\""), "{refusal:?}");
        assert!(chosen(&[], &plain).is_err());
    }

    #[test]
    fn the_caller_chooses_by_name_and_number() {
        let of = |page: Option<usize>, channel: Option<&str>| ReadConfig {
            page,
            channel: channel.map(str::to_owned),
            ..ReadConfig::default()
        };
        let names = [("Height (trace)", Some(true)), ("Height (retrace)", Some(true)), ("Phase (trace)", Some(false))];
        assert_eq!(chosen(&names, &of(Some(1), None)), Ok(1));
        assert_eq!(chosen(&names, &of(None, Some(" phase (TRACE) "))), Ok(2));
        assert_eq!(chosen(&names, &of(None, Some("height"))), Ok(0));
        assert_eq!(chosen(&names, &of(None, Some("retrace"))), Ok(1));
        assert_eq!(chosen(&names, &of(Some(1), Some("height"))), Ok(1));
        for (page, name, words) in [
            (Some(3), None, "page 3 holds no channel"),
            (None, Some("Amplitude"), "no channel is named \"Amplitude\""),
            (None, Some("(trace)"), "several channels fit"),
            (Some(2), Some("Height"), "page 2 is channel"),
        ] {
            let refusal = chosen(&names, &of(page, name)).unwrap_err();
            assert!(refusal.what.contains(words) && !refusal.fix.is_empty(), "{refusal:?}");
        }
    }
}
