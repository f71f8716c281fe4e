#!/usr/bin/env python3
import json
import unittest
from pathlib import Path

from places import changes_of, places_in


def after(kind, line):
    return [changed for found, changed in changes_of(line) if found == kind]


class Changes(unittest.TestCase):
    def test_turn_a_sign(self):
        self.assertIn("x = a - b;", after("sign", "x = a + b;"))
        self.assertIn("x -= v;", after("sign", "x += v;"))
        self.assertIn("return a;", after("sign", "return -a;"))

    def test_drop_a_term_a_factor_and_a_statement(self):
        self.assertIn("x = a;", after("dropped term", "x = a + b;"))
        self.assertIn("x = a;", after("dropped factor", "x = a * b;"))
        self.assertEqual([""], after("dropped statement", "  x += v;"))
        self.assertEqual([""], after("dropped statement", "  pile.step(data, 3);"))

    def test_move_a_bound_by_one_and_turn_a_comparison(self):
        line = "for (int i = 0; i < n; ++i) {"
        self.assertIn("for (int i = 0; i <= n; ++i) {", after("bound", line))
        self.assertIn("for (int i = 1; i < n; ++i) {", after("bound", line))
        self.assertIn("for (int i = 0; i > n; ++i) {", after("comparison", line))

    def test_take_the_wrong_element_or_operand(self):
        self.assertIn("f(a[i + 1]);", after("index", "f(a[i]);"))
        self.assertIn("x = v.y;", after("swapped operand", "x = v.x;"))
        self.assertIn("x = cross(b, a);", after("swapped operand", "x = cross(a, b);"))
        self.assertIn("x = b - a;", after("swapped operand", "x = a - b;"))

    def test_let_operands_be_that_commute(self):
        for line in ("x = std::max(a, b);", "x = min(a, b);", "x = dot(a, b);"):
            self.assertEqual([], after("swapped operand", line))

    def test_set_a_constant_off_by_two_percent(self):
        self.assertIn("constexpr Real deep = 0.0051;", after("constant", "constexpr Real deep = 0.005;"))

    def test_keep_comments(self):
        self.assertIn("x = a - b;  // m + m", after("sign", "x = a + b;  // m + m"))
        self.assertEqual([], changes_of("// x = a + b;"))

    def test_leave_alone_what_no_valid_scene_reaches(self):
        for line in ("check_def(def);", "require(id);", '#include "a + b"', "static_assert(a < b);", "template <int a = 1 + 1>", 'say("a + b");',
                     "Lanes impulses[4];", "const Real* at[lane_count];", "Real separation[2][lane_count];",
                     "constexpr Bin bin_of[3][3] = {"):
            self.assertEqual([], changes_of(line), line)
        self.assertEqual([], places_in("a.cpp", "  if (a < b) {\n    throw 1;\n  }"))
        self.assertEqual([], places_in("a.cpp", "  if (a < 0)\n    refuse_force(\"negative\");"))

    def test_leave_declarations_alone(self):
        self.assertEqual([], changes_of("std::vector<Contact> contacts;"))


class Places(unittest.TestCase):
    def test_say_where_they_are(self):
        (places,) = places_in("a.cpp", "void f() {\n  x = a + b;\n}")
        self.assertEqual({("a.cpp", 2)}, {(place.file, place.line) for place in places})
        self.assertTrue(all(place.before == "  x = a + b;" != place.after for place in places))


class Equivalents(unittest.TestCase):
    def test_are_mistakes_that_can_still_be_drawn(self):
        here = Path(__file__).parent
        for one in json.loads((here / "equivalent.json").read_text()):
            text = (here.parents[1] / "engine" / one["file"]).read_text()
            drawn = {(place.before.strip(), place.after.strip())
                     for places in places_in(one["file"], text) for place in places}
            self.assertIn((one["before"], one["after"]), drawn, one["file"])
            self.assertTrue(one["why"])


if __name__ == "__main__":
    unittest.main()
