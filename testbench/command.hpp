// The command line of glint-cosim.
#pragma once

namespace glint::testbench {

/// All that the program does, with the units that it is linked with. Returns the exit status.
int run_cosim(int argc, char** argv);

}  // namespace glint::testbench
