"""A copy of the engine whose sources are compiled one by one and linked with the objects of an existing build."""

import hashlib
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OBJECTS = "impulse_double_objects"  # scenarios run in double precision
LEVEL = "-O1"  # of optimisation: compiles in half of the time of -O2
# Early inlining precedes counting, so that a function would be counted where it is called.
COUNTING = ["--coverage", "-fno-early-inlining"]


def fail(text):
    sys.exit(f"score.py: {text}")


def digest(paths):
    whole = hashlib.sha256()
    for path in paths:
        whole.update(path.read_bytes())
    return whole.hexdigest()[:16]


def kernels_here():
    """The instruction sets that the engine chooses on this processor: the widest, and AVX2 for what gathers more than it
    computes. See engine/src/core/instruction_set.cpp and engine/src/contacts/contact_kernels.cpp."""
    try:
        flags = set(re.search(r"^flags\s*:(.*)$", Path("/proc/cpuinfo").read_text(), re.M).group(1).split())
    except AttributeError:
        return {"baseline"}
    if {"avx512f", "avx512dq", "avx512vl", "avx512bw"} <= flags:
        return {"avx512", "avx2"}
    return {"avx2"} if "avx2" in flags else {"baseline"}


class Build:
    def __init__(self, built, work):
        self.built, self.work = built, work
        self.engine = work / "engine"
        commands = subprocess.run(["ninja", "-C", built, "-t", "commands", "plumb"], check=True, text=True,
                                  stdout=subprocess.PIPE).stdout.splitlines()
        ours = [line for line in commands if f"/{OBJECTS}.dir/" in line and " -c " in line]
        if not ours:
            fail(f"{built} does not build {OBJECTS}")
        self.link_command = next(line for line in reversed(commands) if re.search(r" -o \S*reports/plumb ", line))
        self.kernels = {re.search(r"kernels_(\w+)\.cpp$", line).group(1): line for line in ours if "kernels_" in line}
        self.plain = next(line for line in ours if "kernels_" not in line)
        self.update_copy()

    def update_copy(self):
        source = ROOT / "engine"
        files = sorted(path for path in source.rglob("*") if path.suffix in (".cpp", ".h"))
        self.base = digest(files)
        stamp = self.work / "engine.sha"
        if stamp.exists() and stamp.read_text() == self.base:
            for path in files:  # undoes a mutant that was interrupted
                copy = self.engine / path.relative_to(source)
                if copy.read_bytes() != path.read_bytes():
                    shutil.copyfile(path, copy)
            return
        for folder in (self.engine, self.work / "objects", self.work / "counting"):
            shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source, self.engine)
        (self.work / "objects").mkdir()
        (self.work / "counting").mkdir()
        stamp.write_text(self.base)

    def units(self):
        """Object name: its compile command without output."""
        all_units = {}
        for source in sorted((self.engine / "src").rglob("*.cpp")):
            name = str(source.relative_to(self.engine / "src"))
            if "lanes/" not in name and not name.startswith("c_api/"):  # kernels include the one, only float has the other
                all_units[name.replace("/", "_")] = self.command(self.plain, source)
        for name, line in self.kernels.items():
            all_units[f"kernels_{name}"] = self.command(line, None)
        return all_units

    def running_units(self):
        """Without the kernels of instruction sets that don't run here: they are the same source."""
        skipped = {f"kernels_{name}" for name in self.kernels if name not in kernels_here()}
        return [name for name in self.units() if name not in skipped]

    def command(self, line, source):
        words = [word.replace(str(ROOT / "engine"), str(self.engine)) for word in shlex.split(line)]
        while not words[0].endswith(("c++", "g++", "clang++")):
            words.pop(0)  # a compiler launcher
        for option in ("-o", "-MF", "-MT"):
            at = words.index(option)
            del words[at:at + 2]
        if source:
            words[-1] = str(source)
        return [*words[:-1], LEVEL, words[-1]]

    def compile(self, name, folder, options=()):
        """What the compiler complains of; empty if it makes the object."""
        out = folder / f"{name}.o"
        made = subprocess.run([*self.units()[name], *options, "-MF", str(out) + ".d", "-o", str(out)], cwd=self.built,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        return made.stderr or "it fails" if made.returncode != 0 else ""

    def compile_missing(self):
        for folder, names, options in ((self.work / "objects", self.units(), []),
                                       (self.work / "counting", self.running_units(), COUNTING)):
            for name in names:
                if not (folder / f"{name}.o").exists():
                    print(f"compiling {folder.name}/{name}", file=sys.stderr)
                    complaint = self.compile(name, folder, options)
                    if complaint:
                        (folder / f"{name}.o").unlink(missing_ok=True)
                        fail(f"the sound engine does not compile:\n{complaint}")

    def users_of(self, file):
        """The running objects made from a file."""
        path = str(self.engine / file)
        return [name for name in self.running_units()
                if path in (self.work / "objects" / f"{name}.o.d").read_text().split()]

    def link(self, program, changed, folder, options=()):
        """`changed`: names of objects in the folder that replace those of the sound engine."""
        ours = [str((folder if name in changed else self.work / "objects") / f"{name}.o") for name in self.units()]
        words = [word for word in shlex.split(self.link_command) if f"/{OBJECTS}.dir/" not in word]
        words = words[words.index("&&") + 1:]
        words = words[:words.index("&&")]
        words[words.index("-o") + 1] = str(program)
        # First, since inline functions of other objects that include the engine's headers are the sound ones.
        subprocess.run([words[0], *options, *ours, *words[1:]], cwd=self.built, check=True)
