#include "run_record.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "case_file/text_file.hpp"
#include "output/atomic_file.hpp"
#include "quantities.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/version.hpp"

namespace shoreline {
namespace {

/// Phases that only tell of a run: what a user who wants the solution alone would not wait for.
constexpr std::array telling{"total", "output", "pictures", "errors", "probes", "diagnostics", "condition", "estimate"};

/// 64 bits of a text, FNV-1a (Fowler, Noll & Vo).
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

Json parsed_file(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return stream ? Json::parse(stream, nullptr, false) : Json();
}

/// Files that a run leaves and a study does not need.
void remove_bulk(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* name : {"results.h5", "results.xdmf", "complaint.txt"})
    std::filesystem::remove(folder / name, ignored);
}

void add_times(const Json& summary, RunResult& result) {
  double seconds = summary["timings"]["total"];
  for (const auto& [phase, time] : summary["timings"].items()) {
    if (phase == "total") continue;
    if (std::ranges::count(telling, phase))
      seconds -= time.get<double>();
    else
      result.phases[phase].push_back(time);
  }
  result.seconds.push_back(seconds);
}

/// What a run complains of may quote bytes of a broken mesh.
constexpr auto readable = Json::error_handler_t::replace;

Json record_of(const Json& identity, const RunResult& result) {
  return {{"identity", identity},
          {"completed", result.completed},
          {"reason", result.reason},
          {"summary", result.summary},
          {"quantities", result.quantities},
          {"seconds", result.seconds},
          {"phases", result.phases},
          {"wall", result.wall}};
}

RunResult result_of_record(const Json& record, const std::filesystem::path& folder) {
  return {.completed = record.at("completed"),
          .reason = record.at("reason"),
          .summary = record.at("summary"),
          .quantities = record.at("quantities"),
          .seconds = record.at("seconds"),
          .phases = record.at("phases"),
          .wall = record.at("wall"),
          .folder = folder};
}

}  // namespace

Runner::Runner(const Study& study, std::filesystem::path program, std::filesystem::path folder)
    : study_(study), program_(std::move(program)), folder_(std::move(folder)) {
  make_folder(folder_);
  const std::filesystem::path file = folder_ / "lock";
  lock_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock_ < 0) throw OutputError(file.string() + ": cannot write: " + std::generic_category().message(errno));
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    close(lock_);
    throw OutputError(folder_.string() + ": another study writes there; wait for it, or name another folder");
  }
}

Runner::~Runner() { close(lock_); }

Json Runner::identity_of(const PreparedCase& prepared, int repeat) const {
  Json identity = {{"case", prepared.json}, {"fault", prepared.fault}, {"repeat", repeat}, {"version", version()}};
  if (study_.seconds) identity["seconds"] = *study_.seconds;
  if (study_.memory) identity["memory"] = *study_.memory;
  if (const Json::json_pointer mesh("/grid/mesh"); prepared.json.contains(mesh) && prepared.json[mesh].is_string())
    if (const std::filesystem::path file(prepared.json[mesh].get<std::string>());
        std::filesystem::is_regular_file(file))
      identity["mesh"] = hash_of(text_of(file, "a mesh"));
  return identity;
}

std::filesystem::path Runner::folder_of(const Json& identity) const { return folder_ / hash_of(identity.dump()); }

std::optional<RunResult> Runner::recorded(const PreparedCase& prepared, int repeat) const {
  const Json identity = identity_of(prepared, repeat);
  const std::filesystem::path folder = folder_of(identity);
  const Json record = parsed_file(folder / "record.json");
  if (!record.is_object() || record.value("identity", Json()) != identity) return std::nullopt;
  return result_of_record(record, folder);
}

ChildOutcome Runner::run_once(const std::filesystem::path& folder) const {
  return run_child({program_, "run", folder / "case.json", "--output", folder, "--quiet"}, folder / "complaint.txt",
                   {study_.seconds, study_.memory});
}

/// The first run of a call finds the program's files and the processor cold.
void Runner::warm_up(const std::filesystem::path& folder) {
  if (!std::exchange(warm_, true)) static_cast<void>(run_once(folder));
}

/// Runs the case once, and adds what that took.
void Runner::add_run(bool first, RunResult& result) const {
  const ChildOutcome outcome = run_once(result.folder);
  result.wall += outcome.seconds;
  result.completed = outcome.succeeded;
  result.reason = outcome.reason;
  if (!outcome.succeeded) return;
  const Json summary = parsed_file(result.folder / "summary.json");
  add_times(summary, result);
  if (!first) return;
  result.summary = summary;
  result.quantities = quantities_of(summary, result.folder);
}

RunResult Runner::result_of(const PreparedCase& prepared, int repeat) {
  if (auto known = recorded(prepared, repeat)) return std::move(*known);
  const Json identity = identity_of(prepared, repeat);
  RunResult result;
  result.folder = folder_of(identity);
  make_folder(result.folder);
  if (!prepared.fault.empty()) {
    result.reason = prepared.fault;
  } else {
    write_atomically(result.folder / "case.json", prepared.json.dump(2) + "\n");
    warm_up(result.folder);
    for (int k = 0; k < repeat && (k == 0 || result.completed); ++k) add_run(k == 0, result);
    const std::string where = (result.folder / "case.json").string() + ": ";
    if (result.reason.starts_with(where)) result.reason = result.reason.substr(where.size());
  }
  write_atomically(result.folder / "record.json", record_of(identity, result).dump(1, ' ', false, readable) + "\n");
  remove_bulk(result.folder);
  return result;
}

}  // namespace shoreline
