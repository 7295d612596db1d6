# shellcheck shell=bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
#
# Functions that the batch files share; they source this file from the folder of
# the repository.

# complete_checkpoints OUTPUT: the complete checkpoints below OUTPUT, each on a
# line with its time of completion. A job that is killed while it writes a
# checkpoint leaves a folder without complete.json, from which no run can
# resume.
complete_checkpoints() {
  [ ! -d "$1" ] ||
    find "$1" -path '*/checkpoint/*/complete.json' -printf '%p %T@\n' | sort
}

# run_or_requeue OUTPUT COMMAND...: runs COMMAND with srun. A run that a signal
# stops after a checkpoint, as SLURM's does before the end of the time, ends with
# 128 and the number of the signal (SIGINT 130, SIGUSR1 138, SIGTERM 143): the
# job is queued again, unless there is no new checkpoint, since the next job
# would then get no further. Any other exit code is that of the job.
run_or_requeue() {
  local output=$1 before code=0
  shift
  before=$(complete_checkpoints "$output")
  srun "$@" || code=$?
  case $code in
    130 | 138 | 143) ;;
    *) exit "$code" ;;
  esac
  if [ "$(complete_checkpoints "$output")" = "$before" ]; then
    echo "stopped with exit code $code and no new checkpoint in $output:" \
      "not queued again; ask for more time (--time, --signal)" >&2
    exit "$code"
  fi
  scontrol requeue "${SLURM_JOB_ID:?}"
}
