#pragma once
// A checked JSON value that knows where it stands.

#include "json_text.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/types.hpp"

namespace shoreline {

/// Read without a second look: the table of keys has been enforced before.
struct Node {
  const Json& value;
  Place place;

  [[nodiscard]] bool has(const char* key) const { return value.contains(key); }
  [[nodiscard]] Node operator[](const char* key) const { return {value.at(key), place / std::string(key)}; }
  [[nodiscard]] Node entry(std::size_t number) const { return {value.at(number), place / number}; }
  [[nodiscard]] std::size_t size() const { return value.size(); }

  template <class T>
  [[nodiscard]] T as() const {
    return value.get<T>();
  }
  [[nodiscard]] bool is(const char* word) const { return value == word; }
  [[nodiscard]] Vec2 vector() const { return {value[0].get<double>(), value[1].get<double>()}; }

  /// What @p make returns; a precondition that this value breaks becomes a CaseError here.
  template <class Make>
  auto made(Make&& make) const {
    try {
      return make();
    } catch (const InvalidArgument& error) {
      place.fail(error.what());
    }
  }
};

}  // namespace shoreline
