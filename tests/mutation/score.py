#!/usr/bin/env python3
"""The mutation score: of N small mistakes in engine/src, how many do the scenarios find?

Draws places from a seed, makes one mistake at a time in a copy of the engine, builds that, runs every scenario and every
reported case with the default settings and then with sleeping and two workers, and says whether a truth or an invariant finds
it: a verdict becomes wrong or failed, or coarse where the sound engine is right, or the program crashes, refuses or hangs.
There is no baseline. What they don't find is tried in the random scenes of plumb find, of those kinds in which the sound engine
is never wrong, and counted apart. What does not compile, or to the same code, is drawn anew. Survivors come in four classes: a mistake in a function that no run
enters (by a build that counts) is a scene to write, or dead code to delete; one that runs enter but that changes no number
needs a scene in which that line decides; one that changes runs but no verdict needs a truth or an invariant; and one that
provably can't change anything (equivalent.json says why) is not counted.

Not a test: a mutant takes some seconds of one core, and a survivor up to a minute. What keeps it short: only scenarios that
enter the function of the mistake run, in small groups, those first that found most per second, and the first group that finds
the mistake ends it; converged references are made only where a case changes and has one; only objects with code of the
function are made again, in one precision, for the instruction sets of this processor, at -O1, which changes no bit. Results
go to a file and are continued after an interruption.

  cmake --build --preset release --target plumb
  tests/mutation/score.py --seed 1 --count 200
"""

import argparse
import collections
import dataclasses
import filecmp
import json
import random
import re
import resource
import shutil
import subprocess
import sys
from pathlib import Path

import entered
from build import COUNTING, ROOT, Build, fail
from places import Place, places_in

MEMORY = 4 << 30  # bytes that a mutant may take
PATIENCE = 8  # times the sound engine's processor time, and a second, then a mutant hangs
GROUP = 8  # scenarios that run before the next look at what they found,
GROUP_SECONDS = 0.5  # if they take no longer than this
SEARCH_SEED = 1
SEARCH_SCENES = 240  # that a survivor is tried in; a kind in which the sound engine is wrong in one of twice as many is left out
WAYS = ["impulse", "impulse:sleeping=on,workers=2,broad-phase=tree"]  # the next only if a mutant survives the last
# What no scene can ask for, neither as a scene nor through the interface of a simulation: files, or functions of them.
OUT_OF_REACH = {
    # What a game does during a run: puts in and takes out bodies, joints, forces, motors; callbacks; copies of worlds.
    "src/world/body.cpp": [],
    "src/world/clock.cpp": [],
    "src/contacts/part_filter.h": [],
    "src/world/world.cpp": [
        "operator=", "awake_contacts", "set_gravity", "remove_force", "destroy_joint", "set_motor", "set_limits",
        "set_filter", "set_pre_solve", "bodies", "body_count", "awake_count", "copy", "State", "~CallbackScope",
        "mark_held"],  # the last for other integrators
    "src/bodies/body_set.cpp": ["remove", "destroy", "set_layers", "set_part_layers", "advance"],  # likewise
    "src/bodies/body_set.h": ["advance"],
    "src/bodies/force_field.cpp": ["refers_to", "remove", "forget", "free_slot"],
    "src/contacts/contact_set.cpp": ["shown", "in_range", "pre_solve", "forget"],
    "src/islands/sleep.cpp": ["put_to_sleep"],
    "src/islands/sleep.h": ["copy"],
    "src/joints/joint_models.cpp": ["with_motor", "with_limits"],
    "src/joints/joint_set.cpp": ["remove", "set_motor", "set_limits", "forget", "free_slot", "impulse"],
    "src/solver/resting_piles.cpp": ["copy"],
    # What a game looks for and draws, materials by the engine's names, and what only tests ask for.
    "src/world/debug_draw.cpp": [],
    "src/world/queries.cpp": [],
    "src/shapes/ray_cast.cpp": [],
    "src/shapes/distance.cpp": ["shape_cast"],
    "src/shapes/shape.cpp": ["contains", "chain"],
    "src/contacts/touch_log.cpp": [],
    "src/bodies/material.cpp": ["listed", "dashed", "find_material"],
    "src/broad_phase/aabb_tree.cpp": ["height"],
    "src/core/stages.cpp": [],
    "src/core/stages.h": [],
    # What the scene format leaves out: chains and sensors.
    "src/narrow_phase/chains.cpp": [],
    "src/world/sensors.cpp": [],
    # Other methods than the default.
    "src/solver/soft_step.cpp": [],
    "src/solver/colouring.cpp": ["order"],
    "src/bodies/integrator.cpp": [],
    "src/contacts/contact_rows.cpp": ["solvable", "prepare_rows"],
    "src/contacts/contact_rows.h": ["within_cone", "warm_start"],
    # Single precision: in double, DirectIsland solves the islands that are as small as these.
}


