//! The program as it is called: help, exit statuses, and what goes to stdout and stderr.

use std::path::Path;

use assert_cmd::Command;

struct Called {
    status: i32,
    stdout: String,
    stderr: String,
}

fn call(folder: &Path, line: &str) -> Called {
    let output = Command::cargo_bin("diffraction-atlas")
        .unwrap()
        .current_dir(folder)
        .args(line.split_whitespace())
        .output()
        .unwrap();
    Called {
        status: output.status.code().expect("ended by itself"),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

/// Every file and folder below a folder, sorted.
fn tree(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        found.push(path.display().to_string());
        if path.is_dir() {
            found.extend(tree(&path));
        }
    }
    found.sort();
    found
}

/// The commands that the program's help names.
fn commands(folder: &Path) -> Vec<String> {
    let help = call(folder, "--help");
    assert_eq!((help.status, help.stderr.as_str()), (0, ""));
    assert!(help.stdout.contains("Exit status"), "{}", help.stdout);
    help.stdout
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| line.starts_with("  "))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .map(str::to_owned)
        .collect()
}

/// Those of them whose first argument is a manifest.
fn manifest_commands(folder: &Path) -> Vec<String> {
    let takes_manifest = |command: &String| call(folder, &format!("{command} --help")).stdout.contains("[MANIFEST]");
    let found: Vec<String> = commands(folder).into_iter().filter(takes_manifest).collect();
    assert!(["run", "plan"].iter().all(|name| found.iter().any(|command| command == name)), "{found:?}");
    found
}

#[test]
fn help_of_every_command_has_an_example() {
    let folder = tempfile::tempdir().unwrap();
    let commands = commands(folder.path());
    assert!(commands.iter().any(|command| command == "list"), "{commands:?}");
    for command in commands {
        let help = call(folder.path(), &format!("{command} --help"));
        assert_eq!(help.status, 0, "{command}");
        let example = format!("diffraction-atlas {command} ");
        let shown = help.stdout.lines().filter(|line| line.trim().starts_with(&example)).count();
        assert!(shown > 0, "{command} shows no example:\n{}", help.stdout);
    }
}

#[test]
fn the_version_is_that_of_the_package() {
    let folder = tempfile::tempdir().unwrap();
    let version = call(folder.path(), "--version");
    assert_eq!(version.status, 0);
    assert_eq!(version.stdout, format!("diffraction-atlas {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn wrong_calls_end_with_2_and_say_why_on_stderr() {
    let folder = tempfile::tempdir().unwrap();
    for (line, fragment) in [
        ("lisst", "'list'"),
        ("list --jsno", "'--json'"),
        ("list --threads 0", "1..=1024"),
        ("list --threads many", "many"),
        ("list nowhere", "nowhere"),
        ("list a b", "'b'"),
    ] {
        let called = call(folder.path(), line);
        assert_eq!((called.status, called.stdout.as_str()), (2, ""), "{line}");
        assert!(called.stderr.contains(fragment), "{line}: {}", called.stderr);
    }
    assert!(tree(folder.path()).is_empty());
}

#[test]
fn list_puts_results_on_stdout_and_remarks_on_stderr() {
    let folder = tempfile::tempdir().unwrap();
    let empty = call(folder.path(), "list .");
    assert_eq!((empty.status, empty.stdout.as_str()), (0, ""));
    assert!(empty.stderr.lines().count() == 1 && empty.stderr.contains("no atlas"), "{}", empty.stderr);
    let quiet = call(folder.path(), "--quiet list .");
    assert_eq!((quiet.status, quiet.stderr.as_str()), (0, ""));

    write(folder.path(), "snakes/v0001/atlas.json", "{}");
    write(folder.path(), "snakes/v0001/elaphe/specimen.json", "{}");
    write(folder.path(), "snakes/latest", "v0001\n");
    let text = call(folder.path(), "list .");
    for needed in ["snakes", "v0001", "latest", "4 B", "elaphe"] {
        assert!(text.stdout.contains(needed), "{needed} is missing in {}", text.stdout);
    }
    let json = call(folder.path(), "list . --json --threads 1");
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(value[0]["latest"], "v0001");
    assert_eq!(value[0]["versions"][0]["specimens"][0], "elaphe");
}

#[test]
fn a_wrong_manifest_ends_with_2_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let text = "schema = 1\n[atlas]\nname = \"snakes\"\n[tables]\nsize = 500\n";
    write(folder.path(), "wrong.toml", text);
    write(folder.path(), "pipeline.toml", text);
    let before = tree(folder.path());
    let mut calls: Vec<(String, &str)> = manifest_commands(folder.path())
        .into_iter()
        .flat_map(|command| [(format!("{command} wrong.toml"), "wrong.toml"), (command, "pipeline.toml")])
        .collect();
    // Called without a command the program runs pipeline.toml.
    calls.push((String::new(), "pipeline.toml"));
    for (line, file) in calls {
        let called = call(folder.path(), &line);
        assert_eq!((called.status, called.stdout.as_str()), (2, ""), "{line:?}: {}", called.stderr);
        let expected = format!("error: {file}:5:8: `tables.size` ");
        assert!(called.stderr.starts_with(&expected), "{line:?}: {}", called.stderr);
        assert!(called.stderr.contains(" 5 | size = 500\n   |        ^^^"), "{}", called.stderr);
        assert_eq!(tree(folder.path()), before, "{line:?} wrote something");
    }
}

#[test]
fn a_missing_manifest_ends_with_2() {
    let folder = tempfile::tempdir().unwrap();
    for command in manifest_commands(folder.path()) {
        let called = call(folder.path(), &format!("{command} none.toml"));
        assert_eq!((called.status, called.stdout.as_str()), (2, ""), "{command}");
        assert!(called.stderr.contains("none.toml"), "{}", called.stderr);
    }
}
