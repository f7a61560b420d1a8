//! Files and which of them use which: circles, and arrows up the floors.

use std::collections::{BTreeMap, BTreeSet};

/// One file uses another.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Arrow {
    /// Path of the file that uses.
    pub from: String,
    /// Path of the file that is used.
    pub to: String,
}

/// For every set of files that reach one another, their number and a shortest circle through the first, which also ends it.
pub fn circles(arrows: &[Arrow]) -> Vec<(usize, Vec<String>)> {
    let mut uses: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for Arrow { from, to } in arrows {
        uses.entry(from).or_default().insert(to);
    }
    let (mut found, mut told) = (Vec::new(), BTreeSet::<&str>::new());
    for &file in uses.keys() {
        if told.contains(file) {
            continue;
        }
        let Some(circle) = shortest_way(&uses, file, file) else { continue };
        // The rest of its set is not told again.
        let reached = |start: &str, end: &str| shortest_way(&uses, start, end).is_some();
        let all =
            uses.keys().copied().filter(|&other| reached(file, other) && reached(other, file)).collect::<Vec<_>>();
        told.extend(all.iter());
        found.push((all.len(), circle.into_iter().map(str::to_owned).collect()));
    }
    found
}

/// Files from `start` to `end` by as few arrows as possible, at least one.
fn shortest_way<'a>(uses: &BTreeMap<&'a str, BTreeSet<&'a str>>, start: &'a str, end: &str) -> Option<Vec<&'a str>> {
    let (mut ways, mut seen) = (vec![vec![start]], BTreeSet::new());
    while !ways.is_empty() {
        let mut longer = Vec::new();
        for way in ways {
            for &next in uses.get(way[way.len() - 1]).into_iter().flatten() {
                let to_next = || way.iter().copied().chain([next]).collect::<Vec<_>>();
                if next == end {
                    return Some(to_next());
                }
                if seen.insert(next) {
                    longer.push(to_next());
                }
            }
        }
        ways = longer;
    }
    None
}

/// Arrows of a crate that do not lead to a lower floor, and files on none; the crate's root is on none and may use all.
pub fn upward(arrows: &[Arrow], folder: &str, floors: &[&[&str]]) -> Vec<String> {
    let prefix = if folder.is_empty() { "src/".to_owned() } else { format!("{folder}/src/") };
    let room = |path: &str| -> Option<String> {
        let own = path.strip_prefix(&prefix)?;
        let name = own.split('/').next()?.trim_end_matches(".rs").to_owned();
        (name != "lib").then_some(name)
    };
    let floor = |room: &str| floors.iter().position(|names| names.contains(&room));
    let mut wrong = BTreeSet::new();
    for Arrow { from, to } in arrows {
        let (Some(own), Some(other)) = (room(from), room(to)) else { continue };
        match (floor(&own), floor(&other)) {
            (None, _) => wrong.insert(format!("{from} is on no floor")),
            (_, None) => wrong.insert(format!("{to} is on no floor")),
            (Some(low), Some(high)) => {
                own != other && high >= low && wrong.insert(format!("{from} uses {to}, which is no lower floor"))
            }
        };
    }
    wrong.into_iter().collect()
}
