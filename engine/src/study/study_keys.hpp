#pragma once
// The keys of a study, in the manner of those of a case.

#include "case_file/keys.hpp"

namespace shoreline::keys {

[[nodiscard]] const Schema& study_keys();

}  // namespace shoreline::keys
