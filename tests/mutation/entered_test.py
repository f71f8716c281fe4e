#!/usr/bin/env python3
import collections
import tempfile
import types
import unittest
from pathlib import Path

from entered import Counts, enters, function_around, name_around, objects_with
from places import Place

SOURCE = """// 1
constexpr int limit = 2;

int World::step(int n) {
  return n;
}
World::World()
    : n_(1) {}
constexpr int twice(int n) {
  return 2 * n;
}
int outer() {
  const auto inner = [] {
    return 1;
  };
  return inner();
}
"""


def place(line):
    return Place("src/a.cpp", line, "sign", "", "")


class Functions(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = types.SimpleNamespace(engine=Path(folder.name))
        (self.build.engine / "src").mkdir()
        (self.build.engine / "src/a.cpp").write_text(SOURCE)
        self.counts = Counts.__new__(Counts)
        self.counts.functions = {"src/a.cpp": {(4, 6, "engine::World::step(int)"), (7, 8, "engine::World::World()"),
                                               (9, 11, "engine::(anonymous namespace)::twice(int)"),
                                               (12, 17, "engine::outer()"),
                                               (13, 15, "engine::outer()::{lambda()#1}::operator()() const")}}
        self.counts.objects = {"src/a.cpp": collections.defaultdict(set, {5: {"a.cpp"}, 14: {"a.cpp", "b.cpp"}})}

    def test_are_the_innermost_ones(self):
        self.assertEqual((4, 6), function_around(self.counts, self.build, place(5)))
        self.assertEqual((13, 15), function_around(self.counts, self.build, place(14)))
        self.assertEqual((12, 17), function_around(self.counts, self.build, place(16)))

    def test_do_not_count_where_what_runs_does_not_tell(self):
        for line in (2, 8, 10):  # a constant, a member's initial value, what a compiler may evaluate
            self.assertIsNone(function_around(self.counts, self.build, place(line)), line)

    def test_have_names_without_class_and_lambda(self):
        self.assertEqual(["", "step", "twice", "outer", "outer"], [name_around(self.counts, place(line))
                                                                   for line in (2, 5, 10, 14, 16)])

    def test_are_entered_if_any_of_their_lines_is(self):
        self.assertTrue(enters({"src/a.cpp": [5]}, (4, 6), place(4)))
        self.assertFalse(enters({"src/a.cpp": [5], "src/b.cpp": [13]}, (12, 17), place(13)))
        self.assertTrue(enters({}, None, place(2)), "nothing is known of a place outside of functions")

    def test_are_in_the_objects_with_their_code(self):
        users = ["a.cpp", "b.cpp", "c.cpp"]
        self.assertEqual(["a.cpp"], objects_with(self.counts, (4, 6), place(5), users))
        self.assertEqual(["a.cpp", "b.cpp"], objects_with(self.counts, (13, 15), place(14), users))
        self.assertEqual(users, objects_with(self.counts, None, place(2), users))


if __name__ == "__main__":
    unittest.main()
