#!/usr/bin/env python3
"""The mutation score: of N small mistakes in engine/src, how many do the scenarios find?

Draws places from a seed, makes one mistake at a time in a copy of the engine, builds that, runs every scenario with the
default settings and then with sleeping and two workers, and says whether a truth or an invariant finds it: a verdict
becomes wrong or failed, or coarse where the sound engine is right, or the program crashes, refuses or hangs. There is no
baseline. What does not compile is drawn anew. Survivors come in four classes: a mistake in a line that no run enters (by a
build that counts) is a scene to write, or dead code to delete; one in a line that runs enter but that changes no number needs
a scene in which that line decides; one that changes runs but no verdict needs a truth or an invariant; and one that provably
can't change anything (equivalent.json says why) is not counted.

Not a test: a mutant takes some seconds of one core, and a survivor half a minute. What keeps it short: scenarios run in
small groups, quick ones first, and the first that finds the mistake ends it; only objects that a mistake changes are made
again, in one precision, for the instruction sets of this processor, at -O1, which changes no bit. Results go to a file and
are continued after an interruption.

  cmake --build --preset release --target plumb
  tests/mutation/score.py --seed 1 --count 200
"""

import argparse
import collections
import dataclasses
import hashlib
import json
import os
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

from places import Place, places_in

