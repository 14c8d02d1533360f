#pragma once
// The names of Catch2 2 that the tests use, where Catch2 3 is installed.

#include <catch2/catch_all.hpp>

using Catch::Approx;

namespace Catch::Matchers {
inline auto Contains(const std::string& text) { return ContainsSubstring(text); }
inline auto Contains(const char* text) { return ContainsSubstring(text); }
}  // namespace Catch::Matchers
