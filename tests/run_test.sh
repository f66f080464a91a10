#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Run one test in an empty folder of its own and compare what it printed with
# the reference, number by number.
#
#   run_test.sh DIRECTORY NUMDIFF REFERENCE COMMAND...
#
# Compared is the file `output` if the command writes one, else its standard
# output, which is moved to `output`. Standard error is shown on failure only.
set -u

directory=$1
numdiff=$2
reference=$3
shift 3

rm -rf "$directory"
mkdir -p "$directory"
cd "$directory" || exit 1

"$@" >stdout 2>stderr
status=$?
if [ $status -ne 0 ]; then
  echo "The command ended with exit code $status: $*"
  echo "--- last lines of standard output"
  tail -n 30 stdout
  echo "--- last lines of standard error"
  tail -n 30 stderr
  exit 1
fi
[ -f output ] || mv stdout output

if [ ! -s output ]; then
  echo "The test printed nothing: it could not fail."
  exit 1
fi
if [ ! -s "$reference" ]; then
  echo "There is no reference $reference"
  echo "Read $directory/output; if it is right, run"
  echo "  contrib/utilities/update_test_output $(basename "$(dirname "$directory")")/$(basename "$directory")"
  exit 1
fi

# The tolerances of deal.II's tests; a text that differs is an error too.
if "$numdiff" -a 1e-6 -r 1e-8 -s ' \t\n:<>=,;' -- "$reference" output >comparison 2>&1; then
  exit 0
fi
echo "The output differs from the reference:"
echo "  reference $reference"
echo "  output    $directory/output"
echo "--- first lines of the comparison (<: reference, >: output)"
head -n 30 comparison
exit 1
