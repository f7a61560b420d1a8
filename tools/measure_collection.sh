#!/usr/bin/env bash
# What a collection costs on this machine: small generated scans, run from nothing, run again, with one scan added, and the overview opened.
#
#   tools/measure_collection.sh FOLDER COUNT [the program's place] [slight]
#
# Slight specimens are of 48 samples a side, under one line of a laser, hold what one small picture asks for, and no errors are measured: they take a
# twentieth of the time, and show what grows with the number.
# Writes into FOLDER/COUNT, which is removed first, and prints a line of figures for each step: elapsed seconds, the share of all cores that was
# used, and the most memory that the process held. Wants GNU time; for the last step Chromium. docs/scale.md tells what came out.
set -euo pipefail
folder=${1:?a folder} count=${2:?a number of scans} program=$(realpath "${3:-target/release/diffraction-atlas}") kind=${4:-whole}
samples=128
[ "$kind" = whole ] || samples=48
cores=$(nproc)
rm -rf "${folder:?}/$count" && mkdir -p "$folder/$count/scans" && cd "$folder/$count"

scan() {
    "$program" --quiet synthesize gaussian-rough --rms-nm 40 --correlation-length-nm 600 --seed "$1" --size "$samples" --pitch-nm 80 \
        --out "scans/scale_$(printf %05d "$1").tif" > /dev/null
}
for seed in $(seq "$count"); do scan "$seed"; done
cat > collection.toml <<'TOML'
schema = 1
scene = []
[atlas]
name = "collection"
out = "out"
[optics]
material = { n = 1.56 }
coherence = { sigma_um = 2.5 }
[tables]
tolerance = 1e-2
[[specimen]]
name = "{file}"
scans = "scans/*.tif"
[gpu]
check = "off"
TOML
if [ "$kind" = slight ]; then
    sed -i '/^scene = /d; s/^tolerance.*/&\nserve = "scenes"\nsize = 33/; s/^coherence.*/coherence = { sigma_um = 0.8 }\nilluminant = { lines_nm = [532] }/' collection.toml
    printf '[report]\nreference = false\n[[scene]]\nname = "map"\nshape = "hemisphere"\nlight = { direction = [0, 0, 1] }\nsize_px = 16\n' >> collection.toml
fi

# Runs the manifest, and says what it took.
run() {
    env time --format '%e %U %S %M' --output times "$program" --quiet run collection.toml > said
    read -r wall user system kib < times
    awk -v what="$1" -v wall="$wall" -v busy="$(echo "$user $system" | awk '{ print $1 + $2 }')" -v kib="$kib" -v cores="$cores" \
        'BEGIN { printf "%-28s %8.1f s, %3.0f %% of %d cores, %6.0f MiB\n", what, wall, 100 * busy / (wall * cores), cores, kib / 1024 }'
    head -1 said
}
echo "$count scans"
run "from nothing"
run "nothing changed"
scan 99999
run "one scan added"
newest=out/collection/$(cat out/collection/latest)
du -sh --apparent-size "$newest" | awk '{ print "a version: " $1 }'
find "$newest" -type f | wc -l | awk '{ print "files: " $1 }'
ls -l "$newest/report.html" "$newest/report.json" "$newest/atlas.json" | awk '{ print $9 ": " $5 " bytes" }'
if chromium=$(command -v chromium); then
    # Loaded and laid out, its pictures included; what the browser takes to start without a page is told beside it.
    for page in about:blank "$newest/report.html"; do
        started=$(date +%s.%N)
        "$chromium" --headless --no-sandbox --disable-gpu --dump-dom "$page" > /dev/null 2>&1
        echo "$started $(date +%s.%N) $page" | awk '{ printf "opening %s: %.1f s\n", $3, $2 - $1 }'
    done
fi
