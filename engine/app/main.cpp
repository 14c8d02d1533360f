// The command line: one case in, results and a report out. Status 0 done, 1 failed, 2 wrong input, 3 cannot write.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "case_file/nearest.hpp"
#include "heap.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/report.hpp"
#include "shoreline/engine/run.hpp"
#include "shoreline/engine/study.hpp"
#include "shoreline/engine/version.hpp"

namespace {

enum Status { done = 0, failed = 1, wrong_input = 2, cannot_write = 3 };

struct Arguments {
  std::string file;
  std::string output;
  std::vector<std::string> overrides;
  std::optional<int> threads;
  bool quiet = false;
  bool markdown = false;
  bool study = false;
  std::optional<shoreline::Tolerance> tolerance;
};

std::vector<std::string> overrides_of(const Arguments& arguments) {
  std::vector<std::string> overrides = arguments.overrides;
  if (arguments.threads) overrides.push_back("solver.threads=" + std::to_string(*arguments.threads));
  return overrides;
}

std::filesystem::path output_of(const Arguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return "out" / std::filesystem::path(arguments.file).stem();
}

void tell_blas() {
  const shoreline::Blas blas = shoreline::blas_at_work();
  std::cerr << (blas.reference ? "shoreline: warning: slow BLAS: " : "BLAS: ") << blas.name << '\n';
}

void run_case(const Arguments& arguments) {
  shoreline::count_heap();
  const shoreline::Case problem = shoreline::read_case(arguments.file, overrides_of(arguments));
  if (!arguments.quiet) tell_blas();
  const std::filesystem::path output = output_of(arguments);
  const shoreline::Summary summary = shoreline::run(problem, {.output = output, .quiet = arguments.quiet});
  std::cout << shoreline::report(summary, output);
}

/// Status 1 where no run completed.
void run_study(const Arguments& arguments) {
  // threads of the runs sleep where they wait, unless the user has said otherwise: spinning ones disturb the clock
  setenv("OMP_WAIT_POLICY", "passive", 0);
  setenv("OPENBLAS_THREAD_TIMEOUT", "4", 0);
  constexpr int most_threads = 1024;
  if (arguments.threads && (*arguments.threads < 0 || *arguments.threads > most_threads))
    throw CLI::ValidationError("--threads", "found " + std::to_string(*arguments.threads) +
                                                ", expected a whole number from 0 to " + std::to_string(most_threads));
  const shoreline::Study study = shoreline::read_study(arguments.file);
  const shoreline::StudyOutcome outcome = shoreline::run_study(study, {.output = output_of(arguments),
                                                                       .program = "/proc/self/exe",
                                                                       .threads = arguments.threads,
                                                                       .quiet = arguments.quiet,
                                                                       .tolerance = arguments.tolerance});
  std::cout << outcome.report;
  if (outcome.failures == outcome.runs)
    throw shoreline::ComputationError("all runs of the study failed; the table above says why");
}

/// NORM=VALUE
shoreline::Tolerance tolerance_in(const std::string& text) {
  const std::size_t equals = text.find('=');
  double value = 0.0;
  const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (equals == 0 || error != std::errc() || end != number.data() + number.size() || !(value > 0.0))
    throw CLI::ValidationError("--tolerance",
                               "found \"" + text + "\", expected NORM=VALUE like stress.l2_relative=1e-2, a value > 0");
  return {text.substr(0, equals), value};
}

void add_output(CLI::App& command, Arguments& arguments) {
  command.add_option("--output", arguments.output, "folder of the results; default: out/<file name>");
  command.add_option("--threads", arguments.threads, "threads; default: as the file says, else all cores");
  command.add_flag("--quiet", arguments.quiet, "no progress");
}

void add_case(CLI::App& command, Arguments& arguments) {
  command.add_option("CASE", arguments.file, "case file, JSON")->required();
  command
      .add_option("--set", arguments.overrides,
                  "override or add a key of the case: --set grid.cell_size=0.0625; list entries by number or name")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

std::string schema_text(const Arguments& arguments) {
  if (arguments.study) return arguments.markdown ? shoreline::study_format() : shoreline::study_schema();
  return arguments.markdown ? shoreline::case_format() : shoreline::case_schema();
}

void add_commands(CLI::App& app, Arguments& arguments) {
  CLI::App* run = app.add_subcommand("run", "compute a case");
  add_case(*run, arguments);
  add_output(*run, arguments);
  run->callback([&arguments] { run_case(arguments); });

  CLI::App* check = app.add_subcommand("check", "check a case and print what a run would do; runs nothing");
  add_case(*check, arguments);
  check->callback(
      [&arguments] { std::cout << shoreline::plan(shoreline::read_case(arguments.file, overrides_of(arguments))); });

  CLI::App* study = app.add_subcommand("study", "run a case over sweeps of its keys: errors, rates, costs");
  study->add_option("STUDY", arguments.file, "study file, JSON")->required();
  add_output(*study, arguments);
  study
      ->add_option_function<std::string>(
          "--tolerance", [&arguments](const std::string& text) { arguments.tolerance = tolerance_in(text); },
          "name the cheapest setting that meets it: --tolerance stress.l2_relative=1e-2")
      ->type_name("NORM=VALUE");
  study->callback([&arguments] { run_study(arguments); });

  CLI::App* schema = app.add_subcommand("schema", "print the JSON Schema of a case");
  schema->add_flag("--study", arguments.study, "of a study");
  schema->add_flag("--markdown", arguments.markdown, "as the page docs/case_format.md or docs/study_format.md instead");
  schema->callback([&arguments] { std::cout << schema_text(arguments); });
}

/// CLI11 would call a misspelt command an unexpected argument.
void refuse_unknown_command(const std::vector<std::string>& words) {
  const std::vector<std::string> commands{"run", "check", "study", "schema"};
  if (words.empty())
    throw CLI::ValidationError("no command", shoreline::expected_one_of(commands, "") + "; see shoreline --help");
  const std::string& word = words.front();
  if (word[0] != '-' && !std::ranges::count(commands, word))
    throw CLI::ValidationError("unknown command \"" + word + "\"", shoreline::expected_one_of(commands, word));
}

int fail(Status status, const std::string& problem) {
  std::cerr << "shoreline: " << problem << '\n';
  return status;
}

int command_line(int argc, char** argv) {
  CLI::App app{"Shoreline: a material point method whose boundaries are cubic B-splines", "shoreline"};
  app.set_version_flag("--version", shoreline::version_report());
  app.require_subcommand(1);
  Arguments arguments;
  add_commands(app, arguments);
  try {
    refuse_unknown_command({argv + 1, argv + argc});
    app.parse(argc, argv);
    return done;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(wrong_input, error.what());
  }
}

}  // namespace

int main(int argc, char** argv) try {
  return command_line(argc, argv);
} catch (const shoreline::ComputationError& error) {
  return fail(failed, error.what());
} catch (const shoreline::OutputError& error) {
  return fail(cannot_write, error.what());
} catch (const shoreline::Error& error) {  // CaseError, and what the library calls an invalid argument or outline
  return fail(wrong_input, error.what());
} catch (const std::bad_alloc&) {
  return fail(failed, "the machine has not enough memory; take fewer points a cell, larger cells or fewer saved steps");
} catch (const std::exception& error) {
  return fail(failed, std::string("unexpected: ") + error.what());
}
