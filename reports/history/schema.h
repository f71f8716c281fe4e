#pragma once

#include "reports/history/database.h"

namespace plumb {

/// A file that holds a history, of the newest version, whatever version it was of. Nothing is written to a file that is
/// not one, that is damaged or that a newer Plumb wrote: it is refused by a std::invalid_argument that says so.
Database open_history(const std::filesystem::path&, Database::Missing);

}  // namespace plumb
