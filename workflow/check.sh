#!/usr/bin/env bash
# Whether the workflows give the atlas of one machine, byte for byte: a small generated collection through `run`, through Snakemake with an executor that
# starts every job as a process of its own, and through Slurm where `sbatch` answers. One scan is damaged in the second round: the others are published all
# the same.
#
#   workflow/check.sh PROGRAM [snakemake's place]
#
# Wants Snakemake 9 with snakemake-executor-plugin-cluster-generic, python3, and for Slurm nodes that see this machine's /tmp.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) program=$(realpath "${1:?the program}") snakemake=${2:-snakemake}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"

mkdir scans
for seed in 1 2 3 4 5 6 7; do
    "$program" --quiet synthesize gaussian-rough --rms-nm 40 --correlation-length-nm 600 --seed $seed --size 96 --pitch-nm 80 --out scans/scale_$seed.tif > /dev/null
done
cat > collection.toml <<'TOML'
schema = 1
atlas = { name = "collection", out = "out" }
gpu = { check = "off" }
report = { reference = false }
[optics]
coherence = { sigma_um = 1 }
material = { n = 1.56 }
[tables]
tolerance = 1e-2
size = 65
[[specimen]]
name = "{file}"
scans = "scans/*.tif"
TOML
manifest=collection.toml

# Digests of all files of the newest version that depend on inputs and program alone.
digests() {
    python3 - "$1" <<'PY'
import json, pathlib, sys
root = pathlib.Path(sys.argv[1])
index = json.loads((root / (root / "latest").read_text().strip() / "atlas.json").read_text())
timed = ("report.html", "report.json", "manifest.toml")
print("\n".join(f["path"] + " " + f["sha256"] for f in index["files"] if f["path"] not in timed and not f["path"].endswith("/result.json")))
PY
}
same() { diff <(digests alone/collection) <(digests out/collection) > /dev/null || { echo "FAILED: $1 gives another atlas" >&2; exit 1; }; }

"$program" --quiet run $manifest > /dev/null
mv out alone

through_snakemake() {
    "$snakemake" --quiet all --snakefile "$here/Snakefile" --executor cluster-generic --cluster-generic-submit-cmd bash --jobs 2 --latency-wait 10 \
        --config manifest=$manifest program="$program" packed=2 > snakemake.log 2>&1
}
through_snakemake || { cat snakemake.log; exit 1; }
same Snakemake
cp scans/scale_3.tif whole.tif && head -c 2000 whole.tif > scans/scale_3.tif
if through_snakemake; then echo "FAILED: Snakemake says nothing of a damaged scan" >&2; exit 1; fi
grep -q 'failed: scale_3 ' snakemake.log
[[ $(cat out/collection/latest) == v0002 ]]
grep -q '"stale": "scans/scale_3.tif' out/collection/v0002/atlas.json
cp whole.tif scans/scale_3.tif
echo "Snakemake: the atlas of one machine; a damaged scan keeps its last good result"

if command -v sbatch > /dev/null && sinfo -h > /dev/null 2>&1; then
    rm -rf out
    merge=$(DIFFRACTION_ATLAS=$program bash "$here/slurm/submit.sh" $manifest 4 --output=slurm-%j.log)
    for _ in $(seq 600); do
        squeue -h -j "$merge" 2> /dev/null | grep -q . || break
        sleep 1
    done
    [[ -f out/collection/latest ]] || { cat slurm-*.log; exit 1; }
    same Slurm
    echo "Slurm: the atlas of one machine"
fi
