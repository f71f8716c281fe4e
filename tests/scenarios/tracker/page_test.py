"""What scenarios/tracker/page.py says of runs: python3 page_test.py FOLDER_OF_PAGE."""
import sys
import unittest

sys.path.insert(0, sys.argv.pop(1))
import page  # noqa: E402


def run(*truth, laws=(), status="ok"):
    return {"status": status, "truth": list(truth),
            "invariants": [{"name": name, "status": "broken", "ratio": ratio} for name, ratio in laws]}


def truth(measured, passed, quantity="y"):
    return {"quantity": quantity, "measured": measured, "expected": 1, "tolerance": 0.1, "passed": passed}


RIGHT = run(truth(1, True))
WRONG = run(truth(-2, False), truth(1.5, False, "vx"))
BROKEN = run(truth(1, True), laws=[("energy", 2), ("free_motion", 3)])


class Page(unittest.TestCase):
    def test_a_cell_says_the_worst_value_that_was_missed(self):
        self.assertEqual(page.cell(WRONG), "**y −2**, not 1 m")

    def test_a_cell_names_the_law_that_is_broken_most_where_nothing_stated_was_missed(self):
        self.assertEqual(page.cell(BROKEN), "(free motion)")

    def test_a_cell_tells_apart_what_did_not_run(self):
        self.assertEqual(page.cell(run(status="not supported")), "n/s")
        self.assertEqual(page.cell(run(status="failed")), "failed")
        self.assertEqual(page.cell(RIGHT), "–")

    def test_a_report_is_reproduced_if_an_engine_of_its_line_misses_what_was_expected(self):
        self.assertEqual(page.state("planck-1-x", {"planck": WRONG, "box2d": RIGHT}), "*reproduced*")
        self.assertEqual(page.state("box2d-1-x", {"planck": RIGHT, "box2d3-wasm": WRONG}), "*reproduced*")

    def test_a_report_is_gone_only_if_its_line_breaks_no_law_either(self):
        self.assertEqual(page.state("planck-1-x", {"planck": RIGHT, "box2d": WRONG}), "*gone*; in another")
        self.assertEqual(page.state("planck-1-x", {"planck": BROKEN, "box2d": RIGHT}), "*another law*")

    def test_a_report_about_an_engine_that_is_not_here_counts_the_others(self):
        self.assertEqual(page.state("godot-1-x", {"planck": WRONG, "box2d": WRONG}), "*reproduced* in 2")
        self.assertEqual(page.state("godot-1-x", {"planck": RIGHT, "box2d": BROKEN}), "*not reproduced*")
        self.assertEqual(page.state("matter-1-x", {"matter": run(status="not supported")}), "*not reproduced*")


if __name__ == "__main__":
    unittest.main()
