#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/report.h"

/// What the texts of a report (console, Markdown, JUnit) share: a row for each engine and each case, and checks in
/// words.
namespace plumb {

/// The shares of its scale within which checks are counted.
inline constexpr std::array<double, 4> grades{0.1, 0.01, 0.001, 0.0001};

/// One engine over all cases, by both rulers.
struct EngineSummary {
  std::string engine;                       // label, see label_of
  std::map<Verdict, int> verdicts;          // how many cases
  int checks = 0;                           // reported checks against the truth
  int laws = 0;                             // invariants that the runs met, see not_tests
  int untested = 0;                         // checks that are not a test
  int untested_laws = 0;                    // the same of invariants
  std::array<int, grades.size()> within{};  // those whose relative error is at most each grade
};

/// Every engine that is not a closed form, in the order of their first runs.
std::vector<EngineSummary> engine_summaries(const Report&);

/// One engine and one metamorphic relation over all cases.
struct RelationSummary {
  std::string engine;    // label
  std::string relation;  // "mirror"
  int cases = 0;         // in which it applies
  int alike = 0;         // whose image moves alike within `relation_grade` of scale
  int broken = 0;
};

/// The share of scale within which a scene and its image count as alike.
inline constexpr double relation_grade = 1e-4;

/// Every engine with every relation that applies to one of its runs; none if relations were not checked.
std::vector<RelationSummary> relation_summaries(const Report&);

/// "97 %", rounded down: 100 % means all. "-" of none.
std::string share_of(int part, int whole);

/// Two labels of engines.
struct Pair {
  std::string a, b;
};

/// Of the engines with a comparison of runs that reached their end, the first and Box2D or, without it, the second;
/// nullopt if there are no two.
std::optional<Pair> first_pair(const Report&);

/// The comparisons of two engines, one a case.
std::vector<const Comparison*> comparisons_of(const Report&, const Pair&);

/// A ratio in percent as short_number, without the sign; "-" if it is not finite.
std::string percent(double ratio);

/// At least two digits: "0.12", "250", "3e-07"; "-" for nullopt.
std::string short_number(const std::optional<double>&);

/// "impulse and box2d are within 1 % of the scene's energy in 60 of 97 cases. ..."
std::string in_one_sentence(const Pair&, const std::vector<const Comparison*>&);

/// "y of box at 1 s: 4.9, expected 5 +- .01 m, off by 2 % of scale".
std::string in_words(const TruthCheck&);

/// Of a broken one: "breaks energy at 0.4 s: 2.4, tolerance .01 J (240 times)".
std::string in_words(const InvariantCheck&);

}  // namespace plumb