ROOT = Path(__file__).resolve().parents[2]
OBJECTS = "impulse_double_objects"  # scenarios run in double precision
MEMORY = 4 << 30  # bytes that a mutant may take
PATIENCE = 8  # times the sound engine's time, then a mutant hangs
GROUP = 12  # scenarios that run before the next look at what they found
LEVEL = "-O1"  # of optimisation: compiles in half of the time of -O2
# Neither a scene nor the interface of a simulation can ask for these (chains, events, filters, what a game does to a body and when
# it draws); and another method than the default.
OUT_OF_REACH = ["src/world/debug_draw.cpp", "src/world/queries.cpp", "src/shapes/ray_cast.cpp", "src/core/stages.cpp",
                "src/core/stages.h", "src/narrow_phase/chains.cpp", "src/contacts/touch_log.cpp", "src/world/body.cpp",
                "src/world/clock.cpp", "src/solver/soft_step.cpp", "src/contacts/part_filter.h"]


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
    """A copy of the engine whose sources are compiled one by one and linked with the objects of an existing build."""

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
        self.scenarios = scenarios(built / "reports/plumb")
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
        for folder in (self.engine, self.work / "objects"):
            shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source, self.engine)
        (self.work / "objects").mkdir()
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

    def compile(self, name, command, folder):
        out = folder / f"{name}.o"
        made = subprocess.run([*command, "-MF", str(out) + ".d", "-o", str(out)], cwd=self.built,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        return made.returncode == 0, made.stderr

    def compile_missing(self):
        for name, command in self.units().items():
            if not (self.work / "objects" / f"{name}.o").exists():
                print(f"compiling {name}", file=sys.stderr)
                passed, said = self.compile(name, command, self.work / "objects")
                if not passed:
                    (self.work / "objects" / f"{name}.o").unlink(missing_ok=True)
                    fail(f"the sound engine does not compile:\n{said}")

    def users_of(self, file):
        """The objects made from a file. Of the kernels only those that run here: the others are the same source."""
        skipped = {f"kernels_{name}" for name in self.kernels if name not in kernels_here()}
        path = str(self.engine / file)
        return [name for name in self.units() if name not in skipped
                and path in (self.work / "objects" / f"{name}.o.d").read_text().split()]

    def link(self, program, changed, folder=None, options=()):
        """`changed`: names of objects in the folder that replace those of the sound engine."""
        ours = [str((folder if name in changed else self.work / "objects") / f"{name}.o") for name in self.units()]
        words = [word for word in shlex.split(self.link_command) if f"/{OBJECTS}.dir/" not in word]
        words = words[words.index("&&") + 1:]
        words = words[:words.index("&&")]
        words[words.index("-o") + 1] = str(program)
        # First, since inline functions of other objects that include the engine's headers are the sound ones.
        subprocess.run([words[0], *options, *ours, *words[1:]], cwd=self.built, check=True)


def scenarios(plumb):
    listed = subprocess.run([plumb, "list"], check=True, text=True, stdout=subprocess.PIPE).stdout
    return re.findall(r"^  ([a-z][\w-]*) ", listed[:listed.index("\nengines\n")], re.M)


def stages(quickest_first):
    """What a mutant is tried with: engine and options of plumb run. The next only if it survives the last; the last, with
    converged references, only in the cases that it changed, because these take most of the time."""
    groups = [quickest_first[at:at + GROUP] for at in range(0, len(quickest_first), GROUP)]
    return [*(("impulse", [*group, "--no-converged"]) for group in groups), ("impulse", ["--all", "--no-converged"]),
            ("impulse:sleeping=on,workers=2,broad-phase=tree", ["--all", "--no-converged"]), ("impulse", ["--all"])]


def run_stage(program, stage, folder, seconds, words):
    """(report, reason): the runs of report.json by case, or why there is none."""
    shutil.rmtree(folder, ignore_errors=True)
    engine, of_stage = stage
    try:
        ended = subprocess.run([program, "run", *of_stage, "--engine", engine, "--ensemble", "0", *words,
                                "--out", folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=seconds,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
    except subprocess.TimeoutExpired:
        return None, "hangs"
    if ended.returncode not in (0, 1):
        return None, f"crashes (exit code {ended.returncode})"
    report = json.loads((folder / "report.json").read_text())
    shutil.rmtree(folder)
    return {f"{run['scenario']}:{run['variant']}": run for run in report["runs"] if run["engine"] == "impulse"}, ""


def why(run):
    """What a verdict rests on: the broken checks of a run."""
    broken = [check["name"] for check in run["invariants"] if check["status"] == "broken"]
    missed = [f"{check['body']} {check['quantity']}".strip() for check in run["truth"]
              if check["reported"] and not check["passed"]]
    return ", ".join((broken + missed)[:3]) or run["reason"]


def kills(sound, mutant):
    found = []
    for case, run in mutant.items():
        before, after = sound[case]["verdict"], run["verdict"]
        worse = after in ("wrong", "failed") and before not in ("wrong", "failed")
        worse = worse or (after == "coarse" and before == "right")
        worse = worse or (after == "not supported" and before != "not supported")
        if worse:
            found.append(f"{case} {after}: {why(run)}" if after != "coarse" else f"{case} coarse")
    return found


def entered_lines(build, words):
    """By file: the lines that any of the runs enters; remembered as long as the sound runs are."""
    file, sound = build.work / "entered.json", build.work / "sound.json"
    if file.exists() and file.stat().st_mtime > sound.stat().st_mtime:
        return json.loads(file.read_text())
    folder = build.work / "counting"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    unused = [f"kernels_{name}" for name in build.kernels if name not in kernels_here()]
    counted = [name for name in build.units() if name not in unused]
    for name in counted:
        passed, said = build.compile(name, [*build.units()[name], "--coverage"], folder)
        if not passed:
            fail(f"the sound engine does not compile with --coverage:\n{said}")
    program = build.work / "plumb-counting"
    build.link(program, counted, folder, ["--coverage"])
    for stage in stages(build.scenarios)[-3:]:  # the others are parts of these
        runs, reason = run_stage(program, stage, build.work / "out", None, words)
        if runs is None:
            fail(f"the engine that counts {reason}")
    entered = collections.defaultdict(dict)
    for name in counted:
        counts = subprocess.run(["gcov", "--json-format", "--stdout", f"{name}.gcda"], cwd=folder, check=True,
                                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
        for source in json.loads(counts)["files"]:
            path = Path(os.path.normpath(build.built / source["file"]))
            if path.is_relative_to(build.engine):
                of_file = entered[str(path.relative_to(build.engine))]
                for line in source["lines"]:
                    at = str(line["line_number"])
                    of_file[at] = of_file.get(at, 0) + line["count"]
    file.write_text(json.dumps(entered))
    return entered


def is_entered(entered, place):
    """A statement of several lines is counted at its first."""
    counts = entered.get(place["file"], {})
    counted = [int(line) for line in counts if int(line) <= place["line"]]
    return bool(counted) and counts[str(max(counted))] > 0


def equivalents():
    """What was shown by hand to change nothing, by file, line of source and change."""
    listed = json.loads((Path(__file__).parent / "equivalent.json").read_text())
    return {(one["file"], one["before"].strip(), one["after"].strip()) for one in listed}


class Draw:
    """The mutants of a seed. Each line of code with places is as likely as any other, then each kind, then each place."""

    def __init__(self, engine, seed):
        self.seed = seed
        self.lines = []
        for path in sorted([*(engine / "src").rglob("*.cpp"), *(engine / "src").rglob("*.h")]):
            if path.parent.name != "c_api":  # the interface in C, which has tests of its own
                self.lines += places_in(str(path.relative_to(engine)), path.read_text())

    def place(self, index, attempt):
        """None if no scene can reach the place that was drawn."""
        dice = random.Random(f"{self.seed} {index} {attempt}")
        places = dice.choice(self.lines)
        if places[0].file in OUT_OF_REACH:
            return None
        kind = dice.choice(sorted({place.kind for place in places}))
        return dice.choice([place for place in places if place.kind == kind])


def try_place(build, place, sound, options):
    """The outcome of a mutant; None if it does not compile."""
    path = build.engine / place.file
    text = path.read_text()
    lines = text.split("\n")
    lines[place.line - 1] = place.after
    folder = build.work / "mutant"
    folder.mkdir(exist_ok=True)
    users = build.users_of(place.file)
    try:
        path.write_text("\n".join(lines))
        if not all(build.compile(name, build.units()[name], folder)[0] for name in users):
            return None
    finally:
        path.write_text(text)
    program = build.work / "plumb-mutant"
    build.link(program, users, folder)
    changed = set()
    for right in sound:
        engine, of_stage = right["stage"]
        if right is sound[-1]:
            if not changed:
                break
            of_stage = sorted(changed)
        runs, reason = run_stage(program, (engine, of_stage), build.work / "out", PATIENCE * max(10, right["seconds"]),
                                 options.words)
        found = kills(right["runs"], runs) if runs else [reason]
        if found:
            return {"killed": True, "by": found, "changed": []}
        changed |= {case for case in runs if runs[case] != right["runs"][case]}
    return {"killed": False, "by": [], "changed": sorted(changed)}


def place_of(record):
    return Place(**{field.name: record[field.name] for field in dataclasses.fields(Place)})


def sound_runs(build, words):
    """Of the sound engine, by stage; remembered until the program it is linked from changes."""
    file = build.work / "sound.json"
    if file.exists() and file.stat().st_mtime > (build.built / "reports/plumb").stat().st_mtime:
        return json.loads(file.read_text())
    program = build.work / "plumb-sound"
    build.link(program, [])
    costs = {}

    def run(stage):
        begun = time.monotonic()
        runs, reason = run_stage(program, stage, build.work / "out", None, words)
        if runs is None:
            fail(f"the sound engine {reason}")
        return {"stage": stage, "seconds": time.monotonic() - begun, "runs": runs}

    for name in build.scenarios:
        costs[name] = run(("impulse", [name, "--no-converged"]))["seconds"]
    sound = [run(stage) for stage in stages(sorted(build.scenarios, key=costs.get))]
    file.write_text(json.dumps(sound))
    return sound


def summary(records, entered):
    same = equivalents()
    alike = [one for one in records if (one["file"], one["before"].strip(), one["after"].strip()) in same]
    judged = [one for one in records if one not in alike]
    killed = [one for one in judged if one["killed"]]
    print(f"\nMutation score: {len(killed)} of {len(judged)} killed, {100 * len(killed) / max(1, len(judged)):.0f} %.")
    kinds = collections.Counter(one["kind"] for one in judged)
    for kind, count in sorted(kinds.items()):
        print(f"  {kind:<20}{sum(one['kind'] == kind for one in killed):>4} of {count}")
    silent = [one for one in judged if not one["killed"] and not one["changed"]]
    unseen = [one for one in silent if not is_entered(entered, one)]
    for title, those in (
            ("No run enters it: a scene to write, or dead code to delete", unseen),
            ("Runs enter it, but no number changes: a scene to write in which it decides",
             [one for one in silent if one not in unseen]),
            ("Changes runs, but no verdict: a truth or an invariant to write",
             [one for one in judged if not one["killed"] and one["changed"]]),
            ("Can change nothing, not counted (equivalent.json)", alike)):
        print(f"\n{title}: {len(those)}")
        for one in those:
            print(f"  {one['index']}: engine/{one['file']}:{one['line']} ({one['kind']})\n    - {one['before'].strip()}\n"
                  f"    + {one['after'].strip()}")
            if one["changed"]:
                print(f"    changes {len(one['changed'])} cases: {', '.join(one['changed'][:6])}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=200, help="mutants of this seed, including those of earlier calls")
    parser.add_argument("--first", type=int, default=0, help="index of the first to try; for a part of them")
    parser.add_argument("--retry", action="store_true", help="try survivors of earlier calls again, after cases were added")
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", help="an up-to-date build of plumb")
    parser.add_argument("--work", type=Path, default=ROOT / "build/mutation", help="folder for the copy and the results")
    parser.add_argument("words", nargs="*", help="after --: further options of plumb run, such as --jobs 1")
    options = parser.parse_args()
    if not (options.build / "reports/plumb").exists():
        fail(f"{options.build} has no plumb: cmake --build --preset release --target plumb")
    options.work.mkdir(parents=True, exist_ok=True)

    build = Build(options.build.resolve(), options.work.resolve())
    build.compile_missing()
    sound = sound_runs(build, options.words)
    draw = Draw(build.engine, options.seed)
    results = options.work / f"seed-{options.seed}.jsonl"
    records = {}
    for line in results.read_text().splitlines() if results.exists() else []:
        record = json.loads(line)
        if record["engine"] != build.base:
            fail(f"{results} is of other sources of the engine: move it away, or give --work another folder")
        records[record["index"]] = record
    survived = {index for index, record in records.items() if not record["killed"]}
    for index in range(options.first, options.count):
        if index in records and not (options.retry and index in survived):
            continue
        for attempt in range(1000):
            place = place_of(records[index]) if index in records else draw.place(index, attempt)
            outcome = try_place(build, place, sound, options) if place else None
            if outcome is not None:
                break
        record = {"engine": build.base, "index": index, **dataclasses.asdict(place), **outcome}
        records[index] = record
        with results.open("a") as file:
            file.write(json.dumps(record) + "\n")
        print(f"{index}: {'killed' if record['killed'] else 'SURVIVES'} engine/{place.file}:{place.line} ({place.kind})"
              f" {record['by'][:1]}", file=sys.stderr)
    summary([records[index] for index in sorted(records)], entered_lines(build, options.words))


if __name__ == "__main__":
    main()
