#include "harness/commands/command_line.hpp"

int main(int argc, char** argv) { return signorini::run_command_line(argc, argv); }
