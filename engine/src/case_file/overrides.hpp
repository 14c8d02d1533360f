#pragma once
// --set path=value: changes to a case from the command line.

#include <string>

#include "json_text.hpp"

namespace shoreline {

/// Sets one value of a case, before it is checked.
///
/// @param assignment  "path=value": a dotted path, list entries by number or by their key "name"; objects that are
/// missing
///                    are added; the value is JSON, or else a string as it stands
/// @throws CaseError  with the assignment as its file, and how far the path led
void override_value(Json& root, const std::string& assignment);

}  // namespace shoreline
