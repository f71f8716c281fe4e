"""plumb-engine 1 for Python 3: the lines between Plumb and an engine. Give serve() yours."""
import json
import sys
import time


class NotSupported(Exception):
    """Raise it with the reason if the engine can't run a scene."""


def serve(hello, stepping, build):
    """Answers Plumb until it says end.

    hello     dict: name, version, and if you like about, source, language, options
    stepping  stepping(options, dt): dict of what the engine states about itself; see reference/README.md
    build     build(scene, masses, options): a world with
              step(dt)    advances by dt seconds; the only call that is timed
              states()    [x, y, angle, vx, vy, angular velocity] for each body, of its centre of mass
              contacts()  optional: [a, b, x, y, normal x, normal y, normal impulse, tangent impulse, separation] each
    """
    lines, sys.stdout = sys.stdout, sys.stderr  # what the engine prints is its log

    def answer(value):
        lines.write(json.dumps(value, allow_nan=False) + "\n")
        lines.flush()

    def step(number, dt):
        began = time.perf_counter_ns()
        world.step(dt)
        spent = time.perf_counter_ns() - began
        told = {"step": number, "states": world.states(), "ns": spent}
        if hasattr(world, "contacts"):
            told["contacts"] = world.contacts()
        return told

    world, steps = None, 0
    for line in sys.stdin:
        ask = json.loads(line)
        if "hello" in ask:
            answer({"plumb-engine": 1, **hello})
        elif "stepping" in ask:
            answer({"stepping": stepping(ask["stepping"]["options"], ask["stepping"]["dt"])})
        elif "build" in ask:
            wanted = ask["build"]
            try:
                world, steps = build(wanted["scene"], wanted["masses"], wanted["options"]), 0
                answer({"states": world.states()})
            except NotSupported as reason:
                answer({"notSupported": str(reason)})
        elif "step" in ask:
            for _ in range(ask["step"]["count"]):
                steps += 1
                answer(step(steps, ask["step"]["dt"]))
        elif "end" in ask:
            return
        else:
            answer({"error": "unknown ask: " + ", ".join(ask)})
