#pragma once
// Rows of the table of keys, and the values that many of them take.

#include "keys.hpp"

namespace shoreline::keys {

inline constexpr double huge = 1e30;           // beyond, squares of stresses and stiffnesses could overflow
inline constexpr std::size_t many = 10000000;  // entries of a list that a person or script might still write

/// Whether a key may be missing, and what it is then.
struct Presence {
  bool required;
  Json fallback;
};
inline const Presence required{true, {}};
inline const Presence optional{false, {}};
inline Presence otherwise(Json fallback) { return {false, std::move(fallback)}; }

inline Key key(std::string name, Schema schema, Presence presence, std::string unit, std::string meaning) {
  return {std::move(name),   std::move(schema), std::move(unit), presence.required, std::move(presence.fallback),
          std::move(meaning)};
}

inline Schema any_number() { return {Number{{-huge, huge}}}; }
inline Schema positive_number() { return {Number{{0.0, huge, true}}}; }
inline Schema coordinate() { return {Number{{-1e9, 1e9}}}; }
inline Schema length() { return {Number{{0.0, 1e9, true}}}; }
inline Schema list(Schema entry, std::size_t at_least, std::size_t at_most) {
  return {List{std::make_shared<const Schema>(std::move(entry)), at_least, at_most}};
}
inline Schema map_of(Schema entry) { return {Map{std::make_shared<const Schema>(std::move(entry))}}; }
inline Schema several(std::size_t n, Schema entry) { return list(std::move(entry), n, n); }
inline Schema position() { return several(2, coordinate()); }
inline Schema one_or_pair(const Schema& entry) { return {Either{{entry, several(2, entry)}}}; }

/// Keys of `grid`.
[[nodiscard]] Schema grid();

/// Keys of `analysis`.
[[nodiscard]] Schema analysis();

/// Keys of `material` where strains are small, and where they may be large.
[[nodiscard]] Schema small_strain_material();
[[nodiscard]] Schema large_strain_material();

/// Keys of `material_points`.
[[nodiscard]] Schema material_points();

}  // namespace shoreline::keys
