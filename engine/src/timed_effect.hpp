#pragma once
// An effect that is a phase of a run, or a part of one: its time is booked under both names.

#include <string_view>
#include <utility>

namespace shoreline {

template <class Record, class Work>
decltype(auto) timed_effect(Record& record, std::string_view phase, std::string_view effect, Work&& work) {
  return record.phases.time(phase,
                            [&]() -> decltype(auto) { return record.effects.time(effect, std::forward<Work>(work)); });
}

}  // namespace shoreline
