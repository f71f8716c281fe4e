// The program `plumb` with an injected delay in our engine: tests/timing_gate.sh compares it with `plumb`.

#include "reports/cli/program.h"
#include "tests/timing/injected_delay.h"

int main(int argc, char** argv) {
  plumb::delay_engine("impulse");
  return plumb::program({argv + 1, argv + argc});
}
