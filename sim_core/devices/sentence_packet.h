// SPDX-License-Identifier: Apache-2.0
// Sentences between fulcrum-hapticd and the program: they are put into words by the program, in the reader's
// language.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim_core/numerics/worded_error.h"

namespace fulcrum {

/// A text, or {"say": "%1 ...", "with": [...]} for one with places.
nlohmann::json sentence_packet(const Sentence& sentence);
/// Of what is not a sentence: `otherwise`.
Sentence sentence_of(const nlohmann::json& packet, const Sentence& otherwise);

}  // namespace fulcrum
