# `just` lists what there is to do; each line is also a command to type without it (https://just.systems).

# What there is to do.
default:
    @just --list --unsorted

# The bundled atlas: out/atlas/bundled/v0001/report.html.
atlas:
    cargo run --release

# The tests of every day, three minutes.
test *ARGS:
    cargo test --release {{ARGS}}

# Slow tests too, in a part of the code or everywhere; nothing may be skipped.
test-all *ARGS:
    REQUIRE_ALL=1 cargo test --release --workspace {{ARGS}} -- --include-ignored --skip measuring

# Formatting, lints and documentation, without a warning.
lint:
    cargo fmt --all --check
    cargo clippy --release --workspace --all-targets -- -D warnings
    RUSTDOCFLAGS=-Dwarnings cargo doc --workspace --no-deps --release

# The page of `view`, built anew and held to the program in a browser; wants npm and Chromium.
viewer:
    npm ci --prefix viewer
    npm run --prefix viewer build
    npm test --prefix viewer
    cargo run --release -- run viewer/tests/pictures.toml
    node --test viewer/tests/page.test.mjs
    node --test viewer/tests/report.test.mjs

# Licences, banned crates and sources of what is depended upon.
deny:
    cargo deny check licenses bans sources

# The solver of Maxwell's equations that says where the model ends, against its stored cases.
rigorous:
    python3 tests/rigorous/check.py

# Times of building and looking up.
bench:
    cargo bench

# Everything that a change has to pass.
ci:
    .ci/run
