#pragma once

namespace plumb {

/// While one lives, Ctrl-C and a scheduler's SIGTERM no longer end the program but are remembered.
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
