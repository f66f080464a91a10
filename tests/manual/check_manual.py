#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manual (doc/) against the project.

    check_manual.py links              files and headings that pages link to; every
                                       page is in a table of contents
    check_manual.py equations          equations and sections of theory.md that
                                       comments and pages cite
    check_manual.py commands PROGRAM PAGE   the commands of a page
    check_manual.py book               Sphinx finds nothing to warn about

Commands are the lines that begin with "$ " in blocks ```console. They run in
order in an empty folder with links to the project's; the exit code must be 0, or
that of a comment "# exit code N". The lines below a command stand for its
output: each must occur there, its numbers within 3 %.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77  # of ctest's SKIP_RETURN_CODE
CONTENTS = ("doc/index.md", "doc/lessons/index.md", "doc/journal/index.md", "doc/scenes.md")
TOLERANCE = 0.03
NUMBER = re.compile(r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def pages():
    """The texts that doc/conf.py makes pages of."""
    found = [*(ROOT / "doc").rglob("*.md"), *(ROOT / "prm").rglob("README.md")]
    return sorted(found) + [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]


def name(file):
    return str(file.relative_to(ROOT))


def prose(text):
    """Text without blocks and spans of code; the number of lines stays."""
    text = re.sub(r"^```.*?^```", lambda block: "\n" * block.group(0).count("\n"), text,
                  flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(text):
    """The anchors that a git host makes of the headings."""
    found = []
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        heading = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
        found.append(slug + ("-%d" % found.count(slug) if slug in found else ""))
    return found


def check_links():
    failures = []
    listed = {"doc/index.md"}
    for page in pages():
        text = page.read_text(encoding="utf-8")
        for match in re.finditer(r"\]\(([^)\s]+)\)", prose(text)):
            target, _, anchor = match.group(1).partition("#")
            if re.match(r"[a-z]+:", target):
                continue
            place = "%s:%d" % (name(page), prose(text)[: match.start()].count("\n") + 1)
            file = (page.parent / target).resolve() if target else page
            if not file.is_file():
                failures.append("%s: there is no file %s" % (place, target))
            elif anchor and anchor not in anchors(file.read_text(encoding="utf-8")):
                failures.append("%s: no heading #%s in %s" % (place, anchor, target or "the page"))
        if name(page) in CONTENTS:
            for target in re.findall(r"^- \[[^]]+\]\(([^)#]+\.md)\)", text, re.M):
                listed.add(os.path.relpath((page.parent / target).resolve(), ROOT))
    failures += ["%s: in no table of contents (%s)" % (name(page), ", ".join(CONTENTS))
                 for page in pages() if name(page) not in listed]
    return failures


def check_equations():
    theory = (ROOT / "doc" / "theory.md").read_text(encoding="utf-8")
    defined = re.findall(r"^    .* \((\d+\.\d+[a-z]?)\)$", theory, re.M)
    sections = re.findall(r"^## (\d+)\.", theory, re.M)
    failures = []
    for section in sections:
        own = [number for number in defined if number.startswith(section + ".")]
        plain = [number for number in own if number[-1].isdigit()]
        if len(set(own)) < len(own) or plain != ["%s.%d" % (section, i + 1) for i in range(len(plain))]:
            failures.append("doc/theory.md: equations of section %s in disorder: %s" % (section, own))
    cited = 0
    files = [file for folder in ("include", "source", "contrib", "tests", "prm", "doc")
             for file in sorted((ROOT / folder).rglob("*"))
             if file.is_file() and file.suffix in (".h", ".cc", ".prm", ".md", ".py")
             and file.resolve() != pathlib.Path(__file__).resolve()]
    for file in files:
        # Comments are broken into lines.
        text = re.sub(r"\n[ \t]*(?:\*|///?|#)? ?", " ", file.read_text(encoding="utf-8"))
        for match in re.finditer(r"theory\.md\)?,? \(\d+\.\d+[a-z]?\)(?:(?:,| and| to) \(\d+\.\d+[a-z]?\))*", text):
            for number in re.findall(r"\((\d+\.\d+[a-z]?)\)", match.group(0)):
                cited += 1
                if number not in defined:
                    failures.append("%s: there is no equation (%s) in theory.md" % (name(file), number))
        for match in re.finditer(r"theory\.md\)?,? sections? (\d+)(?: and (\d+))?", text):
            for number in filter(None, match.groups()):
                if number not in sections:
                    failures.append("%s: there is no section %s in theory.md" % (name(file), number))
    if cited < 20:
        failures.append("only %d citations of equations were found" % cited)
    return failures


def commands(page):
    """Pairs (command, shown lines) of the page, in order."""
    found = []
    for block in re.findall(r"^```console\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S):
        for line in block.splitlines():
            if line.startswith("$ "):
                found.append((line[2:], []))
            elif line.strip():
                found[-1][1].append(line)
    return found


def agrees(shown, line):
    """Whether the words are the same and the numbers nearly."""
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", line).split():
        return False
    pairs = zip(map(float, NUMBER.findall(shown)), map(float, NUMBER.findall(line)))
    return all(abs(a - b) <= TOLERANCE * abs(a) for a, b in pairs)


def check_commands(program, page):
    failures = []
    page = ROOT / page
    listed = commands(page)
    if not listed:
        return ["%s has no commands" % name(page)]
    environment = {**os.environ, "PWD": ""}
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        for folder in ("contrib", "doc", "prm"):
            (scratch / folder).symlink_to(ROOT / folder)
        (scratch / "build").symlink_to(pathlib.Path(program).resolve().parent)
        for command, shown in listed:
            expected = re.search(r"\s+# exit code (\d)$", command)
            result = subprocess.run(["bash", "-c", command], cwd=scratch, env=environment,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                    stdin=subprocess.DEVNULL, text=True, errors="replace")
            code = int(expected.group(1)) if expected else 0
            if result.returncode != code:
                failures.append("%s: %s\n    exit code %d instead of %d\n%s" % (
                    name(page), command, result.returncode, code, result.stdout[-2000:]))
            for text in shown:
                if not any(agrees(text, line) for line in result.stdout.splitlines()):
                    failures.append("%s: %s\n    does not print: %s\n%s" % (
                        name(page), command, text, result.stdout[-500:]))
    print("%s: %d commands" % (name(page), len(listed)))
    return failures


def check_book():
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    modules = subprocess.run([python, "-c", "import sphinx, myst_parser, furo"],
                             capture_output=True, text=True)
    if modules.returncode != 0:
        print("skipped: the packages of contrib/packages_manual.txt are missing\n" + modules.stderr)
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as scratch:
        result = subprocess.run([str(ROOT / "contrib" / "manual"), "--output", scratch],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return [] if result.returncode == 0 else [result.stdout]


def main():
    checks = {"links": check_links, "equations": check_equations, "commands": check_commands,
              "book": check_book}
    if len(sys.argv) < 2 or sys.argv[1] not in checks:
        sys.exit(__doc__)
    failures = checks[sys.argv[1]](*sys.argv[2:])
    for failure in failures:
        print("FAILED: " + failure)
    print("%s: %s" % (" ".join(map(shlex.quote, sys.argv[1:2])), "failed" if failures else "passed"))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
