#!/usr/bin/env python3
"""The table of this folder's README.md, from the report.json of a run:

    ./plumb run tracker --engine impulse --engine box2d ... --no-converged --ensemble 0
    scenarios/tracker/page.py out/report.json
"""
import json
import sys
from pathlib import Path

# Whose report is it: the engines here that stand for the one of the report. Others have no engine here.
SAME = {"box2d": ["box2d", "box2d3-wasm"], "love": ["box2d"], "andengine": ["box2d"], "gamemaker": ["box2d"],
        "box3d": ["box2d3-wasm"], "planck": ["planck"], "matter": ["matter"], "chipmunk": ["chipmunk"],
        "rapier": ["rapier"], "rapier2d": ["rapier"], "rapierjs": ["rapier"]}
UNITS = {"x": "m", "y": "m", "angle": "rad", "vx": "m/s", "vy": "m/s", "speed": "m/s", "angularVelocity": "rad/s",
         "energy": "J"}


def failed(run):
    """The stated truths that a run misses, the worst first."""
    missed = [check for check in run["truth"] if not check["passed"]]
    return sorted(missed, key=lambda check: -abs(check["measured"] - check["expected"]) / check["tolerance"])


def broken(run):
    return [check for check in run["invariants"] if check["status"] == "broken"]


def cell(run):
    if run["status"] == "not supported":
        return "n/s"
    if run["status"] != "ok":
        return "failed"
    missed, laws = failed(run), broken(run)
    if missed:
        worst = missed[0]
        unit = UNITS[worst["quantity"]]
        return f"**{worst['quantity']} {worst['measured']:.3g}**, not {worst['expected']:.3g} {unit}".replace("-", "−")
    return f"({max(laws, key=lambda law: law['ratio'])['name']})".replace("_", " ") if laws else "–"


def state(name, runs):
    """Whether an engine of the reporter's line still does it or breaks another law, else how many engines here do it."""
    shown = [engine for engine, run in runs.items() if run["status"] == "ok" and failed(run)]
    own = [engine for engine in SAME.get(name.split("-")[0], []) if engine in runs]
    if any(engine in shown for engine in own):
        return "*reproduced*"
    others = f"; in {len(shown)} others" if len(shown) > 1 else "; in another" if shown else ""
    if any(broken(runs[engine]) for engine in own):
        return "*another law*" + others
    if any(runs[engine]["status"] == "ok" for engine in own):
        return "*gone*" + others
    return f"*reproduced* in {len(shown)}" if shown else "*not reproduced*"


def main(paths):
    cases, engines = {}, []
    for path in paths:
        for run in json.loads(Path(path).read_text())["runs"]:
            if run["exact"]:
                continue
            engine = run["engine"] + (f" ({run['method']})" if run["method"] else "")
            cases.setdefault(run["scenario"], {})[engine] = run
            if engine not in engines:
                engines.append(engine)
    print("| case | state | " + " | ".join(engines) + " |")
    print("|---|---|" + "---|" * len(engines))
    for name, runs in cases.items():
        link = json.loads((Path(__file__).parent / f"{name}.json").read_text())["source"]
        cells = [cell(runs[engine]) if engine in runs else "" for engine in engines]
        print(f"| [{name}]({link}) | {state(name, runs)} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main(sys.argv[1:])
