#include "shoreline/engine/study.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::OutputFolder;
using Json = nlohmann::json;

namespace {

std::string text_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A study of two runs by a program that complains and fails, and counts its calls.
struct Failing {
  OutputFolder folder;
  Study study;
  StudyOptions options;

  explicit Failing(const std::string& complaint) {
    std::ofstream(folder.path / "case.json") << R"({"title": "a case"})";
    std::ofstream(folder.path / "study.json")
        << R"({"case": "case.json", "sweep": [{"key": "ghost", "values": [1, 2]}]})";
    const std::filesystem::path program = folder.path / "program";
    std::ofstream(program) << "#!/bin/sh\necho call >> '" << (folder.path / "calls").string() << "'\nprintf '"
                           << complaint << "\\n' >&2\nexit 1\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    study = read_study(folder.path / "study.json");
    options = {.output = folder.path / "out", .program = program, .quiet = true};
  }

  /// How often the program was called by a study more.
  std::size_t calls() {
    std::filesystem::remove(folder.path / "calls");
    static_cast<void>(run_study(study, options));
    const std::string text = std::filesystem::exists(folder.path / "calls") ? text_of(folder.path / "calls") : "";
    return text.size() / std::string("call\n").size();
  }
};

}  // namespace

TEST_CASE("runs that fail are rows with their reasons, in every file of the study", "[engine][study]") {
  Failing failing("shoreline: it is broken");
  failing.options.tolerance = Tolerance{"stress.l2_relative", 0.1};  // cannot be asked of no run
  const StudyOutcome outcome = run_study(failing.study, failing.options);
  CHECK(outcome.runs == 2);
  CHECK(outcome.failures == 2);
  CHECK_THAT(outcome.report, Contains("2 runs, 2 failed") && Contains("failed: 2: it is broken"));
  const Json json = Json::parse(text_of(failing.options.output / "study.json"));
  CHECK(json["rows"][1]["reason"] == "it is broken");
  CHECK_THAT(text_of(failing.options.output / "study.csv"), Contains("failed,it is broken"));
  CHECK_THAT(text_of(failing.options.output / "study.md"), Contains("| 2 | failed |"));
}

TEST_CASE("what is on record is not run again, what has changed is", "[engine][study]") {
  Failing failing("broken");
  CHECK(failing.calls() == 1 + 2);  // one beforehand, for a warm machine
  CHECK(failing.calls() == 0);
  failing.study.axes[0].choices[1].settings = {"ghost=3"};
  CHECK(failing.calls() == 1 + 1);
  failing.study.seconds = 100.0;  // what failed may do so no more
  CHECK(failing.calls() == 1 + 2);
}

TEST_CASE("a complaint that is no text does not end the study", "[engine][study]") {
  Failing failing("found \\377\\330 in a mesh");
  CHECK(run_study(failing.study, failing.options).failures == 2);
  CHECK_THAT(Json::parse(text_of(failing.options.output / "study.json"))["rows"][0]["reason"].get<std::string>(),
             Contains("in a mesh"));
  CHECK(failing.calls() == 0);  // its record can be read
}

TEST_CASE("a folder that another study holds, or that is none, is refused", "[engine][study]") {
  Failing failing("broken");
  std::filesystem::create_directories(failing.options.output / "runs");
  const int lock = open((failing.options.output / "runs" / "lock").c_str(), O_RDWR | O_CREAT, 0644);
  flock(lock, LOCK_EX);
  CHECK_THROWS_AS(run_study(failing.study, failing.options), OutputError);
  CHECK_THROWS_WITH(run_study(failing.study, failing.options), Contains("another study writes there"));
  close(lock);
  failing.options.output = failing.folder.path / "case.json";
  CHECK_THROWS_AS(run_study(failing.study, failing.options), OutputError);
}

TEST_CASE("a wrong table of another program is refused before anything is run or written", "[engine][study]") {
  Failing failing("broken");
  failing.study.outside = {failing.folder.path / "missing.csv"};
  CHECK_THROWS_AS(run_study(failing.study, failing.options), CaseError);
  CHECK_FALSE(std::filesystem::exists(failing.options.output));
  CHECK_FALSE(std::filesystem::exists(failing.folder.path / "calls"));
}

TEST_CASE("schema and page of a study tell the same keys", "[engine][study]") {
  const Json schema = Json::parse(study_schema());
  const std::string page = study_format();
  CHECK(page.starts_with("# The study file\n"));
  CHECK(schema["properties"].size() >= 11);
  for (const auto& [key, value] : schema["properties"].items()) CHECK_THAT(page, Contains("| `" + key + "` |"));
}
