#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walks the commands of a page: every ```sh and ```python block, in order, in a
scratch folder that looks like the checkout. Fails if one fails.

    manual_commands.py WAKER SOURCE_DIRECTORY PAGE.md [...]
    manual_commands.py WAKER SOURCE_DIRECTORY --links     what pages point at
    manual_commands.py --self-test

A comment before a block changes how it is walked; readers do not see it:

    <!-- walk: words -->

| --set "A/B=c"  | is added to each `waker run`, `campaign`, `strength-reduction`
| NAME=value     | a placeholder of the block is replaced
| needs PROGRAM  | the block is left out where there is no such program
| without START  | lines that begin so are left out (a comma separates several)
| not REASON     | the block is not walked

Where a page has tables of summary.json and of the columns of statistics, they are
compared with what its own run has written.
"""

import glob
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:<!-- walk: (?P<walk>(?:(?!-->).)*?) -->\n)?"
                   r"```(?P<language>sh|python)\n(?P<text>.*?)```", re.DOTALL)


class Block:
    def __init__(self, match):
        self.language, self.text = match["language"], match["text"]
        self.settings, self.needs, self.reason = [], [], ""
        walk = " ".join((match["walk"] or "").split())
        if walk.startswith("not "):
            self.reason = walk[4:]
            return
        if " without " in " " + walk:
            walk, _, starts = (" " + walk).partition(" without ")
            self.leave_out([start.strip() for start in starts.split(",")])
        words = shlex.split(walk)
        while words:
            word = words.pop(0)
            if word == "--set":
                self.settings += [word, words.pop(0)]
            elif word == "needs":
                self.needs.append(words.pop(0))
            elif re.match(r"[A-Z]+=", word):
                name, value = word.split("=", 1)
                changed = re.sub(rf"\b{name}\b", value, self.text)
                if changed == self.text:
                    sys.exit(f"no {name} in the block:\n{self.text}")
                self.text = changed
            else:
                sys.exit(f"'{word}' is no word of a walk; see {__file__}")

    def leave_out(self, starts):
        lines = self.text.split("\n")
        for start in starts:
            if not any(line.startswith(start) for line in lines):
                sys.exit(f"no line begins with '{start}':\n{self.text}")
        self.text = "\n".join(line for line in lines if not any(
            line.startswith(start) for start in starts))


def blocks_of(text):
    return [Block(match) for match in BLOCK.finditer(text)]


def make_scratch(folder, waker, source):
    """Links to what the commands use; `waker` adds settings."""
    for name in ("parameters", "contrib", "doc", "tests", "CMakeLists.txt"):
        os.symlink(os.path.join(source, name), os.path.join(folder, name))
    programs = os.path.join(folder, "build", "bin")
    os.makedirs(programs)
    for name in os.listdir(os.path.dirname(waker)):
        if name != "waker":
            os.symlink(os.path.join(os.path.dirname(waker), name),
                       os.path.join(programs, name))
    wrapper = os.path.join(programs, "waker")
    with open(wrapper, "w", encoding="utf-8") as file:
        file.write(
            "#!/bin/bash\ncase \"${1:-}\" in\n"
            "run|campaign|strength-reduction)\n"
            "  eval \"more=($WALK_SETTINGS)\"\n"
            f"  exec {shlex.quote(waker)} \"$@\" \"${{more[@]}}\" ;;\n"
            f"*) exec {shlex.quote(waker)} \"$@\" ;;\nesac\n")
    os.chmod(wrapper, 0o755)
    return programs


def documented(text, folder):
    """What the page's tables of summary.json and statistics say, and what the
    run that the page makes has written: differences in words."""
    found, wrong = re.search(r"### summary.json\n(.*?)\n##", text, re.DOTALL), []
    runs = glob.glob(os.path.join(folder, "*", "summary.json"))
    if not found or not runs:
        return wrong
    run = os.path.dirname(sorted(runs)[0])
    cells = [line.split("|")[1] for line in found[1].split("\n")
             if line.startswith("| `")]
    keys = {key for cell in cells for key in re.findall(r"`(\w+)`", cell)}
    with open(os.path.join(run, "summary.json"), encoding="utf-8") as file:
        written = set(json.load(file))
    wrong += [f"summary.json has no {key}" for key in sorted(keys - written)]
    wrong += [f"{key} of summary.json is not in the page"
              for key in sorted(written - keys)]
    with open(os.path.join(run, "statistics"), encoding="utf-8") as file:
        columns = dict(re.findall(r"^# (\d+): (\w+)", file.read(), re.M))
    table = text[text.index("### statistics"):]
    rows = [line.split("|")[1] for line in table.split("\n")
            if re.match(r"\| \d+ ", line)]
    named = dict(pair for row in rows
                 for pair in re.findall(r"(?:^|, ) ?(\d+) (\w+)", row))
    wrong += [f"column {number} of statistics is {columns.get(number)}, in the "
              f"page {named.get(number)}"
              for number in sorted(set(columns) | set(named), key=int)
              if columns.get(number) != named.get(number)]
    return wrong


def walk(page, waker, source):
    """Number of blocks that failed."""
    with open(page, encoding="utf-8") as file:
        text = file.read()
    blocks = blocks_of(text)
    name = os.path.relpath(page, source)
    if not blocks:
        print(f"FAIL {name}: no block; is this the page?")
        return 1
    failed = 0
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        programs = make_scratch(folder, waker, source)
        environment = dict(
            os.environ, PATH=programs + os.pathsep + os.environ["PATH"],
            OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
            OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
            OMPI_MCA_rmaps_base_oversubscribe="1")
        for block in blocks:
            title = block.text.strip().split("\n")[0]
            missing = [program for program in block.needs
                       if not shutil.which(program)]
            if block.reason or missing:
                print(f"     {name}: left out: {title} "
                      f"({block.reason or 'no ' + ', '.join(missing)})")
                continue
            command = (["bash", "-euo", "pipefail", "-c", block.text]
                       if block.language == "sh"
                       else ["/usr/bin/python3", "-c", block.text])
            done = subprocess.run(
                command, cwd=folder, text=True, check=False,
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env={**environment, "WALK_SETTINGS": " ".join(
                    shlex.quote(word) for word in block.settings)})
            good = done.returncode == 0
            failed += not good
            print(f"{'ok  ' if good else 'FAIL'} {name}: {title}", flush=True)
            if not good:
                print(f"{block.text}\nended with {done.returncode}:\n"
                      f"{done.stdout[-3000:]}")
        for what in documented(text, folder):
            failed += 1
            print(f"FAIL {name}: {what}")
    return failed


def pages_of(source):
    return sorted(
        path for pattern in ("*.md", "doc/*.md", "doc/*/*.md", "doc/*/*/*.md",
                             "contrib/*/*.md")
        for path in glob.glob(os.path.join(source, pattern)))


def dead_links(source):
    """What pages point at and is not there: links, and paths in backticks."""
    found = []
    for page in pages_of(source):
        with open(page, encoding="utf-8") as file:
            text = file.read()
        name, here = os.path.relpath(page, source), os.path.dirname(page)
        for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
            if not target.startswith(("http:", "https:", "mailto:")):
                if not os.path.exists(os.path.join(here, target)):
                    found.append(f"{name}: link to {target}")
        for target in re.findall(
                r"(?<![\w/-])((?:contrib|parameters|tests|source|doc|include/"
                r"waker|benchmarks)/[\w./-]*\w)", text):
            # what stands for several, or is the reader's, is not looked for
            if (re.search(re.escape(target) + r"[*{<]", text)
                    or "my_" in target):
                continue
            if not any(os.path.exists(os.path.join(base, target)) for base in
                       (source, here, os.path.join(source, "include/waker"))):
                found.append(f"{name}: path {target}")
    return found


def wrong_parameters(waker, source):
    """Names in backticks that look like a parameter of a section that there
    is, and are none."""
    done = subprocess.run([waker, "parameters", "--format", "markdown"],
                          text=True, stdout=subprocess.PIPE, check=True)
    table, section = {}, ""
    for line in done.stdout.split("\n"):
        if line.startswith("#"):
            section = line.lstrip("# ").strip("`").split("/")[0].strip()
        match = re.match(r"\| *`?([^`|]+?)`? *\|", line)
        if match and section:
            table.setdefault(section, set()).add(match[1])
    found = []
    for page in pages_of(source):
        if page.endswith(("parameters.md", "changelog.md")):
            continue
        with open(page, encoding="utf-8") as file:
            text = file.read()
        for path in re.findall(r"`([A-Z][\w ]+/[^`]+)`", text):
            parts = " ".join(path.split("=")[0].split()).split("/")
            if parts[0] in table and parts[-1] not in table[parts[0]]:
                found.append(f"{os.path.relpath(page, source)}: {path}")
    return len(table), found


def self_test():
    """It sees what it is there to see."""
    text = ("<!-- walk: FILE=a.prm --set \"A/B c=1\" without rm, cd -->\n"
            "```sh\nwaker run FILE\nrm x\ncd y\n```\n```\nnot this\n```\n"
            "<!-- walk: not enough time -->\n```python\nprint(1)\n```\n")
    first, second = blocks_of(text)
    assert first.text == "waker run a.prm\n", first.text
    assert first.settings == ["--set", "A/B c=1"]
    assert second.reason == "enough time"
    with tempfile.TemporaryDirectory() as folder:
        for name in ("contrib", "parameters", "doc", "tests", "bin"):
            os.mkdir(os.path.join(folder, name))
        page = os.path.join(folder, "doc", "page.md")
        waker = os.path.join(folder, "bin", "waker")
        with open(waker, "w", encoding="utf-8") as file:
            file.write("#!/bin/bash\necho \"$@\" >>\"$LOG\"\n"
                       "[ \"$1\" != bad ]\n")
        os.chmod(waker, 0o755)
        os.environ["LOG"] = os.path.join(folder, "log")
        with open(page, "w", encoding="utf-8") as file:
            file.write("<!-- walk: --set \"A/B c=1 2\" -->\n"
                       "```sh\nwaker run x\nbuild/bin/waker status y\n```\n"
                       "```sh\nwaker bad\necho not here >&2\n```\n"
                       "[gone](nothing.md) `contrib/no/such.py`\n")
        assert walk(page, waker, folder) == 1
        with open(os.environ["LOG"], encoding="utf-8") as file:
            assert file.read() == "run x --set A/B c=1 2\nstatus y\nbad\n"
        assert dead_links(folder) == [
            "doc/page.md: link to nothing.md",
            "doc/page.md: path contrib/no/such.py"], dead_links(folder)


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    waker, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    if sys.argv[3] == "--links":
        found = dead_links(source)
        n_sections, wrong = wrong_parameters(waker, source)
        if n_sections < 20:
            sys.exit(f"only {n_sections} sections of parameters were read")
        print("\n".join(found + wrong)
              or f"{len(pages_of(source))} pages: all is there")
        sys.exit(1 if found or wrong else 0)
    failed = sum(walk(os.path.join(source, page), waker, source)
                 for page in sys.argv[3:])
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
