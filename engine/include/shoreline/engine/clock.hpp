#pragma once
// What each phase of a run cost.

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shoreline {

/// Seconds and calls by name, in the order in which the names first occurred.
class Clock {
 public:
  struct Entry {
    std::string name;
    long calls = 0;
    double seconds = 0.0;
  };

  /// Runs @p work and books its time under @p name.
  template <class Work>
  decltype(auto) time(std::string_view name, Work&& work) {
    const Booking booking{*this, name, now()};
    return std::forward<Work>(work)();
  }

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  static double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  void book(std::string_view name, double seconds) {
    auto entry = std::ranges::find(entries_, name, &Entry::name);
    if (entry == entries_.end()) entry = entries_.insert(entry, Entry{.name = std::string(name)});
    ++entry->calls;
    entry->seconds += seconds;
  }

  struct Booking {
    Clock& clock;
    std::string_view name;
    double start;
    ~Booking() { clock.book(name, now() - start); }
  };

  std::vector<Entry> entries_;
};

}  // namespace shoreline
