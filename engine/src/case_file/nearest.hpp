#pragma once
// "Did you mean": the word of a list that is nearest to what was found.

#include <string>
#include <vector>

namespace shoreline {

/// The word with the fewest edits (insert, delete, replace, swap neighbours) from @p found, or "" if none is like it.
[[nodiscard]] std::string nearest(const std::string& found, const std::vector<std::string>& words);

/// `expected one of "a", "b" (nearest: "a")`, or `expected "a"`.
[[nodiscard]] std::string expected_one_of(const std::vector<std::string>& words, const std::string& found);

}  // namespace shoreline
