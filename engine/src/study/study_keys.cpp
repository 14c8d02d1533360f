#include "study_keys.hpp"

#include "case_file/key_rows.hpp"
#include "shoreline/engine/study.hpp"

namespace shoreline::keys {
namespace {

constexpr std::size_t most_choices = 10000;

Schema any_list() { return list({Anything{}}, 1, most_choices); }

Key changes(const std::string& name, std::string meaning) {
  return key(name, map_of({Anything{}}), required, "", std::move(meaning));
}

Schema axis() {
  const Object choice{{key("name", {Text{}}, required, "", "label in tables and pictures"),
                       changes("set", "keys of the case by dotted path, as after `--set`, with their values")},
                      {}};
  const Object choices{{key("choices", list({choice}, 1, most_choices), required, "", "named settings of several keys"),
                        key("name", {Text{}}, required, "", "of the axis, in tables and pictures")},
                       {}};
  const Object zip{{key("zip", map_of(any_list()), required, "",
                        "keys of the case that change together, each with a list of values; lists equally long; the "
                        "first key by name labels the entries"),
                    key("name", {Text{}}, optional, "", "of the axis; default: the labelling key"),
                    key("label", {Text{}}, optional, "", "key that labels the entries")},
                   {}};
  const Object values{{key("key", {Text{}}, required, "", "key of the case by dotted path, as after `--set`"),
                       key("values", any_list(), required, "", "its values, one an entry"),
                       key("name", {Text{}}, optional, "", "of the axis; default: the key")},
                      {}};
  return {Either{{{choices}, {zip}, {values}}}};
}

Schema budget() {
  return {Object{{key("seconds", {Number{{0.0, 1e9, true}}}, optional, "s", "that one run may take"),
                  key("memory", {Number{{1e6, 1e15}}}, optional, "byte", "that one run may hold at once")},
                 {}}};
}

Schema reference() {
  const Object own{{changes("set", "keys of the case by dotted path, for a run of its own")}, {}};
  return {Either{{{own}, {Choice{{"finest", "richardson"}}}}}};
}

}  // namespace

const Schema& study_keys() {
  static const Schema table{Object{
      {key("title", {Text{}}, optional, "", "one line for people; default: the name of the file"),
       key("case", {Text{}}, required, "", "case file, relative to the study file"),
       key("set", map_of({Anything{}}), otherwise(Json::object()), "", "changes for every run, by dotted path"),
       key("sweep", list(axis(), 1, 10), required, "", "axes; every entry of one meets every entry of the others"),
       key("refine", {Text{}}, optional, "",
           "name of the axis along which rates are formed and lines drawn; default: the one that sets "
           "`grid.cell_size`, else the last whose labels are numbers"),
       key("repeat", {Integer{1, 1000}}, otherwise(Study{}.repeat), "",
           "times that each setting is run; the median time counts, least and greatest are told"),
       key("budget", budget(), otherwise(Json::object()), "", "a run that takes more is ended and fails"),
       key("samples", {Integer{0, 10000}}, otherwise(Study{}.samples), "",
           "key `samples` of quasi-static runs with an exact solution, unless the case says otherwise: errors of every "
           "run at the same places; 0: at each run's own material points"),
       key("errors", list({Text{}}, 1, 6), optional, "",
           "norms that tables and pictures show; default: the relative L2 errors of displacement and stress, without "
           "an "
           "exact solution what is compared with the reference"),
       key("reference", reference(), optional, "",
           "what probes, boundary curves, reactions and energy are compared with: the `finest` run (most unknowns), "
           "the "
           "`richardson` limit of its line, or a run of its own; default without an exact solution: `finest`"),
       key("outside", list({Text{}}, 1, 100), optional, "",
           "rows of other programs, CSV files as docs/results.md describes them, relative to the study file")},
      {}}};
  return table;
}

}  // namespace shoreline::keys
