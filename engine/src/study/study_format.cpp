// docs/study_format.md: what the table of keys cannot say, then the table.

#include "shoreline/engine/study.hpp"
#include "study_keys.hpp"

namespace shoreline {
namespace {

constexpr auto introduction = R"(# The study file

`shoreline study STUDY.json` runs one case over sweeps of its keys and lays errors, rates, sizes and costs of all runs
side by side. One JSON file is one study; any key that is not listed here is an error. This page is what
`shoreline schema --study --markdown` prints; `shoreline schema --study` prints the same table as JSON Schema (draft
2020-12). [results.md](results.md#a-study) describes what it leaves in its output folder.

```json
{
  "title": "Basis and volume rule of the plate",
  "case": "../examples/plate_with_hole/neumann.json",
  "sweep": [
    {"name": "basis", "choices": [
      {"name": "bilinear", "set": {"grid.basis": "bilinear"}},
      {"name": "quadratic", "set": {"grid.basis": "bspline", "grid.degree": 2}}]},
    {"key": "material_points.volumes", "values": ["lattice", "clipped"]},
    {"key": "grid.cell_size", "values": [0.25, 0.125, 0.0625]}
  ],
  "repeat": 3
}
```

**Axes.** Every entry of one axis meets every entry of the others. An axis is one key with its `values`; several keys
that change together, each with a list (`zip`); or named `choices` that set any keys. Paths are those of `--set`
([case_format.md](case_format.md)). One axis is refined: rates are formed between its neighbours, which should run from
coarse to fine, and the other axes name the lines of pictures.

**A fair clock.** Runs are processes of their own, one after the other, all with the same number of threads. The time of
a run is that of the whole run but for what only tells of it: output, pictures, errors, probes, diagnostics, estimates.
The first run of a call is made once more beforehand, unrecorded, so that it does not find the machine cold. Threads
sleep where they wait (`OMP_WAIT_POLICY=passive`, `OPENBLAS_THREAD_TIMEOUT=4`, unless set otherwise). With `repeat` the
median counts, and the least and greatest are told: of repeats right after each other. From one call to the next a machine
that others use drifts by more (by a fifth within minutes was measured), so times compare within a call.

**The same device.** Where cases have an exact solution, errors are measured at `samples`, the same places with the
same weights in every run. Without one, runs are compared with a `reference`: `|q - q_ref|/|q_ref|` for displacement and
stress of each probe (in quasi-static cases of the material `at` its `place`, unless the case says otherwise), the
displacement of each boundary curve, each piece's reaction, and the energy.

**Failures.** A run that fails, crashes, or takes more time or memory than the `budget` is a row with its reason. The
exit status is 0 with a count of failures, 1 if every run failed.

**Again.** What has been run lies in the output folder under `runs/`, a folder a run. A second call takes what is there
and runs what is missing or has changed: the case, the study, the version of the program. To run something again, delete
its folder. A study may be killed at any moment.

**The answer.** `--tolerance stress.l2_relative=1e-2` names the cheapest setting of the study that meets it, on the grid
of the study and on one shifted by (0.37, 0.21) cells (not tried where a mesh, or supports on grid lines, leave the grid
no other place); what a tenth and a hundredth of the error cost; and what the error is made of: grid, points, boundary
points, band and time step are refined in turn, and the part whose refinement leaves the least error dominates.
)";

}  // namespace

std::string study_format() { return introduction + keys::reference_page(keys::study_keys(), "The study"); }

}  // namespace shoreline
