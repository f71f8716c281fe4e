#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A fixed number of threads, including the calling one, that share independent pieces of work. Which thread takes
/// which piece is not deterministic, so each piece may write only data of its own; then the bits never depend on the
/// number of threads.
///
/// An idle thread spins for some microseconds, then yields a few times, then sleeps. Nobody waits for a thread that has
/// taken no piece: if the machine is busy and the other threads don't get to run, the caller does all the work.
class Workers {
 public:
  explicit Workers(int count);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(piece, worker) for every piece in 0 ... pieces - 1, with worker in 0 ... count() - 1, and returns when
  /// all are done. Rethrows the first exception thrown by a piece. Throws std::invalid_argument for more than
  /// 2^32 - 1 pieces.
  using Work = std::function<void(std::size_t piece, std::size_t worker)>;
  void share_out(std::size_t pieces, const Work& work);

 private:
  void serve(std::size_t worker);
  bool take_piece(std::size_t worker);
  void give_out(std::uint32_t pieces);

  std::vector<std::thread> threads_;
  // Describe the current round; only threads that hold one of its pieces may read them.
  const Work* work_ = nullptr;
  std::uint32_t pieces_ = 0;

  // On separate cache lines, because all threads write to each.
  static constexpr std::size_t cache_line = 64;
  /// High half: counts calls of share_out, so that a late thread cannot confuse two rounds. Low half: the number of
  /// pieces not taken yet.
  alignas(cache_line) std::atomic<std::uint64_t> round_ = 0;
  alignas(cache_line) std::atomic<std::uint32_t> unfinished_ = 0;  // pieces
  std::atomic<bool> stopping_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;  // guarded by the mutex
};

}  // namespace impulse::inline IMPULSE_PRECISION
