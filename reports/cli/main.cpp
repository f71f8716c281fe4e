#include "reports/cli/program.h"

int main(int argc, char** argv) { return plumb::program({argv + 1, argv + argc}); }
