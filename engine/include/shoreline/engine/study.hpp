#pragma once
// A study: one case over sweeps of its keys, with errors, rates and costs of every run beside each other.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace shoreline {

/// A study as plain data: read and checked. Changes to the case are in the form "path=value" of read_case.
struct Study {
  /// One entry of an axis.
  struct Choice {
    std::string label;
    std::optional<double> number;       ///< where the label is one, or a list that begins with one
    std::vector<std::string> settings;  ///< changes to the case
  };
  struct Axis {
    std::string name;
    std::vector<Choice> choices;
  };
  /// What runs without an exact solution are measured against.
  struct Finest {};
  /// The limit of the line that holds the finest run, from its last three runs.
  struct Richardson {};
  /// A run of its own.
  struct OwnRun {
    std::vector<std::string> settings;
  };
  using Reference = std::variant<Finest, Richardson, OwnRun>;

  std::filesystem::path file;
  std::string title;
  std::filesystem::path base;         ///< case file
  std::vector<std::string> settings;  ///< of every run
  std::vector<Axis> axes;             ///< crossed, the last one fastest
  std::optional<std::size_t> refine;  ///< axis along which rates are formed and lines drawn
  int repeat = 1;                     ///< runs of each setting, of which the median time counts
  std::optional<double> seconds;      ///< that one run may take
  std::optional<double> memory;       ///< that one run may take [bytes]
  int samples = 200;                  ///< key `samples` of cases that know it; 0: errors at the material points
  std::vector<std::string> errors;    ///< norms to draw; empty: the usual ones
  std::optional<Reference> reference;
  std::vector<std::filesystem::path> outside;  ///< rows of other programs, CSV
};

/// Reads and checks a study file (docs/study_format.md).
/// @throws CaseError "FILE: /json/pointer: what was found, what was expected"
[[nodiscard]] Study read_study(const std::filesystem::path& file);

/// The JSON Schema (draft 2020-12) of a study file, and its reference page in Markdown.
[[nodiscard]] std::string study_schema();
[[nodiscard]] std::string study_format();

/// A norm of the error and the largest value that it may have.
struct Tolerance {
  std::string norm;
  double value;
};

struct StudyOptions {
  std::filesystem::path output;   ///< folder of study.json, study.csv, study.md and pictures; runs/ holds what is done
  std::filesystem::path program;  ///< the built `shoreline`, of which every run is a process
  std::optional<int> threads{};   ///< of every run; none: as the case or study says, else all cores
  bool quiet = false;             ///< no progress
  std::optional<Tolerance> tolerance{};  ///< asks for the cheapest setting that meets it
};

struct StudyOutcome {
  int runs = 0;
  int failures = 0;
  std::string report;  ///< for people
};

/// Runs what is missing of a study and writes its tables and pictures.
///
/// Runs are child processes, one after the other: one that fails, crashes or exceeds its time or memory costs its row,
/// which gives the reason. A run is done when its record lies in runs/; the record holds the case as it was run, and is
/// taken again only if that has not changed.
///
/// @throws CaseError    where the tolerance names a norm that no run has, or an outside file is wrong
/// @throws OutputError  if the folder cannot be written, or another study is writing there
StudyOutcome run_study(const Study& study, const StudyOptions& options);

}  // namespace shoreline
