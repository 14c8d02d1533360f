// The table of keys as JSON Schema, draft 2020-12.

#include <cmath>

#include "keys.hpp"
#include "shoreline/boundary/conditions.hpp"

namespace shoreline::keys {
namespace {

Json schema_of(const Schema& schema);

Json schema_of(const Range& range) {
  Json json = {{"type", "number"}};
  if (std::isfinite(range.lower)) json[range.lower_open ? "exclusiveMinimum" : "minimum"] = range.lower;
  if (std::isfinite(range.upper)) json[range.upper_open ? "exclusiveMaximum" : "maximum"] = range.upper;
  return json;
}

Json schema_of(const Key& key) {
  Json json = schema_of(key.schema);
  json["description"] = key.meaning + (key.unit.empty() ? "" : " [" + key.unit + "]");
  if (!key.fallback.is_null()) json["default"] = key.fallback;
  return json;
}

Json schema_of(const Object& object) {
  Json json = {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
  Json required = Json::array();
  for (const Key& key : object.keys) {
    json["properties"][key.name] = schema_of(key);
    if (key.required) required.push_back(key.name);
  }
  if (!required.empty()) json["required"] = required;
  for (const std::string& name : object.exactly_one) json["oneOf"].push_back({{"required", {name}}});
  return json;
}

Json schema_of(const Tagged& tagged) {
  Json json = {{"type", "object"}};
  for (const auto& [name, object] : tagged.alternatives) {
    Json one = schema_of(object);
    one["properties"][tagged.tag] = {{"const", name}};
    if (name != tagged.fallback) one["required"].push_back(tagged.tag);
    json["oneOf"].push_back(one);
  }
  return json;
}

Json schema_of(const Depending& depending) {
  Json json = {{"type", "object"}};
  for (const auto& [tag, object] : depending.alternatives) {
    Json one = schema_of(object);
    one["allOf"] = {{{"properties", {{depending.on, {{"properties", {{"type", {{"const", tag}}}}}}}}}}};
    json["oneOf"].push_back(one);
  }
  return json;
}

Json schema_of(const List& list) {
  return {
      {"type", "array"}, {"items", schema_of(*list.entry)}, {"minItems", list.at_least}, {"maxItems", list.at_most}};
}

Json schema_of(const Either& either) {
  Json json = Json::object();
  for (const Schema& one : either.alternatives) json["oneOf"].push_back(schema_of(one));
  return json;
}

Json schema_of(const Schema& schema) {
  return std::visit(Overloaded{[](const Number& number) { return schema_of(number.range); },
                               [](const Integer& whole) {
                                 return Json{{"type", "integer"}, {"minimum", whole.lower}, {"maximum", whole.upper}};
                               },
                               [](const Boolean&) {
                                 return Json{{"type", "boolean"}};
                               },
                               [](const Text&) {
                                 return Json{{"type", "string"}};
                               },
                               [](const Name&) {
                                 return Json{{"type", "string"}, {"pattern", "^[^/.\\x00-\\x1f]+$"}};
                               },
                               [](const Choice& choice) {
                                 return Json{{"enum", choice.words}};
                               },
                               [](const Formula&) {
                                 return Json{{"type", {"number", "string"}}};
                               },
                               [](const Anything&) { return Json::object(); },
                               [](const Map& map) {
                                 return Json{{"type", "object"}, {"additionalProperties", schema_of(*map.entry)}};
                               },
                               [](const auto& other) { return schema_of(other); }},
                    schema.kind);
}

}  // namespace

Json json_schema(const Schema& schema, const std::string& title) {
  Json json = schema_of(schema);
  json["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  json["title"] = title;
  return json;
}

}  // namespace shoreline::keys
