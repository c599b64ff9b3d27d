#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs a program of the ParaView in a folder, with its own libraries and Python modules
# before the system's.
#
#   run-paraview.sh PREFIX [RANKS] PROGRAM [ARGUMENT...]     PREFIX/bin/PROGRAM
set -euo pipefail
prefix="$1"
shift
ranks=()
if [[ "$1" =~ ^[0-9]+$ ]]; then
  # as root in a container, more ranks than cores, waiting ranks leave the cores alone, and all are on
  # this machine: by its memory, without looking for a network between them
  ranks=(mpirun --allow-run-as-root --oversubscribe --mca mpi_yield_when_idle 1 --mca btl ^tcp -n "$1")
  shift
fi
program="$1"
shift
machine="$(uname -m)"
export LD_LIBRARY_PATH="$prefix/lib/$machine-linux-gnu${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export PYTHONPATH="$prefix/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"
export WIDEFOV_PARAVIEW_PREFIX="$prefix" # for scripts that start further programs
export PYTHONDONTWRITEBYTECODE=1
exec "${ranks[@]}" "$prefix/bin/$program" "$@"
