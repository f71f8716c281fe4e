#pragma once

#include <cstddef>
#include <functional>

namespace plumb {

/// Does work(0) ... work(count - 1), up to `jobs` at a time, each once, begun in that order. Returns when all are done;
/// if some threw, throws what the first of them in order threw, after the others have ended.
void do_all(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// As many jobs as this machine runs at once.
int default_jobs();

}  // namespace plumb
