#pragma once

#include <sys/types.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plumb {

/// What a program did wrong, and the last lines that it wrote to standard error.
class ProgramFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a program may take before it is ended.
struct ProgramLimits {
  double seconds = 10;      // without a line of answer
  double mebibytes = 4096;  // of resident memory
};

/// MiB of resident memory that a process has; 0 if the system does not tell.
double resident_memory(pid_t);

/// A word of a command line, whatever is in it.
std::string quoted_for_shell(const std::string&);

/// A program that is spoken to in lines: it reads them from its standard input and answers on its standard output. It
/// runs in a process group of its own, which ends with this object. Not for use by two threads at once.
class LineProcess {
 public:
  /// Starts a command line, as `sh -c` understands it. Throws std::system_error if there is no process for it.
  explicit LineProcess(const std::string& command);
  LineProcess(const LineProcess&) = delete;
  LineProcess& operator=(const LineProcess&) = delete;
  ~LineProcess();

  /// Sends one line, while reading what the program writes. Throws ProgramFailure if it ended or is beyond its limits.
  void send(std::string_view line, const ProgramLimits&);

  /// The next line of answer, without its end, until the next call. Throws ProgramFailure if the program ended or is
  /// beyond its limits.
  std::string_view receive(const ProgramLimits&);

  /// A failure with this reason and the last lines of the program's log.
  ProgramFailure failure(const std::string& reason) const;

 private:
  using Clock = std::chrono::steady_clock;

  // Waits until something can be read or, if `text` is not empty, written; then does both. Returns what is left of it.
  std::string_view exchange(std::string_view text, const ProgramLimits&, Clock::time_point since);
  void read_answers();
  void read_log();
  [[noreturn]] void end_of_answers();

  pid_t process_ = 0;
  int in_ = -1, out_ = -1, log_ = -1;  // the program's standard input, output and error
  std::string answers_;                // room for what is read
  std::size_t filled_ = 0;             // bytes of it that were read
  std::size_t taken_ = 0;              // of them, returned
  std::size_t searched_ = 0;           // of them, beyond which an end of a line may be
  std::string last_log_;
};

}  // namespace plumb
