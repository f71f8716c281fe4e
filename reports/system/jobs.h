#pragma once

#include <cstddef>
#include <functional>

namespace plumb {

/// Calls work(0) ... work(count - 1) once each, started in that order, up to `jobs` at a time. Returns when all are
/// done. If any threw, rethrows the exception of the lowest index after all have finished.
void do_all(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// The number of hardware threads, at least 1.
int default_jobs();

}  // namespace plumb
