"""Which functions of the engine a run enters, by a build that counts: a mistake in any other function can't change that run."""

import collections
import json
import os
import re
import subprocess
from pathlib import Path


class Counts:
    """What gcov says of the files of the engine, after a run or before any."""

    def __init__(self, build):
        folder = build.work / "counting"
        notes = [f"{name}.gcno" for name in build.running_units()]
        # Its exit code is that of an object without functions, if there is one.
        said = subprocess.run(["gcov", "--json-format", "--stdout", *notes], cwd=folder, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
        self.objects = collections.defaultdict(lambda: collections.defaultdict(set))  # that have code of a line, by file
        self.lines = collections.defaultdict(set)  # that were entered, by file
        self.functions = collections.defaultdict(set)  # (first line, last line, name), by file
        for line in said.splitlines():
            of_object = json.loads(line)
            name = Path(of_object["data_file"]).stem
            for source in of_object["files"]:
                path = Path(os.path.normpath(build.built / source["file"]))
                if path.is_relative_to(build.engine):
                    self.add(str(path.relative_to(build.engine)), source, name)

    def add(self, file, source, name):
        for line in source["lines"]:
            self.objects[file][line["line_number"]].add(name)
            if line["count"] > 0:
                self.lines[file].add(line["line_number"])
        for one in source["functions"]:
            self.functions[file].add((one["start_line"], one["end_line"], one["demangled_name"]))


def reset(build):
    for file in (build.work / "counting").glob("*.gcda"):
        file.unlink()


def innermost(counts, place):
    """(first line, last line, name) of the innermost function with the place, if there is one."""
    around = [one for one in counts.functions[place.file] if one[0] <= place.line <= one[1]]
    return min(around, key=lambda one: one[1] - one[0], default=None)


def name_around(counts, place):
    """The name of the function with the place, without its class; of a lambda, that of the function that has it."""
    found = innermost(counts, place)
    name = found and re.search(r"::(~?\w+|operator=)\(", found[2].replace("(anonymous namespace)::", ""))
    return name.group(1) if name else ""


def function_around(counts, build, place):
    """(first line, last line) of the function with the place; None where that does not tell whether the place has an
    effect: outside of functions, in what compilers evaluate, and in constructors, which initialise members too."""
    found = innermost(counts, place)
    if not found:
        return None
    first, last, name = found
    text = (build.engine / place.file).read_text().split("\n")
    if re.search(r"(\w+)::~?\1\(", name) or "constexpr" in " ".join(text[first - 2:first + 1]):
        return None
    return first, last


def objects_with(counts, function, place, users):
    """Those of the users in which the compiler left code of the function."""
    if not function:
        return users
    of_file = counts.objects[place.file]
    having = set().union(*(of_file[line] for line in of_file if function[0] <= line <= function[1]))
    return [name for name in users if name in having]


def enters(lines, function, place):
    """Whether a run that entered these lines, by file, may show a mistake at the place."""
    return not function or any(function[0] <= line <= function[1] for line in lines.get(place.file, []))
