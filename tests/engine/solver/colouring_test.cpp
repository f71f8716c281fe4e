#include "solver/colouring.h"

#include <gtest/gtest.h>

#include <set>

#include "contact_graph.h"

namespace impulse::inline IMPULSE_PRECISION::colouring_test {

namespace {

/// Each contact once, and no pushable body twice in a batch.
void expect_sound(const Colouring& colouring, const Graph& graph) {
  std::set<std::uint32_t> seen;
  for (const LanesRun& run : colouring.runs()) {
    std::set<std::uint32_t> pushed;
    const std::size_t first = std::size_t{8} * run.begin;
    for (const Slot& slot : colouring.lanes(run.kind).subspan(first, std::size_t{8} * run.end - first)) {
      if (slot.tie.contact == Slot::empty) continue;
      EXPECT_TRUE(seen.insert(slot.tie.contact).second);
      if (slot.tie.pushes_a) {
        EXPECT_TRUE(pushed.insert(slot.tie.a).second) << slot.tie.a;
      }
      if (slot.tie.pushes_b) {
        EXPECT_TRUE(pushed.insert(slot.tie.b).second) << slot.tie.b;
      }
    }
  }
  EXPECT_EQ(seen.size(), graph.contacts().size());
}

TEST(Colouring, NeverSolvesTwoContactsOfABodyAtOnce) {
  Graph graph(60);
  for (std::uint32_t a = 0; a < 60; ++a) {
    for (std::uint32_t b = a + 1; b < 60; b += 1 + (a * b) % 7) graph.touch(a, b, 1 + static_cast<int>((a + b) % 2));
  }
  expect_sound(graph.colour(), graph);
}

TEST(Colouring, SolvesContactsWithFixedShapesLast) {
  Graph graph(12);
  for (std::uint32_t i = 1; i < 12; ++i) graph.touch(0, i, 2);
  for (std::uint32_t i = 1; i < 11; ++i) graph.touch(i, i + 1, 2);
  const Colouring& colouring = graph.colour();
  expect_sound(colouring, graph);
  const LanesRun& last = colouring.runs().back();
  const std::size_t first = std::size_t{8} * last.begin;
  for (const Slot& slot : colouring.lanes(last.kind).subspan(first, std::size_t{8} * last.end - first)) {
    EXPECT_TRUE(slot.tie.contact == Slot::empty || slot.tie.a == 0);
  }
}

TEST(Colouring, GivesContactsOfAHighDegreeBodyLanesOfTheirOwn) {
  Graph graph(202);
  for (std::uint32_t i = 2; i < 202; ++i) graph.touch(1, i, 1);
  const Colouring& colouring = graph.colour();
  expect_sound(colouring, graph);
  EXPECT_EQ(colouring.runs().size(), 200U);
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::colouring_test
