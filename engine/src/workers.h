#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A fixed number of threads, the calling one included, that share out independent pieces of work. Which thread takes
/// which piece is left to chance, so pieces may write only what is theirs alone; then the bits never depend on the
/// number of threads.
class Workers {
 public:
  explicit Workers(int count);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(piece, worker) for every piece in 0 ... pieces - 1, worker in 0 ... count() - 1, and returns when all
  /// are done. The first exception thrown by a piece is thrown on.
  using Work = std::function<void(std::size_t piece, std::size_t worker)>;
  void share_out(std::size_t pieces, const Work& work);

 private:
  void serve(std::size_t worker);
  void take_pieces(std::size_t worker);

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable start_;
  std::condition_variable finish_;
  const Work* work_ = nullptr;
  std::size_t pieces_ = 0;
  std::size_t next_ = 0;
  std::size_t busy_ = 0;   // threads that have not finished this round
  std::size_t round_ = 0;  // counts calls of share_out
  bool stopping_ = false;
  std::exception_ptr failure_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
