#pragma once

#include <string>
#include <vector>

#include "reports/history/trends.h"

/// What the console is told of a history.
namespace plumb {

/// "2026-11-21 04574af1c2", the moment's date and as much of the commit as tells it.
std::string short_name(const SnapshotHead&);

std::string text_of(const std::vector<SnapshotHead>&);

/// All changes, the newest first, the largest of each snapshot first.
std::string text_of(const std::vector<SnapshotHead>&, const std::vector<Trend>&, const std::vector<VerdictChange>&);

/// Each trend with its course and its changes.
std::string courses(const std::vector<SnapshotHead>&, const std::vector<Trend>&);

}  // namespace plumb
