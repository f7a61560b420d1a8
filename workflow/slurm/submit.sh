#!/usr/bin/env bash
# A manifest's specimens on a Slurm cluster: an array of tasks, each making its part, and a job that publishes them once all have ended.
#
#   workflow/slurm/submit.sh MANIFEST TASKS [sbatch's own options, such as --partition=main --mem=4G --cpus-per-task=2]
#
# Wants the program in the path, or its place in DIFFRACTION_ATLAS, and a folder that all nodes share. A part takes only what is not there
# yet: submitting again after a failure goes on where it was. Choose TASKS so that one takes some minutes; `plan --json` predicts seconds
# and MiB of every specimen. The number of the job that publishes is printed.
set -euo pipefail
manifest=${1:?a manifest} tasks=${2:?a number of tasks}
shift 2
program=${DIFFRACTION_ATLAS:-diffraction-atlas}

# A task whose node is lost is queued again. It makes what is missing; what two of them make at once is the same, and the first stays.
array=$(sbatch --parsable --requeue --job-name=atlas-parts --array="1-$tasks" "$@" --wrap "
    exec '$program' run '$manifest' --shard --quiet --threads \${SLURM_CPUS_PER_TASK:-1}")
# Whether or not parts have failed: those that did are named, and keep their last good result.
sbatch --parsable --job-name=atlas-merge --dependency="afterany:$array" "$@" --wrap "exec '$program' merge '$manifest' --quiet"
