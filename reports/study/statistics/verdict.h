#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/study/statistics/ensemble.h"
#include "reports/study/statistics/interval.h"

/// What an ensemble's draws say about its statistics.
namespace plumb {

/// agrees: the interval touches the band and is narrow enough to tell. differs: it lies outside. undecided: it touches
/// the band, but is too wide.
enum class EnsembleVerdict { agrees, differs, undecided };

/// "agrees", "differs", "undecided".
const char* name_of(EnsembleVerdict);

struct EnsembleFinding {
  std::string statistic;
  bool idealisation = false;
  std::size_t draws = 0;
  Estimate interval;
  EnsembleVerdict verdict = EnsembleVerdict::undecided;
  double off = 0;          // standard errors from the value to the band; 0 within it
  std::size_t needed = 0;  // draws in all after which the interval would be narrow enough, if undecided
};

/// A finding for each statistic, and for the distribution if there is one. Each interval misses the truth with the
/// probability `miss`. Takes at least two draws.
std::vector<EnsembleFinding> judge_draws(const Ensemble&, std::span<const EnsembleDraw>, double miss);

/// The largest number of standard errors by which a statistic that is no idealisation differs; 0 if none does.
double worst_difference(std::span<const EnsembleFinding>);

}  // namespace plumb
