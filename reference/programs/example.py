#!/usr/bin/env python3
"""An engine for discs on a floor, to start one's own from: symplectic Euler and sequential impulses."""
import math

from plumb_engine import NotSupported, serve

ITERATIONS = 20


class World:
    def __init__(self, scene, masses, options):
        if scene.get("joints") or scene.get("forces"):
            raise NotSupported("no joints and no forces but gravity")
        self.gravity, self.iterations = scene["gravity"], int(options["iterations"])
        self.mixing = scene.get("mixing", {})
        self.bodies, self.discs, self.walls = [], [], []
        for body, (mass, inertia, cx, cy) in zip(scene["bodies"], masses):
            self.add(body, mass, inertia)
        self.touching = []

    def add(self, body, mass, inertia):
        unknown = set(body) - {"name", "type", "position", "angle", "velocity", "angularVelocity", "gravityScale",
                               "shapes"}
        if unknown or body.get("type") == "kinematic":
            raise NotSupported("no " + ", ".join(sorted(unknown) or ["kinematic bodies"]))
        if len(body["shapes"]) != 1:
            raise NotSupported("one shape a body")
        shape = body["shapes"][0]
        if isinstance(shape.get("friction"), dict):
            raise NotSupported("one coefficient of friction")
        fixed = body.get("type") == "static"
        (x, y), angle = body.get("position", [0, 0]), body.get("angle", 0)
        index = len(self.bodies)
        self.bodies.append([x, y, angle, *body.get("velocity", [0, 0]), body.get("angularVelocity", 0)])
        surface = (shape.get("friction", 0), shape.get("restitution", 0))
        if shape["type"] == "circle" and not fixed and shape.get("center", [0, 0]) == [0, 0]:
            inverse_inertia = 1 / inertia if inertia else 0
            self.discs.append((index, shape["radius"], 1 / mass, inverse_inertia, body.get("gravityScale", 1), surface))
        elif shape["type"] == "halfspace" and fixed and angle == 0:
            nx, ny = shape.get("normal", [0, 1])
            self.walls.append((index, nx, ny, shape.get("offset", 0) + nx * x + ny * y, surface))
        else:
            raise NotSupported("discs that move and half-spaces that don't, nothing else")

    def states(self):
        return self.bodies

    def contacts(self):
        return [[c["a"], c["b"], *c["point"], *c["normal"], c["push"], c["drag"], c["gap"]] for c in self.touching]

    def step(self, dt):
        for index, _, _, _, scale, _ in self.discs:
            state = self.bodies[index]
            state[3] += scale * self.gravity[0] * dt
            state[4] += scale * self.gravity[1] * dt
        self.touching = [contact for contact in self.pairs() if contact["gap"] <= 0]
        for contact in self.touching:
            approach, _ = self.relative(contact)
            contact["bounce"] = contact["restitution"] * max(0, -approach)
        for _ in range(self.iterations):
            for contact in self.touching:
                self.solve(contact)
        for state in self.bodies:
            for k in range(3):
                state[k] += state[k + 3] * dt

    def pairs(self):
        for i, (index, radius, *_, surface) in enumerate(self.discs):
            x, y = self.bodies[index][:2]
            for wall, nx, ny, offset, other in self.walls:
                gap = nx * x + ny * y - offset - radius
                yield self.contact(wall, index, [x - nx * radius, y - ny * radius], [nx, ny], gap, other, surface)
            for far, reach, *_, other in self.discs[i + 1:]:
                dx, dy = self.bodies[far][0] - x, self.bodies[far][1] - y
                apart = math.hypot(dx, dy) or 1
                normal = [dx / apart, dy / apart]
                point = [x + normal[0] * radius, y + normal[1] * radius]
                yield self.contact(index, far, point, normal, apart - radius - reach, surface, other)

    def contact(self, a, b, point, normal, gap, one, other):
        rules = {"geometric": lambda p, q: math.sqrt(p * q), "pythagorean": math.hypot, "max": max, "min": min,
                 "average": lambda p, q: (p + q) / 2, "multiply": lambda p, q: p * q}
        return {"a": a, "b": b, "point": point, "normal": normal, "gap": gap, "push": 0, "drag": 0,
                "friction": rules[self.mixing.get("friction", "geometric")](one[0], other[0]),
                "restitution": rules[self.mixing.get("restitution", "max")](one[1], other[1])}

    def moved_by(self, contact):
        """Of both bodies: state, sign of the impulse, arm, inverse mass and inertia."""
        known = {disc[0]: disc for disc in self.discs}
        for body, sign in ((contact["a"], -1), (contact["b"], 1)):
            state, disc = self.bodies[body], known.get(body)
            arm = (contact["point"][0] - state[0], contact["point"][1] - state[1])
            yield state, sign, arm, disc[2] if disc else 0, disc[3] if disc else 0

    def relative(self, contact):
        nx, ny = contact["normal"]
        normal = tangent = 0
        for state, sign, (rx, ry), _, _ in self.moved_by(contact):
            vx, vy = state[3] - state[5] * ry, state[4] + state[5] * rx
            normal += sign * (vx * nx + vy * ny)
            tangent += sign * (-vx * ny + vy * nx)
        return normal, tangent

    def solve(self, contact):
        nx, ny = contact["normal"]
        masses = list(self.moved_by(contact))
        normal, _ = self.relative(contact)
        push = max(0, contact["push"] - (normal - contact["bounce"]) / sum(
            m + i * (r[0] * ny - r[1] * nx) ** 2 for _, _, r, m, i in masses))
        self.apply(masses, (push - contact["push"]) * nx, (push - contact["push"]) * ny)
        contact["push"] = push
        _, tangent = self.relative(contact)
        most = contact["friction"] * push
        drag = contact["drag"] - tangent / sum(m + i * (r[0] * nx + r[1] * ny) ** 2 for _, _, r, m, i in masses)
        drag = min(most, max(-most, drag))
        self.apply(masses, -(drag - contact["drag"]) * ny, (drag - contact["drag"]) * nx)
        contact["drag"] = drag

    @staticmethod
    def apply(masses, px, py):
        for state, sign, (rx, ry), inverse_mass, inverse_inertia in masses:
            state[3] += sign * px * inverse_mass
            state[4] += sign * py * inverse_mass
            state[5] += sign * (rx * py - ry * px) * inverse_inertia


def stepping(options, dt):
    return {"arithmetic": "double", "drift": 0.5, "order": 1, "orderInContact": 1,
            "iterations": int(options["iterations"]), "wholeImpulses": True}


serve({"name": "example-py", "version": "1", "about": "sequential impulses for discs on a floor",
       "options": [{"key": "iterations", "value": str(ITERATIONS), "about": "of the solver", "min": 1, "max": 10000,
                    "whole": True, "ladder": ["5", "10", "20", "40"]}]},
      stepping, World)
