// glint-cosim: the Verilog, run by Verilator, against the golden model.
#include "command.hpp"

int main(int argc, char** argv) { return glint::testbench::run_cosim(argc, argv); }
