// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/scene_schema.h"

#include <nlohmann/json.hpp>

namespace fulcrum {

// The texts of assets/schemas/scene, embedded by the build.
extern const char* const scene_schema_common;
#define SCENE_PART(type, name) extern const char* const scene_schema_##name;
#include "sim_core/scene/scene_parts.inc"

namespace {

using nlohmann::json;

json part_schema(const char* text) {
    json schema = json::parse(text);
    schema.erase("$comment");  // the licence of the file
    return schema;
}

}  // namespace

const std::string& scene_schema() {
    static const std::string text = [] {
        json schema = json::parse(scene_schema_common);
        json& properties = schema.at("properties");
#define SCENE_PART(type, name) properties[#name] = part_schema(scene_schema_##name);
#include "sim_core/scene/scene_parts.inc"
        return schema.dump();
    }();
    return text;
}

}  // namespace fulcrum
