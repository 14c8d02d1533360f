#include "nearest.hpp"

#include <algorithm>

namespace shoreline {
namespace {

/// Optimal string alignment distance.
std::size_t edits(const std::string& a, const std::string& b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> d((a.size() + 1) * width);
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& best = d[i * width + j];
      if (i == 0 || j == 0) {
        best = i + j;
        continue;
      }
      best = std::min({d[(i - 1) * width + j] + 1, d[i * width + j - 1] + 1,
                       d[(i - 1) * width + j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        best = std::min(best, d[(i - 2) * width + j - 2] + 1);
    }
  }
  return d.back();
}

}  // namespace

std::string nearest(const std::string& found, const std::vector<std::string>& words) {
  constexpr std::size_t longest = 64;
  if (found.size() > longest) return {};
  std::string best;
  std::size_t fewest = std::max<std::size_t>(2, found.size() / 2) + 1;
  for (const std::string& word : words) {
    const bool begins = found.size() > 2 && word.compare(0, found.size(), found) == 0;
    const std::size_t distance = begins ? 1 : edits(found, word);
    if (distance < fewest && distance < word.size()) {
      fewest = distance;
      best = word;
    }
  }
  return best;
}

std::string expected_one_of(const std::vector<std::string>& words, const std::string& found) {
  std::string text = words.size() == 1 ? "expected " : "expected one of ";
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "\"" : ", \"") + words[i] + "\"";
  const std::string like = words.size() == 1 ? "" : nearest(found, words);
  return like.empty() ? text : text + " (nearest: \"" + like + "\")";
}

}  // namespace shoreline
