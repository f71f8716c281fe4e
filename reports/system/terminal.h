#pragma once

#include <string>

/// Talking to the user while a program runs.
namespace plumb {

/// One line on standard error that is overwritten again and again and removed at the end. Only on a terminal.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const std::string& text) const;

 private:
  void clear() const;
  bool terminal_;
};

/// While an object of this class exists, Ctrl-C and a scheduler's SIGTERM set a flag instead of ending the program.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  static bool raised();

 private:
  using Handler = void (*)(int);
  Handler on_int_, on_term_;
};

}  // namespace plumb
