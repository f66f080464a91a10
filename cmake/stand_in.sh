#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# stand_in.sh LIBRARY CALLER: the source in C of a library with the names that
# CALLER takes from LIBRARY, and nothing behind them: a function that is called
# all the same says so and ends the program.
set -e
export LC_ALL=C # sort and join must agree
names() {
  nm -D -P "$1" "$2" | sed 's/@[^ ]*//' | sort
}
wanted=$(mktemp)
trap 'rm -f "$wanted"' EXIT
names --undefined-only "$2" | awk '{ print $1 }' > "$wanted"
[ -s "$wanted" ]
cat << END
#include <stdio.h>
#include <stdlib.h>
static void stop(const char *name)
{
  fprintf(stderr, "%s of $(basename "$1") was called, which this program was linked "
          "without: configure it with -D SEICHE_LEAVE_OUT=\"\"\n", name);
  abort();
}
END
# POSIX format: name, type, address, size (hexadecimal)
names --defined-only "$1" | join - "$wanted" | awk '
  $2 ~ /[TWti]/ { printf "void %s(void) { stop(\"%s\"); }\n", $1, $1; next }
  { printf "char %s[0x%s] __attribute__((aligned(16)));\n", $1, $4 == "" ? 8 : $4 }'
