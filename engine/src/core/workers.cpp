#include "core/workers.h"

#include <limits>
#include <stdexcept>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::uint64_t one_round = std::uint64_t{1} << 32;

std::uint32_t untaken(std::uint64_t round) { return static_cast<std::uint32_t>(round % one_round); }

/// Waits until the number satisfies the condition.
template <class Number, class Enough>
void wait_for(const std::atomic<Number>& number, Enough enough) {
  constexpr int polls = 4000;
  constexpr int yields = 20;
  Number now = number.load(std::memory_order_acquire);
  for (int i = 0; i < polls + yields; ++i) {
    if (enough(now)) return;
    if (i >= polls) std::this_thread::yield();
    now = number.load(std::memory_order_acquire);
  }
  while (!enough(now)) {
    number.wait(now, std::memory_order_acquire);
    now = number.load(std::memory_order_acquire);
  }
}

}  // namespace

Workers::Workers(int count) {
  for (int i = 1; i < count; ++i) threads_.emplace_back([this, i] { serve(static_cast<std::size_t>(i)); });
}

Workers::~Workers() {
  stopping_ = true;
  give_out(1);  // no work: only wakes the threads
  for (std::thread& thread : threads_) thread.join();
}

void Workers::give_out(std::uint32_t pieces) {
  const std::uint64_t last = round_.load(std::memory_order_relaxed);
  round_.store(last - untaken(last) + one_round + pieces, std::memory_order_release);
  round_.notify_all();
}

void Workers::share_out(std::size_t pieces, const Work& work) {
  if (threads_.empty() || pieces < 2) {
    for (std::size_t piece = 0; piece < pieces; ++piece) work(piece, 0);
    return;
  }
  if (pieces > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("Workers::share_out: at most 2^32 - 1 pieces");
  }
  work_ = &work;
  pieces_ = static_cast<std::uint32_t>(pieces);
  unfinished_.store(pieces_, std::memory_order_relaxed);
  give_out(pieces_);
  while (take_piece(0)) {
  }
  wait_for(unfinished_, [](std::uint32_t left) { return left == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Workers::serve(std::size_t worker) {
  while (!stopping_) {
    if (!take_piece(worker)) wait_for(round_, [](std::uint64_t round) { return untaken(round) > 0; });
  }
}

/// Does a piece of the current round; returns false if all are taken.
bool Workers::take_piece(std::size_t worker) {
  std::uint64_t round = round_.load(std::memory_order_acquire);
  do {
    if (untaken(round) == 0 || stopping_) return false;
  } while (!round_.compare_exchange_weak(round, round - 1, std::memory_order_acquire));
  try {
    (*work_)(pieces_ - untaken(round), worker);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
  if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
