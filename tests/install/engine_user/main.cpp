// Runs a case through the installed library: engine_user CASE.json FOLDER.

#include <cstdio>

#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/run.hpp"

int main(int, char** arguments) {
  const shoreline::Summary summary =
      shoreline::run(shoreline::read_case(arguments[1]), {.output = arguments[2], .quiet = true});
  std::printf("completed %d, steps %d\n", summary.completed, summary.steps);
}
