#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "reports/history/database.h"
#include "reports/history/snapshot.h"

/// The tables of a history.
namespace plumb {

/// Opens a file that holds a history and brings it to the newest version. Throws std::invalid_argument, and leaves the
/// file as it is, if it is not a history, is damaged, or was written by a newer Plumb.
Database open_history(const std::filesystem::path&, Database::Missing);

/// Reads a snapshot by the number of its row. Throws std::invalid_argument if the row is missing or damaged.
Snapshot read_snapshot(const Database&, std::int64_t number);

/// The subject in four columns of a row.
Subject subject_at(const Statement& row, int column);

/// An environment from its JSON column. Throws std::invalid_argument if it is damaged.
std::map<std::string, std::string> parse_environment(const Database&, const std::string& json);

}  // namespace plumb
