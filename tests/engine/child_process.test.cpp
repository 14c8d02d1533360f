// Children that end in every way, engine/src/study/child_process.hpp.

#include "study/child_process.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>

#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::OutputFolder;

namespace {

ChildOutcome shell(const std::string& script, const Limits& limits = {}) {
  const OutputFolder folder;
  return run_child({"/bin/sh", "-c", script}, folder.path / "complaint", limits);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("a child succeeds if and only if it ends with status 0", "[engine][study][child]") {
  const Limits limits = GENERATE(Limits{}, Limits{60.0, 1e12});
  const ChildOutcome good = shell("sleep 0.05; echo unheard", limits);
  CHECK(good.succeeded);
  CHECK(good.reason.empty());
  CHECK(good.seconds >= 0.05);
  const ChildOutcome bad = shell("exit 3", limits);
  CHECK_FALSE(bad.succeeded);
  CHECK(bad.reason == "ended with status 3 and without a message");
}

TEST_CASE("a child that complains is quoted by its first line, without the name of the program",
          "[engine][study][child]") {
  CHECK(shell("echo 'shoreline: /grid: found 9' >&2; echo more >&2; exit 2").reason == "/grid: found 9");
  CHECK(shell("echo 'other: words' >&2; exit 1").reason == "other: words");
  CHECK(shell("echo 'only a warning' >&2").reason.empty());
}

TEST_CASE("a child that a signal ends is told by the signal", "[engine][study][child]") {
  const ChildOutcome crashed = shell("kill -SEGV $$");
  CHECK_FALSE(crashed.succeeded);
  CHECK_THAT(crashed.reason, Contains("signal 11") && !Contains("memory"));
  CHECK_THAT(shell("kill -KILL $$").reason, Contains("signal 9") && Contains("out of memory"));
}

TEST_CASE("a child that meets its limit of time is ended there", "[engine][study][child]") {
  const auto start = std::chrono::steady_clock::now();
  const ChildOutcome outcome = shell("exec sleep 60", {.seconds = 0.2, .memory = {}});
  CHECK_FALSE(outcome.succeeded);
  CHECK(outcome.reason == "took longer than budget.seconds, 0.2 s");
  CHECK(outcome.seconds >= 0.2);
  CHECK(seconds_since(start) < 30.0);
}

TEST_CASE("a child that meets its limit of memory is ended there, and one below is not", "[engine][study][child]") {
  const std::string doubles_for_ever = "x=aaaaaaaaaaaaaaaa; while :; do x=$x$x; done";
  const ChildOutcome outcome = shell(doubles_for_ever, {.seconds = 30.0, .memory = 5e7});
  CHECK_FALSE(outcome.succeeded);
  CHECK(outcome.reason == "took more memory than budget.memory, 5e+07 bytes");
  CHECK(shell("sleep 0.05", {.seconds = {}, .memory = 5e7}).succeeded);
}

TEST_CASE("what the parent holds does not count as the child's", "[engine][study][child]") {
  const std::vector<double> held(50'000'000, 1.0);
  CHECK(shell("sleep 0.02", {.seconds = {}, .memory = 1e8}).reason.empty());
  CHECK(held.back() == 1.0);
}

TEST_CASE("what cannot be started or written is told", "[engine][study][child]") {
  const OutputFolder folder;
  CHECK_THAT(run_child({"/no/such/program"}, folder.path / "complaint", {}).reason, Contains("127"));
  CHECK_THROWS_AS(static_cast<void>(run_child({"/bin/true"}, folder.path / "no" / "complaint", {})), OutputError);
}

TEST_CASE("a child before leaves no word to the next", "[engine][study][child]") {
  const OutputFolder folder;
  std::ofstream(folder.path / "complaint") << "of a run before\n";
  CHECK_THAT(run_child({"/bin/false"}, folder.path / "complaint", {}).reason, Contains("without a message"));
}

TEST_CASE("a child whose end nobody keeps has not succeeded", "[engine][study][child]") {
  const auto before = std::signal(SIGCHLD, SIG_IGN);  // as a service may start its programs
  const ChildOutcome outcome = shell("exit 3");
  std::signal(SIGCHLD, before);
  CHECK_FALSE(outcome.succeeded);
}
