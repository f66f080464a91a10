#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run that has to fail: check_failure.py EXIT_CODE MESSAGE COMMAND..."""
import subprocess
import sys

code, message, *command = sys.argv[1:]
result = subprocess.run(command, capture_output=True, text=True)
output = result.stdout + result.stderr
print(output)
if result.returncode != int(code):
    sys.exit(f"exit code {result.returncode}, expected {code}")
if message not in output:
    sys.exit(f"no message \"{message}\"")
