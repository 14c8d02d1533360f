#include "shoreline/engine/progress.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

/// What a progress of two steps, or 2.5 s, prints when stderr is @p descriptor, read from @p reading_end up to a mark
/// written behind it: a terminal hands over what is written in portions, at its own time.
std::string printed(int descriptor, int reading_end, bool quiet, bool by_time = false) {
  const int kept = dup(STDERR_FILENO);
  dup2(descriptor, STDERR_FILENO);
  {
    Progress progress(quiet);
    if (by_time)
      progress.reach(0.0, 2.5);
    else
      progress.begin(1, 2);
  }
  fflush(stderr);
  dup2(kept, STDERR_FILENO);
  close(kept);
  REQUIRE(write(descriptor, "|", 1) == 1);
  std::string text;
  for (char c = 0; read(reading_end, &c, 1) == 1 && c != '|';) text += c;
  return text;
}

}  // namespace

TEST_CASE("the time left is the mean of the steps behind times the steps to come", "[engine][progress]") {
  CHECK(progress_line(1, 50, 0.0) == "load step 1 of 50");
  CHECK(progress_line(2, 3, 30.0) == "load step 2 of 3, 1:00 left");
  CHECK(progress_line(11, 20, 10.0) == "load step 11 of 20, 0:10 left");
  CHECK(progress_line(2, 101, 37.0) == "load step 2 of 101, 1:01:40 left");
  CHECK(progress_line(2, 3, 30.0, "step") == "step 2 of 3, 1:00 left");
}

TEST_CASE("by time, what is left goes with the time to come", "[engine][progress]") {
  CHECK(progress_line(0.0, 2.5, 0.0) == "t = 0 of 2.5 s");
  CHECK(progress_line(0.5, 2.5, 3.0) == "t = 0.5 of 2.5 s, 0:12 left");
  CHECK(progress_line(0.3125, 3.125, 400.0) == "t = 0.312 of 3.125 s, 1:00:00 left");
  CHECK(progress_line(2.5, 2.5, 3.0) == "t = 2.5 of 2.5 s, 0:00 left");
}

TEST_CASE("progress is shown on a terminal, erased at the end, and nowhere else", "[engine][progress]") {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  REQUIRE(grantpt(terminal) == 0);
  REQUIRE(unlockpt(terminal) == 0);
  const int screen = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  REQUIRE(screen >= 0);
  CHECK(printed(screen, terminal, true).empty());
  const std::string shown = printed(screen, terminal, false);
  CHECK_THAT(shown, Contains("load step 1 of 2") && EndsWith("\r\033[K"));
  CHECK_THAT(printed(screen, terminal, false, true), Contains("t = 0 of 2.5 s") && EndsWith("\r\033[K"));
  close(screen);
  close(terminal);

  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  CHECK(printed(ends[1], ends[0], false).empty());
  close(ends[0]);
  close(ends[1]);
}
