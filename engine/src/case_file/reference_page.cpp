// The table of keys as a page for people, in Markdown.

#include <fmt/format.h>

#include "keys.hpp"
#include "shoreline/boundary/conditions.hpp"

namespace shoreline::keys {
namespace {

/// The keys of one object, as one printed table.
struct Section {
  std::string path;       ///< of the object, "" for the whole case
  std::string condition;  ///< under which it has these keys, "" if always
  const Object* object;
};

/// The objects that may stand at a path.
void collect(const Schema& schema, const std::string& path, std::vector<Section>& sections) {
  std::visit(Overloaded{[&](const Object& object) {
                          sections.push_back({path, "", &object});
                        },
                        [&](const Tagged& tagged) {
                          for (const auto& [name, object] : tagged.alternatives)
                            sections.push_back({path,
                                                fmt::format("`\"{}\": \"{}\"`{}", tagged.tag, name,
                                                            name == tagged.fallback ? " (default)" : ""),
                                                &object});
                        },
                        [&](const Depending& depending) {
                          for (const auto& [tag, object] : depending.alternatives)
                            sections.push_back({path, fmt::format("`{}.type` = `\"{}\"`", depending.on, tag), &object});
                        },
                        [&](const Either& either) {
                          for (const Schema& one : either.alternatives) {
                            collect(one, path, sections);
                            if (const auto* object = std::get_if<Object>(&one.kind))
                              sections.back().condition = "`" + object->keys.front().name + "`";
                          }
                        },
                        [&](const List& list) { collect(*list.entry, path + "[]", sections); }, [](const auto&) {}},
             schema.kind);
}

std::string presence(const Key& key, const Object& object) {
  for (const std::string& name : object.exactly_one)
    if (name == key.name) return "exactly one of these";
  if (key.required) return "required";
  return key.fallback.is_null() || key.fallback.empty() ? "–" : fmt::format("`{}`", key.fallback.dump());
}

std::string table_of(const Section& section) {
  std::string table = "\n\n| key | value | unit | default | meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const Key& key : section.object->keys)
    table += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, in_words(key.schema), key.unit,
                         presence(key, *section.object), key.meaning);
  return table;
}

/// Whether a page has a section with these rows and no more.
bool holds(const std::string& page, const std::string& section) {
  return page.ends_with(section) || page.find(section + "\n") != std::string::npos;
}

/// A heading, the keys, and every object below them; each once.
/// @param whole     heading of the outermost keys
/// @param analysis  that has these keys: said where another has other keys under the same heading
void print(const Section& section, const std::string& whole, const std::string& analysis, std::string& page) {
  const std::string of = section.path.empty() ? whole : "`" + section.path + "`";
  const std::string with = section.condition.empty() ? "" : " with " + section.condition;
  const std::string table = table_of(section);
  std::string heading = "\n## " + of + with;
  if (holds(page, heading + table)) return;
  if (page.find(heading + "\n") != std::string::npos) heading += ", where " + analysis;
  if (holds(page, heading + table)) return;
  page += heading + table;
  for (const Key& key : section.object->keys) {
    std::vector<Section> below;
    collect(key.schema, section.path.empty() ? key.name : section.path + "." + key.name, below);
    for (const Section& inner : below) print(inner, whole, analysis, page);
  }
}

}  // namespace

std::string reference_page(const Schema& schema, const std::string& whole) {
  std::vector<Section> top;
  collect(schema, "", top);
  std::string page;
  for (const Section& section : top) print(section, whole, section.condition, page);
  return page;
}

}  // namespace shoreline::keys
