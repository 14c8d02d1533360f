#pragma once
// From text to JSON, stricter than the parser alone: no key twice, no bottomless nesting, no number out of range.

#include <nlohmann/json.hpp>
#include <string>

#include "place.hpp"

namespace shoreline {

using Json = nlohmann::json;

/// @param text  one JSON value
/// @param place where the text comes from, for messages
/// @throws CaseError with line and column of a syntax error, or the pointer of what is refused
[[nodiscard]] Json parse_json(const std::string& text, const Place& place);

/// A value as messages show it: short, on one line, and of which kind.
[[nodiscard]] std::string described(const Json& value);

}  // namespace shoreline
