#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run that has to end with an exit code: check_failure.py EXIT_CODE MESSAGE[|MESSAGE...]
COMMAND... --output FOLDER; the messages stand in this order in what it prints or in its run.log, one
that begins with ! nowhere; one that begins with + is a file of FOLDER; one that begins with $ stands
in the last line of all."""
import pathlib
import subprocess
import sys

code, messages, *command = sys.argv[1:]
result = subprocess.run(command, capture_output=True, text=True)
output = result.stdout + result.stderr
log = pathlib.Path(command[-1], "run.log")
if log.exists():
    output += log.read_text()
print(output)
if result.returncode != int(code):
    sys.exit(f"exit code {result.returncode}, expected {code}")
place = 0
for message in messages.split("|"):
    if message.startswith("!"):
        if message[1:] in output:
            sys.exit(f"message \"{message[1:]}\"")
        continue
    if message.startswith("$"):
        if message[1:] not in output.splitlines()[-1]:
            sys.exit(f"no \"{message[1:]}\" in the last line")
        continue
    if message.startswith("+"):
        if not pathlib.Path(command[-1], message[1:]).exists():
            sys.exit(f"no file {message[1:]}")
        continue
    place = output.find(message, place)
    if place < 0:
        sys.exit(f"no message \"{message}\" (in this place)")
