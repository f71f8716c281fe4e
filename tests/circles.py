#!/usr/bin/env python3
"""Fails on circles of includes: between units, a header and the source of its name, and between rooms, which are folders.
Lanes belong to the room of the kernels' callers."""
import os
import re
import subprocess
import sys

ROOTS = {"engine": ["engine", "engine/src", "engine/include"]}  # where else a file's includes are searched


def files():
    listed = subprocess.run(["git", "ls-files", "*.cpp", "*.h"], capture_output=True, text=True, check=True).stdout
    return [file for file in listed.split() if os.path.exists(file)]


def includes(file, known):
    """The files of the repository that a file includes."""
    with open(file, encoding="utf-8") as source:
        named = re.findall(r'^#include ["<](.+?)[">]', source.read(), re.MULTILINE)
    places = [os.path.dirname(file), "."] + ROOTS.get(file.split("/")[0], [])
    for name in named:
        found = (os.path.normpath(os.path.join(place, name)) for place in places)
        yield from (path for path in [next((path for path in found if path in known), None)] if path)


def room_of(file):
    return os.path.dirname(file).removesuffix("/lanes")


def circles(edges):
    """The sets of nodes that reach each other (Tarjan's algorithm)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for to in sorted(edges[node]):
            if to not in index:
                visit(to)
                low[node] = min(low[node], low[to])
            elif to in stack:
                low[node] = min(low[node], index[to])
        if low[node] == index[node]:
            circle = [stack.pop()]
            while circle[-1] != node:
                circle.append(stack.pop())
            if len(circle) > 1:
                found.append(sorted(circle))

    for node in sorted(edges):
        if node not in index:
            visit(node)
    return found


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    sys.setrecursionlimit(10000)
    known = set(files())
    failed = False
    for what, part_of in (("units", lambda file: os.path.splitext(file)[0]), ("rooms", room_of)):
        edges = {part_of(file): {} for file in known}
        for file in sorted(known):
            for included in includes(file, known):
                if part_of(included) != part_of(file):
                    edges[part_of(file)].setdefault(part_of(included), f"{file} includes {included}")
        for circle in circles(edges):
            failed = True
            print(f"{what} that include each other: {', '.join(circle)}")
            for node in circle:
                for to in sorted(set(circle) & set(edges[node])):
                    print(f"  {edges[node][to]}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
