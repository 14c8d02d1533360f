// The command line: one case in, results and a report out. Status 0 done, 1 failed, 2 wrong input, 3 cannot write.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "case_file/nearest.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/report.hpp"
#include "shoreline/engine/run.hpp"
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
};

std::vector<std::string> overrides_of(const Arguments& arguments) {
  std::vector<std::string> overrides = arguments.overrides;
  if (arguments.threads) overrides.push_back("solver.threads=" + std::to_string(*arguments.threads));
  return overrides;
}

void run_case(const Arguments& arguments) {
  const shoreline::Case problem = shoreline::read_case(arguments.file, overrides_of(arguments));
  std::filesystem::path output = arguments.output;
  if (output.empty()) output = "out" / std::filesystem::path(arguments.file).stem();
  const shoreline::Summary summary = shoreline::run(problem, {.output = output, .quiet = arguments.quiet});
  std::cout << shoreline::report(summary, output);
}

void add_case(CLI::App& command, Arguments& arguments) {
  command.add_option("CASE", arguments.file, "case file, JSON")->required();
  command
      .add_option("--set", arguments.overrides,
                  "override or add a key of the case: --set grid.cell_size=0.0625; list entries by number or name")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

void add_commands(CLI::App& app, Arguments& arguments) {
  CLI::App* run = app.add_subcommand("run", "compute a case");
  add_case(*run, arguments);
  run->add_option("--output", arguments.output, "folder of the results; default: out/<case file name>");
  run->add_option("--threads", arguments.threads, "threads; default: as the case says, else all cores");
  run->add_flag("--quiet", arguments.quiet, "no progress on a terminal");
  run->callback([&arguments] { run_case(arguments); });

  CLI::App* check = app.add_subcommand("check", "check a case and print what a run would do; runs nothing");
  add_case(*check, arguments);
  check->callback(
      [&arguments] { std::cout << shoreline::plan(shoreline::read_case(arguments.file, overrides_of(arguments))); });

  CLI::App* schema = app.add_subcommand("schema", "print the JSON Schema of a case");
  schema->add_flag("--markdown", arguments.markdown, "as the page docs/case_format.md instead");
  schema->callback(
      [&arguments] { std::cout << (arguments.markdown ? shoreline::case_format() : shoreline::case_schema()); });
}

/// CLI11 would call a misspelt command an unexpected argument.
void refuse_unknown_command(const std::vector<std::string>& words) {
  const std::vector<std::string> commands{"run", "check", "schema"};
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