def scenarios(plumb):
    listed = subprocess.run([plumb, "list"], check=True, text=True, stdout=subprocess.PIPE).stdout
    return [*re.findall(r"^  ([a-z][\w-]*) ", listed[:listed.index("\nengines\n")], re.M), "tracker"]


def case_of(run):
    """As plumb run takes it."""
    reported = run["variant"] == "tracker"
    return f"tracker:{run['scenario']}" if reported else f"{run['scenario']}:{run['variant']}"


def run_cases(program, way, cases, folder, words, seconds=None, options=("--no-converged",)):
    """(runs of report.json by case, or why there are none; processor seconds)."""
    shutil.rmtree(folder, ignore_errors=True)
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        if seconds:
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))

    try:
        ended = subprocess.run([program, "run", *cases, *options, "--no-timings", "--engine", way, "--ensemble", "0", *words,
                                "--out", folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limit,
                               timeout=60 + 10 * seconds if seconds else None)  # a deadlock takes no processor time
    except subprocess.TimeoutExpired:
        return "hangs", 0
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds_taken = now.ru_utime + now.ru_stime - spent.ru_utime - spent.ru_stime
    if seconds and seconds_taken > seconds:
        return "hangs", seconds_taken
    if ended.returncode not in (0, 1):
        return f"crashes (exit code {ended.returncode})", seconds_taken
    report = json.loads((folder / "report.json").read_text())
    shutil.rmtree(folder)
    return {case_of(run): run for run in report["runs"] if run["engine"] == "impulse"}, seconds_taken


def search(program, folder, count, kinds=()):
    """What judges say of the engine in random scenes, by scene: a list of complaints, in words."""
    shutil.rmtree(folder, ignore_errors=True)
    chosen = [word for kind in kinds for word in ("--kind", kind)]
    ended = subprocess.run([program, "find", "--engine", "impulse", "--seed", str(SEARCH_SEED), "--count", str(count),
                            "--budget", "0", "--jobs", "1", "--out", folder, *chosen], stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
    if ended.returncode not in (0, 1):
        return {"find": [f"crashes (exit code {ended.returncode})"]}
    results = json.loads((folder / "study-find.json").read_text())["results"]
    shutil.rmtree(folder)
    said = {}
    for result in results:
        if result["key"].startswith("find|"):
            opinion = result["values"].get("opinions", {}).get("impulse", {"complaints": [{"what": result["reason"]}]})
            said[result["key"].removeprefix("find|")] = [one["what"] for one in opinion["complaints"]]
    return said


def kind_of(scene):
    return scene.split("/")[0]


def why(run):
    """What a verdict rests on: the broken checks of a run."""
    broken = [check["name"] for check in run["invariants"] if check["status"] == "broken"]
    missed = [f"{check['body']} {check['quantity']}".strip() for check in run["truth"]
              if check["reported"] and not check["passed"]]
    return ", ".join((broken + missed)[:3]) or run["reason"]


def kills(sound, mutant):
    """By case, how a mutant's verdict is worse."""
    found = {}
    for case, run in mutant.items():
        before, after = sound[case]["verdict"], run["verdict"]
        worse = after in ("wrong", "failed") and before not in ("wrong", "failed")
        worse = worse or (after == "coarse" and before == "right")
        worse = worse or (after == "not supported" and before != "not supported")
        if worse:
            found[case] = f"{after}: {why(run)}" if after != "coarse" else after
    return found


class Sound:
    """The engine without a mistake: by way, groups of scenarios, quick ones first, with their runs, processor seconds and
    entered lines. Remembered in a file until the program changes."""

    def __init__(self, build, words):
        self.build, self.words = build, words
        self.program = build.built / "reports/plumb"
        self.converged_file = build.work / "converged.json"
        file = build.work / "sound.json"
        if not file.exists() or file.stat().st_mtime < self.program.stat().st_mtime:
            self.converged_file.unlink(missing_ok=True)
            build.link(build.work / "plumb-counting", build.running_units(), build.work / "counting", COUNTING)
            file.write_text(json.dumps({way: self.measure(way) for way in WAYS}))
        self.ways = json.loads(file.read_text())
        self.converged = json.loads(self.converged_file.read_text()) if self.converged_file.exists() else {}
        searched = build.work / "searched.json"
        if not searched.exists() or searched.stat().st_mtime < self.program.stat().st_mtime:
            print("searching random scenes", file=sys.stderr)
            searched.write_text(json.dumps(search(self.program, build.work / "out", 2 * SEARCH_SCENES)))
        said = json.loads(searched.read_text())
        wrong = {kind_of(scene) for scene, complaints in said.items() if complaints}
        kinds = {kind_of(scene) for scene in said}
        self.kinds = sorted(kinds - wrong)
        self.scenes = SEARCH_SCENES * len(self.kinds) // len(kinds)

    def run(self, program, way, cases, **options):
        runs, seconds = run_cases(program, way, cases, self.build.work / "out", self.words, **options)
        if isinstance(runs, str):
            fail(f"the sound engine {runs} in {cases}")
        return runs, seconds

    def measure(self, way):
        print(f"running every scenario in {way}", file=sys.stderr)
        alone = {name: self.run(self.program, way, [name]) for name in scenarios(self.program)}
        measured = []
        for names in groups({name: seconds for name, (_, seconds) in alone.items()}):
            runs = {case: run for name in names for case, run in alone[name][0].items()}
            entered.reset(self.build)
            if self.run(self.build.work / "plumb-counting", way, names)[0] != runs:
                fail(f"{names} have other bits at another level of optimisation")
            lines = {file: sorted(of_file) for file, of_file in entered.Counts(self.build).lines.items()}
            measured.append({"names": names, "seconds": sum(alone[name][1] for name in names), "runs": runs, "lines": lines})
        return measured

    def referenced(self, cases):
        """Of these cases those that converged references judge, with their runs."""
        missing = [case for case in cases if case not in self.converged]
        if missing:
            self.converged |= self.run(self.program, WAYS[0], missing, options=())[0]
            self.converged_file.write_text(json.dumps(self.converged))
        plain = {case: run for group in self.ways[WAYS[0]] for case, run in group["runs"].items()}
        return {case: self.converged[case] for case in cases if self.converged[case] != plain[case]}


def groups(seconds):
    """Scenarios that run before the next look at what they found; `seconds` by scenario."""
    found = [[]]
    for name in sorted(seconds, key=seconds.get):
        if len(found[-1]) == GROUP or sum(seconds[other] for other in [*found[-1], name]) > GROUP_SECONDS:
            found.append([])
        found[-1].append(name)
    return [names for names in found if names]


class Mutant:
    """One mistake, while it is made and tried."""

    def __init__(self, build, sound, counts, place):
        self.build, self.sound, self.place = build, sound, place
        self.program = build.work / "plumb-mutant"
        function = entered.function_around(counts, build, place)
        self.objects = entered.objects_with(counts, function, place, build.users_of(place.file))
        self.groups = {way: [group for group in sound.ways[way] if entered.enters(group["lines"], function, place)]
                       for way in WAYS}

    def compiles(self):
        """Whether it can be tried: it compiles, and to other code than the sound engine's, which proves nothing."""
        path = self.build.engine / self.place.file
        text = path.read_text()
        lines = text.split("\n")
        lines[self.place.line - 1] = self.place.after
        folder = self.build.work / "mutant"
        folder.mkdir(exist_ok=True)
        try:
            path.write_text("\n".join(lines))
            return (not any(self.build.compile(name, folder) for name in self.objects) and
                    any(not filecmp.cmp(folder / f"{name}.o", self.build.work / "objects" / f"{name}.o", shallow=False)
                        for name in self.objects))
        finally:
            path.write_text(text)

    def outcome(self, found_before):
        """`found_before`: how many mutants each scenario has found."""
        if change_of(self.place) in equivalents():
            return self.judged({}, [])
        self.build.link(self.program, self.objects, self.build.work / "mutant")
        changed = set()
        for way in WAYS:
            cost = {id(group): group["seconds"] / (1 + sum(found_before[name] for name in group["names"]))
                    for group in self.groups[way]}
            for group in sorted(self.groups[way], key=lambda group: cost[id(group)]):
                found = self.run(way, group["names"], group["runs"], group["seconds"], changed)
                if found:
                    return self.judged(found, [])
        referenced = self.sound.referenced(sorted(changed))
        found = referenced and self.run(WAYS[0], sorted(referenced), referenced, 100, set(), options=())
        return self.judged(found or self.searched(), sorted(changed))

    def searched(self):
        said = search(self.program, self.build.work / "out", self.sound.scenes, self.sound.kinds)
        return {f"random scene {scene}": complaints[0] for scene, complaints in said.items() if complaints}

    def run(self, way, cases, right, seconds, changed, **options):
        """What these cases find; adds to the cases that changed."""
        runs, _ = run_cases(self.program, way, cases, self.build.work / "out", self.sound.words, PATIENCE * (1 + seconds),
                            **options)
        if isinstance(runs, str):
            return {cases[0]: runs}
        changed |= {case for case in runs if runs[case] != right[case]}
        return kills(right, runs)

    def judged(self, found, changed):
        return {"killed": bool(found), "by": found, "changed": changed, "entered": any(self.groups.values())}


def change_of(place):
    return place.file, place.before.strip(), place.after.strip()


def equivalents():
    """The changes that were shown by hand to have no effect."""
    listed = json.loads((Path(__file__).parent / "equivalent.json").read_text())
    return {(one["file"], one["before"], one["after"]) for one in listed}


class Draw:
    """The mutants of a seed. Each line of code with places is as likely as any other, then each kind, then each place."""

    def __init__(self, engine, seed, counts):
        self.seed, self.counts = seed, counts
        self.lines = []
        for path in sorted([*(engine / "src").rglob("*.cpp"), *(engine / "src").rglob("*.h")]):
            if path.parent.name != "c_api":  # the interface in C, which has tests of its own
                self.lines += places_in(str(path.relative_to(engine)), path.read_text())

    def place(self, index, attempt):
        """None if no scene can reach the place that was drawn."""
        dice = random.Random(f"{self.seed} {index} {attempt}")
        places = dice.choice(self.lines)
        kind = dice.choice(sorted({place.kind for place in places}))
        place = dice.choice([place for place in places if place.kind == kind])
        functions = OUT_OF_REACH.get(place.file)
        if functions is not None and (not functions or entered.name_around(self.counts, place) in functions):
            return None
        return place


def place_of(record):
    return Place(**{field.name: record[field.name] for field in dataclasses.fields(Place)})


def summary(records):
    same = equivalents()
    alike = [one for one in records if change_of(place_of(one)) in same]
    judged = [one for one in records if one not in alike]
    killed = [one for one in judged if one["killed"]]
    at_random = sum(all(case.startswith("random scene") for case in one["by"]) for one in killed)
    print(f"\nMutation score: {len(killed)} of {len(judged)} killed, {100 * len(killed) / max(1, len(judged)):.0f} %, "
          f"{at_random} of them in random scenes only.")
    kinds = collections.Counter(one["kind"] for one in judged)
    for kind, count in sorted(kinds.items()):
        print(f"  {kind:<20}{sum(one['kind'] == kind for one in killed):>4} of {count}")
    silent = [one for one in judged if not one["killed"] and not one["changed"]]
    for title, those in (
            ("No run enters its function: a scene to write, or dead code to delete",
             [one for one in silent if not one["entered"]]),
            ("Runs enter it, but no number changes: a scene to write in which it decides",
             [one for one in silent if one["entered"]]),
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
    sound = Sound(build, options.words)
    entered.reset(build)
    counts = entered.Counts(build)
    draw = Draw(build.engine, options.seed, counts)
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
        found_before = collections.Counter(case.split(":")[0] for record in records.values() for case in record["by"])
        drawn = {place_of(record) for record in records.values()}
        for attempt in range(1000):
            place = place_of(records[index]) if index in records else draw.place(index, attempt)
            mutant = Mutant(build, sound, counts, place) if place and (index in records or place not in drawn) else None
            if mutant and mutant.compiles():
                break
        record = {"engine": build.base, "index": index, **dataclasses.asdict(place), **mutant.outcome(found_before)}
        records[index] = record
        with results.open("a") as file:
            file.write(json.dumps(record) + "\n")
        print(f"{index}: {'killed' if record['killed'] else 'SURVIVES'} engine/{place.file}:{place.line} ({place.kind})"
              f" {next(iter(record['by'].items()), '')}", file=sys.stderr)
    summary([records[index] for index in sorted(records)])


if __name__ == "__main__":
    main()
