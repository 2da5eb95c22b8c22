// SPDX-License-Identifier: Apache-2.0
// A JSON document with line numbers. Scenes, tasks and other files written by hand are read through it, so
// that every error names file, line, JSON pointer and a hint.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {

/// Limits beyond which a hand-written file is refused.
struct JsonLimits {
    std::size_t bytes = std::size_t{1} << 20U;  ///< largest size of the text
    int depth = 32;                             ///< largest nesting of arrays and objects
};

/// Parsed text with the line of every value. Not for the haptic or world thread.
class JsonDocument {
  public:
    /// Throws InputError: too large, too deep, not JSON, not UTF-8, or a duplicate key in an object.
    static JsonDocument parse(const std::string& text, const std::string& file,
                              const JsonLimits& limits = {});
    /// As parse, from a file. Also throws InputError if the file cannot be read.
    static JsonDocument load(const std::string& path, const JsonLimits& limits = {});

    const nlohmann::json& root() const noexcept { return root_; }
    const std::string& file() const noexcept { return file_; }
    /// Line (from 1) of the value at a JSON pointer, or of its nearest ancestor that exists.
    int line(const std::string& pointer) const;
    /// Checks the document against a JSON Schema (draft 7; only local "$ref"). Throws InputError for the most
    /// specific violation, with a hint from the schema's own descriptions. The schema is part of the program:
    /// an invalid one throws std::logic_error.
    void check_schema(const char* schema) const;
    /// Throws InputError at a JSON pointer.
    [[noreturn]] void fail(const std::string& pointer, const Sentence& wrong, const Sentence& hint) const;

  private:
    std::string file_;
    nlohmann::json root_;
    std::map<std::string, int> lines_;  ///< by pointer
};

/// The content of a text file. Throws InputError if it cannot be read or is larger than `limit` bytes.
std::string read_text_file(const std::string& path, std::size_t limit);

}  // namespace fulcrum
