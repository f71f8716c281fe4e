"""plumb-engine 1 for Python 3: the lines between Plumb and an engine. Give serve() yours."""
import binascii
import json
import math
import struct
import sys
import time


class NotSupported(Exception):
    """Raise it with the reason if the engine can't run a scene."""


def serve(hello, stepping, build):
    """Answers Plumb until it says end.

    hello     dict: name, version, and if you like about, source, language and execution (of what steps), caveats,
              options
    stepping  stepping(options, dt): dict of what the engine states of its steps; see engine.schema.json
    build     build(scene, masses, options): a world with
              step(dt)    advances by dt seconds; the only call that is timed
              states()    [x, y, angle, vx, vy, angular velocity] for each body, of its centre of mass
              contacts()  optional: [a, b, x, y, normal x, normal y, normal impulse, tangent impulse, separation] each
              drive(body, vx, vy)  optional: gives a kinematic body another velocity; without it there are no paths
    """
    lines, sys.stdout = sys.stdout, sys.stderr  # what the engine prints is its log

    def answer(value):
        lines.write(json.dumps(value, allow_nan=False) + "\n")
        lines.flush()

    def take_steps(count, dt):
        nonlocal steps
        clock, text, flushed = time.perf_counter_ns, [], time.perf_counter_ns()
        for steps in range(steps + 1, steps + count + 1):
            began = clock()
            carry(dt)
            world.step(dt)
            ended = clock()
            states = packed(world.states(), STATE)
            met = f',"contacts":"{packed(world.contacts(), CONTACT)}"' if hasattr(world, "contacts") else ""
            text.append(f'{{"step":{steps},"ns":{ended - began},"states":"{states}"{met}}}\n')
            if len(text) == 64 or ended - flushed > 50e6:  # many answers in one write, none held back for long
                lines.write("".join(text))
                lines.flush()
                text, flushed = [], ended
        lines.write("".join(text))
        lines.flush()

    world, carry, steps = None, None, 0
    for line in sys.stdin:
        ask = json.loads(line)
        if "hello" in ask:
            answer({"plumb-engine": 1, "language": "Python", "execution": "interpreted", **hello})
        elif "stepping" in ask:
            answer({"stepping": stepping(ask["stepping"]["options"], ask["stepping"]["dt"])})
        elif "build" in ask:
            wanted = ask["build"]
            try:
                world, steps = build(wanted["scene"], wanted["masses"], wanted["options"]), 0
                carry = carriage(wanted["scene"], world)
                answer({"states": world.states()})
            except NotSupported as reason:
                answer({"notSupported": str(reason)})
        elif "step" in ask:
            take_steps(**ask["step"])
        elif "end" in ask:
            return
        else:
            answer({"error": "unknown ask: " + ", ".join(ask)})


STATE, CONTACT = struct.Struct("<6d").pack, struct.Struct("<9d").pack


def packed(rows, row):
    """Rows of numbers in base64: a tenth of the time that their digits take."""
    return binascii.b2a_base64(b"".join([row(*numbers) for numbers in rows]), newline=False).decode()


def carriage(scene, world):
    """Drives kinematic bodies along their paths: before a step they get the velocity that takes them to its end."""
    carried = [(index, body) for index, body in enumerate(scene["bodies"]) if "path" in body]
    if carried and not hasattr(world, "drive"):
        raise NotSupported("no paths of kinematic bodies")

    def turn(path, at):
        return 2 * math.pi * path["frequency"] * at + path.get("phase", 0)

    def drive(rate_of):
        for index, body in carried:
            rate, path = rate_of(body["path"]), body["path"]["amplitude"]
            vx, vy = body.get("velocity", [0, 0])
            world.drive(index, vx + rate * path[0], vy + rate * path[1])

    now = 0

    def carry(dt):
        nonlocal now
        drive(lambda path: (math.sin(turn(path, now + dt)) - math.sin(turn(path, now))) / dt)
        now += dt

    drive(lambda path: 2 * math.pi * path["frequency"] * math.cos(turn(path, 0)))
    return carry
